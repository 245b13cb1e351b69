// Tests of patches: each is a rectangle of quads, each quad is in one, and they are those of the
// motorcycle graph, which is made by exact numbers, where each quad is a unit square. How quads are
// shaped. And which sharp edges are features, and which features are noise.

#include <CGAL/Quad_remeshing/measure_quad_shapes.h>
#include <CGAL/Quad_remeshing/quad_patches.h>
#include <CGAL/Quad_remeshing/remove_feature_noise.h>

#include "Polyhedron_copy.h"
#include "checking.h"
#include "feature_detection_checks.h"
#include "quad_reference.h"
#include "random_numbers.h"
#include "test_surfaces.h"

#include <CGAL/Isocurves_and_layouts/Motorcycle_graph.h>

#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/subdivision_method_3.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <limits>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

using namespace random_numbers;
namespace QR = CGAL::Quad_remeshing;
namespace surfaces = test_meshes;
namespace parameters = QR::parameters;
using quad_reference::Mesh;
using Halfedge = Mesh::Halfedge_index;
using Patches = QR::Quad_patches<Mesh>;
using Sizes = std::multiset<std::pair<std::size_t, std::size_t> >;

constexpr unsigned int seed = 1;

struct Quads
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature;

  explicit Quads(Mesh quads)
    : mesh(std::move(quads)),
      is_feature(mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first)
  { }
};

template <typename Number>
std::pair<std::size_t, std::size_t> sorted_size(const Number& width, const Number& height)
{
  return std::minmax({std::size_t(CGAL::to_double(width)), std::size_t(CGAL::to_double(height))});
}

Sizes sizes_of(const Patches& patches)
{
  Sizes result;
  for(const auto& p : patches.patches)
    result.insert(sorted_size(p.width, p.height));
  return result;
}

// Whether the grids of vertices make up the mesh, each quad once, with regular vertices inside; and
// whether the map of faces tells the same.
template <typename Quad_mesh, typename Face_patch_map>
bool is_partition(const Quad_mesh& mesh, const QR::Quad_patches<Quad_mesh>& patches,
                  const Face_patch_map& patch_of)
{
  using Vertex = typename boost::graph_traits<Quad_mesh>::vertex_descriptor;
  using Face = typename boost::graph_traits<Quad_mesh>::face_descriptor;
  std::set<Face> seen;
  for(std::size_t k = 0; k < patches.patches.size(); ++k) {
    const auto& patch = patches.patches[k];
    std::vector<Vertex> grid;
    QR::vertices_of_patch(patch, mesh, std::back_inserter(grid));
    if(grid.size() != (patch.width + 1) * (patch.height + 1))
      return false;
    const auto vertex = [&](const std::size_t i, const std::size_t j)
      { return grid[j * (patch.width + 1) + i]; };
    for(std::size_t j = 0; j < patch.height; ++j)
      for(std::size_t i = 0; i < patch.width; ++i) {
        const auto [h, exists] = CGAL::halfedge(vertex(i, j), vertex(i + 1, j), mesh);
        if(!exists || is_border(h, mesh) || get(patch_of, face(h, mesh)) != k ||
           target(next(h, mesh), mesh) != vertex(i + 1, j + 1) ||
           target(next(next(h, mesh), mesh), mesh) != vertex(i, j + 1) ||
           !seen.insert(face(h, mesh)).second)
          return false;
        if(i > 0 && j > 0 && degree(vertex(i, j), mesh) != 4)
          return false;
      }
  }
  return seen.size() == num_faces(mesh);
}

