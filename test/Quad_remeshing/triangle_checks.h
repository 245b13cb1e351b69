#ifndef SEAMLESS_SNAPPING_TEST_TRIANGLE_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_TRIANGLE_CHECKS_H

// Triangle meshes out of integer-grid maps in lattice coordinates, against surfaces whose triangles
// are known, and against areas in rationals.

#include "checking.h"
#include "hexagonal_maps.h"
#include "quad_reference.h"
#include "random_complexes.h"
#include "test_meshes.h"

#include <CGAL/Quad_remeshing/extract_grid_mesh.h>
#include <CGAL/Quad_remeshing/repair_integer_grid.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace triangle_checks {

namespace QR = CGAL::Quad_remeshing;
using namespace hexagonal_maps;
using quad_reference::are_isomorphic;
using Face = Mesh::Face_index;
using Status = QR::Outcome;

// --- surfaces whose triangles are known ----------------------------------------------------------

// The triangles are those of `expected`, up to the numbering; vertices lie on lattice points of the
// map, and cones are told.
template <typename NamedParameters>
void check_triangles(const Mesh& mesh, const UV_map uv, const Mesh& expected,
                     const NamedParameters& np, const std::string& context)
{
  Mesh triangles;
  auto cones = triangles.add_property_map<Vertex, int>("v:cone", 77).first;
  using Location = std::pair<Face, std::array<double, 3> >;
  auto locations = triangles.add_property_map<Vertex, Location>("v:location").first;
  const auto report = QR::extract_triangle_mesh(
    mesh, uv, triangles, np, QR::parameters::cone_index_map(cones).vertex_location_map(locations));
  CHECK_IN(context + ": " + report.message, bool(report));
  CHECK_IN(context, CGAL::is_valid_polygon_mesh(triangles) && CGAL::is_triangle_mesh(triangles));
  CHECK_IN(context, report.area == double(expected.number_of_faces()));
  CHECK_IN(context, report.number_of_faces == expected.number_of_faces());
  CHECK_IN(context, report.number_of_vertices == expected.number_of_vertices());
  CHECK_IN(context, report.number_of_other_polygons == 0 && report.number_of_cut_cells == 0);
  CHECK_IN(context, are_isomorphic(triangles, expected));
  for(const Vertex v : triangles.vertices()) {
    CHECK_IN(context,
             cones[v] == (triangles.is_border(v) ? 0 : 6 - int(triangles.degree(v))));
    const auto& [f, weights] = locations[v];
    CHECK_IN(context, (std::min)({weights[0], weights[1], weights[2]}) >= 0);
    CHECK_IN(context, std::abs(weights[0] + weights[1] + weights[2] - 1) < 1e-12);
  }
}

// Lays the faces out so that the first vertex is a point of the lattice at any scale.
inline void unfold_from_first(const Mesh& mesh, UV_map uv)
{
  unfold(mesh, uv);
  Halfedge first = mesh.halfedge(*mesh.vertices().begin());
  if(mesh.is_border(first))
    first = mesh.prev(mesh.opposite(first));
  const Vector back = vector(uv[first], Kernel::Point_2(0, 0));
  for(const Halfedge h : mesh.halfedges())
    if(!mesh.is_border(h))
      uv[h] = moved(uv[h], back);
}

// Moves all inner vertices but cones a little along lines of the lattice, which go on to meet them,
// in coordinates that fill a number, so that sums of two don't fit.
template <int N>
void creep(const Mesh& mesh, UV_map uv, std::mt19937& random)
{
  std::map<Vertex, std::vector<int> > turns_before;
  for(const Vertex v : mesh.vertices()) {
    int k = 0;
    for(const Halfedge h : corners_in_turn(mesh, v)) {
      turns_before[v].push_back(k);
      k += is_interior(mesh, mesh.next(h)) ? turns<N>(mesh, uv, mesh.next(h)) : 0;
    }
  }
  for(const Halfedge h : mesh.halfedges())
    if(!mesh.is_border(h))
      uv[h] = moved(uv[h], {{1536, 1536}});
  for(const auto& [v, k] : turns_before) {
    const Vector d{{std::ldexp(int(random() % 9) - 4, -42), 0}};
    const std::vector<Halfedge> corners = corners_in_turn(mesh, v);
    if(!mesh.is_border(v) && mesh.degree(v) == 6)
      for(std::size_t i = 0; i < corners.size(); ++i)
        uv[corners[i]] = moved(uv[corners[i]], turned<N>(k[i], d));
  }
}

