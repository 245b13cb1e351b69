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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_FPLLL_REDUCTION_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_FPLLL_REDUCTION_H

#include <CGAL/license/Linear_snapping.h>

// LLL reduction by fplll, for those who define CGAL_USE_FPLLL and link with it.

#if defined(CGAL_USE_FPLLL) || defined(DOXYGEN_RUNNING)

#include <CGAL/Linear_snapping/internal/exact/checked_integer.h>

#include <fplll.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

inline void assign(const Exact_integer& a, mpz_t& result) // whatever type CGAL has chosen
{
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os << a;
  mpz_set_str(result, os.str().c_str(), 10);
}

inline void assign(const mpz_t& a, Exact_integer& result)
{
  std::vector<char> digits(mpz_sizeinbase(a, 10) + 2);
  mpz_get_str(digits.data(), 10, a);
  std::istringstream is(std::string(digits.data()));
  is.imbue(std::locale::classic());
  is >> result;
}

// Reduces `basis` in place with respect to the norm |scale_i v_i|. Returns false, with the basis as
// it was, if fplll gives up or there is nothing to reduce. The lattice stays the same: what is
// applied is one matrix of integers of determinant +-1.
inline bool reduce_by_fplll(std::vector<std::vector<std::int64_t> >&, const std::vector<double>&)
{
  return false; // what follows is faster
}

inline bool reduce_by_fplll(std::vector<std::vector<Exact_integer> >& basis,
                            const std::vector<double>& scale)
{
  if(basis.size() < 2)
    return false;
  const int rows = static_cast<int>(basis.size()), columns = static_cast<int>(scale.size());
  const double smallest = *std::min_element(scale.begin(), scale.end());
  const bool is_uniform =
    std::all_of(scale.begin(), scale.end(), [&](const double s) { return s == smallest; });
  fplll::ZZ_mat<mpz_t> original(rows, columns);
  for(int i = 0; i < rows; ++i)
    for(int j = 0; j < columns; ++j)
      assign(basis[std::size_t(i)][std::size_t(j)], original(i, j).get_data());

  fplll::ZZ_mat<mpz_t> reduced(original);
  if(is_uniform) {
    if(fplll::lll_reduction(reduced) != fplll::RED_SUCCESS)
      return false;
  } else {
    // Scales become integers of 20 bits or more: they only tell which vectors count as short.
    fplll::ZZ_mat<mpz_t> scaled(original), transform(rows, rows);
    fplll::Z_NR<mpz_t> factor;
    for(int j = 0; j < columns; ++j) {
      mpz_set_d(factor.get_data(), std::ldexp(scale[std::size_t(j)] / smallest, 20));
      for(int i = 0; i < rows; ++i)
        scaled(i, j).mul(scaled(i, j), factor);
    }
    if(fplll::lll_reduction(scaled, transform) != fplll::RED_SUCCESS)
      return false;
    for(int i = 0; i < rows; ++i)
      for(int j = 0; j < columns; ++j) {
        reduced(i, j) = 0;
        for(int k = 0; k < rows; ++k)
          reduced(i, j).addmul(transform(i, k), original(k, j));
      }
  }
  for(int i = 0; i < rows; ++i)
    for(int j = 0; j < columns; ++j)
      assign(reduced(i, j).get_data(), basis[std::size_t(i)][std::size_t(j)]);
  return true;
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_USE_FPLLL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_FPLLL_REDUCTION_H
