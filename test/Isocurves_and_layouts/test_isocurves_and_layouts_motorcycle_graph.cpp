// Tests of motorcycle graphs and other layouts: on surfaces of squares, where much is known in
// advance, and on parametrizations that solvers made; all of what a partition into rectangles is
// made of is checked in rationals on each.

#include "Polyhedron_copy.h"
#include "foreign_locales.h"
#include "floating_point_traps.h"
#include "layout_checks.h"
#include "quad_reference.h"
#include "test_data.h"
#include "test_surfaces.h"

#include <CGAL/Isocurves_and_layouts/copy_to_face_graph.h>
#include <CGAL/Isocurves_and_layouts/Motorcycle_graph.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/IO/PLY.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <string>

using namespace layout_checks;
using quad_reference::Grid_map;
using quad_reference::Kernel;
using quad_reference::Mesh;
using quad_reference::Point_2;
using square_complex::Square_complex;
namespace surfaces = test_meshes;
namespace parameters = IL::parameters;
using IL::Layout_node;
using IL::Outcome;
using Graph = IL::Motorcycle_graph<Mesh>;
using Meeting = IL::Curve_meeting<Mesh>;
using Vertex_set = Mesh::Property_map<Mesh::Vertex_index, bool>;

std::size_t number_of(const Graph& graph, const Layout_node kind)
{
  std::size_t result = 0;
  for(std::size_t n = 0; n < graph.number_of_nodes(); ++n)
    result += graph.node_kind(n) == kind ? 1 : 0;
  return result;
}

// Curves end or not by a rule without any sense, but always the same.
bool ends_at_random(const Meeting& m)
{
  const double x = CGAL::to_double(m.length) * 7 + CGAL::to_double(m.other_length) * 3;
  return std::lround(std::fmod(std::abs(x) * 16, 5)) != 2;
}

// --- surfaces of squares -------------------------------------------------------------------------

// Layouts whose curves don't end as those of the motorcycle graph do.
template <typename NamedParameters>
void check_other_policies(const Grid_map& map, const NamedParameters& np,
                          const std::string& context)
{
  check_layout(map.mesh, map.uv, map.is_feature,
               IL::motorcycle_graph(map.mesh, map.uv, np.curve_stop_policy(IL::Run_to_nodes())),
               context + ", base complex");
  check_layout(map.mesh, map.uv, map.is_feature,
               IL::motorcycle_graph(map.mesh, map.uv, np.curve_stop_policy(&ends_at_random)),
               context + ", random policy");
}

void check_all_policies(const Grid_map& map, const std::string& context)
{
  const auto np = parameters::edge_is_constrained_map(map.is_feature);
  check_motorcycle_graph(map.mesh, map.uv, map.is_feature,
                         IL::motorcycle_graph(map.mesh, map.uv, np), context);
  check_other_policies(map, np, context);
}

void test_surface(const std::string& name, const Square_complex& complex)
{
  for(const auto& [side, n] : {std::pair{4, 4}, {3, 8}})
    for(const unsigned seed : {0u, 1u, 2u}) {
      Grid_map map(complex, side, n);
      if(seed > 0)
        map.perturb(seed, 0.4 * side / n, seed == 1 ? 3 : 30);
      check_all_policies(map, name + ", seed " + std::to_string(seed));
    }
}

Square_complex with_all_features()
{
  Square_complex result = surfaces::disc(5, 5);
  surfaces::mark_all_kinds_of_features(result);
  return result;
}

void test_surfaces()
{
  test_surface("cube", surfaces::box(1, 1, 1));
  test_surface("box", surfaces::box(2, 1, 3));
  test_surface("notched cube", surfaces::notched_cube());
  test_surface("double torus", surfaces::double_torus());
  test_surface("box with holes", surfaces::box_with_holes());
  test_surface("disc", surfaces::disc(3, 2));
  test_surface("torus", surfaces::torus(1, 2));
  test_surface("genus 2", surfaces::genus_2());
  test_surface("tetrahedron", surfaces::tetrahedron());
  test_surface("cylinder", surfaces::cylinder(2, 3));
  test_surface("pair of pants", surfaces::pair_of_pants());
  test_surface("two islands", surfaces::two_islands());
  test_surface("island", surfaces::island(1, {{3, 5}}, true));
  test_surface("features", with_all_features());
  for(const int quarter_turns : {1, 2, 3, 5, 8})
    test_surface("cone ring " + std::to_string(quarter_turns), surfaces::cone_ring(quarter_turns));
  Square_complex scattered = surfaces::double_torus();
  surfaces::scatter_charts(scattered);
  test_surface("scattered", scattered);
  Square_complex creased = surfaces::box(1, 2, 1);
  surfaces::mark_creases(creased);
  test_surface("creases", creased);
  Square_complex parts = surfaces::box(1, 1, 1);
  parts.append(surfaces::disc(2, 2));
  parts.append(surfaces::torus(2, 1));
  parts.append(surfaces::double_torus());
  test_surface("parts", parts);
}

