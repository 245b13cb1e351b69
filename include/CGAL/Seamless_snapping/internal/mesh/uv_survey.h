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

// The one pass over all edges of a mesh: finds the open edges, whose two sides are not the same to
// the bit, and checks on the way that faces are triangles and coordinates are finite. Later
// steps look at open edges only.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/mesh/Mismatched_edges.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/transitions/Side_vectors.h>

#include <CGAL/Bbox_2.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// \pre both sides of `h` have a face
template <typename Surface>
Edge_sides edge_sides(const Surface& surface, const typename Surface::Halfedge h)
{
  const auto g = surface.opposite(h);
  return {surface.uv(surface.prev(h)), surface.uv(h),
          surface.uv(g), surface.uv(surface.prev(g))};
}

template <typename Halfedge>
struct Uv_survey
{
  std::vector<Mismatched_edge<Halfedge> > mismatched_edges; // not measured
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

// To be added to another box, which ignores NaN.
inline CGAL::Bbox_2 box_of(const Uv& u) { return {u[0], u[1], u[0], u[1]}; }

inline double extent_of(const CGAL::Bbox_2& box)
{ return box.xmin() > box.xmax() ? 0 : (std::max)(box.x_span(), box.y_span()); }

// On failure only: names the place, if there is one.
template <typename Surface>
std::optional<Refusal> find_bad_face(const Surface& surface)
{
  std::optional<Refusal> refusal;
  std::size_t index = 0;
  for(const auto first : surface.one_per_face()) {
    std::size_t degree = 0;
    auto h = first;
    do {
      ++degree;
      if(!is_in_range(surface.uv(h)))
        refusal = Refusal(Outcome::NOT_FINITE,
                          name_of_face(index) + " has a coordinate that is NaN, "
                          "infinite, or beyond 1e300 at " + vertex_name(surface, h) +
                          remedy("all corners need finite coordinates"));
      h = surface.next(h);
    } while(h != first);
    if(degree != 3)
      refusal = Refusal(Outcome::NOT_TRIANGULAR,
                        name_of_face(index) + " has " + std::to_string(degree) + " corners" +
                        remedy("triangulate the mesh first"));
    if(refusal)
      break;
    ++index;
  }
  return refusal;
}

// Whether the face of a halfedge, or the hole that it borders, has less than three corners.
template <typename Surface>
bool is_in_digon(const Surface& surface, const typename Surface::Halfedge h)
{
  return surface.next(h) == surface.prev(h);
}

// Edges whose corners are on their way from the memory, while earlier edges are compared.
constexpr std::size_t surveyed_together = 64;

// `is_open_anyway`, if it is not empty, lets callers add edges that are the same on both sides, but
// known to be cuts.
template <typename Surface>
Uv_survey<typename Surface::Halfedge>
survey_uv(const Surface& surface,
          const std::function<bool(typename Surface::Halfedge)>& is_open_anyway)
{
  using Halfedge = typename Surface::Halfedge;
  Uv_survey<Halfedge> survey;
  // growing would copy and touch more memory
  survey.mismatched_edges.reserve(surface.number_of_edges() / 16);
  CGAL::Bbox_2 box;
  std::size_t number_of_corners = 0;
  std::size_t number_of_digons = 0; // halfedges of digons: faces, or holes, which are allowed
  // NaN differs from itself, so that only open edges and the border can hide it
  bool in_range = true;

  const auto add_border_corner = [&](const Halfedge h) {
    ++number_of_corners;
    box += box_of(surface.uv(h));
    in_range = in_range && is_in_range(surface.uv(h));
  };
  const auto compare_sides = [&](const Halfedge h) {
    const Halfedge g = surface.opposite(h);
    number_of_corners += 2;
    box += box_of(surface.uv(h));
    box += box_of(surface.uv(g));
    if(surface.have_same_uv(h, surface.prev(g)) && surface.have_same_uv(g, surface.prev(h)) &&
       !(is_open_anyway && is_open_anyway(h)))
      return;
    const Edge_sides sides = edge_sides(surface, h);
    survey.mismatched_edges.push_back({{h, surface.source(h), surface.vertex(h)}, {sides}});
    in_range = in_range && is_in_range(sides.b) && is_in_range(sides.a_opposite);
  };

  const auto& range = surface.one_per_edge();
  auto edge = std::begin(range);
  const auto last = std::end(range);
  std::array<boost::container::static_vector<Halfedge, surveyed_together>, 2> inner_edges;
  const auto read_edges = [&](auto& inner) {
    inner.clear();
    for(; edge != last && inner.size() < surveyed_together; ++edge) {
      const Halfedge h = *edge, g = surface.opposite(h);
      number_of_digons += std::size_t(is_in_digon(surface, h)) +
                          std::size_t(is_in_digon(surface, g));
      if(!surface.is_border(h) && !surface.is_border(g)) {
        surface.prefetch(surface.prev(h));
        surface.prefetch(surface.prev(g));
        inner.push_back(h);
        continue;
      }
      for(const Halfedge side : {h, g})
        if(!surface.is_border(side)) // else the map need not have a value
          add_border_corner(side);
    }
  };
  read_edges(inner_edges[0]);
  for(std::size_t i = 0; !inner_edges[i].empty(); i = 1 - i) {
    read_edges(inner_edges[1 - i]);
    for(const Halfedge h : inner_edges[i])
      compare_sides(h);
  }
  survey.extent = extent_of(box);
  // If faces have at least three corners, all are triangles if there are no more corners than that.
  if(!in_range || number_of_digons > 0 || !is_in_range({box.xmin(), box.ymin()}) ||
     !is_in_range({box.xmax(), box.ymax()}) || number_of_corners != 3 * surface.number_of_faces())
    survey.refusal = find_bad_face(surface);
  return survey;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_UV_SURVEY_H
