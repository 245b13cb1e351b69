#include "attributes.h"

#include "Failure.h"
#include "files.h"
#include "plain_meshes.h"
#include "words.h"

#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <locale>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <type_traits>

namespace {

using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using formats::Mesh_text;

// The corners of a face, in the order of the coordinates of a location.
std::array<Halfedge, 3> corners(const Mesh& mesh, const Face f)
{
  const Halfedge h = mesh.halfedge(f);
  return {{mesh.prev(h), h, mesh.next(h)}};
}

std::size_t file_face(const Model& model, const Face f)
{
  const std::size_t i = f;
  return i < model.file_faces.size() ? model.file_faces[i] : i;
}

// Calls `visit` with the vertices in the file and the weights of a location.
template <typename Visit>
void for_each_corner(const Model& model, const Location& location, const Visit& visit)
{
  const auto around = corners(model.mesh, location.first);
  for(std::size_t i = 0; i < 3; ++i)
    visit(model.file_vertices[model.mesh.target(around[i])], location.second[i]);
}

// --- PLY -----------------------------------------------------------------------------------------

// Each name of a property with its element before it.
std::vector<std::string> properties(std::istream& file)
{
  std::vector<std::string> result;
  std::string element;
  for(std::string line; std::getline(file, line) && line.find("end_header") != 0; ) {
    std::istringstream words(line);
    std::string word, name;
    words >> word;
    for(std::string next; words >> next; name = next)
      if(word == "element" && name.empty())
        element = next;
    if(word == "property")
      result.push_back(element + " " + (name == "vertex_index" ? "vertex_indices" : name));
  }
  return result;
}

// Whether it is not the standard input, and has this suffix.
bool is_file_of_format(const std::string& filename, const std::string& suffix)
{ return !is_special_file(filename) && suffix_of(filename) == suffix; }

// Those of the file that the text of another one lacks: lists, which CGAL does not read, normals,
// and parts of colors.
std::string missing_properties(const std::string& filename, const std::string& text)
{
  std::ifstream file(filename, std::ios::binary);
  std::istringstream other(text);
  const std::vector<std::string> kept = properties(other);
  std::string result;
  for(const std::string& name : properties(file))
    if(std::find(kept.begin(), kept.end(), name) == kept.end())
      result += (result.empty() ? "'" : ", '") + name + "'";
  return result;
}

// As for_each_corner(), with vertices of the file: of those in one place, which repairs may have
// joined, the vertex of the face.
template <typename Visit>
void for_each_corner_in_file(const Model& model, const Mesh& file, const Location& location,
                             const Visit& visit)
{
  const Face face(Mesh::size_type(file_face(model, location.first)));
  for_each_corner(model, location, [&](const std::size_t first, const double weight) {
    Vertex vertex{Mesh::size_type(first)};
    const Kernel::Point_3 p = file.point(vertex);
    for(const Vertex v : file.vertices_around_face(file.halfedge(face)))
      if(file.point(v) == p)
        vertex = v;
    visit(vertex, weight);
  });
}

// \param is_rounded whether integers are, as those of colors; others are of the nearest vertex
template <typename T>
T interpolated(const Model& model, const Mesh& file, const Mesh::Property_map<Vertex, T>& values,
               const Location& location, const bool is_rounded)
{
  double sum = 0, largest = -1;
  T nearest{};
  for_each_corner_in_file(model, file, location, [&](const Vertex v, const double weight) {
    const T value = values[v];
    if(weight > largest) {
      largest = weight;
      nearest = value;
    }
    sum += weight * double(value);
  });
  if(!std::is_integral_v<T>)
    return T(sum);
  return is_rounded ? T(std::lround(sum)) : nearest;
}

template <typename T>
void carry_over(const Model& model, const Mesh& file, Located_quads& quads)
{
  for(const std::string& name : file.properties<Vertex>())
    if(const auto [values, exists] = file.property_map<Vertex, T>(name); exists) {
      const auto map = quads.mesh.add_property_map<Vertex, T>(name).first;
      for(const Vertex v : quads.mesh.vertices())
        map[v] = interpolated(model, file, values, quads.of_vertex[v], name == "v:alpha");
    }
  for(const std::string& name : file.properties<Face>())
    if(const auto [values, exists] = file.property_map<Face, T>(name); exists) {
      const auto map = quads.mesh.add_property_map<Face, T>(name).first;
      for(const Face f : quads.mesh.faces())
        map[f] = values[Face(Mesh::size_type(file_face(model, quads.of_face[f].first)))];
    }
}

// Where several vertices are in one place, as programs double them at seams of a texture, they may
// differ in properties. Quads have one vertex there.
template <typename... Types>
std::set<std::string> properties_with_seams(const Mesh& file)
{
  std::map<Kernel::Point_3, Vertex> first_in_place;
  std::set<std::string> result;
  for(const Vertex v : file.vertices())
    if(const auto [it, is_first] = first_in_place.emplace(file.point(v), v); !is_first)
      for(const std::string& name : file.properties<Vertex>()) {
        const auto differs = [&](const auto& found)
          { return found.second && found.first[v] != found.first[it->second]; };
        if((differs(file.property_map<Vertex, Types>(name)) || ...))
          result.insert(name.substr(2)); // without "v:"
      }
  return result;
}

// As three numbers: CGAL reads them into one property, and would write that with an opacity.
// \param color_of a vertex or face: three numbers
template <typename Key, typename Keys, typename Color_of>
void add_colors(const std::string& prefix, const Keys& keys, const Color_of& color_of, Mesh& quads)
{
  constexpr const char* names[] = {"red", "green", "blue"};
  for(std::size_t c = 0; c < 3; ++c) {
    const auto map = quads.add_property_map<Key, std::uint8_t>(prefix + names[c]).first;
    for(const Key k : keys)
      map[k] = std::uint8_t(std::lround(color_of(k)[c]));
  }
}

void carry_over_colors(const Model& model, const Mesh& file, Located_quads& quads)
{
  using CGAL::IO::Color;
  if(const auto found = file.property_map<Vertex, Color>("v:color"); found.second)
    add_colors<Vertex>("v:", quads.mesh.vertices(), [&](const Vertex v) {
      std::array<double, 3> sum{};
      for_each_corner_in_file(model, file, quads.of_vertex[v],
                              [&](const Vertex w, const double weight) {
        for(std::size_t c = 0; c < 3; ++c)
          sum[c] += weight * found.first[w][c];
      });
      return sum;
    }, quads.mesh);
  if(const auto found = file.property_map<Face, Color>("f:color"); found.second)
    add_colors<Face>("f:", quads.mesh.faces(), [&](const Face f) {
      return found.first[Face(Mesh::size_type(file_face(model, quads.of_face[f].first)))];
    }, quads.mesh);
}

template <typename... Types>
void carry_over_all(const Model& model, const Mesh& file, Located_quads& quads)
{ (carry_over<Types>(model, file, quads), ...); }

// --- OBJ -----------------------------------------------------------------------------------------

struct OBJ_attributes
{
  using Values = std::array<double, 3>;
  using Part = std::array<std::string, 3>; // the lines of an object, a group, and a material

