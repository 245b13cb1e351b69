#include "Model.h"

#include "Failure.h"
#include "Progress.h"
#include "files.h"
#include "words.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/IO/PLY.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <locale>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace SS = CGAL::Seamless_snapping;

namespace {

// This program snaps for rotations by multiples of 90 degrees only.
std::string with_symmetry_in_words(std::string message)
{
  const std::string hint = "; the map is seamless for N = ";
  const std::size_t begin = message.find(hint);
  if(begin == message.npos)
    return message;
  const int N = std::stoi(message.substr(begin + hint.size()));
  const std::size_t end = (std::min)(message.find(">())", begin), message.size() - 4) + 4;
  return message.replace(begin, end - begin,
                         "; the map is seamless for rotations by multiples of " +
                           std::to_string(360 / N) + " degrees" +
                           (message.find("in lattice", begin) < end
                              ? ", in coordinates of a triangular lattice" : "") +
                           ", but this program makes maps exact for multiples of 90 degrees only");
}

// Options in place of the library's named parameters and functions. Of phrases that contain each
// other, the longer ones come first.
std::string with_options(const std::string& message)
{
  static const char* const words[][2] = {
    // remedies
    {"by snap_to_seamless() with repair_flips(true)", "by --repair-flips"},
    {"repair them by repair_integer_grid(), or leave out the cells around them: allow_holes(true)",
     "try --repair-flips, or leave out the quads around them by --allow-holes"},
    {"; snap_to_seamless() with integer_grid(true) and align_border(true) moves it to the grid",
     "; --align-border moves it to the grid"},
    {"call snap_to_seamless() with integer_grid(true) first, or double the map: grid_scale(2)",
     "ask for a number of quads by --number, or double the map by --grid-scale 2"},
    {"call snap_to_seamless() with integer_grid(true) first", "ask for a number of quads by --number"},
    {"call snap_to_seamless() with align_border(true)", "run 'seamless snap' with --align-border"},
    {"call snap_to_seamless() with the same edge_is_constrained_map",
     "run 'seamless snap' with --features"},
    {"call snap_to_seamless() first", "run 'seamless snap' first"},
    {"; snap with align_border(true)", "; run 'seamless snap' with --align-border"},
    {"snap the map by snap_to_seamless()", "run 'seamless snap'"},
    {"pass the map through snap_to_seamless()", "run 'seamless snap' on the map"},
    {"or scale before the map is made exact, by snap_to_seamless() with grid_scale",
     "or scale before 'seamless snap'"},
    {"raise the tolerance", "raise --tolerance"},
    {"; raise it to at least this distance, or scale the map up by grid_scale",
     "; ask for a number of quads by --number, which finds integers for each map without flips, or "
     "raise it to at least this distance"},
    {"set target_edge_length to about the length of an edge", "scale the mesh to about the size 1"},
    {"and at most maximum_number; see target_number_of_quads and target_edge_length",
     "and at most --maximum-number; see --number, --edge-length, and --sizes"},
    {"quantize to more quads, or with needs_face_graph(true), or call extract_quad_soup()",
     "ask for more quads by --number, or try --soup"},
    {" quantize() with needs_face_graph(true), which leaves out its quad, or call "
     "extract_quad_soup()",
     " have the mesh remeshed by 'seamless remesh', which leaves out its quad, or try --soup"},
    {"by grid_scale, or call extract_quad_soup()",
     "by grid_scale, try --soup, or have the mesh remeshed by 'seamless remesh', which always makes "
     "a mesh of quads"},
    {"call extract_quad_soup()", "try --soup"},
    {"; raise maximum_number, or shrink the map by grid_scale",
     "; shrink the map by --grid-scale, or ask for fewer by --number"},
    {"; raise maximum_number, or let curves end where they meet others",
     "; let curves end where they meet others: leave out --base-complex"},
    {"; raise maximum_number, or ", "; "},
    {"see CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices()",
     "'seamless parametrize' takes them apart"},
    {"quad_remesh() makes", "'seamless remesh' makes"},
    {"apply convert_to_lattice_coordinates()", "convert them"},
    // quantities
    {"can't be multiplied by grid_scale", "can't be multiplied by --grid-scale"},
    {"by grid_scale", "by --grid-scale or --number"},
    {"grid_scale", "--grid-scale"},
    {"more than maximum_number", "more than --maximum-number"},
    {"which is maximum_number", "which is --maximum-number"},
    {"minimize_number_of_quads(true)", "--coarsest"},
    {"maximum_feature_loss", "--feature-loss"},
    {"symmetry_plane", "--symmetry"},
    {"curvature_alignment", "--curvature"},
    {"curvature_adaptivity must", "--adaptivity must"},
    {"vertex_sizing_map and curvature_adaptivity", "--sizes and --adaptivity"},
    {"border_tolerance", "--border-tolerance"},
    {"connection_tolerance", "twice --near, or 0.01,"},
    {"the rounding_tolerance is", "--rounding is"},
    {"Flip_repair::UNTANGLE changes", "--repair-flips changes"},
    {"number_of_untangling_iterations", "--untangling-iterations"}};
  return with_words(with_symmetry_in_words(message), words);
}

// Names of formats are suffixes.
const char* const obj = "obj";
const char* const ply = "ply";

// Standard streams and pipes have no suffix: what comes from them tells its format.
std::string format_of(const std::string& filename, const std::string& standard_format)
{
  const std::string suffix = is_special_file(filename) ? standard_format : suffix_of(filename);
  check_no_tetrahedra(filename);
  if(suffix != obj && suffix != ply)
    throw Failure(USAGE, "'" + filename + "': files with coordinates per corner are .obj and .ply "
                         "files");
  return suffix;
}

template <typename UVNumber>
SS::IO::File_status read_as(const bool weld, Model& model)
{
  return model.file.read<UVNumber>(
    model.mesh, model.uv_map,
    SS::parameters::edge_is_constrained_map(model.is_feature).weld_borders(weld));
}

// The numbers of a property of the vertices, of either type.
std::vector<double> numbers_at_vertices(const Mesh& mesh, const std::string& name)
{
  std::vector<double> result;
  const auto add = [&](const auto& found) {
    if(found.second)
      for(const auto v : mesh.vertices())
        result.push_back(double(found.first[v]));
  };
  add(mesh.property_map<Mesh::Vertex_index, float>("v:" + name));
  add(mesh.property_map<Mesh::Vertex_index, double>("v:" + name));
  return result;
}

std::string OBJ_of_PLY(const std::string& text, const std::string& filename, const std::string& s,
                       const std::string& t)
{
  Mesh mesh;
  std::istringstream file(text);
  std::string comments;
  if(!CGAL::IO::read_PLY(file, mesh, comments, false))
    throw Failure(UNREADABLE, filename + ": the file has coordinates '" + s + "' and '" + t +
                                "' at vertices; they are read from surfaces only, and this is none");
  const std::vector<double> u = numbers_at_vertices(mesh, s), v = numbers_at_vertices(mesh, t);
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os.precision(17);
  for(const auto w : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(w);
    os << "v " << p.x() << " " << p.y() << " " << p.z() << "\nvt " << u[std::size_t(w)] << " "
       << v[std::size_t(w)] << "\n";
  }
  for(const auto f : mesh.faces()) {
    os << "f";
    for(const auto w : mesh.vertices_around_face(mesh.halfedge(f)))
      os << " " << w + 1 << "/" << w + 1;
    os << "\n";
  }
  return os.str();
}

// Coordinates at the vertices of a PLY file, as other programs write them, which cut the mesh open
// along its seams: the same mesh as the text of an OBJ file. Nothing if the file has no such, or if
// its faces have coordinates, too. Throws `Failure`.
std::optional<std::string> with_corners(const std::string& text, const std::string& filename)
{
  if(text.compare(0, 3, ply) != 0)
    return std::nullopt;
  std::set<std::string> names; // of properties
  std::istringstream header(text.substr(0, text.find("end_header")));
  for(std::string line; std::getline(header, line); ) {
    std::istringstream words(line);
    const std::vector<std::string> all(std::istream_iterator<std::string>(words), {});
    if(all.size() > 2 && all.front() == "property")
      names.insert(all.back());
  }
  const auto has = [&](const std::string& name) { return names.count(name) == 1; };
  if(has("texcoord"))
    return std::nullopt;
  for(const auto& [s, t] : {std::pair("s", "t"), std::pair("u", "v"),
                            std::pair("texture_u", "texture_v")})
    if(has(s) && has(t))
      return OBJ_of_PLY(text, filename, s, t);
  return std::nullopt;
}

void exchange_coordinates(const Model& model)
{
  for(const Halfedge h : model.mesh.halfedges())
    model.uv_map[h] = Kernel::Point_2(model.uv_map[h].y(), model.uv_map[h].x());
}

// While it lives, the coordinates of the model are those of its file, as far as mirroring goes.
class Coordinates_of_file
{
public:
  explicit Coordinates_of_file(const Model& model) : m_model(model) { exchange(); }
  ~Coordinates_of_file() { exchange(); }

private:
  void exchange() const
  {
    if(m_model.is_mirrored)
      exchange_coordinates(m_model);
  }

