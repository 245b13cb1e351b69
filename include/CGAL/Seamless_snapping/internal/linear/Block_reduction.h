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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_LINEAR_BLOCK_REDUCTION_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_LINEAR_BLOCK_REDUCTION_H

#include <CGAL/license/Seamless_snapping.h>

// Reduction of a basis of hundreds of vectors.

#include <CGAL/Seamless_snapping/internal/linear/fplll_reduction.h>
#include <CGAL/Seamless_snapping/internal/linear/lattice_reduction.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Multiprecision integers need no bounds.
inline double largest_absolute_value(const std::vector<Exact_integer>&) { return 0; }

// The same for many vectors, much faster: exchanges happen within blocks of consecutive vectors,
// whose projections to the complement of all earlier ones are short tuples of numbers. Only the sum
// of many operations is applied to the vectors themselves.
template <typename Integer>
class Block_reduction
{
public:
  using Vector = std::vector<Integer>;
  static constexpr std::size_t block_size = 64;

  Block_reduction(std::vector<Vector>& basis, const std::vector<double>& scale)
    : m_basis(basis), m_scale(scale), m_frame(0, 0)
  {
    const std::size_t shift = block_size / 2;
    std::size_t previous = (std::numeric_limits<std::size_t>::max)();
    const std::size_t number_of_sweeps = affordable_sweeps();
    for(std::size_t sweep = 0; sweep < number_of_sweeps; ++sweep) {
      set_frame();
      const std::size_t exchanges = reduce_blocks(sweep % 2 == 0 ? 0 : shift);
      m_number_of_exchanges += exchanges;
      // Each boundary between blocks lies within a block of the next sweep.
      if(exchanges == 0 && previous == 0)
        return;
      if(exchanges <= basis.size() / 8 && previous <= basis.size() / 8)
        break;
      previous = exchanges;
    }
    set_frame();
  }

  Orthogonal_frame<double>& frame() { return m_frame; }
  std::size_t number_of_exchanges() const { return m_number_of_exchanges; }

private:
  // A sweep costs one orthogonalization at least. Bases of a thousand vectors have to be reduced
  // well beforehand.
  std::size_t affordable_sweeps() const
  {
    const double size = static_cast<double>(m_basis.size());
    const double cost = 4 * size * size * static_cast<double>(m_scale.size());
    return static_cast<std::size_t>((std::min)(20., 4e9 / cost));
  }

  void set_frame()
  {
    Lattice_reduction<Integer> reduction(m_basis, m_scale, 0);
    m_frame = std::move(reduction.frame());
  }

  std::size_t reduce_blocks(const std::size_t first)
  {
    std::size_t exchanges = 0;
    for(std::size_t begin = 0; begin < m_basis.size();) {
      const std::size_t end = (std::min)(begin == 0 && first > 0 ? first : begin + block_size,
                                         m_basis.size());
      exchanges += reduce_block(begin, end);
      begin = end;
    }
    return exchanges;
  }

  // The tuples are rounded to integers, with the combinations that they stand for in columns of
  // weight 0 behind: so the reduction keeps track of what it does.
  std::size_t reduce_block(const std::size_t begin, const std::size_t end)
  {
    const std::size_t size = end - begin;
    long exponent = m_frame.exponent(begin);
    for(std::size_t k = begin; k < end; ++k)
      exponent = (std::max)(exponent, m_frame.exponent(k));
    double largest = 0;
    for(std::size_t k = begin; k < end; ++k)
      for(std::size_t j = begin; j <= k; ++j)
        largest = (std::max)(largest, std::abs(entry(k, j, exponent)));
    int bits = 0;
    std::frexp(largest, &bits);
    std::vector<std::vector<std::int64_t> > tuples(size, std::vector<std::int64_t>(2 * size, 0));
    for(std::size_t k = begin; k < end; ++k) {
      for(std::size_t j = begin; j <= k; ++j)
        tuples[k - begin][j - begin] =
          static_cast<std::int64_t>(std::ldexp(entry(k, j, exponent), 45 - bits));
      tuples[k - begin][size + k - begin] = 1;
    }
    std::vector<double> scale(2 * size, 0.);
    std::fill(scale.begin(), scale.begin() + std::ptrdiff_t(size), 1.);
    // Deep insertions give shorter vectors, but may take very long to come to an end.
    const std::size_t exchanges = reduce_tuples(tuples, scale, 1000000, false) +
                                  reduce_tuples(tuples, scale, 30000, true);
    if(exchanges > 0)
      apply(begin, tuples);
    return exchanges;
  }

  // Where rounding errors make the numbers explode, the tuples stay as they are.
  static std::size_t reduce_tuples(std::vector<std::vector<std::int64_t> >& tuples,
                                   const std::vector<double>& scale, const std::size_t limit,
                                   const bool is_deep)
  {
    std::vector<std::vector<std::int64_t> > candidate = tuples;
    try {
      const Lattice_reduction<std::int64_t> reduction(candidate, scale, limit, is_deep);
      tuples.swap(candidate);
      return reduction.number_of_exchanges();
    } catch(const Integer_overflow&) {
      return 0;
    }
  }

  double entry(const std::size_t k, const std::size_t j, const long exponent) const
  {
    return scaled_by_power(m_frame.r(k)[j], m_frame.exponent(k) - exponent);
  }

  void apply(const std::size_t begin, const std::vector<std::vector<std::int64_t> >& tuples)
  {
    const std::size_t size = tuples.size();
    std::vector<Vector> combined(size, Vector(m_scale.size(), Integer(0)));
    std::vector<Vector> old(m_basis.begin() + std::ptrdiff_t(begin),
                            m_basis.begin() + std::ptrdiff_t(begin + size));
    for(std::size_t k = 0; k < size; ++k) {
      double bound = 0;
      for(std::size_t j = 0; j < size; ++j)
        if(tuples[k][size + j] != 0) {
          bound += std::abs(static_cast<double>(tuples[k][size + j])) *
                   largest_absolute_value(old[j]);
          check_bound(bound, combined[k]);
          subtract_multiple(combined[k], Integer(-tuples[k][size + j]), old[j]);
        }
    }
    std::move(combined.begin(), combined.end(), m_basis.begin() + std::ptrdiff_t(begin));
  }

  static void check_bound(const double bound, const std::vector<std::int64_t>&)
  {
    if(!(bound < machine_integer_bound))
      throw Integer_overflow();
  }
  static void check_bound(const double, const std::vector<Exact_integer>&) { }

  std::vector<Vector>& m_basis;
  const std::vector<double>& m_scale;
  Orthogonal_frame<double> m_frame;
  std::size_t m_number_of_exchanges = 0;
};

// Returns the frame of the reduced basis.
template <typename Integer>
Orthogonal_frame<double> reduce_basis(std::vector<std::vector<Integer> >& basis,
                                      const std::vector<double>& scale)
{
#ifdef CGAL_USE_FPLLL
  if constexpr(std::is_same<Integer, Exact_integer>::value) // for 64 bits what follows is faster
    if(reduce_by_fplll(basis, scale))
      return std::move(Lattice_reduction<Integer>(basis, scale, 0).frame());
#endif
  if(basis.size() <= Block_reduction<Integer>::block_size)
    return std::move(Lattice_reduction<Integer>(basis, scale).frame());
  return std::move(Block_reduction<Integer>(basis, scale).frame());
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_LINEAR_BLOCK_REDUCTION_H
