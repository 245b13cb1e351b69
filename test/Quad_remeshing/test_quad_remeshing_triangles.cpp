// Integer-grid maps of rotational symmetries of order 1, 2, 3, 4, and 6, checked in rationals by
// code that shares nothing with the packages; and the triangles that some were made of.

#include "checking.h"
#include "hexagonal_data.h"
#include "hexagonal_maps.h"
#include "lattice_walk.h"
#include "random_complexes.h"
#include "test_meshes.h"
#include "triangle_checks.h"

#include <CGAL/Quad_remeshing/is_integer_grid_map.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/FPU.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace QR = CGAL::Quad_remeshing;
using namespace hexagonal_maps;

bool is_integer(const Rational& x)
{
  return x == Rational(std::round(CGAL::to_double(x)));
}

// The transition from `h` to the opposite face; whether the turn is there.
template <int N>
bool find_translation(const Mesh& mesh, const UV_map uv, const Halfedge h, const int turns,
                      Exact_vector& translation)
{
  const Halfedge o = mesh.opposite(h);
  translation = lattice_walk::sum(lattice_walk::exact_point(uv[mesh.prev(o)]), Rational(-1),
                                  turned<N>(turns, lattice_walk::exact_point(uv[h])));
  return turned<N>(turns, exact_vector(uv[mesh.prev(h)], uv[h])) ==
         exact_vector(uv[o], uv[mesh.prev(o)]);
}

// Whether translations and cones are points of the lattice, and given edges on its lines.
template <int N>
bool is_integer_grid(const Mesh& mesh, const UV_map uv,
                     const std::map<Mesh::Edge_index, int>& lines)
{
  for(const Halfedge h : mesh.halfedges()) {
    if(mesh.is_border(h))
      continue;
    const Exact_vector u = lattice_walk::exact_point(uv[h]);
    const Vertex v = mesh.target(h);
    if(!mesh.is_border(v) && mesh.degree(v) != 6 && !(is_integer(u[0]) && is_integer(u[1])))
      return false;
    if(!is_interior(mesh, h))
      continue;
    bool is_some = false;
    Exact_vector t;
    for(int k = 0; k < N; ++k)
      is_some = is_some || (find_translation<N>(mesh, uv, h, k, t) && is_integer(t[0]) &&
                            is_integer(t[1]));
    if(!is_some)
      return false;
  }
  for(const auto& [e, f] : lines) {
    const Halfedge h = mesh.is_border(mesh.halfedge(e)) ? mesh.opposite(mesh.halfedge(e))
                                                        : mesh.halfedge(e);
    for(const Halfedge end : {h, mesh.prev(h)})
      if(!is_integer(random_complexes::value(f, lattice_walk::exact_point(uv[end]))))
        return false;
  }
  return true;
}

// With noise, and much larger, so that all integers are others; some edges on lines of the lattice.
template <int N>
void test_integer_grid(Mesh mesh, const std::string& name)
{
  const UV_map uv = uv_map(mesh);
  auto is_aligned = mesh.add_property_map<Mesh::Edge_index, bool>("e:aligned", false).first;
  for(const double scale : {1., 2.3, 3.1})
    for(const bool aligns : {false, true}) {
      const std::string context = "integer grid, " + name + ", N = " + std::to_string(N) +
                                  ", scale " + std::to_string(scale) +
                                  (aligns ? ", aligned" : "");
      unfold(mesh, uv);
      std::mt19937 random(4);
      std::map<Mesh::Edge_index, int> lines;
      for(const auto e : mesh.edges()) {
        is_aligned[e] = aligns && (random() % 8 == 0 || mesh.is_border(e));
        const Halfedge h = mesh.is_border(mesh.halfedge(e)) ? mesh.opposite(mesh.halfedge(e))
                                                            : mesh.halfedge(e);
        const Vector v = vector(uv[mesh.prev(h)], uv[h]);
        if(is_aligned[e])
          lines[e] = v[0] == 0 ? 0 : v[1] == 0 ? 1 : 2;
      }
      CHECK_IN(context, is_integer_grid<N>(mesh, uv, lines));
      const auto symmetric = symmetry<N>().edge_is_constrained_map(is_aligned);
      CHECK_IN(context, QR::is_integer_grid_map(mesh, uv, symmetric));
      perturb(mesh, uv, std::ldexp(1., -20), random);
      const std::vector<int> before = signs(mesh, uv);
      const auto report = QR::snap_to_seamless(
        mesh, uv, symmetric.integer_grid(true).grid_scale(scale).rounding_tolerance(10));
      CHECK_IN(context + ": " + report.message, bool(report));
      // roundings of several units may turn faces, which are told
      CHECK_IN(context, report.lost_faces.empty() || report.largest_rounding > 3);
      CHECK_IN(context, report.lost_faces.empty() == (signs(mesh, uv) == before));
      CHECK_IN(context, is_exact<N>(mesh, uv) && is_integer_grid<N>(mesh, uv, lines));
      const auto measure = QR::measure_integer_grid(mesh, uv, symmetric);
      CHECK_IN(context, measure.translation_distance == 0 && measure.alignment_distance == 0 &&
                          measure.number_of_aligned_edges == lines.size());
      CHECK_IN(context,
               (measure.number_of_nonpositive_faces == 0) == report.lost_faces.empty());
      if(report.lost_faces.empty()) // around folds, the angle of a regular vertex is another one
        CHECK_IN(context, measure.cone_distance == 0 &&
                            bool(measure) == (measure.number_of_border_edges_off_grid == 0));
      if(report.lost_faces.empty() && (aligns || CGAL::is_closed(mesh)))
        triangle_checks::check_snapped(mesh, uv, triangle_checks::valences_of_cones(mesh),
                                       symmetric, context);
      // as large as asked for, up to the rounding
      const double area = scale * scale * double(mesh.number_of_faces()) / 2;
      CHECK_IN(context, std::abs(measure.area / area - 1) < (scale == 1 ? 1e-5 : 0.5));
      std::cout << context << ": rounded by " << report.largest_rounding << ", area "
                << measure.area / area << std::endl;
    }
}

