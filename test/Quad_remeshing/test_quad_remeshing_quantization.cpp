// Tests of quantization: complexes keep their invariants in every step, surfaces of squares come
// out as the quads that they are made of, small complexes reach what an exhaustive search finds,
// and real maps give meshes of quads at all sizes.

#include "Parametrized_model.h"
#include "floating_point_traps.h"
#include "interruptions.h"
#include "piece_checks.h"
#include "quad_reference.h"
#include "symmetry_plane_checks.h"
#include "test_data.h"
#include "test_surfaces.h"

#include <CGAL/Isocurves_and_layouts/Motorcycle_graph.h>
#include <CGAL/Quad_remeshing/approximate_seamless_parametrization.h>
#include <CGAL/Quad_remeshing/extract_grid_mesh.h>
#include <CGAL/Quad_remeshing/internal/quantization/Face_graph_search.h>
#include <CGAL/Quad_remeshing/internal/quantization/Integer_mesh.h>
#include <CGAL/Quad_remeshing/internal/quantization/quads_needed.h>
#include <CGAL/Quad_remeshing/internal/quantization/coarsen.h>
#include <CGAL/Quad_remeshing/internal/quantization/quantize_complex.h>
#include <CGAL/Quad_remeshing/internal/remeshing/collapse_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/divide_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/mend_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/shape_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_locator.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Upper_sides.h>
#include <CGAL/Quad_remeshing/measure_quad_shapes.h>
#include <CGAL/Quad_remeshing/find_symmetry_plane.h>
#include <CGAL/Quad_remeshing/quad_remesh.h>
#include <CGAL/Quad_remeshing/quantize.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <tuple>
#include <vector>

using namespace quad_reference;
namespace QR = CGAL::Quad_remeshing;
namespace surfaces = test_meshes;
namespace parameters = QR::parameters;
namespace internal = QR::internal;
using internal::Corner_index;
using internal::Grid_vector;
using internal::Intrinsic_complex;
using internal::Intrinsic_corner;
using Status = QR::Outcome;

constexpr internal::Edge_vector vectors = &Intrinsic_corner::vector;
constexpr internal::Edge_vector units = &Intrinsic_corner::units;

template <typename Mesh_, typename UV, typename Is_feature>
internal::Integer_mesh read_integers(const Mesh_& mesh, const UV& uv, const Is_feature& is_feature)
{
  const internal::Flat_numbering<Mesh_> numbering(mesh);
  const auto charts =
    internal::build_chart_mesh<internal::Quarter_turns>(mesh, numbering, uv,
                                                        QR::seam_transitions(mesh, uv).data());
  std::vector<char> features;
  for(const auto h : numbering.halfedges_of_corners())
    features.push_back(is_feature[mesh.edge(h)]);
  internal::Integer_mesh result;
  CHECK(internal::Integer_reader(charts, features).read(result));
  return result;
}

// --- complexes -----------------------------------------------------------------------------------

// What the checks must find: else they would say nothing.
void test_defects(const internal::Integer_mesh& input)
{
  const Intrinsic_complex complex = internal::make_complex(input);
  const std::vector<int> angles = internal::angles_around_vertices(complex);
  const auto problem = [&](const Intrinsic_complex& c) { return defect(c, angles, vectors); };
  CHECK_EQUAL(problem(complex), std::string());
  Intrinsic_complex bad = complex;
  bad.corners[4].vector[0] += 1;
  CHECK_EQUAL(problem(bad), std::string("an open triangle"));
  bad = complex;
  for(Corner_index h = 0; h < bad.number_of_halfedges(); ++h)
    bad.corners[std::size_t(h)].vector[1] *= -1;
  CHECK_EQUAL(problem(bad), std::string("a triangle that is not positive"));
  bad = complex;
  std::size_t inside = 0;
  while(complex.corners[inside].opposite == internal::no_index)
    ++inside;
  bad.corners[inside].rotation = (bad.corners[inside].rotation + 1) % 4;
  CHECK_EQUAL(problem(bad), std::string("an edge of two sides that don't match"));
  bad = complex;
  bad.corners[1].vertex = bad.corners[1].vertex == 0 ? 1 : 0;
  CHECK(problem(bad).find("two sides") != std::string::npos);
  bad = complex;
  bad.corners[0].is_wall = !bad.corners[0].is_wall;
  CHECK(!problem(bad).empty());
  std::vector<int> other_angles = angles;
  other_angles[2] += 4;
  CHECK_EQUAL(defect(complex, other_angles, vectors), std::string("a vertex with another angle"));
}

// A complex of squares is a mesh of quads with the cones and corners of its map.
void test_quads_needed()
{
  const auto check = [](const surfaces::Square_complex& complex, const std::size_t cones,
                        const std::size_t corners, const std::size_t handles,
                        const std::size_t by_cones, const std::string& words) {
    const Grid_map map(complex, 2, 2);
    Mesh mesh(map.mesh);
    const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:none", false).first;
    const internal::Quads_needed needed =
      internal::quads_needed(internal::make_complex(read_integers(map.mesh, map.uv, is_feature)));
    CHECK_EQUAL(needed.cones, cones);
    CHECK_EQUAL(needed.border_corners, corners);
    CHECK_EQUAL(needed.handles, handles);
    CHECK_EQUAL(needed.by_cones, by_cones);
    CHECK(by_cones <= std::size_t(complex.number_of_squares()));
    CHECK_EQUAL(needed.in_words(2 * double(needed.by_topology()) - 0.1), words);
    CHECK_EQUAL(needed.in_words(2 * double(needed.by_topology())), std::string());
  };
  check(surfaces::box(1, 1, 1), 8, 0, 0, 6, "; 8 cones take at least 6 quads");
  check(surfaces::box(2, 1, 3), 8, 0, 0, 6, "; 8 cones take at least 6 quads");
  check(surfaces::tetrahedron(), 4, 0, 0, 2, "; 4 cones take at least 2 quads");
  check(surfaces::disc(3, 2), 0, 4, 0, 1, "; 4 corners of the border take at least 1 quad");
  check(surfaces::torus(4, 3), 0, 0, 1, 1, "; 1 handle takes about 9 quads");
  check(surfaces::cylinder(5, 2), 0, 0, 0, 1, "");
}

// Each edge, followed on the input from its source on, leads to its target, and there alone.
void test_ways(const internal::Integer_mesh& input, const Intrinsic_complex& complex,
               const std::string& name)
{
  bool is_right = true;
  for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h) {
    const auto& departure = complex.corner(h).departure;
    Grid_vector way = complex.corner(h).vector;
    for(int k = departure.turns; k > 0; --k)
      way = {-way[1], way[0]};
    const auto end = [&](const std::int64_t part) {
      return internal::Straight_walk(input, {{{way, {}}}, {{part, 0}}, 1000}).run(departure.corner);
    };
    const auto vertex = [&](const Corner_index g)
      { return input.vertex(complex.corner(g).departure.corner); };
    const auto is_at = [&](const internal::Face_point& l, const std::size_t v) {
      for(Corner_index k = 0; k < 3; ++k)
        if(std::abs(l.weights[std::size_t(k)] - 1) < 1e-9)
          return input.vertex(3 * Corner_index(l.face) + k) == v;
      return false;
    };
    is_right = is_right && is_at(end(0), vertex(h)) &&
               is_at(end(1000), vertex(Intrinsic_complex::next(h)));
    const Corner_index g = complex.opposite(h); // the middle is that of the other side
    if(g != internal::no_index) {
      const auto middle = end(400);
      Grid_vector back = complex.corner(g).vector;
      for(int k = complex.corner(g).departure.turns; k > 0; --k)
        back = {-back[1], back[0]};
      const auto same = internal::Straight_walk(input, {{{back, {}}}, {{600, 0}}, 1000})
                          .run(complex.corner(g).departure.corner);
      if(middle.face == same.face)
        for(std::size_t k = 0; k < 3; ++k)
          is_right = is_right && std::abs(middle.weights[k] - same.weights[k]) < 1e-6;
    }
  }
  CHECK_IN(name, is_right);
}

// Random flips, then the removal of all vertices that can be removed, and flips in between. The
// invariants are checked so often that this takes `work` steps, on small meshes each time.
void test_steps(const internal::Integer_mesh& input, const unsigned seed, const double work,
                const std::string& name)
{
  Intrinsic_complex complex = internal::make_complex(input);
  const std::vector<int> angles = internal::angles_around_vertices(complex);
  std::mt19937 random(seed);
  internal::Polygon_filler filler(input, complex);
  internal::Vertex_remover remover(input, complex);
  const std::size_t period = 1 + std::size_t(3e2 * double(complex.corners.size()) / work);
  std::size_t number_of_steps = 0;
  const auto check = [&] {
    if(++number_of_steps % period == 0)
      CHECK_IN(name + ", seed " + std::to_string(seed),
               defect(complex, angles, vectors) == std::string());
  };
  const auto flip_at_random = [&](const int attempts) {
    for(int i = 0; i < attempts; ++i) {
      const Corner_index h = Corner_index(random() % complex.corners.size());
      if(complex.has_face(h / 3) && is_flippable(complex, h, vectors)) {
        internal::flip(h, complex, filler);
        check();
      }
    }
  };
  flip_at_random(200);
  for(std::size_t round = 0; round < 3; ++round) {
    for(std::size_t v = 0; v < complex.number_of_vertices(); ++v)
      if(complex.corner_at_vertex[v] != internal::no_index && remover.remove(v, 1000))
        check();
    flip_at_random(100);
  }
  CHECK_EQUAL(defect(complex, angles, vectors), std::string());
  complex = compacted(complex);
  test_ways(input, complex, name);
  make_delaunay(input, complex);
  test_ways(input, complex, name);
  CHECK_EQUAL(defect(complex, internal::angles_around_vertices(complex), vectors), std::string());
  CHECK(number_of_steps > 0);
}

// A vertex that is no cone stays only where an edge leads from it to itself.
void test_remaining_vertices(const internal::Integer_mesh& input, const std::size_t expected)
{
  Intrinsic_complex complex = internal::make_complex(input);
  coarsen(input, complex);
  CHECK_EQUAL(compacted(complex).number_of_vertices(), expected);
}

void test_complexes()
{
  Square_complex creased = surfaces::box(2, 1, 3);
  surfaces::mark_creases(creased);
  Square_complex planar = surfaces::disc(5, 5);
  surfaces::mark_all_kinds_of_features(planar);
  Square_complex scattered = surfaces::double_torus();
  surfaces::scatter_charts(scattered);
  for(const Square_complex& complex :
      {surfaces::box(1, 1, 1), creased, planar, scattered, surfaces::genus_2(),
       surfaces::tetrahedron(), surfaces::torus(1, 2), surfaces::cylinder(2, 3),
       surfaces::cone_ring(5), surfaces::cone_ring(8), surfaces::pair_of_pants(),
       surfaces::box_with_holes(), surfaces::two_islands()})
    for(const unsigned seed : {1u, 2u, 3u}) {
      Grid_map map(complex, 4, 4);
      map.perturb(seed, 0.4, seed == 1 ? 3 : 30);
      const internal::Integer_mesh input = read_integers(map.mesh, map.uv, map.is_feature);
      test_steps(input, seed, 1e7, "a surface of squares");
      if(seed == 1)
        test_defects(input);
    }
  const auto remaining = [](const Square_complex& complex, const std::size_t number) {
    const Grid_map map(complex, 4, 4);
    test_remaining_vertices(read_integers(map.mesh, map.uv, map.is_feature), number);
  };
  remaining(surfaces::box(2, 1, 3), 8);
  remaining(surfaces::genus_2(), 1);
  remaining(surfaces::tetrahedron(), 4);
  remaining(surfaces::notched_cube(), 14);
  remaining(surfaces::disc(3, 2), 4);
}

// --- surfaces of squares -------------------------------------------------------------------------

// At the scale of the squares, or a multiple of it, nothing deviates: the quads are known, and lie
// where they lie on the squares.
void test_known_quads(const Square_complex& complex, const int side, const bool is_in_space)
{
  for(const unsigned seed : {0u, 1u, 2u})
    for(const int factor : {1, 2, 3}) {
      Grid_map map(complex, side, 4);
      if(seed > 0)
        map.perturb(seed, 0.1 * side, seed == 1 ? 3 : 30);
      const std::size_t number =
        complex.number_of_squares() * std::size_t(side * side * factor * factor);
      const QR::Quantization quantization =
        QR::quantize(map.mesh, map.uv,
                     parameters::target_number_of_quads(number)
                       .edge_is_constrained_map(map.is_feature));
      CHECK_EQUAL(QR::to_string(quantization.status), std::string("success"));
      CHECK_EQUAL(quantization.message, std::string());
      CHECK_EQUAL(quantization.number_of_quads, number);
      Mesh quads;
      const auto report = QR::extract_quad_mesh(quantization, map.mesh, quads);
      CHECK_EQUAL(QR::to_string(report.status), std::string("success"));
      CHECK_EQUAL(report.message, std::string());
      CHECK(CGAL::is_valid_polygon_mesh(quads));
      const Mesh expected = expected_quads(complex, side * factor);
      CHECK(are_isomorphic(quads, expected));
      if(is_in_space && seed == 0 && factor == 1)
        CHECK(rounded_quads(quads) == rounded_quads(expected));
    }
}

void test_surfaces()
{
  for(const int side : {2, 3}) {
    test_known_quads(surfaces::box(1, 1, 1), side, true);
    test_known_quads(surfaces::box(2, 1, 3), side, true);
    test_known_quads(surfaces::notched_cube(), side, true);
    test_known_quads(surfaces::double_torus(), side, true);
    test_known_quads(surfaces::box_with_holes(), side, true);
    test_known_quads(surfaces::disc(3, 2), side, true);
  }
  test_known_quads(surfaces::genus_2(), 4, false);
  test_known_quads(surfaces::tetrahedron(), 4, false);
  test_known_quads(surfaces::torus(1, 2), 4, false);
  test_known_quads(surfaces::cylinder(2, 3), 4, false);
  test_known_quads(surfaces::pair_of_pants(), 4, false);
  for(const int quarter_turns : {1, 2, 3, 5, 8})
    test_known_quads(surfaces::cone_ring(quarter_turns), 4, false);
  Square_complex parts = surfaces::box(1, 1, 1);
  parts.append(surfaces::disc(2, 2));
  test_known_quads(parts, 4, true);
}

// --- exhaustive search ---------------------------------------------------------------------------

// The least sum of weighted squares over all feasible units, by branch and bound: edges are
// assigned one by one, and closed triangles determine their last edge.
class Exhaustive_search
{
public:
  Exhaustive_search(const Intrinsic_complex& complex, const std::vector<double>& scales)
    : m_complex(complex), m_is_known(complex.corners.size(), false),
      m_wanted(internal::wanted_units(complex, scales))
  { }

  double energy(const Intrinsic_complex& complex) const
  {
    double sum = 0;
    for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h)
      if(complex.represents_edge(h))
        sum += cost(h, complex.corner(h).units);
    return sum;
  }

  // The least one up to `bound`, or a little more than that.
  double run(const double bound)
  {
    m_best = bound * (1 + 1e-9) + 1e-9;
    search(0);
    return m_best;
  }

private:
  double cost(const Corner_index h, const Grid_vector& v) const
  {
    const auto& w = m_wanted[std::size_t(h)];
    const double x = double(v[0]) - w[0], y = double(v[1]) - w[1];
    return (x * x + y * y) / (1 + std::hypot(w[0], w[1]));
  }

  void search(const double sum)
  {
    if(sum >= m_best)
      return;
    Corner_index free = internal::no_index, implied = internal::no_index;
    for(Corner_index h = 0; h < m_complex.number_of_halfedges() && implied == -1; ++h)
      if(!m_is_known[std::size_t(h)]) {
        const bool others = m_is_known[std::size_t(Intrinsic_complex::next(h))] &&
                            m_is_known[std::size_t(Intrinsic_complex::prev(h))];
        implied = others ? h : implied;
        free = free == -1 ? h : free;
      }
    if(implied != -1) {
      const Grid_vector& a = m_complex.corner(Intrinsic_complex::next(implied)).units;
      const Grid_vector& b = m_complex.corner(Intrinsic_complex::prev(implied)).units;
      assign(implied, {-a[0] - b[0], -a[1] - b[1]}, sum);
    } else if(free != -1) {
      const auto& w = m_wanted[std::size_t(free)];
      const double reach = std::sqrt((m_best - sum) * (1 + std::hypot(w[0], w[1])));
      for(long x = std::lround(w[0] - reach - 1); double(x) <= w[0] + reach + 1; ++x)
        for(long y = std::lround(w[1] - reach - 1); double(y) <= w[1] + reach + 1; ++y)
          assign(free, {x, y}, sum);
    } else if(defect(m_complex, internal::angles_around_vertices(m_complex), units).empty()) {
      m_best = sum;
    }
  }

  void assign(const Corner_index h, const Grid_vector& v, double sum)
  {
    const Corner_index g = m_complex.opposite(h);
    sum += cost(h, v);
    if(sum >= m_best)
      return;
    m_complex.corners[std::size_t(h)].units = v;
    m_is_known[std::size_t(h)] = true;
    bool is_possible = is_positive(h / 3);
    if(g != internal::no_index) {
      Grid_vector turned = v;
      for(int k = m_complex.corner(h).rotation; k > 0; --k)
        turned = {-turned[1], turned[0]};
      m_complex.corners[std::size_t(g)].units = {-turned[0], -turned[1]};
      m_is_known[std::size_t(g)] = true;
      is_possible = is_possible && is_positive(g / 3);
    }
    if(is_possible)
      search(sum);
    m_is_known[std::size_t(h)] = false;
    if(g != internal::no_index)
      m_is_known[std::size_t(g)] = false;
  }

  // Unless its edges are not all known.
  bool is_positive(const int f) const
  {
    for(Corner_index h = 3 * f; h < 3 * f + 3; ++h)
      if(!m_is_known[std::size_t(h)])
        return true;
    const Grid_vector &a = m_complex.corner(3 * f).units, &b = m_complex.corner(3 * f + 1).units,
                      &c = m_complex.corner(3 * f + 2).units;
    return a[0] + b[0] + c[0] == 0 && a[1] + b[1] + c[1] == 0 && a[0] * b[1] - a[1] * b[0] > 0;
  }

  Intrinsic_complex m_complex;
  std::vector<char> m_is_known; // per halfedge
  std::vector<std::array<double, 2> > m_wanted;
  double m_best = 0;
};

void test_optimum()
{
  std::size_t number = 0, number_of_optima = 0;
  double worst = 1;
  for(const Square_complex& complex :
      {surfaces::tetrahedron(), surfaces::genus_2(), surfaces::torus(1, 2), surfaces::disc(2, 3),
       surfaces::cylinder(2, 3), surfaces::cone_ring(1), surfaces::cone_ring(3)}) {
    const Grid_map map(complex, 16, 4);
    const internal::Integer_mesh input = read_integers(map.mesh, map.uv, map.is_feature);
    for(const double scale : {0.03, 0.05, 0.07, 0.1, 0.13, 0.17, 0.21, 0.26}) {
      Intrinsic_complex coarse = internal::make_complex(input);
      coarsen(input, coarse);
      coarse = compacted(coarse);
      if(!CHECK(coarse.number_of_faces() <= 8))
        continue;
      const std::vector<double> scales{scale * input.steps[0]};
      internal::Work work;
      Intrinsic_complex found =
        internal::Unit_ladders(input, coarse, input.steps, 1, work).find(0, scale).complex;
      internal::Complex_quantizer quantizer(input, found, scales, work);
      quantizer.improve();
      CHECK(quantizer.is_feasible());
      Exhaustive_search search(found, scales);
      const double ours = search.energy(found), least = search.run(ours);
      CHECK(least <= ours * (1 + 1e-8) + 1e-8);
      ++number;
      number_of_optima += ours <= least * (1 + 1e-8) + 1e-8 ? 1 : 0;
      worst = (std::max)(worst, (ours + 1e-9) / (least + 1e-9));
    }
  }
  std::cout << number_of_optima << " of " << number << " small complexes reach the optimum; the "
            << "worst has " << worst << " times its sum of squares" << std::endl;
  CHECK(10 * number_of_optima >= 9 * number);
}

// What the search from a state finds, or infinity.
double cheapest_strip(internal::Strip_finder& finder, const internal::Strip_state start,
                      const bool from_both_sides)
{
  return finder.find(start, 1e9, from_both_sides) ? finder.length()
                                                  : std::numeric_limits<double>::infinity();
}

std::vector<internal::Wanted_vector> wanted_along(const Intrinsic_complex& complex,
                                                  const std::vector<double>& scales,
                                                  const internal::Cost_of_units cost)
{
  auto result = internal::wanted_units(complex, scales);
  if(cost == internal::Cost_of_units::SHAPE)
    internal::Wall_slider(complex, result).run();
  return result;
}

// Vertices slide along their walls only: triangles stay closed, sides of an edge match, and walls
// keep their isocurves. At each one that slides, some edge is a whole number of units long along
// the wall, in units as large as those there. Returns how many halfedges have changed.
std::size_t check_slides(const Intrinsic_complex& complex, const std::vector<double>& scales)
{
  constexpr double rounding = 1e-9;
  const auto before = internal::wanted_units(complex, scales);
  const auto after = wanted_along(complex, scales, internal::Cost_of_units::SHAPE);
  const auto is_near = [&](const double x, const double y)
    { return std::abs(x - y) < rounding * (1 + std::abs(x)); };
  double length = 0, wanted = 0; // along walls without corners, in units
  std::vector<char> slides(complex.number_of_vertices(), false);
  for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h)
    for(const std::size_t v : {complex.vertex(h), complex.source(h)})
      slides[v] |= complex.corner(h).is_wall && complex.is_regular[v];
  for(std::size_t i = 0; i < slides.size(); ++i)
    for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h)
      if(complex.corner(h).is_wall && !(slides[complex.vertex(h)] && slides[complex.source(h)]))
        slides[complex.vertex(h)] = slides[complex.source(h)] = false;
  std::size_t number = 0;
  for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h) {
    const auto &a = before[std::size_t(h)], &b = after[std::size_t(h)];
    const auto &next = after[std::size_t(Intrinsic_complex::next(h))],
               &prev = after[std::size_t(Intrinsic_complex::prev(h))];
    for(std::size_t c = 0; c < 2; ++c) {
      CHECK(is_near(b[c], -next[c] - prev[c]));
      number += !is_near(a[c], b[c]);
      if(complex.corner(h).is_wall && a[c] == 0)
        CHECK(b[c] == 0);
    }
    if(const Corner_index g = complex.opposite(h); g != internal::no_index) {
      internal::Wanted_vector turned = b;
      for(int k = complex.corner(h).rotation; k > 0; --k)
        turned = {-turned[1], turned[0]};
      for(std::size_t c = 0; c < 2; ++c)
        CHECK(is_near(after[std::size_t(g)][c], -turned[c]));
    }
    const bool source = slides[complex.source(h)], target = slides[complex.vertex(h)];
    if(!source && !target)
      CHECK(a == b);
    if(complex.corner(h).is_wall && source && target) {
      length += internal::length(complex.corner(h).units);
      wanted += std::hypot(a[0], a[1]);
    }
  }
  const double ratio = length > 0 && wanted > 0 ? length / wanted : 1;
  for(std::size_t v = 0; v < complex.number_of_vertices(); ++v) {
    bool has_slid = false, has_whole = false;
    for_each_corner(complex, v, [&](const Corner_index k) {
      for(const Corner_index h : {k, Intrinsic_complex::next(k)})
        for(std::size_t c = 0; c < 2; ++c) {
          const double x = ratio * after[std::size_t(h)][c];
          has_slid |= before[std::size_t(h)][c] != after[std::size_t(h)][c];
          has_whole |= !complex.corner(h).is_wall && std::abs(x - std::round(x)) < 1e-6;
        }
    });
    CHECK(has_whole || !has_slid || !slides[v]);
  }
  return number;
}

