// The extraction of hexahedra from integer-grid maps: against the cubes that maps were made of,
// against integers that the maps alone tell, with cells in another order, and what is refused.

#include "checking.h"
#include "floating_point_traps.h"
#include "hexahedra_reference.h"
#include "integer_maps.h"
#include "test_data.h"
#include "volume_checks.h"

#include <CGAL/Hexahedral_meshing/extract_hexahedra.h>
#include <CGAL/Seamless_snapping/IO/HEXEX.h>
#include <CGAL/Seamless_snapping/snap_volume_to_seamless.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace Meshing = CGAL::Hexahedral_meshing;
using hexahedra_reference::Hexahedra;
using integer_maps::Integer_map;
using Meshing::Hexahedra_report;

template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Hexahedra_report extract(const Integer_map& map, Hexahedra& hexahedra,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  const Floating_point_traps traps;
  Tet_map copy = map.map;
  return Meshing::extract_hexahedra<ConcurrencyTag>(
    map.points, map.map.cells, Double_map{&copy}, hexahedra.points, hexahedra.cells, np);
}

// Cells in another order, their vertices, too, in either orientation; other numbers of vertices.
// Parts without a common facet have each the orientation of most of its cells.
Integer_map shuffled(const Integer_map& map, const unsigned int seed, const bool turns = true)
{
  std::mt19937 generator(seed);
  const auto shuffled_numbers = [&](const std::size_t n) {
    std::vector<std::size_t> result(n);
    std::iota(result.begin(), result.end(), std::size_t(0));
    std::shuffle(result.begin(), result.end(), generator);
    return result;
  };
  Integer_map result;
  const std::vector<std::size_t> new_vertex = shuffled_numbers(map.points.size());
  result.points.resize(map.points.size());
  for(std::size_t v = 0; v < map.points.size(); ++v)
    result.points[new_vertex[v]] = map.points[v];
  for(const std::size_t c : shuffled_numbers(map.map.cells.size())) {
    std::array<int, 4> cell;
    std::vector<std::size_t> order{0, 1, 2, 3};
    if(turns)
      order = shuffled_numbers(4);
    else
      std::rotate(order.begin(), order.begin() + 1, order.begin() + 3);
    for(std::size_t i = 0; i < 4; ++i) {
      cell[i] = int(new_vertex[std::size_t(map.map.cells[c][order[i]])]);
      result.map.corners.push_back(map.map.corners[4 * c + order[i]]);
    }
    result.map.cells.push_back(cell);
  }
  return result;
}

bool touches_itself(const Cube_complex& complex)
{
  return complex.name.find("common") != std::string::npos ||
         complex.name.find("random") != std::string::npos;
}

// Returns the number of hexahedra.
std::size_t check_complex(const Cube_complex& complex, const Charts charts, const double size,
                          const unsigned int seed)
{
  const std::string name =
    complex.name + ", size " + std::to_string(size) + ", seed " + std::to_string(seed);
  const Integer_map map = integer_maps::Builder(complex, charts, size, seed).build();
  Hexahedra hexahedra, again;
  const Hexahedra_report report = extract(map, hexahedra);
  CHECK_IN(name + ": " + report.message, bool(report));
  const Hexahedra expected = hexahedra_reference::expected_hexahedra(map);
  if(!touches_itself(complex)) {
    CHECK_IN(name, hexahedra_reference::are_same(hexahedra, expected));
    hexahedra_reference::check_hexahedra(hexahedra, hexahedra_reference::integers(map.map), name);
    CHECK_IN(name, report.irregular_edges == hexahedra_reference::irregular_edges(expected));
  }
  CHECK_EQUAL(hexahedra.cells.size(), expected.cells.size());
  CHECK_IN(name, report.number_of_hexahedra == hexahedra.cells.size() &&
                   report.number_of_vertices == hexahedra.points.size());
  CHECK_IN(name, bool(extract(shuffled(map, seed, !touches_itself(complex)), again)));
  CHECK_IN(name, hexahedra_reference::are_same(hexahedra, again) || touches_itself(complex));
  CHECK_EQUAL(hexahedra.points.size(), again.points.size());
  return hexahedra.cells.size();
}

