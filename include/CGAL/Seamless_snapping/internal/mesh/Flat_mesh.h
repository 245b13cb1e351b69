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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_FLAT_MESH_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_FLAT_MESH_H

#include <CGAL/license/Seamless_snapping.h>

// The connectivity of a triangle mesh in plain arrays. It does not depend on the mesh data
// structure of the caller, and any number of threads can read it.

#include <boost/container/vector.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// A halfedge with a face, which stands for the corner of the face at its target.
using Corner_index = std::int32_t;
using Flat_vertex_index = std::int32_t;
using Flat_face_index = std::int32_t;
constexpr std::int32_t no_index = -1;

using Place = std::array<double, 3>; // in space

// The least data of a corner of a flat mesh. Without initial values: threads then share the writing
// of large arrays, and the time that the first access to memory takes.
struct Flat_corner
{
  Corner_index opposite;    // no_index: the other side is the border
  Flat_vertex_index vertex; // the target
};

// Invariant: the halfedges 3 f, 3 f + 1, 3 f + 2 are those of face f, counterclockwise; each vertex
// has a face. `Corner` is derived from Flat_corner: all that is known of a corner lies together.
template <typename Corner>
struct Flat_mesh
{
  boost::container::vector<Corner> corners;   // a vector that needn't initialize
  std::vector<Corner_index> corner_at_vertex; // one of them; along the border, the first
                                              // counterclockwise
  std::vector<char> is_border;                // per vertex

  static Flat_face_index face(const Corner_index h) { return h / 3; }
  static Corner_index next(const Corner_index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Corner_index prev(const Corner_index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  Corner_index number_of_halfedges() const { return Corner_index(corners.size()); }
  Flat_face_index number_of_faces() const { return number_of_halfedges() / 3; }
  std::size_t number_of_vertices() const { return corner_at_vertex.size(); }

  const Corner& corner(const Corner_index h) const { return corners[std::size_t(h)]; }
  Corner_index opposite(const Corner_index h) const { return corner(h).opposite; }
  std::size_t vertex(const Corner_index h) const { return std::size_t(corner(h).vertex); }
  std::size_t source(const Corner_index h) const { return vertex(prev(h)); }
  bool is_border_edge(const Corner_index h) const { return opposite(h) == no_index; }

  // One number for both halfedges of an edge.
  Corner_index edge_key(const Corner_index h) const
  {
    const Corner_index g = opposite(h);
    return (g == no_index || h < g) ? h : g;
  }
  bool represents_edge(const Corner_index h) const { return edge_key(h) == h; }

  // The next corners around the same vertex, or no_index at the border.
  Corner_index counterclockwise(const Corner_index h) const
  {
    const Corner_index g = opposite(h);
    return g == no_index ? no_index : prev(g);
  }
  Corner_index clockwise(const Corner_index h) const { return opposite(next(h)); }
};

// Calls `function(corner)` for the corners of a vertex in counterclockwise order.
template <typename Corner, typename Function>
void for_each_corner(const Flat_mesh<Corner>& mesh, const std::size_t vertex,
                     const Function& function)
{
  const Corner_index first = mesh.corner_at_vertex[vertex];
  Corner_index h = first;
  do {
    function(h);
    h = mesh.counterclockwise(h);
  } while(h != no_index && h != first);
}

// The connected parts of a surface: per face, numbered by their first faces. `opposite(halfedge)`
// is no_index where parts end, on both sides.
template <typename Opposite>
std::vector<std::int32_t> connected_parts(const std::size_t number_of_faces,
                                          const Opposite& opposite)
{
  boost::disjoint_sets_with_storage<> sets(number_of_faces);
  for(Corner_index h = 0; h < Corner_index(3 * number_of_faces); ++h)
    if(const Corner_index g = opposite(h); h < g)
      sets.union_set(std::size_t(h / 3), std::size_t(g / 3));
  std::vector<std::int32_t> parts(number_of_faces, no_index);
  std::int32_t number = 0;
  for(std::size_t f = 0; f < number_of_faces; ++f) {
    std::int32_t& part = parts[sets.find_set(f)];
    part = part == no_index ? number++ : part;
    parts[f] = part;
  }
  return parts;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_FLAT_MESH_H