// The map of a subdivided mesh that is the lattice on the mesh before, warped.
template <int N>
void test_surface(const Mesh& coarse, const unsigned int levels, const std::string& name)
{
  Mesh mesh = subdivided(coarse, levels);
  const UV_map uv = uv_map(mesh);
  std::mt19937 random(levels);
  for(int i = 0; i < 4; ++i) {
    const std::string context = "triangles, " + name + ", N = " + std::to_string(N) + ", levels " +
                                std::to_string(levels) + ", warp " + std::to_string(i);
    unfold_from_first(mesh, uv);
    if(i == 3)
      creep<N>(mesh, uv, random);
    else if(i > 0 && CGAL::is_closed(mesh)) {
      warp<N>(mesh, uv, 0.125, random);
      const std::vector<int> orientations = signs(mesh, uv);
      CHECK_IN(context, std::count(orientations.begin(), orientations.end(), 1) ==
                          std::ptrdiff_t(orientations.size()));
    }
    const double unit = std::ldexp(1., -int(levels));
    const auto scaled = [&](const double s) { return symmetry<N>().grid_scale(s); };
    check_triangles(mesh, uv, coarse, scaled(unit), context);
    check_triangles(mesh, uv, subdivided(coarse, 1), scaled(2 * unit), context);
    check_triangles(mesh, uv, subdivided(coarse, 2), scaled(4 * unit), context);
    if(i == 3)
      continue; // which leaves no bits for a factor of 3
    Mesh three;
    const auto report = QR::extract_triangle_mesh(mesh, uv, three, scaled(3 * unit));
    CHECK_IN(context, bool(report) && three.number_of_faces() == 9 * coarse.number_of_faces());
    CHECK_IN(context, quad_reference::euler_characteristic(three) ==
                        quad_reference::euler_characteristic(coarse));
  }
}

// How many inner vertices have which valence, unless that is 6.
inline std::map<int, int> valences_of_cones(const Mesh& mesh)
{
  std::map<int, int> result;
  for(const Vertex v : mesh.vertices())
    if(!mesh.is_border(v) && mesh.degree(v) != 6)
      ++result[int(mesh.degree(v))];
  return result;
}

// Of a map that snapping has made integer: as many triangles as its area has.
template <typename NamedParameters>
void check_number(const Mesh& mesh, const UV_map uv, const NamedParameters& np,
                  const std::string& context)
{
  Rational number(0);
  for(const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    const Exact_vector a = exact_vector(uv[h], uv[mesh.next(h)]);
    const Exact_vector b = exact_vector(uv[h], uv[mesh.prev(h)]);
    number += a[0] * b[1] - a[1] * b[0];
  }
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  const auto report = QR::extract_triangle_soup(mesh, uv, points, triangles, np);
  CHECK_IN(context + ": " + report.message, bool(report) && report.message.empty());
  CHECK_IN(context, Rational(int(triangles.size())) == number);
}

// The same, on the same surface, with these cones.
template <typename NamedParameters>
void check_snapped(const Mesh& mesh, const UV_map uv, const std::map<int, int>& cones,
                   const NamedParameters& np, const std::string& context)
{
  check_number(mesh, uv, np, context);
  Mesh triangles;
  const auto report = QR::extract_triangle_mesh(mesh, uv, triangles, np);
  CHECK_IN(context + ": " + report.message, bool(report));
  CHECK_IN(context, CGAL::is_valid_polygon_mesh(triangles) && CGAL::is_triangle_mesh(triangles));
  CHECK_IN(context, quad_reference::euler_characteristic(triangles) ==
                      quad_reference::euler_characteristic(mesh));
  CHECK_IN(context, valences_of_cones(triangles) == cones);
}

