// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_GIVEN_ON_MESH_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_GIVEN_ON_MESH_H

#include <CGAL/license/Seamless_snapping.h>

// The named parameters that describe a mesh: indices of vertices, known transitions, edges to
// align, and further constraints.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/mesh/Constraint_list.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_transitions.h>
#include <CGAL/Seamless_snapping/internal/transitions/chosen_options.h>
#include <CGAL/Seamless_snapping/types/surface_constraints.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
auto uv_surface(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map, const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, CGAL::internal_np::vertex_index_t>)
    // not by CGAL's function, which asserts what is a status here
    return Uv_surface(tmesh, uv_map,
                      CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_index), true);
  else
    return Uv_surface(tmesh, uv_map, CGAL::get_initialized_vertex_index_map(tmesh, np));
}

template <typename Group, typename TriangleMesh, typename NamedParameters>
auto given_transitions(const TriangleMesh& tmesh, const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  std::function<bool(Halfedge)> is_cut;
  std::function<int(Halfedge)> rotation;
  const auto edge_is_cut = get_parameter(np, CGAL::internal_np::edge_is_cut);
  if constexpr(is_given<decltype(edge_is_cut)>)
    is_cut = [edge_is_cut, &tmesh](const Halfedge h) -> bool
      { return get(edge_is_cut, edge(h, tmesh)); };
  const auto halfedge_rotation = get_parameter(np, CGAL::internal_np::halfedge_rotation);
  if constexpr(is_given<decltype(halfedge_rotation)>)
    rotation = [halfedge_rotation](const Halfedge h)
      { return static_cast<int>(get(halfedge_rotation, h) % Group::order); };
  return Given_transitions<Group, Halfedge>(order_of_symmetry<NamedParameters>, std::move(is_cut),
                                            std::move(rotation));
}

// The residual, relative to the extent, up to which a map counts as seamless by default.
constexpr double default_tolerance = 1e-4;

template <typename NamedParameters>
double chosen_tolerance(const NamedParameters& np)
{
  return chosen(np, CGAL::internal_np::tolerance, default_tolerance);
}

// The transitions, as the named parameters ask for.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
auto read_transitions(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                      const NamedParameters& np)
{
  const auto surface = uv_surface(tmesh, uv_map, np);
  const auto given = given_transitions<Group>(tmesh, np);
  return Transition_reader<Group, std::decay_t<decltype(surface)> >(
           surface, given, chosen_tolerance(np)).run();
}

// One halfedge each of the edges that the named parameters ask to align.
template <typename TriangleMesh, typename NamedParameters>
auto edges_to_align(const TriangleMesh& tmesh, const NamedParameters& np)
{
  using Edge = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
  using No_edges = CGAL::Static_boolean_property_map<Edge, false>;
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> result;
  const auto is_constrained = chosen(np, CGAL::internal_np::edge_is_constrained, No_edges());
  const bool align_border = chosen(np, CGAL::internal_np::align_border, false);
  if(std::is_same<std::decay_t<decltype(is_constrained)>, No_edges>::value && !align_border)
    return result;
  for(const Edge e : edges(tmesh)) {
    const auto h = halfedge(e, tmesh);
    if((get(is_constrained, e) || (align_border && CGAL::is_border_edge(h, tmesh))) &&
       (!is_border(h, tmesh) || !is_border(opposite(h, tmesh), tmesh))) // has a face
      result.push_back(h);
  }
  return result;
}

// Reads further constraints, and checks them.
template <typename TriangleMesh>
class Constraint_reader
{
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using Path = Path_constraint<Halfedge>;

public:
  // \param number_of_components 2, for u and v; or 3, with u + v
  Constraint_reader(const TriangleMesh& tmesh, const int number_of_components)
    : m_tmesh(tmesh), m_number_of_components(number_of_components)
  { }

