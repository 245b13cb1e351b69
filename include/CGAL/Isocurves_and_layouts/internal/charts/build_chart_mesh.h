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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_BUILD_CHART_MESH_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_BUILD_CHART_MESH_H

#include <CGAL/license/Isocurves_and_layouts.h>

// From a mesh, its uv map, and its transitions to plain arrays.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/axis_directions.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/for_each_chunk.h>
#include <CGAL/Seamless_snapping/internal/mesh/given_on_mesh.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_transitions.h>
#include <CGAL/Seamless_snapping/internal/transitions/chosen_options.h>

#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// The quadrant that contains the vector from a to b, which is not null, each with the axis at its
// clockwise end.
inline Direction quadrant(const Uv& a, const Uv& b)
{
  const int x = compare(b[0], a[0]), y = compare(b[1], a[1]);
  if(x > 0 && y >= 0)
    return Quarter_turns::element(0);
  if(x <= 0 && y > 0)
    return Quarter_turns::element(1);
  return Quarter_turns::element((x < 0 && y <= 0) ? 2 : 3);
}

// The sector between the directions of any group.
template <typename Group>
Direction sector(const Uv& a, const Uv& b)
{
  if constexpr(Group::is_signed_permutation) {
    return quadrant(a, b);
  } else {
    const auto is_right = [&](const Direction d) {
      const std::size_t c = constant_component<Group>(d);
      return left_sign<Group>(d) * compare(component<Group>(b, c), component<Group>(a, c)) < 0;
    };
    int d = 0;
    while(is_right(Group::element(d)) || !is_right(Group::element(d + 1)))
      ++d;
    return Group::element(d);
  }
}

// By how many directions a vector passes that turns from the first to the second edge of a corner;
// negative where the face is flipped. These add up to the angle around a vertex, in turns of the
// group, since the seams map directions to directions.
template <typename Group>
int directions_passed(const Uv& p, const Uv& q, const Uv& r)
{
  constexpr int half = Group::order / 2;
  const int passed =
    Group::turns(turned<Group>(sector<Group>(p, r), Group::inverse(sector<Group>(p, q))));
  if(passed == half)
    return orientation({{p, q, r}}) == CGAL::NEGATIVE ? -half : half;
  return passed < half ? passed : passed - Group::order;
}

// The angle if the seams are not exact; the sum is then close to an integer only.
template <typename Group>
double turns_between(const Uv& p, const Uv& q, const Uv& r)
{
  const Uv a = Group::to_cartesian(scaled_to_unit_size(Uv{q[0] - p[0], q[1] - p[1]}));
  const Uv b = Group::to_cartesian(scaled_to_unit_size(Uv{r[0] - p[0], r[1] - p[1]}));
  return std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]) /
         (4 * std::acos(0.) / Group::order);
}

// Whether the angle of a vertex inside of the surface is not 360 degrees. Unlike rotations alone,
// this also finds cones of 720 degrees. An edge without length has no angle with others: at its
// ends, the rotations decide.
template <typename Group>
bool is_singular(const Basic_chart_mesh<Group>& mesh, const std::size_t v)
{
  double angle = 0; // in turns of the group
  typename Group::Element rotation = Group::identity();
  bool has_angle = true;
  for_each_corner(mesh, v, [&](const Corner_index h) {
    const Uv &p = mesh.uv(h), &q = mesh.uv(mesh.next(h)), &r = mesh.uv(mesh.prev(h));
    rotation = Group::compose(mesh.rotation(h), rotation);
    if(p == q || p == r)
      has_angle = false;
    else
      angle += mesh.is_exact ? directions_passed<Group>(p, q, r) : turns_between<Group>(p, q, r);
  });
  return has_angle ? std::lround(angle) != Group::order : rotation != Group::identity();
}

template <typename ConcurrencyTag, typename Group>
void mark_singular_vertices(Basic_chart_mesh<Group>& mesh)
{
  mesh.is_singular.resize(mesh.number_of_vertices());
  for_each_chunk<ConcurrencyTag>(chunks_of(mesh.number_of_vertices()), [&](const Chunk& chunk) {
    for(std::size_t v = chunk.begin; v < chunk.end; ++v)
      mesh.is_singular[v] = !mesh.is_border[v] && is_singular(mesh, v);
  });
}

// The transition across a halfedge whose rotation is known.
template <typename Group>
Basic_chart_transition<Group> make_transition(const Basic_chart_mesh<Group>& mesh,
                                              const Corner_index h,
                                              const typename Group::Element rotation)
{
  const auto translation = [&](const int c) {
    const Signed_functional here = Group::act(Group::inverse(rotation), c);
    return offset<Group>(mesh.component(mesh.prev(h), std::size_t(here.index)), here.sign,
                         mesh.component(mesh.opposite(h), std::size_t(c)));
  };
  if constexpr(Group::number_of_functionals == 2)
    return {rotation, {{translation(0), translation(1)}}};
  else
    return {rotation, {{translation(0), translation(1), translation(2)}}};
}

