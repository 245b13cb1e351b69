// Meshes of hexahedra in one call: the number of hexahedra, shapes and moves of vertices, patches
// of the boundary, and files.

#include "checking.h"
#include "floating_point_traps.h"
#include "hexahedra_reference.h"
#include "integer_maps.h"
#include "volume_checks.h"

#include <CGAL/Hexahedral_meshing/IO/hexahedra.h>
#include <CGAL/Hexahedral_meshing/hexahedral_mesh.h>
#include <CGAL/Hexahedral_meshing/measure_hexahedra.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace Meshing = CGAL::Hexahedral_meshing;
using hexahedra_reference::Hexahedra;
using integer_maps::Integer_map;
using Meshing::Hexahedral_mesh;
using Meshing::Hexahedral_meshing_report;

template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
Hexahedral_meshing_report make_mesh(const Integer_map& map, Hexahedral_mesh& mesh,
                                    const NamedParameters& np =
                                      CGAL::parameters::default_values())
{
  const Floating_point_traps traps;
  Tet_map copy = map.map;
  return Meshing::hexahedral_mesh(map.points, map.map.cells, Double_map{&copy}, mesh, np);
}

// Cubes of size `size`, with the points of the lattice in space.
Integer_map cubes(const std::vector<volume_generator::Lattice_point>& low, const double size)
{
  const auto complex = volume_generator::lattice_cubes("cubes", low);
  Integer_map map = integer_maps::Builder(complex, Charts::BLOCKS, size, 5).build();
  for(std::size_t i = 0; i < map.in_block.size(); ++i)
    map.points[std::size_t(map.map.cells[i / 4][i % 4])] = map.in_block[i];
  return map;
}

double determinant(const Hexahedral_mesh& mesh, const std::array<int, 8>& h, const int k)
{
  // in each coordinate, where the neighbor of each corner is
  constexpr int neighbors[8][3] = {{1, 3, 4}, {0, 2, 5}, {3, 1, 6}, {2, 0, 7},
                                   {5, 7, 0}, {4, 6, 1}, {7, 5, 2}, {6, 4, 3}};
  constexpr int signs[8] = {1, -1, 1, -1, -1, 1, -1, 1};
  std::array<Point, 3> e;
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t c = 0; c < 3; ++c)
      e[i][c] = mesh.points[std::size_t(h[std::size_t(neighbors[k][i])])][c] -
                mesh.points[std::size_t(h[std::size_t(k)])][c];
  return signs[k] * (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                     e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                     e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]));
}

std::vector<std::size_t> nonpositive(const Hexahedral_mesh& mesh)
{
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < mesh.hexahedra.size(); ++i) {
    bool is_positive = true;
    for(int k = 0; k < 8; ++k)
      is_positive = is_positive && determinant(mesh, mesh.hexahedra[i], k) > 0;
    if(!is_positive)
      result.push_back(i);
  }
  return result;
}

void test_shapes()
{
  std::vector<Point> points;
  for(int k = 0; k < 8; ++k)
    points.push_back({{double(k % 4 == 1 || k % 4 == 2), double(k % 4 > 1), double(k > 3)}});
  const std::vector<std::array<int, 8> > one{{{0, 1, 2, 3, 4, 5, 6, 7}}};
  auto shapes = Meshing::measure_hexahedra(points, one);
  CHECK(shapes.number_of_hexahedra == 1 && shapes.nonpositive_hexahedra.empty());
  CHECK(std::abs(shapes.least_scaled_jacobian - 1) < 1e-15 && shapes.number_by_tenths[9] == 1);
  for(int k = 4; k < 8; ++k)
    points[std::size_t(k)][0] += 1; // edges at 45 degrees
  shapes = Meshing::measure_hexahedra(points, one);
  CHECK(std::abs(shapes.least_scaled_jacobian - std::sqrt(0.5)) < 1e-15);
  CHECK(shapes.number_by_tenths[7] == 1);
  points[6] = {{1, 1, 0}}; // on a corner: edges of length zero
  shapes = Meshing::measure_hexahedra(points, one);
  CHECK(shapes.nonpositive_hexahedra == std::vector<std::size_t>{0});
  CHECK(shapes.least_scaled_jacobian <= 0 && shapes.number_by_tenths[0] == 1);
  CHECK_EQUAL(Meshing::measure_hexahedra(points, std::vector<std::array<int, 8> >())
                .mean_scaled_jacobian, 1.);
}