// Features that divide a surface into rings. One of them has a node, or none.
void test_rings()
{
  Square_complex belts = surfaces::cylinder(2, 4);
  for(int x = 0; x < 2; ++x)
    for(const int y : {1, 2, 3})
      belts.set_feature(2 * y + x, 0);
  test_surface("belts", belts);
  Square_complex torus = surfaces::torus(2, 3);
  for(int x = 0; x < 2; ++x)
    for(const int y : {0, 1})
      torus.set_feature(2 * y + x, 0);
  test_surface("torus with belts", torus);
  for(const auto& complex : {belts, torus})
    for(const unsigned seed : {1u, 2u, 3u}) {
      Grid_map map(complex, 4, 8);
      map.perturb(seed, 0.2, 20);
      auto is_given = map.mesh.add_property_map<Mesh::Vertex_index, bool>("v:given", false).first;
      is_given[Mesh::Vertex_index(unsigned(std::mt19937(seed)() % map.mesh.number_of_vertices()))] =
        true;
      const Graph graph = IL::motorcycle_graph(
        map.mesh, map.uv,
        parameters::edge_is_constrained_map(map.is_feature).vertex_is_constrained_map(is_given));
      check_motorcycle_graph(map.mesh, map.uv, map.is_feature, graph, "rings");
      CHECK(number_of(graph, Layout_node::SEED) > 0);
    }
}

// A square above the middle of the upper side of a wider one. Their common vertex is a corner of
// the former; it is a node for the latter only if it is given.
void test_several_fans()
{
  Mesh mesh;
  const auto uv = square_complex::uv_map(mesh);
  auto is_given = mesh.add_property_map<Mesh::Vertex_index, bool>("v:given", false).first;
  const auto vertex = [&](const double x, const double y)
    { return mesh.add_vertex(Kernel::Point_3(x, y, 0)); };
  const auto middle = vertex(1, 2), left = vertex(0, 0), right = vertex(2, 0);
  mesh.add_face(left, right, middle);
  mesh.add_face(left, middle, vertex(0, 2));
  mesh.add_face(right, vertex(2, 2), middle);
  const auto opposite = vertex(2, 3);
  mesh.add_face(middle, vertex(2, 2), opposite);
  mesh.add_face(middle, opposite, vertex(1, 3));
  for(const auto h : mesh.halfedges())
    uv[h] = Point_2(mesh.point(mesh.target(h)).x(), mesh.point(mesh.target(h)).y());
  const auto np = parameters::vertex_is_constrained_map(is_given);
  const Graph graph = IL::motorcycle_graph(mesh, uv, np);
  CHECK_EQUAL(graph.number_of_nodes(), std::size_t(8));
  CHECK_EQUAL(graph.number_of_patches(), std::size_t(2));
  is_given[middle] = true;
  const Graph second = IL::motorcycle_graph(mesh, uv, np);
  CHECK_EQUAL(second.number_of_nodes(), std::size_t(10)); // one more at the lower side
  CHECK_EQUAL(second.number_of_patches(), std::size_t(3));
  Mesh refined;
  CHECK(IL::refine_along_arcs(second, refined) && CGAL::is_valid_polygon_mesh(refined));
  CHECK_EQUAL(std::size_t(refined.number_of_vertices()), std::size_t(10));
}

// Each square is a patch, where all vertices of squares are nodes.
void check_counts(const Square_complex& complex, const std::size_t nodes, const std::size_t arcs,
                  const std::size_t patches)
{
  Grid_map map(complex, 10, 8);
  map.perturb(5, 0.3, 20);
  const Graph graph = IL::motorcycle_graph(map.mesh, map.uv);
  CHECK_EQUAL(graph.number_of_nodes(), nodes);
  CHECK_EQUAL(graph.number_of_arcs(), arcs);
  CHECK_EQUAL(graph.number_of_patches(), patches);
  CHECK_EQUAL(number_of(graph, Layout_node::JUNCTION), std::size_t(0));
  for(std::size_t p = 0; p < graph.number_of_patches(); ++p)
    CHECK(graph.patch_width(p) == 10 && graph.patch_height(p) == 10);
}

void test_known_counts()
{
  check_counts(surfaces::box(1, 1, 1), 8, 12, 6);
  check_counts(surfaces::tetrahedron(), 4, 4, 2);
  check_counts(surfaces::torus(1, 1), 1, 2, 1);
  check_counts(surfaces::genus_2(), 1, 6, 3);
  check_counts(surfaces::disc(1, 1), 4, 4, 1);
}

// --- who ends ------------------------------------------------------------------------------------

Mesh::Vertex_index vertex_at(const Grid_map& map, const double u, const double v)
{
  for(const auto h : map.mesh.halfedges())
    if(!map.mesh.is_border(h) && map.uv[h] == Point_2(u, v))
      return map.mesh.target(h);
  CHECK(false);
  return Mesh::null_vertex();
}

// On a square with sides of 8 units.
struct Square_with_nodes
{
  Grid_map map{surfaces::disc(1, 1), 8, 8};
  Vertex_set is_given = map.mesh.add_property_map<Mesh::Vertex_index, bool>("v:given", false).first;

