// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Linear_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_ELIMINATE_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_ELIMINATE_H

#include <CGAL/license/Linear_snapping.h>

// The elimination of a system, in 64-bit integers or, if these do not suffice, in multiprecision.
// Finds rows that contradict each other.

#include <CGAL/Linear_snapping/internal/linear/System_builder.h>
#include <CGAL/Linear_snapping/internal/linear/Unit_pivot_elimination.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// \param most_work as for `Unit_pivot_elimination`
inline Echelon_form eliminate(const Integer_system& system,
                              const double most_work = std::numeric_limits<double>::infinity())
{
  if(system.is_small())
    try {
      return Unit_pivot_elimination<std::int64_t>(system, most_work).take_echelon_form();
    } catch(const Integer_overflow&) { }
  return Unit_pivot_elimination<Exact_integer>(system, most_work).take_echelon_form();
}

// A combination of eliminated rows, as one of the system's own: eliminates once more, with a log,
// and follows this back. Equations of auxiliary unknowns hold by definition, and so drop out.
template <typename Integer>
void undo_elimination(const Integer_system& system, std::vector<Exact_rational>& multipliers)
{
  typename Unit_pivot_elimination<Integer>::Log log;
  Unit_pivot_elimination<Integer>(system, std::numeric_limits<double>::infinity(), &log);
  for(auto step = log.rbegin(); step != log.rend(); ++step) {
    Exact_rational& target = multipliers[std::size_t(step->target)];
    if(target == 0)
      continue;
    const Exact_rational factor(Exact_integer(step->factor));
    if(step->pivot < 0)
      target /= factor;
    else
      multipliers[std::size_t(step->pivot)] -= target * factor;
  }
}

// \param eliminated multipliers of rows as `form` has them
inline std::vector<std::pair<std::size_t, Exact_rational> >
multipliers_of_rows(const Integer_system& system, const Echelon_form& form,
                    const Certificate& eliminated)
{
  std::vector<Exact_rational> multipliers(system.number_of_rows(), Exact_rational(0));
  for(const auto& multiple : eliminated)
    multipliers[multiple.first] = Exact_rational(multiple.second);
  if(form.is_multiprecision)
    undo_elimination<Exact_integer>(system, multipliers);
  else
    undo_elimination<std::int64_t>(system, multipliers);
  std::vector<std::pair<std::size_t, Exact_rational> > result;
  for(std::size_t i = 0; i < multipliers.size(); ++i)
    if(multipliers[i] != 0)
      result.emplace_back(i, multipliers[i]);
  return result;
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_ELIMINATE_H
