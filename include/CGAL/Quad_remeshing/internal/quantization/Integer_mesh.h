// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_INTEGER_MESH_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_INTEGER_MESH_H

#include <CGAL/license/Quad_remeshing.h>

// A parametrized surface in integers: a vector along each halfedge, in the chart of its face, and
// the rotation of the transition across each edge. Translations are gone, and with them the charts'
// origins. Sums of vectors throw where they don't fit, and signs of products are exact.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Linear_snapping/internal/exact/checked_integer.h>
#include <CGAL/Quad_remeshing/internal/cells/Surface_parts.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Seamless_snapping/internal/mesh/Flat_mesh.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

using Grid_vector = std::array<std::int64_t, 2>;

inline Grid_vector negated(const Grid_vector& a) { return {-a[0], -a[1]}; }

inline Grid_vector multiplied(const std::int64_t factor, const Grid_vector& a)
{ return {checked_product(factor, a[0]), checked_product(factor, a[1])}; }

inline Grid_vector sum(const Grid_vector& a, const Grid_vector& b)
{
  return {checked_difference(a[0], -b[0]), checked_difference(a[1], -b[1])};
}

using Linear_snapping::internal::difference; // and of vectors:

inline Grid_vector difference(const Grid_vector& a, const Grid_vector& b)
{
  return {checked_difference(a[0], b[0]), checked_difference(a[1], b[1])};
}

inline Grid_vector rotated(const Quarter_turns::Element g, const Grid_vector& a)
{
  return Quarter_turns::apply(g, a);
}

// The unit vector in one of the four directions.
inline Grid_vector unit_vector(const int direction)
{
  return rotated(Quarter_turns::element(direction), Grid_vector{1, 0});
}

// a x b where the result fits; throws where it doesn't.
inline std::int64_t cross_product(const Grid_vector& a, const Grid_vector& b)
{
  return checked_difference(checked_product(a[0], b[1]), checked_product(a[1], b[0]));
}

inline BOOST_NOINLINE Exact_integer exact_cross(const Grid_vector& a, const Grid_vector& b)
{
  const auto exact = [](const std::int64_t x) { return from_64_bits<Exact_integer>(x); };
  return difference(product(exact(a[0]), exact(b[1])), product(exact(a[1]), exact(b[0])));
}

// The sign of a x b. Each product has a relative error of at most 4 roundings.
inline int cross_sign(const Grid_vector& a, const Grid_vector& b)
{
  const double p = static_cast<double>(a[0]) * static_cast<double>(b[1]);
  const double q = static_cast<double>(a[1]) * static_cast<double>(b[0]);
  if(std::abs(p - q) > 1e-15 * (std::abs(p) + std::abs(q)))
    return p > q ? 1 : -1;
  return p == 0 && q == 0 ? 0 : int(CGAL::sign(exact_cross(a, b)));
}

// Whether two vectors on a line through 0 point to opposite sides.
inline bool are_opposite(const Grid_vector& a, const Grid_vector& b)
{
  const std::size_t c = a[0] != 0 ? 0 : 1;
  return cross_sign(a, b) == 0 && (a[c] > 0) != (b[c] > 0) && b[c] != 0;
}

// The quadrant that contains the vector, which is not null, each with the axis at its clockwise
// end.
inline int quadrant(const Grid_vector& a)
{
  if(a[0] > 0 && a[1] >= 0)
    return 0;
  if(a[0] <= 0 && a[1] > 0)
    return 1;
  return a[0] < 0 && a[1] <= 0 ? 2 : 3;
}

// By how many axes a vector passes that turns from `first` to `last`, counterclockwise, by less
// than 180 degrees.
inline int axes_between(const Grid_vector& first, const Grid_vector& last)
{
  return Quarter_turns::turns(Quarter_turns::element(quadrant(last) - quadrant(first)));
}

inline double dot(const Grid_vector& a, const Grid_vector& b)
{
  return static_cast<double>(a[0]) * static_cast<double>(b[0]) +
         static_cast<double>(a[1]) * static_cast<double>(b[1]);
}

inline double approximate_cross(const Grid_vector& a, const Grid_vector& b)
{
  return static_cast<double>(a[0]) * static_cast<double>(b[1]) -
         static_cast<double>(a[1]) * static_cast<double>(b[0]);
}

inline double length(const Grid_vector& a)
{
  return std::hypot(static_cast<double>(a[0]), static_cast<double>(a[1]));
}

struct Integer_corner : Flat_corner
{
  Integer_corner() : Flat_corner{no_index, no_index} { }