  std::vector<Values> points, colors;         // per vertex
  std::vector<std::optional<std::array<double, 2> > > coordinates; // the 'vt' elements
  std::vector<std::vector<std::array<std::size_t, 2> > > corners; // vertex and 'vt' from 1; 0: none
  std::vector<Part> parts;          // what faces belong to
  std::vector<std::size_t> part_of; // per face
  std::string libraries;            // of materials
  bool has_coordinates = false;
  std::set<std::string> lost; // what is not carried over

  explicit OBJ_attributes(const Mesh_text& file) : parts(1)
  {
    file.for_each_statement([&](const std::vector<std::string>& words)
                            { add(words[0], {words.begin() + 1, words.end()}); });
    if(!colors.empty() && colors.size() != points.size()) {
      colors.clear();
      lost.insert("colors, which not all vertices have");
    }
    for(std::size_t f = 0; f < corners.size(); ++f)
      for(const auto& [v, vt] : corners[f])
        if(vt > coordinates.size()) {
          lost.insert("coordinates that are no 'vt' element, as of face " + std::to_string(f + 1));
          return;
        }
  }

  bool holds_more_than_a_mesh() const
  {
    return has_coordinates || !colors.empty() || !libraries.empty() || !lost.empty() ||
           parts.size() > 1;
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)(); // no such element

