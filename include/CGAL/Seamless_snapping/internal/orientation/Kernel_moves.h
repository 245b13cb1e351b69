// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_KERNEL_MOVES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_KERNEL_MOVES_H

#include <CGAL/license/Seamless_snapping.h>

// Makes a face positive by moving one of its vertices into the kernel of its 1-ring, the
// intersection of the half planes beside the link's edges ([MC19] Sec. 5.4): as little as it takes,
// on the grid, and only if an exact check of the whole ring agrees.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Seamless_snapping/internal/orientation/Movable_points.h>
#include <CGAL/Seamless_snapping/internal/orientation/Vertex_angles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The displacements d with normal . d >= bound. The normal has length 1.
struct Half_plane
{
  Uv normal;
  double bound;
};

inline double dot(const Uv& a, const Uv& b) { return a[0] * b[0] + a[1] * b[1]; }

// Intersections of half planes, up to rounding: what comes out of it is checked exactly afterwards.
class Half_planes
{
public:
  // All displacements, or the multiples of one.
  Half_planes() = default;
  explicit Half_planes(const Uv& direction) : m_direction(direction) { }

  // The displacements with gradient . d >= bound, for a gradient of any length.
  void add(Uv gradient, const double bound)
  {
    if(m_direction) {
      const double along = dot(gradient, *m_direction) / dot(*m_direction, *m_direction);
      gradient = {{along * (*m_direction)[0], along * (*m_direction)[1]}};
    }
    const double length = std::sqrt(dot(gradient, gradient));
    if(length > 0)
      m_planes.push_back({{gradient[0] / length, gradient[1] / length}, bound / length});
    else
      m_is_empty = m_is_empty || bound > 0;
  }

  // The shortest displacement in the intersection. Returns false if there is none. Half planes come
  // in one after another: one that excludes the shortest so far has the next on its line.
  bool find_shortest(Uv& shortest) const
  {
    shortest = {{0, 0}};
    if(m_is_empty)
      return false;
    for(std::size_t i = 0; i < m_planes.size(); ++i)
      if(!contains(m_planes[i], shortest))
        shortest = shortest_on_line(i);
    return std::all_of(m_planes.begin(), m_planes.end(),
                       [&](const Half_plane& p) { return contains(p, shortest); });
  }

private:
  // The shortest displacement on the line of a half plane, within the interval of the others.
  Uv shortest_on_line(const std::size_t i) const
  {
    const Half_plane& p = m_planes[i];
    const Uv direction{{-p.normal[1], p.normal[0]}};
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    for(std::size_t j = 0; j < i; ++j) {
      const Half_plane& q = m_planes[j];
      const double slope = dot(q.normal, direction);
      const double bound = q.bound - p.bound * dot(q.normal, p.normal);
      if(slope > 1e-14)
        low = (std::max)(low, bound / slope);
      else if(slope < -1e-14)
        high = (std::min)(high, bound / slope);
    }
    const double along = (std::min)((std::max)(0., low), high);
    return {{p.bound * p.normal[0] + along * direction[0],
             p.bound * p.normal[1] + along * direction[1]}};
  }

  // Up to rounding.
  static bool contains(const Half_plane& p, const Uv& d)
  {
    return dot(p.normal, d) >= p.bound - 1e-9 * (std::abs(p.bound) + std::sqrt(dot(d, d)));
  }

  std::optional<Uv> m_direction;
  std::vector<Half_plane> m_planes;
  bool m_is_empty = false;
};

// Twice the area, in units of the grid's squares. Up to rounding.
inline double twice_area(const Uv_triangle& t, const double step)
{
  const double ax = (t[1][0] - t[0][0]) / step, ay = (t[1][1] - t[0][1]) / step;
  const double bx = (t[2][0] - t[0][0]) / step, by = (t[2][1] - t[0][1]) / step;
  return ax * by - ay * bx;
}

// The square of the longest edge, in the same units.
template <typename Group>
double longest_square(const Uv_triangle& t, const double step)
{
  double result = 0;
  for(std::size_t i = 0; i < 3; ++i) {
    const Uv e = Group::to_cartesian({(t[(i + 1) % 3][0] - t[i][0]) / step,
                                      (t[(i + 1) % 3][1] - t[i][1]) / step});
    result = (std::max)(result, dot(e, e));
  }
  return result;
}

// The wanted value of twice the area of a face: the value of the input. Faces that were not
// positive there have none; they are content with a sliver.
template <typename Group>
double wanted_area(const Uv_triangle& input, const bool was_positive, const double step)
{
  return was_positive ? twice_area(input, step) : longest_square<Group>(input, step) / 16;
}

// The least area of a face, as a part of the wanted area: as much as a ring can give, down to the
// least area that rounding to the grid leaves positive.
constexpr std::array<double, 4> area_margins{{1. / 4, 1. / 32, 1. / 1024, 0}};

template <typename Group>
class Kernel_moves
{
  using Member = typename Vertex_move<Group>::Member;

public:
  Kernel_moves(const Movable_points<Group>& points, const Number_format& format)
    : m_points(points), m_angles(points), m_format(format)
  { }