// What units cost by definition: weighted squares of what edges differ by from the wanted ones, of
// which none is shorter than a unit; for shapes, also squares of the entries of the matrix from a
// wanted triangle to that of units, minus 1, times the area. A triangle of less height than 1
// counts as if it had that.
double cost_by_definition(const Intrinsic_complex& complex, const std::vector<double>& scales,
                          const internal::Cost_of_units cost)
{
  const auto wanted = wanted_along(complex, scales, cost);
  const auto difference = [&](const Corner_index h, const std::size_t c)
    { return double(complex.corner(h).units[c]) - wanted[std::size_t(h)][c]; };
  double sum = 0;
  for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h)
    if(complex.represents_edge(h)) {
      const auto& w = wanted[std::size_t(h)];
      const Grid_vector& v = complex.corner(h).units;
      const double length = std::hypot(w[0], w[1]), longer = (std::max)(1., 1 / length);
      const double x = double(v[0]) - longer * w[0], y = double(v[1]) - longer * w[1];
      sum += (x * x + y * y) / (1 + length);
    }
  if(cost == internal::Cost_of_units::LENGTHS)
    return sum;
  for(Corner_index h = 0; h < complex.number_of_halfedges(); h += 3) {
    const auto &a = wanted[std::size_t(h)], &b = wanted[std::size_t(h + 1)];
    const double determinant = a[0] * b[1] - a[1] * b[0];
    const double longest = (std::max)({std::hypot(a[0], a[1]), std::hypot(b[0], b[1]),
                                       std::hypot(a[0] + b[0], a[1] + b[1])});
    const double area = (std::max)(determinant, longest) / 2;
    for(std::size_t c = 0; c < 2; ++c) {
      const double da = difference(h, c), db = difference(h + 1, c);
      const std::array<double, 2> entries{(da * b[1] - db * a[1]) / (2 * area),
                                          (db * a[0] - da * b[0]) / (2 * area)};
      for(std::size_t j = 0; j < 2; ++j)
        sum += (j == c ? 2. : 1.) * area * entries[j] * entries[j];
    }
  }
  return sum;
}

struct Passed_face
{
  internal::Strip_state exit;
  Corner_index entry;
  double cost;
};

std::vector<Passed_face> faces_of_strip(const internal::Strip_finder& finder,
                                        const internal::Strip_rules& rules)
{
  std::vector<Passed_face> result;
  finder.for_each_face([&](const internal::Strip_state exit, const Corner_index entry) {
    const internal::Strip_state stay = internal::Strip_rules::edge_that_stays(entry, exit);
    result.push_back({exit, entry, rules.cost(stay)});
  });
  return result;
}

// Whether the strip passes each face once.
bool is_simple(const std::vector<Passed_face>& strip)
{
  std::set<Corner_index> faces;
  for(const Passed_face& f : strip)
    faces.insert(f.entry / 3);
  return faces.size() == strip.size();
}

// Whether the strip leads from border to border.
bool ends_at_border(const std::vector<Passed_face>& strip, const Intrinsic_complex& complex)
{
  return std::any_of(strip.begin(), strip.end(), [&](const Passed_face& f) {
    return complex.opposite(internal::halfedge_of(f.exit)) == internal::no_index ||
           complex.opposite(f.entry) == internal::no_index;
  });
}

// What a search from a state of the strip counts: gains only next to that.
double cost_from(const std::vector<Passed_face>& strip, const Intrinsic_complex& complex,
                 const Corner_index start)
{
  double sum = 0;
  for(const Passed_face& f : strip) {
    const Corner_index exit = internal::halfedge_of(f.exit), other = complex.opposite(start);
    const bool is_next = exit == start || f.entry == start ||
                         (other != internal::no_index && (exit == other || f.entry == other));
    sum += is_next ? f.cost : (std::max)(0., f.cost);
  }
  return sum;
}

// By how much the move along the strip changes what units cost.
double cost_of_move(const std::vector<Passed_face>& strip, Intrinsic_complex complex,
                    const std::vector<double>& scales, const internal::Cost_of_units cost)
{
  const double before = cost_by_definition(complex, scales, cost);
  const auto add = [&](const Corner_index h, const Grid_vector& v) {
    Grid_vector& vector = complex.corners[std::size_t(h)].units;
    vector = internal::sum(vector, v);
  };
  for(const Passed_face& f : strip) {
    const Grid_vector change = internal::change_of(f.exit);
    add(internal::halfedge_of(f.exit), change);
    add(f.entry, {-change[0], -change[1]});
  }
  return cost_by_definition(complex, scales, cost) - before;
}

// A strip is as cheap in the other direction, and by two searches that meet, and there are as many;
// from each edge of it, none is dearer. A single search finds strips that close, the others those
// that lead from border to border, too. Costs are those by definition.
void test_strips_in_both_directions(const internal::Cost_of_units cost)
{
  constexpr double of_steps = 1e-3; // at most, as each step costs a little
  std::size_t number = 0, number_found = 0, number_at_border = 0, number_of_differences = 0;
  std::size_t number_of_slides = 0;
  for(const Square_complex& complex :
      {surfaces::tetrahedron(), surfaces::genus_2(), surfaces::torus(3, 4), surfaces::disc(3, 4),
       surfaces::cylinder(3, 4), surfaces::cone_ring(3)}) {
    const Grid_map map(complex, 16, 4);
    const internal::Integer_mesh input = read_integers(map.mesh, map.uv, map.is_feature);
    const Intrinsic_complex coarse = internal::make_coarse_complex(input);
    for(const double scale : {0.003, 0.01}) // parts thinner than a unit
      number_of_slides += check_slides(coarse, {scale * input.steps[0]});
    for(const double scale : {0.05, 0.1, 0.2, 0.4}) {
      const std::vector<double> scales{scale * input.steps[0]};
      internal::Work work;
      const Intrinsic_complex all = internal::make_complex(input);
      const Intrinsic_complex intrinsic =
        internal::Unit_ladders(input, all, input.steps, 1, work).find(0, scale).complex;
      const internal::Strip_rules rules(intrinsic, scales, cost);
      internal::Strip_finder finder(rules);
      for(Corner_index h = 0; h < intrinsic.number_of_halfedges(); h += 13)
        for(int k = 0; k < 4; ++k) {
          const internal::Strip_state s = internal::strip_state(h, k);
          if(!rules.is_allowed(s))
            continue;
          CHECK(rules.reversed(rules.reversed(s)) == s);
          const bool is_border = rules.is_border(s);
          const double a = cheapest_strip(finder, s, false);
          if(is_border) {
            CHECK(std::isinf(a));
          } else {
            const double b = cheapest_strip(finder, rules.reversed(s), false);
            number_of_differences += !(a == b || std::abs(a - b) < 1e-9) ? 1 : 0;
          }
          ++number;
          const double c = cheapest_strip(finder, s, true);
          number_found += std::isfinite(c) ? 1 : 0;
          const std::vector<Passed_face> strip =
            std::isfinite(c) ? faces_of_strip(finder, rules) : std::vector<Passed_face>();
          if(std::isinf(c)) {
            number_of_differences += std::isfinite(a) ? 1 : 0;
          } else if(is_simple(strip)) { // two searches know their own faces only
            const bool is_open = ends_at_border(strip, intrinsic);
            CHECK(is_open || !is_border);
            number_at_border += is_open ? 1 : 0;
            number_of_differences += is_open ? c > a + 1e-9 : !(std::abs(a - c) < 1e-9);
            CHECK(std::abs(c - cost_from(strip, intrinsic, h)) < of_steps);
            double sum = 0;
            for(const Passed_face& f : strip)
              sum += f.cost;
            CHECK(std::abs(sum - cost_of_move(strip, intrinsic, scales, cost)) <
                  1e-9 * (1 + std::abs(sum)));
            for(const Passed_face& f : strip)
              number_of_differences +=
                cheapest_strip(finder, f.exit, true) >
                cost_from(strip, intrinsic, internal::halfedge_of(f.exit)) + of_steps;
          }
        }
    }
  }
  std::cout << number_found << " of " << number << " changes of an edge have a strip, "
            << number_at_border << " from border to border, " << number_of_differences
            << " times another one in the other direction or from both sides; "
            << number_of_slides << " vectors slide along walls" << std::endl;
  CHECK(number_found > number_at_border && number_at_border > 0 && number_found < number);
  CHECK(100 * number_of_differences <= number);
  CHECK(number_of_slides > 0);
}

// --- numbers that a mesh can have ----------------------------------------------------------------

// The mesh of least size at or above the number wanted: sizes grow with it, and are near where that
// is possible.
void check_numbers(const Square_complex& complex, const std::string& name)
{
  Grid_map map(complex, 16, 4);
  map.perturb(5, 0.5, 20);
  const QR::Quantization first = QR::quantize(map.mesh, map.uv);
  std::size_t before = 0, near_by = 0, least = 0;
  for(double wanted = 1; wanted < 3000; wanted *= 1.3) {
    const std::string context = name + ", " + std::to_string(wanted) + " quads";
    const auto np = parameters::needs_face_graph(true);
    const QR::Quantization quantization =
      QR::quantize(map.mesh, map.uv, np.target_number_of_quads(std::size_t(wanted)));
    CHECK_IN(context + ": " + quantization.message, bool(quantization));
    Mesh quads;
    const auto report = QR::extract_quad_mesh(quantization, map.mesh, quads);
    CHECK_IN(context + ": " + report.message, bool(report));
    quads.collect_garbage();
    CHECK_IN(context, CGAL::is_valid_polygon_mesh(quads) &&
                        euler_characteristic(quads) == euler_characteristic(map.mesh));
    std::vector<Point_3> points;
    std::vector<std::array<std::size_t, 4> > polygons;
    CHECK_IN(context, bool(QR::extract_quad_soup(quantization, map.mesh, points, polygons)));
    const std::size_t number = quantization.number_of_quads;
    CHECK_EQUAL(polygons.size(), number);
    CHECK_IN(context + ": " + std::to_string(number) + " after " + std::to_string(before),
             double(number) >= 0.95 * double(before));
    CHECK_IN(context,
             quantization.message.empty() == (double(number) <= 1.1 * std::floor(wanted)));
    if(least == 0) {
      least = number;
      CHECK_EQUAL(
        QR::quantize(map.mesh, map.uv, np.minimize_number_of_quads(true)).number_of_quads, least);
      const auto fewer =
        QR::quantize(map.mesh, map.uv, np.minimize_number_of_quads(true).maximum_number(least - 1));
      CHECK_IN(context + ": " + fewer.message,
               fewer.status == Status::TOO_LARGE &&
                 fewer.message.find("maximum_number") != std::string::npos);
      CHECK(fewer.number_of_quads >= least); // and that many would work
      CHECK(bool(QR::quantize(map.mesh, map.uv,
                              np.target_number_of_quads(fewer.number_of_quads))));
    }
    const QR::Quantization again =
      QR::quantize_again(first, map.mesh, np.target_number_of_quads(std::size_t(wanted)));
    CHECK_IN(context + ": " + again.message,
             again.status == quantization.status && again.message == quantization.message &&
               again.number_of_quads == number &&
               again.number_of_moves == quantization.number_of_moves &&
               again.number_of_coarse_faces == quantization.number_of_coarse_faces);
    const auto& corners = quantization.surface().complex.corners;
    CHECK_IN(context, std::equal(corners.begin(), corners.end(),
                                 again.surface().complex.corners.begin(),
                                 [](const auto& a, const auto& b) { return a.units == b.units; }));
    near_by += double(number) <= 1.05 * wanted ? 1 : 0;
    before = (std::max)(before, number);
  }
  std::cout << name << ": at least " << least << " quads, " << near_by << " times near those wanted"
            << std::endl;
  CHECK(near_by > 5);
}

// A torus of m x n quads.
Intrinsic_complex quads_of_torus(const int m, const int n)
{
  const Grid_map map(surfaces::torus(m, n), 4, 4);
  const internal::Integer_mesh input = read_integers(map.mesh, map.uv, map.is_feature);
  Intrinsic_complex complex = internal::make_complex(input);
  coarsen(input, complex);
  complex = compacted(complex);
  for(Intrinsic_corner& corner : complex.corners)
    for(std::size_t c = 0; c < 2; ++c)
      corner.units[c] = std::llround(double(corner.vector[c]) * input.steps[0] / 4);
  return complex;
}

// The quads of a torus are a face graph if there are at least 3 in each direction: strips are
// doubled until then, and no further.
void test_doubled_strips()
{
  for(int m = 1; m <= 5; ++m)
    for(int n = m; n <= 5; ++n) {
      const std::string context = std::to_string(m) + " x " + std::to_string(n) + " quads";
      Intrinsic_complex torus = quads_of_torus(m, n);
      const std::vector<int> angles = internal::angles_around_vertices(torus);
      CHECK_IN(context, internal::number_of_quads(torus) == m * n);
      internal::Work work;
      CHECK_IN(context, internal::Face_graph_mender(torus, {1.}, work).run());
      CHECK_IN(context, internal::defect(torus, angles, &Intrinsic_corner::units).empty());
      CHECK_IN(context,
               internal::number_of_quads(torus) == (std::max)(m, 3) * (std::max)(n, 3));
    }
}

// Tori that are face graphs, ones that can be made some, and one that has too many quads for it.
std::vector<Intrinsic_complex> tori()
{
  std::vector<Intrinsic_complex> result{quads_of_torus(4, 4), quads_of_torus(2, 2),
                                        quads_of_torus(1, 1), quads_of_torus(1, 1)};
  internal::refine(1 << 20, result.back());
  return result;
}

// However the numbers of quads differ from those wanted, and whichever of them face graphs have:
// the search is bounded, and what it finds grows with what is wanted.
void test_search()
{
  const std::vector<Intrinsic_complex> complexes = tori();
  std::size_t most = 0;
  for(unsigned seed = 1; seed <= 20; ++seed) {
    std::size_t calls = 0;
    const auto quantize = [&](const double number) {
      std::mt19937 random(seed + unsigned(std::lround(1000 * std::log2(number))));
      const auto uniform = [&] { return double(random()) / 4294967296.; };
      ++calls;
      internal::Quantized_complex result;
      result.complex = complexes[std::min<std::size_t>(random() % 8, 2)];
      result.scales = {1.};
      result.number_of_quads =
        (std::max)(number * (0.85 + 0.2 * uniform()), 20. * seed * (0.8 + 0.4 * uniform()));
      return result;
    };
    double before = 0;
    for(double wanted = 1; wanted < 1e4; wanted *= 1.25) {
      calls = 0;
      internal::Work work;
      const auto found =
        internal::Face_graph_search<decltype(quantize)>(quantize, work).run(wanted);
      const std::string context = "seed " + std::to_string(seed) + ", " + std::to_string(wanted) +
                                  " quads: " + std::to_string(found.number_of_quads) + " after " +
                                  std::to_string(before);
      CHECK_IN(context, found.number_of_quads >= 0.95 * (std::max)(wanted, before));
      CHECK_IN(context, internal::number_of_quads(found.complex) >= 9); // less is no face graph
      CHECK_IN(context, calls <= (before == 0 ? 149 : 254));
      before = (std::max)(before, found.number_of_quads);
      most = (std::max)(most, calls);
    }
  }
  std::cout << "searches for face graphs: at most " << most << " quantizations" << std::endl;
}

// What the search finds where `number(n)` quads are made for n, which are a face graph at once if
// `kind(n)` is 0, with some more if it is 1 or 2, and never if it is 3.
template <typename Number, typename Kind>
double searched_number(const Number& number, const Kind& kind, const double wanted,
                       const double maximum)
{
  const std::vector<Intrinsic_complex> complexes = tori();
  const auto quantize = [&](const double n) {
    internal::Quantized_complex result;
    result.complex = complexes[std::size_t(kind(n))];
    result.scales = {1.};
    result.number_of_quads = number(n);
    return result;
  };
  internal::Work work;
  return internal::Face_graph_search<decltype(quantize)>(quantize, work, maximum).run(wanted)
    .number_of_quads;
}

void test_choices_of_search()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  // numbers below those of the coarsest quantization are tried
  CHECK_EQUAL(searched_number([](const double n) { return (std::max)(n, 100.); },
                              [](const double n) { return n < 85 ? 0 : 2; }, 1, infinity), 100);
  // what is found later is taken only if it has fewer quads
  CHECK(searched_number([](const double n) { return (n < 500 ? 1.2 : 1.04) * n; },
                        [](const double n) { return n < 500 ? 1 : 0; }, 1000, infinity) < 1060);
  CHECK(searched_number([](const double n) { return (n < 500 ? 1.2 : 1.12) * n; },
                        [](const double n) { return n < 500 ? 1 : 0; }, 1000, infinity) < 1140);
  // a division with slightly fewer quads does not take the place of about as many as are wanted
  CHECK(searched_number([](const double n) { return (n < 500 ? 1. : 1.08) * n; },
                        [](const double) { return 0; }, 1000, infinity) > 1070);
  // what is no face graph, and can't be made one, is passed over
  CHECK(searched_number([](const double n) { return n; },
                        [](const double n) { return n < 200 ? 3 : 0; }, 100, infinity) > 190);
  // what has too many quads, whether a face graph or not, ends the search
  std::size_t calls = 0;
  const double number = searched_number([&](const double n) { ++calls; return (std::max)(n, 60.); },
                                        [](const double) { return 3; }, 50, 100);
  CHECK_IN(std::to_string(number), number > 100 && number < 110);
  CHECK_IN(std::to_string(calls), calls < 60);
}

// Where no work is left, the first face graph that is found is taken, and numbers grow fourfold
// until then.
void test_search_without_work()
{
  const std::vector<Intrinsic_complex> complexes = tori();
  for(const double least : {1., 3e3, 1e5}) {
    std::size_t calls = 0;
    const auto quantize = [&](const double n) {
      ++calls;
      internal::Quantized_complex result;
      result.complex = complexes[n < least ? 2 : 0];
      result.scales = {1.};
      result.number_of_quads = n < least ? 1.2 * n : 1.04 * n;
      return result;
    };
    internal::Work none(0);
    const auto found =
      internal::Face_graph_search<decltype(quantize)>(quantize, none).run(1000);
    CHECK(found.number_of_quads >= 950);
    CHECK(internal::number_of_quads(found.complex) >= 9);
    CHECK_IN(std::to_string(least), calls <= 7);
  }
}

void test_numbers()
{
  check_numbers(test_meshes::genus_2(), "genus 2");
  check_numbers(test_meshes::double_torus(), "double torus");
  check_numbers(test_meshes::torus(1, 2), "torus");
  check_numbers(test_meshes::pair_of_pants(), "pair of pants");
}

// --- real maps -----------------------------------------------------------------------------------

struct Sizes
{
  std::size_t maps = 0, runs = 0, meshes = 0, divided = 0, folds = 0;
};

bool has_double_edges(const Mesh& mesh)
{
  std::set<std::pair<Vertex, Vertex> > pairs;
  for(const auto h : mesh.halfedges())
    pairs.emplace(mesh.source(h), mesh.target(h));
  return pairs.size() < mesh.number_of_halfedges();
}

int expected_characteristic(const Parametrized_model& model)
{
  int chi = int(model.mesh.number_of_faces()) - int(model.mesh.number_of_edges());
  for(const auto v : model.mesh.vertices())
    chi += model.mesh.is_isolated(v) ? 0 : 1;
  return chi;
}

// Once all quads are divided into sixteen, they form a face graph, without those around vertices of
// one edge.
void check_divided(const Parametrized_model& model, const std::size_t number,
                   const std::string& name, Sizes& sizes)
{
  internal::Quantization_options options;
  options.number_of_quads = double(number);
  options.is_coarsest = number == 0;
  const auto features = parameters::edge_is_constrained_map(model.is_aligned);
  QR::Quantization quantization =
    internal::quantize_map(model.mesh, model.uv, internal::strip(features), options);
  CHECK_IN(name + ": " + quantization.message, bool(quantization));
  internal::Quantized_surface surface = quantization.surface();
  internal::refine(4, surface.complex);
  quantization.set_surface(
    std::make_shared<const internal::Quantized_surface>(std::move(surface)));
  quantization.number_of_quads *= 16;
  Mesh quads;
  const auto defaults = parameters::default_values();
  const auto report = internal::extract_cells_of<CGAL::Sequential_tag>(
    quantization, model.mesh, defaults, true,
    internal::cell_mesh_output(model.mesh, quads, defaults));
  CHECK_IN(name + ": " + report.message, bool(report));
  const std::size_t number_of_folds =
    internal::close_folds(quads, internal::holes_of_two_edges(Mesh()));
  quads.collect_garbage();
  CHECK_IN(name, quads.number_of_faces() == report.number_of_faces &&
                   report.number_of_faces + number_of_folds == quantization.number_of_quads);
  CHECK_IN(name, CGAL::is_valid_polygon_mesh(quads) && !has_double_edges(quads));
  CHECK_IN(name, std::all_of(quads.faces().begin(), quads.faces().end(),
                             [&](const auto f) { return quads.degree(f) == 4; }));
  CHECK_IN(name, euler_characteristic(quads) == expected_characteristic(model));
  sizes.folds += number_of_folds;
  ++sizes.divided;
}

using Location = std::pair<Mesh::Face_index, std::array<double, 3> >;

template <typename Surface>
bool lie_where_told(const Mesh& quads, const Surface& mesh,
                    const Mesh::Property_map<Vertex, Location>& location)
{
  for(const auto v : quads.vertices()) {
    const auto& [f, w] = location[v];
    const auto h = mesh.halfedge(f);
    const auto vector = [&](const auto u) { return mesh.point(u) - CGAL::ORIGIN; };
    const auto p = w[0] * vector(mesh.source(h)) + w[1] * vector(mesh.target(h)) +
                   w[2] * vector(mesh.target(mesh.next(h)));
    if(!(w[0] >= 0 && w[1] >= 0 && w[2] >= 0 &&
         (quads.point(v) - (CGAL::ORIGIN + p)).squared_length() <= 1e-18 * p.squared_length()))
      return false;
  }
  return true;
}

