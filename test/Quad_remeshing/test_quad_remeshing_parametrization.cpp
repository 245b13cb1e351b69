// The producer of approximately seamless parametrizations: surfaces of all kinds, its parameters,
// the meshes and property maps that it accepts, and what it refuses.

#include "checking.h"
#include "floating_point_traps.h"
#include "parametrization_checks.h"
#include "test_meshes.h"

#include <CGAL/Quad_remeshing/approximate_seamless_parametrization.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/subdivision_method_3.h>

#include <Eigen/LU>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

// --- the meshes ----------------------------------------------------------------------------------

Mesh icosphere(const unsigned int subdivisions)
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point_3>(mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(
    mesh, CGAL::parameters::number_of_iterations(subdivisions));
  return mesh;
}

Mesh tetrahedron()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1),
                         mesh);
  return mesh;
}

Mesh height_field(const Mesh::size_type n)
{
  Mesh mesh;
  CGAL::make_grid(n, n, mesh, [](const std::size_t i, const std::size_t j) {
    return Point_3(double(i), double(j), std::sin(0.7 * double(i)) * std::cos(0.9 * double(j)));
  }, true);
  return mesh;
}

// A torus of revolution.
Mesh torus(const std::size_t n, const std::size_t m)
{
  Mesh mesh;
  std::vector<Vertex> v;
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < m; ++j) {
      const double a = 6.283185307179586 * double(i) / double(n);
      const double b = 6.283185307179586 * double(j) / double(m), r = 3 + std::cos(b);
      v.push_back(mesh.add_vertex(Point_3(r * std::cos(a), r * std::sin(a), std::sin(b))));
    }
  const auto at = [&](std::size_t i, std::size_t j) { return v[(i % n) * m + j % m]; };
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < m; ++j) {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

Mesh grid(const Mesh::size_type n)
{
  Mesh mesh;
  CGAL::make_grid(n, n, mesh, [](const std::size_t i, const std::size_t j) {
    return Point_3(double(i), double(j), 0);
  }, true);
  return mesh;
}

// A slab with holes: genus 1 to 3, cones of both signs; and the same with rounded edges.
Mesh slab(const int genus, const bool is_round)
{
  square_complex::Square_complex complex = square_complex::voxel_surface(
    { { 2 * genus + 1, 3, 1 } }, [](int x, int y, int) { return y != 1 || x % 2 == 0; });
  complex.unfold();
  Mesh mesh = test_meshes::make_mesh<Kernel>(complex, 2);
  if(is_round)
    CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
  return mesh;
}

// --- surfaces ------------------------------------------------------------------------------------

// Moves the vertices at random.
Mesh perturbed(Mesh mesh, const double size, const unsigned int seed)
{
  CGAL::Random random(seed);
  const auto number = [&] { return random.get_double(-size, size); };
  for(const Vertex v : mesh.vertices()) {
    const double x = number(), y = number(), z = number();
    mesh.point(v) = mesh.point(v) + Kernel::Vector_3(x, y, z);
  }
  return mesh;
}

Mesh scaled(Mesh mesh, const double factor)
{
  for(const Vertex v : mesh.vertices())
    mesh.point(v) = CGAL::ORIGIN + factor * (mesh.point(v) - CGAL::ORIGIN);
  return mesh;
}

void test_generated_meshes()
{
  check_parametrization("triangle", [] {
    Mesh mesh;
    CGAL::make_triangle(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), mesh);
    return mesh;
  }());
  check_parametrization("tetrahedron", tetrahedron());
  check_parametrization("icosahedron", icosphere(0));
  check_parametrization("sphere", icosphere(3));
  check_parametrization("height field", height_field(12));
  for(int genus = 1; genus <= 3; ++genus) {
    check_parametrization("slab of genus " + std::to_string(genus), slab(genus, false));
    check_parametrization("round slab of genus " + std::to_string(genus), slab(genus, true));
  }
  Mesh mesh = icosphere(2);
  mesh += height_field(5);
  mesh += slab(1, true);
  check_parametrization("three components", mesh);
}

// Aligned to its creases, a cube comes out as its six squares.
void test_cube_with_creases()
{
  square_complex::Square_complex complex = test_meshes::box(1, 1, 1);
  test_meshes::mark_creases(complex);
  Mesh mesh = test_meshes::make_mesh<Kernel>(complex, 4);
  check_alignment("cube with creases", mesh, test_meshes::feature_map(mesh), false);
  const Uv_map uv = new_uv_map(mesh);
  const Report report = QR::approximate_seamless_parametrization(
    mesh, uv, parameters::edge_is_constrained_map(test_meshes::feature_map(mesh)));
  CHECK_EQUAL(report.cones.size(), std::size_t(8));
  CHECK_EQUAL(report.number_of_flipped_faces, std::size_t(0));
  for(const auto& cone : report.cones)
    CHECK_EQUAL(cone.second, 1);
}

// Bars of square section along the edges of an icosahedron, with all their edges as features: sides
// that are narrow trapezoids, of two triangles each.
Mesh frame(const double width)
{
  const Mesh solid = icosphere(0);
  Mesh mesh;
  const auto between = [](const Point_3& p, const Point_3& q, const double t)
  { return p + t * (q - p); };
  std::vector<std::array<Vertex, 2> > ends; // outside and inside
  for(const Vertex v : solid.vertices())
    ends.push_back({mesh.add_vertex(solid.point(v)),
                    mesh.add_vertex(between(solid.point(v), CGAL::ORIGIN, width))});
  std::vector<Vertex> corners(solid.number_of_halfedges()); // of holes, at the target
  for(const Halfedge h : solid.halfedges()) {
    const Point_3& p = solid.point(solid.target(h));
    const Point_3 center = CGAL::centroid(p, solid.point(solid.source(h)),
                                          solid.point(solid.target(solid.next(h))));
    corners[h] = mesh.add_vertex(between(between(p, center, width), CGAL::ORIGIN, width / 2));
  }
  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", true).first;
  const auto add_side = [&](const Vertex a, const Vertex b, const Vertex c, const Vertex d) {
    mesh.add_face(a, b, c);
    mesh.add_face(a, c, d);
    is_feature[mesh.edge(mesh.halfedge(a, c))] = false;
  };
  for(const Halfedge h : solid.halfedges()) {
    const auto &a = ends[solid.source(h)], &b = ends[solid.target(h)];
    add_side(a[0], b[0], corners[h], corners[solid.prev(h)]);
    add_side(b[1], a[1], corners[solid.prev(h)], corners[h]);
  }
  return mesh;
}

// Each side of a bar is a rectangle in the map, however narrow its corners are.
void test_frame()
{
  for(const double width : {0.1, 0.2, 0.4}) {
    Mesh mesh = frame(width);
    CHECK(CGAL::is_closed(mesh) && CGAL::is_valid_polygon_mesh(mesh));
    const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature").first;
    const Uv_map uv = new_uv_map(mesh);
    const Report report = QR::approximate_seamless_parametrization(
      mesh, uv, parameters::edge_is_constrained_map(is_feature).release_alignment(true));
    CHECK(report.released_edges.empty());
    CHECK_EQUAL(report.number_of_flipped_faces, std::size_t(0));
    CHECK_EQUAL(report.cones.size(), std::size_t(24));
    for(const auto& cone : report.cones)
      CHECK_EQUAL(cone.second, 4 - 10); // ten sides meet there
  }
}

// Divides faces into four, as they are.
struct Linear_mask
{
  void edge_node(const Halfedge h, Point_3& p) const
  { p = CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))); }
  void vertex_node(const Vertex v, Point_3& p) const { p = mesh.point(v); }
  void border_node(Halfedge, Point_3&, Point_3&) const { }

  const Mesh& mesh;
};

