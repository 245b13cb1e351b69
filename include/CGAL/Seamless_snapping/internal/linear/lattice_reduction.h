// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_LINEAR_LATTICE_REDUCTION_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_LINEAR_LATTICE_REDUCTION_H

#include <CGAL/license/Seamless_snapping.h>

// LLL reduction of a lattice basis: short, nearly orthogonal vectors that span the same lattice.
// Every operation on the basis is an exact unimodular one, so the lattice stays the same no matter
// how the floating point numbers that choose the operations are rounded.

#include <CGAL/Seamless_snapping/internal/linear/Orthogonal_frame.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// \pre |mantissa| is an integer below 2^53
template <typename Integer>
Integer scaled_integer(const double mantissa, const long exponent);

template <>
inline std::int64_t scaled_integer<std::int64_t>(const double mantissa, const long exponent)
{
  const double value = scaled_by_power(mantissa, exponent);
  if(!(std::abs(value) < machine_integer_bound))
    throw Integer_overflow();
  return static_cast<std::int64_t>(value);
}

template <>
inline Exact_integer scaled_integer<Exact_integer>(const double mantissa, const long exponent)
{
  const Exact_integer value(mantissa);
  if(exponent == 0)
    return value;
  return Exact_integer(value * power_of_two(static_cast<std::size_t>(exponent)));
}

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

// a -= factor b
inline void subtract_multiple(std::vector<Exact_integer>& a, const Exact_integer& factor,
                              const std::vector<Exact_integer>& b)
{
  for(std::size_t i = 0; i < a.size(); ++i)
    if(b[i] != 0)
      a[i] = difference_with_product(a[i], factor, b[i]);
}

inline double largest_absolute_value(const std::vector<std::int64_t>& v)
{
  std::int64_t largest = 0;
  for(const std::int64_t a : v)
    largest = (std::max)(largest, a < 0 ? -a : a);
  return static_cast<double>(largest);
}

// The caller makes sure that nothing overflows: the loop must be fast.
inline void subtract_multiple(std::vector<std::int64_t>& a, const std::int64_t factor,
                              const std::vector<std::int64_t>& b)
{
  for(std::size_t i = 0; i < a.size(); ++i)
    a[i] -= factor * b[i];
}

// Upper bounds of the entries of each vector, so that one check for a vector replaces one for each
// entry. Throws `Integer_overflow` where a result might not fit; multiprecision integers always do.
template <typename Integer>
class Entry_bounds
{
public:
  explicit Entry_bounds(const std::vector<std::vector<Integer> >&) { }
  void exchange(const std::size_t) { }
  void subtract(const std::size_t, const Integer&, const std::size_t) { }
};

template <>
class Entry_bounds<std::int64_t>
{
public:
  explicit Entry_bounds(const std::vector<std::vector<std::int64_t> >& vectors)
    : m_vectors(vectors), m_bounds(vectors.size())
  {
    for(std::size_t k = 0; k < vectors.size(); ++k)
      m_bounds[k] = largest_absolute_value(vectors[k]);
  }

  void exchange(const std::size_t k) { std::swap(m_bounds[k - 1], m_bounds[k]); }

  // To be called before vector k loses a multiple of vector j.
  void subtract(const std::size_t k, const std::int64_t factor, const std::size_t j)
  {
    const double f = std::abs(static_cast<double>(factor));
    if(!(m_bounds[k] + f * m_bounds[j] < machine_integer_bound)) {
      m_bounds[k] = largest_absolute_value(m_vectors[k]);
      m_bounds[j] = largest_absolute_value(m_vectors[j]);
      if(!(m_bounds[k] + f * m_bounds[j] < machine_integer_bound))
        throw Integer_overflow();
    }
    m_bounds[k] += f * m_bounds[j];
  }

private:
  const std::vector<std::vector<std::int64_t> >& m_vectors;
  std::vector<double> m_bounds;
};

// Reduces `basis` in place with respect to the norm |scale_i v_i|. The vectors must be linearly
// independent. The work is bounded: in the unlikely case that rounding errors keep the algorithm
// from coming to an end, the basis is left less reduced, but still a basis.
template <typename Integer, typename Real = double>
class Lattice_reduction
{
public:
  using Vector = std::vector<Integer>;

  // With an `exchange_limit` of 0, vectors are made shorter by multiples of earlier ones only.
  Lattice_reduction(std::vector<Vector>& basis, const std::vector<double>& scale,
                    const std::size_t exchange_limit = 1000000, const bool is_deep = false)
    : m_basis(basis), m_scale(scale), m_frame(basis.size(), dimension_of(scale)), m_bounds(basis),
      m_errors(basis.size(), Real(0)),
      m_exchange_limit(exchange_limit), m_is_deep(is_deep)
  {
    // Errors add up from exchange to exchange: what seems reduced is looked at afresh.
    std::size_t exchanges_before = 0;
    do {
      exchanges_before = m_number_of_exchanges;
      m_number_set = 0;
      reduce();
    } while(m_number_of_exchanges > exchanges_before + basis.size() / 8);
  }

  // That of the reduced basis.
  Orthogonal_frame<Real>& frame() { return m_frame; }
  std::size_t number_of_exchanges() const { return m_number_of_exchanges; }

private:
  // Components of scale 0 at the end only keep track of what is done.
  static std::size_t dimension_of(const std::vector<double>& scale)
  {
    std::size_t dimension = scale.size();
    while(dimension > 0 && scale[dimension - 1] == 0)
      --dimension;
    return dimension;
  }

