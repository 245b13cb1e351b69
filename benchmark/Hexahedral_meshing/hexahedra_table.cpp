// Hexahedra of the maps in files: how many there are where a number is wanted, their shapes before
// and after vertices moved, and how long it takes: from the map of the file to the mesh, and the
// extraction alone, by one thread and by several if TBB is linked. The times of one thread are CPU
// times. Times of extractions are the shortest of several runs; memory is the peak during the
// extraction above what there is before, with the result.

#include "benchmark_tools.h"
#include "command_line.h"

#include <CGAL/Hexahedral_meshing/extract_hexahedra.h>
#include <CGAL/Hexahedral_meshing/hexahedral_mesh.h>
#include <CGAL/Seamless_snapping/IO/HEXEX.h>
#include <CGAL/Seamless_snapping/snap_volume_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace options = benchmark::options;
namespace Meshing = CGAL::Hexahedral_meshing;
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;

double cpu_seconds()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

struct Settings
{
  std::vector<std::string> files;
  std::size_t number = 2000;
  int runs = 1;
};

std::vector<Point_3> points_of(const std::vector<std::array<double, 3> >& uvw)
{
  std::vector<Point_3> result;
  for(const auto& u : uvw)
    result.emplace_back(u[0], u[1], u[2]);
  return result;
}

// Of the extraction alone, in seconds; and kilobytes, where that is asked for.
template <typename ConcurrencyTag>
double time_of_extraction(const Meshing::IO::HEXEX_mesh& mesh, std::vector<Point_3>& uvw,
                          const int runs, double* const memory = nullptr)
{
  double best = std::numeric_limits<double>::infinity();
  for(int i = 0; i < runs; ++i) {
    std::vector<std::array<double, 3> > points;
    std::vector<std::array<std::int32_t, 8> > hexahedra;
    benchmark::reset_memory_peak();
    const double before = benchmark::kilobytes("VmRSS:");
    constexpr bool is_one = std::is_same<ConcurrencyTag, CGAL::Sequential_tag>::value;
    const auto now = [] { return is_one ? cpu_seconds() : benchmark::seconds_now(); };
    const double start = now();
    const auto report = Meshing::extract_hexahedra<ConcurrencyTag>(
      mesh.points, mesh.tetrahedra, CGAL::make_property_map(uvw), points, hexahedra);
    best = (std::min)(best, now() - start);
    if(!report)
      return std::numeric_limits<double>::quiet_NaN();
    if(memory != nullptr)
      *memory = benchmark::kilobytes("VmHWM:") - before;
  }
  return best;
}

void write_row(const std::string& file, const Settings& settings)
{
  Meshing::IO::HEXEX_mesh mesh;
  if(const auto status = Meshing::IO::read_HEXEX(file, mesh); !status) {
    std::cerr << file << ": " << status.message << std::endl;
    return;
  }
  std::vector<Point_3> uvw = points_of(mesh.uvw);
  Meshing::Hexahedral_mesh hexahedra;
  const double start = cpu_seconds();
  const auto report = Meshing::hexahedral_mesh(
    mesh.points, mesh.tetrahedra, CGAL::make_property_map(uvw), hexahedra,
    Meshing::parameters::target_number_of_hexahedra(settings.number)
      .feature_facets(mesh.feature_facets)
      .feature_edges(mesh.feature_edges));
  const double time = cpu_seconds() - start;
  std::cout << "| " << std::filesystem::path(file).stem().string() << " | "
            << mesh.tetrahedra.size() << " | ";
  if(!report) {
    std::cout << report.status << " after " << report.number_of_attempts
              << " scales | | | | | | | | |" << std::endl;
    return;
  }
  // the same integers again, for the extraction alone
  Meshing::snap_volume_to_seamless(
    mesh.tetrahedra, CGAL::make_property_map(uvw),
    Meshing::parameters::integer_grid(true).grid_scale(report.grid_scale).rounding_tolerance(1e9)
      .repair_flips(Meshing::Flip_repair::UNTANGLE).feature_facets(mesh.feature_facets)
      .feature_edges(mesh.feature_edges));
  std::size_t irregular = 0;
  for(const auto& [number, edges] : report.irregular_edges)
    irregular += edges;
  double memory = 0;
  const double one = time_of_extraction<CGAL::Sequential_tag>(mesh, uvw, settings.runs, &memory);
  const double several =
    time_of_extraction<CGAL::Parallel_if_available_tag>(mesh, uvw, settings.runs);
  const auto& before = report.shapes_before.nonpositive_hexahedra;
  const auto& after = report.shapes.nonpositive_hexahedra;
  std::cout << report.number_of_hexahedra << " | " << irregular << " | " << before.size() << " | "
            << after.size() << " | " << report.shapes.least_scaled_jacobian << " | "
            << report.shapes.mean_scaled_jacobian << " | " << time << " | " << one << " | "
            << several << " | " << 1024 * memory / double(report.number_of_hexahedra) << " |"
            << std::endl;
}

int main(int argc, char** argv)
{
  Settings settings;
  options::options_description description("options");
  description.add_options()
    ("number", options::value(&settings.number)->default_value(2000), "of hexahedra wanted")
    ("runs", options::value(&settings.runs)->default_value(1), "of each extraction")
    ("files", options::value(&settings.files)->required(), "HEXEX files, and folders of them");
  if(const auto exit = benchmark::read_command_line(
       argc, argv, "hexahedra_table [options] FILES...", description, "files"))
    return *exit;
  std::cout << "| map | cells | hexahedra | irregular edges | not positive before | after "
               "| least scaled Jacobian | mean | s in all | s extraction | s by several threads "
               "| bytes a hexahedron |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n"
            << std::setprecision(3);
  for(const std::string& file : benchmark::files_of(settings.files, {".hexex"}))
    write_row(file, settings);
  return EXIT_SUCCESS;
}
