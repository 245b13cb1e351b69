// How the elimination behaves when connections between random singular vertices are added to the
// constraints of a parametrization, in the way of Table 3 and Fig. 2 of the paper: the largest
// coefficient and pivot that occur, how many pivots are not 1 or -1, and the time against the
// number of nodes.
//
// Feature and border edges that lie on isocurves are aligned. Each result is checked in exact
// arithmetic, by code that shares nothing with the package. Times are those of the elimination of
// the reduced system, the shortest of several runs.

#include "benchmark_tools.h"
#include "command_line.h"
#include "log_log_plot.h"

#include "Parametrized_model.h"
#include "exact_seamless_check.h"
#include "random_constraints.h"
#include "reduced_seamless_system.h"
#include "textbook_method.h"

#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace options = benchmark::options;
namespace SS = CGAL::Seamless_snapping;

using Mesh = Parametrized_model::Mesh;

struct Settings
{
  std::vector<std::string> files;
  std::vector<std::size_t> connections;
  std::size_t cycles;
  std::uint64_t seed;
  int repeats;
  bool with_textbook;
  std::string svg;
};

struct Measurement
{
  std::size_t nodes = 0;
  double seconds = 0;
  SS::Snapping_report report;
  exact_reference::Integer largest_of_textbook = exact_reference::Integer(0);
  bool is_exact = false;
};

// --- one model, one number of connections --------------------------------------------------------

// Snaps the model, and checks it.
template <typename Connections, typename Cycles, typename NamedParameters>
bool snap_and_check(Parametrized_model& model, const SS::Seam_transitions<Mesh>& transitions,
                    const Connections& connections, const Cycles& cycles,
                    const NamedParameters& parameters)
{
  if(!SS::snap_to_seamless(model.mesh, model.uv, parameters))
    return false;
  const auto is_held = [&](const auto& constraint) {
    return random_constraints::is_connected(model.mesh, model.uv, transitions, constraint);
  };
  return exact_check::check_edges(
           model.mesh, model.uv, [&](auto e) { return bool(model.is_aligned[e]); },
           [&](auto h) { return transitions.rotation(h); }).is_exact()
         && std::all_of(connections.begin(), connections.end(), is_held)
         && std::all_of(cycles.begin(), cycles.end(), is_held);
}

Measurement measure(const std::string& file, std::size_t number_of_connections,
                    const Settings& settings)
{
  Parametrized_model model(file);
  if(!model.status)
    throw std::runtime_error(file + ": " + model.status.message);
  const auto transitions = SS::seam_transitions(model.mesh, model.uv);
  random_constraints::Generator<Mesh> random(model.mesh, transitions, settings.seed);
  const auto connections = random.connections(number_of_connections);
  const auto cycles = random.cycles(settings.cycles);
  const auto parameters = SS::parameters::edge_is_constrained_map(model.is_aligned)
                            .connection_constraints(connections)
                            .connection_tolerance(std::numeric_limits<double>::infinity())
                            .cycle_constraints(cycles);

  Measurement result;
  const auto reduced =
    reduced_system::reduced_seamless_system(model.mesh, model.uv, parameters);
  result.nodes = reduced.number_of_nodes;
  for(int i = 0; i < settings.repeats; ++i) {
    result.report = SS::Snapping_report();
    const double start = benchmark::seconds_now();
    const SS::internal::Linear_solver solver(reduced.own_system, reduced.weights,
                                             SS::internal::Number_format::of<double>(),
                                             reduced.weights.size(), false);
    const double seconds = benchmark::seconds_now() - start;
    result.report.linear_solver = solver.figures();
    result.seconds = i == 0 ? seconds : (std::min)(result.seconds, seconds);
  }
  if(settings.with_textbook)
    result.largest_of_textbook = textbook::largest_coefficient(
      textbook::reduced_echelon_form(
        textbook::dense_system<exact_reference::Integer>(reduced.system)).system);
  result.is_exact = snap_and_check(model, transitions, connections, cycles, parameters);
  return result;
}

// --- the table -----------------------------------------------------------------------------------