// A vertex of the tetrahedra far away from where it should be, inside or in a face: hexahedra turn
// over. Vertices of the hexahedra move, but stay in their faces and edges.
void test_moves()
{
  std::vector<volume_generator::Lattice_point> low;
  for(int i = 0; i < 8; ++i)
    low.push_back({{i % 2 * 2, i / 2 % 2 * 2, i / 4 * 2}});
  const std::pair<Point, Point> moved_vertices[] = {{{{2, 2, 2}}, {{3.6, 3.5, 3.7}}},
                                                    {{{2, 2, 0}}, {{3.6, 3.7, 0}}}};
  for(const auto& [from, to] : moved_vertices) {
    Integer_map map = cubes(low, 2);
    for(Point& p : map.points)
      if(p == from)
        p = to;
    Hexahedral_mesh plain, moved;
    const auto before = make_mesh(map, plain, Meshing::parameters::number_of_iterations(0));
    const auto after = make_mesh(map, moved);
    CHECK(bool(before) && bool(after));
    CHECK(before.shapes.nonpositive_hexahedra == nonpositive(plain) && !nonpositive(plain).empty());
    CHECK(after.shapes_before.nonpositive_hexahedra == nonpositive(plain));
    CHECK_EQUAL(after.shapes.nonpositive_hexahedra.size(), std::size_t(0));
    CHECK(nonpositive(moved).empty());
    CHECK(plain.hexahedra == moved.hexahedra);
    std::size_t in_faces = 0, in_edges = 0; // vertices that moved
    for(std::size_t v = 0; v < plain.points.size(); ++v) {
      const Point &p = plain.points[v], &q = moved.points[v];
      int faces = 0;
      for(std::size_t c = 0; c < 3; ++c)
        if(p[c] == 0 || p[c] == 4) {
          ++faces;
          CHECK(std::abs(p[c] - q[c]) < 1e-12);
        } else {
          CHECK(q[c] > 0 && q[c] < 4);
        }
      in_faces += std::size_t(faces == 1 && p != q);
      in_edges += std::size_t(faces == 2 && p != q);
      CHECK(faces < 3 || p == q);
    }
    CHECK(in_faces > 0 && in_edges > 0);
    std::cout << nonpositive(plain).size() << " hexahedra made positive, " << in_faces
              << " vertices moved in faces and " << in_edges << " in edges" << std::endl;
  }
}

