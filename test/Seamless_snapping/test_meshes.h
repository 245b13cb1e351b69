// Small meshes with exactly seamless uv maps, one for each kind of cut, node, branch, border and
// alignment that the tests have to see, and noise to make the maps inexact again.
//
// A mesh has its uv map in the property "h:uv" and its feature edges in "e:feature". Coordinates
// are integers times powers of two and fit into floats too.

#ifndef SEAMLESS_SNAPPING_TEST_TEST_MESHES_H
#define SEAMLESS_SNAPPING_TEST_TEST_MESHES_H

#include "Square_complex.h"
#include "Square_complex_mesh.h"
#include "uv_noise.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace test_meshes {

using square_complex::feature_map;
using square_complex::planar_cells;
using square_complex::Side;
using square_complex::Square_complex;
using square_complex::uv_map;
using square_complex::voxel_surface;

struct Everywhere
{
  template <typename... Indices>
  bool operator()(Indices...) const
  {
    return true;
  }
};

// --- surfaces without a cone ---------------------------------------------------------------------

// A flat torus: two cut loops of pure translations that cross in one node, where both of them start
// and end.
inline Square_complex torus(int width, int height)
{
  Square_complex result = planar_cells(width, height, Everywhere());
  for(int y = 0; y < height; ++y)
    result.glue(y * width + width - 1, 1, y * width, 3);
  for(int x = 0; x < width; ++x)
    result.glue((height - 1) * width + x, 2, x, 0);
  return result;
}

// Both borders, and a cut of pure translation that runs from one to the other.
inline Square_complex cylinder(int circumference, int height)
{
  Square_complex result = planar_cells(circumference, height, Everywhere());
  for(int y = 0; y < height; ++y)
    result.glue(y * circumference + circumference - 1, 1, y * circumference, 3);
  return result;
}

inline Square_complex disc(int width, int height)
{
  return planar_cells(width, height, Everywhere());
}

// A ring around a missing cone of the given number of quarter turns: going round turns the chart by
// them, 4 being a flat ring without any cut.
inline Square_complex cone_ring(int quarter_turns)
{
  Square_complex result;
  for(int q = 0; q < quarter_turns; ++q) {
    const int right = result.add_square(), middle = result.add_square(), up = result.add_square();
    result.square(right).base = { { 1, 0, q } };
    result.square(middle).base = { { 1, 1, q } };
    result.square(up).base = { { 0, 1, q } };
    result.glue(right, 2, middle, 0);
    result.glue(middle, 3, up, 1);
  }
  for(int q = 0; q < quarter_turns; ++q)
    result.glue(3 * q + 2, 3, 3 * ((q + 1) % quarter_turns), 0);
  result.unfold();
  return result;
}

// Three borders. Its right third has a chart of its own, so that cuts run from border to border.
inline Square_complex pair_of_pants()
{
  Square_complex result =
    planar_cells(5, 3, [](int x, int y) { return y != 1 || (x != 1 && x != 3); });
  for(int i = 0; i < result.number_of_squares(); ++i)
    if(result.square(i).base[0] >= 3)
      result.move_chart(i, 1, { { 16, 0 } });
  return result;
}

// A square-tiled surface of genus 2: an L of three squares, opposite sides glued. Translations
// only, and one vertex of 12 quarters.
inline Square_complex genus_2()
{
  Square_complex result = planar_cells(2, 2, [](int x, int y) { return x + y < 2; });
  result.glue(1, 1, 0, 3); // the row of two
  result.glue(2, 1, 2, 3); // the upper one to itself
  result.glue(2, 2, 0, 0); // the column of two
  result.glue(1, 2, 1, 0); // the right one to itself
  return result;
}

// A square of cells whose middle has a chart of its own: a closed cut without a node, around a
// disc, or around the hole of a ring.
inline Square_complex island(int rotation, const square_complex::Vector_2& translation, bool is_ring)
{
  Square_complex result =
    planar_cells(5, 5, [=](int x, int y) { return !is_ring || x != 2 || y != 2; });
  for(int i = 0; i < result.number_of_squares(); ++i) {
    const auto& base = result.square(i).base;
    if(base[0] >= 1 && base[0] <= 3 && base[1] >= 1 && base[1] <= 3)
      result.move_chart(i, rotation, translation);
  }
  return result;
}

