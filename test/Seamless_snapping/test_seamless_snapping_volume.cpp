// Volumes: maps of tetrahedral meshes that are made exactly seamless, against a check in rational
// numbers, and against the least-squares optimum of all facets' equations.

#include "interruptions.h"
#include "test_data.h"
#include "triangulation_checks.h"
#include "volume_checks.h"
#include "volume_file_checks.h"
#include "volume_grid_checks.h"
#include "volume_input_checks.h"
#include "volume_optimum.h"
#include "volume_orientation_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <random>
#include <string>
#include <vector>

void test_group()
{
  using Group = Snapping::internal::Cube_rotations;
  const auto all = volume_reference::rotations();
  const auto matrix = [](const int g) {
    volume_reference::Matrix m{};
    for(std::size_t c = 0; c < 3; ++c)
      m[c][Group::source(g, c)] = Group::sign(g, c);
    return m;
  };
  std::vector<volume_reference::Matrix> found;
  for(int g = 0; g < Group::order; ++g) {
    found.push_back(matrix(g));
    CHECK(std::count(all.begin(), all.end(), matrix(g)) == 1);
    CHECK_EQUAL(Group::compose(g, Group::inverse(g)), Group::identity());
    for(int h = 0; h < Group::order; ++h) {
      const std::array<int, 3> v{{1, 2, 5}};
      CHECK(Group::apply(Group::compose(g, h), v) == Group::apply(g, Group::apply(h, v)));
    }
  }
  std::sort(found.begin(), found.end());
  CHECK(std::unique(found.begin(), found.end()) == found.end());
  const volume_reference::Matrix identity{{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};
  CHECK(matrix(Group::identity()) == identity);
}

// Nearly flat tetrahedra, far from the origin, of all sizes.
void test_orientation()
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for(int i = 0; i < 300; ++i) {
    const double scale = std::ldexp(1., i % 3 == 0 ? -320 : i % 3 == 1 ? 0 : 300);
    Tet_map map{{{{0, 1, 2, 3}}}, {}};
    for(int k = 0; k < 3; ++k)
      map.corners.push_back({{scale * coordinate(generator), scale * coordinate(generator),
                              scale * coordinate(generator)}});
    const double a = 0.25 * (i % 5), b = 0.5;
    Point p;
    for(int c = 0; c < 3; ++c)
      p[c] = map.corners[0][c] + a * (map.corners[1][c] - map.corners[0][c]) +
             b * (map.corners[2][c] - map.corners[0][c]);
    map.corners.push_back(p);
    CHECK_EQUAL(int(Snapping::internal::orientation(
                  Snapping::internal::Uvw_tetrahedron{{map.corners[0], map.corners[1],
                                                       map.corners[2], map.corners[3]}})),
                volume_reference::orientation(map, 0));
  }
}

const char* name_of(const Charts charts)
{
  return charts == Charts::BLOCKS ? "blocks" : charts == Charts::CUBES ? "cubes" : "tetrahedra";
}

void test_generated(const unsigned int seed)
{
  std::cout << "generated maps, seed " << seed << std::endl;
  unsigned int i = seed;
  for(const Cube_complex& complex : volume_generator::all_complexes())
    for(const Charts charts : {Charts::BLOCKS, Charts::CUBES, Charts::TETRAHEDRA}) {
      const Tet_map clean = volume_generator::Tetrahedra_builder(complex, charts, ++i).build();
      const auto measure = Snapping::measure_volume_seamlessness(
        clean.cells, Double_map{const_cast<Tet_map*>(&clean)});
      CHECK_EQUAL(measure.number_of_flipped_cells + measure.number_of_degenerate_cells,
                  std::size_t(0));
      for(const double noise : {0., 1e-16, 1e-12, 1e-8, 1e-5}) {
        // what differs between charts are the numbers of sheets, and where noise is added
        if((charts == Charts::CUBES && noise == 1e-12) ||
           (charts == Charts::TETRAHEDRA && (noise < 1e-8 || clean.cells.size() > 1000)))
          continue;
        Tet_map map = clean;
        ++i;
        if(noise > 0)
          volume_generator::add_noise(map, noise, i % 2 == 0, i);
        const std::string name = complex.name + ", charts of " + name_of(charts) + ", noise " +
                                 std::to_string(std::log10(noise)) + ", seed " + std::to_string(i);
        const Snapping_report report = snap_and_check(map, name);
        CHECK_IN(name, report.lost_faces.empty());
        CHECK_IN(name, report.linear_solver.number_of_non_unit_pivots == 0);
        CHECK_IN(name, report.status == Outcome::ALREADY_EXACT ||
                         report.run.number_of_cut_edges == volume_reference::check(clean).cuts);
        Tet_map again = map;
        CHECK_IN(name, snap(again).status == Outcome::ALREADY_EXACT);
        CHECK_IN(name, again.corners == map.corners);
      }
    }
}

