// The full constraint system of a seamless parametrization, Sec. 5.2, Eqs. (4) and (5), for
// exact_reference.h to solve. Shares no code with the package.

#ifndef SEAMLESS_SNAPPING_TEST_FULL_SEAMLESS_SYSTEM_H
#define SEAMLESS_SNAPPING_TEST_FULL_SEAMLESS_SYSTEM_H

#include "exact_reference.h"
#include "exact_seamless_check.h"

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <map>
#include <vector>

namespace exact_check {

// The full system: the unknowns are the two coordinates of every class of corners. A class is one
// corner, or all corners of a sector where a predicate says which edges are cut.
template <typename Graph>
struct Full_system
{
  using Halfedge = typename boost::graph_traits<Graph>::halfedge_descriptor;

  exact_reference::System system;
  std::map<Halfedge, std::size_t> class_of_corner;
  std::vector<std::size_t> class_sizes;
  exact_reference::Rationals xbar; // of a class: the mean of its corners

  std::size_t unknown(Halfedge corner, std::size_t component) const
  {
    return 2 * class_of_corner.at(corner) + component;
  }

  // Every corner counts the same in the squared change.
  exact_reference::Rationals weights_by_corners() const
  {
    exact_reference::Rationals result;
    for(std::size_t size : class_sizes)
      result.insert(result.end(), 2, Rational(static_cast<double>(size)));
    return result;
  }

  // The unknowns of a uv map whose classes agree (the first corner of each class speaks for it).
  template <typename UVMap>
  exact_reference::Rationals values(const UVMap& uv) const
  {
    exact_reference::Rationals result(2 * class_sizes.size());
    for(auto it = class_of_corner.rbegin(); it != class_of_corner.rend(); ++it) {
      result[2 * it->second] = Rational(get(uv, it->first).x());
      result[2 * it->second + 1] = Rational(get(uv, it->first).y());
    }
    return result;
  }
};

struct Every_edge_cut
{
  template <typename Edge>
  bool operator()(const Edge&) const
  {
    return true;
  }
};

namespace internal {

// All corners that are reached from h around its vertex without crossing a cut edge or the border.
template <typename Graph, typename IsCut>
std::vector<typename boost::graph_traits<Graph>::halfedge_descriptor>
corners_of_class(typename boost::graph_traits<Graph>::halfedge_descriptor h, const Graph& g,
                 const IsCut& is_cut)
{
  using Halfedge = typename boost::graph_traits<Graph>::halfedge_descriptor;
  std::vector<Halfedge> result(1, h);
  const auto passable = [&](Halfedge edge) {
    return !is_border(edge, g) && !is_border(opposite(edge, g), g) && !is_cut(CGAL::edge(edge, g));
  };
  // One way round across the edge that ends the corner, the other across the one that starts it.
  Halfedge c = h;
  while(passable(next(c, g)) && (c = opposite(next(c, g), g)) != h)
    result.push_back(c);
  if(c == h && result.size() > 1)
    return result;
  c = h;
  while(passable(c) && (c = prev(opposite(c, g), g)) != h)
    result.push_back(c);
  return result;
}

template <typename Graph, typename UVMap, typename IsCut>
void number_unknowns(const Graph& g, const UVMap& uv, const IsCut& is_cut, Full_system<Graph>& full)
{
  for(const auto h : halfedges(g)) {
    if(is_border(h, g) || full.class_of_corner.count(h) != 0)
      continue;
    Exact_vector sum = { Rational(0), Rational(0) };
    const auto corners = corners_of_class(h, g, is_cut);
    for(const auto c : corners) {
      full.class_of_corner[c] = full.class_sizes.size();
      sum[0] += Rational(get(uv, c).x());
      sum[1] += Rational(get(uv, c).y());
    }
    full.class_sizes.push_back(corners.size());
    const Rational count(static_cast<double>(corners.size()));
    full.xbar.push_back(sum[0] / count);
    full.xbar.push_back(sum[1] / count);
  }
  full.system.columns = 2 * full.class_sizes.size();
}

// Eq. (4): R (a - b) = a' - b', one row a component.
template <typename Graph>
void add_transition_rows(typename boost::graph_traits<Graph>::halfedge_descriptor h, const Graph& g,
                         int rotation, Full_system<Graph>& full)
{
  const auto o = opposite(h, g);
  for(std::size_t component = 0; component < 2; ++component) {
    exact_reference::Row row;
    for(std::size_t from = 0; from < 2; ++from) {
      Exact_vector unit = { Rational(from == 0 ? 1 : 0), Rational(from == 0 ? 0 : 1) };
      const Rational coefficient = rotated(unit, rotation)[component];
      row.push_back({ full.unknown(h, from), coefficient });
      row.push_back({ full.unknown(prev(h, g), from), Rational(-coefficient) });
    }
    row.push_back({ full.unknown(prev(o, g), component), Rational(-1) });
    row.push_back({ full.unknown(o, component), Rational(1) });
    row = exact_reference::merged(row);
    if(!row.empty())
      full.system.add_row(row);
  }
}

// Eq. (5) from one side; the component that varies less is the one to be constant.
template <typename Graph, typename UVMap>
void add_alignment_row(typename boost::graph_traits<Graph>::halfedge_descriptor h, const Graph& g,
                       const UVMap& uv, Full_system<Graph>& full)
{
  const Exact_vector d = exact_difference(get(uv, h), get(uv, prev(h, g)));
  const std::size_t component = CGAL::abs(d[0]) < CGAL::abs(d[1]) ? 0 : 1;
  full.system.add_row({ { full.unknown(h, component), Rational(1) },
                        { full.unknown(prev(h, g), component), Rational(-1) } });
}

} // namespace internal

// rotation(h) must be 0..3 for every interior halfedge. With the default for is_cut the unknowns
// are all corners, as in Sec. 5.2; otherwise the sectors between cut edges, as in Sec. 5.3.
template <typename Graph, typename UVMap, typename Rotation, typename IsAligned = No_edge_aligned,
          typename IsCut = Every_edge_cut>
Full_system<Graph> full_system(const Graph& g, const UVMap& uv, const Rotation& rotation,
                               const IsAligned& is_aligned = IsAligned(),
                               const IsCut& is_cut = IsCut())
{
  Full_system<Graph> result;
  internal::number_unknowns(g, uv, is_cut, result);
  for(const auto e : edges(g)) {
    const auto h = halfedge(e, g), o = opposite(h, g);
    if(!is_border(h, g) && !is_border(o, g))
      internal::add_transition_rows(h, g, rotation(h), result);
    if(is_aligned(e))
      internal::add_alignment_row(is_border(h, g) ? o : h, g, uv, result);
  }
  return result;
}

} // namespace exact_check

#endif // SEAMLESS_SNAPPING_TEST_FULL_SEAMLESS_SYSTEM_H
