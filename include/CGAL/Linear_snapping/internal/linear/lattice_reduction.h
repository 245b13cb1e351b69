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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LATTICE_REDUCTION_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LATTICE_REDUCTION_H

#include <CGAL/license/Linear_snapping.h>

// LLL reduction of a lattice basis: short, nearly orthogonal vectors that span the same lattice.
// Every operation on the basis is an exact unimodular one, so the lattice stays the same no matter
// how the floating point numbers that choose the operations are rounded. Also reduces the rows of a
// system, because the least-squares problem loses all its digits if rows are nearly parallel.

#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>
#include <CGAL/Linear_snapping/internal/linear/Orthogonal_frame.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// The integer nearest to quotient 2^exponent, to 53 bits, as mantissa 2^exponent with exponent >=
// 0. (Not std::nearbyint: callers may have set another rounding mode.)
inline Scaled_double nearest_integer(double quotient, long exponent)
{
  int bits = 0;
  quotient = std::frexp(quotient, &bits);
  exponent += bits;
  const long shift = (std::max)(0L, exponent - 53);
  return {std::floor(scaled_by_power(quotient, exponent - shift) + 0.5), shift};
}

// \pre the mantissa is an integer, and the exponent not negative
inline BOOST_NOINLINE Exact_integer to_exact_integer(const Scaled_double& a)
{
  const Exact_integer value(a.mantissa);
  return a.exponent == 0 ? value : product(value, power_of_two(std::size_t(a.exponent)));
}

// a -= factor b
inline BOOST_NOINLINE void subtract_multiple(std::vector<Exact_integer>& a,
                                             const Scaled_double& factor,
                                             const std::vector<Exact_integer>& b)
{
  const Exact_integer f = to_exact_integer(factor);
  for(std::size_t i = 0; i < a.size(); ++i)
    if(b[i] != 0)
      a[i] = difference_with_product(a[i], f, b[i]);
}

inline double largest_absolute_value(const std::vector<std::int64_t>& v)
{
  std::int64_t largest = 0;
  for(const std::int64_t a : v)
    largest = (std::max)(largest, absolute_value(a));
  return static_cast<double>(largest);
}

inline void subtract_multiple(std::vector<std::int64_t>& a, const Scaled_double& factor,
                              const std::vector<std::int64_t>& b)
{
  const double f = scaled_by_power(factor.mantissa, factor.exponent);
  if(!(largest_absolute_value(a) + std::abs(f) * largest_absolute_value(b) < machine_integer_bound))
    throw Integer_overflow();
  const std::int64_t multiple = static_cast<std::int64_t>(f);
  for(std::size_t i = 0; i < a.size(); ++i)
    a[i] -= multiple * b[i];
}

// Reduces `basis` in place with respect to the norm |scale_i v_i|. The vectors must be linearly
// independent. The work is bounded: in the unlikely case that rounding errors keep the algorithm
// from coming to an end, the basis is left less reduced, but still a basis.
template <typename Integer>
class Lattice_reduction
{
public:
  using Vector = std::vector<Integer>;

  static constexpr double usual_work = 1e10; // multiplications of words: some seconds

  // \param most_work after which the basis is left as it is
  Lattice_reduction(std::vector<Vector>& basis, const std::vector<double>& scale,
                    const double most_work = usual_work)
    : m_basis(basis), m_scale(scale), m_frame(basis.size(), scale.size()),
      m_words(basis.size(), 0.)
  {
    // Rotations add up errors: what seems reduced is looked at afresh.
    std::size_t insertions = 0, insertions_before = 0;
    do {
      insertions_before = insertions;
      m_number_set = 0;
      for(std::size_t k = 0; k < basis.size();) {
        if(k >= m_number_set || subtract_earlier_vectors(k) >= large_factor)
          size_reduce(k);
        Progress::tell_each_second([&] { return "a lattice of " + counted(basis.size(), "vector") +
                                                " is reduced"; });
        const std::size_t position = m_work < most_work ? position_of(k) : k;
        if(position == k) {
          ++k;
          continue;
        }
        ++insertions;
        insert(k, position);
        k = (std::max)(position, std::size_t(1));
      }
    } while(insertions > insertions_before + basis.size() / 8);
  }

  // The frame of the reduced basis.
  Orthogonal_frame& frame() { return m_frame; }
  double work() const { return m_work; } // multiplications of words

private:
  static constexpr double large_factor = 1024; // after which few correct digits are left

  // Rows of the frame behind k are outdated thereafter.
  void set_row(const std::size_t k)
  {
    m_words[k] = 0;
    const long exponent = to_scaled_row(m_basis[k], m_scale, m_row, m_words[k]);
    m_frame.set_row(k, m_row, exponent);
    m_number_set = k + 1;
    m_work += 4 * static_cast<double>(k + 1) * static_cast<double>(m_scale.size()) + m_words[k];
  }

