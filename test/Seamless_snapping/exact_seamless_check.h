// An exact check of a uv map, in rational arithmetic and sharing no code with the package: which
// edges are exact, how far off the others are, which alignments hold, how the triangles are turned;
// and the full constraint system of Sec. 5.2, Eqs. (4) and (5), for exact_reference.h to solve.
//
// A corner is a halfedge h: the vertex target(h) seen from face(h).

#ifndef SEAMLESS_SNAPPING_TEST_EXACT_SEAMLESS_CHECK_H
#define SEAMLESS_SNAPPING_TEST_EXACT_SEAMLESS_CHECK_H

#include "exact_reference.h"

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace exact_check {

using exact_reference::Rational;
using Exact_vector = std::array<Rational, 2>;

// Turned counterclockwise by k quarter turns.
inline Exact_vector rotated(const Exact_vector& v, int k)
{
  switch(((k % 4) + 4) % 4) {
    case 0: return v;
    case 1: return { Rational(-v[1]), v[0] };
    case 2: return { Rational(-v[0]), Rational(-v[1]) };
    default: return { v[1], Rational(-v[0]) };
  }
}

template <typename Point>
Exact_vector exact_difference(const Point& a, const Point& b)
{
  return { Rational(Rational(a.x()) - Rational(b.x())),
           Rational(Rational(a.y()) - Rational(b.y())) };
}

// The edge of h seen from both sides: its target minus its source, in the chart of face(h) and in
// that of the opposite face.
struct Two_sides
{
  Exact_vector here, there;
};

template <typename Graph, typename UVMap>
Two_sides two_sides(typename boost::graph_traits<Graph>::halfedge_descriptor h, const Graph& g,
                    const UVMap& uv)
{
  const auto o = opposite(h, g);
  return { exact_difference(get(uv, h), get(uv, prev(h, g))),
           exact_difference(get(uv, prev(o, g)), get(uv, o)) };
}

// The larger component of |R_k here - there|.
inline Rational violation(const Two_sides& edge, int k)
{
  const Exact_vector turned = rotated(edge.here, k);
  const Rational x = CGAL::abs(Rational(turned[0] - edge.there[0]));
  const Rational y = CGAL::abs(Rational(turned[1] - edge.there[1]));
  return x < y ? y : x;
}

// The rotation that fits best; the least violation is returned with it.
inline std::pair<int, Rational> best_rotation(const Two_sides& edge)
{
  std::pair<int, Rational> best(0, violation(edge, 0));
  for(int k = 1; k < 4 && best.second != 0; ++k) {
    const Rational candidate = violation(edge, k);
    if(candidate < best.second)
      best = { k, candidate };
  }
  return best;
}

struct Result
{
  std::size_t interior_edges = 0;
  std::size_t inexact_edges = 0;
  std::size_t edges_off_identity = 0; // the two faces disagree about a corner of the edge
  std::array<std::size_t, 4> edges_of_rotation = { { 0, 0, 0, 0 } };
  double largest_violation = 0; // of Eq. (4) and Eq. (5), computed exactly and then rounded

  std::size_t aligned_edges = 0;
  std::size_t inexact_aligned_edges = 0;

  std::size_t positive_faces = 0;
  std::size_t degenerate_faces = 0;
  std::size_t flipped_faces = 0;

  bool is_exact() const { return inexact_edges == 0 && inexact_aligned_edges == 0; }
};

struct No_edge_aligned
{
  template <typename Edge>
  bool operator()(const Edge&) const
  {
    return false;
  }
};

// Any rotation will do: the best fitting one is taken for each edge by itself.
struct Any_rotation
{
  template <typename Halfedge>
  int operator()(const Halfedge&) const
  {
    return -1;
  }
};

namespace internal {

template <typename Graph, typename UVMap>
bool is_off_identity(typename boost::graph_traits<Graph>::halfedge_descriptor h, const Graph& g,
                     const UVMap& uv)
{
  const auto o = opposite(h, g);
  return get(uv, h) != get(uv, prev(o, g)) || get(uv, prev(h, g)) != get(uv, o);
}

template <typename Graph, typename UVMap, typename Rotation>
void check_transition(typename boost::graph_traits<Graph>::halfedge_descriptor h, const Graph& g,
                      const UVMap& uv, const Rotation& rotation, Rational& largest, Result& result)
{
  ++result.interior_edges;
  const int wanted = rotation(h);
  const bool identity = !is_off_identity(h, g, uv);
  if(!identity)
    ++result.edges_off_identity;
  if(identity && wanted <= 0) {
    ++result.edges_of_rotation[0];
    return;
  }
  const Two_sides edge = two_sides(h, g, uv);
  const std::pair<int, Rational> found =
    wanted < 0 ? best_rotation(edge) : std::make_pair(wanted, violation(edge, wanted));
  ++result.edges_of_rotation[static_cast<std::size_t>(found.first)];
  if(found.second != 0)
    ++result.inexact_edges;
  if(largest < found.second)
    largest = found.second;
}

// Seen from each incident face, one of the components must be constant along the edge.
template <typename Graph, typename UVMap>
void check_alignment(typename boost::graph_traits<Graph>::halfedge_descriptor h, const Graph& g,
                     const UVMap& uv, Rational& largest, Result& result)
{
  ++result.aligned_edges;
  bool exact = true;
  for(const auto side : { h, opposite(h, g) }) {
    if(is_border(side, g))
      continue;
    const Exact_vector d = exact_difference(get(uv, side), get(uv, prev(side, g)));
    const Rational x = CGAL::abs(d[0]), y = CGAL::abs(d[1]);
    const Rational off = x < y ? x : y;
    exact = exact && off == 0;
    if(largest < off)
      largest = off;
  }
  if(!exact)
    ++result.inexact_aligned_edges;
}

} // namespace internal

template <typename Point>
int exact_orientation(const Point& a, const Point& b, const Point& c)
{
  const Exact_vector u = exact_difference(b, a), v = exact_difference(c, a);
  const Rational left = u[0] * v[1], right = u[1] * v[0];
  return left > right ? 1 : (left < right ? -1 : 0);
}

template <typename Graph, typename UVMap>
int face_orientation(typename boost::graph_traits<Graph>::face_descriptor f, const Graph& g,
                     const UVMap& uv)
{
  const auto h = halfedge(f, g);
  return exact_orientation(get(uv, prev(h, g)), get(uv, h), get(uv, next(h, g)));
}

// rotation(h) is the number of quarter turns from the chart of face(h) to that of the opposite
// face, or -1 for whichever fits; is_aligned(e) tells whether Eq. (5) is asked of the edge.
template <typename Graph, typename UVMap, typename IsAligned = No_edge_aligned,
          typename Rotation = Any_rotation>
Result check_edges(const Graph& g, const UVMap& uv, const IsAligned& is_aligned = IsAligned(),
                   const Rotation& rotation = Rotation())
{
  Result result;
  Rational largest(0);
  for(const auto e : edges(g)) {
    const auto h = halfedge(e, g);
    if(!is_border(h, g) && !is_border(opposite(h, g), g))
      internal::check_transition(h, g, uv, rotation, largest, result);
    if(is_aligned(e))
      internal::check_alignment(h, g, uv, largest, result);
  }
  result.largest_violation = CGAL::to_double(largest);
  return result;
}

// The same, and the orientations of the faces.
template <typename Graph, typename UVMap, typename IsAligned = No_edge_aligned,
          typename Rotation = Any_rotation>
Result check(const Graph& g, const UVMap& uv, const IsAligned& is_aligned = IsAligned(),
             const Rotation& rotation = Rotation())
{
  Result result = check_edges(g, uv, is_aligned, rotation);
  for(const auto f : faces(g)) {
    const int sign = face_orientation(f, g, uv);
    ++(sign > 0 ? result.positive_faces
                : (sign == 0 ? result.degenerate_faces : result.flipped_faces));
  }
  return result;
}

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

#endif // SEAMLESS_SNAPPING_TEST_EXACT_SEAMLESS_CHECK_H
