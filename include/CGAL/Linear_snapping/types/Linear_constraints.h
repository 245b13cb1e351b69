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

#ifndef CGAL_LINEAR_SNAPPING_TYPES_LINEAR_CONSTRAINTS_H
#define CGAL_LINEAR_SNAPPING_TYPES_LINEAR_CONSTRAINTS_H

#include <CGAL/license/Linear_snapping.h>

// A sparse system of linear equations, which a caller fills in row by row.

#include <CGAL/Exact_rational.h>
#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {

/*!
\ingroup PkgLinearSnappingRef

A sparse system \f$ C x = b \f$ of linear equations, filled in row by row:

\code{.cpp}
CGAL::Linear_snapping::Linear_constraints<> constraints(3); // three unknowns
constraints.add_constraint({{0, 1}, {1, -1}});              // x0 - x1 = 0
constraints.add_constraint({{1, 3}, {2, 1}}, 5);            // 3 x1 + x2 = 5
\endcode

\tparam Coefficient the type of the coefficients: a built-in integer type, `float`, `double` (each
        of which is a rational number), `CGAL::Exact_integer`, or `CGAL::Exact_rational`

\sa `snap_to_linear_constraints()`
*/
template <typename Coefficient = std::int64_t>
class Linear_constraints
{
public:
  /// the index of an unknown and its coefficient
  using Term = std::pair<std::size_t, Coefficient>;

  /// creates a system without constraints on unknowns \f$ x_0, \ldots, x_{n-1} \f$.
  explicit Linear_constraints(const std::size_t number_of_unknowns)
    : m_number_of_unknowns(number_of_unknowns), m_row_begin(1, 0)
  { }

  /*!
  adds the constraint \f$ \sum_k a_k x_{j_k} = b \f$ and returns its index.

  \param terms the pairs \f$ (j_k, a_k) \f$ in any order; terms with equal indices add up
  \param right_hand_side \f$ b \f$, by default 0; converts exactly from integers, `float`, and
         `double`

  \pre all indices are below `number_of_unknowns()`
  \throws std::invalid_argument if `right_hand_side` is NaN or infinite

  If the function throws, the constraints are as before. A coefficient
  may be NaN or infinite; `snap_to_linear_constraints()` then refuses the system.
  */
  std::size_t add_constraint(const std::vector<Term>& terms,
                             const CGAL::Exact_rational& right_hand_side = CGAL::Exact_rational(0))
  {
    return add_constraint(terms.begin(), terms.end(), right_hand_side);
  }

  /// adds the constraint whose terms are a list in braces.
  std::size_t add_constraint(const std::initializer_list<Term>& terms,
                             const CGAL::Exact_rational& right_hand_side = CGAL::Exact_rational(0))
  {
    return add_constraint(terms.begin(), terms.end(), right_hand_side);
  }

#ifndef DOXYGEN_RUNNING // the overloads above, with a right-hand side of any exact type
  template <typename Real, std::enable_if_t<std::is_floating_point<Real>::value>* = nullptr>
  std::size_t add_constraint(const std::vector<Term>& terms, const Real right_hand_side)
  {
    return add_constraint(terms.begin(), terms.end(), finite(right_hand_side));
  }

  template <typename Real, std::enable_if_t<std::is_floating_point<Real>::value>* = nullptr>
  std::size_t add_constraint(const std::initializer_list<Term>& terms, const Real right_hand_side)
  {
    return add_constraint(terms.begin(), terms.end(), finite(right_hand_side));
  }
#endif

  std::size_t number_of_unknowns() const { return m_number_of_unknowns; } ///< the number of columns
  /// the number of rows
  std::size_t number_of_constraints() const { return m_right_hand_side.size(); }

  /// returns the first term of constraint `i`.
  const Term* begin(const std::size_t i) const { return m_terms.data() + m_row_begin[i]; }
  /// returns the past-the-end term of constraint `i`.
  const Term* end(const std::size_t i) const { return m_terms.data() + m_row_begin[i + 1]; }
  /// returns the right-hand side of constraint `i`.
  const CGAL::Exact_rational& right_hand_side(const std::size_t i) const
  { return m_right_hand_side[i]; }

private:
  // The conversion of what is not a number has no defined result.
  template <typename Real>
  CGAL::Exact_rational finite(const Real b) const
  {
    if(!std::isfinite(b))
      throw std::invalid_argument("the right-hand side of constraint " +
                                  std::to_string(number_of_constraints()) + " is NaN or infinite");
    return CGAL::Exact_rational(b);
  }

  template <typename Iterator>
  std::size_t
  add_constraint(const Iterator first, const Iterator last, const CGAL::Exact_rational& b)
  {
    for(Iterator term = first; term != last; ++term)
      CGAL_precondition(term->first < m_number_of_unknowns);
    const std::size_t size = m_terms.size(), row = m_right_hand_side.size();
    try {
      m_terms.insert(m_terms.end(), first, last);
      m_row_begin.push_back(m_terms.size());
      m_right_hand_side.push_back(b); // counts as the constraint
    } catch(...) {
      m_terms.erase(m_terms.begin() + std::ptrdiff_t(size), m_terms.end());
      m_row_begin.resize(row + 1);
      throw;
    }
    return row;
  }

  std::size_t m_number_of_unknowns;
  std::vector<Term> m_terms;
  std::vector<std::size_t> m_row_begin;
  std::vector<CGAL::Exact_rational> m_right_hand_side;
};

} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_TYPES_LINEAR_CONSTRAINTS_H
