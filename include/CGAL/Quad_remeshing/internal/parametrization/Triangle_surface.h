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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_TRIANGLE_SURFACE_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_TRIANGLE_SURFACE_H

#include <CGAL/license/Quad_remeshing.h>

// A triangle mesh in plain arrays with its intrinsic geometry: lengths, angles, and a plane layout
// of each face, on which all steps of the parametrization work.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Seamless_snapping/internal/mesh/Flat_mesh.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

constexpr std::size_t none = static_cast<std::size_t>(-1); // of vertices, components, unknowns
constexpr double pi = 3.14159265358979323846;
constexpr double quarter_turn = 2 * pi / Quarter_turns::order;

// Invariant: the triangles are not degenerate, and the angles, areas and directions belong to
// triangles with the given lengths.
struct Triangle_surface : Flat_mesh<Flat_corner>
{
  std::size_t number_of_components = 0;
  int exponent = 0; // lengths of the mesh times 2^-exponent are far from over- and underflow

  // per halfedge
  std::vector<double> length;
  std::vector<double> angle;     // of the corner
  std::vector<double> direction; // of the halfedge, in the plane layout of its face
  std::vector<double> bending;   // signed dihedral angle, positive if convex; 0 on the border
  std::vector<double> turn_by_size; // from the center of the face; empty if sizes are all the same
  std::vector<char> is_aligned;  // the edge is to lie on an isocurve (equal for both halfedges)

  // per face
  std::vector<double> area;
  std::vector<std::size_t> component;

  std::size_t component_of_vertex(const std::size_t v) const
  { return component[face(corner_at_vertex[v])]; }

  // A place in the mesh for messages: faces are counted in the order of `faces(tmesh)`.
  Message describe_vertex(const std::size_t v) const
  {
    return "a vertex of " + name_of_face(std::size_t(face(corner_at_vertex[v])));
  }

  // A direction at angle `a` in the layout of face(h) has the angle `a + transport(h)` in the
  // layout of the face across `h`: unfold the two faces along the edge.
  double transport(const Corner_index h) const
  {
    const double turn = direction[opposite(h)] + pi - direction[h];
    return turn_by_size.empty() ? turn : turn + turn_by_size[h] - turn_by_size[opposite(h)];
  }
};

// Takes the alignment of an edge away, which is not on the border. Returns the halfedge.
inline Corner_index release_edge(Triangle_surface& surface, const Corner_index h)
{
  surface.is_aligned[h] = surface.is_aligned[surface.opposite(h)] = false;
  return h;
}

// The curvature concentrated at each vertex: what the angles lack of 2 pi, or of pi on the border,
// and what the sizes add.
inline std::vector<double> angle_defects(const Triangle_surface& surface)
{
  std::vector<double> defect(surface.number_of_vertices());
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    defect[v] = surface.is_border[v] ? pi : 2 * pi;
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    defect[surface.vertex(h)] -= surface.angle[h];
  if(!surface.turn_by_size.empty())
    for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
      if(!surface.is_border_edge(h))
        defect[surface.vertex(h)] +=
          surface.turn_by_size[h] - surface.turn_by_size[surface.opposite(h)];
  return defect;
}

// The corners at a vertex from one aligned edge to the next.
struct Aligned_sector
{
  Corner_index first; // its outgoing edge is aligned
  std::size_t number_of_corners;
  double angle;
};

template <typename Visit>
void for_each_corner(const Triangle_surface& surface, const Aligned_sector& sector,
                     const Visit& visit)
{
  Corner_index h = sector.first;
  for(std::size_t i = 0; i < sector.number_of_corners; ++i, h = surface.counterclockwise(h))
    visit(h);
}

// Not for one that goes all around, as where a single aligned edge ends.
template <typename Visit>
void for_each_sector(const Triangle_surface& surface, const std::size_t v, const Visit& visit)
{
  Corner_index first = no_index;
  for_each_corner(surface, v, [&](const Corner_index h) {
    if(first == no_index && surface.is_aligned[surface.next(h)])
      first = h;
  });
  if(first == no_index)
    return;
  Aligned_sector sector{first, 0, 0};
  Corner_index h = first;
  do {
    ++sector.number_of_corners;
    sector.angle += surface.angle[h];
    const Corner_index following = surface.counterclockwise(h);
    if(surface.is_aligned[h]) {
      if(following != sector.first)
        visit(sector);
      sector = {following, 0, 0};
    }
    h = following;
  } while(h != no_index && h != first);
}

