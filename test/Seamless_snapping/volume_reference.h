// Whether a parametrized tetrahedral mesh is exactly seamless, in rational numbers, and how far two
// maps are from each other: shares no code with the package.

#ifndef SEAMLESS_SNAPPING_TEST_VOLUME_REFERENCE_H
#define SEAMLESS_SNAPPING_TEST_VOLUME_REFERENCE_H

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
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

// The edges of a facet from its first vertex.
using Edge_pair = std::array<std::array<Rational, 3>, 2>;

inline Edge_pair edges(const std::array<Point, 3>& p)
{
  Edge_pair result;
  for(int i = 0; i < 2; ++i)
    for(int c = 0; c < 3; ++c)
      result[i][c] = Rational(p[i + 1][c]) - Rational(p[0][c]);
  return result;
}

inline bool is_rotated(const Edge_pair& p, const Edge_pair& q, const Matrix& m)
{
  for(int i = 0; i < 2; ++i)
    for(int r = 0; r < 3; ++r)
      for(int c = 0; c < 3; ++c)
        if(m[r][c] != 0 && q[i][r] != (m[r][c] > 0 ? p[i][c] : Rational(-p[i][c])))
          return false;
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
    const Edge_pair e = edges(p), f = edges(q);
    result.inexact += std::size_t(std::none_of(all.begin(), all.end(), [&](const Matrix& m) {
      return is_rotated(e, f, m);
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

// The sign of the volume of a cell in the domain: that of a number of more digits where it is far
// from 0, else in rational numbers.
template <typename Number>
int sign_of_volume(const Tet_map& map, const std::size_t cell, const Number& least_part)
{
  std::array<std::array<Number, 3>, 3> e;
  for(int i = 0; i < 3; ++i)
    for(int c = 0; c < 3; ++c)
      e[i][c] = Number(map.corners[4 * cell + i + 1][c]) - Number(map.corners[4 * cell][c]);
  Number det(0), size(0);
  for(int i = 0; i < 3; ++i)
    for(int j = 1; j < 3; ++j) {
      const Number term = e[0][i] * e[1][(i + j) % 3] * e[2][(i + 3 - j) % 3];
      det += j == 1 ? term : Number(-term);
      size += term < 0 ? Number(-term) : term;
    }
  size *= least_part;
  return det > size ? 1 : det < -size ? -1 : 0;
}

inline int orientation(const Tet_map& map, const std::size_t cell)
{
  static_assert(std::numeric_limits<long double>::digits >= 64, "the bound is for these");
  const int sign = sign_of_volume<long double>(map, cell, 1e-15L);
  return sign != 0 ? sign : sign_of_volume<Rational>(map, cell, Rational(0));
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