// Three features meet in narrow sectors at each spike. None of them gets a corner: each side of a
// spike has a cone inside.
void test_spikes_with_features()
{
  for(const double height : {2.5, 3., 5., 10.}) {
    Mesh mesh = icosphere(0);
    const std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
    for(const auto f : faces) {
      const Halfedge h = mesh.halfedge(f);
      const Point_3 center = CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                            mesh.point(mesh.target(mesh.next(h))));
      mesh.point(mesh.target(CGAL::Euler::add_center_vertex(h, mesh))) =
        CGAL::ORIGIN + height * (center - CGAL::ORIGIN);
    }
    CGAL::Subdivision_method_3::PTQ(mesh, Linear_mask{mesh},
                                    CGAL::parameters::number_of_iterations(2));
    const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
    CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 20, is_feature);
    const Uv_map uv = new_uv_map(mesh);
    const Report report = QR::approximate_seamless_parametrization(
      mesh, uv, parameters::edge_is_constrained_map(is_feature).release_alignment(true));
    CHECK(report.released_edges.empty());
    CHECK_EQUAL(report.number_of_flipped_faces, std::size_t(0));
    CHECK_EQUAL(report.cones.size(), std::size_t(12 + 20 + 60));
  }
}

void test_meshes_of_all_kinds()
{
  for(const auto& named : test_meshes::all_meshes<Kernel>()) {
    check_parametrization(named.name, named.mesh, true);
    check_alignment(named.name, named.mesh,
                    CGAL::Static_boolean_property_map<Mesh::Edge_index, false>(), true);
    Mesh mesh = named.mesh;
    for(const bool align_border : {false, true})
      check_alignment(named.name + " with features", mesh, test_meshes::feature_map(mesh),
                      align_border);
  }
}

// --- parameters ----------------------------------------------------------------------------------

void test_reproducibility()
{
  Mesh mesh = icosphere(2);
  const Uv_map uv = new_uv_map(mesh);
  CHECK(QR::approximate_seamless_parametrization(mesh, uv));
  const std::vector<Point_2> first(uv.begin(), uv.end());
  CHECK(QR::approximate_seamless_parametrization(mesh, uv, parameters::random_seed(0u)));
  CHECK(std::vector<Point_2>(uv.begin(), uv.end()) == first);
  check_snappable("other seed",
                  QR::approximate_seamless_parametrization(mesh, uv, parameters::random_seed(5)),
                  mesh, uv);
}

void test_target_edge_length()
{
  Mesh mesh = grid(4);
  const Uv_map uv = new_uv_map(mesh);
  const Report unit = QR::approximate_seamless_parametrization(mesh, uv);
  const Report half = QR::approximate_seamless_parametrization(
    mesh, uv, parameters::target_edge_length(2));
  CHECK(std::abs(half.extent - unit.extent / 2) <= 1e-12 * unit.extent);

  // A flat square is mapped isometrically.
  double area = 0;
  for(const auto f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    area += CGAL::area(uv[mesh.prev(h)], uv[h], uv[mesh.next(h)]);
  }
  CHECK(std::abs(area - 4) <= 1e-9);
}

void test_curvature_alignment()
{
  Mesh mesh = torus(24, 10);
  const Uv_map uv = new_uv_map(mesh);
  const Report report = QR::approximate_seamless_parametrization(
    mesh, uv, parameters::curvature_alignment(0.5));
  check_snappable("torus along its curvature", report, mesh, uv);
  // The principal directions of a torus of revolution have no singularity.
  CHECK_EQUAL(report.cones.size(), std::size_t(0));
}

// A surface without features, as the steps of parametrizing read it.
QR::internal::parametrization::Triangle_surface flat_surface(const Mesh& mesh)
{
  namespace P = QR::internal::parametrization;
  const QR::internal::Flat_numbering<Mesh> numbering(mesh);
  P::Triangle_surface surface;
  QR::internal::read_flat_mesh<CGAL::Sequential_tag>(
    mesh, numbering, surface, [](QR::internal::Flat_corner&, Halfedge) { });
  P::find_components(surface);
  P::read_geometry(QR::internal::places_of(numbering.vertices_in_order(), mesh.points()), surface);
  surface.is_aligned.resize(std::size_t(surface.number_of_halfedges()), false);
  return surface;
}

// Of a flat square, all crosses turn to where one of them is wanted, as all others are free.
void test_wanted_cross_with_given_rotations()
{
  namespace P = QR::internal::parametrization;
  const Mesh mesh = grid(6);
  const P::Triangle_surface surface = flat_surface(mesh);
  double seconds = 0;
  P::Timed_solver solver(seconds);
  const std::size_t size = std::size_t(surface.number_of_faces());
  const std::vector<double> before =
    P::cross_field(surface, P::wanted_field(surface, P::Parametrization_options()), 0, solver);
  for(const double turn : {0.2, -0.7}) {
    std::vector<double> angles = before;
    P::Matching matching = P::match_crosses(surface, angles);
    P::Prescribed_field wanted(size);
    wanted[7] = 0.5 * P::cross_of_angle(angles[7] + turn);
    P::smoothen_matched_field(surface, std::vector<char>(size, false), wanted, angles, matching,
                              solver);
    for(std::size_t f = 0; f < size; ++f)
      CHECK(std::abs(angles[f] - before[f] - turn) < 1e-9);
  }
}

// A square in space, whose coordinates have to be turned by 20 degrees against that of its sides.
void test_given_directions()
{
  using Vector_3 = Kernel::Vector_3;
  constexpr int n = 5;
  const Vector_3 side(2, 1, 0), other(-1, 2, 3), normal = CGAL::cross_product(side, other);
  const Vector_3 x = side / std::sqrt(side.squared_length());
  const Vector_3 y = CGAL::cross_product(normal, x) / std::sqrt(normal.squared_length());
  const double angle = 20 * std::acos(-1.) / 180;
  Mesh mesh;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      mesh.add_vertex(CGAL::ORIGIN + i * side + j * other + 0.1 * ((i * j) % 3) * side);
  for(int i = 0; i + 1 < n; ++i)
    for(int j = 0; j + 1 < n; ++j) {
      const Vertex a(n * i + j), b(n * i + n + j), c(n * i + n + j + 1), d(n * i + j + 1);
      mesh.add_face(a, b, c);
      mesh.add_face(c, d, a);
    }
  const auto direction =
    mesh.add_property_map<Mesh::Face_index, Vector_3>("f:direction", Vector_3(0, 0, 0)).first;
  const auto np = parameters::face_direction_map(direction);
  for(const bool is_for_all : {false, true}) { // of one face only, the others follow
    for(const auto f : mesh.faces())
      if(is_for_all || f == Mesh::Face_index(7)) // each of the four of a cross will do
        direction[f] = (is_for_all ? 1e-200 : 1e200) * // whose squares are 0 and infinite
                       (std::cos(angle + std::acos(0.) * int(f)) * x +
                        std::sin(angle + std::acos(0.) * int(f)) * y + 0.5 * normal);
    const Uv_map uv = mesh.add_property_map<Halfedge, Point_2>().first;
    const auto report = QR::approximate_seamless_parametrization(mesh, uv, np);
    CHECK_IN(report.message, bool(report));
    CHECK(report.cones.empty() && report.number_of_flipped_faces == 0);
    for(const Halfedge h : mesh.halfedges()) {
      if(mesh.is_border(h))
        continue;
      const Vector_3 edge = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
      const auto in_plane = uv[h] - uv[mesh.prev(h)];
      const double turn = std::atan2(in_plane.y(), in_plane.x()) -
                          std::atan2(edge * y, edge * x) + angle; // some quarter turns
      CHECK(std::abs(std::sin(2 * turn)) < 1e-6);
    }
  }
  const Uv_map uv = new_uv_map(mesh);
  const auto index = mesh.add_property_map<Vertex, int>("v:index", 0).first;
  CHECK(QR::approximate_seamless_parametrization(mesh, uv, np.cone_index_map(index)).status ==
        Outcome::INVALID_ARGUMENT);
  direction[Mesh::Face_index(3)] = Vector_3(1, std::numeric_limits<double>::quiet_NaN(), 0);
  const auto refused = QR::approximate_seamless_parametrization(mesh, uv, np);
  CHECK(refused.status == Outcome::NOT_FINITE &&
        refused.message.find("face 3") != std::string::npos);
  CHECK(is_untouched(mesh, uv));
}

