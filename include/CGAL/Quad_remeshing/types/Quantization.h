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

A connected part of a surface whose quads have not the size that is wanted.
*/
struct Part_of_other_size
{
  std::size_t face = 0;            ///< its first face, in the order of iteration over all faces
  std::size_t number_of_quads = 0; ///< the quads that it has
  double number_wanted = 0;        ///< the quads that it would have in the wanted size
  /// about the quads that its cones, the corners of its border, its handles, or its features take
  std::size_t number_needed = 0;
  /// whether there are more than twice as many quads as wanted, and as needed
  bool has_too_many_quads = false;
};

/*!
\ingroup PkgQuadRemeshingQuantization

The result of `quantize()`: an all-quad mesh of a parametrized surface, in the form of a coarse
triangulation whose edges are vectors of integers. `extract_quad_mesh()` makes the quads. Converts
to `bool`: `true` if and only if there is one.
*/
class Quantization
  : public Report
{
public:
  /// \name Size
  /// @{
  std::size_t number_of_quads = 0;           ///< of the mesh that it describes
  /// the number of quads that the features force: how many fewer there would be without features.
  /// Counted only if there are clearly more quads than wanted, by the first integers that are
  /// tried, whether their quads are a face graph or not.
  std::size_t number_of_forced_quads = 0;
  /// features that were released with `maximum_feature_loss`: the vertices along each, in the order
  /// of iteration over all vertices that have faces, from 0
  std::vector<std::vector<std::size_t> > released_features;
  /// connected parts whose quads are more than three times as long, or as short, as wanted: for
  /// example, a part that is smaller than a quad
  std::vector<Part_of_other_size> parts_of_other_size;
  std::size_t number_of_coarse_vertices = 0; ///< of the coarse triangulation, with all cones
  std::size_t number_of_coarse_faces = 0;    ///< of the coarse triangulation
  /// @}

  /// \name Search
  /// @{
  /// by how much more finely than wanted the search had to begin
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

  /// returns `true` if and only if there is one, which a default-constructed one is not.
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
