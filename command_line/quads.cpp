// seamless quads IN OUT: extracts the quad mesh of an integer-grid map or, where a number of quads
// is wanted and no such map is near, of a quantization.

#include "Failure.h"
#include "Options.h"
#include "Progress.h"
#include "Summary.h"
#include "Topology.h"
#include "commands.h"
#include "files.h"
#include "json_report.h"
#include "measures.h"
#include "patches.h"
#include "plain_meshes.h"
#include "shape_report.h"
#include "pictures/quad_picture.h"
#include "words.h"
#include "maps/map_quads.h"

#include <CGAL/Quad_remeshing/measure_quad_shapes.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace QR = CGAL::Quad_remeshing;

namespace {

struct Quad_options
{
  Seam_options seams;
  std::string input, output, picture, patches, report;
  double scale = 1, number = 0, rounding = 0;
  bool allow_holes = false, soup = false, has_rounding = false;

  bool parse(const Arguments& arguments)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double largest_number = 1 << 28;
    Options options("quads IN OUT",
                    "Makes the quads of a parametrization. Their edges are the lines on which a\n"
                    "coordinate is an integer, after the coordinates were made an exact integer-grid\n"
                    "map.\n"
                    "\n"
                    "IN is a .obj file, a .ply file with a list 'texcoord' for each face, or with s\n"
                    "and t, or u and v, for each vertex, or - for the standard input. OUT is a .obj,\n"
                    ".off, or .ply file, or - for the standard output, as OBJ.\n");
    options.add_file("input", input);
    options.add_file("output", output);
    seams.add_to(options);
    options.add("grid-scale", "K", scale, {0, infinity, true},
                "multiply the coordinates by K first (default: 1)");
    options.add("number", "N", number, whole_numbers(1, largest_number),
                "make about N quads. The coordinates are scaled to an area of N and rounded if integers "
                "are near; otherwise a quantization finds integers");
    options.add("rounding", "D", rounding, {0, infinity},
                "the largest distance from integers at which translations, cones, and aligned edges are "
                "rounded (default: 0.01; with --number 0.5, or any distance if nothing else helps)");
    seams.add_repair_to(options);
    options.add("allow-holes", allow_holes,
                "leave out the quads around flipped faces instead of refusing the map");
    options.add("soup", soup,
                "also write quads that meet themselves, or meet each other twice");
    options.add("picture", "FILE", picture, "draw the quads, as .svg");
    add_patches_to(options, patches);
    options.add("report", "R.json", report, "write all measurements to a file, as JSON");
    options.add_alias("quads", "number");
    options.add_alias("svg", "picture");
    options.exclude({"number", "grid-scale"});
    options.exclude({"soup", "picture"});
    options.exclude({"soup", "patches"});
    if(!options.parse(arguments))
      return false;
    seams.check(options);
    seams.check_repair(options);
    has_rounding = options.is_given("rounding");
    check_number_of_faces("number", number, "quads", "; --grid-scale makes more");
    check_quad_file(output);
    check_picture(picture);
    check_patch_file(patches);
    check_outputs({input}, {output, picture, patches, report});
    return true;
  }
};

const std::string other_coordinates = "; 'seamless parametrize' computes others";

// What is written, and what is told of it.
struct Result
  : public Map_quads
{
  double diagonal = 0; // of the input
  // if the result is a mesh
  std::size_t number_of_irregular_vertices = 0;
  std::optional<Topologies> topologies;
  QR::Quad_shapes shapes;
  std::optional<Patch_counts> patches;
};

Map_quad_options options_of_maps(const Quad_options& options, Model& model,
                                 std::optional<Progress>& progress)
{
  Map_quad_options result;
  result.number = options.number;
  result.grid_scale = options.scale;
  if(options.has_rounding)
    result.rounding = options.rounding;
  result.allow_holes = options.allow_holes;
  result.soup = options.soup;
  result.repair_flips = options.seams.repair_flips;
  result.verbose = options.seams.reading.verbose;
  result.tolerance = options.seams.tolerance;
  result.untangling_iterations = options.seams.untangling_iterations;
  result.align_border = options.seams.align_border;
  result.alignment = [&](const bool with_border) {
    Seam_options seams = options.seams;
    seams.align_border = with_border;
    return Alignment(model, seams).is_aligned;
  };
  result.tell = [&](const std::string& step) {
    progress.reset(); // a line ends before the next one begins
    progress.emplace(step, options.seams.reading.verbose);
  };
  return result;
}

