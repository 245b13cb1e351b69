// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_IS_EXACT_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_IS_EXACT_H

#include <CGAL/license/Seamless_snapping.h>

// The verification: whether coordinates satisfy all equations of a complex, exactly. It knows the
// final values, but not the way in which they were found.

#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/transitions/Side_vectors.h>

#include <CGAL/Exact_rational.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename Group>
using Exact_vector = std::array<Exact_rational, Group::dimension>;

template <typename Group, typename Vector>
Exact_vector<Group> exact_vector(const Vector& u)
{
  Exact_vector<Group> result;
  for(std::size_t c = 0; c < Group::dimension; ++c)
    result[c] = Exact_rational(u[c]);
  return result;
}

template <typename Group>
Exact_rational exact_value(const Functional<Group::dimension>& f, const Exact_vector<Group>& u)
{
  Exact_rational result(0);
  for(std::size_t c = 0; c < Group::dimension; ++c)
    result += Exact_rational(f[c] * u[c]);
  return result;
}

// The pairs of a branch share one translation: [MC19] Eq. (4) between neighbors.
template <typename Group, typename Vector>
bool branch_is_exact(const Cut_complex<Group>& complex, const std::size_t b,
                     const std::vector<Vector>& u)
{
  const auto pairs = complex.pairs[b];
  for(auto p = pairs.begin(); p + 1 != pairs.end(); ++p) {
    const auto* const q = p + 1;
    const Edge_sides sides{u[std::size_t(p->plus)], u[std::size_t(q->plus)],
                           u[std::size_t(p->minus)], u[std::size_t(q->minus)]};
    if(!satisfies_transition<Group>(sides, complex.element[b]))
      return false;
  }
  return true;
}

// [MC19] Eq. (5): a functional has one value along a chain.
template <typename Group, typename Vector>
bool chain_is_exact(const Cut_complex<Group>& complex, const std::size_t c,
                    const std::vector<Vector>& u)
{
  const auto f = Group::functional(complex.functional[c]);
  const auto links = complex.links[c];
  for(auto s = links.begin(); s + 1 != links.end(); ++s) {
    const Vector &p = u[std::size_t(*s)], &q = u[std::size_t(*(s + 1))];
    const std::array<double, 4> terms{{f[0] * p[0], f[1] * p[1], -f[0] * q[0], -f[1] * q[1]}};
    if(!exact_sum_is_zero(terms.data(), terms.size()))
      return false;
  }
  return true;
}

// By how much the value of the functional at the end of a path differs from that at its beginning:
// 0 if [MC19] Eq. (6) holds. If a branch is inexact, the transition of its first pair counts.
template <typename Group, typename Vector>
Exact_rational path_misfit(const Cut_complex<Group>& complex,
                           const typename Cut_complex<Group>::Path& path,
                           const std::vector<Vector>& u)
{
  Exact_vector<Group> x = exact_vector<Group>(u[std::size_t(path.a)]);
  int f = path.functional;
  for(const auto& crossing : path.crossings) {
    const std::size_t b = std::size_t(crossing.branch);
    const auto& pair = complex.pairs[b].front();
    // from the chart of one sector of a pair to the other chart: u' = g (u - u(here)) + u(there)
    const auto here =
        exact_vector<Group>(u[std::size_t(crossing.is_along ? pair.plus : pair.minus)]);
    const auto there =
        exact_vector<Group>(u[std::size_t(crossing.is_along ? pair.minus : pair.plus)]);
    const auto g = crossing.is_along ? complex.element[b] : Group::inverse(complex.element[b]);
    for(std::size_t c = 0; c < Group::dimension; ++c)
      x[c] -= here[c];
    x = Group::apply(g, x);
    for(std::size_t c = 0; c < Group::dimension; ++c)
      x[c] += there[c];
    f = Group::act(g, f).index;
  }
  return Exact_rational(
    exact_value<Group>(Group::functional(f), x) -
    exact_value<Group>(Group::functional(f), exact_vector<Group>(u[std::size_t(path.b)])));
}

template <typename Group, typename Vector>
bool equation_is_exact(const typename Cut_complex<Group>::Equation& equation,
                       const std::vector<Vector>& u)
{
  Exact_rational sum(-equation.right_hand_side);
  for(const auto& term : equation.terms)
    sum +=
        Exact_rational(term.coefficient *
                       Exact_rational(u[std::size_t(term.sector)][std::size_t(term.coordinate)]));
  return sum == 0;
}

// \pre the coordinates are finite
template <typename Group, typename Vector>
bool is_exact(const Cut_complex<Group>& complex, const std::vector<Vector>& u)
{
  for(std::size_t b = 0; b < complex.number_of_branches(); ++b)
    if(!branch_is_exact(complex, b, u))
      return false;
  for(std::size_t c = 0; c < complex.number_of_chains(); ++c)
    if(!chain_is_exact(complex, c, u))
      return false;
  for(const auto& path : complex.paths)
    if(path_misfit(complex, path, u) != 0)
      return false;
  for(const auto& equation : complex.equations)
    if(!equation_is_exact<Group>(equation, u))
      return false;
  return true;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_IS_EXACT_H