  template <typename NamedParameters>
  Constraint_list<Halfedge> run(const NamedParameters& np)
  {
    using CGAL::parameters::get_parameter_reference;
    add_connections(get_parameter_reference(np, CGAL::internal_np::connection_constraints));
    add_cycles(get_parameter_reference(np, CGAL::internal_np::cycle_constraints));
    add_equations(get_parameter_reference(np, CGAL::internal_np::corner_constraints));
    for(const Path& p : m_result.paths)
      check_path(p);
    for(std::size_t i = 0; i < m_result.equations.size(); ++i)
      for(const auto& term : m_result.equations[i].terms)
        check_corner(term.corner, term.component, m_result.name_of_equation(i));
    return std::move(m_result);
  }

private:
  using Not_given = CGAL::internal_np::Param_not_found;

  void add_connections(const Not_given&) { }
  void add_cycles(const Not_given&) { }
  void add_equations(const Not_given&) { }

  template <typename Range>
  void add_connections(const Range& range)
  {
    for(const Connection_constraint<TriangleMesh>& c : range)
      m_result.paths.push_back({c.a, c.b, c.component, c.path,
                                "connection constraint " + std::to_string(m_result.paths.size())});
  }

  template <typename Range>
  void add_cycles(const Range& range)
  {
    std::size_t i = 0;
    for(const Cycle_constraint<TriangleMesh>& c : range)
      m_result.paths.push_back({c.corner, c.corner, c.component, c.path,
                                "cycle constraint " + std::to_string(i++)});
  }

  template <typename Range>
  void add_equations(const Range& range)
  {
    for(const Corner_constraint<TriangleMesh>& c : range) {
      m_result.equations.push_back({{}, c.right_hand_side});
      for(const auto& term : c.terms)
        m_result.equations.back().terms.push_back({term.corner, term.component, term.coefficient});
    }
  }

  void check_corner(const Halfedge h, const int component, const std::string& name)
  {
    if(h == boost::graph_traits<TriangleMesh>::null_halfedge() || is_border(h, m_tmesh))
      fail(name + " names a corner that is not in a face; a corner is a halfedge that has a face");
    else if(component < 0 || component >= m_number_of_components)
      fail(name + " names component " + std::to_string(component) + "; components are " +
           (m_number_of_components == 2 ? "0 and 1" : "0, 1, and 2 for u, v, and u + v"));
  }

  void check_path(const Path& p)
  {
    check_corner(p.a, p.component, p.name);
    check_corner(p.b, p.component, p.name);
    if(m_result.refusal)
      return;
    auto f = face(p.a, m_tmesh);
    for(std::size_t i = 0; i < p.path.size(); ++i) {
      const Halfedge h = p.path[i];
      const std::string step = "step " + std::to_string(i) + " of the path of " + p.name;
      if(h == boost::graph_traits<TriangleMesh>::null_halfedge())
        return fail(step + " is a null halfedge");
      if(is_border(h, m_tmesh) || is_border(opposite(h, m_tmesh), m_tmesh))
        return fail(step + " crosses the border; a path crosses edges between two faces");
      if(face(h, m_tmesh) != f)
        return fail(step +
                    " does not begin in the face that the path has reached; consecutive halfedges "
                    "h, i of a path have face(opposite(h)) = face(i)");
      f = face(opposite(h, m_tmesh), m_tmesh);
    }
    if(f != face(p.b, m_tmesh))
      fail("the path of " + p.name + " does not end in the face of its last corner");
  }

  void fail(const std::string& message)
  {
    m_result.refusal = Refusal(Outcome::INVALID_ARGUMENT, message);
  }

  const TriangleMesh& m_tmesh;
  int m_number_of_components;
  Constraint_list<Halfedge> m_result;
};

template <typename Group, typename TriangleMesh, typename NamedParameters>
auto read_constraints(const TriangleMesh& tmesh, const NamedParameters& np)
{ return Constraint_reader<TriangleMesh>(tmesh, Group::number_of_functionals).run(np); }

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_GIVEN_ON_MESH_H
