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
#include "snap_model.h"
#include "words.h"

#include <CGAL/Quad_remeshing/extract_grid_mesh.h>
#include <CGAL/Quad_remeshing/measure_quad_shapes.h>
#include <CGAL/Quad_remeshing/quad_remesh.h>
#include <CGAL/Quad_remeshing/quantize.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
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
  double scale = 1, number = 0, rounding = 0.01;
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
                    "IN is a .obj file, a .ply file with a list 'texcoord' for each face, or - for\n"
                    "the standard input. OUT is a .obj, .off, or .ply file, or - for the standard\n"
                    "output, as OBJ.\n");
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
    if(options.is_given("number") && !has_rounding)
      rounding = 0.5;
    check_number_of_faces("number", number, "quads", "; --grid-scale makes more");
    check_quad_file(output);
    check_picture(picture);
    check_patch_file(patches);
    check_outputs({input}, {output, picture, patches, report});
    return true;
  }
};

const std::string other_coordinates = "; 'seamless parametrize' computes others";

// The area in the domain becomes the number of quads, but for that of holes. It is known before the
// seams are, whose refusal users are to see.
double scale_for_number(const Model& model, const Quad_options& options)
{
  if(options.number == 0)
    return options.scale;
  const auto [area, exponent] = area_in_domain(model, options.allow_holes);
  if(!(area > 0))
    throw Failure(NOT_SOLVED, options.input + ": the coordinates enclose no area, or none beside a "
                                              "much larger coordinate" + other_coordinates);
  return std::ldexp(std::sqrt(options.number / area), -exponent);
}

QR::Snapping_report snap_to_integers(const Quad_options& options, const double rounding,
                                     Model& model)
{
  const Alignment alignment(model, options.seams);
  const Progress progress("snapping " + counted(model.mesh.number_of_faces(), "face"),
                          options.seams.reading.verbose);
  return QR::snap_to_seamless(
    model.mesh, model.uv_map,
    snapping_parameters(alignment, options.seams).integer_grid(true).rounding_tolerance(rounding)
      .grid_scale(scale_for_number(model, options)));
}

// What is written, and how it was made.
struct Result
{
  QR::Extraction_report report;
  Quad_soup soup;
  Mesh mesh;
  Edge_bool_map is_feature;
  QR::Snapping_report snapped; // to integers, unless there is a quantization
  QR::Snapping_report repaired; // of what was extracted or quantized
  std::string integers;        // which they are
  std::string why_rounded;     // where there was to be a quantization
  std::optional<QR::Remeshing_report> smoothed; // how far, if vertices were smoothed
  double diagonal = 0;                          // of the input
  // where the result is a mesh
  std::size_t number_of_irregular_vertices = 0;
  std::optional<Topologies> topologies;
  QR::Quad_shapes shapes;
  std::optional<Patch_counts> patches;

  bool is_rounded() const { return snapped.run.number_of_faces > 0; }
};

// With the border aligned where it is nearly. Flips are repaired near by without being asked for.
QR::Quantization quantize(const Quad_options& options, Model& model, Result& result)
{
  Seam_options seams = options.seams;
  seams.align_border = true;
  const Alignment alignment(model, seams);
  const Progress progress("quantizing", options.seams.reading.verbose);
  const auto snap_and_quantize = [&] {
    result.repaired = snap_in_double(model, alignment, seams);
    check_snapped(result.repaired, model, seams.tolerance);
    return QR::quantize(model.mesh, model.uv_map,
                        QR::parameters::edge_is_constrained_map(model.is_feature)
                          .needs_face_graph(!options.soup)
                          .target_number_of_quads(static_cast<std::size_t>(options.number)));
  };
  const QR::Quantization quantization = snap_and_quantize();
  if(quantization.nonpositive_faces.empty() || options.seams.repair_flips)
    return quantization;
  seams.repairs_flips_near_by = true;
  return snap_and_quantize();
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
    why += "; integers at any distance are tried, as " + result.why_rounded;
  throw Failure(NOT_SOLVED, options.input + ": " + why);
}

// `input` is the mesh and its map, or a quantization and the mesh.
template <typename NamedParameters, typename... Input>
void extract(const Quad_options& options, Result& result, const NamedParameters& np,
             const Input&... input)
{
  const Progress progress("extracting quads", options.seams.reading.verbose);
  using Tag = CGAL::Parallel_if_available_tag;
  if(options.soup) {
    result.report =
      QR::extract_quad_soup<Tag>(input..., result.soup.points, result.soup.polygons, np);
    return;
  }
  result.is_feature = result.mesh.add_property_map<Edge, bool>("e:feature", false).first;
  result.report = QR::extract_quad_mesh<Tag>(
    input..., result.mesh, np, QR::parameters::edge_is_constrained_map(result.is_feature));
  result.mesh.collect_garbage();
}