// By another algorithm, where no vertex had to be chosen.
template <typename Policy>
void compare_with_motorcycle_graph(const Quads& quads, const Patches& patches, const Policy& policy,
                                   std::size_t& number_of_comparisons, std::size_t& number_wrong)
{
  Mesh triangles(quads.mesh); // keeps indices
  const auto uv =
    triangles.add_property_map<Halfedge, quad_reference::Kernel::Point_2>("h:uv").first;
  const auto is_feature = triangles.property_map<Mesh::Edge_index, bool>("e:feature").first;
  for(const auto f : quads.mesh.faces()) {
    const Halfedge h = quads.mesh.halfedge(f), other = quads.mesh.next(quads.mesh.next(h));
    uv[h] = {1, 0};
    uv[quads.mesh.next(h)] = {1, 1};
    uv[other] = {0, 1};
    uv[quads.mesh.prev(h)] = {0, 0};
    const Halfedge diagonal = CGAL::Euler::split_face(h, other, triangles);
    uv[diagonal] = uv[other];
    uv[triangles.opposite(diagonal)] = uv[h];
    is_feature[triangles.edge(diagonal)] = false;
  }
  const auto graph = QR::motorcycle_graph(
    triangles, uv, parameters::edge_is_constrained_map(is_feature).curve_stop_policy(policy));
  CHECK(bool(graph));
  Sizes sizes;
  for(std::size_t p = 0; p < graph.number_of_patches(); ++p)
    sizes.insert(sorted_size(graph.patch_width(p), graph.patch_height(p)));
  std::size_t number_of_t_junctions = 0;
  for(std::size_t n = 0; n < graph.number_of_nodes(); ++n) {
    if(graph.node_kind(n) == QR::Layout_node::SEED)
      return;
    const auto around = graph.half_arcs_around_node(n);
    number_of_t_junctions +=
      graph.node_kind(n) == QR::Layout_node::JUNCTION && around.size() == 3 &&
      std::none_of(around.begin(), around.end(), [&](const std::size_t h) {
        return graph.patch(h) == graph.null_patch ||
               graph.patch(graph.opposite(h)) == graph.null_patch;
      });
  }
  ++number_of_comparisons;
  number_wrong += sizes == sizes_of(patches) &&
                  number_of_t_junctions == patches.number_of_t_junctions ? 0 : 1;
}

struct Figures
{
  std::size_t meshes = 0, comparisons = 0, wrong = 0, patches = 0, t_junctions = 0;
};

// Returns the patches of the motorcycle graph.
Patches test_both_policies(const Quads& quads, Figures& figures)
{
  const auto patch_of = get(CGAL::dynamic_face_property_t<std::size_t>(), quads.mesh);
  const auto np = parameters::edge_is_constrained_map(quads.is_feature).face_patch_map(patch_of);
  const Patches base = QR::quad_patches(quads.mesh, np.curve_stop_policy(QR::Run_to_nodes()));
  figures.wrong += base && is_partition(quads.mesh, base, patch_of) ? 0 : 1;
  const Patches result = QR::quad_patches(quads.mesh, np);
  figures.wrong += result && is_partition(quads.mesh, result, patch_of) &&
                   base.patches.size() >= result.patches.size() ? 0 : 1;
  compare_with_motorcycle_graph(quads, base, QR::Run_to_nodes(), figures.comparisons,
                                figures.wrong);
  compare_with_motorcycle_graph(quads, result, QR::Stop_at_curves(), figures.comparisons,
                                figures.wrong);
  ++figures.meshes;
  figures.patches += result.patches.size();
  figures.t_junctions += result.number_of_t_junctions;
  return result;
}

// --- random meshes -------------------------------------------------------------------------------