// Against the optimum of the equations of all facets, whose unknowns are all sectors.
void test_optimum()
{
  for(const Cube_complex& complex :
      {volume_generator::quadrants(3, 1), volume_generator::tetrahedron_of_blocks(1),
       volume_generator::twisted_bar(2, 3), volume_generator::one_sided_cut(1, 2, 2),
       volume_generator::quotient("torus", 3, {})})
    for(const Charts charts : {Charts::BLOCKS, Charts::CUBES}) {
      Tet_map map = volume_generator::Tetrahedra_builder(complex, charts, 5).build();
      volume_generator::add_noise(map, 1e-6, false, 6);
      const std::vector<Point> optimum = volume_optimum::optimum(map);
      const Snapping_report report = snap_and_check(map, complex.name);
      double distance = 0;
      for(std::size_t i = 0; i < optimum.size(); ++i)
        for(int c = 0; c < 3; ++c)
          distance = (std::max)(distance, std::abs(optimum[i][c] - map.corners[i][c]));
      CHECK_IN(complex.name + ": " + std::to_string(distance / report.grid_step) + " steps",
               distance <= 16 * report.grid_step);
    }
}

// Where charts are joined, the optimum is approximated: in squared changes of all sectors, and in
// no place by much more.
void test_optimum_of_joined_charts()
{
  for(const Cube_complex& complex :
      {volume_generator::quadrants(5, 2), volume_generator::one_sided_cut(1, 3, 2),
       volume_generator::tetrahedron_of_blocks(1)}) {
    const Charts charts = complex.cubes.size() > 33 ? Charts::CUBES : Charts::TETRAHEDRA;
    Tet_map map = volume_generator::Tetrahedra_builder(complex, charts, 5).build();
    volume_generator::add_noise(map, 1e-6, false, 6);
    const Tet_map before = map, best{map.cells, volume_optimum::optimum(map)};
    const Snapping_report report = snap_and_check(map, complex.name);
    CHECK_IN(complex.name, report.run.number_of_cut_branches < 16); // joined
    const double change = volume_optimum::sum_of_squared_changes(before, map);
    const double least = volume_optimum::sum_of_squared_changes(before, best);
    CHECK_IN(complex.name + ": " + std::to_string(change / least), change <= 1.2 * least);
    CHECK_IN(complex.name, volume_reference::largest_change(before, map) <=
                             1.5 * volume_reference::largest_change(before, best));
  }
}

// The same for cells, corners, and vertices in another order: the optimum does not depend on it.
void test_renumbering()
{
  std::mt19937 generator(11);
  for(const Cube_complex& complex :
      {volume_generator::tetrahedron_of_blocks(2), volume_generator::one_sided_cut(1, 3, 2)}) {
    Tet_map map = volume_generator::Tetrahedra_builder(complex, Charts::CUBES, 3).build();
    volume_generator::add_noise(map, 1e-9, false, 4);
    std::vector<std::size_t> order(map.cells.size()), corner;
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::shuffle(order.begin(), order.end(), generator);
    Tet_map other;
    for(const std::size_t c : order) {
      std::array<int, 4> k{{0, 1, 2, 3}};
      std::shuffle(k.begin(), k.end(), generator);
      other.cells.emplace_back();
      for(int i = 0; i < 4; ++i) {
        other.cells.back()[std::size_t(i)] = 5000 - map.cells[c][std::size_t(k[std::size_t(i)])];
        corner.push_back(4 * c + std::size_t(k[std::size_t(i)]));
        other.corners.push_back(map.corners[corner.back()]);
      }
    }
    const Snapping_report report = snap_and_check(map, complex.name);
    CHECK(bool(snap(other)));
    double distance = 0;
    for(std::size_t i = 0; i < corner.size(); ++i)
      for(std::size_t c = 0; c < 3; ++c)
        distance = (std::max)(distance,
                              std::abs(other.corners[i][c] - map.corners[corner[i]][c]));
    CHECK_IN(complex.name, distance <= 4 * report.grid_step);
  }
}