// Two islands that touch in one vertex: branches that start and end at the same node.
inline Square_complex two_islands()
{
  Square_complex result = disc(4, 4);
  result.move_chart(5, 1, { { 16, 2 } });
  result.move_chart(10, 2, { { 0, 16 } });
  return result;
}

// --- surfaces with cones -------------------------------------------------------------------------

// Two squares back to back; with n = 1 it is a tetrahedron. Four cones of half a turn.
inline Square_complex tetrahedron()
{
  Square_complex result;
  result.add_square();
  result.add_square({ { 1, 0, 0 } }, { { -1, 0, 0 } }, { { 0, 1, 0 } });
  result.glue_in_space();
  result.unfold();
  return result;
}

// Eight cones of three quarters.
inline Square_complex box(int x, int y, int z)
{
  Square_complex result = voxel_surface({ { x, y, z } }, Everywhere());
  result.unfold();
  return result;
}

// The sides where a box has its creases.
inline void mark_creases(Square_complex& complex)
{
  for(int i = 0; i < complex.number_of_squares(); ++i) {
    for(int s = 0; s < 4; ++s) {
      const Side o = complex.across(i, s);
      if(o.is_border())
        continue;
      const auto &a = complex.square(i), &b = complex.square(o.square);
      const auto normal = [](const square_complex::Square& q, std::size_t d) {
        return q.along[(d + 1) % 3] * q.up[(d + 2) % 3] - q.along[(d + 2) % 3] * q.up[(d + 1) % 3];
      };
      int cosine = 0;
      for(std::size_t d = 0; d < 3; ++d)
        cosine += normal(a, d) * normal(b, d);
      if(cosine == 0)
        complex.set_feature(i, s);
    }
  }
}

// A box with three square holes: cones, and cuts that end on borders.
inline Square_complex box_with_holes()
{
  Square_complex whole = voxel_surface({ { 3, 3, 3 } }, Everywhere());
  Square_complex result;
  for(int i = 0; i < whole.number_of_squares(); ++i) {
    const square_complex::Square& q = whole.square(i);
    bool is_middle = true; // of one of the faces that look away from the origin
    int at_three = 0;
    for(std::size_t d = 0; d < 3; ++d) {
      const int twice_centre = 2 * q.base[d] + q.along[d] + q.up[d];
      at_three += twice_centre == 6 ? 1 : 0;
      is_middle = is_middle && (twice_centre == 6 || twice_centre == 3);
    }
    if(!is_middle || at_three != 1)
      result.add_square(q.base, q.along, q.up);
  }
  result.glue_in_space();
  result.unfold();
  return result;
}

// A corner cut out of a cube: cones of three and of five quarters.
inline Square_complex notched_cube()
{
  Square_complex result =
    voxel_surface({ { 2, 2, 2 } }, [](int x, int y, int z) { return x + y + z < 3; });
  result.unfold();
  return result;
}

// A slab with two holes: genus 2 with cones of three and of five quarters.
inline Square_complex double_torus()
{
  Square_complex result = voxel_surface(
    { { 5, 3, 1 } }, [](int x, int y, int) { return y != 1 || (x != 1 && x != 3); });
  result.unfold();
  return result;
}

// --- charts and features -------------------------------------------------------------------------

// Gives every square a chart of its own: every side becomes a cut.
inline void scatter_charts(Square_complex& complex)
{
  for(int i = 0; i < complex.number_of_squares(); ++i)
    complex.move_chart(i, i % 4, { { double(7 * (i % 5)), double(11 * (i % 3)) } });
}

