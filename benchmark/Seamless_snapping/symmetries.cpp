// Times the reduced systems of rotational symmetries of order N = 1, 2, 3, 4, 6 against each other,
// and measures how close their solutions come to the least-squares optimum.
//
// Input: generated complexes of the same shape for all N. Those of a sphere have one node per
// vertex of a triangle mesh, and a branch with three inner vertices per edge; each face has a
// chart that is turned at random, and cones are at the ends of one edge in eight, whose transition
// is drawn at random. The others are drawn at random altogether, with chains and connections. Their
// coordinates are an exact solution, moved by noise of 1e-8. Times are in milliseconds, the
// shortest of several runs.

#include "hexagonal_maps.h"
#include "net_of_cuts.h"
#include "benchmark_tools.h"
#include "command_line.h"

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Seamless_snapping/internal/complex/Complex_solver.h>
#include <CGAL/Seamless_snapping/internal/complex/is_exact.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace options = benchmark::options;
namespace internal = CGAL::Seamless_snapping::internal;

using hexagonal_maps::Mesh;
using hexagonal_maps::Vector;
using random_complexes::Complex;
using random_complexes::net_of_cuts;

struct Measurement
{
  double milliseconds = 0, closeness = 0;
  std::size_t nodes = 0;
  long largest_pivot = 0;
  bool is_exact = false;
};

template <int N>
double sum_of_squares(const std::vector<Vector>& a, const std::vector<Vector>& b)
{
  double result = 0;
  for(std::size_t s = 0; s < a.size(); ++s)
    for(const double x : internal::Group_of_order<N>::to_cartesian({a[s][0] - b[s][0],
                                                                    a[s][1] - b[s][1]}))
      result += x * x;
  return result;
}

template <int N>
Measurement measure(Complex<N> complex, const int repeats, const unsigned int seed)
{
  using Solver = internal::Complex_solver<internal::Group_of_order<N> >;
  const auto format = internal::Number_format::of<double>();
  internal::Snapped_coordinates<internal::Group_of_order<N> > snapped;
  if(Solver(complex, format).solve(snapped))
    return {};
  complex.coordinates = snapped.coordinates;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1e-8, 1e-8);
  for(Vector& u : complex.coordinates)
    for(double& x : u)
      x += uniform(random);
  Measurement result;
  result.nodes = std::size_t(std::count(complex.is_node.begin(), complex.is_node.end(), true));
  for(int i = 0; i < repeats; ++i) {
    const double start = benchmark::seconds_now();
    Solver solver(complex, format);
    if(solver.solve(snapped))
      return {};
    const double time = 1e3 * (benchmark::seconds_now() - start);
    result.milliseconds = i == 0 ? time : (std::min)(result.milliseconds, time);
    result.largest_pivot = long(solver.linear_solver().figures().largest_pivot);
  }
  result.closeness = std::sqrt(sum_of_squares<N>(snapped.coordinates, complex.coordinates)) /
                     snapped.optimal_changes.root(1);
  result.is_exact = internal::is_exact(complex, snapped.coordinates);
  return result;
}

bool print(const char* const shape, const int N, const Measurement& m, const double unit)
{
  std::printf("%-8s %6zu %2d %9.2f %6.2f %10.6f %6ld %6s\n", shape, m.nodes, N, m.milliseconds,
              m.milliseconds / unit, m.closeness, m.largest_pivot, m.is_exact ? "yes" : "NO");
  return m.is_exact;
}

// \param make makes the complex for a value of N
template <typename Make>
bool compare(const char* const shape, const Make& make, const int repeats, const unsigned int seed)
{
  const Measurement four = measure<4>(make.template operator()<4>(), repeats, seed);
  const double unit = four.milliseconds;
  bool all = print(shape, 4, four, unit);
  all &= print(shape, 1, measure<1>(make.template operator()<1>(), repeats, seed), unit);
  all &= print(shape, 2, measure<2>(make.template operator()<2>(), repeats, seed), unit);
  all &= print(shape, 3, measure<3>(make.template operator()<3>(), repeats, seed), unit);
  all &= print(shape, 6, measure<6>(make.template operator()<6>(), repeats, seed), unit);
  return all;
}

struct Net
{
  const Mesh& mesh;
  unsigned int seed;

  template <int N>
  Complex<N> operator()() const { return net_of_cuts<N>(mesh, seed); }
};

struct Random
{
  std::size_t branches;
  unsigned int seed;

  template <int N>
  Complex<N> operator()() const
  {
    return random_complexes::Generator<N>(seed).make(branches, false);
  }
};

int main(int argc, char* argv[])
{
  int repeats = 5;
  unsigned int seed = 1;
  options::options_description description("Options");
  description.add_options()(
    "repeats", options::value(&repeats)->default_value(repeats), "the shortest counts")(
    "seed", options::value(&seed)->default_value(seed), "of all that is drawn at random");
  if(const auto exit_code =
       benchmark::read_command_line(argc, argv, "symmetries [options]", description, ""))
    return *exit_code;
  const internal::Protect_exact_arithmetic protect;
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  std::printf("shape     nodes  N      time  ratio closeness   pivot  exact\n");
  bool all = true;
  for(const unsigned int times : {3u, 4u}) { // 642 and 2,562 vertices
    const Mesh mesh = hexagonal_maps::subdivided(hexagonal_maps::icosahedron(), times);
    all = compare("sphere", Net{mesh, seed}, repeats, seed) && all;
  }
  for(const std::size_t branches : {420u, 4200u})
    all = compare("random", Random{branches, seed}, repeats, seed) && all;
  return all ? EXIT_SUCCESS : EXIT_FAILURE;
}
