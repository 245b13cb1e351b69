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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_WATCHED_FACES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_WATCHED_FACES_H

#include <CGAL/license/Seamless_snapping.h>

// The few faces whose orientation the moves of sectors can change. A face whose corners all move by
// no more than its height allows needs no second look; what is left is checked exactly, as often as
// it takes.

#include <CGAL/Seamless_snapping/internal/orientation/Point_stars.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant: contains each face once.
class Watched_faces
{
public:
  void add(const Face_index f)
  {
    if(m_is_known.size() <= std::size_t(f))
      m_is_known.resize(std::size_t(f) + 1, false);
    if(!m_is_known[std::size_t(f)])
      m_faces.push_back(f);
    m_is_known[std::size_t(f)] = true;
  }

  void add(const std::vector<Face_index>& faces)
  {
    for(const Face_index f : faces)
      add(f);
  }

  // Those that are not positive, among the faces that were positive in the input, or all others.
  template <typename Points>
  std::vector<Face_index> not_positive(const Points& points, const Uv_state& state,
                                       const bool were_positive) const
  {
    std::vector<Face_index> result;
    for(const Face_index f : m_faces)
      if(points.domain_face(f).was_positive == were_positive && !points.is_positive(state, f))
        result.push_back(f);
    return result;
  }

private:
  std::vector<Face_index> m_faces;
  std::vector<bool> m_is_known; // per face that was met
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_WATCHED_FACES_H