  Grid_vector vector{};  // from the source of the halfedge to its target
  Quarter_turns::Element rotation = Quarter_turns::identity(); // to the chart of the opposite face
  bool is_wall = false; // on the border, or a feature: it lies on an isocurve, and stays there
};

// Invariant: the vectors of each face add up to 0 and turn left, the vectors of the two sides of an
// edge are opposite up to the rotation, and one coordinate of each wall is 0.
struct Integer_mesh : Flat_mesh<Integer_corner>
{
  std::vector<double> steps;      // per connected part: the length of one unit in the domain
  std::vector<std::int32_t> part; // per face
};

// The corner of a vertex that contains a direction, and the direction in the chart of its face.
struct Direction_at_corner
{
  Corner_index corner = no_index;
  Quarter_turns::Element turns = Quarter_turns::identity(); // to the chart of that corner's face
};

// Turns on, counterclockwise, until `vector` lies before the last edge of the corner. It must lie
// less than 180 degrees behind the first edge of `at.corner`. `turned` carries whatever belongs to
// the chart along.
template <typename Turn>
void turn_to(const Integer_mesh& mesh, Corner_index& corner, Grid_vector& vector,
             const Turn& turned)
{
  while(cross_sign(negated(mesh.corner(corner).vector), vector) >= 0 &&
        mesh.opposite(corner) != no_index) {
    const Quarter_turns::Element rotation = mesh.corner(corner).rotation;
    vector = rotated(rotation, vector);
    turned(rotation);
    corner = mesh.counterclockwise(corner);
  }
}

// Whether `b` lies less than 180 degrees counterclockwise of `a`, or in the same direction.
inline bool is_counterclockwise(const Grid_vector& a, const Grid_vector& b)
{
  const int sign = cross_sign(a, b);
  return sign > 0 || (sign == 0 && !are_opposite(a, b));
}

// The direction of `vector`, which is less than a whole turn counterclockwise of the known
// direction of `from`.
inline Direction_at_corner find_direction(const Integer_mesh& mesh, Direction_at_corner known,
                                          Grid_vector from, const Grid_vector& vector)
{
  const auto turn = [&](const Grid_vector& direction) {
    Grid_vector here = rotated(known.turns, direction);
    turn_to(mesh, known.corner, here, [&](const Quarter_turns::Element rotation)
            { known.turns = Quarter_turns::compose(rotation, known.turns); });
  };
  while(!is_counterclockwise(from, vector)) {
    from = rotated(Quarter_turns::element(1), from);
    turn(from);
  }
  turn(vector);
  return known;
}

// From an exactly seamless map in doubles to vectors of integers.

// The exponent of the lowest bit of a number that is not 0.
inline int lowest_bit(const double x)
{
  int exponent = 0;
  const std::int64_t significand = std::int64_t(std::ldexp(std::frexp(x, &exponent), 53));
  return exponent - 53 + number_of_halvings(significand);
}

// A grid of integers for each connected part of the surface. Translations and cones have to lie on
// it, as in a snapped map. Other coordinates may have any bits: they are rounded to the
// grid, the same in all charts, which changes no transition.
class Integer_reader
{
public:
  static constexpr int most_bits = 59; // of a coordinate: sums of vectors have to fit as well

  Integer_reader(const Chart_mesh& mesh, const std::vector<char>& is_feature)
    : m_mesh(mesh), m_is_feature(is_feature), m_parts(mesh)
  { }

  // Fills the mesh; returns false if `unrepresentable_vertex` doesn't lie on a grid of integers.
  bool read(Integer_mesh& result)
  {
    if(!choose_grids())
      return false;
    find_points();
    result.corner_at_vertex = m_mesh.corner_at_vertex;
    result.is_border = m_mesh.is_border;
    for(const int e : m_exponents)
      result.steps.push_back(std::ldexp(1., e));
    for(std::size_t f = 0; f < m_mesh.corners.size() / 3; ++f)
      result.part.push_back(std::int32_t(m_parts.part_of_face(f)));
    result.corners.resize(m_mesh.corners.size());
    for(Corner_index h = 0; h < m_mesh.number_of_halfedges(); ++h) {
      Integer_corner& corner = result.corners[std::size_t(h)];
      static_cast<Flat_corner&>(corner) = m_mesh.corner(h);
      corner.vector =
        difference(m_points[std::size_t(h)], m_points[std::size_t(Chart_mesh::prev(h))]);
      corner.rotation = m_mesh.rotation(h);
      corner.is_wall = is_wall(h, corner.vector);
    }
    return true;
  }

