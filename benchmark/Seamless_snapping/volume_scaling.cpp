// How the time and memory of snap_volume_to_seamless() grow with the mesh and the number of charts.
// The yardstick is one pass over the interior facets that compares the coordinates of their
// vertices on both sides: no exact method can do with less.
//
// Meshes: five blocks around a singular edge (volume_generator.h), with a chart for each block,
// each cube of 24 cells, or each cell, and noise of 1e-9 of the extent in every sector; and files
// in the HEXEX format. Each is snapped in a process of its own. Times are those of the processor,
// the shortest of several runs, with the neighbors of cells given; what finding them takes is told
// apart. Memory is the peak resident set during the first snap above what there is before.

#include "benchmark_tools.h"
#include "child_process.h"
#include "command_line.h"

#include "volume_generator.h"

#include <CGAL/Seamless_snapping/IO/HEXEX.h>
#include <CGAL/Seamless_snapping/snap_volume_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace options = benchmark::options;
namespace Snapping = CGAL::Seamless_snapping;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using volume_reference::Tet_map;

struct Settings
{
  std::vector<std::string> files;
  std::vector<int> sizes;
  int repeats = 5;
  unsigned int seed = 1;
  double noise = 1e-9;
};

double processor_seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// --- one map -------------------------------------------------------------------------------------

struct Volume
{
  std::vector<std::array<int, 4> > cells, neighbors;
  std::vector<Point_3> uvw;

  explicit Volume(const Tet_map& map)
    : cells(map.cells), neighbors(map.cells.size(), {{-1, -1, -1, -1}})
  {
    for(const auto& p : map.corners)
      uvw.emplace_back(p[0], p[1], p[2]);
    std::vector<std::pair<std::array<int, 3>, std::size_t> > facets;
    for(std::size_t f = 0; f < uvw.size(); ++f) {
      std::array<int, 3> vertices;
      for(std::size_t k = 0; k < 3; ++k)
        vertices[k] = cells[f / 4][(f + 1 + k) % 4];
      std::sort(vertices.begin(), vertices.end());
      facets.emplace_back(vertices, f);
    }
    std::sort(facets.begin(), facets.end());
    for(std::size_t i = 1; i < facets.size(); ++i)
      if(facets[i].first == facets[i - 1].first)
        for(const auto& [f, d] : {std::make_pair(facets[i].second, facets[i - 1].second),
                                  std::make_pair(facets[i - 1].second, facets[i].second)})
          neighbors[f / 4][f % 4] = int(d / 4);
  }

  // The yardstick: the number of interior facets whose sides differ somewhere.
  std::size_t count_mismatches() const
  {
    std::size_t result = 0;
    for(std::size_t c = 0; c < cells.size(); ++c)
      for(std::size_t k = 0; k < 4; ++k)
        if(const int d = neighbors[c][k]; d > int(c))
          result += std::size_t(!is_same(c, k, std::size_t(d)));
    return result;
  }

private:
  bool is_same(const std::size_t c, const std::size_t k, const std::size_t d) const
  {
    for(std::size_t i = (k + 1) % 4; i != k; i = (i + 1) % 4) {
      std::size_t j = 0;
      while(cells[d][j] != cells[c][i])
        ++j;
      if(uvw[4 * c + i] != uvw[4 * d + j])
        return false;
    }
    return true;
  }
};

struct Measurement
{
  std::size_t cells = 0, cuts = 0, sheets = 0, unknowns = 0, lost = 0;
  double pass = 0, snap = 0, adjacency = 0, bytes_per_cell = 0, change = 0;
  bool is_exact = false;
};

template <typename Run>
double shortest_time(const int repeats, const Run& run)
{
  double best = 0;
  for(int i = 0; i < repeats; ++i) {
    const double seconds = run();
    best = i == 0 ? seconds : (std::min)(best, seconds);
  }
  return best;
}

Measurement measure(Tet_map map, const int repeats)
{
  Volume volume(map);
  Measurement result;
  result.cells = volume.cells.size();
  std::size_t mismatches = 0;
  result.pass = shortest_time((std::max)(5, repeats), [&] {
    const double start = processor_seconds();
    mismatches += volume.count_mismatches();
    return processor_seconds() - start;
  });
  if(mismatches == 0)
    std::cerr << "the input has no cut" << std::endl; // keeps the pass from being optimised away
  const std::vector<Point_3> input(volume.uvw);
  const auto snap = [&](const auto& np) {
    volume.uvw = input;
    const double start = processor_seconds();
    const auto report = Snapping::snap_volume_to_seamless(
      volume.cells, CGAL::make_property_map(volume.uvw), np);
    const double seconds = processor_seconds() - start;
    if(!report)
      throw std::runtime_error(report.message);
    result.cuts = report.run.number_of_cut_edges;
    result.sheets = report.run.number_of_cut_branches;
    result.unknowns = report.linear_solver.number_of_unknowns;
    result.lost = report.lost_faces.size();
    if(report.violation_before > 0)
      result.change = report.largest_change / report.violation_before;
    return seconds;
  };
  const auto with_neighbors = Snapping::parameters::cell_neighbors(std::cref(volume.neighbors));
  benchmark::reset_memory_peak();
  const double before = benchmark::kilobytes("VmRSS:");
  result.snap = snap(with_neighbors);
  result.bytes_per_cell =
    1024 * (benchmark::kilobytes("VmHWM:") - before) / static_cast<double>(result.cells);
  if(repeats > 1)
    result.snap = (std::min)(result.snap, shortest_time(repeats - 1, [&] {
      return snap(with_neighbors);
    }));
  result.adjacency = shortest_time(repeats, [&] {
    return snap(Snapping::parameters::default_values());
  }) - result.snap;
  for(std::size_t i = 0; i < volume.uvw.size(); ++i)
    map.corners[i] = {{volume.uvw[i].x(), volume.uvw[i].y(), volume.uvw[i].z()}};
  result.is_exact = volume_reference::check(map).is_exact();
  return result;
}

