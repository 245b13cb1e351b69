// Tests of the surface function: the same surface must come out the same to the bit in all mesh
// data structures and modes of the processor, and exact in all ranges of numbers.

#include "floating_point_traps.h"
#include "surface_checks.h"

#include <CGAL/Linear_snapping/snap_to_linear_constraints.h>
#include <CGAL/Seamless_snapping/snap_soup_to_seamless.h>

#include <CGAL/FPU.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <array>
#include <cfenv>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace surface_checks;
using test_meshes::Named_mesh;
using uv_noise::Noise;

using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Mesh::Halfedge_index;
using Point_2 = Kernel::Point_2;

Named_mesh<Kernel> disturbed(Named_mesh<Kernel> named, unsigned int seed, double relative = 1e-9)
{
  test_meshes::warp(named, seed);
  const auto uv = test_meshes::uv_map(named.mesh);
  uv_noise::perturb(named.mesh, uv, relative * extent(named.mesh, uv), seed,
                    seed % 2 == 0 ? Noise::per_sector : Noise::per_corner);
  return named;
}

Named_mesh<Kernel> snapped(Named_mesh<Kernel> named, const std::string& context)
{
  snap_and_check(named, context);
  return named;
}

// --- mesh data structures ------------------------------------------------------------------------

// A point and a uv map that have only what the documentation asks for.
struct Plain_point
{
  Plain_point(double x_, double y_)
    : m_x(x_)
    , m_y(y_)
  { }
  double x() const { return m_x; }
  double y() const { return m_y; }

private:
  double m_x, m_y;
};

struct Plain_map
{
  using key_type = Halfedge;
  using value_type = Plain_point;
  using reference = Plain_point;
  using category = boost::read_write_property_map_tag;

  std::shared_ptr<std::map<Halfedge, std::array<double, 2> > > values =
    std::make_shared<std::map<Halfedge, std::array<double, 2> > >();

  friend Plain_point get(const Plain_map& m, const Halfedge h)
  {
    const std::array<double, 2>& value = m.values->at(h);
    return Plain_point(value[0], value[1]);
  }
  friend void put(const Plain_map& m, const Halfedge h, const Plain_point& p)
  {
    (*m.values)[h] = { { p.x(), p.y() } };
  }
};

Plain_map plain_uv(const Mesh& mesh)
{
  const Plain_map uv;
  for(const auto h : halfedges(mesh))
    put(uv, h, Plain_point(0, 0));
  return uv;
}

// `pairs` relates the halfedges of a mesh to those of a copy that has no uv map as yet. The copy's
// vertices may come in another order, since the order of processing is up to their indices.
template <typename Graph, typename Pairs, typename UVMap>
void expect_same(const Named_mesh<Kernel>& input, const Named_mesh<Kernel>& expected, Graph& copy,
                 const Pairs& pairs, UVMap uv, const std::string& context)
{
  Mesh original = input.mesh, result = expected.mesh;
  const auto original_uv = test_meshes::uv_map(original);
  const auto result_uv = test_meshes::uv_map(result);
  const auto original_features = test_meshes::feature_map(original);
  const auto features = get(CGAL::dynamic_edge_property_t<bool>(), copy);
  const auto index = get(CGAL::dynamic_vertex_property_t<std::size_t>(), copy);
  for(const auto& pair : pairs) {
    const Point_2& p = original_uv[pair.first];
    put(uv, pair.second, typename UVMap::value_type(p.x(), p.y()));
    put(features, edge(pair.second, copy), original_features[original.edge(pair.first)]);
    put(index, target(pair.second, copy), std::size_t(target(pair.first, original)));
  }
  const Graph& unchanging = copy;
  const auto np = SS::parameters::edge_is_constrained_map(features)
                    .align_border(input.align_border)
                    .vertex_index_map(index);
  const SS::Snapping_report report = SS::snap_to_seamless(unchanging, uv, np);
  CHECK_IN(context, bool(report));
  CHECK_IN(context, report.run.number_of_faces == input.mesh.number_of_faces());
  CHECK_IN(context, SS::is_seamless(unchanging, uv, np));
  std::size_t different = 0;
  for(const auto& pair : pairs) {
    if(is_border(pair.first, original))
      continue;
    const auto p = get(uv, pair.second);
    const Point_2& q = result_uv[pair.first];
    different += bits(p.x()) != bits(q.x()) || bits(p.y()) != bits(q.y()) ? 1 : 0;
  }
  CHECK_IN(context, different == 0);
}

