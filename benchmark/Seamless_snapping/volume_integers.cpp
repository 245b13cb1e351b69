// How few hexahedra the integers of snap_volume_to_seamless() serve: for each file in the HEXEX
// format and each number, the map is scaled such that its volume is that number, and rounded to an
// integer grid. A grid is clean if no cell is flipped or degenerate.

#include "benchmark_tools.h"
#include "command_line.h"

#include <CGAL/Seamless_snapping/IO/HEXEX.h>
#include <CGAL/Seamless_snapping/is_volume_seamless.h>
#include <CGAL/Seamless_snapping/snap_volume_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace options = benchmark::options;
namespace Snapping = CGAL::Seamless_snapping;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;

struct Settings
{
  std::vector<std::string> files;
  std::vector<double> numbers;
};

// Prints the number of hexahedra, or why the grid is not clean. Returns whether it is.
bool measure(const Snapping::IO::HEXEX_mesh& mesh, const double number)
{
  std::vector<Point_3> uvw;
  for(const auto& u : mesh.uvw)
    uvw.emplace_back(u[0], u[1], u[2]);
  const auto uvw_map = CGAL::make_property_map(uvw);
  const auto grid = [&] { return Snapping::measure_volume_integer_grid(mesh.tetrahedra, uvw_map); };
  constexpr double any_distance = 1e9;
  const auto report = Snapping::snap_volume_to_seamless(
    mesh.tetrahedra, uvw_map,
    Snapping::parameters::integer_grid(true)
      .grid_scale(std::cbrt(number / grid().volume))
      .rounding_tolerance(any_distance)
      .repair_flips(Snapping::Flip_repair::UNTANGLE));
  const std::size_t bad = report.lost_faces.size() + report.remaining_flips.size();
  if(!report)
    std::printf(" refused |");
  else if(bad > 0)
    std::printf(" %zu flipped |", bad);
  else
    std::printf(" %.0f |", grid().volume);
  std::fflush(stdout);
  return report && bad == 0;
}

std::optional<int> read_command_line(int argc, char** argv, Settings& settings)
{
  options::options_description description("Options");
  description.add_options()(
    "numbers",
    options::value(&settings.numbers)->multitoken()->default_value(
      { 100, 300, 1000, 3000, 10000 }, "100 300 1000 3000 10000"), "of hexahedra")(
    "files", options::value(&settings.files), "parametrized meshes (HEXEX), or folders");
  return benchmark::read_command_line(argc, argv, "volume_integers [options] FILE_OR_FOLDER...",
                                      description, "files");
}

int main(int argc, char** argv)
{
  Settings settings;
  if(const std::optional<int> exit_code = read_command_line(argc, argv, settings))
    return *exit_code;
  std::printf("| map | cells |");
  for(const double number : settings.numbers)
    std::printf(" %.0f |", number);
  std::printf(" seconds |\n|---|--:|");
  for(std::size_t k = 0; k <= settings.numbers.size(); ++k)
    std::printf("--:|");
  std::printf("\n");
  std::vector<std::size_t> clean(settings.numbers.size(), 0);
  const std::vector<std::string> files = benchmark::files_of(settings.files, {".hexex"});
  for(const std::string& file : files) {
    Snapping::IO::HEXEX_mesh mesh;
    if(const auto status = Snapping::IO::read_HEXEX(file, mesh); !status) {
      std::cerr << file << ": " << status.message << std::endl;
      return EXIT_FAILURE;
    }
    std::printf("| %s | %zu |", file.substr(file.find_last_of('/') + 1).c_str(),
                mesh.tetrahedra.size());
    const std::clock_t start = std::clock();
    for(std::size_t k = 0; k < settings.numbers.size(); ++k)
      clean[k] += std::size_t(measure(mesh, settings.numbers[k]));
    std::printf(" %.1f |\n", static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::printf("| clean, of %zu | |", files.size());
  for(const std::size_t n : clean)
    std::printf(" %zu |", n);
  std::printf(" |\n");
  return EXIT_SUCCESS;
}
