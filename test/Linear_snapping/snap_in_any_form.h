// Calls snap_to_linear_constraints() in one of the forms in which callers may give the system:
// terms with rational or integer coefficients, or Eigen's matrices of integers or doubles with
// right-hand sides of several types or none.

#ifndef SEAMLESS_SNAPPING_TEST_SNAP_IN_ANY_FORM_H
#define SEAMLESS_SNAPPING_TEST_SNAP_IN_ANY_FORM_H

#include <CGAL/Linear_snapping/snap_to_linear_constraints.h>
#include <CGAL/Linear_snapping/types/Linear_constraints.h>
#include <CGAL/Linear_snapping/types/parameters.h>

#include "exact_reference.h"
#include "random_systems.h"

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace snap_in_any_form {

namespace LS = CGAL::Linear_snapping;

using exact_reference::Rational;
using exact_reference::System;

inline bool are_integers(const System& system, double bound)
{
  for(const auto& row : system.rows)
    for(const auto& entry : row)
      if(exact_reference::denominator(entry.coefficient) != 1
         || CGAL::abs(entry.coefficient) > Rational(bound))
        return false;
  return true;
}

template <typename Coefficient>
LS::Linear_constraints<Coefficient> linear_constraints(const System& system)
{
  LS::Linear_constraints<Coefficient> result(system.columns);
  for(std::size_t r = 0; r < system.rows.size(); ++r) {
    std::vector<std::pair<std::size_t, Coefficient> > terms;
    for(const auto& entry : system.rows[r]) {
      if constexpr(std::is_same<Coefficient, Rational>::value)
        terms.emplace_back(entry.column, entry.coefficient);
      else
        terms.emplace_back(entry.column,
                           static_cast<Coefficient>(std::stoll(
                             (std::ostringstream() << entry.coefficient).str())));
    }
    result.add_constraint(terms, system.b[r]);
  }
  return result;
}

template <typename Scalar>
Eigen::SparseMatrix<Scalar> sparse_matrix(const System& system)
{
  std::vector<Eigen::Triplet<Scalar> > entries;
  for(std::size_t r = 0; r < system.rows.size(); ++r)
    for(const auto& entry : system.rows[r])
      entries.emplace_back(int(r), int(entry.column),
                           static_cast<Scalar>(CGAL::to_double(entry.coefficient)));
  Eigen::SparseMatrix<Scalar> result(Eigen::Index(system.rows.size()),
                                     Eigen::Index(system.columns));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

template <typename Matrix, typename Values, typename NamedParameters>
LS::Linear_report snap_matrix(const Matrix& matrix, const System& system, Values& x,
                              const NamedParameters& np)
{
  std::vector<double> b;
  for(const Rational& value : system.b)
    b.push_back(CGAL::to_double(value));
  if(exact_reference::to_rationals(b) != system.b)
    return LS::snap_to_linear_constraints(matrix, system.b, x, np);
  if(std::all_of(b.begin(), b.end(), [](double value) { return value == 0; }))
    return LS::snap_to_linear_constraints(matrix, x, np);
  return LS::snap_to_linear_constraints(matrix, b, x, np);
}

// The form is drawn from those that can hold the system.
template <typename Values>
LS::Linear_report snap(random_systems::Random& random, const System& system, Values& x,
                       const std::vector<double>& weights)
{
  const auto np = LS::parameters::value_weights(weights);
  const bool are_small = are_integers(system, 1000000);
  switch(random() % 4) {
    case 1:
      if(are_integers(system, 0x1p62))
        return LS::snap_to_linear_constraints(linear_constraints<std::int64_t>(system), x, np);
      break;
    case 2:
      if(are_small)
        return snap_matrix(sparse_matrix<int>(system), system, x, np);
      break;
    case 3:
      if(are_small)
        return snap_matrix(sparse_matrix<double>(system), system, x, np);
      break;
    default: break;
  }
  return LS::snap_to_linear_constraints(linear_constraints<Rational>(system), x, np);
}

} // namespace snap_in_any_form

#endif // SEAMLESS_SNAPPING_TEST_SNAP_IN_ANY_FORM_H