  // Nothing where it is no finite number.
  static std::optional<double> finite_number(const std::string& token)
  {
    std::istringstream stream(token);
    stream.imbue(std::locale::classic());
    double x = 0;
    return stream >> x && std::isfinite(x) ? std::optional<double>(x) : std::nullopt;
  }

  static double number(const std::string& token) { return finite_number(token).value_or(0); }

  void add(const std::string& name, const std::vector<std::string>& tokens)
  {
    if(name == "v" && tokens.size() >= 3) {
      points.push_back({number(tokens[0]), number(tokens[1]), number(tokens[2])});
      if(tokens.size() >= 6)
        colors.push_back({number(tokens[3]), number(tokens[4]), number(tokens[5])});
      if(tokens.size() > 6)
        lost.insert("numbers after the colors of vertices, such as opacities");
    } else if(name == "vn") {
      lost.insert("normals");
    } else if(name == "s" && !tokens.empty() && tokens[0] != "off" && tokens[0] != "0") {
      lost.insert("smoothing groups");
    } else if(name == "vt" && !tokens.empty()) {
      add_coordinates(tokens);
    } else if(name == "mtllib") {
      libraries += line(name, tokens);
    } else if(name == "o" || name == "g" || name == "usemtl") {
      m_lines[name] = line(name, tokens);
      m_part = 0;
    } else if(name == "f") {
      add_face(tokens);
    }
  }

  void add_coordinates(const std::vector<std::string>& tokens)
  {
    const std::optional<double> u = finite_number(tokens[0]);
    const std::optional<double> v = tokens.size() > 1 ? finite_number(tokens[1]) : 0;
    coordinates.emplace_back();
    if(u && v)
      coordinates.back() = {*u, *v};
    else
      lost.insert("'vt' elements without numbers, such as number " +
                  std::to_string(coordinates.size()));
    if(tokens.size() > 2 && number(tokens[2]) != 0)
      lost.insert("third numbers of 'vt' elements");
  }

  static std::string line(const std::string& name, const std::vector<std::string>& tokens)
  {
    std::string result = name;
    for(const std::string& token : tokens)
      result += " " + token;
    return result + "\n";
  }

  void add_face(const std::vector<std::string>& tokens)
  {
    if(m_part == 0) {
      const Part part{m_lines["o"], m_lines["g"], m_lines["usemtl"]};
      const auto it = m_numbers.emplace(part, parts.size()).first;
      if(it->second == parts.size())
        parts.push_back(part);
      m_part = it->second;
    }
    part_of.push_back(m_part);
    corners.emplace_back();
    for(const std::string& token : tokens) {
      const std::size_t slash = token.find('/');
      const std::string rest = slash == token.npos ? "" : token.substr(slash + 1);
      std::size_t vt = index(rest, coordinates.size());
      if(vt == 0 && !rest.empty() && rest[0] != '/')
        vt = none;
      corners.back().push_back({index(token, points.size()), vt});
      has_coordinates = has_coordinates || vt > 0;
    }
  }

  // From 1; 0 if there is none.
  static std::size_t index(const std::string& token, const std::size_t size)
  {
    const long i = std::strtol(token.c_str(), nullptr, 10);
    return i < 0 ? size + 1 - std::size_t(-i) : std::size_t(i);
  }

  std::map<std::string, std::string> m_lines; // in force
  std::map<Part, std::size_t> m_numbers;
  std::size_t m_part = 0; // 0: to be looked up
};

// Texture coordinates of the model's corners. A seam is an edge whose faces don't agree on them; one
// chart can be on both of its sides.
class Texture
{
public:
  using Coordinates = std::array<double, 2>;

  Texture(const Model& model, const OBJ_attributes& file)
    : m_model(model), m_coordinates(model.mesh.num_halfedges())
  {
    for(const Face f : mesh().faces())
      for(const Halfedge h : corners(mesh(), f))
        m_coordinates[h] = find(file, f, h);
  }

