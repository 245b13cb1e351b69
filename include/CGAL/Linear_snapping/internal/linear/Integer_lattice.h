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

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/linear/Kernel_lattice.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// A lattice together with a weighted Euclidean norm, in which near lattice points are looked for.
// The point found is a lattice point exactly; that it is near rests on floating point arithmetic.

// a += factor b
inline void add_multiple(std::vector<Exact_integer>& a, const Exact_integer& factor,
                         const Entries<Exact_integer>& b)
{
  const Exact_integer opposite(-factor);
  for(const Entry<Exact_integer>& e : b) {
    Exact_integer& value = a[std::size_t(e.column)];
    value = difference_with_product(value, opposite, e.coefficient);
  }
}

// Invariant: the vectors are a basis of the given lattice, reduced with respect to the norm
// sqrt(sum_i w_i v_i^2), and the frame is theirs.
class Lattice_metric
{
public:
  using Vector = Entries<Exact_integer>;

  // \pre the vectors are linearly independent, the weights positive
  // \param most_work multiplications of words, after which the basis is left as it is
  Lattice_metric(const std::vector<Vector>& basis, const std::vector<double>& weights,
                 const double most_work)
    : m_scale(weights.size()), m_frame(0, 0), m_work_left(most_work)
  {
    for(std::size_t i = 0; i < weights.size(); ++i)
      m_scale[i] = std::sqrt(weights[i]);
    try {
      reduce(dense_vectors<std::int64_t>(basis, weights.size()));
    } catch(const Integer_overflow&) {
      reduce(dense_vectors<Exact_integer>(basis, weights.size()));
    }
  }

  const std::vector<Vector>& basis() const { return m_basis; }
  double work_left() const { return m_work_left; }

  // Adds a lattice vector to `point` such that it comes close to the target: the nearest plane
  // algorithm. Coefficients have 53 bits, so large differences take several rounds.
  void approach(const std::vector<Grid_value>& target, std::vector<Exact_integer>& point) const
  {
    if(m_basis.empty())
      return;
    std::vector<Exact_integer> difference(point.size());
    for(std::size_t i = 0; i < point.size(); ++i)
      difference[i] = Exact_integer(from_64_bits<Exact_integer>(target[i].base) - point[i]);
    long smallest_exponent = (std::numeric_limits<long>::max)();
    std::vector<double> row;
    double words = 0; // not counted: few rows
    for(int rounds_left = 3; rounds_left > 0; --rounds_left) {
      const long exponent = to_scaled_row(difference, m_scale, row, words);
      for(std::size_t i = 0; i < row.size(); ++i)
        row[i] += scaled_by_power(target[i].offset, -exponent) * m_scale[i];
      if(exponent < smallest_exponent) {
        smallest_exponent = exponent;
        rounds_left = 3;
      }
      if(!approach_once(row, exponent, difference, point))
        break;
    }
  }

private:
  static void convert(const Exact_integer& a, Exact_integer& b) { b = a; }
  static void convert(const Exact_integer& a, std::int64_t& b)
  {
    if(!fits_64_bits(a))
      throw Integer_overflow();
    b = to_64_bits(a);
  }

  template <typename Integer>
  static std::vector<std::vector<Integer> > dense_vectors(const std::vector<Vector>& basis,
                                                          const std::size_t dimension)
  {
    std::vector<std::vector<Integer> > result(basis.size(),
                                              std::vector<Integer>(dimension, Integer(0)));
    for(std::size_t k = 0; k < basis.size(); ++k)
      for(const Entry<Exact_integer>& e : basis[k])
        convert(e.coefficient, result[k][std::size_t(e.column)]);
    return result;
  }

  template <typename Integer>
  void reduce(std::vector<std::vector<Integer> > vectors)
  {
    Lattice_reduction<Integer> reduction(vectors, m_scale, m_work_left);
    m_work_left -= reduction.work();
    m_frame = std::move(reduction.frame());
    m_basis.clear();
    for(const std::vector<Integer>& v : vectors) {
      Vector sparse;
      for(std::size_t i = 0; i < v.size(); ++i)
        if(v[i] != 0)
          sparse.push_back({Column_index(i), Exact_integer(v[i])});
      m_basis.push_back(std::move(sparse));
    }
  }

  // Returns whether the point changed. The row is the difference in floating point, and is used up.
  bool approach_once(std::vector<double>& row, const long exponent,
                     std::vector<Exact_integer>& difference,
                     std::vector<Exact_integer>& point) const
  {
    std::vector<double> coefficients(m_basis.size(), 0.);
    m_frame.project(m_basis.size(), row.data(), coefficients.data());
    bool has_changed = false;
    for(std::size_t j = m_basis.size(); j-- > 0;) {
      const double* const r = m_frame.r(j);
      const long shift = exponent - m_frame.exponent(j);
      const Scaled_double factor = nearest_integer(coefficients[j] / r[j], shift);
      if(factor.mantissa == 0 || !std::isfinite(factor.mantissa))
        continue;
      const Exact_integer z = to_exact_integer(factor);
      add_multiple(point, z, m_basis[j]);
      add_multiple(difference, Exact_integer(-z), m_basis[j]);
      subtract_multiple(coefficients.data(),
                        scaled_by_power(factor.mantissa, factor.exponent - shift), r, j + 1);
      has_changed = true;
    }
    return has_changed;
  }

  std::vector<double> m_scale; // square roots of the weights
  Orthogonal_frame m_frame;
  double m_work_left;
  std::vector<Vector> m_basis;
};

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
  double work_left() const { return m_work_left; } // of that which was allowed

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
  Lattice_metric metric(const std::vector<double>& weights,
                        const double most_work = Lattice_reduction<Exact_integer>::usual_work) const
  {
    CGAL_precondition(weights.size() == number_of_columns());
    return Lattice_metric(m_basis, weights, most_work);
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
  // modulus. Because these vectors span Z^n, it is an integer vector before multiplication.
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
  double m_work_left = 0;
  std::vector<Entries<Exact_integer> > m_rows;
  std::vector<Echelon_step<Exact_integer> > m_steps;
  std::vector<Vector> m_basis;
};

// Not inline: few of the sources that include this file compile it.
template <typename Integer>
void Integer_lattice::take_kernel(const Integer_system& system, const double most_work)
{
  Kernel_lattice<Integer> kernel(system, most_work);
  m_work_left = kernel.work_left();
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
