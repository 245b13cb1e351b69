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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_NEAREST_PLACE_TREE_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_NEAREST_PLACE_TREE_H

#include <CGAL/license/Quad_remeshing.h>

// Finds the nearest place on triangles or segments: this takes most of the time of smoothing.
// `CGAL::AABB_tree` takes two to four times as long, because it does not visit the nearer of two
// boxes first, and makes each triangle from the mesh at each visit.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Space_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Times two.
inline Space_vector area_vector(const Space_triangle& t)
{ return vector_product(vector_to(t[0], t[1]), vector_to(t[0], t[2])); }

inline double squared_distance(const Space_vector& a, const Space_vector& b)
{
  const Space_vector d = vector_to(a, b);
  return inner_product(d, d);
}

inline Space_vector nearest_place(const Space_vector& p, const Space_segment& s)
{
  const Space_vector side = vector_to(s[0], s[1]);
  const double along = inner_product(vector_to(s[0], p), side);
  const double length = inner_product(side, side);
  return along <= 0 ? s[0] : along < length ? between(s[0], s[1], along / length) : s[1];
}

// On the triangle, up to rounding, also if it is a sliver.
inline Space_vector nearest_place(const Space_vector& p, const Space_triangle& t)
{
  const Space_vector normal = area_vector(t);
  const std::array<Space_vector, 3> d{vector_to(p, t[0]), vector_to(p, t[1]), vector_to(p, t[2])};
  std::array<double, 3> part; // areas, as seen along the normal; that opposite to a corner
  double least = std::numeric_limits<double>::infinity();
  Space_vector result = t[0];
  for(std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    part[i] = inner_product(vector_product(d[j], d[k]), normal);
    if(part[i] <= 0) {
      const Space_vector q = nearest_place(p, Space_segment{t[j], t[k]});
      if(const double squared = squared_distance(p, q); squared < least) {
        least = squared;
        result = q;
      }
    }
  }
  if(part[0] > 0 && part[1] > 0 && part[2] > 0) {
    if(inner_product(d[0], normal) == 0)
      return p; // as it is, as on a surface that is a plane
    const double sum = part[0] + part[1] + part[2];
    for(std::size_t c = 0; c < 3; ++c)
      result[c] += part[1] / sum * (t[1][c] - t[0][c]) + part[2] / sum * (t[2][c] - t[0][c]);
  }
  return result;
}

// Boxes around the elements, and around halves of them.
// \tparam Element `Space_segment` or `Space_triangle`
template <typename Element>
class Nearest_place_tree
{
public:
  struct Place
  {
    Space_vector point;
    std::size_t element = 0; // its number
    double squared_distance = std::numeric_limits<double>::infinity();
  };

  // \pre there are fewer than 2^32
  explicit Nearest_place_tree(const std::vector<Element>& elements = {})
  {
    if(elements.empty())
      return;
    std::vector<Entry> entries;
    entries.reserve(elements.size());
    for(const Element& e : elements) {
      Entry entry;
      entry.number = Index(entries.size());
      entry.box.extend(e);
      for(const Space_vector& p : e)
        for(std::size_t c = 0; c < 3; ++c)
          entry.sum[c] += p[c];
      entries.push_back(entry);
    }
    m_nodes.reserve(elements.size());
    m_nodes.emplace_back();
    m_elements.reserve(elements.size());
    m_boxes.reserve(elements.size());
    m_numbers.reserve(elements.size());
    build(0, entries.begin(), entries.end(), elements);
  }

  bool empty() const { return m_elements.empty(); }

  std::size_t number_of_searches() const { return m_number_of_searches; }

  // \pre not empty
  Place nearest(const Space_vector& p) const
  {
    Place result = search_from(p, {});
    result.element = m_numbers[result.element];
    return result;
  }

  // A faster search, which begins at a known place.
  Space_vector nearest(const Space_vector& p, const Space_vector& near_by) const
  { return search_from(p, {near_by, 0, squared_distance(p, near_by)}).point; }

  // The largest distance of points from the elements. Where the element that was found last is near
  // enough, none is looked for: few searches, if points are in an order of neighbors.
  // \pre not empty
  class Largest_distance
  {
  public:
    explicit Largest_distance(const Nearest_place_tree& tree) : m_tree(tree) { }

    void add(const Space_vector& p)
    {
      if(squared_distance(p, nearest_place(p, m_tree.m_elements[m_last])) <= m_squared)
        return;
      const Place found = m_tree.search_from(p, {});
      m_squared = (std::max)(m_squared, found.squared_distance);
      m_last = found.element;
    }

    double value() const { return std::sqrt(m_squared); }

  private:
    const Nearest_place_tree& m_tree;
    std::size_t m_last = 0; // in the order of leaves
    double m_squared = 0;
  };

  // Calls visit(number) for the elements whose box meets the box of a segment.
  template <typename Visit>
  void visit_near(const Space_segment& s, const Visit& visit) const
  {
    Box box;
    box.extend(s);
    if(!empty())
      visit_near(m_nodes.front(), box, visit);
  }

private:
  using Index = std::uint32_t;

