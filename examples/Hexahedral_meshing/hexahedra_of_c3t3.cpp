// Makes hexahedra from a complex of tetrahedra, as mesh generators return it, and a map of it.
// Prints their number and their shapes.

#include <CGAL/Hexahedral_meshing/IO/hexahedra.h>
#include <CGAL/Hexahedral_meshing/hexahedral_mesh.h>
#include <CGAL/Seamless_snapping/snap_volume_to_seamless.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Random.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Triangulation = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<Kernel>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
namespace Meshing = CGAL::Hexahedral_meshing;

// The box [0,8] x [0,4] x [0,4].
C3t3 mesh_of_box(CGAL::Random& random)
{
  C3t3 c3t3;
  Triangulation& triangulation = c3t3.triangulation();
  const auto moved = [&](const int x, const int size)
  { return x == 0 || x == size ? x : x + random.get_double(-0.2, 0.2); };
  for(int x = 0; x <= 8; ++x)
    for(int y = 0; y <= 4; ++y)
      for(int z = 0; z <= 4; ++z)
        triangulation.insert(Point_3(moved(x, 8), moved(y, 4), moved(z, 4)));
  for(const auto cell : triangulation.finite_cell_handles())
    c3t3.add_to_complex(cell, 1);
  return c3t3;
}

// The box is bent along its length by half a turn.
Point_3 bent(const Point_3& p)
{
  const double angle = p.x() * std::acos(0.) / 4, radius = 3 + p.y();
  return Point_3(radius * std::cos(angle), -radius * std::sin(angle), p.z());
}

int main(int argc, char** argv)
{
  const std::size_t number = argc > 1 ? std::size_t(std::atoi(argv[1])) : 1000;
  CGAL::Random random(1);
  const C3t3 c3t3 = mesh_of_box(random);
  const auto mesh = Meshing::cells_of_c3t3(c3t3);
  std::vector<Point_3> points, uvw; // uvw at 4 * i + k: of corner k of cell i
  for(const auto vertex : mesh.vertices)
    points.push_back(bent(vertex->point()));
  for(const auto cell : mesh.cells)
    for(int k = 0; k < 4; ++k)
      uvw.push_back(cell->vertex(k)->point());

  Meshing::Hexahedral_mesh hexahedra;
  const auto report = Meshing::hexahedral_mesh(
    points, mesh.tetrahedra, CGAL::make_property_map(uvw), hexahedra,
    Meshing::parameters::target_number_of_hexahedra(number).cell_neighbors(mesh.neighbors));
  std::cout << report << ": " << hexahedra.hexahedra.size() << " hexahedra; scaled Jacobian: least "
            << report.shapes.least_scaled_jacobian << ", mean "
            << report.shapes.mean_scaled_jacobian << std::endl;
  return report && (argc < 3 || Meshing::IO::write_MEDIT(argv[2], hexahedra)) ? EXIT_SUCCESS
                                                                              : EXIT_FAILURE;
}