  explicit Square_with_nodes(const std::vector<std::array<double, 2> >& nodes)
  {
    for(const auto& [u, v] : nodes)
      is_given[vertex_at(map, u, v)] = true;
  }

  Graph graph() const
  {
    return IL::motorcycle_graph(map.mesh, map.uv, parameters::vertex_is_constrained_map(is_given));
  }

  void check(const Graph& graph, const std::string& context) const
  { check_motorcycle_graph(map.mesh, map.uv, map.is_feature, graph, context); }
};

// Degrees of the nodes at these coordinates; 0 where there is none.
std::size_t degree_at(const Graph& graph, const Exact_rational& u, const Exact_rational& v)
{
  for(std::size_t n = 0; n < graph.number_of_nodes(); ++n)
    if(graph.node_coordinates(n) == std::array<Exact_rational, 2>{u, v})
      return graph.half_arcs_around_node(n).size();
  return 0;
}

// Whether an arc leads from one node to another.
bool has_arc_to(const Graph& graph, const std::array<Exact_rational, 2>& from,
                const std::array<Exact_rational, 2>& to)
{
  for(std::size_t h = 0; h < 2 * graph.number_of_arcs(); ++h)
    if(graph.node_coordinates(graph.source(h)) == from &&
       graph.node_coordinates(graph.target(h)) == to)
      return true;
  return false;
}

void test_right_of_way()
{
  // Both curves that meet have the same length: they come to (5, 3) from the left and from above,
  // to (3, 5) from below and from the right.
  const Square_with_nodes ties({{3, 3}, {5, 5}});
  const Graph graph = ties.graph();
  ties.check(graph, "ties");
  CHECK_EQUAL(degree_at(graph, 5, 3), std::size_t(3));
  CHECK_EQUAL(degree_at(graph, 3, 5), std::size_t(3));
  CHECK(has_arc_to(graph, {5, 3}, {8, 3})); // who comes from above sees the other at the right
  CHECK(!has_arc_to(graph, {5, 3}, {5, 0}));
  CHECK(has_arc_to(graph, {3, 5}, {0, 5}));
  CHECK(!has_arc_to(graph, {3, 5}, {3, 8}));
  CHECK_EQUAL(number_of(graph, Layout_node::GIVEN), std::size_t(2));

  // The nearer one is there before, whatever the side.
  const Square_with_nodes earlier({{4, 3}, {5, 5}});
  const Graph second = earlier.graph();
  earlier.check(second, "sooner");
  CHECK(has_arc_to(second, {5, 3}, {8, 3}) && !has_arc_to(second, {5, 3}, {5, 0}));
  CHECK(has_arc_to(second, {4, 5}, {0, 5}) && !has_arc_to(second, {4, 5}, {4, 8}));

  // Four at once, two by two head on: all of them end, or two arcs cross, which is the same.
  const Square_with_nodes four({{4, 2}, {6, 4}, {4, 6}, {2, 4}});
  const Graph third = four.graph();
  four.check(third, "four at once");
  CHECK_EQUAL(degree_at(third, 4, 4), std::size_t(4));

  // Three at once.
  const Square_with_nodes three({{4, 2}, {6, 4}, {4, 6}});
  const Graph fourth = three.graph();
  three.check(fourth, "three");
  CHECK_EQUAL(degree_at(fourth, 4, 4), std::size_t(3));
  CHECK(!has_arc_to(fourth, {4, 4}, {0, 4}));

  // Head on, off the middle: no node between both; and a third one that comes where they met.
  const Square_with_nodes head_on({{1, 4}, {6, 4}});
  const Graph fifth = head_on.graph();
  head_on.check(fifth, "head on");
  CHECK(has_arc_to(fifth, {1, 4}, {6, 4}));
  const Square_with_nodes later({{2, 4}, {6, 4}, {4, 1}});
  const Graph sixth = later.graph();
  later.check(sixth, "later");
  CHECK_EQUAL(degree_at(sixth, 4, 4), std::size_t(3));
  CHECK(!has_arc_to(sixth, {4, 4}, {4, 8}));
}

// Many nodes at random: crossings of all kinds, in faces, on edges, and at vertices.
void test_given_nodes()
{
  std::mt19937_64 random(11);
  for(const auto& complex : {surfaces::disc(2, 2), surfaces::box(1, 1, 1), surfaces::torus(2, 1),
                             surfaces::genus_2(), surfaces::cylinder(2, 2), with_all_features()})
    for(int run = 0; run < 12; ++run) {
      Grid_map map(complex, 4, 4);
      map.perturb(unsigned(run), 0.4, run % 3 == 0 ? 1 : run % 3 == 1 ? 3 : 20);
      auto is_given = map.mesh.add_property_map<Mesh::Vertex_index, bool>("v:given", false).first;
      for(int k = 0; k <= run; ++k)
        is_given[Mesh::Vertex_index(unsigned(random() % map.mesh.number_of_vertices()))] = true;
      const auto np = parameters::edge_is_constrained_map(map.is_feature)
                        .vertex_is_constrained_map(is_given);
      const std::string context = "given nodes, run " + std::to_string(run);
      check_motorcycle_graph(map.mesh, map.uv, map.is_feature,
                             IL::motorcycle_graph(map.mesh, map.uv, np), context);
      check_other_policies(map, np, context);
    }
}