  void reduce()
  {
    const std::size_t size = m_basis.size();
    for(std::size_t k = 0; k < size;) {
      if(k >= m_number_set) {
        set_rows(k, k);
        size_reduce(k);
      } else if(k > 0) {
        subtract_earlier_vector(k, k - 1); // is all that the order depends on
      }
      std::size_t position = k;
      if(is_well_ordered(k)) {
        size_reduce(k);
        position = insertion_position(k);
      } else {
        position = k - 1;
      }
      if(position + 1 == k)
        exchange(k);
      else if(position < k)
        insert(k, position);
      k = position == k ? k + 1 : (std::max)(position, std::size_t(1));
    }
  }

  // Where vector k belongs: with deep insertions at the first place where it is shorter than the
  // vector there, with both projected to the complement of all vectors before.
  std::size_t insertion_position(const std::size_t k) const
  {
    if(!m_is_deep)
      return is_well_ordered(k) ? k : k - 1;
    if(m_number_of_exchanges >= m_exchange_limit)
      return k;
    Real rest = inner_product(m_frame.r(k), m_frame.r(k), k + 1);
    for(std::size_t i = 0; i < k; ++i) {
      const Real length = m_frame.r(i)[i];
      if(rest < Real(0.99) * length * length)
        return i;
      rest -= m_frame.r(k)[i] * m_frame.r(k)[i];
    }
    return k;
  }

  // Rows of the frame behind `last` are outdated thereafter.
  void set_rows(const std::size_t first, const std::size_t last)
  {
    for(std::size_t k = first; k <= last; ++k) {
      const long exponent = to_scaled_row(m_basis[k], m_scale, m_frame.dimension(), m_row);
      m_frame.set_row(k, m_row, exponent);
      m_errors[k] = error_when_set(k);
    }
    m_number_set = last + 1;
  }

  Real error_when_set(const std::size_t k) const
  {
    return 8 * std::numeric_limits<Real>::epsilon() *
           std::sqrt(inner_product(m_frame.r(k), m_frame.r(k), k + 1));
  }

  void exchange(const std::size_t k)
  {
    ++m_number_of_exchanges;
    std::swap(m_basis[k - 1], m_basis[k]);
    m_bounds.exchange(k);
    // The rotation is as uncertain as the short row that defines it.
    const Real amplification = m_frame.r(k - 1)[k - 1] / length_in_plane(k);
    m_frame.exchange(k, m_number_set);
    m_errors[k - 1] += m_errors[k] * amplification;
    std::swap(m_errors[k - 1], m_errors[k]);
  }

  // What changes that much is better set again than rotated.
  void insert(const std::size_t k, const std::size_t position)
  {
    for(std::size_t i = k; i > position; --i) {
      ++m_number_of_exchanges;
      std::swap(m_basis[i - 1], m_basis[i]);
      m_bounds.exchange(i);
    }
    set_rows(position, position);
  }

  // Subtracts multiples of earlier vectors. Where much cancels, few correct digits are left: then
  // rows are set again from the exact vectors.
  void size_reduce(const std::size_t k)
  {
    subtract_earlier_vectors(k);
    // Each round gains some 40 bits, unless the vectors are too nearly dependent for this arithmetic.
    for(int round = 0; round < 100 && is_inaccurate(k); ++round) {
      std::size_t first = k;
      for(std::size_t j = k; j-- > 0;)
        if(is_inaccurate(j))
          first = j;
      set_rows(first, k);
      subtract_earlier_vectors(k);
    }
  }

  // And would be much better if set again.
  bool is_inaccurate(const std::size_t k) const
  {
    const Real error = m_errors[k];
    return error > Real(1e-6) * length_in_plane(k) && error > 1e3 * error_when_set(k);
  }

  // The length of the vector's part that is orthogonal to all earlier ones but the last.
  Real length_in_plane(const std::size_t k) const
  {
    return k == 0 ? m_frame.r(0)[0] : std::hypot(m_frame.r(k)[k - 1], m_frame.r(k)[k]);
  }

  void subtract_earlier_vectors(const std::size_t k)
  {
    for(std::size_t j = k; j-- > 0;)
      subtract_earlier_vector(k, j);
  }

  void subtract_earlier_vector(const std::size_t k, const std::size_t j)
  {
    Real* const row = m_frame.r(k);
    const Real* const other = m_frame.r(j);
    const long exponent = m_frame.exponent(k) - m_frame.exponent(j);
    if(!(std::abs(scaled_by_power(row[j], exponent)) > Real(0.501) * other[j]) || other[j] == 0)
      return;
    const Scaled_double factor = nearest_integer(static_cast<double>(row[j] / other[j]), exponent);
    const Integer multiple = scaled_integer<Integer>(factor.mantissa, factor.exponent);
    m_bounds.subtract(k, multiple, j);
    subtract_multiple(m_basis[k], multiple, m_basis[j]);
    subtract_multiple(row, scaled_by_power(factor.mantissa, factor.exponent - exponent),
                      other, j + 1);
  }

  bool is_well_ordered(const std::size_t k) const
  {
    const Real length = length_in_plane(k);
    if(k == 0 || length == 0 || m_number_of_exchanges >= m_exchange_limit)
      return true; // nothing is left after rounding: an exchange could go on forever
    const Real ratio = scaled_by_power(length / m_frame.r(k - 1)[k - 1],
                                         m_frame.exponent(k) - m_frame.exponent(k - 1));
    return ratio * ratio >= Real(0.99);
  }

  std::vector<Vector>& m_basis;
  const std::vector<double>& m_scale;
  Orthogonal_frame<Real> m_frame;
  Entry_bounds<Integer> m_bounds;
  std::vector<Real> m_errors; // estimates of the rows' absolute errors, without their exponents
  std::vector<Real> m_row;
  std::size_t m_exchange_limit;
  bool m_is_deep;
  std::size_t m_number_set = 0; // rows of the frame that are up to date
  std::size_t m_number_of_exchanges = 0;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_LINEAR_LATTICE_REDUCTION_H
