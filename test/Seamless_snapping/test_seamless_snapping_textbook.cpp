// The methods that the package is compared with: the paper's Algorithms 1 to 5 as printed, against
// exact verification on thousands of random systems and on the reduced systems of parametrizations;
// and constraint elimination in floating point, which gets close and no more.

#include "Parametrized_model.h"
#include "checking.h"
#include "exact_reference.h"
#include "naive_elimination.h"
#include "random_constraints.h"
#include "random_systems.h"
#include "reduced_seamless_system.h"
#include "snap_in_any_form.h"
#include "test_data.h"
#include "textbook_method.h"

#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

namespace parameters = CGAL::Seamless_snapping::parameters;

using exact_reference::Integer;
using exact_reference::Rational;
using exact_reference::Rationals;
using exact_reference::System;
using random_systems::Random;
using random_systems::random_integer;
using random_systems::random_real;
using textbook::Echelon_form;
using textbook::Outcome;

// --- the final matrix ----------------------------------------------------------------------------

// Each column with a pivot has no other entry, and pivots go down to the right.
bool is_reduced(const Echelon_form<Integer>& form)
{
  for(std::size_t k = 0; k < form.pivots.size(); ++k) {
    if(k > 0 && form.pivots[k - 1] >= form.pivots[k])
      return false;
    for(std::size_t i = 0; i < form.pivots.size(); ++i) {
      const auto& row = form.system.c[i];
      if((row[form.pivots[k]] != 0) != (i == k))
        return false;
      if(i == k && std::any_of(row.begin(), row.begin() + std::ptrdiff_t(form.pivots[k]),
                               [](const Integer& a) { return a != 0; }))
        return false;
    }
  }
  return true;
}

// Whether all rows of the system, with their right-hand sides, are combinations of those of the
// final matrix: its pivots tell which.
bool spans(const Echelon_form<Integer>& form, const System& system)
{
  for(std::size_t r = 0; r < system.rows.size(); ++r) {
    Rationals rest(system.columns, Rational(0));
    Rational b = system.b[r];
    for(const auto& entry : system.rows[r])
      rest[entry.column] += entry.coefficient;
    for(std::size_t k = 0; k < form.pivots.size(); ++k) {
      const Rational factor = rest[form.pivots[k]] / Rational(form.pivot(k));
      if(factor == 0)
        continue;
      for(std::size_t j = 0; j < system.columns; ++j)
        if(form.system.c[k][j] != 0)
          rest[j] -= factor * Rational(form.system.c[k][j]);
      b -= factor * Rational(form.system.b[k]);
    }
    if(b != 0 || std::any_of(rest.begin(), rest.end(), [](const Rational& a) { return a != 0; }))
      return false;
  }
  return true;
}

// --- the result ----------------------------------------------------------------------------------

// The free variables as Algorithm 4 sets them, the others by (2') in rational arithmetic. Whether
// all right-hand sides are divisible by their pivots, and all values in range.
struct Rational_evaluation
{
  bool is_divisible = true, is_in_range = true;
  Rationals x;
};

Rational_evaluation evaluate_in_rationals(const Echelon_form<Integer>& form,
                                          const std::vector<double>& xbar)
{
  const textbook::Fixed_point fixed_point(xbar);
  const Rational step(fixed_point.step()), delta(fixed_point.delta());
  Rational_evaluation result{ true, true, Rationals(xbar.size(), Rational(0)) };
  for(std::size_t j = 0; j < xbar.size(); ++j) {
    std::vector<Integer> divisors;
    for(std::size_t k = 0; k < form.pivots.size(); ++k)
      if(form.system.c[k][j] != 0)
        divisors.push_back(form.pivot(k));
    if(!std::binary_search(form.pivots.begin(), form.pivots.end(), j))
      result.x[j] = Rational(textbook::make_div(xbar[j], divisors, fixed_point));
  }
  for(std::size_t k = 0; k < form.pivots.size(); ++k) {
    Rational sum(form.system.b[k]);
    const Rational quotient = sum / (Rational(form.pivot(k)) * step);
    result.is_divisible = result.is_divisible && exact_reference::denominator(quotient) == 1
                          && CGAL::abs(quotient) * step < delta;
    for(std::size_t j = form.pivots[k] + 1; j < xbar.size(); ++j)
      if(form.system.c[k][j] != 0)
        sum -= Rational(form.system.c[k][j]) * result.x[j];
    result.x[form.pivots[k]] = sum / Rational(form.pivot(k));
    result.is_in_range = result.is_in_range && CGAL::abs(result.x[form.pivots[k]]) < delta;
  }
  return result;
}

