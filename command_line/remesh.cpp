// seamless remesh IN OUT: from a triangle mesh to a quad mesh.

#include "Failure.h"
#include "Feature_options.h"
#include "Options.h"
#include "Progress.h"
#include "Repairs.h"
#include "Topology.h"
#include "attributes.h"
#include "commands.h"
#include "directions.h"
#include "files.h"
#include "json_report.h"
#include "patches.h"
#include "plain_meshes.h"
#include "shape_report.h"
#include "pictures/quad_picture.h"
#include "words.h"

#include <CGAL/Quad_remeshing/find_symmetry_plane.h>
#include <CGAL/Quad_remeshing/quad_remesh.h>

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Search_traits_3.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <limits>
#include <locale>
#include <memory>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace QR = CGAL::Quad_remeshing;

namespace {

using Sizing_map = Mesh::Property_map<Mesh::Vertex_index, double>;

// The plane of a name; none without a name. Throws `Failure`.
std::optional<Kernel::Plane_3> named_plane(const std::string& name)
{
  if(name.empty())
    return std::nullopt;
  if(name == "x" || name == "y" || name == "z")
    return Kernel::Plane_3(name == "x", name == "y", name == "z", 0);
  std::istringstream stream(name);
  stream.imbue(std::locale::classic());
  std::array<double, 4> plane;
  char comma = ',';
  for(std::size_t i = 0; i < 4 && comma == ','; ++i)
    if(stream >> plane[i] && i < 3)
      stream >> comma;
  if(!stream || comma != ',' || !(stream >> std::ws).eof())
    throw Failure(USAGE, "'" + name + "' is not x, y, z, auto, or four numbers A,B,C,D");
  const Kernel::Plane_3 result(plane[0], plane[1], plane[2], plane[3]);
  if(result.is_degenerate())
    throw Failure(USAGE, "'" + name + "' is no plane: one of A, B, C must not be 0");
  return result;
}

// The area of the mesh in squares of the given sizes.
double area_in_sizes(const Mesh& mesh, const Sizing_map& sizes)
{
  double result = 0;
  for(const auto f : mesh.faces()) {
    double size = 1;
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      size *= std::cbrt(sizes[v]);
    result += PMP::face_area(f, mesh) / size / size;
  }
  return result;
}

// A note if sizes vary so much that a few of them may be mistakes.
std::string note_on_sizes(const Sizing_map& sizes, const Model& model)
{
  constexpr double much = 1000;
  const auto vertices = model.mesh.vertices();
  const auto [least, largest] =
    std::minmax_element(vertices.begin(), vertices.end(),
                        [&](const auto v, const auto w) { return sizes[v] < sizes[w]; });
  if(least == vertices.end() || !(sizes[*largest] > much * sizes[*least]))
    return {};
  std::ostringstream os;
  os << "note: sizes vary from " << sizes[*least] << ", number "
     << model.file_vertices[*least] + 1 << ", to " << sizes[*largest] << ", number "
     << model.file_vertices[*largest] + 1 << "; a single small one makes many quads\n";
  return os.str();
}

struct Remesh_options
{
  std::string input, output, field, sizes, symmetry, picture, patches, report;
  Plain_reading_options reading;
  double number = 10000, maximum_number = 0, edge_length = 0, feature_loss = 0, adaptivity = 1;
  Feature_options features;
  std::optional<double> curvature, border_tolerance, area_threshold;
  bool coarsest = false, leaves_out_noise = false;

