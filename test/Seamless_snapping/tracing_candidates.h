// Connections and cycles that may be asked for on a parametrization: random isocurves that nearly
// meet a vertex, or nearly close.

#ifndef SEAMLESS_SNAPPING_TEST_TRACING_CANDIDATES_H
#define SEAMLESS_SNAPPING_TEST_TRACING_CANDIDATES_H

#include "tracing_constraints.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/isocurve_constraints.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace tracing_checks {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Start = SS::Isocurve_start<Mesh>;
using Tracer = SS::Isocurve_tracer<Mesh>;
using Curve = SS::Isocurve<Mesh>;
using Pass = Near_pass<Mesh>;
using Random = std::mt19937_64;

// Curves are followed for so many crossings; as a candidate, a curve may pass by at this part of an
// edge's length; noise is smaller than the clearance by far.
constexpr std::size_t maximum_number = 1000;
constexpr double near = 0.05;
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
  if(!CHECK(SS::IO::read_OBJ(path.string(), model.mesh, model.uv)) ||
     !CHECK(SS::snap_to_seamless(mesh, model.uv)))
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
  model.extent = SS::seam_transitions(mesh, model.uv).extent();
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
  using Constraint = SS::Connection_constraint<Mesh>;
  static constexpr Status expected = Status::TARGET, failure = Status::MISSED_TARGET;

  static auto as_parameter(const std::vector<Constraint>& constraints)
  { return parameters::connection_constraints(constraints); }

  static Constraint constraint(const Curve& curve, const Mesh& mesh)
  { return SS::connection_along_isocurve(mesh, curve); }

  static Vertex target(const Pass& pass, const Mesh& mesh) { return mesh.target(pass.corner); }

  // A curve from a random end that meets or nearly meets another one.
  static bool find_candidate(const Model& model, const Tracer& tracer, Random& random, Pass& pass)
  {
    const Mesh& mesh = model.mesh;
    const Vertex v = model.ends[random() % model.ends.size()];
    const auto outgoing = tracer.outgoing(v);
    if(outgoing.empty())
      return false;
    const auto& [start, direction] = outgoing[random() % outgoing.size()];
    const Curve curve = tracer.trace(start, direction, parameters::maximum_number(maximum_number));
    if(find_near_pass(curve, mesh, model.uv, near * model.edge_length, failure,
                      [&](const auto h, Direction)
                      { return mesh.target(h) != v && model.is_end[mesh.target(h)]; }, pass))
      return true;
    pass = {curve, curve.points.back().halfedge()};
    return curve.status == Status::SINGULAR_VERTEX && model.is_end[mesh.target(pass.corner)];
  }
};

struct Cycles
{
  using Constraint = SS::Cycle_constraint<Mesh>;
  static constexpr Status expected = Status::CLOSED, failure = Status::SPIRALS;

  static auto as_parameter(const std::vector<Constraint>& constraints)
  { return parameters::cycle_constraints(constraints); }

  static Constraint constraint(const Curve& curve, const Mesh& mesh)
  { return SS::cycle_along_isocurve(mesh, curve); }

  static Vertex target(const Pass&, const Mesh&) { return Mesh::null_vertex(); }

  // A random curve that crosses an edge twice, at about the same place: a curve from an end of this
  // edge may return to it.
  static bool find_candidate(const Model& model, const Tracer& tracer, Random& random, Pass& pass)
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
         std::abs(first->second - level) <= near * model.edge_length)
        return find_return(model, tracer, point.halfedge(), point.direction(), pass);
    }
    return curve.status == Status::CLOSED &&
           find_return(model, tracer, start.halfedge, direction, pass);
  }

  // Whether the curve from the target of `h` returns to it.
  static bool find_return(const Model& model, const Tracer& tracer, const Mesh::Halfedge_index h,
                          const Direction direction, Pass& pass)
  {
    const Mesh& mesh = model.mesh;
    const Vertex v = mesh.target(h);
    if(tracer.is_singular(v) || CGAL::is_border(v, mesh) || !model.is_unfolded(v))
      return false;
    const auto seams = SS::seam_transitions(mesh, model.uv);
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
           find_near_pass(curve, mesh, model.uv, near * model.edge_length, failure, leads_back,
                          pass);
  }
};

} // namespace tracing_checks

#endif // SEAMLESS_SNAPPING_TEST_TRACING_CANDIDATES_H
