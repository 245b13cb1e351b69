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

#ifndef CGAL_LINEAR_SNAPPING_SNAP_TO_LINEAR_CONSTRAINTS_H
#define CGAL_LINEAR_SNAPPING_SNAP_TO_LINEAR_CONSTRAINTS_H

#include <CGAL/license/Linear_snapping.h>

// The generic function: moves floating point values to nearby ones that satisfy a sparse system of
// linear equations exactly.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/linear/constraint_input.h>
#include <CGAL/Linear_snapping/internal/linear/snap_values.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/Linear_constraints.h>
#include <CGAL/Linear_snapping/types/Linear_report.h>
#include <CGAL/Linear_snapping/types/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

constexpr auto linear_parameters =
  named<CGAL::internal_np::value_weights, CGAL::internal_np::verbose, CGAL::internal_np::visitor>;

// Copies `values` to `x`. Returns the index of the first that is not finite, or their number.
template <typename Values>
std::size_t read_values(const Values& values, std::vector<double>& x)
{
  const std::size_t size = std::size_t(std::size(values));
  x.resize(size);
  std::size_t first = size;
  for(std::size_t j = size; j-- > 0;) {
    x[j] = static_cast<double>(*std::next(std::begin(values), std::ptrdiff_t(j)));
    if(!std::isfinite(x[j]))
      first = j;
  }
  return first;
}

// Weights are a range of positive numbers, or not given. Returns what is wrong with them.
inline std::string read_weights(const CGAL::internal_np::Param_not_found&, const std::size_t size,
                                std::vector<double>& weights)
{
  weights.assign(size, 1.);
  return "";
}

// Only ratios matter. Their squares must not overflow, so no weight is less than 2^-400 times the
// largest.
template <typename Weights>
std::string read_weights(const Weights& range, const std::size_t size,
                         std::vector<double>& weights)
{
  read_values(range, weights);
  if(weights.size() != size)
    return "there are " + std::to_string(weights.size()) + " weights for " +
           std::to_string(size) + " values; give one weight per value";
  for(std::size_t j = 0; j < size; ++j)
    if(!(weights[j] > 0) || !std::isfinite(weights[j]))
      return "weight " + std::to_string(j) + " is not a positive number";
  int exponent = (std::numeric_limits<int>::min)();
  for(const double w : weights)
    exponent = (std::max)(exponent, std::ilogb(w));
  for(double& w : weights)
    w = (std::max)(std::ldexp(w, -exponent), std::ldexp(1., -400));
  return "";
}

template <typename Coefficient, typename RightHandSide, typename Values, typename NamedParameters>
Linear_report snap_to_linear_constraints(const Linear_constraints<Coefficient>& c,
                                         const RightHandSide& b, Values& values,
                                         const NamedParameters& np)
{
  using Value = std::decay_t<decltype(*std::begin(values))>;
  using CGAL::parameters::get_parameter_reference;

  const Protect_exact_arithmetic protect;
  if(const auto refusal = inexact_arithmetic())
    return refused<Linear_report>(*refusal);
  const Progress progress(np);
  Linear_report report;
  Step_timer timer(report);

  std::vector<double> x;
  const std::size_t unbounded = read_values(values, x);
  if(x.size() != c.number_of_unknowns())
    return refused<Linear_report>(
      Outcome::INVALID_ARGUMENT,
      "there are " + std::to_string(x.size()) + " values, but the constraints have " +
        std::to_string(c.number_of_unknowns()) + " unknowns");
  if(unbounded != x.size())
    return refused<Linear_report>(
      Outcome::NOT_FINITE, "value " + std::to_string(unbounded) +
                             " is NaN or infinite; only finite values can be snapped");
  std::vector<double> weights;
  std::string problem = read_weights(
    get_parameter_reference(np, CGAL::internal_np::value_weights), x.size(), weights);
  Scaled_system system;
  if(!problem.empty() || !read_constraints(c, b, system, problem))
    return refused<Linear_report>(Outcome::INVALID_ARGUMENT, problem);
  report.linear_solver.number_of_unknowns = x.size();
  report.linear_solver.number_of_constraints = c.number_of_constraints();
  if(const std::optional<Refusal> refusal =
       snap_values(system, weights, Number_format::of<Value>(), x, report, timer)) {
    refuse(report, *refusal);
    report.certificate = refusal->certificate;
  }
  if(report.status == Outcome::SNAPPED)
    for(std::size_t j = 0; j < x.size(); ++j)
      *std::next(std::begin(values), std::ptrdiff_t(j)) = static_cast<Value>(x[j]);
  return report;
}

} // namespace internal