// --- borders beside the lattice, and faces that are not positive ---------------------------------

using Polygon = std::vector<Exact_vector>;

// The part of a convex polygon where sign * (functional - level) is not negative.
inline Polygon clipped(const Polygon& polygon, const int functional, const int sign,
                       const int level)
{
  Polygon result;
  const auto side = [&](const Exact_vector& p)
  { return Rational(sign * (random_complexes::value(functional, p) - level)); };
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    const Exact_vector &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Rational da = side(a), db = side(b);
    if(da >= 0)
      result.push_back(a);
    if((da > 0 && db < 0) || (da < 0 && db > 0)) {
      const Rational t(da / (da - db));
      result.push_back({Rational(a[0] + t * (b[0] - a[0])), Rational(a[1] + t * (b[1] - a[1]))});
    }
  }
  return result;
}

inline Rational twice_area(const Polygon& p)
{
  Rational sum(0);
  for(std::size_t i = 0; i < p.size(); ++i) {
    const Exact_vector &a = p[i], &b = p[(i + 1) % p.size()];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum;
}

// A triangle of the lattice: the smallest u and v of its corners, and 1 if it points down.
using Cell = std::array<int, 3>;

// In a single chart without folds: the triangles of the lattice that the faces cover.
inline std::set<Cell> covered_cells(const Mesh& mesh, const UV_map uv)
{
  std::map<Cell, Rational> areas;
  for(const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    Polygon triangle;
    double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
    for(const Halfedge g : {h, mesh.next(h), mesh.prev(h)}) {
      triangle.push_back({Rational(uv[g].x()), Rational(uv[g].y())});
      for(int c = 0; c < 2; ++c) {
        low[c] = (std::min)(low[c], uv[g][c]);
        high[c] = (std::max)(high[c], uv[g][c]);
      }
    }
    for(int x = int(std::floor(low[0])); x < high[0]; ++x)
      for(int y = int(std::floor(low[1])); y < high[1]; ++y) {
        const Polygon column = clipped(clipped(triangle, 0, 1, x), 0, -1, x + 1);
        const Polygon square = clipped(clipped(column, 1, 1, y), 1, -1, y + 1);
        areas[{x, y, 0}] += twice_area(clipped(square, 2, -1, x + y + 1));
        areas[{x, y, 1}] += twice_area(clipped(square, 2, 1, x + y + 1));
      }
  }
  std::set<Cell> result;
  for(const auto& [cell, area] : areas)
    if(area == 1)
      result.insert(cell);
  return result;
}

// The triangles of a flat map, whose points in space become those of the domain.
inline std::set<Cell> extracted_cells(Mesh& mesh, const UV_map uv, const bool allow_holes,
                                      QR::Extraction_report& report)
{
  for(const Halfedge h : mesh.halfedges())
    if(!mesh.is_border(h))
      mesh.point(mesh.target(h)) = Kernel::Point_3(uv[h].x(), uv[h].y(), 0);
  Mesh triangles;
  report =
    QR::extract_triangle_mesh(mesh, uv, triangles, QR::parameters::allow_holes(allow_holes));
  CHECK(CGAL::is_valid_polygon_mesh(triangles) && CGAL::is_triangle_mesh(triangles));
  std::set<Cell> result;
  for(const Face f : triangles.faces()) {
    std::vector<std::array<int, 2> > corners;
    for(const Vertex v : CGAL::vertices_around_face(triangles.halfedge(f), triangles)) {
      const Kernel::Point_3& p = triangles.point(v);
      corners.push_back({int(std::lround(p.x())), int(std::lround(p.y()))});
      CHECK(std::abs(p.x() - corners.back()[0]) < 1e-9 &&
            std::abs(p.y() - corners.back()[1]) < 1e-9);
    }
    const int u = (std::min)({corners[0][0], corners[1][0], corners[2][0]});
    const int v = (std::min)({corners[0][1], corners[1][1], corners[2][1]});
    const bool is_up = std::count(corners.begin(), corners.end(), std::array<int, 2>{u, v}) == 1;
    const std::vector<std::array<int, 2> > wanted =
      is_up ? std::vector<std::array<int, 2> >{{u, v}, {u + 1, v}, {u, v + 1}}
            : std::vector<std::array<int, 2> >{{u + 1, v}, {u + 1, v + 1}, {u, v + 1}};
    std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), wanted[0]),
                corners.end());
    CHECK(corners == wanted);
    result.insert({u, v, is_up ? 0 : 1});
  }
  CHECK_EQUAL(result.size(), std::size_t(triangles.number_of_faces()));
  return result;
}

