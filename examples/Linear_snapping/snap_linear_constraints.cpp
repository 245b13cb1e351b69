// Moves values that nearly satisfy linear equations to values that satisfy them exactly.

#include <CGAL/Linear_snapping/snap_to_linear_constraints.h>

#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <vector>

int main()
{
  CGAL::Linear_snapping::Linear_constraints<> constraints(3); // three unknowns
  constraints.add_constraint({{0, 1}, {1, -1}});                // x0 - x1 = 0
  constraints.add_constraint({{1, 3}, {2, 1}}, 5);              // 3 x1 + x2 = 5

  std::vector<double> x = {0.1, 0.1, 4.7}; // nearly a solution
  std::cout << "residual of the second equation: " << std::fma(3, x[1], x[2] - 5) << "\n";
  const auto report = CGAL::Linear_snapping::snap_to_linear_constraints(constraints, x);
  std::cout << report << ", largest change " << report.largest_change << "\n"
            << std::setprecision(17);
  for(const double value : x)
    std::cout << value << "\n";
  std::cout << "residual of the second equation: " << std::fma(3, x[1], x[2] - 5) << "\n"; // 0
  return report ? EXIT_SUCCESS : EXIT_FAILURE;
}
