// Integer-grid maps of volumes and repairs of cells, against checks in rational numbers that share
// no code with the package.

#ifndef SEAMLESS_SNAPPING_TEST_VOLUME_GRID_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_VOLUME_GRID_CHECKS_H

#include "test_data.h"
#include "volume_checks.h"
#include "volume_input_checks.h"

#include <CGAL/Seamless_snapping/internal/volume/Volume_check.h>
#include <CGAL/Seamless_snapping/is_volume_seamless.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace volume_grid_reference {

using namespace volume_reference;
using Edge = std::array<int, 2>; // vertices, ascending

inline bool is_integer(const Rational& x)
{
  return x == Rational(std::round(CGAL::to_double(x))); // which are small
}

struct Counts
{
  std::size_t cuts = 0, planes = 0, lines = 0; // that are off the integers
  std::size_t singular_edges = 0;              // whose rotations don't cancel

  bool are_integers() const { return cuts + planes + lines == 0; }
};

// The rotation from one cell to the next across a facet.
inline Matrix rotation_across(const Tet_map& map, const Facet& facet, const std::size_t from,
                              const std::size_t to)
{
  static const std::vector<Matrix> all = rotations();
  const auto p = edges(facet_points(map, from, facet)), q = edges(facet_points(map, to, facet));
  const auto found = std::find_if(all.begin(), all.end(), [&](const Matrix& m) {
    return is_rotated(p, q, m);
  });
  CHECK(found != all.end());
  return found != all.end() ? *found : all.front();
}

// The integers of the transition of a facet.
inline bool is_integer_cut(const Tet_map& map, const Facet& facet,
                           const std::vector<std::size_t>& cells)
{
  const Matrix m = rotation_across(map, facet, cells[0], cells[1]);
  const Point p = facet_points(map, cells[0], facet)[0], q = facet_points(map, cells[1], facet)[0];
  for(int r = 0; r < 3; ++r) {
    Rational t(q[r]);
    for(int c = 0; c < 3; ++c)
      t -= m[r][c] * Rational(p[c]);
    if(!is_integer(t))
      return false;
  }
  return true;
}

inline bool is_on_plane(const std::array<Point, 3>& p)
{
  for(int c = 0; c < 3; ++c)
    if(p[0][c] == p[1][c] && p[0][c] == p[2][c] && is_integer(p[0][c]))
      return true;
  return false;
}