using Counts = std::array<int, 5>; // of outcomes

void check_system(const System& system, const std::vector<double>& xbar, Counts& counts)
{
  const Echelon_form<Integer> form =
    textbook::reduced_echelon_form(textbook::dense_system<Integer>(system));
  std::vector<double> x = xbar;
  const Outcome outcome = textbook::algorithm_3(form, x);
  ++counts[std::size_t(outcome)];
  CHECK(is_reduced(form) || !form.is_consistent);
  CHECK_EQUAL(form.pivots.size(),
              exact_reference::independent_rows(
                exact_reference::integer_problem(system, Rationals(xbar.size(), Rational(0)),
                                                 Rationals()), system.columns).size());
  CHECK_EQUAL(form.is_consistent,
              exact_reference::optimum_in_closed_form(
                system, exact_reference::to_rationals(xbar)).feasible);
  if(outcome != Outcome::EXACT)
    CHECK(x == xbar);
  if(!form.is_consistent) {
    CHECK(outcome == Outcome::INCONSISTENT);
    return;
  }
  CHECK(spans(form, system));
  const Rational_evaluation reference = evaluate_in_rationals(form, xbar);
  CHECK(exact_reference::exactly_satisfies(system, reference.x));
  if(outcome == Outcome::EXACT) {
    CHECK(exact_reference::exactly_satisfies(system, x));
    CHECK(exact_reference::to_rationals(x) == reference.x);
  } else {
    CHECK(outcome != Outcome::INCONSISTENT);
    CHECK(outcome != Outcome::NOT_DIVISIBLE || !reference.is_divisible);
    CHECK(outcome != Outcome::OUT_OF_RANGE || !reference.is_in_range);
  }
  // What Algorithm 4's rule promises, up to sums that Algorithm 5 takes too long for.
  if(reference.is_divisible && reference.is_in_range)
    CHECK(outcome == Outcome::EXACT || outcome == Outcome::TOO_LONG);
}

void print(const std::string& name, const Counts& counts)
{
  std::cout << name << ": exact " << counts[0] << ", inconsistent " << counts[1]
            << ", not divisible " << counts[2] << ", out of range " << counts[3] << ", too long "
            << counts[4] << std::endl;
}

void test_random_systems(const std::string& name, std::uint64_t first_seed, int count,
                         std::size_t largest, bool homogeneous)
{
  Counts counts{};
  for(int i = 0; i < count; ++i) {
    Random random(first_seed + std::uint64_t(i));
    const auto kind = random_systems::Kind(random() % 5);
    const std::size_t columns = 1 + random() % largest, rows = 1 + random() % columns;
    System system = random_systems::random_homogeneous_system(random, kind, columns, rows);
    if(!homogeneous)
      random_systems::set_right_hand_side(random, random_systems::random_right_hand_side(random),
                                          system);
    random_systems::add_redundant_rows(random, system, random_integer(random, 0, 3));
    const double magnitude = std::ldexp(1., random_integer(random, -20, 20));
    std::vector<double> xbar;
    for(std::size_t j = 0; j < columns; ++j)
      xbar.push_back(random() % 16 == 0 ? magnitude : magnitude * random_real(random));
    const std::size_t failed = checking::counts().failed;
    check_system(system, xbar, counts);
    if(failed != checking::counts().failed)
      std::cerr << "    seed " << first_seed + std::uint64_t(i) << std::endl;
  }
  if(homogeneous)
    CHECK_EQUAL(counts[1] + counts[2], 0);
  print(name + ", seeds from " + std::to_string(first_seed), counts);
}

// --- the addendum --------------------------------------------------------------------------------

Outcome outcome_of(const std::vector<int>& coefficients, int b, std::vector<double>& x)
{
  System system;
  system.columns = coefficients.size();
  exact_reference::Row row;
  for(std::size_t j = 0; j < coefficients.size(); ++j)
    row.push_back({ j, Rational(coefficients[j]) });
  system.add_row(row, Rational(b));
  const Outcome outcome = textbook::algorithm_3(
    textbook::reduced_echelon_form(textbook::dense_system<Integer>(system)), x);
  if(outcome == Outcome::EXACT)
    CHECK(exact_reference::exactly_satisfies(system, x));
  return outcome;
}

