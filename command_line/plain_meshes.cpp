#include "plain_meshes.h"

#include "Failure.h"
#include "files.h"
#include "words.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

std::string summary_of_features(const Mesh& mesh, const Edge_bool_map& is_feature)
{
  const auto is_inside = [&](const Edge e) { return is_feature[e] && !mesh.is_border(e); };
  boost::disjoint_sets_with_storage<> chains(mesh.num_edges());
  std::vector<char> is_dead_end(mesh.num_vertices(), 0);
  for(const auto v : mesh.vertices()) {
    std::vector<Edge> at_vertex;
    for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
      if(h != Mesh::null_halfedge() && is_inside(mesh.edge(h)))
        at_vertex.push_back(mesh.edge(h));
    if(at_vertex.size() == 2)
      chains.union_set(std::size_t(at_vertex[0]), std::size_t(at_vertex[1]));
    is_dead_end[std::size_t(v)] = at_vertex.size() == 1 && !mesh.is_border(v) ? 1 : 0;
  }
  std::map<std::size_t, std::vector<Edge> > edges_of_chain;
  double length = 0;
  for(const Edge e : mesh.edges())
    if(is_inside(e)) {
      edges_of_chain[chains.find_set(std::size_t(e))].push_back(e);
      length += PMP::edge_length(e, mesh);
    }
  if(edges_of_chain.empty())
    return "";
  std::size_t number_of_edges = 0, singles = 0;
  for(const auto& [chain, edges] : edges_of_chain) {
    number_of_edges += edges.size();
    const Edge e = edges.front();
    singles += edges.size() == 1 && (is_dead_end[std::size_t(mesh.vertex(e, 0))] ||
                                     is_dead_end[std::size_t(mesh.vertex(e, 1))]) ? 1 : 0;
  }
  std::ostringstream os;
  os << "features: " << counted(number_of_edges, "edge") << " in "
     << counted(edges_of_chain.size(), "chain") << ", of length " << length << " in sum\n";
  constexpr std::size_t few = 20;
  if(singles > few && 2 * singles > edges_of_chain.size())
    os << "note: " << singles << " of these chains are single edges that lead nowhere, as noise makes "
          "them: a larger --feature-angle keeps fewer\n";
  return os.str();
}

void mark_sharp_edges(const double angle, Mesh& mesh, Edge_bool_map& is_feature)
{
  const Edge_bool_map is_sharp = mesh.add_property_map<Edge, bool>("e:sharp", false).first;
  PMP::detect_sharp_edges(mesh, angle, is_sharp);
  for(const Edge e : mesh.edges())
    is_feature[e] = is_feature[e] || (is_sharp[e] && !mesh.is_border(e));
}

std::size_t release_one_of_three(const Mesh& mesh, Edge_bool_map& is_feature)
{
  std::size_t result = 0;
  for(const auto f : mesh.faces()) {
    const auto around = mesh.halfedges_around_face(mesh.halfedge(f));
    if(std::all_of(around.begin(), around.end(),
                   [&](Halfedge h) { return is_feature[mesh.edge(h)]; })) {
      is_feature[mesh.edge(mesh.halfedge(f))] = false;
      ++result;
    }
  }
  return result;
}

void check_quad_file(const std::string& filename)
{
  const std::string suffix = suffix_of(filename);
  if(!is_special_file(filename) && suffix != "obj" && suffix != "off" && suffix != "ply")
    throw Failure(USAGE, "'" + filename + "': quads are written to .obj, .off, and .ply files");
}

void write_inverted_quads(std::ostream& os, const std::size_t number,
                          const std::vector<std::size_t>& first, const std::string& filename)
{
  if(number == 0)
    return;
  os << "warning: " << counted(number, "quad") << (number == 1 ? " is" : " are")
     << " inverted: at a corner, the sides turn the other way than the quad as a whole does, or it "
        "lies upside down. ";
  os << (number == 1 ? "It is face" : number == first.size() ? "They are faces"
                                                             : "The first are faces");
  const std::string suffix = suffix_of(filename);
  const std::size_t first_number = suffix == "off" || suffix == "ply" ? 0 : 1;
  for(const std::size_t f : first)
    os << (f == first.front() ? " " : ", ") << f + first_number;
  os << " of " << filename << "\n";
}

void write_displacement(std::ostream& os, const std::size_t number, const double largest)
{
  if(number > 0)
    os << "moved off the surface or off a feature, as quads would be inverted: "
       << counted(number, "vertex") << ", by at most " << largest << "\n";
}

namespace {

template <typename... Quads>
std::string text(const std::string& filename, const Quads&... quads)
{
  std::ostringstream os;
  const auto precision = CGAL::parameters::stream_precision(17);
  const std::string suffix = suffix_of(filename);
  if(!(suffix == "off"   ? CGAL::IO::write_OFF(os, quads..., precision)
       : suffix == "ply" ? CGAL::IO::write_PLY(os, quads..., precision)
                         : CGAL::IO::write_OBJ(os, quads..., precision)))
    throw Failure(UNWRITABLE, "cannot write '" + filename + "'");
  return os.str();
}

} // namespace

std::string lines_of_features(const Mesh& quads, const Edge_bool_map& is_feature)
{
  std::vector<std::size_t> numbers(quads.num_vertices());
  std::size_t number = 0;
  for(const auto v : quads.vertices())
    numbers[std::size_t(v)] = ++number;
  std::string result;
  for(const Edge e : quads.edges())
    if(is_feature[e] && !quads.is_border(e))
      result += "l " + std::to_string(numbers[std::size_t(quads.vertex(e, 0))]) + " " +
                std::to_string(numbers[std::size_t(quads.vertex(e, 1))]) + "\n";
  return result;
}

std::string text_of_quads(const Mesh& quads, const Edge_bool_map& is_feature,
                          const std::string& filename)
{
  const std::string result = text(filename, quads), suffix = suffix_of(filename);
  return suffix == "off" || suffix == "ply" ? result
                                            : result + lines_of_features(quads, is_feature);
}

std::string text_of_quads(const Quad_soup& quads, const std::string& filename)
{
  return text(filename, quads.points, quads.polygons);
}