// Whether all faces are quads and the mesh is what the surface is; vertices lie where they say.
void check_mesh(const Parametrized_model& model, const QR::Quantization& quantization,
                const std::size_t number, const std::string& name, Sizes& sizes)
{
  Mesh quads;
  const auto location = quads.add_property_map<Vertex, Location>("v:location").first;
  const auto report = QR::extract_quad_mesh(quantization, model.mesh, quads,
                                            parameters::default_values(),
                                            parameters::vertex_location_map(location));
  if(report.status == QR::Outcome::NO_FACE_GRAPH)
    return check_divided(model, number, name, sizes); // all checks of the cells held before
  CHECK_IN(name + ": " + report.message, bool(report));
  CHECK_IN(name, report.number_of_faces == quantization.number_of_quads);
  CHECK_IN(name, report.number_of_other_polygons == 0 && CGAL::is_valid_polygon_mesh(quads));
  bool are_quads = true;
  for(const auto f : quads.faces())
    are_quads = are_quads && quads.degree(f) == 4;
  CHECK_IN(name, are_quads);
  CHECK_IN(name, euler_characteristic(quads) == expected_characteristic(model));
  CHECK_IN(name, !has_double_edges(quads));
  CHECK_IN(name, lie_where_told(quads, model.mesh, location));
  ++sizes.meshes;
}

void test_map(const std::filesystem::path& file, Sizes& sizes)
{
  Parametrized_model model(file.string());
  const std::string name = file.filename().string();
  const auto features = parameters::edge_is_constrained_map(model.is_aligned);
  if(!QR::snap_to_seamless(model.mesh, model.uv, features.align_border(true).tolerance(1.)))
    return;
  const QR::Quantization first = QR::quantize(model.mesh, model.uv, features);
  if(first.status == Status::NOT_POSITIVE)
    return;
  ++sizes.maps;
  for(const std::size_t number : {30000, 5000, 1000, 200, 0}) {
    const QR::Quantization quantization =
      QR::quantize(model.mesh, model.uv,
                   features.target_number_of_quads(number).minimize_number_of_quads(number == 0));
    const std::string run = name + " with " + std::to_string(number) + " quads";
    CHECK_IN(run + ": " + quantization.message, bool(quantization));
    if(!quantization)
      continue;
    const internal::Quantized_surface& surface = quantization.surface();
    const std::vector<int> angles = internal::angles_around_vertices(surface.complex);
    CHECK_IN(run, defect(surface.complex, angles, vectors).empty());
    CHECK_IN(run, defect(surface.complex, angles, units).empty());
    CHECK_IN(run, number < 1000 || std::abs(double(quantization.number_of_quads) -
                                            double(number)) < 0.5 * double(number));
    ++sizes.runs;
    check_mesh(model, quantization, number, run, sizes);
  }
  test_steps(read_integers(model.mesh, model.uv, model.is_aligned), 1, 1e5, name);
}

void test_maps()
{
  Sizes sizes;
  for(const auto& file : test_data::package_files())
    test_map(file, sizes);
  for(const auto& file : test_data::fifth_of_further_files("uv", ".obj"))
    test_map(file, sizes);
  std::cout << sizes.maps << " maps, " << sizes.runs << " quantizations, " << sizes.meshes
            << " of them face graphs, and " << sizes.divided << " once divided, "
            << sizes.folds << " vertices of one edge" << std::endl;
  CHECK(sizes.maps >= 5 && sizes.meshes > 4 * sizes.runs / 5);
}

// What is told of the quads that features force is what there is without them, also where more are
// needed for a mesh.
void test_quads_without_features()
{
  std::size_t number_of_forced = 0;
  for(const auto& file : test_data::package_files()) {
    Parametrized_model model(file.string());
    const auto features = parameters::edge_is_constrained_map(model.is_aligned);
    if(!QR::snap_to_seamless(model.mesh, model.uv, features.align_border(true).tolerance(1.)))
      continue;
    const auto with = QR::quantize(model.mesh, model.uv, features.target_number_of_quads(1));
    const auto without = QR::quantize(model.mesh, model.uv, parameters::target_number_of_quads(1));
    if(!with)
      continue;
    CHECK_EQUAL(with.number_of_quads - with.number_of_forced_quads,
                (std::min)(with.number_of_quads, without.number_of_quads));
    CHECK_EQUAL(with.message.find("some features can be released by maximum_feature_loss") !=
                  std::string::npos, 2 * with.number_of_forced_quads > with.number_of_quads);
    const auto mesh = QR::quantize(model.mesh, model.uv,
                                   features.target_number_of_quads(1).needs_face_graph(true));
    CHECK_EQUAL(mesh.number_of_forced_quads, with.number_of_forced_quads);
    number_of_forced += with.number_of_forced_quads;
  }
  std::cout << number_of_forced << " quads are forced by features" << std::endl;
  CHECK(number_of_forced > 0);
}

// A plate of 16 x 16 in one chart, with a feature from border to border, and a short one close to
// it: three columns and three rows are the fewest with both, two and one with the long one alone.
struct Plate_with_features
{
  using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;
  static constexpr double close_by = 8.0625;

  Mesh mesh;
  Edge_map is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;

  Plate_with_features()
  {
    const std::array<double, 6> x{0, 4, 8, close_by, 12, 16};
    const std::array<double, 5> y{0, 4, 8, 12, 16};
    for(const double b : y)
      for(const double a : x)
        mesh.add_vertex(Point_3(a, b, 0));
    const auto at = [&](const std::size_t i, const std::size_t j)
      { return Vertex(Mesh::size_type(x.size() * j + i)); };
    for(std::size_t j = 0; j + 1 < y.size(); ++j)
      for(std::size_t i = 0; i + 1 < x.size(); ++i) {
        mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    for(std::size_t j = 0; j + 1 < y.size(); ++j)
      is_feature[mesh.edge(mesh.halfedge(at(2, j), at(2, j + 1)))] = true;
    is_feature[mesh.edge(mesh.halfedge(at(3, 1), at(3, 2)))] = true;
  }
};

// Features go where they force quads, as far as that is allowed, the ones that are dear first.
void test_release_of_features()
{
  const Plate_with_features plate;
  std::vector<std::size_t> short_feature;
  Mesh copy(plate.mesh);
  UV_map uv = copy.add_property_map<Halfedge, Point_2>("h:uv").first;
  for(const auto h : copy.halfedges())
    uv[h] = Point_2(copy.point(copy.target(h)).x(), copy.point(copy.target(h)).y());
  for(const auto v : copy.vertices())
    if(copy.point(v).x() == plate.close_by && (copy.point(v).y() == 4 || copy.point(v).y() == 8))
      short_feature.push_back(std::size_t(v));
  const auto np = parameters::edge_is_constrained_map(plate.is_feature).target_number_of_quads(4);
  CHECK_EQUAL(QR::quantize(copy, uv, np).number_of_quads, 9u);
  for(const double loss : {0., 0.1, 0.19, 0.2, 0.5, 1.}) {
    const std::string context = "loss " + std::to_string(loss);
    const bool is_released = loss >= 0.2; // of 16 + 4
    auto quantization = QR::quantize(copy, uv, np.maximum_feature_loss(loss));
    CHECK_IN(context + ": " + quantization.message, bool(quantization));
    CHECK_IN(context, quantization.number_of_quads == (is_released ? 4u : 9u));
    CHECK_IN(context, quantization.released_features.size() == (is_released ? 1u : 0u));
    CHECK_IN(context, (quantization.message.find("20 % of the length") != std::string::npos) ==
                        is_released);
    CHECK_IN(context, (quantization.message.find("no feature is released: each that forces") !=
                       std::string::npos) == (loss > 0 && !is_released));
    for(std::vector<std::size_t>& f : quantization.released_features) {
      std::sort(f.begin(), f.end());
      CHECK(f == short_feature);
    }
    Mesh quads;
    const auto is_kept = quads.add_property_map<Mesh::Edge_index, bool>("e:kept", false).first;
    CHECK(bool(QR::extract_quad_mesh(quantization, copy, quads, parameters::default_values(),
                                     parameters::edge_is_constrained_map(is_kept))));
    double length = 0; // of features inside
    for(const auto e : quads.edges())
      if(is_kept[e] && !quads.is_border(e)) {
        const auto side = quads.point(quads.vertex(e, 1)) - quads.point(quads.vertex(e, 0));
        CHECK(std::abs(side.x()) < 1e-12);
        length += std::abs(side.y());
      }
    CHECK(std::abs(length - (is_released ? 16 : 20)) < 1e-12);
  }
  for(const double loss : {-0.5, 1.5, std::numeric_limits<double>::quiet_NaN()})
    CHECK(QR::quantize(copy, uv, np.maximum_feature_loss(loss)).status == Status::INVALID_ARGUMENT);

  const auto report = QR::quad_remesh(plate.mesh, *std::make_unique<Mesh>(),
                                      np.maximum_feature_loss(0.25));
  CHECK_IN(report.message, bool(report));
  CHECK(report.number_of_quads <
        QR::quad_remesh(plate.mesh, *std::make_unique<Mesh>(), np).number_of_quads);
  if(CHECK_EQUAL(report.released_features.size(), 1u)) {
    const QR::Released_feature& f = report.released_features.front();
    CHECK_EQUAL(f.length, 4.);
    CHECK_EQUAL(f.source[0], plate.close_by);
    CHECK_EQUAL(f.target[0], plate.close_by);
    CHECK_EQUAL(f.source[1] + f.target[1], 12.);
  }
}

// --- borders off isocurves -----------------------------------------------------------------------

// Moves vertices of the border that lie in one chart.
void move_border(Grid_map& map, const unsigned seed)
{
  std::mt19937_64 random(seed);
  const auto number = [&] { return double(random() % 129) / 32 - 2; };
  for(const auto v : map.mesh.vertices()) {
    if(map.mesh.is_isolated(v) || !map.mesh.is_border(v))
      continue;
    std::vector<Halfedge> corners;
    for(const auto h : CGAL::halfedges_around_target(map.mesh.halfedge(v), map.mesh))
      if(!map.mesh.is_border(h))
        corners.push_back(h);
    const CGAL::Vector_2<Kernel> d(number(), number());
    const bool is_in_one_chart = std::all_of(corners.begin(), corners.end(), [&](const Halfedge h)
                                             { return map.uv[h] == map.uv[corners.front()]; });
    if(!is_in_one_chart || random() % 2 == 0)
      continue;
    for(const Halfedge h : corners)
      map.uv[h] = map.uv[h] + d;
    if(!map.is_positive_around(v))
      for(const Halfedge h : corners)
        map.uv[h] = map.uv[h] - d;
  }
}

std::size_t number_of_unaligned_border_edges(const Grid_map& map)
{
  std::size_t number = 0;
  for(const Halfedge h : map.mesh.halfedges()) {
    const Halfedge o = map.mesh.opposite(h);
    if(map.mesh.is_border(o)) {
      const auto d = map.uv[h] - map.uv[map.mesh.prev(h)];
      number += d.x() != 0 && d.y() != 0 ? 1 : 0;
    }
  }
  return number;
}

// The border of the quads is that of the surface.
void check_unaligned_border(const Grid_map& map, const std::size_t number, const std::string& name)
{
  const QR::Quantization quantization =
    QR::quantize(map.mesh, map.uv,
                 parameters::target_number_of_quads(number).needs_face_graph(true));
  CHECK_IN(name + ": " + quantization.message, bool(quantization));
  CHECK_EQUAL(quantization.number_of_unaligned_border_edges, number_of_unaligned_border_edges(map));
  CHECK_IN(name, quantization.message.find("on no isocurve") != std::string::npos);
  Mesh quads;
  const auto location = quads.add_property_map<Vertex, Location>("v:location").first;
  const auto report = QR::extract_quad_mesh(quantization, map.mesh, quads,
                                            parameters::default_values(),
                                            parameters::vertex_location_map(location));
  CHECK_IN(name + ": " + report.message, bool(report));
  quads.collect_garbage();
  CHECK_IN(name, CGAL::is_valid_polygon_mesh(quads) &&
                   euler_characteristic(quads) == euler_characteristic(map.mesh));
  bool are_quads = true, are_on_border = true;
  for(const auto f : quads.faces())
    are_quads = are_quads && quads.degree(f) == 4;
  for(const auto v : quads.vertices()) {
    const auto& [f, w] = location[v];
    const Halfedge h = map.mesh.halfedge(f);
    const std::array<Halfedge, 3> edges{map.mesh.next(h), map.mesh.prev(h), h}; // opposite to each
    bool is_on_border = false;
    for(std::size_t i = 0; i < 3; ++i)
      is_on_border = is_on_border || w[i] == 1 || // at vertices, any face is told
                     (w[i] == 0 && map.mesh.is_border(map.mesh.opposite(edges[i])));
    are_on_border = are_on_border && (!quads.is_border(v) || is_on_border);
  }
  CHECK_IN(name, are_quads);
  CHECK_IN(name, are_on_border);
}

// The step over an edge from (4, 3) to (0, 4) has its corner at the foot of the height there.
void test_place_of_step()
{
  Mesh mesh;
  const Mesh::Vertex_index v[] = {mesh.add_vertex(Point_3(0, 0, 0)),
                                  mesh.add_vertex(Point_3(4, 0, 0)),
                                  mesh.add_vertex(Point_3(4, 3, 0)),
                                  mesh.add_vertex(Point_3(0, 4, 0))};
  mesh.add_face(v[0], v[1], v[2]);
  mesh.add_face(v[0], v[2], v[3]);
  const auto uv = mesh.add_property_map<Halfedge, Point_2>("h:uv").first;
  for(const Halfedge h : mesh.halfedges()) {
    const Point_3& p = mesh.point(mesh.target(h));
    uv[h] = Point_2(p.x(), p.y());
  }
  const auto quantization = QR::quantize(mesh, uv, parameters::target_number_of_quads(16));
  CHECK_IN(quantization.message, quantization.number_of_quads == 16);
  Mesh quads;
  CHECK(bool(QR::extract_quad_mesh(quantization, mesh, quads)));
  CHECK(std::any_of(quads.vertices().begin(), quads.vertices().end(), [&](const auto w) {
    return CGAL::squared_distance(quads.point(w), Point_3(4 - 4. / 17, 3 + 1. / 17, 0)) < 1e-24;
  }));
}

// A square turned by 45 degrees in the domain: two quads meet at all vertices along its sides but
// two next to each corner, and none is inverted. Without that, one and three do by turns.
void test_even_border()
{
  for(const std::size_t wanted : {60, 300, 2000}) {
    Grid_map map(surfaces::disc(4, 4), 1, 1);
    for(const Halfedge h : map.mesh.halfedges()) {
      const Point_3& p = map.mesh.point(map.mesh.target(h));
      map.uv[h] = Point_2(p.x() - p.y(), p.x() + p.y());
    }
    const QR::Quantization quantization =
      QR::quantize(map.mesh, map.uv,
                   parameters::target_number_of_quads(wanted).needs_face_graph(true));
    Mesh quads;
    const auto report = QR::quad_remesh(quantization, map.mesh, quads);
    CHECK_IN(report.message, bool(report));
    CHECK_EQUAL(report.number_of_inverted_quads, std::size_t(0));
    CHECK_IN(std::to_string(report.mean_scaled_jacobian), report.mean_scaled_jacobian > 0.7);
    quads.collect_garbage();
    CHECK(CGAL::is_valid_polygon_mesh(quads) && euler_characteristic(quads) == 1);
    const auto number_of_others = std::count_if(
      quads.vertices().begin(), quads.vertices().end(), [&](const Vertex v) {
        const Point_3& p = quads.point(v);
        const bool is_corner = (p.x() == 0 || p.x() == 4) && (p.y() == 0 || p.y() == 4);
        return quads.is_border(v) && !is_corner && quads.degree(v) != 3;
      });
    CHECK_IN(std::to_string(number_of_others), number_of_others <= 8);
  }
}

void test_unaligned_borders()
{
  std::size_t number = 0;
  for(const Square_complex& complex :
      {surfaces::disc(2, 2), surfaces::cylinder(2, 3), surfaces::cone_ring(5),
       surfaces::pair_of_pants(), surfaces::box_with_holes(), surfaces::two_islands()})
    for(const unsigned seed : {1u, 2u, 3u}) {
      Grid_map map(complex, 16, 4);
      move_border(map, seed);
      for(const std::size_t wanted : {1, 4000})
        check_unaligned_border(map, wanted, "seed " + std::to_string(seed) + ", " +
                                              std::to_string(wanted) + " quads");
      number += number_of_unaligned_border_edges(map);
    }
  std::cout << number << " border edges on no isocurve" << std::endl;
  CHECK(number > 100);
  test_place_of_step();
  test_even_border();
}

// --- quads around vertices of one edge -----------------------------------------------------------

// Puts a square between the two sides of an edge that is folded around its corner 0, with an edge
// to the end of the side.
void insert_folded_square(surfaces::Square_complex& complex, const int i, const int s)
{
  const square_complex::Side other = complex.across(i, s);
  const int q = complex.add_square();
  complex.glue(q, 0, q, 3);
  complex.glue(q, 1, i, s);
  complex.glue(q, 2, other.square, other.side);
}

// The folded squares share vertices with each other, and with the border.
void test_folded_squares(const surfaces::Square_complex& complex, const int i,
                         const std::vector<int>& sides)
{
  surfaces::Square_complex folded = complex;
  for(const int s : sides)
    insert_folded_square(folded, i, s);
  folded.unfold();
  const Grid_map without(complex, 4, 4), map(folded, 4, 4);
  const QR::Quantization quantization = QR::quantize(
    map.mesh, map.uv, parameters::target_number_of_quads(std::size_t(folded.number_of_squares())));
  CHECK_EQUAL(quantization.number_of_quads, std::size_t(folded.number_of_squares()));
  Mesh quads;
  for(const std::string message : {QR::extract_quad_mesh(map.mesh, map.uv, quads).message,
                                  QR::extract_quad_mesh(quantization, map.mesh, quads).message})
    CHECK_IN(message, message.find("has only one edge, at any scale; quantize() with ") !=
                        message.npos && quads.is_empty());
  const auto location = quads.add_property_map<Vertex, Location>("v:location").first;
  const auto np = parameters::vertex_location_map(location);
  const auto report = internal::extract_cells_of<CGAL::Sequential_tag>(
    quantization, map.mesh, parameters::default_values(), true,
    internal::cell_mesh_output(map.mesh, quads, np));
  CHECK_IN(report.message, bool(report));
  CHECK_EQUAL(internal::close_folds(quads, internal::holes_of_two_edges(Mesh())), sides.size());
  quads.collect_garbage();
  CHECK(lie_where_told(quads, map.mesh, location));
  CHECK(CGAL::is_valid_polygon_mesh(quads) && !has_double_edges(quads));
  CHECK_EQUAL(quads.number_of_faces(), Mesh::size_type(complex.number_of_squares()));
  CHECK_EQUAL(euler_characteristic(quads), euler_characteristic(without.mesh));
}

void test_folds()
{
  const std::vector<std::vector<int> > some_sides{{0}, {0, 1}, {0, 1, 2}, {1, 3}};
  for(const auto& sides : some_sides)
    test_folded_squares(surfaces::box(3, 3, 3), 4, sides);
  for(int s = 0; s < 4; ++s) // of a square in a corner of the disc, two sides are border
    for(int i = 0; i < 9; ++i)
      if(!surfaces::disc(3, 3).across(i, s).is_border())
        test_folded_squares(surfaces::disc(3, 3), i, {s});
}

// --- remeshing -----------------------------------------------------------------------------------

void check_remeshing(const Parametrized_model& model, const QR::Remeshing_report& report,
                     const Mesh& quads, const std::size_t number, const std::string& name)
{
  CHECK_IN(name + ": " + report.message, bool(report));
  CHECK_IN(name, CGAL::is_valid_polygon_mesh(quads) && report.number_of_quads > number / 2);
  CHECK_IN(name, !has_double_edges(quads));
  CHECK_EQUAL(report.number_of_quads, std::size_t(quads.number_of_faces()));
  CHECK_EQUAL(report.number_of_vertices, std::size_t(quads.number_of_vertices()));
  CHECK_EQUAL(euler_characteristic(quads), euler_characteristic(model.mesh));
  std::size_t number_of_irregular = 0;
  for(const auto v : quads.vertices())
    number_of_irregular += CGAL::is_border(v, quads) || quads.degree(v) == 4 ? 0 : 1;
  CHECK_EQUAL(number_of_irregular, report.number_of_irregular_vertices);
  for(const auto f : quads.faces())
    CHECK_EQUAL(quads.degree(f), 4u);
  CHECK_IN(name, report.mean_scaled_jacobian > 0.7 && report.mean_scaled_jacobian <= 1);
  const QR::Quad_shapes shapes = QR::measure_quad_shapes(quads); // in another size
  CHECK_EQUAL(report.least_scaled_jacobian, shapes.least_scaled_jacobian);
  CHECK_EQUAL(report.mean_scaled_jacobian, shapes.mean_scaled_jacobian);
  CHECK_EQUAL(report.largest_aspect_ratio, shapes.largest_aspect_ratio);
  CHECK_EQUAL(report.number_of_long_quads, shapes.number_of_long_quads);
  CHECK_IN(name, report.first_thin_quads == shapes.first_thin_quads);
  CHECK_EQUAL(report.first_inverted_quads.size(),
              (std::min)(report.number_of_inverted_quads, std::size_t(10)));
  if(std::abs(report.least_scaled_jacobian) > 1e-9)
    CHECK_EQUAL(report.number_of_inverted_quads > 0, report.least_scaled_jacobian < 0);
  // The ends and corners of features are vertices of quads, exactly.
  std::set<Point_3> points;
  for(const auto v : quads.vertices())
    points.insert(quads.point(v));
  for(const auto v : model.mesh.vertices()) {
    int n = 0;
    for(const auto h : CGAL::halfedges_around_target(v, model.mesh))
      n += model.is_aligned[model.mesh.edge(h)] ? 1 : 0;
    if(n == 1 || n > 2)
      CHECK_IN(name, points.count(model.mesh.point(v)) == 1);
  }
}

// A closed tube of six sides, which are twisted by some of them. Its walls are one or three lines;
// their lengths have to be multiples, or all quads are sheared. A side is a small part of a quad
// wide, so that a shift by one unit is much.
void test_twisted_tubes()
{
  constexpr int n = 100, sides = 6;
  for(const int twist : {1, 3}) {
    Mesh mesh;
    for(int i = 0; i < n; ++i)
      for(int k = 0; k < sides; ++k) {
        const double a = 2 * CGAL_PI * i / n, b = 2 * CGAL_PI * (k + double(twist) * i / n) / sides;
        const double r = 10 + 0.1 * std::cos(b);
        mesh.add_vertex(Point_3(r * std::cos(a), r * std::sin(a), 0.1 * std::sin(b)));
      }
    const auto vertex = [&](const int i, const int k)
      { return Vertex(i % n * sides + (k + i / n * twist) % sides); };
    for(int i = 0; i < n; ++i)
      for(int k = 0; k < sides; ++k) {
        mesh.add_face(vertex(i, k), vertex(i + 1, k), vertex(i + 1, k + 1));
        mesh.add_face(vertex(i, k), vertex(i + 1, k + 1), vertex(i, k + 1));
      }
    const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
    for(int i = 0; i < n; ++i)
      for(int k = 0; k < sides; ++k)
        is_feature[mesh.edge(mesh.halfedge(vertex(i, k), vertex(i + 1, k)))] = true;
    // Of few quads, others are chosen where these are sheared.
    for(const std::size_t wanted : {200, twist == 1 ? 2000 : 1100}) {
      Mesh quads;
      const auto report = QR::quad_remesh(
        mesh, quads,
        parameters::edge_is_constrained_map(is_feature).target_number_of_quads(wanted));
      const std::string context = "twisted by " + std::to_string(twist) + ": " +
                                  std::to_string(report.number_of_quads) +
                                  " quads, mean Jacobian " +
                                  std::to_string(report.mean_scaled_jacobian) + report.message;
      CHECK_IN(context, report && report.number_of_quads < 2 * wanted &&
                          report.mean_scaled_jacobian > 0.98);
    }
  }
}

// A wire wound to a spring, hundreds of times as long as thick. Nothing holds it but the cones at
// its ends. Once around it the map has two to four quads, and the ends take four: what is added
// must not shear the quads of the whole length.
void test_thin_springs()
{
  constexpr int n = 300, sides = 6, turns = 3;
  constexpr double pitch = 0.6, radius = 0.03; // of the wire; that of the spring is 1
  Mesh mesh;
  const double slope = pitch / (2 * CGAL_PI);
  const auto axis = [&](const double a) { return Point_3(std::cos(a), std::sin(a), slope * a); };
  for(int i = 0; i <= n; ++i) {
    const double a = 2 * CGAL_PI * turns * i / n;
    const Kernel::Vector_3 outward(std::cos(a), std::sin(a), 0);
    Kernel::Vector_3 across(slope * std::sin(a), -slope * std::cos(a), 1);
    across = across / std::sqrt(across.squared_length());
    for(int k = 0; k < sides; ++k) {
      const double b = 2 * CGAL_PI * (k + 0.5 * (i % 2)) / sides;
      mesh.add_vertex(axis(a) + radius * (std::cos(b) * outward + std::sin(b) * across));
    }
  }
  const auto vertex = [&](const int i, const int k) { return Vertex(i * sides + k % sides); };
  for(int i = 0; i < n; ++i)
    for(int k = 0; k < sides; ++k) {
      const int shift = i % 2; // of the next circle
      mesh.add_face(vertex(i, k), vertex(i + 1, k + shift), vertex(i, k + 1));
      mesh.add_face(vertex(i + 1, k), vertex(i + 1, k + 1), vertex(i, k + 1 - shift));
    }
  for(const int i : {0, n}) {
    const Vertex tip = mesh.add_vertex(axis(2 * CGAL_PI * turns * i / n));
    for(int k = 0; k < sides; ++k)
      i == 0 ? mesh.add_face(tip, vertex(i, k), vertex(i, k + 1))
             : mesh.add_face(tip, vertex(i, k + 1), vertex(i, k));
  }
  CHECK(CGAL::is_closed(mesh));
  for(const std::size_t wanted : {200, 300, 400, 600, 1000, 2000}) {
    Mesh quads;
    const auto report =
      QR::quad_remesh(mesh, quads, parameters::target_number_of_quads(wanted));
    const std::string context = "spring: " + std::to_string(report.number_of_quads) +
                                " quads, mean Jacobian " +
                                std::to_string(report.mean_scaled_jacobian) + report.message;
    std::cout << context << std::endl;
    CHECK_IN(context, report && double(report.number_of_quads) < 1.1 * double(wanted) &&
                        report.number_of_inverted_quads == 0 &&
                        report.mean_scaled_jacobian > 0.95);
  }
}

// There are fewest where they are to be as few as possible. If some of so few would be inverted or
// folded, which the message tells, there are at most twice as many. Where fewer are wanted, there
// are not more than for a better shape, which takes up to half as many again.
void check_monotony(const Parametrized_model& model, const std::string& name)
{
  const auto remeshed = [&](const auto& np) {
    const auto report = QR::quad_remesh(model.mesh, *std::make_unique<Mesh>(), np);
    CHECK_IN(name + ": " + report.message, bool(report));
    return report;
  };
  const auto coarsest = remeshed(parameters::minimize_number_of_quads(true));
  const double fewest = double(coarsest.number_of_quads);
  const double of_one = double(remeshed(parameters::target_number_of_quads(1)).number_of_quads);
  const double of_50 = double(remeshed(parameters::target_number_of_quads(50)).number_of_quads);
  const bool would_be_bad =
    std::string(coarsest.message).find("of them inverted or folded") != std::string::npos;
  CHECK_IN(name + ": " + std::to_string(fewest) + " quads, " + std::to_string(of_one) + ", and " +
             std::to_string(of_50) + "; " + coarsest.message,
           (std::min)(of_one, of_50) >= (would_be_bad ? 0.5 : 0.95) * fewest &&
             of_50 >= 0.95 * of_one / 1.5);
}

// Refused alike by all functions.
void test_empty_mesh()
{
  Mesh empty, quads;
  const auto uv = empty.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  const auto check = [](const auto status, const auto expected, const std::string& message) {
    CHECK(status == expected);
    CHECK_EQUAL(message, std::string("the mesh has no face; was it read?"));
  };
  const auto snapped = QR::snap_to_seamless(empty, uv);
  check(snapped.status, QR::Outcome::INVALID_ARGUMENT, snapped.message);
  const auto made = QR::approximate_seamless_parametrization(empty, uv);
  check(made.status, QR::Outcome::INVALID_ARGUMENT, made.message);
  const auto extracted = QR::extract_quad_mesh(empty, uv, quads);
  check(extracted.status, QR::Outcome::INVALID_ARGUMENT, extracted.message);
  const auto quantization = QR::quantize(empty, uv);
  check(quantization.status, Status::INVALID_ARGUMENT, quantization.message);
  const auto graph = QR::motorcycle_graph(empty, uv);
  check(graph.status(), QR::Outcome::INVALID_ARGUMENT, graph.message());
  const auto remeshed = QR::quad_remesh(empty, quads);
  check(remeshed.status, QR::Outcome::INVALID_ARGUMENT, remeshed.message);
}

// What the mesh has before is not touched, such as a hole of two edges, which folds leave, too.
void test_addition_of_quads()
{
  const Square_complex complex = test_meshes::torus(1, 2);
  const Grid_map map(complex, 16, 4);
  const QR::Quantization quantization =
    QR::quantize(map.mesh, map.uv, parameters::target_number_of_quads(100).needs_face_graph(true));
  Mesh quads;
  const auto h = CGAL::make_tetrahedron(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0),
                                        Point_3(0, 0, 1), quads);
  CGAL::Euler::split_face(h, quads.prev(h), quads); // beside the edge, which has two faces now
  CGAL::Euler::make_hole(quads.degree(quads.face(h)) == 2 ? h : quads.opposite(h), quads);
  CHECK_EQUAL(internal::holes_of_two_edges(quads).size(), 1u);
  CHECK(bool(QR::extract_quad_mesh(quantization, map.mesh, quads)));
  CHECK(quads.number_of_removed_edges() == 0 && quads.number_of_faces() > 50);
}

