// The surfaces that the test meshes are made of, as glued squares: one for each kind of cut, node,
// branch, border and alignment.

#ifndef SEAMLESS_SNAPPING_TEST_TEST_SURFACES_H
#define SEAMLESS_SNAPPING_TEST_TEST_SURFACES_H

#include "Square_complex.h"

#include <cstddef>

namespace test_meshes {

using square_complex::planar_cells;
using square_complex::Side;
using square_complex::Square_complex;
using square_complex::Vector_2;
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
inline Square_complex island(int rotation, const Vector_2& translation, bool is_ring)
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

} // namespace test_meshes

#endif // SEAMLESS_SNAPPING_TEST_TEST_SURFACES_H
