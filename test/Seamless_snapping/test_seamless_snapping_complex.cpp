// The mesh-free middle for all five transition groups: group laws; random complexes with noise are
// solved, expanded, and verified, and an independent check in rationals agrees with the
// verification.

#include "checking.h"
#include "random_complexes.h"

#include <CGAL/Seamless_snapping/internal/complex/Complex_solver.h>
#include <CGAL/Seamless_snapping/internal/complex/Free_coordinates.h>
#include <CGAL/Seamless_snapping/internal/complex/is_exact.h>

#include <CGAL/FPU.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace internal = CGAL::Seamless_snapping::internal;
using Vector = std::array<double, 2>;

// --- groups --------------------------------------------------------------------------------------

template <int N>
void test_group()
{
  using Group = internal::Group_of_order<N>;
  const std::string context = "N = " + std::to_string(N);
  const std::vector<Vector> vectors{{{3, 0}}, {{-1, 5}}, {{2, 7}}};
  for(int i = 0; i < N; ++i) {
    const auto g = Group::element(i, N);
    CHECK_IN(context, Group::compose(g, Group::inverse(g)) == Group::identity());
    CHECK_IN(context, Group::element(i - 5 * N, N) == g && Group::turns(g, N) == i);
    for(const Vector& u : vectors) {
      CHECK_IN(context, Group::apply(g, u) == random_complexes::turned<N>(i, u));
      for(int j = 0; j < N; ++j)
        CHECK_IN(context, Group::apply(Group::compose(g, Group::element(j, N)), u) ==
                            Group::apply(g, Group::apply(Group::element(j, N), u)));
      // turning keeps lengths
      const Vector x = Group::to_cartesian(u), y = Group::to_cartesian(Group::apply(g, u));
      CHECK_IN(context, std::abs(std::hypot(x[0], x[1]) - std::hypot(y[0], y[1])) < 1e-14);
      for(int f = 0; f < Group::number_of_functionals; ++f) {
        const auto behind = Group::act(g, f);
        CHECK_IN(context, behind.index == random_complexes::functional_behind<N>(i, f));
        CHECK_IN(context, random_complexes::value(behind.index, Group::apply(g, u)) ==
                            behind.sign * random_complexes::value(f, u));
      }
    }
  }
}

// --- complexes -----------------------------------------------------------------------------------

struct Totals
{
  std::size_t solved = 0, exact_before = 0, detected = 0, undetected = 0;
  double largest_growth = 0; // of noise

  void print(const std::string& name) const
  {
    std::cout << name << ": " << solved << " solved, " << detected << " single changes detected, "
              << undetected << " without effect; largest change " << largest_growth
              << " times the noise" << std::endl;
  }
};

template <typename Complex>
void add_noise(Complex& complex,
               const double noise,
               const bool rounds_to_float,
               std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(-noise, noise);
  for(Vector& u : complex.coordinates)
    for(double& x : u) {
      x += uniform(random);
      if(rounds_to_float)
        x = internal::rounded_to<float>(x);
    }
}

// The verification and the independent check agree on coordinates with one change.
template <int N, typename Complex>
void test_single_changes(const Complex& complex, std::vector<Vector> u, std::mt19937& random,
                         const std::string& context, Totals& totals)
{
  for(int i = 0; i < 5; ++i) {
    double& x = u[random() % u.size()][random() % 2];
    const double before = x;
    x = std::nextafter(x, 2.);
    const bool is_solution = random_complexes::is_solution<N>(complex, u);
    CHECK_IN(context, internal::is_exact(complex, u) == is_solution);
    ++(is_solution ? totals.undetected : totals.detected);
    x = before;
  }
}

