// Tetrahedral meshes with maps whose exact form is known: cubes, glued in any way, of 24 tetrahedra
// each, which all symmetries of the cube keep. Charts are turned and moved at will, by blocks,
// cubes, or tetrahedra.

#ifndef SEAMLESS_SNAPPING_TEST_VOLUME_GENERATOR_H
#define SEAMLESS_SNAPPING_TEST_VOLUME_GENERATOR_H

#include "volume_reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace volume_generator {

using volume_reference::Matrix;
using volume_reference::Point;
using volume_reference::Tet_map;
using Key = std::vector<int>;             // names a vertex
using Lattice_point = std::array<int, 3>; // corners of cubes are even in all coordinates

// A cube in the coordinates of its block.
struct Cube
{
  int block;
  Lattice_point low;
  int half_turned = 0; // in a chart that is turned by 180 degrees about the third axis
};

// Points of blocks with the same name are one vertex.
struct Cube_complex
{
  std::string name;
  std::vector<Cube> cubes;
  std::function<Key(int, Lattice_point)> vertex_name;
};

enum class Charts { BLOCKS, CUBES, TETRAHEDRA };

inline Lattice_point turned(const Matrix& m, const Lattice_point& p)
{
  Lattice_point result{};
  for(int r = 0; r < 3; ++r)
    for(int c = 0; c < 3; ++c)
      result[r] += m[r][c] * p[c];
  return result;
}

// A chart: a rotation, and an offset that is no round number.
struct Chart
{
  Matrix rotation{{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};
  Point offset{{0, 0, 0}};

  static Chart random(std::mt19937& generator)
  {
    static const std::vector<Matrix> all = volume_reference::rotations();
    std::uniform_real_distribution<double> offset(-2, 2);
    Chart result;
    result.rotation = all[generator() % all.size()];
    for(double& x : result.offset)
      x = offset(generator);
    return result;
  }

  Point operator()(const Point& p) const
  {
    Point result = offset;
    for(int r = 0; r < 3; ++r)
      for(int c = 0; c < 3; ++c)
        if(rotation[r][c] != 0)
          result[r] += rotation[r][c] * p[c];
    return result;
  }
};

// The cubes as tetrahedra: from each cube's center over half an edge's facet to its face's center.
class Tetrahedra_builder
{
public:
  Tetrahedra_builder(const Cube_complex& complex, const Charts charts, const unsigned int seed)
    : m_complex(complex), m_charts(charts), m_generator(seed)
  { }

  Tet_map build()
  {
    for(const Cube& cube : m_complex.cubes)
      add(cube);
    return m_map;
  }

private:
  void add(const Cube& cube)
  {
    static const Matrix half_turn{{{{-1, 0, 0}}, {{0, -1, 0}}, {{0, 0, 1}}}};
    if(m_charts == Charts::CUBES)
      m_chart = Chart::random(m_generator);
    else if(m_charts == Charts::BLOCKS && m_chart_of_block.count(cube.block) == 0)
      m_chart_of_block[cube.block] = Chart::random(m_generator);
    if(m_charts == Charts::BLOCKS)
      m_chart = m_chart_of_block[cube.block];
    std::uniform_real_distribution<double> shift(-0.3, 0.3);
    m_center_shift = {{shift(m_generator), shift(m_generator), shift(m_generator)}};
    for(int axis = 0; axis < 3; ++axis)
      for(int side = 0; side < 2; ++side)
        for(int edge = 0; edge < 4; ++edge) {
          Lattice_point center{{1, 1, 1}}, face = center, a, b;
          face[axis] = 2 * side;
          a = b = face;
          const int c1 = (axis + 1) % 3, c2 = (axis + 2) % 3;
          // counterclockwise as seen from outside
          constexpr int around[5][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}};
          a[c1] = around[edge][0]; a[c2] = around[edge][1];
          b[c1] = around[edge + 1][0]; b[c2] = around[edge + 1][1];
          if(side == 0)
            std::swap(a, b);
          if(m_charts == Charts::TETRAHEDRA)
            m_chart = Chart::random(m_generator);
          add_cell(cube, {{center, face, a, b}}, cube.half_turned != 0 ? &half_turn : nullptr);
        }
  }

  void add_cell(const Cube& cube, const std::array<Lattice_point, 4>& points, const Matrix* turn)
  {
    std::array<int, 4> cell;
    for(int i = 0; i < 4; ++i) {
      Lattice_point p = points[i];
      for(int c = 0; c < 3; ++c)
        p[c] += cube.low[c];
      cell[i] = vertex(m_complex.vertex_name(cube.block, p));
      if(turn != nullptr)
        p = turned(*turn, p);
      Point u;
      for(int c = 0; c < 3; ++c)
        u[c] = (p[c] + (i == 0 ? m_center_shift[c] : 0)) * (3.14159265358979323846 / 10);
      m_map.corners.push_back(m_chart(u));
    }
    m_map.cells.push_back(cell);
  }

