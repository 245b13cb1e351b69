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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SIZES_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SIZES_H

#include <CGAL/license/Quad_remeshing.h>

// Sizes that vary: the surface is measured in units of the size wanted at each place, which is a
// conformal change of its metric.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Cross_graph.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Parametrization_options.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Sparse_system.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// Sizes that are all the same go into the target edge length, and so does a power of two near their
// mean, so that no factor is too large.
// \param size wanted at each vertex, in multiples of the target edge length
inline void read_sizes(const std::vector<double>& size, const Triangle_surface& surface,
                       Parametrization_options& options)
{
  double sum = 0;
  for(std::size_t v = 0; v < size.size(); ++v) {
    if(!(size[v] > 0 && std::isfinite(size[v])))
      throw Refusal(Outcome::INVALID_ARGUMENT,
                    "the size of " + surface.describe_vertex(v) + " is not positive and finite");
    sum += std::log2(size[v]);
  }
  if(std::adjacent_find(size.begin(), size.end(), std::not_equal_to<>()) == size.end()) {
    options.target_edge_length *= size[0];
    return;
  }
  constexpr double largest_ratio = 1e9; // of coordinates, bits would be left for few triangles
  const auto range = std::minmax_element(size.begin(), size.end());
  if(*range.second / *range.first > largest_ratio)
    throw Refusal(Outcome::INVALID_ARGUMENT,
                  "the size of " +
                    surface.describe_vertex(std::size_t(range.first - size.begin())) +
                    " is less than a billionth of the largest one; let sizes vary less");
  const int exponent = int(std::lround(sum / double(size.size())));
  options.target_edge_length = std::ldexp(options.target_edge_length, exponent);
  for(const double x : size)
    options.log_size.push_back(std::log(std::ldexp(x, -exponent)));
}

// The bends of edges, times their lengths, over the area around: the sum of the sizes of the
// principal curvatures, roughly; diffused over a part of each component, so that noise makes no
// cones. No value is negative.
inline std::vector<double> diffused_curvature(const Triangle_surface& surface, Timed_solver& solver)
{
  constexpr double distance = 0.08; // relative to the root of the component's area
  const std::vector<double> mean_area = component_means(surface, surface.area);
  std::vector<std::size_t> faces(surface.number_of_components, 0);
  for(const std::size_t c : surface.component)
    ++faces[c];
  Sparse_system system(surface.number_of_vertices(), solver);
  std::vector<double> bending(surface.number_of_vertices(), 0);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    const std::size_t v = surface.vertex(h), c = surface.component[surface.face(h)];
    system.add(v, v, surface.area[surface.face(h)] / 3);
    if(surface.is_border_edge(h))
      continue;
    bending[v] += std::abs(surface.bending[h]) * surface.length[h] / 2;
    const double weight =
      distance * distance * mean_area[c] * double(faces[c]) / dual_weight(surface, h);
    system.add(v, v, weight);
    system.add(v, surface.source(h), -weight);
  }
  system.factor();
  return system.solve(bending);
}

// Adds to the logarithms of sizes, in which they vary with curvature: a chord of the length h is
// off by about h^2 times the curvature, so that the inverse of its root is the size that is wanted.
// Sizes differ by the ratio that is allowed at most, around the mean of each component.
inline void adapt_to_curvature(const Triangle_surface& surface,
                               const std::vector<double>& curvature, const double ratio,
                               std::vector<double>& log_size)
{
  const double largest = *std::max_element(curvature.begin(), curvature.end());
  const auto size = [&](const std::size_t v)
    { return -std::log((std::max)(curvature[v] / largest, 1e-9)) / 2; };
  if(!(largest > 0))
    return;
  std::vector<double> mean(surface.number_of_components, 0), area(mean);
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h) {
    const std::size_t c = surface.component[surface.face(h)];
    mean[c] += surface.area[surface.face(h)] * size(surface.vertex(h));
    area[c] += surface.area[surface.face(h)];
  }
  const double three_areas = std::accumulate(area.begin(), area.end(), 0.);
  if(!(largest * std::sqrt(three_areas) > 1e-6))
    return; // flat but for rounding
  const double most = std::log(ratio) / 2;
  log_size.resize(surface.number_of_vertices(), 0);
  for(std::size_t v = 0; v < log_size.size(); ++v) {
    const std::size_t c = surface.component_of_vertex(v);
    log_size[v] += (std::min)((std::max)(size(v) - mean[c] / area[c], -most), most);
  }
}

// The turns of the metric from the center of each face to the middles of its sides, where the
// logarithm of the size is linear in the face: what `transport()` is to add. Around a vertex, this
// adds up to the change of its curvature.
inline void turn_by_sizes(Triangle_surface& surface, const std::vector<double>& log_size)
{
  surface.turn_by_size.resize(surface.number_of_halfedges());
  for(Corner_index h = 0; h < surface.number_of_halfedges(); h += 3) {
    std::array<std::array<double, 2>, 2> side;
    std::array<double, 2> change;
    for(int i = 0; i < 2; ++i) {
      const double angle = surface.direction[h + i], length = surface.length[h + i];
      side[std::size_t(i)] = {length * std::cos(angle), length * std::sin(angle)};
      change[std::size_t(i)] = log_size[surface.vertex(h + i)] - log_size[surface.source(h + i)];
    }
    const std::array<double, 2> &a = side[0], &b = side[1];
    const double det = a[0] * b[1] - a[1] * b[0];
    const double dx = (change[0] * b[1] - change[1] * a[1]) / det;
    const double dy = (change[1] * a[0] - change[0] * b[0]) / det;
    const auto set = [&](const Corner_index g, const double x, const double y) {
      const double cx = (2 * a[0] + b[0]) / 3, cy = (2 * a[1] + b[1]) / 3;
      surface.turn_by_size[g] = dx * (y - cy) - dy * (x - cx);
    };
    set(h, a[0] / 2, a[1] / 2);
    set(h + 1, a[0] + b[0] / 2, a[1] + b[1] / 2);
    set(h + 2, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
  }
}

// Lengths and areas of each face in units of its size: afterwards, the two sides of an edge differ.
// Returns by how much lengths have become larger in the mean.
inline double measure_by_sizes(Triangle_surface& surface, const std::vector<double>& log_size)
{
  const double area = std::accumulate(surface.area.begin(), surface.area.end(), 0.);
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f) {
    const Corner_index h = 3 * f;
    const double factor = std::exp(-(log_size[surface.vertex(h)] + log_size[surface.vertex(h + 1)] +
                                     log_size[surface.vertex(h + 2)]) / 3);
    for(Corner_index g = h; g < h + 3; ++g)
      surface.length[g] *= factor;
    surface.area[f] *= factor * factor;
  }
  return std::sqrt(std::accumulate(surface.area.begin(), surface.area.end(), 0.) / area);
}

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_SIZES_H