// The facets of a map that lie in the middle plane of a box, and an edge inside of it, as the
// tetrahedra have them.
void test_features()
{
  Tet_map map = box_map(8);
  const Tet_map clean = map;
  volume_generator::add_noise(map, 1e-7, false, 9);
  std::vector<volume_reference::Facet> features;
  for(const auto& [facet, cells] : volume_reference::cells_of_facets(clean))
    if(cells.size() == 2 && cells[0] / 24 != cells[1] / 24)
      features.push_back(facet);
  CHECK_EQUAL(features.size(), std::size_t(20 * 4));
  Tet_map plain = map;
  CHECK(bool(snap(plain)));
  CHECK(volume_reference::check(plain).is_exact());
  CHECK(!volume_reference::check(plain, true, features).is_exact());
  const Snapping_report report = snap(map, parameters::feature_facets(features));
  CHECK(bool(report));
  CHECK(volume_reference::check(map, true, features).is_exact());
  CHECK(report.largest_change <= 2 * report.violation_before);
  const auto all = parameters::feature_facets(features);
  CHECK(Snapping::is_volume_seamless(map.cells, Double_map{&map}, all));
  CHECK(!Snapping::is_volume_seamless(plain.cells, Double_map{&plain}, all));

  // edges along one axis: in a cell, those whose clean ends differ in one coordinate
  Tet_map edged = clean;
  volume_generator::add_noise(edged, 1e-7, false, 10);
  std::vector<std::array<int, 2> > edges;
  std::vector<std::array<std::size_t, 2> > corners;
  for(std::size_t i = 0; i < clean.corners.size(); i += 4 * 7) // two corners of a cube's edge
    if(clean.corners[i + 2] != clean.corners[i + 3]) {
      edges.push_back({edged.cells[i / 4][2], edged.cells[i / 4][3]});
      corners.push_back({i + 2, i + 3});
    }
  const Snapping_report of_edges = snap(edged, parameters::feature_edges(edges));
  CHECK(bool(of_edges) && volume_reference::check(edged).is_exact());
  CHECK(of_edges.largest_change <= 2 * of_edges.violation_before);
  for(const auto& [i, k] : corners) {
    int number_of_constants = 0;
    for(std::size_t c = 0; c < 3; ++c)
      number_of_constants += int(edged.corners[i][c] == edged.corners[k][c]);
    CHECK_EQUAL(number_of_constants, 2);
  }
}

// A cell at the boundary, which is thinner than the noise: where the boundary passes its fourth
// vertex, that moves, although no constraint concerns it.
void test_repair(const bool per_corner)
{
  std::size_t number_of_lost_cells = 0;
  for(unsigned int seed = 1; seed <= 20; ++seed) {
    const Tet_map thick = box_map(seed);
    Tet_map clean = thick;
    const auto facets = volume_reference::cells_of_facets(clean);
    std::size_t cell = 0;
    for(const auto& [facet, cells] : facets)
      cell = cells.size() == 1 ? (std::max)(cell, cells[0]) : cell;
    Tet_map map = clean;
    volume_generator::add_noise(map, 1e-8, per_corner, seed);
    const int center = map.cells[cell][0];
    for(std::size_t i = 0; i < map.corners.size(); ++i)
      for(std::size_t c = 0; c < 3 && map.cells[i / 4][i % 4] == center; ++c) {
        const Point *const u = &clean.corners[4 * cell];
        const double middle = (u[1][c] + u[2][c] + u[3][c]) / 3;
        map.corners[i][c] += middle + 2e-8 * (u[0][c] - middle) - u[0][c];
      }
    if(volume_reference::orientation(map, cell) != 1)
      continue;
    const Snapping_report report = snap_and_check(map, "thin cell, seed " + std::to_string(seed));
    number_of_lost_cells += report.run.number_of_lost_faces;
    CHECK_EQUAL(report.lost_faces.size(), std::size_t(0));
    CHECK_EQUAL(report.run.number_of_lost_faces, report.run.number_of_faces_repaired_by_moves);
  }
  CHECK(per_corner || number_of_lost_cells > 0); // else the vertex is one that moves anyway
}

// The middle of a face of a cube comes so near to one of its edges that several rotations fit their
// facet, or two coordinates of the boundary. With a wrong one it would have to lie on the edge, and
// its cells would have no volume. Each cell has a chart of its own: all facets around count.
void test_thin_facets(const bool is_at_boundary)
{
  for(unsigned int seed = 1; seed <= 30; ++seed) {
    Tet_map map = box_map(seed);
    std::mt19937 generator(seed);
    std::vector<std::size_t> candidates;
    for(const auto& [facet, cells] : volume_reference::cells_of_facets(map))
      for(const std::size_t c : cells)
        if((cells.size() == 1) == is_at_boundary &&
           std::find(facet.begin(), facet.end(), map.cells[c][0]) == facet.end())
          candidates.push_back(c);
    const std::size_t cell = candidates[generator() % candidates.size()];
    const Point a = map.corners[4 * cell + 2], b = map.corners[4 * cell + 3];
    for(std::size_t i = 0; i < map.corners.size(); ++i)
      for(std::size_t c = 0; c < 3 && map.cells[i / 4][i % 4] == map.cells[cell][1]; ++c) {
        const double middle = (a[c] + b[c]) / 2;
        const double part = 1e-7 + 1e-8 * (seed % 30);
        map.corners[i][c] = middle + part * (map.corners[i][c] - middle);
      }
    volume_generator::Chart chart;
    for(std::size_t i = 0; i < map.corners.size(); ++i) {
      if(i % 4 == 0)
        chart = volume_generator::Chart::random(generator);
      map.corners[i] = chart(map.corners[i]);
    }
    volume_generator::add_noise(map, 1e-8, true, seed);
    const std::string name = "thin facet, seed " + std::to_string(seed);
    CHECK_IN(name, snap_and_check(map, name).lost_faces.empty());
  }
}

