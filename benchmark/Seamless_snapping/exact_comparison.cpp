// Four ways to satisfy the constraints of a parametrization exactly (Sec. 6.1 of the paper), or to
// try, on the reduced and the full systems of given OBJ files (the full ones in the coordinates of
// sectors or of corners), or on systems from MatrixMarket files:
//
//   ours      snap_to_linear_constraints()
//   textbook  the paper's Algorithms 1 to 5 as printed, dense, in integers of any length
//   naive     constraint elimination in floating point
//   QP        CGAL's quadratic programming solver in exact rationals, minimising the squared change
//
// All get the same rows and values, and start from them in the form that they want. Each runs in a
// process of its own, which is stopped when the time or the memory is used up; times are the
// shortest of a few runs where runs are short. Violations are those of the values rounded to
// doubles, computed exactly: the solution of the QP is exact as long as it is not rounded
// ("rational"). It gets the problem in integers, which it solves 4 times as fast as in fractions.

#include "benchmark_tools.h"
#include "child_process.h"
#include "command_line.h"
#include "compared_systems.h"

#include "naive_elimination.h"
#include "textbook_method.h"

#include <CGAL/Exact_integer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <optional>
#include <string>
#include <vector>

namespace options = benchmark::options;

using compared_systems::Problem;
using exact_reference::Integer;
using exact_reference::Rational;
using exact_reference::Rationals;

struct Settings
{
  std::vector<std::string> files, methods, systems;
  benchmark::Child_limits limits;
};

// --- the methods ---------------------------------------------------------------------------------

struct Result
{
  double seconds = 0, violation = 0, largest_change = 0, mean_change = 0;
  std::string verdict; // without blanks
  std::size_t bits = 0;
};

std::size_t bit_length(Integer n)
{
  std::size_t bits = 0;
  for(; n != 0; n /= 2)
    ++bits;
  return bits;
}

// Repeats what takes less than a moment; f(x) changes a copy of the values.
template <typename Function>
double shortest_time(const std::vector<double>& xbar, std::vector<double>& x, const Function& f)
{
  double shortest = 0, total = 0;
  for(int i = 0; i == 0 || (i < 20 && total < 0.2); ++i) {
    x = xbar;
    const double start = benchmark::seconds_now();
    f(x);
    const double seconds = benchmark::seconds_now() - start;
    shortest = i == 0 ? seconds : (std::min)(shortest, seconds);
    total += seconds;
  }
  return shortest;
}

double nearest_double(const Rational& value)
{
  const double guess = CGAL::to_double(value); // truncated, perhaps
  double nearest = guess;
  for(const double other : { std::nextafter(guess, -HUGE_VAL), std::nextafter(guess, HUGE_VAL) })
    if(CGAL::abs(Rational(value - Rational(other)))
       < CGAL::abs(Rational(value - Rational(nearest))))
      nearest = other;
  return nearest;
}

void measure_solution(const Problem& problem, const Rationals& x, Result& result)
{
  Rationals rounded;
  for(std::size_t i = 0; i < x.size(); ++i) {
    rounded.push_back(Rational(nearest_double(x[i])));
    const double change =
      std::abs(CGAL::to_double(Rational(x[i] - Rational(problem.xbar[i]))));
    result.largest_change = (std::max)(result.largest_change, change);
    result.mean_change += change / double(x.size());
  }
  for(std::size_t r = 0; r < problem.system.rows.size(); ++r)
    result.violation = (std::max)(
      result.violation,
      std::abs(CGAL::to_double(exact_reference::residual(problem.system, r, rounded))));
  if(result.verdict.empty())
    result.verdict = result.violation == 0 ? "yes" : "NO";
}

Result run_ours(const Problem& problem)
{
  const auto constraints = snap_in_any_form::linear_constraints<std::int64_t>(problem.system);
  Result result;
  CGAL::Linear_snapping::Linear_report report;
  std::vector<double> x;
  result.seconds = shortest_time(problem.xbar, x, [&](std::vector<double>& values) {
    report = CGAL::Linear_snapping::snap_to_linear_constraints(constraints, values);
  });
  result.bits = report.linear_solver.coefficient_bits;
  measure_solution(problem, exact_reference::to_rationals(x), result);
  return result;
}

Result run_textbook(const Problem& problem)
{
  const auto system = textbook::dense_system<Integer>(problem.system);
  Result result;
  std::vector<double> x;
  result.seconds = shortest_time(problem.xbar, x, [&](std::vector<double>& values) {
    const auto form = textbook::reduced_echelon_form(system);
    result.bits = bit_length(form.largest);
    if(textbook::algorithm_3(form, values) != textbook::Outcome::EXACT)
      result.verdict = "fails";
  });
  measure_solution(problem, exact_reference::to_rationals(x), result);
  return result;
}

Result run_naive(const Problem& problem)
{
  const auto system = naive::dense_system(problem.system);
  Result result;
  std::vector<double> x;
  result.seconds = shortest_time(problem.xbar, x, [&](std::vector<double>& values) {
    naive::eliminate(system, values);
  });
  result.bits = 53;
  measure_solution(problem, exact_reference::to_rationals(x), result);
  return result;
}

Result run_quadratic_program(const Problem& problem)
{
  const Rationals xbar = exact_reference::to_rationals(problem.xbar);
  Result result;
  exact_reference::Optimum optimum;
  std::vector<double> x;
  result.seconds = shortest_time(problem.xbar, x, [&](std::vector<double>&) {
    optimum = exact_reference::optimum_by_quadratic_program(problem.system, xbar);
  });
  if(!optimum.feasible)
    throw std::runtime_error("the quadratic program has no solution");
  if(exact_reference::exactly_satisfies(problem.system, optimum.x))
    result.verdict = "rational";
  for(const Rational& value : optimum.x)
    result.bits = (std::max)({ result.bits, bit_length(exact_reference::numerator(value)),
                               bit_length(exact_reference::denominator(value)) });
  measure_solution(problem, optimum.x, result);
  return result;
}