// Marks the sides that lie between two lattice points of one row or column of planar cells.
inline void mark_segment(Square_complex& complex, int x0, int y0, int x1, int y1)
{
  for(int i = 0; i < complex.number_of_squares(); ++i) {
    const int x = complex.square(i).base[0], y = complex.square(i).base[1];
    if(y0 == y1 && x >= x0 && x < x1 && (y == y0 || y + 1 == y0))
      complex.set_feature(i, y == y0 ? 0 : 2);
    if(x0 == x1 && y >= y0 && y < y1 && (x == x0 || x + 1 == x0))
      complex.set_feature(i, x == x0 ? 3 : 1);
  }
}

// Features that cross, end inside, turn a corner and reach the border.
inline void mark_all_kinds_of_features(Square_complex& complex)
{
  mark_segment(complex, 1, 2, 4, 2); // crosses the next one, both ends inside
  mark_segment(complex, 2, 1, 2, 3);
  mark_segment(complex, 1, 4, 3, 4); // turns a corner
  mark_segment(complex, 3, 3, 3, 4);
  mark_segment(complex, 4, 0, 4, 1); // starts at the border
}

// --- the collection ------------------------------------------------------------------------------

struct Recipe
{
  std::string name;
  Square_complex complex;
  int divisions;     // of a square's side: 2 * divisions^2 faces a square
  bool align_border; // the border runs along isocurves and may be aligned
};

inline std::vector<Recipe> recipes()
{
  std::vector<Recipe> result;
  const auto add = [&](const std::string& name, const Square_complex& complex, int divisions,
                       bool align_border = false) {
    result.push_back({ name, complex, divisions, align_border });
  };

  add("disc", disc(3, 2), 1);
  add("disc with aligned border", disc(3, 2), 2, true);
  add("tetrahedron", tetrahedron(), 1);
  add("divided tetrahedron", tetrahedron(), 4);
  add("cube", box(1, 1, 1), 1);
  add("divided cube", box(1, 1, 1), 3);
  add("long box", box(3, 2, 1), 1);
  add("cylinder", cylinder(5, 2), 1);
  add("cylinder with aligned borders", cylinder(4, 2), 2, true);
  add("torus", torus(3, 3), 1);
  add("divided torus", torus(4, 3), 2);
  add("pair of pants", pair_of_pants(), 1);
  add("box with three holes", box_with_holes(), 1, true);
  add("notched cube", notched_cube(), 1);
  add("genus 2 of translations", genus_2(), 3);
  add("genus 2 with cones", double_torus(), 1);
  for(int turns = 1; turns <= 6; ++turns)
    add("ring of " + std::to_string(turns) + " quarters", cone_ring(turns), turns < 3 ? 2 : 1,
        turns % 2 == 0);

  add("closed cut around a disc, translation", island(0, { { 8, 0.5 } }, false), 1);
  add("closed cut around a disc, rotation", island(1, { { 12, 0 } }, false), 1);
  add("closed cut around a hole, translation", island(0, { { 8, 0 } }, true), 1);
  add("closed cut around a hole, half turn", island(2, { { 16, 0.25 } }, true), 1, true);
  add("closed cut of tiny translation", island(0, { { std::ldexp(1., -20), 0 } }, true), 1);
  add("two islands", two_islands(), 2);

  Square_complex complex = disc(5, 5);
  mark_all_kinds_of_features(complex);
  add("disc with features", complex, 1, true);
  complex = island(1, { { 12, 0 } }, false);
  mark_all_kinds_of_features(complex);
  add("features across and along a cut", complex, 1);
  complex = box(1, 1, 1);
  mark_creases(complex);
  add("cube with creases", complex, 2);
  complex = notched_cube();
  mark_creases(complex);
  add("notched cube with creases", complex, 1);

  complex = box(2, 1, 1);
  scatter_charts(complex);
  add("box of scattered charts", complex, 1);
  complex = torus(3, 3);
  scatter_charts(complex);
  add("torus of scattered charts", complex, 1);
  complex = pair_of_pants();
  scatter_charts(complex);
  add("pants of scattered charts", complex, 2, true);

  complex = box(1, 1, 1);
  complex.append(torus(3, 3));
  complex.append(disc(2, 2));
  add("three components", complex, 1);
  return result;
}

