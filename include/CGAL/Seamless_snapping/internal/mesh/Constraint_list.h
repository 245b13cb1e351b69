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

// The further constraints that the caller gave, brought into one form.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <CGAL/Exact_rational.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// A connection, or a cycle as the special case a = b.
template <typename Halfedge>
struct Path_constraint
{
  Halfedge a, b; // corners
  int component;
  std::vector<Halfedge> path;
  std::string name; // "connection 3"
};

template <typename Halfedge>
struct Corner_equation
{
  struct Term
  {
    Halfedge corner;
    int component;
    CGAL::Exact_rational coefficient;
  };

  std::vector<Term> terms;
  CGAL::Exact_rational right_hand_side;
};

// Invariant: unless there is a refusal, all corners have faces, all components are those of the
// symmetry, and all paths are connected and cross interior edges only.
template <typename Halfedge>
struct Constraint_list
{
  std::vector<Path_constraint<Halfedge> > paths;
  std::vector<Corner_equation<Halfedge> > equations;
  std::vector<Halfedge> grid_points; // corners at points of an integer grid that cuts don't tell of
  std::optional<Refusal> refusal;

  bool empty() const { return paths.empty() && equations.empty(); }

  static Message name_of_equation(const std::size_t i)
  { return "corner constraint " + std::to_string(i); }

  // The corners whose coordinates occur, in the order: both ends of each path, all terms, points of
  // the grid.
  std::vector<Halfedge> corners() const
  {
    std::vector<Halfedge> result;
    for(const Path_constraint<Halfedge>& p : paths) {
      result.push_back(p.a);
      result.push_back(p.b);
    }
    for(const Corner_equation<Halfedge>& e : equations)
      for(const auto& term : e.terms)
        result.push_back(term.corner);
    result.insert(result.end(), grid_points.begin(), grid_points.end());
    return result;
  }

  // The constraints with `number(h)` for each halfedge h.
  template <typename Number>
  auto renumbered(const Number& number) const
  {
    Constraint_list<decltype(number(Halfedge()))> result;
    result.refusal = refusal;
    if(refusal)
      return result;
    for(const Path_constraint<Halfedge>& p : paths) {
      result.paths.push_back({number(p.a), number(p.b), p.component, {}, p.name});
      for(const Halfedge h : p.path)
        result.paths.back().path.push_back(number(h));
    }
    for(const Corner_equation<Halfedge>& e : equations) {
      result.equations.push_back({{}, e.right_hand_side});
      for(const auto& term : e.terms)
        result.equations.back().terms.push_back(
          {number(term.corner), term.component, term.coefficient});
    }
    return result;
  }
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_CONSTRAINT_LIST_H
