// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_PATH_ROTATIONS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_PATH_ROTATIONS_H

#include <CGAL/license/Seamless_snapping.h>

// The rotations across the halfedges of the constraints' paths.

#include <CGAL/Seamless_snapping/internal/surface/Constraint_list.h>
#include <CGAL/Seamless_snapping/internal/surface/read_transitions.h>

#include <unordered_map>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant: knows all cut edges, if there are paths at all; most calls have none, and then it is empty.
template <typename TriangleMesh>
class Path_rotations
{
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

public:
  Path_rotations(const TriangleMesh& tmesh, const Transition_data<TriangleMesh>& transitions,
                 const Constraint_list<TriangleMesh>& constraints)
  {
    if(constraints.paths().empty())
      return;
    for(const Open_edge<Halfedge>& edge : transitions.edges)
      if(edge.rotation != 0) {
        m_rotations[edge.halfedge] = edge.rotation;
        m_rotations[opposite(edge.halfedge, tmesh)] = inverse_rotation(edge.rotation);
      }
  }

  int operator()(const Halfedge h) const
  {
    const auto found = m_rotations.find(h);
    return found == m_rotations.end() ? 0 : found->second;
  }

private:
  std::unordered_map<Halfedge, int> m_rotations;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_PATH_ROTATIONS_H
