// Checks of which sharp edges are features: boxes, whose edges are known, against what looks alike
// edge by edge, as nets of voxels and spheres with noise.

#ifndef QUAD_REMESHING_FEATURE_DETECTION_CHECKS_H
#define QUAD_REMESHING_FEATURE_DETECTION_CHECKS_H

#include <CGAL/Quad_remeshing/detect_features.h>

#include "checking.h"
#include "random_numbers.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace feature_detection_checks {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;
using Place = std::array<int, 3>;
namespace QR = CGAL::Quad_remeshing;

// The surface of unit cubes, each side of two triangles.
template <typename Is_inside>
Mesh surface_of_voxels(const int n, const Is_inside& is_inside)
{
  Mesh mesh;
  std::map<Place, Mesh::Vertex_index> vertices;
  const auto vertex = [&](const Place& p) {
    const auto [it, is_new] = vertices.try_emplace(p);
    if(is_new)
      it->second = mesh.add_vertex(Point_3(p[0], p[1], p[2]));
    return it->second;
  };
  for(int i = 0; i < 6 * n * n * n; ++i) {
    const Place cube{i / 6 % n, i / 6 / n % n, i / 6 / n / n};
    const std::size_t axis = std::size_t(i % 3), u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int is_upper = i / 3 % 2;
    Place next = cube, corner = cube;
    next[axis] += 2 * is_upper - 1;
    if(!is_inside(cube) || is_inside(next))
      continue;
    corner[axis] += is_upper;
    std::array<Mesh::Vertex_index, 4> around;
    for(std::size_t k = 0; k < 4; ++k) {
      Place p = corner;
      p[u] += k == 1 || k == 2;
      p[v] += k >= 2;
      around[is_upper == 1 ? k : 3 - k] = vertex(p);
    }
    mesh.add_face(around[0], around[1], around[2]);
    mesh.add_face(around[0], around[2], around[3]);
  }
  return mesh;
}

Mesh box(const int n)
{
  return surface_of_voxels(n, [=](const Place& p) {
    return p[0] >= 0 && p[1] >= 0 && p[2] >= 0 && p[0] < n && p[1] < n && p[2] < n;
  });
}

// No two cubes meet in an edge only, or in a corner.
Mesh ball_of_voxels(const int n)
{
  return surface_of_voxels(n, [=](const Place& p) {
    double square = 0;
    for(const int x : p)
      square += (x + 0.5 - n / 2.) * (x + 0.5 - n / 2.);
    return square < 0.245 * n * n;
  });
}

// A sphere of squares, with noise as a part of the length of an edge.
Mesh sphere_with_noise(const int n, const double noise, random_numbers::Random& random)
{
  Mesh mesh = box(n);
  for(const auto v : mesh.vertices()) {
    const Kernel::Vector_3 p = mesh.point(v) - Point_3(n / 2., n / 2., n / 2.);
    const double radius = n / 2. + noise * (random_numbers::below(random, 2001) / 1000. - 1);
    mesh.point(v) = CGAL::ORIGIN + radius / std::sqrt(p.squared_length()) * p;
  }
  return mesh;
}

Edge_map new_map(Mesh& mesh, const std::string& name)
{ return mesh.add_property_map<Mesh::Edge_index, bool>("e:" + name, false).first; }

std::size_t count(const Mesh& mesh, const Edge_map is_feature)
{
  std::size_t result = 0;
  for(const auto e : mesh.edges())
    result += is_feature[e] ? 1 : 0;
  return result;
}

// All edges of a box, and no others; whatever is marked already stays.
void test_boxes()
{
  for(const int n : {1, 2, 6}) {
    Mesh mesh = box(n);
    const Edge_map is_feature = new_map(mesh, "feature");
    const QR::Detected_features found = QR::detect_features(mesh, 40, n / 4., is_feature);
    CHECK_EQUAL(found.number_of_sharp_edges, std::size_t(12 * n));
    CHECK_EQUAL(found.number_of_features, std::size_t(12 * n));
    for(const auto e : mesh.edges()) {
      const Point_3 p =
        CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
      int number_of_sides = 0;
      for(const double x : {p.x(), p.y(), p.z()})
        number_of_sides += x == 0 || x == n ? 1 : 0;
      CHECK(is_feature[e] == (number_of_sides >= 2));
    }
    const Edge_map others = new_map(mesh, "others");
    others[*mesh.edges_begin()] = true;
    CHECK_EQUAL(QR::detect_features(mesh, 40, 1.01 * n / 4., others).number_of_features, 0u);
    CHECK_EQUAL(count(mesh, others), 1u);
    CHECK_EQUAL(QR::detect_features(mesh, 91, 0, others).number_of_sharp_edges, 0u);
  }
}

