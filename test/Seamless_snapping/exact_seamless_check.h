// An exact check of a uv map, in rational arithmetic and sharing no code with the package: which
// edges are exact, how far off the others are, which alignments hold, how the triangles are turned.
//
// A corner is a halfedge h: the vertex target(h) seen from face(h).

#ifndef SEAMLESS_SNAPPING_TEST_EXACT_SEAMLESS_CHECK_H
#define SEAMLESS_SNAPPING_TEST_EXACT_SEAMLESS_CHECK_H

#include "exact_reference.h"

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

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

// Rational numbers take most of the time of some tests. They decide only if floating point numbers
// do not: those have three roundings in each product, and one in the difference.
template <typename Point>
int exact_orientation(const Point& a, const Point& b, const Point& c)
{
  using Real = long double;
  const Real ax(a.x()), ay(a.y());
  const Real first = (b.x() - ax) * (c.y() - ay), second = (b.y() - ay) * (c.x() - ax);
  const Real bound = 1e-15L * (std::abs(first) + std::abs(second));
  if(bound > 1e-200L && std::abs(first - second) > bound)
    return first > second ? 1 : -1;
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

} // namespace exact_check

#endif // SEAMLESS_SNAPPING_TEST_EXACT_SEAMLESS_CHECK_H
