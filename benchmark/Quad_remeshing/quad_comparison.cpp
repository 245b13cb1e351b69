// What quad_remesh() makes of the given meshes, and of all meshes in given folders, at several
// sizes: a table of outcomes, quads, irregular vertices, released features, scaled Jacobians,
// distances from the input, and times; and what becomes of the same parametrizations without
// snapping. Edges with an angle of more than that of --feature-angle are features; without, none.
//
//   quad_comparison [--quads N]... [--feature-angle DEGREES] MESH_OR_FOLDER...

#include "command_line.h"

#include <CGAL/Quad_remeshing/approximate_seamless_parametrization.h>
#include <CGAL/Quad_remeshing/quad_remesh.h>
#include <CGAL/Quad_remeshing/quantize.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace po = benchmark::options;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SS = CGAL::Seamless_snapping;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Feature_map = Mesh::Property_map<Mesh::Edge_index, bool>;

// Of all meshes and sizes.
struct Totals
{
  std::size_t tried = 0, remeshed = 0, parametrized = 0, quantized_unsnapped = 0;
};

// Whether the parametrization is good for quads as the solver returns it.
void try_unsnapped(Mesh& mesh, const Feature_map& is_feature, Totals& totals)
{
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  if(!SS::approximate_seamless_parametrization(
       mesh, uv, SS::parameters::align_border(true).edge_is_constrained_map(is_feature)))
    return;
  ++totals.parametrized;
  totals.quantized_unsnapped +=
    SS::quantize(mesh, uv, SS::parameters::edge_is_constrained_map(is_feature)) ? 1 : 0;
}

void print_row(const std::string& name, const Mesh& mesh, const Feature_map& is_feature,
               const std::size_t number, Totals& totals)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
  Mesh quads;
  CGAL::Real_timer timer;
  timer.start();
  const SS::Remeshing_report report = SS::quad_remesh(
    mesh, quads,
    SS::parameters::target_number_of_quads(number).edge_is_constrained_map(is_feature));
  ++totals.tried;
  totals.remeshed += report ? 1 : 0;
  std::cout << "| " << name << " | " << mesh.number_of_faces() << " | " << number << " | ";
  if(report)
    std::cout << report.number_of_quads << " | " << report.number_of_cones << " | "
              << report.number_of_released_edges << " | " << std::fixed << std::setprecision(3)
              << report.least_scaled_jacobian << " | " << report.mean_scaled_jacobian << " | "
              << std::setprecision(2) << 100 * report.largest_distance / diagonal << " | ";
  else
    std::cout << " | | | | | | ";
  std::cout << std::fixed << std::setprecision(2) << timer.time() << " | " << report << " |"
            << std::endl;
}

int main(int argc, char** argv)
{
  std::vector<std::size_t> numbers;
  std::vector<std::string> names;
  double feature_angle = 0; // in degrees; 0: no features
  po::options_description options("Options");
  options.add_options()
    ("quads", po::value(&numbers)->composing(), "sizes (default: 1000, 5000, and 20000)")
    ("feature-angle", po::value(&feature_angle), "edges with a larger angle are features, degrees")
    ("mesh", po::value(&names)->required(), "meshes of any format that CGAL reads, or folders");
  if(const auto exit_code = benchmark::read_command_line(
       argc, argv, "quad_comparison [options] MESH_OR_FOLDER...", options, "mesh"))
    return *exit_code;
  if(numbers.empty())
    numbers = {1000, 5000, 20000};
  std::cout << "| mesh | faces | asked | quads | irregular | released | least Jacobian "
               "| mean Jacobian | distance, % of diagonal | seconds | outcome |\n"
               "|---|---|---|---|---|---|---|---|---|---|---|" << std::endl;
  Totals totals;
  for(const std::string& filename : benchmark::mesh_files_of(names)) {
    const std::string name = std::filesystem::path(filename).filename().string();
    Mesh mesh;
    if(!PMP::IO::read_polygon_mesh(filename, mesh)) {
      std::cout << "| " << name << " | unreadable |" << std::endl;
      continue;
    }
    PMP::triangulate_faces(mesh);
    const Feature_map is_feature =
      mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
    if(feature_angle > 0)
      PMP::detect_sharp_edges(mesh, feature_angle, is_feature);
    for(const std::size_t number : numbers)
      print_row(name, mesh, is_feature, number, totals);
    try_unsnapped(mesh, is_feature, totals);
  }
  std::cout << totals.remeshed << " of " << totals.tried << " remeshed; without snapping, "
            << totals.quantized_unsnapped << " of " << totals.parametrized
            << " parametrizations are exact, and the others refused" << std::endl;
  return EXIT_SUCCESS;
}
