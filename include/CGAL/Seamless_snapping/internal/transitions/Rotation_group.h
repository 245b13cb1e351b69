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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_ROTATION_GROUP_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_ROTATION_GROUP_H

#include <CGAL/license/Seamless_snapping.h>

// The rotations of transitions, as groups of integer matrices: by multiples of 90 degrees in
// Cartesian coordinates, and of 60 degrees in coordinates of the lattice basis u = a + b w, where w
// is the unit vector at 60 degrees. In Cartesian coordinates no rotation by 60 degrees is exact:
// sqrt(3) is irrational. Rotational symmetries of order n = 1, 2, 4 have rotations of the first
// group, symmetries of order n = 3, 6 of the second. The order is known at run time only, so that
// all share the code of two groups.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <std::size_t D>
using Integer_matrix = std::array<std::array<int, D>, D>;

// An integer linear form f: f(u) = f[0] u[0] + f[1] u[1].
template <std::size_t D>
using Functional = std::array<int, D>;

// A functional of the group's list, up to its sign.
struct Signed_functional
{
  int index;
  int sign;
};

// The cyclic group of rotations by multiples of 360 / N degrees. Elements are numbers of turns from
// 0 to N - 1: only this class knows that; all others compose them.
template <int N>
class Rotation_group
{
  static_assert(N == 4 || N == 6, "the others are subgroups of these");

public:
  static constexpr std::size_t dimension = 2;
  static constexpr int order = N;
  // Whether matrices only swap coordinates and change signs, which no rounding can harm.
  static constexpr bool is_signed_permutation = (N == 4);
  // Isocurves run where one of these is constant; the group permutes them up to the sign.
  static constexpr int number_of_functionals = is_signed_permutation ? 2 : 3;

  using Element = int;
  using Matrix = Integer_matrix<dimension>;

  static constexpr Element identity() { return 0; }

  // First `h`, then `g`.
  static constexpr Element compose(const Element g, const Element h) { return (g + h) % N; }
  static constexpr Element inverse(const Element g) { return (N - g) % N; }

  // The element of any number of turns by 360 / n degrees, also a negative one. \pre n divides N
  static constexpr Element element(const int turns, const int n = N)
  { return (N / n * turns % N + N) % N; }

  // The least number of these turns, from 0 on.
  static constexpr int turns(const Element g, const int n = N) { return g * n / N; }

  static constexpr const Matrix& matrix(const Element g) { return matrices[std::size_t(g)]; }

  static constexpr Functional<dimension> functional(const int f)
  {
    return f == 0 ? Functional<dimension>{{1, 0}}
                  : f == 1 ? Functional<dimension>{{0, 1}} : Functional<dimension>{{1, 1}};
  }

  // The functional f' with f'(g u) = sign f(u): what is constant along an isocurve in the chart
  // behind a transition by `g`.
  static constexpr Signed_functional act(const Element g, const int f)
  {
    const Functional<dimension> wanted = functional(f);
    for(int index = 0; index < number_of_functionals; ++index) {
      const Functional<dimension> pulled_back = times_matrix(functional(index), g);
      for(const int sign : {1, -1})
        if(wanted[0] == sign * pulled_back[0] && wanted[1] == sign * pulled_back[1])
          return {index, sign};
    }
    return {-1, 0}; // not reached: the group permutes the functionals
  }

  // f g, as a linear form.
  static constexpr Functional<dimension> times_matrix(const Functional<dimension>& f,
                                                      const Element g)
  {
    const Matrix& m = matrix(g);
    return {{f[0] * m[0][0] + f[1] * m[1][0], f[0] * m[0][1] + f[1] * m[1][1]}};
  }

  // g v, for a pair of numbers.
  template <typename Vector>
  static Vector apply(const Element g, const Vector& v)
  {
    using Number = typename Vector::value_type;
    const Matrix& m = matrix(g);
    return {Number(m[0][0]) * v[0] + Number(m[0][1]) * v[1],
            Number(m[1][0]) * v[0] + Number(m[1][1]) * v[1]};
  }

