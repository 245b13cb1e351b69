#include "Repairs.h"

#include "Failure.h"
#include "Polygon_soup.h"
#include "words.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

using Polygon = std::vector<std::size_t>;

// A surface in the making. Points and faces know the numbers that they have in the file.
struct Surface_soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<Polygon> polygons;
  std::vector<std::size_t> file_points, file_faces;
};

[[noreturn]] void refuse(const Polygon_soup& soup, const std::size_t face, const std::string& why)
{
  const std::size_t line = soup.polygons[face].line;
  throw Failure(UNREADABLE, (line == 0 ? "face " + std::to_string(face + soup.first_number)
                                       : "line " + std::to_string(line)) + ": " + why);
}

// For each point the first one in the same place.
std::vector<std::size_t> first_points(const Polygon_soup& soup)
{
  std::vector<std::size_t> order(soup.points.size()), result(soup.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](const std::size_t i, const std::size_t j) {
    return soup.points[i] < soup.points[j];
  });
  for(std::size_t k = 0; k < order.size(); ++k) {
    const bool is_new = k == 0 || soup.points[order[k]] != soup.points[order[k - 1]];
    result[order[k]] = is_new ? order[k] : result[order[k - 1]];
  }
  return result;
}

// Counts points of no face, and makes those one that lie in one place.
void weld(Polygon_soup& soup, Repairs& repairs)
{
  std::vector<char> is_used(soup.points.size(), false);
  for(const auto& polygon : soup.polygons)
    for(const std::size_t v : polygon.vertices)
      is_used[v] = true;
  const std::vector<std::size_t> first = first_points(soup);
  for(std::size_t i = 0; i < is_used.size(); ++i) {
    repairs.unused_points += is_used[i] ? 0 : 1;
    repairs.welded_points += is_used[i] && first[i] != i ? 1 : 0;
  }
  for(auto& polygon : soup.polygons)
    for(std::size_t& v : polygon.vertices)
      v = first[v];
  for(auto& segment : soup.segments)
    for(std::size_t& v : segment.vertices)
      v = first[v];
}

// From the least vertex on, in the direction of its lesser neighbor: the same for all polygons with
// the same sides.
Polygon canonical(Polygon polygon)
{
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  if(polygon[1] > polygon.back())
    std::reverse(polygon.begin() + 1, polygon.end());
  return polygon;
}

// Without corners that follow on themselves.
Polygon simplified(Polygon polygon)
{
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while(polygon.size() > 1 && polygon.front() == polygon.back())
    polygon.pop_back();
  return polygon;
}

// Faces with three different corners or more, each once.
Surface_soup clean_faces(const Polygon_soup& soup, Repairs& repairs)
{
  Surface_soup result;
  std::set<Polygon> known;
  for(std::size_t f = 0; f < soup.polygons.size(); ++f) {
    Polygon polygon = simplified(soup.polygons[f].vertices);
    const std::size_t corners = std::set<std::size_t>(polygon.begin(), polygon.end()).size();
    if(corners < 3) {
      ++repairs.degenerate_faces;
      continue;
    }
    if(corners < polygon.size())
      refuse(soup, f, "the face meets itself in a corner");
    if(!known.insert(canonical(polygon)).second) {
      ++repairs.duplicate_faces;
      continue;
    }
    result.polygons.push_back(std::move(polygon));
    result.file_faces.push_back(f);
  }
  return result;
}

// Adds the points of the faces, in the order of the file.
void add_points(const Polygon_soup& soup, Surface_soup& surface)
{
  std::vector<std::size_t> new_index(soup.points.size(), 0);
  for(const Polygon& polygon : surface.polygons)
    for(const std::size_t v : polygon)
      new_index[v] = 1;
  for(std::size_t v = 0; v < new_index.size(); ++v)
    if(new_index[v] == 1) {
      new_index[v] = surface.points.size();
      surface.points.emplace_back(soup.points[v][0], soup.points[v][1], soup.points[v][2]);
      surface.file_points.push_back(v);
    }
  for(Polygon& polygon : surface.polygons)
    for(std::size_t& v : polygon)
      v = new_index[v];
}

// The edges at which faces came apart that had shared them.
void count_cut_edges(const Surface_soup& soup, Repairs& repairs)
{
  struct Side
  {
    std::array<std::size_t, 2> in_file, now;
  };
  std::vector<Side> sides;
  for(const Polygon& polygon : soup.polygons)
    for(std::size_t k = 0; k < polygon.size(); ++k) {
      const std::size_t v = polygon[k], w = polygon[(k + 1) % polygon.size()];
      const auto edge = std::minmax(soup.file_points[v], soup.file_points[w]);
      const auto edge_now = std::minmax(v, w);
      sides.push_back({{edge.first, edge.second}, {edge_now.first, edge_now.second}});
    }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.in_file < b.in_file; });
  std::set<std::size_t> ends; // of these edges
  for(std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while(end < sides.size() && sides[end].in_file == sides[i].in_file)
      ++end;
    const bool is_one_sided = end == i + 2 && sides[i].now != sides[i + 1].now;
    repairs.cut_edges += end > i + 2 ? 1 : 0;
    repairs.one_sided_edges += is_one_sided ? 1 : 0;
    if(end > i + 2 || is_one_sided)
      ends.insert(sides[i].in_file.begin(), sides[i].in_file.end());
  }
  std::set<std::size_t> seen; // points of the file
  for(const std::size_t v : soup.file_points)
    if(!seen.insert(v).second && ends.count(v) == 0)
      ++repairs.bowtie_vertices;
}