// --- borders that lie on no isocurve -------------------------------------------------------------

// A part of the plane, whose coordinates are those of the points.
struct Flat_mesh
{
  Mesh mesh;
  quad_reference::UV_map uv = square_complex::uv_map(mesh);
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature = square_complex::feature_map(mesh);
  Vertex_set is_given = mesh.add_property_map<Mesh::Vertex_index, bool>("v:given", false).first;

  Flat_mesh(const std::vector<std::array<double, 2> >& points,
            const std::vector<std::array<unsigned, 3> >& triangles)
  {
    for(const auto& p : points)
      mesh.add_vertex(Kernel::Point_3(p[0], p[1], 0));
    for(const auto& t : triangles)
      mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
    for(const auto h : mesh.halfedges())
      uv[h] = Point_2(mesh.point(mesh.target(h)).x(), mesh.point(mesh.target(h)).y());
  }
  Flat_mesh(const Flat_mesh&) = delete;

  Graph graph(const std::vector<unsigned>& nodes)
  {
    for(const unsigned v : nodes)
      is_given[Mesh::Vertex_index(v)] = true;
    const Graph result = IL::motorcycle_graph(
      mesh, uv, parameters::vertex_is_constrained_map(is_given));
    check_motorcycle_graph(mesh, uv, is_feature, result, "flat mesh");
    return result;
  }
};

void test_known_oblique_borders()
{
  // A right triangle. Its corners are nodes, but no curve leaves them into it.
  const std::vector<std::array<double, 2> > triangle = {{0, 0}, {8, 0}, {0, 8}, {4, 4}, {2, 4},
                                                        {4, 2}};
  const std::vector<std::array<unsigned, 3> > faces = {{0, 1, 5}, {5, 1, 3}, {0, 5, 4}, {4, 5, 3},
                                                       {0, 4, 2}, {4, 3, 2}};
  const Graph whole = Flat_mesh(triangle, faces).graph({});
  CHECK_EQUAL(whole.number_of_arcs(), std::size_t(3));
  CHECK_EQUAL(whole.number_of_cut_patches(), std::size_t(1));
  CHECK(whole.patch_area(0) == 32);
  CHECK_IN(whole.message(), whole.message().find("2 border edges do not lie") == 0);
  // The middle of the long side: a square, and two triangles.
  Flat_mesh middle(triangle, faces);
  const Graph halved = middle.graph({3});
  CHECK_EQUAL(halved.number_of_patches(), std::size_t(3));
  CHECK_EQUAL(halved.number_of_cut_patches(), std::size_t(2));
  CHECK_EQUAL(degree_at(halved, 4, 4), std::size_t(4));
  // Two curves that come to the middle at the same time.
  Flat_mesh both(triangle, faces);
  const Graph meeting = both.graph({4, 5});
  CHECK_EQUAL(degree_at(meeting, 4, 4), std::size_t(4));
  CHECK_EQUAL(degree_at(meeting, 2, 6), std::size_t(3));
  // Both at an inner point of an edge, at coordinates that are no binary numbers.
  Flat_mesh third({{0, 0}, {3, 0}, {0, 7}, {1, 1}}, {{0, 1, 3}, {3, 1, 2}, {0, 3, 2}});
  const Graph thirds = third.graph({3});
  CHECK_EQUAL(degree_at(thirds, Exact_rational(18) / 7, 1), std::size_t(3));
  CHECK_EQUAL(degree_at(thirds, 1, Exact_rational(14) / 3), std::size_t(3));
  CHECK_EQUAL(thirds.number_of_patches(), std::size_t(4));
  CHECK_EQUAL(thirds.number_of_cut_patches(), std::size_t(3));

  // A dent, to whose vertex two curves come: between them, the patch has 270 degrees.
  Flat_mesh dent({{-4, -4}, {4, -4}, {4, 1}, {0, 0}, {1, 4}, {-4, 4}, {0, 2}, {2, 0}},
                 {{0, 1, 3}, {1, 2, 7}, {7, 2, 3}, {1, 7, 3}, {3, 4, 6}, {6, 4, 5}, {3, 6, 5},
                  {0, 3, 5}});
  const Graph around = dent.graph({6, 7});
  CHECK_EQUAL(degree_at(around, 0, 0), std::size_t(4));
  std::size_t number = 0; // of patches of an L
  for(std::size_t p = 0; p < around.number_of_patches(); ++p)
    number += around.patch_is_cut(p) && around.patch_area(p) == 32 ? 1 : 0;
  CHECK_EQUAL(number, std::size_t(1));
}

