// Triangulates a box of two subdomains, gives it a parametrization with the errors of a solver, and
// makes it exact, also on the boundary and on the interface.

#include <CGAL/Seamless_snapping/snap_volume_to_seamless.h>
#include <CGAL/Seamless_snapping/is_volume_seamless.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Random.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/property_map.h>

#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Triangulation = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<Kernel>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
namespace Snapping = CGAL::Seamless_snapping;

// The box [0,8] x [0,4] x [0,4], divided at x = 4. Mesh generators return such a complex.
C3t3 mesh_of_box(CGAL::Random& random)
{
  C3t3 c3t3;
  Triangulation& triangulation = c3t3.triangulation();
  const auto moved = [&](const int x, const int step, const int size)
  { return x % step == 0 || x == size ? x : x + random.get_double(-0.2, 0.2); };
  for(int x = 0; x <= 8; ++x)
    for(int y = 0; y <= 4; ++y)
      for(int z = 0; z <= 4; ++z)
        triangulation.insert(Point_3(moved(x, 4, 8), moved(y, 4, 4), moved(z, 4, 4)));
  for(const auto cell : triangulation.finite_cell_handles())
    c3t3.add_to_complex(cell, CGAL::centroid(triangulation.tetrahedron(cell)).x() < 4 ? 1 : 2);
  for(const auto& facet : triangulation.finite_facets())
    if(c3t3.subdomain_index(facet.first) !=
       c3t3.subdomain_index(facet.first->neighbor(facet.second)))
      c3t3.add_to_complex(facet, 1);
  return c3t3;
}

int main()
{
  CGAL::Random random(1);
  const C3t3 c3t3 = mesh_of_box(random);
  const auto mesh = Snapping::cells_of_c3t3(c3t3);

  std::vector<Point_3> uvw; // at 4 * i + k: the coordinates of corner k of cell i
  for(const auto cell : mesh.cells)
    for(int k = 0; k < 4; ++k) {
      const Point_3& p = cell->vertex(k)->point();
      // the chart of the second subdomain is turned, and lies elsewhere
      const bool is_turned = c3t3.subdomain_index(cell) == 2;
      const Point_3 u = is_turned ? Point_3(0.1 - p.y(), p.x(), p.z() + 7) : p;
      const auto noise = [&] { return random.get_double(-1e-8, 1e-8); };
      uvw.push_back(u + Kernel::Vector_3(noise(), noise(), noise()));
    }

  const auto np = Snapping::parameters::cell_neighbors(mesh.neighbors)
                                       .feature_facets(mesh.interfaces);
  const auto uvw_map = CGAL::make_property_map(uvw);
  const auto report = Snapping::snap_volume_to_seamless(mesh.tetrahedra, uvw_map, np);
  std::cout << mesh.tetrahedra.size() << " cells, " << mesh.interfaces.size() << " facets between "
            << "subdomains; " << report << ": " << report.run.number_of_cut_edges
            << " cut facets, largest change " << report.largest_change << std::endl;
  return report && Snapping::is_volume_seamless(mesh.tetrahedra, uvw_map, np) ? EXIT_SUCCESS
                                                                              : EXIT_FAILURE;
}
