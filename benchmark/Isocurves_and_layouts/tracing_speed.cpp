// How fast isocurves are traced: crossings per second of all separatrices of a parametrization,
// exactly and in floating point, with and without keeping the points of the curves; kept also by
// several threads, where TBB is linked.

#include "benchmark_tools.h"
#include "command_line.h"

#include <CGAL/Isocurves_and_layouts/trace_isocurve.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace po = benchmark::options;
namespace IL = CGAL::Isocurves_and_layouts;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Tracer = IL::Isocurve_tracer<Mesh>;

// Walks without keeping anything.
template <typename MakeDecisions>
std::size_t walk_all(const Tracer& tracer, const std::size_t maximum_number,
                     const MakeDecisions& make_decisions)
{
  const auto& mesh = tracer.chart_mesh();
  IL::internal::Walk_limits limits;
  limits.maximum_number = maximum_number;
  std::size_t crossings = 0;
  for(std::size_t v = 0; v < mesh.is_singular.size(); ++v)
    if(mesh.is_singular[v])
      for(const auto& ray : IL::internal::rays_from_vertex(mesh, v)) {
        const auto decisions = make_decisions();
        IL::internal::Isocurve_walk<std::decay_t<decltype(decisions)>> walk(mesh, limits,
                                                                            decisions);
        walk.begin_at_vertex(ray);
        IL::internal::run(walk, [](const auto&) { });
        crossings += walk.number_of_crossings();
      }
  return crossings;
}

template <typename ConcurrencyTag>
std::size_t keep_all(const Tracer& tracer, const std::size_t maximum_number)
{
  std::size_t crossings = 0;
  for(const auto& curve : tracer.separatrices<ConcurrencyTag>(
        IL::parameters::maximum_number(maximum_number)))
    crossings += curve.number_of_crossings;
  return crossings;
}

// Million crossings per second, of the fastest of several runs.
template <typename Run>
double speed(const int runs, std::size_t& crossings, const Run& run)
{
  double best = 0;
  for(int i = 0; i < runs; ++i) {
    const double start = benchmark::seconds_now();
    crossings = run();
    best = (std::max)(best, double(crossings) / (benchmark::seconds_now() - start) / 1e6);
  }
  return best;
}

void measure(const std::string& file, const int runs, const std::size_t maximum_number)
{
  Mesh mesh;
  UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  if(!IL::IO::read_OBJ(file, mesh, uv) || !IL::snap_to_seamless(mesh, uv)) {
    std::cerr << file << ": can't be read or snapped" << std::endl;
    return;
  }
  const double start = benchmark::seconds_now();
  const Tracer tracer(mesh, uv);
  const double preparation = benchmark::seconds_now() - start;

  std::size_t crossings = 0, other_crossings = 0;
  const double exact = speed(runs, crossings, [&] {
    return walk_all(tracer, maximum_number, [&] {
      return IL::internal::Exact_decisions(tracer.chart_mesh());
    });
  });
  const IL::internal::Walk_limits nowhere;
  using Naive = IL::internal::Basic_floating_point_decisions<IL::internal::Quarter_turns>;
  const double naive = speed(runs, other_crossings, [&] {
    return walk_all(tracer, maximum_number, [&] {
      return Naive(tracer.chart_mesh(), nowhere, IL::internal::no_index, 0, 0);
    });
  });
  const double kept = speed(runs, other_crossings, [&] {
    return keep_all<CGAL::Sequential_tag>(tracer, maximum_number);
  });
  const double threaded = speed(runs, other_crossings, [&] {
    return keep_all<CGAL::Parallel_if_available_tag>(tracer, maximum_number);
  });
  std::cout << std::setw(10) << mesh.number_of_faces() << std::setw(12) << crossings
            << std::setw(12) << 1000 * preparation << std::setw(12) << exact << std::setw(12)
            << kept << std::setw(12) << threaded << std::setw(12) << naive << "  "
            << file.substr(file.find_last_of('/') + 1)
            << std::endl;
}

int main(int argc, char* argv[])
{
  int runs = 0;
  std::size_t maximum_number = 0;
  std::vector<std::string> files;
  po::options_description options("Options");
  options.add_options()(
    "runs", po::value(&runs)->default_value(5), "the fastest of so many runs counts")(
    "maximum-number", po::value(&maximum_number)->default_value(10000), "crossings per curve")(
    "files", po::value(&files)->required(), "parametrized meshes (OBJ), or folders");
  if(const auto exit_code = benchmark::read_command_line(
       argc, argv, "tracing_speed [options] FILE_OR_FOLDER...", options, "files"))
    return *exit_code;
  std::cout << std::fixed << std::setprecision(1)
            << "     faces   crossings     prep/ms     exact/s      kept/s  threaded/s     naive/s"
               "  (million crossings per second)" << std::endl;
  for(const std::string& file : benchmark::files_of(files))
    measure(file, runs, maximum_number);
  return EXIT_SUCCESS;
}
