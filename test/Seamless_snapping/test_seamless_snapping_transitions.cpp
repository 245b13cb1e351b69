// Transitions and the two sides of an edge, against rational numbers that are near by or equal.

#include <CGAL/Seamless_snapping/internal/transitions/Side_vectors.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include "checking.h"
#include "random_numbers.h"

#include <cmath>
#include <cstddef>
#include <iostream>

using namespace CGAL::Seamless_snapping::internal;
using namespace random_numbers;

constexpr unsigned int seed = 1;

// By the matrix of one turn, so many times.
Exact_point turned(const Integer_matrix<2>& turn, const int times, Exact_point u)
{
  for(int i = 0; i < times; ++i) {
    const Rational first(turn[0][0] * u[0] + turn[0][1] * u[1]);
    const Rational second(turn[1][0] * u[0] + turn[1][1] * u[1]);
    u = {first, second};
  }
  return u;
}

// Sides of few bits that satisfy a transition, moved by translations and then to neighbors; with
// coordinates of any size up to the largest.
template <int N>
void test_transitions(const Integer_matrix<2>& turn)
{
  using Group = Group_of_order<N>;
  Random random(seed);
  std::size_t satisfied = 0, violated = 0, overflows = 0;
  for(int i = 0; i < 20000; ++i) {
    const auto g = Group::element(below(random, N), N);
    const int scale = i % 4 == 0 ? 1023 - 7 : below(random, 60) - 30; // differences overflow
    const auto coordinate = [&] { return std::ldexp(double(below(random, 512) - 256), scale); };
    const auto part = [&](const double x) { return std::ldexp(x, -2); };
    const Uv a{coordinate(), coordinate()};
    Uv b{coordinate(), coordinate()}, t{part(coordinate()), part(coordinate())};
    if(!Group::is_signed_permutation)
      b = {a[0] + part(part(b[0])), a[1] + part(part(b[1]))};
    if(i % 4 == 0)
      t = {0, 0};
    const Uv ta = Group::apply(g, a), tb = Group::apply(g, b);
    Edge_sides sides{a, b, {ta[0] + t[0], ta[1] + t[1]}, {tb[0] + t[0], tb[1] + t[1]}};
    if(below(random, 4) != 0) {
      Uv* const points[4] = {&sides.a, &sides.b, &sides.a_opposite, &sides.b_opposite};
      double& x = (*points[below(random, 4)])[std::size_t(below(random, 2))];
      x = random_neighbor(random, x);
    }
    bool is_finite = true;
    for(const Uv& u : {sides.a, sides.b, sides.a_opposite, sides.b_opposite})
      is_finite = is_finite && std::isfinite(u[0]) && std::isfinite(u[1]);
    if(!is_finite)
      continue;
    overflows += Side_vectors<Group>(sides).are_valid() ? 0 : 1;
    bool any = false;
    const Exact_point opposite_side = difference(sides.b_opposite, sides.a_opposite);
    for(int k = 0; k < N; ++k) {
      const bool expected = turned(turn, k, difference(sides.b, sides.a)) == opposite_side;
      if(!CHECK_EQUAL(satisfies_transition<Group>(sides, Group::element(k, N)), expected))
        std::cerr << "    N = " << N << ", case " << i << std::endl;
      any = any || expected;
      ++(expected ? satisfied : violated);
    }
    CHECK_EQUAL(satisfies_some_transition<Group>(sides, N), any);
  }
  CHECK(satisfied > 1000 && violated > 1000);
  CHECK(overflows > 100 || !Group::is_signed_permutation);
}

int main()
{
  std::cout << "random seed " << seed << std::endl;
  test_transitions<1>({{{{1, 0}}, {{0, 1}}}});
  test_transitions<2>({{{{-1, 0}}, {{0, -1}}}});
  test_transitions<3>({{{{-1, -1}}, {{1, 0}}}});
  test_transitions<4>({{{{0, -1}}, {{1, 0}}}});
  test_transitions<6>({{{{0, -1}}, {{1, 1}}}});
  return report_checks();
}
