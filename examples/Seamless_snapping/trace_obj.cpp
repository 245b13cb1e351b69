// Traces the isocurves that leave the singular vertices of a parametrization: in floating point on
// the map as it is, and exactly on the snapped one. Prints how the curves end, and writes them as
// polylines and pictures, among them one with an example of each failure.

#include "tracing_failure_panel.h"
#include "tracing_overview.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>
#include <CGAL/Seamless_snapping/trace_isocurve.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

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
namespace SS = CGAL::Seamless_snapping;
namespace parameters = CGAL::Seamless_snapping::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Mesh::Halfedge_index;
using Vertex = Mesh::Vertex_index;
using UV_map = Mesh::Property_map<Halfedge, Kernel::Point_2>;
using Curve = SS::Isocurve<Mesh>;
using Tracer = SS::Isocurve_tracer<Mesh>;

// The curves from all singular vertices, or from all vertices.
std::vector<Curve> trace(const Mesh& mesh, const Tracer& tracer, const bool from_all_vertices,
                         const std::size_t maximum_number, const bool exactly,
                         const double tolerance)
{
  const auto how = parameters::maximum_number(maximum_number).decide_exactly(exactly);
  std::vector<Curve> curves;
  for(const Vertex v : mesh.vertices())
    if(from_all_vertices || tracer.is_singular(v))
      for(const auto& [start, direction] : tracer.outgoing(v))
        curves.push_back(tolerance > 0 ? tracer.trace(start, direction, how.tolerance(tolerance))
                                       : tracer.trace(start, direction, how));
  return curves;
}

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

void write_head(std::ostream& os, double width, double height)
{
  os << std::fixed << std::setprecision(2)
     << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' '
     << height << "\" font-family=\"sans-serif\" font-size=\"17\" fill=\"#333\">\n"
        "<defs><marker id=\"arrow\" viewBox=\"0 0 10 10\" refX=\"8\" refY=\"5\" markerWidth=\"6\" "
        "markerHeight=\"6\" orient=\"auto\"><path d=\"M0 0L10 5L0 10Z\" fill=\"#c62828\"/></marker>"
        "</defs>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
}

void write_text(std::ostream& os, double x, double y, const std::string& text,
                const std::string& style)
{
  os << "<text x=\"" << x << "\" y=\"" << y << "\" " << style << ">" << text << "</text>\n";
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
  os << "<path stroke-width=\"3\" stroke=\"#1f4fd0\" d=\"M60 1275H90\"/>"
        "<path stroke-width=\"3\" stroke=\"#c62828\" d=\"M420 1275H450\"/>\n";
  write_text(os, 100, 1281, "isocurves that end as they should", "");
  write_text(os, 460, 1281, "isocurves that fail, and where", "");
  os << "</svg>\n";
}

const char* explanation(const SS::Isocurve_status status)
{
  switch(status) {
  case SS::Isocurve_status::STUCK_AT_CUT:
    return "Stuck at a cut: behind it, the direction points back onto the edge.";
  case SS::Isocurve_status::FELL_INTO_GAP:
    return "Fallen into the gap: behind the cut, the place lies beside the edge.";
  case SS::Isocurve_status::NO_WAY_OUT:
    return "No way out of a regular vertex on a cut.";
  case SS::Isocurve_status::SEVERAL_WAYS_OUT:
    return "Several ways out of a regular vertex on a cut.";
  case SS::Isocurve_status::FELL_OFF_BORDER:
    return "Fallen off an aligned border.";
  case SS::Isocurve_status::MISSED_TARGET:
    return "Missed connection: the curve passes beside the vertex it should meet.";
  default:
    return "Helix instead of a cycle: the curve returns beside its start.";
  }
}

// The two maps of a comparison.
struct Pair_of_maps
{
  const Mesh& mesh;
  UV_map inexact, exact;
  double tolerance;
};

// A failure at the left, the same curve on the exact map at the right.
void write_failure(std::ostream& os, const Pair_of_maps& maps, const Curve& curve,
                   const Curve& same, const double x, const double y)
{
  const auto inexact = SS::seam_transitions(maps.mesh, maps.inexact,
                                            parameters::tolerance(maps.tolerance));
  const auto exact = SS::seam_transitions(maps.mesh, maps.exact);
  write_text(os, x, y, explanation(curve.status), "");
  const bool spirals = curve.status == SS::Isocurve_status::SPIRALS;
  const bool has_expected = spirals || curve.status == SS::Isocurve_status::MISSED_TARGET;
  const Halfedge end = curve.points.back().halfedge();
  Vertex expected = maps.mesh.target(curve.start.halfedge);
  if(!spirals && has_expected)
    expected = maps.mesh.target(maps.mesh.next(maps.mesh.opposite(end)));
  Tracing_failure_panel<Mesh, UV_map>(maps.mesh, maps.inexact, inexact, end)
    .write(os, curve, has_expected ? &expected : nullptr, x + 150, y + 170, 150);
  Tracing_failure_panel<Mesh, UV_map>(maps.mesh, maps.exact, exact, end)
    .write(os, same, has_expected ? &expected : nullptr, x + 470, y + 170, 150);
}

void write_legend(std::ostream& os, const double y)
{
  os << "<path stroke-width=\"3\" stroke=\"#1f4fd0\" d=\"M40 " << y
     << "h26\"/><path stroke-width=\"3\" stroke=\"#e08a00\" d=\"M190 " << y
     << "h26\"/><path stroke-width=\"3\" stroke=\"#222\" d=\"M390 " << y
     << "h26\"/><circle cx=\"516\" cy=\"" << y << "\" r=\"6\" fill=\"#1b7f3b\"/>"
     << "<circle cx=\"716\" cy=\"" << y
     << "\" r=\"5\" fill=\"#fff\" stroke=\"#c62828\" stroke-width=\"2.5\"/>\n";
  write_text(os, 76, y + 6, "isocurve", "");
  write_text(os, 226, y + 6, "cut, both sides", "");
  write_text(os, 426, y + 6, "border", "");
  write_text(os, 532, y + 6, "vertex to be met", "");
  write_text(os, 732, y + 6, "failure, and the direction in which the isocurve should go on", "");
}

