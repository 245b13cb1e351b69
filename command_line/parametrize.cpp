// seamless parametrize IN OUT: from a plain triangle mesh to an exactly seamless parametrization.

#include "Failure.h"
#include "Feature_options.h"
#include "Model.h"
#include "Options.h"
#include "Progress.h"
#include "Repairs.h"
#include "commands.h"
#include "directions.h"
#include "files.h"
#include "json_report.h"
#include "pictures/picture.h"
#include "words.h"

#include <CGAL/Quad_remeshing/approximate_seamless_parametrization.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace QR = CGAL::Quad_remeshing;

namespace {

struct Parametrize_options
{
  std::string input, output, field, approximate, picture, report;
  Plain_reading_options reading;
  Feature_options features;
  double curvature = 0;
  bool align_border = false;
  bool overwrite = false;

  // Returns whether there is something to do.
  bool parse(const Arguments& arguments)
  {
    Options options("parametrize IN OUT",
                    "Computes an exactly seamless parametrization of a mesh.\n"
                    "\n"
                    "IN is a .obj, .ply, .off, or .stl file, a file of another format that CGAL\n"
                    "reads, or - for the standard input. The program repairs IN if necessary, and tells\n"
                    "how. OUT is a .obj or .ply file, or - for the standard output, as OBJ. It has the\n"
                    "points, faces, and features of IN only.\n");
    options.add_file("input", input);
    options.add_file("output", output);
    features.add_to(options, "align");
    options.add("align-border", align_border, "align border edges");
    options.add("curvature", "STRENGTH", curvature, {0, (std::numeric_limits<double>::max)()},
                "how strongly the field follows the curvature (default: 0)");
    options.add("field", "FILE", field,
                "directions of the field for the faces of IN, a .rosy or .rawfield file. Faces with the "
                "direction 0 are free. Features take precedence");
    reading.add_to(options);
    options.add("approximate", "APPROX", approximate, "also write the parametrization before it was made exact");
    options.add("overwrite", overwrite, "let OUT replace IN");
    options.add("picture", "FILE", picture,
                "draw the domain, and the largest gaps before and after, as .svg");
    options.add("report", "R.json", report, "write all measurements to a file, as JSON");
    options.add("verbose", reading.verbose, "report each step");
    options.add_alias("svg", "picture");
    if(!options.parse(arguments))
      return false;
    if(reading.features && features.is_automatic())
      features.angle = 0;
    check_format(output);
    check_direction_file(field);
    if(!approximate.empty())
      check_format(approximate);
    check_picture(picture);
    check_outputs({input, field}, {output, approximate, picture, report},
                  overwrite ? Overwriting::ASKED_FOR : Overwriting::NOT_ASKED_FOR);
    return true;
  }
};

// How long edges of as many quads are as 'quads' and 'remesh' make by default: what the map is for is
// not known here.
double edge_of_quads(Mesh& mesh)
{
  constexpr double number = 10000;
  const Size_near_one size(mesh);
  return size.unscaled(std::sqrt(CGAL::Polygon_mesh_processing::area(mesh) / number));
}

// What is told of the work, as far as it came.
struct Outcome
{
  Repairs repairs;
  std::size_t number_of_single_edges = 0; // that are released, each as one of all three of a face
  QR::Parametrization_report<Mesh::Vertex_index> made;
  QR::Snapping_report snapped;
  bool is_exact = false;