// Of an L of three cubes: its eight faces, and their edges.
void test_patches()
{
  const Integer_map map = cubes({{{0, 0, 0}}, {{2, 0, 0}}, {{0, 2, 0}}}, 2);
  Hexahedral_mesh mesh;
  CHECK(bool(make_mesh(map, mesh)));
  CHECK_EQUAL(mesh.hexahedra.size(), std::size_t(24));
  CHECK_EQUAL(mesh.quadrilaterals.size(), std::size_t(4 * 14));
  CHECK_EQUAL(mesh.edges.size(), std::size_t(2 * (2 * 8 + 6)));
  std::map<int, std::set<std::array<double, 4> > > lines; // of curves
  for(std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const Point &p = mesh.points[std::size_t(mesh.edges[i][0])],
                &q = mesh.points[std::size_t(mesh.edges[i][1])];
    for(std::size_t c = 0; c < 3; ++c)
      if(p[c] != q[c])
        lines[mesh.curves[i]].insert({{double(c), p[(c + 1) % 3], p[(c + 2) % 3], 0}});
  }
  CHECK_EQUAL(lines.size(), std::size_t(18));
  for(const auto& [curve, all] : lines)
    CHECK_EQUAL(all.size(), std::size_t(1));
  std::map<int, std::set<std::pair<int, double> > > planes; // of patches
  double volume = 0;
  for(std::size_t i = 0; i < mesh.quadrilaterals.size(); ++i) {
    std::array<Point, 4> p;
    for(std::size_t k = 0; k < 4; ++k)
      p[k] = mesh.points[std::size_t(mesh.quadrilaterals[i][k])];
    for(std::size_t c = 0; c < 3; ++c)
      if(p[0][c] == p[1][c] && p[0][c] == p[2][c] && p[0][c] == p[3][c]) {
        planes[mesh.patches[i]].emplace(int(c), p[0][c]);
        const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
        volume += p[0][c] * ((p[1][d] - p[0][d]) * (p[2][e] - p[0][e]) -
                             (p[1][e] - p[0][e]) * (p[2][d] - p[0][d]));
      }
  }
  CHECK_EQUAL(planes.size(), std::size_t(8));
  CHECK(planes.begin()->first == 1 && planes.rbegin()->first == 8);
  for(const auto& [patch, all] : planes)
    CHECK_EQUAL(all.size(), std::size_t(1));
  CHECK_EQUAL(volume, 3 * 24.); // quadrilaterals look outside
}

using Features = std::vector<std::vector<int> >;

// Facets of cells whose vertices have c-th coordinate x, or edges that have two coordinates in
// common with a point; each is listed once, and its vertices in any order.
Features facets_in_plane(const Integer_map& map, const std::size_t c, const double x)
{
  std::set<std::set<int> > found;
  for(const auto& cell : map.map.cells) {
    std::set<int> facet;
    for(const int v : cell)
      if(map.points[std::size_t(v)][c] == x)
        facet.insert(v);
    if(facet.size() == 3)
      found.insert(facet);
  }
  Features result;
  for(const auto& facet : found)
    result.emplace_back(facet.rbegin(), facet.rend());
  return result;
}

Features edges_on_line(const Integer_map& map, const std::size_t c, const Point& p)
{
  std::set<std::set<int> > found;
  for(const auto& cell : map.map.cells) {
    std::set<int> edge;
    for(const int v : cell) {
      const Point& q = map.points[std::size_t(v)];
      if(q[(c + 1) % 3] == p[(c + 1) % 3] && q[(c + 2) % 3] == p[(c + 2) % 3])
        edge.insert(v);
    }
    if(edge.size() == 2)
      found.insert(edge);
  }
  Features result;
  for(const auto& edge : found)
    result.emplace_back(edge.rbegin(), edge.rend());
  return result;
}

template <typename Element>
Point middle(const Hexahedral_mesh& mesh, const Element& element)
{
  Point result{};
  for(const int v : element)
    for(std::size_t c = 0; c < 3; ++c)
      result[c] += mesh.points[std::size_t(v)][c] / double(element.size());
  return result;
}

// Whether a point lies in the triangle or segment of some vertices, all in an axis-parallel plane.
bool contains(const Integer_map& map, const std::vector<int>& element, const Point& p)
{
  double whole = 0, parts = 0; // areas, or lengths
  const auto size = [](const Point& a, const Point& b, const Point& c) {
    Point n;
    for(std::size_t k = 0; k < 3; ++k)
      n[k] = (b[(k + 1) % 3] - a[(k + 1) % 3]) * (c[(k + 2) % 3] - a[(k + 2) % 3]) -
             (b[(k + 2) % 3] - a[(k + 2) % 3]) * (c[(k + 1) % 3] - a[(k + 1) % 3]);
    return std::hypot(n[0], n[1], n[2]);
  };
  const auto at = [&](const std::size_t k) { return map.points[std::size_t(element[k])]; };
  if(element.size() == 2) {
    const auto length = [](const Point& a, const Point& b)
    { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); };
    whole = length(at(0), at(1));
    parts = length(at(0), p) + length(at(1), p);
  } else {
    whole = size(at(0), at(1), at(2));
    parts = size(p, at(1), at(2)) + size(at(0), p, at(2)) + size(at(0), at(1), p);
  }
  return std::abs(whole - parts) < 1e-12;
}