  // From now on, repairs of flips may leave other cones than the cones of the input.
  void allow_other_cones() { m_keeps_cones = false; }

  // Returns the faces that remain.
  // \param reach the largest change of a functional, from the input
  std::vector<Face_index> repair(std::vector<Face_index> faces, const double reach,
                                 Uv_state& state) const
  {
    // A move can make room for another. The last pass is one that gains little, so that all
    // together take linear time.
    for(bool gains = !faces.empty(); gains;) {
      const std::size_t before = faces.size();
      faces.erase(std::remove_if(faces.begin(), faces.end(),
                                 [&](const Face_index f) { return repair(f, reach, state); }),
                  faces.end());
      gains = before - faces.size() > before / 16;
    }
    return faces;
  }

private:
  // A face around the vertex that moves; its first corner does.
  struct Ring_face
  {
    Face_index face;
    bool is_target, is_wanted, is_positive;
    double area, wanted;
    Uv form; // a displacement times it is the change of the area
  };

  struct Plan
  {
    Vertex_move<Group> move;
    double unit; // for areas and displacements
    bool is_for_flip; // in the input
    std::vector<Ring_face> ring;
    Uv displacement; // in the coordinates of the map; half planes are Cartesian
  };

  bool repair(const Face_index target, const double reach, Uv_state& state) const
  {
    if(m_points.is_positive(state, target))
      return true; // by another face's move
    const Domain_face target_face = m_points.domain_face(target);
    std::vector<Plan> plans;
    for(const Point_index p : target_face.points) {
      Plan plan{find_vertex_move(m_points, p), 0, !target_face.was_positive, {}, {}};
      plan.unit = m_points.spacing(p);
      if(plan.move.is_possible() && collect_ring(target, state, plan))
        plans.push_back(std::move(plan));
    }
    // Flips of the input are repaired by the kernel of the whole ring only: a face less flipped
    // among others would be no gain. Where snapping turned several faces, some may have to wait for
    // another move.
    for(const double margin : area_margins)
      if(apply_shortest(plans, margin, true, reach, state) ||
         (target_face.was_positive && apply_shortest(plans, margin, false, reach, state)))
        return true;
    return false;
  }

  // Returns false if a face has several corners that move.
  bool collect_ring(const Face_index target, const Uv_state& state, Plan& plan) const
  {
    bool is_simple = true;
    for(const Member& member : plan.move.members)
      for(const Face_corner& corner : m_points.stars().star(member.point)) {
        const Domain_face& face = m_points.domain_face(corner.face);
        for(std::size_t i = 1; i < 3; ++i)
          is_simple = is_simple &&
                      plan.move.find(face.points[(corner.position + i) % 3]) == nullptr;
        plan.ring.push_back(ring_face(corner, member.element, target, state, plan.unit));
      }
    return is_simple;
  }

  Ring_face ring_face(const Face_corner& corner, const typename Group::Element element,
                      const Face_index target, const Uv_state& state, const double unit) const
  {
    const Domain_face& face = m_points.domain_face(corner.face);
    const Uv_triangle now = rotated(m_points.triangle(state, face), corner.position);
    const Uv normal{{(now[1][1] - now[2][1]) / unit, (now[2][0] - now[1][0]) / unit}};
    Ring_face result;
    result.face = corner.face;
    result.is_target = corner.face == target;
    result.is_wanted = face.was_positive || !m_points.domain_face(target).was_positive;
    result.is_positive = orientation(now) == CGAL::POSITIVE;
    result.area = twice_area(now, unit);
    result.wanted =
      wanted_area<Group>(rotated(face.input, corner.position), face.was_positive, unit);
    result.form = transposed_times(element, normal);
    return result;
  }

  // With another corner first.
  static Uv_triangle rotated(const Uv_triangle& t, const std::size_t first)
  {
    return {{t[first], t[(first + 1) % 3], t[(first + 2) % 3]}};
  }

  // How a linear form of the displacement g d depends on d.
  static Uv transposed_times(const typename Group::Element g, const Uv& form)
  {
    const auto& m = Group::matrix(g);
    return {{m[0][0] * form[0] + m[1][0] * form[1], m[0][1] * form[0] + m[1][1] * form[1]}};
  }

  // Faces that are positive stay so.
  // \param all whether the other faces of the ring that want to become positive must
  bool apply_shortest(std::vector<Plan>& plans, const double margin, const bool all,
                      const double reach, Uv_state& state) const
  {
    std::vector<std::pair<double, const Plan*> > found;
    for(Plan& plan : plans) {
      Half_planes kernel = half_planes(plan.move);
      for(const Member& member : plan.move.members)
        add_reach(member, reach, plan.unit, state, kernel);
      for(const Ring_face& f : plan.ring) {
        const double one_step = std::sqrt(dot(f.form, f.form)); // what rounding can cost
        const double bound = (std::max)(margin * f.wanted, one_step);
        if(f.is_positive)
          kernel.add(Group::form_to_cartesian(f.form), (std::min)(bound, f.area / 2) - f.area);
        else if(f.is_target || (all && f.is_wanted))
          kernel.add(Group::form_to_cartesian(f.form), bound - f.area);
      }
      Uv shortest;
      if(kernel.find_shortest(shortest)) {
        plan.displacement = Group::from_cartesian(shortest);
        found.emplace_back(dot(shortest, shortest), &plan);
      }
    }
    std::sort(found.begin(), found.end());
    return std::any_of(found.begin(), found.end(),
                       [&](const auto& f) { return apply(*f.second, all, state); });
  }