  // Moves vector k to a place before.
  void insert(std::size_t k, const std::size_t position)
  {
    bool is_accurate = true;
    for(; k > position; --k) {
      std::swap(m_basis[k - 1], m_basis[k]);
      std::swap(m_words[k - 1], m_words[k]);
      // a rotation is as uncertain as the short row that defines it
      const double length = scaled_by_power(m_frame.length_in_plane(k),
                                            m_frame.exponent(k) - m_frame.exponent(k - 1));
      is_accurate = is_accurate && length > 0.5 * m_frame.r(k - 1)[k - 1];
      if(is_accurate)
        m_frame.exchange(k, m_number_set);
      m_work += 4 * static_cast<double>(m_scale.size() + m_basis.size());
    }
    if(!is_accurate)
      set_row(position);
  }

  // Subtracts multiples of earlier vectors. Where much cancels, few correct digits are left: then
  // the row is set again from the exact vector. Each round gains some 40 bits.
  void size_reduce(const std::size_t k)
  {
    for(int round = 0; round < 100; ++round) {
      set_row(k);
      const double largest_factor = subtract_earlier_vectors(k);
      if(largest_factor == 0)
        return;
      if(largest_factor < large_factor) {
        set_row(k);
        return;
      }
    }
  }

  // Returns the size of the largest factor.
  double subtract_earlier_vectors(const std::size_t k)
  {
    double largest_factor = 0;
    for(std::size_t j = k; j-- > 0;)
      largest_factor = (std::max)(largest_factor, subtract_earlier_vector(k, j));
    return largest_factor;
  }

  double subtract_earlier_vector(const std::size_t k, const std::size_t j)
  {
    double* const row = m_frame.r(k);
    const double* const other = m_frame.r(j);
    const long exponent = m_frame.exponent(k) - m_frame.exponent(j);
    if(!(std::abs(scaled_by_power(row[j], exponent)) > 0.501 * other[j]) || other[j] == 0)
      return 0;
    const Scaled_double factor = nearest_integer(row[j] / other[j], exponent);
    subtract_multiple(m_basis[k], factor, m_basis[j]);
    m_work += m_words[j] * static_cast<double>(1 + factor.exponent / 64);
    subtract_multiple(row, scaled_by_power(factor.mantissa, factor.exponent - exponent), other,
                      j + 1);
    return scaled_by_power(std::abs(factor.mantissa), factor.exponent);
  }

  // The place of vector k: it sinks as long as it is shorter than the vector before it, with both
  // projected to the complement of all vectors before these.
  std::size_t position_of(std::size_t k) const
  {
    const double* const row = m_frame.r(k);
    const long exponent = m_frame.exponent(k);
    double rest = std::abs(row[k]);
    for(; k > 0; --k) {
      rest = std::hypot(rest, row[k - 1]); // squares would underflow
      if(rest == 0)
        break; // nothing is left after rounding: this could go on forever
      const double ratio = rest / m_frame.r(k - 1)[k - 1];
      if(!(scaled_by_power(ratio, exponent - m_frame.exponent(k - 1)) < 0.995))
        break;
    }
    return k;
  }

  std::vector<Vector>& m_basis;
  const std::vector<double>& m_scale;
  Orthogonal_frame m_frame;
  std::vector<double> m_words; // of each vector, when its row was set last
  double m_work = 0;
  std::size_t m_number_set = 0; // rows of the frame that are up to date
  std::vector<double> m_row; // scratch
};

// A reduced basis of the lattice that the rows span; right-hand sides follow.
// \pre the rows are linearly independent
inline Integer_system reduced_rows(const Integer_system& system, const std::vector<Row_index>& rows,
                                   const std::vector<double>& weights)
{
  const std::size_t n = system.number_of_columns();
  std::vector<std::vector<Exact_integer> > basis;
  for(const Row_index row : rows) {
    basis.emplace_back(n + 1, Exact_integer(0)); // the right-hand side is the last
    const Integer_row<Exact_integer> exact = system.exact_row(std::size_t(row));
    for(const Entry<Exact_integer>& e : exact.entries)
      basis.back()[std::size_t(e.column)] = e.coefficient;
    basis.back()[n] = exact.right_hand_side;
  }
  std::vector<double> scale;
  for(const double w : weights)
    scale.push_back(1. / std::sqrt(w));
  scale.push_back(0.);
  Lattice_reduction<Exact_integer>(basis, scale);

  Integer_system result(n);
  result.set_right_hand_scale(system.right_hand_scale());
  for(const std::vector<Exact_integer>& v : basis) {
    Integer_row<Exact_integer> row;
    for(std::size_t j = 0; j < n; ++j)
      if(v[j] != 0)
        row.entries.push_back({Column_index(j), v[j]});
    row.right_hand_side = v[n];
    result.add_row(std::move(row));
  }
  return result;
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LATTICE_REDUCTION_H
