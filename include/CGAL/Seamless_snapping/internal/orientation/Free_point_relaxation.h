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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_FREE_POINT_RELAXATION_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_FREE_POINT_RELAXATION_H

#include <CGAL/license/Seamless_snapping.h>

// Moves free points around flipped faces into the middle of their neighbors. This helps if the
// coordinates of the input are useless, for example after wrong numbers in a file.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Seamless_snapping/internal/orientation/Movable_points.h>
#include <CGAL/Seamless_snapping/internal/orientation/Vertex_angles.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The faces of a disk that is relaxed with uniform weights are positive where its border is convex,
// by Tutte's theorem; elsewhere, an exact check decides.
template <typename Group>
class Free_point_relaxation
{
public:
  Free_point_relaxation(const Movable_points<Group>& points, const Number_format& format)
    : m_points(points), m_angles(points), m_format(format)
  { }

  // Faces that are positive stay so. A point alone comes first, so that no others move if it is the
  // only one with a wrong place.
  void repair(const std::vector<Face_index>& faces, Uv_state& state) const
  {
    std::set<Face_index> tried;
    for(const Face_index f : faces) {
      if(!tried.insert(f).second || m_points.is_positive(state, f))
        continue;
      Points group = free_points(f);
      if(relax_alone(group, f, state))
        continue;
      for(int ring = 0; ring <= most_rings; ++ring) {
        const std::vector<Face_index> around = add_flips(group, state);
        tried.insert(around.begin(), around.end());
        const std::size_t before = group.size();
        if(before > most_points || relax(group, around, state))
          break;
        for(const Face_index g : around)
          group.merge(free_points(g));
        if(group.size() == before)
          break;
      }
    }
  }

private:
  using Points = std::map<Point_index, Eigen::Index>; // with their numbers
  using Matrix = Eigen::SparseMatrix<double>;

  Points free_points(const Face_index f) const
  {
    Points result;
    const auto points = m_points.domain_face(f).points; // a copy: stars meet more faces
    for(const Point_index p : points)
      if(m_points.is_free(p))
        result.emplace(p, 0);
    return result;
  }

  // One of the points, that with the most flips around it first. Returns whether that repairs `f`.
  bool relax_alone(const Points& points, const Face_index f, Uv_state& state) const
  {
    std::vector<std::pair<std::ptrdiff_t, Point_index> > order;
    for(const auto& point : points) {
      const std::vector<Face_corner> star = m_points.stars().star(point.first);
      order.emplace_back(std::count_if(star.begin(), star.end(), [&](const Face_corner& corner)
                                       { return m_points.is_positive(state, corner.face); }) -
                           std::ptrdiff_t(star.size()), point.first);
    }
    std::sort(order.begin(), order.end());
    return std::any_of(order.begin(), order.end(), [&](const auto& next) {
      Points alone{{next.second, 0}};
      std::vector<Face_index> around;
      for(const Face_corner& corner : m_points.stars().star(next.second))
        around.push_back(corner.face);
      return relax(alone, around, state) && m_points.is_positive(state, f);
    });
  }

  // The faces around a group, after it has those points of flipped ones that are free.
  std::vector<Face_index> add_flips(Points& group, const Uv_state& state) const
  {
    std::set<Face_index> around;
    std::vector<Point_index> next;
    for(const auto& point : group)
      next.push_back(point.first);
    while(!next.empty()) {
      const Point_index p = next.back();
      next.pop_back();
      for(const Face_corner& corner : m_points.stars().star(p)) {
        if(!around.insert(corner.face).second || m_points.is_positive(state, corner.face))
          continue;
        for(const Point_index q : Domain_face(m_points.domain_face(corner.face)).points)
          if(m_points.is_free(q) && group.emplace(q, 0).second)
            next.push_back(q);
      }
    }
    return std::vector<Face_index>(around.begin(), around.end());
  }

  // Returns whether that repairs a face.
  bool relax(Points& group, const std::vector<Face_index>& around, Uv_state& state) const
  {
    Eigen::Index number = 0;
    for(auto& point : group)
      point.second = number++;
    Eigen::MatrixX2d fixed = Eigen::MatrixX2d::Zero(number, 2);
    std::vector<Eigen::Triplet<double> > terms;
    bool is_at_others = false;
    for(const auto& [p, i] : group)
      for(const Face_corner& corner : m_points.stars().star(p))
        for(std::size_t k = 1; k < 3; ++k) {
          const Point_index q = m_points.domain_face(corner.face).points[(corner.position + k) % 3];
          const auto found = group.find(q);
          terms.emplace_back(i, i, 1.);
          if(found != group.end()) {
            terms.emplace_back(i, found->second, -1.);
          } else {
            fixed.row(i) += Eigen::RowVector2d(m_points.uv(state, q)[0], m_points.uv(state, q)[1]);
            is_at_others = true;
          }
        }
    if(!is_at_others)
      return false;
    Matrix matrix(number, number);
    matrix.setFromTriplets(terms.begin(), terms.end());
    const Eigen::MatrixX2d places = Eigen::SimplicialLDLT<Matrix>(matrix).solve(fixed);
    std::vector<bool> was_positive;
    for(const Face_index f : around)
      was_positive.push_back(m_points.is_positive(state, f));
    std::vector<Uv> before;
    for(const auto& [p, i] : group) {
      before.push_back(m_points.uv(state, p));
      m_points.set_uv(state, p, {{rounded_to(m_format, places(i, 0)),
                                  rounded_to(m_format, places(i, 1))}});
    }
    if(is_better(around, was_positive, state))
      return true;
    for(const auto& [p, i] : group)
      m_points.set_uv(state, p, before[std::size_t(i)]);
    return false;
  }

  bool is_better(const std::vector<Face_index>& faces, const std::vector<bool>& was_positive,
                 const Uv_state& state) const
  {
    bool has_repaired = false;
    for(std::size_t i = 0; i < faces.size(); ++i) {
      const bool is_positive = m_points.is_positive(state, faces[i]);
      has_repaired = has_repaired || (is_positive && !was_positive[i]);
      if((!is_positive && was_positive[i]) || !m_angles.are_kept_by_sectors(state, faces[i]))
        return false;
    }
    return has_repaired;
  }

  static constexpr int most_rings = 3; // more than the points of flipped faces
  static constexpr std::size_t most_points = 10000; // in a group

  const Movable_points<Group>& m_points;
  Vertex_angles<Group> m_angles;
  Number_format m_format;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_FREE_POINT_RELAXATION_H
