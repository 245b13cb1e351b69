// Reads a triangle mesh with coordinates per corner, makes it exactly seamless, and writes it.

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Mesh::Halfedge_index;

int main(int argc, char* argv[])
{
  const std::string input = (argc > 1) ? argv[1] : "data/genus3_border.obj";
  const std::string output = (argc > 2) ? argv[2] : "snapped.obj";

  Mesh mesh;
  auto uv_map = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  const auto read = CGAL::Seamless_snapping::IO::read_OBJ(input, mesh, uv_map);
  if(!read) {
    std::cerr << input << ": " << read << std::endl;
    return EXIT_FAILURE;
  }

  const auto report = CGAL::Seamless_snapping::snap_to_seamless(mesh, uv_map);
  std::cout << report << "\n"
            << "violation before: " << report.violation_before << "\n"
            << "largest change:   " << report.largest_change << std::endl;
  if(!report)
    return EXIT_FAILURE;

  const auto written = CGAL::Seamless_snapping::IO::write_OBJ(output, mesh, uv_map);
  if(!written)
    std::cerr << output << ": " << written << std::endl;
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
