// Traces the isocurves that leave the singular vertices of a parametrization: in floating point on
// the map as it is, and exactly on the snapped one. Prints how the curves end, and writes them as
// polylines and pictures, among them one with an example of each failure.

#include "tracing_constraint_figure.h"
#include "tracing_failure_figure.h"
#include "tracing_overview.h"
#include "tracing_types.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/isocurve_constraints.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>
#include <CGAL/Seamless_snapping/trace_isocurve.h>

#include <boost/program_options.hpp>

#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace po = boost::program_options;

void print_table(const std::vector<Curve>& before, const std::vector<Curve>& after)
{
  std::map<SS::Isocurve_status, std::pair<std::size_t, std::size_t> > counts;
  for(const Curve& curve : before)
    ++counts[curve.status].first;
  for(const Curve& curve : after)
    ++counts[curve.status].second;
  std::cout << std::left << std::setw(22) << "end of the curve" << std::right << std::setw(10)
            << "inexact" << std::setw(10) << "exact" << "\n";
  for(const auto& [status, count] : counts)
    std::cout << std::left << std::setw(22) << SS::to_string(status) << std::right << std::setw(10)
              << count.first << std::setw(10) << count.second << "\n";
  std::cout << std::flush;
}

using Overview = Tracing_overview<Mesh, UV_map>;

void write_overview(const std::string& filename, const Overview& before, const Overview& after)
{
  std::ofstream os(filename);
  write_head(os, 1240, 1300);
  const std::string heading = "font-size=\"22\" text-anchor=\"middle\"";
  write_text(os, 320, 44, "inexact, traced in floating point", heading);
  write_text(os, 920, 44, "exactly seamless, traced exactly", heading);
  before.write_domain(os, 320, 350, 540);
  after.write_domain(os, 920, 350, 540);
  before.write_projection(os, 320, 950, 540);
  after.write_projection(os, 920, 950, 540);
  os << "<path stroke-width=\"3\" stroke=\"#0072b2\" d=\"M60 1275H90\"/>"
        "<path stroke-width=\"3\" stroke=\"#d55e00\" d=\"M420 1275H450\"/>\n";
  write_text(os, 100, 1281, "isocurves that end as they should", "");
  write_text(os, 460, 1281, "isocurves that fail, and where", "");
  os << "</svg>\n";
}

bool read(const std::string& filename, Mesh& mesh, UV_map uv_map,
          Feature_map is_feature)
{
  const auto status =
    SS::IO::read_OBJ(filename, mesh, uv_map, parameters::edge_is_constrained_map(is_feature));
  if(!status)
    std::cerr << filename << ": " << status << std::endl;
  return bool(status);
}

// Another map of the same mesh.
bool read_map(const std::string& filename, const Mesh& mesh, UV_map uv_map)
{
  Mesh other;
  UV_map map = other.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  if(!read(filename, other, map, other.add_property_map<Mesh::Edge_index, bool>("e:f").first))
    return false;
  if(other.number_of_halfedges() != mesh.number_of_halfedges()) {
    std::cerr << filename << ": another mesh" << std::endl;
    return false;
  }
  for(const Halfedge h : mesh.halfedges())
    uv_map[h] = map[h];
  return true;
}

struct Options
{
  // without arguments: small meshes with every failure, whose seams are so far off that it shows
  explicit Options(const bool is_demo)
    : input(is_demo ? "data/isocurves.obj" : ""),
      exact_input(is_demo ? "data/isocurves_exact.obj" : ""), tolerance(is_demo ? 0.5 : 1e-4),
      near_distance(is_demo ? 0.008 : 0), starts_at_all_vertices(is_demo)
  { }

  std::string input, exact_input, output = "traced";
  std::size_t maximum_number = 500;
  double tolerance, near_distance;
  bool features = false, border = false, constrain = false, starts_at_all_vertices;
};

// Returns whether there is something to do.
bool parse(int argc, char* argv[], Options& o, int& exit_code)
{
  po::options_description options("Options");
  options.add_options()("help", "print this")("input", po::value(&o.input), "the mesh (OBJ)")(
    "exact", po::value(&o.exact_input), "the same mesh with an exact map, instead of snapping")(
    "output,o", po::value(&o.output), "how the names of the files written begin")(
    "maximum-number", po::value(&o.maximum_number), "crossings per curve (default 500)")(
    "tolerance", po::value(&o.tolerance), "relative violation that is accepted (default 1e-4)")(
    "near", po::value(&o.near_distance), "relative distance at which a target counts as missed")(
    "features", po::bool_switch(&o.features), "align the l elements, as far as the exact map goes")(
    "border", po::bool_switch(&o.border), "align the border likewise")(
    "constrain", po::bool_switch(&o.constrain),
    "snap with what fails as constraints: curves that miss a vertex as connections, curves that "
    "spiral as cycles")(
    "all", po::bool_switch(&o.starts_at_all_vertices)->default_value(o.starts_at_all_vertices),
    "start at all vertices, not only at the singular ones");
  po::positional_options_description positional;
  positional.add("input", 1);
  po::variables_map given;
  try {
    po::store(po::command_line_parser(argc, argv).options(options).positional(positional).run(),
              given);
    po::notify(given);
  } catch(const po::error& e) {
    std::cerr << e.what() << "\n" << options;
    exit_code = EXIT_FAILURE;
    return false;
  }
  if(given.count("help") == 0 && !o.input.empty())
    return true;
  std::cout << "usage: trace_obj [options] IN.obj\n" << options;
  exit_code = given.count("help") != 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  return false;
}

