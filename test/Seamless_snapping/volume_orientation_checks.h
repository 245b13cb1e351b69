// Volumes whose cells are listed in both orientations.

#ifndef SEAMLESS_SNAPPING_TEST_VOLUME_ORIENTATION_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_VOLUME_ORIENTATION_CHECKS_H

#include "volume_checks.h"
#include "volume_grid_checks.h"

#include <CGAL/Seamless_snapping/is_volume_seamless.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Lists cells in the other orientation.
inline void turn(Tet_map& map, const std::vector<std::size_t>& cells)
{
  for(const std::size_t c : cells) {
    std::swap(map.cells[c][0], map.cells[c][1]);
    std::swap(map.corners[4 * c], map.corners[4 * c + 1]);
  }
}

// Tangled cells, and a box apart from them that is listed the other way round as a whole.
inline Tet_map tangled_cells_and_box(const double size)
{
  Tet_map map = volume_generator::Tetrahedra_builder(volume_generator::quadrants(5, 2),
                                                     Charts::BLOCKS, 3).build();
  tangle(map, size, 3);
  const Tet_map box = box_map(3);
  std::vector<std::size_t> cells_of_box;
  for(std::size_t c = 0; c < box.cells.size(); ++c) {
    cells_of_box.push_back(map.cells.size());
    map.cells.push_back(box.cells[c]);
    for(int& v : map.cells.back())
      v += 10000;
    map.corners.insert(map.corners.end(), &box.corners[4 * c], &box.corners[4 * c] + 4);
  }
  turn(map, cells_of_box);
  volume_generator::add_noise(map, 1e-10, true, 3);
  return map;
}

// Fewer than half of the cells are turned, the first one of each component among them: that is as
// if none were, to the bit.
template <typename NamedParameters>
void test_turned_cells(const std::string& name, const double size, const NamedParameters& np)
{
  const Tet_map map = tangled_cells_and_box(size);
  std::mt19937 generator(8);
  std::vector<std::size_t> turned;
  for(std::size_t c = 0; c < map.cells.size(); ++c)
    if(c == 0 || (map.cells[c][0] >= 10000 && map.cells[c - 1][0] < 10000) || generator() % 3 == 0)
      turned.push_back(c);
  Tet_map plain = map, other = map;
  turn(other, turned);
  const auto measure = [&](const Tet_map& m) {
    const auto result = Snapping::measure_volume_seamlessness(
      m.cells, Double_map{const_cast<Tet_map*>(&m)});
    return std::array<std::size_t, 4>{{result.number_of_flipped_cells,
                                       result.number_of_degenerate_cells,
                                       result.number_of_inexact_facets,
                                       result.number_of_misalignments}};
  };
  CHECK_IN(name, measure(other) == measure(map) && measure(map)[0] > 20);
  const Snapping_report report = snap(plain, np), report_of_other = snap(other, np);
  CHECK_IN(name + ": " + report.message, bool(report));
  CHECK_EQUAL(report_of_other.status, report.status);
  CHECK_EQUAL(report_of_other.message, report.message);
  CHECK_IN(name, report_of_other.lost_faces == report.lost_faces);
  CHECK_IN(name, report_of_other.remaining_flips == report.remaining_flips);
  CHECK_EQUAL(report_of_other.run.number_of_repaired_flips, report.run.number_of_repaired_flips);
  CHECK_IN(name, measure(other) == measure(plain));
  turn(other, turned);
  CHECK_IN(name, other.corners == plain.corners && plain.corners != map.corners);
}

// A ring of cells that has no orientation keeps the one of each cell: the fewer ones are flipped.
inline void test_cells_without_common_orientation()
{
  constexpr std::array<int, 12> vertices{{0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 0, 2}};
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Tet_map map;
  for(std::size_t c = 0; c < 9; ++c) {
    map.cells.push_back({{vertices[c], vertices[c + 1], vertices[c + 2], vertices[c + 3]}});
    for(int k = 0; k < 4; ++k)
      map.corners.push_back({{coordinate(generator), coordinate(generator),
                              coordinate(generator)}});
  }
  for(std::size_t c = 0; c < 9; ++c) {
    turn(map, {c});
    const std::size_t negative = flips(map).size();
    CHECK_EQUAL(Snapping::measure_volume_seamlessness(map.cells, Double_map{&map})
                  .number_of_flipped_cells, (std::min)(negative, map.cells.size() - negative));
  }
}

inline void test_orientations_of_lists()
{
  using Snapping::Flip_repair;
  test_turned_cells("turned cells", 0.6, parameters::default_values());
  test_turned_cells("turned cells, repairs", 0.6, parameters::repair_flips(Flip_repair::UNTANGLE));
  test_turned_cells("turned cells, integers", 0.2,
                    parameters::integer_grid(true).grid_scale(4 * cubes_to_units)
                               .rounding_tolerance(10.));
  test_cells_without_common_orientation();
}

#endif // SEAMLESS_SNAPPING_TEST_VOLUME_ORIENTATION_CHECKS_H
