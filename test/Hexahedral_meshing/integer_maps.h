// Integer-grid maps whose hexahedra are known: the cubes of a complex, each of 24 tetrahedra, as
// `volume_generator` glues them, with integers for translations and levels. Vertices have random
// points, so that each point of the mesh is recognized by where it is in space.

#ifndef HEXAHEDRAL_MESHING_TEST_INTEGER_MAPS_H
#define HEXAHEDRAL_MESHING_TEST_INTEGER_MAPS_H

#include "volume_generator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <vector>

namespace integer_maps {

using volume_generator::Chart;
using volume_generator::Charts;
using volume_generator::Cube;
using volume_generator::Cube_complex;
using volume_generator::Key;
using volume_generator::Lattice_point;
using volume_reference::Point;
using volume_reference::Tet_map;

struct Integer_map
{
  Tet_map map;
  std::vector<Point> points;   // per vertex
  std::vector<Point> in_block; // per corner: in the block's coordinates, one unit a hexahedron
  std::vector<int> block_of_cell;
};

// \param size the number of units along a cube
class Builder
{
public:
  Builder(const Cube_complex& complex, const Charts charts, const double size,
          const unsigned int seed)
    : m_complex(complex), m_charts(charts), m_size(size), m_generator(seed)
  { }

  Integer_map build()
  {
    for(const Cube& cube : m_complex.cubes)
      add(cube);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    m_result.points.resize(m_vertices.size());
    for(Point& p : m_result.points)
      for(double& x : p)
        x = coordinate(m_generator);
    return m_result;
  }

private:
  Chart random_chart()
  {
    Chart result = Chart::random(m_generator);
    for(double& x : result.offset)
      x = std::round(10 * x);
    return result;
  }

  void add(const Cube& cube)
  {
    if(m_charts == Charts::CUBES)
      m_chart = random_chart();
    else if(m_charts == Charts::BLOCKS && m_chart_of_block.count(cube.block) == 0)
      m_chart_of_block[cube.block] = random_chart();
    if(m_charts == Charts::BLOCKS)
      m_chart = m_chart_of_block[cube.block];
    std::uniform_int_distribution<int> shift(-300, 300);
    const Point center_shift{{shift(m_generator) / 1024., shift(m_generator) / 1024.,
                              shift(m_generator) / 1024.}};
    for(int axis = 0; axis < 3; ++axis)
      for(int side = 0; side < 2; ++side)
        for(int edge = 0; edge < 4; ++edge) {
          constexpr int around[5][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}};
          Lattice_point center{{1, 1, 1}}, face = center, a, b;
          face[axis] = 2 * side;
          a = b = face;
          a[(axis + 1) % 3] = around[edge + 1 - side][0];
          a[(axis + 2) % 3] = around[edge + 1 - side][1];
          b[(axis + 1) % 3] = around[edge + side][0];
          b[(axis + 2) % 3] = around[edge + side][1];
          if(m_charts == Charts::TETRAHEDRA)
            m_chart = random_chart();
          add_cell(cube, {{center, face, a, b}}, center_shift);
        }
  }

  void add_cell(const Cube& cube, const std::array<Lattice_point, 4>& points,
                const Point& center_shift)
  {
    std::array<int, 4> cell;
    for(int i = 0; i < 4; ++i) {
      Lattice_point p = points[i];
      Point u;
      for(int c = 0; c < 3; ++c) {
        p[c] += cube.low[c];
        u[c] = (p[c] + (i == 0 ? center_shift[c] : 0)) * (m_size / 2);
      }
      cell[i] = m_vertices.emplace(m_complex.vertex_name(cube.block, p), int(m_vertices.size()))
                  .first->second;
      m_result.map.corners.push_back(m_chart(u));
      m_result.in_block.push_back(u);
    }
    m_result.map.cells.push_back(cell);
    m_result.block_of_cell.push_back(cube.block);
  }

  const Cube_complex& m_complex;
  Charts m_charts;
  double m_size;
  std::mt19937 m_generator;
  Chart m_chart;
  std::map<int, Chart> m_chart_of_block;
  std::map<Key, int> m_vertices;
  Integer_map m_result;
};

// Where the points of blocks are in space: by rational numbers, of all cells of the block.
class Point_locator
{
  using Rational = volume_reference::Rational;

public:
  explicit Point_locator(const Integer_map& map)
    : m_map(map)
  {
    for(std::size_t c = 0; c < map.map.cells.size(); ++c)
      m_cells[map.block_of_cell[c]].push_back(c);
  }

  // Returns false if no cell of the block contains the point.
  bool locate(const int block, const Point& p, Point& in_space) const
  {
    for(const std::size_t c : m_cells.at(block)) {
      bool is_near = true;
      for(int k = 0; k < 3; ++k) {
        double least = p[k] + 1, largest = p[k] - 1;
        for(std::size_t i = 4 * c; i < 4 * c + 4; ++i) {
          least = (std::min)(least, m_map.in_block[i][k]);
          largest = (std::max)(largest, m_map.in_block[i][k]);
        }
        is_near = is_near && least <= p[k] && p[k] <= largest;
      }
      std::array<Rational, 4> weights;
      if(!is_near || !find_weights(c, p, weights))
        continue;
      for(int k = 0; k < 3; ++k) {
        Rational x(0);
        for(std::size_t i = 0; i < 4; ++i)
          x += weights[i] * Rational(m_map.points[std::size_t(m_map.map.cells[c][i])][k]);
        in_space[k] = CGAL::to_double(x);
      }
      return true;
    }
    return false;
  }

private:
  static Rational six_volumes(const std::array<Point, 4>& u)
  {
    std::array<std::array<Rational, 3>, 3> e;
    for(int i = 0; i < 3; ++i)
      for(int k = 0; k < 3; ++k)
        e[i][k] = Rational(u[i + 1][k]) - Rational(u[0][k]);
    return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
           e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
  }

  bool find_weights(const std::size_t c, const Point& p, std::array<Rational, 4>& weights) const
  {
    std::array<Point, 4> u;
    for(std::size_t i = 0; i < 4; ++i)
      u[i] = m_map.in_block[4 * c + i];
    const Rational all = six_volumes(u);
    for(std::size_t i = 0; i < 4; ++i) {
      std::array<Point, 4> part = u;
      part[i] = p;
      weights[i] = six_volumes(part) / all;
      if(weights[i] < 0)
        return false;
    }
    return true;
  }

  const Integer_map& m_map;
  std::map<int, std::vector<std::size_t> > m_cells; // of blocks
};

} // namespace integer_maps

#endif // HEXAHEDRAL_MESHING_TEST_INTEGER_MAPS_H
