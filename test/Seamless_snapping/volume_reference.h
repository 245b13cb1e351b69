// Whether a parametrized tetrahedral mesh is exactly seamless, in rational numbers, and how far two
// maps are from each other: shares no code with the package.

#ifndef SEAMLESS_SNAPPING_TEST_VOLUME_REFERENCE_H
#define SEAMLESS_SNAPPING_TEST_VOLUME_REFERENCE_H

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace volume_reference {

using Rational = CGAL::Exact_rational;
using Point = std::array<double, 3>;
using Matrix = std::array<std::array<int, 3>, 3>;
using Facet = std::array<int, 3>; // vertices, ascending

struct Tet_map
{
  std::vector<std::array<int, 4> > cells;
  std::vector<Point> corners; // 4 i + k
};

// All signed permutation matrices of determinant 1.
inline std::vector<Matrix> rotations()
{
  std::vector<Matrix> result;
  std::array<int, 3> p{{0, 1, 2}};
  do
    for(int signs = 0; signs < 8; ++signs) {
      Matrix m{};
      for(int i = 0; i < 3; ++i)
        m[i][p[i]] = (signs >> i & 1) != 0 ? -1 : 1;
      const int det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                      m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                      m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
      if(det == 1)
        result.push_back(m);
    }
  while(std::next_permutation(p.begin(), p.end()));
  return result;
}

using Rational_facet = std::array<std::array<Rational, 3>, 3>;

// The coordinates of the vertices of a facet, in the order of the vertices' numbers.
inline std::array<Point, 3> facet_points(const Tet_map& map, const std::size_t cell,
                                         const Facet& facet)
{
  std::array<Point, 3> result;
  for(int i = 0; i < 3; ++i)
    for(int k = 0; k < 4; ++k)
      if(map.cells[cell][k] == facet[i])
        result[i] = map.corners[4 * cell + k];
  return result;
}

inline bool is_rotated(const std::array<Point, 3>& p, const std::array<Point, 3>& q,
                       const Matrix& m)
{
  for(int i = 1; i < 3; ++i)
    for(int r = 0; r < 3; ++r) {
      Rational sum = Rational(q[0][r]) - Rational(q[i][r]);
      for(int c = 0; c < 3; ++c)
        if(m[r][c] != 0)
          sum += m[r][c] * (Rational(p[i][c]) - Rational(p[0][c]));
      if(sum != 0)
        return false;
    }
  return true;
}

struct Result
{
  std::size_t interior = 0, cuts = 0, inexact = 0, border = 0, misaligned = 0;

  bool is_exact() const { return inexact == 0 && misaligned == 0; }
};

inline std::map<Facet, std::vector<std::size_t> > cells_of_facets(const Tet_map& map)
{
  std::map<Facet, std::vector<std::size_t> > result;
  for(std::size_t c = 0; c < map.cells.size(); ++c)
    for(int k = 0; k < 4; ++k) {
      Facet facet;
      for(int i = 0; i < 3; ++i)
        facet[i] = map.cells[c][(k + 1 + i) % 4];
      std::sort(facet.begin(), facet.end());
      result[facet].push_back(c);
    }
  return result;
}

inline bool is_aligned(const std::array<Point, 3>& p)
{
  for(int c = 0; c < 3; ++c)
    if(p[0][c] == p[1][c] && p[0][c] == p[2][c])
      return true;
  return false;
}

// \param features interior facets that are to be aligned as well
inline Result check(const Tet_map& map, const bool align_boundary = true,
                    const std::vector<Facet>& features = {})
{
  static const std::vector<Matrix> all = rotations();
  Result result;
  for(const auto& [facet, cells] : cells_of_facets(map)) {
    const auto p = facet_points(map, cells[0], facet);
    if(cells.size() == 1) {
      ++result.border;
      result.misaligned += std::size_t(align_boundary && !is_aligned(p));
      continue;
    }
    ++result.interior;
    const auto q = facet_points(map, cells[1], facet);
    if(p == q)
      continue;
    ++result.cuts;
    result.inexact += std::size_t(std::none_of(all.begin(), all.end(), [&](const Matrix& m) {
      return is_rotated(p, q, m);
    }));
  }
  for(Facet facet : features) {
    std::sort(facet.begin(), facet.end());
    const auto all_cells = cells_of_facets(map);
    const auto found = all_cells.find(facet);
    if(found == all_cells.end() || !is_aligned(facet_points(map, found->second[0], facet)))
      ++result.misaligned;
  }
  return result;
}

// The sign of the volume of a cell in the domain.
inline int orientation(const Tet_map& map, const std::size_t cell)
{
  std::array<std::array<Rational, 3>, 3> e;
  for(int i = 0; i < 3; ++i)
    for(int c = 0; c < 3; ++c)
      e[i][c] = Rational(map.corners[4 * cell + i + 1][c]) - Rational(map.corners[4 * cell][c]);
  const Rational det = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                       e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                       e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
  return det > 0 ? 1 : det < 0 ? -1 : 0;
}

// Cells that were positive, and are not.
inline std::size_t lost_cells(const Tet_map& before, const Tet_map& after)
{
  std::size_t result = 0;
  for(std::size_t c = 0; c < before.cells.size(); ++c) {
    bool is_same = true;
    for(std::size_t k = 4 * c; k < 4 * c + 4; ++k)
      is_same = is_same && before.corners[k] == after.corners[k];
    if(is_same)
      continue;
    result += std::size_t(orientation(before, c) > 0 && orientation(after, c) <= 0);
  }
  return result;
}

inline double largest_change(const Tet_map& before, const Tet_map& after)
{
  double result = 0;
  for(std::size_t i = 0; i < before.corners.size(); ++i)
    for(int c = 0; c < 3; ++c)
      result = (std::max)(result, std::abs(before.corners[i][c] - after.corners[i][c]));
  return result;
}

inline double extent(const Tet_map& map)
{
  double result = 0;
  for(int c = 0; c < 3; ++c) {
    double least = map.corners[0][c], largest = least;
    for(const Point& p : map.corners) {
      least = (std::min)(least, p[c]);
      largest = (std::max)(largest, p[c]);
    }
    result = (std::max)(result, largest - least);
  }
  return result;
}

} // namespace volume_reference

#endif // SEAMLESS_SNAPPING_TEST_VOLUME_REFERENCE_H