// Sizes that vary by 4: how long a unit of the plane is on the surface, in the median of the faces.
template <typename SizeAt>
void check_sizes(const std::string& name, Mesh mesh, const SizeAt& size_at)
{
  const auto size = mesh.add_property_map<Vertex, double>("v:size").first;
  for(const Vertex v : mesh.vertices())
    size[v] = size_at(mesh.point(v));
  const auto [least, most] = std::minmax_element(size.begin(), size.end());
  CHECK_IN(name, *most / *least > 3.9 && *most / *least < 4.1);
  const Uv_map uv = new_uv_map(mesh);
  const Report report =
    QR::approximate_seamless_parametrization(mesh, uv, parameters::vertex_sizing_map(size));
  check_snappable(name, report, mesh, uv);
  CHECK_IN(name, report.number_of_flipped_faces == 0);
  std::vector<double> ratios; // of the length to the one asked for
  for(const auto f : mesh.faces()) {
    const Halfedge g = mesh.halfedge(f), h = mesh.next(g), i = mesh.next(h);
    const Point_3 &p = mesh.point(mesh.target(g)), &q = mesh.point(mesh.target(h)),
                  &r = mesh.point(mesh.target(i));
    ratios.push_back(std::sqrt(std::sqrt(CGAL::squared_area(p, q, r)) /
                               CGAL::area(uv[g], uv[h], uv[i])) / size_at(CGAL::centroid(p, q, r)));
  }
  std::sort(ratios.begin(), ratios.end());
  const double median = ratios[ratios.size() / 2];
  CHECK_IN(name + ": median ratio " + std::to_string(median), median > 0.85 && median < 1.15);
  for(double& ratio : ratios)
    ratio = std::abs(std::log(ratio));
  std::sort(ratios.begin(), ratios.end());
  const double deviation = ratios[ratios.size() / 2];
  CHECK_IN(name + ": median deviation " + std::to_string(deviation), deviation < std::log(1.15));
  std::cout << name << ": median ratio " << median << ", median deviation " << deviation << ", "
            << report.cones.size() << " cones" << std::endl;
}

void test_sizes()
{
  check_sizes("square, exponential sizes", grid(20), [](const Point_3& p)
              { return std::exp(std::log(4.) * p.x() / 20); });
  check_sizes("square, small in the middle", grid(40), [](const Point_3& p) {
    const double x = p.x() / 20 - 1, y = p.y() / 20 - 1;
    return std::exp(-std::log(4.) * std::exp(-6 * (x * x + y * y)));
  });
  check_sizes("sphere, 4 times larger on one side", icosphere(4), [](const Point_3& p)
              { return std::exp(std::log(4.) * p.x() / std::sqrt(p.x() * p.x() + p.y() * p.y() +
                                                                  p.z() * p.z()) / 2); });
  check_sizes("torus", torus(60, 24), [](const Point_3& p)
              { return std::exp(std::log(4.) * p.x() / 8); });

  // Sizes that are all the same are a target edge length.
  Mesh mesh = grid(5);
  const auto size = mesh.add_property_map<Vertex, double>("v:size", 3).first;
  const Uv_map uv = new_uv_map(mesh), other = mesh.add_property_map<Halfedge, Point_2>().first;
  CHECK(bool(QR::approximate_seamless_parametrization(
    mesh, uv, parameters::vertex_sizing_map(size).target_edge_length(0.5))));
  CHECK(bool(QR::approximate_seamless_parametrization(mesh, other,
                                                      parameters::target_edge_length(1.5))));
  for(const Halfedge h : mesh.halfedges())
    CHECK(mesh.is_border(h) || uv[h] == other[h]);
  for(const double bad : {0., -1., 1e-9, std::numeric_limits<double>::infinity(),
                          std::nan("")}) { // all others are 3
    size[Vertex(7)] = bad;
    const Uv_map none = new_uv_map(mesh);
    const auto refused =
      QR::approximate_seamless_parametrization(mesh, none, parameters::vertex_sizing_map(size));
    CHECK(refused.status == Outcome::INVALID_ARGUMENT &&
          refused.message.find("size") != std::string::npos);
  }
}

// Where a surface is flat, the faces are mapped to less.
void test_sizes_by_curvature()
{
  Mesh mesh = height_field(30);
  for(const Vertex v : mesh.vertices())
    if(mesh.point(v).x() > 15)
      mesh.point(v) = Point_3(mesh.point(v).x(), mesh.point(v).y(), 0);
  const auto mean_size = [&](const Uv_map& uv, const bool is_flat) {
    double plane = 0, space = 0;
    for(const auto f : mesh.faces()) {
      const Halfedge g = mesh.halfedge(f), h = mesh.next(g), i = mesh.next(h);
      const Point_3 &p = mesh.point(mesh.target(g)), &q = mesh.point(mesh.target(h)),
                    &r = mesh.point(mesh.target(i));
      if((CGAL::centroid(p, q, r).x() > 20) != is_flat)
        continue;
      space += std::sqrt(CGAL::squared_area(p, q, r));
      plane += CGAL::area(uv[g], uv[h], uv[i]);
    }
    return std::sqrt(space / plane);
  };
  for(const double adaptivity : {1., 4.}) {
    const Uv_map uv = mesh.add_property_map<Halfedge, Point_2>().first;
    CHECK(bool(QR::approximate_seamless_parametrization(
      mesh, uv, parameters::curvature_adaptivity(adaptivity))));
    const double ratio = mean_size(uv, true) / mean_size(uv, false);
    std::cout << "curvature_adaptivity " << adaptivity << ": ratio " << ratio << std::endl;
    CHECK(adaptivity == 1 ? ratio < 1.3 : ratio > 1.6 && ratio < 4.5);
  }
  const Uv_map uv = new_uv_map(mesh);
  CHECK(QR::approximate_seamless_parametrization(mesh, uv, parameters::curvature_adaptivity(0.5))
          .status == Outcome::INVALID_ARGUMENT);
  CHECK(is_untouched(mesh, uv));
}

void test_given_cones()
{
  std::vector<std::pair<int, int> > cones;
  for(int v = 0; v < 8; ++v)
    cones.emplace_back(v, 1);
  check_given_cones("sphere with 8 cones", icosphere(2), cones);
  check_given_cones("sphere with 4 cones", icosphere(2), {{0, 2}, {3, 2}, {6, 2}, {9, 2}});
  check_given_cones("torus without cones", torus(12, 8), {});
  check_given_cones("torus with 4 cones", torus(12, 8), {{0, 1}, {5, 1}, {40, -1}, {64, -1}});
  check_given_cones("disk with 3 cones", grid(8), {{20, 1}, {40, 1}, {60, -1}});
}

// The turns around handles, and between border loops, are any numbers before they are rounded.
void test_given_cones_around_handles()
{
  const Mesh pants = test_meshes::make_mesh<Kernel>(test_meshes::pair_of_pants(), 2);
  const Mesh box = test_meshes::make_mesh<Kernel>(test_meshes::box_with_holes(), 2);
  const Mesh two_handles = slab(2, false);
  std::vector<std::pair<int, int> > eight_cones;
  for(int i = 0; i < 8; ++i)
    eight_cones.emplace_back(5 * i, -1);
  for(unsigned int seed = 0; seed < 12; ++seed) {
    const std::string suffix = ", given cones, seed " + std::to_string(seed);
    check_given_cones("torus" + suffix, perturbed(torus(9, 7), 0.2, seed), {});
    check_given_cones("genus 2" + suffix, perturbed(two_handles, 0.05, seed), eight_cones);
    check_given_cones("pair of pants" + suffix, perturbed(pants, 0.03, seed), {});
    check_given_cones("box with three holes" + suffix, perturbed(box, 0.03, seed), {});
  }
}

