// How the time and memory of snap_to_seamless() grow with the mesh. The yardstick is one pass over
// the edges that compares the coordinates of both ends on both sides: no exact method can do with
// less.
//
// Meshes: Height_field_surface.h, with noise of 1e-9 of the extent in every sector. Each size runs
// in a process of its own. (The smallest mesh may fit into the cache, which makes all of it, the
// pass too, seem to grow faster than it does from there on.) Times are the shortest of several
// runs; memory is the peak resident set during the first snap above what mesh and uv map (and a
// copy of it) occupy before.

#include "benchmark_tools.h"
#include "child_process.h"
#include "command_line.h"

#include "Height_field_surface.h"
#include "exact_seamless_check.h"

#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace options = benchmark::options;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;

struct Settings
{
  std::vector<std::size_t> faces;
  std::size_t faces_per_node;
  int repeats;
  unsigned int seed;
  double noise;
};

// --- one size ------------------------------------------------------------------------------------

// The yardstick: the number of edges whose sides differ somewhere.
std::size_t count_mismatches(const Mesh& mesh, const UV_map& uv)
{
  std::size_t result = 0;
  for(const Mesh::Edge_index e : mesh.edges()) {
    const Mesh::Halfedge_index h = mesh.halfedge(e), o = mesh.opposite(h);
    result += uv[h] != uv[mesh.prev(o)] || uv[o] != uv[mesh.prev(h)] ? 1 : 0;
  }
  return result;
}

struct Measurement
{
  double faces = 0, nodes = 0, pass = 0, bytes_per_face = 0;
  bool is_exact = false;
  benchmark::Shortest_times run;
};

double time_of_pass(const Mesh& mesh, const UV_map& uv, int repeats)
{
  double best = 0;
  std::size_t mismatches = 0;
  for(int i = 0; i < repeats; ++i) {
    const double start = benchmark::seconds_now();
    mismatches += count_mismatches(mesh, uv);
    const double seconds = benchmark::seconds_now() - start;
    best = i == 0 ? seconds : (std::min)(best, seconds);
  }
  if(mismatches == 0)
    std::cerr << "the input has no cut" << std::endl; // keeps the pass from being optimised away
  return best;
}

Measurement measure(std::size_t faces, const Settings& settings)
{
  Mesh mesh;
  height_field_surface::make_surface({ faces, faces / settings.faces_per_node, settings.seed },
                                     mesh);
  height_field_surface::perturb(mesh, settings.noise, settings.seed);
  UV_map uv = square_complex::uv_map(mesh);

  Measurement result;
  result.faces = double(mesh.number_of_faces());
  result.pass = time_of_pass(mesh, uv, (std::max)(5, settings.repeats));

  const std::vector<Kernel::Point_2> input(uv.begin(), uv.end());
  benchmark::reset_memory_peak();
  const double before = benchmark::kilobytes("VmRSS:");
  for(int i = 0; i < settings.repeats; ++i) {
    std::copy(input.begin(), input.end(), uv.begin());
    const double start = benchmark::seconds_now();
    const auto report = CGAL::Seamless_snapping::snap_to_seamless(mesh, uv);
    result.run.add(report.step_times, benchmark::seconds_now() - start);
    result.nodes = double(report.run.number_of_nodes);
    if(i == 0)
      result.bytes_per_face = 1024 * (benchmark::kilobytes("VmHWM:") - before) / result.faces;
    if(!report)
      std::cerr << report << std::endl;
  }
  const exact_check::Result check = exact_check::check_edges(mesh, uv);
  result.is_exact = check.is_exact();
  return result;
}

// --- a process for each size ---------------------------------------------------------------------

std::string to_text(const Measurement& m)
{
  std::ostringstream os;
  os.precision(17);
  os << m.faces << '\t' << m.nodes << '\t' << m.pass << '\t' << m.bytes_per_face << '\t'
     << m.is_exact << '\t' << m.run.total() << '\n';
  for(const auto& step : m.run.steps())
    os << step.second << '\t' << step.first << '\n';
  return os.str();
}

Measurement from_text(const std::string& text)
{
  Measurement m;
  std::istringstream is(text);
  double total = 0, seconds = 0;
  is >> m.faces >> m.nodes >> m.pass >> m.bytes_per_face >> m.is_exact >> total;
  benchmark::Step_times steps;
  for(std::string name; is >> seconds && is.get() && std::getline(is, name);)
    steps.emplace_back(name, seconds);
  m.run.add(steps, total);
  return m;
}

