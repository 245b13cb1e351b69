// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Isocurves_and_layouts package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_CHART_MESH_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_CHART_MESH_H

#include <CGAL/license/Isocurves_and_layouts.h>

// A parametrized mesh in plain arrays, for tracing isocurves.

#include <CGAL/Isocurves_and_layouts/internal/charts/Exact_level.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/axis_directions.h>
#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/for_each_chunk.h>
#include <CGAL/Seamless_snapping/internal/mesh/Flat_mesh.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

struct Chart_corner : Flat_corner
{
  Uv uv;                   // of the target of the halfedge
  std::int32_t transition; // no_index: the same coordinates on both sides
};

// u' = R u + t, from the face of a halfedge to the opposite one. The translation holds
// exactly at the source of the halfedge; in an exactly seamless map, also at the target. It is
// stored by components: for N = 6, these are sums of three or four coordinates.
template <typename Group>
struct Basic_chart_transition
{
  using Translation =
    std::conditional_t<Group::is_signed_permutation, Exact_difference, Exact_level>;

  typename Group::Element rotation;
  std::array<Translation, std::size_t(Group::number_of_functionals)> translation;
};

// Invariant: an interior halfedge has a transition if and only if its two sides have different
// coordinates or charts.
template <typename Group>
struct Basic_chart_mesh : Flat_mesh<Chart_corner>
{
  std::vector<Basic_chart_transition<Group> > transitions;
  std::vector<char> is_singular; // per vertex
  double extent = 0;             // the larger side of the bounding box of the coordinates
  double violation = 0;          // the largest one of a transition
  bool is_exact = true;          // all transitions hold exactly

  const Uv& uv(const Corner_index h) const { return corner(h).uv; }

  // A component of the coordinates of a corner, exactly and rounded.
  Component<Group> component(const Corner_index h, const std::size_t c) const
  { return internal::component<Group>(uv(h), c); }
  double rounded_component(const Corner_index h, const std::size_t c) const
  { return Group::value(int(c), uv(h)); }

  typename Group::Element rotation(const Corner_index h) const
  {
    const std::int32_t t = corner(h).transition;
    return t == no_index ? Group::identity() : transitions[std::size_t(t)].rotation;
  }
};

// Whether a component is constant along an edge, on a level that is asked for.
template <typename Group, typename Is_level>
bool is_on_isocurve(const Basic_chart_mesh<Group>& mesh, const Corner_index h,
                    const Is_level& is_level)
{
  for(std::size_t c = 0; c < std::size_t(Group::number_of_functionals); ++c) {
    const auto a = mesh.component(mesh.prev(h), c);
    if(a == mesh.component(h, c) && is_level(a))
      return true;
  }
  return false;
}

template <typename Group>
bool is_on_isocurve(const Basic_chart_mesh<Group>& mesh, const Corner_index h)
{ return is_on_isocurve(mesh, h, [](const auto&) { return true; }); }

using Chart_transition = Basic_chart_transition<Quarter_turns>;
using Chart_mesh = Basic_chart_mesh<Quarter_turns>;

// The number that turns sign * (a component in one chart) into the component in another chart.
template <typename Group>
typename Basic_chart_transition<Group>::Translation
offset(const Component<Group>& from, const int sign, const Component<Group>& to)
{
  if constexpr(Group::is_signed_permutation) {
    return Exact_difference(to, sign * from);
  } else {
    Exact_level result(from);
    result.transform(-sign, to);
    return result;
  }
}

// A point of the surface: weights of the corners 3 f, 3 f + 1, 3 f + 2 of a face; rounded.
struct Face_point
{
  Flat_face_index face = no_index;
  std::array<double, 3> weights{};
};

inline Face_point point_at_vertex(const Corner_index h)
{
  Face_point result;
  result.face = Flat_mesh<Chart_corner>::face(h);
  result.weights[std::size_t(h % 3)] = 1;
  return result;
}

// `t` is 0 at the source of the halfedge, 1 at its target.
inline Face_point point_on_edge(const Corner_index h, const double t)
{
  Face_point result = point_at_vertex(h);
  result.weights[std::size_t(h % 3)] = t;
  result.weights[std::size_t((h + 2) % 3)] = 1 - t;
  return result;
}

// Takes a component of a point on the edge of a halfedge to the chart of the opposite face. Returns
// which component it becomes.
template <typename Group>
std::size_t carry_over_edge(const Basic_chart_mesh<Group>& mesh, const Corner_index h,
                            const std::size_t c, Exact_level& value)
{
  const std::int32_t t = mesh.corner(h).transition;
  if(t == no_index)
    return c;
  const Basic_chart_transition<Group>& transition = mesh.transitions[std::size_t(t)];
  const Signed_functional image = Group::act(transition.rotation, int(c));
  value.transform(image.sign, transition.translation[std::size_t(image.index)]);
  return std::size_t(image.index);
}

// The faces that are flipped or degenerate in the domain: no isocurve can be followed through them.

template <typename Group>
Uv_triangle triangle(const Basic_chart_mesh<Group>& mesh, const std::size_t face)
{
  const Corner_index h = Corner_index(3 * face);
  return {mesh.uv(h), mesh.uv(h + 1), mesh.uv(h + 2)};
}

// In order.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename Group>
std::vector<std::size_t> nonpositive_faces(const Basic_chart_mesh<Group>& mesh)
{
  using Faces = std::vector<std::size_t>;
  Faces result;
  const auto of_chunk = [&](const Chunk& chunk) {
    Faces faces;
    for(std::size_t f = chunk.begin; f < chunk.end; ++f)
      if(orientation(triangle(mesh, f)) != CGAL::POSITIVE)
        faces.push_back(f);
    return faces;
  };
  for(const Faces& faces : results_of_chunks<Faces, ConcurrencyTag>(mesh.corners.size() / 3,
                                                                    of_chunk))
    result.insert(result.end(), faces.begin(), faces.end());
  return result;
}

// How many there are, and the first, in words. `what` they are, such as "flipped".
inline Message name_of_faces(const std::vector<std::size_t>& faces, const std::string& what)
{
  return std::to_string(faces.size()) + (faces.size() == 1 ? " face is " : " faces are ") + what +
         ", the first is " + name_of_face(faces.front());
}

// Tells the report why no isocurve can be followed, if there is such a face.
template <typename Group>
bool are_positive(const Basic_chart_mesh<Group>& mesh, const std::vector<std::size_t>& nonpositive,
                  Report& report,
                  const Message& how_to_repair =
                    remedy("repair them by snap_to_seamless() with repair_flips(true)"))
{
  if(nonpositive.empty())
    return true;
  const std::size_t flipped =
    std::count_if(nonpositive.begin(), nonpositive.end(), [&](const std::size_t f) {
      return orientation(triangle(mesh, f)) == CGAL::NEGATIVE;
    });
  return refuse(report, Outcome::NOT_POSITIVE,
                name_of_faces(nonpositive, "flipped or degenerate in the domain") +
                  (mean_mirroring(flipped, mesh.corners.size() / 3)
                     ? remedy(remedy_for_mirrored_maps) : how_to_repair));
}

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_CHART_MESH_H
