// What the tests of the surface function share: what is known about a test mesh before its uv map
// is disturbed, and the checks that every snapped uv map must pass.

#ifndef SEAMLESS_SNAPPING_TEST_SURFACE_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_SURFACE_CHECKS_H

#include "checking.h"
#include "exact_seamless_check.h"
#include "test_meshes.h"
#include "uv_noise.h"

#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace surface_checks {

namespace SS = CGAL::Seamless_snapping;

using Kernel = CGAL::Simple_cartesian<double>;
using Float_kernel = CGAL::Simple_cartesian<float>;

using Bits = std::vector<std::uint64_t>;

// The bits of a double; of a float, those of the double of the same value.
inline std::uint64_t bits(double x)
{
  std::uint64_t result;
  std::memcpy(&result, &x, sizeof(double));
  return result;
}

// The coordinates of all halfedges, those on the border included.
template <typename Graph, typename UVMap>
Bits all_bits(const Graph& g, const UVMap& uv)
{
  Bits result;
  for(const auto h : halfedges(g)) {
    const auto p = get(uv, h);
    result.push_back(bits(p.x()));
    result.push_back(bits(p.y()));
  }
  return result;
}

template <typename Graph>
bool is_interior(const Graph& g, typename boost::graph_traits<Graph>::halfedge_descriptor h)
{
  return !is_border(h, g) && !is_border(opposite(h, g), g);
}

// The larger side of the bounding box.
template <typename Graph, typename UVMap>
double extent(const Graph& g, const UVMap& uv)
{
  const double infinity = std::numeric_limits<double>::infinity();
  double low[2] = { infinity, infinity }, high[2] = { -infinity, -infinity };
  for(const auto h : halfedges(g)) {
    if(is_border(h, g))
      continue;
    const double p[2] = { double(get(uv, h).x()), double(get(uv, h).y()) };
    for(int c = 0; c < 2; ++c) {
      low[c] = (std::min)(low[c], p[c]);
      high[c] = (std::max)(high[c], p[c]);
    }
  }
  return (std::max)(high[0] - low[0], high[1] - low[1]);
}

// What is known of an exactly seamless map without flips: cuts, rotations, and the index of every
// inner vertex, from its angles.
template <typename Graph, typename UVMap>
class Truth
{
  using Halfedge = typename boost::graph_traits<Graph>::halfedge_descriptor;
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;

public:
  Truth(const Graph& g, const UVMap& uv)
    : m_g(g)
    , m_cuts(g, uv)
    , extent(surface_checks::extent(g, uv))
  {
    for(const auto h : halfedges(g)) {
      if(is_cut(h) && m_cuts.rotation(h) == 0)
        smallest_translation = (std::min)(smallest_translation, translation(h, uv));
      is_closed = is_closed && !is_border(h, g);
    }
    for(const auto v : vertices(g))
      if(!CGAL::is_border(v, g))
        add_index(v, uv);
  }

  bool is_cut(Halfedge h) const { return is_interior(m_g, h) && !m_cuts.is_passable(h); }
  int rotation(Halfedge h) const { return m_cuts.rotation(h); }
  const std::map<Vertex, int>& indices() const { return m_indices; } // other than 0

  // Noise of this size leaves no doubt about what is a cut.
  bool is_clear_with(double noise) const { return smallest_translation > 300 * noise; }

private:
  double translation(Halfedge h, const UVMap& uv) const
  {
    const auto a = get(uv, h), b = get(uv, prev(opposite(h, m_g), m_g));
    return (std::max)(std::abs(double(a.x()) - double(b.x())),
                      std::abs(double(a.y()) - double(b.y())));
  }

  void add_index(Vertex v, const UVMap& uv)
  {
    double angles = 0;
    for(const auto h : CGAL::halfedges_around_target(v, m_g)) {
      const auto p = get(uv, h), q = get(uv, next(h, m_g)), r = get(uv, prev(h, m_g));
      const double a[2] = { double(q.x()) - double(p.x()), double(q.y()) - double(p.y()) };
      const double b[2] = { double(r.x()) - double(p.x()), double(r.y()) - double(p.y()) };
      angles += std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
    }
    const int index = 4 - static_cast<int>(std::lround(angles / std::acos(0.)));
    if(index != 0)
      m_indices[v] = index;
  }

  const Graph& m_g;
  uv_noise::Cuts<Graph, UVMap> m_cuts;
  std::map<Vertex, int> m_indices;

public:
  double extent;
  double smallest_translation = std::numeric_limits<double>::infinity();
  bool is_closed = true;
};