  // Returns whether there is something to do.
  bool parse(const Arguments& arguments)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double largest_number = 1 << 28;
    Options options("remesh IN OUT",
                    "Makes a mesh of quads from a triangle mesh. Quads follow borders and sharp edges.\n"
                    "\n"
                    "IN is a .obj, .ply, .off, or .stl file, a file of another format that CGAL\n"
                    "reads, or - for the standard input. The program repairs IN if necessary, and tells\n"
                    "how. OUT is a .obj, .off, or .ply file, or - for the standard output, as OBJ. From\n"
                    ".obj to .obj, the quads get texture coordinates, colors, groups, and materials;\n"
                    "from .ply to .ply, all properties that are numbers, except normals.\n");
    options.add_file("input", input);
    options.add_file("output", output);
    options.add("number", "N", number, whole_numbers(1, largest_number),
                "the wanted number of quads (default: 10000)");
    options.add("edge-length", "L", edge_length, {0, infinity, true},
                "instead of a number, the wanted length of edges");
    options.add("coarsest", coarsest, "instead of a number, make as few quads as the search finds");
    options.add("maximum-number", "N", maximum_number, whole_numbers(1, largest_number),
                "the largest number of quads, in case features force more than wanted (default: 100 "
                "times the wanted number, and at least 100000). Give it to ask for more than 10 million");
    features.add_to(options, "keep",
                    "the wanted length of edges of quads; 0 with --coarsest and --features");
    options.add("feature-loss", "PART", feature_loss, {0, 1},
                "the part of the length of all features, from 0 to 1, that may be given up if features "
                "force more quads than wanted (default: 0)");
    double strength = 0, tolerance = 0, area = 0;
    options.add("curvature", "STRENGTH", strength, {0, (std::numeric_limits<double>::max)()},
                "how strongly quads follow the curvature. 0: not at all; the default if sizes vary. 0.002: "
                "along sharp edges and around cylinders; the default otherwise, and less on large "
                "meshes. 0.1 and more: strongly, with more irregular vertices");
    options.add("border-tolerance", "L", tolerance, {0, infinity},
                "ignore steps of the border up to this size (default: half the wanted length of edges; 0 "
                "if sizes vary, and with --coarsest)");
    options.add("area-threshold", "A", area, {0, infinity},
                "leave out closed pieces of less area, except for the largest piece (default: the area "
                "of a quad, and a hundredth of the largest piece, if that is less; 0 with --coarsest)");
    options.add("field", "FILE", field,
                "directions of the quads for the faces of IN, a .rosy or .rawfield file. Faces with the "
                "direction 0 are free. Features take precedence. Quads can turn away from the "
                "directions to keep equal sizes, unless --sizes fit the directions");
    options.add("sizes", "FILE", sizes,
                "wanted lengths of edges at the vertices of IN: a text file with a number for each "
                "vertex, in the order of IN; or the name of a property if IN is a .ply file. With "
                "--number, only ratios count; with --edge-length, sizes are multiples of it; otherwise, "
                "they are lengths");
    options.add("adaptivity", "R", adaptivity, {1, (std::numeric_limits<double>::max)()},
                "make quads up to R times larger on flat parts than on curved parts; the ratio is often "
                "2 to 4 only");
    options.add("symmetry", "PLANE", symmetry,
                "keep the half on the positive side of a plane, and mirror it: x for the plane x = 0, y, "
                "or z; A,B,C,D for the plane Ax + By + Cz + D = 0; auto for a plane by which all "
                "vertices of IN are symmetric up to about six digits");
    reading.add_to(options);
    options.add("picture", "FILE", picture, "draw the quads, as .svg");
    add_patches_to(options, patches);
    options.add("report", "R.json", report, "write all measurements to a file, as JSON");
    options.add("verbose", reading.verbose, "report each step");
    options.add_alias("quads", "number");
    options.add_alias("svg", "picture");
    options.exclude({"number", "edge-length", "coarsest"});
    if(!options.parse(arguments))
      return false;
    if(reading.features && features.is_automatic())
      features.angle = 0;
    leaves_out_noise = features.angle != 0 && !coarsest && !reading.features &&
                       !options.is_given("feature-length");
    if(options.is_given("curvature"))
      curvature = strength;
    if(options.is_given("border-tolerance"))
      border_tolerance = tolerance;
    if(options.is_given("area-threshold"))
      area_threshold = area;
    check_quad_file(output);
    if(!sizes.empty() && !options.is_given("number") && !options.is_given("edge-length") &&
       !coarsest)
      edge_length = 1;
    if(edge_length == 0 && !coarsest)
      check_number_of_faces("number", number, "quads", "; --maximum-number allows more",
                            most_quads());
    if(symmetry != "auto")
      named_plane(symmetry);
    check_direction_file(field);
    check_picture(picture);
    check_patch_file(patches);
    check_outputs({input, field, sizes}, {output, picture, patches, report});
    return true;
  }

