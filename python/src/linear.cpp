// Snapping to any sparse system of linear equations.

#include "Call.h"
#include "functions.h"
#include "reports.h"

#include <CGAL/Linear_snapping/snap_to_linear_constraints.h>

#include <CGAL/Exact_rational.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace LS = CGAL::Linear_snapping;
using Rational = CGAL::Exact_rational;

namespace {

// What words are converted to; integers stay as they are.
template <typename Coefficient>
using Rational_or =
  std::conditional_t<std::is_same_v<Coefficient, std::string>, Rational, Coefficient>;

// Coefficients and right-hand sides, and numbers near a solution.
template <typename Coefficient>
struct System_to_snap
{
  // Row i has the terms from `begins[i]` to `begins[i + 1]`. Rationals are in decimal digits.
  void run()
  {
    LS::Linear_constraints<Rational_or<Coefficient> > constraints(x.size());
    std::vector<std::pair<std::size_t, Rational_or<Coefficient> > > terms;
    for(std::size_t i = 0; i < sides.size(); ++i) {
      terms.clear();
      for(std::size_t k = std::size_t(begins[i]); k < std::size_t(begins[i + 1]); ++k)
        terms.emplace_back(std::size_t(columns[k]), Rational_or<Coefficient>(coefficients[k]));
      constraints.add_constraint(terms, Rational(sides[i]));
    }
    report = LS::snap_to_linear_constraints(constraints, x, LS::parameters::value_weights(weights));
  }

  std::vector<std::int64_t> begins, columns;
  std::vector<Coefficient> coefficients;
  std::vector<std::string> sides;
  std::vector<double> x, weights;
  LS::Linear_report report = LS::Linear_report();
};

template <typename Coefficient>
std::pair<Doubles, py::dict> snap(std::shared_ptr<System_to_snap<Coefficient> > snapping,
                                  const py::object& progress)
{
  const double seconds = run_apart(progress, snapping);
  const LS::Linear_report& report = snapping->report;
  py::dict dict = ::dict_of(report);
  add_distances(dict, report);
  dict["seconds_in_core"] = seconds;
  dict["distance_ratio"] = report.distance_ratio;
  std::vector<std::int64_t> rows;
  for(const auto& [row, multiplier] : report.certificate)
    rows.push_back(std::int64_t(row));
  dict["contradicting_rows"] = to_array(std::move(rows));
  return {to_array(std::move(snapping->x)), dict};
}

std::pair<Doubles, py::dict>
snap_integers(const Integers& begins, const Integers& columns, const Integers& coefficients,
              const std::vector<std::string>& sides, const Doubles& values, const Doubles& weights,
              const py::object& progress)
{
  return snap(std::shared_ptr<System_to_snap<std::int64_t> >(new System_to_snap<std::int64_t>{
                copy_of(begins), copy_of(columns), copy_of(coefficients), sides, copy_of(values),
                copy_of(weights)}), progress);
}

std::pair<Doubles, py::dict>
snap_rationals(const Integers& begins, const Integers& columns,
               const std::vector<std::string>& coefficients, const std::vector<std::string>& sides,
               const Doubles& values, const Doubles& weights, const py::object& progress)
{
  return snap(std::shared_ptr<System_to_snap<std::string> >(new System_to_snap<std::string>{
                copy_of(begins), copy_of(columns), coefficients, sides, copy_of(values),
                copy_of(weights)}), progress);
}

} // namespace

void add_linear(py::module_& module)
{
  module.def("snap_linear_integers", snap_integers);
  module.def("snap_linear_rationals", snap_rationals);
}
