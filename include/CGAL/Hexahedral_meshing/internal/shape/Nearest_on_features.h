// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Hexahedral_meshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_NEAREST_ON_FEATURES_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_NEAREST_ON_FEATURES_H

#include <CGAL/license/Hexahedral_meshing.h>

// The nearest points on patches of the boundary and on curves, in space.

#include <CGAL/Hexahedral_meshing/internal/packages_below.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR < 1060000000 // CGAL 6 has other names
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#else
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#endif

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

using Space_kernel = CGAL::Simple_cartesian<double>;

#if CGAL_VERSION_NR < 1060000000
template <typename Primitive>
using Nearest_traits = CGAL::AABB_traits<Space_kernel, Primitive>;
template <typename Iterator>
using Triangle_primitive = CGAL::AABB_triangle_primitive<Space_kernel, Iterator>;
template <typename Iterator>
using Segment_primitive = CGAL::AABB_segment_primitive<Space_kernel, Iterator>;
#else
template <typename Primitive>
using Nearest_traits = CGAL::AABB_traits_3<Space_kernel, Primitive>;
template <typename Iterator>
using Triangle_primitive = CGAL::AABB_triangle_primitive_3<Space_kernel, Iterator>;
template <typename Iterator>
using Segment_primitive = CGAL::AABB_segment_primitive_3<Space_kernel, Iterator>;
#endif

// Numbered sets of elements; the tree of each is built when it is first asked.
template <typename Element, template <typename> class Primitive>
class Nearest_on_sets
{
  using Point = Space_kernel::Point_3;
  using Tree =
    CGAL::AABB_tree<Nearest_traits<Primitive<typename std::vector<Element>::const_iterator> > >;

public:
  // Elements without an extent are left out.
  // \pre no tree is built yet
  void add(const std::size_t set, const Element& element)
  {
    m_sets.resize((std::max)(m_sets.size(), set + 1));
    if(!element.is_degenerate())
      m_sets[set].push_back(element);
  }

  // \param near_by a point on an element of the set, which bounds the search
  Uvw nearest(const std::size_t set, const Uvw& p, const Uvw& near_by)
  {
    m_trees.resize(m_sets.size());
    if(m_trees[set] == nullptr)
      m_trees[set] = std::make_unique<Tree>(m_sets[set].begin(), m_sets[set].end());
    if(m_sets[set].empty())
      return near_by;
    const Point q = m_trees[set]->closest_point(Point(p[0], p[1], p[2]),
                                                Point(near_by[0], near_by[1], near_by[2]));
    return {q.x(), q.y(), q.z()};
  }

private:
  std::vector<std::vector<Element> > m_sets;
  std::vector<std::unique_ptr<Tree> > m_trees;
};

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_SHAPE_NEAREST_ON_FEATURES_H