// Triangles or quads of a solid, of which some are divided, some edges are flipped, and some faces
// left out; then two rounds of Catmull and Clark's make quads, with long regular strips.
Mesh random_quads(Random& random)
{
  Mesh mesh;
  const quad_reference::Kernel::Point_3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  if(below(random, 2) == 0)
    CGAL::make_tetrahedron(o, x, y, z, mesh);
  else
    CGAL::make_icosahedron(mesh, o);
  const auto any_face = [&]
    { return Mesh::Face_index(unsigned(below(random, int(mesh.num_faces())))); };
  for(int i = below(random, 4); i > 0; --i)
    CGAL::Euler::add_center_vertex(mesh.halfedge(any_face()), mesh);
  for(int i = below(random, 12); i > 0; --i) {
    const Halfedge h = mesh.halfedge(any_face());
    const auto a = mesh.target(mesh.next(h)), b = mesh.target(mesh.next(mesh.opposite(h)));
    if(a != b && !CGAL::halfedge(a, b, mesh).second && mesh.degree(mesh.target(h)) > 3 &&
       mesh.degree(mesh.source(h)) > 3)
      CGAL::Euler::flip_edge(h, mesh);
  }
  for(int i = below(random, 3); i > 0 && mesh.number_of_faces() > 3; --i) {
    const auto f = any_face();
    if(!mesh.is_removed(f))
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  }
  mesh.collect_garbage();
  CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices(mesh);
  CGAL::Subdivision_method_3::CatmullClark_subdivision(
    mesh, CGAL::parameters::number_of_iterations(unsigned(1 + below(random, 2))));
  mesh.collect_garbage();
  return mesh;
}

void test_random_meshes()
{
  Random random(seed);
  Figures figures;
  for(int run = 0; run < 400; ++run) {
    Quads quads(random_quads(random));
    if(run % 2 == 1)
      for(const auto e : quads.mesh.edges())
        quads.is_feature[e] = below(random, 40) == 0;
    test_both_policies(quads, figures);
  }
  std::cout << figures.patches << " patches of " << figures.meshes << " meshes, "
            << figures.t_junctions << " T-junctions" << std::endl;
  CHECK_EQUAL(figures.wrong, std::size_t(0));
  CHECK(figures.comparisons > 2 * figures.meshes - 20);
  CHECK(figures.t_junctions > 500);
}

// --- surfaces whose patches are known ------------------------------------------------------------

Patches patches_of(const test_meshes::Square_complex& complex, const int side)
{
  Figures figures;
  const Quads quads(quad_reference::expected_quads(complex, side));
  const Patches result = test_both_policies(quads, figures);
  CHECK_EQUAL(figures.wrong, std::size_t(0));
  return result;
}

void test_known_surfaces()
{
  CHECK(sizes_of(patches_of(surfaces::disc(5, 3), 1)) == Sizes({{3, 5}}));
  CHECK(sizes_of(patches_of(surfaces::cylinder(7, 4), 1)) == Sizes({{4, 7}}));
  CHECK(sizes_of(patches_of(surfaces::torus(6, 5), 1)) == Sizes({{5, 6}}));
  CHECK(sizes_of(patches_of(surfaces::box(2, 3, 4), 2)) ==
        Sizes({{4, 6}, {4, 6}, {4, 8}, {4, 8}, {6, 8}, {6, 8}}));
}

// --- refusals, and other types of meshes ---------------------------------------------------------

void test_refusals()
{
  Mesh mesh;
  CHECK(QR::quad_patches(mesh).status == QR::Outcome::INVALID_ARGUMENT);
  const quad_reference::Kernel::Point_3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  CGAL::make_quad(o, x, y, z, mesh);
  CHECK(bool(QR::quad_patches(mesh)));
  CGAL::make_triangle(o, x, y, mesh);
  const Patches refused = QR::quad_patches(mesh);
  CHECK(refused.status == QR::Outcome::INVALID_ARGUMENT && refused.patches.empty());
  CHECK(refused.message.find("face 1 has 3 sides") != std::string::npos);

  Mesh pinched;
  const auto v = pinched.add_vertex(o);
  const auto add = [&] { return pinched.add_vertex(o); };
  for(int i = 0; i < 2; ++i) {
    const auto a = add(), b = add(), c = add();
    pinched.add_face(v, a, b, c);
  }
  const Patches several = QR::quad_patches(pinched);
  CHECK(several.status == QR::Outcome::NOT_MANIFOLD);
  CHECK(several.message.find("vertex 0 ") != std::string::npos);
}

// --- shapes --------------------------------------------------------------------------------------

