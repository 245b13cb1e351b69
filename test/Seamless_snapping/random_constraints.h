// Random connections between singular vertices and random cycles, Eqs. (6) and (8), and an exact
// check of them that composes the transitions along their paths in rational arithmetic and shares
// no code with the package.

#ifndef SEAMLESS_SNAPPING_TEST_RANDOM_CONSTRAINTS_H
#define SEAMLESS_SNAPPING_TEST_RANDOM_CONSTRAINTS_H

#include "exact_seamless_check.h"

#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/types/surface_constraints.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace random_constraints {

namespace CS = CGAL::Seamless_snapping;

template <typename Graph>
class Generator
{
  using Halfedge = typename boost::graph_traits<Graph>::halfedge_descriptor;

public:
  // Connections end in singular vertices, if there are any.
  Generator(const Graph& g, const CS::Seam_transitions<Graph>& transitions, std::uint64_t seed)
    : m_graph(g), m_random(seed)
  {
    for(const auto f : faces(g))
      m_corners.push_back(halfedge(f, g));
    for(const auto& vertex : transitions.singular_vertices())
      m_nodes.push_back(halfedge(vertex.first, g));
    if(m_nodes.empty())
      m_nodes = m_corners;
  }

  CS::Connection_constraint<Graph> connection()
  {
    const Halfedge a = any_of(m_nodes), b = any_of(m_nodes);
    return { a, b, component(), CS::shortest_face_path(m_graph, a, b) };
  }

  // Through two random faces and back.
  CS::Cycle_constraint<Graph> cycle()
  {
    const Halfedge stops[3] = { any_of(m_corners), any_of(m_corners), any_of(m_corners) };
    CS::Cycle_constraint<Graph> result{ stops[0], component(), {} };
    for(int i = 0; i < 3; ++i) {
      const auto part = CS::shortest_face_path(m_graph, stops[i], stops[(i + 1) % 3]);
      result.path.insert(result.path.end(), part.begin(), part.end());
    }
    return result;
  }

  std::vector<CS::Connection_constraint<Graph> > connections(std::size_t count)
  {
    std::vector<CS::Connection_constraint<Graph> > result;
    while(result.size() < count)
      result.push_back(connection());
    return result;
  }

  std::vector<CS::Cycle_constraint<Graph> > cycles(std::size_t count)
  {
    std::vector<CS::Cycle_constraint<Graph> > result;
    while(result.size() < count)
      result.push_back(cycle());
    return result;
  }

private:
  Halfedge any_of(const std::vector<Halfedge>& halfedges)
  {
    return halfedges[std::size_t(m_random() % halfedges.size())];
  }

  int component() { return int(m_random() % 2); }

  const Graph& m_graph;
  std::mt19937_64 m_random;
  std::vector<Halfedge> m_corners, m_nodes;
};

// --- the exact check -----------------------------------------------------------------------------

using exact_check::Exact_vector;
using exact_reference::Rational;

// u and a direction in the chart of face(h), brought to the chart of the opposite face by k quarter
// turns. False if the transition isn't exact.
template <typename Graph, typename UVMap>
bool cross(typename boost::graph_traits<Graph>::halfedge_descriptor h, const Graph& g,
           const UVMap& uv, int k, Exact_vector& u, Exact_vector& direction)
{
  const auto o = opposite(h, g);
  const auto from = get(uv, prev(h, g)), to = get(uv, o);
  if(k == 0 && from == to && get(uv, h) == get(uv, prev(o, g)))
    return true;
  Exact_vector relative = { Rational(u[0] - Rational(from.x())),
                            Rational(u[1] - Rational(from.y())) };
  relative = exact_check::rotated(relative, k);
  u = { Rational(Rational(to.x()) + relative[0]), Rational(Rational(to.y()) + relative[1]) };
  direction = exact_check::rotated(direction, k);
  return exact_check::violation(exact_check::two_sides(h, g, uv), k) == 0;
}

// The transitions are those from before anything was moved: edges of no length don't tell.
template <typename Graph, typename UVMap>
bool is_connected(const Graph& g, const UVMap& uv, const CS::Seam_transitions<Graph>& transitions,
                  const CS::Connection_constraint<Graph>& c)
{
  Exact_vector u = { Rational(get(uv, c.a).x()), Rational(get(uv, c.a).y()) };
  // the direction across the isocurve tells which component stays the same
  Exact_vector across = { Rational(c.component == 0 ? 1 : 0), Rational(c.component == 0 ? 0 : 1) };
  for(const auto h : c.path)
    if(!cross(h, g, uv, transitions.rotation(h), u, across))
      return false;
  const Rational x = across[0] * Rational(u[0] - Rational(get(uv, c.b).x()));
  const Rational y = across[1] * Rational(u[1] - Rational(get(uv, c.b).y()));
  return x + y == 0;
}

template <typename Graph, typename UVMap>
bool is_connected(const Graph& g, const UVMap& uv, const CS::Seam_transitions<Graph>& transitions,
                  const CS::Cycle_constraint<Graph>& c)
{
  return is_connected(g, uv, transitions, { c.corner, c.corner, c.component, c.path });
}

} // namespace random_constraints

#endif // SEAMLESS_SNAPPING_TEST_RANDOM_CONSTRAINTS_H
