// How long motorcycle graphs take, and how much of what their curves visit is part of the result:
// on height fields, whose curves run along edges, on the same with vertices moved, and on files.

#include "benchmark_tools.h"
#include "command_line.h"

#include "Height_field_surface.h"

#include <CGAL/Isocurves_and_layouts/Isocurve_tracer.h>
#include <CGAL/Isocurves_and_layouts/copy_to_face_graph.h>
#include <CGAL/Isocurves_and_layouts/Motorcycle_graph.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace po = benchmark::options;
namespace IL = CGAL::Isocurves_and_layouts;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Graph = IL::Motorcycle_graph<Mesh>;

template <typename Run>
double seconds(const int runs, const Run& run)
{
  double best = std::numeric_limits<double>::infinity();
  for(int i = 0; i < runs; ++i) {
    const double start = benchmark::seconds_now();
    run();
    best = (std::min)(best, benchmark::seconds_now() - start);
  }
  return best;
}

void measure(const Mesh& mesh, const UV_map& uv, const int runs, const std::string& name)
{
  const double reading = seconds(runs, [&] { IL::Isocurve_tracer<Mesh>(mesh, uv); });
  const Graph graph = IL::motorcycle_graph(mesh, uv);
  if(!graph) {
    std::cout << name << ": " << graph.status() << ": " << graph.message() << std::endl;
    return;
  }
  const double dividing = seconds(runs, [&] { IL::motorcycle_graph(mesh, uv); });
  const double refining = seconds(runs, [&] {
    Mesh refined;
    IL::refine_along_arcs(graph, refined);
  });
  std::size_t nodes = 0, segments = 0;
  for(std::size_t n = 0; n < graph.number_of_nodes(); ++n)
    nodes += graph.node_kind(n) == IL::Layout_node::JUNCTION ? 0 : 1;
  for(std::size_t a = 0; a < graph.number_of_arcs(); ++a)
    if(!graph.arc_is_constrained(a))
      segments += graph.arc_path(a).size() - 1;
  std::cout << std::setw(10) << mesh.number_of_faces() << std::setw(10) << nodes << std::setw(10)
            << graph.number_of_patches() << std::setw(12) << segments << std::setw(10)
            << std::setprecision(2) << double(graph.number_of_visited_segments()) / double(segments)
            << std::setw(12) << std::setprecision(3) << reading << std::setw(12) << dividing
            << std::setw(12) << refining << "  " << name << std::endl;
}

int main(int argc, char* argv[])
{
  int runs = 0;
  std::size_t faces = 0, nodes = 0;
  std::vector<std::string> files;
  po::options_description options("Options");
  options.add_options()(
    "runs", po::value(&runs)->default_value(3), "the fastest of so many runs counts")(
    "faces", po::value(&faces)->default_value(1900000), "of the height field; 0 for none")(
    "nodes", po::value(&nodes)->default_value(5000), "of the height field")(
    "files", po::value(&files), "parametrized meshes (OBJ), or folders");
  if(const auto exit_code = benchmark::read_command_line(
       argc, argv, "layout_speed [options] [FILE_OR_FOLDER...]", options, "files"))
    return *exit_code;
  std::cout << std::fixed
            << "     faces     nodes   patches    segments   visited   reading/s  dividing/s"
               "  refining/s" << std::endl;
  if(faces > 0) {
    Mesh mesh;
    height_field_surface::Wish wish;
    wish.faces = faces;
    wish.nodes = nodes;
    height_field_surface::make_surface(wish, mesh);
    measure(mesh, square_complex::uv_map(mesh), runs, "height field");
    height_field_surface::perturb(mesh, 1e-9, 1);
    if(IL::snap_to_seamless(mesh, square_complex::uv_map(mesh)))
      measure(mesh, square_complex::uv_map(mesh), runs, "height field, with noise, snapped");
  }
  for(const std::string& file : benchmark::files_of(files)) {
    Mesh mesh;
    UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
    if(IL::IO::read_OBJ(file, mesh, uv) &&
       IL::snap_to_seamless(mesh, uv, IL::parameters::align_border(true).repair_flips(true)))
      measure(mesh, uv, runs, file.substr(file.find_last_of('/') + 1));
    else
      std::cerr << file << ": can't be read or snapped" << std::endl;
  }
  return EXIT_SUCCESS;
}
