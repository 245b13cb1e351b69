// From a plain triangle mesh to an exactly seamless parametrization:
//
//   parameterize_and_snap IN OUT.obj [--feature-angle DEGREES] [--align-border]
//                         [--curvature STRENGTH] [--approximate APPROX.obj] [--svg PICTURE.svg]
//
// The mesh can be in any format that CGAL reads; edges that are sharper than the given angle are
// aligned with the coordinates. --approximate writes what was snapped as well.

#include "svg_picture.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/approximate_seamless_parameterization.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace po = boost::program_options;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SS = CGAL::Seamless_snapping;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Mesh::Halfedge_index;
using Uv_map = Mesh::Property_map<Halfedge, Kernel::Point_2>;
using Edge_bool_map = Mesh::Property_map<Mesh::Edge_index, bool>;

struct Options
{
  std::string input, output, approximate, svg;
  double feature_angle = 0; // in degrees; 0: no features
  double curvature = 0;
  bool align_border = false;
};

Options parse_command_line(int argc, char** argv)
{
  Options options;
  po::options_description description("Options");
  description.add_options()
    ("input", po::value(&options.input)->required(), "the mesh")
    ("output", po::value(&options.output)->required(), "the OBJ file to write")
    ("feature-angle", po::value(&options.feature_angle), "align edges that are sharper")
    ("align-border", po::bool_switch(&options.align_border), "align border edges")
    ("curvature", po::value(&options.curvature), "how strongly to follow the curvature")
    ("approximate", po::value(&options.approximate), "write the input of the snapping, too")
    ("svg", po::value(&options.svg), "draw the domain, and the largest gaps before and after");
  try {
    po::variables_map values;
    const auto files = po::positional_options_description().add("input", 1).add("output", 1);
    po::store(po::command_line_parser(argc, argv).options(description).positional(files).run(),
              values);
    po::notify(values);
  } catch(const po::error& error) {
    std::cerr << description;
    throw std::runtime_error(error.what());
  }
  return options;
}

Mesh read_mesh(const std::string& filename)
{
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh) || is_empty(mesh))
    throw std::runtime_error("cannot read '" + filename + "'");
  PMP::triangulate_faces(mesh);
  return mesh;
}

// A face can be aligned along two of its edges at most.
void mark_features(const Mesh& mesh, const double angle, Edge_bool_map is_feature)
{
  PMP::detect_sharp_edges(mesh, angle, is_feature);
  for(const auto e : mesh.edges())
    if(mesh.is_border(e))
      is_feature[e] = false;
  for(const auto f : mesh.faces()) {
    const auto around = mesh.halfedges_around_face(mesh.halfedge(f));
    if(std::all_of(around.begin(), around.end(),
                   [&](Halfedge h) { return is_feature[mesh.edge(h)]; }))
      is_feature[mesh.edge(mesh.halfedge(f))] = false;
  }
}

void write(const std::string& filename, const Mesh& mesh, Uv_map uv_map, Edge_bool_map is_feature)
{
  const auto status = SS::IO::write_OBJ(filename, mesh, uv_map,
                                        SS::parameters::edge_is_constrained_map(is_feature));
  if(!status)
    throw std::runtime_error(filename + ": " + status.message);
}

void draw(const Options& options, const Mesh& mesh, Uv_map old_uv_map, Uv_map uv_map)
{
  const SS::Seam_transitions<Mesh> transitions = SS::seam_transitions(mesh, old_uv_map);
  std::ofstream os(options.svg);
  Svg_picture<Mesh, Uv_map, Uv_map>(mesh, old_uv_map, uv_map, transitions)
    .write(os, std::filesystem::path(options.input).filename().string());
  if(!os)
    throw std::runtime_error("cannot write '" + options.svg + "'");
}

void run(const Options& options)
{
  Mesh mesh = read_mesh(options.input);
  Uv_map uv_map = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  Edge_bool_map is_feature =
    mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  if(options.feature_angle > 0)
    mark_features(mesh, options.feature_angle, is_feature);

  const auto alignment = SS::parameters::edge_is_constrained_map(is_feature)
                                        .align_border(options.align_border);
  const auto made = SS::approximate_seamless_parameterization(
    mesh, uv_map, alignment.curvature_alignment(options.curvature));
  if(!made)
    throw std::runtime_error(options.input + ": " + made.message);
  std::cout << made.number_of_faces << " faces, genus " << made.genus << ", "
            << made.number_of_border_loops << " border loops, " << made.cones.size() << " cones, "
            << made.number_of_flipped_faces << " flipped faces, violation "
            << made.violation / made.extent << " of the extent" << std::endl;
  if(!options.approximate.empty())
    write(options.approximate, mesh, uv_map, is_feature);

  Uv_map old_uv_map = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:old_uv").first;
  for(const Halfedge h : mesh.halfedges())
    old_uv_map[h] = uv_map[h];
  const auto snapped = SS::snap_to_seamless(mesh, uv_map, alignment);
  if(!snapped)
    throw std::runtime_error(options.input + ": " + snapped.message);
  std::cout << "exactly seamless: " << std::boolalpha << SS::is_seamless(mesh, uv_map, alignment)
            << ", largest change " << snapped.largest_change / snapped.extent << " of the extent"
            << std::endl;
  write(options.output, mesh, uv_map, is_feature);
  if(!options.svg.empty())
    draw(options, mesh, old_uv_map, uv_map);
}

int main(int argc, char** argv)
{
  try {
    run(parse_command_line(argc, argv));
  } catch(const std::exception& failure) {
    std::cerr << failure.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
