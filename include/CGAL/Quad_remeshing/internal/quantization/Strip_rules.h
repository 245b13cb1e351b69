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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRIP_RULES_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRIP_RULES_H

#include <CGAL/license/Quad_remeshing.h>

// The changes that strips of triangles may make, by one unit in one direction, and their costs.

#include <CGAL/Quad_remeshing/internal/quantization/Wall_slider.h>
#include <CGAL/Quad_remeshing/internal/quantization/wanted_units.h>

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

// A halfedge, over which a strip leaves its face, and the direction in that face's chart by which
// the halfedge's vector changes.
using Strip_state = std::int32_t;

inline constexpr Strip_state no_strip_state = -1;

inline Strip_state strip_state(const Corner_index h, const int direction)
{ return 4 * h + direction; }
inline Corner_index halfedge_of(const Strip_state s) { return s / 4; }
inline Grid_vector change_of(const Strip_state s) { return unit_vector(s % 4); }
inline Strip_state with_opposite_change(const Strip_state s) { return s ^ 2; }

// The units of a face's halfedges.
using Face_units = std::array<Grid_vector, 3>;

inline void add_to(Face_units& units, const Corner_index h, const Grid_vector& change)
{
  units[std::size_t(h % 3)] = sum(units[std::size_t(h % 3)], change);
}

inline std::int64_t determinant(const Face_units& units)
{ return cross_product(units[0], units[1]); }

// Along lengths alone, units get near to the wanted numbers from far. They leave shear: of a thin
// part, edges across may be wrong by a unit, which is little for their length. Shape counts that as
// well; but where a part has no shear at some numbers of units only, it would let no strip get from
// one of these to the next.
enum class Cost_of_units
{
  LENGTHS, // squares of the deviations of edges; errors of long ones weigh less
  SHAPE    // also squares of what the maps of triangles, from the wanted ones, differ by from 1
};