  nlohmann::json json(const std::string& message) const
  {
    return {{"exact", is_exact},
            {"message", message},
            {"status", made ? to_string(snapped.status) : to_string(made.status)},
            {"input", json_of(repairs)},
            {"faces", made.number_of_faces}, {"genus", made.genus},
            {"components", made.number_of_components},
            {"border_loops", made.number_of_border_loops}, {"cones", made.cones.size()},
            {"cut_edges", is_exact ? snapped.run.number_of_cut_edges : made.number_of_cut_edges},
            {"aligned_edges", made.number_of_aligned_edges},
            {"released_edges", number_of_single_edges + made.released_edges.size()},
            {"flipped_faces", made.number_of_flipped_faces},
            {"extent", made.extent}, {"violation", made.violation},
            {"largest_change", snapped.largest_change},
            {"steps", json_of_steps(made.step_times)}};
  }
};

Message name_of_vertices(const std::size_t v, const std::size_t w)
{
  return Message(Message::VERTEX, "vertices", v) + " and " + Message(Message::VERTEX, "", w);
}

void write_made(std::ostream& os, const Outcome& outcome, const Model& model)
{
  const auto& made = outcome.made;
  os << counted(made.number_of_faces, "face") << ", genus " << made.genus << ", "
     << counted(made.number_of_border_loops, "border loop") << ", "
     << counted(made.cones.size(), "cone") << ", "
     << counted(made.number_of_flipped_faces, "flipped face") << ", violation "
     << made.violation / made.extent << " of the extent" << std::endl;
  for(const auto& [v, w] : made.released_edges)
    os << in_words_of_user("not aligned, as faces would be flipped: the edge of the " +
                             name_of_vertices(v, w), model) << "\n";
}

// The features, which become fewer, and the border if that is asked for.
Edge_bool_map aligned_edges(const Parametrize_options& options, Model& model, Outcome& outcome,
                            std::ostream& os)
{
  const Mesh& mesh = model.mesh;
  Edge_bool_map result = model.mesh.add_property_map<Edge, bool>("e:aligned", false).first;
  for(const Edge e : mesh.edges())
    result[e] = model.is_feature[e] || (options.align_border && mesh.is_border(e));
  const std::vector<Edge> released = release_one_of_three(mesh, result);
  for(const Edge e : released)
    model.is_feature[e] = false;
  outcome.number_of_single_edges = released.size();
  if(!released.empty())
    os << in_words_of_user(
            "not aligned, because all three edges of a face would be: " +
              counted(released.size(), "edge") + ", the first has the " +
              name_of_vertices(mesh.vertex(released.front(), 0), mesh.vertex(released.front(), 1)),
            model) << "\n";
  return result;
}

void make_parametrization(const Parametrize_options& options, Model& model, Outcome& outcome,
                          std::ostream& os)
{
  Edge_bool_map is_aligned = aligned_edges(options, model, outcome, os);
  const auto alignment = QR::parameters::edge_is_constrained_map(is_aligned)
                                        .verbose(options.reading.verbose);
  const auto is_cut = get(CGAL::dynamic_edge_property_t<bool>(), model.mesh);
  const auto rotation = get(CGAL::dynamic_halfedge_property_t<int>(), model.mesh);
  const auto transitions = alignment.edge_is_cut_map(is_cut).halfedge_rotation_map(rotation);
  const std::string faces = counted(model.mesh.number_of_faces(), "face");
  {
    const Progress progress("parametrizing " + faces, options.reading.verbose);
    outcome.made = QR::approximate_seamless_parametrization(
      model.mesh, model.uv_map,
      transitions.curvature_alignment(options.curvature).release_alignment(true)
        .face_direction_map(read_directions(options.field, outcome.repairs, model.mesh, os)));
  }
  const auto& made = outcome.made;
  if(!made)
    throw Failure(NOT_SOLVED, options.input + ": " + in_words_of_user(made.message, model));
  write_made(os, outcome, model);
  for(const auto& [v, w] : made.released_edges) {
    const Edge e = model.mesh.edge(model.mesh.halfedge(v, w));
    model.is_feature[e] = is_aligned[e] = false;
  }
  if(!options.approximate.empty())
    write_file(options.approximate, text_of_model(model, options.approximate));

  const Uv_map old_uv_map = copy_of_uv_map(model);
  {
    const Progress progress("snapping " + faces, options.reading.verbose);
    outcome.snapped = QR::snap_to_seamless(model.mesh, model.uv_map, transitions);
  }
  if(!outcome.snapped)
    throw Failure(NOT_SOLVED,
                  options.input + ": " + in_words_of_user(outcome.snapped.message, model));
  outcome.is_exact = QR::is_seamless(model.mesh, model.uv_map, alignment);
  if(!outcome.is_exact)
    throw Failure(NOT_SOLVED, options.input + ": the result is not exact; please report this");
  write_file(options.output, text_of_model(model, options.output));
  if(!options.picture.empty())
    write_file(options.picture, picture(model, old_uv_map, 1e-4,
                                        std::filesystem::path(options.input).filename().string()));
  os << "exactly seamless: largest change " << outcome.snapped.largest_change << ", that is "
     << outcome.snapped.largest_change / outcome.snapped.extent << " of the extent" << std::endl;
}

} // namespace

void parametrize(const Arguments& arguments)
{
  Parametrize_options options;
  if(!options.parse(arguments))
    return;
  std::ostream& os =
    summary_stream({options.output, options.approximate, options.picture, options.report});
  Model model;
  Outcome outcome;
  outcome.repairs = read_or_tell(options.report, "exact", [&]
    { return read_plain_model(options.input, options.reading, model); });
  write_repairs(os, options.input, outcome.repairs);
  os << note_on_features(options.reading.features, model);
  options.features.mark(edge_of_quads(model.mesh), model, os);
  run_and_tell([&] { make_parametrization(options, model, outcome, os); },
               [&](Exit, const std::string& message) {
    if(!options.report.empty())
      write_json(options.report, outcome.json(message));
  });
}
