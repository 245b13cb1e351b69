// Connections and cycles that a parametrization nearly has: isocurves that pass close by a vertex,
// or return close by their start. Snapping with these as constraints makes them exact.

#ifndef SEAMLESS_SNAPPING_TEST_TRACING_CONSTRAINTS_H
#define SEAMLESS_SNAPPING_TEST_TRACING_CONSTRAINTS_H

#include "tracing_checks.h"

#include <CGAL/Seamless_snapping/surface_constraints.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace tracing_checks {

// A curve, and a corner that it meets at its end or passes by at a small distance.
template <typename Mesh>
struct Near_pass
{
  SS::Isocurve<Mesh> curve; // no longer than up to there
  Halfedge<Mesh> corner{};
};

// The component that is constant along curves of a direction.
inline int constant_component(const Direction direction) { return int(direction) % 2 == 0 ? 1 : 0; }

// The first place where a curve passes by a corner for which is_wanted(corner, direction of the
// curve in its chart) holds, closer than `near`. There the curve gets the status, and ends.
template <typename Mesh, typename UVMap, typename IsWanted>
bool find_near_pass(const SS::Isocurve<Mesh>& curve, const Mesh& mesh, const UVMap& uv,
                    const double near, const Status status, const IsWanted& is_wanted,
                    Near_pass<Mesh>& result)
{
  const auto& points = curve.points;
  for(std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto& behind = points[i + 1];
    if(points[i].place() != Place::EDGE || behind.place() != Place::EDGE)
      continue;
    const auto apex = next(opposite(points[i].halfedge(), mesh), mesh);
    const auto p = get(uv, apex);
    const double coordinate = constant_component(behind.direction()) == 0 ? p.x() : p.y();
    if(std::abs(coordinate - behind.approximate_constant_coordinate()) <= near &&
       is_wanted(apex, behind.direction())) {
      result.corner = apex;
      result.curve = curve;
      result.curve.points.resize(i + 1);
      result.curve.status = status;
      return true;
    }
  }
  return false;
}

// Whether noise below `near` can't change on which side a curve passes a critical vertex: it meets
// none on its way, and comes near none that it doesn't meet.
template <typename Mesh, typename UVMap>
bool is_clear(const SS::Isocurve<Mesh>& curve, const Mesh& mesh, const UVMap& uv, const double near,
              const std::vector<char>& is_critical)
{
  const auto& points = curve.points;
  const auto is_met = [&](const std::size_t i, const auto v)
  { return points[i].place() == Place::VERTEX && target(points[i].halfedge(), mesh) == v; };
  for(std::size_t i = 1; i < points.size(); ++i) {
    const double level = points[i].approximate_constant_coordinate();
    const int c = constant_component(points[i].direction());
    if(i + 1 < points.size() && points[i].place() == Place::VERTEX &&
       is_critical[target(points[i].halfedge(), mesh)])
      return false;
    for(const auto h : CGAL::halfedges_around_face(points[i].halfedge(), mesh)) {
      const auto v = target(h, mesh);
      if(is_critical[v] && !is_met(i - 1, v) && !is_met(i, v) &&
         std::abs((c == 0 ? get(uv, h).x() : get(uv, h).y()) - level) <= near)
        return false;
    }
  }
  return true;
}

template <typename Mesh, typename UVMap>
bool is_unfolded(const Mesh& mesh, const UVMap& uv, const Halfedge<Mesh> at)
{
  for(const auto h : CGAL::halfedges_around_target(at, mesh))
    if(!is_border(h, mesh) && CGAL::orientation(get(uv, prev(h, mesh)), get(uv, h),
                                                get(uv, next(h, mesh))) != CGAL::LEFT_TURN)
      return false;
  return true;
}

// Noise that opens the seams. Corners of a vertex that have the same coordinates move together.
template <typename Mesh, typename UVMap>
void disturb(const Mesh& mesh, UVMap uv, const double size, std::mt19937_64& random)
{
  using Point = typename boost::property_traits<UVMap>::value_type;
  for(const auto v : vertices(mesh)) {
    std::map<std::pair<double, double>, Point> moved;
    if(halfedge(v, mesh) == boost::graph_traits<Mesh>::null_halfedge())
      continue;
    for(const auto h : CGAL::halfedges_around_target(halfedge(v, mesh), mesh)) {
      if(is_border(h, mesh))
        continue;
      const Point p = get(uv, h);
      const std::pair<double, double> key(p.x(), p.y());
      if(moved.count(key) == 0)
        moved.emplace(key, Point(p.x() + size * uv_noise::symmetric_random(random),
                                 p.y() + size * uv_noise::symmetric_random(random)));
      put(uv, h, moved.at(key));
    }
  }
}

} // namespace tracing_checks

#endif // SEAMLESS_SNAPPING_TEST_TRACING_CONSTRAINTS_H