  // The length of the edges of the quads, if all are squares; the mean one where sizes vary.
  double wanted_length(Mesh& mesh, const Sizing_map& sizes_of_vertices) const
  {
    if(edge_length > 0 && sizes.empty())
      return edge_length;
    const Size_near_one size(mesh);
    if(edge_length == 0)
      return size.unscaled(std::sqrt(PMP::area(mesh) / number));
    return edge_length * std::sqrt(PMP::area(mesh) / area_in_sizes(mesh, sizes_of_vertices));
  }

  double most_quads() const { return maximum_number > 0 ? maximum_number : most_faces; }
};

// How far images of vertices by a plane are from vertices, at most.
double asymmetry(const Mesh& mesh, const Kernel::Plane_3& plane)
{
  using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel> >;
  const Search::Tree tree(mesh.points().begin(), mesh.points().end());
  double largest = 0;
  for(const auto v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    largest = (std::max)(largest, Search(tree, p + 2 * (plane.projection(p) - p)).begin()->second);
  }
  return std::sqrt(largest);
}

// As --symmetry takes it.
std::string in_words(const Kernel::Plane_3& plane)
{
  std::ostringstream os;
  os << std::setprecision(17) << plane.a() << "," << plane.b() << "," << plane.c() << ","
     << plane.d();
  return os.str();
}

// Nothing without a name. Throws `Failure`.
std::optional<Kernel::Plane_3> symmetry_plane(const Remesh_options& options, const Mesh& mesh)
{
  if(options.symmetry != "auto")
    return named_plane(options.symmetry);
  const auto plane = QR::find_symmetry_plane(mesh);
  if(plane)
    return plane;
  std::ostringstream os;
  os << options.input << ": the vertices are not symmetric by a plane across a coordinate axis";
  const auto nearest = QR::find_symmetry_plane(
    mesh, QR::parameters::tolerance(std::numeric_limits<double>::infinity()));
  if(nearest)
    os << "; by --symmetry " << in_words(*nearest) << ", they are up to " << std::setprecision(3)
       << asymmetry(mesh, *nearest) << " off";
  throw Failure(NOT_SOLVED, os.str());
}

// Throws `Failure` if the quads are too many, or less than one.
void check_edge_length(const Remesh_options& options, const Mesh& mesh, const Sizing_map& sizes)
{
  const double number = area_in_sizes(mesh, sizes);
  const double most = options.most_quads();
  if(!(options.edge_length > 0 && std::isfinite(number)))
    return;
  const double wanted = number / options.edge_length / options.edge_length;
  const std::string name = options.sizes.empty() ? "edge-length" : "sizes";
  if(wanted < 1)
    throw Failure(USAGE, "--" + name + " makes less than one quad");
  check_number_of_faces(name, wanted, "quads",
                        by_edge_length(number, most) + "; --maximum-number allows more", most);
}

// The piece with the first face of a part.
std::string name_of_piece(const QR::Part_of_other_size& part, const Model& model)
{
  return in_words_of_user("the piece with " + Message(Message::FACE, "face", part.face), model);
}

// Throws `Failure` if there are many more quads than wanted without a reason, in all or in a piece.
void check_number_of_quads(const Remesh_options& options, const QR::Remeshing_report& report,
                           const Model& model)
{
  if(!report.has_too_many_quads)
    return;
  const auto& parts = report.parts_of_other_size;
  const auto part = std::find_if(parts.begin(), parts.end(), [&](const auto& p) {
    return p.has_too_many_quads && p.number_of_quads < report.number_of_quads;
  });
  throw Failure(STILL_FLIPPED, options.output + ": written, but " +
                                 (part == parts.end() ? "" : name_of_piece(*part, model) + " has ") +
                                 counted(part == parts.end() ? report.number_of_quads
                                                             : part->number_of_quads, "quad") +
                                 (part == parts.end() ? " are" : ",") +
                                 " more than twice as many as wanted; ask for more quads by "
                                 "--number, or keep fewer features by a larger --feature-angle");
}