// Returns a measurement of no faces if the child fails.
Measurement measure_in_child(std::size_t faces, const Settings& settings)
{
  std::string text;
  const auto end = benchmark::run_in_child([&] { return to_text(measure(faces, settings)); },
                                           benchmark::Child_limits(), text);
  return end == benchmark::Child_end::FINISHED ? from_text(text) : Measurement();
}

// --- the table -----------------------------------------------------------------------------------

int width_of(const std::string& step)
{
  return int((std::max)(step.size(), std::size_t(8)));
}

void print_head(const Measurement& m)
{
  std::printf("%10s %7s %9s |", "faces", "nodes", "pass");
  for(const auto& step : m.run.steps())
    std::printf(" %*s", width_of(step.first), step.first.c_str());
  std::printf(" | %9s %10s %10s %5s\n", "total", "total/pass", "bytes/face", "exact");
}

void print(const Measurement& m)
{
  std::printf("%10.0f %7.0f %9.2f |", m.faces, m.nodes, 1e3 * m.pass);
  for(const auto& step : m.run.steps())
    std::printf(" %*.2f", width_of(step.first), 1e3 * step.second);
  std::printf(" | %9.2f %10.2f %10.1f %5s\n", 1e3 * m.run.total(), m.run.total() / m.pass,
              m.bytes_per_face, m.is_exact ? "yes" : "NO");
  std::fflush(stdout);
}

// Each with the number of faces; steps too short to be timed are left out.
void print_growth(const std::vector<Measurement>& all)
{
  using Pairs = std::vector<std::pair<double, double> >;
  Pairs pass, total;
  std::vector<std::pair<std::string, Pairs> > steps;
  for(const auto& step : all.front().run.steps())
    steps.emplace_back(step.first, Pairs());
  for(const Measurement& m : all) {
    pass.emplace_back(m.faces, m.pass);
    total.emplace_back(m.faces, m.run.total());
    benchmark::Step_times times = m.run.steps();
    for(auto& step : steps)
      step.second.emplace_back(m.faces, (std::max)(benchmark::time_of(step.first, times), 1e-6));
  }
  std::printf("growth with the faces n: pass n^%.2f, total n^%.2f",
              benchmark::growth_exponent(pass), benchmark::growth_exponent(total));
  for(const auto& step : steps)
    if(step.second.back().second > 1e-3)
      std::printf(", %s n^%.2f", step.first.c_str(), benchmark::growth_exponent(step.second));
  std::printf("\n");
}

// --- the command line ----------------------------------------------------------------------------

std::optional<int> read_command_line(int argc, char** argv, Settings& settings)
{
  options::options_description description("Options");
  description.add_options()(
    "faces",
    options::value(&settings.faces)->multitoken()->default_value({ 100000, 1000000 },
                                                                 "100000 1000000"),
    "sizes")(
    "faces-per-node", options::value(&settings.faces_per_node)->default_value(200), "about")(
    "repeats", options::value(&settings.repeats)->default_value(5), "the shortest counts")(
    "seed", options::value(&settings.seed)->default_value(1), "of surface and noise")(
    "noise", options::value(&settings.noise)->default_value(1e-9), "relative to the extent");
  const auto exit_code =
    benchmark::read_command_line(argc, argv, "snap_scaling [options]", description, "faces");
  settings.faces_per_node = (std::max)(settings.faces_per_node, std::size_t(1));
  settings.repeats = (std::max)(settings.repeats, 1);
  return exit_code;
}

int main(int argc, char** argv)
{
  Settings settings;
  if(const std::optional<int> exit_code = read_command_line(argc, argv, settings))
    return *exit_code;

  std::printf("times in milliseconds\n");
  std::vector<Measurement> all;
  for(const std::size_t faces : settings.faces) {
    all.push_back(measure_in_child(faces, settings));
    if(all.back().faces == 0) {
      std::cerr << "the run with " << faces << " faces failed" << std::endl;
      return EXIT_FAILURE;
    }
    if(all.size() == 1)
      print_head(all.back());
    print(all.back());
  }
  if(all.size() > 1)
    print_growth(all);
  const bool ok =
    std::all_of(all.begin(), all.end(), [](const Measurement& m) { return m.is_exact; });
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
