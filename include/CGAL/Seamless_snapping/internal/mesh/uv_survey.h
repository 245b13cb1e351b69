// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_UV_SURVEY_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_UV_SURVEY_H

#include <CGAL/license/Seamless_snapping.h>

// The one pass over all edges of a mesh: finds the open edges, those whose two sides are not the
// same to the bit, and checks on the way that faces are triangles and coordinates are finite. What
// follows looks at open edges only.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/mesh/Mismatched_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/check_uv_map.h>
#include <CGAL/Seamless_snapping/internal/support/prefetch.h>
#include <CGAL/Seamless_snapping/internal/transitions/Edge_vectors.h>

#include <CGAL/boost/graph/helpers.h>
#include <boost/container/static_vector.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The number type of a uv map's points.
template <typename HalfedgeUVMap>
struct Uv_number
{
  using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;
  using type = std::decay_t<decltype(std::declval<const Point&>().x())>;
  static_assert(std::is_same<type, double>::value || std::is_same<type, float>::value,
                "the coordinates of the uv map must be of type float or double");
};

template <typename HalfedgeUVMap, typename Halfedge>
Uv get_uv(const HalfedgeUVMap& uv_map, const Halfedge h)
{
  if constexpr(check_map_of_corners<HalfedgeUVMap, Halfedge>()) {
    const auto& p = get(uv_map, h);
    return {static_cast<double>(p.x()), static_cast<double>(p.y())};
  }
}

template <typename Point>
bool are_equal(const Point& p, const Point& q)
{
  return (int(p.x() == q.x()) & int(p.y() == q.y())) != 0; // without branches
}

// Meshes may have edges without.
template <typename TriangleMesh, typename Halfedge>
bool has_face(const Halfedge h, const TriangleMesh& tmesh)
{
  return !is_border(h, tmesh) || !is_border(opposite(h, tmesh), tmesh);
}

// \pre both sides of `h` have a face
template <typename TriangleMesh, typename HalfedgeUVMap, typename Halfedge>
Edge_sides edge_sides(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map, const Halfedge h)
{
  const Halfedge g = opposite(h, tmesh);
  return {get_uv(uv_map, prev(h, tmesh)), get_uv(uv_map, h),
          get_uv(uv_map, g), get_uv(uv_map, prev(g, tmesh))};
}

template <typename TriangleMesh>
struct Uv_survey
{
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  std::vector<Surveyed_edge<Halfedge> > mismatched_edges;
  double extent = 0;                    // the larger side of the bounding box of the coordinates
  std::optional<Refusal> refusal;
};

// Beyond this, differences of coordinates and their squares may overflow.
constexpr double largest_coordinate = 1e300;

inline bool is_finite(const Uv& u) { return std::isfinite(u[0]) && std::isfinite(u[1]); }

inline bool is_in_range(const Uv& u)
{
  return std::abs(u[0]) <= largest_coordinate && std::abs(u[1]) <= largest_coordinate;
}

// The bounding box of coordinates. Ignores NaN.
class Uv_box
{
public:
  void add(const Uv& u)
  {
    for(std::size_t c = 0; c < 2; ++c) { // without branches
      m_low[c] = u[c] < m_low[c] ? u[c] : m_low[c];
      m_high[c] = u[c] > m_high[c] ? u[c] : m_high[c];
    }
  }

  bool is_empty() const { return m_low[0] > m_high[0]; }
  bool is_in_range() const
  { return is_empty() || (internal::is_in_range(m_low) && internal::is_in_range(m_high)); }

  double extent() const
  { return is_empty() ? 0 : (std::max)(m_high[0] - m_low[0], m_high[1] - m_low[1]); }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Uv m_low{{infinity, infinity}};
  Uv m_high{{-infinity, -infinity}};
};

// On failure only: names the place, if there is one.
template <typename TriangleMesh, typename HalfedgeUVMap, typename VertexIndexMap>
std::optional<Refusal> find_bad_face(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                                     const VertexIndexMap& vertex_indices)
{
  std::optional<Refusal> refusal;
  std::size_t index = 0;
  for(const auto f : faces(tmesh)) {
    std::size_t degree = 0;
    for(const auto h : halfedges_around_face(halfedge(f, tmesh), tmesh)) {
      ++degree;
      if(!is_in_range(get_uv(uv_map, h)))
        refusal = Refusal(Outcome::NOT_FINITE,
                          "face " + std::to_string(index) + " has a coordinate that is NaN, "
                          "infinite, or beyond 1e300 at vertex " +
                          std::to_string(get(vertex_indices, target(h, tmesh))) +
                          "; all corners need finite coordinates");
    }
    if(degree != 3)
      refusal = Refusal(Outcome::NOT_TRIANGULAR,
                        "face " + std::to_string(index) + " has " + std::to_string(degree) +
                        " corners; triangulate the mesh first");
    if(refusal)
      break;
    ++index;
  }
  return refusal;
}

