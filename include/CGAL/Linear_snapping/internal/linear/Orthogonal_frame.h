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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_ORTHOGONAL_FRAME_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_ORTHOGONAL_FRAME_H

#include <CGAL/license/Linear_snapping.h>

// Gram-Schmidt orthogonalization in floating point, for the two algorithms that choose among
// lattice vectors: basis reduction and rounding to a near lattice point. Inexact throughout:
// nothing here decides whether something holds, only which of several exact choices is a good one.
//
// Numbers of hundreds of bits come as rows of doubles that share one binary exponent.

#include <CGAL/Linear_snapping/internal/exact/checked_integer.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// How many multiplications take as long as an operation on short `Exact_integer`s.
constexpr long exact_operation = 100;

// mantissa 2^exponent
struct Scaled_double
{
  double mantissa;
  long exponent;
};

inline Scaled_double to_scaled_double(const std::int64_t a)
{
  return {static_cast<double>(a), 0};
}

// The relative error is a few ulps, whatever the size of the integer.
inline BOOST_NOINLINE Scaled_double to_scaled_double(const Exact_integer& a)
{
  static const Exact_integer too_large = power_of_two(960);
  static const Exact_integer divisor = power_of_two(512);
  Exact_integer rest = a;
  long exponent = 0;
  while(rest >= too_large || Exact_integer(-rest) >= too_large) {
    rest = Exact_integer(rest / divisor);
    exponent += 512;
  }
  int binary_exponent = 0;
  const double mantissa = std::frexp(CGAL::to_double(rest), &binary_exponent);
  return {mantissa, mantissa == 0 ? 0 : exponent + binary_exponent};
}

// ldexp for exponents of any size.
inline double scaled_by_power(const double a, const long exponent)
{
  if(exponent == 0 || a == 0)
    return a;
  return std::ldexp(a, static_cast<int>((std::max)(-5000L, (std::min)(5000L, exponent))));
}

// Writes v, each component times its scale, as `row` 2^(returned exponent). Adds to `words` the
// words of the components.
inline long to_scaled_row(const std::vector<std::int64_t>& v, const std::vector<double>& scale,
                          std::vector<double>& row, double& words)
{
  words += static_cast<double>(v.size());
  row.resize(v.size());
  for(std::size_t i = 0; i < v.size(); ++i)
    row[i] = static_cast<double>(v[i]) * scale[i];
  return 0;
}

// The largest component becomes about 1: where it had a large scale, or a component with the scale
// 0 was larger, squares would underflow.
inline long to_scaled_row(const std::vector<Exact_integer>& v, const std::vector<double>& scale,
                          std::vector<double>& row, double& words)
{
  row.resize(v.size());
  std::vector<long> exponents(v.size());
  long largest = (std::numeric_limits<long>::min)();
  for(std::size_t i = 0; i < v.size(); ++i) {
    const Scaled_double number = to_scaled_double(v[i]);
    words += static_cast<double>(exact_operation + number.exponent / 64);
    int bits = 0;
    row[i] = std::frexp(number.mantissa * scale[i], &bits);
    exponents[i] = number.exponent + bits;
    if(row[i] != 0)
      largest = (std::max)(largest, exponents[i]);
  }
  if(largest == (std::numeric_limits<long>::min)())
    return 0;
  for(std::size_t i = 0; i < v.size(); ++i)
    row[i] = scaled_by_power(row[i], exponents[i] - largest);
  return largest;
}

// Several partial sums: they keep the processor busy, and the rounding error small.
inline double inner_product(const double* a, const double* b, const std::size_t n)
{
  double s[4] = { 0, 0, 0, 0 };
  std::size_t i = 0;
  for(; i + 4 <= n; i += 4)
    for(std::size_t l = 0; l < 4; ++l)
      s[l] += a[i + l] * b[i + l];
  for(; i < n; ++i)
    s[0] += a[i] * b[i];
  return (s[0] + s[1]) + (s[2] + s[3]);
}