// Around an interior edge, from its first cell: the product of rotations.
inline Matrix product_around(const Tet_map& map, const std::vector<Facet>& facets,
                             const std::map<Facet, std::vector<std::size_t> >& cells_of_facet)
{
  Matrix product{{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};
  const std::size_t first = cells_of_facet.at(facets[0])[0];
  std::size_t cell = first;
  Facet facet = facets[0];
  do {
    const auto& sides = cells_of_facet.at(facet);
    const std::size_t next = sides[0] == cell ? sides[1] : sides[0];
    const Matrix m = rotation_across(map, facet, cell, next);
    Matrix result{};
    for(int r = 0; r < 3; ++r)
      for(int c = 0; c < 3; ++c)
        for(int k = 0; k < 3; ++k)
          result[r][c] += m[r][k] * product[k][c];
    product = result;
    for(const Facet& other : facets) // the other one of the next cell
      if(other != facet && (cells_of_facet.at(other)[0] == next ||
                            cells_of_facet.at(other)[1] == next)) {
        facet = other;
        break;
      }
    cell = next;
  } while(cell != first);
  return product;
}

inline Counts count(const Tet_map& map)
{
  Counts result;
  const auto all = cells_of_facets(map);
  std::map<Edge, std::vector<Facet> > facets_of_edge;
  std::map<Edge, bool> is_border;
  for(const auto& [facet, cells] : all) {
    if(cells.size() == 1)
      result.planes += std::size_t(!is_on_plane(facet_points(map, cells[0], facet)));
    else
      result.cuts += std::size_t(!is_integer_cut(map, facet, cells));
    for(const Edge& edge : {Edge{{facet[0], facet[1]}}, Edge{{facet[0], facet[2]}},
                            Edge{{facet[1], facet[2]}}}) {
      facets_of_edge[edge].push_back(facet);
      is_border[edge] = is_border[edge] || cells.size() == 1;
    }
  }
  for(const auto& [edge, facets] : facets_of_edge) {
    if(is_border[edge])
      continue;
    const Matrix m = product_around(map, facets, all);
    const std::size_t cell = all.at(facets[0])[0];
    bool is_singular = false, is_on_line = true;
    for(int c = 0; c < 3; ++c)
      if(m[c][c] != 1) {
        is_singular = true;
        for(int k = 0; k < 4; ++k)
          if(std::find(edge.begin(), edge.end(), map.cells[cell][k]) != edge.end())
            is_on_line = is_on_line && is_integer(map.corners[4 * cell + k][c]);
      }
    result.singular_edges += std::size_t(is_singular);
    result.lines += std::size_t(!is_on_line);
  }
  return result;
}

// The number of hexahedra, if the boundary is on the grid.
inline Rational volume(const Tet_map& map)
{
  Rational result(0);
  for(std::size_t cell = 0; cell < map.cells.size(); ++cell) {
    std::array<std::array<Rational, 3>, 3> e;
    for(int i = 0; i < 3; ++i)
      for(int c = 0; c < 3; ++c)
        e[i][c] = Rational(map.corners[4 * cell + i + 1][c]) - Rational(map.corners[4 * cell][c]);
    result += e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
              e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
              e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
  }
  return result / 6;
}

} // namespace volume_grid_reference

// Maps that are made of `size` units to a cube, of noise and charts anywhere.
constexpr double cubes_to_units = 5 / 3.14159265358979323846;

inline bool is_grid(Tet_map map)
{
  return Snapping::is_volume_integer_grid_map(map.cells, Double_map{&map});
}

inline Snapping_report round_and_check(Tet_map& map, const double scale, const std::string& name)
{
  const Tet_map before = map;
  const auto np = parameters::integer_grid(true).grid_scale(scale).rounding_tolerance(1.5);
  const Snapping_report report = snap(map, np);
  CHECK_IN(name + ": " + report.message, bool(report));
  const auto counts = volume_grid_reference::count(map);
  CHECK_IN(name, volume_reference::check(map).is_exact());
  CHECK_IN(name, counts.are_integers());
  CHECK_IN(name, is_grid(map) && !is_grid(before));
  CHECK_IN(name, volume_grid_reference::is_integer(volume_grid_reference::volume(map)));
  CHECK_IN(name, report.lost_faces.empty() && volume_reference::lost_cells(before, map) == 0);
  // each sector counts, and has no more corners than there are
  CHECK_IN(name, report.mean_change <= report.rms_change &&
                   report.rms_change <= report.largest_change * (1 + 1e-12));
  CHECK_IN(name, report.rms_change * std::sqrt(3.) * double(map.corners.size()) >=
                   report.largest_change);
  const auto measure = Snapping::measure_volume_integer_grid(map.cells, Double_map{&map});
  CHECK_IN(name, measure.number_of_singular_edges >= counts.singular_edges);
  CHECK_IN(name, volume_grid_reference::Rational(measure.volume) ==
                   volume_grid_reference::volume(map));
  for(const double shift : {0., 0.5}) {
    Tet_map other = map; // with halves
    for(Point& p : other.corners)
      for(double& x : p)
        x = shift + (shift > 0 ? x : x / 2);
    CHECK_IN(name, is_grid(other) == volume_grid_reference::count(other).are_integers());
  }
  Tet_map again = map;
  CHECK_IN(name, snap(again, parameters::integer_grid(true)).status ==
                   Outcome::ALREADY_EXACT);
  CHECK_IN(name, again.corners == map.corners);
  return report;
}

