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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_MATCHING_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_MATCHING_H

#include <CGAL/license/Quad_remeshing.h>

// Matching of the crosses of adjacent faces, the indices of vertices that follow from it, and the
// index theorem; and combing, which turns the crosses by quarter turns until they agree across all
// edges but the cuts.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Quad_remeshing/internal/parametrization/prescribe_alignment.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// Invariant: across each interior halfedge, from face f to face g,
//   angle(f) + transport - angle(g) = turns * quarter_turn + deviation;
// a direction that has the uv coordinates w in the chart of f has R^turns w in the chart of g.
// Both numbers change their signs with the halfedge.
struct Matching
{
  std::vector<int> turns;
  std::vector<double> deviation;
};

// The left hand side of the invariant; transports there and back add up to a full turn, which one
// of the halfedges has to leave out.
inline double turn_across(const Triangle_surface& surface, const std::vector<double>& angles,
                          const Corner_index h)
{
  const double transport = surface.represents_edge(h) ? surface.transport(h)
                                                      : -surface.transport(surface.opposite(h));
  return angles[surface.face(h)] + transport - angles[surface.face(surface.opposite(h))];
}

inline void set_turns(const Triangle_surface& surface, const std::vector<double>& angles,
                         const Corner_index h, const int turns, Matching& matching)
{
  const Corner_index o = surface.opposite(h);
  matching.turns[h] = turns;
  matching.deviation[h] = turn_across(surface, angles, h) - turns * quarter_turn;
  matching.turns[o] = -matching.turns[h];
  matching.deviation[o] = -matching.deviation[h];
}

// Ties are broken away from the half, so that symmetric meshes don't decide by rounding errors.
inline int nearest_turns(const double angle)
{
  constexpr double tie_breaker = 1e-4; // of a quarter turn
  return static_cast<int>(std::floor(angle / quarter_turn + 0.5 - tie_breaker));
}

// The angle from the closest direction of the cross of its face to a halfedge.
inline double turn_from_cross(const Triangle_surface& surface, const std::vector<double>& angles,
                              const Corner_index h)
{
  const double turn = surface.direction[h] - angles[surface.face(h)];
  return turn - quarter_turn * std::round(turn / quarter_turn);
}

// Matches each direction with the closest one; across an aligned edge, directions that are closest
// to it on either side, so that it is on isocurves of one coordinate for both.
inline Matching match_crosses(const Triangle_surface& surface, const std::vector<double>& angles)
{
  const Corner_index n = surface.number_of_halfedges();
  Matching matching{std::vector<int>(n, 0), std::vector<double>(n, 0)};
  for(Corner_index h = 0; h < n; ++h)
    if(surface.represents_edge(h) && !surface.is_border_edge(h)) {
      const double turn = turn_across(surface, angles, h);
      const int turns =
        surface.is_aligned[h]
          ? static_cast<int>(std::lround((turn + turn_from_cross(surface, angles, h) -
                                          turn_from_cross(surface, angles, surface.opposite(h))) /
                                         quarter_turn))
          : nearest_turns(turn);
      set_turns(surface, angles, h, turns, matching);
    }
  return matching;
}

// The Euler characteristics and the border loops of the components.
struct Topology
{
  std::vector<std::ptrdiff_t> euler_characteristic; // per component
  std::vector<std::size_t> border_loops;            // per component
  std::vector<std::size_t> loop_of_vertex;          // border vertices only, else none
  std::size_t number_of_loops = 0;
};

