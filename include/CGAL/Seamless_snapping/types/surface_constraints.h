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

#ifndef CGAL_SEAMLESS_SNAPPING_TYPES_SURFACE_CONSTRAINTS_H
#define CGAL_SEAMLESS_SNAPPING_TYPES_SURFACE_CONSTRAINTS_H

#include <CGAL/license/Seamless_snapping.h>

// Further constraints on a parametrization ([MC19] Sec. 5.1): connections, cycles, and linear
// equations on the coordinates of corners; and helpers to state them.

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <deque>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingConstraints

A connection constraint (Eq.\ (6) of \cgalCite{cgal:mc-ecstsp-19}): an isocurve of corner `a` leads
along a path to corner `b`. In other words, \f$ g(\mathbf{u}(a)) \f$ and \f$ \mathbf{u}(b) \f$ agree
in one component, with the composition \f$ g \f$ of the transitions across the halfedges of the
path. The member `component` names the coordinate of corner `a` that is constant on the isocurve;
\f$ g \f$ may turn it into the other coordinate of corner `b`.

A path is a sequence of halfedges: `h` leads from `face(h)` to `face(opposite(h))`. The path of a
connection begins in `face(a)` and ends in `face(b)`; it is empty if these are the same.

\sa `shortest_face_path()`
*/
template <typename TriangleMesh>
struct Connection_constraint
{
  /// a halfedge of the mesh
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  halfedge_descriptor a; ///< the corner of `face(a)` at `target(a)`
  halfedge_descriptor b; ///< the corner of `face(b)` at `target(b)`
  int component = 0;     ///< 0 or 1: the constant coordinate of corner `a`
  std::vector<halfedge_descriptor> path; ///< from `face(a)` to `face(b)`
};

/*!
\ingroup PkgSeamlessSnappingConstraints

A cycle constraint (Eq.\ (8) of \cgalCite{cgal:mc-ecstsp-19}): an isocurve of a corner returns along
a closed path to the corner, instead of forming a spiral.
*/
template <typename TriangleMesh>
struct Cycle_constraint
{
  /// a halfedge of the mesh
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  halfedge_descriptor corner; ///< the corner of `face(corner)` at `target(corner)`
  int component = 0;          ///< 0 or 1: the constant coordinate of the corner
  std::vector<halfedge_descriptor> path; ///< from `face(corner)` back to `face(corner)`
};

/*!
\ingroup PkgSeamlessSnappingConstraints

A linear equation on the coordinates of corners, with rational coefficients. Examples are pinned
coordinates, spacings of nodes, and integer coordinates of quantized parametrizations.
*/
template <typename TriangleMesh>
struct Corner_constraint
{
  /// a coordinate of a corner, times a coefficient
  struct Term
  {
    /// the corner of `face(corner)` at `target(corner)`
    typename boost::graph_traits<TriangleMesh>::halfedge_descriptor corner;
    int component = 0; ///< 0 or 1: the coordinate of the corner
    CGAL::Exact_rational coefficient = CGAL::Exact_rational(1); ///< the coefficient
  };

  std::vector<Term> terms;                  ///< the terms of the sum
  CGAL::Exact_rational right_hand_side = CGAL::Exact_rational(0); ///< the value of the sum
};

/*!
\ingroup PkgSeamlessSnappingConstraints

returns a path from `face(a)` to `face(b)` that crosses as few edges as possible. The path is empty
if both are the same face, if the faces are not connected, or if one of the halfedges is on the
border.

\tparam TriangleMesh a model of `FaceGraph`

\param tmesh the mesh
\param a a halfedge of the face in which the path begins
\param b a halfedge of the face in which the path ends

\par Complexity
Linear in the number of faces.
*/
template <typename TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>
shortest_face_path(const TriangleMesh& tmesh,
                   const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor a,
                   const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor b)
{
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using Face = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  std::vector<Halfedge> path;
  if(is_border(a, tmesh) || is_border(b, tmesh))
    return path;
  struct Arrival { Halfedge halfedge; bool is_set = false; };
  auto arrivals = get(CGAL::dynamic_face_property_t<Arrival>(), tmesh);
  const Face first = face(a, tmesh), last = face(b, tmesh);
  std::deque<Face> queue(1, first);
  put(arrivals, first, Arrival{Halfedge(), true});
  while(!queue.empty() && !get(arrivals, last).is_set) {
    const Face f = queue.front();
    queue.pop_front();
    for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh)) {
      const Halfedge g = opposite(h, tmesh);
      if(is_border(g, tmesh) || get(arrivals, face(g, tmesh)).is_set)
        continue;
      put(arrivals, face(g, tmesh), Arrival{h, true});
      queue.push_back(face(g, tmesh));
    }
  }
  if(!get(arrivals, last).is_set)
    return path;
  for(Face f = last; f != first; f = face(path.back(), tmesh))
    path.push_back(get(arrivals, f).halfedge);
  std::reverse(path.begin(), path.end());
  return path;
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_TYPES_SURFACE_CONSTRAINTS_H