QR::Remeshing_report make_quads(const Remesh_options& options, const Mesh& mesh,
                                const Edge_bool_map& is_feature,
                                const Direction_map& directions, const Sizing_map& sizes,
                                const std::optional<Kernel::Plane_3>& plane, Located_quads& quads)
{
  const Progress progress("remeshing " + counted(mesh.number_of_faces(), "face"),
                          options.reading.verbose);
  const auto parameters =
    QR::parameters::edge_is_constrained_map(is_feature)
                   .curvature_alignment(options.curvature).face_direction_map(directions)
                   .curvature_adaptivity(options.adaptivity).vertex_sizing_map(sizes)
                   .border_tolerance(options.border_tolerance)
                   .area_threshold(options.area_threshold)
                   .symmetry_plane(plane).minimize_number_of_quads(options.coarsest)
                   .verbose(options.reading.verbose).maximum_feature_loss(options.feature_loss)
                   .target_number_of_quads(static_cast<std::size_t>(options.number));
  const auto make = [&](const auto& np) {
    return QR::quad_remesh(mesh, quads.mesh, np,
                           QR::parameters::edge_is_constrained_map(quads.is_feature)
                                          .vertex_location_map(quads.of_vertex)
                                          .face_location_map(quads.of_face));
  };
  const auto make_at_most = [&](const auto& np) {
    return options.maximum_number > 0
             ? make(np.maximum_number(static_cast<std::size_t>(options.maximum_number))) : make(np);
  };
  return options.edge_length > 0 ? make_at_most(parameters.target_edge_length(options.edge_length))
                                 : make_at_most(parameters);
}

double largest_distance(const QR::Remeshing_report& report)
{ return (std::max)(report.largest_distance, report.largest_distance_of_input); }

// Whether quads that follow detected features have a flaw. On most models they have none: they are
// nearly squares, and the surface is near, because no quad crosses a sharp edge.
bool may_be_better_without_features(const QR::Remeshing_report& report)
{
  constexpr double good_jacobian = 0.98, near = 0.25; // of the median edge
  return !report || report.number_of_bad_quads() > 0 ||
         report.mean_scaled_jacobian < good_jacobian ||
         largest_distance(report) > near * report.edge_lengths[1];
}

// Whether quads without the detected features are not worse in any respect: validity, distance, and
// shape.
bool is_better_without_features(const QR::Remeshing_report& without,
                                const QR::Remeshing_report& with)
{
  constexpr double about_equal = 1.05; // ratio of distances: samples measure them
  if(!without || !with)
    return bool(without);
  if(without.number_of_bad_quads() != with.number_of_bad_quads())
    return without.number_of_bad_quads() < with.number_of_bad_quads();
  return without.mean_scaled_jacobian > with.mean_scaled_jacobian &&
         largest_distance(without) <= about_equal * largest_distance(with);
}

// That a plane has no half on its other side, which would be replaced; or that what replaces it is
// much different; else nothing.
std::string note_on_plane(const Remesh_options& options,
                          const std::optional<Kernel::Plane_3>& plane, const Mesh& mesh)
{
  constexpr double much = 0.01; // of the diagonal
  if(!plane)
    return {};
  const auto has_vertex_on = [&](const CGAL::Oriented_side side) {
    return std::any_of(mesh.vertices_begin(), mesh.vertices_end(), [&](const auto v)
                       { return plane->oriented_side(mesh.point(v)) == side; });
  };
  if(!has_vertex_on(CGAL::ON_NEGATIVE_SIDE) && has_vertex_on(CGAL::ON_POSITIVE_SIDE))
    return "note: no vertex is on the negative side of the plane of --symmetry: the mesh as a whole "
           "is mirrored, not one half of it\n";
  if(options.symmetry == "auto") {
    std::ostringstream os;
    os << "symmetry: by the plane " << in_words(*plane);
    if(const double distance = asymmetry(mesh, *plane); distance > 0)
      os << ", up to " << std::setprecision(3) << distance << " off; the quads are symmetric exactly";
    os << "\n";
    return os.str();
  }
  const double distance = asymmetry(mesh, *plane);
  if(!(distance > much * diagonal(mesh)))
    return {};
  std::ostringstream os;
  os << "note: the mesh is not symmetric by --symmetry: images of vertices are up to " << distance
     << " off the nearest vertex; the image of one half takes the place of the other\n";
  return os.str();
}

