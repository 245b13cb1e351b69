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
#include <CGAL/Quad_remeshing/types/Quantization.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {

/*!
\ingroup PkgQuadRemeshingRemeshing

A feature that `quad_remesh()` has released, between two points at which it turned, ended, or met
other features.
*/
struct Released_feature
{
  std::array<double, 3> source, target; ///< its ends
  double length = 0;                    ///< its length on the surface
};

/*!
\ingroup PkgQuadRemeshingRemeshing

The result of `quad_remesh()`. Converts to `bool`: `true` if and only if the quads were written.
*/
struct Remeshing_report
  : public Report, public Quad_shapes
{
  /// \name Result
  /// @{
  std::size_t number_of_quads = 0;    ///< faces that were written
  std::size_t number_of_vertices = 0; ///< vertices that were written
  /// inner vertices that have other than four edges
  std::size_t number_of_irregular_vertices = 0;
  /// the number of quads that the features force; counted, and told in the message, only if there
  /// are clearly more quads than wanted
  std::size_t number_of_forced_quads = 0;
  /// whether there are more than twice as many quads as wanted, although neither features nor the
  /// topology of the surface force them; or whether the same is true of one of
  /// `parts_of_other_size`. Never with `minimize_number_of_quads`.
  bool has_too_many_quads = false;
  /// connected parts whose quads are more than three times as long, or as short, as wanted; faces
  /// belong to the input
  std::vector<Part_of_other_size> parts_of_other_size;
  /// closed connected parts that were left out by `area_threshold`
  std::size_t number_of_parts_left_out = 0;
  double area_of_parts_left_out = 0; ///< the sum of their areas
  /// with `maximum_feature_loss`, features that are not kept because they force quads
  std::vector<Released_feature> released_features;
  /// quads that are inverted in space: at a corner, the sides turn against the quad as a whole, or
  /// the area or a side is zero. This is decided exactly, for the points as doubles.
  std::size_t number_of_inverted_quads = 0;
  /// the first of these quads, at most ten, counted from 0 in the order in which the faces were
  /// written
  std::vector<std::size_t> first_inverted_quads;
  /// other quads that are folded: they, or a corner of them, face against the surface below, or
  /// they turn back on a neighbor although the surface does not. Such quads cover a part of the
  /// surface more than once, whatever their own shape is. A sharp edge, a thin wall, or a bend of
  /// the input that is narrower than a quad is no fold. This is decided in floating point.
  std::size_t number_of_folded_quads = 0;
  /// the first of these quads, counted like `first_inverted_quads`
  std::vector<std::size_t> first_folded_quads;
  /// returns the number of quads that are inverted or folded.
  std::size_t number_of_bad_quads() const
  { return number_of_inverted_quads + number_of_folded_quads; }
  /// vertices that were moved off the surface, a feature, or the border, because quads would be
  /// inverted or folded otherwise
  std::size_t number_of_displaced_vertices = 0;
  double largest_displacement = 0; ///< the largest distance of such a move
  /// the largest distance from the input that was found, at vertices and at points of the bilinear
  /// patches over the quads. Vertices lie on the input, up to rounding, except for displaced
  /// vertices and for mirror images of parts that are not symmetric.
  double largest_distance = 0;
  /// the largest distance of the input from the quads that was found, at vertices and at points
  /// spread over the area of the input; each quad counts as two triangles
  double largest_distance_of_input = 0;
  /// the 10th, 50th, and 90th percentile of the lengths of the edges
  std::array<double, 3> edge_lengths{};
  /// the median deviation of an edge's length from the wanted length at its middle: 0.5 if one of
  /// the two is half as long again as the other. There is no value without wanted lengths: with
  /// `minimize_number_of_quads`, with `curvature_adaptivity`, and for the quads of a quantization.
  std::optional<double> median_size_deviation;
  /// @}

  /// \name Steps
  /// @{
  /// faces that were flipped in the approximate parametrization
  std::size_t number_of_flipped_faces = 0;
  /// feature edges, or parts of them, that are not kept, because faces would be flipped there, or
  /// quads inverted or folded
  std::size_t number_of_released_edges = 0;
  double length_of_released_edges = 0; ///< the sum of their lengths
  /// corners of the border, with angles nearer to 90 or 270 degrees than to 180, that
  /// `border_tolerance` left out
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