// A vertex of the tetrahedra lies far away in a sheet that a line goes through: no vertex leaves
// the sheet, and the vertex at the line stays.
void test_moves_on_features()
{
  std::vector<volume_generator::Lattice_point> low;
  for(int i = 0; i < 8; ++i)
    low.push_back({{i % 2 * 2, i / 2 % 2 * 2, i / 4 * 2}});
  Integer_map map = cubes(low, 2);
  const Features facets = facets_in_plane(map, 0, 2), edges = edges_on_line(map, 0, {{0, 2, 2}});
  for(Point& p : map.points)
    if(p == Point{{2, 1, 1}})
      p = {{2, 2.7, 2.6}};
    else if(p == Point{{3, 3, 3}})
      p = {{2.1, 2.2, 2.1}};
  const auto np = Meshing::parameters::feature_facets(facets).feature_edges(edges);
  Hexahedral_mesh plain, moved;
  CHECK(bool(make_mesh(map, plain, np.number_of_iterations(0))));
  CHECK(bool(make_mesh(map, moved, np)));
  std::size_t on_sheet = 0;
  for(std::size_t v = 0; v < plain.points.size(); ++v) {
    const Point &p = plain.points[v], &q = moved.points[v];
    if(p[0] == 2)
      CHECK(std::abs(q[0] - 2) < 1e-12);
    if(p == Point{{2, 2, 2}})
      CHECK(p == q);
    on_sheet += std::size_t(p[0] == 2 && p != q);
  }
  CHECK(!nonpositive(plain).empty() && nonpositive(moved).empty());
  CHECK(on_sheet > 0);
  std::cout << nonpositive(plain).size() << " hexahedra made positive at a sheet" << std::endl;
}

