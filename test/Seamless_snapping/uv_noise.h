// Changes exactly seamless uv maps: warp() makes the coordinates generic and keeps every transition
// exact; perturb() adds noise that breaks them. Deterministic by seed on every platform.

#ifndef SEAMLESS_SNAPPING_TEST_UV_NOISE_H
#define SEAMLESS_SNAPPING_TEST_UV_NOISE_H

#include "Square_complex.h"

#include <CGAL/Kernel_traits.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace uv_noise {

// In [-1,1); the same on every platform, unlike std::uniform_real_distribution.
inline double symmetric_random(std::mt19937_64& random)
{
  return static_cast<double>(static_cast<std::int64_t>(random())) * 0x1p-63;
}

// Quarter turns of the transition across each halfedge h, from face(h) to the opposite face; -1: no
// cut. Kept per halfedge, since halfedge(edge(h)) is h for either halfedge of a Surface_mesh. For
// exactly seamless maps of few significant bits only, whose differences are exact.
template <typename Graph, typename UVMap>
class Cuts
{
  using Halfedge = typename boost::graph_traits<Graph>::halfedge_descriptor;
  using Rotation_map =
    typename boost::property_map<Graph, CGAL::dynamic_halfedge_property_t<signed char> >::type;

public:
  Cuts(const Graph& g, const UVMap& uv)
    : m_g(g)
    , m_rotation(get(CGAL::dynamic_halfedge_property_t<signed char>(), const_cast<Graph&>(g)))
  {
    for(const auto e : edges(g)) {
      const Halfedge h = halfedge(e, g), o = opposite(h, g);
      const bool is_cut = !is_border(h, g) && !is_border(o, g)
                          && (get(uv, h) != get(uv, prev(o, g))
                              || get(uv, prev(h, g)) != get(uv, o));
      const int k = is_cut ? quarter_turns(h, uv) : -1;
      put(m_rotation, h, static_cast<signed char>(k));
      put(m_rotation, o, static_cast<signed char>(is_cut ? (4 - k) % 4 : -1));
    }
  }

  // Neither a cut nor the border.
  bool is_passable(Halfedge h) const
  {
    return !is_border(h, m_g) && !is_border(opposite(h, m_g), m_g)
           && get(m_rotation, h) < 0;
  }

  int rotation(Halfedge h) const { return (std::max)(0, int(get(m_rotation, h))); }

private:
  int quarter_turns(Halfedge h, const UVMap& uv) const
  {
    const Halfedge o = opposite(h, m_g);
    const auto here = difference(get(uv, h), get(uv, prev(h, m_g)));
    const auto there = difference(get(uv, prev(o, m_g)), get(uv, o));
    for(int k = 0; k < 4; ++k)
      if(square_complex::rotated(here, k) == there)
        return k;
    CGAL_error_msg("the uv map is not exactly seamless");
    return -1;
  }

  template <typename Point>
  static square_complex::Vector_2 difference(const Point& a, const Point& b)
  {
    return { { double(a.x()) - double(b.x()), double(a.y()) - double(b.y()) } };
  }

  const Graph& m_g;
  Rotation_map m_rotation;
};

// The halfedges around target(h) in turn, each followed by the one across the edge of its next().
// The first one comes right after the border, or else starts a sector if there is a cut.
template <typename Graph, typename UVMap>
void corners_in_turn(typename boost::graph_traits<Graph>::halfedge_descriptor h, const Graph& g,
                     const Cuts<Graph, UVMap>& cuts,
                     std::vector<typename boost::graph_traits<Graph>::halfedge_descriptor>& result)
{
  result.clear();
  auto corner = h;
  do {
    result.push_back(corner);
    corner = opposite(next(corner, g), g);
  } while(corner != h);

  const auto follows_border = [&](const auto& c) {
    return !is_border(c, g) && is_border(opposite(c, g), g);
  };
  auto first = std::find_if(result.begin(), result.end(), follows_border);
  if(first == result.end())
    first = std::find_if(result.begin(), result.end(),
                         [&](const auto& c) { return !cuts.is_passable(c); });
  if(first != result.end())
    std::rotate(result.begin(), first, result.end());
}

template <typename Point>
Point moved(const Point& p, const square_complex::Vector_2& by)
{
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  return Point(FT(double(p.x()) + by[0]), FT(double(p.y()) + by[1]));
}

enum class Noise {
  per_sector, // corners that no cut separates move together
  per_corner  // every corner moves by itself, so that edges without a cut come apart too
};

// Moves every coordinate by up to `size`. The map must be exactly seamless as yet.
template <typename Graph, typename UVMap>
void perturb(const Graph& g, UVMap uv, double size, unsigned int seed,
             Noise noise = Noise::per_sector)
{
  const Cuts<Graph, UVMap> cuts(g, uv);
  std::mt19937_64 random(seed);
  std::vector<typename boost::graph_traits<Graph>::halfedge_descriptor> corners;
  for(const auto v : vertices(g)) {
    corners_in_turn(halfedge(v, g), g, cuts, corners);
    square_complex::Vector_2 move = { { 0, 0 } };
    for(std::size_t i = 0; i < corners.size(); ++i) {
      if(is_border(corners[i], g))
        continue;
      if(i == 0 || noise == Noise::per_corner || !cuts.is_passable(corners[i])) {
        move[0] = size * symmetric_random(random);
        move[1] = size * symmetric_random(random);
      }
      put(uv, corners[i], moved(get(uv, corners[i]), move));
    }
  }
}

// Moves every vertex that is no cone, and for which is_fixed(v) doesn't hold, by multiples of
// `size`/8 up to `size`, alike in all charts that see it. Take a power of two.
template <typename Graph, typename UVMap, typename IsFixed>
void warp(const Graph& g, UVMap uv, double size, unsigned int seed, const IsFixed& is_fixed)
{
  using Vector_2 = square_complex::Vector_2;
  const Cuts<Graph, UVMap> cuts(g, uv);
  std::mt19937_64 random(seed);
  std::vector<typename boost::graph_traits<Graph>::halfedge_descriptor> corners;
  for(const auto v : vertices(g)) {
    if(is_fixed(v))
      continue;
    corners_in_turn(halfedge(v, g), g, cuts, corners);
    const Vector_2 start = { { size * double(int(random() % 17) - 8) / 8,
                               size * double(int(random() % 17) - 8) / 8 } };
    std::vector<Vector_2> moves(1, start);
    for(const auto corner : corners) { // what the next corner sees
      const auto across = next(corner, g);
      const bool passes = !is_border(corner, g) && !is_border(opposite(across, g), g);
      moves.push_back(passes ? square_complex::rotated(moves.back(), cuts.rotation(across))
                             : start);
    }
    if(moves.back() != start)
      continue; // a cone
    for(std::size_t i = 0; i < corners.size(); ++i)
      if(!is_border(corners[i], g))
        put(uv, corners[i], moved(get(uv, corners[i]), moves[i]));
  }
}

} // namespace uv_noise

#endif // SEAMLESS_SNAPPING_TEST_UV_NOISE_H
