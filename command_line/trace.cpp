// seamless trace IN: traces the isocurves that leave the singular vertices of a parametrization: in
// floating point on the map as it is, and exactly on the snapped one. Tells how the curves end, and
// if asked to writes them as polylines and pictures, among them one with an example of each failure.

#include "Failure.h"
#include "Model.h"
#include "Options.h"
#include "Progress.h"
#include "Summary.h"
#include "commands.h"
#include "files.h"
#include "json_report.h"
#include "pictures/tracing_constraint_figure.h"
#include "pictures/tracing_failure_figure.h"
#include "pictures/tracing_overview.h"
#include "pictures/tracing_types.h"
#include "words.h"

#include <CGAL/Isocurves_and_layouts/isocurve_constraints.h>
#include <CGAL/Isocurves_and_layouts/trace_isocurve.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using Overview = Tracing_overview<Mesh, Uv_map>;

// The files that are written, but for how their names begin.
enum File { overview, failures, constraints, inexact_obj, inexact_ply, exact_obj, exact_ply };
constexpr std::array<const char*, 7> names = {{
  "overview.svg", "failures.svg", "constraints.svg", "curves_inexact.obj", "curves_inexact.ply",
  "curves_exact.obj", "curves_exact.ply"}};

struct Trace_options
{
  Reading_options reading;
  std::string input, exact_input, report;
  std::string output; // how names of files begin; none if empty
  int maximum_number = 500;
  double tolerance = 1e-4, near_by = 0;
  bool features = false, border = false, constrain = false, starts_at_all_vertices = false;

  // Returns whether there is something to do.
  bool parse(const Arguments& arguments)
  {
    Options options("trace IN [NAME]",
                    "Follows the isocurves from the singular vertices of a parametrization, in\n"
                    "floating point and, after snapping, exactly, and counts how they end.\n"
                    "\n"
                    "With NAME, writes pictures (.svg) and the curves (.obj, .ply) to files whose\n"
                    "names begin with NAME, such as NAME_overview.svg, or into the folder NAME. The\n"
                    "overview shows the first crossings of each curve, about 2000 in all.\n");
    options.add_file("input", input);
    options.add_file("output", output, true);
    options.add("exact", "EXACT", exact_input,
                "the same mesh with an exact map (default: made by snapping)");
    options.add("weld", reading.weld, "weld border edges between the same points");
    options.add("features", features, "align the edges of 'l' elements");
    options.add("align-border", border, "align border edges");
    options.add("constrain", constrain,
                "snap with constraints for failing curves: connections for curves that miss a vertex, "
                "cycles for curves that spiral");
    options.add("all", starts_at_all_vertices, "start at all vertices, not only at singular ones");
    options.add("maximum-number", "N", maximum_number,
                {1, (std::numeric_limits<int>::max)()}, "crossings per curve (default: 500)");
    options.add("tolerance", "T", tolerance, {0, 1, true},
                "the largest violation of seams that is accepted, relative to the extent (default: 1e-4)");
    options.add("near", "D", near_by, {0, 1},
                "the largest distance at which a curve counts as missing a vertex, relative to the extent");
    options.add("report", "R.json", report, "write all measurements to a file, as JSON");
    options.add("verbose", reading.verbose, "report each step on the error stream");
    if(!options.parse(arguments))
      return false;
    if(output == "-")
      throw Failure(USAGE, "several files are written, whose names need a beginning");
    const std::string suffix = suffix_of(output);
    if(suffix == "obj" || suffix == "ply" || suffix == "svg")
      throw Failure(USAGE, "'" + output + "': several files are written, whose names begin so; "
                           "leave the suffix out");
    check_format(input);
    if(!exact_input.empty())
      check_format(exact_input);
    std::vector<std::string> outputs = filenames();
    outputs.push_back(report);
    check_outputs({input, exact_input}, outputs);
    return true;
  }

  // Those that are written.
  std::vector<std::string> filenames() const
  {
    std::vector<std::string> result;
    if(!output.empty())
      for(const char* const name : names)
        if(constrain || name != names[constraints])
          result.push_back(filename(name));
    return result;
  }

  std::string filename(const std::string& name) const
  {
    return std::filesystem::is_directory(output) ? (std::filesystem::path(output) / name).string()
                                                 : output + "_" + name;
  }
};

// Another map of the same mesh.
void read_map(const std::string& filename, const Reading_options& options, const Model& model,
              const Uv_map uv_map)
{
  Model other;
  read_model(filename, options, other);
  const auto halfedges = model.mesh.halfedges();
  if(other.mesh.number_of_halfedges() != model.mesh.number_of_halfedges() ||
     std::any_of(halfedges.begin(), halfedges.end(), [&](const Halfedge h) {
       return other.mesh.target(h) != model.mesh.target(h);
     }))
    throw Failure(UNREADABLE, filename + ": another mesh than " + model.filename);
  for(const Halfedge h : model.mesh.halfedges())
    uv_map[h] = other.uv_map[h];
}