// The curves from all singular vertices, or from all vertices.
std::vector<Curve> trace(const Mesh& mesh, const Tracer& tracer, const Options& options,
                         const bool exactly)
{
  const auto how = parameters::maximum_number(options.maximum_number).decide_exactly(exactly);
  std::vector<Curve> curves;
  for(const Vertex v : mesh.vertices())
    if(options.starts_at_all_vertices || tracer.is_singular(v))
      for(const auto& [start, direction] : tracer.outgoing(v))
        curves.push_back(options.near_distance > 0
                           ? tracer.trace(start, direction, how.tolerance(options.near_distance))
                           : tracer.trace(start, direction, how));
  return curves;
}

SS::Snapping_report snap(const Mesh& mesh, UV_map uv_map, const Feature_map& is_feature,
                         const std::vector<Curve>& failures, const Options& options)
{
  std::vector<SS::Connection_constraint<Mesh> > connections;
  std::vector<SS::Cycle_constraint<Mesh> > cycles;
  for(const Curve& curve : failures)
    if(curve.status == SS::Isocurve_status::MISSED_TARGET)
      connections.push_back(SS::connection_along_isocurve(mesh, curve));
    else if(curve.status == SS::Isocurve_status::SPIRALS)
      cycles.push_back(SS::cycle_along_isocurve(mesh, curve));
  const auto report = SS::snap_to_seamless(
    mesh, uv_map, parameters::edge_is_constrained_map(is_feature).align_border(options.border)
                             .tolerance(options.tolerance).connection_constraints(connections)
                             .cycle_constraints(cycles));
  std::cout << "snapping with " << connections.size() << " connections and " << cycles.size()
            << " cycles: " << report << ", largest change " << report.largest_change << std::endl;
  return report;
}

void write_polylines(const std::string& name, const Overview& overview)
{
  std::ofstream obj(name + ".obj"), ply(name + ".ply");
  overview.write_OBJ(obj);
  overview.write_PLY(ply);
}

int main(int argc, char* argv[])
{
  Options options(argc == 1);
  int exit_code = EXIT_SUCCESS;
  if(!parse(argc, argv, options, exit_code))
    return exit_code;

  Mesh mesh;
  UV_map uv_map = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  UV_map exact_map = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:exact_uv").first;
  Feature_map is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  if(!read(options.input, mesh, uv_map, is_feature) ||
     (!options.exact_input.empty() && !read_map(options.exact_input, mesh, exact_map)))
    return EXIT_FAILURE;
  if(options.exact_input.empty())
    for(const Halfedge h : mesh.halfedges())
      exact_map[h] = uv_map[h];
  if(!options.features)
    for(const auto e : mesh.edges())
      is_feature[e] = false;

  const Tracer inexact_tracer(mesh, uv_map, parameters::tolerance(options.tolerance));
  if(!inexact_tracer) {
    std::cerr << options.input << ": not seamless up to the tolerance" << std::endl;
    return EXIT_FAILURE;
  }
  const auto before = trace(mesh, inexact_tracer, options, false);
  if(!snap(mesh, exact_map, is_feature, options.constrain ? before : std::vector<Curve>(), options))
    return EXIT_FAILURE;
  const Tracer exact_tracer(mesh, exact_map);
  const auto after = trace(mesh, exact_tracer, options, true);
  print_table(before, after);

  const Overview overview_before(mesh, uv_map, before), overview_after(mesh, exact_map, after);
  const Pair_of_maps maps{mesh, uv_map, exact_map, options.tolerance};
  write_overview(options.output + "_overview.svg", overview_before, overview_after);
  write_failures(options.output + "_failures.svg", maps, before, exact_tracer);
  if(options.constrain)
    Constraint_figure(options.output + "_constraints.svg", maps, inexact_tracer, exact_tracer)
      .write(before);
  write_polylines(options.output + "_curves_inexact", overview_before);
  write_polylines(options.output + "_curves_exact", overview_after);
  std::cout << "written: " << options.output << "_*.svg, " << options.output
            << "_curves_{inexact,exact}.{obj,ply}" << std::endl;
  return EXIT_SUCCESS;
}
