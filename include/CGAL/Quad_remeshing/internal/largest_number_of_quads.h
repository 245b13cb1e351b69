// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_LARGEST_NUMBER_OF_QUADS_H
#define CGAL_QUAD_REMESHING_INTERNAL_LARGEST_NUMBER_OF_QUADS_H

#include <CGAL/license/Quad_remeshing.h>

// How many more quads than wanted are a success: nothing in the input is a reason for more.

#include <CGAL/Quad_remeshing/internal/quantization/quads_needed.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// An edge of each closed sequence of border edges. CGAL's own function has another name and place
// from CGAL 6.2 on.
template <typename Mesh>
auto border_cycles(const Mesh& mesh)
{
  std::vector<bool> is_visited(mesh.num_halfedges());
  std::vector<typename Mesh::Halfedge_index> result;
  for(const auto h : mesh.halfedges()) {
    if(!mesh.is_border(h) || is_visited[std::size_t(h)])
      continue;
    result.push_back(h);
    for(const auto next : CGAL::halfedges_around_face(h, mesh))
      is_visited[std::size_t(next)] = true;
  }
  return result;
}

// About as many quads as a surface of this topology takes at least.
template <typename Mesh>
double number_for_topology(const Mesh& mesh)
{
  constexpr double of_part = 6; // quads of a closed surface, or of an open one without holes
  constexpr double of_hole = 4; // quads around it
  std::vector<std::size_t> part(mesh.num_faces());
  const double parts = double(CGAL::Polygon_mesh_processing::connected_components(
    mesh, CGAL::make_property_map(part)));
  const double euler_characteristic = double(mesh.number_of_vertices()) +
                                      double(mesh.number_of_faces()) -
                                      double(mesh.number_of_edges());
  double loops = 0, holes = 0; // the first loop of a part is no hole
  std::vector<bool> is_open(part.size());
  for(const auto h : border_cycles(mesh)) {
    const std::size_t p = part[std::size_t(mesh.face(mesh.opposite(h)))];
    ++loops;
    holes += is_open[p];
    is_open[p] = true;
  }
  const double handles = (2 * parts - loops - euler_characteristic) / 2;
  return of_part * parts + double(quads_of_handle) * handles + of_hole * holes;
}

template <typename Mesh>
double largest_number_of_quads(const Mesh& mesh, const double wanted, const std::size_t forced)
{ return 2 * (std::max)({wanted, double(forced), number_for_topology(mesh)}); }

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_LARGEST_NUMBER_OF_QUADS_H