// Where cones of a torus cancel, it keeps those that it has no map without.
void test_cones_of_tori()
{
  for(const std::size_t n : {12, 20, 30})
    for(const std::size_t m : {4, 5, 6}) {
      Mesh mesh = torus(n, m);
      const Report report = QR::approximate_seamless_parametrization(
        mesh, new_uv_map(mesh), parameters::least_cone_distance(1e9));
      CHECK_EQUAL(report.number_of_flipped_faces, 0u);
    }
}

// Without features, opposite cones cancel whatever their distance is, until all have the same sign,
// or a torus would have no map; features, and directions in all faces, keep theirs.
void test_cone_distance()
{
  const auto any_distance =
    parameters::least_cone_distance(1e9).number_of_untangling_iterations(0);
  const auto sum_of_indices = [](const Report& report) {
    int sum = 0;
    for(const auto& cone : report.cones)
      sum += std::abs(cone.second);
    return sum;
  };
  for(const unsigned int seed : {0u, 1u, 2u})
    for(Mesh mesh : {perturbed(icosphere(3), 0.08, seed), perturbed(torus(24, 10), 0.2, seed),
                     perturbed(slab(2, true), 0.08, seed)}) {
      const std::string context = "seed " + std::to_string(seed);
      const auto no_untangling = parameters::number_of_untangling_iterations(0);
      const Uv_map uv = new_uv_map(mesh);
      const Report all = QR::approximate_seamless_parametrization(mesh, uv, no_untangling);
      const Report some = QR::approximate_seamless_parametrization(
        mesh, uv, no_untangling.least_cone_distance(0.5));
      const Report few = QR::approximate_seamless_parametrization(
        mesh, uv, any_distance.curvature_alignment(seed == 2 ? 0.002 : 0));
      check_result(mesh, uv, few, exact_check::No_edge_aligned(), parameters::default_values());
      if(few.euler_characteristic != 0 || sum_of_indices(few) < 4)
        CHECK_EQUAL(sum_of_indices(few), std::abs(4 * int(few.euler_characteristic)));
      CHECK_IN(context, sum_of_indices(few) <= sum_of_indices(some) &&
                          sum_of_indices(some) <= sum_of_indices(all) &&
                          sum_of_indices(few) < sum_of_indices(all));
    }

  Mesh cube = [] {
    square_complex::Square_complex complex = test_meshes::box(1, 1, 1);
    test_meshes::mark_creases(complex);
    return test_meshes::make_mesh<Kernel>(complex, 4);
  }();
  const auto cones = [](Mesh& mesh, const auto& np) {
    return QR::approximate_seamless_parametrization(mesh, new_uv_map(mesh), np).cones;
  };
  const auto creases = test_meshes::feature_map(cube);
  CHECK(cones(cube, any_distance.edge_is_constrained_map(creases)) ==
        cones(cube, parameters::edge_is_constrained_map(creases)));
  Mesh rough = perturbed(icosphere(3), 0.08, 0);
  std::set<std::vector<int> > known; // no map is made of a field again
  CHECK(!cones(rough, parameters::known_fields(&known)).empty());
  CHECK(!cones(rough, any_distance.known_fields(&known)).empty() && known.size() == 2);
  const Report again = QR::approximate_seamless_parametrization(
    rough, new_uv_map(rough), parameters::least_cone_distance(1e8).known_fields(&known));
  CHECK(again.status == Outcome::INVALID_ARGUMENT && again.message == "the field is known");
  const auto direction = rough.add_property_map<Mesh::Face_index, Kernel::Vector_3>(
    "f:direction", Kernel::Vector_3(1, 2, 3)).first;
  CHECK(cones(rough, any_distance.face_direction_map(direction)) ==
        cones(rough, parameters::face_direction_map(direction)));
}

// On large surfaces, the field is made smooth only near edges across which it turns by another
// rotation: what is farther away stays as it is. Nothing is near that is farther away along a
// straight line.
void test_fields_near_cones()
{
  namespace P = QR::internal::parametrization;
  using QR::internal::Corner_index;
  for(const unsigned int seed : {0u, 1u, 2u}) {
    const std::string context = "seed " + std::to_string(seed);
    const Mesh mesh = perturbed(icosphere(4), 0.01, seed);
    const P::Triangle_surface surface = flat_surface(mesh);
    const double scale = std::ldexp(1., -surface.exponent);
    const std::size_t size = std::size_t(surface.number_of_faces());
    double seconds = 0;
    P::Timed_solver solver(seconds);
    const P::Wanted_field wanted = P::wanted_field(surface, P::Parametrization_options());
    const std::vector<double> before = P::cross_field(surface, wanted, 0, solver);
    P::Matching matching = P::match_crosses(surface, before);
    for(const Corner_index h : {100, 5000, 14000})
      P::set_turns(surface, before, h, matching.turns[std::size_t(h)] + 1, matching);
    const std::vector<char> none(size, false);
    std::vector<char> is_far(size, false);
    P::fix_far_faces(surface, matching, 0.4 * scale, is_far);

    const auto energy_of = [&](const P::Matching& m) {
      double result = 0;
      for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
        result += P::dual_weight(surface, h) * m.deviation[h] * m.deviation[h];
      return result;
    };
    std::vector<double> energies;
    for(const std::vector<char>& is_fixed : {none, is_far}) {
      std::vector<double> angles = before;
      P::Matching smooth = matching;
      P::smoothen_matched_field(surface, is_fixed, wanted.crosses, angles, smooth, solver);
      energies.push_back(energy_of(smooth));
      for(std::size_t f = 0; f < size; ++f)
        CHECK(!is_fixed[f] || angles[f] == before[f]);
    }
    const auto number = std::count(is_far.begin(), is_far.end(), char(true));
    std::cout << context << ": " << number << " faces of " << size << " are far away; energy "
              << energy_of(matching) << " -> " << energies[1] << ", " << energies[0]
              << " if all faces may turn" << std::endl;
    CHECK_IN(context, number > 0 && number < std::ptrdiff_t(size) && energies[0] < energies[1] &&
                        energies[1] < energy_of(matching));

    std::vector<Point_3> sources;
    const auto point = [&](const std::size_t v)
      { return mesh.point(Mesh::Vertex_index(Mesh::size_type(v))); };
    for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
      if(std::abs(matching.deviation[h]) >= P::quarter_turn / 2) {
        sources.push_back(point(surface.vertex(h)));
        CHECK(!is_far[std::size_t(h / 3)]);
      }
    for(Corner_index h = 0; h < surface.number_of_halfedges(); h += 3)
      CHECK(is_far[std::size_t(h / 3)] ||
            std::any_of(sources.begin(), sources.end(), [&](const Point_3& p) {
              const auto is_near = [&](const Corner_index g) {
                return CGAL::squared_distance(p, point(surface.vertex(g))) < 0.16 + 1e-9;
              };
              return is_near(h) || is_near(h + 1) || is_near(h + 2);
            }));
  }
}

// A sphere of latitudes and longitudes, whose upper half is `height` above the lower one. Diagonals
// run one way, or each second one the other way.
Mesh capsule(const std::size_t n, const double height, const bool is_alternating)
{
  Mesh mesh;
  std::vector<Vertex> v;
  for(std::size_t i = 1; i < n; ++i)
    for(std::size_t j = 0; j < 2 * n; ++j) {
      const double a = 3.141592653589793 * double(i) / double(n);
      const double b = 3.141592653589793 * double(j) / double(n);
      const double z = std::cos(a) + (2 * i < n ? height : 0);
      v.push_back(mesh.add_vertex(Point_3(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b),
                                          z)));
    }
  const Vertex top = mesh.add_vertex(Point_3(0, 0, 1 + height));
  const Vertex bottom = mesh.add_vertex(Point_3(0, 0, -1));
  const auto at = [&](std::size_t i, std::size_t j) { return v[i * 2 * n + j % (2 * n)]; };
  for(std::size_t j = 0; j < 2 * n; ++j) {
    mesh.add_face(top, at(0, j), at(0, j + 1));
    mesh.add_face(bottom, at(n - 2, j + 1), at(n - 2, j));
    for(std::size_t i = 0; i + 2 < n; ++i) {
      const Vertex a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      const bool is_other = is_alternating && (i + j) % 2 == 1;
      mesh.add_face(a, b, is_other ? d : c);
      mesh.add_face(is_other ? b : a, c, d);
    }
  }
  return mesh;
}