inline Topology topology(const Triangle_surface& surface)
{
  Topology result;
  result.euler_characteristic.assign(surface.number_of_components, 0);
  result.border_loops.assign(surface.number_of_components, 0);
  result.loop_of_vertex.assign(surface.number_of_vertices(), none);
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f)
    ++result.euler_characteristic[surface.component[f]];
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    if(surface.represents_edge(h))
      --result.euler_characteristic[surface.component[surface.face(h)]];
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
    const std::size_t c = surface.component_of_vertex(v);
    ++result.euler_characteristic[c];
    if(!surface.is_border[v] || result.loop_of_vertex[v] != none)
      continue;
    // The outgoing edge of the first corner of a border vertex is a border edge.
    for(std::size_t w = v; result.loop_of_vertex[w] == none;
        w = surface.vertex(surface.next(surface.corner_at_vertex[w])))
      result.loop_of_vertex[w] = result.number_of_loops;
    ++result.number_of_loops;
    ++result.border_loops[c];
  }
  return result;
}

struct Singularities
{
  std::vector<int> index;                  // per vertex, in quarter turns; 0 on the border
  std::vector<std::ptrdiff_t> loop_turning; // per border loop, in quarter turns
};

// The turn of the field around each vertex, against the curvature there: in units of a quarter turn
// an integer but for rounding errors. Border vertices have no index of their own, unless the field
// is aligned, but each loop has: the number of quarter turns of its tangent against the field.
inline Singularities singularities(const Triangle_surface& surface, const Topology& topo,
                                   const Matching& matching)
{
  std::vector<double> turns = angle_defects(surface);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    turns[surface.vertex(h)] -= matching.deviation[h];

  Singularities result;
  result.index.assign(surface.number_of_vertices(), 0);
  std::vector<double> loop_turns(topo.number_of_loops, 0);
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
    if(surface.is_border[v])
      loop_turns[topo.loop_of_vertex[v]] += turns[v] / quarter_turn;
    else
      result.index[v] = static_cast<int>(std::lround(turns[v] / quarter_turn));
  }
  for(const double t : loop_turns)
    result.loop_turning.push_back(static_cast<std::ptrdiff_t>(std::llround(t)));
  return result;
}

// The halfedge from the neighbor of smallest index that can take a quarter turn more. No index
// if there is none.
inline Corner_index neighbor_of_smallest_index(const Triangle_surface& surface, const std::size_t v,
                                               const std::vector<int>& index,
                                               const int largest_index, const bool along_features)
{
  Corner_index best = no_index;
  for_each_corner(surface, v, [&](const Corner_index h) {
    const std::size_t w = surface.source(h);
    if(bool(surface.is_aligned[h]) == along_features && !surface.is_border_edge(h)
       && index[w] < largest_index
       && (best == no_index || index[w] < index[surface.source(best)]))
      best = h;
  });
  return best;
}

// Hands a quarter turn of index on, from the target of an edge to its source.
inline void hand_on_turn(const Triangle_surface& surface, const std::vector<double>& angles,
                         const Corner_index h, std::vector<int>& index, Matching& matching)
{
  set_turns(surface, angles, h, matching.turns[h] - 1, matching);
  --index[surface.vertex(h)];
  ++index[surface.source(h)];
}

// A cone of index 4 or more, as at the tip of a spike, leaves no angle for its faces, so that they
// would flip: what is above the largest index is handed on to neighbors, but not along features,
// unless these may be released. Returns whether anything was changed.
inline bool spread_large_indices(Triangle_surface& surface, const std::vector<double>& angles,
                                 const int largest_index, const bool may_release,
                                 std::vector<int>& index, Matching& matching,
                                 std::vector<Corner_index>& released)
{
  bool changed = false;
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    while(index[v] > largest_index) {
      Corner_index best = neighbor_of_smallest_index(surface, v, index, largest_index, false);
      if(best == no_index && may_release) {
        best = neighbor_of_smallest_index(surface, v, index, largest_index, true);
        if(best != no_index)
          released.push_back(release_edge(surface, best));
      }
      if(best == no_index)
        break;
      hand_on_turn(surface, angles, best, index, matching);
      changed = true;
    }
  return changed;
}