// What seam_transitions() says against what is known. Around edges of no length the angles, and
// with them the numbers of full turns, are anyone's guess.
template <typename Graph, typename UVMap>
void check_transitions(const Graph& g, const Truth<Graph, UVMap>& truth,
                       const SS::Seam_transitions<Graph>& transitions, const std::string& context,
                       bool has_angles = true)
{
  CHECK_IN(context, bool(transitions));
  std::size_t wrong_cuts = 0, wrong_rotations = 0, cuts = 0;
  for(const auto h : halfedges(g)) {
    cuts += truth.is_cut(h) ? 1 : 0;
    wrong_cuts += transitions.is_cut(h) != truth.is_cut(h) ? 1 : 0;
    wrong_rotations += transitions.rotation(h) != truth.rotation(h) ? 1 : 0;
  }
  CHECK_IN(context, wrong_cuts == 0);
  CHECK_IN(context, wrong_rotations == 0);
  CHECK_IN(context, 2 * transitions.cut_halfedges().size() == cuts);

  // vertices where the angles are off by full turns have no holonomy
  std::map<typename boost::graph_traits<Graph>::vertex_descriptor, int> expected, found;
  const auto modulo = [&](int index) { return has_angles ? index : ((index % 4) + 4) % 4; };
  for(const auto& singular : truth.indices())
    if(singular.second % 4 != 0)
      expected[singular.first] = modulo(singular.second);
  for(const auto& singular : transitions.singular_vertices())
    if(singular.second % 4 != 0)
      found[singular.first] = modulo(singular.second);
  CHECK_IN(context, expected == found);
}

// Poincare and Hopf, for the test meshes themselves as much as for what is compared with them.
template <typename Graph, typename UVMap>
void check_sum_of_indices(const Graph& g, const Truth<Graph, UVMap>& truth,
                          const std::string& context)
{
  if(!truth.is_closed)
    return;
  const long chi = long(num_vertices(g)) - long(num_edges(g)) + long(num_faces(g));
  long sum = 0;
  for(const auto& singular : truth.indices())
    sum += singular.second;
  CHECK_IN(context, sum == 4 * chi);
}

// Eq. (5) is asked of feature edges and, perhaps, of the border.
template <typename Graph, typename FeatureMap>
struct Is_aligned
{
  const Graph& g;
  FeatureMap features;
  bool align_border;

  template <typename Edge>
  bool operator()(const Edge& e) const
  {
    return get(features, e) || (align_border && CGAL::is_border_edge(halfedge(e, g), g));
  }
};

template <typename Graph, typename FeatureMap>
Is_aligned<Graph, FeatureMap> is_aligned(const Graph& g, const FeatureMap& features,
                                         bool align_border)
{
  return { g, features, align_border };
}

// The number of edges that are no cut, but whose sides are not the same to the bit.
template <typename Graph, typename UVMap>
std::size_t edges_that_gape(const Graph& g, const UVMap& uv, const Truth<Graph, UVMap>& truth)
{
  const auto differ = [&](const auto a, const auto b) {
    const auto p = get(uv, a), q = get(uv, b);
    return bits(p.x()) != bits(q.x()) || bits(p.y()) != bits(q.y());
  };
  std::size_t result = 0;
  for(const auto h : halfedges(g))
    if(is_interior(g, h) && !truth.is_cut(h) && differ(h, prev(opposite(h, g), g)))
      ++result;
  return result;
}

inline double largest_difference(const Bits& a, const Bits& b)
{
  double result = 0;
  for(std::size_t i = 0; i < a.size(); ++i) {
    double x, y;
    std::memcpy(&x, &a[i], sizeof(double));
    std::memcpy(&y, &b[i], sizeof(double));
    result = (std::max)(result, std::abs(x - y));
  }
  return result;
}

template <typename K>
struct Snapped
{
  SS::Snapping_report report;
  Bits before, after;
};

// Snaps, and checks by exact arithmetic of its own that the result is seamless and aligned, that
// the library thinks so too, that a second run finds nothing to do, and what the report says.
template <typename K>
Snapped<K> snap_and_check(test_meshes::Named_mesh<K>& named, const std::string& context)
{
  auto& mesh = named.mesh;
  const auto uv = test_meshes::uv_map(mesh);
  const auto features = test_meshes::feature_map(mesh);
  const auto np =
    SS::parameters::edge_is_constrained_map(features).align_border(named.align_border);

  Snapped<K> result;
  result.before = all_bits(mesh, uv);
  const bool was_exact =
    exact_check::check_edges(mesh, uv, is_aligned(mesh, features, named.align_border)).is_exact();
  result.report = SS::snap_to_seamless(mesh, uv, np);
  result.after = all_bits(mesh, uv);

  CHECK_IN(context + ": " + result.report.message, bool(result.report));
  CHECK_IN(context, exact_check::check_edges(mesh, uv,
                                             is_aligned(mesh, features, named.align_border))
                      .is_exact());
  CHECK_IN(context, SS::is_seamless(mesh, uv, np));
  CHECK_IN(context, SS::measure_seamlessness(mesh, uv, np).is_exact());
  const bool merges = result.report.run.number_of_merged_edges > 0;
  CHECK_IN(context, (result.report.status == SS::Outcome::ALREADY_EXACT)
                      == (was_exact && !merges));
  CHECK_IN(context, result.report.status == SS::Outcome::SNAPPED
                      || result.before == result.after);
  const double change = largest_difference(result.before, result.after);
  CHECK_IN(context, std::abs(result.report.largest_change - change) <= 1e-12 * change);

  CHECK_IN(context, SS::snap_to_seamless(mesh, uv, np).status
                      == SS::Outcome::ALREADY_EXACT);
  CHECK_IN(context, all_bits(mesh, uv) == result.after);
  return result;
}

} // namespace surface_checks

#endif // SEAMLESS_SNAPPING_TEST_SURFACE_CHECKS_H