// Where the surface curves alike in all directions, how its triangles run does not direct the
// field: the cones of a sphere are far apart, as the corners of a cube are, and also on its halves.
void test_cones_of_spheres()
{
  constexpr double least = 0.8, strength = 0.002; // corners of a cube are 1.15 apart
  for(const auto& [n, height] : {std::make_pair(16u, 0.), std::make_pair(32u, 0.),
                                 std::make_pair(32u, 3.)})
    for(const bool is_alternating : {false, true}) {
      Mesh mesh = capsule(n, height, is_alternating);
      const std::string context = "sphere of " + std::to_string(n) + " latitudes, height " +
                                  std::to_string(height);
      const Report report = QR::approximate_seamless_parametrization(
        mesh, new_uv_map(mesh), parameters::curvature_alignment(strength));
      CHECK_IN(context, report.cones.size() == 8);
      for(const auto& [v, index] : report.cones)
        for(const auto& [w, other] : report.cones)
          CHECK_IN(context, v == w || CGAL::squared_distance(mesh.point(v), mesh.point(w)) >
                                        least * least);
    }
}

// The ends of a capsule of few segments, whose faces are then divided in their planes: next to the
// poles, single bends tell of the mesh, and the surface is symmetric around its axis. The cones of
// an end are still far from the pole and from each other. Without alignment, they are as far apart.
void test_cones_of_divided_ends()
{
  constexpr double least = 0.45, strength = 0.002; // a cone at the pole has the distance 0
  for(const auto& [n, height] : {std::make_pair(12u, 1.), std::make_pair(12u, 3.),
                                 std::make_pair(24u, 3.)})
    for(const bool is_alternating : {false, true}) {
      Mesh mesh = capsule(n, height, is_alternating);
      CGAL::Subdivision_method_3::PTQ(mesh, Linear_mask{mesh},
                                      CGAL::parameters::number_of_iterations(1));
      const std::string context = "capsule of " + std::to_string(2 * n) + " segments, height " +
                                  std::to_string(height);
      const Report report = QR::approximate_seamless_parametrization(
        mesh, new_uv_map(mesh), parameters::curvature_alignment(strength));
      CHECK_IN(context, report.cones.size() == 8);
      for(const auto& [v, index] : report.cones) {
        const Point_3& p = mesh.point(v);
        CHECK_IN(context, index == 1);
        CHECK_IN(context, p.x() * p.x() + p.y() * p.y() > least * least);
        for(const auto& [w, other] : report.cones)
          CHECK_IN(context, v == w || CGAL::squared_distance(p, mesh.point(w)) > least * least);
      }
    }
}

// A cone of 8 half turns has no room in the 6 faces around a vertex: no round of stiffening helps,
// but those that fail must not cost the coordinates either.
void test_unavoidable_flips()
{
  Mesh mesh = grid(6);
  const Uv_map uv = new_uv_map(mesh);
  auto index = mesh.add_property_map<Vertex, int>("v:index", 0).first;
  index[Vertex(24)] = -12;
  const auto cone = parameters::cone_index_map(index);
  const Report report = QR::approximate_seamless_parametrization(
    mesh, uv, cone.number_of_iterations(2000));
  CHECK(report.number_of_flipped_faces > 0);
  CHECK_EQUAL(report.cones.size(), std::size_t(1)); // untangling would make it a regular vertex
  check_result(mesh, uv, report, exact_check::No_edge_aligned(), parameters::default_values());
  const Report unstiffened = QR::approximate_seamless_parametrization(
    mesh, uv, cone.number_of_iterations(0));
  CHECK(report.number_of_flipped_faces <= unstiffened.number_of_flipped_faces);
}

// Features that end anywhere, meet at any angle, and enclose faces: many can't be followed without
// flips.
void test_release(const unsigned int seed)
{
  std::cout << "random features, seed " << seed << std::endl;
  CGAL::Random random(seed);
  Mesh mesh = seed % 2 == 0 ? icosphere(2) : slab(1, true);
  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:random_feature", false).first;
  std::size_t count = 0;
  for(int path = 0; path < 12; ++path) {
    Halfedge h(Mesh::size_type(random.get_int(0, int(mesh.number_of_halfedges()))));
    for(int i = 0; i < 8 && !mesh.is_border(h); ++i) {
      count += is_feature[mesh.edge(h)] ? 0 : 1;
      is_feature[mesh.edge(h)] = true;
      h = mesh.next(h);
      for(int turn = random.get_int(1, 4); turn > 0 && !mesh.is_border(mesh.opposite(h)); --turn)
        h = mesh.next(mesh.opposite(h));
    }
  }
  const Uv_map uv = new_uv_map(mesh);
  const auto alignment = parameters::edge_is_constrained_map(is_feature);
  const Report report =
    QR::approximate_seamless_parametrization(mesh, uv, alignment.release_alignment(true));
  for(const auto& [v, w] : report.released_edges) {
    const Halfedge h = mesh.halfedge(v, w);
    CHECK(h != Mesh::null_halfedge() && is_feature[mesh.edge(h)]); // and each once
    is_feature[mesh.edge(h)] = false;
  }
  CHECK_EQUAL(report.number_of_aligned_edges + report.released_edges.size(), count);
  CHECK_EQUAL(report.number_of_flipped_faces, std::size_t(0));
  check_result(mesh, uv, report, [&](const Mesh::Edge_index e) { return is_feature[e]; },
               parameters::edge_is_constrained_map(is_feature));
  CHECK(exact_check::check(mesh, uv).flipped_faces == 0); // after snapping
}

// A strip around a tube whose ends are held by steps of the features: nothing but the release of
// an edge helps, and without it the number of flips is not raised by untangling.
void test_untangling_without_release()
{
  Mesh mesh = icosphere(2);
  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:some_feature", false).first;
  for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(Mesh::Face_index(5))))
    for(const Halfedge g : mesh.halfedges_around_face(mesh.opposite(h)))
      is_feature[mesh.edge(g)] = g != mesh.opposite(h);
  const Uv_map uv = new_uv_map(mesh);
  const auto alignment = parameters::edge_is_constrained_map(is_feature);
  const Report without = QR::approximate_seamless_parametrization(
    mesh, uv, alignment.number_of_untangling_iterations(0));
  CHECK_EQUAL(without.number_of_untangling_iterations, std::size_t(0));
  CHECK_EQUAL(without.number_of_flipped_faces, without.number_of_flips_before_untangling);
  const Report with = QR::approximate_seamless_parametrization(mesh, uv, alignment);
  CHECK_EQUAL(with.number_of_flips_before_untangling, without.number_of_flipped_faces);
  CHECK(with.number_of_flipped_faces <= without.number_of_flipped_faces);
  CHECK(with.released_edges.empty());
  check_result(mesh, uv, with, [&](const Mesh::Edge_index e) { return is_feature[e]; }, alignment);
}