void test_remeshing()
{
  std::size_t number = 0;
  for(const auto& file : test_data::package_files()) {
    const std::string name = file.filename().string();
    Parametrized_model model(file.string());
    const auto features = parameters::edge_is_constrained_map(model.is_aligned);
    constexpr std::size_t wanted = 1000;
    const auto np = features.target_number_of_quads(wanted);
    Mesh quads, others;
    check_remeshing(model, QR::quad_remesh(model.mesh, quads, np), quads, wanted, name);
    CHECK_IN(name, bool(QR::snap_to_seamless(model.mesh, model.uv,
                                             features.repair_flips(true))));
    const auto quantization =
      QR::quantize(model.mesh, model.uv, np.needs_face_graph(true));
    CHECK_IN(name + ": " + quantization.message, bool(quantization));
    check_remeshing(model, QR::quad_remesh(quantization, model.mesh, others), others, wanted,
                    name + ", of a quantization");
    if(number++ % 4 == 0 || test_data::are_tests_long()) // it takes long
      check_monotony(model, name);
  }
  Mesh one_quad, square, quads;
  CHECK(QR::quad_remesh(QR::Quantization(), square, quads).status ==
        QR::Outcome::INVALID_ARGUMENT);
  std::vector<Vertex> corners;
  for(Mesh* mesh : {&one_quad, &square})
    corners = {mesh->add_vertex(Point_3(0, 0, 0)), mesh->add_vertex(Point_3(1, 0, 0)),
               mesh->add_vertex(Point_3(1, 1, 0)), mesh->add_vertex(Point_3(0, 1, 0))};
  one_quad.add_face(corners);
  CHECK(QR::quad_remesh(one_quad, quads).status == QR::Outcome::NOT_TRIANGULAR);
  square.add_face(corners[0], corners[1], corners[2]);
  square.add_face(corners[2], corners[3], corners[0]);
  CHECK(QR::quad_remesh(square, quads, parameters::target_number_of_quads(0)).status ==
        QR::Outcome::INVALID_ARGUMENT);
  CHECK(quads.is_empty());
  CHECK(bool(QR::quad_remesh(square, quads, parameters::target_number_of_quads(100))));
  CHECK_EQUAL(quads.number_of_faces(), 100u);
}

// Of parametrization, quantization, and remeshing: nothing is left of what was interrupted.
void test_interruptions()
{
  Parametrized_model model(test_data::package_file("genus2_features"));
  const Mesh& mesh = model.mesh;
  const auto features = parameters::edge_is_constrained_map(model.is_aligned);
  const std::vector<Point_2> before(model.uv.begin(), model.uv.end());
  interruptions::test("parametrization", [&](const auto& visitor) {
    std::copy(before.begin(), before.end(), model.uv.begin());
    return bool(QR::approximate_seamless_parametrization(mesh, model.uv,
                                                         features.visitor(visitor)));
  }, [&] { return std::equal(before.begin(), before.end(), model.uv.begin()); });
  CHECK(bool(QR::snap_to_seamless(mesh, model.uv, features.repair_flips(true))));
  QR::Quantization quantization;
  interruptions::test("quantization", [&](const auto& visitor) {
    quantization = QR::Quantization();
    quantization = QR::quantize(mesh, model.uv, features.needs_face_graph(true).visitor(visitor));
    return bool(quantization);
  }, [&] { return quantization.number_of_quads == 0; });
  Mesh quads;
  const auto texts = interruptions::test("remeshing", [&](const auto& visitor) {
    quads.clear();
    return bool(QR::quad_remesh(mesh, quads,
                                features.target_number_of_quads(300).visitor(visitor)));
  }, [&] { return quads.is_empty(); });
  CHECK(texts.size() > 10);
}

// A square, and one of random heights.
std::vector<Mesh> square_and_peaks(const unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<Mesh> result(2);
  for(const std::size_t height : {0u, 8u}) {
    const auto point = [&](const std::size_t i, const std::size_t j)
    { return Point_3(double(i), double(j), double(height) * double(random() % 1000) / 1000); };
    CGAL::make_grid(6, 6, result[height > 0 ? 1 : 0], point, true);
  }
  return result;
}

// Where the work is spent, searches end, and the message tells so: what has no flips by then is
// remeshed nevertheless. The work is counted, and the same at each run.
void test_spent_work()
{
  const auto remesh = [](const Mesh& mesh, const double most, double& left) {
    const auto np = parameters::target_number_of_quads(100);
    const auto& plain_np = internal::strip(np);
    internal::Remeshing_options options = internal::remeshing_options(mesh, plain_np, false);
    *options.quantization.work = internal::Work(most);
    Mesh quads;
    const auto is_feature = quads.add_property_map<Mesh::Edge_index, bool>("e:feature").first;
    internal::Marked_surface input = internal::read_surface(mesh, plain_np);
    const QR::Remeshing_report report =
      internal::remesh(input, std::nullopt, options, quads, is_feature);
    left = options.quantization.work->left();
    CHECK_IN(report.message, (left == 0) == (report.message.find(internal::words_for_spent_work) !=
                                             std::string::npos));
    CHECK_EQUAL(quads.is_empty(), !report);
    return report;
  };
  constexpr double most = internal::Work::most_work;
  constexpr unsigned seed = 1;
  std::cout << "spent work: peaks of seed " << seed << std::endl;
  for(const Mesh& mesh : square_and_peaks(seed)) {
    double left = 0, again = 0;
    CHECK(bool(remesh(mesh, most, left)) && left > 0 && left < most);
    remesh(mesh, most, again);
    CHECK_EQUAL(left, again);
    const QR::Remeshing_report report = remesh(mesh, 0, left);
    CHECK_IN(report.message, bool(report));
    CHECK_EQUAL(left, 0);
  }
}

// Times a power of two, the quads are the same ones times this power, to the last bit; so are those
// that are quantized on a map of any size.
void test_sizes_in_space()
{
  const auto np = parameters::target_number_of_quads(300);
  const Parametrized_model model(test_data::package_files().front().string());
  Mesh quads;
  const auto report = QR::quad_remesh(model.mesh, quads, np);
  CHECK(bool(report));
  const auto by_length = QR::quad_remesh(model.mesh, *std::make_unique<Mesh>(),
                                         parameters::target_edge_length(0.25));
  CHECK(bool(by_length));
  for(const int exponent : {-900, -500, 3, 531, 900}) {
    const std::string context = "size 2^" + std::to_string(exponent);
    Parametrized_model scaled(test_data::package_files().front().string());
    for(const auto v : scaled.mesh.vertices()) {
      Point_3& p = scaled.mesh.point(v);
      p = Point_3(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                  std::ldexp(p.z(), exponent));
    }
    Mesh scaled_quads;
    const auto scaled_report = QR::quad_remesh(scaled.mesh, scaled_quads, np);
    CHECK_IN(context + ": " + scaled_report.message, bool(scaled_report));
    CHECK_IN(context, scaled_report.largest_distance ==
                        std::ldexp(report.largest_distance, exponent));
    CHECK_IN(context, scaled_quads.number_of_vertices() == quads.number_of_vertices() &&
                        scaled_quads.number_of_faces() == quads.number_of_faces());
    for(const auto v : quads.vertices())
      for(int c = 0; c < 3; ++c)
        CHECK_IN(context, scaled_quads.is_valid(v) && scaled_quads.point(v)[c] ==
                                                        std::ldexp(quads.point(v)[c], exponent));
    const auto scaled_by_length =
      QR::quad_remesh(scaled.mesh, *std::make_unique<Mesh>(),
                      parameters::target_edge_length(std::ldexp(0.25, exponent)));
    CHECK_IN(context, scaled_by_length.number_of_quads == by_length.number_of_quads);

    CHECK_IN(context, bool(QR::snap_to_seamless(model.mesh, scaled.uv)));
    const auto in_domain = QR::quantize(model.mesh, scaled.uv, np);
    for(const auto h : scaled.mesh.halfedges())
      scaled.uv[h] = Point_2(std::ldexp(scaled.uv[h].x(), exponent),
                             std::ldexp(scaled.uv[h].y(), exponent));
    const auto scaled_in_domain = QR::quantize(model.mesh, scaled.uv, np);
    CHECK_IN(context + ": " + scaled_in_domain.message, bool(scaled_in_domain));
    CHECK_IN(context, scaled_in_domain.number_of_quads == in_domain.number_of_quads);
  }
}

// --- sizes, symmetry, and what hangs on the surface ----------------------------------------------

// A torus of revolution around the z-axis, whose vertices are symmetric by x = center, to the bit.
Mesh symmetric_torus(const int n, const int m, const double center)
{
  Mesh mesh;
  const double pi = std::acos(-1.);
  const auto cosine = [&](const int i) { // of quarter turns and multiples, to the bit
    const int k = i % n, l = (std::min)(k, n - k);
    return 2 * l <= n / 2 ? std::cos(2 * pi * l / n) : -std::cos(2 * pi * (n / 2 - l) / n);
  };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j) {
      const double r = std::ldexp(std::round(std::ldexp(3 + std::cos(2 * pi * j / m), 20)), -20);
      const double x = std::ldexp(std::round(std::ldexp(r * cosine(i), 20)), -20);
      mesh.add_vertex(Point_3(center + x, r * cosine(i + 3 * n / 4), std::sin(2 * pi * j / m)));
    }
  const auto at = [&](const int i, const int j) { return Vertex((i % n) * m + j % m); };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j) {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

// The median over the edges of the ratio of their length to the size there, and of its deviation.
template <typename SizeAt>
std::pair<double, double> measure_sizes(const Mesh& quads, const SizeAt& size_at)
{
  std::vector<double> ratios;
  for(const auto e : quads.edges()) {
    const Point_3 &p = quads.point(quads.vertex(e, 0)), &q = quads.point(quads.vertex(e, 1));
    ratios.push_back(std::sqrt(CGAL::squared_distance(p, q)) / size_at(CGAL::midpoint(p, q)));
  }
  const auto middle = ratios.begin() + std::ptrdiff_t(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  const double median = *middle;
  for(double& ratio : ratios)
    ratio = std::abs(std::log(ratio / median));
  std::nth_element(ratios.begin(), middle, ratios.end());
  return {median, *middle};
}

void test_sizes_of_quads()
{
  Mesh mesh = symmetric_torus(48, 24, 0);
  const auto size = mesh.add_property_map<Vertex, double>("v:size").first;
  const auto size_at = [](const Point_3& p) { return 0.25 * std::exp(std::log(4.) * p.x() / 8); };
  for(const auto v : mesh.vertices())
    size[v] = size_at(mesh.point(v));
  const auto np = parameters::vertex_sizing_map(size);
  Mesh quads, fewer, smaller;
  const auto report = QR::quad_remesh(mesh, quads, np);
  CHECK_IN(report.message, bool(report));
  const auto [median, deviation] = measure_sizes(quads, size_at);
  std::cout << report.number_of_quads << " quads: median ratio " << median << ", deviation "
            << deviation << std::endl;
  CHECK(median > 0.85 && median < 1.15 && deviation < std::log(1.15));
  // Of so many quads, the sizes are relative; with a length, they are multiples of it.
  const auto by_number = QR::quad_remesh(mesh, fewer, np.target_number_of_quads(1000));
  CHECK(by_number && by_number.number_of_quads > 900 && by_number.number_of_quads < 1100);
  const auto relative = measure_sizes(fewer, size_at);
  const double factor = std::sqrt(double(report.number_of_quads) / 1000);
  CHECK(relative.first > 0.85 * factor && relative.first < 1.15 * factor &&
        relative.second < std::log(1.15));
  const auto by_length = QR::quad_remesh(mesh, smaller, np.target_edge_length(0.5));
  CHECK(by_length && std::abs(double(by_length.number_of_quads) /
                              double(report.number_of_quads) - 4) < 0.4);
  for(const int exponent : {-1000, 1000}) { // squares are 0 and infinite
    const auto extreme = mesh.add_property_map<Vertex, double>().first;
    for(const auto v : mesh.vertices())
      extreme[v] = std::ldexp(size[v], exponent);
    const auto same = QR::quad_remesh(mesh, quads,
                                      parameters::vertex_sizing_map(extreme)
                                                 .target_number_of_quads(1000));
    CHECK_IN(same.message, same.number_of_quads == by_number.number_of_quads &&
                           same.median_size_deviation == by_number.median_size_deviation);
  }
  size[Vertex(3)] = 0;
  CHECK(QR::quad_remesh(mesh, quads, np).status == QR::Outcome::INVALID_ARGUMENT);
}

// Whether the image of each point is a vertex, to the bit, and that of each quad a quad.
bool is_symmetric(const Mesh& quads, const double center)
{
  std::map<Point_3, Vertex> vertices;
  for(const auto v : quads.vertices())
    vertices[quads.point(v)] = v;
  std::set<std::set<Vertex> > faces;
  std::vector<std::set<Vertex> > images;
  for(const auto f : quads.faces()) {
    std::set<Vertex> face, image;
    for(const auto v : CGAL::vertices_around_face(quads.halfedge(f), quads)) {
      const Point_3& p = quads.point(v);
      const auto it = vertices.find(Point_3(2 * center - p.x(), p.y(), p.z()));
      if(it == vertices.end())
        return false;
      face.insert(v);
      image.insert(it->second);
    }
    faces.insert(face);
    images.push_back(image);
  }
  return vertices.size() == quads.number_of_vertices() &&
         std::all_of(images.begin(), images.end(),
                     [&](const auto& image) { return faces.count(image) == 1; });
}

void test_symmetry()
{
  for(const double center : {0., 1.25}) {
    const Mesh mesh = symmetric_torus(48, 24, center);
    const auto plane = QR::find_symmetry_plane(mesh);
    CHECK(plane.has_value() && plane->a() == 1 && plane->b() == 0 && plane->c() == 0 &&
          plane->d() == -center);
    for(const bool is_tilted : {false, true}) { // the cut runs through the middle of faces, then
      Mesh cut = mesh;
      if(is_tilted)
        for(const auto v : cut.vertices())
          cut.point(v) = cut.point(v) + Kernel::Vector_3(0.05 + 0.1 * cut.point(v).y(), 0, 0);
      for(const std::size_t number : {60, 1000}) {
        const std::string context = std::to_string(number) + (is_tilted ? " tilted" : "") +
                                    " around " + std::to_string(center);
        Mesh quads;
        const auto report = QR::quad_remesh(
          cut, quads, parameters::symmetry_plane(*plane).target_number_of_quads(number));
        CHECK_IN(context + ": " + report.message, bool(report));
        CHECK_IN(context, CGAL::is_valid_polygon_mesh(quads) && CGAL::is_closed(quads) &&
                            !has_double_edges(quads));
        CHECK_IN(context, is_symmetric(quads, center));
        CHECK_EQUAL(euler_characteristic(quads), 0);
        CHECK_EQUAL(report.number_of_quads, std::size_t(quads.number_of_faces()));
        CHECK_IN(context + ": " + std::to_string(report.number_of_quads),
                 double(report.number_of_quads) > 0.8 * double(number) &&
                   double(report.number_of_quads) < 1.4 * double(number));
        CHECK_IN(context, report.number_of_inverted_quads == 0);
      }
    }
    symmetry_plane_checks::test_perturbed(mesh, *plane);
    Mesh quads;
    CHECK(QR::quad_remesh(mesh, quads, parameters::symmetry_plane(Kernel::Plane_3(1, 0, 0, -9)))
            .status == QR::Outcome::INVALID_ARGUMENT);
    CHECK(QR::quad_remesh(mesh, quads, parameters::symmetry_plane(Kernel::Plane_3(0, 0, 0, 1)))
            .status == QR::Outcome::INVALID_ARGUMENT);
    CHECK(quads.is_empty());
  }
}

// Each vertex lies where its location says, up to a distance. Returns the quads.
template <typename NamedParameters>
Mesh check_locations(const Mesh& mesh, const NamedParameters& np, const double largest)
{
  Mesh quads;
  const auto of_vertex = quads.add_property_map<Vertex, Location>("v:location").first;
  const auto of_face = quads.add_property_map<Mesh::Face_index, Location>("f:location").first;
  const auto report = QR::quad_remesh(
    mesh, quads, np, parameters::vertex_location_map(of_vertex).face_location_map(of_face));
  CHECK_IN(report.message, bool(report));
  const auto distance = [&](const Point_3& p, const Location& location) {
    const auto h = mesh.halfedge(location.first);
    Kernel::Vector_3 sum(0, 0, 0);
    double weight = 0;
    std::size_t i = 0;
    for(const auto v : {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))}) {
      CHECK(location.second[i] >= 0);
      weight += location.second[i];
      sum = sum + location.second[i++] * (mesh.point(v) - CGAL::ORIGIN);
    }
    CHECK(std::abs(weight - 1) < 1e-14);
    return std::sqrt((p - (CGAL::ORIGIN + sum)).squared_length());
  };
  for(const auto v : quads.vertices())
    CHECK(distance(quads.point(v), of_vertex[v]) < largest);
  for(const auto f : quads.faces()) {
    Kernel::Vector_3 sum(0, 0, 0);
    for(const auto v : quads.vertices_around_face(quads.halfedge(f)))
      sum = sum + (quads.point(v) - CGAL::ORIGIN) / 4;
    CHECK(distance(CGAL::ORIGIN + sum, of_face[f]) < 0.1);
  }
  return quads;
}