// In the plane, 1 wide.
void add_quad(Mesh& mesh, const double height, const double slant)
{
  const quad_reference::Kernel::Point_3 o(0, 0, 0), p(1, 0, 0), q(1 + slant, height, 0),
    r(slant, height, 0);
  CGAL::make_quad(o, p, q, r, mesh);
}

void test_known_shapes()
{
  using quad_reference::Kernel;
  Mesh mesh;
  const QR::Quad_shapes of_none = QR::measure_quad_shapes(mesh);
  CHECK(of_none.mean_scaled_jacobian == 1 && of_none.number_of_thin_quads == 0);
  const Kernel::Point_3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0);
  CGAL::make_triangle(o, x, y, mesh);
  add_quad(mesh, 1, 0);
  add_quad(mesh, 0.75, 1); // a sine of 0.6
  QR::Quad_shapes shapes = QR::measure_quad_shapes(mesh);
  CHECK(std::abs(shapes.least_scaled_jacobian - 0.6) < 1e-15);
  CHECK(std::abs(shapes.mean_scaled_jacobian - 0.8) < 1e-15);
  CHECK_EQUAL(shapes.largest_aspect_ratio, 1.25);
  CHECK(shapes.number_of_thin_quads == 0 && shapes.number_of_long_quads == 0);
  add_quad(mesh, 10, 0);
  CHECK_EQUAL(QR::measure_quad_shapes(mesh).number_of_long_quads, std::size_t(0));
  add_quad(mesh, 10.5, 0);
  add_quad(mesh, 0.09, 1);
  const Kernel::Point_3 inside(0.25, 0.25, 0), z(0, 0, 1);
  CGAL::make_quad(o, x, inside, y, mesh); // inverted
  CGAL::make_triangle(o, x, y, mesh);
  CGAL::make_quad(o, x, x, z, mesh); // a side without length
  shapes = QR::measure_quad_shapes(mesh);
  CHECK_EQUAL(shapes.least_scaled_jacobian, -1.);
  CHECK_EQUAL(shapes.largest_aspect_ratio, std::numeric_limits<double>::infinity());
  CHECK_EQUAL(shapes.number_of_long_quads, std::size_t(2));
  CHECK_EQUAL(shapes.number_of_thin_quads, std::size_t(3));
  CHECK((shapes.first_thin_quads == std::vector<std::size_t>{5, 6, 8}));
  CHECK_EQUAL(shapes.number_of_degenerate_quads, std::size_t(1));
  CHECK((shapes.first_degenerate_quads == std::vector<std::size_t>{8}));
  for(int i = 0; i < 20; ++i)
    add_quad(mesh, 0.01, 1);
  shapes = QR::measure_quad_shapes(mesh);
  CHECK_EQUAL(shapes.number_of_thin_quads, std::size_t(23));
  CHECK_EQUAL(shapes.first_thin_quads.size(), std::size_t(10));
  // Long ones, and one that is a square, but small.
  for(const double size : {1., 1e-200, 1e200}) {
    Mesh squares;
    const auto add_rectangle = [&](const double width, const double height) {
      CGAL::make_quad(o, Kernel::Point_3(width * size, 0, 0),
                      Kernel::Point_3(width * size, height * size, 0),
                      Kernel::Point_3(0, height * size, 0), squares);
    };
    for(const double width : {1., 99., 101.})
      add_rectangle(width, 1);
    for(const double width : {1e-4, 1e-5})
      add_rectangle(width, width);
    const QR::Quad_shapes sides = QR::measure_quad_shapes(squares); // the mean side is 20.4
    CHECK((sides.first_degenerate_quads == std::vector<std::size_t>{2, 4}));
    CHECK_EQUAL(sides.number_of_degenerate_quads, std::size_t(2));
  }
  // Of any size, and without numbers that mean nothing.
  for(const double size : {1e-300, 1e-100, 1e100, 1e300}) {
    Mesh square;
    CGAL::make_quad(o, Kernel::Point_3(size, 0, 0), Kernel::Point_3(size, size, 0),
                    Kernel::Point_3(0, size, 0), square);
    CHECK_EQUAL(QR::measure_quad_shapes(square).least_scaled_jacobian, 1.);
  }
  for(const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Mesh square;
    CGAL::make_quad(o, x, Kernel::Point_3(1, 1, bad), y, square);
    CHECK_EQUAL(QR::measure_quad_shapes(square).mean_scaled_jacobian, -1.);
  }
  // By the caller's points, and of another type of meshes.
  const auto moved = boost::make_function_property_map<Mesh::Vertex_index>(
    [&](const Mesh::Vertex_index v) { return mesh.point(v) + Kernel::Vector_3(v, v, v); });
  CHECK(QR::measure_quad_shapes(mesh, parameters::vertex_point_map(moved)).mean_scaled_jacobian !=
        shapes.mean_scaled_jacobian);
  const surfaces::Polyhedron_copy<Kernel> copy(mesh);
  CHECK_EQUAL(QR::measure_quad_shapes(copy.polyhedron).mean_scaled_jacobian,
              shapes.mean_scaled_jacobian);
}