// Holes in maps: faces around vertices are removed, as far as the holes don't touch anything.
void make_holes(Grid_map& map, const int number, const unsigned seed)
{
  std::mt19937_64 random(seed);
  const std::vector<Mesh::Vertex_index> vertices(map.mesh.vertices().begin(),
                                                 map.mesh.vertices().end());
  for(int k = 0; k < number; ++k) {
    const auto center = vertices[random() % vertices.size()];
    if(map.mesh.is_removed(center))
      continue;
    std::set<Mesh::Face_index> star;
    std::set<Mesh::Vertex_index> link;
    bool is_free = true;
    for(const auto h : map.mesh.halfedges_around_target(map.mesh.halfedge(center))) {
      is_free = is_free && !map.mesh.is_border(h) && link.insert(map.mesh.source(h)).second &&
                map.mesh.source(h) != center && !map.mesh.is_border(map.mesh.source(h), true);
      if(is_free)
        star.insert(map.mesh.face(h));
    }
    if(is_free && star.size() == link.size() && star.size() < map.mesh.number_of_faces())
      for(const auto f : star)
        CGAL::Euler::remove_face(map.mesh.halfedge(f), map.mesh);
  }
  map.mesh.collect_garbage();
}

void test_holes()
{
  std::size_t number = 0, cut = 0, not_discs = 0;
  for(const auto& [name, complex] :
      {std::pair{"disc", surfaces::disc(2, 2)}, {"box", surfaces::box(1, 1, 1)},
       {"torus", surfaces::torus(2, 1)}, {"genus 2", surfaces::genus_2()},
       {"cylinder", surfaces::cylinder(2, 2)}, {"features", with_all_features()},
       {"double torus", surfaces::double_torus()}, {"cone ring", surfaces::cone_ring(3)}})
    for(int run = 0; run < 12; ++run) {
      Grid_map map(complex, 4, 4);
      if(run % 3 != 0)
        map.perturb(unsigned(run), 0.4, run % 3 == 1 ? 3 : 30);
      make_holes(map, 1 + run, unsigned(run));
      const std::string context = name + std::string(" with holes, run ") + std::to_string(run);
      const auto np = parameters::edge_is_constrained_map(map.is_feature);
      const Graph graph = IL::motorcycle_graph(map.mesh, map.uv, np);
      check_motorcycle_graph(map.mesh, map.uv, map.is_feature, graph, context);
      check_other_policies(map, np, context);
      number += graph.number_of_patches();
      cut += graph.number_of_cut_patches();
      for(std::size_t p = 0; p < graph.number_of_patches(); ++p)
        not_discs += graph.patch_euler_characteristic(p) != 1 ? 1 : 0;
    }
  CHECK(0 < not_discs && not_discs < cut && cut < number);
  std::cout << "with holes: " << number << " patches, " << cut << " of them cut, " << not_discs
            << " of these no discs" << std::endl;
}

// --- integer lengths -----------------------------------------------------------------------------

void test_integer_lengths()
{
  Grid_map map(surfaces::notched_cube(), 3, 4); // lengths are odd multiples of 3
  const Graph graph = IL::motorcycle_graph(map.mesh, map.uv);
  const IL::Integer_arc_lengths integers = IL::integer_arc_lengths(graph);
  CHECK(integers.unit == 1);
  bool is_any_odd = false;
  for(std::size_t a = 0; a < graph.number_of_arcs(); ++a) {
    CHECK(graph.arc_length(a) == Exact_rational(integers.lengths[a]) * integers.unit);
    is_any_odd = is_any_odd || integers.lengths[a] % 2 != 0;
  }
  CHECK(is_any_odd);
  CHECK(IL::are_lengths_consistent(graph, integers.lengths));
  auto other = integers.lengths;
  other.front() += 1;
  CHECK(!IL::are_lengths_consistent(graph, other));

  for(const auto h : map.mesh.halfedges())
    map.uv[h] = Point_2(map.uv[h].x() / 64, map.uv[h].y() / 64);
  const auto finer = IL::integer_arc_lengths(IL::motorcycle_graph(map.mesh, map.uv));
  CHECK(finer.unit * 64 == integers.unit);
  CHECK(finer.lengths == integers.lengths);
}

// Of rectangles: positive multiples of the unit, of which no larger one would do; opposite sides
// agree.
void check_integer_lengths(const Graph& graph, const std::string& context)
{
  using CGAL::Exact_integer;
  const IL::Integer_arc_lengths integers = IL::integer_arc_lengths(graph);
  bool is_any_odd = false;
  for(std::size_t a = 0; a < graph.number_of_arcs(); ++a) {
    bool bounds_rectangle = false;
    for(const std::size_t h : {2 * a, 2 * a + 1})
      bounds_rectangle =
        bounds_rectangle ||
        (graph.patch(h) != Graph::null_patch && !graph.patch_is_cut(graph.patch(h)));
    const Exact_integer& length = integers.lengths[a];
    CHECK_IN(context, bounds_rectangle
                        ? length > 0 &&
                            graph.arc_length(a) == Exact_rational(length) * integers.unit
                        : length == 0);
    is_any_odd = is_any_odd || Exact_integer(length % 2) != 0;
  }
  std::size_t rectangles = 0;
  for(std::size_t p = 0; p < graph.number_of_patches(); ++p) {
    if(graph.patch_is_cut(p))
      continue;
    ++rectangles;
    std::array<Exact_integer, 4> sides;
    for(std::size_t s = 0; s < 4; ++s) {
      sides[s] = 0;
      for(const std::size_t h : graph.patch_side(p, s))
        sides[s] += integers.lengths[Graph::arc(h)];
    }
    CHECK_IN(context, sides[0] == sides[2] && sides[1] == sides[3] && sides[0] > 0 && sides[1] > 0);
  }
  CHECK_IN(context, is_any_odd || rectangles == 0);
  CHECK_IN(context, IL::are_lengths_consistent(graph, integers.lengths));
}