void test_other_types()
{
  Mesh mesh = icosphere(1);
  const Uv_map uv = new_uv_map(mesh);
  using Solver = CGAL::Eigen_solver_traits<
    Eigen::SimplicialLDLT<CGAL::Eigen_sparse_matrix<double>::EigenType> >;
  check_snappable("solver of Eigen", QR::approximate_seamless_parametrization(
                    mesh, uv, parameters::sparse_linear_solver(Solver())), mesh, uv);

  using Float_point = CGAL::Simple_cartesian<float>::Point_2;
  auto float_uv = mesh.add_property_map<Halfedge, Float_point>("h:float_uv").first;
  const Report float_report = QR::approximate_seamless_parametrization(mesh, float_uv);
  CHECK(float_report);
  const exact_check::Result measured = exact_check::check(mesh, float_uv);
  CHECK(measured.largest_violation > 0);
  CHECK(std::abs(float_report.violation - measured.largest_violation)
        <= 1e-6 * measured.largest_violation);
  CHECK_EQUAL(float_report.number_of_flipped_faces,
              measured.degenerate_faces + measured.flipped_faces);
  for(const Halfedge h : mesh.halfedges())
    uv[h] = Point_2(float_uv[h].x(), float_uv[h].y());
  CHECK(QR::snap_to_seamless(mesh, uv) && QR::is_seamless(mesh, uv));

  CGAL::Polyhedron_3<Kernel> polyhedron;
  CGAL::make_icosahedron<CGAL::Polyhedron_3<Kernel>, Point_3>(polyhedron);
  auto polyhedron_uv = get(CGAL::dynamic_halfedge_property_t<Point_2>(), polyhedron);
  const auto points = get(CGAL::vertex_point, polyhedron);
  CHECK(QR::approximate_seamless_parametrization(polyhedron, polyhedron_uv,
                                                  CGAL::parameters::vertex_point_map(points)));
  Mesh copy;
  std::vector<std::pair<CGAL::Polyhedron_3<Kernel>::Halfedge_handle, Halfedge> > halfedges;
  CGAL::copy_face_graph(
    polyhedron, copy,
    CGAL::parameters::halfedge_to_halfedge_output_iterator(std::back_inserter(halfedges)));
  const Uv_map copy_uv = new_uv_map(copy);
  for(const auto& [original, h] : halfedges)
    copy_uv[h] = get(polyhedron_uv, original);
  CHECK(QR::snap_to_seamless(copy, copy_uv) && QR::is_seamless(copy, copy_uv));
}

// --- bad input -----------------------------------------------------------------------------------

void test_refused_meshes()
{
  const auto none = parameters::default_values();
  check_refused("no face", Mesh(), Outcome::INVALID_ARGUMENT, none);

  Mesh quad;
  CGAL::make_quad(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0), quad);
  check_refused("quadrangle", quad, Outcome::NOT_TRIANGULAR, none,
                "face 0 has 4 edges");

  // Two triangles that have one vertex in common, and nothing else.
  Mesh bow_tie;
  std::array<Vertex, 5> v;
  for(std::size_t i = 0; i < 5; ++i)
    v[i] = bow_tie.add_vertex(Point_3(double(i % 3), double(i / 2), 0));
  bow_tie.add_face(v[0], v[1], v[2]);
  bow_tie.add_face(v[0], v[3], v[4]);
  check_refused("two fans", bow_tie, Outcome::NOT_MANIFOLD, none,
                "vertex of face ");

  for(const double x : {std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<double>::infinity()}) {
    Mesh mesh = icosphere(0);
    mesh.point(Vertex(3)) = Point_3(0, x, 0);
    check_refused("not finite", mesh, Outcome::NOT_FINITE, none,
                  "vertex of face ");
  }
}

void test_ranges()
{
  Mesh point = scaled(icosphere(0), 0);
  check_refused("point", point, Outcome::INVALID_ARGUMENT,
                parameters::default_values());
  for(const double length : {1e-310, 1e308})
    check_refused("length out of range", scaled(icosphere(1), 1e-4),
                  Outcome::INVALID_ARGUMENT,
                  parameters::target_edge_length(length), "target_edge_length");

  // What counts is the result.
  for(const double scale : {1e-305, 1e-200, 1e-100, 1e100, 1e200, 1e307}) {
    Mesh mesh = scaled(icosphere(1), scale);
    const Uv_map uv = new_uv_map(mesh);
    for(const double length : {(std::max)(1., scale / 1e290), scale})
      for(const double curvature_alignment : {0., 1.}) {
        const Report report = QR::approximate_seamless_parametrization(
          mesh, uv, parameters::target_edge_length(length)
                    .curvature_alignment(curvature_alignment));
        check_result(mesh, uv, report, exact_check::No_edge_aligned(),
                     parameters::default_values());
      }
    using Float_point = CGAL::Simple_cartesian<float>::Point_2;
    auto float_uv = mesh.add_property_map<Halfedge, Float_point>("h:float_uv",
                                                                 Float_point(-7, 7)).first;
    CHECK_EQUAL(int(QR::approximate_seamless_parametrization(mesh, float_uv).status),
                int(Outcome::INVALID_ARGUMENT));
    CHECK(*float_uv.begin() == Float_point(-7, 7));
    CHECK(QR::approximate_seamless_parametrization(mesh, float_uv,
                                                    parameters::target_edge_length(scale)));
  }
}

// Each component counts by itself, however small it is.
void test_components_of_all_sizes()
{
  Mesh mesh;
  for(const double size : {1e8, 1., 1e-4, 1e-8}) {
    mesh += scaled(height_field(6), size);
    mesh += scaled(grid(4), size);
    mesh += scaled(icosphere(1), size);
    mesh += scaled(torus(9, 7), size);
  }
  check_parametrization("components of all sizes", mesh);
}

// The smoothest field has all its turns at the tips, where no angle would be left.
void test_spikes()
{
  Mesh mesh; // two long pyramids on a hexagon
  std::array<Vertex, 6> ring;
  const Vertex a = mesh.add_vertex(Point_3(0, 0, -50)), b = mesh.add_vertex(Point_3(0, 0, 50));
  for(std::size_t i = 0; i < 6; ++i) {
    const double angle = 3.141592653589793 / 3 * double(i);
    ring[i] = mesh.add_vertex(Point_3(std::cos(angle), std::sin(angle), 0));
  }
  for(std::size_t i = 0; i < 6; ++i) {
    mesh.add_face(ring[(i + 1) % 6], ring[i], a);
    mesh.add_face(ring[i], ring[(i + 1) % 6], b);
  }
  check_parametrization("two spikes", mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(2));
  check_parametrization("two spikes, smooth", mesh);
}

void test_tiny_meshes()
{
  Mesh triangle;
  CGAL::make_triangle(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), triangle);
  check_refused("triangle with aligned border", triangle,
                Outcome::INVALID_ALIGNMENT, parameters::align_border(true));
  const CGAL::Static_boolean_property_map<Mesh::Edge_index, false> no_feature;
  check_alignment("square", grid(1), no_feature, true);
  Mesh mesh = tetrahedron();
  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  for(const auto e : mesh.edges()) { // two opposite edges, then a circle of four
    is_feature[e] = true;
    check_alignment("tetrahedron with a feature", mesh, is_feature, false);
    is_feature[e] = false;
  }
  check_given_cones("tetrahedron of half turns", mesh, {{0, 2}, {1, 2}, {2, 2}, {3, 2}});
  check_given_cones("tetrahedron of three quarters", mesh, {{0, 3}, {1, 3}, {2, 3}, {3, -1}});
  check_given_cones("triangle", triangle, {});
}

void test_refused_parameters()
{
  const Mesh sphere = icosphere(0);
  check_refused("length 0", sphere, Outcome::INVALID_ARGUMENT,
                parameters::target_edge_length(0.));
  check_refused("length NaN", sphere, Outcome::INVALID_ARGUMENT,
                parameters::target_edge_length(std::numeric_limits<double>::quiet_NaN()));
  check_refused("negative curvature alignment", sphere, Outcome::INVALID_ARGUMENT,
                parameters::curvature_alignment(-1.));
  check_refused("curvature alignment that rounding hides", sphere, Outcome::INVALID_ARGUMENT,
                parameters::curvature_alignment(1e-20));
  check_refused("negative number of iterations", sphere, Outcome::INVALID_ARGUMENT,
                parameters::number_of_iterations(-1));

  Mesh mesh = sphere;
  auto index = mesh.add_property_map<Vertex, int>("v:index", 0).first;
  check_refused("sphere without cones", mesh, Outcome::INVALID_CONES,
                parameters::cone_index_map(index));
  for(int i = 0; i < 9; ++i)
    index[Vertex(Mesh::size_type(i))] = 1;
  check_refused("nine cones", mesh, Outcome::INVALID_CONES,
                parameters::cone_index_map(index));
  index[Vertex(8)] = 0;
  index[Vertex(0)] = 4;
  index[Vertex(1)] = -2;
  check_refused("cone without an angle", mesh, Outcome::INVALID_CONES,
                parameters::cone_index_map(index), "a vertex of face ");
  index[Vertex(0)] = index[Vertex(1)] = 1;
  check_refused("cones and their distance", mesh, Outcome::INVALID_ARGUMENT,
                parameters::cone_index_map(index).least_cone_distance(1));
  check_refused("negative distance of cones", mesh, Outcome::INVALID_ARGUMENT,
                parameters::least_cone_distance(-1));
  check_refused("cones and curvature", mesh, Outcome::INVALID_ARGUMENT,
                parameters::cone_index_map(index).curvature_alignment(1.));

  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(*mesh.faces().begin())))
    is_feature[mesh.edge(h)] = true;
  check_refused("three features", mesh, Outcome::INVALID_ALIGNMENT,
                parameters::edge_is_constrained_map(is_feature));
  check_refused("cones and features", mesh, Outcome::INVALID_ARGUMENT,
                parameters::edge_is_constrained_map(is_feature).cone_index_map(index));
}

