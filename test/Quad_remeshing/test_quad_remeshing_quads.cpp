// Tests of the extraction of quads: all of them are known in advance, from surfaces of squares, or
// found by brute force; the result does not depend on numberings, mesh data structures, or threads.

#ifdef SEAMLESS_SNAPPING_TEST_OPENMESH
#include "open_mesh_checks.h"
#endif
#include "Polyhedron_copy.h"
#include "floating_point_traps.h"
#include "interruptions.h"
#include "quad_reference.h"
#include "slit_checks.h"
#include "test_data.h"
#include "test_surfaces.h"

#include <CGAL/Linear_snapping/internal/linear/Range_space_solver.h>
#include <CGAL/Linear_snapping/internal/linear/Sparse_cholesky.h>
#include <CGAL/Quad_remeshing/extract_grid_mesh.h>
#include <CGAL/Quad_remeshing/is_integer_grid_map.h>
#include <CGAL/Quad_remeshing/repair_integer_grid.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace quad_reference;
namespace QR = CGAL::Quad_remeshing;
namespace surfaces = test_meshes;
namespace internal = QR::internal;
namespace parameters = QR::parameters;
using Status = QR::Outcome;
using CGAL::Exact_rational;

// --- inverted quads ------------------------------------------------------------------------------

// With a and b the sides at a corner and d and e the diagonals, (a x b) (d x e) is
// (a d) (b e) - (a e) (b d).
bool is_inverted_in_rationals(const std::array<std::array<double, 3>, 4>& q)
{
  using Vector = CGAL::Simple_cartesian<Exact_rational>::Vector_3;
  const auto vector = [&](const std::size_t i, const std::size_t k) {
    return Vector(q[k][0], q[k][1], q[k][2]) - Vector(q[i][0], q[i][1], q[i][2]);
  };
  const Vector d = vector(0, 2), e = vector(1, 3);
  bool result = CGAL::cross_product(d, e) == CGAL::NULL_VECTOR;
  for(std::size_t k = 0; k < 4; ++k) {
    const Vector a = vector(k, (k + 1) % 4), b = vector(k, (k + 3) % 4);
    result = result || (a * d) * (b * e) < (a * e) * (b * d) || a == CGAL::NULL_VECTOR;
  }
  return result;
}

// A square whose corner 2 moves over the diagonal of the others, by the last bit, at sizes whose
// products overflow, or vanish; and random ones.
void test_inverted_quads()
{
  for(const double size : {1., 1e-160, 1e160, 3e-80}) {
    std::array<std::array<double, 3>, 4> q{{{0, 0, 0}, {size, 0, 0}, {0, 0, size}, {0, size, 0}}};
    const double on_diagonal = size / 2;
    for(const double x : {std::nextafter(on_diagonal, 0.), on_diagonal,
                          std::nextafter(on_diagonal, size), size, 0.}) {
      q[2] = {x, x, 0};
      CHECK_EQUAL(internal::is_inverted(q), x < on_diagonal);
      CHECK_EQUAL(is_inverted_in_rationals(q), x < on_diagonal);
    }
    q[1] = q[2] = q[3] = q[0];
    CHECK(internal::is_inverted(q));
  }
  std::mt19937 random(1);
  std::size_t number = 0;
  for(int i = 0; i < 4000; ++i) {
    std::array<std::array<double, 3>, 4> q;
    for(auto& point : q)
      for(double& x : point)
        x = double(int(random() % 5)) + (i % 2 == 0 ? 0 : std::ldexp(double(random() % 3), -51));
    CHECK_EQUAL(internal::is_inverted(q), is_inverted_in_rationals(q));
    number += internal::is_inverted(q) ? 1 : 0;
  }
  CHECK(number > 400 && number < 3600);
}

// In the reports, by their numbers.
void check_inverted_quads(const Mesh& quads, const QR::Extraction_report& report)
{
  std::vector<std::size_t> inverted;
  std::size_t i = 0;
  for(const auto f : quads.faces()) {
    std::array<std::array<double, 3>, 4> q;
    std::size_t k = 0;
    for(const auto v : CGAL::vertices_around_face(quads.halfedge(f), quads))
      q[k++] = {quads.point(v).x(), quads.point(v).y(), quads.point(v).z()};
    if(is_inverted_in_rationals(q))
      inverted.push_back(i);
    ++i;
  }
  CHECK_EQUAL(report.number_of_inverted_quads, inverted.size());
  inverted.resize((std::min)(inverted.size(), std::size_t(10)));
  CHECK(report.first_inverted_quads == inverted);
}

void test_reports_on_inverted_quads()
{
  Grid_map map(surfaces::disc(1, 1), 6, 6);
  std::mt19937 random(2);
  for(const double shift : {0., 1e-3, 0.9, 3.}) {
    for(const auto v : map.mesh.vertices()) {
      const auto noise = [&] { return shift * (double(random() % 1000) / 500 - 1); };
      const Point_3 p = map.mesh.point(v);
      map.mesh.point(v) = Point_3(p.x() + noise(), p.y() + noise(), p.z() + noise());
    }
    Mesh quads;
    const QR::Extraction_report report = QR::extract_quad_mesh(map.mesh, map.uv, quads);
    CHECK_IN(report.message, bool(report));
    check_inverted_quads(quads, report);
    CHECK_EQUAL(report.number_of_inverted_quads > 0, shift > 0.1);
    std::vector<Point_3> points;
    std::vector<std::vector<std::size_t> > polygons;
    const auto same = QR::extract_quad_soup(map.mesh, map.uv, points, polygons);
    CHECK_EQUAL(same.number_of_inverted_quads, report.number_of_inverted_quads);
  }
}

// --- surfaces whose quads are known --------------------------------------------------------------

// The same in other words: is it the expected mesh, up to the numbering?
void check_quads(const Mesh& quads, const QR::Extraction_report& report, const Mesh& expected)
{
  CHECK_EQUAL(QR::to_string(report.status), std::string("success"));
  CHECK_EQUAL(report.message, std::string());
  CHECK(CGAL::is_valid_polygon_mesh(quads));
  CHECK_EQUAL(report.number_of_faces, std::size_t(expected.number_of_faces()));
  CHECK_EQUAL(report.number_of_vertices, std::size_t(quads.number_of_vertices()));
  CHECK_EQUAL(report.number_of_other_polygons, std::size_t(0));
  CHECK_EQUAL(report.number_of_cut_cells, std::size_t(0));
  CHECK(are_isomorphic(quads, expected));
}

void test_surface(const Square_complex& complex, const int side, const int n,
                  const bool is_in_space)
{
  const Mesh expected = expected_quads(complex, side);
  Grid_map map(complex, side, n);
  for(const unsigned seed : {0u, 1u, 2u, 3u}) {
    if(seed > 0)
      map.perturb(seed, 0.4 * side / n, seed == 1 ? 3 : 30);
    CHECK(QR::is_seamless(map.mesh, map.uv));
    CHECK(QR::is_integer_grid_map(map.mesh, map.uv, parameters::align_border(true)));
    Mesh quads;
    const auto report = QR::extract_quad_mesh(map.mesh, map.uv, quads);
    check_quads(quads, report, expected);
    CHECK_EQUAL(report.area, double(complex.number_of_squares()) * side * side);
    if(is_in_space && seed == 0)
      CHECK(rounded_quads(quads) == rounded_quads(expected));
  }
}