template <typename Kernel>
CGAL::Surface_mesh<typename Kernel::Point_3> make_mesh(const Square_complex& complex,
                                                       int divisions, double scale = 0.125)
{
  CGAL::Surface_mesh<typename Kernel::Point_3> result;
  square_complex::build_mesh(complex, divisions, scale, result);
  return result;
}

template <typename Kernel>
struct Named_mesh
{
  std::string name;
  bool align_border;
  CGAL::Surface_mesh<typename Kernel::Point_3> mesh;
};

// All of them, from 4 to some 200 faces.
template <typename Kernel>
std::vector<Named_mesh<Kernel> > all_meshes()
{
  std::vector<Named_mesh<Kernel> > result;
  for(const Recipe& recipe : recipes())
    result.push_back({ recipe.name, recipe.align_border,
                       make_mesh<Kernel>(recipe.complex, recipe.divisions) });
  return result;
}

// A closed cut around a hole whose sides differ by a translation of 2^-30 of a side: about 1e-9, far
// above the noise of 1e-17 that it is to be told from, far below what looks like a translation.
// For doubles only.
template <typename Kernel>
Named_mesh<Kernel> tiny_translation()
{
  return { "cut of translation 2^-30", false,
           make_mesh<Kernel>(island(0, { { std::ldexp(1., -30), 0 } }, true), 1, 0.25) };
}

// Warps the uv map of a test mesh (see uv_noise.h); vertices on features and, where the border may
// be aligned, on the border stay.
template <typename Kernel>
void warp(Named_mesh<Kernel>& named, unsigned int seed, double size = 0.125 / 8)
{
  auto& mesh = named.mesh;
  const auto features = feature_map(mesh);
  uv_noise::warp(mesh, uv_map(mesh), size, seed, [&](const auto& v) {
    for(const auto h : CGAL::halfedges_around_target(v, mesh)) {
      const bool is_on_border = mesh.is_border(mesh.edge(h));
      if(features[mesh.edge(h)] || (named.align_border && is_on_border))
        return true;
    }
    return false;
  });
}

// The same surface as a polyhedron, whose uv map is a dynamic property and whose feature edges are
// another.
template <typename Kernel>
class Polyhedron_copy
{
public:
  using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
  using UV_map = typename boost::property_map<
    Polyhedron, CGAL::dynamic_halfedge_property_t<typename Kernel::Point_2> >::type;
  using Feature_map =
    typename boost::property_map<Polyhedron, CGAL::dynamic_edge_property_t<bool> >::type;

  explicit Polyhedron_copy(const CGAL::Surface_mesh<typename Kernel::Point_3>& original)
  {
    using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
    using Pair = std::pair<typename boost::graph_traits<Mesh>::halfedge_descriptor,
                           typename boost::graph_traits<Polyhedron>::halfedge_descriptor>;
    Mesh mesh = original;
    std::vector<Pair> halfedge_pairs;
    CGAL::copy_face_graph(
      mesh, polyhedron,
      CGAL::parameters::halfedge_to_halfedge_output_iterator(std::back_inserter(halfedge_pairs)));
    CGAL::set_halfedgeds_items_id(polyhedron);
    uv = get(CGAL::dynamic_halfedge_property_t<typename Kernel::Point_2>(), polyhedron);
    is_feature = get(CGAL::dynamic_edge_property_t<bool>(), polyhedron);
    const auto original_uv = uv_map(mesh);
    const auto original_features = feature_map(mesh);
    for(const Pair& pair : halfedge_pairs) {
      put(uv, pair.second, original_uv[pair.first]);
      put(is_feature, CGAL::edge(pair.second, polyhedron),
          original_features[mesh.edge(pair.first)]);
    }
  }

  Polyhedron_copy(const Polyhedron_copy&) = delete; // the maps refer to the member
  Polyhedron_copy& operator=(const Polyhedron_copy&) = delete;

  Polyhedron polyhedron;
  UV_map uv;
  Feature_map is_feature;
};

} // namespace test_meshes

#endif // SEAMLESS_SNAPPING_TEST_TEST_MESHES_H