  // The value of a functional, rounded where it has two terms.
  template <typename Vector>
  static typename Vector::value_type value(const int f, const Vector& v)
  {
    if constexpr(is_signed_permutation)
      return v[std::size_t(f)];
    else
      return f < 2 ? v[std::size_t(f)] : v[0] + v[1];
  }

  // Lengths. That which decides whether vectors are small is the largest absolute value of a
  // functional; that of least squares is Euclidean, and the sum of the squares of the functionals
  // is a multiple of its square. So no direction is favoured, and both are the same in all charts.
  static double norm(const std::array<double, dimension>& v)
  {
    double largest = (std::max)(std::abs(v[0]), std::abs(v[1]));
    if constexpr(!is_signed_permutation)
      largest = (std::max)(largest, std::abs(v[0] + v[1]));
    return largest;
  }

  // The sum of the squares of all functionals, for the shortest vector where one of them is 1.
  static constexpr double squares_at_level_1 = is_signed_permutation ? 1 : 1.5;

  // That vector.
  static constexpr std::array<double, dimension> shortest_at_level_1(const int f)
  {
    if constexpr(is_signed_permutation)
      return {double(f == 0), double(f == 1)};
    else
      return {f == 0 ? 1 : f == 1 ? -0.5 : 0.5, f == 0 ? -0.5 : f == 1 ? 1 : 0.5};
  }

  // The vector in Cartesian coordinates, rounded: for angles and lengths that decide nothing
  // exactly.
  static std::array<double, dimension> to_cartesian(const std::array<double, dimension>& v)
  {
    if constexpr(is_signed_permutation)
      return v;
    else
      return {v[0] + 0.5 * v[1], height * v[1]};
  }

  static std::array<double, dimension> from_cartesian(const std::array<double, dimension>& v)
  {
    if constexpr(is_signed_permutation)
      return v;
    else
      return {v[0] - 0.5 / height * v[1], v[1] / height};
  }

  // Converts a linear form, so that its values stay.
  static std::array<double, dimension> form_to_cartesian(const std::array<double, dimension>& form)
  {
    if constexpr(is_signed_permutation)
      return form;
    else
      return {form[0], (form[1] - 0.5 * form[0]) / height};
  }

  // The vector whose Euclidean inner products are the values of a linear form.
  static std::array<double, dimension> gradient(const std::array<double, dimension>& form)
  {
    return from_cartesian(form_to_cartesian(form));
  }

private:
  static constexpr double height = 0.86602540378443864676; // triangle of the lattice: sqrt(3) / 2

  static constexpr Matrix generator()
  { return {{{{0, -1}}, {{1, is_signed_permutation ? 0 : 1}}}}; }

  // A plain array: arrays of the library can't be assigned to in constant expressions of C++17.
  struct Table
  {
    Matrix power[N];
    constexpr const Matrix& operator[](const std::size_t g) const { return power[g]; }
  };

  static constexpr Matrix product(const Matrix& a, const Matrix& b)
  {
    return {{{{a[0][0] * b[0][0] + a[0][1] * b[1][0], a[0][0] * b[0][1] + a[0][1] * b[1][1]}},
             {{a[1][0] * b[0][0] + a[1][1] * b[1][0], a[1][0] * b[0][1] + a[1][1] * b[1][1]}}}};
  }

  static constexpr Table table()
  {
    Table result{};
    for(int g = 0; g < N; ++g)
      result.power[g] = g == 0 ? Matrix{{{{1, 0}}, {{0, 1}}}}
                               : product(generator(), result.power[g - 1]);
    return result;
  }

  static constexpr Table matrices = table();
};

using Quarter_turns = Rotation_group<4>;
using Sixth_turns = Rotation_group<6>;

// That which has the rotations of symmetry n.
template <int n>
using Group_of_order = Rotation_group<n % 3 == 0 ? 6 : 4>;

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_TRANSITIONS_ROTATION_GROUP_H