// A block of eight cubes and 64 hexahedra with a sheet inside, and lines inside and on a face.
void test_features()
{
  std::vector<volume_generator::Lattice_point> low;
  for(int i = 0; i < 8; ++i)
    low.push_back({{i % 2 * 2, i / 2 % 2 * 2, i / 4 * 2}});
  const Integer_map map = cubes(low, 2);
  const Features facets = facets_in_plane(map, 0, 2);
  Features edges = edges_on_line(map, 2, {{4, 2, 0}}), inside = edges_on_line(map, 1, {{1, 0, 3}});
  CHECK(!facets.empty() && edges.size() >= 2 && inside.empty());
  inside = edges_on_line(map, 0, {{0, 2, 2}});
  const std::size_t number_on_face = edges.size();
  edges.insert(edges.end(), inside.begin(), inside.end());
  Hexahedral_mesh mesh;
  const auto report = make_mesh(
    map, mesh, Meshing::parameters::feature_facets(facets).feature_edges(edges));
  CHECK_IN(report.message, bool(report));
  CHECK_EQUAL(report.number_of_boundary_quadrilaterals, std::size_t(96));
  CHECK_EQUAL(mesh.quadrilaterals.size(), std::size_t(96 + 16));
  CHECK(mesh.feature_facets.size() == 112 && mesh.patches.size() == 112);
  std::map<int, std::set<std::pair<int, double> > > planes; // of patches
  for(std::size_t i = 0; i < mesh.quadrilaterals.size(); ++i) {
    const Point p = middle(mesh, mesh.quadrilaterals[i]);
    CHECK_EQUAL(mesh.feature_facets[i] >= 0, p[0] == 2);
    if(mesh.feature_facets[i] >= 0)
      CHECK(contains(map, facets[std::size_t(mesh.feature_facets[i])], p));
    for(std::size_t c = 0; c < 3; ++c)
      if(p[c] == 0 || p[c] == 4 || (c == 0 && p[c] == 2))
        planes[mesh.patches[i]].emplace(int(c), p[c]);
  }
  CHECK_EQUAL(planes.size(), std::size_t(6 + 4 + 1 + 1)); // two sides are divided, and one more
  for(const auto& [patch, all] : planes)
    CHECK_EQUAL(all.size(), std::size_t(1));

  std::size_t on_face = 0, in_space = 0, others = 0;
  CHECK(mesh.feature_edges.size() == mesh.edges.size() && mesh.curves.size() == mesh.edges.size());
  for(std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const int feature = mesh.feature_edges[i];
    CHECK(mesh.edges[i][0] < mesh.edges[i][1]);
    if(feature >= 0)
      CHECK(contains(map, edges[std::size_t(feature)], middle(mesh, mesh.edges[i])));
    ++(feature < 0 ? others : std::size_t(feature) < number_on_face ? on_face : in_space);
  }
  CHECK_EQUAL(on_face, std::size_t(4));
  CHECK_EQUAL(in_space, std::size_t(4));
  CHECK_EQUAL(others, std::size_t(12 * 4 + 16));
  // The sheet divides four edges of the block, the line on a face two, and the line in space the
  // line on a face.
  std::map<int, std::set<int> > directions; // of curves
  for(std::size_t i = 0; i < mesh.edges.size(); ++i)
    for(std::size_t c = 0; c < 3; ++c)
      if(mesh.points[std::size_t(mesh.edges[i][0])][c] !=
         mesh.points[std::size_t(mesh.edges[i][1])][c])
        directions[mesh.curves[i]].insert(int(c));
  CHECK_EQUAL(directions.size(), std::size_t(12 + 4 + 2 + 4 + 2 + 1));
  for(const auto& [curve, all] : directions)
    CHECK_EQUAL(all.size(), std::size_t(1));
  std::cout << directions.size() << " curves and " << planes.size() << " patches" << std::endl;
}

// Reads words until `keyword`, then a number.
std::size_t number_after(std::istream& is, const std::string& keyword)
{
  std::string word;
  while(is >> word && word != keyword) { }
  std::size_t number = 0;
  CHECK(bool(is >> number));
  return number;
}

void check_points(std::istream& is, const Hexahedral_mesh& mesh, const bool has_reference)
{
  for(const Point& p : mesh.points) {
    Point q;
    int reference = 0;
    is >> q[0] >> q[1] >> q[2];
    if(has_reference)
      is >> reference;
    CHECK(p == q && reference == 0);
  }
}

// In the format of VTK: the number of vertices first.
template <typename Elements>
void check_cells(std::istream& is, const Elements& elements)
{
  for(const auto& element : elements) {
    std::size_t v = 0;
    is >> v;
    CHECK_EQUAL(v, element.size());
    for(const int w : element) {
      is >> v;
      CHECK_EQUAL(v, std::size_t(w));
    }
  }
}

template <typename Elements, typename Reference>
void check_elements(std::istream& is, const Elements& elements, const Reference& reference)
{
  for(std::size_t i = 0; i < elements.size(); ++i) {
    for(const auto v : elements[i]) {
      std::int64_t w = 0;
      is >> w;
      CHECK_EQUAL(w, std::int64_t(v) + 1);
    }
    int r = 0;
    is >> r;
    CHECK_EQUAL(r, reference(i));
  }
}

