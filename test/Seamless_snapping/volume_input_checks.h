// What snapping of volumes refuses, and what it takes in other forms.

#ifndef SEAMLESS_SNAPPING_TEST_VOLUME_INPUT_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_VOLUME_INPUT_CHECKS_H

#include "volume_checks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// A refusal names the place, and nothing is written.
template <typename NamedParameters>
void check_refusal(const Outcome status, Tet_map map, const std::string& place,
                   const NamedParameters& np)
{
  const Tet_map before = map;
  std::size_t number_of_writings = 0;
  const Snapping_report report = Snapping::snap_volume_to_seamless(
    map.cells, Double_map{&map, &number_of_writings}, np);
  CHECK_EQUAL(report.status, status);
  CHECK_IN(report.message + " should name " + place,
           report.message.find(place) != std::string::npos);
  CHECK_EQUAL(number_of_writings, std::size_t(0));
}

inline void test_refusals()
{
  const Tet_map map = box_map(12);
  const auto none = parameters::default_values();
  const auto vertex = [&](const std::size_t c, const std::size_t k) {
    return std::to_string(map.cells[c][k]);
  };
  Tet_map bad = map;
  bad.corners[41][1] = std::numeric_limits<double>::quiet_NaN();
  check_refusal(Outcome::NOT_FINITE, bad, "cell 10", none);
  CHECK(!is_seamless(bad));
  bad = map;
  bad.corners[41][1] = 1e301;
  check_refusal(Outcome::NOT_FINITE, bad, "vertex " + vertex(10, 1), none);
  bad = map;
  bad.cells.push_back({{map.cells[0][0], map.cells[0][1], map.cells[0][2], 4000}});
  bad.corners.resize(4 * bad.cells.size(), Point{{0, 0, 0}});
  check_refusal(Outcome::NOT_MANIFOLD, bad, "more than two cells", none);
  bad = Tet_map{{{{0, 1, 2, 3}}, {{2, 1, 3, 0}}}, std::vector<Point>(8, Point{{0, 0, 0}})};
  check_refusal(Outcome::NOT_MANIFOLD, bad, "cells 0 and 1", none);
  bad = map;
  bad.cells[3][2] = bad.cells[3][0];
  check_refusal(Outcome::INVALID_ARGUMENT, bad, "cell 3", none);
  bad.cells[3][2] = -1;
  check_refusal(Outcome::INVALID_ARGUMENT, bad, "negative", none);
  check_refusal(Outcome::INVALID_ARGUMENT, Tet_map(), "no cell", none);
  check_refusal(Outcome::INVALID_ARGUMENT, map, "tolerance", parameters::tolerance(-1.));
  using Facets = std::vector<std::array<int, 3> >;
  check_refusal(Outcome::INVALID_ARGUMENT, map, "facet 0, 1, 4000",
                parameters::feature_facets(Facets{{{4000, 1, 0}}}));
  using Lists = std::vector<std::vector<int> >;
  check_refusal(Outcome::INVALID_ARGUMENT, map, "3 vertices in place of 2",
                parameters::feature_edges(Lists{{0, 1, 2}}));
  // one vertex moved by more than the tolerance: on the boundary, and at a facet inside
  bad = map;
  const int at = bad.cells[0][2];
  for(std::size_t i = 0; i < bad.corners.size(); ++i)
    if(bad.cells[i / 4][i % 4] == at)
      for(std::size_t c = 0; c < 3; ++c)
        bad.corners[i][c] += 0.01;
  check_refusal(Outcome::NOT_ALIGNED, bad, "align_boundary(false)", none);
  CHECK_EQUAL(snap(bad, parameters::align_boundary(false)).status,
              Outcome::ALREADY_EXACT);
  bad = map;
  bad.corners[0][0] += 0.01;
  check_refusal(Outcome::NOT_SEAMLESS, bad, vertex(0, 0), none);
}

