// Makes faces of exactly seamless uv maps thin: what noise of their height then turns over. Cuts
// stay exact, since a vertex moves alike in all charts that see it.

#ifndef SEAMLESS_SNAPPING_TEST_SLIVERS_H
#define SEAMLESS_SNAPPING_TEST_SLIVERS_H

#include "exact_seamless_check.h"
#include "uv_noise.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace slivers {

using square_complex::Vector_2;

// Moves the target of `h` by `move`, as the chart of face(h) sees it. Returns false, with nothing
// done, at cones and where a face would not be positive any more.
template <typename Graph, typename UVMap>
bool move_vertex(const Graph& g, UVMap uv, const uv_noise::Cuts<Graph, UVMap>& cuts,
                 typename boost::graph_traits<Graph>::halfedge_descriptor h, const Vector_2& move)
{
  using Halfedge = typename boost::graph_traits<Graph>::halfedge_descriptor;
  using Point = typename boost::property_traits<UVMap>::value_type;
  std::vector<Halfedge> corners;
  uv_noise::corners_in_turn(h, g, cuts, corners);
  // rotations relative to the first corner, and that of h among them
  std::vector<int> turns(1, 0);
  int turn_of_h = 0;
  for(const Halfedge corner : corners) {
    if(corner == h)
      turn_of_h = turns.back();
    const Halfedge across = next(corner, g);
    const bool passes = !is_border(corner, g) && !is_border(opposite(across, g), g);
    turns.push_back(passes ? (turns.back() + cuts.rotation(across)) % 4 : 0);
  }
  if(turns.back() != 0)
    return false; // a cone
  std::vector<Point> before;
  bool positive = true;
  for(const Halfedge corner : corners)
    before.push_back(get(uv, corner));
  for(std::size_t i = 0; i < corners.size(); ++i)
    if(!is_border(corners[i], g))
      put(uv, corners[i],
          uv_noise::moved(before[i],
                          square_complex::rotated(move, (turns[i] + 4 - turn_of_h) % 4)));
  for(const Halfedge corner : corners)
    positive = positive && (is_border(corner, g)
                            || exact_check::face_orientation(face(corner, g), g, uv) > 0);
  for(std::size_t i = 0; i < corners.size() && !positive; ++i)
    put(uv, corners[i], before[i]);
  return positive;
}

// Moves the target of `h` towards the edge opposite to it in face(h), so that its height falls to
// about `height`, a power of two; by multiples of `height`, and only where `may_move(v, move)` says
// so.
template <typename Graph, typename UVMap, typename MayMove>
bool flatten(const Graph& g, UVMap uv, const uv_noise::Cuts<Graph, UVMap>& cuts,
             typename boost::graph_traits<Graph>::halfedge_descriptor h, double height,
             const MayMove& may_move)
{
  const auto p = get(uv, h), a = get(uv, next(h, g)), b = get(uv, prev(h, g));
  // to the foot of the altitude or, along an isocurve, as far as it leads
  const Vector_2 edge = { { double(b.x()) - double(a.x()), double(b.y()) - double(a.y()) } };
  const Vector_2 to_p = { { double(p.x()) - double(a.x()), double(p.y()) - double(a.y()) } };
  const double square = edge[0] * edge[0] + edge[1] * edge[1];
  const double along = (edge[0] * to_p[0] + edge[1] * to_p[1]) / square;
  Vector_2 move = { { along * edge[0] - to_p[0], along * edge[1] - to_p[1] } };
  const double length = std::sqrt(move[0] * move[0] + move[1] * move[1]);
  if(length <= 2 * height)
    return false;
  for(double& c : move)
    c = std::round(c * (1 - 1.5 * height / length) / height) * height;
  return may_move(target(h, g), move) && move_vertex(g, uv, cuts, h, move);
}

// Flattens some faces, about one in `rarity`. Returns how many.
template <typename Graph, typename UVMap, typename MayMove>
std::size_t make_slivers(const Graph& g, UVMap uv, double height, unsigned int rarity,
                         unsigned int seed, const MayMove& may_move)
{
  const uv_noise::Cuts<Graph, UVMap> cuts(g, uv);
  std::mt19937_64 random(seed);
  std::size_t result = 0;
  for(const auto h : halfedges(g))
    if(!is_border(h, g) && random() % (3 * rarity) == 0)
      result += flatten(g, uv, cuts, h, height, may_move) ? 1 : 0;
  return result;
}

} // namespace slivers

#endif // SEAMLESS_SNAPPING_TEST_SLIVERS_H