void test_complexes()
{
  std::vector<Cube_complex> complexes = volume_generator::all_complexes();
  complexes.push_back(volume_generator::quadrants(4, 1));
  complexes.push_back(volume_generator::quadrants(6, 1));
  complexes.push_back(volume_generator::quadrants(8, 1)); // 720 degrees
  unsigned int seed = 0;
  std::size_t number = 0;
  for(const Cube_complex& complex : complexes)
    for(const Charts charts : {Charts::BLOCKS, Charts::CUBES, Charts::TETRAHEDRA}) {
      if(complex.cubes.size() > 40 && charts != Charts::CUBES)
        continue; // takes long in rational numbers
      ++seed;
      number += check_complex(complex, charts, seed % 3 == 0 && complex.cubes.size() < 16 ? 2 : 1,
                              seed);
    }
  for(const Cube_complex& complex : // blocks of three units, but no cube is of one
      {volume_generator::quadrants(3, 2), volume_generator::quadrants(5, 2),
       volume_generator::tetrahedron_of_blocks(2), volume_generator::twisted_bar(2, 4)}) {
    ++seed;
    number += check_complex(complex, seed % 2 == 0 ? Charts::BLOCKS : Charts::TETRAHEDRA, 1.5,
                            seed);
  }
  for(const Cube_complex& complex : // a hexahedron is of eight cubes, its center a vertex
      {volume_generator::quadrants(3, 2), volume_generator::quadrants(5, 2),
       volume_generator::tetrahedron_of_blocks(2)})
    for(const Charts charts : {Charts::BLOCKS, Charts::TETRAHEDRA})
      number += check_complex(complex, charts, 0.5, ++seed);
  std::cout << number << " hexahedra of complexes" << std::endl;
}

// Cubes of a small lattice, at random; they may touch in edges and vertices.
void test_random_cubes(const unsigned int number)
{
  std::size_t hexahedra = 0;
  for(unsigned int seed = 1; seed <= number; ++seed) {
    std::mt19937 generator(seed);
    std::vector<volume_generator::Lattice_point> low;
    const bool is_connected = seed % 2 == 0; // a bar with bends, which touches nothing
    volume_generator::Lattice_point at{{0, 0, 0}};
    for(int i = 0; i < 4; ++i)
      if(is_connected) {
        low.push_back(at);
        at[i % 2 == 0 ? generator() % 3 : 0] += 2;
      } else if(generator() % 2 == 0 || i == 0) {
        low.push_back({{i % 2 * 2, i / 2 * 2, int(generator() % 2) * 2}});
      }
    Cube_complex complex = volume_generator::lattice_cubes(
      is_connected ? "bent bar" : "random cubes", low);
    constexpr Charts charts[] = {Charts::BLOCKS, Charts::CUBES, Charts::TETRAHEDRA};
    hexahedra += check_complex(complex, charts[generator() % 3], 1 + double(generator() % 2), seed);
  }
  std::cout << hexahedra << " hexahedra of random cubes" << std::endl;
}

// Many hexahedra a cell and several threads, outputs of other types, and where vertices lie.
void test_outputs()
{
  const Integer_map map = integer_maps::Builder(volume_generator::quadrants(5, 2), Charts::CUBES, 6,
                                                7).build();
  Hexahedra one, several;
  CHECK(bool(extract(map, one)));
  CHECK(bool(extract<CGAL::Parallel_if_available_tag>(map, several)));
  CHECK(one.points == several.points && one.cells == several.cells);
  hexahedra_reference::check_hexahedra(one, hexahedra_reference::integers(map.map), "many");
  CHECK_EQUAL(one.cells.size(), std::size_t(5 * 12 * 12 * 12));

  using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
  using Location = std::pair<std::size_t, std::array<double, 4> >;
  std::vector<Point_3> points(3, Point_3(0, 0, 0));
  std::vector<std::vector<std::size_t> > cells(2);
  std::vector<Location> locations(3 + one.points.size());
  Tet_map copy = map.map;
  const auto report = Meshing::extract_hexahedra(
    map.points, map.map.cells, Double_map{&copy}, points, cells,
    Meshing::parameters::vertex_location_map(CGAL::make_property_map(locations)));
  CHECK(bool(report));
  CHECK_EQUAL(points.size(), 3 + one.points.size());
  CHECK_EQUAL(cells.size(), 2 + one.cells.size());
  for(std::size_t i = 0; i < one.cells.size(); ++i)
    for(std::size_t k = 0; k < 8; ++k)
      CHECK(cells[i + 2][k] == 3 + std::size_t(one.cells[i][k]));
  for(std::size_t v = 3; v < points.size(); ++v) {
    const auto& [cell, weights] = locations[v];
    Point in_space{}, in_domain{};
    for(std::size_t i = 0; i < 4; ++i)
      for(std::size_t k = 0; k < 3; ++k) {
        in_space[k] += weights[i] * map.points[std::size_t(map.map.cells[cell][i])][k];
        in_domain[k] += weights[i] * map.map.corners[4 * cell + i][k];
      }
    for(int k = 0; k < 3; ++k) {
      CHECK(points[v][k] == one.points[v - 3][std::size_t(k)]);
      CHECK(std::abs(in_space[std::size_t(k)] - points[v][k]) < 1e-12);
      CHECK(std::abs(in_domain[std::size_t(k)] - std::round(in_domain[std::size_t(k)])) < 1e-9);
    }
  }
}