  const Model& m_model;
};

void parse(const Reading_options& options, Model& model)
{
  if(model.file.format() == ply)
    model.first_number = 0;
  model.is_float = options.in_float;
  const SS::IO::File_status status = model.is_float ? read_as<float>(options.weld, model)
                                                    : read_as<double>(options.weld, model);
  if(!status) {
    const bool lacks_coordinates =
      status.message.find("has no texture coordinate") != status.message.npos ||
      status.message.find("has no list texcoord") != status.message.npos;
    const bool is_manifold = status.message.find("is not manifold") == status.message.npos;
    throw Failure(UNREADABLE, model.filename + ": " + status.message +
                                (lacks_coordinates ? "; 'seamless parametrize' computes some"
                                 : is_manifold     ? ""
                                                   : "; 'seamless parametrize' cuts such edges, and "
                                                     "computes other coordinates"));
  }
  model.is_mirrored = area_in_domain(model).first < 0;
  if(model.is_mirrored)
    exchange_coordinates(model);
  model.file_vertices = model.file.vertex_numbers();
  model.number_of_split_vertices = status.number_of_split_vertices;
  model.number_of_welded_edges = status.number_of_welded_edges;
  model.number_of_coinciding_border_edges = status.number_of_coinciding_border_edges;
}

// Of another format than the file.
SS::IO::File_status write_as(const std::string& format, const Model& model, std::string& text)
{
  const auto np = SS::parameters::edge_is_constrained_map(model.is_feature);
  std::ostringstream os;
  const SS::IO::File_status status = format == ply
                                       ? SS::IO::write_PLY(os, model.mesh, model.uv_map, np)
                                       : SS::IO::write_OBJ(os, model.mesh, model.uv_map, np);
  text = os.str();
  return status;
}

// Whether the text reads back as the mesh, with vertices as in the file if it is of its format.
bool reads_back(const Model& model, const SS::IO::Mesh_text& text, const bool is_of_file)
{
  const auto number = [&](const Mesh::Vertex_index v) {
    return is_of_file ? model.file_vertices[v] : std::size_t(v);
  };
  const auto np = SS::parameters::edge_is_constrained_map(model.is_feature)
                    .vertex_index_map(
                      boost::make_function_property_map<Mesh::Vertex_index>(number));
  return text.holds(model.mesh, model.uv_map, np) &&
         (!model.is_float || text.holds<float>(model.mesh, model.uv_map, np));
}

} // namespace