// Neighbors that the caller knows give the same result, and wrong ones are refused.
inline void test_neighbors()
{
  Tet_map map = volume_generator::Tetrahedra_builder(volume_generator::quadrants(3, 2),
                                                     Charts::BLOCKS, 2).build();
  volume_generator::add_noise(map, 1e-9, true, 3);
  std::vector<std::array<int, 4> > neighbors(map.cells.size(), {{-1, -1, -1, -1}});
  for(const auto& [facet, cells] : volume_reference::cells_of_facets(map))
    for(std::size_t side = 0; side < 2 && cells.size() == 2; ++side)
      for(std::size_t k = 0; k < 4; ++k)
        if(std::find(facet.begin(), facet.end(), map.cells[cells[side]][k]) == facet.end())
          neighbors[cells[side]][k] = int(cells[1 - side]);
  Tet_map other = map;
  CHECK(bool(snap(map)));
  CHECK(bool(snap(other, parameters::cell_neighbors(neighbors))));
  CHECK(map.corners == other.corners);

  // a cell that its neighbors list the other way round, and all cells
  const auto turn = [&](const std::size_t c) {
    std::swap(other.cells[c][0], other.cells[c][1]);
    std::swap(other.corners[4 * c], other.corners[4 * c + 1]);
    std::swap(neighbors[c][0], neighbors[c][1]);
  };
  turn(5);
  check_refusal(Outcome::INVALID_ARGUMENT, other, "in the same order",
                parameters::cell_neighbors(neighbors));
  for(std::size_t c = 0; c < map.cells.size(); ++c)
    if(c != 5)
      turn(c);
  CHECK(bool(snap(other, parameters::cell_neighbors(neighbors))));
  for(std::size_t c = 0; c < map.cells.size(); ++c)
    turn(c);

  std::swap(neighbors[0][0], neighbors[0][1]);
  check_refusal(Outcome::INVALID_ARGUMENT, map, "cell 0",
                parameters::cell_neighbors(neighbors));
  neighbors.pop_back();
  check_refusal(Outcome::INVALID_ARGUMENT, map, "size",
                parameters::cell_neighbors(neighbors));

  // neighbors that would hide the boundary, which is to be aligned
  Tet_map apart = map;
  apart.cells = {{{0, 1, 2, 3}}, {{4, 5, 6, 7}}};
  apart.corners.resize(8);
  neighbors = {{{1, 1, 1, 1}}, {{0, 0, 0, 0}}};
  check_refusal(Outcome::INVALID_ARGUMENT, apart, "is no cell with the facet",
                parameters::cell_neighbors(neighbors));
  neighbors = {{{0, 0, 0, 0}}, {{1, 1, 1, 1}}};
  check_refusal(Outcome::INVALID_ARGUMENT, apart, "is no other cell",
                parameters::cell_neighbors(neighbors));

  // three cells at a facet, two of which are neighbors, say
  map.cells = {{{0, 1, 2, 3}}, {{4, 2, 1, 3}}, {{5, 2, 1, 3}}};
  map.corners.resize(12);
  for(const std::array<int, 3>& first :
      {std::array<int, 3>{{1, -1, -1}}, {{-1, 0, -1}}, {{1, 0, 0}}, {{2, 2, 0}}, {{2, 2, 1}},
       {{1, 2, 1}}}) {
    neighbors.assign(3, {{-1, -1, -1, -1}});
    for(std::size_t c = 0; c < 3; ++c)
      neighbors[c][0] = first[c];
    check_refusal(Outcome::INVALID_ARGUMENT, map, "not the other way round",
                  parameters::cell_neighbors(neighbors));
  }
}

// The sides of one facet, which differ at one vertex, by so little that rounded differences of
// coordinates are the same, or by much.
inline void test_two_cells()
{
  Tet_map map{{{{0, 1, 2, 3}}, {{1, 2, 3, 4}}},
                    {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}},
                     {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{1, 1, 1}}}};
  const auto is_exact = [](Tet_map changed) {
    const bool result = Snapping::is_volume_seamless(changed.cells, Double_map{&changed},
                                                     parameters::align_boundary(false));
    CHECK_EQUAL(result, volume_reference::check(changed, false).is_exact());
    return result;
  };
  CHECK(is_exact(map));
  for(std::size_t c = 0; c < 3; ++c)
    for(const double by : {0x1p-60, 0.25}) {
      for(std::size_t k = 4; k < 7; ++k) {
        Tet_map changed = map;
        changed.corners[k][c] += by;
        CHECK(!is_exact(changed) || changed.corners == map.corners);
      }
      Tet_map moved = map;
      for(std::size_t k = 4; k < 8; ++k)
        moved.corners[k][c] += by;
      CHECK_EQUAL(is_exact(moved), by == 0.25);
    }
  // the last cell has its features, too
  CHECK_EQUAL(snap(map, parameters::align_boundary(false)
                .feature_edges(std::vector<std::array<int, 2> >{{{1, 4}}})).status,
              Outcome::NOT_ALIGNED);
}

// A component of the mesh has no flips if all its cells are listed the other way round, or if it is
// mirrored.
inline void test_components_listed_negatively()
{
  const Tet_map one = box_map(3);
  for(const bool is_mirrored : {false, true}) {
    Tet_map map = one, alone = one;
    for(std::size_t c = 0; c < one.cells.size(); ++c) { // a second component
      map.cells.push_back(one.cells[c]);
      for(int& v : map.cells.back())
        v += 10000;
      for(std::size_t i = 4 * c; i < 4 * c + 4; ++i)
        map.corners.push_back(one.corners[i]);
      for(Tet_map* const m : {&map, &alone}) {
        const std::size_t last = m == &map ? map.cells.size() - 1 : c;
        if(!is_mirrored) {
          std::swap(m->cells[last][0], m->cells[last][1]);
          std::swap(m->corners[4 * last], m->corners[4 * last + 1]);
        } else
          for(std::size_t i = 4 * last; i < 4 * last + 4; ++i)
            std::swap(m->corners[i][0], m->corners[i][1]);
      }
    }
    for(Tet_map* const m : {&map, &alone}) {
      const auto measure = Snapping::measure_volume_seamlessness(m->cells, Double_map{m});
      CHECK_EQUAL(measure.number_of_flipped_cells, std::size_t(0));
      const auto np = parameters::integer_grid(true).grid_scale(4.).rounding_tolerance(10.);
      CHECK_EQUAL(snap(*m, np).status, Outcome::SNAPPED);
      const auto grid = Snapping::measure_volume_integer_grid(m->cells, Double_map{m});
      CHECK(grid && grid.number_of_nonpositive_cells == 0 && grid.volume > 0);
    }
  }
}

