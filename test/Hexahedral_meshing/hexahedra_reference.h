// Checks of hexahedra that share no code with the package: against those of the complex that a map
// was made of, against integers of the map alone, and against other hexahedra.

#ifndef HEXAHEDRAL_MESHING_TEST_HEXAHEDRA_REFERENCE_H
#define HEXAHEDRAL_MESHING_TEST_HEXAHEDRA_REFERENCE_H

#include "checking.h"
#include "integer_maps.h"
#include "volume_reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace hexahedra_reference {

using integer_maps::Integer_map;
using volume_reference::Point;
using volume_reference::Rational;
using volume_reference::Tet_map;

struct Hexahedra
{
  std::vector<Point> points;
  std::vector<std::array<int, 8> > cells;

  // The vertices of edges, by the order that the manual draws.
  static constexpr int edges[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                       {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  static constexpr int facets[6][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                       {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
};

// Points that differ by rounding are one.
class Point_names
{
public:
  int name(const Point& p)
  {
    std::array<long long, 3> key, other;
    for(int k = 0; k < 3; ++k)
      key[k] = std::llround(p[k] * 1e8);
    for(int i = 0; i < 27; ++i) {
      other = {{key[0] + i % 3 - 1, key[1] + i / 3 % 3 - 1, key[2] + i / 9 - 1}};
      if(const auto found = m_names.find(other); found != m_names.end())
        return found->second;
    }
    return m_names.emplace(key, int(m_names.size())).first->second;
  }

  std::size_t size() const { return m_names.size(); }

private:
  std::map<std::array<long long, 3>, int> m_names;
};

using Shape = std::vector<std::array<int, 2> >; // the edges of a hexahedron, sorted

inline Shape shape(const std::array<int, 8>& names)
{
  Shape result;
  for(const auto& e : Hexahedra::edges)
    result.push_back({{(std::min)(names[e[0]], names[e[1]]),
                       (std::max)(names[e[0]], names[e[1]])}});
  std::sort(result.begin(), result.end());
  return result;
}

inline std::vector<Shape> shapes(const Hexahedra& hexahedra, Point_names& names)
{
  std::vector<Shape> result;
  for(const auto& cell : hexahedra.cells) {
    std::array<int, 8> of_cell;
    for(int k = 0; k < 8; ++k)
      of_cell[k] = names.name(hexahedra.points[std::size_t(cell[k])]);
    result.push_back(shape(of_cell));
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Whether two lists of hexahedra are the same, in any order.
inline bool are_same(const Hexahedra& a, const Hexahedra& b)
{
  Point_names names;
  const std::vector<Shape> of_a = shapes(a, names);
  const std::size_t number = names.size();
  return of_a == shapes(b, names) && names.size() == number &&
         a.points.size() == b.points.size() && number <= a.points.size();
}

// Unit cubes of the blocks' coordinates, wherever all of their corners are.
inline Hexahedra expected_hexahedra(const Integer_map& map)
{
  const integer_maps::Point_locator locator(map);
  std::map<int, std::pair<Point, Point> > boxes;
  for(std::size_t i = 0; i < map.in_block.size(); ++i) {
    const Point& p = map.in_block[i];
    auto& box = boxes.emplace(map.block_of_cell[i / 4], std::make_pair(p, p)).first->second;
    for(int k = 0; k < 3; ++k) {
      box.first[k] = (std::min)(box.first[k], p[k]);
      box.second[k] = (std::max)(box.second[k], p[k]);
    }
  }
  Hexahedra result;
  Point_names names;
  for(const auto& [block, box] : boxes)
    for(double x = std::ceil(box.first[0]); x < box.second[0]; ++x)
      for(double y = std::ceil(box.first[1]); y < box.second[1]; ++y)
        for(double z = std::ceil(box.first[2]); z < box.second[2]; ++z) {
          Point in_space;
          if(!locator.locate(block, {{x + 0.5, y + 0.5, z + 0.5}}, in_space))
            continue;
          std::array<int, 8> cell;
          for(int k = 0; k < 8; ++k) {
            const Point corner{{x + (k % 4 == 1 || k % 4 == 2), y + (k % 4 > 1), z + (k > 3)}};
            CHECK(locator.locate(block, corner, in_space));
            cell[k] = names.name(in_space);
            if(cell[k] == int(result.points.size()))
              result.points.push_back(in_space);
          }
          result.cells.push_back(cell);
        }
  return result;
}

// What holds for the hexahedra of any map, by integers that the map alone tells.
struct Integers
{
  Rational volume{0}, border_area{0};
  long long euler_characteristic = 0; // of a mesh whose parts don't touch in edges or vertices only
};

inline Integers integers(const Tet_map& map)
{
  Integers result;
  std::set<int> vertices;
  std::set<std::pair<int, int> > edges;
  for(std::size_t c = 0; c < map.cells.size(); ++c) {
    std::array<std::array<Rational, 3>, 3> e;
    for(int i = 0; i < 3; ++i)
      for(int k = 0; k < 3; ++k)
        e[i][k] = Rational(map.corners[4 * c + i + 1][k]) - Rational(map.corners[4 * c][k]);
    result.volume += (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                      e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                      e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) / 6;
    for(const int a : map.cells[c]) {
      vertices.insert(a);
      for(const int b : map.cells[c])
        if(a < b)
          edges.emplace(a, b);
    }
  }
  result.volume = CGAL::abs(result.volume);
  const auto facets = volume_reference::cells_of_facets(map);
  for(const auto& [facet, cells] : facets)
    if(cells.size() == 1) {
      const auto e = volume_reference::edges(volume_reference::facet_points(map, cells[0], facet));
      for(int k = 0; k < 3; ++k) // two of these are zero
        result.border_area += CGAL::abs(Rational(e[0][k] * e[1][(k + 1) % 3] -
                                                 e[0][(k + 1) % 3] * e[1][k])) / 2;
    }
  result.euler_characteristic = (long long)(vertices.size()) - (long long)(edges.size()) +
                                (long long)(facets.size()) - (long long)(map.cells.size());
  return result;
}

// The number of hexahedra around interior edges, if not four.
inline std::map<int, std::size_t> irregular_edges(const Hexahedra& hexahedra)
{
  std::map<std::pair<int, int>, int> number;
  std::map<std::array<int, 4>, std::array<int, 4> > boundary; // by sorted vertices
  for(const auto& cell : hexahedra.cells) {
    for(const auto& e : Hexahedra::edges)
      ++number[std::minmax({cell[e[0]], cell[e[1]]})];
    for(const auto& f : Hexahedra::facets) {
      const std::array<int, 4> q{{cell[f[0]], cell[f[1]], cell[f[2]], cell[f[3]]}};
      std::array<int, 4> key = q;
      std::sort(key.begin(), key.end());
      if(!boundary.emplace(key, q).second)
        boundary.erase(key);
    }
  }
  for(const auto& [key, q] : boundary)
    for(int k = 0; k < 4; ++k)
      number.erase(std::minmax({q[k], q[(k + 1) % 4]}));
  std::map<int, std::size_t> result;
  for(const auto& [edge, n] : number)
    if(n != 4)
      ++result[n];
  return result;
}

inline void check_hexahedra(const Hexahedra& hexahedra, const Integers& expected,
                            const std::string& name)
{
  std::set<int> vertices;
  std::set<std::pair<int, int> > edges;
  std::map<std::array<int, 4>, int> facets;
  for(const auto& cell : hexahedra.cells) {
    CHECK_IN(name, std::set<int>(cell.begin(), cell.end()).size() == 8);
    vertices.insert(cell.begin(), cell.end());
    for(const auto& e : Hexahedra::edges)
      edges.insert(std::minmax({cell[e[0]], cell[e[1]]}));
    for(const auto& f : Hexahedra::facets) {
      std::array<int, 4> q{{cell[f[0]], cell[f[1]], cell[f[2]], cell[f[3]]}};
      std::sort(q.begin(), q.end());
      ++facets[q];
    }
  }
  long long border = 0;
  for(const auto& [q, number] : facets) {
    CHECK_IN(name, number == 1 || number == 2);
    border += number == 1;
  }
  CHECK_IN(name, expected.volume == int(hexahedra.cells.size()));
  CHECK_IN(name, expected.border_area == long(border));
  CHECK_IN(name, vertices.size() == hexahedra.points.size() && *vertices.begin() == 0);
  CHECK_IN(name, (long long)(vertices.size()) - (long long)(edges.size()) +
                     (long long)(facets.size()) - (long long)(hexahedra.cells.size()) ==
                   expected.euler_characteristic);
}

} // namespace hexahedra_reference

#endif // HEXAHEDRAL_MESHING_TEST_HEXAHEDRA_REFERENCE_H
