// seamless quads IN OUT: extracts the quad mesh of an integer-grid map.

#include "Failure.h"
#include "Options.h"
#include "Progress.h"
#include "Summary.h"
#include "commands.h"
#include "files.h"
#include "json_report.h"
#include "measures.h"
#include "plain_meshes.h"
#include "quad_picture.h"
#include "words.h"

#include <CGAL/Seamless_snapping/extract_quad_mesh.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace SS = CGAL::Seamless_snapping;

namespace {

struct Quad_options
{
  Seam_options seams;
  std::string input, output, picture, report;
  double scale = 1, number = 0, rounding = 0.01;
  bool allow_holes = false, soup = false;

  bool parse(const Arguments& arguments)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double largest_number = 1 << 28;
    Options options("quads IN OUT",
                    "Makes the texture coordinates of a triangle mesh an exact integer-grid map,\n"
                    "and extracts the quad mesh that it describes: its edges are the lines on which\n"
                    "a coordinate is an integer. IN is a .obj file, a .ply file with a list\n"
                    "'texcoord' for each face, or - for the standard input; OUT is a .obj or .off\n"
                    "file.\n");
    options.add_file("input", input);
    options.add_file("output", output);
    seams.add_to(options);
    options.add("grid-scale", "K", scale, {0, infinity, true},
                "multiply the coordinates by K first (default: 1)");
    options.add("number", "N", number, {1, largest_number},
                "instead, scale the coordinates to an area of N, for about N quads, and round as "
                "far as needed");
    options.add("rounding", "D", rounding, {0, infinity},
                "how far from integers translations, cones, and levels may be that are rounded to "
                "them (default: 0.01; with --number, any distance)");
    seams.add_repair_to(options);
    options.add("allow-holes", allow_holes,
                "leave out the quads around faces that are still flipped, instead of refusing "
                "them");
    options.add("soup", soup,
                "write quads that no mesh of quads can be, as they meet themselves or each other "
                "twice");
    options.add("picture", "FILE", picture, "write a picture of the quads as .svg");
    options.add("report", "R.json", report, "write all figures to a file");
    options.add_alias("quads", "number");
    options.add_alias("svg", "picture");
    options.exclude({"number", "grid-scale"});
    options.exclude({"soup", "picture"});
    if(!options.parse(arguments))
      return false;
    seams.check(options);
    if(options.is_given("number") && !options.is_given("rounding"))
      rounding = infinity;
    check_quad_file(output);
    check_picture(picture);
    check_outputs({input}, {output, picture, report});
    return true;
  }
};

// Known before the seams are, so that it is their refusal that users see.
double area_in_domain(const Model& model)
{
  const Mesh& mesh = model.mesh;
  double result = 0;
  for(const auto f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    result += CGAL::area(model.uv_map[h], model.uv_map[mesh.next(h)], model.uv_map[mesh.prev(h)]);
  }
  return result;
}

// The area in the domain becomes the number of quads.
double scale_for_number(const Model& model, const Quad_options& options)
{
  if(options.number == 0)
    return options.scale;
  const double area = area_in_domain(model);
  if(!(area > 0))
    throw Failure(NOT_SOLVED, options.input + ": the coordinates enclose no area");
  return std::sqrt(options.number / area);
}

SS::Snapping_report snap(const Quad_options& options, Model& model)
{
  const Alignment alignment(model, options.seams);
  const Progress progress("snapping " + counted(model.mesh.number_of_faces(), "face"),
                          options.seams.reading.verbose);
  const SS::Snapping_report report = SS::snap_to_seamless(
    model.mesh, model.uv_map,
    SS::parameters::edge_is_constrained_map(alignment.is_aligned).tolerance(options.seams.tolerance)
      .integer_grid(true).grid_scale(scale_for_number(model, options))
      .rounding_tolerance(options.rounding)
      .repair_flips(options.seams.flip_repair())
      .number_of_untangling_iterations(options.seams.untangling_iterations)
      .verbose(options.seams.reading.verbose));
  if(!report)
    throw Failure(NOT_SOLVED, options.input + ": " + in_words_of_user(to_text(report), model));
  return report;
}

