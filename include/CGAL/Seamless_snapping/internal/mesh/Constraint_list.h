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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_CONSTRAINT_LIST_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_CONSTRAINT_LIST_H

#include <CGAL/license/Seamless_snapping.h>

// The further constraints that the caller gave, brought into one form and checked.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/types/surface_constraints.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// A connection, or a cycle as the special case a = b.
template <typename TriangleMesh>
struct Path_constraint
{
  Connection_constraint<TriangleMesh> connection;
  std::string name; // "connection 3"
};

// Invariant: unless there is a refusal, all corners have faces, all components are those of the
// symmetry, and all paths are connected and cross interior edges only.
template <typename TriangleMesh>
class Constraint_list
{
public:
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using Corner = Corner_constraint<TriangleMesh>;

  // \param number_of_components 2, for u and v; or 3, with u + v
  template <typename NamedParameters>
  Constraint_list(const TriangleMesh& tmesh, const NamedParameters& np,
                  const int number_of_components = 2)
    : m_tmesh(tmesh), m_number_of_components(number_of_components)
  {
    namespace parameters = CGAL::parameters;
    add_connections(
        parameters::get_parameter_reference(np, CGAL::internal_np::connection_constraints));
    add_cycles(parameters::get_parameter_reference(np, CGAL::internal_np::cycle_constraints));
    add_corner_constraints(
        parameters::get_parameter_reference(np, CGAL::internal_np::corner_constraints));
    for(const Path_constraint<TriangleMesh>& p : m_paths)
      check_path(p);
    for(std::size_t i = 0; i < m_corner_constraints.size(); ++i)
      for(const typename Corner::Term& term : m_corner_constraints[i].terms)
        check_corner(term.corner, term.component, corner_constraint_name(i));
  }

  const std::optional<Refusal>& refusal() const { return m_refusal; }

  bool empty() const { return m_paths.empty() && m_corner_constraints.empty(); }
  const std::vector<Path_constraint<TriangleMesh> >& paths() const { return m_paths; }
  const std::vector<Corner>& corner_constraints() const { return m_corner_constraints; }
  static std::string corner_constraint_name(const std::size_t i)
  { return "corner constraint " + std::to_string(i); }

  // Corners that have to be points of the integer grid, though cuts don't tell of them.
  void add_grid_points(const std::vector<Halfedge>& corners) { m_grid_points = corners; }

  // The corners whose coordinates occur, in the order: both ends of each path, all terms, points of
  // the grid.
  std::vector<Halfedge> corners() const
  {
    std::vector<Halfedge> result;
    for(const Path_constraint<TriangleMesh>& p : m_paths) {
      result.push_back(p.connection.a);
      result.push_back(p.connection.b);
    }
    for(const Corner& c : m_corner_constraints)
      for(const typename Corner::Term& term : c.terms)
        result.push_back(term.corner);
    result.insert(result.end(), m_grid_points.begin(), m_grid_points.end());
    return result;
  }

private:
  using Not_given = CGAL::internal_np::Param_not_found;

  void add_connections(const Not_given&) { }
  void add_cycles(const Not_given&) { }
  void add_corner_constraints(const Not_given&) { }

  template <typename Range>
  void add_connections(const Range& range)
  {
    for(const Connection_constraint<TriangleMesh>& c : range)
      m_paths.push_back({c, "connection constraint " + std::to_string(m_paths.size())});
  }

  template <typename Range>
  void add_cycles(const Range& range)
  {
    std::size_t i = 0;
    for(const Cycle_constraint<TriangleMesh>& c : range)
      m_paths.push_back({{c.corner, c.corner, c.component, c.path},
                         "cycle constraint " + std::to_string(i++)});
  }

  template <typename Range>
  void add_corner_constraints(const Range& range)
  {
    m_corner_constraints.assign(std::begin(range), std::end(range));
  }

  void check_corner(const Halfedge h, const int component, const std::string& name)
  {
    if(h == boost::graph_traits<TriangleMesh>::null_halfedge() || is_border(h, m_tmesh))
      fail(name + " names a corner that is not in a face; a corner is a halfedge that has a face");
    else if(component < 0 || component >= m_number_of_components)
      fail(name + " names component " + std::to_string(component) + "; components are " +
           (m_number_of_components == 2 ? "0 and 1" : "0, 1, and 2 for u, v, and u + v"));
  }

  void check_path(const Path_constraint<TriangleMesh>& p)
  {
    check_corner(p.connection.a, p.connection.component, p.name);
    check_corner(p.connection.b, p.connection.component, p.name);
    if(m_refusal)
      return;
    auto f = face(p.connection.a, m_tmesh);
    for(std::size_t i = 0; i < p.connection.path.size(); ++i) {
      const Halfedge h = p.connection.path[i];
      const std::string step = "step " + std::to_string(i) + " of the path of " + p.name;
      if(h == boost::graph_traits<TriangleMesh>::null_halfedge())
        return fail(step + " is a null halfedge");
      if(is_border(h, m_tmesh) || is_border(opposite(h, m_tmesh), m_tmesh))
        return fail(step + " crosses the border; a path crosses edges between two faces");
      if(face(h, m_tmesh) != f)
        return fail(step +
                    " does not begin in the face where the path has arrived; consecutive halfedges "
                    "h, i of a path have face(opposite(h)) = face(i)");
      f = face(opposite(h, m_tmesh), m_tmesh);
    }
    if(f != face(p.connection.b, m_tmesh))
      fail("the path of " + p.name + " does not end in the face of its last corner");
  }

  void fail(const std::string& message)
  {
    m_refusal = Refusal(Outcome::INVALID_ARGUMENT, message);
  }

  const TriangleMesh& m_tmesh;
  int m_number_of_components;
  std::vector<Path_constraint<TriangleMesh> > m_paths;
  std::vector<Corner> m_corner_constraints;
  std::vector<Halfedge> m_grid_points;
  std::optional<Refusal> m_refusal;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_CONSTRAINT_LIST_H