  int vertex(const Key& key)
  {
    return m_vertices.emplace(key, int(m_vertices.size())).first->second;
  }

  const Cube_complex& m_complex;
  Charts m_charts;
  std::mt19937 m_generator;
  Chart m_chart;
  Point m_center_shift; // of the cube at hand
  std::map<int, Chart> m_chart_of_block;
  std::map<Key, int> m_vertices;
  Tet_map m_map;
};

// A motion of the lattice.
struct Motion
{
  Matrix rotation;
  Lattice_point shift;

  Lattice_point operator()(const Lattice_point& p, const int period) const
  {
    Lattice_point result = turned(rotation, p);
    for(int c = 0; c < 3; ++c)
      result[c] = ((result[c] + shift[c]) % period + period) % period;
    return result;
  }
};

// Space modulo motions and the translations by `cubes` cubes: all points that motions relate are
// one. Of each orbit of cubes, one is there.
inline Cube_complex quotient(const std::string& name, const int cubes,
                             const std::vector<Motion>& generators)
{
  const int period = 2 * cubes;
  const auto orbit_name = [=](const Lattice_point& p) {
    std::vector<Lattice_point> orbit;
    Lattice_point start = p;
    for(int& x : start)
      x = (x % period + period) % period;
    orbit.push_back(start);
    for(std::size_t i = 0; i < orbit.size(); ++i)
      for(const Motion& motion : generators) {
        const Lattice_point q = motion(orbit[i], period);
        if(std::find(orbit.begin(), orbit.end(), q) == orbit.end())
          orbit.push_back(q);
      }
    const Lattice_point least = *std::min_element(orbit.begin(), orbit.end());
    return Key(least.begin(), least.end());
  };
  Cube_complex result{name, {}, [=](int, const Lattice_point p) { return orbit_name(p); }};
  for(int x = 0; x < period; x += 2)
    for(int y = 0; y < period; y += 2)
      for(int z = 0; z < period; z += 2)
        if(orbit_name({{x + 1, y + 1, z + 1}}) == Key({x + 1, y + 1, z + 1}))
          result.cubes.push_back({0, {{x, y, z}}});
  return result;
}

inline void add_box(Cube_complex& complex, const int block, const int nx, const int ny,
                    const int nz)
{
  for(int x = 0; x < nx; ++x)
    for(int y = 0; y < ny; ++y)
      for(int z = 0; z < nz; ++z)
        complex.cubes.push_back({block, {{2 * x, 2 * y, 2 * z}}});
}

// Quadrants around an axis: an edge of valence `number`.
inline Cube_complex quadrants(const int number, const int size)
{
  Cube_complex result{std::to_string(number) + " quadrants", {},
                      [=](const int block, const Lattice_point p) -> Key {
    if(p[0] == 0 && p[1] == 0)
      return {-1, 0, 0, p[2]};
    if(p[0] == 0)
      return {(block + 1) % number, p[1], 0, p[2]};
    return {block, p[0], p[1], p[2]};
  }};
  for(int block = 0; block < number; ++block)
    add_box(result, block, size, size, size);
  return result;
}

