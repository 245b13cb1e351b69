// Surfaces of several pieces: each has quads of the size that is wanted, whatever the others are.

#ifndef SEAMLESS_SNAPPING_TEST_PIECE_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_PIECE_CHECKS_H

#include "quad_reference.h"
#include "test_surfaces.h"

#include <CGAL/Quad_remeshing/internal/largest_number_of_quads.h>
#include <CGAL/Quad_remeshing/internal/quantization/quads_needed.h>
#include <CGAL/Quad_remeshing/quad_remesh.h>
#include <CGAL/Quad_remeshing/quantize.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace pieces {

using namespace quad_reference;
namespace QR = CGAL::Quad_remeshing;
namespace surfaces = test_meshes;

// The numbers of faces of the pieces, from few to many.
inline std::vector<std::size_t> sizes(Mesh& mesh)
{
  const auto piece = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:piece", 0).first;
  std::vector<std::size_t> result(
    CGAL::Polygon_mesh_processing::connected_components(mesh, piece), 0);
  for(const auto f : mesh.faces())
    ++result[piece[f]];
  std::sort(result.begin(), result.end());
  return result;
}

// A box, and a rectangle of six squares that are smaller than those of the box.
inline void test_units()
{
  for(const int exponent : {-4, -9, -20}) {
    surfaces::Square_complex complex = surfaces::box(2, 1, 3);
    const std::size_t faces_of_box = complex.number_of_squares() * 32;
    complex.append(surfaces::disc(3, 2));
    Grid_map map(complex, 4, 4);
    for(const auto h : map.mesh.halfedges())
      if(!map.mesh.is_border(h) && std::size_t(map.mesh.face(h)) >= faces_of_box)
        map.uv[h] = Point_2(std::ldexp(map.uv[h].x(), exponent),
                            std::ldexp(map.uv[h].y(), exponent));
    for(const bool needs_face_graph : {false, true}) {
      const auto found = QR::quantize(map.mesh, map.uv,
                                      QR::parameters::target_number_of_quads(352)
                                        .needs_face_graph(needs_face_graph));
      CHECK_EQUAL(found.message, std::string());
      CHECK_EQUAL(found.number_of_quads, std::size_t(353));
      Mesh quads;
      CHECK(found && QR::extract_quad_mesh(found, map.mesh, quads));
      CHECK((sizes(quads) == std::vector<std::size_t>{1, 352}));
      CHECK_EQUAL(found.parts_of_other_size.size(), std::size_t(exponent < -4 ? 1 : 0));
      for(const QR::Part_of_other_size& part : found.parts_of_other_size) {
        CHECK(part.face == faces_of_box && part.number_of_quads == 1);
        CHECK(std::abs(part.number_wanted / std::ldexp(96., 2 * exponent) - 1) < 1e-3);
        CHECK(part.number_needed == 1 && !part.has_too_many_quads);
      }
    }
  }
}