  // At a vertex of a quad, as seen from the middle of the quad without crossing a seam: in the face
  // where the vertex is, or in that which is nearest to it.
  std::optional<Coordinates> at(const Kernel::Point_3& point, const Location& vertex,
                                const Location& middle) const
  {
    if(!has_coordinates(middle.first))
      return std::nullopt;
    const Face face = face_before_seam(point, vertex.first, middle);
    const auto around = corners(mesh(), face);
    const auto weights = this->weights(point, face);
    Coordinates result{};
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t c = 0; c < 2; ++c)
        result[c] += weights[i] * (*m_coordinates[around[i]])[c];
    return result;
  }

private:
  const Mesh& mesh() const { return m_model.mesh; }

  bool has_coordinates(const Face f) const
  {
    const auto around = corners(mesh(), f);
    return std::all_of(around.begin(), around.end(),
                       [&](const Halfedge h) { return m_coordinates[h].has_value(); });
  }

  bool is_seam(const Halfedge h) const
  {
    const Halfedge o = mesh().opposite(h);
    return mesh().is_border(o) || m_coordinates[h] != m_coordinates[mesh().prev(o)] ||
           m_coordinates[o] != m_coordinates[mesh().prev(h)];
  }

  Kernel::Triangle_3 triangle(const Face f) const
  {
    const auto around = corners(mesh(), f);
    const auto point = [&](const std::size_t i) { return mesh().point(mesh().target(around[i])); };
    return Kernel::Triangle_3(point(0), point(1), point(2));
  }

  Kernel::Point_3 point(const Location& location) const
  {
    const Kernel::Triangle_3 t = triangle(location.first);
    const auto& weights = location.second;
    return CGAL::barycenter(t[0], weights[0], t[1], weights[1], t[2], weights[2]);
  }

  // Looks no further from the middle than a bit beyond the point.
  Face face_before_seam(const Kernel::Point_3& p, const Face wanted, const Location& middle) const
  {
    constexpr double reach = 1.5;
    const Kernel::Point_3 m = point(middle);
    const double most = reach * reach * CGAL::squared_distance(p, m);
    std::vector<Face> faces(1, middle.first);
    std::set<Face> known{middle.first};
    Face result = middle.first;
    double least = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < faces.size(); ++i) {
      const Face f = faces[i];
      if(f == wanted)
        return f;
      if(const double d = CGAL::squared_distance(p, triangle(f)); d < least) {
        least = d;
        result = f;
      }
      for(const Halfedge h : corners(mesh(), f))
        if(const Face g = mesh().face(mesh().opposite(h)); !is_seam(h) && known.insert(g).second &&
           has_coordinates(g) && CGAL::squared_distance(m, triangle(g)) <= most)
          faces.push_back(g);
    }
    return result;
  }

  // Vertices may have been joined with others in the same place.
  std::optional<Coordinates> find(const OBJ_attributes& file, const Face f, const Halfedge h) const
  {
    const std::size_t v = m_model.file_vertices[mesh().target(h)];
    for(const auto& [w, vt] : file.corners[file_face(m_model, f)])
      if(vt > 0 && vt <= file.coordinates.size() &&
         (w == v + 1 || file.points[w - 1] == file.points[v]))
        return file.coordinates[vt - 1];
    return std::nullopt;
  }

  // Barycentric coordinates in the plane of a face, also outside of it.
  std::array<double, 3> weights(const Kernel::Point_3& p, const Face f) const
  {
    const auto around = corners(mesh(), f);
    std::array<Kernel::Point_3, 3> q;
    for(std::size_t i = 0; i < 3; ++i)
      q[i] = mesh().point(mesh().target(around[i]));
    const Kernel::Vector_3 normal = CGAL::cross_product(q[1] - q[0], q[2] - q[0]);
    const double area = normal.squared_length();
    if(!(area > 0))
      return {{1, 0, 0}};
    std::array<double, 3> result;
    for(std::size_t i = 0; i < 3; ++i)
      result[i] = CGAL::cross_product(q[(i + 1) % 3] - p, q[(i + 2) % 3] - p) * normal / area;
    return result;
  }

  const Model& m_model;
  std::vector<std::optional<Coordinates> > m_coordinates; // per halfedge
};