// A tetrahedron of four blocks: a singular node at its center, with four singular edges. Weights
// name points: that of the block's vertex is the largest.
inline Cube_complex tetrahedron_of_blocks(const int size)
{
  Cube_complex result{"tetrahedron", {}, [=](const int block, const Lattice_point p) {
    Key weights(4, 2 * size);
    // orders of the other vertices that keep the orientation
    constexpr int others[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    for(int c = 0; c < 3; ++c)
      weights[std::size_t(others[block][c])] = p[c];
    return weights;
  }};
  for(int block = 0; block < 4; ++block)
    add_box(result, block, size, size, size);
  return result;
}

// A ring of a bar that is glued with a quarter twist: its four sides are one.
inline Cube_complex twisted_bar(const int width, const int length)
{
  Cube_complex result{"twisted bar", {}, [=](int, const Lattice_point p) -> Key {
    if(p[2] == 2 * length)
      return {2 * width - p[1], p[0], 0};
    return {p[0], p[1], p[2]};
  }};
  add_box(result, 0, width, width, length);
  return result;
}

// Half of a square ring, closed by a half turn. The charts change across a surface that itself
// turns by half around the ring's core: it has one side only.
inline Cube_complex one_sided_cut(const int inner, const int outer, const int height)
{
  Cube_complex result{"one-sided cut", {}, [](int, const Lattice_point p) -> Key {
    const bool is_other = p[1] < 0 || (p[1] == 0 && p[0] < 0);
    return {is_other ? -p[0] : p[0], is_other ? -p[1] : p[1], p[2]};
  }};
  for(int x = -2 * outer; x < 2 * outer; x += 2)
    for(int y = 0; y < 2 * outer; y += 2)
      for(int z = 0; z < 2 * height; z += 2) {
        const int r = (std::max)(std::abs(x + 1), y + 1);
        if(r < 2 * inner)
          continue;
        const double angle = std::atan2(y + 1, x + 1);
        const double d = r - (inner + outer), e = z + 1 - height;
        const bool is_above = e * std::cos(angle) - d * std::sin(angle) > 0;
        result.cubes.push_back({0, {{x, y, z}}, is_above ? 1 : 0});
      }
  return result;
}

// Cubes of one lattice, each a block.
inline Cube_complex lattice_cubes(const std::string& name, const std::vector<Lattice_point>& low)
{
  Cube_complex result{name, {}, [=](const int, const Lattice_point p) -> Key {
    return {p[0], p[1], p[2]};
  }};
  for(std::size_t i = 0; i < low.size(); ++i)
    result.cubes.push_back({int(i), low[i]});
  return result;
}

inline std::vector<Cube_complex> all_complexes()
{
  const Matrix half{{{{-1, 0, 0}}, {{0, -1, 0}}, {{0, 0, 1}}}};
  const Matrix quarter{{{{0, -1, 0}}, {{1, 0, 0}}, {{0, 0, 1}}}};
  const Matrix about_x{{{{1, 0, 0}}, {{0, -1, 0}}, {{0, 0, -1}}}};
  const Matrix about_y{{{{-1, 0, 0}}, {{0, 1, 0}}, {{0, 0, -1}}}};
  std::vector<Cube_complex> result;
  result.push_back(quotient("torus", 3, {}));
  result.push_back(quotient("half-turn manifold", 6, {{half, {{0, 0, 6}}}}));
  result.push_back(quotient("quarter-turn manifold", 8, {{quarter, {{0, 0, 4}}}}));
  result.push_back(quotient("Hantzsche-Wendt manifold", 4,
                            {{about_x, {{4, 4, 0}}}, {about_y, {{0, 4, 4}}}}));
  result.push_back(quotient("torus with axes of half turns", 6, {{half, {{0, 0, 0}}}}));
  for(const int k : {2, 3, 5, 7})
    result.push_back(quadrants(k, 2));
  result.push_back(tetrahedron_of_blocks(2));
  result.push_back(twisted_bar(2, 4));
  result.push_back(one_sided_cut(1, 3, 2));
  result.push_back(lattice_cubes("cubes with a common edge", {{{0, 0, 0}}, {{2, 2, 0}}}));
  result.push_back(lattice_cubes("cubes with a common vertex", {{{0, 0, 0}}, {{2, 2, 2}}}));
  result.push_back(lattice_cubes("ring of cubes around an edge",
                                 {{{0, 0, 0}}, {{2, 0, 0}}, {{2, 2, 0}}, {{0, 2, 0}}}));
  // four sheets meet along several vertices, between the two first bars and the two others
  result.push_back(lattice_cubes("bars around an edge", {}));
  for(int i = 0; i < 16; ++i)
    result.back().cubes.push_back({i % 4, {{i % 4 == 1 || i % 4 == 2 ? 2 : 0,
                                            i % 2 == 1 ? 2 : 0, i / 4 * 2}}});
  return result;
}

// Noise relative to the extent: the same for the corners of a sector, or for each corner its own.
inline void add_noise(Tet_map& map, const double size, const bool per_corner,
                      const unsigned int seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> noise(-size * volume_reference::extent(map),
                                               size * volume_reference::extent(map));
  std::map<std::pair<int, Point>, Point> noise_of_sector;
  for(std::size_t i = 0; i < map.corners.size(); ++i) {
    Point by{{noise(generator), noise(generator), noise(generator)}};
    if(!per_corner)
      by = noise_of_sector.emplace(std::make_pair(map.cells[i / 4][i % 4], map.corners[i]), by)
             .first->second;
    for(int c = 0; c < 3; ++c)
      map.corners[i][c] += by[c];
  }
}

} // namespace volume_generator

#endif // SEAMLESS_SNAPPING_TEST_VOLUME_GENERATOR_H
