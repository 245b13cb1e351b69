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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_INTEGER_LATTICE_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_INTEGER_LATTICE_H

#include <CGAL/license/Linear_snapping.h>

// All integer solutions of A Y = B, for a fixed A and several B: whether there are any, with proof,
// and one that is near to given real numbers. Complete, unlike the divisibility rule of
// [MC19] Algorithm 4 (see part B of its addendum).

#include <CGAL/Linear_snapping/internal/linear/Lattice_metric.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

enum class Solvability
{
  SOLVABLE,     // over the integers
  NOT_INTEGER,  // over the rational numbers only
  INCONSISTENT  // not even over those
};

// A combination y of rows that proves that A Y = B has no integer solution:
// y^T A = 0 and y^T B != 0 modulo `modulus`, where modulus 0 means equality.
struct Insolvability_certificate
{
  std::vector<Exact_integer> multipliers;
  Exact_integer modulus = Exact_integer(0);
};

struct Lattice_solution
{
  Solvability solvability = Solvability::SOLVABLE;
  std::vector<Exact_integer> values;
  // If NOT_INTEGER: whether 2^k B has a solution for some k, and the smallest such k. If it has
  // none, the modulus of the certificate is odd, and so proves it for all k.
  bool is_dyadic = false;
  std::size_t power_of_two = 0;
  Insolvability_certificate certificate;
};

// Invariant: the basis spans the kernel of A in Z^n, and together with the vectors of the echelon
// steps it spans Z^n. The cost is in the constructor; queries are cheap.
class Integer_lattice
{
public:
  using Vector = Entries<Exact_integer>;

  // The right-hand sides of the system, all 0, play no role.
  // \param most_work as for `Kernel_lattice`
  explicit Integer_lattice(const Integer_system& system,
                           const double most_work = std::numeric_limits<double>::infinity())
    : m_number_of_columns(system.number_of_columns())
  {
    for(std::size_t i = 0; i < system.number_of_rows(); ++i)
      m_rows.push_back(system.exact_row(i).entries);
    if(system.is_small())
      try {
        take_kernel<std::int64_t>(system, most_work);
        return;
      } catch(const Integer_overflow&) { }
    take_kernel<Exact_integer>(system, most_work);
  }

  std::size_t number_of_columns() const { return m_number_of_columns; }
  std::size_t number_of_rows() const { return m_rows.size(); }
  std::size_t rank() const { return number_of_columns() - m_basis.size(); }

  // Rows that all others depend on over the rational numbers.
  std::vector<Row_index> independent_rows() const
  {
    std::vector<Row_index> rows;
    for(const Echelon_step<Exact_integer>& step : m_steps)
      if(step.gcd != 0)
        rows.push_back(step.row);
    return rows;
  }

  // The diagonal of the Hermite form: what right-hand sides have to be divisible by.
  Exact_integer largest_pivot() const
  {
    Exact_integer largest(0);
    for(const Echelon_step<Exact_integer>& step : m_steps)
      if(CGAL::abs(step.gcd) > largest)
        largest = CGAL::abs(step.gcd);
    return largest;
  }

  // A basis of all Y in Z^n with A Y = 0, of short vectors.
  const std::vector<Vector>& kernel_basis() const { return m_basis; }

  // \pre one positive weight per column
  Lattice_metric metric(const std::vector<double>& weights) const
  {
    CGAL_precondition(weights.size() == number_of_columns());
    return Lattice_metric(m_basis, weights);
  }

  Lattice_solution some_solution(const std::vector<Exact_integer>& right_hand_side) const
  {
    CGAL_precondition(right_hand_side.size() == number_of_rows());
    // The coordinates with respect to the echelon vectors are unique, even as rational numbers.
    // All of them are kept as integers over one denominator, which never is larger than needed.
    std::vector<Exact_integer> point(number_of_columns(), Exact_integer(0));
    Exact_integer denominator(1);
    std::size_t culprit = m_steps.size();
    bool is_dyadic = true;
    for(std::size_t i = 0; i < m_steps.size(); ++i) {
      const Echelon_step<Exact_integer>& step = m_steps[i];
      const std::size_t row = std::size_t(step.row);
      Exact_integer rest(Exact_integer(right_hand_side[row] * denominator) - image(row, point));
      if(step.gcd == 0) {
        if(rest != 0)
          return inconsistent(i);
        continue;
      }
      const Exact_integer factor = missing_factor(rest, step.gcd);
      if(factor != 1) {
        const bool is_still_dyadic = odd_part(factor) == 1;
        if(culprit == m_steps.size() || (is_dyadic && !is_still_dyadic))
          culprit = i;
        is_dyadic = is_dyadic && is_still_dyadic;
        denominator *= factor;
        rest *= factor;
        for(Exact_integer& value : point)
          value *= factor;
      }
      add_multiple(point, exact_quotient(rest, step.gcd), step.vector);
    }
    if(culprit != m_steps.size())
      return not_integer(culprit, is_dyadic, denominator);
    Lattice_solution result;
    result.values = std::move(point);
    return result;
  }

