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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_MEASURE_QUADS_IMPL_H
#define CGAL_QUAD_REMESHING_INTERNAL_MEASURE_QUADS_IMPL_H

#include <CGAL/license/Quad_remeshing.h>

// The deviation of quads from the wanted ones, and their places on the surface.

#include <CGAL/Quad_remeshing/internal/Remeshing_run.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Quad_writer.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_locator.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_samples.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_to_remesh.h>
#include <CGAL/Quad_remeshing/internal/remeshing/smooth_quads.h>
#include <CGAL/Quad_remeshing/types/Remeshing_report.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The wanted length of an edge at a place.
inline double size_at(const Surface_to_remesh& input, const Space_vector& place,
                      const Quad_smoother& smoother)
{
  const auto& mesh = input.mesh();
  const auto face = smoother.surface().nearest_face(place);
  const auto part = locate_in_face(to_point(place), face, mesh, mesh.points()).second;
  const auto h = mesh.halfedge(face);
  return part[0] * input.sizes()[mesh.source(h)] + part[1] * input.sizes()[mesh.target(h)] +
         part[2] * input.sizes()[mesh.target(mesh.next(h))];
}

inline std::vector<double> sorted_edge_lengths(const Surface_to_remesh::Mesh& quads,
                                               const Quad_smoother& smoother)
{
  std::vector<double> lengths;
  for(const auto e : quads.edges())
    lengths.push_back(norm(vector_to(smoother.point(quads.vertex(e, 0)),
                                     smoother.point(quads.vertex(e, 1)))));
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

// See `Remeshing_report::median_size_deviation`.
// \param number_wanted of quads for the input, which tells the unit of sizes; 0 where these are not
//        known
inline std::optional<double> median_size_deviation(const Surface_to_remesh& input,
                                                   const double number_wanted,
                                                   const Surface_to_remesh::Mesh& quads,
                                                   const Quad_smoother& smoother)
{
  if(!(number_wanted > 0) || quads.number_of_edges() == 0)
    return std::nullopt;
  const double unit = std::sqrt(area_in_squares(input) / number_wanted);
  const bool sizes_vary = input.has_sizes_that_vary();
  std::vector<double> deviations;
  for(const auto e : quads.edges()) {
    const Space_vector p = smoother.point(quads.vertex(e, 0));
    const Space_vector q = smoother.point(quads.vertex(e, 1));
    const double size = sizes_vary ? size_at(input, between(p, q, 0.5), smoother)
                                   : *input.sizes().begin();
    const double ratio = norm(vector_to(p, q)) / (unit * size);
    deviations.push_back((std::max)(ratio, 1 / ratio) - 1);
  }
  const auto middle = deviations.begin() + std::ptrdiff_t(deviations.size() / 2);
  std::nth_element(deviations.begin(), middle, deviations.end());
  return *middle;
}

// On the side of the quads, up to half of their size away.
inline Nearest_faces nearest_faces(const Surface_to_remesh& input,
                                   const Surface_to_remesh::Mesh& quads,
                                   const Located_elements located, const Quad_smoother& smoother)
{
  const auto number = [&](const Space_vector& place, const Space_vector& doubled_area_vector,
                          const std::size_t number_of_quads) {
    const double size = std::sqrt(norm(doubled_area_vector) / double(2 * number_of_quads));
    return input.original(smoother.surface().nearest_face(place, doubled_area_vector, size / 2));
  };
  Nearest_faces result;
  if(located.vertices) {
    const auto visit = [](const auto&...) { };
    result.of_vertices.resize(quads.num_vertices());
    for(const auto v : quads.vertices())
      result.of_vertices[v] = number(smoother.point(v), smoother.visit_star(v, visit).normal,
                                     quads.degree(v));
  }
  if(located.faces) {
    result.of_faces.resize(quads.num_faces());
    for(const auto f : quads.faces())
      result.of_faces[f] = number(to_vector(middle(quads, f)), quad_normal(smoother.quad(f)), 1);
  }
  return result;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Nearest_faces measure_quads(const Marked_surface& surface, const double number_wanted,
                            Remeshing_types::Mesh quads, const Located_elements located,
                            Remeshing_report& report)
{
  const Surface_to_remesh input(surface, std::nullopt);
  for(auto& p : quads.points())
    p = {input.scaled(p.x()), input.scaled(p.y()), input.scaled(p.z())};
  const Surface_locator locator(input.mesh());
  const Quad_smoother smoother(quads, locator);
  const std::size_t number = (std::max)(20000u, input.mesh().number_of_faces());
  const Surface_samples samples(input.mesh(), number);
  report.largest_distance = input.unscaled(smoother.measure_distance());
  report.largest_distance_of_input = input.unscaled(samples.largest_distance(quads));
  report.median_size_deviation = median_size_deviation(input, number_wanted, quads, smoother);
  const std::vector<double> lengths = sorted_edge_lengths(quads, smoother);
  const std::size_t n = lengths.size();
  if(n > 0)
    report.edge_lengths = {input.unscaled(lengths[n / 10]), input.unscaled(lengths[n / 2]),
                           input.unscaled(lengths[n - 1 - n / 10])};
  return nearest_faces(input, quads, located, smoother);
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_MEASURE_QUADS_IMPL_H