// Hexahedra are positive in space whether the map mirrors or not, each component by itself.
void test_mirrored_maps()
{
  for(const int mirrored : {0, 1, 2}) {
    Integer_map map = integer_maps::Builder(
      volume_generator::lattice_cubes("boxes", {{{0, 0, 0}}, {{6, 0, 0}}}), Charts::BLOCKS, 2, 3)
                        .build();
    for(std::size_t i = 0; i < map.in_block.size(); ++i)
      map.points[std::size_t(map.map.cells[i / 4][i % 4])] = map.in_block[i];
    for(std::size_t i = 0; i < map.map.corners.size(); ++i) // of the second box, or of both
      if(int(i / (4 * 24)) >= 2 - mirrored)
        map.map.corners[i][1] = -map.map.corners[i][1];
    Hexahedra hexahedra;
    CHECK(bool(extract(map, hexahedra)));
    CHECK_EQUAL(hexahedra.cells.size(), std::size_t(16));
    for(const auto& cell : hexahedra.cells) {
      std::array<Point, 3> e;
      for(std::size_t i = 0; i < 3; ++i)
        for(std::size_t k = 0; k < 3; ++k)
          e[i][k] = hexahedra.points[std::size_t(cell[i == 0 ? 1 : i == 1 ? 3 : 4])][k] -
                    hexahedra.points[std::size_t(cell[0])][k];
      CHECK(e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
              e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
              e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]) > 0);
    }
  }
}

template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
void check_refusal(const Outcome status, const Integer_map& map, const std::string& place,
                   const std::string& remedy,
                   const NamedParameters& np = CGAL::parameters::default_values())
{
  Hexahedra hexahedra;
  hexahedra.points.resize(5);
  const Hexahedra_report report = extract(map, hexahedra, np);
  CHECK_EQUAL(report.status, status);
  for(const std::string& part : {place, remedy})
    CHECK_IN(report.message + " should name " + part,
             report.message.find(part) != std::string::npos);
  CHECK(hexahedra.points.size() == 5 && hexahedra.cells.empty());
}

std::string name_of_facet(const Integer_map& map, const std::size_t c, const int opposite)
{
  std::vector<int> v;
  for(int k = 0; k < 4; ++k)
    if(k != opposite)
      v.push_back(map.map.cells[c][std::size_t(k)]);
  std::string result;
  for(const int x : v)
    result += (result.empty() ? "" : ", ") + std::to_string(x);
  return result;
}

