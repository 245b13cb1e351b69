// Unit squares glued along their sides, unfolded into the plane and cut into triangles: what the
// generators of test and benchmark meshes stand on. Where the charts of two glued squares don't
// match, the sides are a cut, related by a rotation by a multiple of 90 degrees and a translation;
// all coordinates are small integers times a power of two, so that the uv map is exactly seamless.

#ifndef SEAMLESS_SNAPPING_TEST_SQUARE_COMPLEX_H
#define SEAMLESS_SNAPPING_TEST_SQUARE_COMPLEX_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

namespace square_complex {

using Vector_2 = std::array<double, 2>;
using Lattice_point = std::array<int, 3>;

// Counterclockwise by k quarter turns.
inline Vector_2 rotated(const Vector_2& v, int k)
{
  switch(((k % 4) + 4) % 4) {
    case 0: return v;
    case 1: return { -v[1], v[0] };
    case 2: return { -v[0], -v[1] };
    default: return { v[1], -v[0] };
  }
}

// Side s runs from corner s to corner s + 1 of (0,0), (1,0), (1,1), (0,1).
struct Side
{
  int square = -1; // -1: a border
  int side = 0;

  bool is_border() const { return square < 0; }
};

struct Square
{
  std::array<Side, 4> across;
  std::array<bool, 4> is_feature = { { false, false, false, false } };

  // The chart: p is at rotated(p, rotation) + origin, in units of one side.
  int rotation = 0;
  Vector_2 origin = { { 0, 0 } };

  // Its place in space.
  Lattice_point base = { { 0, 0, 0 } }, along = { { 1, 0, 0 } }, up = { { 0, 1, 0 } };
};

inline Vector_2 corner_of_unit_square(int s)
{
  static const std::array<Vector_2, 4> corners = { { { { 0, 0 } }, { { 1, 0 } }, { { 1, 1 } },
                                                     { { 0, 1 } } } };
  return corners[static_cast<std::size_t>(s & 3)];
}

// Invariant: gluing is symmetric, and glued sides run in opposite directions (the surface is
// orientable).
class Square_complex
{
public:
  int number_of_squares() const { return static_cast<int>(m_squares.size()); }
  const Square& square(int i) const { return m_squares[static_cast<std::size_t>(i)]; }
  Square& square(int i) { return m_squares[static_cast<std::size_t>(i)]; }

  const Side& across(int i, int s) const
  {
    return square(i).across[static_cast<std::size_t>(s & 3)];
  }

  int add_square(const Lattice_point& base = { { 0, 0, 0 } },
                 const Lattice_point& along = { { 1, 0, 0 } },
                 const Lattice_point& up = { { 0, 1, 0 } })
  {
    Square square;
    square.base = base;
    square.along = along;
    square.up = up;
    m_squares.push_back(square);
    return number_of_squares() - 1;
  }

  void glue(int i, int s, int j, int t)
  {
    side(i, s) = { j, t };
    side(j, t) = { i, s };
  }

  // Glues sides that lie at the same place in space, of squares that are oriented alike.
  void glue_in_space();

  // Both sides become borders.
  void unglue(int i, int s)
  {
    const Side other = across(i, s);
    side(i, s) = Side();
    if(!other.is_border())
      side(other.square, other.side) = Side();
  }

  // Marks the side as feature, seen from both squares.
  void set_feature(int i, int s)
  {
    square(i).is_feature[static_cast<std::size_t>(s)] = true;
    const Side other = across(i, s);
    if(!other.is_border())
      square(other.square).is_feature[static_cast<std::size_t>(other.side)] = true;
  }

  // Lays out a spanning tree of the squares of each component, so that tree sides need no cut:
  // breadth first, or grown at random if the seed is not 0.
  void unfold(unsigned int seed = 0);

  // Moves the chart of one square: its sides become cuts unless its neighbours move alike.
  void move_chart(int i, int rotation, const Vector_2& translation)
  {
    Square& moved = square(i);
    const Vector_2 turned = rotated(moved.origin, rotation);
    moved.rotation = (moved.rotation + rotation) & 3;
    moved.origin = { { turned[0] + translation[0], turned[1] + translation[1] } };
  }

  // Appends a copy of another complex.
  void append(const Square_complex& other)
  {
    const int offset = number_of_squares();
    for(Square square : other.m_squares) {
      for(Side& side : square.across)
        if(!side.is_border())
          side.square += offset;
      m_squares.push_back(square);
    }
  }

private:
  Side& side(int i, int s) { return square(i).across[static_cast<std::size_t>(s)]; }

  Lattice_point corner_in_space(int i, int s) const
  {
    const Square& q = square(i);
    const Vector_2 c = corner_of_unit_square(s);
    Lattice_point result = q.base;
    for(std::size_t d = 0; d < 3; ++d)
      result[d] += (c[0] > 0 ? q.along[d] : 0) + (c[1] > 0 ? q.up[d] : 0);
    return result;
  }