// Names of vertices that are much larger than their number change nothing.
inline void test_large_names()
{
  Tet_map map = box_map(6);
  volume_generator::add_noise(map, 1e-7, false, 7);
  Tet_map other = map;
  for(auto& cell : other.cells)
    for(int& v : cell)
      v = 1 + 3000000 * v;
  using Facets = std::vector<std::array<int, 3> >;
  using Edges = std::vector<std::array<int, 2> >;
  const auto& c = map.cells[0]; // an edge and a facet of the first cube's side
  CHECK(bool(snap(map, parameters::feature_facets(Facets{{{c[1], c[2], c[3]}}})
                         .feature_edges(Edges{{{c[2], c[3]}}}))));
  const auto& d = other.cells[0];
  CHECK(bool(snap(other, parameters::feature_facets(Facets{{{d[1], d[2], d[3]}}})
                           .feature_edges(Edges{{{d[2], d[3]}}}))));
  CHECK(map.corners == other.corners);
  CHECK(bool(snap(map, parameters::grid_scale(3.))));
  CHECK(bool(snap(other, parameters::grid_scale(3.))));
  CHECK(map.corners == other.corners);
  other.corners[41][1] = std::numeric_limits<double>::infinity();
  check_refusal(Outcome::NOT_FINITE, other,
                "vertex " + std::to_string(other.cells[10][1]), parameters::default_values());
}

// In floats, and with a component that is exact and stays as it is.
inline void test_floats_and_components()
{
  Tet_map map = volume_generator::Tetrahedra_builder(volume_generator::quadrants(5, 2),
                                                     Charts::CUBES, 4).build();
  for(Point& p : map.corners)
    for(double& x : p)
      x = double(float(x));
  const Tet_map before = map;
  const Snapping_report report = Snapping::snap_volume_to_seamless(map.cells,
                                                                   Corner_map<float>{&map});
  CHECK(report.status == Outcome::SNAPPED && volume_reference::check(map).is_exact());
  CHECK(volume_reference::largest_change(before, map) <=
        2 * report.violation_before + 8 * report.grid_step);
  for(const Point& p : map.corners)
    for(const double x : p)
      CHECK(x == double(float(x)));

  Tet_map both = box_map(3), exact = both;
  volume_generator::add_noise(both, 1e-6, true, 5);
  CHECK(bool(snap(exact)));
  const std::size_t size = both.corners.size();
  for(std::size_t c = 0; c < exact.cells.size(); ++c) {
    both.cells.push_back(exact.cells[c]);
    for(int& v : both.cells.back())
      v += 10000;
  }
  for(const Point& p : exact.corners)
    both.corners.push_back({{p[0] * 0x1p-20, p[1] * 0x1p-20, p[2] * 0x1p-20}});
  const std::vector<Point> kept(both.corners.begin() + std::ptrdiff_t(size), both.corners.end());
  CHECK(snap(both).status == Outcome::SNAPPED);
  CHECK(volume_reference::check(both).is_exact());
  CHECK(std::equal(kept.begin(), kept.end(), both.corners.begin() + std::ptrdiff_t(size)));
}

// A map that does not keep what is written is told from one that does.
struct Rounding_map
{
  using key_type = std::size_t;
  using value_type = CGAL::Simple_cartesian<double>::Point_3;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;
  Tet_map* map;

  friend value_type get(const Rounding_map& m, const std::size_t i)
  {
    const Point& p = m.map->corners[i];
    return value_type(p[0], p[1], p[2]);
  }
  friend void put(const Rounding_map& m, const std::size_t i, const value_type& p)
  {
    m.map->corners[i] = {{double(float(p.x())), double(float(p.y())), double(float(p.z()))}};
  }
};

inline void test_map_that_rounds()
{
  Tet_map map = volume_generator::Tetrahedra_builder(volume_generator::quadrants(3, 1),
                                                     Charts::CUBES, 4).build();
  volume_generator::add_noise(map, 1e-5, false, 5);
  CHECK_EQUAL(Snapping::snap_volume_to_seamless(map.cells, Rounding_map{&map}).status,
              Outcome::INTERNAL_ERROR);
}

#endif // SEAMLESS_SNAPPING_TEST_VOLUME_INPUT_CHECKS_H
