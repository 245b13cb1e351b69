#include "Array_surface.h"

#include "Call.h"
#include "maps/map_measures.h"

#include <CGAL/Seamless_snapping/internal/IO/Used_vertices.h>
#include <CGAL/Seamless_snapping/internal/IO/text_and_mesh.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace SS = CGAL::Seamless_snapping;

namespace {

using Soup = SS::internal::Corner_soup<double, double>;
using SS::internal::Used_vertices;

[[noreturn]] void refuse_feature(const Surface_arrays& arrays, const std::size_t i)
{
  throw Refused(SS::Outcome::INVALID_ARGUMENT,
                row_of(i, "features") + ": no triangle has an edge between the vertices " +
                  std::to_string(arrays.features[2 * i]) + " and " +
                  std::to_string(arrays.features[2 * i + 1]) +
                  remedy("take pairs of vertices that follow each other around a triangle"));
}

Soup soup_of(const Surface_arrays& arrays, const Used_vertices& used)
{
  const std::vector<std::size_t>& rows = used.names();
  Soup soup;
  soup.points.resize(rows.size());
  for(std::size_t v = 0; v < rows.size(); ++v)
    if(arrays.points.empty())
      soup.points[v] = {{double(v), 0, 0}};
    else
      std::copy_n(arrays.points.data() + 3 * rows[v], 3, soup.points[v].begin());
  soup.triangles.resize(arrays.number_of_triangles());
  for(std::size_t f = 0; f < soup.triangles.size(); ++f)
    for(std::size_t k = 0; k < 3; ++k) {
      soup.triangles[f].vertices[k] =
        used.number(std::size_t(arrays.triangles[3 * f + k]));
      soup.triangles[f].uvs[k] =
        arrays.uv.empty() ? 0 : SS::internal::Soup_index(3 * f + k);
    }
  soup.uvs.assign(1, {{0, 0}});
  if(!arrays.uv.empty()) {
    soup.uvs.resize(3 * arrays.number_of_triangles());
    std::copy_n(arrays.uv.data(), arrays.uv.size(), soup.uvs.front().data());
  }
  for(std::size_t i = 0; i < arrays.number_of_features(); ++i) {
    SS::internal::Soup_segment segment{};
    for(std::size_t k = 0; k < 2; ++k) {
      const std::int64_t row = arrays.features[2 * i + k];
      segment.vertices[k] = used.number(std::size_t(row));
      if(segment.vertices[k] == Used_vertices::none)
        refuse_feature(arrays, i);
    }
    soup.segments.push_back(segment);
  }
  return soup;
}

} // namespace

Surface_arrays::Surface_arrays(const Integers& t, const std::optional<Doubles>& p,
                               const std::optional<Doubles>& coordinates,
                               const std::optional<Integers>& edges)
  : triangles(copy_of(t)), features(copy_of(edges)), points(copy_of(p)), uv(copy_of(coordinates))
{ }

Array_surface::Array_surface(Surface_arrays&& given, const bool weld)
{
  const Surface_arrays arrays = std::move(given);
  using namespace SS::internal;
  const Used_vertices used({arrays.triangles.begin(), arrays.triangles.end()});
  const std::vector<std::size_t>& rows = used.names();
  Soup soup = soup_of(arrays, used);
  Vertex_changes changes;
  std::optional<Soup_edges<Soup::Triangle> > edges;
  try {
    edges = connect_soup(weld, soup, changes);
  } catch(const File_refusal& refusal) {
    throw Refused(SS::Outcome::NOT_MANIFOLD, refusal.message(), renamed(rows));
  }
  m_number_of_coinciding_border_edges = changes.number_of_coinciding_border_edges;
  for(const std::size_t v : changes.file_vertices)
    m_rows.push_back(rows[v]);
  const std::size_t n = soup.triangles.size();
  mesh.reserve(Mesh::size_type(soup.points.size()), Mesh::size_type(n + n / 2 + n / 8),
               Mesh::size_type(n));
  m_corners = add_triangles(soup, add_vertices(soup.points, changes, mesh, mesh.points()), mesh,
                            uv_map);
  for(std::size_t i = 0; i < soup.segments.size(); ++i) {
    const Side_index side =
      edges->find(soup.segments[i].vertices[0], soup.segments[i].vertices[1]);
    if(side == Soup_edges<Soup::Triangle>::no_side)
      refuse_feature(arrays, i);
    is_feature[mesh.edge(m_corners[side])] = true;
  }
  for(Halfedge& h : m_corners) // from corner k to the next
    h = mesh.prev(h);
}

void Array_surface::add_border()
{
  for(const Edge e : mesh.edges())
    is_feature[e] = is_feature[e] || mesh.is_border(e);
}

void Array_surface::turn_if_mirrored()
{
  if(area_in_domain(mesh, uv_map).first >= 0)
    return;
  m_is_mirrored = true;
  for(const Halfedge h : m_corners)
    uv_map[h] = Kernel::Point_2(uv_map[h].y(), uv_map[h].x());
}

void Array_surface::write_uv(double* uv) const
{
  for(const Halfedge h : m_corners) {
    *uv++ = uv_map[h][m_is_mirrored ? 1 : 0];
    *uv++ = uv_map[h][m_is_mirrored ? 0 : 1];
  }
}

std::vector<std::size_t> renamed(const std::vector<std::size_t>& rows)
{
  for(std::size_t v = 0; v < rows.size(); ++v)
    if(rows[v] != v)
      return rows;
  return {};
}