// The model, and its exact map, which is to become one if no other file has it.
Uv_map read_maps(const Trace_options& options, Model& model)
{
  read_model(options.input, options.reading, model);
  const Uv_map result = copy_of_uv_map(model);
  if(!options.exact_input.empty())
    read_map(options.exact_input, options.reading, model, result);
  if(!options.features)
    for(const Edge e : model.mesh.edges())
      model.is_feature[e] = false;
  return result;
}

// The curves from all singular vertices, or from all vertices.
std::vector<Curve> trace(const Mesh& mesh, const Tracer& tracer, const Trace_options& options,
                         const bool exactly)
{
  const auto how =
    parameters::maximum_number(static_cast<std::size_t>(options.maximum_number))
               .decide_exactly(exactly);
  std::vector<Curve> curves;
  for(const Vertex v : mesh.vertices())
    if(options.starts_at_all_vertices || tracer.is_singular(v))
      for(const auto& [start, direction] : tracer.outgoing(v))
        curves.push_back(options.near_by > 0
                           ? tracer.trace(start, direction, how.near_distance(options.near_by))
                           : tracer.trace(start, direction, how));
  return curves;
}

IL::Snapping_report snap(const Model& model, const Uv_map uv_map,
                         const Edge_bool_map is_feature,
                         const std::vector<Curve>& failures, const Trace_options& options)
{
  std::vector<IL::Connection_constraint<Mesh> > connections;
  std::vector<IL::Cycle_constraint<Mesh> > cycles;
  for(const Curve& curve : failures)
    if(curve.status == IL::Isocurve_status::MISSED_TARGET)
      connections.push_back(IL::connection_along_isocurve(model.mesh, curve));
    else if(curve.status == IL::Isocurve_status::SPIRALS)
      cycles.push_back(IL::cycle_along_isocurve(model.mesh, curve));
  const auto report = IL::snap_to_seamless(
    model.mesh, uv_map,
    parameters::edge_is_constrained_map(is_feature).align_border(options.border)
               .tolerance(options.tolerance).connection_constraints(connections)
               .cycle_constraints(cycles)
               .connection_tolerance((std::max)(0.01, 2 * options.near_by)));
  check_snapped(report, model, options.tolerance);
  if(!options.exact_input.empty() && !options.constrain && report.status != IL::Outcome::ALREADY_EXACT)
    throw Failure(NOT_SOLVED, options.exact_input + ": not exactly seamless; 'seamless snap' makes "
                                                    "it so");
  std::cout << "snapping with " << connections.size() << " connections and " << cycles.size()
            << " cycles: " << in_words_of_user(report, model) << ", largest change "
            << report.largest_change;
  if(report.extent > 0)
    std::cout << ", that is " << report.largest_change / report.extent << " of the extent";
  std::cout << std::endl;
  return report;
}

// How many curves end in each way, inexact and exact ones.
using Curve_counts = std::map<IL::Isocurve_status, std::pair<std::size_t, std::size_t> >;

Curve_counts count_ends(const std::vector<Curve>& before, const std::vector<Curve>& after)
{
  Curve_counts counts;
  for(const Curve& curve : before)
    ++counts[curve.status].first;
  for(const Curve& curve : after)
    ++counts[curve.status].second;
  return counts;
}

void print_table(const Curve_counts& counts, const int maximum_number)
{
  std::cout << std::left << std::setw(22) << "end of the curve" << std::right << std::setw(10)
            << "inexact" << std::setw(10) << "exact" << "\n";
  for(const auto& [status, count] : counts)
    std::cout << std::left << std::setw(22)
              << (status == IL::Isocurve_status::MAXIMUM_NUMBER
                    ? "after " + counted(std::size_t(maximum_number), "crossing")
                    : IL::to_string(status))
              << std::right << std::setw(10) << count.first << std::setw(10) << count.second
              << "\n";
  if(counts.empty())
    std::cout << "no curve, because no vertex is singular; --all starts at all vertices\n";
  std::cout << std::flush;
}

nlohmann::json json_of(const Curve_counts& counts)
{
  nlohmann::json result = nlohmann::json::object();
  for(const auto& [status, count] : counts)
    result[IL::to_string(status)] = {{"inexact", count.first}, {"exact", count.second}};
  return result;
}

// Of so many crossings that a picture remains.
Overview overview_of(const Mesh& mesh, const Uv_map uv_map, const std::vector<Curve>& curves)
{
  constexpr std::size_t most = 2000, few = 500;
  std::size_t number = 0;
  for(const Curve& curve : curves)
    number += curve.points.size();
  return {mesh, uv_map, curves, number > few ? 0.7 : 1.6,
          number > most ? most / curves.size() + 1 : number};
}