void test_addendum()
{
  std::vector<double> x = { 0.3 };
  CHECK(outcome_of({ 3 }, 1, x) == Outcome::NOT_DIVISIBLE);
  x = { 0.3, -0.1 };
  CHECK(outcome_of({ 9, 15 }, 1, x) == Outcome::NOT_DIVISIBLE);
  CHECK(outcome_of({ 9, 14 }, 1, x) == Outcome::NOT_DIVISIBLE); // which has solutions
  x = { 1.3, 1.4 };
  CHECK(outcome_of({ 2, 1 }, 4, x) == Outcome::EXACT);          // where (2) is wrong and (2') right
  x = { 0, 1e-3, 1 };
  CHECK(outcome_of({ 1, 1000, 1000 }, 0, x) == Outcome::OUT_OF_RANGE);
}

// --- systems of parametrizations -----------------------------------------------------------------

// The largest violation after constraint elimination in floating point.
double violation_by_naive_method(const System& system, std::vector<double> x)
{
  naive::eliminate(naive::dense_system(system), x);
  const Rationals exact_x = exact_reference::to_rationals(x);
  double largest = 0;
  for(std::size_t r = 0; r < system.rows.size(); ++r)
    largest = (std::max)(largest,
                         std::abs(CGAL::to_double(exact_reference::residual(system, r, exact_x))));
  return largest;
}

// Returns the violation by the naive method.
double test_reduced_system(const std::string& name, std::size_t connections)
{
  const Parametrized_model model(test_data::package_file(name));
  CHECK(bool(model.status));
  const auto transitions = CGAL::Seamless_snapping::seam_transitions(model.mesh, model.uv);
  random_constraints::Generator<Parametrized_model::Mesh> random(model.mesh, transitions, 1);
  const auto constraints = random.connections(connections);
  const auto reduced = reduced_system::reduced_seamless_system(
    model.mesh, model.uv, parameters::edge_is_constrained_map(model.is_aligned)
                                     .connection_constraints(constraints));

  std::vector<double> x = reduced.xbar, ours = reduced.xbar;
  const auto form =
    textbook::reduced_echelon_form(textbook::dense_system<Integer>(reduced.system));
  CHECK(form.is_consistent);
  CHECK(textbook::algorithm_3(form, x) == Outcome::EXACT);
  CHECK(exact_reference::exactly_satisfies(reduced.system, x));
  CHECK(bool(CGAL::Linear_snapping::snap_to_linear_constraints(
    snap_in_any_form::linear_constraints<Rational>(reduced.system), ours)));
  const Rationals xbar = exact_reference::to_rationals(reduced.xbar);
  const double change = std::sqrt(CGAL::to_double(
    exact_reference::squared_distance(exact_reference::to_rationals(x), xbar)));
  const double our_change = std::sqrt(CGAL::to_double(
    exact_reference::squared_distance(exact_reference::to_rationals(ours), xbar)));
  CHECK(our_change <= 1.01 * change); // ours is next to the optimum
  const double violation = violation_by_naive_method(reduced.system, reduced.xbar);
  CHECK(violation < 1e-9);
  std::cout << name << ", " << connections << " connections: " << reduced.system.rows.size()
            << " rows, largest coefficient " << form.largest << ", change "
            << change << ", ours " << our_change << ", naive violation " << violation << std::endl;
  return violation;
}

int main(int argc, char** argv)
{
  const std::uint64_t seed = argc > 1 ? std::stoull(argv[1]) : 1;
  test_addendum();
  test_random_systems("homogeneous, up to 6 unknowns", seed, 2000, 6, true);
  test_random_systems("homogeneous, up to 20 unknowns", seed + 10000, 1000, 20, true);
  test_random_systems("inhomogeneous, up to 6 unknowns", seed + 20000, 1000, 6, false);
  double naive_violation = 0;
  for(const std::string name : { "genus0", "genus1", "genus2", "genus3", "genus0_border",
                                 "genus2_features", "genus2_features_border" })
    for(const std::size_t connections : { 0u, 20u })
      naive_violation = (std::max)(naive_violation, test_reduced_system(name, connections));
  CHECK(naive_violation > 0);
  return report_checks();
}