// Of quads in space that are not flat, by vectors of CGAL.
void test_random_shapes()
{
  using quad_reference::Kernel;
  Random random(seed);
  for(int i = 0; i < 1000; ++i) {
    const auto coordinate = [&] { return double(below(random, 1000)); };
    std::array<Kernel::Point_3, 4> p;
    for(Kernel::Point_3& q : p)
      q = Kernel::Point_3(coordinate(), coordinate(), coordinate());
    const Kernel::Vector_3 normal = CGAL::cross_product(p[2] - p[0], p[3] - p[1]);
    double least = 1, shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for(std::size_t k = 0; k < 4; ++k) {
      const Kernel::Vector_3 a = p[(k + 1) % 4] - p[k], b = p[(k + 3) % 4] - p[k];
      least = (std::min)(least, CGAL::cross_product(a, b) * normal /
                                  std::sqrt(a.squared_length() * b.squared_length() *
                                            normal.squared_length()));
      shortest = (std::min)(shortest, std::sqrt(a.squared_length()));
      longest = (std::max)(longest, std::sqrt(a.squared_length()));
    }
    Mesh mesh;
    CGAL::make_quad(p[0], p[1], p[2], p[3], mesh);
    const QR::Quad_shapes shapes = QR::measure_quad_shapes(mesh);
    CHECK(std::abs(shapes.least_scaled_jacobian - least) < 1e-12);
    CHECK(std::abs(shapes.largest_aspect_ratio * shortest - longest) < 1e-9);
  }
}

void test_polyhedron()
{
  using Polyhedron = CGAL::Polyhedron_3<quad_reference::Kernel>;
  Polyhedron cube;
  const quad_reference::Kernel::Point_3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1),
    xy(1, 1, 0), xz(1, 0, 1), yz(0, 1, 1), xyz(1, 1, 1);
  CGAL::make_hexahedron(o, x, xy, y, yz, z, xz, xyz, cube);
  const auto patch_of = get(CGAL::dynamic_face_property_t<std::size_t>(), cube);
  const auto patches = QR::quad_patches(cube, parameters::face_patch_map(patch_of));
  CHECK(patches && patches.patches.size() == 6 && is_partition(cube, patches, patch_of));
}

// The squares of a grid, and edges along its lines, which are 1 long.
struct Net
{
  Quads grid;

  explicit Net(const int n) : grid(make(n)) { }

  static Mesh make(const int n)
  {
    Mesh mesh;
    CGAL::make_grid(std::size_t(n), std::size_t(n), mesh);
    return mesh;
  }

  bool is_feature(const Mesh::Edge_index e) const
  { return grid.is_feature[e] && !grid.mesh.is_border(e); }