void write_overview(std::ostream& os, const Overview& before, const Overview& after)
{
  write_head(os, 1240, 1300);
  const std::string heading = "font-size=\"22\" text-anchor=\"middle\"";
  write_text(os, 320, 44, "inexact, traced in floating point", heading);
  write_text(os, 920, 44, "exactly seamless, traced exactly", heading);
  write_text(os, 320, 68, before.what_is_drawn(), "text-anchor=\"middle\"");
  write_text(os, 920, 68, after.what_is_drawn(), "text-anchor=\"middle\"");
  before.write_domain(os, 320, 350, 540);
  after.write_domain(os, 920, 350, 540);
  before.write_projection(os, 320, 950, 540);
  after.write_projection(os, 920, 950, 540);
  os << "<path stroke-width=\"3\" stroke=\"#0072b2\" d=\"M60 1275H90\"/>"
        "<path stroke-width=\"3\" stroke=\"#d55e00\" d=\"M420 1275H450\"/>\n";
  write_text(os, 100, 1281, "isocurves that do not fail", "");
  write_text(os, 460, 1281, "isocurves that fail, and where", "");
  os << "</svg>\n";
}

// Calls `write(os)`, and tells of the file when it is written.
template <typename Write>
void write_and_tell(const std::string& filename, const Write& write)
{
  std::ostringstream os;
  write(os);
  write_file(filename, os.str());
  std::cout << "written: " << filename << std::endl;
}

void write_results(const Trace_options& options, const Pair_of_maps& maps,
                   const Tracer& inexact_tracer, const Tracer& exact_tracer,
                   const std::vector<Curve>& before, const std::vector<Curve>& after)
{
  const Overview overview_before = overview_of(maps.mesh, maps.inexact, before);
  const Overview overview_after = overview_of(maps.mesh, maps.exact, after);
  write_and_tell(options.filename(names[overview]), [&](std::ostream& os) {
    write_overview(os, overview_before, overview_after);
  });
  if(std::any_of(before.begin(), before.end(),
                 [](const Curve& curve) { return IL::is_failure(curve.status); }))
    write_and_tell(options.filename(names[failures]), [&](std::ostream& os) {
      write_failures(os, maps, before, exact_tracer);
    });
  else
    std::cout << "not written, because no curve fails: " << options.filename(names[failures])
              << "\n";
  if(options.constrain)
    write_and_tell(options.filename(names[constraints]), [&](std::ostream& os) {
      Constraint_figure(os, maps, inexact_tracer, exact_tracer).write(before);
    });
  write_and_tell(options.filename(names[inexact_obj]),
                 [&](std::ostream& os) { overview_before.write_OBJ(os); });
  write_and_tell(options.filename(names[inexact_ply]),
                 [&](std::ostream& os) { overview_before.write_PLY(os); });
  write_and_tell(options.filename(names[exact_obj]),
                 [&](std::ostream& os) { overview_after.write_OBJ(os); });
  write_and_tell(options.filename(names[exact_ply]),
                 [&](std::ostream& os) { overview_after.write_PLY(os); });
}

} // namespace

void trace(const Arguments& arguments)
{
  Trace_options options;
  if(!options.parse(arguments))
    return;
  Model model;
  const Uv_map exact_map = read_or_tell(options.report, "traced",
                                        [&] { return read_maps(options, model); });
  std::cout << notes_on_reading(model) << note_on_features(options.features, model) << std::flush;
  IL::Snapping_report report;
  Curve_counts counts;
  const auto work = [&] {
    const Progress progress("tracing", options.reading.verbose);
    const Tracer inexact_tracer(model.mesh, model.uv_map,
                                parameters::tolerance(options.tolerance));
    if(!inexact_tracer)
      throw Failure(NOT_SOLVED, options.input + ": not seamless up to the tolerance; 'seamless "
                                  "snap' tells where, and --tolerance raises it");
    const auto before = trace(model.mesh, inexact_tracer, options, false);
    report = snap(model, exact_map, model.is_feature,
                  options.constrain ? before : std::vector<Curve>(), options);
    const Tracer exact_tracer(model.mesh, exact_map);
    const auto after = trace(model.mesh, exact_tracer, options, true);
    counts = count_ends(before, after);
    print_table(counts, options.maximum_number);
    const Pair_of_maps maps{model.mesh, model.uv_map, exact_map, options.tolerance};
    if(options.output.empty())
      std::cout << "no files are written; 'seamless trace IN NAME' writes pictures and curves to "
                   "files whose names begin with NAME\n";
    else
      write_results(options, maps, inexact_tracer, exact_tracer, before, after);
  };
  run_and_tell(work, [&](const Exit status, const std::string& message) {
    const bool is_traced = status == SUCCESS;
    if(!options.report.empty())
      write_json(options.report, {{"traced", is_traced}, {"message", message},
                                  {"curves", if_known(is_traced, json_of(counts))},
                                  {"maximum_number", options.maximum_number},
                                  {"extent", if_known(is_traced, report.extent)},
                                  {"largest_change", if_known(is_traced, report.largest_change)}});
  });
}
