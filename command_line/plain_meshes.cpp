#include "plain_meshes.h"

#include "Failure.h"
#include "files.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <algorithm>
#include <sstream>
#include <string>

namespace PMP = CGAL::Polygon_mesh_processing;

void read_mesh(const std::string& filename, Mesh& mesh)
{
  read_file(filename); // tells why, if it cannot be read
  if(!PMP::IO::read_polygon_mesh(filename, mesh) || is_empty(mesh))
    throw Failure(UNREADABLE, "'" + filename + "' is not a mesh in a format that its suffix names");
  PMP::triangulate_faces(mesh);
}

// A face can be aligned along two of its edges at most.
void mark_features(const double angle, Mesh& mesh, Edge_bool_map& is_feature)
{
  PMP::detect_sharp_edges(mesh, angle, is_feature);
  for(const Edge e : mesh.edges())
    if(mesh.is_border(e))
      is_feature[e] = false;
  for(const auto f : mesh.faces()) {
    const auto around = mesh.halfedges_around_face(mesh.halfedge(f));
    if(std::all_of(around.begin(), around.end(),
                   [&](Halfedge h) { return is_feature[mesh.edge(h)]; }))
      is_feature[mesh.edge(mesh.halfedge(f))] = false;
  }
}

namespace {

template <typename... Quads>
std::string text(const std::string& filename, const Quads&... quads)
{
  std::ostringstream os;
  const auto precision = CGAL::parameters::stream_precision(17);
  if(!(suffix_of(filename) == "off" ? CGAL::IO::write_OFF(os, quads..., precision)
                                    : CGAL::IO::write_OBJ(os, quads..., precision)))
    throw Failure(UNWRITABLE, "cannot write '" + filename + "'");
  return os.str();
}

} // namespace

std::string text_of_quads(const Mesh& quads, const std::string& filename)
{
  return text(filename, quads);
}

std::string text_of_quads(const Quad_soup& quads, const std::string& filename)
{
  return text(filename, quads.points, quads.polygons);
}