// Pieces that have no quads, or quads of another size than wanted.
std::string note_on_pieces(const QR::Remeshing_report& report, const Model& model)
{
  constexpr std::size_t most = 10;
  std::ostringstream os;
  if(const std::size_t n = report.number_of_parts_left_out; n > 0)
    os << "left out: " << counted(n, "small closed piece") << ", of area "
       << report.area_of_parts_left_out << (n == 1 ? "" : " in sum")
       << "; --area-threshold 0 keeps all\n";
  const auto& parts = report.parts_of_other_size;
  for(std::size_t i = 0; i < parts.size() && i < most; ++i) {
    const bool has_more = double(parts[i].number_of_quads) > parts[i].number_wanted;
    os << "warning: " << name_of_piece(parts[i], model) << " has "
       << counted(parts[i].number_of_quads, "quad") << " in place of " << parts[i].number_wanted
       << " of the wanted size, so its quads are " << (has_more ? "smaller" : "larger");
    if(has_more)
      os << "; it needs " << parts[i].number_needed;
    os << "\n";
  }
  if(parts.size() > most)
    os << "warning: quads of " << parts.size() - most << " more pieces have another size\n";
  return os.str();
}

nlohmann::json json_of(const std::vector<QR::Part_of_other_size>& parts)
{
  nlohmann::json result = nlohmann::json::array();
  for(const auto& p : parts)
    result.push_back({{"face", p.face}, {"number_of_quads", p.number_of_quads},
                      {"number_wanted", p.number_wanted}, {"number_needed", p.number_needed},
                      {"has_too_many_quads", p.has_too_many_quads}});
  return result;
}

nlohmann::json json_of(const std::vector<QR::Released_feature>& features)
{
  nlohmann::json result = nlohmann::json::array();
  for(const auto& f : features)
    result.push_back({{"source", f.source}, {"target", f.target}, {"length", f.length}});
  return result;
}

nlohmann::json json_of(const std::optional<Kernel::Plane_3>& p)
{ return p ? nlohmann::json{p->a(), p->b(), p->c(), p->d()} : nullptr; }

// What is told of the work, as far as it came.
struct Remesh_outcome
{
  Repairs repairs;
  Marked_features features;
  QR::Remeshing_report report;
  std::optional<Kernel::Plane_3> symmetry_plane;
  double diagonal = 0; // of the input
  std::optional<double> turn; // against the directions of --field
  std::optional<Topologies> topologies;
  std::optional<Patch_counts> patches;

