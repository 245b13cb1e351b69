// seamless layout IN OUT: divides a parametrized surface into rectangles along isocurves.

#include "Failure.h"
#include "Options.h"
#include "Progress.h"
#include "Summary.h"
#include "commands.h"
#include "files.h"
#include "json_report.h"
#include "pictures/layout_picture.h"
#include "measures.h"
#include "snap_model.h"
#include "words.h"

#include <CGAL/Isocurves_and_layouts/copy_to_face_graph.h>
#include <CGAL/Isocurves_and_layouts/Motorcycle_graph.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>

namespace IL = CGAL::Isocurves_and_layouts;

namespace {

struct Layout_options
{
  Seam_options seams;
  std::string input, output, picture, report;
  bool base_complex = false;

  bool parse(const Arguments& arguments)
  {
    Options options("layout IN OUT",
                    "Divides a surface into rectangles along isocurves of its parametrization, which\n"
                    "is made exactly seamless first. Curves start at all cones and corners, and stop\n"
                    "at curves that were there first. A border that nearly lies on isocurves is\n"
                    "aligned; at other borders, patches can have any shape.\n"
                    "\n"
                    "IN is a .obj file, a .ply file with a list 'texcoord' for each face, or with s\n"
                    "and t, or u and v, for each vertex, or - for the standard input. OUT is a .obj\n"
                    "file with a group of faces for each patch and an element 'l' for each side;\n"
                    "patches that are no rectangles are also in the group 'cut'.\n");
    options.add_file("input", input);
    options.add_file("output", output);
    seams.add_to(options);
    options.add("base-complex", base_complex,
                "let curves cross each other, up to a cone, corner, border, or feature");
    seams.add_repair_to(options);
    options.add("picture", "FILE", picture, "draw the surface, as .svg");
    options.add("report", "R.json", report, "write all measurements to a file, as JSON");
    options.add_alias("svg", "picture");
    if(!options.parse(arguments))
      return false;
    seams.check(options);
    seams.check_repair(options);
    seams.align_border = true;
    if(suffix_of(output) != "obj" && !is_special_file(output))
      throw Failure(USAGE, "'" + output + "': layouts are written to .obj files");
    check_picture(picture);
    check_outputs({input}, {output, picture, report});
    return true;
  }
};

// Where flips should be repaired and remain, there is no layout.
IL::Snapping_report snap(const Layout_options& options, Model& model, const Alignment& alignment)
{
  const Progress progress("snapping " + counted(model.mesh.number_of_faces(), "face"),
                          options.seams.reading.verbose);
  const IL::Snapping_report report = snap_in_double(model, alignment, options.seams);
  check_snapped(report, model, options.seams.tolerance);
  if(report.status == IL::Outcome::FLIPS_REMAIN)
    throw Failure(NOT_SOLVED, options.input + ": " + in_words_of_user(report, model));
  return report;
}

struct Layout_counts
{
  Layout_counts(const IL::Motorcycle_graph<Mesh>& graph, const IL::Snapping_report& snapped)
    : cut_patches(graph.number_of_cut_patches()),
      rectangles(graph.number_of_patches() - cut_patches), arcs(graph.number_of_arcs()),
      extent(snapped.extent)
  {
    constexpr double much = 4; // the changes along a path across cuts add up
    for(std::size_t p = 0; p < graph.number_of_patches(); ++p)
      if(!graph.patch_is_cut(p)) {
        const double width = CGAL::to_double((std::min)(graph.patch_width(p),
                                                        graph.patch_height(p)));
        if(width < least_width.value_or(std::numeric_limits<double>::infinity())) {
          least_width = width;
          thinnest = p;
        }
        thin_rectangles += width < much * snapped.run.largest_change_before_repair ? 1 : 0;
      }
    for(std::size_t n = 0; n < graph.number_of_nodes(); ++n) {
      const IL::Layout_node kind = graph.node_kind(n);
      ++(kind == IL::Layout_node::JUNCTION ? junctions
         : kind == IL::Layout_node::SEED   ? seeds : cones_and_corners);
    }
  }