/*!
\ingroup PkgLinearSnappingRef

moves the values `x` to nearby values that satisfy \f$ C x = b \f$ exactly.

On success, \f$ C x = b \f$ holds in exact arithmetic on the new values, which have the number type
of the old ones. The function verifies this before it writes the values. They approximate the
weighted least-squares optimum: the real solution \f$ x^* \f$ that minimizes
\f$ \sum_j w_j (x^*_j - \bar x_j)^2 \f$. Values that depend on each other are multiples of one power
of two or, if there is no such solution nearby, of a power of two for each value.

A value that occurs in no constraint does not change. If all constraints of an independent part of
the system hold, the values of this part do not change. On failure, nothing changes. Constraints may
be redundant. Coefficients may have any size: if 64-bit integers do not suffice, the function uses
multiprecision integers.

The method follows Mandad and Campen \cgalCite{cgal:mc-ecstsp-19}.

\tparam Constraints a `Linear_constraints`, an `Eigen::SparseMatrix`, or an expression of sparse
        matrices of Eigen. The type of the coefficients is an integer type, `float`, `double`,
        `CGAL::Exact_integer`, or `CGAL::Exact_rational`. A floating point number stands for its
        exact binary value: 0.1 is not one tenth.
\tparam RightHandSide a random access range or an array of the same types of numbers
\tparam Values a random access range or an array of `float` or `double`, for example
        `std::vector<double>` or `Eigen::VectorXd`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param c the matrix \f$ C \f$, with one row per constraint and one column per unknown
\param b the right-hand side, one number per constraint
\param x the values, one per unknown; changed in place
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
        below

\cgalNamedParamsBegin
  \cgalParamNBegin{value_weights}
    \cgalParamDescription{the weights \f$ w_j \f$: a value with a large weight moves less}
    \cgalParamType{a random access range of positive numbers of type `double`, one per unknown;
                   ratios above \f$ 2^{400} \f$ count as \f$ 2^{400} \f$}
    \cgalParamDefault{all 1}
    \cgalParamExtra{Weights do not affect exactness.}
  \cgalParamNEnd
  \cgalParamNBegin{verbose}
    \cgalParamDescription{whether the function writes its progress to `std::cerr`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`; ignored if `visitor` is passed}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{receives the progress as lines of text, in the calling thread. If it
                          throws, the exception propagates, and `x` is as before.}
    \cgalParamType{a model of `ProgressVisitor`, or `std::ref()` of one}
    \cgalParamDefault{with `verbose`, a visitor that writes to `std::cerr`; else none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the status and figures; converts to `true` if and only if \f$ C x = b \f$ holds exactly. On
        failure, `Linear_report::status` is
        - `INVALID_ARGUMENT`: sizes do not match, an index is out of range, a weight is not
          positive, or a coefficient or right-hand side is not finite;
        - `NOT_FINITE`: a value is NaN or infinite;
        - `INCONSISTENT`: there is no solution; `Linear_report::certificate` holds the constraints
          that contradict each other;
        - `INEXACT_ARITHMETIC`: the program was compiled with options like `-ffast-math`;
        - `NOT_REPRESENTABLE`: there are rational solutions, but the function found no solution in
          the number type near the values. A solution of an independent part is too far if the root
          mean square of its changes exceeds a tenth of the root mean square of its values, and its
          `Linear_report::distance_ratio` exceeds 1,000;
        - `TOO_LARGE`: the constraints link too many unknowns, see below.

\par Search
The function first looks for a solution on one grid for all unknowns that depend on each other. If
it finds none, or one whose `Linear_report::distance_ratio` exceeds 10, it looks for a solution with
a grid for each unknown, for up to 200 unknowns. For \f$ x_0 + x_1 + x_2 = 2^{-60} \f$ near
\f$ (1, -1, 0) \f$, for example, this search finds \f$ (1, -1, 2^{-60}) \f$. It can miss a solution,
but rarely does (see \ref LSnappingGuarantees). If the `Linear_report::distance_ratio` of the result
exceeds 10, `Linear_report::message` says this.

\par Complexity
Nearly linear in the number of nonzero coefficients if the elimination finds a pivot 1 or -1 in each
row and creates few entries, as in the systems of seamless parametrizations. A row with many
entries, as in the first two systems of the table, costs more. The function solves independent parts
of the system by themselves, and factorizes equal parts with equal weights once. Triangular
systems of more than 200 unknowns, such as \f$ 8 f = a + 6 b + c \f$ for each vertex \f$ f \f$ of a
refinement, take linear time too. All other constraints without a coefficient 1 or -1 take a dense
integer lattice: quadratic memory and cubic time in the number of unknowns that they link.

If each constraint links distant unknowns, the elimination or the factorization for the optimum
creates many entries. If the factorization takes more than about a second, the function computes the
optimum by conjugate gradients, which take nearly linear time for most such systems. They converge
slowly if constraints are nearly dependent, for example because of weights of very different sizes.

The work of each step is bounded: beyond about a minute the status is `TOO_LARGE`.

| system | outcome |
|---|---|
| \f$ \sum_j x_j = 0 \f$ and all \f$ x_i = x_{i+1} \f$, 10,000 unknowns | a fraction of a second |
| the same system, 100,000 unknowns | about ten seconds |
| 250 constraints of six terms without a coefficient 1 or -1, 500 unknowns | solved |
| 350 such constraints, 700 unknowns | `TOO_LARGE` |
| 15,000 constraints of four random unknowns, 30,000 unknowns | a fraction of a second |
| 24,000 such constraints, 30,000 unknowns | `TOO_LARGE` |
| one constraint with coefficients of 40 bits, 100 unknowns | half a second |
| one such constraint, 300 or 1,000 unknowns | about ten seconds |
| each of 1,600 unknowns in a square is the mean of its four neighbors | `NOT_REPRESENTABLE` |
| a grid for each unknown, 200 unknowns, coefficients of 40 bits | at most a few seconds |
*/
template <typename Constraints, typename RightHandSide, typename Values,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , std::enable_if_t<!internal::is_named_parameters<Values>::value>* = nullptr
#endif
          >
Linear_report snap_to_linear_constraints(const Constraints& c, const RightHandSide& b, Values& x,
                                         const NamedParameters& np =
                                           CGAL::parameters::default_values())
{
  return internal::snap_to_linear_constraints(internal::as_constraints(c), b, x,
                                              internal::strip(np, internal::linear_parameters));
}

/*!
\ingroup PkgLinearSnappingRef

moves the values `x` to nearby values that satisfy \f$ C x = b \f$ exactly, with the right-hand side
of a `Linear_constraints`, or with \f$ b = 0 \f$ for a matrix.
*/
template <typename Constraints, typename Values,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , std::enable_if_t<internal::is_named_parameters<NamedParameters>::value>* = nullptr
#endif
          >
Linear_report snap_to_linear_constraints(const Constraints& c, Values& x,
                                         const NamedParameters& np =
                                           CGAL::parameters::default_values())
{
  return internal::snap_to_linear_constraints(internal::as_constraints(c),
                                              internal::No_right_hand_side(), x,
                                              internal::strip(np, internal::linear_parameters));
}

} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_SNAP_TO_LINEAR_CONSTRAINTS_H