// The mean of values per face or per halfedge over each component: components are parametrized
// independently of each other, whatever their sizes are.
inline std::vector<double> component_means(const Triangle_surface& surface,
                                           const std::vector<double>& values)
{
  std::vector<double> mean(surface.number_of_components, 0), count(mean);
  for(std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t c = surface.component[i * surface.number_of_faces() / values.size()];
    mean[c] += values[i];
    ++count[c];
  }
  for(std::size_t c = 0; c < mean.size(); ++c)
    mean[c] /= count[c];
  return mean;
}

// Fills the arrays that follow from `length`: angles, areas and directions. The layout of a face
// has its first halfedge along the x-axis.
inline void lay_out_faces(Triangle_surface& surface)
{
  using S = Triangle_surface;
  surface.angle.resize(surface.number_of_halfedges());
  surface.direction.resize(surface.number_of_halfedges());
  surface.area.resize(surface.number_of_faces());
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    const double a = surface.length[h], b = surface.length[S::next(h)];
    const double c = surface.length[S::prev(h)];
    // Kahan's formula for half of the angle: stable for needles.
    const double numerator = (c + (a - b)) * (c - (a - b));
    const double denominator = (a + b + c) * (a + b - c);
    surface.angle[h] = 2 * std::atan2(std::sqrt((std::max)(numerator, 0.)),
                                      std::sqrt((std::max)(denominator, 0.)));
  }
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f) {
    const Corner_index h = 3 * f;
    surface.direction[h] = 0;
    surface.direction[h + 1] = pi - surface.angle[h];
    surface.direction[h + 2] = surface.direction[h + 1] + pi - surface.angle[h + 1];
    surface.area[f] = surface.length[h] * surface.length[h + 1] * std::sin(surface.angle[h]) / 2;
  }
}

// Lengthens all edges of a component by the same small amount such that no triangle is degenerate.
// Only the lengths matter to the steps that follow, so that this lets them run on any mesh; it is
// zero for components without (nearly) degenerate faces.
inline void mollify_lengths(Triangle_surface& surface)
{
  using S = Triangle_surface;
  std::vector<double> mean = component_means(surface, surface.length);
  const double largest_mean = *std::max_element(mean.begin(), mean.end());
  for(double& m : mean)
    m = (m > 0) ? m : largest_mean; // all points of the component coincide
  std::vector<double> increase(surface.number_of_components, 0);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    const double slack = surface.length[h] + surface.length[S::next(h)]
                         - surface.length[S::prev(h)];
    const std::size_t c = surface.component[S::face(h)];
    increase[c] = (std::max)(increase[c], 1e-6 * mean[c] - slack);
  }
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    surface.length[h] += increase[surface.component[S::face(h)]];
}

// Spanning trees of the faces of each component, by breadth: visit(h) for each halfedge by whose
// edge a tree goes on from the face of h. Trees cross only edges for which may_cross(h).
template <typename MayCross, typename Visit>
void for_each_edge_of_face_trees(const Triangle_surface& surface, const MayCross& may_cross,
                                 const Visit& visit)
{
  std::vector<char> is_visited(surface.number_of_faces(), false);
  std::vector<Flat_face_index> queue;
  for(Flat_face_index seed = 0; seed < surface.number_of_faces(); ++seed) {
    if(is_visited[seed])
      continue;
    is_visited[seed] = true;
    queue.assign(1, seed);
    for(std::size_t i = 0; i < queue.size(); ++i)
      for(Corner_index h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h) {
        if(surface.is_border_edge(h) || !may_cross(h))
          continue;
        const Flat_face_index g = surface.face(surface.opposite(h));
        if(is_visited[g])
          continue;
        is_visited[g] = true;
        visit(h);
        queue.push_back(g);
      }
  }
}

// Whether it takes less time to look at few faces by themselves than at all faces.
inline bool is_large(const Triangle_surface& surface) { return surface.number_of_faces() > 50000; }

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_TRIANGLE_SURFACE_H