// --- the same graph for any numbering and mesh data structure ------------------------------------

// The same mesh with faces, corners, and vertices in another order.
struct Renumbered
{
  Mesh mesh;
  quad_reference::UV_map uv = square_complex::uv_map(mesh);
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature = square_complex::feature_map(mesh);

  Renumbered(const Mesh& original, const quad_reference::UV_map& original_uv,
             const Mesh::Property_map<Mesh::Edge_index, bool>& features, const unsigned seed)
  {
    std::mt19937_64 random(seed);
    std::vector<Mesh::Vertex_index> order(original.vertices().begin(), original.vertices().end());
    std::shuffle(order.begin(), order.end(), random);
    std::map<Mesh::Vertex_index, Mesh::Vertex_index> copy;
    for(const auto v : order)
      copy[v] = mesh.add_vertex(original.point(v));
    std::vector<Mesh::Face_index> triangles(original.faces().begin(), original.faces().end());
    std::shuffle(triangles.begin(), triangles.end(), random);
    for(const auto f : triangles) {
      auto h = original.halfedge(f);
      for(std::size_t k = random() % 3; k > 0; --k)
        h = original.next(h);
      const auto g = original.next(h), i = original.next(g);
      mesh.add_face(copy[original.target(h)], copy[original.target(g)], copy[original.target(i)]);
    }
    for(const auto h : original.halfedges()) {
      const auto c = mesh.halfedge(copy[original.source(h)], copy[original.target(h)]);
      uv[c] = original_uv[h];
      is_feature[mesh.edge(c)] = features[original.edge(h)];
    }
  }
  Renumbered(const Renumbered&) = delete;
};

void check_numbering(const Mesh& mesh, const quad_reference::UV_map& uv,
                     const Mesh::Property_map<Mesh::Edge_index, bool>& features,
                     const std::string& context)
{
  const Graph graph =
    IL::motorcycle_graph(mesh, uv, parameters::edge_is_constrained_map(features));
  for(const unsigned seed : {1u, 2u}) {
    const Renumbered other(mesh, uv, features, seed);
    const Graph renumbered = IL::motorcycle_graph(
      other.mesh, other.uv, parameters::edge_is_constrained_map(other.is_feature));
    CHECK_IN(context, bool(renumbered) && shape(graph) == shape(renumbered));
    CHECK_IN(context,
             graph.number_of_visited_segments() == renumbered.number_of_visited_segments());
  }
}

void test_numbering()
{
  for(const auto& complex : {surfaces::box(2, 1, 3), surfaces::double_torus(), surfaces::disc(3, 2),
                             surfaces::notched_cube(), with_all_features()}) {
    Grid_map map(complex, 4, 4);
    check_numbering(map.mesh, map.uv, map.is_feature, "aligned");
    map.perturb(3, 0.3, 20);
    check_numbering(map.mesh, map.uv, map.is_feature, "perturbed");
    make_holes(map, 12, 4);
    check_numbering(map.mesh, map.uv, map.is_feature, "with holes");
    const surfaces::Polyhedron_copy<Kernel> copy(map.mesh);
    const auto graph = IL::motorcycle_graph(
      copy.polyhedron, copy.uv, parameters::edge_is_constrained_map(copy.is_feature));
    CHECK(shape(graph) == shape(IL::motorcycle_graph(
                            map.mesh, map.uv,
                            parameters::edge_is_constrained_map(map.is_feature))));
  }
}

// --- what is refused -----------------------------------------------------------------------------

void check_refusal(const Graph& graph, const Outcome status, const std::string& word)
{
  CHECK_EQUAL(graph.status(), status);
  CHECK_IN(graph.message(), graph.message().find(word) != std::string::npos);
  CHECK_EQUAL(graph.number_of_nodes() + graph.number_of_arcs() + graph.number_of_patches(),
              std::size_t(0));
}