void print_head(const Settings& settings)
{
  std::printf(
      "Seed %llu, %zu random cycles. For each number of connections: the largest "
      "coefficient that occurs%s, the largest pivot (number of pivots other than 1 and -1), "
      "and the milliseconds of the elimination.\n\n| model | nodes |",
      static_cast<unsigned long long>(settings.seed), settings.cycles,
      settings.with_textbook ? " (in the textbook method's final matrix)" : "");
  for(const std::size_t n : settings.connections)
    std::printf(" %zu |", n);
  std::printf(" exact |\n|---|--:|");
  for(std::size_t i = 0; i < settings.connections.size(); ++i)
    std::printf("---|");
  std::printf("---|\n");
}

void print_cell(const Measurement& m, const Settings& settings)
{
  std::printf(" %.0f", m.report.linear_solver.largest_coefficient);
  if(settings.with_textbook)
    std::printf(" (%.0f)", CGAL::to_double(m.largest_of_textbook));
  std::printf(", %.0f (%zu), %.3f |", m.report.linear_solver.largest_pivot,
              m.report.linear_solver.number_of_non_unit_pivots, 1e3 * m.seconds);
}

// Returns whether all results are exact.
bool measure_and_print(const std::string& file, const Settings& settings,
                       std::vector<benchmark::Series>& series)
{
  std::printf("| %s |", std::filesystem::path(file).stem().string().c_str());
  bool ok = true;
  for(std::size_t i = 0; i < settings.connections.size(); ++i) {
    const Measurement m = measure(file, settings.connections[i], settings);
    if(i == 0)
      std::printf(" %zu |", m.nodes);
    print_cell(m, settings);
    std::fflush(stdout);
    series[i].points.emplace_back(double((std::max)(m.nodes, std::size_t(1))), 1e3 * m.seconds);
    ok = ok && m.is_exact;
  }
  std::printf(" %s |\n", ok ? "yes" : "NO");
  return ok;
}

void print_growth(const std::vector<benchmark::Series>& series)
{
  std::printf("\ngrowth of the time with the nodes n:");
  for(const benchmark::Series& s : series)
    std::printf("  %s: n^%.2f", s.name.c_str(), benchmark::growth_exponent(s.points));
  std::printf("\n");
}

// --- the command line ----------------------------------------------------------------------------

std::optional<int> read_command_line(int argc, char** argv, Settings& settings)
{
  options::options_description description("Options");
  description.add_options()(
    "file", options::value(&settings.files)->required(),
    "OBJ files, or folders (may go without --file)")(
    "connections",
    options::value(&settings.connections)->multitoken()->default_value({ 0, 10, 20, 50, 100 },
                                                                       "0 10 20 50 100"),
    "numbers of connections")(
    "cycles", options::value(&settings.cycles)->default_value(0), "random cycles in addition")(
    "seed", options::value(&settings.seed)->default_value(1), "of connections and cycles")(
    "repeats", options::value(&settings.repeats)->default_value(5), "the shortest counts")(
    "textbook", options::bool_switch(&settings.with_textbook),
    "also the largest coefficient of the textbook method: slow from a few hundred nodes on")(
    "svg", options::value(&settings.svg), "where to draw the times against the numbers of nodes");
  const auto exit_code = benchmark::read_command_line(
    argc, argv, "connection_growth [options] FILE_OR_FOLDER...", description, "file");
  settings.repeats = (std::max)(settings.repeats, 1);
  return exit_code;
}

int main(int argc, char** argv)
{
  Settings settings;
  if(const std::optional<int> exit_code = read_command_line(argc, argv, settings))
    return *exit_code;
  std::vector<benchmark::Series> series;
  for(const std::size_t n : settings.connections)
    series.push_back({ std::to_string(n) + " connections", {} });
  print_head(settings);
  bool ok = true;
  for(const std::string& file : benchmark::files_of(settings.files)) {
    try {
      ok = measure_and_print(file, settings, series) && ok;
    } catch(const std::exception& error) {
      std::cerr << error.what() << std::endl;
      ok = false;
    }
  }
  if(series[0].points.size() > 1)
    print_growth(series);
  if(!settings.svg.empty()) {
    std::ofstream os(settings.svg);
    benchmark::Log_log_plot("nodes", "elimination (ms)", series).write(os);
    ok = bool(os) && ok;
  }
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
