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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_COINCIDING_BORDER_EDGES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_COINCIDING_BORDER_EDGES_H

#include <CGAL/license/Seamless_snapping.h>

// Whether a mesh looks as if it was cut open along its seams: its border edges then lie on each
// other, and what is a seam to the user is a border to every function here.

#include <CGAL/Seamless_snapping/internal/mesh/Segments_in_space.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Kernel_traits.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Returns how many border edges have the same two points as another border edge.
template <typename TriangleMesh, typename VertexPointMap>
std::size_t number_of_coinciding_border_edges(const TriangleMesh& tmesh, const VertexPointMap& vpm)
{
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  const auto coordinates = [&vpm](const auto v) {
    const Point& p = get(vpm, v);
    return std::array<FT, 3>{p.x(), p.y(), p.z()};
  };

  Segments_in_space<FT> border;
  for(const auto h : halfedges(tmesh))
    if(is_border(h, tmesh))
      border.add(coordinates(source(h, tmesh)), coordinates(target(h, tmesh)), 0);
  std::size_t result = 0;
  border.for_each_coincidence([&result](const auto first, const auto last) {
    result += static_cast<std::size_t>(last - first);
  });
  return result;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_COINCIDING_BORDER_EDGES_H