template <int N, typename Number>
void test_complexes(const std::string& name, const double noise, const unsigned int seeds)
{
  using Group = internal::Group_of_order<N>;
  Totals totals;
  for(unsigned int seed = 1; seed <= seeds; ++seed) {
    const std::string context = name + ", seed " + std::to_string(seed);
    std::mt19937 random(seed);
    auto complex = random_complexes::Generator<N>(seed).make(1 + seed % 12, seed % 3 == 0);
    CHECK_IN(context, random_complexes::is_solution<N>(complex, complex.coordinates));
    CHECK_IN(context, internal::is_exact(complex, complex.coordinates));
    add_noise(complex, noise, sizeof(Number) == sizeof(float), random);
    internal::Complex_solver<Group> solver(complex, internal::Number_format::of<Number>());
    internal::Snapped_coordinates<Group> snapped;
    const auto refusal = solver.solve(snapped);
    CHECK_IN(context, !refusal);
    if(refusal)
      continue;
    ++totals.solved;
    CHECK_IN(context, random_complexes::is_solution<N>(complex, snapped.coordinates));
    CHECK_IN(context, internal::is_exact(complex, snapped.coordinates));
    CHECK_EQUAL(solver.linear_solver().figures().number_of_eliminations, 1u);
    double squares = 0; // of the changes, in steps
    for(std::size_t s = 0; s < complex.coordinates.size(); ++s)
      for(std::size_t c = 0; c < 2; ++c) {
        const double x = snapped.coordinates[s][c];
        const double steps = (x - complex.coordinates[s][c]) / solver.coarsest_step();
        squares += steps * steps;
        CHECK_IN(context, x == static_cast<double>(static_cast<Number>(x)));
        totals.largest_growth = (std::max)(totals.largest_growth,
                                           std::abs(x - complex.coordinates[s][c]) / noise);
      }
    const double optimum = snapped.optimal_changes.root(1) / solver.coarsest_step();
    if(Group::is_signed_permutation) // else the optimum is not that of the coordinates' squares
      CHECK_IN(context, squares <= 1.01 * optimum * optimum +
                                     4 * static_cast<double>(complex.coordinates.size()));
    test_single_changes<N>(complex, snapped.coordinates, random, context, totals);
  }
  totals.print(name);
  CHECK(totals.detected > seeds);
  CHECK(totals.largest_growth < 100);
  std::cout << "seeds 1 to " << seeds << std::endl;
}

template <int N>
void test_symmetry()
{
  test_group<N>();
  const std::string name = "N = " + std::to_string(N);
  test_complexes<N, double>(name, 1e-9, 1000);
  test_complexes<N, float>(name + ", float", 1e-3, 500);
}

// A second solve for shifted targets makes no second elimination, and moves what is shifted.
void test_shifted_targets()
{
  using Group = internal::Quarter_turns;
  auto complex = random_complexes::Generator<4>(7).make(12, false);
  std::mt19937 random(7);
  add_noise(complex, 1e-9, false, random);
  internal::Complex_solver<Group> solver(complex, internal::Number_format::of<double>());
  internal::Snapped_coordinates<Group> snapped;
  CHECK(!solver.solve(snapped));
  const internal::Sector_index s = complex.pairs[0].front().plus;
  std::vector<Vector> shifted;
  CHECK(solver.solve_shifted({{s, {{1e-6, 0}}}}, shifted));
  CHECK(random_complexes::is_solution<4>(complex, shifted));
  CHECK(shifted[std::size_t(s)][0] > snapped.coordinates[std::size_t(s)][0]);
  CHECK_EQUAL(solver.linear_solver().figures().number_of_eliminations, 1u);
}

// Where the levels of a component are small, its grid is fine; shifts may be of any size, and what
// is an exact solution already is met up to a step of the grid for that size.
template <int N>
void test_large_shifts()
{
  using Group = internal::Group_of_order<N>;
  for(unsigned int seed = 1; seed <= 20; ++seed) {
    const std::string context =
      "large shifts, N = " + std::to_string(N) + ", seed " + std::to_string(seed);
    auto complex = random_complexes::Generator<N>(seed).make(1 + seed % 12, false);
    internal::Target_shifts<Group> shifts;
    for(std::size_t s = 0; s < complex.coordinates.size(); ++s) {
      Vector& u = complex.coordinates[s];
      const Vector to = u;
      u = {{std::ldexp(u[0], -100), std::ldexp(u[1], -100)}}; // exact, too
      shifts[internal::Sector_index(s)] = {{to[0] - u[0], to[1] - u[1]}};
    }
    const internal::Complex_solver<Group> solver(complex,
                                                 internal::Number_format::of<double>());
    std::vector<Vector> shifted;
    CHECK_IN(context, solver.solve_shifted(shifts, shifted));
    CHECK_IN(context, random_complexes::is_solution<N>(complex, shifted));
    solver.components().for_each_sector([&](const internal::Sector_index s, const auto& k) {
      for(std::size_t c = 0; c < 2; ++c)
        if(k[c] >= 0)
          CHECK_IN(context, std::abs(shifted[std::size_t(s)][c] - shifts[s][c]) < 1e-13);
    });
  }
}

