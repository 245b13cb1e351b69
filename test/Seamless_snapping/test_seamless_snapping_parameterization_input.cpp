// The producer of approximately seamless parametrizations: its parameters, the meshes and property
// maps that it accepts, what it refuses, and that it touches nothing then.

#include "checking.h"
#include "test_meshes.h"

#include <CGAL/Seamless_snapping/approximate_seamless_parameterization.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/subdivision_method_3.h>

#include <Eigen/SparseCholesky>

#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace SS = CGAL::Seamless_snapping;
namespace parameters = CGAL::Seamless_snapping::parameters;
using SS::Parameterization_status;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Uv_map = Mesh::Property_map<Halfedge, Point_2>;
using Report = SS::Parameterization_report<Vertex>;

Uv_map new_uv_map(Mesh& mesh)
{
  return mesh.add_property_map<Halfedge, Point_2>("h:new_uv", Point_2(-7, 7)).first;
}

bool is_untouched(const Mesh& mesh, const Uv_map& uv)
{
  for(const Halfedge h : mesh.halfedges())
    if(uv[h] != Point_2(-7, 7))
      return false;
  return true;
}

Mesh icosphere(const unsigned int subdivisions)
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point_3>(mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(
    mesh, CGAL::parameters::number_of_iterations(subdivisions));
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

// --- parameters ----------------------------------------------------------------------------------

void check_snappable(const std::string& name, const Report& report, Mesh& mesh, Uv_map uv)
{
  if(!CHECK(bool(report)))
    std::cerr << "    " << name << ": " << report << std::endl;
  const SS::Snapping_report snapped = SS::snap_to_seamless(mesh, uv);
  if(!CHECK(bool(snapped)))
    std::cerr << "    " << name << ": " << snapped << std::endl;
  CHECK(SS::is_seamless(mesh, uv));
}

void test_reproducibility()
{
  Mesh mesh = icosphere(2);
  const Uv_map uv = new_uv_map(mesh);
  CHECK(SS::approximate_seamless_parameterization(mesh, uv));
  const std::vector<Point_2> first(uv.begin(), uv.end());
  CHECK(SS::approximate_seamless_parameterization(mesh, uv, parameters::random_seed(0u)));
  CHECK(std::vector<Point_2>(uv.begin(), uv.end()) == first);
  check_snappable("other seed",
                  SS::approximate_seamless_parameterization(mesh, uv, parameters::random_seed(5)),
                  mesh, uv);
}

void test_target_edge_length()
{
  Mesh mesh = grid(4);
  const Uv_map uv = new_uv_map(mesh);
  const Report unit = SS::approximate_seamless_parameterization(mesh, uv);
  const Report half = SS::approximate_seamless_parameterization(
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
  const Report report = SS::approximate_seamless_parameterization(
    mesh, uv, parameters::curvature_alignment(0.5));
  check_snappable("torus along its curvature", report, mesh, uv);
  // The principal directions of a torus of revolution have no singularity.
  CHECK_EQUAL(report.cones.size(), std::size_t(0));
}

void check_cones(const std::string& name, Mesh mesh, const std::vector<std::pair<int, int> >& cones)
{
  const Uv_map uv = new_uv_map(mesh);
  auto index = mesh.add_property_map<Vertex, int>("v:index", 0).first;
  for(const auto& cone : cones)
    index[Vertex(Mesh::size_type(cone.first))] = cone.second;
  const Report report = SS::approximate_seamless_parameterization(
    mesh, uv, parameters::cone_index_map(index));
  check_snappable(name, report, mesh, uv);
  CHECK_EQUAL(report.cones.size(), cones.size());
  for(const auto& cone : report.cones)
    CHECK_EQUAL(cone.second, index[cone.first]);
}

void test_given_cones()
{
  std::vector<std::pair<int, int> > cones;
  for(int v = 0; v < 8; ++v)
    cones.emplace_back(v, 1);
  check_cones("sphere with 8 cones", icosphere(2), cones);
  check_cones("sphere with 4 cones", icosphere(2), {{0, 2}, {3, 2}, {6, 2}, {9, 2}});
  check_cones("torus without cones", torus(12, 8), {});
  check_cones("torus with 4 cones", torus(12, 8), {{0, 1}, {5, 1}, {40, -1}, {64, -1}});
  check_cones("disk with 3 cones", grid(8), {{20, 1}, {40, 1}, {60, -1}});
}

void test_other_types()
{
  Mesh mesh = icosphere(1);
  const Uv_map uv = new_uv_map(mesh);
  using Solver = CGAL::Eigen_solver_traits<
    Eigen::SimplicialLDLT<CGAL::Eigen_sparse_matrix<double>::EigenType> >;
  check_snappable("solver of Eigen", SS::approximate_seamless_parameterization(
                    mesh, uv, parameters::sparse_linear_solver(Solver())), mesh, uv);

  using Float_point = CGAL::Simple_cartesian<float>::Point_2;
  auto float_uv = mesh.add_property_map<Halfedge, Float_point>("h:float_uv").first;
  CHECK(SS::approximate_seamless_parameterization(mesh, float_uv));
  CHECK(SS::snap_to_seamless(mesh, float_uv));
  CHECK(SS::is_seamless(mesh, float_uv));

  CGAL::Polyhedron_3<Kernel> polyhedron;
  CGAL::make_icosahedron<CGAL::Polyhedron_3<Kernel>, Point_3>(polyhedron);
  auto polyhedron_uv = get(CGAL::dynamic_halfedge_property_t<Point_2>(), polyhedron);
  const auto points = get(CGAL::vertex_point, polyhedron);
  CHECK(SS::approximate_seamless_parameterization(polyhedron, polyhedron_uv,
                                                  CGAL::parameters::vertex_point_map(points)));
  CHECK(SS::snap_to_seamless(polyhedron, polyhedron_uv));
  CHECK(SS::is_seamless(polyhedron, polyhedron_uv));
}

// --- bad input -----------------------------------------------------------------------------------

template <typename NamedParameters>
void check_refused(const std::string& name, Mesh mesh, const Parameterization_status expected,
                   const NamedParameters& np)
{
  const Uv_map uv = new_uv_map(mesh);
  const Report report = SS::approximate_seamless_parameterization(mesh, uv, np);
  if(!CHECK_EQUAL(std::string(to_string(report.status)), std::string(to_string(expected))))
    std::cerr << "    " << name << ": " << report << std::endl;
  CHECK(!report);
  CHECK(!report.message.empty());
  CHECK(is_untouched(mesh, uv));
}

void test_refused_meshes()
{
  const auto none = parameters::default_values();
  check_refused("no face", Mesh(), Parameterization_status::INVALID_ARGUMENT, none);

  Mesh quad;
  CGAL::make_quad(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0), quad);
  check_refused("quadrangle", quad, Parameterization_status::NOT_TRIANGULAR, none);

  // Two triangles that have one vertex in common, and nothing else.
  Mesh bow_tie;
  std::array<Vertex, 5> v;
  for(std::size_t i = 0; i < 5; ++i)
    v[i] = bow_tie.add_vertex(Point_3(double(i % 3), double(i / 2), 0));
  bow_tie.add_face(v[0], v[1], v[2]);
  bow_tie.add_face(v[0], v[3], v[4]);
  check_refused("two fans", bow_tie, Parameterization_status::NOT_MANIFOLD, none);

  for(const double x : {std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<double>::infinity()}) {
    Mesh mesh = icosphere(0);
    mesh.point(Vertex(3)) = Point_3(0, x, 0);
    check_refused("not finite", mesh, Parameterization_status::NOT_FINITE, none);
  }
}

void test_refused_parameters()
{
  const Mesh sphere = icosphere(0);
  check_refused("length 0", sphere, Parameterization_status::INVALID_ARGUMENT,
                parameters::target_edge_length(0.));
  check_refused("length NaN", sphere, Parameterization_status::INVALID_ARGUMENT,
                parameters::target_edge_length(std::numeric_limits<double>::quiet_NaN()));
  check_refused("negative curvature alignment", sphere, Parameterization_status::INVALID_ARGUMENT,
                parameters::curvature_alignment(-1.));
  check_refused("negative number of iterations", sphere, Parameterization_status::INVALID_ARGUMENT,
                parameters::number_of_iterations(-1));

  Mesh mesh = sphere;
  auto index = mesh.add_property_map<Vertex, int>("v:index", 0).first;
  check_refused("sphere without cones", mesh, Parameterization_status::INVALID_CONES,
                parameters::cone_index_map(index));
  for(int i = 0; i < 9; ++i)
    index[Vertex(Mesh::size_type(i))] = 1;
  check_refused("nine cones", mesh, Parameterization_status::INVALID_CONES,
                parameters::cone_index_map(index));
  index[Vertex(8)] = 0;
  check_refused("cones and curvature", mesh, Parameterization_status::INVALID_ARGUMENT,
                parameters::cone_index_map(index).curvature_alignment(1.));

  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(*mesh.faces().begin())))
    is_feature[mesh.edge(h)] = true;
  check_refused("three features", mesh, Parameterization_status::INVALID_ALIGNMENT,
                parameters::edge_is_constrained_map(is_feature));
  check_refused("cones and features", mesh, Parameterization_status::INVALID_ARGUMENT,
                parameters::edge_is_constrained_map(is_feature).cone_index_map(index));
}