  // Marks an edge from a point to the right, or above.
  void mark(const int x, const int y, const bool is_upright)
  {
    const quad_reference::Kernel::Point_3 p(x, y, 0), q(x + !is_upright, y + is_upright, 0);
    for(const Mesh::Edge_index e : grid.mesh.edges()) {
      const auto a = grid.mesh.point(grid.mesh.vertex(e, 0)),
                 b = grid.mesh.point(grid.mesh.vertex(e, 1));
      if((a == p && b == q) || (a == q && b == p))
        grid.is_feature[e] = true;
    }
  }

  void mark_row(const int y, const int from, const int to)
  {
    for(int x = from; x < to; ++x)
      mark(x, y, false);
  }

  std::size_t number() const
  {
    const auto edges = grid.mesh.edges();
    return std::size_t(std::count_if(edges.begin(), edges.end(),
                                     [&](const auto e) { return is_feature(e); }));
  }

  std::size_t remove_noise(const double length)
  { return QR::remove_feature_noise(grid.mesh, grid.is_feature, length); }

  // What is left where each edge with an end inside goes, again and again.
  std::set<Mesh::Edge_index> core() const
  {
    std::set<Mesh::Edge_index> result;
    for(const Mesh::Edge_index e : grid.mesh.edges())
      if(is_feature(e))
        result.insert(e);
    for(std::size_t size = 0; size != result.size();) {
      size = result.size();
      std::vector<int> degree(grid.mesh.number_of_vertices(), 0);
      for(const Mesh::Edge_index e : result)
        for(const unsigned int i : {0u, 1u})
          ++degree[grid.mesh.vertex(e, i)];
      for(auto e = result.begin(); e != result.end();) {
        const auto v = grid.mesh.vertex(*e, 0), w = grid.mesh.vertex(*e, 1);
        const bool has_end = (degree[v] == 1 && !grid.mesh.is_border(v)) ||
                             (degree[w] == 1 && !grid.mesh.is_border(w));
        e = has_end ? result.erase(e) : std::next(e);
      }
    }
    return result;
  }

  // Features at the target of one.
  std::vector<Halfedge> others(const Halfedge h) const
  {
    std::vector<Halfedge> next;
    for(const Halfedge g : grid.mesh.halfedges_around_target(h))
      if(g != h && is_feature(grid.mesh.edge(g)))
        next.push_back(grid.mesh.opposite(g));
    return next;
  }

  // Of all chains: how long they are, and whether they lead nowhere. Follows them edge by edge.
  std::vector<std::pair<int, bool> > chains() const
  {
    const Mesh& mesh = grid.mesh;
    std::vector<std::pair<int, bool> > result;
    std::set<Mesh::Edge_index> seen;
    for(const Mesh::Edge_index e : mesh.edges()) {
      if(!is_feature(e) || seen.count(e) > 0)
        continue;
      seen.insert(e);
      int length = 1;
      bool leads_nowhere = false;
      for(Halfedge h : {mesh.halfedge(e), mesh.opposite(mesh.halfedge(e))}) {
        auto next = others(h);
        for(; next.size() == 1 && seen.insert(mesh.edge(next[0])).second; next = others(h)) {
          h = next[0];
          ++length;
        }
        leads_nowhere |= next.empty() && !mesh.is_border(mesh.target(h));
      }
      result.emplace_back(length, leads_nowhere);
    }
    return result;
  }
};

// Of the chains that are shorter, or of these lead nowhere: their part of the length of all.
double part(const std::vector<std::pair<int, bool> >& chains, const double length,
            const bool must_lead_nowhere)
{
  int all = 0, meant = 0;
  for(const auto& [own_length, leads_nowhere] : chains) {
    all += own_length;
    if(own_length < length && (leads_nowhere || !must_lead_nowhere))
      meant += own_length;
  }
  return all > 0 ? double(meant) / all : 0;
}

