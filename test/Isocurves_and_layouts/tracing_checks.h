// What the tests of isocurve tracing share: exact comparison of curves, and charts to disturb.

#ifndef SEAMLESS_SNAPPING_TEST_TRACING_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_TRACING_CHECKS_H

#include "checking.h"
#include "uv_noise.h"

#include <CGAL/Isocurves_and_layouts/trace_isocurve.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace tracing_checks {

namespace IL = CGAL::Isocurves_and_layouts;
namespace parameters = CGAL::Isocurves_and_layouts::parameters;

using Status = IL::Isocurve_status;
using Place = IL::Isocurve_place;
using Direction = IL::Isocurve_direction;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Start = IL::Isocurve_start<Mesh>;
using Curve = IL::Isocurve<Mesh>;
using Tracer = IL::Isocurve_tracer<Mesh>;
using CGAL::Exact_rational;

template <typename Graph>
using Halfedge = typename boost::graph_traits<Graph>::halfedge_descriptor;

// Where to start to take the way back.
template <typename Graph, typename UVMap>
IL::Isocurve_start<Graph> start_at(const IL::Isocurve_point<Graph>& point, const Graph& mesh,
                                  const UVMap& uv)
{
  if(point.place() == Place::VERTEX)
    return IL::Isocurve_start<Graph>::at_vertex(point.halfedge());
  if(point.place() == Place::FACE) {
    const auto u = IL::isocurve_uv(point, mesh, uv);
    return IL::Isocurve_start<Graph>::in_face(point.halfedge(), u[0], u[1]);
  }
  return IL::Isocurve_start<Graph>::on_edge(point.halfedge(),
                                            IL::isocurve_parameter(point, mesh, uv));
}

// Whether two points, passed in opposite directions, are the same: by exact parameters on the edge,
// which are computed in the charts of its two faces.
template <typename Graph, typename UVMap>
bool are_same(const IL::Isocurve_point<Graph>& a, const IL::Isocurve_point<Graph>& b,
              const Graph& mesh, const UVMap& uv)
{
  if(a.place() != b.place())
    return false;
  if(a.place() == Place::FACE)
    return a.halfedge() == b.halfedge() && a.constant_coordinate() == b.constant_coordinate();
  if(a.place() == Place::VERTEX)
    return target(a.halfedge(), mesh) == target(b.halfedge(), mesh);
  const auto s = IL::isocurve_parameter(a, mesh, uv);
  const auto t = IL::isocurve_parameter(b, mesh, uv);
  return (a.halfedge() == b.halfedge() && s == t) ||
         (a.halfedge() == opposite(b.halfedge(), mesh) && s == 1 - t);
}

// A curve that starts inside of an edge and runs along it.
template <typename Graph, typename UVMap>
bool starts_along_edge(const IL::Isocurve<Graph>& curve, const Graph& mesh, const UVMap& uv)
{
  if(curve.start.place != Place::EDGE)
    return false;
  const auto h = curve.start.halfedge;
  const auto a = get(uv, prev(h, mesh)), b = get(uv, h);
  if(int(curve.direction) > 3)
    return Exact_rational(a.x()) + Exact_rational(a.y()) ==
           Exact_rational(b.x()) + Exact_rational(b.y());
  return int(curve.direction) % 2 == 0 ? a.y() == b.y() : a.x() == b.x();
}

// Traces a curve back from its end, and compares it point by point with the first one.
template <int D, typename Graph, typename UVMap>
bool is_symmetric(const IL::Isocurve_tracer<Graph, D>& tracer, const IL::Isocurve<Graph>& curve,
                  const Graph& mesh, const UVMap& uv)
{
  const std::size_t n = curve.points.size();
  if(n < 2)
    return true;
  const auto& end = curve.points.back();
  const auto back = tracer.trace(start_at(end, mesh, uv), IL::reversed(end.direction()),
                                 parameters::maximum_number(n + 1));
  const bool is_first_seen = curve.status == Status::CLOSED ||
    (curve.start.place != Place::FACE && !starts_along_edge(curve, mesh, uv));
  const std::size_t first = is_first_seen ? 0 : 1;
  if(back.points.size() + first < n)
    return false;
  for(std::size_t i = first; i < n; ++i)
    if(!are_same(curve.points[i], back.points[n - 1 - i], mesh, uv))
      return false;
  return true;
}

// An end of exact tracing, but for the one that only degenerate faces bring about.
inline bool is_proper_end(const Status status)
{
  return !IL::is_failure(status) && status != Status::CONTINUES &&
         status != Status::CONSTANT_ON_FACE;
}

// Ends properly, and is the same backwards.
template <int D, typename Graph, typename UVMap>
bool is_good(const IL::Isocurve_tracer<Graph, D>& tracer, const IL::Isocurve<Graph>& curve,
             const Graph& mesh, const UVMap& uv)
{
  return is_proper_end(curve.status) && is_symmetric(tracer, curve, mesh, uv);
}

// Whether all faces around a vertex are oriented alike.
template <typename Graph, typename UVMap>
bool is_unfolded(const Graph& mesh, const UVMap& uv, const Halfedge<Graph> at)
{
  for(const auto h : CGAL::halfedges_around_target(at, mesh))
    if(!is_border(h, mesh) && CGAL::orientation(get(uv, prev(h, mesh)), get(uv, h),
                                                get(uv, next(h, mesh))) != CGAL::LEFT_TURN)
      return false;
  return true;
}

// How many curves ended in which way.
using Counts = std::map<Status, std::size_t>;

inline std::ostream& operator<<(std::ostream& os, const Counts& counts)
{
  const char* separator = "";
  for(const auto& entry : counts) {
    os << separator << entry.second << " " << entry.first;
    separator = ", ";
  }
  return os;
}

// Traces all curves from all vertices in floating point.
template <typename Graph, typename UVMap>
Counts naive_ends(const Graph& mesh, const UVMap& uv, const double tolerance)
{
  const IL::Isocurve_tracer<Graph> tracer(mesh, uv);
  Counts result;
  for(const auto v : vertices(mesh))
    for(const auto& [start, direction] : tracer.outgoing(v))
      ++result[tracer.trace(start, direction,
                            parameters::decide_exactly(false).near_distance(tolerance)).status];
  return result;
}

// Noise in all charts but that of the first face: the seams open, while its isocurves stay aligned.
template <typename Graph, typename UVMap>
void perturb_other_charts(Graph& mesh, UVMap uv, const double size, const unsigned int seed)
{
  using Face = typename boost::graph_traits<Graph>::face_descriptor;
  const uv_noise::Cuts<Graph, UVMap> cuts(mesh, uv);
  std::map<Halfedge<Graph>, typename boost::property_traits<UVMap>::value_type> kept;
  std::vector<Face> chart(1, *faces(mesh).begin());
  while(!chart.empty()) {
    const Face f = chart.back();
    chart.pop_back();
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh)) {
      kept.emplace(h, get(uv, h));
      if(cuts.is_passable(h) && kept.count(opposite(h, mesh)) == 0)
        chart.push_back(face(opposite(h, mesh), mesh));
    }
  }
  uv_noise::perturb(mesh, uv, size, seed);
  for(const auto& entry : kept)
    put(uv, entry.first, entry.second);
}

} // namespace tracing_checks

#endif // SEAMLESS_SNAPPING_TEST_TRACING_CHECKS_H