// Whatever the free unknowns are: all constraints hold. The numbers are small integers, so that
// nothing is rounded.
template <int N>
void test_free_coordinates()
{
  std::mt19937 random(N);
  for(unsigned int seed = 1; seed <= 40; ++seed) {
    const std::string context =
      "free coordinates, N = " + std::to_string(N) + ", seed " + std::to_string(seed);
    const auto complex = random_complexes::Generator<N>(seed).make(1 + seed % 12, false);
    const internal::Free_coordinates<internal::Group_of_order<N> > free(complex);
    std::vector<double> unknowns;
    for(std::size_t i = 0; i < free.number_of_unknowns(); ++i)
      unknowns.push_back(double(random() % 17) - 8);
    std::vector<Vector> u;
    for(std::size_t s = 0; s < complex.number_of_sectors(); ++s)
      u.push_back({{internal::value_of(free.coordinate(s, 0), unknowns),
                    internal::value_of(free.coordinate(s, 1), unknowns)}});
    CHECK_IN(context, random_complexes::is_solution<N>(complex, u));
    CHECK_IN(context, u == free.evaluate(unknowns));
    // each unknown can change something
    std::vector<char> is_used(unknowns.size(), false);
    for(std::size_t s = 0; s < complex.number_of_sectors(); ++s)
      for(std::size_t c = 0; c < 2; ++c)
        for(const auto& term : free.coordinate(s, c))
          is_used[term.first] = true;
    CHECK_IN(context, std::count(is_used.begin(), is_used.end(), false) == 0);
  }
}

// Each component has a grid of its own: a part that is 2^-20 times as large keeps 20 bits more.
void test_components()
{
  using Group = internal::Quarter_turns;
  internal::Cut_complex<Group> complex;
  const double scale = std::ldexp(1., -20);
  for(const double size : {1., scale}) {
    const internal::Sector_index first = internal::Sector_index(complex.coordinates.size());
    for(const double x : {0.1, 0.3, 0.6, 0.8})
      complex.coordinates.push_back({{x * size, x * size}});
    complex.pairs.push_back({first, first + 1});
    complex.pairs.push_back({first + 2, first + 3});
    complex.pairs.end_list();
    complex.element.push_back(Group::identity());
  }
  complex.is_node.assign(8, true);
  for(internal::Sector_index s = 0; s <= 8; ++s)
    complex.first_sector.push_back(s);
  internal::Complex_solver<Group> solver(complex, internal::Number_format::of<double>());
  internal::Snapped_coordinates<Group> snapped;
  CHECK(!solver.solve(snapped));
  CHECK(random_complexes::is_solution<1>(complex, snapped.coordinates));
  for(std::size_t s = 0; s < 4; ++s) // the same values, scaled exactly
    CHECK(snapped.coordinates[s + 4][0] == scale * snapped.coordinates[s][0]);
}

int main()
{
  const CGAL::Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
  test_symmetry<1>();
  test_symmetry<2>();
  test_symmetry<3>();
  test_symmetry<4>();
  test_symmetry<6>();
  test_shifted_targets();
  test_large_shifts<1>();
  test_large_shifts<2>();
  test_large_shifts<3>();
  test_large_shifts<4>();
  test_large_shifts<6>();
  test_free_coordinates<1>();
  test_free_coordinates<2>();
  test_free_coordinates<4>();
  test_components();
  return report_checks();
}