// --- the elimination -----------------------------------------------------------------------------

// Equations without a coefficient of 1 or -1, which meshes hardly ever lead to: the free unknowns
// span the solutions.
void test_equations_without_units()
{
  using Row = QR::internal::Entries<std::int64_t>;
  constexpr std::size_t number_of_columns = 7, rank = 4;
  QR::internal::Integer_system system(number_of_columns);
  const std::vector<Row> rows = {{{0, 2}, {1, 3}}, {{1, 4}, {2, -6}, {3, 9}}, {{3, 1}, {4, 2}},
                                 {{5, 10}}, {{1, 8}, {2, -12}, {3, 18}}};
  for(const Row& row : rows)
    system.add_row(row, 0);
  const QR::internal::Free_unknowns unknowns(system);
  CHECK_EQUAL(unknowns.size(), number_of_columns - rank);

  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(number_of_columns, Eigen::Index(unknowns.size()));
  for(std::size_t c = 0; c < number_of_columns; ++c)
    for(const auto& [unknown, coefficient] : unknowns.sum(c))
      sums(Eigen::Index(c), Eigen::Index(unknown)) = coefficient;
  CHECK_EQUAL(std::size_t(sums.fullPivLu().rank()), unknowns.size());
  for(const Row& row : rows) {
    Eigen::RowVectorXd left_hand_side = Eigen::RowVectorXd::Zero(sums.cols());
    for(const auto& entry : row)
      left_hand_side += double(entry.coefficient) * sums.row(entry.column);
    CHECK(left_hand_side.isZero(0));
  }
}

// --- what is for large meshes --------------------------------------------------------------------

// More terms than are kept at a time, with two sets of values: solutions meet the sums of terms.
void test_matrix_of_many_terms(const std::size_t size, const std::size_t number_of_edges)
{
  namespace P = QR::internal::parametrization;
  double seconds = 0;
  P::Timed_solver solver(seconds);
  P::Sparse_system system(size, solver);
  for(const unsigned int seed : {3u, 4u}) {
    const auto for_each_term = [&](const auto& f) {
      for(std::size_t i = 0; i < size; ++i)
        f(i, i, 1.);
      CGAL::Random random(seed);
      for(std::size_t k = 0; k < number_of_edges; ++k) {
        const std::size_t i = k % (size - 150), j = i + (k % 3 == 0 ? 150 : 1);
        const double weight = random.get_double(0.5, 2);
        f(i, i, weight);
        f(j, j, weight);
        f(j, i, -weight);
        f(i, j, -weight);
      }
    };
    for_each_term([&](const auto i, const auto j, const double a) { system.add(i, j, a); });
    system.factor();
    std::vector<double> b(size), residual;
    for(std::size_t i = 0; i < size; ++i)
      b[i] = double(i % 7) - 3;
    const std::vector<double> x = system.solve(b);
    residual = b;
    for_each_term([&](const auto i, const auto j, const double a) { residual[i] -= a * x[j]; });
    CHECK(std::all_of(residual.begin(), residual.end(),
                      [](const double r) { return std::abs(r) < 1e-9; }));
    system.set_zero();
  }
}

// A square that is not definite by a rounding: its solution is nearly one of the singular system.
void test_matrix_that_is_not_definite()
{
  namespace P = QR::internal::parametrization;
  double seconds = 0;
  P::Timed_solver solver(seconds);
  P::Sparse_system system(2, solver);
  for(const double below : {1e-15, 1e-11}) {
    system.add(0, 0, 4);
    system.add(1, 0, 4);
    system.add(1, 1, 4 * (1 - below));
    system.factor();
    const std::vector<double> x = system.solve({8, 8});
    CHECK(std::abs(x[0] + x[1] - 2) < 1e-6);
    system.set_zero();
  }
}

// Where flips are few, untangling looks at the faces around them alone: where these are enough, it
// changes the same unknowns to the same values, and the same faces stay flipped, as with all faces.
void test_parts_of_a_map()
{
  namespace P = QR::internal::parametrization;
  using QR::internal::Coordinate_table;
  using QR::internal::Quarter_turns;
  using Unknowns = std::vector<double>;
  const Mesh mesh = perturbed(icosphere(4), 0.01, 5);
  const P::Triangle_surface surface = flat_surface(mesh);
  double seconds = 0;
  P::Timed_solver solver(seconds);
  const std::size_t size = std::size_t(surface.number_of_faces());
  std::vector<double> angles =
    P::cross_field(surface, P::wanted_field(surface, P::Parametrization_options()), 0, solver);
  const P::Matching matching = P::match_crosses(surface, angles);
  const std::vector<int> index = P::singularities(surface, P::topology(surface), matching).index;
  P::Cut_graph cuts(surface);
  cuts.connect(std::vector<char>(index.begin(), index.end()));
  const auto rotation = P::comb(surface, cuts.is_cut(), matching, angles);
  const P::Surface_complex complex(surface, cuts.is_cut(), rotation, angles);
  const QR::internal::Free_coordinates<Quarter_turns> coordinates(complex.complex());
  const Coordinate_table table(coordinates, complex.number_of_sectors());
  P::Sparse_system system(coordinates.number_of_unknowns(), solver);
  P::factor_poisson(surface, complex, table, std::vector<double>(size, 1), system);
  const Unknowns smooth = P::solve_poisson(
    surface, [&](const auto h) { return P::wanted_difference(surface, angles, h); }, complex, table,
    std::vector<double>(size, 1), system);

  P::Timed_solver solver_of_product(seconds); // the matrix another way
  P::Sparse_system product(smooth.size(), solver_of_product);
  P::add_product(
    surface, complex, table,
    [&](const auto h) { return 1 / std::tan(surface.angle[surface.next(h)]); }, product);
  product.factor();
  Unknowns b(smooth.size());
  for(std::size_t i = 0; i < b.size(); ++i)
    b[i] = double(i % 11) - 5;
  const Unknowns x = system.solve(b), y = product.solve(b);
  for(std::size_t i = 0; i < b.size(); ++i)
    CHECK(std::abs(x[i] - y[i]) <= 1e-6 * (1 + std::abs(x[i])));

  std::vector<std::size_t> all(size);
  std::iota(all.begin(), all.end(), std::size_t(0));
  std::size_t number_of_flips = 0, number_of_changes = 0;
  for(std::size_t moved = 0; moved < smooth.size(); moved += 97) {
    Unknowns start = smooth;
    start[moved] += moved % 2 == 0 ? 0.1 : 0.3; // more than an edge
    const P::Coordinates uv = coordinates.evaluate(start);
    const std::vector<std::size_t> around = P::faces_near_flips(surface, complex, uv, 20);
    CHECK(around.size() < all.size());
    if(around.empty())
      continue; // it is not enough for a flip
    std::array<Unknowns, 2> ends{start, start};
    std::array<std::vector<std::size_t>, 2> left;
    for(const std::size_t i : {0, 1}) {
      const P::Map_part part(surface, index, complex, table, start.size(), uv,
                             i == 0 ? all : around);
      CHECK_EQUAL(part.map().triangles.size(), i == 0 ? all.size() : around.size());
      QR::internal::Untangler<double> untangler(part.map());
      number_of_flips += part.map().not_positive(untangler.unknowns()).size();
      untangler.run(500, QR::internal::Untangling::CLOSE_BY);
      part.add(untangler.unknowns(), ends[i]);
      for(const std::size_t t : part.map().not_positive(untangler.unknowns()))
        left[i].push_back(i == 0 ? t : around[t]);
    }
    CHECK(left[0] == left[1]);
    CHECK(ends[0] == ends[1]);
    number_of_changes += ends[0] != start;
  }
  CHECK(number_of_flips > 0 && number_of_changes > 0);
}

