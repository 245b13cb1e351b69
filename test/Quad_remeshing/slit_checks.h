// Flat surfaces with a slit: a chain of edges along which faces are not joined, so that both sides
// of the border coincide. Their whole cells, and the vertices of these, are known by counting. And
// surfaces cut open at random that are made integer-grid maps: their area is the number of cells.

#ifndef SEAMLESS_SNAPPING_TEST_SLIT_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_SLIT_CHECKS_H

#include "quad_reference.h"
#include "test_data.h"
#include "test_surfaces.h"

#include <CGAL/Quad_remeshing/extract_grid_mesh.h>
#include <CGAL/Quad_remeshing/is_integer_grid_map.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace slits {

using namespace quad_reference;
namespace QR = CGAL::Quad_remeshing;
using Cell = std::array<int, 2>; // its lower left corner
using Cells = std::set<Cell>;

// From `begin` to `end` where the component `across` has this level, in lengths of edges, of which
// `edges_in_unit` are a unit of the grid.
struct Slit
{
  std::size_t across = 1;
  int level = 0, begin = 0, end = 0, edges_in_unit = 1;

  // How much of the unit that begins at n lies in the slit.
  int overlap(const int n) const
  {
    return (std::min)(end, (n + 1) * edges_in_unit) - (std::max)(begin, n * edges_in_unit);
  }
  bool is_on_grid() const { return level % edges_in_unit == 0; }

  // Whether it holds the side common to a cell and the next one in a direction.
  bool separates(const Cell& cell, const std::size_t direction) const
  {
    return direction == across && level == (cell[across] + 1) * edges_in_unit &&
           overlap(cell[1 - across]) == edges_in_unit;
  }

  // Whether it runs through the cell, or along a part of one of its sides.
  bool cuts(const Cell& cell) const
  {
    const int n = overlap(cell[1 - across]);
    const int above = level - cell[across] * edges_in_unit;
    return n > 0 && above >= 0 && above <= edges_in_unit &&
           (!is_on_grid() || n < edges_in_unit);
  }
};

// Points have the coordinates of the domain. Vertices on the slit are there twice, but for its ends
// inside of the surface.
inline Mesh with_slit(const Grid_map& map, const Slit& slit, UV_map& uv)
{
  Mesh result;
  std::vector<Vertex> copies(map.mesh.number_of_vertices());
  std::map<Vertex, Vertex> others;
  for(Vertex& v : copies)
    v = result.add_vertex(Point_3(0, 0, 0));
  uv = square_complex::uv_map(result);
  const auto is_doubled = [&](const Halfedge h) {
    const Point_2 p = map.uv[h];
    const double t = p[int(1 - slit.across)] * slit.edges_in_unit;
    const bool is_end = t == slit.begin || t == slit.end;
    return p[int(slit.across)] * slit.edges_in_unit == slit.level && t >= slit.begin &&
           t <= slit.end && (!is_end || CGAL::is_border(map.mesh.target(h), map.mesh).has_value());
  };
  for(const auto f : map.mesh.faces()) {
    std::array<Vertex, 3> corners;
    std::array<Point_2, 3> places;
    std::size_t k = 0;
    bool is_above = false;
    for(const Halfedge h : CGAL::halfedges_around_face(map.mesh.halfedge(f), map.mesh)) {
      places[k++] = map.uv[h];
      is_above = is_above || map.uv[h][int(slit.across)] * slit.edges_in_unit > slit.level;
    }
    k = 0;
    for(const Halfedge h : CGAL::halfedges_around_face(map.mesh.halfedge(f), map.mesh)) {
      Vertex& v = corners[k++];
      v = copies[map.mesh.target(h)];
      if(is_above && is_doubled(h)) {
        const auto found = others.find(v);
        v = found != others.end() ? found->second
                                  : (others[v] = result.add_vertex(Point_3(0, 0, 0)));
      }
      result.point(v) = Point_3(map.uv[h].x(), map.uv[h].y(), 0);
    }
    const auto face = result.add_face(corners);
    for(const Halfedge h : CGAL::halfedges_around_face(result.halfedge(face), result))
      uv[h] = Point_2(result.point(result.target(h)).x(), result.point(result.target(h)).y());
  }
  return result;
}