// A strip changes each face that it passes: the corner between the two edges that it crosses moves,
// the third edge stays. So costs are given for the state of the edge that stays, in the direction
// in which the corner moves. The complex has to outlive it.
// Invariant: costs and determinants belong to the units at the last update.
class Strip_rules
{
  // Together, as a search asks for all of them.
  struct State_values
  {
    double price;
    double cost; // of a face, where this edge stays
    std::int64_t cross;
    Strip_state across;
  };

public:
  Strip_rules(const Intrinsic_complex& complex, const std::vector<double>& scales,
              const Cost_of_units cost)
    : m_complex(complex), m_wanted(wanted_units(complex, scales)),
      m_values(4 * complex.corners.size()), m_determinant(complex.corners.size() / 3)
  {
    if(cost == Cost_of_units::SHAPE)
      Wall_slider(complex, m_wanted).run();
    for(const Wanted_vector& w : m_wanted)
      m_lengths.push_back(at_least_a_unit(w));
    for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h) {
      m_weight.push_back(weight_of_edge(m_wanted[std::size_t(h)]));
      const Corner_index g = complex.opposite(h);
      for(Strip_state s = strip_state(h, 0); s < strip_state(h, 4); ++s) {
        State_values& values = m_values[std::size_t(s)];
        values.price = is_allowed(s) ? price_of_step : infinity;
        values.across = g == no_index ? no_strip_state : strip_state(
          g, Quarter_turns::compose(complex.corner(h).rotation, s % 4));
      }
    }
    for(Flat_face_index f = 0; f < complex.number_of_faces(); ++f) {
      if(cost == Cost_of_units::SHAPE)
        m_shapes.push_back(shape_of_face(f));
      update(f);
    }
  }

  // To be called for each face whose units have changed, once it is closed again.
  void update(const Flat_face_index f)
  {
    m_determinant[std::size_t(f)] = determinant(units_of_face(f));
    for(Strip_state s = strip_state(3 * f, 0); s < strip_state(3 * f + 3, 0); ++s) {
      State_values& values = m_values[std::size_t(s)];
      values.cost = cost_of_moves(s, 1);
      values.cross = cross_product(change_of(s), m_complex.corner(halfedge_of(s)).units);
    }
  }

  // No strip but one from there may change the edge so, until all is allowed again.
  void forbid(const Strip_state s)
  {
    for(const Strip_state t : {s, is_border(s) ? s : reversed(s)}) {
      m_values[std::size_t(t)].price = infinity;
      m_forbidden.push_back(t);
    }
  }

  void allow_all()
  {
    for(const Strip_state s : m_forbidden)
      m_values[std::size_t(s)].price = price_of_step;
    m_forbidden.clear();
  }

  const Intrinsic_complex& complex() const { return m_complex; }

  // The edge that stays, of a face that a strip enters over a halfedge and leaves by a state.
  static Strip_state edge_that_stays(const Corner_index entry, const Strip_state exit)
  {
    const Corner_index next = Intrinsic_complex::next(entry);
    return halfedge_of(exit) == next
             ? strip_state(Intrinsic_complex::prev(entry), with_opposite_change(exit) % 4)
             : strip_state(next, exit % 4);
  }

  // The cost of moving the corner once.
  double cost(const Strip_state stay) const { return m_values[std::size_t(stay)].cost; }

  // The cost of moving the corner several times, which is quadratic.
  double cost_of_moves(const Strip_state stay, const double times) const
  {
    const Corner_index h = halfedge_of(stay);
    const std::size_t c = std::size_t(stay % 2);
    const double t = stay % 4 < 2 ? times : -times;
    const double result = cost_of_edge(Intrinsic_complex::next(h), c, t) +
                          cost_of_edge(Intrinsic_complex::prev(h), c, -t);
    return m_shapes.empty() ? result : result + cost_of_shape(h, c, t);
  }

  // The least cost of a face that is entered by a state.
  double least_cost(const Strip_state side) const
  {
    const Corner_index entry = halfedge_of(side);
    double result = infinity;
    for(const Corner_index exit :
        {Intrinsic_complex::next(entry), Intrinsic_complex::prev(entry)})
      if(const Strip_state s = strip_state(exit, side % 4); is_allowed(s))
        result = (std::min)(result, cost(edge_that_stays(entry, s)));
    return result;
  }

  // The least cost of both faces at an edge that changes.
  double least_cost_around(const Strip_state s) const
  {
    return least_cost(with_opposite_change(s)) + (is_border(s) ? 0. : least_cost(across(s)));
  }

  // The price of crossing an edge, beside the costs of faces: infinite if it is not allowed, and
  // little otherwise, which keeps strips short.
  double price(const Strip_state s) const { return m_values[std::size_t(s)].price; }

  // The change times the halfedge's units.
  std::int64_t cross(const Strip_state s) const { return m_values[std::size_t(s)].cross; }

  // Walls change along themselves only.
  bool is_allowed(const Strip_state s) const
  {
    const Intrinsic_corner& corner = m_complex.corner(halfedge_of(s));
    const Grid_vector d = change_of(s);
    return !corner.is_wall || (corner.vector[0] == 0 ? d[0] == 0 : d[1] == 0);
  }

  std::int64_t determinant_of_face(const Flat_face_index f) const
  { return m_determinant[std::size_t(f)]; }

  bool is_no_worse(const Flat_face_index f, const std::int64_t before,
                   const std::int64_t after) const
  {
    return after > 0 || (before <= 0 && after - before >= (f == face_to_raise ? 1 : 0));
  }

  Face_units units_of_face(const Flat_face_index f) const
  {
    return {m_complex.corner(3 * f).units, m_complex.corner(3 * f + 1).units,
            m_complex.corner(3 * f + 2).units};
  }

  // The change as the halfedge on the other side sees it, in the chart there, or no state.
  Strip_state across(const Strip_state s) const { return m_values[std::size_t(s)].across; }

  // The edge from the other side; strips through it run in the other direction.
  Strip_state reversed(const Strip_state s) const
  { return with_opposite_change(is_border(s) ? s : across(s)); }

  bool is_border(const Strip_state s) const { return across(s) == no_strip_state; }

  Flat_face_index face_to_raise = no_index; // a strip has to raise its determinant

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double price_of_step = 1e-6; // prefers the shorter of two strips
  static constexpr double weight_of_stretching = 2; // the weight of shear is 1

  // The change of the map from a wanted triangle to the triangle of units if the corner opposite to
  // a halfedge moves by one.
  struct Shape
  {
    double area;
    std::array<Wanted_vector, 3> gradients; // per halfedge
  };

  // Triangles of less height than a unit, which no units are near to, count as if they had that:
  // else nothing would matter beside them.
  Shape shape_of_face(const Flat_face_index f) const
  {
    const Wanted_vector* const w = &m_wanted[std::size_t(3 * f)];
    double twice_area = (std::max)(1e-9, w[0][0] * w[1][1] - w[0][1] * w[1][0]);
    for(std::size_t k = 0; k < 3; ++k)
      twice_area = (std::max)(twice_area, std::hypot(w[k][0], w[k][1]));
    Shape result;
    result.area = twice_area / 2;
    for(std::size_t k = 0; k < 3; ++k)
      result.gradients[k] = {-w[k][1] / twice_area, w[k][0] / twice_area};
    return result;
  }

  // No units are shorter than 1: of a shorter vector, the direction tells which of them are wanted.
  static Wanted_vector at_least_a_unit(const Wanted_vector& w)
  {
    const double length = std::hypot(w[0], w[1]);
    return length > 0 && length < 1 ? Wanted_vector{w[0] / length, w[1] / length} : w;
  }

  double deviation(const Corner_index h, const std::size_t c,
                   const std::vector<Wanted_vector>& wanted) const
  { return static_cast<double>(m_complex.corner(h).units[c]) - wanted[std::size_t(h)][c]; }

  // The other half of the edge belongs to the other face.
  double cost_of_edge(const Corner_index h, const std::size_t c, const double change) const
  {
    const double part = m_complex.opposite(h) == no_index ? 1 : 0.5;
    return part * m_weight[std::size_t(h)] * change * (2 * deviation(h, c, m_lengths) + change);
  }

  // \param h the edge that stays
  double cost_of_shape(const Corner_index h, const std::size_t c, const double change) const
  {
    const Flat_face_index f = h / 3;
    const Shape& shape = m_shapes[std::size_t(f)];
    const double first = deviation(3 * f, c, m_wanted), third = deviation(3 * f + 2, c, m_wanted);
    double result = 0;
    for(std::size_t j = 0; j < 2; ++j) {
      const double before = first * shape.gradients[2][j] - third * shape.gradients[0][j];
      const double difference = change * shape.gradients[std::size_t(h % 3)][j];
      result += (j == c ? weight_of_stretching : 1) * difference * (2 * before + difference);
    }
    return shape.area * result;
  }

  const Intrinsic_complex& m_complex;
  std::vector<Strip_state> m_forbidden;
  std::vector<Wanted_vector> m_wanted;     // per halfedge
  std::vector<Wanted_vector> m_lengths;    // the same, none shorter than a unit
  std::vector<double> m_weight;            // per halfedge
  std::vector<Shape> m_shapes;             // per face, where they count
  std::vector<State_values> m_values;      // per state
  std::vector<std::int64_t> m_determinant; // per face
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_STRIP_RULES_H