void write_vertices(const Model& model, const OBJ_attributes& file, const Located_quads& quads,
                    std::ostream& os)
{
  for(const Vertex v : quads.mesh.vertices()) {
    const Kernel::Point_3& p = quads.mesh.point(v);
    os << "v " << p.x() << " " << p.y() << " " << p.z();
    if(!file.colors.empty()) {
      std::array<double, 3> color{};
      for_each_corner(model, quads.of_vertex[v], [&](const std::size_t w, const double weight) {
        for(std::size_t c = 0; c < 3; ++c)
          color[c] += weight * file.colors[w][c];
      });
      os << " " << color[0] << " " << color[1] << " " << color[2];
    }
    os << "\n";
  }
}

// By their parts: an object that is named again would be another one for programs that read it.
std::vector<Face> ordered_faces(const std::vector<std::size_t>& parts, const Mesh& quads)
{
  std::vector<Face> result(quads.faces().begin(), quads.faces().end());
  std::stable_sort(result.begin(), result.end(), [&](const Face f, const Face g)
                   { return parts[std::size_t(f)] < parts[std::size_t(g)]; });
  return result;
}

std::string OBJ_text(const Model& model, const std::string& input, Located_quads& quads,
                     const std::string& filename)
{
  const OBJ_attributes file(Mesh_text(read_file(input), "obj"));
  for(const std::string& lost : file.lost)
    std::cerr << "note: not carried over: " << lost << std::endl;
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os.precision(17);
  os << with_libraries(file.libraries, input, filename);
  write_vertices(model, file, quads, os);
  std::map<Vertex, std::size_t> numbers;
  for(const Vertex v : quads.mesh.vertices())
    numbers.emplace(v, numbers.size() + 1);
  std::optional<Texture> texture;
  if(file.has_coordinates)
    texture.emplace(model, file);
  std::map<Texture::Coordinates, std::size_t> known;
  std::vector<std::size_t> parts(quads.mesh.num_faces());
  for(const Face f : quads.mesh.faces())
    parts[std::size_t(f)] = file.part_of[file_face(model, quads.of_face[f].first)];
  quads.written = ordered_faces(parts, quads.mesh);
  std::size_t part = 0;
  for(const Face f : quads.written) {
    const Location& middle = quads.of_face[f];
    for(std::size_t i = 0; i < 3; ++i)
      if(const std::string& line = file.parts[parts[std::size_t(f)]][i]; line != file.parts[part][i])
        os << line;
    part = parts[std::size_t(f)];
    std::string face = "f";
    for(const Vertex v : quads.mesh.vertices_around_face(quads.mesh.halfedge(f))) {
      face += " " + std::to_string(numbers[v]);
      if(const auto uv = texture ? texture->at(quads.mesh.point(v), quads.of_vertex[v], middle)
                                 : std::nullopt) {
        const auto [it, is_new] = known.emplace(*uv, known.size() + 1);
        if(is_new)
          os << "vt " << (*uv)[0] << " " << (*uv)[1] << "\n";
        face += "/" + std::to_string(it->second);
      }
    }
    os << face << "\n";
  }
  os << lines_of_features(quads.mesh, quads.is_feature);
  return os.str();
}

// Whether a .obj or .ply file holds what could be carried over to a file of its format.
bool holds_more_than_a_mesh(const std::string& filename)
{
  static const std::string mesh_alone =
    "ply\nformat ascii 1.0\nelement vertex 0\nproperty double x\nproperty double y\n"
    "property double z\nelement face 0\nproperty list uchar int vertex_indices\n"
    "property list uchar int vertex_index\nend_header\n";
  if(suffix_of(filename) == "ply")
    return !missing_properties(filename, mesh_alone).empty();
  return suffix_of(filename) == "obj" &&
         OBJ_attributes(Mesh_text(read_file(filename), "obj")).holds_more_than_a_mesh();
}

} // namespace

bool read_PLY_mesh(const std::string& text, Mesh& mesh)
{
  std::istringstream stream(text);
  std::string comments;
  return CGAL::IO::read_PLY(stream, mesh, comments, false);
}

