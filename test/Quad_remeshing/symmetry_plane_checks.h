// Checks of planes of symmetry of meshes that are not symmetric exactly.

#ifndef QUAD_REMESHING_SYMMETRY_PLANE_CHECKS_H
#define QUAD_REMESHING_SYMMETRY_PLANE_CHECKS_H

#include <CGAL/Quad_remeshing/find_symmetry_plane.h>

#include "checking.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace symmetry_plane_checks {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vector_3 = Kernel::Vector_3;
namespace QR = CGAL::Quad_remeshing;

// The coordinate after printing with six decimals.
Kernel::Point_3 printed(const Kernel::Point_3& p)
{
  std::array<double, 3> x{p.x(), p.y(), p.z()};
  for(double& c : x)
    c = std::round(c * 1e6) / 1e6;
  return Kernel::Point_3(x[0], x[1], x[2]);
}

// \param mesh a torus around a point of the x-axis, whose plane across this axis is exact
void test_perturbed(const Mesh& mesh, const Kernel::Plane_3& plane)
{
  const auto tolerance = [](const double x) { return QR::parameters::tolerance(x); };
  const double infinity = std::numeric_limits<double>::infinity();
  Mesh digits = mesh, rounded = mesh;
  for(const auto v : mesh.vertices()) {
    const double x = std::size_t(v) % 2 == 0 ? 8.7e-19 : -4e-7;
    digits.point(v) = printed(mesh.point(v) + Vector_3(x, x, x));
  }
  rounded.point(Mesh::Vertex_index(5)) = mesh.point(Mesh::Vertex_index(5)) + Vector_3(0, 1e-15, 0);
  rounded.point(Mesh::Vertex_index(7)) = mesh.point(Mesh::Vertex_index(7)) +
                                         Vector_3(0, 1e-9, 1e-9);
  for(const Mesh* m : {&digits, &rounded}) {
    const auto found = QR::find_symmetry_plane(*m);
    CHECK(found && found->a() + found->b() + found->c() == 1);
    CHECK(found && std::abs(found->d() - found->a() * plane.d()) <= 1e-5);
    CHECK(!QR::find_symmetry_plane(*m, tolerance(0)).has_value());
  }

  // one vertex sticks out: no plane, and the nearest one is where it was, even if no vertex is as
  // far off by another plane
  Mesh bulge = mesh;
  auto& p = bulge.point(Mesh::Vertex_index(5));
  p = p + Vector_3(0, 0.2, 0.2);
  CHECK(!QR::find_symmetry_plane(bulge).has_value());
  const auto nearest = QR::find_symmetry_plane(bulge, tolerance(infinity));
  CHECK(nearest && nearest->a() + nearest->b() + nearest->c() == 1);
  CHECK(nearest && std::abs(nearest->d() - nearest->a() * plane.d()) <= 1e-12);
  Mesh skew = mesh;
  for(const auto v : mesh.vertices()) {
    const Kernel::Point_3& q = mesh.point(v);
    skew.point(v) =
      Kernel::Point_3(q.x() + 0.01 * q.z() * q.z() * q.y(), q.y() + 0.1 * q.x(), q.z());
  }
  skew.point(Mesh::Vertex_index(5)) = skew.point(Mesh::Vertex_index(5)) + Vector_3(0, 0, 0.5);
  const auto across_z = QR::find_symmetry_plane(skew, tolerance(infinity));
  CHECK(across_z && across_z->c() == 1 && std::abs(across_z->d()) <= 1e-12);
}

} // namespace symmetry_plane_checks

#endif // QUAD_REMESHING_SYMMETRY_PLANE_CHECKS_H