  // A solution near to the target in the norm of the metric, which must be one of this lattice.
  Lattice_solution nearest_solution(const std::vector<Exact_integer>& right_hand_side,
                                    const std::vector<Grid_value>& target,
                                    const Lattice_metric& metric) const
  {
    CGAL_precondition(target.size() == number_of_columns());
    Lattice_solution result = some_solution(right_hand_side);
    if(result.solvability == Solvability::SOLVABLE)
      metric.approach(target, result.values);
    return result;
  }

  Lattice_solution nearest_solution(const std::vector<Exact_integer>& right_hand_side,
                                    const std::vector<Grid_value>& target,
                                    const std::vector<double>& weights) const
  {
    return nearest_solution(right_hand_side, target, metric(weights));
  }

private:
  template <typename Integer>
  void take_kernel(const Integer_system& system, double most_work);

  template <typename Integer>
  static Vector to_exact_vector(const Entries<Integer>& vector)
  {
    Vector result;
    for(const Entry<Integer>& e : vector)
      result.push_back({e.column, Exact_integer(e.coefficient)});
    return result;
  }

  Exact_integer image(const std::size_t row, const std::vector<Exact_integer>& point) const
  {
    Exact_integer sum(0);
    for(const Entry<Exact_integer>& e : m_rows[row])
      sum += product(e.coefficient, point[std::size_t(e.column)]);
    return sum;
  }

  // The smallest positive f such that f a is divisible by b.
  static Exact_integer missing_factor(const Exact_integer& a, const Exact_integer& b)
  {
    const Exact_integer gcd = greatest_common_divisor(CGAL::abs(a), CGAL::abs(b));
    return CGAL::abs(exact_quotient(b, gcd));
  }

  static Exact_integer odd_part(const Exact_integer& a)
  {
    return a == 0 ? a : exact_quotient(a, power_of_two(std::size_t(number_of_halvings(a))));
  }

  Lattice_solution inconsistent(const std::size_t step) const
  {
    Lattice_solution result;
    result.solvability = Solvability::INCONSISTENT;
    result.certificate = certificate(step);
    result.certificate.modulus = 0;
    return result;
  }

  Lattice_solution not_integer(const std::size_t culprit, const bool is_dyadic,
                               const Exact_integer& denominator) const
  {
    Lattice_solution result;
    result.solvability = Solvability::NOT_INTEGER;
    result.is_dyadic = is_dyadic;
    if(is_dyadic)
      result.power_of_two = bit_length(denominator) - 1;
    result.certificate = certificate(culprit);
    if(!is_dyadic)
      result.certificate.modulus = odd_part(result.certificate.modulus);
    return result;
  }

  // The combination of the row of a step with earlier rows that maps its vector to 1 and all other
  // echelon and basis vectors to 0 (all, for a redundant row), times a common denominator: the
  // modulus. Since those vectors span Z^n, it is an integer vector before multiplication.
  Insolvability_certificate certificate(const std::size_t step) const
  {
    Insolvability_certificate result;
    result.multipliers.assign(number_of_rows(), Exact_integer(0));
    result.modulus = m_steps[step].gcd == 0 ? Exact_integer(1) : CGAL::abs(m_steps[step].gcd);
    std::vector<Exact_integer> combination(number_of_columns(), Exact_integer(0));
    add_row(m_steps[step].row, Exact_integer(1), result, combination);
    for(std::size_t i = step; i-- > 0;) {
      const Exact_integer& gcd = m_steps[i].gcd;
      if(gcd == 0)
        continue;
      Exact_integer value(0);
      for(const Entry<Exact_integer>& e : m_steps[i].vector)
        value += Exact_integer(e.coefficient * combination[std::size_t(e.column)]);
      if(value == 0)
        continue;
      const Exact_integer factor = missing_factor(value, gcd);
      if(factor != 1) {
        for(Exact_integer& y : result.multipliers)
          y *= factor;
        for(Exact_integer& c : combination)
          c *= factor;
        result.modulus *= factor;
        value *= factor;
      }
      add_row(m_steps[i].row, Exact_integer(-exact_quotient(value, gcd)), result, combination);
    }
    return result;
  }

  void add_row(const Row_index row, const Exact_integer& factor, Insolvability_certificate& result,
               std::vector<Exact_integer>& combination) const
  {
    result.multipliers[std::size_t(row)] = factor;
    for(const Entry<Exact_integer>& e : m_rows[std::size_t(row)])
      combination[std::size_t(e.column)] += product(factor, e.coefficient);
  }

  std::size_t m_number_of_columns;
  std::vector<Entries<Exact_integer> > m_rows;
  std::vector<Echelon_step<Exact_integer> > m_steps;
  std::vector<Vector> m_basis;
};

// Not inline: few of those that include this file compile it.
template <typename Integer>
void Integer_lattice::take_kernel(const Integer_system& system, const double most_work)
{
  Kernel_lattice<Integer> kernel(system, most_work);
  m_steps.clear();
  m_basis.clear();
  for(const Echelon_step<Integer>& step : kernel.steps())
    m_steps.push_back({step.row, Exact_integer(step.gcd), to_exact_vector(step.vector)});
  for(const Entries<Integer>& vector : kernel.basis())
    m_basis.push_back(to_exact_vector(vector));
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_INTEGER_LATTICE_H
