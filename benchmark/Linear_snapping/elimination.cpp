// Times snap_to_linear_constraints() on systems C x = 0 from MatrixMarket files.
//
// Input: values of magnitude 1 drawn at random and snapped once, so that they solve the system,
// then moved by noise of 1e-8, which is what numerical solvers leave. Times are in milliseconds,
// the shortest of several runs: of the clock for the steps, of the processor for the total. "exact"
// is this program's own check in rational arithmetic.

#include "benchmark_tools.h"
#include "command_line.h"

#include <CGAL/Linear_snapping/snap_to_linear_constraints.h>

#include <CGAL/Exact_rational.h>

#include <Eigen/SparseCore>
#include <unsupported/Eigen/SparseExtra>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <random>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace options = benchmark::options;

using Matrix = Eigen::SparseMatrix<int>;
using Values = std::vector<double>;

struct Settings
{
  std::vector<std::string> files;
  int repeats;
  unsigned int seed;
  double noise;
};

// --- one system ----------------------------------------------------------------------------------

bool is_exact(const Matrix& matrix, const Values& x)
{
  std::vector<CGAL::Exact_rational> sums(std::size_t(matrix.rows()), CGAL::Exact_rational(0));
  for(Eigen::Index c = 0; c < matrix.cols(); ++c)
    for(Matrix::InnerIterator entry(matrix, c); entry; ++entry)
      sums[std::size_t(entry.row())] +=
        CGAL::Exact_rational(entry.value()) * CGAL::Exact_rational(x[std::size_t(c)]);
  return std::all_of(sums.begin(), sums.end(), [](const auto& sum) { return sum == 0; });
}

void add_noise(Values& x, double size, std::mt19937_64& random)
{
  for(double& value : x)
    value += size * static_cast<double>(static_cast<std::int64_t>(random())) * 0x1p-63;
}

double largest_difference(const Values& a, const Values& b)
{
  double result = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    result = (std::max)(result, std::abs(a[i] - b[i]));
  return result;
}

struct Measurement
{
  std::string name;
  std::size_t rows, columns, entries;
  benchmark::Shortest_times run;
  CGAL::Linear_snapping::Linear_report report;
  bool exact;
  double largest_change;
};

Measurement measure(const Matrix& matrix, const Settings& settings)
{
  std::mt19937_64 random(settings.seed);
  Values input(std::size_t(matrix.cols()), 0.);
  add_noise(input, 1, random);
  CGAL::Linear_snapping::snap_to_linear_constraints(matrix, input);
  add_noise(input, settings.noise, random);

  Measurement result;
  result.rows = std::size_t(matrix.rows());
  result.columns = std::size_t(matrix.cols());
  result.entries = std::size_t(matrix.nonZeros());
  for(int i = 0; i < settings.repeats; ++i) {
    Values x = input;
    const std::clock_t start = std::clock();
    result.report = CGAL::Linear_snapping::snap_to_linear_constraints(matrix, x);
    result.run.add(result.report.step_times, double(std::clock() - start) / CLOCKS_PER_SEC);
    result.exact = is_exact(matrix, x);
    result.largest_change = largest_difference(input, x);
  }
  return result;
}

// --- the table -----------------------------------------------------------------------------------

double milliseconds(const Measurement& m, const std::string& step)
{
  benchmark::Step_times steps = m.run.steps();
  return 1e3 * benchmark::time_of(step, steps);
}

void print_head()
{
  std::printf("%-40s %7s %7s %8s | %9s %9s %9s %9s %9s %9s | %5s %5s %9s %s\n",
              "system", "rows", "columns", "entries", "input", "eliminate", "target", "evaluate",
              "verify", "total CPU", "bits", "exact", "change", "status");
}

void print(const Measurement& m)
{
  std::printf("%-40s %7zu %7zu %8zu | %9.2f %9.2f %9.2f %9.2f %9.2f %9.2f | %5zu %5s %9.2e %s\n",
              m.name.c_str(), m.rows, m.columns, m.entries, milliseconds(m, "input"),
              milliseconds(m, "elimination"), milliseconds(m, "least-squares target"),
              milliseconds(m, "evaluation"), milliseconds(m, "verification"),
              1e3 * m.run.total(), m.report.linear_solver.coefficient_bits, m.exact ? "yes" : "NO",
              m.largest_change, CGAL::Linear_snapping::to_string(m.report.status));
  std::fflush(stdout);
}

// Over the plain seam systems, that is those without connections.
void print_growth(const std::vector<Measurement>& all)
{
  std::vector<std::pair<double, double> > elimination, target, total;
  for(const Measurement& m : all) {
    if(m.name.find("seams_") != 0 || m.name.find("connections") != std::string::npos)
      continue;
    const double size = double(m.columns);
    elimination.emplace_back(size, milliseconds(m, "elimination"));
    target.emplace_back(size, milliseconds(m, "least-squares target"));
    total.emplace_back(size, m.run.total());
  }
  if(total.size() > 1)
    std::printf("growth with the columns of the seam systems without connections: "
                "elimination n^%.2f, target n^%.2f, total n^%.2f\n",
                benchmark::growth_exponent(elimination), benchmark::growth_exponent(target),
                benchmark::growth_exponent(total));
}

// --- the command line ----------------------------------------------------------------------------

std::optional<int> read_command_line(int argc, char** argv, Settings& settings)
{
  options::options_description description("Options");
  description.add_options()(
    "file", options::value(&settings.files)->required(),
    "MatrixMarket files, or folders (may go without --file)")(
    "repeats", options::value(&settings.repeats)->default_value(5), "the shortest counts")(
    "seed", options::value(&settings.seed)->default_value(1), "of the random values")(
    "noise", options::value(&settings.noise)->default_value(1e-8), "added to a solution");
  return benchmark::read_command_line(argc, argv, "elimination [options] FILE_OR_FOLDER...",
                                      description, "file");
}

int main(int argc, char** argv)
{
  Settings settings;
  if(const std::optional<int> exit_code = read_command_line(argc, argv, settings))
    return *exit_code;

  std::vector<Measurement> all;
  print_head();
  for(const std::string& file : benchmark::files_of(settings.files, {".mtx"})) {
    Matrix matrix;
    if(!Eigen::loadMarket(matrix, file)) {
      std::cerr << "cannot read " << file << std::endl;
      return EXIT_FAILURE;
    }
    all.push_back(measure(matrix, settings));
    all.back().name = std::filesystem::path(file).stem().string();
    print(all.back());
  }
  print_growth(all);
  const bool ok = std::all_of(all.begin(), all.end(), [](const Measurement& m) { return m.exact; });
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