void test_refusals()
{
  Grid_map box(surfaces::box(1, 1, 1), 4, 4);
  const auto h = *box.mesh.halfedges().begin();
  const Point_2 good = box.uv[h];
  box.uv[h] = Point_2(std::nextafter(good.x(), 100), good.y());
  check_refusal(IL::motorcycle_graph(box.mesh, box.uv), Outcome::NOT_SEAMLESS,
                "snap_to_seamless");
  box.uv[h] = Point_2(std::numeric_limits<double>::quiet_NaN(), 0);
  check_refusal(IL::motorcycle_graph(box.mesh, box.uv), Outcome::NOT_FINITE, "face");
  box.uv[h] = good;
  const auto unfinished = IL::motorcycle_graph(box.mesh, box.uv, parameters::maximum_number(20));
  check_refusal(unfinished, Outcome::TOO_LARGE, "maximum_number");
  CHECK(unfinished.number_of_visited_segments() > 0);
  CHECK(bool(IL::motorcycle_graph(box.mesh, box.uv)));

  Grid_map mirrored(surfaces::box(1, 1, 1), 4, 4);
  for(const auto g : mirrored.mesh.halfedges())
    mirrored.uv[g] = Point_2(mirrored.uv[g].y(), mirrored.uv[g].x());
  check_refusal(IL::motorcycle_graph(mirrored.mesh, mirrored.uv), Outcome::NOT_POSITIVE,
                "exchange the two coordinates");

  Grid_map disc(surfaces::disc(2, 2), 4, 4);
  const auto seams = IL::seam_transitions(disc.mesh, disc.uv);
  const auto inner = disc.mesh.halfedge(vertex_at(disc, 3, 3));
  disc.move_vertex(seams, inner, Kernel::Vector_2(1.5, 0.25));
  const Graph flipped = IL::motorcycle_graph(disc.mesh, disc.uv);
  check_refusal(flipped, Outcome::NOT_POSITIVE, "repair_flips");
  CHECK(!flipped.nonpositive_faces().empty());
  for(const std::size_t f : flipped.nonpositive_faces()) {
    const auto g = disc.mesh.halfedge(Mesh::Face_index(unsigned(f)));
    CHECK(!disc.is_positive(g));
  }

  Grid_map bent(surfaces::disc(2, 2), 4, 4);
  for(const auto g : bent.mesh.halfedges())
    if(!bent.mesh.is_border(g) && bent.uv[g] == Point_2(8, 3))
      bent.uv[g] = Point_2(8.25, 3);
  check_refusal(IL::motorcycle_graph(bent.mesh, bent.uv, parameters::align_border(true)),
                Outcome::NOT_ALIGNED, "align_border");
  for(const auto e : bent.mesh.edges())
    bent.is_feature[e] = bent.mesh.is_border(e);
  check_refusal(IL::motorcycle_graph(bent.mesh, bent.uv,
                                     parameters::edge_is_constrained_map(bent.is_feature)),
                Outcome::NOT_ALIGNED, "on the border");
  Grid_map diagonal(surfaces::disc(2, 2), 4, 4);
  for(const auto e : diagonal.mesh.edges()) {
    auto g = diagonal.mesh.halfedge(e);
    g = diagonal.mesh.is_border(g) ? diagonal.mesh.opposite(g) : g;
    const Point_2 a = diagonal.uv[g], b = diagonal.uv[diagonal.mesh.prev(g)];
    if(a.x() != b.x() && a.y() != b.y()) {
      diagonal.is_feature[e] = true;
      break;
    }
  }
  const Graph misaligned = IL::motorcycle_graph(
    diagonal.mesh, diagonal.uv, parameters::edge_is_constrained_map(diagonal.is_feature));
  check_refusal(misaligned, Outcome::NOT_ALIGNED, "edge_is_constrained_map");
  CHECK(misaligned.message().find("1 border or feature edge does not") == 0);

  Mesh quad;
  const auto uv = square_complex::uv_map(quad);
  std::vector<Mesh::Vertex_index> corners;
  for(int i = 0; i < 4; ++i)
    corners.push_back(quad.add_vertex(Kernel::Point_3(i, i * i, 0)));
  quad.add_face(corners);
  check_refusal(IL::motorcycle_graph(quad, uv), Outcome::NOT_TRIANGULAR, "face 0");
}

// --- parametrizations that solvers made ----------------------------------------------------------

struct File
{
  Mesh mesh;
  quad_reference::UV_map uv = square_complex::uv_map(mesh);
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature = square_complex::feature_map(mesh);

  explicit File(const std::string& path)
  {
    CHECK_IN(path, bool(IL::IO::read_OBJ(path, mesh, uv,
                                         parameters::edge_is_constrained_map(is_feature))));
  }
  File(const File&) = delete;
};

enum class Division { RECTANGLES, CUT_PATCHES, REFUSED };