void test_files()
{
  Integer_map map = cubes({{{0, 0, 0}}, {{2, 0, 0}}, {{0, 2, 0}}}, 2);
  for(Point& p : map.points)
    for(double& x : p)
      x /= 3;
  Hexahedral_mesh mesh;
  CHECK(bool(make_mesh(map, mesh)));
  const auto one = [](std::size_t) { return 1; };
  const auto curve = [&](const std::size_t i) { return mesh.curves[i]; };
  const auto patch = [&](const std::size_t i) { return mesh.patches[i]; };
  CHECK(std::set<int>(mesh.curves.begin(), mesh.curves.end()).size() > 1);
  std::stringstream medit, vtk, ovm;
  CHECK(bool(Meshing::IO::write_MEDIT(medit, mesh)));
  CHECK_EQUAL(number_after(medit, "Vertices"), mesh.points.size());
  check_points(medit, mesh, true);
  CHECK_EQUAL(number_after(medit, "Edges"), mesh.edges.size());
  check_elements(medit, mesh.edges, curve);
  CHECK_EQUAL(number_after(medit, "Quadrilaterals"), mesh.quadrilaterals.size());
  check_elements(medit, mesh.quadrilaterals, patch);
  CHECK_EQUAL(number_after(medit, "Hexahedra"), mesh.hexahedra.size());
  check_elements(medit, mesh.hexahedra, one);
  std::string word;
  CHECK(bool(medit >> word) && word == "End");

  CHECK(bool(Meshing::IO::write_VTK(vtk, mesh)));
  CHECK_EQUAL(number_after(vtk, "POINTS"), mesh.points.size());
  vtk >> word;
  check_points(vtk, mesh, false);
  const std::size_t number =
    mesh.hexahedra.size() + mesh.quadrilaterals.size() + mesh.edges.size();
  CHECK_EQUAL(number_after(vtk, "CELLS"), number);
  std::size_t size = 0;
  vtk >> size;
  CHECK_EQUAL(size, 9 * mesh.hexahedra.size() + 5 * mesh.quadrilaterals.size() +
                      3 * mesh.edges.size());
  check_cells(vtk, mesh.hexahedra);
  check_cells(vtk, mesh.quadrilaterals);
  check_cells(vtk, mesh.edges);
  CHECK_EQUAL(number_after(vtk, "CELL_TYPES"), number);
  std::vector<int> types(number), references(number);
  for(int& type : types)
    vtk >> type;
  CHECK_EQUAL(std::size_t(std::count(types.begin(), types.end(), 12)), mesh.hexahedra.size());
  CHECK_EQUAL(std::size_t(std::count(types.begin(), types.end(), 9)), mesh.quadrilaterals.size());
  CHECK_EQUAL(types.back(), 3);
  CHECK_EQUAL(number_after(vtk, "CELL_DATA"), number);
  while(vtk >> word && word != "default") { }
  for(int& reference : references)
    vtk >> reference;
  CHECK(bool(vtk) && references.front() == 1);
  CHECK(std::equal(mesh.patches.begin(), mesh.patches.end(),
                   references.begin() + std::ptrdiff_t(mesh.hexahedra.size())));
  CHECK(std::equal(mesh.curves.rbegin(), mesh.curves.rend(), references.rbegin()));

  // each halfface belongs to one hexahedron or none; those of one close it, and look outside
  CHECK(bool(Meshing::IO::write_OVM(ovm, mesh)));
  CHECK_EQUAL(number_after(ovm, "Vertices"), mesh.points.size());
  check_points(ovm, mesh, false);
  std::vector<std::array<int, 2> > edges(number_after(ovm, "Edges"));
  for(auto& e : edges)
    ovm >> e[0] >> e[1];
  std::vector<std::array<int, 5> > faces(number_after(ovm, "Faces"));
  for(auto& f : faces)
    for(int& x : f)
      ovm >> x;
  CHECK_EQUAL(number_after(ovm, "Polyhedra"), mesh.hexahedra.size());
  std::set<int> used;
  for(const auto& h : mesh.hexahedra) {
    int n = 0;
    ovm >> n;
    CHECK_EQUAL(n, 6);
    std::set<std::pair<int, int> > sides;
    std::set<int> vertices;
    double volume = 0; // six times
    for(int i = 0; i < 6; ++i) {
      int halfface = 0;
      ovm >> halfface;
      CHECK(used.insert(halfface).second);
      const auto& f = faces.at(std::size_t(halfface / 2));
      CHECK_EQUAL(f[0], 4);
      for(std::size_t k = 1; k < 5; ++k) {
        const auto& e = edges.at(std::size_t(f[k] / 2));
        int a = e[std::size_t(f[k] % 2)], b = e[std::size_t(1 - f[k] % 2)];
        if(halfface % 2 == 1)
          std::swap(a, b);
        CHECK(sides.emplace(a, b).second);
        vertices.insert(a);
        Point middle{}, p = mesh.points[std::size_t(a)], q = mesh.points[std::size_t(b)];
        for(std::size_t c = 0; c < 3; ++c)
          for(std::size_t j = 1; j < 5; ++j)
            middle[c] += mesh.points[std::size_t(edges[std::size_t(f[j] / 2)][0])][c] / 8 +
                         mesh.points[std::size_t(edges[std::size_t(f[j] / 2)][1])][c] / 8;
        for(std::size_t c = 0; c < 3; ++c)
          volume += middle[c] * (p[(c + 1) % 3] * q[(c + 2) % 3] - p[(c + 2) % 3] * q[(c + 1) % 3]);
      }
    }
    for(const auto& [a, b] : sides)
      CHECK(sides.count({b, a}) == 1);
    CHECK(vertices == std::set<int>(h.begin(), h.end()));
    CHECK(std::abs(volume - 6. / 27) < 1e-12);
  }
  CHECK(bool(ovm));
  std::size_t with_curve = 0, with_patch = 0;
  while(ovm >> word && word != "\"curve\"") { }
  for(const auto& e : edges) {
    int c = 0;
    ovm >> c;
    with_curve += std::size_t(c != 0);
    const std::array<int, 2> key{{(std::min)(e[0], e[1]), (std::max)(e[0], e[1])}};
    const auto found = std::find(mesh.edges.begin(), mesh.edges.end(), key);
    CHECK_EQUAL(c, found == mesh.edges.end()
                     ? 0 : mesh.curves[std::size_t(found - mesh.edges.begin())]);
  }
  while(ovm >> word && word != "\"patch\"") { }
  for(std::size_t i = 0; i < faces.size(); ++i) {
    int p = 0;
    ovm >> p;
    with_patch += std::size_t(p != 0);
  }
  CHECK(bool(ovm));
  CHECK_EQUAL(with_curve, mesh.edges.size());
  CHECK_EQUAL(with_patch, mesh.quadrilaterals.size());
  mesh.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  std::ostringstream nothing;
  CHECK(!Meshing::IO::write_MEDIT(nothing, mesh) && nothing.str().empty());
}