// The shortest curve of each kind of failure, two in a row.
void write_failures(const std::string& filename, const Pair_of_maps& maps,
                    const std::vector<Curve>& before, const Tracer& exact_tracer)
{
  std::map<SS::Isocurve_status, const Curve*> shortest;
  for(const Curve& curve : before)
    if(SS::is_failure(curve.status) && curve.points.size() > 1) {
      const Curve*& best = shortest[curve.status];
      if(best == nullptr || curve.points.size() < best->points.size())
        best = &curve;
    }
  std::ofstream os(filename);
  const double height = 390 * double((shortest.size() + 1) / 2);
  write_head(os, 1400, height + 130);
  for(const double x : {40., 740.}) {
    const std::string style = "font-size=\"22\" text-anchor=\"middle\" fill=";
    write_text(os, x + 150, 44, "inexact", style + "\"#b3261e\"");
    write_text(os, x + 470, 44, "exact", style + "\"#1b7f3b\"");
  }
  std::size_t i = 0;
  for(const auto& [status, curve] : shortest) {
    const Curve same = exact_tracer.trace(curve->start, curve->direction,
                                          parameters::maximum_number(10000));
    write_failure(os, maps, *curve, same, i % 2 == 0 ? 40 : 740, 86 + 390 * double(i / 2));
    ++i;
  }
  write_legend(os, height + 95);
  os << "</svg>\n";
}

bool read(const std::string& filename, Mesh& mesh, UV_map uv_map,
          Mesh::Property_map<Mesh::Edge_index, bool> is_feature)
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

int main(int argc, char* argv[])
{
  // without arguments: small meshes with every failure, whose seams are so far off that it shows
  const bool is_demo = argc == 1;
  std::string input = is_demo ? "data/isocurves.obj" : "";
  std::string exact_input = is_demo ? "data/isocurves_exact.obj" : "", output = "traced";
  std::size_t maximum_number = 500;
  double tolerance = is_demo ? 0.5 : 1e-4, near = is_demo ? 0.008 : 0;
  po::options_description options("Options");
  options.add_options()("help", "print this")("input", po::value(&input), "the mesh (OBJ)")(
    "exact", po::value(&exact_input), "the same mesh with an exact map, instead of snapping")(
    "output,o", po::value(&output), "how the names of the files written begin")(
    "maximum-number", po::value(&maximum_number), "crossings per curve (default 500)")(
    "tolerance", po::value(&tolerance), "relative violation that is accepted (default 1e-4)")(
    "near", po::value(&near), "relative distance at which a target counts as missed")(
    "features", "align the l elements, as far as the exact map goes")(
    "border", "align the border likewise")(
    "all", "start at all vertices, not only at the singular ones");
  po::positional_options_description positional;
  positional.add("input", 1);
  po::variables_map given;
  try {
    po::store(po::command_line_parser(argc, argv).options(options).positional(positional).run(),
              given);
    po::notify(given);
  } catch(const po::error& e) {
    std::cerr << e.what() << "\n" << options;
    return EXIT_FAILURE;
  }
  if(given.count("help") != 0 || input.empty()) {
    std::cout << "usage: trace_obj [options] IN.obj\n" << options;
    return input.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
  }

  Mesh mesh;
  UV_map uv_map = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  UV_map exact_map = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:exact_uv").first;
  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  if(!read(input, mesh, uv_map, is_feature) ||
     (!exact_input.empty() && !read_map(exact_input, mesh, exact_map)))
    return EXIT_FAILURE;
  if(exact_input.empty())
    for(const Halfedge h : mesh.halfedges())
      exact_map[h] = uv_map[h];
  if(given.count("features") == 0)
    for(const auto e : mesh.edges())
      is_feature[e] = false;
  const auto report = SS::snap_to_seamless(
    mesh, exact_map, parameters::edge_is_constrained_map(is_feature)
                                .align_border(given.count("border") != 0).tolerance(tolerance));
  std::cout << "snapping: " << report << std::endl;
  if(!report)
    return EXIT_FAILURE;

  const bool from_all = is_demo || given.count("all") != 0;
  const Tracer inexact_tracer(mesh, uv_map, parameters::tolerance(tolerance));
  const Tracer exact_tracer(mesh, exact_map);
  const auto before = trace(mesh, inexact_tracer, from_all, maximum_number, false, near);
  const auto after = trace(mesh, exact_tracer, from_all, maximum_number, true, near);
  print_table(before, after);

  const Overview overview_before(mesh, uv_map, before), overview_after(mesh, exact_map, after);
  write_overview(output + "_overview.svg", overview_before, overview_after);
  write_failures(output + "_failures.svg", Pair_of_maps{mesh, uv_map, exact_map, tolerance}, before,
                 exact_tracer);
  std::ofstream before_obj(output + "_curves_inexact.obj"), after_obj(output + "_curves_exact.obj");
  std::ofstream before_ply(output + "_curves_inexact.ply"), after_ply(output + "_curves_exact.ply");
  overview_before.write_OBJ(before_obj);
  overview_after.write_OBJ(after_obj);
  overview_before.write_PLY(before_ply);
  overview_after.write_PLY(after_ply);
  std::cout << "written: " << output << "_{overview,failures}.svg, " << output
            << "_curves_{inexact,exact}.{obj,ply}" << std::endl;
  return EXIT_SUCCESS;
}
