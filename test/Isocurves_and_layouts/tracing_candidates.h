// Connections and cycles that may be asked for on a parametrization: random isocurves that nearly
// meet a vertex, or nearly close. Snapping with these as constraints makes them exact.

#ifndef SEAMLESS_SNAPPING_TEST_TRACING_CANDIDATES_H
#define SEAMLESS_SNAPPING_TEST_TRACING_CANDIDATES_H

#include "tracing_checks.h"

#include <CGAL/Isocurves_and_layouts/isocurve_constraints.h>
#include <CGAL/Isocurves_and_layouts/trace_isocurve.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace tracing_checks {

using Random = std::mt19937_64;

// A curve, and a corner that it meets at its end or passes by at a small distance.
struct Near_pass
{
  Curve curve; // no longer than up to there
  Mesh::Halfedge_index corner;
};

// The component that is constant along curves of a direction.
inline int constant_component(const Direction direction) { return int(direction) % 2 == 0 ? 1 : 0; }

// The first place where a curve passes by a corner for which is_wanted(corner, direction of the
// curve in its chart) holds, closer than `near`. There the curve gets the status, and ends.
template <typename IsWanted>
bool find_near_pass(const Curve& curve,
                    const Mesh& mesh,
                    const UV_map& uv,
                    const double distance,
                    const Status status,
                    const IsWanted& is_wanted,
                    Near_pass& result)
{
  const auto& points = curve.points;
  for(std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto& behind = points[i + 1];
    if(points[i].place() != Place::EDGE || behind.place() != Place::EDGE)
      continue;
    const auto apex = next(opposite(points[i].halfedge(), mesh), mesh);
    const auto p = get(uv, apex);
    const double coordinate = constant_component(behind.direction()) == 0 ? p.x() : p.y();
    if(std::abs(coordinate - behind.approximate_constant_coordinate()) <= distance &&
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
inline bool is_clear(const Curve& curve, const Mesh& mesh, const UV_map& uv, const double distance,
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
         std::abs((c == 0 ? get(uv, h).x() : get(uv, h).y()) - level) <= distance)
        return false;
    }
  }
  return true;
}

