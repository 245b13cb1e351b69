// One table of what approximate_seamless_parametrization() does on the given meshes: topology,
// cones, cuts, flips, violation, and time, in total and in the sparse solvers; and whether
// snap_to_seamless() makes the result exact.
//
//   parametrization_table [--subdivide N] [--align-border] MESH_OR_FOLDER...
//
// With --subdivide, each mesh is refined by N rounds of Loop subdivision first.

#include "command_line.h"

#include <CGAL/Quad_remeshing/approximate_seamless_parametrization.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace po = benchmark::options;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace QR = CGAL::Quad_remeshing;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

void print_header()
{
  std::cout << "| mesh | faces | genus | borders | cones | cut edges | aligned | violation | flips "
               "| seconds | in solvers | snapping | exact |\n"
               "|---|---|---|---|---|---|---|---|---|---|---|---|---|" << std::endl;
}

void print_row(const std::string& filename,
               const unsigned int subdivisions,
               const bool align_border)
{
  const std::string name = std::filesystem::path(filename).filename().string();
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh)) {
    std::cout << "| " << name << " | unreadable |" << std::endl;
    return;
  }
  PMP::triangulate_faces(mesh);
  if(subdivisions > 0)
    CGAL::Subdivision_method_3::Loop_subdivision(
      mesh, CGAL::parameters::number_of_iterations(subdivisions));

  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  CGAL::Real_timer timer;
  timer.start();
  const auto alignment = QR::parameters::align_border(align_border);
  const auto report = QR::approximate_seamless_parametrization(mesh, uv, alignment);
  const double seconds = timer.time();
  if(!report) {
    std::cout << "| " << name << " | " << report << " |" << std::endl;
    return;
  }
  timer.reset();
  const bool is_snapped = bool(QR::snap_to_seamless(mesh, uv, alignment));
  const double snapping = timer.time();
  std::cout << "| " << name << " | " << report.number_of_faces << " | " << report.genus << " | "
            << report.number_of_border_loops << " | " << report.cones.size() << " | "
            << report.number_of_cut_edges << " | " << report.number_of_aligned_edges << " | "
            << std::scientific << std::setprecision(1) << report.violation / report.extent << " | "
            << report.number_of_flipped_faces << " | "
            << std::fixed << std::setprecision(2) << seconds << " | " << report.seconds_in_solvers
            << " | " << std::setprecision(5) << snapping << " | "
            << (is_snapped && QR::is_seamless(mesh, uv, alignment) ? "yes" : "NO") << " |"
            << std::endl;
}

int main(int argc, char** argv)
{
  unsigned int subdivisions = 0;
  bool align_border = false;
  std::vector<std::string> meshes;
  po::options_description options("Options");
  options.add_options()
    ("subdivide", po::value(&subdivisions), "rounds of Loop subdivision")
    ("align-border", po::bool_switch(&align_border), "align border edges")
    ("mesh", po::value(&meshes)->required(), "meshes of any format that CGAL reads, or folders");
  if(const auto exit_code = benchmark::read_command_line(
       argc, argv, "parametrization_table [options] MESH_OR_FOLDER...", options, "mesh"))
    return *exit_code;
  print_header();
  for(const std::string& mesh : benchmark::mesh_files_of(meshes))
    print_row(mesh, subdivisions, align_border);
  return EXIT_SUCCESS;
}