// Four cubes around an edge, which a slit ends at.
inline Cube_complex cubes_with_slit()
{
  Cube_complex result{"slit", {}, [](const int block, const volume_generator::Lattice_point p) {
    return volume_generator::Key{p[0], p[1], p[2], int(block == 3 && p[1] == 2 && p[0] < 2)};
  }};
  int block = 0;
  for(const volume_generator::Lattice_point& low :
      {volume_generator::Lattice_point{{0, 0, 0}}, volume_generator::Lattice_point{{2, 0, 0}},
       volume_generator::Lattice_point{{2, 2, 0}}, volume_generator::Lattice_point{{0, 2, 0}}})
    result.cubes.push_back({block++, low});
  return result;
}

inline void test_integer_grids()
{
  std::vector<Cube_complex> complexes = volume_generator::all_complexes();
  complexes.push_back(volume_generator::quadrants(8, 1)); // 720 degrees
  complexes.push_back(cubes_with_slit());
  unsigned int seed = 20;
  for(const Cube_complex& complex : complexes) {
    if(complex.cubes.size() > 40)
      continue; // takes long in rational numbers
    const Charts charts = ++seed % 2 == 0 ? Charts::BLOCKS : Charts::CUBES;
    Tet_map map = volume_generator::Tetrahedra_builder(complex, charts, seed).build();
    volume_generator::add_noise(map, 1e-8, true, seed);
    const std::string name = "grid of " + complex.name + ", seed " + std::to_string(seed);
    if(seed % 3 == 0) {
      round_and_check(map, 1.5 * cubes_to_units, name + ", refined");
      continue;
    }
    const Snapping_report report = round_and_check(map, cubes_to_units, name);
    if(volume_reference::check(map).border == 0)
      continue; // has no levels to lay charts by
    CHECK_IN(name, report.largest_rounding < 1e-6);
    CHECK_IN(name, volume_grid_reference::volume(map) == int(complex.cubes.size()));
  }
}

inline void test_refusals_of_grids()
{
  const Tet_map map = box_map(3);
  const auto grid = parameters::integer_grid(true);
  check_refusal(Outcome::NOT_INTEGER, map, "grid_scale", grid);
  // a closed manifold without nodes: its periods become 0, and no cell keeps a volume to speak of
  Tet_map torus = volume_generator::Tetrahedra_builder(volume_generator::quotient("torus", 3, {}),
                                                       Charts::BLOCKS, 1).build();
  const Snapping_report collapsed = snap(torus, grid.grid_scale(1e-3).rounding_tolerance(10.));
  CHECK_IN(collapsed.message, collapsed.status == Outcome::FLIPS_REMAIN ||
                              collapsed.status == Outcome::NOT_INTEGER);
  CHECK_IN(collapsed.message, collapsed.message.find("cell") != std::string::npos);
  check_refusal(Outcome::INVALID_ARGUMENT, map, "grid_scale", grid.grid_scale(-1.));
  check_refusal(Outcome::INVALID_ARGUMENT, map, "tolerance", grid.rounding_tolerance(-1.));
  check_refusal(Outcome::NOT_REPRESENTABLE, map, "2^46", grid.grid_scale(1e15));
  check_refusal(Outcome::NOT_REPRESENTABLE, map, "too large", grid.grid_scale(1e305));
  check_refusal(Outcome::NOT_REPRESENTABLE, map, "too small", parameters::grid_scale(1e-300));
  Tet_map bad = map;
  bad.corners[0][0] += 0.01;
  check_refusal(Outcome::NOT_SEAMLESS, bad, "facet", grid);
  // which rotations have an axis that an integer grid knows
  using Group = Snapping::internal::Cube_rotations;
  std::array<int, 4> number{};
  for(int g = 0; g < Group::order; ++g)
    ++number[std::size_t(Snapping::internal::axis_of(g) + 1)];
  CHECK((number == std::array<int, 4>{{15, 3, 3, 3}}));
  // numbers of 24 bits
  Tet_map floats = map;
  for(Point& p : floats.corners)
    for(double& x : p)
      x = double(float(x));
  const Snapping_report report = Snapping::snap_volume_to_seamless(
    floats.cells, Corner_map<float>{&floats},
    grid.grid_scale(4 * cubes_to_units).rounding_tolerance(1.));
  CHECK(bool(report) && volume_grid_reference::count(floats).are_integers());
  for(const Point& p : floats.corners)
    for(const double x : p)
      CHECK(x == double(float(x)));
}

