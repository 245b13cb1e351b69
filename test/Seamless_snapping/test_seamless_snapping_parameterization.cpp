// The producer of approximately seamless parametrizations: topology and index theorem in integers,
// transitions measured in rational arithmetic, what it refuses, and that snap_to_seamless() makes
// each of its results exact.

#include "checking.h"
#include "exact_seamless_check.h"
#include "test_meshes.h"

#include <CGAL/Seamless_snapping/approximate_seamless_parameterization.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <map>
#include <string>

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

std::ptrdiff_t euler_characteristic(const Mesh& mesh)
{
  std::ptrdiff_t chi = std::ptrdiff_t(mesh.number_of_faces());
  for(const Vertex v : mesh.vertices())
    chi += mesh.is_isolated(v) ? 0 : 1;
  return chi - std::ptrdiff_t(mesh.number_of_edges());
}

// --- what each result has to be ------------------------------------------------------------------

void check_topology(const Mesh& mesh, const Report& report)
{
  CHECK_EQUAL(report.number_of_faces, std::size_t(mesh.number_of_faces()));
  CHECK_EQUAL(report.euler_characteristic, euler_characteristic(mesh));
  CHECK_EQUAL(report.euler_characteristic,
              2 * std::ptrdiff_t(report.number_of_components) - 2 * report.genus
              - std::ptrdiff_t(report.number_of_border_loops));
  std::ptrdiff_t sum = report.border_turning;
  for(const auto& cone : report.cones) {
    CHECK(cone.second != 0);
    CHECK(!mesh.is_border(cone.first));
    sum += cone.second;
  }
  CHECK_EQUAL(sum, 4 * euler_characteristic(mesh));
}

// The turns that the transitions make around a vertex agree with the index that was reported.
void check_cones(const Mesh& mesh, const Uv_map& uv, const Report& report)
{
  const SS::Seam_transitions<Mesh> transitions = SS::seam_transitions(mesh, uv);
  if(!CHECK(bool(transitions))) {
    std::cerr << "    " << transitions.message() << std::endl;
    return;
  }
  std::map<Vertex, int> index(report.cones.begin(), report.cones.end());
  for(const Vertex v : mesh.vertices()) {
    if(mesh.is_border(v) || mesh.is_isolated(v))
      continue;
    // Counterclockwise: from a face across the halfedge that points to v.
    int turns = 0;
    for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
      turns += transitions.rotation(h);
    CHECK_EQUAL(((turns - index[v]) % 4 + 4) % 4, 0);
  }
}

template <typename IsAligned, typename NamedParameters>
void check_result(Mesh& mesh, Uv_map uv, const Report& report, const IsAligned& is_aligned,
                  const NamedParameters& alignment)
{
  if(!CHECK_EQUAL(int(report.status), int(Parameterization_status::PARAMETERIZED))) {
    std::cerr << "    " << report << std::endl;
    return;
  }
  check_topology(mesh, report);
  check_cones(mesh, uv, report);

  const exact_check::Result before = exact_check::check(mesh, uv, is_aligned);
  CHECK(report.extent > 0);
  CHECK(before.largest_violation <= 1e-12 * report.extent);
  CHECK(before.edges_off_identity <= report.number_of_cut_edges);
  CHECK_EQUAL(before.aligned_edges, report.number_of_aligned_edges);
  CHECK_EQUAL(before.degenerate_faces + before.flipped_faces, report.number_of_flipped_faces);

  const SS::Snapping_report snapped = SS::snap_to_seamless(mesh, uv, alignment);
  if(!CHECK(bool(snapped)))
    std::cerr << "    " << snapped << std::endl;
  const exact_check::Result after = exact_check::check(mesh, uv, is_aligned);
  CHECK_EQUAL(after.inexact_edges, std::size_t(0));
  CHECK_EQUAL(after.inexact_aligned_edges, std::size_t(0));
  CHECK(SS::is_seamless(mesh, uv, alignment));
}

void check_parameterization(const std::string& name, Mesh mesh, const bool may_flip = false)
{
  std::cout << name << std::endl;
  const Uv_map uv = new_uv_map(mesh);
  const Report report = SS::approximate_seamless_parameterization(mesh, uv);
  CHECK(may_flip || report.number_of_flipped_faces == 0);
  check_result(mesh, uv, report, exact_check::No_edge_aligned(), parameters::default_values());
}

template <typename EdgeIsConstrainedMap>
void check_alignment(const std::string& name, Mesh mesh, const EdgeIsConstrainedMap is_feature,
                     const bool align_border)
{
  std::cout << name << ", aligned" << std::endl;
  const Uv_map uv = new_uv_map(mesh);
  const auto alignment = parameters::edge_is_constrained_map(is_feature).align_border(align_border);
  const auto is_aligned = [&](const Mesh::Edge_index e)
  {
    return get(is_feature, e) || (align_border && mesh.is_border(e));
  };
  const Report report = SS::approximate_seamless_parameterization(mesh, uv, alignment);
  check_result(mesh, uv, report, is_aligned, alignment);
}

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

void test_generated_meshes()
{
  check_parameterization("triangle", [] {
    Mesh mesh;
    CGAL::make_triangle(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), mesh);
    return mesh;
  }());
  check_parameterization("tetrahedron", tetrahedron());
  check_parameterization("icosahedron", icosphere(0));
  check_parameterization("sphere", icosphere(3));
  check_parameterization("height field", height_field(12));
  for(int genus = 1; genus <= 3; ++genus) {
    check_parameterization("slab of genus " + std::to_string(genus), slab(genus, false));
    check_parameterization("round slab of genus " + std::to_string(genus), slab(genus, true));
  }
  Mesh mesh = icosphere(2);
  mesh += height_field(5);
  mesh += slab(1, true);
  check_parameterization("three components", mesh);
}

// Aligned to its creases, a cube comes out as its six squares.
void test_cube_with_creases()
{
  square_complex::Square_complex complex = test_meshes::box(1, 1, 1);
  test_meshes::mark_creases(complex);
  Mesh mesh = test_meshes::make_mesh<Kernel>(complex, 4);
  check_alignment("cube with creases", mesh, test_meshes::feature_map(mesh), false);
  const Uv_map uv = new_uv_map(mesh);
  const Report report = SS::approximate_seamless_parameterization(
    mesh, uv, parameters::edge_is_constrained_map(test_meshes::feature_map(mesh)));
  CHECK_EQUAL(report.cones.size(), std::size_t(8));
  CHECK_EQUAL(report.number_of_flipped_faces, std::size_t(0));
  for(const auto& cone : report.cones) {
    CHECK_EQUAL(cone.second, 1);

  }
}

void test_meshes_of_all_kinds()
{
  for(const auto& named : test_meshes::all_meshes<Kernel>()) {
    check_parameterization(named.name, named.mesh, true);
    check_alignment(named.name, named.mesh,
                    CGAL::Static_boolean_property_map<Mesh::Edge_index, false>(), true);
    Mesh mesh = named.mesh;
    check_alignment(named.name + " with features", mesh, test_meshes::feature_map(mesh), false);
  }
}

int main()
{
  test_generated_meshes();
  test_cube_with_creases();
  test_meshes_of_all_kinds();
  return report_checks();
}