// The half that is a mirror image lies near by.
void test_locations()
{
  const Mesh mesh = symmetric_torus(48, 24, 0);
  const auto np = parameters::target_number_of_quads(1000);
  check_locations(mesh, np, 1e-12);
  check_locations(mesh, np.symmetry_plane(Kernel::Plane_3(1, 0, 0, 0)), 0.05);
  // squares of such lengths overflow, or vanish
  Mesh scaled = mesh, quads, scaled_quads;
  const auto of_vertex = quads.add_property_map<Vertex, Location>("v:location").first;
  CHECK(bool(QR::quad_remesh(mesh, quads, np, parameters::vertex_location_map(of_vertex))));
  for(const int exponent : {600, -600}) {
    for(const auto v : mesh.vertices()) {
      const Point_3& p = mesh.point(v);
      scaled.point(v) = Point_3(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                                std::ldexp(p.z(), exponent));
    }
    scaled_quads.clear();
    const auto of_scaled =
      scaled_quads.add_property_map<Vertex, Location>("v:location").first;
    CHECK(bool(QR::quad_remesh(scaled, scaled_quads, np,
                               parameters::vertex_location_map(of_scaled))));
    CHECK_EQUAL(scaled_quads.number_of_vertices(), quads.number_of_vertices());
    for(const auto v : quads.vertices())
      CHECK(of_scaled[v] == of_vertex[v]);
  }
}

template <typename NamedParameters>
internal::Surface_to_remesh surface_to_remesh(const Mesh& mesh, const NamedParameters& np)
{
  return {internal::read_surface(mesh, internal::strip(np)), std::nullopt};
}

internal::Surface_to_remesh surface_to_remesh(const Mesh& mesh)
{
  return surface_to_remesh(mesh, parameters::default_values());
}

// --- long triangles ------------------------------------------------------------------------------

// Polygons at two heights, and the sides between them, as programs for construction write them. The
// edges of the polygons are features, and upright ones where they are sharp.
struct Prism
{
  using Cap = std::vector<std::array<int, 3> >;

  // \param cap triangles of the polygon; the lower one is left out if the prism is open
  Prism(const std::vector<Kernel::Point_2>& polygon, const Cap& cap, const double low,
        const double high, const bool is_sharp, const bool is_open = false)
  {
    const int n = int(polygon.size());
    for(const double z : {low, high})
      for(const auto& p : polygon)
        mesh.add_vertex(Point_3(p.x(), p.y(), z));
    const auto at = [&](const int ring, const int i) { return Vertex(ring * n + i % n); };
    const auto mark = [&](const Vertex v, const Vertex w)
      { is_feature[mesh.edge(mesh.halfedge(v, w))] = true; };
    for(int i = 0; i < n; ++i) {
      mesh.add_face(at(0, i), at(0, i + 1), at(1, i + 1));
      mesh.add_face(at(0, i), at(1, i + 1), at(1, i));
      for(const int ring : {0, 1})
        mark(at(ring, i), at(ring, i + 1));
      if(is_sharp)
        mark(at(0, i), at(1, i));
    }
    for(const auto& [i, j, k] : cap) {
      mesh.add_face(at(1, i), at(1, j), at(1, k));
      if(!is_open)
        mesh.add_face(at(0, i), at(0, k), at(0, j));
    }
  }

  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature =
    mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
};

// \param radius of the corner with a number
template <typename Radius>
std::vector<Kernel::Point_2> polygon_around_origin(const int n, const double first,
                                                   const Radius& radius)
{
  const double pi = std::acos(-1.);
  std::vector<Kernel::Point_2> result;
  for(int i = 0; i < n; ++i)
    result.emplace_back(radius(i) * std::cos(2 * pi * (i + first) / n),
                        radius(i) * std::sin(2 * pi * (i + first) / n));
  return result;
}

Prism::Cap fan(const int n)
{
  Prism::Cap result;
  for(int i = 1; i + 1 < n; ++i)
    result.push_back({0, i, i + 1});
  return result;
}

// A flat cylinder, of which one cap, or none, is left out.
struct Coin : Prism
{
  explicit Coin(const bool is_open)
    : Prism(polygon_around_origin(n, 0.5, [](int) { return 2.; }), fan(n), -0.125, 0.125, false,
            is_open)
  { }

  static constexpr int n = 100;
};

double length_of(const Mesh& mesh, const Mesh::Edge_index e)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)),
                                          mesh.point(mesh.vertex(e, 1))));
}

Kernel::Triangle_3 triangle(const Mesh& mesh, const Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
          mesh.point(mesh.target(mesh.next(h)))};
}

double area_of(const Mesh& mesh)
{
  double sum = 0;
  for(const auto f : mesh.faces())
    sum += std::sqrt(triangle(mesh, f).squared_area());
  return sum;
}

// In each part, below a height or above it, the area is the same as before.
void check_refined_coin(const Coin& coin, const std::string& context)
{
  const auto sizes = boost::make_function_property_map<Vertex>(
    [&](const Vertex v) { return 2 + coin.mesh.point(v).x() / 4; });
  internal::Surface_to_remesh surface = surface_to_remesh(
    coin.mesh, parameters::edge_is_constrained_map(coin.is_feature).vertex_sizing_map(sizes));
  const double scale = surface.unscaled(1);
  double largest_size = 0; // only ratios are kept
  for(const auto v : coin.mesh.vertices())
    largest_size = (std::max)(largest_size, get(sizes, v));
  const double unit = std::ldexp(1., std::ilogb(largest_size));
  CHECK_IN(context, surface.refine(false));
  const auto& refined = surface.mesh();
  CHECK_IN(context, CGAL::is_valid_polygon_mesh(refined) && CGAL::is_triangle_mesh(refined) &&
                      !has_double_edges(refined));
  CHECK_EQUAL(euler_characteristic(refined), euler_characteristic(coin.mesh));
  CHECK_IN(context, refined.number_of_faces() <= coin.mesh.number_of_faces() + 10000);
  const auto point = [&](const auto v)
    { return CGAL::ORIGIN + scale * (refined.point(v) - CGAL::ORIGIN); };
  std::set<Point_3> points;
  for(const auto v : refined.vertices())
    points.insert(point(v));
  for(const Point_3& p : coin.mesh.points())
    CHECK_IN(context, points.count(p) == 1);
  double features = 0, border = 0, size_error = 0, distance = 0;
  for(const auto e : refined.edges()) {
    features += surface.is_feature()[e] ? scale * length_of(refined, e) : 0;
    border += refined.is_border(e) ? scale * length_of(refined, e) : 0;
  }
  double features_before = 0, border_before = 0;
  for(const auto e : coin.mesh.edges()) {
    features_before += coin.is_feature[e] ? length_of(coin.mesh, e) : 0;
    border_before += coin.mesh.is_border(e) ? length_of(coin.mesh, e) : 0;
  }
  CHECK_IN(context, std::abs(features - features_before) < 1e-11 &&
                      std::abs(border - border_before) < 1e-11);
  CHECK_IN(context, std::abs(scale * scale * area_of(refined) - area_of(coin.mesh)) < 1e-11);
  for(const auto v : refined.vertices()) {
    const Point_3 p = point(v);
    size_error = (std::max)(size_error, std::abs(unit * surface.sizes()[v] - (2 + p.x() / 4)));
    double nearest = 1;
    for(const auto f : coin.mesh.faces())
      nearest = (std::min)(nearest, CGAL::squared_distance(p, triangle(coin.mesh, f)));
    distance = (std::max)(distance, nearest);
  }
  CHECK_IN(context, size_error < 1e-12 && distance < 1e-24);
  std::size_t flat = 0; // no side leads from cap to cap, or through the coin
  for(const auto f : refined.faces()) {
    const Point_3 middle = CGAL::centroid(triangle(refined, f));
    double nearest = 1;
    for(const auto g : coin.mesh.faces())
      nearest = (std::min)(nearest,
                           CGAL::squared_distance(CGAL::ORIGIN + scale * (middle - CGAL::ORIGIN),
                                                  triangle(coin.mesh, g)));
    flat += nearest < 1e-24 ? 1 : 0;
  }
  CHECK_EQUAL(flat, std::size_t(refined.number_of_faces()));
  const auto has_two_walls = [&](const auto f) {
    int result = 0;
    for(const auto h : refined.halfedges_around_face(refined.halfedge(f)))
      result += refined.is_border(refined.edge(h)) || surface.is_feature()[refined.edge(h)] ? 1 : 0;
    return result > 1;
  };
  for(const auto f : refined.faces()) // ends of fans at most
    CHECK_IN(context, !has_two_walls(f) ||
                        std::size_t(f) < std::size_t(coin.mesh.number_of_faces()));
  std::size_t number_of_long = 0;
  for(const auto f : refined.faces()) {
    double longest = 0, size = 0;
    for(const auto h : refined.halfedges_around_face(refined.halfedge(f))) {
      longest = (std::max)(longest, length_of(refined, refined.edge(h)));
      size += surface.sizes()[refined.target(h)] / 3;
    }
    const double height = 2 * std::sqrt(triangle(refined, f).squared_area()) / longest;
    // about 12.6 squares of the size 2 each are half of the surface, whose scale is 2
    number_of_long += (scale * longest > 0.1 * size && longest > 4 * height) ||
                      scale * longest > 0.4 * size ? 1 : 0;
  }
  CHECK_EQUAL(number_of_long, 0u);
}

// A square of narrow strips, flat or folded, with a direction on its left part, and a feature in
// the middle: each keeps its area, or length.
void check_refined_strips(const double height)
{
  Mesh strips;
  for(int i = 0; i < 21; ++i)
    for(const double y : {0., 1.})
      strips.add_vertex(Point_3(0.05 * i, y, i % 2 * height));
  for(unsigned int i = 0; i < 20; ++i) {
    strips.add_face(Vertex(2 * i), Vertex(2 * i + 2), Vertex(2 * i + 3));
    strips.add_face(Vertex(2 * i), Vertex(2 * i + 3), Vertex(2 * i + 1));
  }
  const auto is_feature =
    strips.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  is_feature[strips.edge(strips.halfedge(Vertex(20), Vertex(21)))] = true;
  const auto direction = boost::make_function_property_map<Mesh::Face_index>(
    [](const Mesh::Face_index f) { return Kernel::Vector_3(f < Mesh::Face_index(18), 0, 0); });
  internal::Surface_to_remesh surface = surface_to_remesh(
    strips, parameters::edge_is_constrained_map(is_feature).face_direction_map(direction));
  const double scale = surface.unscaled(1);
  CHECK(surface.refine(true));
  const auto& refined = surface.mesh();
  CHECK(refined.number_of_faces() > strips.number_of_faces());
  double area = 0, length = 0;
  for(const auto f : refined.faces())
    if(surface.directions()[f].x() == 1)
      area += scale * scale * std::sqrt(triangle(refined, f).squared_area());
  for(const auto e : refined.edges())
    length += surface.is_feature()[e] ? scale * length_of(refined, e) : 0;
  CHECK(std::abs(area - 9 * std::hypot(0.05, height)) < 1e-13);
  CHECK(std::abs(scale * scale * area_of(refined) - area_of(strips)) < 1e-13);
  CHECK(std::abs(length - 1) < 1e-13);
}

// A surface without long triangles is the same.
void test_refinement()
{
  for(const bool is_open : {false, true})
    check_refined_coin(Coin(is_open), is_open ? "open coin" : "coin");
  check_refined_strips(0);
  check_refined_strips(0.001);
  const Mesh torus = symmetric_torus(48, 24, 0);
  const auto copy = [&](const bool may_refine) {
    internal::Surface_to_remesh surface = surface_to_remesh(torus);
    CHECK(!may_refine || !surface.refine(true));
    std::vector<Point_3> points;
    for(const auto f : surface.mesh().faces())
      for(const auto v : CGAL::vertices_around_face(surface.mesh().halfedge(f), surface.mesh()))
        points.push_back(surface.mesh().point(v));
    return points;
  };
  CHECK(copy(true) == copy(false));
  // where a triangle is divided into nine, sizes that are all the same stay so
  Mesh one_triangle;
  for(const auto& p : {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0)})
    one_triangle.add_vertex(p);
  one_triangle.add_face(Vertex(0), Vertex(1), Vertex(2));
  const internal::Surface_to_remesh divided = surface_to_remesh(one_triangle);
  CHECK_EQUAL(divided.mesh().number_of_faces(), 9u);
  CHECK(!divided.has_sizes_that_vary());
  // and where there is a half only, of which it is the first one, its parts are of the second one
  Mesh two_triangles;
  for(const auto& p : {Point_3(-1, 0, 0), Point_3(0, 0, 0), Point_3(0, 1, 0), Point_3(1, 0, 0)})
    two_triangles.add_vertex(p);
  two_triangles.add_face(Vertex(0), Vertex(1), Vertex(2));
  two_triangles.add_face(Vertex(1), Vertex(3), Vertex(2));
  const internal::Surface_to_remesh half(
    internal::read_surface(two_triangles, internal::strip(parameters::default_values())),
    internal::Mirror(1, 0, 0, 0));
  CHECK_EQUAL(half.mesh().number_of_faces(), 9u);
  for(const auto f : half.mesh().faces())
    CHECK_EQUAL(half.original(f), 1u);
}

// Few quads are shaped at more expense: without that, the mean here is 0.951, with it about 0.955.
void test_few_quads()
{
  double sum = 0;
  const auto files = test_data::package_files();
  for(const auto& file : files) {
    const Parametrized_model model(file.string());
    const auto report = QR::quad_remesh(model.mesh, *std::make_unique<Mesh>(),
                                        parameters::target_number_of_quads(50));
    CHECK_IN(file.filename().string(), report && report.number_of_inverted_quads == 0);
    sum += report.mean_scaled_jacobian;
  }
  std::cout << "about 50 quads: mean scaled Jacobian " << sum / double(files.size()) << std::endl;
  CHECK(sum > 0.953 * double(files.size()));
}

// Of the maps that are tried, the one whose quads are best is taken.
void test_choice_of_map()
{
  const Parametrized_model model((test_data::data_folder() / "genus2_border.obj").string());
  Mesh quads;
  const auto report = QR::quad_remesh(model.mesh, quads,
                                      parameters::target_number_of_quads(100));
  std::cout << "choice of a map: " << report.number_of_quads << " quads, mean scaled Jacobian "
            << report.mean_scaled_jacobian << ", " << report.message << std::endl;
  CHECK_IN(report.message, report && report.mean_scaled_jacobian > 0.955);
  // the vertices of the input, from the triangles of three corners of a quad, by either diagonal
  double largest = 0;
  for(const auto v : model.mesh.vertices()) {
    double least = std::numeric_limits<double>::infinity();
    for(const auto h : quads.halfedges())
      if(!quads.is_border(h))
        least = (std::min)(least, CGAL::squared_distance(
          model.mesh.point(v), Kernel::Triangle_3(quads.point(quads.source(h)),
                                                  quads.point(quads.target(h)),
                                                  quads.point(quads.target(quads.next(h))))));
    largest = (std::max)(largest, std::sqrt(least));
  }
  CHECK(report.largest_distance_of_input >= (1 - 1e-9) * largest);
  CHECK(report.largest_distance_of_input < 1.3 * largest);
}

// Sizes that grow by 3 along the x-axis, linearly: a place of a face has the size at its x.
void test_edge_lengths()
{
  const Parametrized_model model((test_data::data_folder() / "genus2_border.obj").string());
  Mesh mesh(model.mesh);
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  const auto size_at = [&](const double x)
    { return 1 + 2 * (x - box.xmin()) / (box.xmax() - box.xmin()); };
  const auto size = mesh.add_property_map<Mesh::Vertex_index, double>("v:size").first;
  for(const auto v : mesh.vertices())
    size[v] = size_at(mesh.point(v).x());
  Mesh quads;
  const auto report = QR::quad_remesh(
    mesh, quads, parameters::vertex_sizing_map(size).target_edge_length(0.05));
  CHECK_IN(report.message, report && report.median_size_deviation);
  if(!report.median_size_deviation)
    return;
  std::vector<double> lengths, deviations;
  for(const auto e : quads.edges()) {
    const auto &p = quads.point(quads.vertex(e, 0)), &q = quads.point(quads.vertex(e, 1));
    lengths.push_back(std::sqrt(CGAL::squared_distance(p, q)));
    const double ratio = lengths.back() / (0.05 * size_at((p.x() + q.x()) / 2));
    deviations.push_back((std::max)(ratio, 1 / ratio) - 1);
  }
  std::sort(lengths.begin(), lengths.end());
  std::sort(deviations.begin(), deviations.end());
  const std::size_t n = lengths.size();
  const double parts[] = {0.1, 0.5, 0.9};
  for(std::size_t i = 0; i < 3; ++i)
    CHECK(std::abs(report.edge_lengths[i] - lengths[std::size_t(parts[i] * double(n))]) <
          0.01 * lengths[n / 2]);
  std::cout << n << " edges, " << *report.median_size_deviation << " off their sizes, by the test "
            << deviations[n / 2] << std::endl;
  CHECK(std::abs(*report.median_size_deviation - deviations[n / 2]) < 0.02);
  // what is wanted is not known
  Mesh few;
  CHECK(!QR::quad_remesh(mesh, few, parameters::minimize_number_of_quads(true))
           .median_size_deviation);
}

