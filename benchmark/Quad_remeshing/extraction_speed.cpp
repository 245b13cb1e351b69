// How long the extraction of quads takes, by one thread and by several where TBB is linked, and how
// much memory it needs above its input and its output: on a height field with cones, whose faces
// and quads cross each other everywhere, and on files.

#include "benchmark_tools.h"
#include "command_line.h"

#include "Height_field_surface.h"

#include <CGAL/Quad_remeshing/extract_grid_mesh.h>
#include <CGAL/Quad_remeshing/is_integer_grid_map.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace po = benchmark::options;
namespace QR = CGAL::Quad_remeshing;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;

struct Settings
{
  int runs = 0, threads = 0;
  double quads = 0;
};

// The shortest of several runs, in seconds.
template <typename ConcurrencyTag>
double time_of(const Mesh& mesh, const UV_map& uv, const int runs)
{
  double best = std::numeric_limits<double>::infinity();
  for(int i = 0; i < runs; ++i) {
    Mesh quads;
    const double start = benchmark::seconds_now();
    QR::extract_quad_mesh<ConcurrencyTag>(mesh, uv, quads);
    best = (std::min)(best, benchmark::seconds_now() - start);
  }
  return best;
}

double time_of_threads(const Mesh& mesh, const UV_map& uv, const Settings& settings)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    std::size_t(settings.threads));
#endif
  return time_of<CGAL::Parallel_if_available_tag>(mesh, uv, settings.runs);
}

// Distances in the domain that are multiples of `unit` become integers; all others are rounded to
// them where they have to be.
void measure(Mesh& mesh, const double unit, const Settings& settings, const std::string& name)
{
  const UV_map uv = square_complex::uv_map(mesh);
  const double area = QR::measure_integer_grid(mesh, uv).area;
  const double steps = (std::max)(1., std::round(unit * std::sqrt(settings.quads / area)));
  const auto snap =
    QR::snap_to_seamless(mesh, uv, QR::parameters::integer_grid(true).repair_flips(true)
                                     .align_border(true).rounding_tolerance(10.)
                                     .grid_scale(steps / unit));
  if(!snap) {
    std::cout << name << ": " << snap << std::endl;
    return;
  }
  benchmark::reset_memory_peak();
  const double before = benchmark::kilobytes("VmRSS:");
  Mesh quads;
  const auto report = QR::extract_quad_mesh(mesh, uv, quads);
  const double peak = benchmark::kilobytes("VmHWM:") - before;
  malloc_trim(0);
  const double output = benchmark::kilobytes("VmRSS:") - before;
  if(!report) {
    std::cout << name << ": " << report << std::endl;
    return;
  }
  const std::size_t number = quads.number_of_faces();
  quads = Mesh();
  const double sequential = time_of<CGAL::Sequential_tag>(mesh, uv, settings.runs);
  const double parallel = time_of_threads(mesh, uv, settings);
  std::cout << std::setw(10) << mesh.number_of_faces() << std::setw(10) << number << std::setw(10)
            << std::setprecision(3) << sequential << std::setw(10) << parallel << std::setw(10)
            << std::setprecision(2) << sequential / parallel << std::setw(14)
            << std::setprecision(0) << 1024 * output / double(number) << std::setw(13)
            << 1024 * (peak - output) / double(number) << "  " << name << std::endl;
}

int main(int argc, char* argv[])
{
  Settings settings;
  std::size_t faces = 0, nodes = 0;
  std::vector<std::string> files;
  po::options_description options("Options");
  options.add_options()(
    "runs", po::value(&settings.runs)->default_value(3), "the fastest of so many runs counts")(
    "threads", po::value(&settings.threads)->default_value(2), "of the parallel runs")(
    "quads", po::value(&settings.quads)->default_value(1.06e6), "about")(
    "faces", po::value(&faces)->default_value(1900000), "of the height field; 0 for none")(
    "nodes", po::value(&nodes)->default_value(200), "of the height field")(
    "files", po::value(&files), "parametrized meshes (OBJ), or folders");
  if(const auto exit_code = benchmark::read_command_line(
       argc, argv, "extraction_speed [options] [FILE_OR_FOLDER...]", options, "files"))
    return *exit_code;
  std::cout << std::fixed
            << "     faces     quads  1 thread/s  several/s   ratio  output B/quad  more B/quad"
            << std::endl;
  if(faces > 0) {
    Mesh mesh;
    height_field_surface::Wish wish;
    wish.faces = faces;
    wish.nodes = nodes;
    const double side = height_field_surface::make_surface(wish, mesh);
    measure(mesh, side, settings, "height field");
  }
  for(const std::string& file : benchmark::files_of(files)) {
    Mesh mesh;
    if(QR::IO::read_OBJ(file, mesh, square_complex::uv_map(mesh)))
      measure(mesh, 1e-9, settings, file.substr(file.find_last_of('/') + 1));
    else
      std::cerr << file << ": can't be read" << std::endl;
  }
  return EXIT_SUCCESS;
}