// A part of the plane whose border and vertices lie anywhere.
inline void make_flat_map(Mesh& mesh, UV_map& uv, std::mt19937& random)
{
  mesh = triangle(9);
  uv = uv_map(mesh);
  unfold(mesh, uv);
  warp<6>(mesh, uv, 0.25, random);
  const double scale = std::array<double, 3>{{0.375, 0.625, 1}}[random() % 3];
  const Vector by{{0.125 * int(random() % 8), 0.125 * int(random() % 8)}};
  for(const Halfedge h : mesh.halfedges())
    if(!mesh.is_border(h))
      uv[h] = moved(Kernel::Point_2(scale * uv[h].x(), scale * uv[h].y()), by);
}

inline void test_borders()
{
  std::size_t kept = 0, cut = 0, unaligned = 0;
  for(unsigned int seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    Mesh mesh;
    UV_map uv;
    make_flat_map(mesh, uv, random);
    std::vector<Face> removed;
    for(const Face f : mesh.faces())
      if(random() % (seed < 30 ? 40 : 200) == 0)
        removed.push_back(f);
    for(const Face f : removed)
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
    mesh.collect_garbage();
    const std::vector<int> orientations = signs(mesh, uv);
    if(std::count(orientations.begin(), orientations.end(), 1) !=
       std::ptrdiff_t(orientations.size()))
      continue;
    QR::Extraction_report report;
    const std::set<Cell> expected = covered_cells(mesh, uv);
    const std::string context = "triangles with border, seed " + std::to_string(seed);
    CHECK_IN(context, expected == extracted_cells(mesh, uv, false, report));
    CHECK_IN(context, bool(report) == !expected.empty());
    kept += expected.size();
    cut += report.number_of_cut_cells;
    unaligned += report.number_of_unaligned_border_edges;
  }
  std::cout << "triangles with border: " << kept << " kept, " << cut << " cut" << std::endl;
  CHECK(kept > 500 && cut > 500 && unaligned > 1000);
}

// Faces that are not positive are refused, or holes.
inline void test_holes()
{
  std::size_t flips = 0, kept = 0;
  for(unsigned int seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    Mesh mesh;
    UV_map uv;
    make_flat_map(mesh, uv, random);
    const Vertex v(Mesh::size_type(random() % mesh.number_of_vertices()));
    for(const Halfedge h : CGAL::halfedges_around_target(v, mesh))
      if(!mesh.is_border(h))
        uv[h] = moved(uv[h], {{0.625, 0.375}});
    const std::vector<int> orientations = signs(mesh, uv);
    std::vector<std::size_t> bad;
    for(std::size_t f = 0; f < orientations.size(); ++f)
      if(orientations[f] <= 0)
        bad.push_back(f);
    const std::string context = "triangles with holes, seed " + std::to_string(seed);
    QR::Extraction_report report;
    CHECK_IN(context, extracted_cells(mesh, uv, false, report).empty() == !bad.empty());
    CHECK_IN(context, report.nonpositive_faces == bad);
    CHECK_IN(context, report.status == (bad.empty() ? Status::SUCCESS : Status::NOT_POSITIVE));
    const std::set<Cell> cells = extracted_cells(mesh, uv, true, report);
    CHECK_IN(context + ": " + report.message, bool(report) == !cells.empty());
    for(const std::size_t f : bad)
      CGAL::Euler::remove_face(mesh.halfedge(Face(Mesh::size_type(f))), mesh);
    mesh.collect_garbage();
    CHECK_IN(context, cells == extracted_cells(mesh, uv, false, report));
    flips += bad.size();
    kept += cells.size();
  }
  CHECK(flips > 40 && kept > 1000);
}

