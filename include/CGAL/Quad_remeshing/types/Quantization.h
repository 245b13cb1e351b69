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

#ifndef CGAL_QUAD_REMESHING_TYPES_QUANTIZATION_H
#define CGAL_QUAD_REMESHING_TYPES_QUANTIZATION_H

#include <CGAL/license/Quad_remeshing.h>

// The result of a quantization.

#include <CGAL/Linear_snapping/types/Report.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

struct Quantized_surface;

} // namespace internal

/*!
\ingroup PkgQuadRemeshingQuantization

A connected part of a surface whose quads do not have the wanted size.
*/
struct Part_of_other_size
{
  std::size_t face = 0;            ///< its first face, in the order of iteration over all faces
  std::size_t number_of_quads = 0; ///< its number of quads
  double number_wanted = 0;        ///< its number of quads of the wanted size
  /// about how many quads its cones, the corners of its border, its handles, or its features need
  std::size_t number_needed = 0;
  /// whether there are more than twice as many quads as wanted, and as needed
  bool has_too_many_quads = false;
};

/*!
\ingroup PkgQuadRemeshingQuantization

The result of `quantize()`: an all-quad mesh of a parametrized surface, in the form of a coarse
triangulation whose edges are vectors of integers. `extract_quad_mesh()` makes the quads. Converts
to `bool`: `true` if and only if the function has found a quantization.
*/
class Quantization
  : public Report
{
public:
  /// \name Size
  /// @{
  std::size_t number_of_quads = 0;           ///< quads of the mesh
  /// the number of quads that the features force: there would be so many fewer without features.
  /// The function only counts them if there are clearly more quads than wanted. It uses the first
  /// integers that it tries, even if their quads form no face graph.
  std::size_t number_of_forced_quads = 0;
  /// features that were released with `maximum_feature_loss`: the vertices along each, numbered
  /// from 0 in the order of iteration over all vertices that have faces
  std::vector<std::vector<std::size_t> > released_features;
  /// connected parts whose quads are more than three times as long, or as short, as wanted: for
  /// example, a part that is smaller than a quad
  std::vector<Part_of_other_size> parts_of_other_size;
  std::size_t number_of_coarse_vertices = 0; ///< vertices of the coarse triangulation
  std::size_t number_of_coarse_faces = 0;    ///< faces of the coarse triangulation
  /// @}

  /// \name Search
  /// @{
  /// the scale at which the search began, divided by the wanted scale
  double first_scale = 1;
  std::size_t number_of_moves = 0; ///< steps of the search
  /// edges of the coarse triangulation that are longer than twice the wanted length, plus one unit
  std::size_t number_of_long_edges = 0;
  /// @}

  /// \name Input
  /// @{
  /// faces that are flipped or degenerate in the domain, in the order of iteration over all faces,
  /// from 0
  std::vector<std::size_t> nonpositive_faces;
  /// border edges that lie on no isocurve; two sides of quads follow each of them
  std::size_t number_of_unaligned_border_edges = 0;
  std::size_t number_of_unaligned_features = 0; ///< feature edges that lie on no isocurve
  /// @}

  /// returns `true` if and only if this is a quantization; `false` for a default-constructed
  /// object.
  explicit operator bool() const { return m_surface && Report::operator bool(); }

  /// \cond SKIP_IN_MANUAL
  const internal::Quantized_surface& surface() const { return *m_surface; }
  void set_surface(std::shared_ptr<const internal::Quantized_surface> surface)
  { m_surface = std::move(surface); }

private:
  std::shared_ptr<const internal::Quantized_surface> m_surface;
  /// \endcond
};

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_TYPES_QUANTIZATION_H