// How many quarter turns there are from the first side of a sector to the other.
inline int turns_of_sector(const Triangle_surface& surface, const std::vector<double>& angles,
                           const Matching& matching, const Aligned_sector& sector)
{
  double turn = sector.angle + turn_from_cross(surface, angles, surface.next(sector.first));
  for_each_corner(surface, sector, [&](const Corner_index h) {
    turn += surface.is_aligned[h] ? -turn_from_cross(surface, angles, h) : matching.deviation[h];
  });
  return static_cast<int>(std::lround(turn / quarter_turn));
}

// Whether the vertex that an edge comes from, or its sector there, can do with a quarter turn less.
inline bool has_turn_to_give(const Triangle_surface& surface, const std::vector<double>& angles,
                             const Matching& matching, const std::vector<int>& index,
                             const int largest_index, const Corner_index h)
{
  const std::size_t v = surface.source(h);
  bool has_sectors = false, result = false;
  for_each_sector(surface, v, [&](const Aligned_sector& sector) {
    has_sectors = true;
    for_each_corner(surface, sector, [&](const Corner_index corner) {
      if(corner == surface.prev(h))
        result = turns_of_sector(surface, angles, matching, sector) > 1;
    });
  });
  return has_sectors ? result : !surface.is_border[v] && index[v] < largest_index;
}

// Hands quarter turns to a sector until it has as many as wanted, from the other ends of edges
// inside that `can_give(halfedge)`. Returns whether anything was changed.
template <typename Predicate>
bool add_turns(const Triangle_surface& surface, const std::vector<double>& angles,
               const Aligned_sector& sector, const int wanted, const Predicate& can_give,
               std::vector<int>& index, Matching& matching)
{
  bool changed = false;
  for(int turns = turns_of_sector(surface, angles, matching, sector); turns < wanted; ++turns) {
    Corner_index best = no_index;
    for_each_corner(surface, sector, [&](const Corner_index h) {
      if(!surface.is_aligned[h] &&
         (best == no_index || matching.deviation[h] < matching.deviation[best]) && can_give(h))
        best = h;
    });
    if(best == no_index)
      break;
    hand_on_turn(surface, angles, best, index, matching);
    changed = true;
  }
  return changed;
}

// The sides of a sector without a quarter turn would be one isocurve, and the faces between them
// collapse: it gets one from the other end of an edge inside. Returns whether anything was changed.
inline bool open_collapsed_sectors(const Triangle_surface& surface,
                                   const std::vector<double>& angles, const int largest_index,
                                   std::vector<int>& index, Matching& matching)
{
  bool changed = false;
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    for_each_sector(surface, v, [&](const Aligned_sector& sector) {
      changed |= add_turns(surface, angles, sector, 1, [&](const Corner_index h) {
        return has_turn_to_give(surface, angles, matching, index, largest_index, h);
      }, index, matching);
    });
  return changed;
}

// Where narrow sectors were opened, the field turns by 45 degrees from their faces to the next
// ones, so that a quarter turn can get to either side: to the feature that is followed from there,
// which would get a corner then, or inside, where it leaves the lengths of features free. Moves it
// inside. Returns whether anything was changed.
inline bool straighten_sides_of_narrow_sectors(const Triangle_surface& surface,
                                               const std::vector<double>& angles,
                                               const int largest_index, std::vector<int>& index,
                                               Matching& matching)
{
  bool changed = false;
  const auto straighten = [&](const std::size_t v, const Flat_face_index f) {
    for_each_sector(surface, v, [&](const Aligned_sector& sector) {
      bool is_beside = false;
      for_each_corner(surface, sector, [&](const Corner_index h)
                      { is_beside = is_beside || Flat_face_index(surface.face(h)) == f; });
      constexpr int straight = 2;
      if(is_beside && sector.angle > (straight - 0.5) * quarter_turn)
        changed |= add_turns(surface, angles, sector, straight, [&](const Corner_index h) {
          const std::size_t w = surface.source(h);
          bool is_free = !surface.is_border[w] && index[w] < largest_index;
          for_each_corner(surface, w, [&](const Corner_index g)
                          { is_free = is_free && !surface.is_aligned[g]; });
          return is_free;
        }, index, matching);
    });
  };
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    for_each_sector(surface, v, [&](const Aligned_sector& sector) {
      if(!(sector.angle < narrow_sector))
        return;
      Corner_index last = sector.first;
      for_each_corner(surface, sector, [&](const Corner_index h) { last = h; });
      straighten(surface.vertex(surface.next(sector.first)), surface.face(sector.first));
      straighten(surface.source(last), surface.face(last));
    });
  return changed;
}