// A map that is seamless up to noise, thin in one direction: its two sides stay a unit apart.
void test_numbers()
{
  Integer_map map = cubes({{{0, 0, 0}}, {{2, 0, 0}}, {{4, 0, 0}}}, 1);
  for(Point& u : map.in_block)
    u[2] *= 0.1;
  map.map.corners = map.in_block;
  for(Point& u : map.map.corners)
    for(double& x : u)
      x *= 1.2345;
  Hexahedral_mesh mesh;
  const auto few = Meshing::parameters::target_number_of_hexahedra(3);
  const auto report = make_mesh(map, mesh, few.maximum_number(100000));
  CHECK_IN(report.message, bool(report));
  CHECK_EQUAL(report.number_of_attempts > 1, !report.reason_for_more.empty());
  CHECK_EQUAL(report.number_of_hexahedra, mesh.hexahedra.size());
  CHECK(mesh.hexahedra.size() >= 3 && mesh.hexahedra.size() < 1000);
  std::cout << mesh.hexahedra.size() << " hexahedra with " << report.number_of_attempts
            << " attempts" << std::endl;
  const Hexahedral_mesh before = mesh;
  const auto refused = make_mesh(map, mesh, few.maximum_number(5));
  CHECK(!refused && refused.message.find("maximum_number") != std::string::npos);
  const auto contradictory = make_mesh(map, mesh, few.maximum_number(2));
  CHECK_EQUAL(contradictory.status, Outcome::INVALID_ARGUMENT);
  CHECK(contradictory.message.find("maximum_number") != std::string::npos);
  const std::size_t number = before.hexahedra.size();
  const auto enough = make_mesh(map, mesh, few.maximum_number(number));
  CHECK_IN(enough.message, bool(enough) && enough.number_of_hexahedra == number);
  CHECK_EQUAL(make_mesh(map, mesh, few.maximum_number(number - 1)).status, Outcome::TOO_LARGE);
  CHECK(before.points == mesh.points && before.hexahedra == mesh.hexahedra);

  // as it is: near integers, and far from them
  Hexahedral_mesh plain;
  CHECK(bool(make_mesh(cubes({{{0, 0, 0}}}, 3), plain)) && plain.hexahedra.size() == 27);
  CHECK_EQUAL(make_mesh(map, plain).status, Outcome::NOT_INTEGER);
  CHECK_EQUAL(plain.hexahedra.size(), std::size_t(27));
  Hexahedral_mesh many;
  CHECK(bool(make_mesh(cubes({{{0, 0, 0}}}, 3), many,
                       Meshing::parameters::target_number_of_hexahedra(1000))));
  CHECK_EQUAL(many.hexahedra.size(), std::size_t(1000));
}