// Whether the face of a halfedge, or the hole that it borders, has less than three corners.
template <typename TriangleMesh, typename Halfedge>
bool is_in_digon(const Halfedge h, const TriangleMesh& tmesh)
{
  return next(h, tmesh) == prev(h, tmesh);
}

// Edges whose corners are on their way from the memory, while those before them are compared.
constexpr std::size_t surveyed_together = 64;

// `is_open_anyway`, if it is not empty, lets callers add edges that are the same on both sides, but
// known to be cuts.
template <typename TriangleMesh, typename HalfedgeUVMap, typename VertexIndexMap>
Uv_survey<TriangleMesh>
survey_uv(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
          const VertexIndexMap& vertex_indices,
          const std::function<bool(typename Uv_survey<TriangleMesh>::Halfedge)>& is_open_anyway)
{
  using Survey = Uv_survey<TriangleMesh>;
  using Halfedge = typename Survey::Halfedge;
  Survey survey;
  // growing would copy and touch more memory
  survey.mismatched_edges.reserve(std::size_t(num_edges(tmesh)) / 16);
  Uv_box box;
  std::size_t number_of_corners = 0;
  std::size_t number_of_digons = 0; // of faces or, which is allowed, of holes, by halfedges
  // NaN differs from itself, so that only open edges and the border can hide it
  bool in_range = true;

  const auto add_border_corner = [&](const Halfedge h) {
    ++number_of_corners;
    box.add(get_uv(uv_map, h));
    in_range = in_range && is_in_range(get_uv(uv_map, h));
  };
  const auto compare_sides = [&](const Halfedge h) {
    const Halfedge g = opposite(h, tmesh);
    number_of_corners += 2;
    box.add(get_uv(uv_map, h));
    box.add(get_uv(uv_map, g));
    // Points are compared where they are: copying them first would take as long again.
    if(are_equal(get(uv_map, h), get(uv_map, prev(g, tmesh))) &&
       are_equal(get(uv_map, g), get(uv_map, prev(h, tmesh))) &&
       !(is_open_anyway && is_open_anyway(h)))
      return;
    const Edge_sides sides = edge_sides(tmesh, uv_map, h);
    survey.mismatched_edges.push_back({{h, std::size_t(get(vertex_indices, source(h, tmesh))),
                                        std::size_t(get(vertex_indices, target(h, tmesh)))},
                                       sides});
    in_range = in_range && is_in_range(sides.b) && is_in_range(sides.a_opposite);
  };

  const auto range = edges(tmesh);
  auto edge = std::begin(range);
  const auto last = std::end(range);
  std::array<boost::container::static_vector<Halfedge, surveyed_together>, 2> inner_edges;
  const auto read_edges = [&](auto& inner) {
    inner.clear();
    for(; edge != last && inner.size() < surveyed_together; ++edge) {
      const Halfedge h = halfedge(*edge, tmesh), g = opposite(h, tmesh);
      number_of_digons += std::size_t(is_in_digon(h, tmesh)) + std::size_t(is_in_digon(g, tmesh));
      if(!is_border(h, tmesh) && !is_border(g, tmesh)) {
        prefetch(uv_map, prev(h, tmesh));
        prefetch(uv_map, prev(g, tmesh));
        inner.push_back(h);
        continue;
      }
      for(const Halfedge side : {h, g})
        if(!is_border(side, tmesh)) // else the map need not have a value
          add_border_corner(side);
    }
  };
  read_edges(inner_edges[0]);
  for(std::size_t i = 0; !inner_edges[i].empty(); i = 1 - i) {
    read_edges(inner_edges[1 - i]);
    for(const Halfedge h : inner_edges[i])
      compare_sides(h);
  }
  survey.extent = box.extent();
  // If faces have at least three corners, all are triangles if there are no more corners than that.
  // num_faces() counts removed ones too.
  if(!in_range || number_of_digons > 0 || !box.is_in_range() ||
     number_of_corners != 3 * std::size_t(faces(tmesh).size()))
    survey.refusal = find_bad_face(tmesh, uv_map, vertex_indices);
  return survey;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_UV_SURVEY_H