std::string text_with_attributes(const Model& model, const std::string& input, Located_quads& quads,
                                 const std::string& filename)
{
  const std::string format = is_special_file(filename) ? "obj" : suffix_of(filename);
  if(format == "obj" && is_file_of_format(input, "obj"))
    return OBJ_text(model, input, quads, filename);
  if(!is_special_file(input) && format != suffix_of(input) && holds_more_than_a_mesh(input))
    std::cerr << "note: only the mesh of " << input << " is in " << filename
              << ", which is of another format" << std::endl;
  if(is_special_file(input))
    std::cerr << "note: only the mesh of the standard input is read; to carry over its attributes, "
                 "name a file" << std::endl;
  Mesh file;
  const bool has_properties = format == "ply" && is_file_of_format(input, "ply");
  if(has_properties && !read_PLY_mesh(read_file(input), file)) {
    std::cerr << "note: " << input << " is no mesh before repairs: its attributes are not carried "
              << "over" << std::endl;
  } else if(has_properties) {
    carry_over_all<std::int8_t, std::int16_t, std::uint16_t, std::int32_t, std::uint32_t, float,
                   double>(model, file, quads);
    for(const std::string& name : properties_with_seams<float, double>(file))
      std::cerr << "note: '" << name << "' differs between vertices of " << input << " in the same "
                << "place, as at seams of a texture: the quads there are not cut; .obj files have "
                << "coordinates of each corner" << std::endl;
    carry_over_colors(model, file, quads);
    carry_over<std::uint8_t>(model, file, quads); // as an opacity, which goes with colors
  }
  const std::string text = text_of_quads(quads.mesh, quads.is_feature, filename);
  if(has_properties)
    if(const std::string missing = missing_properties(input, text); !missing.empty())
      std::cerr << "note: not carried over: " << missing << std::endl;
  return text;
}

namespace {

template <typename T>
bool read_property(const Mesh& file, const std::string& name, std::vector<double>& values)
{
  const auto [map, exists] = file.property_map<Vertex, T>("v:" + name);
  if(exists)
    for(const Vertex v : file.vertices())
      values.push_back(double(map[v]));
  return exists;
}

template <typename... Types>
bool read_property_of_any(const Mesh& file, const std::string& name, std::vector<double>& values)
{ return (read_property<Types>(file, name, values) || ...); }

} // namespace

Mesh::Property_map<Vertex, double>
read_sizes(const std::string& property_or_file, const std::string& input, const Repairs& repairs,
           Model& model)
{
  const auto sizes = model.mesh.add_property_map<Vertex, double>("v:size", 1).first;
  if(property_or_file.empty())
    return sizes;
  Mesh file;
  std::vector<double> values;
  const bool is_property =
    is_file_of_format(input, "ply") && read_PLY_mesh(read_file(input), file) &&
    read_property_of_any<float, double, std::int8_t, std::uint8_t, std::int16_t, std::uint16_t,
                         std::int32_t, std::uint32_t>(file, property_or_file, values);
  if(!is_property) {
    if(suffix_of(input) == "ply" && !std::filesystem::exists(property_or_file))
      throw Failure(UNREADABLE, "'" + property_or_file + "' is neither a number at each vertex of " +
                                  input + " nor a file");
    values = read_numbers(property_or_file);
    if(values.size() != repairs.file_points)
      throw Failure(UNREADABLE, property_or_file + ": the file has " +
                                  counted(values.size(), "number") + ", not one for each of " +
                                  counted(repairs.file_points, "vertex") + " of the mesh" +
                                  (values.size() == repairs.file_faces
                                     ? "; sizes belong to vertices, not to faces" : ""));
  }
  for(const double& x : values)
    if(!(x > 0) || std::isinf(x))
      throw Failure(UNREADABLE, property_or_file + ": number " +
                                  std::to_string(&x - values.data() + 1) + " of the " +
                                  (is_property ? "property" : "file") +
                                  " is not positive and finite");
  for(const Vertex v : model.mesh.vertices())
    sizes[v] = values[model.file_vertices[v]];
  return sizes;
}
