// Computes a parametrization with a solver of SuiteSparse, and makes it exactly seamless.

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/approximate_seamless_parameterization.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/config.h>

#include <Eigen/CholmodSupport>

#include <cstdlib>
#include <iostream>
#include <string>

namespace SS = CGAL::Seamless_snapping;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Mesh::Halfedge_index;
using Solver = CGAL::Eigen_solver_traits<
  Eigen::CholmodSupernodalLLT<CGAL::Eigen_sparse_matrix<double>::EigenType> >;

int main(int argc, char* argv[])
{
  const std::string input = (argc > 1) ? argv[1] : CGAL::data_file_path("genus2.obj");
  const std::string output = (argc > 2) ? argv[2] : "parameterized.obj";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(input, mesh)) {
    std::cerr << input << ": not a mesh" << std::endl;
    return EXIT_FAILURE;
  }
  auto uv_map = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  const auto made = SS::approximate_seamless_parameterization(
    mesh, uv_map, SS::parameters::sparse_linear_solver(Solver()));
  std::cout << made << ", " << made.number_of_faces << " faces, " << made.seconds_in_solvers
            << " seconds in solvers" << std::endl;
  if(!made)
    return EXIT_FAILURE;

  const auto snapped = SS::snap_to_seamless(mesh, uv_map);
  std::cout << snapped << std::endl;
  return snapped && SS::IO::write_OBJ(output, mesh, uv_map) ? EXIT_SUCCESS : EXIT_FAILURE;
}