// Checks, in integers, that the rotations around each interior vertex agree with its index, and
// that all indices of a component add up to 4 chi.
inline void check_index_theorem(const Triangle_surface& surface, const Topology& topo,
                                const Matching& matching, const Singularities& singular)
{
  std::vector<std::ptrdiff_t> sum(surface.number_of_components, 0);
  std::vector<char> loop_is_counted(topo.number_of_loops, false);
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
    const std::size_t c = surface.component_of_vertex(v);
    if(surface.is_border[v]) {
      const std::size_t loop = topo.loop_of_vertex[v];
      if(!loop_is_counted[loop])
        sum[c] += singular.loop_turning[loop];
      loop_is_counted[loop] = true;
      continue;
    }
    int turns = 0;
    for_each_corner(surface, v, [&](const Corner_index h) { turns += matching.turns[h]; });
    if(Quarter_turns::element(turns) != Quarter_turns::element(singular.index[v]))
      throw Refusal(Outcome::INTERNAL_ERROR,
                    "the index of a vertex does not match the rotations around it");
    sum[c] += singular.index[v];
  }
  for(std::size_t c = 0; c < surface.number_of_components; ++c)
    if(sum[c] != Quarter_turns::order * topo.euler_characteristic[c])
      throw Refusal(Outcome::INTERNAL_ERROR,
                    "the indices of component " + std::to_string(c) + " add up to "
                    + std::to_string(sum[c]) + " instead of "
                    + std::to_string(Quarter_turns::order * topo.euler_characteristic[c]));
}

// The angle that +u is turned by.
inline double angle_of(const Quarter_turns::Element g)
{
  const auto& m = Quarter_turns::matrix(g);
  return std::atan2(m[1][0], m[0][0]);
}

// Changes `angles` by multiples of a quarter turn, and returns the rotations of the transitions
// between the new charts, per halfedge: the identity across edges that are not cut.
inline std::vector<Quarter_turns::Element> comb(const Triangle_surface& surface,
                                                const std::vector<char>& is_cut,
                                                const Matching& matching,
                                                std::vector<double>& angles)
{
  const auto across = [&](const Corner_index h)
  { return Quarter_turns::element(matching.turns[h]); };
  std::vector<Quarter_turns::Element> turn(surface.number_of_faces(), Quarter_turns::identity());
  for_each_edge_of_face_trees(
    surface, [&](const Corner_index h) { return !is_cut[h]; },
    [&](const Corner_index h) {
      turn[surface.face(surface.opposite(h))] =
        Quarter_turns::compose(across(h), turn[surface.face(h)]);
    });

  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f)
    angles[f] += angle_of(turn[f]);
  std::vector<Quarter_turns::Element> rotation(surface.number_of_halfedges(),
                                               Quarter_turns::identity());
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    if(surface.is_border_edge(h))
      continue;
    rotation[h] = Quarter_turns::compose(
      Quarter_turns::inverse(turn[surface.face(surface.opposite(h))]),
      Quarter_turns::compose(across(h), turn[surface.face(h)]));
    if(rotation[h] != Quarter_turns::identity() && !is_cut[h])
      throw Refusal(Outcome::INTERNAL_ERROR,
                    "the field can't be combed: a cone or a handle was not cut open");
  }
  return rotation;
}

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_MATCHING_H