// Sets it, unless the coordinates are the same on both sides.
template <typename Group>
void add_transition(Basic_chart_mesh<Group>& mesh, const Corner_index h,
                    const typename Group::Element rotation)
{
  const Corner_index p = mesh.prev(h);
  const Corner_index g = mesh.opposite(h);
  if(rotation == Group::identity() && mesh.uv(h) == mesh.uv(mesh.prev(g)) &&
     mesh.uv(p) == mesh.uv(g))
    return;
  mesh.corners[std::size_t(h)].transition = std::int32_t(mesh.transitions.size());
  mesh.transitions.push_back(make_transition(mesh, h, rotation));
}

// The connectivity and the coordinates. Vertices with several fans of faces do no harm here: the
// border keeps their fans apart.
// \pre `numbering` refuses nothing
template <typename ConcurrencyTag, typename TriangleMesh, typename HalfedgeUVMap, typename Group>
void read_charts(const TriangleMesh& tmesh, const Flat_numbering<TriangleMesh>& numbering,
                 const HalfedgeUVMap& uv_map, Basic_chart_mesh<Group>& mesh)
{
  read_flat_mesh<ConcurrencyTag>(tmesh, numbering, mesh, [&](Chart_corner& corner, const auto h) {
    corner.uv = get_uv(uv_map, h);
    corner.transition = no_index;
  });
}

// The rest: `seams` are the transitions that were read off the uv map.
template <typename ConcurrencyTag, typename TriangleMesh, typename Halfedge, typename Group>
void add_transitions(const TriangleMesh& tmesh, const Flat_numbering<TriangleMesh>& numbering,
                     const Transition_data<Halfedge>& seams, Basic_chart_mesh<Group>& mesh)
{
  mesh.extent = seams.extent;
  mesh.violation = seams.violation;
  mesh.is_exact = seams.is_exact;
  for(const auto& edge : seams.edges) {
    add_transition(mesh, numbering.corner(edge.halfedge), edge.rotation);
    add_transition(mesh, numbering.corner(opposite(edge.halfedge, tmesh)),
                   Group::inverse(edge.rotation));
  }
  mark_singular_vertices<ConcurrencyTag>(mesh);
}

template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename Halfedge>
Basic_chart_mesh<Group>
build_chart_mesh(const TriangleMesh& tmesh, const Flat_numbering<TriangleMesh>& numbering,
                 const HalfedgeUVMap& uv_map, const Transition_data<Halfedge>& seams)
{
  Basic_chart_mesh<Group> mesh;
  read_charts<CGAL::Sequential_tag>(tmesh, numbering, uv_map, mesh);
  add_transitions<CGAL::Sequential_tag>(tmesh, numbering, seams, mesh);
  return mesh;
}

// Fills `mesh`, unless it returns a refusal.
// \param read_seams returns the transitions
template <typename ConcurrencyTag, typename TriangleMesh, typename HalfedgeUVMap,
          typename Halfedge, typename Group>
std::optional<Refusal>
read_exact_map_with(const std::function<Transition_data<Halfedge>()>& read_seams,
                    const TriangleMesh& tmesh, const Flat_numbering<TriangleMesh>& numbering,
                    const HalfedgeUVMap& uv_map, Basic_chart_mesh<Group>& mesh)
{
  if(auto refusal = inexact_arithmetic())
    return refusal;
  if(faces(tmesh).size() == 0)
    return Refusal(Outcome::INVALID_ARGUMENT, "the mesh has no face; was it read?");
  Transition_data<Halfedge> seams;
  call_both<ConcurrencyTag>([&] { seams = read_seams(); }, [&] {
    if(!numbering.refusal())
      read_charts<ConcurrencyTag>(tmesh, numbering, uv_map, mesh);
  });
  if(seams.refusal)
    return seams.refusal;
  if(!seams.is_exact)
    return Refusal(Outcome::NOT_SEAMLESS,
                   "the map is not exactly seamless: sides of edges differ by up to " +
                     short_number(seams.violation) + remedy("call snap_to_seamless() first"));
  add_transitions<ConcurrencyTag>(tmesh, numbering, seams, mesh);
  return std::nullopt;
}

template <typename ConcurrencyTag = CGAL::Sequential_tag, typename TriangleMesh,
          typename HalfedgeUVMap, typename NamedParameters, typename Group>
std::optional<Refusal> read_exact_map(const TriangleMesh& tmesh,
                                      const Flat_numbering<TriangleMesh>& numbering,
                                      const HalfedgeUVMap& uv_map, const NamedParameters& np,
                                      Basic_chart_mesh<Group>& mesh)
{
  static_assert(std::is_same_v<Group, Symmetry_group<NamedParameters> >,
                "quads, their quantization, and layouts take maps of rotational symmetry 1, 2, and "
                "4 only; triangles those of 3 and 6");
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  const std::function<Transition_data<Halfedge>()> read_seams =
    [&] { return read_transitions<Group>(tmesh, uv_map, np); };
  return read_exact_map_with<ConcurrencyTag>(read_seams, tmesh, numbering, uv_map, mesh);
}

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_BUILD_CHART_MESH_H
