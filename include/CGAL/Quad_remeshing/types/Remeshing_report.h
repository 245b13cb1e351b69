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

#ifndef CGAL_QUAD_REMESHING_TYPES_REMESHING_REPORT_H
#define CGAL_QUAD_REMESHING_TYPES_REMESHING_REPORT_H

#include <CGAL/license/Quad_remeshing.h>

// How remeshing ends.

#include <CGAL/Linear_snapping/types/Report.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Quad_remeshing/types/Quad_shapes.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {

/*!
\ingroup PkgQuadRemeshingQuads

A feature that `quad_remesh()` has released, between two points where it turned, ended, or met
others.
*/
struct Released_feature
{
  std::array<double, 3> source, target; ///< its ends
  double length = 0;                    ///< on the surface
};

/*!
\ingroup PkgQuadRemeshingQuads

What `quad_remesh()` returns. Converts to `bool`: `true` if and only if the quads were written.
*/
struct Remeshing_report
  : public Report, public Quad_shapes
{
  /// \name Result
  /// @{
  std::size_t number_of_quads = 0;    ///< faces that were written
  std::size_t number_of_vertices = 0; ///< vertices that were written
  /// vertices inside that have other than four edges
  std::size_t number_of_irregular_vertices = 0;
  /// where there are more than 1.1 times as many quads as wanted: how many of them the features
  /// force; the message tells of it, too
  std::size_t number_of_forced_quads = 0;
  /// features that are not kept as they force quads, with `maximum_feature_loss`
  std::vector<Released_feature> released_features;
  /// quads that are inverted: at a corner, their sides turn the other way than the quad as a whole
  /// does, or the quad has no area, or a side no length, decided exactly, for the points as
  /// doubles; or that lie upside down: by more than 120 degrees, if the surface is flat, they face
  /// against it on the average, at their middle, and half way from there to each corner, as walks
  /// over the surface find in floating point.
  std::size_t number_of_inverted_quads = 0;
  /// the first of them, at most ten, counted from 0 in the order in which the faces were written
  std::vector<std::size_t> first_inverted_quads;
  /// vertices that were moved off the surface, or off the feature or border that they lay on, as
  /// quads would be inverted otherwise
  std::size_t number_of_displaced_vertices = 0;
  double largest_displacement = 0; ///< the largest distance by which these were moved
  /// the largest distance from the input that was found: at vertices and at the middles of faces
  /// and edges, and of up to 6,250 quads at more points of the bilinear patches over them, 25,000
  /// to 100,000 in all, or 4,096 of each. The vertices lie on the input, up to rounding, but for
  /// those that were displaced, and images of what is not symmetric.
  double largest_distance = 0;
  /// the largest distance of the input from the quads, each of them two triangles, that was found:
  /// at its vertices, and at 20,000 points spread over its area, or one for each face
  double largest_distance_of_input = 0;
  /// lengths of edges: a tenth of the edges is shorter than the first one, a half than the second
  /// one, and a tenth is longer than the third one
  std::array<double, 3> edge_lengths{};
  /// by which part the lengths differ from those that are wanted at their middles, in the median:
  /// 0.5 where they are half as long again, or the wanted length is. Without wanted lengths, as
  /// with `minimize_number_of_quads`, with those of `curvature_adaptivity`, and for the quads of a
  /// quantization, there is no value.
  std::optional<double> median_size_deviation;
  /// @}

  /// \name Steps
  /// @{
  /// faces that were flipped in the approximate parametrization
  std::size_t number_of_flipped_faces = 0;
  /// feature edges, or parts of them, that are not kept, as faces would be flipped at them, or
  /// quads inverted
  std::size_t number_of_released_edges = 0;
  double length_of_released_edges = 0; ///< the sum of their lengths
  /// how many corners of the border, with angles nearer to 90 or 270 degrees than to 180, were left
  /// out by `border_tolerance`
  std::size_t number_of_corners_left_out = 0;
  /// the faces that stayed flipped, in the order of iteration over all faces, from 0
  std::vector<std::size_t> remaining_flips;
  /// the steps in the order in which they were made, with their wall-clock times in seconds
  std::vector<std::pair<std::string, double> > step_times;
  /// @}
};

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_TYPES_REMESHING_REPORT_H