  static Half_planes half_planes(const Vertex_move<Group>& move)
  {
    return move.freedom == Vertex_move<Group>::ANY_DIRECTION
      ? Half_planes()
      : Half_planes(Group::to_cartesian({double(move.direction[0]), double(move.direction[1])}));
  }

  // Functionals change by no more than that, or by as much as they have already: a box, or a
  // hexagon.
  void add_reach(const Member& member, const double reach, const double unit,
                 const Uv_state& state, Half_planes& kernel) const
  {
    const Uv u = m_points.uv(state, member.point);
    for(int f = 0; f < Group::number_of_functionals && std::isfinite(reach); ++f) {
      double low = -infinity, high = infinity;
      for(const Face_corner& corner : m_points.stars().star(member.point)) {
        const double input =
          Group::value(f, m_points.domain_face(corner.face).input[corner.position]);
        low = (std::max)(low, input - reach - Group::value(f, u));
        high = (std::min)(high, input + reach - Group::value(f, u));
      }
      const auto terms = Group::functional(f);
      Uv form = transposed_times(member.element, {double(terms[0]), double(terms[1])});
      kernel.add(Group::form_to_cartesian(form), (std::min)(low, 0.) / unit);
      form = {{-form[0], -form[1]}};
      kernel.add(Group::form_to_cartesian(form), (std::min)(-high, 0.) / unit);
    }
  }

  // Takes the first displacement in whole grid steps, around the plan's, that the exact
  // check accepts.
  bool apply(const Plan& plan, const bool all, Uv_state& state) const
  {
    constexpr double largest = 4503599627370496.; // 2^52
    if(!(std::abs(plan.displacement[0]) < largest && std::abs(plan.displacement[1]) < largest))
      return false;
    std::vector<std::pair<double, Uv> > candidates;
    for(const Uv& d : grid_displacements(plan)) {
      const Uv off = Group::to_cartesian({d[0] - plan.displacement[0],
                                          d[1] - plan.displacement[1]});
      candidates.emplace_back(dot(off, off), d);
    }
    std::sort(candidates.begin(), candidates.end());
    return std::any_of(candidates.begin(), candidates.end(),
                       [&](const auto& c) { return try_displacement(plan, c.second, all, state); });
  }

  static std::vector<Uv> grid_displacements(const Plan& plan)
  {
    std::vector<Uv> result;
    if(plan.move.freedom == Vertex_move<Group>::ANY_DIRECTION) {
      for(int i = -2; i <= 2; ++i)
        for(int j = -2; j <= 2; ++j)
          result.push_back({{std::round(plan.displacement[0]) + i,
                             std::round(plan.displacement[1]) + j}});
      return result;
    }
    const Uv direction{double(plan.move.direction[0]), double(plan.move.direction[1])};
    const double along = std::round(dot(plan.displacement, direction) / dot(direction, direction));
    for(int i = -2; i <= 2; ++i)
      result.push_back({{(along + i) * direction[0], (along + i) * direction[1]}});
    return result;
  }

  bool try_displacement(const Plan& plan, const Uv& d, const bool all, Uv_state& state) const
  {
    std::vector<Uv> before;
    bool is_exact = true, is_finite = true;
    for(const Member& member : plan.move.members) {
      const Uv u = m_points.uv(state, member.point);
      const Uv steps = Group::apply(member.element, d);
      before.push_back(u);
      Uv moved;
      for(std::size_t c = 0; c < 2; ++c) {
        const double by = steps[c] * plan.unit;
        moved[c] = rounded_to(m_format, u[c] + by);
        const Exact_difference difference(moved[c], u[c]);
        is_finite = is_finite && std::isfinite(moved[c]);
        is_exact = is_exact && difference.rounded == by && difference.error == 0;
      }
      m_points.set_uv(state, member.point, moved);
    }
    if(is_finite && (is_exact || !plan.move.is_on_grid) &&
       std::all_of(plan.ring.begin(), plan.ring.end(), [&](const Ring_face& f) {
         return !(f.is_positive || f.is_target || (all && f.is_wanted)) ||
                m_points.is_positive(state, f.face);
       }) &&
       (!plan.is_for_flip || !m_keeps_cones ||
        std::all_of(plan.ring.begin(), plan.ring.end(), [&](const Ring_face& f) {
          return m_angles.are_kept(state, f.face);
        })))
      return true;
    for(std::size_t i = 0; i < before.size(); ++i)
      m_points.set_uv(state, plan.move.members[i].point, before[i]);
    return false;
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  const Movable_points<Group>& m_points;
  Vertex_angles<Group> m_angles;
  bool m_keeps_cones = true;
  Number_format m_format;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_KERNEL_MOVES_H
