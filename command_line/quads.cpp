// seamless quads IN OUT: extracts the quad mesh of an integer-grid map.

#include "Failure.h"
#include "Options.h"
#include "Summary.h"
#include "commands.h"
#include "files.h"
#include "measures.h"
#include "plain_meshes.h"
#include "quad_picture.h"

#include <CGAL/Seamless_snapping/extract_quad_mesh.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

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
  std::string input, output, picture;
  double scale = 1, number = 0, rounding = 0.01;
  bool allow_holes = false, soup = false;

  bool parse(const Arguments& arguments)
  {
    Options options("quads IN OUT",
                    "Makes the texture coordinates of a triangle mesh an exact integer-grid map,\n"
                    "and extracts the quad mesh that it describes: its edges are the lines on which\n"
                    "a coordinate is an integer. IN is a .obj file, a .ply file with a list\n"
                    "'texcoord' for each face, or - for the standard input; OUT is a .obj or .off\n"
                    "file.\n");
    options.add_file("input", input);
    options.add_file("output", output);
    seams.add_to(options);
    options.add("grid-scale", "K", scale, "multiply the coordinates by K first (default: 1)");
    options.add("number", "N", number,
                "instead, scale the coordinates to an area of N, for about N quads, and round as "
                "far as needed");
    options.add("rounding", "D", rounding,
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
    if(!options.parse(arguments))
      return false;
    seams.check(options);
    if(options.is_given("number") && options.is_given("grid-scale"))
      throw Failure(USAGE, "--number and --grid-scale exclude each other");
    if(options.is_given("number") && !(number >= 1))
      throw Failure(USAGE, "the number of quads must be at least 1");
    if(soup && options.is_given("picture"))
      throw Failure(USAGE, "--soup and --picture exclude each other");
    if(options.is_given("number") && !options.is_given("rounding"))
      rounding = std::numeric_limits<double>::infinity();
    if(suffix_of(output) != "obj" && suffix_of(output) != "off")
      throw Failure(USAGE, "'" + output + "': quads are written to .obj and .off files");
    check_picture(picture);
    check_outputs({input}, {output, picture}, false);
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
  const SS::Snapping_report report = SS::snap_to_seamless(
    model.mesh, model.uv_map,
    SS::parameters::edge_is_constrained_map(alignment.is_aligned).tolerance(options.seams.tolerance)
      .integer_grid(true).grid_scale(scale_for_number(model, options))
      .rounding_tolerance(options.rounding)
      .repair_flips(options.seams.flip_repair())
      .verbose(options.seams.reading.verbose));
  if(!report)
    throw Failure(NOT_SOLVED, options.input + ": " + in_words_of_user(to_text(report), model));
  return report;
}

// In the words of the command line.
std::string flips_message(const Quad_options& options, const std::vector<std::size_t>& faces)
{
  return std::to_string(faces.size()) +
         " faces of the integer-grid map are flipped or degenerate, the first is face " +
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

} // namespace

void quads(const Arguments& arguments)
{
  Quad_options options;
  if(!options.parse(arguments))
    return;
  Model model;
  read_model(options.input, options.seams.reading, model);
  const SS::Snapping_report snapped = snap(options, model);
  const auto np =
    SS::parameters::edge_is_constrained_map(model.is_feature).allow_holes(options.allow_holes);
  SS::Extraction_report report;
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
  std::ostream& os = summary_stream({options.output, options.picture});
  os << report.number_of_faces - report.number_of_other_polygons << " quads, "
     << report.number_of_vertices << " vertices, " << report.number_of_cones << " cones\n"
     << "translations, cones, and levels rounded by up to " << snapped.largest_rounding << "\n";
  if(report.number_of_other_polygons > 0)
    os << report.number_of_other_polygons << " other polygons around cones between grid lines; "
          "--grid-scale 2 avoids those at half-integers\n";
  if(report.number_of_cut_cells > 0)
    os << report.number_of_cut_cells << " pieces of cells at the border or at holes left out\n";
  if(!report.nonpositive_faces.empty())
    os << report.nonpositive_faces.size() << " flipped faces taken for holes\n";
}
