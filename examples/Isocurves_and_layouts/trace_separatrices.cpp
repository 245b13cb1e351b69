// Snaps a parametrization, traces the isocurves from all its singular vertices, and counts how they
// end.

#include <CGAL/Isocurves_and_layouts/trace_isocurve.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace IL = CGAL::Isocurves_and_layouts;
namespace SS = CGAL::Seamless_snapping;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string input = (argc > 1) ? argv[1] : "data/genus3_features.obj";
  Mesh mesh;
  auto uv_map = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  if(!SS::IO::read_OBJ(input, mesh, uv_map) || !SS::snap_to_seamless(mesh, uv_map))
    return EXIT_FAILURE;

  std::vector<IL::Isocurve<Mesh> > curves;
  IL::trace_all_separatrices(mesh, uv_map, std::back_inserter(curves),
                             IL::parameters::maximum_number(10000));
  std::map<IL::Isocurve_status, std::size_t> number;
  for(const auto& curve : curves)
    ++number[curve.status];
  for(const auto& [status, n] : number)
    std::cout << n << " curves: " << status << "\n";

  if(!curves.empty())
    std::cout << "the first one leads to "
              << IL::isocurve_point_3(curves.front().points.back(), mesh, uv_map, mesh.points())
              << std::endl;
  return EXIT_SUCCESS;
}