void extract_map(const Quad_options& options, const Model& model, Result& result)
{
  extract(options, result,
          QR::parameters::edge_is_constrained_map(model.is_feature)
            .allow_holes(options.allow_holes), model.mesh, model.uv_map);
}

void extract_rounded(const Quad_options& options, Model& model, const double rounding,
                     Result& result)
{
  result.snapped = result.repaired = snap_to_integers(options, rounding, model);
  check_snapped(result.snapped, model, options.seams.tolerance);
  extract_map(options, model, result);
}

// Whether the border is meant to lie on isocurves: most of it does.
bool has_aligned_border(Model& model, const Quad_options& options)
{
  Seam_options seams = options.seams;
  seams.align_border = true;
  const Alignment alignment(model, seams);
  std::size_t number = 0, number_of_others = 0;
  for(const Edge e : model.mesh.edges())
    if(model.mesh.is_border(e))
      ++(alignment.is_aligned[e] ? number : number_of_others);
  return 3 * number_of_others <= number;
}

// The quads of the same quantization, in a better shape.
void extract_and_smooth(const Quad_options& options, const Model& model,
                        const QR::Quantization& quantization, Result& result)
{
  const Progress progress("smoothing quads", options.seams.reading.verbose);
  result.mesh.clear();
  result.is_feature = result.mesh.add_property_map<Edge, bool>("e:feature", false).first;
  const QR::Remeshing_report made = QR::quad_remesh(
    quantization, model.mesh, result.mesh, QR::parameters::default_values(),
    QR::parameters::edge_is_constrained_map(result.is_feature));
  QR::Extraction_report& report = result.report;
  report.status = made.status;
  report.message = made.message;
  report.number_of_faces = made.number_of_quads;
  report.number_of_vertices = made.number_of_vertices;
  report.number_of_inverted_quads = made.number_of_inverted_quads;
  report.first_inverted_quads = made.first_inverted_quads;
  result.smoothed = made;
  result.diagonal = diagonal(model.mesh);
}

// Smooths them where quads are inverted otherwise: where the map is much distorted, and where two
// sides of a quad follow one edge of the border.
void extract_quantized(const Quad_options& options, const Model& model,
                       const QR::Quantization& quantization, Result& result)
{
  result.integers = "of a quantization";
  if(!quantization.message.empty())
    result.integers += "; " + in_words_of_user(quantization.message, model);
  extract(options, result, QR::parameters::default_values(), quantization, model.mesh);
  const std::size_t number = result.report.number_of_inverted_quads;
  const bool has_steps = quantization.number_of_unaligned_border_edges > 0;
  if(!result.report || options.soup || (number == 0 && !has_steps))
    return;
  extract_and_smooth(options, model, quantization, result);
  result.integers += "; vertices are smoothed";
  if(has_steps)
    result.integers += ", and edges next to the border moved";
  if(number > 0)
    result.integers += ", as " + counted(number, "quad") + (number == 1 ? " was" : " were") +
                       " inverted";
}

// Of the area in the domain.
double part_left_out(const QR::Extraction_report& report)
{
  return report.number_of_cut_cells == 0 ? 0
                                         : 1 - double(report.number_of_faces) / report.area;
}