// The vertices of these cells: around each point, one for each of the fans that they form.
template <typename Separates>
std::size_t number_of_vertices(const Cells& cells, const Separates& separates)
{
  std::set<Cell> points;
  for(const Cell& c : cells)
    points.insert({c, {c[0] + 1, c[1]}, {c[0], c[1] + 1}, {c[0] + 1, c[1] + 1}});
  std::size_t n = 0;
  for(const auto& [x, y] : points) {
    const std::array<Cell, 4> around{{{x - 1, y - 1}, {x, y - 1}, {x, y}, {x - 1, y}}};
    std::size_t present = 0, joined = 0;
    for(std::size_t i = 0; i < 4; ++i) {
      const Cell &a = around[i], &b = around[(i + 1) % 4];
      if(cells.count(a) == 0)
        continue;
      ++present;
      joined += cells.count(b) == 1 && !separates((std::min)(a, b), i % 2) ? 1 : 0;
    }
    n += present - joined + (joined == 4 ? 1 : 0);
  }
  return n;
}

// The cells of a flat soup, whose points are those of the domain.
inline Cells cells_of(const std::vector<Point_3>& points,
                      const std::vector<std::array<std::size_t, 4> >& quads)
{
  Cells result;
  for(const auto& quad : quads) {
    Cell low{1000000, 1000000};
    for(const std::size_t i : quad)
      for(std::size_t c = 0; c < 2; ++c)
        low[c] = (std::min)(low[c], int(std::lround(points[i][int(c)])));
    result.insert(low);
  }
  CHECK_EQUAL(result.size(), quads.size());
  return result;
}

inline void check(const Slit& slit, const int units, std::size_t& number_cut)
{
  const Grid_map map(test_meshes::disc(1, 1), units, units * slit.edges_in_unit);
  UV_map uv;
  const Mesh mesh = with_slit(map, slit, uv);
  Cells expected;
  for(int x = 0; x < units; ++x)
    for(int y = 0; y < units; ++y)
      if(!slit.cuts({x, y}))
        expected.insert({x, y});
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 4> > quads;
  const auto report = QR::extract_quad_soup(mesh, uv, points, quads);
  CHECK(bool(report));
  const auto separates = [&](const Cell& cell, const std::size_t direction)
                         { return slit.separates(cell, direction); };
  const bool is_right = CHECK(cells_of(points, quads) == expected);
  if(!(CHECK_EQUAL(points.size(), number_of_vertices(expected, separates)) && is_right))
    std::cerr << "  slit across " << slit.across << " at " << slit.level << " from " << slit.begin
              << " to " << slit.end << ", " << slit.edges_in_unit << " edges in a unit"
              << std::endl;
  number_cut += std::size_t(units * units) - expected.size();
}

// All slits in a small square: on the grid and off it, from the border and inside.
inline void check_all()
{
  std::size_t number = 0, number_cut = 0;
  constexpr int units = 4;
  for(const int edges_in_unit : {1, 2})
    for(const std::size_t across : {0, 1})
      for(int level = 1; level < units * edges_in_unit; ++level)
        for(int begin = 0; begin < units * edges_in_unit; ++begin)
          for(int end = begin + 2; end <= units * edges_in_unit; ++end, ++number)
            check({across, level, begin, end, edges_in_unit}, units, number_cut);
  std::cout << number << " slits cut " << number_cut << " cells" << std::endl;
  CHECK(number_cut > number);
}

// --- surfaces cut open at random -----------------------------------------------------------------

// Squares around a vertex.
inline Square_complex fan(const int number)
{
  Square_complex result;
  for(int i = 0; i < number; ++i)
    result.add_square();
  for(int i = 0; i < number; ++i)
    result.glue(i, 3, (i + 1) % number, 0);
  return result;
}

inline Square_complex random_surface(std::mt19937_64& random)
{
  const auto number = [&](const unsigned most) { return 1 + int(random() % most); };
  switch(const int a = number(3), b = number(3); random() % 8) {
  case 0: return test_meshes::disc(a + 1, b + 1);
  case 1: return test_meshes::torus(a, b);
  case 2: return test_meshes::cylinder(a, b);
  case 3: return test_meshes::box(a, b, 1);
  case 4: return fan(number(10));
  case 5: return test_meshes::notched_cube();
  case 6: return test_meshes::cone_ring(number(8));
  default: return test_meshes::genus_2();
  }
}

