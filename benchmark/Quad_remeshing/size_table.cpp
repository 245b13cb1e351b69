// One table of how well quad_remesh() meets sizes that vary over a surface: for each mesh, sizes
// that grow along its longest side, by an exponential or a linear function, and such that are small
// in the middle.
//
//   size_table [--quads N] [--ratio R] MESH_OR_FOLDER...
//
// The columns: quads, irregular vertices, the mean scaled Jacobian, the median over the edges of
// their length by the size at their middle, and the median and the ninth decile of how far this is
// from 1.

#include "command_line.h"

#include <CGAL/Quad_remeshing/quad_remesh.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace po = benchmark::options;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace QR = CGAL::Quad_remeshing;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Size = std::function<double(double)>; // along the longest side, from 0 to 1

void print_sizes(const std::vector<double>& sizes)
{
  std::vector<double> ratios(sizes), deviations;
  std::sort(ratios.begin(), ratios.end());
  for(const double ratio : ratios)
    deviations.push_back(std::exp(std::abs(std::log(ratio))) - 1);
  std::sort(deviations.begin(), deviations.end());
  std::cout << ratios[ratios.size() / 2] << " | " << deviations[deviations.size() / 2] << " | "
            << deviations[9 * deviations.size() / 10] << " |" << std::endl;
}

void print_row(const std::string& filename, const double number, const std::string& kind,
               const Size& size)
{
  Mesh mesh, quads;
  std::cout << "| " << std::filesystem::path(filename).stem().string() << " | " << kind << " | ";
  if(!PMP::IO::read_polygon_mesh(filename, mesh)) {
    std::cout << "unreadable |" << std::endl;
    return;
  }
  PMP::triangulate_faces(mesh);
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  int axis = 0;
  for(const int i : {1, 2})
    if(box.max(i) - box.min(i) > box.max(axis) - box.min(axis))
      axis = i;
  const double unit = std::sqrt(PMP::area(mesh) / number);
  const auto size_at = [&](const Point_3& p)
    { return unit * size((p[axis] - box.min(axis)) / (box.max(axis) - box.min(axis))); };
  const auto sizes = mesh.add_property_map<Mesh::Vertex_index, double>("v:size").first;
  for(const auto v : mesh.vertices())
    sizes[v] = size_at(mesh.point(v));
  const auto report = QR::quad_remesh(mesh, quads, QR::parameters::vertex_sizing_map(sizes));
  if(!report) {
    std::cout << report << " |" << std::endl;
    return;
  }
  std::vector<double> ratios;
  for(const auto e : quads.edges()) {
    const Point_3 &p = quads.point(quads.vertex(e, 0)), &q = quads.point(quads.vertex(e, 1));
    ratios.push_back(std::sqrt(CGAL::squared_distance(p, q)) / size_at(CGAL::midpoint(p, q)));
  }
  std::cout << report.number_of_quads << " | " << report.number_of_irregular_vertices << " | "
            << report.mean_scaled_jacobian << " | ";
  print_sizes(ratios);
}

int main(int argc, char** argv)
{
  double number = 5000, ratio = 4;
  std::vector<std::string> meshes;
  po::options_description options("Options");
  options.add_options()
    ("quads", po::value(&number), "about how many quads there would be of a single size")
    ("ratio", po::value(&ratio), "of the largest size to the smallest")
    ("mesh", po::value(&meshes)->required(), "meshes of any format that CGAL reads, or folders");
  if(const auto exit_code = benchmark::read_command_line(
       argc, argv, "size_table [options] MESH_OR_FOLDER...", options, "mesh"))
    return *exit_code;
  const double root = std::sqrt(ratio);
  const std::vector<std::pair<std::string, Size> > kinds{
    {"one", [&](double) { return 1.; }},
    {"exponential", [&](const double t) { return std::pow(ratio, t - 0.5); }},
    {"linear", [&](const double t) { return (1 + (ratio - 1) * t) / root; }},
    {"small in the middle", [&](const double t)
     { return std::pow(ratio, 0.5 - std::exp(-20 * (t - 0.5) * (t - 0.5))); }}};
  std::cout << "| mesh | sizes | quads | irregular | mean Jacobian | median ratio "
               "| median deviation | ninth decile |\n|---|---|---|---|---|---|---|---|" << std::endl
            << std::fixed << std::setprecision(3);
  for(const std::string& mesh : benchmark::mesh_files_of(meshes))
    for(const auto& [kind, size] : kinds)
      print_row(mesh, number, kind, size);
  return EXIT_SUCCESS;
}