  std::size_t cut_patches, rectangles, arcs;
  std::size_t cones_and_corners = 0;
  std::size_t junctions = 0; // at which curves meet
  std::size_t seeds = 0;     // chosen in parts without cones and corners
  double extent;                     // of the domain
  std::size_t thin_rectangles = 0;   // as thin as if made by snapping
  std::optional<double> least_width; // of a rectangle, in the domain
  std::size_t thinnest = 0;          // the patch that this is
};

void write_summary(std::ostream& os, const Layout_counts& n)
{
  os << counted(n.rectangles, "rectangle") << ", "
     << (n.cut_patches > 0 ? counted(n.cut_patches, "patch") + " cut by the border, " : "")
     << counted(n.arcs, "arc") << " between "
     << (n.cones_and_corners == 1 ? "1 cone or corner"
                                  : std::to_string(n.cones_and_corners) + " cones and corners")
     << (n.seeds > 0 ? ", " + counted(n.seeds, "vertex") + " chosen in parts without any," : "")
     << " and " << counted(n.junctions, "point") << " at which curves meet\n";
  if(n.least_width)
    os << "the thinnest rectangle, patch_" << n.thinnest + 1 << ", is " << *n.least_width
       << " wide in the domain, that is " << *n.least_width / n.extent << " of the extent\n";
  if(n.thin_rectangles > 0)
    os << "note: " << counted(n.thin_rectangles, "rectangle")
       << " can be due to the inaccuracy of the input, as thin as the changes by snapping: curves "
          "that are meant to meet may pass each other there; a map that is more accurate, or whose "
          "cones are at integers, has no such ones\n";
}

nlohmann::json json_of(const std::optional<Layout_counts>& n, const bool is_written,
                       const std::string& message)
{
  if(!is_written || !n)
    return {{"written", false}, {"message", message}};
  return {{"written", true}, {"message", message}, {"rectangles", n->rectangles},
          {"cut_patches", n->cut_patches}, {"arcs", n->arcs},
          {"cones_and_corners", n->cones_and_corners}, {"junctions", n->junctions},
          {"chosen_vertices", n->seeds}, {"thin_rectangles", n->thin_rectangles},
          {"least_width", n->least_width ? nlohmann::json(*n->least_width) : nullptr}};
}

} // namespace

void layout(const Arguments& arguments)
{
  Layout_options options;
  if(!options.parse(arguments))
    return;
  Model model;
  read_or_tell(options.report, "written",
               [&] { read_model(options.input, options.seams.reading, model); });
  std::ostream& os = summary_stream({options.output, options.picture, options.report});
  os << notes_on_reading(model) << note_on_features(options.seams.features, model) << std::flush;
  std::optional<Layout_counts> counts;
  const auto work = [&] {
    const Alignment alignment(model, options.seams);
    const IL::Snapping_report snapped = snap(options, model, alignment);
    const Progress progress("dividing the surface", options.seams.reading.verbose);
    const auto np = IL::parameters::edge_is_constrained_map(alignment.is_aligned);
    const IL::Motorcycle_graph<Mesh> graph =
      options.base_complex
        ? IL::motorcycle_graph(model.mesh, model.uv_map, np.curve_stop_policy(IL::Run_to_nodes()))
        : IL::motorcycle_graph(model.mesh, model.uv_map, np);
    if(!graph)
      throw Failure(NOT_SOLVED, options.input + ": " + to_string(graph.status()) + ": " +
                                  in_words_of_user(graph.message(), model));
    std::ostringstream text;
    IL::IO::write_layout(text, graph);
    write_file(options.output, text.str());
    if(!options.picture.empty())
      write_file(options.picture, layout_picture(graph));
    counts.emplace(graph, snapped);
    write_summary(os, *counts);
  };
  run_and_tell(work, [&](const Exit status, const std::string& message) {
    if(!options.report.empty())
      write_json(options.report, json_of(counts, status == SUCCESS, message));
  });
}
