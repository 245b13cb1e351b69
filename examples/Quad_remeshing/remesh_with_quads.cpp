// Remeshes a triangle mesh with about as many quads as you ask for. The quads follow sharp edges
// that are features.

#include <CGAL/Quad_remeshing/detect_features.h>
#include <CGAL/Quad_remeshing/quad_remesh.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace QR = CGAL::Quad_remeshing;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string input = (argc > 1) ? argv[1] : "data/genus3.off";
  const std::size_t number_of_quads = (argc > 2) ? std::size_t(std::atol(argv[2])) : 2000;
  const std::string output = (argc > 3) ? argv[3] : "quads.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(input, mesh)) {
    std::cerr << "cannot read " << input << std::endl;
    return EXIT_FAILURE;
  }
  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  const double edge_length =
    std::sqrt(CGAL::Polygon_mesh_processing::area(mesh) / double(number_of_quads));
  QR::detect_features(mesh, 40, edge_length, is_feature); // sharper than 40 degrees

  // A program with a window shows these lines, and throws an exception here to stop the work.
  const auto show = [](const std::string& line) { std::cerr << line << "\n"; };
  Mesh quads;
  const auto report = QR::quad_remesh(mesh, quads,
                                      QR::parameters::visitor(show)
                                        .target_number_of_quads(number_of_quads)
                                        .edge_is_constrained_map(is_feature));
  std::cout << report << "\n";
  std::cout << report.number_of_quads << " quads, " << report.number_of_irregular_vertices
            << " irregular vertices; scaled Jacobian: least " << report.least_scaled_jacobian
            << ", mean " << report.mean_scaled_jacobian << std::endl;
  return report && CGAL::IO::write_polygon_mesh(output, quads) ? EXIT_SUCCESS : EXIT_FAILURE;
}