  // Puts the square beyond side s of i next to it.
  void place_beyond(int i, int s)
  {
    const Side other = across(i, s);
    const Square& here = square(i);
    Square& there = square(other.square);
    there.rotation = (here.rotation + s - other.side + 2) & 3;
    const Vector_2 from = rotated(corner_of_unit_square(s), here.rotation);
    const Vector_2 to = rotated(corner_of_unit_square(other.side + 1), there.rotation);
    there.origin = { { here.origin[0] + from[0] - to[0], here.origin[1] + from[1] - to[1] } };
  }

  std::vector<Square> m_squares;
};

inline void Square_complex::glue_in_space()
{
  struct Directed_side
  {
    Lattice_point low, high;
    bool ascends;
    Side side;
  };
  std::vector<Directed_side> sides;
  sides.reserve(4 * m_squares.size());
  for(int i = 0; i < number_of_squares(); ++i) {
    for(int s = 0; s < 4; ++s) {
      const Lattice_point a = corner_in_space(i, s), b = corner_in_space(i, s + 1);
      sides.push_back({ (std::min)(a, b), (std::max)(a, b), a < b, { i, s } });
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Directed_side& a, const Directed_side& b) {
    return std::tie(a.low, a.high) < std::tie(b.low, b.high);
  });
  for(std::size_t k = 1; k < sides.size(); ++k) {
    const Directed_side &a = sides[k - 1], &b = sides[k];
    if(a.low == b.low && a.high == b.high && a.ascends != b.ascends
       && across(a.side.square, a.side.side).is_border())
      glue(a.side.square, a.side.side, b.side.square, b.side.side);
  }
}

inline void Square_complex::unfold(unsigned int seed)
{
  std::mt19937_64 random(seed);
  std::vector<bool> is_placed(m_squares.size(), false);
  double next_root = 0; // side by side, for the eye only
  for(int root = 0; root < number_of_squares(); ++root) {
    if(is_placed[static_cast<std::size_t>(root)])
      continue;
    square(root).rotation = 0;
    square(root).origin = { { next_root, 0 } };
    next_root += 8;
    is_placed[static_cast<std::size_t>(root)] = true;
    std::deque<int> front(1, root);
    while(!front.empty()) {
      if(seed != 0)
        std::swap(front.front(), front[static_cast<std::size_t>(random() % front.size())]);
      const int i = front.front();
      front.pop_front();
      for(int s = 0; s < 4; ++s) {
        const Side other = across(i, s);
        if(other.is_border() || is_placed[static_cast<std::size_t>(other.square)])
          continue;
        place_beyond(i, s);
        is_placed[static_cast<std::size_t>(other.square)] = true;
        front.push_back(other.square);
      }
    }
  }
}

// The boundary of the cells (x,y,z) of a box for which is_filled holds, glued, not yet unfolded.
template <typename IsFilled>
Square_complex voxel_surface(const Lattice_point& size, const IsFilled& is_filled)
{
  Square_complex result;
  const auto filled = [&](const Lattice_point& c) {
    for(std::size_t d = 0; d < 3; ++d)
      if(c[d] < 0 || c[d] >= size[d])
        return false;
    return bool(is_filled(c[0], c[1], c[2]));
  };
  const auto unit = [](std::size_t d) {
    Lattice_point e = { { 0, 0, 0 } };
    e[d % 3] = 1;
    return e;
  };
  Lattice_point c;
  for(c[2] = 0; c[2] < size[2]; ++c[2]) {
    for(c[1] = 0; c[1] < size[1]; ++c[1]) {
      for(c[0] = 0; c[0] < size[0]; ++c[0]) {
        for(std::size_t d = 0; d < 3 && filled(c); ++d) {
          Lattice_point beyond = c, before = c;
          ++beyond[d];
          --before[d];
          if(!filled(beyond))
            result.add_square(beyond, unit(d + 1), unit(d + 2));
          if(!filled(before))
            result.add_square(c, unit(d + 2), unit(d + 1));
        }
      }
    }
  }
  result.glue_in_space();
  return result;
}

// The cells (x,y) of a rectangle for which is_filled holds, in one chart.
template <typename IsFilled>
Square_complex planar_cells(int width, int height, const IsFilled& is_filled)
{
  Square_complex result;
  for(int y = 0; y < height; ++y) {
    for(int x = 0; x < width; ++x) {
      if(!is_filled(x, y))
        continue;
      const int i = result.add_square({ { x, y, 0 } });
      result.square(i).origin = { { double(x), double(y) } };
    }
  }
  result.glue_in_space();
  return result;
}

} // namespace square_complex

#endif // SEAMLESS_SNAPPING_TEST_SQUARE_COMPLEX_H