// Noise that opens the seams. Corners of a vertex that have the same coordinates move together.
inline void disturb(const Mesh& mesh, const UV_map& uv, const double size, Random& random)
{
  using Point = Kernel::Point_2;
  for(const auto v : vertices(mesh)) {
    std::map<std::pair<double, double>, Point> moved;
    if(mesh.is_isolated(v))
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

// Curves are followed for so many crossings; as a candidate, a curve may pass by at this part of an
// edge's length; noise is smaller than the clearance by far.
constexpr std::size_t maximum_number = 1000;
constexpr double near_distance = 0.05;
constexpr double clearance = 1e-4;
constexpr double noise = 1e-10; // of the extent

struct Model
{
  Mesh mesh;
  UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  std::vector<Vertex> ends; // of connections: singular vertices, or any if there are none
  std::vector<char> is_end; // per vertex
  double edge_length = 0;   // in the domain, on average
  double extent = 0;

  bool is_unfolded(const Vertex v) const
  { return tracing_checks::is_unfolded(mesh, uv, mesh.halfedge(v)); }
};

inline bool read(const std::filesystem::path& path, Model& model)
{
  const Mesh& mesh = model.mesh;
  if(!CHECK(IL::IO::read_OBJ(path.string(), model.mesh, model.uv)) ||
     !CHECK(IL::snap_to_seamless(mesh, model.uv)))
    return false;
  const Tracer tracer(mesh, model.uv);
  std::vector<Vertex> regular;
  for(const Vertex v : mesh.vertices())
    if(!mesh.is_isolated(v) && !CGAL::is_border(v, mesh))
      (tracer.is_singular(v) ? model.ends : regular).push_back(v);
  if(model.ends.size() < 2)
    for(std::size_t i = 0; i < 40; ++i)
      model.ends.push_back(regular[i * regular.size() / 40]);
  model.is_end.assign(mesh.num_vertices(), false);
  for(const Vertex v : model.ends)
    model.is_end[v] = true;
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(h))
      model.edge_length += std::sqrt(CGAL::squared_distance(model.uv[h], model.uv[mesh.prev(h)])) /
                           double(mesh.number_of_halfedges());
  model.extent = IL::seam_transitions(mesh, model.uv).extent();
  return true;
}

// Vertices on whose side it depends how a curve goes on.
inline std::vector<char> critical_vertices(const Model& model, const Tracer& tracer)
{
  std::vector<char> result(model.mesh.num_vertices(), false);
  for(const Vertex v : model.mesh.vertices())
    if(!model.mesh.is_isolated(v))
      result[v] = tracer.is_singular(v) || CGAL::is_border(v, model.mesh) || !model.is_unfolded(v);
  return result;
}

struct Connections
{
  using Constraint = IL::Connection_constraint<Mesh>;
  static constexpr Status expected = Status::TARGET, failure = Status::MISSED_TARGET;

  static auto as_parameter(const std::vector<Constraint>& constraints)
  { return parameters::connection_constraints(constraints); }

  static Constraint constraint(const Curve& curve, const Mesh& mesh)
  { return IL::connection_along_isocurve(mesh, curve); }

  static Vertex target(const Near_pass& pass, const Mesh& mesh) { return mesh.target(pass.corner); }

  // A curve from a random end that meets or nearly meets another one.
  static bool
  find_candidate(const Model& model, const Tracer& tracer, Random& random, Near_pass& pass)
  {
    const Mesh& mesh = model.mesh;
    const Vertex v = model.ends[random() % model.ends.size()];
    const auto outgoing = tracer.outgoing(v);
    if(outgoing.empty())
      return false;
    const auto& [start, direction] = outgoing[random() % outgoing.size()];
    const Curve curve = tracer.trace(start, direction, parameters::maximum_number(maximum_number));
    if(find_near_pass(curve, mesh, model.uv, near_distance * model.edge_length, failure,
                      [&](const auto h, Direction)
                      { return mesh.target(h) != v && model.is_end[mesh.target(h)]; }, pass))
      return true;
    pass = {curve, curve.points.back().halfedge()};
    return curve.status == Status::SINGULAR_VERTEX && model.is_end[mesh.target(pass.corner)];
  }
};

struct Cycles
{
  using Constraint = IL::Cycle_constraint<Mesh>;
  static constexpr Status expected = Status::CLOSED, failure = Status::SPIRALS;

  static auto as_parameter(const std::vector<Constraint>& constraints)
  { return parameters::cycle_constraints(constraints); }

  static Constraint constraint(const Curve& curve, const Mesh& mesh)
  { return IL::cycle_along_isocurve(mesh, curve); }

  static Vertex target(const Near_pass&, const Mesh&) { return Mesh::null_vertex(); }

  // A random curve that crosses an edge twice, at about the same place: a curve from an end of this
  // edge may return to it.
  static bool
  find_candidate(const Model& model, const Tracer& tracer, Random& random, Near_pass& pass)
  {
    const Mesh& mesh = model.mesh;
    const Vertex v(Mesh::size_type(random() % mesh.number_of_vertices()));
    const auto outgoing = tracer.outgoing(v);
    if(outgoing.empty())
      return false;
    const auto& [start, direction] = outgoing[random() % outgoing.size()];
    const Curve curve = tracer.trace(start, direction, parameters::maximum_number(maximum_number));
    std::map<std::pair<Mesh::Halfedge_index, Direction>, double> levels;
    for(const auto& point : curve.points) {
      const double level = point.approximate_constant_coordinate();
      const auto [first, is_new] = levels.insert({{point.halfedge(), point.direction()}, level});
      if(!is_new && point.place() == Place::EDGE &&
         std::abs(first->second - level) <= near_distance * model.edge_length)
        return find_return(model, tracer, point.halfedge(), point.direction(), pass);
    }
    return curve.status == Status::CLOSED &&
           find_return(model, tracer, start.halfedge, direction, pass);
  }

  // Whether the curve from the target of `h` returns to it.
  static bool find_return(const Model& model, const Tracer& tracer, const Mesh::Halfedge_index h,
                          const Direction direction, Near_pass& pass)
  {
    const Mesh& mesh = model.mesh;
    const Vertex v = mesh.target(h);
    if(tracer.is_singular(v) || CGAL::is_border(v, mesh) || !model.is_unfolded(v))
      return false;
    const auto seams = IL::seam_transitions(mesh, model.uv);
    const auto leads_back = [&](Mesh::Halfedge_index g, const Direction d) {
      int turns = int(d);
      if(mesh.target(g) != v)
        return false;
      for(; g != h; g = mesh.prev(mesh.opposite(g)))
        turns += seams.rotation(g);
      return turns % 4 == int(direction);
    };
    const Curve curve = tracer.trace(Start::at_vertex(h), direction,
                                     parameters::maximum_number(maximum_number));
    pass = {curve, curve.points.back().halfedge()};
    return curve.status == Status::CLOSED ||
           find_near_pass(curve, mesh, model.uv, near_distance * model.edge_length, failure,
                          leads_back, pass);
  }
};

} // namespace tracing_checks

#endif // SEAMLESS_SNAPPING_TEST_TRACING_CANDIDATES_H