void test_known_noise()
{
  Net net(20);
  net.mark_row(10, 4, 8); // leads nowhere
  net.mark_row(15, 0, 20);
  for(int y = 15; y < 17; ++y)
    net.mark(9, y, true); // ends at the long one
  for(int y = 0; y < 2; ++y)
    net.mark(3, y, true); // begins at the border
  for(const double none : {0., -1., 2., std::nan("")})
    CHECK_EQUAL(net.remove_noise(none), 0u);
  CHECK_EQUAL(net.remove_noise(2.5), 4u);
  CHECK_EQUAL(net.remove_noise(4), 0u);
  CHECK_EQUAL(net.remove_noise(4.5), 4u);
  CHECK_EQUAL(net.number(), 20u);
  CHECK_EQUAL(net.remove_noise(1000), 0u); // it leads from border to border

  Net squares(20); // as on a model that is made of boxes
  for(int y = 2; y <= 18; y += 4)
    for(int x = 2; x < 18; ++x) {
      squares.mark(x, y, false);
      squares.mark(y, x, true);
    }
  CHECK_EQUAL(squares.remove_noise(1000), 0u);
}

// Whatever is kept is as documented. Nets of all densities are seen as noise, and as none.
void test_random_noise()
{
  Random random(seed);
  int number_of_nets_of_noise = 0;
  for(int i = 0; i < 600; ++i) {
    Net net(4 + below(random, 12));
    const int percent = 1 + below(random, 99);
    for(const auto e : net.grid.mesh.edges())
      net.grid.is_feature[e] = below(random, 100) < percent;
    const auto before = net.chains();
    const auto core = net.core();
    const std::size_t number = net.number();
    const double length = (1 + below(random, 24)) / 4.;
    const std::size_t number_removed = net.remove_noise(length);
    CHECK_EQUAL(number_removed, number - net.number());
    const auto after = net.chains();
    CHECK_EQUAL(part(after, length, true), 0);
    const bool has_dead_ends = before.size() > 20 && part(before, 1e9, true) > 0.2;
    CHECK(!(has_dead_ends && part(after, 2 * length, false) > 0.2));
    for(const auto e : core)
      CHECK(has_dead_ends || net.is_feature(e));
    if(has_dead_ends && net.number() < number && part(after, 4 * length, false) == 0)
      ++number_of_nets_of_noise;
  }
  CHECK(number_of_nets_of_noise > 100 && number_of_nets_of_noise < 500);
}

// Of slivers in a plane, where third sides become features, and cease to be: the number is that of
// those that were features before.
void test_number_removed()
{
  Random random(seed);
  for(int i = 0; i < 200; ++i) {
    using quad_reference::Kernel;
    const auto point = [&](const std::size_t x, const std::size_t y)
      { return Kernel::Point_3(double(x) + below(random, 100) / 110., double(y), 0); };
    Mesh mesh;
    CGAL::make_grid(8, 8, mesh, point, true);
    const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
    std::vector<Mesh::Edge_index> before;
    for(const auto e : mesh.edges())
      if((is_feature[e] = below(random, 3) == 0) && !mesh.is_border(e))
        before.push_back(e);
    const std::size_t number = QR::remove_feature_noise(mesh, is_feature, 1.5);
    CHECK_EQUAL(number, std::size_t(std::count_if(before.begin(), before.end(),
                                                  [&](const auto e) { return !is_feature[e]; })));
  }
}

