// Quads of the same maps, extracted exactly and in floating point: how many darts the latter loses
// as the gaps at the cuts grow; and the numbers of quads, to compare with those of other programs.

#include "benchmark_tools.h"
#include "command_line.h"
#include "naive_extraction.h"

#include <CGAL/Quad_remeshing/extract_grid_mesh.h>
#include <CGAL/Quad_remeshing/is_integer_grid_map.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace po = benchmark::options;
namespace QR = CGAL::Quad_remeshing;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;

QR::internal::Chart_mesh chart_mesh(const Mesh& mesh, const UV_map& uv)
{
  return QR::internal::build_chart_mesh<QR::internal::Quarter_turns>(
    mesh, QR::internal::Flat_numbering<Mesh>(mesh), uv, QR::seam_transitions(mesh, uv).data());
}

// Each sector moves by itself, by up to `gap` times the extent: its corners between two cuts.
void open_cuts(QR::internal::Chart_mesh& mesh, const double gap)
{
  std::mt19937_64 random(1);
  const auto number = [&] { return gap * mesh.extent * (double(random() % 2001) / 1000 - 1); };
  for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    QR::internal::Uv d{0, 0};
    QR::internal::for_each_corner(mesh, v, [&](const QR::internal::Corner_index h) {
      mesh.corners[std::size_t(h)].uv[0] += d[0];
      mesh.corners[std::size_t(h)].uv[1] += d[1];
      if(mesh.corner(h).transition != QR::internal::no_index)
        d = {number(), number()};
    });
  }
}

void compare(const std::string& file, const double number)
{
  Mesh mesh;
  UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  if(!QR::IO::read_OBJ(file, mesh, uv)) {
    std::cerr << file << ": can't be read" << std::endl;
    return;
  }
  std::cout << file.substr(file.find_last_of('/') + 1) << std::endl;
  const double area = QR::measure_integer_grid(mesh, uv).area;
  const auto snapped = QR::snap_to_seamless(
    mesh, uv,
    QR::parameters::integer_grid(true).grid_scale(number > 0 ? std::sqrt(number / area) : 1.)
      .rounding_tolerance(number > 0 ? 10. : 0.01).repair_flips(true));
  std::cout << "  snapped: " << snapped << ", largest rounding " << snapped.largest_rounding
            << ", faces not positive " << snapped.lost_faces.size() + snapped.remaining_flips.size()
            << std::endl;
  if(!snapped)
    return;
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t> > polygons;
  const double start = benchmark::seconds_now();
  const auto report = QR::extract_quad_soup(mesh, uv, points, polygons,
                                            QR::parameters::allow_holes(true));
  std::cout << "  exact: " << report << ", area " << report.area << ", "
            << report.number_of_faces - report.number_of_other_polygons << " quads, "
            << report.number_of_other_polygons << " other polygons, " << report.number_of_cut_cells
            << " pieces, " << benchmark::seconds_now() - start << " s" << std::endl;
  if(!snapped.remaining_flips.empty() || !snapped.lost_faces.empty())
    return;
  std::cout << "       gap     points      darts       lost     uneven" << std::endl;
  for(const double gap : {0., 1e-16, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4}) {
    QR::internal::Chart_mesh opened = chart_mesh(mesh, uv);
    open_cuts(opened, gap);
    const naive_extraction::Counts counts = naive_extraction::Extraction(opened).run();
    std::cout << std::setw(10) << gap << std::setw(11) << counts.points << std::setw(11)
              << counts.darts << std::setw(11) << counts.lost << std::setw(11) << counts.uneven
              << std::endl;
  }
}

int main(int argc, char* argv[])
{
  std::vector<std::string> files;
  double number = 0;
  po::options_description options("Options");
  options.add_options()(
    "number", po::value(&number),
    "scale maps to so many quads, and round as far as needed; else they must be integer-grid maps")(
    "files", po::value(&files)->required(), "parametrized meshes (OBJ), or folders");
  if(const auto exit_code = benchmark::read_command_line(
       argc, argv, "extraction_comparison [options] FILE_OR_FOLDER...", options, "files"))
    return *exit_code;
  for(const std::string& file : benchmark::files_of(files))
    compare(file, number);
  return EXIT_SUCCESS;
}