// Slits, loops of the border, vertices of up to 900 degrees on it; squares of 1.5 to 5.5 units,
// with charts anywhere.
inline void make_map_with_cuts(std::mt19937_64& random, Mesh& mesh)
{
  Square_complex complex = random_surface(random);
  for(int cuts = 1 + int(random() % 4); cuts > 0; --cuts)
    complex.unglue(int(random() % std::size_t(complex.number_of_squares())), int(random() % 4));
  complex.unfold(unsigned(random()));
  const auto shift = [&] { return double(random() % 1000) / 777; };
  if(random() % 2 == 0)
    for(int i = 0; i < complex.number_of_squares(); ++i)
      complex.move_chart(i, int(random() % 4), {{shift(), shift()}});
  const int n = 2 + int(random() % 3);
  square_complex::build_mesh(complex, n, (1.5 + double(random() % 1000) / 250) / n, mesh);
  const UV_map uv = square_complex::uv_map(mesh);
  const Kernel::Vector_2 by(shift(), shift());
  for(const auto h : mesh.halfedges())
    uv[h] = uv[h] + by;
}

inline CGAL::Exact_rational exact_area(const Mesh& mesh, const UV_map& uv)
{
  using Number = CGAL::Exact_rational;
  Number result(0);
  for(const auto f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    const Point_2 p = uv[h], q = uv[mesh.next(h)], r = uv[mesh.prev(h)];
    result += (Number(q.x()) - p.x()) * (Number(r.y()) - p.y()) -
              (Number(q.y()) - p.y()) * (Number(r.x()) - p.x());
  }
  return Number(result / 2);
}

// As long as no face is flipped, the cells are as many as the area says; an integer-grid map is
// what has them all. Repairs of faces that roundings have turned over make no new cones.
// Whether the report tells the changes of the coordinates of corners.
inline bool tells_changes(const QR::Snapping_report& report, const Mesh& mesh, const UV_map uv,
                          const std::vector<Point_2>& before)
{
  double largest = 0, sum = 0, squares = 0, number = 0;
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(h))
      for(int c = 0; c < 2; ++c) {
        const double change = std::abs(uv[h][c] - before[std::size_t(h)][c]);
        largest = (std::max)(largest, change);
        sum += change;
        squares += change * change;
        ++number;
      }
  const auto is_near = [](const double a, const double b) { return std::abs(a - b) <= 1e-12 * b; };
  return is_near(report.largest_change, largest) && is_near(report.mean_change, sum / number) &&
         is_near(report.rms_change, std::sqrt(squares / number));
}

inline void check_cut_surfaces()
{
  std::size_t number_complete = 0, number_off_grid = 0;
  const auto number = unsigned(test_data::trials(600));
  for(unsigned seed = 1; seed <= number; ++seed) {
    std::mt19937_64 random(seed);
    Mesh mesh;
    make_map_with_cuts(random, mesh);
    const UV_map uv = square_complex::uv_map(mesh);
    const bool align = seed % 4 != 0;
    std::vector<Point_2> before;
    for(const auto h : mesh.halfedges())
      before.push_back(uv[h]);
    const auto seams = QR::measure_seamlessness(mesh, uv);
    const auto snapped = QR::snap_to_seamless(
      mesh, uv, QR::parameters::integer_grid(true).align_border(align).rounding_tolerance(100.));
    bool is_right = CHECK(bool(snapped)) && CHECK(tells_changes(snapped, mesh, uv, before)) &&
                    CHECK_EQUAL(snapped.extent, seams.extent) &&
                    CHECK(snapped.violation_before >= seams.violation - 1e-12 * seams.extent);
    if(!is_right || !snapped.lost_faces.empty())
      continue;
    std::vector<Point_3> points;
    std::vector<std::array<std::size_t, 4> > quads;
    const auto report = QR::extract_quad_soup(mesh, uv, points, quads);
    const bool is_complete = CGAL::Exact_rational(int(quads.size())) == exact_area(mesh, uv);
    is_right = CHECK_EQUAL(bool(QR::is_integer_grid_map(mesh, uv)), is_complete);
    is_right = CHECK(is_complete || !align) && is_right;
    is_right = CHECK_EQUAL(report.message.empty(), is_complete) && is_right;
    if(!is_right)
      std::cerr << "  seed " << seed << ": " << report.message << std::endl;
    ++(is_complete ? number_complete : number_off_grid);
  }
  std::cout << number_complete << " surfaces cut open are complete, " << number_off_grid
            << " are not" << std::endl;
  CHECK(12 * number_complete > 7 * number && 12 * number_off_grid > number);
}

} // namespace slits

#endif // SEAMLESS_SNAPPING_TEST_SLIT_CHECKS_H