Result run(const std::string& method, const Problem& problem)
{
  if(method == "ours")
    return run_ours(problem);
  if(method == "textbook")
    return run_textbook(problem);
  if(method == "naive")
    return run_naive(problem);
  return run_quadratic_program(problem);
}

// --- a process for each --------------------------------------------------------------------------

std::string to_text(const Result& r)
{
  std::ostringstream os;
  os.precision(17);
  os << r.seconds << ' ' << r.violation << ' ' << r.largest_change << ' ' << r.mean_change << ' '
     << r.bits << ' ' << r.verdict;
  return os.str();
}

Result from_text(const std::string& text)
{
  Result r;
  std::istringstream is(text);
  is >> r.seconds >> r.violation >> r.largest_change >> r.mean_change >> r.bits >> r.verdict;
  return r;
}

void print_head()
{
  std::printf("| model | system | nodes | variables | rows | method | ms | ratio to ours | exact "
              "| violation | bits | largest change | mean change |\n"
              "|---|---|--:|--:|--:|---|--:|--:|---|--:|--:|--:|--:|\n");
}

void print_start(const Problem& problem, const std::string& method)
{
  std::printf("| %s | %s | %zu | %zu | %zu | %s |", problem.model.c_str(), problem.kind.c_str(),
              problem.nodes, problem.xbar.size(), problem.system.rows.size(), method.c_str());
}

void print_end(benchmark::Child_end end, double seconds, double seconds_of_ours)
{
  if(end == benchmark::Child_end::TIME_IS_UP && seconds_of_ours > 0)
    std::printf(" > %.0f | > %.0f | time is up | | | | |\n", 1e3 * seconds,
                seconds / seconds_of_ours);
  else
    std::printf(" | | %s | | | | |\n", end == benchmark::Child_end::TIME_IS_UP ? "time is up"
                : end == benchmark::Child_end::OUT_OF_MEMORY ? "out of memory"
                                                             : "crash, or out of memory");
}

// Returns whether ours is exact.
bool compare_methods(const Problem& problem, const Settings& settings)
{
  double seconds_of_ours = 0;
  bool is_ours_exact = true;
  for(const std::string& method : settings.methods) {
    std::string text;
    print_start(problem, method);
    const auto end = benchmark::run_in_child([&] { return to_text(run(method, problem)); },
                                             settings.limits, text);
    if(end != benchmark::Child_end::FINISHED) {
      print_end(end, settings.limits.seconds, seconds_of_ours);
      is_ours_exact = is_ours_exact && method != "ours";
      continue;
    }
    const Result r = from_text(text);
    if(method == "ours") {
      seconds_of_ours = r.seconds;
      is_ours_exact = r.violation == 0;
    }
    std::printf(" %.3f | %.1f | %s | %.1e | %zu | %.2e | %.2e |\n", 1e3 * r.seconds,
                seconds_of_ours > 0 ? r.seconds / seconds_of_ours : 1., r.verdict.c_str(),
                r.violation, r.bits, r.largest_change, r.mean_change);
    std::fflush(stdout);
  }
  return is_ours_exact;
}

// --- the command line ----------------------------------------------------------------------------

void check_names(const std::vector<std::string>& names, const std::vector<std::string>& all)
{
  for(const std::string& name : names)
    if(std::find(all.begin(), all.end(), name) == all.end())
      throw options::error("unknown: " + name);
}

const std::vector<std::string> all_methods = { "ours", "textbook", "naive", "QP" };

std::optional<int> read_command_line(int argc, char** argv, Settings& settings)
{
  options::options_description description("Options");
  description.add_options()("file", options::value(&settings.files)->required(),
                            "OBJ or MatrixMarket files, or folders")(
    "methods",
    options::value(&settings.methods)
      ->multitoken()
      ->default_value(all_methods, "ours textbook naive QP")
      ->notifier([](const auto& names) { check_names(names, all_methods); }),
    "some of these")(
    "systems",
    options::value(&settings.systems)
      ->multitoken()
      ->default_value({ "reduced", "sectors" }, "reduced sectors")
      ->notifier([](const auto& names)
                 { check_names(names, { "reduced", "sectors", "corners" }); }),
    "some of these, or corners")(
    "time-limit", options::value(&settings.limits.seconds)->default_value(600), "seconds a run")(
    "memory-limit", options::value(&settings.limits.megabytes)->default_value(8000),
    "megabytes a run");
  return benchmark::read_command_line(argc, argv,
                                      "exact_comparison [options] FILE_OR_FOLDER...", description,
                                      "file");
}

int main(int argc, char** argv)
{
  Settings settings;
  if(const std::optional<int> exit_code = read_command_line(argc, argv, settings))
    return *exit_code;
  std::printf("Stopped after %g s or %zu MB a run.\n\n", settings.limits.seconds,
              settings.limits.megabytes);
  print_head();
  bool ok = true;
  for(const std::string& file : benchmark::files_of(settings.files, {".obj", ".mtx"})) {
    try {
      for(const Problem& problem : compared_systems::problems_of_file(file, settings.systems))
        ok = compare_methods(problem, settings) && ok;
    } catch(const std::exception& error) {
      std::cerr << error.what() << std::endl;
      ok = false;
    }
  }
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
