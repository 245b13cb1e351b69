// Remeshes a triangle mesh with quads, divides the quads into rectangular patches, and writes the
// points of each patch, row by row, for a program that fits splines.

#include <CGAL/Quad_remeshing/quad_patches.h>
#include <CGAL/Quad_remeshing/quad_remesh.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace QR = CGAL::Quad_remeshing;
namespace SS = CGAL::Seamless_snapping;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string input = (argc > 1) ? argv[1] : "data/genus3_features.obj";
  const std::size_t number_of_quads = (argc > 2) ? std::size_t(std::atol(argv[2])) : 2000;
  const std::string output = (argc > 3) ? argv[3] : "patches.txt";
  Mesh mesh, quads;
  auto uv_map = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  auto is_kept = quads.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  if(!SS::IO::read_OBJ(input, mesh, uv_map, QR::parameters::edge_is_constrained_map(is_feature)) ||
     !QR::quad_remesh(mesh, quads,
                      QR::parameters::target_number_of_quads(number_of_quads)
                        .edge_is_constrained_map(is_feature),
                      QR::parameters::edge_is_constrained_map(is_kept)))
    return EXIT_FAILURE;

  const auto patches = QR::quad_patches(quads, QR::parameters::edge_is_constrained_map(is_kept));
  std::cout << patches << "\n"
            << patches.patches.size() << " patches of " << quads.number_of_faces() << " quads, "
            << patches.number_of_t_junctions << " T-junctions" << std::endl;
  std::ofstream file(output);
  file.precision(17);
  for(const auto& patch : patches.patches) {
    file << patch.height + 1 << " rows of " << patch.width + 1 << " points\n";
    std::vector<Mesh::Vertex_index> grid;
    QR::vertices_of_patch(patch, quads, std::back_inserter(grid));
    for(const Mesh::Vertex_index v : grid)
      file << quads.point(v) << "\n";
  }
  return patches && file ? EXIT_SUCCESS : EXIT_FAILURE;
}