void test_refusals()
{
  const Integer_map map =
    integer_maps::Builder(volume_generator::quadrants(3, 2), Charts::BLOCKS, 2, 11).build();
  const std::string snap = "snap_volume_to_seamless()";
  Integer_map bad = map;
  std::swap(bad.map.corners[4 * 17], bad.map.corners[4 * 17 + 1]);
  check_refusal(Outcome::NOT_POSITIVE, bad, "cell 17", "repair_flips");
  bad.map.corners[4 * 17] = bad.map.corners[4 * 17 + 1];
  check_refusal(Outcome::NOT_POSITIVE, bad, "cell 17", "repair_flips");
  bad = map; // the center of a cube is in no boundary: one of its corners moves alone
  bad.map.corners[4 * 17][0] += 0x1p-40;
  check_refusal(Outcome::NOT_SEAMLESS, bad, std::to_string(map.map.cells[17][0]), snap);
  bad = map;
  for(std::size_t i = 0; i < bad.map.corners.size() / 3; ++i) // those of the first block
    bad.map.corners[i][1] += 0x1p-40;
  check_refusal(Outcome::NOT_INTEGER, bad, "translation across facet", "integer_grid");
  bad = map;
  for(Point& u : bad.map.corners) // of cells of one chart: translations stay integers
    for(double& x : u)
      x *= 0x1p50;
  check_refusal(Outcome::TOO_LARGE, bad, "2^46", "scale the map down");
  check_refusal(Outcome::TOO_LARGE, map, "192 hexahedra", "maximum_number",
                Meshing::parameters::maximum_number(100));
  bad = map;
  bad.points[3][1] = std::numeric_limits<double>::infinity();
  check_refusal(Outcome::NOT_FINITE, bad, "vertex 3", "correct it");
  bad = map;
  bad.points.pop_back();
  check_refusal(Outcome::INVALID_ARGUMENT, bad, "vertex " + std::to_string(map.points.size() - 1),
                "no point");
  bad.map.cells[2][1] = bad.map.cells[2][0];
  check_refusal(Outcome::INVALID_ARGUMENT, bad, "cell 2", "remove it");

  // a box with its boundary between the planes, and with a vertex out of its plane
  Integer_map box = integer_maps::Builder(volume_generator::lattice_cubes("box", {{{0, 0, 0}}}),
                                          Charts::BLOCKS, 2, 5).build();
  bad = box;
  for(Point& u : bad.map.corners)
    u[2] += 0.25;
  check_refusal(Outcome::NOT_INTEGER, bad, "the boundary facet", "integer_grid");
  bad = box;
  const int moved = bad.map.cells[0][1]; // the center of a face
  for(std::size_t i = 0; i < bad.map.corners.size(); ++i)
    for(double& x : bad.map.corners[i])
      if(bad.map.cells[i / 4][i % 4] == moved)
        x += 0x1p-45;
  check_refusal(Outcome::NOT_ALIGNED, bad, name_of_facet(bad, 0, 0), snap);
  using Edges = std::vector<std::array<int, 2> >;
  const auto& cell = box.map.cells[0];
  check_refusal(Outcome::NOT_ALIGNED, box, std::to_string(cell[0]), snap,
                Meshing::parameters::feature_edges(Edges{{{cell[0], cell[2]}}}));

  // a singular edge between the lines, in a closed mesh: translations are integers all the same
  bad = integer_maps::Builder(volume_generator::all_complexes()[4], Charts::BLOCKS, 1, 5).build();
  CHECK(volume_reference::check(bad.map).border == 0);
  for(Point& u : bad.map.corners)
    for(double& x : u)
      x += 0.5;
  check_refusal(Outcome::NOT_INTEGER, bad, "singular edge", "integer_grid");

  for(const int size : {1, 2}) {
    const Integer_map torus = integer_maps::Builder(volume_generator::quotient("torus", size, {}),
                                                    Charts::BLOCKS, 1, 9).build();
    if(size == 2) // the tetrahedra of a single cube are no manifold
      check_refusal(Outcome::TOO_COARSE, torus, "the hexahedron at (", "grid_scale");
  }
}

// Real maps, with 500 hexahedra and more, made integer-grid maps before.
void test_further_files()
{
  std::size_t number = 0, number_of_maps = 0;
  for(const auto& file : test_data::fifth_of_further_files("volume", ".hexex")) {
    Snapping::IO::HEXEX_mesh mesh;
    if(!CHECK(bool(Snapping::IO::read_HEXEX(file.string(), mesh))) ||
       file.string().find("_noise") != std::string::npos || mesh.tetrahedra.size() > 5000)
      continue;
    Integer_map map;
    for(const auto& cell : mesh.tetrahedra)
      map.map.cells.push_back({{cell[0], cell[1], cell[2], cell[3]}});
    map.map.corners = mesh.uvw;
    map.points = mesh.points;
    const double extent = volume_reference::extent(map.map);
    if(!snap(map.map, parameters::integer_grid(true)
                        .grid_scale(25 / extent)
                        .rounding_tolerance(10.)
                        .feature_facets(mesh.feature_facets)
                        .feature_edges(mesh.feature_edges)))
      continue;
    Hexahedra hexahedra, again;
    const Hexahedra_report report = extract(map, hexahedra);
    if(report.status == Outcome::NOT_POSITIVE || report.status == Outcome::TOO_COARSE)
      continue; // too few hexahedra for integers that are the nearest ones
    CHECK_IN(file.string() + ": " + report.message, bool(report));
    hexahedra_reference::check_hexahedra(hexahedra, hexahedra_reference::integers(map.map),
                                         file.string());
    CHECK_IN(file.string(),
             report.irregular_edges == hexahedra_reference::irregular_edges(hexahedra));
    CHECK_IN(file.string(), bool(extract(shuffled(map, 1), again)));
    CHECK_IN(file.string(), hexahedra_reference::are_same(hexahedra, again));
    number += hexahedra.cells.size();
    ++number_of_maps;
  }
  std::cout << number << " hexahedra of " << number_of_maps << " files" << std::endl;
}

// \param argv a number of random maps, for a longer run
int main(int argc, char** argv)
{
  test_complexes();
  test_random_cubes(argc > 1 ? static_cast<unsigned int>(std::atoi(argv[1])) : 40);
  test_outputs();
  test_mirrored_maps();
  test_refusals();
  test_further_files();
  return report_checks();
}
