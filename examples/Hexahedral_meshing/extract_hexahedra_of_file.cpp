// Makes an integer-grid map of the parametrization of a tetrahedral mesh, and extracts hexahedra.

#include <CGAL/Hexahedral_meshing/extract_hexahedra.h>
#include <CGAL/Seamless_snapping/IO/HEXEX.h>
#include <CGAL/Seamless_snapping/snap_volume_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace Meshing = CGAL::Hexahedral_meshing;
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : "data/three_quadrants.hexex";
  const double scale = argc > 2 ? std::atof(argv[2]) : 5; // units of the grid, per unit of the map
  Meshing::IO::HEXEX_mesh mesh;
  if(const auto status = Meshing::IO::read_HEXEX(filename, mesh); !status) {
    std::cerr << filename << ": " << status.message << std::endl;
    return EXIT_FAILURE;
  }
  std::vector<Point_3> uvw; // at 4 * i + k: the coordinates of corner k of cell i
  for(const auto& u : mesh.uvw)
    uvw.emplace_back(u[0], u[1], u[2]);

  const auto snapping = Meshing::snap_volume_to_seamless(
    mesh.tetrahedra, CGAL::make_property_map(uvw),
    Meshing::parameters::integer_grid(true).grid_scale(scale).rounding_tolerance(10));
  std::cout << snapping << "\n";

  std::vector<Point_3> points;
  std::vector<std::array<int, 8> > hexahedra;
  const auto report = Meshing::extract_hexahedra(mesh.points, mesh.tetrahedra,
                                                 CGAL::make_property_map(uvw), points, hexahedra);
  std::cout << report << ": " << hexahedra.size() << " hexahedra, " << points.size()
            << " vertices" << std::endl;
  return report ? EXIT_SUCCESS : EXIT_FAILURE;
}
