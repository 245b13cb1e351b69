// A program of a project that uses the package: it compiles, links and runs, with no more than what
// the target of the package brings along.

#include <CGAL/Linear_snapping/snap_to_linear_constraints.h>

#include <cstdlib>
#include <iostream>
#include <vector>

int main()
{
  CGAL::Linear_snapping::Linear_constraints<> constraints(3);
  constraints.add_constraint({{0, 1}, {1, -1}});
  constraints.add_constraint({{1, 3}, {2, 1}}, 5);
  std::vector<double> x = {0.1, 0.10000001, 4.7};
  const auto report = CGAL::Linear_snapping::snap_to_linear_constraints(constraints, x);

  const CGAL::Exact_rational sum = 3 * CGAL::Exact_rational(x[1]) + CGAL::Exact_rational(x[2]);
  const bool is_exact = (x[0] == x[1]) && (sum == 5);
  std::cout << report << ": " << x[0] << " " << x[1] << " " << x[2] << std::endl;
  return (report && is_exact) ? EXIT_SUCCESS : EXIT_FAILURE;
}