// The square root of the sum of squares, also where these underflow.
inline double length(const double* a, const std::size_t n)
{
  const double squares = inner_product(a, a, n);
  if(squares > 1e-280)
    return std::sqrt(squares);
  double result = 0;
  for(std::size_t i = 0; i < n; ++i)
    result = std::hypot(result, a[i]);
  return result;
}

inline void subtract_multiple(double* a, const double factor, const double* b, const std::size_t n)
{
  for(std::size_t i = 0; i < n; ++i)
    a[i] -= factor * b[i];
}

// Rows f_k = sum_{j <= k} r(k, j) q_j with orthonormal q_j. The true row is f_k 2^exponent(k).
class Orthogonal_frame
{
public:
  Orthogonal_frame(const std::size_t number_of_rows, const std::size_t dimension)
    : m_dimension(dimension), m_number_of_rows(number_of_rows), m_q(number_of_rows * dimension),
      m_r(number_of_rows * number_of_rows), m_exponents(number_of_rows, 0)
  { }

  double* r(const std::size_t k) { return m_r.data() + k * m_number_of_rows; }
  const double* r(const std::size_t k) const { return m_r.data() + k * m_number_of_rows; }
  long exponent(const std::size_t k) const { return m_exponents[k]; }

  // Sets row k, given that rows 0 to k - 1 are set.
  void set_row(const std::size_t k, const std::vector<double>& f, const long exponent)
  {
    m_exponents[k] = exponent;
    double* const rest = m_q.data() + k * m_dimension;
    std::copy(f.begin(), f.end(), rest);
    std::fill(r(k), r(k) + k, 0.);
    project(k, rest, r(k));
    const double size = length(rest, m_dimension);
    r(k)[k] = size;
    if(size > 0)
      for(std::size_t i = 0; i < m_dimension; ++i)
        rest[i] /= size;
  }

  // Splits v into sum_{j < k} c_j q_j, where c is added to `coefficients`, and an orthogonal rest
  // that replaces v.
  void project(const std::size_t k, double* v, double* coefficients) const
  {
    // If most of a vector cancels, so do its correct digits: once more restores orthogonality.
    double before = inner_product(v, v, m_dimension);
    for(int pass = 0; pass < 3; ++pass) {
      for(std::size_t j = 0; j < k; ++j) {
        const double* const q = m_q.data() + j * m_dimension;
        const double c = inner_product(v, q, m_dimension);
        if(c == 0)
          continue;
        coefficients[j] += c;
        subtract_multiple(v, c, q, m_dimension);
      }
      const double after = inner_product(v, v, m_dimension);
      if(after > 0.01 * before)
        break;
      before = after;
    }
  }

  // The length of row k, projected to the complement of the rows before k - 1.
  double length_in_plane(const std::size_t k) const { return std::hypot(r(k)[k - 1], r(k)[k]); }

  // Follows an exchange of the rows k - 1 and k by one plane rotation; rows up to `end` are set.
  void exchange(const std::size_t k, const std::size_t end)
  {
    const double length = length_in_plane(k);
    const double c = r(k)[k - 1] / length, s = r(k)[k] / length;
    std::swap_ranges(r(k), r(k) + (k - 1), r(k - 1));
    std::swap(m_exponents[k - 1], m_exponents[k]);
    const double old_length = r(k - 1)[k - 1];
    r(k - 1)[k - 1] = length;
    r(k)[k - 1] = old_length * c;
    r(k)[k] = old_length * s;
    double* const p = m_q.data() + (k - 1) * m_dimension;
    double* const q = m_q.data() + k * m_dimension;
    for(std::size_t i = 0; i < m_dimension; ++i)
      rotate(c, s, p[i], q[i]);
    for(std::size_t i = k + 1; i < end; ++i)
      rotate(c, s, r(i)[k - 1], r(i)[k]);
  }

private:
  static void rotate(const double c, const double s, double& a, double& b)
  {
    const double old_a = a;
    a = c * old_a + s * b;
    b = s * old_a - c * b;
  }

  std::size_t m_dimension;
  std::size_t m_number_of_rows;
  std::vector<double> m_q;
  std::vector<double> m_r;
  std::vector<long> m_exponents;
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_ORTHOGONAL_FRAME_H
