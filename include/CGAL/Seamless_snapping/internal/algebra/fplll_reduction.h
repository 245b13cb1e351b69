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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_FPLLL_REDUCTION_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_FPLLL_REDUCTION_H

#include <CGAL/license/Seamless_snapping.h>

// LLL reduction by fplll, for those who define CGAL_USE_FPLLL and link with it.

#if defined(CGAL_USE_FPLLL) || defined(DOXYGEN_RUNNING)

#include <CGAL/Seamless_snapping/internal/algebra/checked_integer.h>

#include <fplll.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

inline void assign(const std::int64_t a, mpz_t& result) { mpz_set_si(result, static_cast<long>(a)); }

inline void assign(const Exact_integer& a, mpz_t& result) // whatever type CGAL has chosen
{
  std::ostringstream os;
  os << a;
  mpz_set_str(result, os.str().c_str(), 10);
}

inline void assign(const mpz_t& a, std::int64_t& result)
{
  if(mpz_sizeinbase(a, 2) > 62)
    throw Integer_overflow();
  result = static_cast<std::int64_t>(mpz_get_si(a));
}

inline void assign(const mpz_t& a, Exact_integer& result)
{
  std::vector<char> digits(mpz_sizeinbase(a, 10) + 2);
  mpz_get_str(digits.data(), 10, a);
  std::istringstream is(std::string(digits.data()));
  is >> result;
}

// Reduces `basis` in place with respect to the norm |scale_i v_i|. Returns false, with the basis as it was, if
// fplll gives up or there is nothing to reduce. The lattice stays the same: what is applied is one matrix of
// integers of determinant +-1.
template <typename Integer>
bool reduce_by_fplll(std::vector<std::vector<Integer> >& basis, const std::vector<double>& scale)
{
  if(basis.size() < 2)
    return false;
  const int rows = static_cast<int>(basis.size()), columns = static_cast<int>(scale.size());
  // Scales become integers of 20 bits or more: they only tell which vectors count as short.
  const double smallest = *std::min_element(scale.begin(), scale.end());
  const bool is_uniform = std::all_of(scale.begin(), scale.end(), [&](const double s) { return s == smallest; });
  if(!(smallest > 0))
    return false;
  fplll::ZZ_mat<mpz_t> b(rows, columns), transform(is_uniform ? 0 : rows, is_uniform ? 0 : rows);
  for(int i = 0; i < rows; ++i)
    for(int j = 0; j < columns; ++j) {
      mpz_t& entry = b(i, j).get_data();
      assign(basis[std::size_t(i)][std::size_t(j)], entry);
      if(!is_uniform) {
        fplll::Z_NR<mpz_t> factor;
        mpz_set_d(factor.get_data(), std::ldexp(scale[std::size_t(j)] / smallest, 20));
        mpz_mul(entry, entry, factor.get_data());
      }
    }
  const int status = is_uniform ? fplll::lll_reduction(b) : fplll::lll_reduction(b, transform);
  if(status != fplll::RED_SUCCESS)
    return false;
  std::vector<std::vector<Integer> > result(basis.size(), std::vector<Integer>(scale.size(), Integer(0)));
  fplll::Z_NR<mpz_t> sum, original;
  for(int i = 0; i < rows; ++i)
    for(int j = 0; j < columns; ++j) {
      if(is_uniform) {
        assign(b(i, j).get_data(), result[std::size_t(i)][std::size_t(j)]);
        continue;
      }
      mpz_set_si(sum.get_data(), 0);
      for(int k = 0; k < rows; ++k) {
        assign(basis[std::size_t(k)][std::size_t(j)], original.get_data());
        mpz_addmul(sum.get_data(), transform(i, k).get_data(), original.get_data());
      }
      assign(sum.get_data(), result[std::size_t(i)][std::size_t(j)]);
    }
  basis.swap(result);
  return true;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_USE_FPLLL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_FPLLL_REDUCTION_H
