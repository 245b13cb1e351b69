// Makes a parametrization exactly seamless, divides the surface into rectangles, and writes them as
// polygons, and as a mesh refined along their sides.

#include <CGAL/Isocurves_and_layouts/copy_to_face_graph.h>
#include <CGAL/Isocurves_and_layouts/Motorcycle_graph.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace IL = CGAL::Isocurves_and_layouts;
namespace SS = CGAL::Seamless_snapping;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string input = (argc > 1) ? argv[1] : "data/genus3_features.obj";
  const std::string output = (argc > 2) ? argv[2] : "layout.obj";
  Mesh mesh;
  auto uv_map = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  const auto features = IL::parameters::edge_is_constrained_map(is_feature);
  if(!SS::IO::read_OBJ(input, mesh, uv_map, features) ||
     !SS::snap_to_seamless(mesh, uv_map, features.align_border(true)))
    return EXIT_FAILURE;

  const IL::Motorcycle_graph<Mesh> graph = IL::motorcycle_graph(mesh, uv_map, features);
  if(!graph) {
    std::cerr << graph.status() << ": " << graph.message() << std::endl;
    return EXIT_FAILURE;
  }
  CGAL::Exact_rational area(0);
  for(std::size_t p = 0; p < graph.number_of_patches(); ++p)
    area += graph.patch_width(p) * graph.patch_height(p);
  std::cout << graph.number_of_patches() << " rectangles of area " << CGAL::to_double(area)
            << " in all" << std::endl;

  Mesh rectangles;
  if(IL::copy_to_face_graph(graph, rectangles))
    CGAL::IO::write_OFF(output + ".off", rectangles);
  std::ofstream os(output);
  return IL::IO::write_layout(os, graph) ? EXIT_SUCCESS : EXIT_FAILURE;
}