  void write_summary(std::ostream& os, const std::string& output) const
  {
    os << counted(report.number_of_quads, "quad") << ", "
       << counted(report.number_of_vertices, "vertex") << ", "
       << counted(report.number_of_irregular_vertices, "irregular vertex") << "\n"
       << (report.message.empty() ? "" : "note: " + report.message + "\n");
    write_shape(os, report, diagonal);
    if(!symmetry_plane && cuts_off())
      os << "note: the quads cut off much of the input; more of them"
         << (features.length > 0 ? "" : ", or features, as by --feature-angle,") << " keep it\n";
    write_edges(os);
    if(report.number_of_corners_left_out > 0)
      os << "border: " << counted(report.number_of_corners_left_out, "corner")
         << " left out, of steps that are smaller than quads; --border-tolerance 0 keeps all\n";
    write_inverted_quads(os, report.number_of_inverted_quads, report.first_inverted_quads, output);
    write_folded_quads(os, report.number_of_folded_quads, report.first_folded_quads, output);
    if(report.number_of_bad_quads() > 0 &&
       report.number_of_quads < 10 * report.number_of_irregular_vertices)
      os << "note: these are few quads for so many irregular vertices; a larger --number leaves more "
            "room for good ones\n";
    write_displacement(os, report.number_of_displaced_vertices, report.largest_displacement);
    if(report.number_of_released_edges > 0)
      os << "not kept, because faces would be flipped, or quads inverted, folded, or thin: "
         << counted(report.number_of_released_edges, "feature edge")
         << ", or parts of edges, of length " << report.length_of_released_edges << " in sum\n";
    if(const auto& released = report.released_features; !released.empty())
      os << "released by --feature-loss: " << counted(released.size(), "line")
         << " of features, of length "
         << std::accumulate(released.begin(), released.end(), 0.,
                            [](const double sum, const auto& f) { return sum + f.length; })
         << " in sum\n";
    ::write_summary(os, patches);
  }

  // More than quads of this size take off a corner.
  bool cuts_off() const
  {
    const double most = largest_distance(report);
    return most > 0.1 * diagonal || most > 1.5 * report.edge_lengths[1];
  }

  void write_edges(std::ostream& os) const
  {
    const auto& [shortest, median, longest] = report.edge_lengths;
    os << "edges: " << median << " long in the median, and eight of ten " << shortest << " to "
       << longest;
    if(report.median_size_deviation)
      os << "; " << 100 * *report.median_size_deviation << " % off the wanted length in the median";
    os << "\n";
    if(turn)
      os << "directions of --field: quads are turned by " << *turn << " degrees in the median\n";
  }

  nlohmann::json json(const bool is_written, const std::string& message) const
  {
    nlohmann::json result = {{"written", is_written},
                             {"status", to_string(report.status)},
                             {"message", is_written ? report.message.str() : message},
                             {"input", json_of(repairs)},
                             {"number_of_forced_quads", report.number_of_forced_quads},
                             {"released_features", json_of(report.released_features)},
                             {"steps", json_of_steps(report.step_times)}};
    if(!is_written)
      return result;
    result.update(nlohmann::json{
      {"number_of_quads", report.number_of_quads},
      {"number_of_vertices", report.number_of_vertices},
      {"number_of_irregular_vertices", report.number_of_irregular_vertices},
      {"number_of_inverted_quads", report.number_of_inverted_quads},
      {"first_inverted_quads", report.first_inverted_quads},
      {"number_of_folded_quads", report.number_of_folded_quads},
      {"first_folded_quads", report.first_folded_quads},
      {"number_of_displaced_vertices", report.number_of_displaced_vertices},
      {"largest_displacement", report.largest_displacement},
      {"edge_lengths", report.edge_lengths},
      {"median_size_deviation", report.median_size_deviation
                                  ? nlohmann::json(*report.median_size_deviation) : nullptr},
      {"median_turn_against_field", turn ? nlohmann::json(*turn) : nullptr},
      {"symmetry_plane", json_of(symmetry_plane)},
      {"topology", json_of(topologies)},
      {"patches", json_of(patches)},
      {"length_of_features", features.length},
      {"number_of_edges_left_out", features.number_left_out},
      {"number_of_corners_left_out", report.number_of_corners_left_out},
      {"parts_of_other_size", json_of(report.parts_of_other_size)},
      {"number_of_parts_left_out", report.number_of_parts_left_out},
      {"area_of_parts_left_out", report.area_of_parts_left_out},
      {"number_of_released_edges", report.number_of_released_edges},
      {"length_of_released_edges", report.length_of_released_edges}});
    result.update(json_of_shape(report, diagonal));
    return result;
  }
};