// Crosses of clusters go to their faces and back; nothing of the surface is lost on the way.
void test_clusters()
{
  namespace P = QR::internal::parametrization;
  Mesh mesh = perturbed(icosphere(3), 0.01, 1);
  mesh += height_field(9);
  CGAL::make_triangle(Point_3(9, 0, 0), Point_3(9, 1, 0), Point_3(9, 0, 1), mesh);
  P::Triangle_surface surface = flat_surface(mesh);
  P::Cross_graph graph = P::cross_graph(surface);
  const auto sum = [](const std::vector<double>& a)
  { return std::accumulate(a.begin(), a.end(), 0.); };
  const double area = sum(graph.area), mass = sum(graph.mass);
  for(std::size_t size = graph.size(); size > 100; size = graph.size()) {
    const P::Clusters clusters(graph);
    CHECK(clusters.size() < size / 2);
    P::Prescribed_field field;
    for(std::size_t i = 0; i < clusters.size(); ++i)
      field.push_back(std::polar(1., double(i)));
    const P::Prescribed_field back = clusters.restrict(graph, clusters.prolong(field));
    for(std::size_t i = 0; i < field.size(); ++i)
      CHECK(std::abs(back[i] - field[i]) < 1e-12);
    graph = clusters.coarse_graph(graph);
    CHECK(std::abs(sum(graph.area) - area) < 1e-9 * area);
    CHECK(std::abs(sum(graph.mass) - mass) < 1e-9 * mass);
    for(std::size_t i = 0; i < graph.size(); ++i)
      for(const auto& arc : graph.arcs[i]) {
        CHECK(std::abs(arc.rotation) < 1 + 1e-12);
        std::size_t number_of_opposite_arcs = 0;
        for(const auto& opposite : graph.arcs[arc.target])
          number_of_opposite_arcs += std::size_t(opposite.target) == i &&
                                     std::abs(opposite.length - arc.length) < 1e-12 &&
                                     std::abs(opposite.rotation - std::conj(arc.rotation)) < 1e-12;
        CHECK_EQUAL(number_of_opposite_arcs, std::size_t(1));
      }
  }
}

// The field comes from a coarser graph, and what is flipped is untangled before it is stiffened.
void test_large_surface()
{
  Mesh mesh = perturbed(icosphere(6), 0.004, 2);
  const Uv_map uv = new_uv_map(mesh);
  const Report report =
    QR::approximate_seamless_parametrization(mesh, uv, parameters::release_alignment(true));
  CHECK(bool(report));
  check_topology(mesh, report);
  CHECK_EQUAL(report.number_of_flipped_faces, std::size_t(0));
  CHECK(report.cones.size() < 100);
  CHECK(QR::snap_to_seamless(mesh, uv));
  CHECK(QR::is_seamless(mesh, uv));
}

// --- input that is handled -----------------------------------------------------------------------

void test_poor_meshes()
{
  Mesh isolated = icosphere(1);
  isolated.add_vertex(Point_3(9, 9, 9));
  Uv_map uv = new_uv_map(isolated);
  check_snappable("isolated vertex", QR::approximate_seamless_parametrization(isolated, uv),
                  isolated, uv);

  Mesh holes = icosphere(2); // with removed elements: indices are not contiguous
  for(const int f : {3, 40, 41, 200})
    CGAL::Euler::remove_face(holes.halfedge(Mesh::Face_index(Mesh::size_type(f))), holes);
  uv = new_uv_map(holes);
  check_snappable("removed faces", QR::approximate_seamless_parametrization(holes, uv), holes, uv);

  // Collinear, and then also coincident vertices.
  Mesh degenerate = icosphere(2);
  const Halfedge h = degenerate.halfedge(Mesh::Face_index(7));
  const Point_3 a = degenerate.point(degenerate.source(h));
  const Point_3 b = degenerate.point(degenerate.target(h));
  degenerate.point(degenerate.target(degenerate.next(h))) = CGAL::midpoint(a, b);
  uv = new_uv_map(degenerate);
  check_snappable("collinear", QR::approximate_seamless_parametrization(degenerate, uv),
                  degenerate, uv);
  degenerate.point(degenerate.target(h)) = a;
  degenerate.point(degenerate.target(degenerate.next(h))) = a;
  check_snappable("coincident", QR::approximate_seamless_parametrization(degenerate, uv),
                  degenerate, uv);
}

// --- threads of BLAS -----------------------------------------------------------------------------

#if defined(CGAL_SEAMLESS_SNAPPING_USE_SUITESPARSE) && defined(__ELF__) && defined(__GNUC__)

// These stand in for those of OpenBLAS.
int blas_threads = 7;
std::size_t times_at_one = 0;

extern "C" int openblas_get_num_threads() { return blas_threads; }

extern "C" void openblas_set_num_threads(const int n)
{
  blas_threads = n;
  times_at_one += n == 1 ? 1 : 0;
}

// And these for those of OpenMP.
int openmp_levels = 3;

extern "C" int omp_get_max_active_levels() { return openmp_levels; }

extern "C" void omp_set_max_active_levels(const int n) { openmp_levels = n; }

// Threads that wait for each other would take many times as long on a machine with other work.
void test_blas_threads()
{
  times_at_one = 0;
  Mesh mesh = icosphere(2);
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:threads").first;
  CHECK(bool(CGAL::Quad_remeshing::approximate_seamless_parametrization(mesh, uv)));
  CHECK(times_at_one > 0 && blas_threads == 7);
  {
    const CGAL::Quad_remeshing::internal::One_blas_thread first;
    CHECK(blas_threads == 1 && openmp_levels == 0);
    { const CGAL::Quad_remeshing::internal::One_blas_thread second; }
    CHECK(blas_threads == 1 && openmp_levels == 0);
  }
  CHECK(blas_threads == 7 && openmp_levels == 3);
}

#else

void test_blas_threads() { }

#endif

int main()
{
  const Floating_point_traps traps; // for all functions that are called
  test_blas_threads();
  test_generated_meshes();
  test_cube_with_creases();
  test_frame();
  test_spikes_with_features();
  test_meshes_of_all_kinds();
  test_reproducibility();
  test_target_edge_length();
  test_curvature_alignment();
  test_wanted_cross_with_given_rotations();
  test_given_directions();
  test_sizes();
  test_sizes_by_curvature();
  test_given_cones();
  test_given_cones_around_handles();
  test_cones_of_tori();
  test_cone_distance();
  test_fields_near_cones();
  test_cones_of_spheres();
  test_cones_of_divided_ends();
  test_unavoidable_flips();
  for(unsigned int seed = 0; seed < 20; ++seed)
    test_release(seed);
  test_untangling_without_release();
  test_other_types();
  test_refused_meshes();
  test_refused_parameters();
  test_ranges();
  test_components_of_all_sizes();
  test_spikes();
  test_tiny_meshes();
  test_equations_without_units();
  test_matrix_that_is_not_definite();
  test_matrix_of_many_terms(20000, 400000);
  test_matrix_of_many_terms(120000, 200000); // so large that one order of elimination is tried only
  test_parts_of_a_map();
  test_clusters();
  test_large_surface();
  test_poor_meshes();
  return report_checks();
}