// Two graphs, with features and without. A border that can't be aligned stays as it is.
Division test_file(const std::string& path, const bool with_features)
{
  File file(path);
  if(!with_features)
    for(const auto e : file.mesh.edges())
      file.is_feature[e] = false;
  const auto np = parameters::edge_is_constrained_map(file.is_feature);
  const auto options = np.repair_flips(IL::Flip_repair::UNTANGLE);
  auto report = IL::snap_to_seamless(file.mesh, file.uv, options.align_border(true));
  const bool is_aligned = report.status != IL::Outcome::NOT_ALIGNED;
  if(!is_aligned)
    report = IL::snap_to_seamless(file.mesh, file.uv, options);
  if(report.status == IL::Outcome::NOT_ALIGNED)
    return Division::REFUSED; // features on that border
  CHECK_IN(path, bool(report));
  const Graph graph = IL::motorcycle_graph(file.mesh, file.uv, np);
  if(!report.remaining_flips.empty()) {
    CHECK_IN(path, graph.status() == Outcome::NOT_POSITIVE);
    CHECK_EQUAL(graph.nonpositive_faces().size(), report.remaining_flips.size());
    if(with_features)
      std::cout << path << ": " << graph.message() << std::endl;
    return Division::REFUSED;
  }
  check_motorcycle_graph(file.mesh, file.uv, file.is_feature, graph, path);
  CHECK_IN(path, is_aligned == (graph.number_of_cut_patches() == 0));
  check_integer_lengths(graph, path);
  std::size_t segments = 0;
  for(std::size_t a = 0; a < graph.number_of_arcs(); ++a)
    segments += graph.arc_is_constrained(a) ? 0 : graph.arc_path(a).size() - 1;
  CHECK_IN(path, 2 * graph.number_of_visited_segments() <= 3 * segments);
  // Where all charts are the same, as in one of these maps, numbers decide which vertex is a seed.
  if(with_features && file.mesh.number_of_faces() < 5000 &&
     number_of(graph, Layout_node::SEED) == 0)
    check_numbering(file.mesh, file.uv, file.is_feature, path);
  return is_aligned ? Division::RECTANGLES : Division::CUT_PATCHES;
}

void test_files()
{
  for(const auto& path : test_data::package_files())
    for(const bool with_features : {false, true})
      test_file(path.string(), with_features);
  std::map<Division, std::size_t> numbers;
  for(const auto& path : test_data::fifth_of_further_files("uv", ".obj"))
    for(const bool with_features : {false, true})
      ++numbers[test_file(path.string(), with_features)];
  std::cout << numbers[Division::RECTANGLES] << " maps divided into rectangles, "
            << numbers[Division::CUT_PATCHES] << " with patches cut by a border, "
            << numbers[Division::REFUSED] << " with flips or features off isocurves" << std::endl;
}

void test_cube_file()
{
  const auto folder = test_data::further_data("uv", "the cube of 10 x 10 x 10");
  if(folder.empty())
    return;
  File file((folder / "mc_s01c_cube.obj").string());
  CHECK(bool(IL::snap_to_seamless(file.mesh, file.uv, parameters::integer_grid(true))));
  const Graph graph = IL::motorcycle_graph(file.mesh, file.uv);
  CHECK_EQUAL(graph.number_of_nodes(), std::size_t(8));
  CHECK_EQUAL(graph.number_of_arcs(), std::size_t(12));
  CHECK_EQUAL(graph.number_of_patches(), std::size_t(6));
  for(std::size_t p = 0; p < graph.number_of_patches(); ++p)
    CHECK(graph.patch_width(p) == 10 && graph.patch_height(p) == 10);
  for(const auto e : file.mesh.edges())
    file.is_feature[e] = false;
  check_numbering(file.mesh, file.uv, file.is_feature, "cube");
}

// All that is written about a map with a corner that is off: statuses, messages, files.
std::string all_texts(const std::string& path, const bool is_far)
{
  File file(path);
  std::ostringstream os;
  const auto h = file.mesh.halfedge(*file.mesh.faces().begin());
  file.uv[h] = Point_2(is_far ? 12345.5 : std::nextafter(file.uv[h].x(), 1e9), file.uv[h].y());
  const auto np = parameters::tolerance(1e-4);
  os << IL::snap_to_seamless(file.mesh, file.uv, np.integer_grid(true)) << '\n'
     << IL::snap_to_seamless(file.mesh, file.uv, np.align_border(true)) << '\n'
     << IL::snap_to_seamless(file.mesh, file.uv, parameters::tolerance(-1.5)) << '\n';
  const Graph refused = IL::motorcycle_graph(file.mesh, file.uv);
  os << refused.status() << ' ' << refused.message() << '\n'
     << IL::snap_to_seamless(file.mesh, file.uv, np) << '\n';
  const Graph graph = IL::motorcycle_graph(file.mesh, file.uv);
  os << graph.status() << ' ' << graph.message() << '\n'
     << IL::IO::write_layout(os, graph) << '\n'
     << IL::IO::write_OBJ(os, file.mesh, file.uv) << '\n'
     << IL::IO::write_PLY(os, file.mesh, file.uv) << '\n';
  return os.str();
}

void test_text()
{
  for(const auto& path : test_data::package_files())
    for(const bool is_far : {false, true})
      foreign_locales::check_text([&] { return all_texts(path.string(), is_far); }, path.string());
}

int main()
{
  const Floating_point_traps traps; // for all functions that are called
  std::cout.precision(17);
  test_known_counts();
  test_surfaces();
  test_rings();
  test_several_fans();
  test_right_of_way();
  test_given_nodes();
  test_known_oblique_borders();
  test_holes();
  test_integer_lengths();
  test_numbering();
  test_refusals();
  test_files();
  test_cube_file();
  test_text();
  return report_checks();
}