// Takes the quads without the detected features, which nobody has asked for, if these are better.
void try_without_features(const Remesh_options& options, const Direction_map& directions,
                          const Sizing_map& sizes, Model& model, Remesh_outcome& outcome,
                          std::unique_ptr<Located_quads>& quads, std::ostream& os)
{
  const Edge_bool_map none = model.mesh.add_property_map<Edge, bool>("e:none", false).first;
  auto others = std::make_unique<Located_quads>();
  const QR::Remeshing_report without =
    make_quads(options, model.mesh, none, directions, sizes, outcome.symmetry_plane, *others);
  if(!is_better_without_features(without, outcome.report))
    return;
  os << "no sharp edge kept after all, because quads that ignore them have better shapes, and are "
        "about as near to the surface; --feature-angle "
     << Feature_options::detected_angle << " keeps them\n";
  outcome.report = without;
  outcome.features.length = 0;
  quads.swap(others);
}

} // namespace

void remesh(const Arguments& arguments)
{
  Remesh_options options;
  if(!options.parse(arguments))
    return;
  std::ostream& os = summary_stream({options.output, options.picture, options.patches, options.report});
  Model model;
  Remesh_outcome outcome;
  outcome.repairs = read_or_tell(options.report, "written", [&]
    { return read_plain_model(options.input, options.reading, model); });
  write_repairs(os, options.input, outcome.repairs);
  os << note_on_features(options.reading.features, model);
  auto quads = std::make_unique<Located_quads>();
  const auto work = [&] {
    const Direction_map directions =
      read_directions(options.field, outcome.repairs, model.mesh, os);
    const Sizing_map sizes = read_sizes(options.sizes, options.input, outcome.repairs, model);
    os << note_on_sizes(sizes, model);
    const double length = options.wanted_length(model.mesh, sizes);
    if(options.leaves_out_noise) {
      options.features.length = length;
      options.features.has_default_length = true;
    }
    outcome.features = options.features.mark(length, model, os);
    if(options.feature_loss > 0 && outcome.features.length == 0)
      os << "note: no edge is a feature that --feature-loss could release; see --feature-angle and "
            "--features\n";
    os << std::flush; // before long work
    const auto& plane = outcome.symmetry_plane = symmetry_plane(options, model.mesh);
    os << note_on_plane(options, plane, model.mesh);
    check_edge_length(options, model.mesh, sizes);
    QR::Remeshing_report& report = outcome.report;
    report = make_quads(options, model.mesh, model.is_feature, directions, sizes, plane, *quads);
    if(options.features.is_automatic() && outcome.features.length > 0 && !options.coarsest &&
       may_be_better_without_features(report))
      try_without_features(options, directions, sizes, model, outcome, quads, os);
    if(!report)
      throw Failure(NOT_SOLVED, options.input + ": " + in_words_of_user(to_string(report.status) + (": " + report.message), model));
    report.message = in_words_of_user(report.message, model);
    outcome.topologies = {Topology(model.mesh), Topology(quads->mesh)};
    os << note_on_pieces(report, model)
       << note(*outcome.topologies, plane ? "mirroring" : "remeshing");
    outcome.diagonal = ::diagonal(model.mesh);
    outcome.turn = median_turn(*quads, directions, model.mesh);
    write_file(options.output, text_with_attributes(model, options.input, *quads, options.output));
    quads->count_as_written(report.first_inverted_quads);
    quads->count_as_written(report.first_folded_quads);
    quads->count_as_written(report.first_thin_quads);
    quads->count_as_written(report.first_degenerate_quads);
    if(!options.picture.empty())
      write_file(options.picture, quad_picture(quads->mesh, quads->is_feature));
    outcome.patches = write_patches(quads->mesh, quads->is_feature, options.patches);
    outcome.write_summary(os, options.output);
    check_inverted_quads(report.number_of_inverted_quads, options.output);
    check_folded_quads(report.number_of_folded_quads, options.output);
    check_number_of_quads(options, report, model);
  };
  run_and_tell(work, [&](const Exit status, const std::string& message) {
    if(!options.report.empty())
      write_json(options.report, outcome.json(is_written(status), message));
  });
}