// --- a process for each map ----------------------------------------------------------------------

std::string to_text(const Measurement& m)
{
  std::ostringstream os;
  os.precision(17);
  os << m.cells << ' ' << m.cuts << ' ' << m.sheets << ' ' << m.unknowns << ' ' << m.lost << ' '
     << m.pass << ' ' << m.snap << ' ' << m.adjacency << ' ' << m.bytes_per_cell << ' ' << m.change
     << ' ' << m.is_exact;
  return os.str();
}

Measurement from_text(const std::string& text)
{
  Measurement m;
  std::istringstream is(text);
  is >> m.cells >> m.cuts >> m.sheets >> m.unknowns >> m.lost >> m.pass >> m.snap >> m.adjacency >>
    m.bytes_per_cell >> m.change >> m.is_exact;
  return m;
}

// Returns whether that went well.
template <typename MakeMap>
bool measure_in_child(const std::string& name, const Settings& settings, const MakeMap& make_map)
{
  std::string text;
  const auto end = benchmark::run_in_child(
    [&] {
      Tet_map map = make_map();
      if(settings.noise > 0)
        volume_generator::add_noise(map, settings.noise, false, settings.seed);
      return to_text(measure(std::move(map), settings.repeats));
    },
    benchmark::Child_limits(), text);
  if(end != benchmark::Child_end::FINISHED) {
    std::cerr << name << " failed" << std::endl;
    return false;
  }
  const Measurement m = from_text(text);
  std::printf("| %s | %zu | %zu | %zu | %zu | %.1f | %.1f | %.1f | %.0f | %.2f | %zu | %s |\n",
              name.c_str(), m.cells, m.cuts, m.sheets, m.unknowns, 1e3 * m.pass, m.snap / m.pass,
              m.adjacency / m.pass, m.bytes_per_cell, m.change, m.lost, m.is_exact ? "yes" : "NO");
  std::fflush(stdout);
  return true;
}

Tet_map read_file(const std::string& name)
{
  Snapping::IO::HEXEX_mesh mesh;
  if(const auto status = Snapping::IO::read_HEXEX(name, mesh); !status)
    throw std::runtime_error(status.message);
  Tet_map map;
  map.corners = mesh.uvw;
  for(const auto& cell : mesh.tetrahedra)
    map.cells.push_back({{cell[0], cell[1], cell[2], cell[3]}});
  return map;
}

// --- the command line ----------------------------------------------------------------------------

std::optional<int> read_command_line(int argc, char** argv, Settings& settings)
{
  options::options_description description("Options");
  description.add_options()(
    "cubes", options::value(&settings.sizes)->multitoken()->default_value({ 10, 20 }, "10 20"),
    "along the edges of blocks: of 120 cells each, to the third power; 0 for none")(
    "repeats", options::value(&settings.repeats)->default_value(5), "the shortest counts")(
    "seed", options::value(&settings.seed)->default_value(1), "of charts and noise")(
    "noise", options::value(&settings.noise)->default_value(1e-9), "relative to the extent")(
    "files", options::value(&settings.files), "parametrized meshes (HEXEX), or folders");
  const auto exit_code = benchmark::read_command_line(
    argc, argv, "volume_scaling [options] [FILE_OR_FOLDER...]", description, "files");
  settings.repeats = (std::max)(settings.repeats, 1);
  return exit_code;
}

int main(int argc, char** argv)
{
  Settings settings;
  if(const std::optional<int> exit_code = read_command_line(argc, argv, settings))
    return *exit_code;
  std::printf("Passes are those of the yardstick; change is the largest one, in violations.\n\n"
              "| charts, or file | cells | cut facets | sheets | unknowns | pass/ms | passes |"
              " adjacency | bytes/cell | change | lost | exact |\n"
              "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|\n");
  bool is_complete = true;
  using volume_generator::Charts;
  for(const int size : settings.sizes)
    for(const auto& [charts, name] : {std::make_pair(Charts::BLOCKS, "blocks"),
                                      std::make_pair(Charts::CUBES, "cubes"),
                                      std::make_pair(Charts::TETRAHEDRA, "cells")})
      if(size > 0)
        is_complete &= measure_in_child(name, settings, [&, kind = charts] {
          return volume_generator::Tetrahedra_builder(volume_generator::quadrants(5, size), kind,
                                                      settings.seed).build();
        });
  for(const std::string& file : benchmark::files_of(settings.files, {".hexex"}))
    is_complete &= measure_in_child(file.substr(file.find_last_of('/') + 1), settings, [&] {
      return read_file(file);
    });
  return is_complete ? EXIT_SUCCESS : EXIT_FAILURE;
}