struct Orientation_visitor : public PMP::Default_orientation_visitor
{
  Orientation_visitor(std::vector<char>& is_turned, std::vector<std::size_t>& file_points)
    : m_is_turned(is_turned), m_file_points(file_points)
  { }

  void polygon_orientation_reversed(const std::size_t polygon)
  { m_is_turned[polygon] = !m_is_turned[polygon]; }

  void duplicated_vertex(const std::size_t vertex, std::size_t)
  { m_file_points.push_back(m_file_points[vertex]); }

private:
  std::vector<char>& m_is_turned;
  std::vector<std::size_t>& m_file_points;
};

// Turns the pieces back of which most faces were turned: the file tells which side is outside.
void turn_back(Mesh& mesh, const std::vector<char>& is_turned, Repairs& repairs)
{
  auto piece = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:piece").first;
  repairs.pieces = PMP::connected_components(mesh, piece);
  std::vector<std::ptrdiff_t> turned(repairs.pieces, 0), faces(repairs.pieces, 0);
  for(const auto f : mesh.faces()) {
    turned[piece[f]] += is_turned[f] ? 1 : 0;
    ++faces[piece[f]];
  }
  std::vector<Mesh::Face_index> back;
  for(const auto f : mesh.faces())
    if(2 * turned[piece[f]] > faces[piece[f]])
      back.push_back(f);
  PMP::reverse_face_orientations(back, mesh);
  for(std::size_t p = 0; p < repairs.pieces; ++p)
    repairs.turned_faces += std::size_t((std::min)(turned[p], faces[p] - turned[p]));
  mesh.remove_property_map(piece);
}

struct Triangulation_visitor : public PMP::Triangulate_faces::Default_visitor<Mesh>
{
  explicit Triangulation_visitor(std::vector<std::size_t>& file_faces) : m_file_faces(&file_faces)
  { }

  void before_subface_creations(const Mesh::Face_index f) { m_of = (*m_file_faces)[f]; }

  void after_subface_created(const Mesh::Face_index f)
  {
    m_file_faces->resize((std::max)(m_file_faces->size(), std::size_t(f) + 1));
    (*m_file_faces)[f] = m_of;
  }

private:
  std::vector<std::size_t>* m_file_faces; // visitors are copied
  std::size_t m_of = 0;
};

void triangulate(const Polygon_soup& soup, Model& model, Repairs& repairs)
{
  for(const auto f : model.mesh.faces())
    repairs.triangulated_faces += model.mesh.degree(f) > 3 ? 1 : 0;
  PMP::triangulate_faces(model.mesh, CGAL::parameters::visitor(
                                       Triangulation_visitor(model.file_faces)));
  for(const auto f : model.mesh.faces())
    if(model.mesh.degree(f) > 3)
      refuse(soup, model.file_faces[f], "the face has more than 3 corners, and no area, so that it "
                                        "can't be triangulated");
}

// All edges between the points of segments, of which there are several where edges were cut.
void mark_segments(const Polygon_soup& soup, Model& model)
{
  const auto edge_in_file = [](const std::size_t v, const std::size_t w) {
    return std::array<std::size_t, 2>{{(std::min)(v, w), (std::max)(v, w)}};
  };
  std::vector<std::pair<std::array<std::size_t, 2>, Edge> > edges;
  for(const Edge e : model.mesh.edges())
    edges.emplace_back(edge_in_file(model.file_vertices[model.mesh.vertex(e, 0)],
                                    model.file_vertices[model.mesh.vertex(e, 1)]), e);
  std::sort(edges.begin(), edges.end());
  for(const auto& segment : soup.segments) {
    const auto sought = edge_in_file(segment.vertices[0], segment.vertices[1]);
    auto it = std::lower_bound(edges.begin(), edges.end(), sought,
                               [](const auto& e, const auto& key) { return e.first < key; });
    if(it == edges.end() || it->first != sought)
      throw Failure(UNREADABLE,
                    (segment.line == 0 ? "" : "line " + std::to_string(segment.line) + ": ") +
                      "line element " + std::to_string(sought[0] + soup.first_number) + " " +
                      std::to_string(sought[1] + soup.first_number) +
                      " is not an edge of the mesh");
    for(; it != edges.end() && it->first == sought; ++it)
      model.is_feature[it->second] = true;
  }
}

std::size_t count_faces_without_area(const Mesh& mesh)
{
  using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto point = [&](const Halfedge h) {
    const Kernel::Point_3& p = mesh.point(mesh.target(h));
    return Exact_kernel::Point_3(p.x(), p.y(), p.z());
  };
  return static_cast<std::size_t>(
    std::count_if(mesh.faces_begin(), mesh.faces_end(), [&](const auto f) {
      const Halfedge h = mesh.halfedge(f);
      return CGAL::collinear(point(h), point(mesh.next(h)), point(mesh.prev(h)));
    }));
}