void make_quads(const Quad_options& options, Model& model, Result& result)
{
  std::optional<Progress> progress;
  try {
    static_cast<Map_quads&>(result) = make_map_quads(options_of_maps(options, model, progress),
                                                     model.mesh, model.uv_map, model.is_feature);
  } catch(const Not_snapped& refusal) {
    progress.reset();
    result.repaired = refusal.report;
    check_snapped(result.repaired, model, options.seams.tolerance);
  }
}

// In the words of the command line.
Message flips_message(const Quad_options& options, const Model& model,
                      const std::vector<std::size_t>& faces)
{
  if(faces.size() == model.mesh.number_of_faces())
    return "no face of the integer-grid map has a positive area" + other_coordinates;
  return counted(faces.size(), "face") + " of the integer-grid map" + is_or_are(faces.size()) +
         "flipped or degenerate, the first is " + Message(Message::FACE, "face", faces.front()) +
         "; ask for more quads, " + (options.seams.repair_flips ? "" : "try --repair-flips, ") +
         "or leave out the quads around these faces by --allow-holes";
}

void check_report(const Quad_options& options, const Model& model, const Result& result)
{
  const QR::Extraction_report& report = result.report;
  if(report)
    return;
  const bool has_flips = report.status == QR::Outcome::NOT_POSITIVE;
  std::string why =
    in_words_of_user(has_flips ? flips_message(options, model, report.nonpositive_faces)
                               : to_string(report.status) + (": " + report.message), model);
  if(!result.why_rounded.empty())
    why += "; integers at any distance are tried, because " +
           in_words_of_user(result.why_rounded, model);
  throw Failure(NOT_SOLVED, options.input + ": " + why);
}

// How far the map has changed where faces were flipped.
void write_flip_repairs(std::ostream& os, const QR::Snapping_report& report)
{
  const QR::Snapping_figures& run = report.run;
  if(run.number_of_repaired_flips == 0)
    return;
  os << "repaired: " << counted(run.number_of_repaired_flips, "flipped face")
     << "; coordinates change by up to " << report.largest_change / report.extent
     << " of their extent";
  if(run.number_of_changed_cones > 0)
    os << ", and the angle at " << counted(run.number_of_changed_cones, "vertex")
       << " by a full turn or more";
  os << "\n";
}

// What the result lacks of the surface.
void write_left_out(std::ostream& os, const Quad_options& options, const Result& result)
{
  const QR::Extraction_report& report = result.report;
  if(report.number_of_cut_cells == 0)
    return;
  os << "left out: " << counted(report.number_of_cut_cells, "piece")
     << " of cells at the border or at holes, " << 100 * result.part_left_out()
     << " % of the area in the domain. More quads leave out less; ";
  if(!options.seams.align_border)
    os << "--align-border keeps cells whole where border edges are nearly on isocurves, as in maps of "
          "'parametrize --align-border'; ";
  os << "'remesh' makes whole ones\n";
}

void write_summary(std::ostream& os, const Quad_options& options, const Model& model,
                   const Result& result)
{
  const QR::Extraction_report& report = result.report;
  os << counted(report.number_of_faces - report.number_of_other_polygons, "quad") << ", "
     << counted(report.number_of_vertices, "vertex");
  if(result.topologies)
    os << ", " << counted(result.number_of_irregular_vertices, "irregular vertex");
  os << "\n";
  if(options.number > 0 || !result.is_rounded())
    os << "integers: " << in_words_of_user(result.integers, model) << "\n";
  write_flip_repairs(os, result.repaired);
  if(result.is_rounded())
    os << "translations, cones, and levels rounded by up to " << result.snapped.largest_rounding
       << " of the side of a cell\n";
  if(report.number_of_other_polygons > 0)
    os << counted(report.number_of_other_polygons, "other polygon")
       << " around cones between grid lines; --grid-scale 2 avoids them at half-integers\n";
  write_left_out(os, options, result);
  if(result.topologies)
    os << note(*result.topologies, "extraction");
  if(!report.nonpositive_faces.empty())
    os << "taken for holes: " << counted(report.nonpositive_faces.size(), "flipped face") << "\n";
  write_inverted_quads(os, report.number_of_inverted_quads, report.first_inverted_quads,
                       options.output);
  if(result.smoothed) {
    write_folded_quads(os, result.smoothed->number_of_folded_quads,
                       result.smoothed->first_folded_quads, options.output);
    write_shape(os, *result.smoothed, result.diagonal);
    write_displacement(os, result.smoothed->number_of_displaced_vertices,
                       result.smoothed->largest_displacement);
  } else if(result.topologies) {
    write_shapes(os, result.shapes);
  }
  write_summary(os, result.patches);
}