bool has_coordinates_at_vertices(const Model& model)
{
  return model.file.format() == obj && model.first_number == 0;
}

double diagonal(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

Size_near_one::Size_near_one(Mesh& mesh)
  : m_mesh(mesh), m_points(mesh.points().begin(), mesh.points().end())
{
  double size = 0;
  for(const Kernel::Point_3& p : m_points)
    for(int c = 0; c < 3; ++c)
      size = (std::max)(size, std::abs(p[c]));
  m_exponent = size > 0 ? std::ilogb(size) : 0;
  for(Kernel::Point_3& p : mesh.points())
    p = {std::ldexp(p.x(), -m_exponent), std::ldexp(p.y(), -m_exponent),
         std::ldexp(p.z(), -m_exponent)};
}

Size_near_one::~Size_near_one()
{
  for(const auto v : m_mesh.vertices()) { // some may be new
    const Kernel::Point_3& p = m_mesh.point(v);
    m_mesh.point(v) = std::size_t(v) < m_points.size()
                        ? m_points[std::size_t(v)]
                        : Kernel::Point_3(std::ldexp(p.x(), m_exponent), std::ldexp(p.y(), m_exponent),
                                          std::ldexp(p.z(), m_exponent));
  }
}

double Size_near_one::unscaled(const double length) const
{
  return std::ldexp(length, m_exponent);
}

void read_model(const std::string& filename, const Reading_options& options, Model& model)
{
  check_format(filename);
  const Progress progress("reading " + filename, options.verbose);
  model.filename = filename;
  const std::string text = read_file(filename);
  const std::optional<std::string> corners = with_corners(text, filename);
  model.first_number = corners ? 0 : 1;
  model.file = corners ? SS::IO::Mesh_text(*corners, obj)
                       : SS::IO::Mesh_text(text, is_special_file(filename) ? "" : suffix_of(filename));
  parse(options, model);
}

std::pair<double, int> area_in_domain(const Model& model, const bool only_positive)
{
  double largest = 0, area = 0;
  for(const Halfedge h : model.mesh.halfedges())
    if(!model.mesh.is_border(h))
      largest = (std::max)({largest, std::abs(model.uv_map[h].x()), std::abs(model.uv_map[h].y())});
  const int exponent = largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0;
  const auto scaled = [&](const Halfedge h) {
    return Kernel::Point_2(std::ldexp(model.uv_map[h].x(), -exponent),
                           std::ldexp(model.uv_map[h].y(), -exponent));
  };
  for(const auto f : model.mesh.faces()) {
    const Halfedge h = model.mesh.halfedge(f);
    const double of_face =
      CGAL::area(scaled(h), scaled(model.mesh.next(h)), scaled(model.mesh.prev(h)));
    area += only_positive ? (std::max)(of_face, 0.) : of_face;
  }
  return {area, exponent};
}

void read_again(const Model& other, const Reading_options& options, Model& model)
{
  model.filename = other.filename;
  model.first_number = other.first_number;
  model.file = SS::IO::Mesh_text(other.file.text(), other.file.format());
  parse(options, model);
}

std::string notes_on_reading(const Model& model)
{
  std::string result;
  if(has_coordinates_at_vertices(model))
    result += "note: coordinates at vertices are taken for those of all corners there; what is written "
              "has coordinates of corners\n";
  if(model.is_mirrored)
    result += "note: the map is mirrored, as most of its faces turn clockwise; u and v are exchanged "
              "to work on it, and what counts as flipped is what turns the other way\n";
  if(model.number_of_welded_edges > 0)
    result += "note: " + counted(model.number_of_welded_edges, "edge") +
              (model.number_of_welded_edges == 1 ? " was" : " were") + " welded\n";
  if(model.number_of_coinciding_border_edges > 0)
    result += "note: " + counted(model.number_of_coinciding_border_edges, "border edge") +
              (model.number_of_coinciding_border_edges == 1 ? " coincides with others"
                                                            : " coincide") +
              ": is this a mesh that was cut open?" +
              (model.number_of_welded_edges > 0
                 ? " They can't be welded, as it is open which belong together.\n"
                 : " --weld closes it.\n");
  if(model.number_of_split_vertices > 0)
    result += "note: " + counted(model.number_of_split_vertices, "vertex") +
              (model.number_of_split_vertices == 1 ? " was" : " were") +
              " added where the faces around a vertex form several fans\n";
  return result;
}

std::string note_on_features(const bool are_asked_for, const Model& model)
{
  const auto edges = model.mesh.edges();
  return !are_asked_for || std::any_of(edges.begin(), edges.end(),
                                       [&](const Edge e) { return model.is_feature[e]; })
           ? "" : "note: " + model.filename + " marks no edges as features ('l' elements)\n";
}

std::string text_of_model(const Model& model, const std::string& filename)
{
  const std::string format = format_of(filename, model.file.format());
  const Progress progress("writing " + filename);
  const Coordinates_of_file coordinates(model);
  const bool is_of_file = format == model.file.format() && !model.file.text().empty();
  std::string text;
  const SS::IO::File_status status =
    is_of_file ? model.file.rewrite(text, model.mesh, model.uv_map)
               : write_as(format, model, text);
  if(!status)
    throw Failure(UNWRITABLE, filename + ": " + status.message);
  SS::IO::Mesh_text written(std::move(text), format);
  if(!reads_back(model, written, is_of_file))
    throw Failure(UNWRITABLE, filename + ": does not read back as it was written; not written");
  text = std::move(written).text();
  return is_of_file && format == obj ? with_libraries(std::move(text), model.filename, filename)
                                     : text;
}

bool changes_format(const Model& model, const std::string& filename)
{
  return format_of(filename, model.file.format()) != model.file.format();
}

void check_format(const std::string& filename)
{
  format_of(filename, obj);
}

Uv_map copy_of_uv_map(Model& model)
{
  const Uv_map copy = model.mesh.add_property_map<Halfedge, Kernel::Point_2>("h:old_uv").first;
  for(const Halfedge h : model.mesh.halfedges())
    copy[h] = model.uv_map[h];
  return copy;
}

std::string in_words_of_user(const std::string& message, const Model& model)
{
  const auto number_in_file = [&](const std::string& kind, const std::size_t i) {
    const auto& numbers = kind == "face" ? model.file_faces : model.file_vertices;
    return (i < numbers.size() ? numbers[i] : i) + model.first_number;
  };
  std::string result, kind; // the kind of element that the last word was about
  std::istringstream words(with_options(message));
  for(std::string word; words >> word; ) {
    const std::size_t digits = (std::min)(word.find_first_not_of("0123456789"), word.size());
    const std::string rest = word.substr(digits), noun = word.substr(word[0] == '(' ? 1 : 0);
    if(!kind.empty() && digits > 0 && rest.find_first_not_of(",;:.)") == rest.npos)
      word = std::to_string(number_in_file(kind, std::stoul(word))) + rest;
    else if(noun == "vertex" || noun == "vertices" || noun == "face")
      kind = noun;
    else if(!(kind == "vertices" && word == "and")) // as in "vertices 1 and 2"
      kind.clear();
    result += (result.empty() ? "" : " ") + word;
  }
  return result;
}