// Integer-grid maps whose charts lie anywhere, one for each face: nothing is rounded, and edges
// stay what they are.
template <int N>
void test_chart_positions(Mesh mesh, UV_map uv, const std::string& name)
{
  const std::vector<Kernel::Point_2> clean = all_points(mesh, uv);
  for(unsigned int seed = 1; seed <= 5; ++seed) {
    std::mt19937 random(seed);
    const auto number = [&] { return double(random() % 1000000) / 999983; };
    std::vector<Vector> edges(mesh.number_of_halfedges());
    for(const auto f : mesh.faces()) {
      const int turns = int(random() % unsigned(N));
      const Vector shift{{3 * number(), 3 * number()}};
      for(const Halfedge h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
        const Kernel::Point_2 p = clean[std::size_t(h)];
        uv[h] = moved(Kernel::Point_2(0, 0), turned<N>(turns, Vector{{p.x(), p.y()}}));
        uv[h] = moved(uv[h], shift);
      }
      for(const Halfedge h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
        edges[std::size_t(h)] = vector(uv[mesh.prev(h)], uv[h]);
    }
    const std::string context = "charts, " + name + ", N = " + std::to_string(N) + ", seed " +
                                std::to_string(seed);
    const auto report = QR::snap_to_seamless(
      mesh, uv, symmetry<N>().integer_grid(true).align_border(true));
    CHECK_IN(context + ": " + report.message, bool(report) && report.lost_faces.empty());
    CHECK_IN(context, report.largest_rounding < 1e-12);
    CHECK_IN(context, QR::is_integer_grid_map(mesh, uv, symmetry<N>()));
    double largest = 0;
    for(const Halfedge h : mesh.halfedges())
      if(!mesh.is_border(h))
        for(std::size_t c = 0; c < 2; ++c)
          largest = (std::max)(largest, std::abs(vector(uv[mesh.prev(h)], uv[h])[c] -
                                                 edges[std::size_t(h)][c]));
    CHECK_IN(context + ": " + std::to_string(largest), largest < 1e-12);
  }
}

template <int N>
void test_chart_positions(Mesh mesh, const std::string& name)
{
  const UV_map uv = uv_map(mesh);
  unfold(mesh, uv);
  test_chart_positions<N>(mesh, uv, name);
}

template <int N>
void test_chart_positions(const square_complex::Square_complex& complex, const std::string& name)
{
  Mesh mesh;
  square_complex::build_mesh(complex, 4, 1, mesh);
  test_chart_positions<N>(mesh, square_complex::uv_map(mesh), name);
}

// Cut open along edges at random, all of them to be borders on lines of the lattice. Faces are
// larger than units, so that few are flipped.
template <int N>
void test_borders_on_lattice(const Mesh& closed, const std::string& name)
{
  std::size_t number_flipped = 0;
  for(unsigned int seed = 1; seed <= 15; ++seed) {
    std::mt19937 random(seed);
    std::vector<char> is_cut;
    for(const auto e : closed.edges())
      is_cut.push_back(random() % 8 == 0 || closed.is_border(e));
    Mesh mesh = cut_open(closed, is_cut);
    const UV_map uv = uv_map(mesh);
    unfold(mesh, uv);
    const std::string context = "borders, " + name + ", seed " + std::to_string(seed);
    const auto report = QR::snap_to_seamless(
      mesh, uv, symmetry<N>().integer_grid(true).align_border(true).rounding_tolerance(100)
                  .grid_scale(4 + double(random() % 1000) / 999));
    CHECK_IN(context + ": " + report.message, bool(report));
    if(!report.lost_faces.empty()) {
      ++number_flipped;
      continue;
    }
    CHECK_IN(context, QR::is_integer_grid_map(mesh, uv, symmetry<N>()));
    triangle_checks::check_number(mesh, uv, symmetry<N>(), context);
  }
  CHECK_IN(name, number_flipped < 4);
}

// What is beside the lattice is counted, by however little.
void test_integer_grid_measure()
{
  Mesh mesh = subdivided(icosahedron(), 1);
  const UV_map uv = uv_map(mesh);
  unfold(mesh, uv);
  const auto np = symmetry<6>();
  for(const Halfedge h : mesh.halfedges())
    uv[h] = moved(uv[h], {{0.25, std::ldexp(1., -40)}}); // in all charts alike, unlike rotations
  const auto measure = QR::measure_integer_grid(mesh, uv, np);
  CHECK(measure.is_exactly_seamless && !measure);
  CHECK(measure.number_of_cones == 12 && measure.number_of_noninteger_cones == 12);
  CHECK(measure.cone_distance == 0.25 && measure.translation_distance > 0.2);
  std::size_t turned_edges = 0; // what the translations of these are depends on where all is
  for(const auto e : mesh.edges()) {
    Exact_vector t;
    for(int k = 1; k < 6; ++k)
      if(find_translation<6>(mesh, uv, mesh.halfedge(e), k, t)) {
        ++turned_edges;
        CHECK(!is_integer(t[0]) && !is_integer(t[1]));
      }
  }
  CHECK(turned_edges > 0);
  CHECK_EQUAL(measure.number_of_noninteger_cuts, turned_edges);
  CHECK(!QR::is_integer_grid_map(mesh, uv, np) && !is_integer_grid<6>(mesh, uv, {}));
  const auto refused = QR::snap_to_seamless(
    mesh, uv, symmetry<6>().integer_grid(true).rounding_tolerance(0));
  CHECK_IN(refused.message, refused.status == QR::Outcome::NOT_INTEGER);
  const auto moved_back = QR::snap_to_seamless(mesh, uv, symmetry<6>().integer_grid(true));
  CHECK_IN(moved_back.message, bool(moved_back) && moved_back.largest_rounding == 0);
  CHECK(QR::is_integer_grid_map(mesh, uv, np));
}

// --- a real map ----------------------------------------------------------------------------------

void test_data_file()
{
  Mesh mesh;
  const UV_map uv = uv_map(mesh);
  if(!hexagonal_maps::read_torus(mesh, uv))
    return;
  CHECK(bool(QR::snap_to_seamless(mesh, uv, symmetry<6>())));
  for(const double scale : {1., 2.}) {
    const auto integers = QR::snap_to_seamless(
      mesh, uv, symmetry<6>().integer_grid(true).grid_scale(scale).rounding_tolerance(1));
    CHECK_IN(integers.message, bool(integers));
    triangle_checks::check_snapped(mesh, uv, {}, symmetry<6>(), "data");
  }
}

int main()
{
  const CGAL::Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
  for(const Case& c : meshes_of_six_directions())
    test_integer_grid<6>(c.mesh, c.name);
  test_integer_grid<3>(subdivided(octahedron(), 2), "octahedron");
  for(const Case& c : meshes_of_six_directions())
    test_chart_positions<6>(c.mesh, c.name);
  test_chart_positions<3>(subdivided(octahedron(), 2), "octahedron");
  test_chart_positions<1>(test_meshes::torus(3, 3), "torus");
  test_chart_positions<2>(test_meshes::tetrahedron(), "tetrahedron");
  test_chart_positions<4>(test_meshes::box(1, 1, 1), "cube");
  test_chart_positions<4>(test_meshes::pair_of_pants(), "pair of pants");
  for(const Case& c : meshes_of_six_directions())
    test_borders_on_lattice<6>(c.mesh, c.name);
  test_borders_on_lattice<3>(subdivided(octahedron(), 2), "octahedron");
  test_integer_grid_measure();
  test_data_file();
  triangle_checks::test_triangles();
  return report_checks();
}