inline std::vector<std::size_t> flips(const Tet_map& map)
{
  std::vector<std::size_t> result;
  for(std::size_t c = 0; c < map.cells.size(); ++c)
    if(volume_reference::orientation(map, c) != 1)
      result.push_back(c);
  return result;
}

// Moves all corners of vertices inside of a chart.
inline void tangle(Tet_map& map, const double size, const unsigned int seed)
{
  std::map<int, std::vector<std::size_t> > corners;
  std::map<int, bool> is_fixed;
  for(std::size_t i = 0; i < map.corners.size(); ++i)
    corners[map.cells[i / 4][i % 4]].push_back(i);
  for(const auto& [facet, cells] : volume_reference::cells_of_facets(map))
    for(const int v : facet)
      is_fixed[v] = is_fixed[v] || cells.size() == 1;
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> distance(-size, size);
  for(const auto& [v, list] : corners)
    if(!is_fixed[v] && std::all_of(list.begin(), list.end(), [&, first = list[0]](const auto i) {
         return map.corners[i] == map.corners[first];
       })) {
      const Point by{{distance(generator), distance(generator), distance(generator)}};
      for(const std::size_t i : list)
        for(std::size_t c = 0; c < 3; ++c)
          map.corners[i][c] += by[c];
    }
}

inline void test_repairs_of_flips()
{
  using Snapping::Flip_repair;
  std::size_t before = 0, left_near_by = 0, left = 0;
  unsigned int seed = 0;
  for(const Cube_complex& complex :
      {volume_generator::quotient("torus", 3, {}), volume_generator::quadrants(5, 2),
       volume_generator::tetrahedron_of_blocks(2), volume_generator::twisted_bar(2, 4),
       volume_generator::one_sided_cut(1, 3, 2)}) {
    Tet_map map = volume_generator::Tetrahedra_builder(complex, Charts::BLOCKS, ++seed).build();
    tangle(map, 0.6, seed);
    before += flips(map).size();
    volume_generator::add_noise(map, 1e-10, false, seed);
    std::size_t passes = 0;
    for(const auto& [repair, number] : // the first and third are stopped on the way
        {std::make_pair(Flip_repair::NEAR_BY, 1), std::make_pair(Flip_repair::NEAR_BY, 400),
         std::make_pair(Flip_repair::UNTANGLE, 0), std::make_pair(Flip_repair::UNTANGLE, 400)}) {
      Tet_map repaired = map;
      const std::size_t most = number > 0 ? std::size_t(number) : passes + 1;
      const Snapping_report report =
        snap(repaired, parameters::repair_flips(repair).number_of_untangling_iterations(most));
      const std::string name = "flips of " + complex.name + ", seed " + std::to_string(seed);
      CHECK_IN(name + ": " + report.message, bool(report));
      CHECK_IN(name, volume_reference::check(repaired).is_exact());
      CHECK_IN(name, volume_reference::lost_cells(map, repaired) == 0);
      CHECK_IN(name, report.lost_faces.empty() && report.remaining_flips == flips(repaired));
      CHECK_IN(name, (report.status == Outcome::FLIPS_REMAIN) ==
                       !flips(repaired).empty());
      CHECK_IN(name, report.run.number_of_untangling_iterations <= most);
      if(repair == Flip_repair::NEAR_BY)
        passes = report.run.number_of_untangling_iterations;
      if(number == 400)
        (repair == Flip_repair::NEAR_BY ? left_near_by : left) += flips(repaired).size();
    }
  }
  std::cout << before << " tangled cells, " << left_near_by << " of them left near by, " << left
            << " in all" << std::endl;
  CHECK(before > 500 && 10 * left_near_by < before && 100 * left < before);

  // an exact map with a flip: no search, and one that ends at once
  Tet_map map = box_map(1);
  CHECK(bool(snap(map)));
  tangle(map, 0.4, 5);
  Tet_map plain = map, stopped = map;
  CHECK(snap(plain).status == Outcome::ALREADY_EXACT && plain.corners == map.corners);
  const Snapping_report report = snap(stopped, parameters::repair_flips(true)
                                                 .number_of_untangling_iterations(0));
  CHECK_EQUAL(report.status, Outcome::FLIPS_REMAIN);
  CHECK(stopped.corners == map.corners && report.remaining_flips == flips(map));
  CHECK(report.message.find("number_of_untangling_iterations") != std::string::npos);
}

