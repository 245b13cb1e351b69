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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LATTICE_METRIC_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LATTICE_METRIC_H

#include <CGAL/license/Linear_snapping.h>

// A lattice together with a weighted Euclidean norm, in which near lattice points are looked for.
// The point found is a lattice point exactly; that it is near rests on floating point arithmetic.

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
  Lattice_metric(const std::vector<Vector>& basis, const std::vector<double>& weights)
    : m_scale(weights.size()), m_frame(0, 0)
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
    for(int rounds_left = 3; rounds_left > 0; --rounds_left) {
      const long exponent = to_scaled_row(difference, m_scale, row);
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
  static void convert(const std::int64_t a, Exact_integer& b)
  { b = from_64_bits<Exact_integer>(a); }

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
    m_frame = std::move(Lattice_reduction<Integer>(vectors, m_scale).frame());
    m_basis.clear();
    for(const std::vector<Integer>& v : vectors) {
      Vector sparse;
      for(std::size_t i = 0; i < v.size(); ++i)
        if(v[i] != 0) {
          sparse.push_back({Column_index(i), Exact_integer(0)});
          convert(v[i], sparse.back().coefficient);
        }
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
  std::vector<Vector> m_basis;
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_LATTICE_METRIC_H
