// Makes the parametrization of a tetrahedral mesh exactly seamless, for hexahedral meshing.

#include <CGAL/Seamless_snapping/IO/HEXEX.h>
#include <CGAL/Seamless_snapping/is_volume_seamless.h>
#include <CGAL/Seamless_snapping/snap_volume_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace Snapping = CGAL::Seamless_snapping;
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : "data/three_quadrants.hexex";
  Snapping::IO::HEXEX_mesh mesh;
  if(const auto status = Snapping::IO::read_HEXEX(filename, mesh); !status) {
    std::cerr << filename << ": " << status.message << std::endl;
    return EXIT_FAILURE;
  }
  std::vector<Point_3> uvw; // at 4 * i + k: the coordinates of corner k of cell i
  for(const auto& u : mesh.uvw)
    uvw.emplace_back(u[0], u[1], u[2]);

  const auto report = Snapping::snap_volume_to_seamless(mesh.tetrahedra,
                                                        CGAL::make_property_map(uvw));
  std::cout << report << ": " << report.run.number_of_cut_edges << " cut facets in "
            << report.run.number_of_cut_branches << " sheets; largest violation "
            << report.violation_before << ", largest change " << report.largest_change << "\n";
  if(!report || !Snapping::is_volume_seamless(mesh.tetrahedra, CGAL::make_property_map(uvw)))
    return EXIT_FAILURE;

  for(std::size_t i = 0; i < uvw.size(); ++i)
    mesh.uvw[i] = {{uvw[i].x(), uvw[i].y(), uvw[i].z()}};
  return argc < 3 || Snapping::IO::write_HEXEX(argv[2], mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