// Two cubes, of which one side of each lies on one of the other: all quads become squares.
void test_touching_bodies()
{
  Mesh mesh, quads;
  const std::size_t triangles[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                        {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                                        {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  for(const double x : {0., 1.}) {
    std::vector<Vertex> v;
    for(int i = 0; i < 8; ++i)
      v.push_back(mesh.add_vertex(Point_3(x + (i & 1), (i >> 1) & 1, (i >> 2) & 1)));
    for(const auto& [a, b, c] : triangles)
      mesh.add_face(v[a], v[b], v[c]);
  }
  const auto normal = [](const Mesh& surface, const Mesh::Face_index f) {
    const auto h = surface.halfedge(f);
    const Point_3& p = surface.point(surface.source(h));
    return CGAL::cross_product(surface.point(surface.target(h)) - p,
                               surface.point(surface.target(surface.next(h))) - p);
  };
  const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  for(const auto e : mesh.edges())
    is_feature[e] = normal(mesh, mesh.face(mesh.halfedge(e, 0))) *
                      normal(mesh, mesh.face(mesh.halfedge(e, 1))) < 0.5;
  const auto face_of = quads.add_property_map<Mesh::Face_index, Location>("f:location").first;
  const auto report = QR::quad_remesh(
    mesh, quads, parameters::edge_is_constrained_map(is_feature).target_number_of_quads(500),
    parameters::face_location_map(face_of));
  std::cout << "two cubes: " << report.number_of_quads << " quads, least scaled Jacobian "
            << report.least_scaled_jacobian << ", mean " << report.mean_scaled_jacobian
            << std::endl;
  CHECK_IN(report.message, report && report.number_of_quads > 400);
  CHECK(report.least_scaled_jacobian > 0.999);
  CHECK(report.number_of_released_edges == 0 && report.number_of_displaced_vertices == 0);
  CHECK_EQUAL(report.number_of_thin_quads, std::size_t(0));
  // each on a face of its own cube, which it faces as
  for(const auto f : quads.faces())
    CHECK(normal(quads, f) * normal(mesh, face_of[f].first) > 0);
}

// Two sheets that face to opposite sides, divided differently, and less far apart than they deviate
// from their common shape: each has the quads that it has by itself.
void test_double_sheets()
{
  for(const double gap : {0., 1e-6, 1e-4}) {
    Mesh mesh, quads;
    const auto add_sheet = [&](const std::size_t n, const std::size_t m, const bool is_upper) {
      std::vector<Vertex> v;
      for(std::size_t i = 0; i <= n; ++i)
        for(std::size_t j = 0; j <= m; ++j) {
          const double x = double(i) / double(n), y = double(j) / double(m);
          v.push_back(mesh.add_vertex(Point_3(x, y, 0.03 * std::sin(4 * x) * std::cos(3 * y) +
                                                      (is_upper ? gap : 0))));
        }
      for(std::size_t i = 0; i < n; ++i)
        for(std::size_t j = 0; j < m; ++j) {
          const Vertex a = v[i * (m + 1) + j], b = v[i * (m + 1) + j + 1],
                       c = v[(i + 1) * (m + 1) + j], d = v[(i + 1) * (m + 1) + j + 1];
          is_upper ? mesh.add_face(a, c, d) : mesh.add_face(d, c, a);
          is_upper ? mesh.add_face(a, d, b) : mesh.add_face(b, d, a);
        }
    };
    add_sheet(20, 20, true);
    add_sheet(17, 23, false);
    const auto report = QR::quad_remesh(mesh, quads, parameters::target_number_of_quads(600));
    const std::string context = "sheets at " + std::to_string(gap) + ": " +
                                std::to_string(report.number_of_quads) + " quads, mean Jacobian " +
                                std::to_string(report.mean_scaled_jacobian) + report.message;
    std::cout << context << std::endl;
    CHECK_IN(context, report && report.number_of_inverted_quads == 0 &&
                        report.number_of_irregular_vertices == 0 &&
                        report.number_of_displaced_vertices == 0 &&
                        report.mean_scaled_jacobian > 0.99);
  }
}

// Cones lie inside of the caps. Without vertices there, over 100 of them crowd on the rims.
void test_remeshing_of_long_triangles()
{
  const Coin coin(false);
  const auto np = parameters::target_number_of_quads(1000).edge_is_constrained_map(coin.is_feature);
  Mesh quads;
  const auto report = QR::quad_remesh(coin.mesh, quads, np);
  std::cout << "coin: " << report.number_of_quads << " quads, "
            << report.number_of_irregular_vertices << " irregular vertices, mean Jacobian "
            << report.mean_scaled_jacobian << std::endl;
  CHECK_IN(report.message, bool(report));
  CHECK_EQUAL(report.number_of_irregular_vertices, 8u);
  CHECK_EQUAL(report.number_of_released_edges, 0u);
  CHECK(report.mean_scaled_jacobian > 0.9 && report.number_of_inverted_quads == 0);
  check_locations(coin.mesh, np, 1e-12);
  const Mesh mirrored =
    check_locations(coin.mesh, np.symmetry_plane(Kernel::Plane_3(1, 0, 0, 0)), 0.1);
  CHECK(is_symmetric(mirrored, 0));
}

// A prism of a star of five tips of 36 degrees, each in one triangle. If its whole cross is turned,
// also the corners between tips are rounded otherwise: the least scaled Jacobian is 0.32 and 0.53,
// the mean 0.94 and 0.91.
void test_tips()
{
  constexpr int n = 10; // corners of the star
  const double pi = std::acos(-1.);
  Prism::Cap cap{{9, 0, 1}};
  for(int i = 2; i < n; i += 2)
    cap.push_back({i - 1, i, i + 1});
  for(int i = 3; i + 2 < n; i += 2)
    cap.push_back({1, i, i + 2});
  const Prism star(polygon_around_origin(n, 0, [](const int i) { return i % 2 == 0 ? 1. : 0.382; }),
                   cap, 0, 0.3, true);
  CHECK(CGAL::is_closed(star.mesh));
  for(const std::size_t number : {500, 2000}) {
    Mesh quads;
    const auto report = QR::quad_remesh(
      star.mesh, quads,
      parameters::target_number_of_quads(number).edge_is_constrained_map(star.is_feature));
    std::cout << "star: " << report.number_of_quads << " quads, least scaled Jacobian "
              << report.least_scaled_jacobian << ", mean " << report.mean_scaled_jacobian
              << std::endl;
    CHECK_IN(report.message, report && report.number_of_released_edges == 0);
    CHECK(report.number_of_displaced_vertices == 0 && report.number_of_inverted_quads == 0);
    CHECK(report.least_scaled_jacobian > 0.95 * std::sin(pi / 5)); // the tip's is the sine
    CHECK(report.mean_scaled_jacobian > 0.96);
  }
}

// Prisms of few triangles. Where these were not divided, 10 to 12 features of those with 5 and 7
// sides were not kept, and 3 and 4 of those with 6 and 11.
void test_prisms()
{
  for(const int n : {5, 6, 7, 11}) {
    const Prism prism(polygon_around_origin(n, 0, [](int) { return 1.; }), fan(n), 0, 1, true);
    const auto report = QR::quad_remesh(
      prism.mesh, *std::make_unique<Mesh>(),
      parameters::target_number_of_quads(500).edge_is_constrained_map(prism.is_feature));
    const std::string context = "prism of " + std::to_string(n) + " sides";
    std::cout << context << ": least scaled Jacobian " << report.least_scaled_jacobian << ", mean "
              << report.mean_scaled_jacobian << std::endl;
    CHECK_IN(context, report && report.number_of_released_edges == 0);
    CHECK_IN(context, report.least_scaled_jacobian > 0.7 && report.mean_scaled_jacobian > 0.979);
    CHECK_IN(context, report.largest_distance < 1e-9);
  }
}

// About 50 quads between features have a good shape, and no vertex leaves the surface or a feature.
void test_few_quads_between_features()
{
  const Coin coin(false);
  const auto report = QR::quad_remesh(
    coin.mesh, *std::make_unique<Mesh>(),
    parameters::target_number_of_quads(50).edge_is_constrained_map(coin.is_feature));
  std::cout << "coin of few quads: " << report.number_of_quads << ", mean scaled Jacobian "
            << report.mean_scaled_jacobian << ", " << report.message << std::endl;
  CHECK_IN(report.message, report && report.mean_scaled_jacobian > 0.9);
  CHECK(report.number_of_displaced_vertices == 0 && report.number_of_released_edges == 0);
  CHECK(report.number_of_quads <= 90);
}

// A flat spiral tube, of circles that lie in the plane they are moved in: it meets itself, and some
// of its folds are features, which end anywhere. Many quads at these are inverted. They are not
// mended one by one, which would leave a mean scaled Jacobian of .45.
void test_hopeless_features()
{
  constexpr int n = 8, steps = 12; // vertices of a circle, and circles of a turn
  constexpr double radius = 0.1, pitch = 0.2;
  Mesh mesh;
  const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  for(int i = 0; i <= steps; ++i) {
    const double t = 2 * CGAL_PI * i / steps;
    for(int k = 0; k < n; ++k) {
      const double a = 2 * CGAL_PI * k / n, x = 1 + radius * std::cos(a), y = radius * std::sin(a);
      mesh.add_vertex(Point_3(x * std::cos(t) - y * std::sin(t),
                              x * std::sin(t) + y * std::cos(t), pitch * i / steps));
    }
  }
  for(int i = 0; i < steps; ++i)
    for(int k = 0; k < n; ++k) {
      const Vertex a(n * i + k), b(n * i + (k + 1) % n), c(n * (i + 1) + k),
                   d(n * (i + 1) + (k + 1) % n);
      mesh.add_face(a, b, d);
      mesh.add_face(a, d, c);
    }
  namespace PMP = CGAL::Polygon_mesh_processing;
  PMP::detect_sharp_edges(mesh, 40, is_feature);
  std::size_t number_of_inverted_quads = 0; // of the first attempt
  const auto visitor = [&](const std::string& text) {
    if(number_of_inverted_quads == 0 && text.find("inverted quads; again") != std::string::npos)
      number_of_inverted_quads = std::stoul(text);
  };
  QR::Remeshing_report report; // rounding errors choose which number gives a good shape
  for(const std::size_t wanted : {70, 80, 90, 120, 60}) {
    report = QR::quad_remesh(mesh, *std::make_unique<Mesh>(),
                             parameters::edge_is_constrained_map(is_feature)
                               .target_number_of_quads(wanted).visitor(visitor));
    std::cout << "spiral: " << report.number_of_quads << " quads, mean scaled Jacobian "
              << report.mean_scaled_jacobian << ", " << number_of_inverted_quads
              << " were inverted at features" << std::endl;
    if(report && report.mean_scaled_jacobian > 0.7)
      break;
  }
  CHECK_IN(report.message, report && report.mean_scaled_jacobian > 0.7);
  CHECK(number_of_inverted_quads >= 10 && report.number_of_inverted_quads == 0);
}

// At the tips of a long double pyramid, four features meet in narrow sectors. Each of its four
// sides between features is a rectangle of quads, and all features are kept. For fewer quads, there
// are several maps, the best of which does not have the fewest.
void test_double_pyramid()
{
  Mesh mesh;
  const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  for(const auto& [x, y] : {std::make_pair(1, 0), std::make_pair(0, 1), std::make_pair(-1, 0),
                            std::make_pair(0, -1)})
    mesh.add_vertex(Point_3(x, y, 0));
  const std::array<Vertex, 2> tips{mesh.add_vertex(Point_3(0, 0, 4)),
                                   mesh.add_vertex(Point_3(0, 0, -4))};
  for(Mesh::size_type i = 0; i < 4; ++i) {
    const Vertex v(i), w((i + 1) % 4);
    mesh.add_face(v, w, tips[0]);
    mesh.add_face(w, v, tips[1]);
    for(const Vertex tip : tips)
      is_feature[mesh.edge(mesh.halfedge(v, tip))] = true;
  }
  const auto np = parameters::edge_is_constrained_map(is_feature);
  const auto report =
    QR::quad_remesh(mesh, *std::make_unique<Mesh>(), np.target_number_of_quads(180));
  std::string messages;
  for(const std::size_t few : {12, 30}) // rounding errors choose which one has a larger number
    messages += QR::quad_remesh(mesh, *std::make_unique<Mesh>(),
                                np.target_number_of_quads(few)).message;
  CHECK_IN(messages, messages.find("quads were found, too, but in a worse shape") !=
                       std::string::npos);
  std::cout << "double pyramid: " << report.number_of_quads << " quads, mean scaled Jacobian "
            << report.mean_scaled_jacobian << std::endl;
  CHECK_IN(report.message, report && report.mean_scaled_jacobian > 0.94);
  CHECK_EQUAL(report.number_of_irregular_vertices, 8u);
  CHECK(report.number_of_released_edges == 0 && report.number_of_displaced_vertices == 0 &&
        report.number_of_thin_quads == 0);
}

// Quads are thin at some tips of a flat star, for a number of quads that rounding errors choose: it
// is tried without the features next to these. The better result stays, in which most are kept.
void test_attempt_without_features()
{
  constexpr int n = 24; // corners
  Mesh mesh;
  const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  double length = 0;
  const auto make_star = [&](const double turn) { // by so many corners
    mesh.clear_without_removing_property_maps();
    length = 0;
    const auto polygon =
      polygon_around_origin(n, turn, [](const int i) { return i % 2 == 0 ? 1 : 0.5; });
    for(const double z : {0., 0.2})
      for(const auto& p : polygon)
        mesh.add_vertex(Point_3(p.x(), p.y(), z));
    const Vertex below = mesh.add_vertex(Point_3(0, 0, 0)),
                 above = mesh.add_vertex(Point_3(0, 0, 0.2));
    for(int i = 0; i < n; ++i) {
      const Vertex a(i), b((i + 1) % n), c(n + i), d(n + (i + 1) % n);
      mesh.add_face(a, b, d);
      mesh.add_face(a, d, c);
      mesh.add_face(b, a, below);
      mesh.add_face(c, d, above);
      for(const auto& [v, w] : {std::make_pair(a, b), std::make_pair(c, d), std::make_pair(a, c)}) {
        is_feature[mesh.edge(mesh.halfedge(v, w))] = true;
        length += std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w)));
      }
    }
  };
  std::size_t number_left_out = 0; // of features, in further attempts
  const auto visitor = [&](const std::string& text) {
    const std::string words = "; again without ";
    if(const std::size_t at = text.find(words);
       at != std::string::npos && text.find("thin quad") < at)
      number_left_out += std::stoul(text.substr(at + words.size()));
  };
  Mesh quads;
  const auto is_kept = quads.add_property_map<Mesh::Edge_index, bool>("e:kept", false).first;
  QR::Remeshing_report report;
  for(const double turn : {1.91, 1.37, 2.43, 0.77}) { // it is not aligned to the axes
    if(number_left_out > 0)
      break;
    make_star(turn);
    for(std::size_t wanted = 340; number_left_out == 0 && wanted <= 400; wanted += 5) {
      quads.clear_without_removing_property_maps();
      report = QR::quad_remesh(
        mesh, quads,
        parameters::edge_is_constrained_map(is_feature).target_number_of_quads(wanted)
          .visitor(visitor),
        parameters::edge_is_constrained_map(is_kept));
    }
  }
  std::cout << "flat star: " << report.number_of_quads << " quads, mean scaled Jacobian "
            << report.mean_scaled_jacobian << ", again without " << number_left_out
            << " edges, " << report.number_of_released_edges << " edges released" << std::endl;
  CHECK_IN(report.message, report && report.mean_scaled_jacobian > 0.9);
  CHECK_IN(std::to_string(number_left_out), number_left_out > 0 && number_left_out < 3 * n / 2);
  CHECK(report.number_of_thin_quads <= 2 && report.number_of_displaced_vertices == 0);
  CHECK_EQUAL(report.number_of_folded_quads, std::size_t(0));
  CHECK(report.length_of_released_edges < length / 8);
  double kept = 0;
  for(const auto e : quads.edges()) {
    const Point_3 &p = quads.point(quads.vertex(e, 0)), &q = quads.point(quads.vertex(e, 1));
    kept += is_kept[e] ? std::sqrt(CGAL::squared_distance(p, q)) : 0;
  }
  CHECK(kept > 0.8 * (length - report.length_of_released_edges)); // not where only a part is kept
}

// The cells of a grid whose middles are inside of a shape, as two triangles each.
template <typename Predicate>
Mesh cells_inside(const int n, const Predicate& is_inside)
{
  Mesh mesh;
  std::map<std::pair<int, int>, Vertex> vertices;
  const auto vertex = [&](const int i, const int j) {
    const auto [at, is_new] = vertices.insert({{i, j}, Vertex()});
    if(is_new)
      at->second = mesh.add_vertex(Point_3(double(i) / n, double(j) / n, 0));
    return at->second;
  };
  for(int i = -n; i < n; ++i)
    for(int j = -n; j < n; ++j)
      if(is_inside((i + 0.5) / n, (j + 0.5) / n)) {
        const Vertex a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                     d = vertex(i, j + 1);
        mesh.add_face(a, b, c);
        mesh.add_face(a, c, d);
      }
  return mesh;
}

// A border in the steps of a grid has corners at each of them. What is smaller than quads is left
// out; the vertices of the quads lie on the steps all the same.
void test_border_in_steps()
{
  const auto check = [&](const std::string& name, const Mesh& mesh, const std::size_t wanted) {
    CHECK(CGAL::is_valid_polygon_mesh(mesh));
    const auto np = parameters::target_number_of_quads(wanted);
    Mesh quads, quads_with_all;
    const auto report = QR::quad_remesh(mesh, quads, np);
    const auto with_all = QR::quad_remesh(mesh, quads_with_all, np.border_tolerance(0.));
    std::cout << name << ": " << report.number_of_corners_left_out << " corners left out, "
              << report.number_of_quads << " quads, mean scaled Jacobian "
              << report.mean_scaled_jacobian << "; with all " << with_all.number_of_quads
              << " quads, " << with_all.mean_scaled_jacobian << std::endl;
    CHECK_IN(report.message, report && report.number_of_inverted_quads == 0);
    CHECK(report.number_of_corners_left_out > 20);
    CHECK(with_all && with_all.number_of_corners_left_out == 0);
    CHECK(report.mean_scaled_jacobian > 0.9);
    CHECK(report.number_of_quads < wanted + wanted / 5);
    std::vector<Kernel::Segment_3> border;
    for(const auto e : mesh.edges())
      if(mesh.is_border(e))
        border.emplace_back(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
    for(const auto v : quads.vertices())
      if(quads.is_border(v))
        CHECK(std::any_of(border.begin(), border.end(), [&](const Kernel::Segment_3& s)
                          { return CGAL::squared_distance(quads.point(v), s) < 1e-20; }));
    for(const Mesh* m : {&quads, &quads_with_all})
      for(const Point_3& p : m->points())
        CHECK_EQUAL(p.z(), 0.);
  };
  check("disc in steps", cells_inside(40, [](const double x, const double y)
                                      { return std::hypot(x, y) < 0.9; }), 300);
  constexpr double angle = 0.7;
  check("turned square in steps", cells_inside(40, [&](const double x, const double y) {
    return std::abs(std::cos(angle) * x + std::sin(angle) * y) < 0.7 &&
           std::abs(std::cos(angle) * y - std::sin(angle) * x) < 0.7;
  }), 300);
  for(const unsigned int seed : {1u, 2u}) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> phase(0, 6.28), height(0.02, 0.1);
    std::vector<std::array<double, 2> > waves;
    for(int k = 0; k < 5; ++k) {
      const double p = phase(engine), h = height(engine);
      waves.push_back({p, h});
    }
    check("coast in steps, seed " + std::to_string(seed),
          cells_inside(40, [&](const double x, const double y) {
            double radius = 0.6;
            for(std::size_t k = 0; k < waves.size(); ++k)
              radius += waves[k][1] * std::cos(double(k + 2) * std::atan2(y, x) + waves[k][0]);
            return std::hypot(x, y) < radius;
          }), 300);
  }

  // Slots that are narrow but deep, and steps that are larger than quads, stay.
  for(const auto& size : {std::make_pair(1, 30), std::make_pair(6, 16)}) { // width, depth
    const Mesh comb = cells_inside(20, [&](const double x, const double y)
                                   { return int(std::floor(20 * x + 23)) % 8 >= size.first ||
                                            20 * y + 20 > size.second; });
    const auto report = QR::quad_remesh(comb, *std::make_unique<Mesh>(),
                                        parameters::target_edge_length(0.1));
    CHECK_IN(report.message, report && report.number_of_corners_left_out == 0);
  }

  // What has no steps stays: the same quads.
  const Mesh square = cells_inside(10, [](double, double) { return true; });
  const auto np = parameters::target_number_of_quads(100);
  Mesh quads, others;
  const auto report = QR::quad_remesh(square, quads, np);
  CHECK_EQUAL(report.number_of_corners_left_out, 0u);
  QR::quad_remesh(square, others, np.border_tolerance(0.));
  CHECK(std::equal(quads.points().begin(), quads.points().end(), others.points().begin(),
                   others.points().end()));
  CHECK(QR::quad_remesh(square, others, np.border_tolerance(-1.)).status ==
        QR::Outcome::INVALID_ARGUMENT);
}

// --- improvement of quads ------------------------------------------------------------------------

void scale(Mesh& quads, const double factor)
{
  for(const auto v : quads.vertices())
    quads.point(v) = CGAL::ORIGIN + factor * (quads.point(v) - CGAL::ORIGIN);
}

// Calls run(surface, is_feature, lines, smoother) with quads as large as the copy of the surface.
// Borders are features.
template <typename Run>
void run_on_copy(const Mesh& mesh, Mesh& quads, const Run& run)
{
  const auto is_feature = quads.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  for(const auto e : quads.edges())
    is_feature[e] = quads.is_border(e);
  const internal::Surface_to_remesh surface = surface_to_remesh(mesh);
  scale(quads, 1 / surface.unscaled(1));
  const QR::internal::Surface_locator locator(surface.mesh());
  QR::internal::Quad_smoother smoother(quads, locator);
  run(surface, is_feature, QR::internal::Feature_lines(surface), smoother);
  scale(quads, surface.unscaled(1));
}

struct Shaped
{
  double distance_before, distance, least_jacobian;
};

// Until little is gained.
Shaped shape(const Mesh& mesh, Mesh& quads)
{
  Shaped result;
  run_on_copy(mesh, quads, [&](const auto& surface, const auto& is_feature, const auto& lines,
                               auto& smoother) {
    result.distance_before = surface.unscaled(smoother.measure_distance());
    QR::internal::Quad_shaper(quads, is_feature, surface.mesh(), lines, smoother).shape_all(50);
    result.distance = surface.unscaled(smoother.measure_distance());
    result.least_jacobian = smoother.shapes().least_scaled_jacobian;
  });
  return result;
}

// A grid of 4 x 4 points at integers, times a height, and the surface below.
struct Flat_quads
{
  explicit Flat_quads(const double height)
  {
    for(int j = 0; j < 4; ++j)
      for(int i = 0; i < 4; ++i)
        vertices.push_back(quads.add_vertex(Point_3(i, j * height, 0)));
    const std::array<Point_3, 4> corners{Point_3(0, 0, 0), Point_3(3, 0, 0),
                                         Point_3(3, 3 * height, 0), Point_3(0, 3 * height, 0)};
    std::array<Vertex, 4> v;
    for(std::size_t i = 0; i < 4; ++i)
      v[i] = square.add_vertex(corners[i]);
    square.add_face(v[0], v[1], v[2]);
    square.add_face(v[2], v[3], v[0]);
  }

  void add_quad(const std::size_t first)
  {
    quads.add_face(vertices[first], vertices[first + 1], vertices[first + 5], vertices[first + 4]);
  }

  // The four vertices inside, by 180 degrees.
  void turn()
  {
    for(const auto& [i, j] : {std::pair(5, 10), std::pair(6, 9)})
      std::swap(quads.point(vertices[std::size_t(i)]), quads.point(vertices[std::size_t(j)]));
  }

  // The least scaled Jacobian before, and after; and the number of vertices that were removed.
  std::tuple<double, double, std::size_t> improve()
  {
    std::tuple<double, double, std::size_t> result;
    run_on_copy(square, quads, [&](const auto& surface, const auto& is_feature, const auto& lines,
                                   auto& smoother) {
      std::get<0>(result) = smoother.shapes().least_scaled_jacobian;
      QR::internal::Quad_shaper(quads, is_feature, surface.mesh(), lines, smoother)
        .shape_thin_quads();
      QR::internal::Quad_collapser collapser(quads, is_feature, smoother, false);
      std::get<2>(result) = collapser.remove_vertices_of_two_edges();
      std::get<1>(result) = smoother.shapes().least_scaled_jacobian;
    });
    return result;
  }

  Mesh square, quads;
  std::vector<Vertex> vertices;
};

// Nine squares, whose four vertices inside are turned by 180 degrees: all but those at the corners
// are inverted, and smoothing without inversions could not turn them back.
void test_unfolding()
{
  Flat_quads flat(1);
  for(const std::size_t first : {0, 1, 2, 4, 5, 6, 8, 9, 10})
    flat.add_quad(first);
  const std::vector<Point_3> squares(flat.quads.points().begin(), flat.quads.points().end());
  flat.turn();
  run_on_copy(flat.square, flat.quads, [&](const auto&, const auto&, const auto&, auto& smoother) {
    const auto is_held = [&](const Vertex v) { return flat.quads.is_border(v); };
    CHECK(smoother.shapes().least_scaled_jacobian < 0);
    smoother.smooth(10, is_held);
    CHECK(smoother.shapes().least_scaled_jacobian < 0);
    smoother.unfold(is_held);
    const Point_3 p = flat.quads.point(flat.vertices[5]);
    smoother.unfold(is_held);
    CHECK_EQUAL(flat.quads.point(flat.vertices[5]), p);
  });
  for(std::size_t i = 0; i < 16; ++i)
    CHECK(CGAL::squared_distance(flat.quads.point(flat.vertices[i]), squares[i]) < 1e-6);
}

// Nine quads that are a torus, in disorder: without a border, averages would end in one point, in a
// better shape.
void test_unfolding_without_border()
{
  constexpr unsigned int seed = 1;
  std::cout << "quads that are a torus: seed " << seed << std::endl;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(0, 3);
  for(int i = 0; i < 50; ++i) {
    const Flat_quads flat(1);
    Mesh quads;
    for(int k = 0; k < 9; ++k) {
      const double x = coordinate(random), y = coordinate(random);
      quads.add_vertex(Point_3(x, y, 0));
    }
    for(int x = 0; x < 3; ++x)
      for(int y = 0; y < 3; ++y) {
        const auto v = [&](const int dx, const int dy)
          { return Vertex(Mesh::size_type(3 * ((x + dx) % 3) + (y + dy) % 3)); };
        quads.add_face(v(0, 0), v(1, 0), v(1, 1), v(0, 1));
      }
    run_on_copy(flat.square, quads, [&](const auto&, const auto&, const auto&, auto& smoother) {
      const double area = smoother.area();
      smoother.unfold([](const Vertex) { return false; });
      CHECK(smoother.area() >= area / 2);
    });
  }
}

