// The least-squares optimum of a map of a volume under the equations of all its facets, in floating
// point: all sectors are unknowns, and facets are all that it knows. Conjugate gradients, in units
// of the violation, so that the result has more digits than the grid.

#ifndef SEAMLESS_SNAPPING_TEST_VOLUME_OPTIMUM_H
#define SEAMLESS_SNAPPING_TEST_VOLUME_OPTIMUM_H

#include "volume_reference.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace volume_optimum {

using volume_reference::Facet;
using volume_reference::Matrix;
using volume_reference::Point;
using volume_reference::Tet_map;

using Row = std::vector<std::pair<std::size_t, double> >;

// Unknown 3 s + c is coordinate c of sector s: the corners at a vertex that are joined by facets
// whose sides are the same.
struct Equations
{
  std::vector<std::size_t> sector; // per corner
  std::vector<double> values;      // per unknown
  std::vector<Row> rows;
};

inline double misfit(const std::array<Point, 3>& p, const std::array<Point, 3>& q, const Matrix& m)
{
  double largest = 0;
  for(int i = 1; i < 3; ++i)
    for(int r = 0; r < 3; ++r) {
      double sum = q[0][r] - q[i][r];
      for(int c = 0; c < 3; ++c)
        sum += m[r][c] * (p[i][c] - p[0][c]);
      largest = (std::max)(largest, std::abs(sum));
    }
  return largest;
}

inline Equations equations_of(const Tet_map& map)
{
  Equations result;
  std::vector<std::size_t> parent(map.corners.size());
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  const auto root = [&](std::size_t i) {
    while(parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  };
  const auto corner = [&](const std::size_t cell, const int vertex) {
    std::size_t k = 4 * cell;
    while(map.cells[cell][k % 4] != vertex)
      ++k;
    return k;
  };
  const auto facets = volume_reference::cells_of_facets(map);
  for(const auto& [facet, cells] : facets)
    if(cells.size() == 2 && volume_reference::facet_points(map, cells[0], facet) ==
                              volume_reference::facet_points(map, cells[1], facet))
      for(const int v : facet)
        parent[root(corner(cells[0], v))] = root(corner(cells[1], v));
  std::map<std::size_t, std::size_t> sectors;
  for(std::size_t i = 0; i < map.corners.size(); ++i) {
    const auto found = sectors.emplace(root(i), sectors.size());
    result.sector.push_back(found.first->second);
    if(found.second)
      result.values.insert(result.values.end(), map.corners[i].begin(), map.corners[i].end());
  }
  const auto unknown = [&](const std::size_t cell, const int vertex, const int c) {
    return 3 * result.sector[corner(cell, vertex)] + std::size_t(c);
  };
  static const std::vector<Matrix> all = volume_reference::rotations();
  for(const auto& [facet, cells] : facets) {
    const auto p = volume_reference::facet_points(map, cells[0], facet);
    if(cells.size() == 1) {
      int best = 0;
      std::array<double, 3> spread;
      for(int c = 0; c < 3; ++c) {
        spread[c] = (std::max)(std::abs(p[1][c] - p[0][c]), std::abs(p[2][c] - p[0][c]));
        best = spread[c] < spread[best] ? c : best;
      }
      for(int i = 1; i < 3; ++i)
        result.rows.push_back({{unknown(cells[0], facet[i], best), 1.},
                               {unknown(cells[0], facet[0], best), -1.}});
      continue;
    }
    const auto q = volume_reference::facet_points(map, cells[1], facet);
    if(p == q)
      continue;
    const Matrix* best = &all[0];
    for(const Matrix& m : all)
      if(misfit(p, q, m) < misfit(p, q, *best))
        best = &m;
    for(int i = 1; i < 3; ++i)
      for(int r = 0; r < 3; ++r) {
        Row row{{unknown(cells[1], facet[i], r), -1.}, {unknown(cells[1], facet[0], r), 1.}};
        for(int c = 0; c < 3; ++c)
          if((*best)[r][c] != 0) {
            row.push_back({unknown(cells[0], facet[i], c), double((*best)[r][c])});
            row.push_back({unknown(cells[0], facet[0], c), -double((*best)[r][c])});
          }
        result.rows.push_back(row);
      }
  }
  return result;
}

// x - A^T y with A A^T y = A x
inline std::vector<double> projected(const std::vector<Row>& rows, const std::vector<double>& x,
                                     const std::vector<double>& right)
{
  const auto times = [&](const std::vector<double>& v) {
    std::vector<double> result;
    for(const Row& row : rows) {
      double sum = 0;
      for(const auto& [j, a] : row)
        sum += a * v[j];
      result.push_back(sum);
    }
    return result;
  };
  const auto transposed = [&](const std::vector<double>& y) {
    std::vector<double> result(x.size(), 0);
    for(std::size_t i = 0; i < rows.size(); ++i)
      for(const auto& [j, a] : rows[i])
        result[j] += a * y[i];
    return result;
  };
  const auto dot = [](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for(std::size_t i = 0; i < a.size(); ++i)
      sum += a[i] * b[i];
    return sum;
  };
  std::vector<double> y(rows.size(), 0), r = right, p = r;
  double rho = dot(r, r);
  const double enough = 1e-28 * rho;
  for(int i = 0; i < 20000 && rho > enough; ++i) {
    const std::vector<double> q = times(transposed(p));
    const double step = rho / dot(p, q);
    for(std::size_t k = 0; k < y.size(); ++k) {
      y[k] += step * p[k];
      r[k] -= step * q[k];
    }
    const double next = dot(r, r);
    for(std::size_t k = 0; k < y.size(); ++k)
      p[k] = r[k] + next / rho * p[k];
    rho = next;
  }
  std::vector<double> result(x);
  const std::vector<double> by = transposed(y);
  for(std::size_t j = 0; j < x.size(); ++j)
    result[j] -= by[j];
  return result;
}

// Per corner.
inline std::vector<Point> optimum(const Tet_map& map)
{
  const Equations equations = equations_of(map);
  std::vector<double> violations; // with few digits lost, as neighbors are near each other
  for(const Row& row : equations.rows) {
    long double sum = 0;
    for(const auto& [j, a] : row)
      sum += a * static_cast<long double>(equations.values[j]);
    violations.push_back(static_cast<double>(sum));
  }
  const std::vector<double> x = projected(equations.rows, equations.values, violations);
  std::vector<Point> result;
  for(const std::size_t s : equations.sector)
    result.push_back({{x[3 * s], x[3 * s + 1], x[3 * s + 2]}});
  return result;
}

// Over all sectors; these are corners at a vertex with the same coordinates before.
inline double sum_of_squared_changes(const Tet_map& before, const Tet_map& after)
{
  std::map<std::pair<int, Point>, double> changes;
  for(std::size_t i = 0; i < before.corners.size(); ++i) {
    double square = 0;
    for(int c = 0; c < 3; ++c)
      square += std::pow(after.corners[i][c] - before.corners[i][c], 2);
    changes[{before.cells[i / 4][i % 4], before.corners[i]}] = square;
  }
  double result = 0;
  for(const auto& change : changes)
    result += change.second;
  return result;
}

} // namespace volume_optimum

#endif // SEAMLESS_SNAPPING_TEST_VOLUME_OPTIMUM_H
