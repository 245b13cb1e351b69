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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_LINEAR_ORTHOGONAL_FRAME_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_LINEAR_ORTHOGONAL_FRAME_H

#include <CGAL/license/Seamless_snapping.h>

// Gram-Schmidt orthogonalization in floating point, for the two algorithms that choose among
// lattice vectors: basis reduction and rounding to a near lattice point. Inexact throughout:
// nothing here decides whether something holds, only which of several exact choices is a good one.
//
// Numbers of hundreds of bits come as rows of doubles that share one binary exponent.

#include <CGAL/Seamless_snapping/internal/linear/Scaled_double.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Writes the first components of v, each times its scale, as `row` 2^(returned exponent).
template <typename Real>
long to_scaled_row(const std::vector<std::int64_t>& v, const std::vector<double>& scale,
                   const std::size_t dimension, std::vector<Real>& row)
{
  row.resize(dimension);
  for(std::size_t i = 0; i < dimension; ++i)
    row[i] = static_cast<Real>(v[i]) * static_cast<Real>(scale[i]);
  return 0;
}

template <typename Real>
long to_scaled_row(const std::vector<Exact_integer>& v, const std::vector<double>& scale,
                   const std::size_t dimension, std::vector<Real>& row)
{
  std::vector<Scaled_double> numbers(dimension);
  long exponent = 0;
  for(std::size_t i = 0; i < dimension; ++i) {
    numbers[i] = to_scaled_double(v[i]);
    exponent = (std::max)(exponent, numbers[i].exponent);
  }
  row.resize(dimension);
  for(std::size_t i = 0; i < dimension; ++i)
    row[i] = scaled_by_power(numbers[i].mantissa, numbers[i].exponent - exponent) * scale[i];
  return exponent;
}

// Several partial sums: they keep the processor busy, and the rounding error small.
template <typename Real>
Real inner_product(const Real* a, const Real* b, const std::size_t n)
{
  Real s[4] = { 0, 0, 0, 0 };
  std::size_t i = 0;
  for(; i + 4 <= n; i += 4)
    for(std::size_t l = 0; l < 4; ++l)
      s[l] += a[i + l] * b[i + l];
  for(; i < n; ++i)
    s[0] += a[i] * b[i];
  return (s[0] + s[1]) + (s[2] + s[3]);
}

template <typename Real>
void subtract_multiple(Real* a, const Real factor, const Real* b, const std::size_t n)
{
  for(std::size_t i = 0; i < n; ++i)
    a[i] -= factor * b[i];
}

// Rows f_k = sum_{j <= k} r(k, j) q_j with orthonormal q_j. The true row is f_k 2^exponent(k).
template <typename Real>
class Orthogonal_frame
{
public:
  Orthogonal_frame(const std::size_t number_of_rows, const std::size_t dimension)
    : m_dimension(dimension), m_number_of_rows(number_of_rows), m_q(number_of_rows * dimension),
      m_r(number_of_rows * number_of_rows), m_exponents(number_of_rows, 0)
  { }

  std::size_t dimension() const { return m_dimension; }
  Real* r(const std::size_t k) { return m_r.data() + k * m_number_of_rows; }
  const Real* r(const std::size_t k) const { return m_r.data() + k * m_number_of_rows; }
  long exponent(const std::size_t k) const { return m_exponents[k]; }

  // Sets row k, given that rows 0 to k - 1 are set.
  void set_row(const std::size_t k, const std::vector<Real>& f, const long exponent)
  {
    m_exponents[k] = exponent;
    Real* const residual = m_q.data() + k * m_dimension;
    std::copy(f.begin(), f.end(), residual);
    std::fill(r(k), r(k) + k, Real(0));
    project(k, residual, r(k));
    const Real length = std::sqrt(inner_product(residual, residual, m_dimension));
    r(k)[k] = length;
    if(length > 0)
      for(std::size_t i = 0; i < m_dimension; ++i)
        residual[i] /= length;
  }

  // Splits v into sum_{j < k} c_j q_j, where c is added to `coefficients`, and an orthogonal rest
  // that replaces v.
  void project(const std::size_t k, Real* v, Real* coefficients) const
  {
    // Where most of a vector cancels, so do its correct digits: once more restores orthogonality.
    Real before = inner_product(v, v, m_dimension);
    for(int pass = 0; pass < 3; ++pass) {
      for(std::size_t j = 0; j < k; ++j) {
        const Real* const q = m_q.data() + j * m_dimension;
        const Real c = inner_product(v, q, m_dimension);
        if(c == 0)
          continue;
        coefficients[j] += c;
        subtract_multiple(v, c, q, m_dimension);
      }
      const Real after = inner_product(v, v, m_dimension);
      if(after > Real(0.01) * before)
        break;
      before = after;
    }
  }

  // Follows an exchange of the rows k - 1 and k by one plane rotation; rows up to `end` are set.
  void exchange(const std::size_t k, const std::size_t end)
  {
    const Real length = std::hypot(r(k)[k - 1], r(k)[k]);
    const Real c = r(k)[k - 1] / length, s = r(k)[k] / length;
    for(std::size_t j = 0; j + 1 < k; ++j)
      std::swap(r(k)[j], r(k - 1)[j]);
    std::swap(m_exponents[k - 1], m_exponents[k]);
    const Real old_length = r(k - 1)[k - 1];
    r(k - 1)[k - 1] = length;
    r(k)[k - 1] = old_length * c;
    r(k)[k] = old_length * s;
    Real* const p = m_q.data() + (k - 1) * m_dimension;
    Real* const q = m_q.data() + k * m_dimension;
    for(std::size_t i = 0; i < m_dimension; ++i)
      rotate(c, s, p[i], q[i]);
    for(std::size_t i = k + 1; i < end; ++i)
      rotate(c, s, r(i)[k - 1], r(i)[k]);
  }

private:
  static void rotate(const Real c, const Real s, Real& a, Real& b)
  {
    const Real old_a = a;
    a = c * old_a + s * b;
    b = s * old_a - c * b;
  }

  std::size_t m_dimension;
  std::size_t m_number_of_rows;
  std::vector<Real> m_q;
  std::vector<Real> m_r;
  std::vector<long> m_exponents;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_LINEAR_ORTHOGONAL_FRAME_H
