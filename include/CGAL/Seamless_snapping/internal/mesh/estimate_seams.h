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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_ESTIMATE_SEAMS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_ESTIMATE_SEAMS_H

#include <CGAL/license/Seamless_snapping.h>

// Which mismatched edges are cuts, and how their charts are turned: the topology that explains the
// coordinates with the smallest residuals. Floating point is used throughout: this chooses which
// parametrization is approximated, not whether it is met exactly.

#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Seamless_snapping/internal/complex/trace_branches.h>
#include <CGAL/Seamless_snapping/internal/mesh/Mismatched_edges.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The measures of mismatched edges, whatever the type of halfedges.
class Measured_edges
{
public:
  template <typename Halfedge>
  explicit Measured_edges(std::vector<Mismatched_edge<Halfedge> >& edges)
  {
    m_edges.reserve(edges.size());
    for(Measured_edge& edge : edges)
      m_edges.push_back(&edge);
  }

  std::size_t size() const { return m_edges.size(); }
  Measured_edge& operator[](const std::size_t i) const { return *m_edges[i]; }

private:
  std::vector<Measured_edge*> m_edges;
};

// All edges at a vertex, mismatched or not.
struct Vertex_star
{
  std::size_t number_of_edges = 0;
  bool has_border = false;
};

// The star of the vertex of an incidence.
using Vertex_star_of = std::function<Vertex_star(const Incidence&)>;

struct Seam_options
{
  int order;        // of the symmetry
  double scale;     // lengths are measured after multiplication with it
  double tolerance; // the largest residual that a rotation may have, after that
  double epsilon;   // of the number type
};

// Chooses the rotations. Returns the number of edges whose surroundings ask for another rotation
// than the one that fits them best by themselves.
template <typename Group>
std::size_t estimate_rotations(const Seam_options& options, const std::vector<Edge_ends>& ends,
                               const Vertex_incidences& incidences, const Vertex_star_of& star,
                               const Measured_edges& edges);

// For all groups of rotations.
#define CGAL_SEAMLESS_SNAPPING_ESTIMATE_ROTATIONS(PREFIX, GROUP)                                   \
  PREFIX template std::size_t estimate_rotations<GROUP>(                                           \
    const Seam_options&, const std::vector<Edge_ends>&, const Vertex_incidences&,                  \
    const Vertex_star_of&, const Measured_edges&);

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
CGAL_SEAMLESS_SNAPPING_ESTIMATE_ROTATIONS(extern, Rotation_group<4>)
CGAL_SEAMLESS_SNAPPING_ESTIMATE_ROTATIONS(extern, Rotation_group<6>)
#endif

// How far noise may exceed the largest residual. Residuals add up along a branch, so a gap that
// should be closed can be a few times as wide as a single residual.
constexpr double noise_factor = 8;

// The first condition, for a single edge; the second is for its chain.
inline bool may_be_noise(const Measured_edge& edge, const double residual)
{
  return edge.rotation == 0 && edge.gap <= 8 * noise_factor * residual;
}

// A chain of edges without rotation is judged as a whole, by the mean of its gaps against the
// largest residual of its part, so that a small translation on an accurate map stays what it is.
void mark_merged_edges(const Vertex_incidences& incidences, const Vertex_star_of& star,
                       const Measured_edges& edges);

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Seamless_snapping/internal/mesh/estimate_seams_impl.h>
#endif

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_ESTIMATE_SEAMS_H