template <typename Graph>
using Halfedge_pairs =
  std::vector<std::pair<Halfedge, typename boost::graph_traits<Graph>::halfedge_descriptor> >;

template <typename Graph>
Halfedge_pairs<Graph> copy_into(const Mesh& mesh, Graph& copy)
{
  Halfedge_pairs<Graph> pairs;
  CGAL::copy_face_graph(mesh, copy, CGAL::parameters::halfedge_to_halfedge_output_iterator(
                                      std::back_inserter(pairs)));
  return pairs;
}

template <typename Graph>
auto dynamic_uv(Graph& g)
{
  return get(CGAL::dynamic_halfedge_property_t<Point_2>(), g);
}

// The same vertices; faces and edges in another order, edges turned round, and any halfedge for the
// one of a vertex or face.
Halfedge_pairs<Mesh> shuffle_into(const Mesh& mesh, unsigned int seed, Mesh& copy)
{
  std::mt19937_64 random(seed);
  for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    copy.add_vertex();
  std::vector<Halfedge> first;
  for(std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    first.push_back(copy.add_edge());
  std::vector<Mesh::Face_index> place;
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    place.push_back(copy.add_face());
  std::shuffle(first.begin(), first.end(), random);
  std::shuffle(place.begin(), place.end(), random);

  std::map<Halfedge, Halfedge> image;
  std::size_t n = 0;
  for(const auto e : mesh.edges()) {
    const Halfedge h = mesh.halfedge(e), k = first[n++];
    const bool turn = random() % 2 == 0;
    image[h] = turn ? copy.opposite(k) : k;
    image[mesh.opposite(h)] = turn ? k : copy.opposite(k);
  }
  for(const auto h : mesh.halfedges()) {
    copy.set_target(image[h], mesh.target(h));
    copy.set_next(image[h], image[mesh.next(h)]);
    if(!mesh.is_border(h))
      copy.set_face(image[h], place[mesh.face(h)]);
  }
  std::vector<Halfedge> halfedges;
  for(const auto h : mesh.halfedges())
    halfedges.push_back(image[h]);
  std::shuffle(halfedges.begin(), halfedges.end(), random);
  for(const Halfedge h : halfedges) { // the last one wins
    copy.set_halfedge(copy.target(h), h);
    if(!copy.is_border(h))
      copy.set_halfedge(copy.face(h), h);
  }
  return Halfedge_pairs<Mesh>(image.begin(), image.end());
}

// Leaves removed elements behind.
void add_garbage(Mesh& mesh)
{
  Mesh::Vertex_index v[3];
  for(auto& vertex : v)
    vertex = mesh.add_vertex();
  const auto f = mesh.add_face(v[0], v[1], v[2]);
  CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  CHECK(mesh.has_garbage() && mesh.number_of_removed_faces() > 0);
}

constexpr int largest_vertex = 2147483646; // of a soup

// A soup has no mesh: triples of vertices, and an array of points, three for each.
struct Soup
{
  explicit Soup(Named_mesh<Kernel> named)
  {
    const Mesh& mesh = named.mesh;
    const auto uv = test_meshes::uv_map(named.mesh);
    const auto features = test_meshes::feature_map(named.mesh);
    for(const auto f : mesh.faces()) {
      triangles.emplace_back();
      for(const auto h : halfedges_around_face(mesh.halfedge(f), mesh)) {
        triangles.back().push_back(int(mesh.target(h)));
        points.push_back(uv[h]);
      }
    }
    for(const auto e : mesh.edges())
      if(features[e])
        feature_edges.push_back({{mesh.vertex(e, 0), mesh.vertex(e, 1)}});
  }

  auto map() const
  {
    return boost::make_iterator_property_map(points.begin(),
                                             boost::typed_identity_property_map<std::size_t>());
  }
  auto map()
  {
    return boost::make_iterator_property_map(points.begin(),
                                             boost::typed_identity_property_map<std::size_t>());
  }

  // Gives the vertices far larger indices in the same order, up to the largest one.
  void scatter_vertices(const std::size_t number_of_vertices)
  {
    const auto scattered = [&](const std::size_t v)
      { return largest_vertex - 1009 * int(number_of_vertices - 1 - v); };
    for(std::vector<int>& triangle : triangles)
      for(int& v : triangle)
        v = scattered(std::size_t(v));
    for(auto& edge : feature_edges)
      for(std::size_t& v : edge)
        v = std::size_t(scattered(v));
  }

  std::vector<std::vector<int> > triangles;
  std::vector<Point_2> points;
  std::vector<std::array<std::size_t, 2> > feature_edges;
};

void test_soup(const Named_mesh<Kernel>& input, const Named_mesh<Kernel>& expected,
               const std::string& context)
{
  Soup soup(input);
  const Soup expected_soup(expected);
  const auto np =
    SS::parameters::feature_edges(soup.feature_edges).align_border(input.align_border);
  const SS::Snapping_report report = SS::snap_soup_to_seamless(soup.triangles, soup.map(), np);
  CHECK_IN(context, bool(report));
  CHECK_IN(context, SS::is_soup_seamless(soup.triangles, expected_soup.map(), np));
  std::size_t different = 0;
  for(std::size_t c = 0; c < soup.points.size(); ++c) {
    const Point_2 &p = soup.points[c], &q = expected_soup.points[c];
    different += bits(p.x()) != bits(q.x()) || bits(p.y()) != bits(q.y()) ? 1 : 0;
  }
  CHECK_IN(context, different == 0);
  soup.points[0] = Point_2(soup.points[0].x() + 1, soup.points[0].y());
  CHECK_IN(context, !SS::is_soup_seamless(soup.triangles, soup.map(), np));
  Soup scattered(input);
  scattered.scatter_vertices(input.mesh.number_of_vertices());
  CHECK_IN(context, bool(SS::snap_soup_to_seamless(
                      scattered.triangles, scattered.map(),
                      np.feature_edges(scattered.feature_edges))));
  CHECK_IN(context, scattered.points == expected_soup.points);
}

void test_refused_soups()
{
  std::vector<Point_2> points(9, Point_2(0, 0));
  const auto map = boost::make_iterator_property_map(
    points.begin(), boost::typed_identity_property_map<std::size_t>());
  const auto status = [&map](const std::vector<std::vector<int> >& triangles,
                             const std::vector<std::vector<int> >& edges = {}) {
    const auto np = SS::parameters::feature_edges(edges);
    const SS::Snapping_report report = SS::snap_soup_to_seamless(triangles, map, np);
    bool is_refused = false;
    try {
      SS::is_soup_seamless(triangles, map, np);
    } catch(const std::invalid_argument& e) {
      is_refused = report.message == e.what();
    }
    CHECK(bool(report) != is_refused);
    return report.status;
  };
  using Status = SS::Outcome;
  CHECK(status({{0, 1, 2}}) == Status::ALREADY_EXACT);
  CHECK(status({{0, 1, 2}}, {{1, 2}}) == Status::ALREADY_EXACT);
  CHECK(status({{0, 1, 2}, {0, 1}}) == Status::NOT_TRIANGULAR);
  CHECK(status({{0, 1, 2}, {0, 1, 2, 3}}) == Status::NOT_TRIANGULAR);
  CHECK(status({{0, 1, 1}}) == Status::INVALID_ARGUMENT);
  CHECK(status({{0, 1, -1}}) == Status::INVALID_ARGUMENT);
  CHECK(status({{0, 1, 2}, {0, 1, 3}}) == Status::NOT_MANIFOLD);
  CHECK(status({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}) == Status::NOT_MANIFOLD);
  CHECK(status({{0, 1, 2}}, {{1, 3}}) == Status::INVALID_ARGUMENT);
  CHECK(status({{0, 1, 2}}, {{1}}) == Status::INVALID_ARGUMENT);
  CHECK(status({{0, 1, largest_vertex}}, {{1, largest_vertex}}) == Status::ALREADY_EXACT);
  CHECK(status({{0, 1, largest_vertex}}, {{1, 2}}) == Status::INVALID_ARGUMENT);
}

// Messages name vertices by the indices of the caller, however far apart these are.
void test_names_of_soup_vertices()
{
  using Status = SS::Outcome;
  const auto expect = [](const Status status, const std::string& name,
                         const std::vector<std::vector<int> >& triangles,
                         std::vector<Point_2> points, const auto& np) {
    const SS::Snapping_report report = SS::snap_soup_to_seamless(
      triangles, boost::make_iterator_property_map(
                   points.begin(), boost::typed_identity_property_map<std::size_t>()), np);
    CHECK_IN(name + ": " + report.message, report.status == status);
    CHECK_IN(report.message, report.message.find(name + ' ') != std::string::npos ||
                             report.message.find(name + ';') != std::string::npos);
  };
  const std::string last = std::to_string(largest_vertex);
  const Point_2 a(0, 0), b(1, 0), c(0, 1), d(1, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto none = CGAL::parameters::default_values();
  expect(Status::NOT_MANIFOLD, "edge 70000 " + last,
         {{3, 70000, largest_vertex}, {5, 70000, largest_vertex}}, {a, b, c, a, b, c}, none);
  expect(Status::NOT_FINITE, "vertex " + last, {{3, 70000, largest_vertex}},
         {a, b, Point_2(0, nan)}, none);
  // the faces form two fans around the vertex that is not finite
  expect(Status::NOT_FINITE, "vertex " + last,
         {{3, 70000, largest_vertex}, {5, 6, largest_vertex}}, {a, b, c, a, b, Point_2(0, nan)},
         none);
  expect(Status::NOT_SEAMLESS, "vertices 70000 and " + last,
         {{3, 70000, largest_vertex}, {largest_vertex, 70000, 5}},
         {a, b, c, c, Point_2(1.3, 0), d}, none);
  // in the arrays of integer grids
  expect(Status::NOT_REPRESENTABLE, "vertex " + last,
         {{3, 70000, largest_vertex}, {largest_vertex, 70000, 5}},
         {a, b, Point_2(0, 1e15), Point_2(0, 1e15), b, d}, SS::parameters::integer_grid(true));
}

void test_data_structures(const Named_mesh<Kernel>& original, unsigned int seed)
{
  const std::string context = original.name + ", seed " + std::to_string(seed);
  // noise of the size of the last bits makes for means halfway between two grid points
  const Named_mesh<Kernel> input = disturbed(original, seed, seed % 4 < 2 ? 1e-9 : 3e-16);
  const Named_mesh<Kernel> expected = snapped(input, context);
  {
    CGAL::Polyhedron_3<Kernel> polyhedron;
    const auto pairs = copy_into(input.mesh, polyhedron);
    expect_same(input, expected, polyhedron, pairs, dynamic_uv(polyhedron),
                context + ", polyhedron");
  }
  {
    Mesh mesh;
    mesh.set_recycle_garbage(false);
    add_garbage(mesh);
    const auto pairs = copy_into(input.mesh, mesh);
    add_garbage(mesh);
    expect_same(input, expected, mesh, pairs, plain_uv(mesh), context + ", garbage");
  }
  for(unsigned int k = 1; k <= 3; ++k) {
    Mesh mesh;
    const auto pairs = shuffle_into(input.mesh, k * seed, mesh);
    expect_same(input, expected, mesh, pairs, plain_uv(mesh),
                context + ", shuffled " + std::to_string(k));
  }
  test_soup(input, expected, context + ", soup");
}

// --- modes of the processor ----------------------------------------------------------------------

template <typename F>
Named_mesh<Kernel> transformed(Named_mesh<Kernel> named, const F& f)
{
  const auto uv = test_meshes::uv_map(named.mesh);
  for(const auto h : named.mesh.halfedges())
    uv[h] = Point_2(f(uv[h].x()), f(uv[h].y()));
  return named;
}

// Nothing depends on the mode of the caller, which each function leaves as it was.
class Mode_tester
{
public:
  Mode_tester(const Named_mesh<Kernel>& input, const std::string& context)
    : m_context(context), m_input(input), m_expected(all_bits_of(snapped(input, context)))
  {
    m_is_seamless = exact_check::check_edges(
      m_input.mesh, test_meshes::uv_map(m_input.mesh),
      is_aligned(m_input.mesh, test_meshes::feature_map(m_input.mesh), m_input.align_border))
        .is_exact();
  }

  // Runs in the mode that is set, of which `is_restored` tells whether it still is; `reset` ends
  // it.
  template <typename IsRestored, typename Reset>
  void run(const IsRestored& is_restored, const Reset& reset) const
  {
    Named_mesh<Kernel> named = m_input;
    const auto uv = test_meshes::uv_map(named.mesh);
    const auto np = SS::parameters::edge_is_constrained_map(test_meshes::feature_map(named.mesh))
                      .align_border(named.align_border);
    const bool is_right = SS::is_seamless(named.mesh, uv, np) == m_is_seamless && is_restored();
    const bool measured =
      SS::measure_seamlessness(named.mesh, uv, np).is_exact() == m_is_seamless && is_restored();
    const bool transitions = bool(SS::seam_transitions(named.mesh, uv, np)) && is_restored();
    const SS::Snapping_report report = SS::snap_to_seamless(named.mesh, uv, np);
    const bool restored = is_restored();
    const bool is_seamless = SS::is_seamless(named.mesh, uv, np) && is_restored();
    reset();
    CHECK_IN(m_context, is_right && measured && transitions && is_seamless);
    CHECK_IN(m_context, restored);
    CHECK_IN(m_context, bool(report));
    CHECK_IN(m_context, all_bits_of(named) == m_expected);
  }

private:
  static Bits all_bits_of(Named_mesh<Kernel> named)
  { return all_bits(named.mesh, test_meshes::uv_map(named.mesh)); }

  std::string m_context;
  Named_mesh<Kernel> m_input;
  Bits m_expected;
  bool m_is_seamless = false;
};

void test_rounding_modes(const Named_mesh<Kernel>& original, unsigned int seed)
{
  const Mode_tester tester(disturbed(original, seed), original.name + " in other rounding modes");
  for(const int mode : { FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO }) {
    std::fesetround(mode);
    tester.run([&]() { return std::fegetround() == mode; },
               []() { std::fesetround(FE_TONEAREST); });
  }
  for(const int mode :
      { int(CGAL_FE_UPWARD), int(CGAL_FE_DOWNWARD), int(CGAL_FE_TOWARDZERO) }) {
    CGAL::FPU_set_cw(CGAL::FPU_CW_t(mode));
    const auto word = CGAL::FPU_get_cw();
    tester.run([&]() { return CGAL::FPU_get_cw() == word; },
               []() { CGAL::FPU_set_cw(CGAL_FE_TONEAREST); });
  }
}

// Libraries that are linked with -ffast-math let the processor take the smallest numbers for zero.
void test_flushing_to_zero(const Named_mesh<Kernel>& original, unsigned int seed)
{
#ifdef CGAL_HAS_SSE2
  constexpr unsigned int flushing = 0x8040;
  const unsigned int normal = _mm_getcsr() & 0xffc0u;
  const auto is_restored = [&]() { return (_mm_getcsr() & 0xffc0u) == (normal | flushing); };
  const auto reset = [&]() { _mm_setcsr(normal); };

  const Named_mesh<Kernel> input = disturbed(original, seed);
  for(const int exponent : { 0, -1020, -1040 }) {
    const Mode_tester tester(transformed(input, [&](double x) { return std::ldexp(x, exponent); }),
                             original.name + " times 2^" + std::to_string(exponent) + ", flushed");
    _mm_setcsr(normal | flushing);
    tester.run(is_restored, reset);
  }

  std::vector<double> x = { std::numeric_limits<double>::denorm_min() };
  SS::Linear_constraints<> constraints(1);
  constraints.add_constraint({{0, 1}});
  _mm_setcsr(normal | flushing);
  const SS::Linear_report report = SS::snap_to_linear_constraints(constraints, x);
  const bool restored = is_restored();
  reset();
  CHECK(report.status == SS::Outcome::SNAPPED && x[0] == 0 && restored);
#else
  checking::skip("flushing to zero, as it is not known how to set it on this processor");
#endif
}

// --- ranges of numbers ---------------------------------------------------------------------------

void test_scales(const Named_mesh<Kernel>& original, unsigned int seed)
{
  Named_mesh<Kernel> input = disturbed(original, seed);
  const Named_mesh<Kernel> expected = snapped(input, original.name);
  const auto transitions = SS::seam_transitions(input.mesh, test_meshes::uv_map(input.mesh));
  for(const int exponent : { -900, -498, -60, -1, 1, 60, 498, 900 }) {
    const std::string context = original.name + " times 2^" + std::to_string(exponent);
    const auto scale = [&](double x) { return std::ldexp(x, exponent); };
    Named_mesh<Kernel> here = transformed(input, scale);
    const auto scaled = SS::seam_transitions(here.mesh, test_meshes::uv_map(here.mesh));
    CHECK_IN(context, scaled.cut_halfedges() == transitions.cut_halfedges());
    CHECK_IN(context, scaled.singular_vertices() == transitions.singular_vertices());
    here = snapped(here, context);
    Named_mesh<Kernel> there = transformed(expected, scale);
    CHECK_IN(context, all_bits(here.mesh, test_meshes::uv_map(here.mesh))
                        == all_bits(there.mesh, test_meshes::uv_map(there.mesh)));
  }
  Named_mesh<Kernel> copy = input;
  const double size = extent(copy.mesh, test_meshes::uv_map(copy.mesh));
  // down to subnormal numbers of few bits, up to the largest that are accepted
  for(const double scale : { 4e-318, 3e-310, 7e-308, 1e-300, 1e-150, 3e-7, 3e7, 1e150, 3e299 }) {
    const std::string context = original.name + " of size " + std::to_string(std::log10(scale));
    copy = transformed(input, [&](double x) { return x / size * scale; });
    const auto result = snap_and_check(copy, context);
    CHECK_IN(context, result.report.largest_change <= 1e-4 * scale);
  }
}

void test_offsets(const Named_mesh<Kernel>& original, unsigned int seed)
{
  Named_mesh<Kernel> exact = original;
  test_meshes::warp(exact, seed);
  const auto exact_uv = test_meshes::uv_map(exact.mesh);
  const Truth<Mesh, std::decay_t<decltype(exact_uv)> > truth(exact.mesh, exact_uv);
  for(const double offset : { 1e6, -3e9 }) {
    const std::string context = original.name + " moved by " + std::to_string(offset);
    const double noise = 1e-9 * truth.extent;
    const double rounding = std::abs(offset) * truth.extent * 0x1p-52;
    Named_mesh<Kernel> named = exact;
    uv_noise::perturb(named.mesh, test_meshes::uv_map(named.mesh), noise, seed);
    named = transformed(named, [&](double x) { return x + offset * truth.extent; });
    const auto uv = test_meshes::uv_map(named.mesh);
    const bool is_clear = truth.is_clear_with(noise + rounding);
    if(is_clear)
      check_transitions(exact.mesh, truth, SS::seam_transitions(named.mesh, uv), context);
    const auto result = snap_and_check(named, context);
    CHECK_IN(context, result.report.largest_change <= 8 * (noise + rounding) || !is_clear);
  }
}

// --- nothing to do -------------------------------------------------------------------------------

void test_exact_input(const Named_mesh<Kernel>& original, unsigned int seed)
{
  Named_mesh<Kernel> named = original;
  test_meshes::warp(named, seed);
  const auto result = snap_and_check(named, named.name + ", exact");
  CHECK_IN(named.name, result.report.status == SS::Outcome::ALREADY_EXACT);
  CHECK_IN(named.name, result.before == result.after);
}

int main()
{
  const Floating_point_traps traps; // for all functions that are called
  std::cout.precision(3);
  unsigned int seed = 0;
  test_refused_soups();
  test_names_of_soup_vertices();
  for(const Named_mesh<Kernel>& named : test_meshes::all_meshes<Kernel>()) {
    for(int round = 0; round < 20; ++round)
      test_data_structures(named, ++seed);
    test_rounding_modes(named, seed);
    test_flushing_to_zero(named, seed);
    test_scales(named, ++seed);
    test_offsets(named, ++seed);
    test_exact_input(named, ++seed);
  }
  std::cout << "seeds 1 to " << seed << std::endl;
  return report_checks();
}
