#include "Surface_soup.h"

#include "Failure.h"

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

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
  explicit Orientation_visitor(Surface_soup& soup) : m_soup(soup) { }

  void polygon_orientation_reversed(const std::size_t polygon)
  { m_soup.is_turned[polygon] = !m_soup.is_turned[polygon]; }

  void duplicated_vertex(const std::size_t vertex, std::size_t)
  {
    const std::size_t number = m_soup.file_points[vertex];
    m_soup.file_points.push_back(number);
  }

private:
  Surface_soup& m_soup;
};

} // namespace

void refuse(const Polygon_soup& soup, const std::size_t face, const std::string& why)
{
  const std::size_t line = soup.polygons[face].line;
  throw Failure(UNREADABLE, (line == 0 ? "face " + std::to_string(face + soup.first_number)
                                       : "line " + std::to_string(line)) + ": " + why);
}

Surface_soup make_surface(Polygon_soup& soup, Repairs& repairs)
{
  weld(soup, repairs);
  Surface_soup surface = clean_faces(soup, repairs);
  if(surface.polygons.empty())
    throw Failure(UNREADABLE, "no face has three corners in different places, as points coincide");
  add_points(soup, surface);
  surface.is_turned.assign(surface.polygons.size(), false);
  PMP::orient_polygon_soup(surface.points, surface.polygons,
                           CGAL::parameters::visitor(Orientation_visitor(surface)));
  count_cut_edges(surface, repairs);
  if(!PMP::is_polygon_soup_a_polygon_mesh(surface.polygons))
    throw Failure(UNREADABLE, "the faces are no surface, even when cut apart");
  return surface;
}