// In the words of the command line.
std::string flips_message(const Quad_options& options, const std::vector<std::size_t>& faces)
{
  return counted(faces.size(), "face") + " of the integer-grid map " +
         (faces.size() == 1 ? "is" : "are") + " flipped or degenerate, the first is face " +
         std::to_string(faces.front()) +
         "; ask for more quads, " + (options.seams.repair_flips ? "" : "try --repair-flips, ") +
         "or leave out the quads around these faces by --allow-holes";
}

void check_report(const Quad_options& options, const Model& model,
                  const SS::Extraction_report& report)
{
  if(report)
    return;
  const bool has_flips = report.status == SS::Extraction_status::NOT_POSITIVE;
  const std::string why = has_flips ? flips_message(options, report.nonpositive_faces)
                                    : to_string(report.status) + (": " + report.message);
  throw Failure(NOT_SOLVED, options.input + ": " + in_words_of_user(why, model));
}

void write_summary(std::ostream& os, const Quad_options& options,
                   const SS::Snapping_report& snapped, const SS::Extraction_report& report)
{
  os << counted(report.number_of_faces - report.number_of_other_polygons, "quad") << ", "
     << counted(report.number_of_vertices, "vertex") << ", "
     << counted(report.number_of_cones, "cone") << "\n"
     << "translations, cones, and levels rounded by up to " << snapped.largest_rounding << "\n";
  if(report.number_of_other_polygons > 0)
    os << counted(report.number_of_other_polygons, "other polygon")
       << " around cones between grid lines; --grid-scale 2 avoids those at half-integers\n";
  if(report.number_of_cut_cells > 0)
    os << "left out: " << counted(report.number_of_cut_cells, "piece")
       << " of cells at the border or at holes\n";
  if(!report.nonpositive_faces.empty())
    os << "taken for holes: " << counted(report.nonpositive_faces.size(), "flipped face") << "\n";
  write_inverted_quads(os, report.number_of_inverted_quads, report.first_inverted_quads,
                       options.output);
}

nlohmann::json json_of(const SS::Snapping_report& snapped, const SS::Extraction_report& report)
{
  return {{"number_of_quads", report.number_of_faces - report.number_of_other_polygons},
          {"number_of_vertices", report.number_of_vertices},
          {"number_of_cones", report.number_of_cones},
          {"number_of_inverted_quads", report.number_of_inverted_quads},
          {"first_inverted_quads", report.first_inverted_quads},
          {"number_of_other_polygons", report.number_of_other_polygons},
          {"number_of_cut_cells", report.number_of_cut_cells},
          {"nonpositive_faces", report.nonpositive_faces},
          {"largest_rounding", snapped.largest_rounding},
          {"steps", json_of_steps(snapped.run.step_times)}};
}

} // namespace

void quads(const Arguments& arguments)
{
  Quad_options options;
  if(!options.parse(arguments))
    return;
  Model model;
  read_model(options.input, options.seams.reading, model);
  std::ostream& os = summary_stream({options.output, options.picture, options.report});
  os << notes_on_reading(model) << std::flush;
  const SS::Snapping_report snapped = snap(options, model);
  const auto np =
    SS::parameters::edge_is_constrained_map(model.is_feature).allow_holes(options.allow_holes);
  SS::Extraction_report report;
  const Progress progress("extracting quads", options.seams.reading.verbose);
  if(options.soup) {
    Quad_soup soup;
    report = SS::extract_quad_soup<CGAL::Parallel_if_available_tag>(
      model.mesh, model.uv_map, soup.points, soup.polygons, np);
    check_report(options, model, report);
    write_file(options.output, text_of_quads(soup, options.output));
  } else {
    Mesh mesh;
    const Edge_bool_map is_feature = mesh.add_property_map<Edge, bool>("e:feature", false).first;
    report = SS::extract_quad_mesh<CGAL::Parallel_if_available_tag>(
      model.mesh, model.uv_map, mesh, np, SS::parameters::edge_is_constrained_map(is_feature));
    check_report(options, model, report);
    write_file(options.output, text_of_quads(mesh, options.output));
    if(!options.picture.empty())
      write_file(options.picture, quad_picture(mesh, is_feature));
  }
  write_summary(os, options,
                snapped, report);
  if(!options.report.empty())
    write_json(options.report, json_of(snapped, report));
}