// An integer grid with flips of the input is none to make hexahedra of, and what is refused because
// of them does not speak of cells that lose their orientation.
inline void test_grids_with_flips()
{
  std::size_t number_of_refusals = 0;
  const bool all = test_data::are_tests_long(); // of all seeds, the sixth alone has a refusal
  for(unsigned int seed = 1; seed <= (all ? 40u : 10u); ++seed) {
    Tet_map map = volume_generator::Tetrahedra_builder(volume_generator::quadrants(3, 1),
                                                       Charts::BLOCKS, seed).build();
    const std::string name = "grid with flips, seed " + std::to_string(seed);
    CHECK_IN(name, bool(snap(map, parameters::integer_grid(true).grid_scale(2 * cubes_to_units)
                                            .rounding_tolerance(10.))));
    tangle(map, 1.5, seed);
    std::mt19937 generator(seed);
    const int v = map.cells[generator() % map.cells.size()][3]; // its cells become flat
    std::size_t first = map.corners.size();
    for(std::size_t i = 0; i < map.corners.size() && seed % 2 == 0; ++i)
      if(map.cells[i / 4][i % 4] == v) {
        first = (std::min)(first, i);
        map.corners[i] = map.corners[4 * (i / 4) + (i % 4 + 1) % 4];
      }
    const Snapping_report report = snap(map, parameters::integer_grid(true)
                                               .number_of_untangling_iterations(0)
                                               .tolerance(1.).rounding_tolerance(10.));
    if(report) {
      CHECK_IN(name, (report.status == Outcome::FLIPS_REMAIN) == !flips(map).empty());
      CHECK_IN(name, report.lost_faces.size() + report.remaining_flips.size() ==
                       flips(map).size());
    } else if(report.message.find("nearest integers") != std::string::npos) {
      ++number_of_refusals;
      CHECK_IN(name + ": " + report.message, report.message.find(" 0 cells") == std::string::npos);
      CHECK_IN(name + ": " + report.message,
               report.message.find("before, such as cell ") != std::string::npos);
    }
  }
  std::cout << number_of_refusals << " grids with flips refused" << std::endl;
  CHECK(number_of_refusals > 0);
}

// A cell in the boundary, that covers two facets of one plane.
inline void test_cell_without_volume()
{
  Tet_map map = box_map(4);
  CHECK(bool(snap(map)));
  std::map<std::array<int, 2>, std::pair<volume_reference::Facet, std::size_t> > seen;
  for(const auto& [facet, cells] : volume_reference::cells_of_facets(map)) {
    if(cells.size() != 1)
      continue;
    const auto [first, is_new] =
      seen.emplace(std::array<int, 2>{{facet[0], facet[1]}}, std::make_pair(facet, cells[0]));
    if(is_new || first->second.second / 24 != cells[0] / 24)
      continue;
    const std::size_t other = first->second.second;
    const auto p = volume_reference::facet_points(map, cells[0], facet),
               q = volume_reference::facet_points(map, other, first->second.first);
    map.cells.push_back({{facet[0], facet[1], facet[2], first->second.first[2]}});
    for(const Point& u : {p[0], p[1], p[2], q[2]})
      map.corners.push_back(u);
    break;
  }
  CHECK_EQUAL(flips(map).size(), std::size_t(1));
  const Snapping_report report = snap(map, parameters::repair_flips(
                                             Snapping::Flip_repair::UNTANGLE));
  CHECK_EQUAL(report.status, Outcome::FLIPS_REMAIN);
  CHECK_EQUAL(report.run.number_of_faces_without_area, std::size_t(1));
  CHECK(report.message.find("no volume") != std::string::npos);
}