// On a plane, vertices go where their quads are rectangles, those on the border along it.
void test_shape_of_flat_quads()
{
  Flat_quads flat(1);
  for(const std::size_t first : {0, 1, 2, 4, 5, 6, 8, 9, 10})
    flat.add_quad(first);
  const std::array<std::size_t, 4> inside{5, 6, 9, 10};
  for(const std::size_t i : inside)
    flat.quads.point(flat.vertices[i]) += Kernel::Vector_3(0.3, i == 6 ? -0.4 : 0.2, 0);
  flat.quads.point(flat.vertices[1]) += Kernel::Vector_3(0.4, 0, 0);
  flat.quads.point(flat.vertices[7]) += Kernel::Vector_3(0, -0.3, 0);
  const double least_jacobian = shape(flat.square, flat.quads).least_jacobian;
  std::cout << "on a square, the least scaled Jacobian " << least_jacobian << std::endl;
  CHECK(least_jacobian > 0.99);
  for(std::size_t i = 0; i < 16; ++i) {
    const Point_3& p = flat.quads.point(flat.vertices[i]);
    CHECK_EQUAL(p.z(), 0.);
    CHECK(i % 4 > 0 || p.x() == 0.);
    CHECK(i >= 4 || p.y() == 0.);
  }
}

// Where quads follow a field that is no border's, angles get better as vertices come near corners.
void test_long_sides()
{
  Mesh square = cells_inside(20, [](double, double) { return true; });
  const auto direction = square.add_property_map<Mesh::Face_index, Kernel::Vector_3>(
    "f:direction", Kernel::Vector_3(std::cos(0.5), std::sin(0.5), 0)).first;
  Mesh quads;
  const auto report = QR::quad_remesh(
    square, quads, parameters::face_direction_map(direction).target_number_of_quads(2000));
  std::cout << "with a field of another direction, the longest side over the shortest of a quad "
            << report.largest_aspect_ratio << std::endl;
  CHECK(report && report.number_of_inverted_quads == 0);
  CHECK(report.largest_aspect_ratio < 100);
}

// Of ten tori, with a few quads each, some are inverted that can't be mended.
void test_larger_number()
{
  constexpr int n = 24, m = 12;
  Mesh tori;
  for(int k = 0; k < 10; ++k) {
    std::vector<Vertex> v;
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < m; ++j) {
        const double a = 2 * CGAL_PI * i / n, b = 2 * CGAL_PI * j / m, r = 3 + std::cos(b);
        v.push_back(tori.add_vertex(Point_3(r * std::cos(a) + 10 * k, r * std::sin(a),
                                            std::sin(b))));
      }
    const auto at = [&](const int i, const int j) { return v[std::size_t(i % n * m + j % m)]; };
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < m; ++j) {
        tori.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        tori.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  Mesh quads;
  const auto report = QR::quad_remesh(tori, quads, parameters::target_number_of_quads(50));
  std::cout << "tori of few quads: " << report.number_of_quads << ", " << report.message
            << std::endl;
  CHECK(report && report.number_of_inverted_quads == 0);
  CHECK(report.message.find(" of them inverted") != std::string::npos);
}

// A sheet that is rolled to a cone, much thinner than a quad, with noise.
Mesh rolled_sheet(const unsigned int seed)
{
  constexpr int n = 50, m = 14, ring = 2 * (m + 1); // vertices along the roll, and around the sheet
  constexpr double thickness = 0.01, noise = 0.02;
  std::mt19937 random(seed);
  const auto random_number = [&]
    { return noise * (static_cast<double>(random()) / 2147483648. - 1); };
  Mesh sheet;
  for(int i = 0; i <= n; ++i)
    for(int k = 0; k < ring; ++k) {
      const double a = 6. * i / n, r = 0.02 + double((std::min)(k, ring - 1 - k)) / m;
      const Kernel::Vector_3 outward(std::cos(a), std::sin(a), 2),
                             normal(2 * std::cos(a), 2 * std::sin(a), -1);
      sheet.add_vertex(CGAL::ORIGIN + r * outward +
                       (k <= m ? thickness : -thickness) / 2 / std::sqrt(5.) * normal +
                       Kernel::Vector_3(random_number(), random_number(), random_number()));
    }
  const auto at = [&](const int i, const int k) { return Vertex(i * ring + k % ring); };
  for(int i = 0; i < n; ++i)
    for(int k = 0; k < ring; ++k) {
      sheet.add_face(at(i, k), at(i + 1, k), at(i + 1, k + 1));
      sheet.add_face(at(i, k), at(i + 1, k + 1), at(i, k + 1));
    }
  for(int j = 0; j < m; ++j)
    for(const bool is_end : {false, true}) {
      const int i = is_end ? n : 0;
      const Vertex a = at(i, j), b = at(i, j + 1),
                   c = at(i, ring - 2 - j), d = at(i, ring - 1 - j);
      for(const auto& [q, r] : {std::make_pair(b, c), std::make_pair(c, d)})
        is_end ? sheet.add_face(r, q, a) : sheet.add_face(a, q, r);
    }
  return sheet;
}

// A few quads are folded, for some of these sheets, until there are slightly more.
void test_slightly_more_quads()
{
  constexpr std::size_t wanted = 1100;
  bool is_mended = false;
  for(unsigned int seed = 1; seed <= 8 && !is_mended; ++seed) {
    const Mesh sheet = rolled_sheet(seed);
    CHECK(CGAL::is_closed(sheet) && CGAL::is_triangle_mesh(sheet));
    bool is_tried = false;
    const auto report = QR::quad_remesh(
      sheet, *std::make_unique<Mesh>(),
      parameters::target_number_of_quads(wanted).visitor([&](const std::string& text)
        { is_tried = is_tried || text.find("slightly more quads") != std::string::npos; }));
    const std::size_t bad = report.number_of_inverted_quads + report.number_of_folded_quads;
    std::cout << "rolled sheet of seed " << seed << ": " << report.number_of_quads << " quads, "
              << bad << " inverted or folded" << (is_tried ? " in the end" : "") << std::endl;
    CHECK(report && 10 * report.number_of_quads < 12 * wanted);
    is_mended = is_tried && bad == 0;
  }
  CHECK(is_mended);
}

// A cube whose eight corners are cut off by six quads: their vertices find them.
void test_distance_of_quads()
{
  const std::array<Point_3, 8> corners{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0),
                                       Point_3(0, 1, 0), Point_3(0, 0, 1), Point_3(1, 0, 1),
                                       Point_3(1, 1, 1), Point_3(0, 1, 1)};
  const std::vector<std::array<Mesh::size_type, 4> > sides{
    {{0, 3, 2, 1}}, {{4, 5, 6, 7}}, {{0, 1, 5, 4}}, {{1, 2, 6, 5}}, {{2, 3, 7, 6}}, {{3, 0, 4, 7}}};
  Mesh cube, quads;
  const Point_3 peak(1, 1, 1);
  for(const Point_3& p : corners) {
    cube.add_vertex(p);
    const Kernel::Vector_3 inwards = CGAL::midpoint(Point_3(0, 0, 0), peak) - p;
    const bool is_low = p.z() == 0; // on the bottom and the top, turned against each other
    quads.add_vertex(p + 0.4 * Kernel::Vector_3(is_low ? inwards.x() : 0,
                                                is_low ? 0 : inwards.y(), 0));
  }
  for(const auto& s : sides) {
    quads.add_face(Vertex(s[0]), Vertex(s[1]), Vertex(s[2]), Vertex(s[3]));
    cube.add_face(Vertex(s[0]), Vertex(s[1]), Vertex(s[2]));
    cube.add_face(Vertex(s[2]), Vertex(s[3]), Vertex(s[0]));
  }
  const Shaped result = shape(cube, quads);
  std::cout << "distance " << result.distance_before << ", then " << result.distance << std::endl;
  CHECK(result.distance_before > 0.05 && result.distance < 0.01);
  for(std::size_t i = 0; i < 8; ++i)
    CHECK(CGAL::squared_distance(quads.point(Vertex(Mesh::size_type(i))), corners[i]) < 0.01);
}

void test_improvement()
{
  for(const bool on_border : {false, true}) {
    const double height = on_border ? 0.1 : 1;
    Flat_quads flat(height);
    for(const std::size_t first : {0, 1, 2, 4, 5, 6, 8, 9, 10})
      flat.add_quad(first);
    if(on_border) { // toward one end
      flat.quads.point(flat.vertices[1]) = Point_3(2.9, 0, 0);
      flat.quads.point(flat.vertices[2]) = Point_3(2.95, 0, 0);
    } else { // across both opposite edges
      flat.quads.point(flat.vertices[5]) = Point_3(2.5, 2.5, 0);
    }
    const auto [before, after, removed] = flat.improve();
    std::cout << "least scaled Jacobian " << before << ", improved " << after << std::endl;
    CHECK(before < 0.2 && after >= 0.2 && removed == 0);
    for(std::size_t i = 0; i < 4; ++i) { // still on the border, and its corners where they were
      CHECK_EQUAL(flat.quads.point(flat.vertices[i]).y(), 0.);
      CHECK(i % 3 > 0 || flat.quads.point(flat.vertices[i]).x() == double(i));
    }
    for(const auto v : flat.quads.vertices())
      CHECK_EQUAL(flat.quads.point(v).z(), 0.);
  }

  Flat_quads flat(1); // the middle is two quads, around a vertex of two edges
  for(const std::size_t first : {0, 1, 2, 4, 6, 8, 9, 10})
    flat.add_quad(first);
  const Vertex v = flat.quads.add_vertex(Point_3(1.5, 1.5, 0));
  flat.quads.add_face(flat.vertices[5], flat.vertices[6], flat.vertices[10], v);
  flat.quads.add_face(flat.vertices[5], v, flat.vertices[10], flat.vertices[9]);
  const auto [before, after, removed] = flat.improve();
  CHECK(before < 0.2 && after > 0.2 && removed == 1);
  CHECK_EQUAL(flat.quads.number_of_faces(), 9u);
  CHECK(CGAL::is_valid_polygon_mesh(flat.quads) && CGAL::is_quad_mesh(flat.quads));
}

// A quad whose sides at a corner are a straight line, or turn by more, as features may hold them.
void test_division()
{
  using Feature_map = Mesh::Property_map<Mesh::Edge_index, bool>;
  for(const double y : {0., 0.4, 3.}) { // the last one is inverted, and can't be helped
    Mesh surface_mesh, quads;
    std::vector<Vertex> v;
    const std::vector<Point_3> corners{Point_3(-1, 0, 0), Point_3(0, y, 0), Point_3(1, 0, 0),
                                       Point_3(0, 2, 0)};
    for(const Point_3& p : {Point_3(-4, -4, 0), Point_3(4, -4, 0), Point_3(0, 9, 0)})
      surface_mesh.add_vertex(p);
    surface_mesh.add_face(Vertex(0), Vertex(1), Vertex(2));
    for(const Point_3& p : corners)
      v.push_back(quads.add_vertex(p));
    quads.add_face(v[0], v[1], v[2], v[3]);
    const Feature_map is_feature =
      quads.add_property_map<Mesh::Edge_index, bool>("e:feature", true).first;
    const internal::Surface_to_remesh surface = surface_to_remesh(surface_mesh);
    const QR::internal::Surface_locator locator(surface.mesh());
    QR::internal::Quad_smoother smoother(quads, locator);
    CHECK(smoother.shapes().least_scaled_jacobian <= 0);
    QR::internal::Quad_divider divider(quads, is_feature, smoother);
    const bool is_helped = y < 1;
    CHECK_EQUAL(divider.run(), is_helped ? 1u : 0u);
    CHECK_EQUAL(faces(quads).size(), is_helped ? 5u : 1u);
    CHECK(!is_helped || smoother.shapes().least_scaled_jacobian > 0.1);
    CHECK(CGAL::is_valid_polygon_mesh(quads) && CGAL::is_quad_mesh(quads));
    for(std::size_t i = 0; i < 4; ++i)
      CHECK_EQUAL(quads.point(v[i]), corners[i]);
    for(const auto e : quads.edges())
      CHECK_EQUAL(is_feature[e], quads.is_border(e));
    for(const auto w : quads.vertices())
      CHECK_EQUAL(quads.point(w).z(), 0.);
    CHECK_EQUAL(divider.run(), 0u);
  }
}

// What lies on the surface is looked for on the side of the quads, also below a thin plate.
void test_side_of_plate()
{
  constexpr double thickness = 0.01;
  Mesh plate;
  for(const double z : {0., thickness}) {
    std::vector<Vertex> v;
    for(const Point_3& p : {Point_3(0, 0, z), Point_3(1, 0, z), Point_3(1, 1, z), Point_3(0, 1, z)})
      v.push_back(plate.add_vertex(p));
    if(z == 0)
      std::swap(v[1], v[3]);
    plate.add_face(v[0], v[1], v[2]);
    plate.add_face(v[0], v[2], v[3]);
  }
  const QR::internal::Surface_locator locator(plate);
  for(const double distance : {0.5 * thickness, 2 * thickness}) {
    const auto face = locator.nearest_face({{0.4, 0.3, -0.1}}, {{0, 0, 1}}, distance);
    CHECK_EQUAL(locator.normal(face)[2] > 0, distance > thickness);
  }
}

// Quads that are inverted or upside down, and held by features, are mended, in either precision.
// \param has_to_relax whether that takes more than to mend each quad for itself
// \param stays_in_plane where neighbors of the quads have to move as well
void check_mending(Flat_quads& flat, const bool has_single_precision,
                   const bool has_to_relax = false, const bool stays_in_plane = false)
{
  using Feature_map = Mesh::Property_map<Mesh::Edge_index, bool>;
  const Feature_map is_feature =
    flat.quads.add_property_map<Mesh::Edge_index, bool>("e:feature", true).first;
  const internal::Surface_to_remesh surface = surface_to_remesh(flat.square);
  scale(flat.quads, 1 / surface.unscaled(1));
  const QR::internal::Surface_locator locator(surface.mesh());
  QR::internal::Quad_smoother smoother(flat.quads, locator);
  QR::internal::Upper_sides upper_sides(flat.quads, is_feature, surface, smoother);
  const auto faces_down = [&](const auto f) // other than the square
    { return QR::internal::quad_normal(smoother.quad(f))[2] < 0; };
  for(const auto f : flat.quads.faces())
    CHECK_EQUAL(upper_sides.is_folded(f),
                faces_down(f) ||
                  QR::internal::has_corner_against(smoother.quad(f), {0, 0, 1},
                                                   QR::internal::clearly_against));
  const auto number_of_bad = [&] {
    std::size_t result = 0;
    for(const auto f : flat.quads.faces())
      result += QR::internal::is_inverted(smoother.quad(f)) || faces_down(f) ? 1 : 0;
    return result;
  };
  const std::vector<Point_3> before(flat.quads.points().begin(), flat.quads.points().end());
  CHECK(number_of_bad() > 0);
  upper_sides.update();
  QR::internal::Quad_mender mender(flat.quads, is_feature, smoother, has_single_precision);
  if(!has_to_relax)
    mender.run(false);
  CHECK_EQUAL(number_of_bad() > 0, has_to_relax || stays_in_plane);
  mender.relax([&] { return upper_sides.update(); });
  CHECK_EQUAL(number_of_bad(), 0u);
  for(const auto v : flat.quads.vertices())
    if(has_to_relax && flat.quads.is_border(v))
      CHECK_EQUAL(flat.quads.point(v), before[std::size_t(v)]);

  std::size_t moved = 0;
  double largest = 0;
  for(const auto v : flat.quads.vertices()) {
    const Point_3 &p = before[std::size_t(v)], &q = flat.quads.point(v);
    CHECK(!stays_in_plane || q.z() == 0);
    moved += p == q ? 0 : 1;
    largest = (std::max)(largest, std::sqrt(CGAL::squared_distance(p, q)));
    for(int c = 0; has_single_precision && c < 3; ++c)
      CHECK_EQUAL(double(float(q[c])), q[c]);
  }
  CHECK_EQUAL(mender.number_of_displaced_vertices(), moved);
  CHECK(std::abs(mender.largest_displacement() - largest) < 1e-12);
}

void test_mending()
{
  for(const bool has_single_precision : {false, true}) {
    // Slightly, and so far that the smallest steps don't help.
    for(const double x : {2.0009765625, 2.375}) {
      Flat_quads flat(1);
      for(const std::size_t first : {0, 1, 2, 4, 5, 6, 8, 9, 10})
        flat.add_quad(first);
      flat.quads.point(flat.vertices[5]) = Point_3(x, x, 0);
      check_mending(flat, has_single_precision);
    }
    // Two of four quads that are inverted lie upside down.
    Flat_quads folded(1);
    for(const std::size_t first : {0, 1, 2, 4, 5, 6, 8, 9, 10})
      folded.add_quad(first);
    folded.quads.point(folded.vertices[5]) = Point_3(2.5, 0.75, 0);
    folded.quads.point(folded.vertices[6]) = Point_3(1.25, 0.75, 0);
    folded.quads.point(folded.vertices[9]) = Point_3(0.75, 1.25, 0);
    folded.quads.point(folded.vertices[10]) = Point_3(0.5, 2.5, 0);
    check_mending(folded, has_single_precision);
    // No place on the plane mends two quads around a vertex of two edges; some off it do, if the
    // surface is not all in it.
    for(const bool is_plane : {false, true}) {
      Flat_quads flat(1);
      const Vertex v = flat.quads.add_vertex(Point_3(1.5, 1.5, 0));
      flat.quads.add_face(flat.vertices[5], flat.vertices[6], flat.vertices[10], v);
      flat.quads.add_face(flat.vertices[5], v, flat.vertices[10], flat.vertices[9]);
      flat.quads.point(v) = Point_3(1.625, 1.375, 0);
      if(!is_plane)
        flat.square.add_face(flat.square.add_vertex(Point_3(6, 0, 0)),
                             flat.square.add_vertex(Point_3(7, 0, 0)),
                             flat.square.add_vertex(Point_3(6, 0, 1)));
      check_mending(flat, has_single_precision, false, is_plane);
    }
    // Three quads in a row lie upside down between the others, and all nine are rectangles.
    Flat_quads pleat(1);
    for(const std::size_t first : {0, 1, 2, 4, 5, 6, 8, 9, 10})
      pleat.add_quad(first);
    for(const std::size_t row : {0, 4, 8, 12})
      for(const std::size_t i : {1, 2})
        pleat.quads.point(pleat.vertices[row + i]) =
          Point_3(i == 1 ? 1.75 : 1.25, double(row / 4), 0);
    check_mending(pleat, has_single_precision);
    // All four vertices inside are turned by 180 degrees.
    Flat_quads turned(1);
    for(const std::size_t first : {0, 1, 2, 4, 5, 6, 8, 9, 10})
      turned.add_quad(first);
    turned.turn();
    check_mending(turned, has_single_precision, true);
  }
}

// A quad over a valley, whose middle is nearest to something that faces the other way.
void test_folded_quads()
{
  for(const bool is_folded : {false, true}) {
    Mesh valley;
    std::vector<Vertex> v;
    for(const int x : {-1, 0, 1})
      for(const int y : {0, 1})
        v.push_back(valley.add_vertex(Point_3(x, y, std::abs(x))));
    for(const std::size_t i : {0, 2}) {
      valley.add_face(v[i], v[i + 2], v[i + 3]);
      valley.add_face(v[i + 3], v[i + 1], v[i]);
    }
    const Vertex a = valley.add_vertex(Point_3(-1, 0, 1.1)),
                 b = valley.add_vertex(Point_3(0, 2, 1.1)),
                 c = valley.add_vertex(Point_3(1, 0, 1.1));
    if(is_folded)
      valley.add_face(a, c, b);
    else
      valley.add_face(a, b, c);
    const internal::Surface_to_remesh surface = surface_to_remesh(valley);
    Mesh quads;
    std::vector<Vertex> corners;
    for(const std::size_t i : {0, 4, 5, 1})
      corners.push_back(quads.add_vertex(surface.mesh().point(v[i])));
    if(is_folded)
      std::reverse(corners.begin(), corners.end());
    const auto f = quads.add_face(corners);
    const QR::internal::Surface_locator locator(surface.mesh());
    QR::internal::Quad_smoother smoother(quads, locator);
    const auto is_feature = quads.add_property_map<Mesh::Edge_index, bool>("e:line", false).first;
    const QR::internal::Upper_sides upper_sides(quads, is_feature, surface, smoother);
    const auto quad = smoother.quad(f);
    CHECK(QR::internal::inner_product(locator.normal(quad),
                                      QR::internal::quad_normal(quad)) < 0);
    CHECK_EQUAL(upper_sides.is_folded(f), is_folded);
  }
}

// A bow tie on a plane, two corners of which lie above it: all of its corners turn as its area
// vector does, which is along the plane. Without the crossing, the quad is not folded.
void test_bow_tie()
{
  for(const bool is_bow_tie : {false, true}) {
    Mesh plane;
    std::vector<Vertex> v;
    for(const Point_3& p : {Point_3(-2, -2, 0), Point_3(2, -2, 0), Point_3(2, 2, 0),
                            Point_3(-2, 2, 0)})
      v.push_back(plane.add_vertex(p));
    plane.add_face(v[0], v[1], v[2]);
    plane.add_face(v[0], v[2], v[3]);
    // one that is no plane as a whole, so that vertices may leave it
    plane.add_face(plane.add_vertex(Point_3(3, 0, 0)), plane.add_vertex(Point_3(4, 0, 0)),
                   plane.add_vertex(Point_3(3, 0, 1)));
    const internal::Surface_to_remesh surface = surface_to_remesh(plane);
    std::vector<Point_3> points{Point_3(0, 0, 0), Point_3(1, 0, 0.125), Point_3(1, 1, 0),
                                Point_3(0, 1, 0.125)};
    if(is_bow_tie)
      std::swap(points[1], points[2]);
    Mesh quads;
    std::vector<Vertex> corners;
    for(const Point_3& p : points)
      corners.push_back(quads.add_vertex(p));
    const auto f = quads.add_face(corners);
    scale(quads, 1 / surface.unscaled(1));
    const QR::internal::Surface_locator locator(surface.mesh());
    QR::internal::Quad_smoother smoother(quads, locator);
    const auto is_feature = quads.add_property_map<Mesh::Edge_index, bool>("e:line", false).first;
    QR::internal::Upper_sides upper_sides(quads, is_feature, surface, smoother);
    CHECK(!QR::internal::is_inverted(smoother.quad(f)));
    CHECK_EQUAL(upper_sides.is_folded(f), is_bow_tie);
    CHECK_EQUAL(upper_sides.update(), is_bow_tie ? 1u : 0u);
    CHECK_EQUAL(smoother.is_bad(f), is_bow_tie);
    QR::internal::Quad_mender mender(quads, is_feature, smoother, false);
    mender.run(false);
    CHECK_EQUAL(mender.number_of_displaced_vertices() > 0, is_bow_tie);
    CHECK(!QR::internal::is_inverted(smoother.quad(f)) && !upper_sides.is_folded(f));
  }
}