// A sliver between two triangles, with or without one below its longest side, and others around.
void test_slivers()
{
  for(const bool has_border : {false, true})
    for(const double height : {0., 0.05, 0.2}) {
      Mesh mesh;
      const auto add = [&](const double x, const double y)
      { return mesh.add_vertex(quad_reference::Kernel::Point_3(x, y, 0)); };
      const auto left = add(0, 0), right = add(4, 0), middle = add(2, height), top = add(2, 2);
      mesh.add_face(left, right, middle);
      mesh.add_face(left, middle, top);
      mesh.add_face(middle, right, top);
      if(!has_border) {
        mesh.add_face(right, left, add(2, -2));
        const Halfedge h = *std::find_if(mesh.halfedges_begin(), mesh.halfedges_end(),
                                         [&](const Halfedge g) { return mesh.is_border(g); });
        CGAL::Euler::fill_hole(h, mesh);
        mesh.point(mesh.target(CGAL::Euler::add_center_vertex(h, mesh))) = {2, 0, 9};
      }
      const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
      const auto edge = [&](const auto v, const auto w) { return mesh.edge(mesh.halfedge(v, w)); };
      const auto bottom = edge(left, right), first = edge(left, middle),
                 second = edge(middle, right);
      is_feature[bottom] = is_feature[first] = is_feature[second] = true;
      const double close = 3 * height;
      CHECK_EQUAL(QR::remove_feature_noise(mesh, is_feature, 0.9 * close), 0u);
      if(height == 0) { // no area
        CHECK_EQUAL(QR::remove_feature_noise(mesh, is_feature, 1), 0u);
        continue;
      }
      is_feature[bottom] = false;
      CHECK_EQUAL(QR::remove_feature_noise(mesh, is_feature, 1.1 * close), has_border ? 2u : 0u);
      is_feature[bottom] = is_feature[first] = is_feature[second] = true;
      CHECK_EQUAL(QR::remove_feature_noise(mesh, is_feature, 1.1 * close), 2u);
      CHECK(is_feature[bottom] && !is_feature[first] && !is_feature[second]);
      if(has_border)
        continue;
      for(const bool is_spike : {true, false}) { // at the left, of a line to the top
        is_feature[first] = is_feature[edge(middle, top)] = true;
        is_feature[second] = false;
        is_feature[edge(left, top)] = !is_spike;
        CHECK_EQUAL(QR::remove_feature_noise(mesh, is_feature, 1.1 * close), 1u);
        CHECK(!is_feature[first] && is_feature[bottom] && is_feature[second] == is_spike);
      }
    }
}

// The narrow tip of a face stays, unless it is not flat, a side ends, or more features meet there.
void test_tips_of_faces()
{
  for(const char* change : {"none", "bent", "ends", "many"}) {
    const std::string_view changed = change;
    Mesh mesh;
    const auto add = [&](const double x, const double y, const double z)
    { return mesh.add_vertex(quad_reference::Kernel::Point_3(x, y, z)); };
    const double z = changed == "bent" ? 1 : 0;
    const auto tip = add(0, 0, 0), a = add(4, 0.5, 0), b = add(4, -0.5, 0), c = add(8, 1, z),
               d = add(8, -1, z), p = add(4, 3, 3), q = add(4, -3, 3);
    mesh.add_face(tip, b, a);
    mesh.add_face(b, c, a);
    mesh.add_face(b, d, c);
    mesh.add_face(tip, a, p);
    mesh.add_face(a, c, p);
    mesh.add_face(tip, q, b);
    mesh.add_face(b, q, d);
    mesh.add_face(tip, p, q);
    const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
    const auto edge = [&](const auto v, const auto w) { return mesh.edge(mesh.halfedge(v, w)); };
    for(const auto e : {edge(tip, a), edge(tip, b), edge(b, d)})
      is_feature[e] = true;
    is_feature[edge(a, c)] = changed != "ends";
    is_feature[edge(tip, p)] = is_feature[edge(tip, q)] = changed == "many";
    const bool stays = changed == "none";
    CHECK_EQUAL(QR::remove_feature_noise(mesh, is_feature, 3.5), stays ? 0u : 1u);
    CHECK((is_feature[edge(tip, a)] && is_feature[edge(tip, b)]) == stays);
  }
}

int main()
{
  std::cout << "random seed " << seed << std::endl;
  test_random_meshes();
  test_known_surfaces();
  test_refusals();
  test_known_shapes();
  test_random_shapes();
  test_polyhedron();
  test_known_noise();
  test_random_noise();
  test_number_removed();
  test_slivers();
  test_tips_of_faces();
  feature_detection_checks::test_all();
  return report_checks();
}