void test_surfaces()
{
  const auto in_space = [](const Square_complex& complex) {
    for(const auto& [side, n] : {std::pair{2, 4}, {3, 4}, {3, 8}, {5, 2}, {4, 1}})
      test_surface(complex, side, n, true);
  };
  in_space(surfaces::box(1, 1, 1));
  in_space(surfaces::box(2, 1, 3));
  in_space(surfaces::notched_cube());
  in_space(surfaces::double_torus());
  in_space(surfaces::box_with_holes());
  in_space(surfaces::disc(3, 2));
  const auto glued = [](const Square_complex& complex) {
    for(const auto& [side, n] : {std::pair{3, 4}, {3, 8}, {5, 2}})
      test_surface(complex, side, n, false);
  };
  glued(surfaces::torus(1, 2));
  glued(surfaces::genus_2()); // with a cone of 1080 degrees, around which the rotations cancel
  glued(surfaces::tetrahedron());
  glued(surfaces::cylinder(2, 3));
  glued(surfaces::pair_of_pants());
  glued(surfaces::two_islands());
  for(const int quarter_turns : {1, 2, 3, 5, 8})
    glued(surfaces::cone_ring(quarter_turns));
  Square_complex scattered = surfaces::double_torus(); // each square with a chart of its own
  surfaces::scatter_charts(scattered);
  in_space(scattered);
  Square_complex parts = surfaces::box(1, 1, 1);
  parts.append(surfaces::disc(2, 2));
  parts.append(surfaces::double_torus());
  in_space(parts);
}

// --- cones between the lines of the grid ---------------------------------------------------------

// A quarter of the corners of all cells is the area; the cell around a cone of index i has 4 - i.
void check_cells_around_cones(const Grid_map& map, const std::map<int, int>& expected_degrees)
{
  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t> > polygons;
  const auto report = QR::extract_quad_soup(map.mesh, map.uv, points, polygons);
  CHECK(bool(report));
  std::map<int, int> degrees;
  double corners = 0;
  for(const auto& polygon : polygons) {
    corners += double(polygon.size());
    if(polygon.size() != 4)
      ++degrees[int(polygon.size())];
  }
  CHECK(degrees == expected_degrees);
  CHECK_EQUAL(corners, 4 * report.area);
  CHECK_EQUAL(report.number_of_faces, polygons.size());
  CHECK_EQUAL(report.number_of_vertices, points.size());
  int number = 0;
  for(const auto& [degree, n] : expected_degrees)
    number += n;
  CHECK_EQUAL(report.number_of_other_polygons, std::size_t(number));
  CHECK_EQUAL(report.number_of_cones_in_cells, std::size_t(number));

  std::vector<std::array<std::size_t, 4> > quads(1);
  const auto refusal = QR::extract_quad_soup(map.mesh, map.uv, points, quads);
  CHECK(refusal.status == Status::NOT_INTEGER);
  CHECK_EQUAL(quads.size(), std::size_t(1));
}

void test_half_integer_cones()
{
  Grid_map box(surfaces::box(1, 2, 1), 3, 4);
  box.shift(0.5, 0.5);
  CHECK(QR::is_seamless(box.mesh, box.uv) && !QR::is_integer_grid_map(box.mesh, box.uv));
  const auto measure = QR::measure_integer_grid(box.mesh, box.uv);
  CHECK_EQUAL(measure.number_of_half_integer_cones, std::size_t(8));
  CHECK_EQUAL(measure.number_of_noninteger_cones, std::size_t(8));
  CHECK_EQUAL(measure.number_of_noninteger_cuts, std::size_t(0));
  CHECK_EQUAL(measure.cone_distance, 0.5);
  check_cells_around_cones(box, {{3, 8}});
  Mesh quads;
  CHECK(bool(QR::extract_quad_mesh(box.mesh, box.uv, quads)));
  CHECK(CGAL::is_valid_polygon_mesh(quads));
  CHECK_EQUAL(euler_characteristic(quads), 2);
  const auto doubled = [](const Grid_map& map) {
    Mesh result;
    CHECK(bool(QR::extract_quad_mesh(map.mesh, map.uv, result, parameters::grid_scale(2))));
    return result;
  };
  CHECK(are_isomorphic(doubled(box), expected_quads(surfaces::box(1, 2, 1), 6)));

  Grid_map notched(surfaces::notched_cube(), 3, 4);
  notched.shift(0.5, 0.5);
  check_cells_around_cones(notched, {{3, 11}, {5, 3}}); // corners, and the ends of the inner edges

  Grid_map pillow(surfaces::tetrahedron(), 3, 4);
  pillow.shift(0.5, 0.5);
  check_cells_around_cones(pillow, {{2, 4}});
  Mesh two_gons;
  const auto report = QR::extract_quad_mesh(pillow.mesh, pillow.uv, two_gons);
  CHECK(report.status == Status::NO_FACE_GRAPH);
  CHECK(two_gons.is_empty());
  CHECK(are_isomorphic(doubled(pillow), expected_quads(surfaces::tetrahedron(), 6)));
  pillow.shift(0.5, 0); // cones on lines of the grid
  const auto on_line = QR::extract_quad_mesh(pillow.mesh, pillow.uv, two_gons);
  CHECK(on_line.status == Status::NOT_INTEGER);
  CHECK(on_line.message.find("vertex") != std::string::npos);
  CHECK(are_isomorphic(doubled(pillow), expected_quads(surfaces::tetrahedron(), 6)));

  Grid_map genus_2(surfaces::genus_2(), 3, 4); // whose cone of 1080 degrees can be anywhere
  genus_2.shift(0.25, 0.125);
  check_cells_around_cones(genus_2, {{12, 1}});
}

// --- results that are no face graph --------------------------------------------------------------

void test_loops()
{
  std::string message;
  const auto status = [&](const Square_complex& complex, const int side, const std::size_t quads) {
    const Grid_map map(complex, side, 4);
    Mesh mesh;
    std::vector<Point_3> points;
    std::vector<std::array<int, 4> > polygons;
    CHECK(bool(QR::extract_quad_soup(map.mesh, map.uv, points, polygons)));
    CHECK_EQUAL(polygons.size(), quads);
    const auto report = QR::extract_quad_mesh(map.mesh, map.uv, mesh);
    CHECK(bool(report) != mesh.is_empty());
    message = report.message;
    return report.status;
  };
  CHECK(status(surfaces::torus(1, 1), 1, 1) == Status::NO_FACE_GRAPH); // two loops at one vertex
  CHECK(status(surfaces::torus(1, 1), 2, 4) == Status::NO_FACE_GRAPH); // double edges
  CHECK_IN(message, message.find("scale the map up") != message.npos);
  CHECK(status(surfaces::torus(1, 1), 3, 9) == Status::SUCCESS);
  CHECK(status(surfaces::cone_ring(1), 1, 3) == Status::NO_FACE_GRAPH);
  CHECK(status(surfaces::cylinder(1, 1), 3, 9) == Status::SUCCESS);
  CHECK(status(surfaces::tetrahedron(), 1, 2) == Status::SUCCESS); // a pillow of two quads
}