// Divided into n x m squares, in the plane.
inline void add_rectangle(const Point_3& corner, const double width, const double height,
                          const int n, const int m, Mesh& mesh)
{
  const auto first = mesh.number_of_vertices();
  for(int j = 0; j <= m; ++j)
    for(int i = 0; i <= n; ++i)
      mesh.add_vertex(corner + Kernel::Vector_3(width * i / n, height * j / m, 0));
  const auto vertex = [&](const int i, const int j)
    { return Vertex(Mesh::size_type(first) + Mesh::size_type(j * (n + 1) + i)); };
  for(int j = 0; j < m; ++j)
    for(int i = 0; i < n; ++i) {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
}

inline void add_octahedron(const Point_3& center, const double size, Mesh& mesh)
{
  std::array<Vertex, 6> v;
  for(std::size_t i = 0; i < 6; ++i) {
    std::array<double, 3> d{};
    d[i / 2] = i % 2 == 0 ? size : -size;
    v[i] = mesh.add_vertex(center + Kernel::Vector_3(d[0], d[1], d[2]));
  }
  for(const auto& [a, b] : {std::array<int, 2>{0, 2}, {2, 1}, {1, 3}, {3, 0}}) {
    mesh.add_face(v[a], v[b], v[4]);
    mesh.add_face(v[b], v[a], v[5]);
  }
}

// Open pieces of very different sizes stay, and the largest has the quads that are wanted.
inline void test_open_pieces()
{
  for(const bool has_tolerance : {false, true})
    for(const double size : {1e-3, 1e-5}) {
      Mesh mesh, quads;
      add_rectangle(Point_3(0, 0, 0), 2, 1, 8, 4, mesh);
      add_rectangle(Point_3(3, 0, 0), 0.3, 0.2, 3, 2, mesh);
      for(const double x : {5., 6.})
        add_rectangle(Point_3(x, 0, 0), size, 0.6 * size, 1, 1, mesh);
      const auto np = QR::parameters::target_number_of_quads(200);
      const auto report = has_tolerance ? QR::quad_remesh(mesh, quads, np)
                                        : QR::quad_remesh(mesh, quads, np.border_tolerance(0.));
      CHECK_IN(report.message, bool(report));
      const std::vector<std::size_t> found = sizes(quads);
      std::cout << "pieces:";
      for(const std::size_t n : found)
        std::cout << " " << n;
      std::cout << " quads" << std::endl;
      CHECK_EQUAL(found.size(), std::size_t(4));
      CHECK(found[0] == 1 && found[1] == 1);
      CHECK(found[2] >= 4 && found[2] <= 8);
      CHECK(found[3] > 185 && found[3] < 205);
      CHECK_EQUAL(report.parts_of_other_size.size(), std::size_t(2));
      for(const QR::Part_of_other_size& part : report.parts_of_other_size)
        CHECK(part.face >= mesh.number_of_faces() - 4 && part.number_wanted < 1e-3 &&
              part.number_needed == 1 && !part.has_too_many_quads);
    }
}

// Closed pieces that are smaller than a quad are left out, unless all are to stay.
inline void test_small_closed_pieces()
{
  const Grid_map cube(surfaces::box(1, 1, 1), 4, 4);
  Mesh mesh(cube.mesh);
  add_octahedron(Point_3(9, 0, 0), 0.01, mesh);
  const double area = 4 * std::sqrt(3.) * 1e-4;
  const auto np = QR::parameters::target_number_of_quads(600);
  const auto remesh = [&](const auto& parameters) {
    Mesh quads;
    const auto report = QR::quad_remesh(mesh, quads, parameters);
    CHECK_IN(report.message, bool(report));
    const std::vector<std::size_t> found = sizes(quads);
    CHECK(found.back() > 570 && found.back() < 630);
    CHECK_EQUAL(found.size(), 2 - report.number_of_parts_left_out);
    CHECK_EQUAL(report.parts_of_other_size.size(), found.size() - 1);
    return report;
  };
  const auto report = remesh(np);
  CHECK_EQUAL(report.number_of_parts_left_out, std::size_t(1));
  CHECK(std::abs(report.area_of_parts_left_out / area - 1) < 1e-9);
  CHECK(report.largest_distance_of_input < 1);
  CHECK_EQUAL(remesh(np.area_threshold(1.01 * area)).number_of_parts_left_out, std::size_t(1));
  CHECK_EQUAL(remesh(np.area_threshold(0.99 * area)).number_of_parts_left_out, std::size_t(0));
  CHECK_EQUAL(remesh(np.area_threshold(1e9)).number_of_parts_left_out, std::size_t(1));
  Mesh quads;
  for(const double bad : {-1., std::nan("")})
    CHECK(QR::quad_remesh(mesh, quads, np.area_threshold(bad)).status ==
          QR::Outcome::INVALID_ARGUMENT);
  // equal ones stay, though each is smaller than a quad
  Mesh equal;
  for(int i = 0; i < 5; ++i)
    add_octahedron(Point_3(i, 0, 0), 0.1, equal);
  const auto of_equal = QR::quad_remesh(equal, quads, QR::parameters::target_number_of_quads(2));
  CHECK_EQUAL(of_equal.number_of_parts_left_out, std::size_t(0));
  CHECK(of_equal.number_of_quads > 4 && !of_equal.has_too_many_quads); // five parts need more
}

// More than twice the number that is wanted has a reason if features, parts, handles, or holes need
// it.
inline void test_too_many_quads()
{
  const auto check = [](const surfaces::Square_complex& complex, const std::size_t needed) {
    const Grid_map map(complex, 1, 1);
    const std::size_t n = map.mesh.number_of_faces();
    using QR::internal::largest_number_of_quads;
    const auto is_too_many = [&](const double wanted, const std::size_t forced)
    { return double(n) > largest_number_of_quads(map.mesh, wanted, forced); };
    CHECK_EQUAL(is_too_many(0, 0), n > 2 * needed);
    CHECK_EQUAL(is_too_many(double(n) / 2 - 0.1, n / 2 - 1), n > 2 * needed);
    CHECK(!is_too_many(double(n) / 2, 0));
    CHECK(!is_too_many(0, (n + 1) / 2));
  };
  for(const int i : {1, 2, 3, 4}) {
    check(surfaces::box(1, 1, i), 6);
    check(surfaces::disc(i, i), 6);
    check(surfaces::torus(i + 2, i + 2), 6 + 9);
    check(surfaces::cylinder(i + 2, i + 2), 6 + 4);
    surfaces::Square_complex complex = surfaces::box(1, 1, i);
    complex.append(surfaces::box(i, 1, 1));
    check(complex, 2 * 6);
  }
  for(const double wanted : {0.1, 6., 7.})
    for(const std::size_t needed : {5, 6})
      for(const std::size_t n : {12, 13, 14}) {
        const QR::Part_of_other_size part{0, n, wanted, needed, false};
        CHECK_EQUAL(QR::internal::has_too_many_quads(part),
                    n > 2 * (std::max)(std::size_t(wanted), needed));
      }
}

// A vertex far away is refused and named, unless the whole piece is there.
inline void test_vertex_far_away()
{
  Mesh quads;
  const auto np = QR::parameters::target_number_of_quads(100);
  for(const std::size_t v : {0, 17, 44}) {
    Mesh mesh;
    add_rectangle(Point_3(0, 0, 0), 2, 1, 8, 4, mesh);
    mesh.point(Vertex(Mesh::size_type(v))) = Point_3(0, -std::ldexp(1., 31), 0);
    const auto report = QR::quad_remesh(mesh, quads, np);
    CHECK(report.status == QR::Outcome::INVALID_ARGUMENT && quads.is_empty());
    CHECK_IN(report.message,
             report.message.find(" has a vertex at (0, -2.15e+09, 0), which") !=
               std::string::npos);
  }
  Mesh mesh;
  add_rectangle(Point_3(0, 0, 0), 2, 1, 8, 4, mesh);
  add_rectangle(Point_3(std::ldexp(1., 31), 0, 0), 2, 1, 1, 1, mesh);
  CHECK(bool(QR::quad_remesh(mesh, quads, np)));
  CHECK(quads.number_of_faces() > 80);
}

inline void test_all()
{
  test_units();
  test_open_pieces();
  test_small_closed_pieces();
  test_too_many_quads();
  test_vertex_far_away();
}

} // namespace pieces

#endif // SEAMLESS_SNAPPING_TEST_PIECE_CHECKS_H