// --- input that is handled -----------------------------------------------------------------------

void test_poor_meshes()
{
  Mesh isolated = icosphere(1);
  isolated.add_vertex(Point_3(9, 9, 9));
  Uv_map uv = new_uv_map(isolated);
  check_snappable("isolated vertex", SS::approximate_seamless_parameterization(isolated, uv),
                  isolated, uv);

  Mesh holes = icosphere(2); // with removed elements: indices are not contiguous
  for(const int f : {3, 40, 41, 200})
    CGAL::Euler::remove_face(holes.halfedge(Mesh::Face_index(Mesh::size_type(f))), holes);
  uv = new_uv_map(holes);
  check_snappable("removed faces", SS::approximate_seamless_parameterization(holes, uv), holes, uv);

  // Collinear, and then also coincident vertices.
  Mesh degenerate = icosphere(2);
  const Halfedge h = degenerate.halfedge(Mesh::Face_index(7));
  const Point_3 a = degenerate.point(degenerate.source(h));
  const Point_3 b = degenerate.point(degenerate.target(h));
  degenerate.point(degenerate.target(degenerate.next(h))) = CGAL::midpoint(a, b);
  uv = new_uv_map(degenerate);
  check_snappable("collinear", SS::approximate_seamless_parameterization(degenerate, uv),
                  degenerate, uv);
  degenerate.point(degenerate.target(h)) = a;
  degenerate.point(degenerate.target(degenerate.next(h))) = a;
  check_snappable("coincident", SS::approximate_seamless_parameterization(degenerate, uv),
                  degenerate, uv);

  for(const double scale : {1e-100, 1e100}) {
    Mesh mesh = icosphere(1);
    for(const Vertex v : mesh.vertices())
      mesh.point(v) = CGAL::ORIGIN + scale * (mesh.point(v) - CGAL::ORIGIN);
    uv = new_uv_map(mesh);
    check_snappable("scaled", SS::approximate_seamless_parameterization(mesh, uv), mesh, uv);
  }
}

int main()
{
  test_reproducibility();
  test_target_edge_length();
  test_curvature_alignment();
  test_given_cones();
  test_other_types();
  test_refused_meshes();
  test_refused_parameters();
  test_poor_meshes();
  return report_checks();
}