// --- coarse maps, cones between the lines, refusals ----------------------------------------------

inline Status status_of_mesh(const Mesh& mesh, const UV_map uv)
{
  Mesh triangles;
  triangles.add_vertex();
  const auto report = QR::extract_triangle_mesh(mesh, uv, triangles);
  CHECK(bool(report) || (triangles.number_of_vertices() == 1 && triangles.is_empty() == false));
  CHECK(bool(report) == report.message.empty());
  return report.status;
}

// A torus of two triangles, as the identity of opposite sides of a parallelogram: loops and double
// edges, which points and indices can hold.
inline void test_coarse_torus()
{
  for(const int side : {1, 2, 3, 4}) {
    const quad_reference::Grid_map map(test_meshes::torus(1, 1), side, 4);
    CHECK(status_of_mesh(map.mesh, map.uv) ==
          (side < 3 ? Status::NO_FACE_GRAPH : Status::SUCCESS));
    std::vector<Kernel::Point_3> points;
    std::vector<std::array<int, 3> > triangles;
    CHECK(bool(QR::extract_triangle_soup(map.mesh, map.uv, points, triangles)));
    CHECK_EQUAL(points.size(), std::size_t(side * side));
    CHECK_EQUAL(triangles.size(), std::size_t(2 * side * side));
  }
  // there is no cone that tells
  const quad_reference::Grid_map map(test_meshes::torus(1, 1), 3, 4);
  Mesh triangles;
  const auto report =
    QR::extract_triangle_mesh(map.mesh, map.uv, triangles, QR::parameters::grid_scale(0.5));
  CHECK(report.status == Status::NOT_INTEGER && triangles.is_empty());
  CHECK_IN(report.message, report.message.find("the translation across") != std::string::npos);
}

// A map of translations is one of any symmetry. That of a surface of genus 2 has a cone of 1080
// degrees: with 18 triangles around it, or, between the lines, inside of a cell with 9 corners.
inline void test_cone_of_1080_degrees()
{
  quad_reference::Grid_map map(test_meshes::genus_2(), 4, 4);
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t> > polygons;
  const auto report = QR::extract_triangle_soup(map.mesh, map.uv, points, polygons);
  CHECK(bool(report) && report.number_of_cones == 1 && report.number_of_other_polygons == 0);
  std::vector<int> valences(points.size(), 0);
  for(const auto& triangle : polygons) {
    CHECK_EQUAL(triangle.size(), std::size_t(3));
    for(const std::size_t p : triangle)
      ++valences[p];
  }
  std::map<int, int> number_of_valences;
  for(const int valence : valences)
    ++number_of_valences[valence];
  CHECK(number_of_valences == (std::map<int, int>{{6, int(points.size()) - 1}, {18, 1}}));
  CHECK_EQUAL(double(polygons.size()), report.area);

  for(const auto& [u, v] : {std::pair{0.25, 0.125}, {0.5, 0.25}}) {
    map.shift(u, v); // by 3/4 and 3/8 in the end, which is in the other triangle of the square
    polygons.clear();
    points.clear();
    const auto between = QR::extract_triangle_soup(map.mesh, map.uv, points, polygons);
    CHECK(bool(between) && between.number_of_cones_in_cells == 1);
    CHECK_EQUAL(between.number_of_other_polygons, std::size_t(1));
    std::map<std::size_t, int> sizes;
    for(const auto& polygon : polygons)
      ++sizes[polygon.size()];
    CHECK(sizes == (std::map<std::size_t, int>{{3, int(report.area) - 9 + 6}, {9, 1}}));
    std::vector<std::array<std::size_t, 3> > triangles(1);
    const auto refusal = QR::extract_triangle_soup(map.mesh, map.uv, points, triangles);
    CHECK(refusal.status == Status::NOT_INTEGER && triangles.size() == 1);
  }
  map.shift(0, -0.125); // to (3/4, 1/4), on a line of u + v alone
  CHECK(status_of_mesh(map.mesh, map.uv) == Status::NOT_INTEGER);
}