Repairs build(Polygon_soup& soup, const bool with_features, Model& model)
{
  Repairs repairs;
  repairs.file_points = soup.points.size();
  repairs.file_faces = soup.polygons.size();
  repairs.is_indexed = soup.format != "stl";
  weld(soup, repairs);
  Surface_soup surface = clean_faces(soup, repairs);
  if(surface.polygons.empty())
    throw Failure(UNREADABLE, "no face has three corners in different places, as points coincide");
  add_points(soup, surface);

  std::vector<char> is_turned(surface.polygons.size(), false);
  PMP::orient_polygon_soup(surface.points, surface.polygons,
                           CGAL::parameters::visitor(
                             Orientation_visitor(is_turned, surface.file_points)));
  count_cut_edges(surface, repairs);
  if(!PMP::is_polygon_soup_a_polygon_mesh(surface.polygons))
    throw Failure(UNREADABLE, "the faces are no surface, even when cut apart");
  PMP::polygon_soup_to_polygon_mesh(surface.points, surface.polygons, model.mesh);
  model.file_vertices = surface.file_points;
  model.file_faces = surface.file_faces;
  model.first_number = soup.first_number;
  turn_back(model.mesh, is_turned, repairs);
  triangulate(soup, model, repairs);
  repairs.vertices = model.mesh.number_of_vertices();
  repairs.faces = model.mesh.number_of_faces();
  repairs.faces_without_area = count_faces_without_area(model.mesh);
  if(repairs.faces_without_area == repairs.faces)
    throw Failure(UNREADABLE, "the faces have no area: the corners of each lie on a line");
  if(with_features)
    mark_segments(soup, model);
  return repairs;
}

} // namespace

void Plain_reading_options::add_to(Options& options)
{
  options.add("features", features, "take the edges of 'l' elements for features");
  options.add("strict", strict, "refuse a mesh that has to be repaired or triangulated on reading");
}

std::string Repairs::in_words() const
{
  std::string result;
  const auto add = [&](const std::size_t n, const std::string& what, const std::string& done) {
    if(n > 0)
      result += (result.empty() ? "" : ", ") + counted(n, what) + (n == 1 ? " was " : " were ") +
                done;
  };
  if(is_indexed)
    add(welded_points, "point", "welded to others in the same place");
  add(degenerate_faces, "face", "removed that had less than three different corners");
  add(duplicate_faces, "face", "removed that had the corners of others");
  add(cut_edges, "edge", "cut that three faces or more had shared");
  add(one_sided_edges, "edge", "cut as the surface had one side only");
  add(bowtie_vertices, "vertex", "added where faces had met in a point only");
  add(turned_faces, "face", "turned round to fit the others");
  add(triangulated_faces, "face", "triangulated");
  return result;
}

Repairs read_plain_model(const std::string& filename, const Plain_reading_options& options,
                         Model& model)
{
  model.filename = filename;
  Polygon_soup soup = read_polygon_soup(filename);
  Repairs repairs;
  try {
    repairs = build(soup, options.features, model);
  } catch(const Failure& failure) {
    throw Failure(failure.status, filename + ": " + failure.what());
  }
  if(options.strict && !repairs.in_words().empty())
    throw Failure(UNREADABLE, filename + ": refused by --strict, as reading repairs it: " +
                                repairs.in_words());
  return repairs;
}

void write_repairs(std::ostream& os, const std::string& filename, const Repairs& repairs)
{
  os << filename << ": " << counted(repairs.file_faces, "face") << ", "
     << counted(repairs.file_points, "point");
  const std::string words = repairs.in_words();
  if(!words.empty())
    os << "\nrepaired: " << words;
  if(!repairs.is_indexed)
    os << "\nwelded: " << counted(repairs.welded_points, "point")
       << ", as the format has one for each corner";
  os << "\nread: " << counted(repairs.faces, "triangle") << ", "
     << counted(repairs.vertices, "vertex") << ", " << counted(repairs.pieces, "piece") << "\n";
  if(repairs.faces_without_area > 0)
    os << "note: among them without area: " << counted(repairs.faces_without_area, "triangle")
       << "\n";
}

nlohmann::json json_of(const Repairs& r)
{
  return {{"file", {{"faces", r.file_faces}, {"points", r.file_points}}},
          {"repairs", {{"welded_points", r.welded_points},
                       {"removed_degenerate_faces", r.degenerate_faces},
                       {"removed_duplicate_faces", r.duplicate_faces},
                       {"unused_points", r.unused_points},
                       {"cut_edges", r.cut_edges},
                       {"cut_one_sided_edges", r.one_sided_edges},
                       {"added_bowtie_vertices", r.bowtie_vertices},
                       {"turned_faces", r.turned_faces},
                       {"triangulated_faces", r.triangulated_faces}}},
          {"repaired", r.in_words()},
          {"mesh", {{"faces", r.faces}, {"vertices", r.vertices}, {"pieces", r.pieces},
                    {"faces_without_area", r.faces_without_area}}}};
}
