// Snapping to any sparse system of linear equations.

#include "Call.h"
#include "functions.h"
#include "reports.h"

#include <CGAL/Linear_snapping/snap_to_linear_constraints.h>

#include <CGAL/Exact_rational.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace LS = CGAL::Linear_snapping;
using Rational = CGAL::Exact_rational;

namespace {

// A matrix by rows: the terms of row i are those from `begins[i]` to `begins[i + 1]`.
template <typename Coefficient, typename Get>
LS::Linear_constraints<Coefficient>
constraints_of(const Integers& begins, const Integers& columns, const std::size_t unknowns,
               const std::vector<Rational>& sides, const Get& coefficient)
{
  LS::Linear_constraints<Coefficient> result(unknowns);
  std::vector<std::pair<std::size_t, Coefficient> > terms;
  for(py::ssize_t i = 0; i + 1 < begins.size(); ++i) {
    terms.clear();
    for(std::int64_t k = begins.data()[i]; k < begins.data()[i + 1]; ++k)
      terms.emplace_back(std::size_t(columns.data()[k]), coefficient(std::size_t(k)));
    result.add_constraint(terms, sides[std::size_t(i)]);
  }
  return result;
}

// \param numbers integers or fractions in decimal digits
std::vector<Rational> rationals(const std::vector<std::string>& numbers)
{
  std::vector<Rational> result;
  for(const std::string& s : numbers)
    result.emplace_back(s);
  return result;
}

template <typename Constraints>
std::pair<Doubles, py::dict> snap(const Constraints& constraints, const Doubles& values,
                                  const Doubles& weights, const py::object& progress)
{
  std::vector<double> x(values.data(), values.data() + values.size());
  const std::vector<double> w(weights.data(), weights.data() + weights.size());
  LS::Linear_report report;
  Call(progress).run([&] {
    report = LS::snap_to_linear_constraints(constraints, x, LS::parameters::value_weights(w));
  });
  py::dict dict = dict_of(report);
  add_distances(dict, report);
  dict["distance_ratio"] = report.distance_ratio;
  std::vector<std::int64_t> rows;
  for(const auto& [row, multiplier] : report.certificate)
    rows.push_back(std::int64_t(row));
  dict["contradicting_rows"] = to_array(std::move(rows));
  return {to_array(std::move(x)), dict};
}

std::pair<Doubles, py::dict>
snap_integers(const Integers& begins, const Integers& columns, const Integers& coefficients,
              const std::vector<std::string>& sides, const Doubles& values, const Doubles& weights,
              const py::object& progress)
{
  return snap(constraints_of<std::int64_t>(begins, columns, std::size_t(values.size()),
                                           rationals(sides), [&](const std::size_t k)
                                             { return coefficients.data()[k]; }),
              values, weights, progress);
}

std::pair<Doubles, py::dict>
snap_rationals(const Integers& begins, const Integers& columns,
               const std::vector<std::string>& coefficients, const std::vector<std::string>& sides,
               const Doubles& values, const Doubles& weights, const py::object& progress)
{
  const std::vector<Rational> numbers = rationals(coefficients);
  return snap(constraints_of<Rational>(begins, columns, std::size_t(values.size()),
                                       rationals(sides), [&](const std::size_t k)
                                         { return numbers[k]; }),
              values, weights, progress);
}

} // namespace

void add_linear(py::module_& module)
{
  module.def("snap_linear_integers", snap_integers);
  module.def("snap_linear_rationals", snap_rationals);
}