// By the integers that are near in the map itself, if there are and make about the number; or by a
// quantization, also where that can't make so few, so that it never makes more than for a larger
// number, and if fewer quads are inverted in it; or, where faces are flipped, by integers at any
// distance. Where the border is not meant to be aligned, a quantization comes last, as it follows
// the border edge by edge: where there are no quads otherwise, or they leave out more than half of
// the area.
void make_number_of_quads(const Quad_options& options, Model& model, Result& result)
{
  constexpr double tolerance = 0.05;
  const Uv_map input = copy_of_uv_map(model);
  const auto restore = [&] {
    for(const Halfedge h : model.mesh.halfedges())
      model.uv_map[h] = input[h];
  };
  Result near_by;
  near_by.snapped = near_by.repaired = snap_to_integers(options, options.rounding, model);
  if(near_by.snapped && near_by.snapped.lost_faces.empty() &&
     near_by.snapped.remaining_flips.empty())
    extract_map(options, model, near_by);
  near_by.integers = "those nearest in the map";
  const double number = static_cast<double>(near_by.report.number_of_faces);
  const bool is_near = near_by.report && std::abs(number / options.number - 1) <= tolerance;
  restore();
  const bool is_aligned = has_aligned_border(model, options);
  QR::Quantization quantization;
  if(is_aligned)
    quantization = quantize(options, model, result);
  const double least = static_cast<double>(quantization.number_of_quads);
  const bool is_chosen = is_near && !(quantization && least > (1 + tolerance) * options.number);
  const std::size_t number_inverted = near_by.report.number_of_inverted_quads;
  if(quantization && !(is_chosen && number_inverted == 0))
    extract_quantized(options, model, quantization, result);
  if(is_chosen && !(quantization && result.report &&
                    result.report.number_of_inverted_quads < number_inverted))
    result = std::move(near_by);
  if(is_chosen || quantization)
    return;
  restore();
  const double any = std::numeric_limits<double>::infinity();
  extract_rounded(options, model, options.has_rounding ? options.rounding : any, result);
  result.why_rounded =
    is_aligned ? "there is no quantization: " + in_words_of_user(quantization.message, model)
               : "most of the border lies on no isocurve";
  result.integers = "at any distance, as " + result.why_rounded;
  if(is_aligned || (result.report && part_left_out(result.report) <= 0.5))
    return;
  restore();
  Result last;
  if(const QR::Quantization other = quantize(options, model, last)) {
    extract_quantized(options, model, other, last);
    result = std::move(last);
  }
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
void write_left_out(std::ostream& os, const Result& result)
{
  const QR::Extraction_report& report = result.report;
  if(report.number_of_cut_cells == 0)
    return;
  os << "left out: " << counted(report.number_of_cut_cells, "piece")
     << " of cells at the border or at holes, " << 100 * part_left_out(report)
     << " % of the area in the domain. More quads leave out less; --align-border keeps cells whole "
        "where border edges are nearly on isocurves, as in maps of 'parametrize --align-border'; "
        "'remesh' makes whole ones\n";
}

void write_summary(std::ostream& os, const Quad_options& options, const Result& result)
{
  const QR::Extraction_report& report = result.report;
  os << counted(report.number_of_faces - report.number_of_other_polygons, "quad") << ", "
     << counted(report.number_of_vertices, "vertex");
  if(result.topologies)
    os << ", " << counted(result.number_of_irregular_vertices, "irregular vertex");
  os << "\n";
  if(!result.integers.empty())
    os << "integers: " << result.integers << "\n";
  write_flip_repairs(os, result.repaired);
  if(result.is_rounded())
    os << "translations, cones, and levels rounded by up to " << result.snapped.largest_rounding
       << " of the side of a cell\n";
  if(report.number_of_other_polygons > 0)
    os << counted(report.number_of_other_polygons, "other polygon")
       << " around cones between grid lines; --grid-scale 2 avoids those at half-integers\n";
  write_left_out(os, result);
  if(result.topologies)
    os << note(*result.topologies, "extraction");
  if(!report.nonpositive_faces.empty())
    os << "taken for holes: " << counted(report.nonpositive_faces.size(), "flipped face") << "\n";
  write_inverted_quads(os, report.number_of_inverted_quads, report.first_inverted_quads,
                       options.output);
  if(result.smoothed) {
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
  result["number_of_displaced_vertices"] = report.number_of_displaced_vertices;
  result["largest_displacement"] = report.largest_displacement;
  return result;
}

nlohmann::json json_of(const Result& result, const bool is_written, const std::string& message)
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
    {"integers", result.integers},
    {"number_of_repaired_flips", result.repaired.run.number_of_repaired_flips},
    {"number_of_changed_cones", result.repaired.run.number_of_changed_cones},
    {"part_of_domain_left_out", part_left_out(report)},
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
    if(options.number > 0)
      make_number_of_quads(options, model, result);
    else
      extract_rounded(options, model, options.rounding, result);
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
    write_summary(os, options, result);
    if(!options.soup) // which is asked for to see them
      check_inverted_quads(result.report.number_of_inverted_quads, options.output,
                           options.number > 0 || result.report.number_of_cut_cells > 0 ? "" :
                             "; --number " + std::to_string(result.report.number_of_faces) +
                             " makes about as many and moves their vertices");
  };
  run_and_tell(work, [&](const Exit status, const std::string& message) {
    if(!options.report.empty())
      write_json(options.report, json_of(result, is_written(status), message));
  });
}
