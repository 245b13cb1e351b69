// Two triangles and their map, which the installed package calls exactly seamless. A check has much
// less code than a snap, and calculates by GMP, too.

#include <CGAL/Seamless_snapping/is_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>

int main()
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  Mesh mesh;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0});
  const auto c = mesh.add_vertex({1, 1, 0}), d = mesh.add_vertex({0, 1, 0});
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, d);
  for(const auto h : mesh.halfedges())
    uv[h] = Kernel::Point_2(mesh.point(mesh.target(h)).x(), mesh.point(mesh.target(h)).y());
  if(CGAL::Seamless_snapping::is_seamless(mesh, uv))
    std::cout << "exactly seamless\n";
}
