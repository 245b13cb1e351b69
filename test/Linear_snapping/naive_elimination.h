// Constraint elimination in floating point, the comparison of Sec. 6.1: row reduction, free
// variables kept, and Eq. (2') evaluated for the others, all in doubles. The values violate the
// constraints.

#ifndef SEAMLESS_SNAPPING_TEST_NAIVE_ELIMINATION_H
#define SEAMLESS_SNAPPING_TEST_NAIVE_ELIMINATION_H

#include "exact_reference.h"

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace naive {

struct Dense_system // C x = b
{
  std::vector<std::vector<double> > c; // rows
  std::vector<double> b;
};

inline Dense_system dense_system(const exact_reference::System& system)
{
  Dense_system result;
  for(std::size_t r = 0; r < system.rows.size(); ++r) {
    result.c.emplace_back(system.columns, 0.);
    for(const auto& entry : system.rows[r])
      result.c.back()[entry.column] += CGAL::to_double(entry.coefficient);
    result.b.push_back(CGAL::to_double(system.b[r]));
  }
  return result;
}

// What is smaller than this counts as zero, for coefficients that are small integers to begin with.
const double tolerance = 1e-9;

// Reduced row echelon form with pivots 1, chosen by size within each column. Returns their columns.
inline std::vector<std::size_t> reduce(Dense_system& system)
{
  std::vector<std::size_t> pivots;
  const std::size_t rows = system.c.size(), columns = rows == 0 ? 0 : system.c[0].size();
  for(std::size_t column = 0; column < columns && pivots.size() < rows; ++column) {
    const std::size_t k = pivots.size();
    std::size_t l = k;
    for(std::size_t i = k + 1; i < rows; ++i)
      if(std::abs(system.c[i][column]) > std::abs(system.c[l][column]))
        l = i;
    const double pivot = system.c[l][column];
    if(std::abs(pivot) < tolerance)
      continue;
    std::swap(system.c[k], system.c[l]);
    std::swap(system.b[k], system.b[l]);
    const std::vector<double>& by = system.c[k];
    for(double& a : system.c[k])
      a /= pivot;
    system.b[k] /= pivot;
    for(std::size_t i = 0; i < rows; ++i) {
      const double factor = system.c[i][column];
      if(i == k || factor == 0)
        continue;
      for(std::size_t j = column; j < columns; ++j)
        system.c[i][j] -= factor * by[j];
      system.b[i] -= factor * system.b[k];
    }
    pivots.push_back(column);
  }
  return pivots;
}

inline void eliminate(Dense_system system, std::vector<double>& x)
{
  const std::vector<std::size_t> pivots = reduce(system);
  for(std::size_t k = 0; k < pivots.size(); ++k) {
    double sum = system.b[k];
    for(std::size_t j = pivots[k] + 1; j < x.size(); ++j)
      if(system.c[k][j] != 0)
        sum -= system.c[k][j] * x[j];
    x[pivots[k]] = sum;
  }
}

} // namespace naive

#endif // SEAMLESS_SNAPPING_TEST_NAIVE_ELIMINATION_H