// Edge by edge a box, but the chains have no room for quads, unless these are smaller than voxels.
void test_voxels()
{
  for(const int n : {8, 14}) {
    Mesh mesh = ball_of_voxels(n);
    CHECK(CGAL::is_closed(mesh) && CGAL::is_triangle_mesh(mesh));
    const Edge_map is_feature = new_map(mesh, "feature");
    const QR::Detected_features coarse = QR::detect_features(mesh, 40, 1, is_feature);
    CHECK(coarse.number_of_sharp_edges > std::size_t(n * n));
    CHECK_EQUAL(coarse.number_of_features, 0u);
    CHECK_EQUAL(count(mesh, is_feature), 0u);
    const QR::Detected_features fine = QR::detect_features(mesh, 40, 0.2, is_feature);
    CHECK_EQUAL(fine.number_of_features, coarse.number_of_sharp_edges);
  }
}

// Of some tens of thousands of edges, the sharp ones lie among others that are nearly as sharp.
void test_noise()
{
  random_numbers::Random random(1);
  for(const double noise : {0.2, 0.3, 0.4}) {
    Mesh mesh = sphere_with_noise(24, noise, random);
    const Edge_map is_feature = new_map(mesh, "feature");
    const QR::Detected_features found = QR::detect_features(mesh, 40, 0.1, is_feature);
    const std::string context = "noise " + std::to_string(noise);
    CHECK_IN(context, found.number_of_sharp_edges > 20);
    CHECK_IN(context + ": " + std::to_string(found.number_of_features),
             found.number_of_features == 0);
  }
}

// Each component is decided for itself.
void test_components()
{
  random_numbers::Random random(1);
  Mesh mesh = sphere_with_noise(24, 0.3, random);
  const std::size_t number = mesh.number_of_vertices();
  mesh += box(6);
  const Edge_map is_feature = new_map(mesh, "feature");
  const QR::Detected_features found = QR::detect_features(mesh, 40, 0.1, is_feature);
  CHECK_EQUAL(found.number_of_features, 72u);
  CHECK(found.number_of_sharp_edges > 72 + 20);
  for(const auto e : mesh.edges())
    CHECK(!is_feature[e] || std::size_t(mesh.vertex(e, 0)) >= number);
}

// A needle along an edge of a box, whose normal leans away from both sides. And a border.
void test_needles()
{
  Mesh mesh;
  const auto add = [&](const double x, const double y, const double z)
    { return mesh.add_vertex(Point_3(x, y, z)); };
  const auto left = add(0, 0, 0), right = add(4, 0, 0), middle = add(2, 1e-9, -1e-9);
  const auto a = add(0, 4, 0), b = add(4, 4, 0), c = add(0, 0, -4), d = add(4, 0, -4);
  mesh.add_face(left, right, middle);
  mesh.add_face(left, middle, a);
  mesh.add_face(middle, b, a);
  mesh.add_face(middle, right, b);
  mesh.add_face(left, d, right);
  mesh.add_face(left, c, d);
  const Edge_map is_feature = new_map(mesh, "feature");
  const QR::Detected_features found = QR::detect_features(mesh, 40, 1, is_feature);
  CHECK(found.number_of_features > 0);
  CHECK_EQUAL(found.number_of_features, found.number_of_sharp_edges);
  for(const auto e : mesh.edges())
    CHECK(!is_feature[e] || !mesh.is_border(e));
}

void test_all()
{
  test_boxes();
  test_voxels();
  test_noise();
  test_components();
  test_needles();
}

} // namespace feature_detection_checks

#endif // QUAD_REMESHING_FEATURE_DETECTION_CHECKS_H
