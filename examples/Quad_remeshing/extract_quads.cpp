// Makes a parametrization an exact integer-grid map of about as many quads as you ask for, and
// extracts the quads.

#include <CGAL/Quad_remeshing/extract_grid_mesh.h>
#include <CGAL/Quad_remeshing/is_integer_grid_map.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace QR = CGAL::Quad_remeshing;
namespace SS = CGAL::Seamless_snapping;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string input = (argc > 1) ? argv[1] : "data/genus3_features.obj";
  const double number_of_quads = (argc > 2) ? std::atof(argv[2]) : 20000;
  const std::string output = (argc > 3) ? argv[3] : "quads.off";
  Mesh mesh;
  auto uv_map = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  if(!SS::IO::read_OBJ(input, mesh, uv_map))
    return EXIT_FAILURE;

  // After the scaling, integers can be at any distance.
  const double area = QR::measure_integer_grid(mesh, uv_map).area;
  const auto snapped = SS::snap_to_seamless(
    mesh, uv_map,
    QR::parameters::integer_grid(true)
      .grid_scale(std::sqrt(number_of_quads / area))
      .rounding_tolerance(10.));
  std::cout << "snapping: " << snapped << std::endl;
  if(!snapped)
    return EXIT_FAILURE;

  Mesh quads;
  const auto extracted = QR::extract_quad_mesh(mesh, uv_map, quads);
  std::cout << "extraction: " << extracted << "\n"
            << extracted.number_of_faces << " quads around " << extracted.number_of_cones
            << " cones" << std::endl;
  return extracted && CGAL::IO::write_OFF(output, quads) ? EXIT_SUCCESS : EXIT_FAILURE;
}