inline void test_refusals()
{
  Mesh mesh = subdivided(icosahedron(), 1);
  UV_map uv = uv_map(mesh);
  unfold(mesh, uv);
  const std::vector<Kernel::Point_2> clean(uv.begin(), uv.end());
  CHECK(status_of_mesh(mesh, uv) == Status::SUCCESS);
  const auto restore = [&] { std::copy(clean.begin(), clean.end(), uv.begin()); };
  for(const Halfedge h : mesh.halfedges())
    uv[h] = moved(uv[h], {{0.25, 0}});
  CHECK(status_of_mesh(mesh, uv) == Status::NOT_INTEGER);
  restore();
  const Halfedge any = mesh.halfedge(*std::next(mesh.vertices().begin(), 30));
  uv[any] = moved(uv[any], {{std::ldexp(1., -30), 0}});
  CHECK(status_of_mesh(mesh, uv) == Status::NOT_SEAMLESS);
  restore();
  for(const Halfedge h : mesh.halfedges())
    uv[h] = moved(uv[h], {{std::ldexp(1., 47), 0}});
  CHECK(status_of_mesh(mesh, uv) == Status::NOT_INTEGER ||
        status_of_mesh(mesh, uv) == Status::TOO_LARGE);
  restore();
  Mesh triangles;
  const auto report =
    QR::extract_triangle_mesh(mesh, uv, triangles, QR::parameters::maximum_number(79));
  CHECK(report.status == Status::TOO_LARGE && triangles.is_empty());
  CHECK(report.message.find("there would be 80 triangles") != std::string::npos);
  CHECK(bool(QR::extract_triangle_mesh(mesh, uv, triangles,
                                       QR::parameters::maximum_number(80))));
}

// Vertices moved across opposite edges come back.
inline void test_repair()
{
  const Mesh coarse = icosahedron();
  Mesh mesh = subdivided(coarse, 2);
  UV_map uv = uv_map(mesh);
  std::size_t repaired = 0;
  for(unsigned int seed = 1; seed <= 10; ++seed) {
    unfold_from_first(mesh, uv);
    std::mt19937 random(seed);
    const Vertex v(Mesh::size_type(coarse.number_of_vertices() +
                                   random() % (mesh.number_of_vertices() -
                                               coarse.number_of_vertices())));
    Vector d{{1.5, 0.75}};
    for(const Halfedge h : corners_in_turn(mesh, v)) {
      const int k = turns<6>(mesh, uv, mesh.next(h));
      uv[h] = moved(uv[h], d);
      d = turned<6>(k, d);
    }
    Mesh triangles;
    const auto np = QR::parameters::grid_scale(0.25);
    CHECK(QR::extract_triangle_mesh(mesh, uv, triangles, np).status == Status::NOT_POSITIVE);
    const auto repair = QR::repair_integer_grid(
      mesh, uv, np.rotational_symmetry(QR::Rotational_symmetry<6>()));
    CHECK_IN(repair.message, bool(repair));
    const auto report = QR::extract_triangle_mesh(mesh, uv, triangles);
    CHECK_IN(report.message, bool(report));
    CHECK(are_isomorphic(triangles, coarse));
    repaired += repair.run.number_of_repaired_flips;
  }
  CHECK(repaired >= 10);
}

inline void test_triangles()
{
  for(const unsigned int levels : {0u, 1u, 2u}) {
    test_surface<6>(icosahedron(), levels, "icosahedron");
    test_surface<6>(octahedron(), levels, "octahedron");
    test_surface<3>(octahedron(), levels, "octahedron");
    test_surface<6>(torus(6, 5), levels, "torus");
    test_surface<6>(genus_2(), levels, "genus 2");
    test_surface<6>(triangle(4), levels, "triangle with border");
  }
  test_borders();
  test_holes();
  test_coarse_torus();
  test_cone_of_1080_degrees();
  test_refusals();
  test_repair();
}

} // namespace triangle_checks

#endif // SEAMLESS_SNAPPING_TEST_TRIANGLE_CHECKS_H