// --- borders beside the grid, holes, and faces that are not positive -----------------------------

using Polygon = std::vector<std::array<Exact_rational, 2> >;

// The part of a convex polygon where sign * (component - value) is positive.
Polygon clipped(const Polygon& polygon, const std::size_t c, const int sign, const int value)
{
  Polygon result;
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Exact_rational da(sign * (a[c] - value)), db(sign * (b[c] - value));
    if(da > 0)
      result.push_back(a);
    if((da > 0) != (db > 0) && da != db) {
      const Exact_rational t(da / (da - db));
      result.push_back({Exact_rational(a[0] + t * (b[0] - a[0])),
                        Exact_rational(a[1] + t * (b[1] - a[1]))});
    }
  }
  return result;
}

Exact_rational twice_area(const Polygon& p)
{
  Exact_rational sum(0);
  for(std::size_t i = 0; i < p.size(); ++i) {
    const auto &a = p[i], &b = p[(i + 1) % p.size()];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum;
}

// In a single chart without folds: the cells that the faces cover, by their lower left corners.
std::set<std::array<int, 2> > covered_cells(const Grid_map& map)
{
  std::map<std::array<int, 2>, Exact_rational> areas;
  for(const auto f : map.mesh.faces()) {
    const Halfedge h = map.mesh.halfedge(f);
    Polygon triangle;
    double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
    for(const Halfedge g : {h, map.mesh.next(h), map.mesh.prev(h)}) {
      const Point_2 p = map.uv[g];
      triangle.push_back({Exact_rational(p.x()), Exact_rational(p.y())});
      for(int c = 0; c < 2; ++c) {
        low[c] = (std::min)(low[c], p[c]);
        high[c] = (std::max)(high[c], p[c]);
      }
    }
    for(int x = int(std::floor(low[0])); x < high[0]; ++x)
      for(int y = int(std::floor(low[1])); y < high[1]; ++y)
      {
        const Polygon column = clipped(clipped(triangle, 0, 1, x), 0, -1, x + 1);
        areas[{x, y}] += twice_area(clipped(clipped(column, 1, 1, y), 1, -1, y + 1));
      }
  }
  std::set<std::array<int, 2> > result;
  for(const auto& [cell, area] : areas)
    if(area == 2)
      result.insert(cell);
  return result;
}

void put_points_in_domain(Grid_map& map)
{
  for(const auto h : map.mesh.halfedges())
    if(!map.mesh.is_border(h))
      map.mesh.point(map.mesh.target(h)) = Point_3(map.uv[h].x(), map.uv[h].y(), 0);
}

// Each face gets a chart of its own.
void scatter_faces(Grid_map& map, std::mt19937_64& random)
{
  for(const auto f : map.mesh.faces()) {
    const auto turns = random() % 4;
    const Kernel::Vector_2 shift(double(random() % 9), double(random() % 9));
    for(const Halfedge h : CGAL::halfedges_around_face(map.mesh.halfedge(f), map.mesh)) {
      for(auto k = turns; k > 0; --k)
        map.uv[h] = Point_2(-map.uv[h].y(), map.uv[h].x());
      map.uv[h] = map.uv[h] + shift;
    }
  }
}

// Cells of a flat map, by its points in space, which are those of the domain.
std::set<std::array<int, 2> > extracted_cells(const Grid_map& map, const bool allow_holes,
                                              QR::Extraction_report& report)
{
  Mesh quads;
  report = QR::extract_quad_mesh(map.mesh, map.uv, quads, parameters::allow_holes(allow_holes));
  CHECK(CGAL::is_valid_polygon_mesh(quads));
  std::set<std::array<int, 2> > result;
  for(const auto& corners : rounded_quads(quads)) {
    CHECK_EQUAL(corners.size(), std::size_t(4));
    result.insert({int(corners[0][0] / 1000000), int(corners[0][1] / 1000000)});
    CHECK(corners[2][0] == corners[0][0] + 1000000 && corners[2][1] == corners[0][1] + 1000000);
  }
  CHECK_EQUAL(result.size(), std::size_t(quads.number_of_faces()));
  return result;
}

void remove_faces(Mesh& mesh, std::mt19937_64& random, const unsigned one_in)
{
  std::vector<Mesh::Face_index> removed;
  for(const auto f : mesh.faces())
    if(random() % one_in == 0)
      removed.push_back(f);
  for(const auto f : removed)
    CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  mesh.collect_garbage();
}

void test_borders()
{
  std::size_t kept = 0, cut = 0, inside = 0;
  for(unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937_64 random(seed);
    Grid_map map(surfaces::disc(3, 3), 2 + int(seed % 3), 8);
    map.perturb(seed, 0.1, seed % 2 == 0 ? 4 : 30);
    if(seed % 4 == 0)
      map.shift(0.25, 0.125);
    remove_faces(map.mesh, random, seed < 30 ? 40 : 200);
    QR::Extraction_report report;
    const auto expected = covered_cells(map);
    put_points_in_domain(map);
    if(seed % 3 == 0)
      scatter_faces(map, random);
    CHECK(expected == extracted_cells(map, false, report));
    CHECK(bool(report) != expected.empty());
    kept += expected.size();
    cut += report.number_of_cut_cells;
    inside += report.number_of_unaligned_border_edges;
  }
  CHECK(kept > 500 && cut > 500 && inside > 1000);
  slits::check_all();
  slits::check_cut_surfaces();
}

// A corner is moved across the opposite edge; what remains positive is as if the others were holes.
void test_flips()
{
  std::size_t flips = 0, kept = 0;
  for(unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937_64 random(seed);
    Grid_map map(surfaces::disc(3, 3), 3, 8);
    map.perturb(seed, 0.1, seed % 2 == 0 ? 4 : 30);
    const auto seams = QR::seam_transitions(map.mesh, map.uv);
    for(int i = 0; i < int(seed % 5) + 1; ++i) {
      const Vertex v(Mesh::size_type(random() % map.mesh.number_of_vertices()));
      if(!CGAL::is_border(v, map.mesh))
        map.move_vertex(seams, map.mesh.halfedge(v), Kernel::Vector_2(0.5, 0.25));
    }
    std::vector<std::size_t> expected_faces;
    for(const auto f : map.mesh.faces())
      if(!map.is_positive(map.mesh.halfedge(f)))
        expected_faces.push_back(std::size_t(f));
    put_points_in_domain(map);
    QR::Extraction_report report;
    const auto without_holes = extracted_cells(map, false, report);
    CHECK(expected_faces == report.nonpositive_faces);
    CHECK_EQUAL(without_holes.empty(), !expected_faces.empty());
    CHECK(report.status == (expected_faces.empty() ? Status::SUCCESS : Status::NOT_POSITIVE));
    const auto cells = extracted_cells(map, true, report);
    CHECK(bool(report));
    flips += expected_faces.size();
    kept += cells.size();
    for(const std::size_t f : expected_faces)
      CGAL::Euler::remove_face(map.mesh.halfedge(Mesh::Face_index(Mesh::size_type(f))), map.mesh);
    map.mesh.collect_garbage();
    CHECK(cells == extracted_cells(map, false, report)); // faces around the holes may overlap
  }
  CHECK(flips > 40 && kept > 1000);
}

template <typename NamedParameters>
void check_refusal(const Grid_map& map, const Status expected, const std::string& word,
                   const NamedParameters& np)
{
  Mesh quads;
  quads.add_vertex(Point_3(1, 2, 3));
  std::vector<Point_3> points(1);
  std::vector<std::vector<std::size_t> > polygons(2);
  const auto report = QR::extract_quad_mesh(map.mesh, map.uv, quads, np);
  const auto soup = QR::extract_quad_soup(map.mesh, map.uv, points, polygons, np);
  CHECK_EQUAL(QR::to_string(report.status), std::string(QR::to_string(expected)));
  CHECK(soup.status == report.status && soup.message == report.message);
  if(!CHECK(report.message.find(word) != std::string::npos))
    std::cerr << report.message << std::endl;
  CHECK(quads.number_of_vertices() == 1 && quads.number_of_faces() == 0);
  CHECK(points.size() == 1 && polygons.size() == 2);
  CHECK(!report);
}

// Vertices moved across opposite edges come back in a copy of the map; the map itself stays.
void test_repair()
{
  std::size_t repaired = 0;
  Square_complex box = surfaces::box(1, 2, 1);
  surfaces::mark_creases(box);
  for(const auto& [complex, side] : {std::pair{box, 3}, {surfaces::disc(3, 3), 5},
                                     {surfaces::genus_2(), 4}, {surfaces::tetrahedron(), 5}})
    for(unsigned seed = 1; seed <= 5; ++seed) {
      std::mt19937_64 random(seed);
      Grid_map map(complex, side, 8);
      map.perturb(seed, 0.1, seed % 2 == 0 ? 4 : 30);
      const auto seams = QR::seam_transitions(map.mesh, map.uv);
      const QR::Isocurve_tracer<Mesh> tracer(map.mesh, map.uv);
      for(int i = 0; i < 3; ++i) {
        const Vertex v(Mesh::size_type(random() % map.mesh.number_of_vertices()));
        if(!CGAL::is_border(v, map.mesh) && !tracer.is_singular(v) && !map.is_on_feature(v))
          map.move_vertex(seams, map.mesh.halfedge(v), Kernel::Vector_2(1, 0.75));
      }
      std::size_t flips = 0;
      for(const auto f : map.mesh.faces())
        flips += map.is_positive(map.mesh.halfedge(f)) ? 0 : 1;
      Mesh quads;
      const auto options = parameters::edge_is_constrained_map(map.is_feature);
      const auto refusal = QR::extract_quad_mesh(map.mesh, map.uv, quads, options);
      CHECK_EQUAL(refusal.nonpositive_faces.size(), flips);
      CHECK_EQUAL(quads.is_empty(), flips > 0);
      quads.clear();
      auto is_feature = quads.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
      const auto repair = QR::repair_integer_grid(map.mesh, map.uv, options);
      CHECK_IN(repair.message, bool(repair));
      CHECK_EQUAL(repair.run.number_of_repaired_flips, flips);
      CHECK(repair.remaining_flips.empty() && repair.lost_faces.empty());
      const auto report =
        QR::extract_quad_mesh(map.mesh, map.uv, quads, options,
                              parameters::edge_is_constrained_map(is_feature));
      check_quads(quads, report, expected_quads(complex, side));
      CHECK(report.nonpositive_faces.empty());
      CHECK_EQUAL(report.number_of_unaligned_features, std::size_t(0));
      repaired += flips;
    }
  CHECK(repaired > 50);

  Grid_map map(surfaces::box(1, 1, 1), 3, 4); // a flip, and integers that are none
  const auto seams = QR::seam_transitions(map.mesh, map.uv);
  const QR::Isocurve_tracer<Mesh> tracer(map.mesh, map.uv);
  Vertex v(0);
  while(tracer.is_singular(v) || !map.is_positive_around(v))
    ++v;
  map.move_vertex(seams, map.mesh.halfedge(v), Kernel::Vector_2(2, 1.5));
  check_refusal(map, Status::NOT_POSITIVE, "repair", CGAL::parameters::default_values());
  map.shift(0.25, 0.125);
  const std::vector<Point_2> before(map.uv.begin(), map.uv.end());
  const auto repair = QR::repair_integer_grid(map.mesh, map.uv);
  CHECK_EQUAL(QR::to_string(repair.status), std::string("not integer"));
  CHECK_IN(repair.message, repair.message.find("integer") != std::string::npos);
  CHECK(std::equal(before.begin(), before.end(), map.uv.begin()));
}

// Maps of a mixed-integer solver. Untangling turns some of the folds into cones, which are to be
// points of the grid, too; and a cone of 450 degrees in a fold is not to become one of 90, for
// which another vertex gets 720. Then there are quads only, as many as the area says.
void test_untangling()
{
  struct Map { std::string name; std::size_t flips, quads; };
  const std::vector<Map> maps{{"qex_duck_miq_4.obj", 18, 1073}, {"qex_fandisk.obj", 9, 897}};
  for(const auto& file : test_data::further_files("uv", ".obj"))
    for(const Map& map : maps) {
      if(file.filename() != map.name)
        continue;
      Mesh mesh, quads;
      UV_map uv = square_complex::uv_map(mesh);
      CHECK(QR::IO::read_OBJ(file.string(), mesh, uv));
      CHECK(bool(QR::snap_to_seamless(mesh, uv, parameters::integer_grid(true))));
      const auto refusal = QR::extract_quad_mesh(mesh, uv, quads);
      CHECK_EQUAL(refusal.nonpositive_faces.size(), map.flips);
      std::vector<Point_3> points;
      std::vector<std::vector<std::size_t> > soup;
      const auto repair =
        QR::repair_integer_grid(mesh, uv, parameters::repair_flips(QR::Flip_repair::UNTANGLE));
      CHECK_IN(repair.message, bool(repair));
      CHECK_EQUAL(repair.run.number_of_repaired_flips, map.flips);
      const auto report = QR::extract_quad_soup(mesh, uv, points, soup);
      CHECK_EQUAL(QR::to_string(report.status), std::string("success"));
      CHECK_EQUAL(report.number_of_faces, map.quads);
      CHECK_EQUAL(report.number_of_other_polygons, std::size_t(0));
    }
}

// --- what is known of each vertex and edge -------------------------------------------------------

void test_property_maps()
{
  const Square_complex complex = [] {
    Square_complex box = surfaces::box(1, 2, 1);
    surfaces::mark_creases(box);
    return box;
  }();
  Grid_map map(complex, 3, 8);
  map.perturb(1, 0.1, 30);
  Mesh quads;
  using Location = std::pair<Mesh::Face_index, std::array<double, 3> >;
  auto location = quads.add_property_map<Vertex, Location>("v:location").first;
  auto cone = quads.add_property_map<Vertex, int>("v:cone", 7).first;
  auto is_feature = quads.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  std::map<Vertex, Point_3> points;
  const auto report = QR::extract_quad_mesh(
    map.mesh, map.uv, quads, parameters::edge_is_constrained_map(map.is_feature),
    parameters::vertex_location_map(location).cone_index_map(cone)
      .edge_is_constrained_map(is_feature)
      .vertex_point_map(boost::make_assoc_property_map(points)));
  CHECK(bool(report));
  CHECK_EQUAL(points.size(), std::size_t(quads.number_of_vertices()));
  std::map<int, int> cones;
  double off_grid = 0, off_place = 0;
  for(const auto v : quads.vertices()) {
    ++cones[cone[v]];
    CHECK_EQUAL(cone[v], 4 - int(quads.degree(v)));
    const auto& [f, w] = location[v];
    const Halfedge h = map.mesh.halfedge(f);
    double u[2] = {0, 0}, x[3] = {0, 0, 0};
    int k = 0;
    for(const Halfedge g : {map.mesh.prev(h), h, map.mesh.next(h)}) { // source, target, third
      CHECK(w[std::size_t(k)] >= 0 && w[std::size_t(k)] <= 1);
      for(int c = 0; c < 2; ++c)
        u[c] += w[std::size_t(k)] * map.uv[g][c];
      for(int c = 0; c < 3; ++c)
        x[c] += w[std::size_t(k)] * map.mesh.point(map.mesh.target(g))[c];
      ++k;
    }
    for(int c = 0; c < 2; ++c)
      off_grid = (std::max)(off_grid, std::abs(u[c] - std::round(u[c])));
    for(int c = 0; c < 3; ++c)
      off_place = (std::max)(off_place, std::abs(points[v][c] - x[c]));
  }
  CHECK(off_grid < 1e-12 && off_place < 1e-12);
  CHECK((cones == std::map<int, int>{{0, int(quads.number_of_vertices()) - 8}, {1, 8}}));
  // 8 edges of length 1, and 4 of length 2, in chains between the cones
  std::size_t number = 0;
  std::map<Vertex, int> ends;
  for(const auto e : quads.edges())
    if(is_feature[e]) {
      ++number;
      ++ends[quads.vertex(e, 0)];
      ++ends[quads.vertex(e, 1)];
    }
  CHECK_EQUAL(number, std::size_t(3 * (8 + 2 * 4)));
  for(const auto& [v, degree] : ends)
    CHECK_EQUAL(degree, cone[v] == 1 ? 3 : 2);
  CHECK_EQUAL(report.number_of_unaligned_features, std::size_t(0));
  map.shift(0.5, 0.5);
  Mesh others;
  CHECK_EQUAL(QR::extract_quad_mesh(map.mesh, map.uv, others,
                                    parameters::edge_is_constrained_map(map.is_feature))
                .number_of_unaligned_features, std::size_t(8 * (8 + 2 * 4)));
}

// --- the same in all forms -----------------------------------------------------------------------

// Vertices and faces in a random order, and faces beginning anywhere.
Mesh renumbered(const Mesh& mesh, const UV_map& original_uv, const unsigned seed, UV_map& uv)
{
  std::mt19937_64 random(seed);
  Mesh result;
  std::vector<Vertex> order(mesh.vertices().begin(), mesh.vertices().end());
  std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  std::shuffle(order.begin(), order.end(), random);
  std::shuffle(faces.begin(), faces.end(), random);
  std::map<Vertex, Vertex> image;
  for(const Vertex v : order)
    image[v] = result.add_vertex(mesh.point(v));
  uv = square_complex::uv_map(result);
  for(const auto f : faces) {
    Halfedge h = mesh.halfedge(f);
    for(auto k = random() % 3; k > 0; --k)
      h = mesh.next(h);
    std::vector<Vertex> corners;
    for(const auto v : CGAL::vertices_around_face(h, mesh))
      corners.push_back(image.at(v));
    Halfedge g = result.halfedge(result.add_face(corners));
    while(result.target(g) != image.at(mesh.target(h)))
      g = result.next(g);
    for(int i = 0; i < 3; ++i, h = mesh.next(h), g = result.next(g))
      uv[g] = original_uv[h];
  }
  return result;
}

bool are_identical(const Mesh& a, const Mesh& b)
{
  if(a.number_of_vertices() != b.number_of_vertices() ||
     a.number_of_halfedges() != b.number_of_halfedges() ||
     a.number_of_faces() != b.number_of_faces())
    return false;
  for(const auto h : a.halfedges())
    if(a.next(h) != b.next(h) || a.target(h) != b.target(h) || a.face(h) != b.face(h))
      return false;
  for(const auto v : a.vertices())
    if(std::memcmp(&a.point(v), &b.point(v), sizeof(Point_3)) != 0)
      return false;
  return true;
}

// Whether two results are equal but for their numbering. Points tell which of several parts is
// which, and that no part is turned.
void check_alike(const Mesh& quads, const Mesh& others)
{
  CHECK(are_isomorphic(quads, others));
  CHECK(rounded_quads(quads) == rounded_quads(others));
}

template <typename UVMap>
void check_forms(const Mesh& mesh, const UVMap& uv, const Mesh& quads)
{
  Mesh parallel;
  CHECK(bool(QR::extract_quad_mesh<CGAL::Parallel_if_available_tag>(mesh, uv, parallel)));
  CHECK(are_identical(quads, parallel));

  const test_meshes::Polyhedron_copy<Kernel> copy(mesh);
  CGAL::Polyhedron_3<Kernel> polyhedron;
  CHECK(bool(QR::extract_quad_mesh(copy.polyhedron, copy.uv, polyhedron)));
  CHECK(polyhedron.is_valid());
  Mesh from_polyhedron;
  CGAL::copy_face_graph(polyhedron, from_polyhedron);
  check_alike(quads, from_polyhedron);

  for(unsigned seed = 1; seed <= 3; ++seed) {
    UV_map other_uv;
    const Mesh other = renumbered(mesh, uv, seed, other_uv);
    Mesh result;
    CHECK(bool(QR::extract_quad_mesh(other, other_uv, result)));
    check_alike(quads, result);
  }
}

// Maps of other programs, made integer-grid maps of about this many quads where they have none.
void test_forms_of_files(const std::vector<std::filesystem::path>& files, const double wanted)
{
  std::size_t compared = 0;
  for(const auto& file : files) {
    Mesh mesh;
    UV_map uv = square_complex::uv_map(mesh);
    CHECK(QR::IO::read_OBJ(file.string(), mesh, uv));
    const double scale = std::sqrt(wanted / QR::measure_integer_grid(mesh, uv).area);
    const auto options =
      parameters::integer_grid(true).rounding_tolerance(1e9).grid_scale(scale).repair_flips(true);
    Mesh quads;
    if(!QR::snap_to_seamless(mesh, uv, options) || !QR::extract_quad_mesh(mesh, uv, quads))
      continue;
    check_forms(mesh, uv, quads);
    ++compared;
  }
  std::cout << compared << " of " << files.size() << " files compared in all forms, at " << wanted
            << " quads" << std::endl;
  CHECK(5 * compared > 2 * files.size()); // the others have faces that rounding turns over
}

// The small ones, or all of them at three sizes: that takes minutes.
void test_forms_of_files()
{
  const bool is_long = test_data::are_tests_long();
  std::vector<std::filesystem::path> files = test_data::package_files();
  for(const auto& file : test_data::further_files("uv", ".obj"))
    if(is_long || std::filesystem::file_size(file) < 120000)
      files.push_back(file);
  for(const double wanted : is_long ? std::vector<double>{500, 5000, 50000}
                                    : std::vector<double>{300})
    test_forms_of_files(files, wanted);
}

void test_forms()
{
  Grid_map map(surfaces::box(2, 1, 3), 13, 16);
  map.perturb(5, 0.3, 30);
  Mesh quads;
  CHECK(bool(QR::extract_quad_mesh(map.mesh, map.uv, quads)));
  check_forms(map.mesh, map.uv, quads);
  CHECK(!are_isomorphic(quads, expected_quads(surfaces::box(1, 1, 5), 13))); // as many
#ifdef SEAMLESS_SNAPPING_TEST_OPENMESH
  open_mesh::check(map.mesh, map.uv);
#else
  checking::skip("meshes of OpenMesh, which the build system has not found");
#endif

  Mesh scaled; // the result is added to what is there
  CHECK(bool(QR::extract_quad_mesh(map.mesh, map.uv, scaled, parameters::grid_scale(2))));
  CHECK_EQUAL(scaled.number_of_faces(), 4 * quads.number_of_faces());
  CHECK(bool(QR::extract_quad_mesh(map.mesh, map.uv, scaled, parameters::grid_scale(4))));
  CHECK_EQUAL(scaled.number_of_faces(), 20 * quads.number_of_faces());
  CHECK(CGAL::is_valid_polygon_mesh(scaled));

  std::vector<Point_3> points(3);
  std::vector<std::vector<unsigned> > polygons;
  CHECK(bool(QR::extract_quad_soup(map.mesh, map.uv, points, polygons)));
  CHECK_EQUAL(points.size(), std::size_t(3 + quads.number_of_vertices()));
  Mesh from_soup;
  for(const Point_3& p : points)
    from_soup.add_vertex(p);
  for(const auto& polygon : polygons) {
    std::vector<Vertex> corners;
    for(const unsigned i : polygon)
      corners.emplace_back(i);
    from_soup.add_face(corners);
  }
  CHECK(rounded_quads(quads) == rounded_quads(from_soup));
}

// --- bad input -----------------------------------------------------------------------------------

void test_refusals()
{
  const auto none = CGAL::parameters::default_values();
  const auto fresh = [] { return std::make_unique<Grid_map>(surfaces::box(1, 1, 1), 3, 4); };
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  auto map = fresh();
  for(const double bad : {0., -1., infinity, nan})
    check_refusal(*map, Status::INVALID_ARGUMENT, "grid_scale", parameters::grid_scale(bad));
  check_refusal(*map, Status::INVALID_ARGUMENT, "power of two", parameters::grid_scale(1 + 1e-15));
  check_refusal(*map, Status::TOO_LARGE, "2^46", parameters::grid_scale(1e300));
  check_refusal(*map, Status::TOO_LARGE, "maximum_number", parameters::grid_scale(1 << 15));
  check_refusal(*map, Status::TOO_LARGE, "maximum_number", parameters::maximum_number(53));
  CHECK(bool(QR::extract_quad_mesh(map->mesh, map->uv, *std::make_unique<Mesh>(),
                                   parameters::maximum_number(54))));
  check_refusal(*map, Status::NOT_INTEGER, "integer", parameters::grid_scale(0.25));
  check_refusal(*map, Status::TOO_LARGE, "; shrink the map", parameters::grid_scale(1 << 20)
                                                               .maximum_number(~std::size_t(0)));
  for(const double bad : {infinity, -infinity, nan}) {
    Point_3& p = map->mesh.point(Mesh::Vertex_index(3));
    const Point_3 old = p;
    p = Point_3(old.x(), bad, old.z());
    check_refusal(*map, Status::NOT_FINITE, "vertex 3 has", none);
    p = old;
  }
  const Halfedge h = map->mesh.halfedge(Mesh::Face_index(5));
  const Point_2 good = map->at(h);
  for(const double bad : {infinity, -infinity, nan, 1e301}) {
    map->at(h) = Point_2(bad, 0);
    check_refusal(*map, Status::NOT_FINITE, "face 5", none);
  }
  map->at(h) = Point_2(good.x() + 1e-9, good.y());
  check_refusal(*map, Status::NOT_SEAMLESS, "snap_to_seamless", none);
  map->at(h) = Point_2(std::nextafter(good.x(), 9), good.y());
  check_refusal(*map, Status::NOT_SEAMLESS, "snap_to_seamless", none);
  map = fresh();
  map->shift(0.25, 0); // translations across cuts with rotations
  check_refusal(*map, Status::NOT_INTEGER, "edge from vertex", none);
  map = fresh();
  map->shift(0, 1e15);
  check_refusal(*map, Status::TOO_LARGE, "2^46", none);
  const auto snapped = QR::snap_to_seamless(map->mesh, map->uv, parameters::integer_grid(true));
  CHECK(snapped.status == QR::Outcome::NOT_REPRESENTABLE);
  CHECK(snapped.message.find("beyond 2^46") != std::string::npos);

  Grid_map pillow(surfaces::tetrahedron(), 1, 4); // too small for a quad
  for(const auto g : pillow.mesh.halfedges())
    pillow.uv[g] = Point_2(pillow.uv[g].x() + 0.5, pillow.uv[g].y() + 0.5);
  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t> > polygons;
  const auto report = QR::extract_quad_soup(pillow.mesh, pillow.uv, points, polygons);
  CHECK(bool(report)); // four 2-gons
  CHECK_EQUAL(polygons.size(), std::size_t(4));
  Grid_map disc(surfaces::disc(1, 1), 1, 4);
  disc.shift(0.5, 0.5);
  check_refusal(disc, Status::TOO_COARSE, "grid_scale", none);

  // A sliver that crosses a great many lines without any area.
  Grid_map sliver(surfaces::disc(1, 1), 1, 1);
  for(const auto g : sliver.mesh.halfedges())
    if(!sliver.mesh.is_border(g))
      sliver.uv[g] = Point_2(std::ldexp(sliver.uv[g].x(), -20) + std::ldexp(sliver.uv[g].y(), 32),
                             std::ldexp(sliver.uv[g].y(), 32));
  check_refusal(sliver, Status::TOO_LARGE, "would cross", none);
}

// --- making integer-grid maps --------------------------------------------------------------------

void multiply(Grid_map& map, const double factor, const double noise)
{
  std::mt19937_64 random(7);
  const auto number = [&] { return noise * (double(random() % 2001) / 1000 - 1); };
  for(const auto h : map.mesh.halfedges())
    if(!map.mesh.is_border(h))
      map.uv[h] = Point_2(factor * map.uv[h].x() + number(), factor * map.uv[h].y() + number());
}

// Noise, and a scale that makes no translation an integer, are undone.
void test_snapping(const Square_complex& complex, const int side, const int n)
{
  for(const double factor : {1., 1. / 3, 2.7182818})
    for(const double noise : {0., 1e-8}) {
      Grid_map map(complex, side, n);
      map.perturb(3, 0.3 * side / n, 20);
      multiply(map, factor, noise);
      const auto report = QR::snap_to_seamless(
        map.mesh, map.uv,
        parameters::integer_grid(true).grid_scale(1 / factor).align_border(true)
          .edge_is_constrained_map(map.is_feature));
      CHECK(bool(report));
      CHECK(report.largest_rounding < 1e-6 && report.largest_change < 1e-6);
      CHECK(report.lost_faces.empty() && report.remaining_flips.empty());
      CHECK(QR::is_seamless(map.mesh, map.uv));
      CHECK(QR::is_integer_grid_map(map.mesh, map.uv,
                                    parameters::align_border(true)
                                      .edge_is_constrained_map(map.is_feature)));
      Mesh quads;
      const auto extraction = QR::extract_quad_mesh(map.mesh, map.uv, quads);
      check_quads(quads, extraction, expected_quads(complex, side));
    }
}

// Roundings as large as units: what comes out is an integer-grid map all the same.
void test_large_roundings(const Square_complex& complex, const int side, const int n)
{
  for(const double factor : {1.037, 0.83}) {
    Grid_map map(complex, side, n);
    map.perturb(3, 0.2 * side / n, 20);
    multiply(map, factor, 1e-9);
    const std::vector<Point_2> before(map.uv.begin(), map.uv.end());
    const auto refusal = QR::snap_to_seamless(map.mesh, map.uv,
                                              parameters::integer_grid(true).align_border(true));
    CHECK(refusal.status == QR::Outcome::NOT_INTEGER);
    CHECK(refusal.message.find("vert") != std::string::npos);
    CHECK(refusal.message.find("rounding_tolerance") != std::string::npos);
    CHECK(refusal.largest_rounding > 0.01);
    CHECK(std::equal(before.begin(), before.end(), map.uv.begin()));
    const auto report = QR::snap_to_seamless(
      map.mesh, map.uv,
      parameters::integer_grid(true).align_border(true).rounding_tolerance(10.));
    CHECK(bool(report));
    CHECK(report.largest_rounding > 0.01); // of others, it may be
    CHECK(QR::is_integer_grid_map(map.mesh, map.uv, parameters::align_border(true)));
    CHECK(report.lost_faces.empty());
    Mesh quads;
    const auto extraction = QR::extract_quad_mesh(map.mesh, map.uv, quads);
    CHECK(bool(extraction));
    CHECK_EQUAL(extraction.number_of_other_polygons, std::size_t(0));
    CHECK_EQUAL(extraction.number_of_cut_cells, std::size_t(0));
    CHECK_EQUAL(double(extraction.number_of_faces), extraction.area);
    CHECK_EQUAL(euler_characteristic(quads), euler_characteristic(map.mesh));
  }
}

// Where coordinates that are rounded independently turn over faces, integers are chosen that don't.
void test_integers_one_after_another(const std::string& name, const double number_of_quads)
{
  Mesh mesh;
  UV_map uv = square_complex::uv_map(mesh);
  CHECK(QR::IO::read_OBJ(test_data::package_file(name), mesh, uv));
  const double scale = std::sqrt(number_of_quads / QR::measure_integer_grid(mesh, uv).area);
  const auto report = QR::snap_to_seamless(
    mesh, uv, parameters::integer_grid(true).grid_scale(scale).rounding_tolerance(10.));
  CHECK_EQUAL(report.status, QR::Outcome::SNAPPED);
  CHECK_EQUAL(report.lost_faces.size(), std::size_t(0));
  const auto measure = QR::measure_integer_grid(mesh, uv);
  CHECK_EQUAL(measure.number_of_nonpositive_faces, std::size_t(0));
  CHECK(std::abs(measure.area - number_of_quads) < 0.1 * number_of_quads);
}

// Where repairs of faces that roundings turn over make cones, these are points of the grid, too, so
// that the map is an integer-grid map, and stays as it is.
void test_cones_of_repairs()
{
  for(const auto& file : test_data::further_files("uv", ".obj")) {
    if(file.filename() != "wmtk_seamed_cup.obj")
      continue;
    Mesh mesh;
    UV_map uv = square_complex::uv_map(mesh);
    CHECK(QR::IO::read_OBJ(file.string(), mesh, uv));
    const auto np = parameters::integer_grid(true).rounding_tolerance(10.);
    const double scale = std::sqrt(5000 / QR::measure_integer_grid(mesh, uv).area);
    CHECK(bool(QR::snap_to_seamless(mesh, uv, np.grid_scale(scale))));
    CHECK(QR::is_integer_grid_map(mesh, uv));
    CHECK_EQUAL(QR::snap_to_seamless(mesh, uv, np).largest_change, 0.);
  }
}

// On coarse grids, some of them can't be: that is no success, unless faces stay flipped.
void test_cones_off_the_grid(const std::string& name, const double size)
{
  for(const auto& file : test_data::further_files("uv", ".obj")) {
    if(file.filename() != name)
      continue;
    Mesh mesh;
    UV_map uv = square_complex::uv_map(mesh);
    CHECK(QR::IO::read_OBJ(file.string(), mesh, uv));
    const auto untangle = parameters::repair_flips(QR::Flip_repair::UNTANGLE);
    const double extent = QR::snap_to_seamless(mesh, uv, untangle).extent;
    const std::vector<Point_2> before(uv.begin(), uv.end());
    const auto report = QR::snap_to_seamless(
      mesh, uv, untangle.integer_grid(true).grid_scale(size / extent).rounding_tolerance(10.)
                        .align_border(true));
    if(report.status == QR::Outcome::SNAPPED)
      CHECK_IN(name, QR::is_integer_grid_map(mesh, uv, parameters::align_border(true)));
    if(!report)
      CHECK_IN(name, std::equal(before.begin(), before.end(), uv.begin()) &&
                     report.message.find("scale the map up") != std::string::npos);
  }
}

// Equations that come one after another, against the system with all multipliers; among them one
// that follows from others, and one that holds by itself.
void test_range_space()
{
  constexpr Eigen::Index n = 30, m = 8;
  std::mt19937 random(29);
  std::uniform_real_distribution<double> number(-1, 1);
  Eigen::MatrixXd matrix = 2 * Eigen::MatrixXd::Identity(n, n), rows = Eigen::MatrixXd::Zero(m, n);
  Eigen::VectorXd rhs(n), values(m);
  for(Eigen::Index i = 0; i < n; ++i) {
    rhs[i] = number(random);
    if(i > 0)
      matrix(i, i - 1) = matrix(i - 1, i) = number(random);
  }
  for(Eigen::Index i = 0; i < m; ++i) {
    for(const Eigen::Index j : {3 * i, (7 * i + 1) % n})
      rows(i, j) += number(random);
    values[i] = number(random);
  }
  const Eigen::SparseMatrix<double> sparse = matrix.sparseView();
  internal::Sparse_cholesky<Eigen::SparseMatrix<double> > solver;
  std::vector<int> blocks;
  for(Eigen::Index i = 0; i < n; ++i)
    blocks.push_back(int(i % (n / 2)));
  solver.analyzePattern(sparse, blocks);
  solver.factorize(sparse);
  internal::Range_space_solver<decltype(solver)> minimum(solver, rhs);
  CHECK((matrix * minimum.solution() - rhs).norm() < 1e-12);
  const auto add = [&](const Eigen::VectorXd& row, const double value) {
    std::vector<std::pair<Eigen::Index, double> > terms;
    for(Eigen::Index j = 0; j < n; ++j)
      if(row[j] != 0)
        terms.emplace_back(j, row[j]);
    minimum.add(terms, value);
  };
  add(rows.row(0), rows.row(0).dot(minimum.solution()));
  CHECK((matrix * minimum.solution() - rhs).norm() < 1e-12);
  for(const Eigen::Index end : {3, 4, 8}) { // with those before
    for(Eigen::Index i = end == 3 ? 0 : end == 4 ? 3 : 4; i < end; ++i)
      add(rows.row(i), values[i]);
    add(rows.row(1) - 2 * rows.row(2), values[1] - 2 * values[2]);
    const Eigen::VectorXd x = minimum.solution();
    CHECK((rows.topRows(end) * x - values.head(end)).norm() < 1e-10);
    const Eigen::MatrixXd forces = rows.topRows(end).transpose();
    const Eigen::VectorXd rest = matrix * x - rhs;
    const Eigen::MatrixXd products = forces.transpose() * forces;
    CHECK((forces * products.ldlt().solve(forces.transpose() * rest) - rest).norm() < 1e-10);
  }
}

// Whatever is interrupted on the way to integers, the map is as before.
void test_interruptions()
{
  Mesh mesh;
  UV_map uv = square_complex::uv_map(mesh);
  CHECK(QR::IO::read_OBJ(test_data::package_file("genus2"), mesh, uv));
  const double scale = std::sqrt(300 / QR::measure_integer_grid(mesh, uv).area);
  const std::vector<Point_2> before(uv.begin(), uv.end());
  interruptions::test("genus2", [&](const auto& visitor) {
    std::copy(before.begin(), before.end(), uv.begin());
    return bool(QR::snap_to_seamless(
      mesh, uv, parameters::integer_grid(true).grid_scale(scale).rounding_tolerance(10.)
                  .repair_flips(QR::Flip_repair::UNTANGLE).visitor(visitor)));
  }, [&] { return std::equal(before.begin(), before.end(), uv.begin()); });
}

void test_integer_grids()
{
  test_integers_one_after_another("genus1", 400);
  test_integers_one_after_another("genus2", 500);
  test_integers_one_after_another("genus3", 800);
  test_cones_of_repairs();
  test_cones_off_the_grid("bd_cfip16_joint-hex.obj", 10);
  Square_complex box = surfaces::box(1, 2, 1);
  surfaces::mark_creases(box);
  for(const auto& [complex, n] : {std::pair{box, 8}, {surfaces::double_torus(), 4},
                                  {surfaces::genus_2(), 8}, {surfaces::tetrahedron(), 8},
                                  {surfaces::torus(1, 2), 8}, {surfaces::box_with_holes(), 8},
                                  {surfaces::cone_ring(5), 8}, {surfaces::pair_of_pants(), 8}}) {
    test_snapping(complex, 5, n);
    test_large_roundings(complex, 16, n);
  }
  Grid_map map(surfaces::box(1, 1, 1), 3, 4); // cones at half-integers
  map.shift(0.5, 0.5);
  const auto refusal = QR::snap_to_seamless(
    map.mesh, map.uv, parameters::integer_grid(true).rounding_tolerance(0.)); // nothing is moved
  CHECK(refusal.status == QR::Outcome::NOT_INTEGER);
  CHECK(refusal.largest_rounding >= 0.5);
  CHECK(refusal.message.find("grid_scale") != std::string::npos);
  for(const double tiny : {1e-300, 1e-3}) {
    const auto nothing = QR::snap_to_seamless(
      map.mesh, map.uv,
      parameters::integer_grid(true).grid_scale(tiny).rounding_tolerance(1.));
    CHECK_EQUAL(nothing.status, QR::Outcome::NOT_INTEGER);
    CHECK(nothing.message.find("no cell; scale the map up") != std::string::npos);
  }
  const auto report = QR::snap_to_seamless(map.mesh, map.uv,
                                           parameters::integer_grid(true).grid_scale(2));
  CHECK(bool(report));
  CHECK_EQUAL(report.largest_rounding, 0.);
  CHECK_EQUAL(report.largest_change, 0.);
  Mesh quads;
  const auto extraction = QR::extract_quad_mesh(map.mesh, map.uv, quads);
  check_quads(quads, extraction, expected_quads(surfaces::box(1, 1, 1), 6));
  const auto bad = QR::snap_to_seamless(map.mesh, map.uv, parameters::grid_scale(-1));
  CHECK(bad.status == QR::Outcome::INVALID_ARGUMENT);
}

int main()
{
  const Floating_point_traps traps; // for all functions that are called
  std::cout.precision(17);
  test_inverted_quads();
  test_reports_on_inverted_quads();
  test_surfaces();
  test_half_integer_cones();
  test_loops();
  test_borders();
  test_flips();
  test_repair();
  test_untangling();
  test_property_maps();
  test_forms();
  test_forms_of_files();
  test_refusals();
  test_range_space();
  test_integer_grids();
  test_interruptions();
  return report_checks();
}