  struct Box
  {
    Space_vector lower = all(std::numeric_limits<double>::infinity());
    Space_vector upper = all(-std::numeric_limits<double>::infinity());

    static Space_vector all(const double x) { return {x, x, x}; }

    template <typename Points>
    void extend(const Points& points)
    {
      for(const Space_vector& p : points)
        for(std::size_t c = 0; c < 3; ++c) {
          lower[c] = (std::min)(lower[c], p[c]);
          upper[c] = (std::max)(upper[c], p[c]);
        }
    }

    std::size_t longest_side() const
    {
      const Space_vector sides = vector_to(lower, upper);
      return std::size_t(std::max_element(sides.begin(), sides.end()) - sides.begin());
    }

    double squared_distance(const Space_vector& p) const
    {
      double result = 0;
      for(std::size_t c = 0; c < 3; ++c) {
        const double d = (std::max)({lower[c] - p[c], p[c] - upper[c], 0.});
        result += d * d;
      }
      return result;
    }

    bool meets(const Box& other) const
    {
      bool result = true;
      for(std::size_t c = 0; c < 3; ++c)
        result = result && lower[c] <= other.upper[c] && other.lower[c] <= upper[c];
      return result;
    }
  };

  // A node of elements, or of two nodes.
  struct Node
  {
    Box box;
    Index first = 0, number_of_elements = 0;
  };

  // An element without its points: its box, their sum, and its number.
  struct Entry
  {
    Box box;
    Space_vector sum{};
    Index number;
  };
  using Entry_iterator = typename std::vector<Entry>::iterator;

  static constexpr std::ptrdiff_t most_in_leaf = 4; // triangles

  // Gives the node the elements from `begin` to `end`.
  void build(const std::size_t node, const Entry_iterator begin, const Entry_iterator end,
             const std::vector<Element>& elements)
  {
    Box box;
    for(Entry_iterator e = begin; e != end; ++e)
      box.extend(std::array<Space_vector, 2>{e->box.lower, e->box.upper});
    if(end - begin <= most_in_leaf) {
      m_nodes[node] = {box, Index(m_elements.size()), Index(end - begin)};
      for(Entry_iterator e = begin; e != end; ++e) {
        m_elements.push_back(elements[e->number]);
        m_boxes.push_back(e->box);
        m_numbers.push_back(e->number);
      }
      return;
    }
    const Entry_iterator half = begin + (end - begin) / 2;
    std::nth_element(begin, half, end, [c = box.longest_side()](const Entry& a, const Entry& b)
                                       { return a.sum[c] < b.sum[c]; });
    const Index first = Index(m_nodes.size());
    m_nodes[node] = {box, first, 0};
    m_nodes.resize(m_nodes.size() + 2);
    build(first, begin, half, elements);
    build(first + 1, half, end, elements);
  }

  // The nearest place, if it is nearer than `best`; elements are numbered in the order of leaves.
  Place search_from(const Space_vector& p, Place best) const
  {
    ++m_number_of_searches;
    Progress::tell_each_second([&] { return counted(m_number_of_searches, "place") +
                                            " looked for on the surface"; });
    search(m_nodes.front(), p, best);
    return best;
  }

  void search(const Node& node, const Space_vector& p, Place& best) const
  {
    for(Index i = node.first; i < node.first + node.number_of_elements; ++i) {
      if(m_boxes[i].squared_distance(p) >= best.squared_distance)
        continue;
      const Space_vector q = nearest_place(p, m_elements[i]);
      if(const double squared = internal::squared_distance(p, q); squared < best.squared_distance)
        best = {q, i, squared};
    }
    if(node.number_of_elements > 0)
      return;
    const Node *nearer = &m_nodes[node.first], *other = nearer + 1;
    double distance = nearer->box.squared_distance(p);
    double other_distance = other->box.squared_distance(p);
    if(other_distance < distance) {
      std::swap(nearer, other);
      std::swap(distance, other_distance);
    }
    if(distance < best.squared_distance)
      search(*nearer, p, best);
    if(other_distance < best.squared_distance)
      search(*other, p, best);
  }

  template <typename Visit>
  void visit_near(const Node& node, const Box& box, const Visit& visit) const
  {
    if(!node.box.meets(box))
      return;
    for(Index i = node.first; i < node.first + node.number_of_elements; ++i)
      visit(m_numbers[i]);
    for(Index child = 0; child < 2 && node.number_of_elements == 0; ++child)
      visit_near(m_nodes[node.first + child], box, visit);
  }

  std::vector<Node> m_nodes; // the root first
  std::vector<Element> m_elements; // in the order of leaves
  std::vector<Box> m_boxes; // of these
  std::vector<Index> m_numbers; // of these
  mutable std::size_t m_number_of_searches = 0;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_NEAREST_PLACE_TREE_H
