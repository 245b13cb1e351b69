#include "Model.h"

#include "Failure.h"
#include "Progress.h"
#include "attributes.h"
#include "files.h"
#include "words.h"
#include "maps/map_measures.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/IO/PLY.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

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
using formats::Mesh_text;

namespace {

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
  return model.file.read<UVNumber>(model.mesh, model.uv_map, model.is_feature, weld);
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
  if(!read_PLY_mesh(text, mesh))
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
  if(!status)
    throw Failure(UNREADABLE, model.filename + ": " + in_words_of_user(status.message));
  model.is_mirrored = area_in_domain(model.mesh, model.uv_map).first < 0;
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
bool reads_back(const Model& model, const Mesh_text& text, const bool is_of_file)
{
  const formats::Vertex_numbers as_in_mesh;
  const formats::Vertex_numbers& numbers = is_of_file ? model.file_vertices : as_in_mesh;
  return text.holds(model.mesh, model.uv_map, model.is_feature, numbers) &&
         (!model.is_float || text.holds<float>(model.mesh, model.uv_map, model.is_feature, numbers));
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
  model.file = corners ? Mesh_text(*corners, obj)
                       : Mesh_text(text, is_special_file(filename) ? "" : suffix_of(filename));
  parse(options, model);
}

void read_again(const Model& other, const Reading_options& options, Model& model)
{
  model.filename = other.filename;
  model.first_number = other.first_number;
  model.file = Mesh_text(other.file.text(), other.file.format());
  parse(options, model);
}

std::string notes_on_reading(const Model& model)
{
  std::string result;
  if(has_coordinates_at_vertices(model))
    result += "note: all corners at a vertex have the coordinates of the vertex; the output has "
              "coordinates of corners\n";
  if(model.is_mirrored)
    result += "note: the map is mirrored, because most of its faces turn clockwise; u and v are "
              "exchanged to work on it, and faces that turn counterclockwise count as flipped\n";
  if(model.number_of_welded_edges > 0)
    result += "note: " + counted(model.number_of_welded_edges, "edge") +
              (model.number_of_welded_edges == 1 ? " was" : " were") + " welded\n";
  if(model.number_of_coinciding_border_edges > 0)
    result += "note: " + counted(model.number_of_coinciding_border_edges, "border edge") +
              (model.number_of_coinciding_border_edges == 1 ? " coincides with others"
                                                            : " coincide") +
              ": is this a mesh that was cut open?" +
              (model.number_of_welded_edges > 0
                 ? " They can't be welded, because several pairs of them fit.\n"
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
    throw Failure(UNWRITABLE, filename + ": " + in_words_of_user(status.message));
  Mesh_text written(std::move(text), format);
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

std::string in_words_of_user(const Message& message, const Model& model)
{
  return message.str(words_of_program, [&](const Message::Part& part) {
    const auto& numbers = part.kind == Message::FACE ? model.file_faces : model.file_vertices;
    return part.kind == Message::ELEMENT ? part.index :
      (part.index < numbers.size() ? numbers[part.index] : part.index) + model.first_number;
  });
}