// A box of three cubes in a row, the first of which becomes 0.3 wide, before a plane of features:
// its two planes would be rounded to one integer each on its own.
inline void test_slab_thinner_than_a_unit()
{
  Tet_map map = box_map(4);
  Point least = map.corners[0], largest = map.corners[0];
  for(const Point& p : map.corners)
    for(std::size_t k = 0; k < 3; ++k) {
      least[k] = (std::min)(least[k], p[k]);
      largest[k] = (std::max)(largest[k], p[k]);
    }
  std::size_t along = 0;
  for(std::size_t k = 1; k < 3; ++k)
    if(largest[k] - least[k] > largest[along] - least[along])
      along = k;
  for(Point& p : map.corners) {
    for(std::size_t k = 0; k < 3; ++k)
      p[k] = std::round(12 * cubes_to_units * (p[k] - least[k])) / 12;
    p[along] = p[along] < 1 ? 0.3 * p[along] : p[along] - 0.7;
  }
  std::vector<std::array<std::int32_t, 3> > features;
  for(const auto& [facet, cells] : volume_reference::cells_of_facets(map)) {
    const auto points = volume_reference::facet_points(map, cells[0], facet);
    if(std::all_of(points.begin(), points.end(), [&](const Point& p)
                   { return p[along] == 1 - 0.7; }))
      features.push_back({{facet[0], facet[1], facet[2]}});
  }
  const Tet_map before = map;
  const Snapping_report report = snap(map, parameters::integer_grid(true).rounding_tolerance(1.)
                                               .feature_facets(features));
  CHECK_IN(report.message, report.status == Outcome::SNAPPED && report.message.empty());
  CHECK_EQUAL(volume_reference::lost_cells(before, map), std::size_t(0));
  CHECK(volume_grid_reference::count(map).are_integers());
  std::map<double, double> level; // of planes, as they were
  for(std::size_t i = 0; i < map.corners.size(); ++i)
    level[before.corners[i][along]] = map.corners[i][along];
  CHECK_EQUAL(level.at(1 - 0.7) - level.at(0), 1.);
}

// Blocks of two cubes along each edge around singular edges and nodes, each block 0.4 units wide:
// levels, curves, and nodes stay apart.
inline void test_blocks_smaller_than_a_unit()
{
  unsigned int seed = 0;
  for(const auto& [complex, blocks] :
      {std::make_pair(volume_generator::quadrants(3, 2), 3),
       std::make_pair(volume_generator::quadrants(5, 2), 5),
       std::make_pair(volume_generator::tetrahedron_of_blocks(2), 4)}) {
    ++seed;
    const Charts charts = seed % 2 == 0 ? Charts::BLOCKS : Charts::CUBES;
    Tet_map map = volume_generator::Tetrahedra_builder(complex, charts, seed).build();
    const std::string name = "small blocks of " + complex.name;
    const Tet_map before = map;
    const Snapping_report report = snap(map, parameters::integer_grid(true)
                                               .grid_scale(0.2 * cubes_to_units)
                                               .rounding_tolerance(10.));
    CHECK_IN(name + ": " + report.message, report.status == Outcome::SNAPPED);
    CHECK_EQUAL(volume_reference::lost_cells(before, map), std::size_t(0));
    CHECK_IN(name, volume_grid_reference::count(map).are_integers());
    CHECK_IN(name, volume_grid_reference::volume(map) == blocks);
  }
}

#endif // SEAMLESS_SNAPPING_TEST_VOLUME_GRID_CHECKS_H