// Three corners are on one side of a fin, and one on the other, to which the quad faces: it is as
// large as the fin is thick, so that both sides are below it.
void test_quad_across_fin()
{
  Mesh fin;
  std::vector<Vertex> v;
  for(const double x : {0., 0.1})
    for(const auto& [y, z] :
        {std::pair(-3, -3), std::pair(3, -3), std::pair(3, 3), std::pair(-3, 3)})
      v.push_back(fin.add_vertex(Point_3(x, y, z)));
  for(const auto& [i, j, k] : {std::tuple(0, 3, 2), std::tuple(2, 1, 0), std::tuple(4, 5, 6),
                               std::tuple(6, 7, 4), std::tuple(2, 3, 7), std::tuple(7, 6, 2)})
    fin.add_face(v[std::size_t(i)], v[std::size_t(j)], v[std::size_t(k)]);
  const internal::Surface_to_remesh surface = surface_to_remesh(fin);
  for(const bool is_folded : {false, true}) { // all four corners are on one side
    Mesh quads;
    std::vector<Vertex> corners;
    for(const auto& [x, y, z] : {std::tuple(0., 0, 0), std::tuple(0., 1, 0),
                                 std::tuple(is_folded ? 0. : 0.1, 1, 1), std::tuple(0., 0, 1)})
      corners.push_back(
        quads.add_vertex(Point_3(surface.scaled(x), surface.scaled(y), surface.scaled(z))));
    const auto f = quads.add_face(corners);
    const QR::internal::Surface_locator locator(surface.mesh());
    QR::internal::Quad_smoother smoother(quads, locator);
    const auto is_feature = quads.add_property_map<Mesh::Edge_index, bool>("e:line", false).first;
    const QR::internal::Upper_sides upper_sides(quads, is_feature, surface, smoother);
    CHECK_EQUAL(upper_sides.is_folded(f), is_folded);
  }
}

// Quads turn back at a crest: they are folded over a plane, but not over a fin, however thin. A low
// crest over a plane is mended.
void test_quads_that_turn_back()
{
  constexpr std::size_t rows = 2;
  for(const double width : {0.6, 0.01, 0.}) // of the foot of a fin; 0 for a plane
    for(const bool has_feature : {false, true}) {
      const bool is_plane = width == 0;
      const std::array<double, 5> x{-3, is_plane ? -0.3 : -width / 2, is_plane ? 0.1 : 0.2 * width,
                                    is_plane ? 0.3 : width / 2, 3};
      const auto make_columns = [&](Mesh& mesh) {
        for(std::size_t i = 0; i < 5; ++i)
          for(std::size_t j = 0; j <= rows; ++j)
            mesh.add_vertex(Point_3(x[i], double(j), i == 2 && !is_plane ? 3 : 0));
      };
      const auto vertex = [&](const std::size_t i, const std::size_t j)
        { return Vertex(Mesh::size_type(i * (rows + 1) + j)); };
      const auto mark_crest = [&](const Mesh& mesh, const auto& is_marked) {
        for(std::size_t j = 0; j < rows; ++j)
          is_marked[mesh.edge(mesh.halfedge(vertex(2, j), vertex(2, j + 1)))] = has_feature;
      };
      Mesh mesh, quads;
      make_columns(mesh);
      make_columns(quads);
      for(std::size_t i = 0; i < 4; ++i)
        for(std::size_t j = 0; j < rows; ++j) {
          mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
          mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
          quads.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
        }
      const auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
      const auto is_line = quads.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
      mark_crest(mesh, is_sharp);
      mark_crest(quads, is_line);
      const internal::Surface_to_remesh surface =
        surface_to_remesh(mesh, parameters::edge_is_constrained_map(is_sharp));
      scale(quads, 1 / surface.unscaled(1));
      const QR::internal::Surface_locator locator(surface.mesh());
      QR::internal::Quad_smoother smoother(quads, locator);
      QR::internal::Upper_sides upper_sides(quads, is_line, surface, smoother);
      const auto raise_crest = [&](const double height) {
        for(std::size_t j = 0; j <= rows; ++j) {
          const Point_3 p = quads.point(vertex(2, j));
          quads.point(vertex(2, j)) = Point_3(p.x(), p.y(), surface.scaled(height));
        }
      };
      raise_crest(3); // after the places on the surface are known
      for(const auto f : quads.faces()) {
        const std::size_t column = std::size_t(f) / rows;
        CHECK(!QR::internal::is_inverted(smoother.quad(f)));
        CHECK_EQUAL(upper_sides.is_folded(f), is_plane && column == 2);
      }
      if(!is_plane)
        continue;
      raise_crest(0.45);
      CHECK_EQUAL(upper_sides.update(), rows);
      QR::internal::Quad_mender(quads, is_line, smoother, false).run(true);
      CHECK_EQUAL(upper_sides.update(), 0u);
    }
}

// Quads may turn back where the surface does: nine quads of a torus, and the two of a pillow.
void test_coarse_quads()
{
  const auto check = [](const Mesh& mesh, Mesh& quads, const double largest_cosine) {
    const internal::Surface_to_remesh surface = surface_to_remesh(mesh);
    scale(quads, 1 / surface.unscaled(1));
    const auto is_line = quads.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
    const QR::internal::Surface_locator locator(surface.mesh());
    const QR::internal::Quad_smoother smoother(quads, locator);
    const QR::internal::Upper_sides upper_sides(quads, is_line, surface, smoother);
    double least = 1; // cosine of the normals of two quads
    for(const auto e : quads.edges()) {
      const auto normal = [&](const Mesh::Halfedge_index h) {
        return QR::internal::scaled_to_one(
          QR::internal::quad_normal(smoother.quad(quads.face(h))));
      };
      const auto h = quads.halfedge(e);
      least = (std::min)(least,
                         QR::internal::inner_product(normal(h), normal(quads.opposite(h))));
    }
    CHECK_IN(std::to_string(least), least < largest_cosine);
    for(const auto f : quads.faces())
      CHECK(!upper_sides.is_folded(f));
  };
  const auto torus = [](const int n, const bool has_triangles) {
    Mesh mesh;
    const double turn = 4 * std::acos(0.) / n;
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j) {
        const double x = 3 + std::cos(turn * j);
        mesh.add_vertex(Point_3(x * std::cos(turn * i), x * std::sin(turn * i),
                                std::sin(turn * j)));
      }
    const auto vertex = [&](const int i, const int j)
      { return Vertex(Mesh::size_type((i % n) * n + j % n)); };
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j) {
        const std::array<Vertex, 4> v{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1),
                                      vertex(i, j + 1)};
        if(has_triangles) {
          mesh.add_face(v[0], v[1], v[2]);
          mesh.add_face(v[0], v[2], v[3]);
        } else
          mesh.add_face(v[0], v[1], v[2], v[3]);
      }
    return mesh;
  };
  Mesh nine = torus(3, false);
  check(torus(24, true), nine, -0.4);
  for(const double height : {0.5, 0.05}) {
    Mesh pillow, two;
    std::vector<Vertex> v, w;
    for(const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
      v.push_back(pillow.add_vertex(Point_3(x, y, 0)));
      w.push_back(two.add_vertex(Point_3(x, y, 0)));
    }
    const Vertex above = pillow.add_vertex(Point_3(0.5, 0.5, height)),
                 below = pillow.add_vertex(Point_3(0.5, 0.5, -height));
    for(std::size_t i = 0; i < 4; ++i) {
      pillow.add_face(v[i], v[(i + 1) % 4], above);
      pillow.add_face(v[(i + 1) % 4], v[i], below);
    }
    two.add_face(w);
    std::reverse(w.begin(), w.end());
    two.add_face(w);
    check(pillow, two, -0.99);
  }
}

// An inverted quad goes, unless it is on the border, or features around it would be folded.
void test_collapse()
{
  enum Case { FREE, ON_LINE, AT_CORNER, ON_BORDER };
  for(const Case kind : {FREE, ON_LINE, AT_CORNER, ON_BORDER}) {
    Flat_quads flat(1);
    for(const std::size_t first : {0, 1, 2, 4, 5, 6, 8, 9, 10})
      if(kind != ON_BORDER || first != 1)
        flat.add_quad(first);
    Mesh& quads = flat.quads;
    const auto& v = flat.vertices;
    quads.point(v[5]) = Point_3(1.9, 1.3, 0); // beyond the other diagonal
    const auto is_feature = quads.add_property_map<Mesh::Edge_index, bool>("e:line", false).first;
    for(const auto e : quads.edges())
      is_feature[e] = quads.is_border(e);
    const auto mark = [&](const std::size_t a, const std::size_t b)
      { is_feature[quads.edge(quads.halfedge(v[a], v[b]))] = true; };
    if(kind == ON_LINE)
      mark(6, 10);
    if(kind == ON_LINE || kind == AT_CORNER)
      for(const std::size_t i : {2, 10})
        mark(i, i + 4);
    if(kind == AT_CORNER) {
      mark(5, 6);
      mark(6, 10);
    }
    const auto number_of_features = [&] {
      return std::count_if(quads.edges().begin(), quads.edges().end(),
                           [&](const auto e) { return bool(is_feature[e]); });
    };
    const auto features_before = number_of_features();
    const internal::Surface_to_remesh surface = surface_to_remesh(flat.square);
    scale(flat.quads, 1 / surface.unscaled(1));
    const QR::internal::Surface_locator locator(surface.mesh());
    QR::internal::Quad_smoother smoother(quads, locator);
    const Point_3 on_line = quads.point(v[10]);
    const std::size_t expected = kind == FREE || kind == ON_LINE ? 1 : 0;
    const std::size_t number_before = quads.number_of_faces();
    CHECK_EQUAL(QR::internal::Quad_collapser(quads, is_feature, smoother, false).run(), expected);
    CHECK_EQUAL(quads.number_of_faces(), number_before - expected);
    CHECK(CGAL::is_valid_polygon_mesh(quads) && CGAL::is_quad_mesh(quads));
    CHECK_EQUAL(quads.number_of_vertices() + quads.number_of_faces() - quads.number_of_edges(), 1u);
    std::size_t number_of_inverted = 0;
    for(const auto f : quads.faces())
      number_of_inverted += QR::internal::is_inverted(smoother.quad(f)) ? 1 : 0;
    CHECK((number_of_inverted == 0) == (expected == 1));
    CHECK_EQUAL(number_of_features(), features_before);
    for(const std::size_t i : {5, 10}) // one of the two is gone
      CHECK(kind != ON_LINE || quads.is_removed(v[i]) || quads.point(v[i]) == on_line);
  }
}

// No map aligns three sides of a triangle, as all of these edges are features or border.
template <typename Quad_mesh>
void check_aligned_triangles(const std::vector<Point_3>& points,
                          const std::vector<std::array<Mesh::size_type, 3> >& triangles)
{
  Mesh mesh;
  for(const Point_3& p : points)
    mesh.add_vertex(p);
  for(const auto& t : triangles)
    mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", true).first;
  Quad_mesh quads;
  std::map<typename boost::graph_traits<Quad_mesh>::edge_descriptor, bool> is_on_feature;
  const QR::Remeshing_report report = QR::quad_remesh(
    mesh, quads, parameters::edge_is_constrained_map(is_feature).target_number_of_quads(300),
    parameters::edge_is_constrained_map(boost::make_assoc_property_map(is_on_feature)));
  CHECK_IN(report.message, bool(report));
  CHECK(CGAL::is_valid_polygon_mesh(quads));
  CHECK_EQUAL(faces(quads).size(), report.number_of_quads);
  const auto point_map = get(CGAL::vertex_point, quads);
  std::set<Point_3> corners;
  for(const auto v : vertices(quads))
    corners.insert(get(point_map, v));
  const bool is_as_wanted =
    report.number_of_released_edges == 0 && report.number_of_displaced_vertices == 0;
  for(const Point_3& p : points)
    CHECK(corners.count(p) == 1 || !is_as_wanted);
  // As long in both meshes: where two quads meet at an angle, or at the border.
  double length = 0, length_of_features = 0, expected = 0;
  for(const auto e : edges(mesh))
    expected += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)),
                                                 mesh.point(mesh.vertex(e, 1))));
  const auto is_on_edge = [&](const Point_3& p, const auto e) {
    const Point_3 &a = mesh.point(mesh.vertex(e, 0)), &b = mesh.point(mesh.vertex(e, 1));
    return CGAL::squared_distance(p, Kernel::Segment_3(a, b)) <
           1e-20 * CGAL::squared_distance(a, b);
  };
  for(const auto f : edges(quads)) {
    const auto p = get(point_map, source(f, quads)), q = get(point_map, target(f, quads));
    const auto along = edges(mesh);
    const bool is_along = std::any_of(along.begin(), along.end(), [&](const auto e) {
      return is_on_edge(p, e) && is_on_edge(q, e);
    });
    CHECK(is_on_feature.count(f) == 1);
    CHECK(is_on_feature[f] == is_along || !is_as_wanted);
    const double length_of_edge = std::sqrt(CGAL::squared_distance(p, q));
    length += is_along ? length_of_edge : 0;
    length_of_features += is_on_feature[f] ? length_of_edge : 0;
  }
  // What is not kept was released; quads may go on along a bit of that. A vertex that was displaced
  // makes each of its edges on features longer or shorter, of which there are at most three.
  const double tolerance =
    1e-9 * expected + 3 * double(report.number_of_displaced_vertices) * report.largest_displacement;
  CHECK(length_of_features < expected + tolerance);
  CHECK(length_of_features + report.length_of_released_edges > expected - tolerance);
  CHECK((report.length_of_released_edges > 0) == (report.number_of_released_edges > 0));
  CHECK(!is_as_wanted || std::abs(length - expected) < 1e-9 * expected);
  CHECK(report.number_of_released_edges == 0 || triangles.size() > 1);
}

void test_triangles()
{
  const Point_3 a(0, 0, 0);
  const std::vector<std::array<Mesh::size_type, 3> > one{{{0, 1, 2}}};
  for(const Point_3& c : {Point_3(0, 1, 0), Point_3(0.5, 0.9, 0), Point_3(1.8, 1, 0),
                          Point_3(0.5, 0.29, 0), Point_3(0.1, 8, 3)})
    check_aligned_triangles<Mesh>({a, Point_3(1, 0, 0), c}, one);
  for(const Point_3& d : {Point_3(0, 0, 1), Point_3(0.3, 0.4, 0.3), Point_3(2, 2, 3)})
    check_aligned_triangles<CGAL::Polyhedron_3<Kernel> >(
      {a, Point_3(1, 0, 0), Point_3(0, 1, 0), d},
      {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}});
}

// --- refusals ------------------------------------------------------------------------------------

void check_refusal(const Grid_map& map, const Status status, const std::string& word,
                   const std::size_t number = 100)
{
  const auto quantization =
    QR::quantize(map.mesh, map.uv, parameters::target_number_of_quads(number));
  CHECK_EQUAL(QR::to_string(quantization.status), std::string(QR::to_string(status)));
  CHECK_IN(quantization.message, quantization.message.find(word) != std::string::npos);
  Mesh quads;
  CHECK(QR::extract_quad_mesh(quantization, map.mesh, quads).status ==
        QR::Outcome::INVALID_ARGUMENT);
  CHECK(quads.is_empty());
}

void check_quads_near_origin(const Mesh& mesh, const UV_map& uv)
{
  const auto quantization =
    QR::quantize(mesh, uv, parameters::target_number_of_quads(77).needs_face_graph(true));
  CHECK_IN(quantization.message, bool(quantization));
  Mesh quads;
  const auto report = QR::extract_quad_mesh(quantization, mesh, quads);
  CHECK_IN(report.message, bool(report));
  CHECK(!quads.is_empty() && CGAL::is_closed(quads) == CGAL::is_closed(mesh));
  for(const auto v : quads.vertices())
    CHECK(quads.is_border(v) || quads.degree(v) == 4);
}

// A torus whose translations along v have finer bits than integers of 64 bits hold beside those
// along u; with faces so thin that moving the map degenerates them, it is refused.
void test_map_near_origin()
{
  const auto stretch = [](Grid_map& map, const double first_v) {
    for(const auto h : map.mesh.halfedges())
      map.uv[h] = Point_2(2.00001 * map.uv[h].x(),
                          map.uv[h].y() == 1 ? first_v : 0.00001 * map.uv[h].y());
  };
  Grid_map map(surfaces::torus(4, 4), 1, 1);
  stretch(map, 0.00001);
  const std::vector<Point_2> before(map.uv.begin(), map.uv.end());
  check_quads_near_origin(map.mesh, map.uv);
  CHECK(std::equal(before.begin(), before.end(), map.uv.begin()));

  Grid_map tube(surfaces::cylinder(4, 4), 1, 1);
  for(const auto h : tube.mesh.halfedges())
    tube.uv[h] = Point_2(0.00001 * tube.uv[h].x(), 2.00001 * tube.uv[h].y());
  check_quads_near_origin(tube.mesh, tube.uv);

  Mesh tubes; // that meet at a vertex of their borders
  const auto uv = tubes.add_property_map<Halfedge, Point_2>("h:uv").first;
  Mesh::Vertex_index meeting;
  for(int i = 0; i < 2; ++i) {
    std::map<Mesh::Vertex_index, Mesh::Vertex_index> copy;
    for(const auto v : tube.mesh.vertices())
      copy[v] = i == 1 && copy.empty() ? meeting : tubes.add_vertex(tube.mesh.point(v));
    meeting = copy.begin()->second;
    CHECK(tube.mesh.is_border(copy.begin()->first));
    for(const auto f : tube.mesh.faces()) {
      std::vector<Mesh::Vertex_index> corners;
      for(const auto v : tube.mesh.vertices_around_face(tube.mesh.halfedge(f)))
        corners.push_back(copy[v]);
      const auto g = tubes.add_face(corners);
      for(const auto h : tube.mesh.halfedges_around_face(tube.mesh.halfedge(f)))
        for(const auto k : tubes.halfedges_around_face(tubes.halfedge(g)))
          if(tubes.target(k) == copy[tube.mesh.target(h)])
            uv[k] = tube.uv[h];
    }
  }
  check_quads_near_origin(tubes, uv);

  Grid_map thin(surfaces::torus(4, 4), 1, 1);
  stretch(thin, 1e-40);
  check_refusal(thin, Status::TOO_LARGE, "which was tried: 8 faces", 77);
}

void test_refusals()
{
  Grid_map map(surfaces::box(1, 1, 1), 4, 4);
  check_refusal(map, Status::INVALID_ARGUMENT, "2^28", 0);
  check_refusal(map, Status::INVALID_ARGUMENT, "2^28", std::size_t(1) << 29);
  for(const double length : {0., -1., std::numeric_limits<double>::quiet_NaN()})
    CHECK(QR::quantize(map.mesh, map.uv, parameters::target_edge_length(length)).status ==
          Status::INVALID_ARGUMENT);
  const QR::Quantization by_length =
    QR::quantize(map.mesh, map.uv, parameters::target_edge_length(0.5));
  CHECK_EQUAL(by_length.number_of_quads, std::size_t(6 * 2 * 2));
  Mesh quads;
  const Grid_map other(surfaces::box(1, 1, 1), 4, 2);
  CHECK(QR::extract_quad_mesh(by_length, other.mesh, quads).status ==
        QR::Outcome::INVALID_ARGUMENT);
  const Halfedge h = *map.mesh.halfedges().begin();
  const Point_2 good = map.uv[h];
  map.at(h) = Point_2(good.x(), std::nextafter(good.y(), 9));
  check_refusal(map, Status::NOT_SEAMLESS, "snap_to_seamless");
  map.at(h) = Point_2(good.x(), std::numeric_limits<double>::infinity());
  check_refusal(map, Status::NOT_FINITE, "face");

  Grid_map flipped(surfaces::disc(2, 2), 4, 4);
  const Point_2 center = Point_2(4, 4);
  for(const auto g : flipped.mesh.halfedges())
    if(!flipped.mesh.is_border(g) && flipped.uv[g] == center)
      flipped.uv[g] = Point_2(6.5, 4);
  check_refusal(flipped, Status::NOT_POSITIVE, "repair_flips");

  Grid_map slanted(surfaces::disc(2, 2), 4, 4);
  for(const auto g : slanted.mesh.halfedges())
    if(!slanted.mesh.is_border(g))
      slanted.uv[g] = Point_2(std::ldexp(slanted.uv[g].y(), -20) + slanted.uv[g].x(),
                              slanted.uv[g].y());
  check_refusal(slanted, Status::NOT_ALIGNED, "align_border");

  // the copy that is remeshed has more faces, as theirs have border sides only
  Mesh bow_tie;
  for(const double x : {-1., 1.})
    for(const double y : {-1., 1.})
      bow_tie.add_vertex(Point_3(x, y, 0));
  const Vertex middle = bow_tie.add_vertex(Point_3(0, 0, 0));
  bow_tie.add_face(Vertex(1), Vertex(0), middle);
  bow_tie.add_face(Vertex(2), Vertex(3), middle);
  const auto report = QR::quad_remesh(bow_tie, quads);
  CHECK(report.status == Status::NOT_MANIFOLD);
  CHECK_IN(report.message, report.message.find("of face 0 ") != std::string::npos ||
                             report.message.find("of face 1 ") != std::string::npos);
}

void test_no_quantization()
{
  const Mesh mesh = square_and_peaks(1)[0];
  const QR::Quantization none;
  CHECK(QR::quantize_again(none, mesh).message.find("quantize() makes one") != std::string::npos);
}

int main()
{
  test_no_quantization();
  std::cout.precision(6);
  test_complexes();
  test_surfaces();
  test_optimum();
  test_strips_in_both_directions(internal::Cost_of_units::LENGTHS);
  test_strips_in_both_directions(internal::Cost_of_units::SHAPE);
  {
    const Floating_point_traps traps; // for public functions
    test_maps();
    test_quads_without_features();
    test_release_of_features();
    test_unaligned_borders();
    test_folds();
    test_map_near_origin();
    test_empty_mesh();
    test_addition_of_quads();
    test_doubled_strips();
    test_search();
    test_choices_of_search();
    test_search_without_work();
    test_numbers();
    test_remeshing();
    test_interruptions();
    test_spent_work();
    test_sizes_of_quads();
    test_symmetry();
    test_locations();
    test_remeshing_of_long_triangles();
    test_few_quads();
    test_choice_of_map();
    test_few_quads_between_features();
    test_double_pyramid();
    test_twisted_tubes();
    test_thin_springs();
    test_attempt_without_features();
    test_border_in_steps();
    test_side_of_plate();
    test_hopeless_features();
    test_tips();
    test_prisms();
    test_edge_lengths();
    test_touching_bodies();
    test_double_sheets();
    pieces::test_all();
  }
  test_quads_needed();
  test_refinement();
  test_sizes_in_space();
  test_unfolding();
  test_unfolding_without_border();
  test_shape_of_flat_quads();
  test_long_sides();
  test_larger_number();
  test_slightly_more_quads();
  test_distance_of_quads();
  test_improvement();
  test_division();
  test_mending();
  test_folded_quads();
  test_bow_tie();
  test_quad_across_fin();
  test_quads_that_turn_back();
  test_coarse_quads();
  test_collapse();
  test_triangles();
  test_refusals();
  return report_checks();
}