  std::size_t unrepresentable_vertex = 0;
  std::size_t number_of_unaligned_features = 0;

private:
  static constexpr int no_bit = (std::numeric_limits<int>::max)();

  static int lowest_bit(const double x) { return x == 0 ? no_bit : internal::lowest_bit(x); }

  bool choose_grids()
  {
    std::vector<int> largest(m_parts.size(), (std::numeric_limits<int>::min)());
    std::vector<int> needed(m_parts.size(), no_bit);
    std::vector<std::size_t> vertex(m_parts.size(), 0);
    m_exponents.assign(m_parts.size(), no_bit);
    for(Corner_index h = 0; h < m_mesh.number_of_halfedges(); ++h) {
      const std::size_t part = m_parts.part_of_face(std::size_t(h / 3));
      const int bit = lowest_needed_bit(h);
      if(bit < needed[part]) {
        needed[part] = bit;
        vertex[part] = m_mesh.vertex(h);
      }
      for(const double u : m_mesh.uv(h))
        if(u != 0) {
          largest[part] = (std::max)(largest[part], std::ilogb(u));
          m_exponents[part] = (std::min)(m_exponents[part], lowest_bit(u));
        }
    }
    for(std::size_t part = 0; part < m_parts.size(); ++part) {
      m_exponents[part] =
        (std::max)((std::min)(m_exponents[part], needed[part]), largest[part] + 1 - most_bits);
      unrepresentable_vertex = vertex[part];
      if(needed[part] < m_exponents[part])
        return false;
    }
    return true;
  }

  // Whether the transitions around a vertex leave it no other place.
  bool is_fixed(const std::size_t v) const
  {
    Quarter_turns::Element turn = Quarter_turns::identity();
    if(m_mesh.is_singular[v])
      for_each_corner(m_mesh, v, [&](const Corner_index h)
                      { turn = Quarter_turns::compose(m_mesh.rotation(h), turn); });
    return turn != Quarter_turns::identity();
  }

  // The lowest bit of the translation across the halfedge, and of its target if it is fixed.
  int lowest_needed_bit(const Corner_index h) const
  {
    int bit = no_bit;
    if(m_mesh.corner(h).transition != no_index)
      for(const Exact_difference& t :
          m_mesh.transitions[std::size_t(m_mesh.corner(h).transition)].translation)
        bit = (std::min)({bit, lowest_bit(t.rounded), lowest_bit(t.error)});
    if(is_fixed(m_mesh.vertex(h)))
      for(const double u : m_mesh.uv(h))
        bit = (std::min)(bit, lowest_bit(u));
    return bit;
  }

  // Each vertex in the chart of its first corner, and from there in the others.
  void find_points()
  {
    m_points.resize(m_mesh.corners.size());
    for(std::size_t v = 0; v < m_mesh.number_of_vertices(); ++v) {
      const Corner_index first = m_mesh.corner_at_vertex[v];
      const int e = m_exponents[m_parts.part_of_face(std::size_t(first / 3))];
      const auto integer = [e](const double x) { return std::llround(std::ldexp(x, -e)); };
      Grid_vector p{integer(m_mesh.uv(first)[0]), integer(m_mesh.uv(first)[1])};
      for_each_corner(m_mesh, v, [&](const Corner_index h) {
        m_points[std::size_t(h)] = p;
        const std::int32_t t = m_mesh.corner(h).transition;
        if(t == no_index)
          return;
        const Chart_transition& transition = m_mesh.transitions[std::size_t(t)];
        p = rotated(transition.rotation, p);
        for(std::size_t c = 0; c < 2; ++c)
          p[c] += integer(transition.translation[c].rounded) +
                  integer(transition.translation[c].error);
      });
    }
  }

  bool is_wall(const Corner_index h, const Grid_vector& vector)
  {
    if(m_mesh.opposite(h) == no_index)
      return true;
    if(m_is_feature.empty() || !m_is_feature[std::size_t(h)])
      return false;
    const bool is_aligned = vector[0] == 0 || vector[1] == 0;
    number_of_unaligned_features += is_aligned || m_mesh.edge_key(h) != h ? 0 : 1;
    return is_aligned;
  }

  const Chart_mesh& m_mesh;
  const std::vector<char>& m_is_feature;
  Surface_parts m_parts;
  std::vector<int> m_exponents;      // per part
  std::vector<Grid_vector> m_points; // per corner
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_INTEGER_MESH_H