nlohmann::json json_of_smoothing(const QR::Remeshing_report& report, const double diagonal)
{
  nlohmann::json result = json_of_shape(report, diagonal);
  result["number_of_folded_quads"] = report.number_of_folded_quads;
  result["first_folded_quads"] = report.first_folded_quads;
  result["number_of_displaced_vertices"] = report.number_of_displaced_vertices;
  result["largest_displacement"] = report.largest_displacement;
  return result;
}

nlohmann::json json_of(const Result& result, const std::string& integers, const bool is_written,
                       const std::string& message)
{
  const QR::Extraction_report& report = result.report;
  if(!is_written)
    return {{"written", false},
            {"message", message},
            {"nonpositive_faces", report.nonpositive_faces},
            {"steps", json_of_steps(result.repaired.step_times)}};
  nlohmann::json json = {
    {"written", true},
    {"message", message},
    {"number_of_quads", report.number_of_faces - report.number_of_other_polygons},
    {"number_of_vertices", report.number_of_vertices},
    {"number_of_irregular_vertices",
     if_known(result.topologies.has_value(), result.number_of_irregular_vertices)},
    {"number_of_inverted_quads", report.number_of_inverted_quads},
    {"first_inverted_quads", report.first_inverted_quads},
    {"smoothed", result.smoothed ? json_of_smoothing(*result.smoothed, result.diagonal)
                                 : nlohmann::json()},
    {"topology", json_of(result.topologies)},
    {"patches", json_of(result.patches)},
    {"number_of_other_polygons", report.number_of_other_polygons},
    {"number_of_cut_cells", report.number_of_cut_cells},
    {"nonpositive_faces", report.nonpositive_faces},
    {"integers", integers},
    {"number_of_repaired_flips", result.repaired.run.number_of_repaired_flips},
    {"number_of_changed_cones", result.repaired.run.number_of_changed_cones},
    {"part_of_domain_left_out", result.part_left_out()},
    {"largest_rounding", if_known(result.is_rounded(), result.snapped.largest_rounding)},
    {"steps", json_of_steps(result.repaired.step_times)}};
  if(result.topologies)
    json.update(json_of_shapes(result.shapes));
  return json;
}

} // namespace

void quads(const Arguments& arguments)
{
  Quad_options options;
  if(!options.parse(arguments))
    return;
  Model model;
  read_or_tell(options.report, "written",
               [&] { read_model(options.input, options.seams.reading, model); });
  std::ostream& os = summary_stream({options.output, options.picture, options.patches, options.report});
  os << notes_on_reading(model) << note_on_features(options.seams.features, model) << std::flush;
  Result result;
  const auto work = [&] {
    make_quads(options, model, result);
    result.diagonal = diagonal(model.mesh);
    check_report(options, model, result);
    write_file(options.output, options.soup ? text_of_quads(result.soup, options.output)
                                            : text_of_quads(result.mesh, result.is_feature,
                                                          options.output));
    if(!options.picture.empty())
      write_file(options.picture, quad_picture(result.mesh, result.is_feature));
    if(!options.soup) {
      result.number_of_irregular_vertices = number_of_irregular_vertices(result.mesh);
      result.topologies = {Topology(model.mesh), Topology(result.mesh)};
      result.shapes = QR::measure_quad_shapes(result.mesh);
    }
    result.patches = write_patches(result.mesh, result.is_feature, options.patches);
    write_summary(os, options, model, result);
    if(!options.soup) // which is asked for to see them
      check_inverted_quads(result.report.number_of_inverted_quads, options.output,
                           options.number > 0 || result.report.number_of_cut_cells > 0 ? "" :
                             "; --number " + std::to_string(result.report.number_of_faces) +
                             " makes about as many and moves their vertices");
    if(result.smoothed)
      check_folded_quads(result.smoothed->number_of_folded_quads, options.output);
  };
  run_and_tell(work, [&](const Exit status, const std::string& message) {
    if(!options.report.empty())
      write_json(options.report, json_of(result, in_words_of_user(result.integers, model),
                                         is_written(status), message));
  });
}
