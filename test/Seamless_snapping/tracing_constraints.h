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
// curve in its chart) holds, closer than `near`. Everything behind it is removed from the curve.
template <typename Mesh, typename UVMap, typename IsWanted>
bool find_near_pass(const SS::Isocurve<Mesh>& curve, const Mesh& mesh, const UVMap& uv,
                    const double near, const IsWanted& is_wanted, Near_pass<Mesh>& result)
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
      result.curve.points.resize(i + 2);
      result.curve.status = Status::MAXIMUM_NUMBER;
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

// A curve from a vertex, on another map of the same mesh. Where it ran along an edge, it may now
// leave the vertex beside the corner where it did before.
template <typename Mesh>
std::pair<SS::Isocurve_start<Mesh>, Direction>
same_start(const SS::Isocurve_tracer<Mesh>& tracer, const Mesh& mesh,
           const SS::Seam_transitions<Mesh>& seams, const SS::Isocurve<Mesh>& curve)
{
  const auto h = curve.start.halfedge;
  const auto turned = [&](const auto across)
  { return Direction((int(curve.direction) + seams.rotation(across)) % 4); };
  std::map<Halfedge<Mesh>, Direction> near = {{h, curve.direction}};
  if(!is_border(opposite(h, mesh), mesh))
    near.emplace(prev(opposite(h, mesh), mesh), turned(h));
  if(!is_border(opposite(next(h, mesh), mesh), mesh))
    near.emplace(opposite(next(h, mesh), mesh), turned(next(h, mesh)));
  for(const auto& [start, direction] : tracer.outgoing(target(h, mesh))) {
    const auto found = near.find(start.halfedge);
    if(found != near.end() && found->second == direction)
      return {start, direction};
  }
  return {curve.start, curve.direction};
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