// Fifty hexahedra along a side: fewer would need better integers than the nearest.
void test_grid_of_file(Tet_map map, const std::string& name)
{
  const Tet_map before = map;
  const double scale = 50 / volume_reference::extent(map);
  const Snapping_report report =
    snap(map, parameters::integer_grid(true).grid_scale(scale).rounding_tolerance(10.));
  CHECK_IN(name + ": " + report.message, bool(report) && is_grid(map));
  CHECK_IN(name, report.lost_faces.empty() && volume_reference::lost_cells(before, map) == 0);
  if(map.cells.size() < 2000) // takes long in rational numbers
    CHECK_IN(name, volume_grid_reference::count(map).are_integers());
}

// As they are, and to integers with repairs.
void test_interruptions()
{
  Tet_map map = volume_generator::Tetrahedra_builder(volume_generator::all_complexes().front(),
                                                     Charts::CUBES, 1).build();
  volume_generator::add_noise(map, 1e-8, true, 1);
  const Tet_map before = map;
  const auto test = [&](const auto& np) {
    interruptions::test("a volume", [&](const auto& visitor) {
      map = before;
      return bool(snap(map, np.visitor(visitor)));
    }, [&] { return map.corners == before.corners; });
  };
  test(parameters::default_values());
  test(parameters::integer_grid(true).rounding_tolerance(10.)
                  .grid_scale(20 / volume_reference::extent(map))
                  .repair_flips(Snapping::Flip_repair::UNTANGLE));
}

// Real maps, as they are and with noise.
void test_further_files()
{
  for(const auto& file : test_data::fifth_of_further_files("volume", ".hexex")) {
    Snapping::IO::HEXEX_mesh mesh;
    const auto status = Snapping::IO::read_HEXEX(file.string(), mesh);
    if(!CHECK(bool(status)))
      continue;
    Tet_map map;
    for(const auto& cell : mesh.tetrahedra)
      map.cells.push_back({{cell[0], cell[1], cell[2], cell[3]}});
    map.corners = mesh.uvw;
    Tet_map noisy = map;
    CHECK_IN(file.string(), snap_and_check(map, file.string()).lost_faces.empty());
    volume_generator::add_noise(noisy, 1e-8, true, 1);
    if(file.string().find("_noise") == std::string::npos)
      test_grid_of_file(noisy, file.string());
    CHECK_IN(file.string(), snap_and_check(noisy, file.string()).lost_faces.empty());
    if(mesh.feature_facets.empty())
      continue;
    map.corners = mesh.uvw;
    CHECK(bool(snap(map, parameters::feature_facets(mesh.feature_facets)
                                    .feature_edges(mesh.feature_edges))));
    CHECK(volume_reference::check(map).is_exact());
  }
}

// \param argv a number of seeds, for a longer run with generated maps
int main(int argc, char** argv)
{
  test_group();
  test_orientation();
  for(int i = 0; i < (argc > 1 ? std::atoi(argv[1]) : 1); ++i)
    test_generated(1 + 1000 * static_cast<unsigned int>(i));
  test_optimum();
  test_optimum_of_joined_charts();
  test_renumbering();
  test_features();
  test_repair(false);
  test_repair(true);
  test_thin_facets(false);
  test_thin_facets(true);
  test_refusals();
  test_neighbors();
  for(const unsigned int seed : {1, 2, 3}) {
    triangulation_checks::test_cells_of_triangulation(seed);
    triangulation_checks::test_cells_of_complex(seed);
  }
  test_two_cells();
  test_large_names();
  test_floats_and_components();
  test_map_that_rounds();
  test_integer_grids();
  test_refusals_of_grids();
  test_repairs_of_flips();
  test_grids_with_flips();
  test_orientations_of_lists();
  test_components_listed_negatively();
  test_interruptions();
  test_cell_without_volume();
  test_slab_thinner_than_a_unit();
  test_blocks_smaller_than_a_unit();
  test_files();
  test_rounding_of_fractions();
  test_further_files();
  return report_checks();
}
