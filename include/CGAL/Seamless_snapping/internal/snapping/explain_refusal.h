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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_EXPLAIN_REFUSAL_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_EXPLAIN_REFUSAL_H

#include <CGAL/license/Seamless_snapping.h>

// Translates a refusal of the solver into the words of the caller: which edges and constraints of
// the mesh the rows of the system, and roundings, stand for. And refuses paths that miss.

#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/complex/is_exact.h>
#include <CGAL/Seamless_snapping/internal/complex/row_origins.h>
#include <CGAL/Seamless_snapping/internal/mesh/Constraint_list.h>
#include <CGAL/Seamless_snapping/internal/mesh/Uv_surface.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The place of a rounding.
template <typename Group, typename Surface>
Message name_of_rounding(const Rounding<Group>& rounding, const Surface& surface,
                         const Surface_cuts<Group, typename Surface::Halfedge>& cuts)
{
  switch(rounding.kind) {
  case Rounding<Group>::BRANCH:
    return "the translation across " + edge_name(surface, cuts.branch_ends[rounding.index][0]);
  case Rounding<Group>::CHAIN:
    return "the level of " + edge_name(surface, cuts.chain_ends[rounding.index][0]);
  case Rounding<Group>::POINT:
    break;
  }
  const auto corner = cuts.corners[rounding.index].front();
  return (has_border_at_target(surface, corner) ? "the border at " : "the cone at ") +
         vertex_name(surface, corner);
}

// The meaning of a row.
template <typename Group, typename Surface>
Message name_of_row(const Row_origin& origin, const Surface& surface,
                    const Surface_cuts<Group, typename Surface::Halfedge>& cuts,
                    const Constraint_list<typename Surface::Halfedge>& constraints,
                    const std::vector<Rounding<Group> >& roundings)
{
  const std::size_t i = origin.index, end = origin.is_at_end ? 1 : 0;
  switch(origin.kind) {
  case Row_origin::BRANCH:
    return "the transition across " + edge_name(surface, cuts.branch_ends[i][end]);
  case Row_origin::CHAIN:
    return "the alignment of " + edge_name(surface, cuts.chain_ends[i][end]);
  case Row_origin::PATH: return constraints.paths[i].name;
  case Row_origin::SUM: // in no contradiction
  case Row_origin::EQUATION: break;
  }
  const std::size_t n = constraints.equations.size();
  return i < n ? constraints.name_of_equation(i)
               : "the rounding of " + name_of_rounding(roundings[i - n], surface, cuts);
}

// The refusal with a message that names the place and the remedy.
template <typename Group, typename Surface>
Refusal explained(Refusal refusal, const Surface& surface,
                  const Surface_cuts<Group, typename Surface::Halfedge>& cuts,
                  const Constraint_list<typename Surface::Halfedge>& constraints,
                  const std::vector<Rounding<Group> >& roundings, // equations after the caller's
                  const std::vector<Row_origin>& contradiction)
{
  if(refusal.status == Outcome::NOT_REPRESENTABLE) {
    refusal.message =
        constraints.equations.empty()
            ? "the exact coordinates would exceed the largest number of their type" +
                remedy("scale them down")
            : "the corner constraints have solutions, but none whose coordinates are multiples of "
              "one power of two that the number type can hold at the size of the coordinates" +
                remedy("round their right-hand sides to fewer bits");
    return refusal;
  }
  constexpr std::size_t at_most = 8;
  std::map<std::string, Message> names;
  for(const Row_origin& origin : contradiction) {
    const Message name = name_of_row(origin, surface, cuts, constraints, roundings);
    names.emplace(name.str(), name);
  }
  refusal.message = "constraints contradict each other:";
  std::size_t count = 0;
  for(const auto& name : names)
    if(++count <= at_most)
      refusal.message += (count == 1 ? " " : ", ") + name.second;
  if(count > at_most)
    refusal.message += ", and " + std::to_string(count - at_most) + " more";
  refusal.message += remedy("remove or correct one of them");
  return refusal;
}

// How far connections and cycles are from being met before anything moves. Returns a refusal if one
// misses by more than the tolerance, relative to the extent: it would distort the whole map.
// \param report its extent is set; receives the largest distance by which a path misses
template <typename Group, typename Halfedge>
std::optional<Refusal> check_paths(const Cut_complex<Group>& complex,
                                   const Constraint_list<Halfedge>& constraints,
                                   const double tolerance, Snapping_report& report)
{
  if(!(tolerance >= 0))
    return Refusal(Outcome::INVALID_ARGUMENT, term("connection_tolerance") + " is " +
                   short_number(tolerance) + remedy("it must not be negative"));
  std::size_t worst = 0, count = 0;
  for(std::size_t i = 0; i < complex.paths.size(); ++i) {
    const double distance =
      std::abs(CGAL::to_double(path_misfit(complex, complex.paths[i], complex.coordinates)));
    if(distance > tolerance * report.extent)
      ++count;
    if(distance > report.connection_violation_before) {
      report.connection_violation_before = distance;
      worst = i;
    }
  }
  if(count == 0)
    return std::nullopt;
  return Refusal(Outcome::NOT_CONNECTED, constraints.paths[worst].name + " misses by " +
                 short_number(report.connection_violation_before / report.extent) +
                 " of the extent, more than " + term("the connection_tolerance of") + " " +
                 short_number(tolerance) +
                 (count > 1 ? ", as with " + counted(count - 1, "other") : std::string()) +
                 remedy("see whether its path is the one that is meant, and raise the tolerance "
                        "if so"));
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_EXPLAIN_REFUSAL_H