// Two arcs with five quadrants each, a unit apart, in blocks of four units: that is less than half
// a unit at the number which is wanted. No more are needed, however many charts the map has.
void test_near_arcs()
{
  constexpr int size = 4, distance = 1;
  volume_generator::Cube_complex complex{
    "two arcs", {}, [](const int block, const volume_generator::Lattice_point& p)
                      -> volume_generator::Key {
      if(block == 5 && p[0] == 0)
        return {0, 2 * distance + p[1], 0, p[2]};
      if(block == 5)
        return {5, p[0], p[1], p[2]};
      if(p[0] == 0 && p[1] == 0)
        return {-1, 0, 0, p[2]};
      if(p[0] == 0 && block == 4 && p[1] > 2 * distance)
        return {5, p[1] - 2 * distance, 0, p[2]};
      if(p[0] == 0)
        return {(block + 1) % 5, p[1], 0, p[2]};
      return {block, p[0], p[1], p[2]};
    }};
  for(int block = 0; block < 5; ++block)
    volume_generator::add_box(complex, block, size, size, size);
  volume_generator::add_box(complex, 5, size - distance, size - distance, size);
  const double volume = 5 * size * size * size + 3 * 3 * size;
  for(const Charts charts : {Charts::BLOCKS, Charts::CUBES}) {
    const Integer_map map = integer_maps::Builder(complex, charts, 1, 21).build();
    Hexahedral_mesh mesh;
    const std::size_t number = 24;
    CHECK(std::cbrt(double(number) / volume) * distance < 0.5);
    const auto report = make_mesh(map, mesh, Meshing::parameters::target_number_of_hexahedra(number)
                                               .number_of_iterations(0));
    CHECK_IN(report.message, bool(report));
    CHECK_IN(report.reason_for_more, report.number_of_attempts == 1);
    CHECK(report.number_of_hexahedra >= number / 2 && report.number_of_hexahedra <= 2 * number);
    const auto irregular = hexahedra_reference::irregular_edges({mesh.points, mesh.hexahedra});
    CHECK(irregular == report.irregular_edges);
    CHECK_EQUAL(irregular.size(), std::size_t(1));
    CHECK(irregular.begin()->first == 5 && irregular.begin()->second % 2 == 0);
    std::cout << report.number_of_hexahedra << " hexahedra at two arcs" << std::endl;
  }
}

int main()
{
  test_shapes();
  test_moves();
  test_patches();
  test_features();
  test_moves_on_features();
  test_files();
  test_numbers();
  test_near_arcs();
  return report_checks();
}
