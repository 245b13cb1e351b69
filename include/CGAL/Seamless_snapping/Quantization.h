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

#ifndef CGAL_SEAMLESS_SNAPPING_QUANTIZATION_H
#define CGAL_SEAMLESS_SNAPPING_QUANTIZATION_H

#include <CGAL/license/Seamless_snapping.h>

// How a quantization ends, and what it is.

#include <CGAL/Seamless_snapping/internal/quantization/Intrinsic_complex.h>

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant: the units of the complex are feasible.
struct Quantized_surface
{
  Integer_mesh input;
  Intrinsic_complex complex;
  bool is_for_face_graph = false; // without the quads around vertices of one edge
};

} // namespace internal

/*!
\ingroup PkgSeamlessSnappingQuads

The outcome of a quantization.
*/
enum class Quantization_status
{
  QUANTIZED,          ///< there are integers for all edges
  INEXACT_ARITHMETIC, ///< the processor or the compiler doesn't compute as IEEE 754 says
  INVALID_ARGUMENT,   ///< no face, a target that is not positive and finite, and the like
  NOT_TRIANGULAR,     ///< a face of the input is not a triangle
  NOT_FINITE,         ///< a coordinate is NaN, infinite, or beyond 1e300
  NOT_SEAMLESS,       ///< the map is not exactly seamless
  NOT_POSITIVE,       ///< faces are flipped or degenerate in the domain
  NOT_ALIGNED,        ///< border edges don't lie on isocurves
  TOO_LARGE,          ///< numbers don't fit into 64 bits
  INTERNAL_ERROR      ///< the result failed its own exact verification and was discarded
};

/*!
\ingroup PkgSeamlessSnappingQuads
returns the status in words.
*/
inline const char* to_string(const Quantization_status status)
{
  switch(status) {
  case Quantization_status::QUANTIZED:          return "quantized";
  case Quantization_status::INEXACT_ARITHMETIC: return "inexact arithmetic";
  case Quantization_status::INVALID_ARGUMENT:   return "invalid argument";
  case Quantization_status::NOT_TRIANGULAR:     return "not triangular";
  case Quantization_status::NOT_FINITE:         return "not finite";
  case Quantization_status::NOT_SEAMLESS:       return "not seamless";
  case Quantization_status::NOT_POSITIVE:       return "not positive";
  case Quantization_status::NOT_ALIGNED:        return "not aligned";
  case Quantization_status::TOO_LARGE:          return "too large";
  case Quantization_status::INTERNAL_ERROR:     break;
  }
  return "internal error";
}

/*!
\ingroup PkgSeamlessSnappingQuads

What `quantize()` returns: an all-quad mesh of a parametrized surface, in the form of a coarse
triangulation whose edges are vectors of integers. `extract_quad_mesh()` makes the quads. Converts
to `bool`: `true` if and only if there is one.
*/
class Quantization
{
public:
  Quantization_status status = Quantization_status::QUANTIZED; ///< the outcome
  /// on failure: the place, the reason, and the remedy; else, if there are more than 1.1 times as
  /// many quads as wanted, that no fewer were found
  std::string message;

  /// \name Size
  /// @{
  std::size_t number_of_quads = 0;           ///< of the mesh that it describes
  std::size_t number_of_coarse_vertices = 0; ///< of the coarse triangulation, with all cones
  std::size_t number_of_coarse_faces = 0;    ///< of the coarse triangulation
  /// @}

  /// \name Search
  /// @{
  /// by how much more finely than wanted the search had to begin
  double first_scale = 1;
  std::size_t number_of_moves = 0; ///< steps of the search
  /// edges of the coarse triangulation that are longer than twice what was wanted, plus one unit
  std::size_t number_of_long_edges = 0;
  /// @}

  /// \name Input
  /// @{
  /// faces that are flipped or degenerate in the domain, in the order of iteration over all faces,
  /// from 0
  std::vector<std::size_t> nonpositive_faces;
  std::size_t number_of_unaligned_border_edges = 0; ///< border edges that lie on no isocurve
  std::size_t number_of_unaligned_features = 0; ///< feature edges that lie on no isocurve
  /// @}

  /// returns `true` if and only if there is a quantization.
  explicit operator bool() const { return status == Quantization_status::QUANTIZED; }

  /// \cond SKIP_IN_MANUAL
  const internal::Quantized_surface& surface() const { return *m_surface; }
  void set_surface(internal::Quantized_surface&& surface)
  { m_surface = std::make_shared<const internal::Quantized_surface>(std::move(surface)); }

private:
  std::shared_ptr<const internal::Quantized_surface> m_surface;
  /// \endcond
};

/*!
\ingroup PkgSeamlessSnappingQuads
writes the status and, if there is one, the message.
*/
inline std::ostream& operator<<(std::ostream& os, const Quantization& quantization)
{
  os << to_string(quantization.status);
  if(!quantization.message.empty())
    os << ": " << quantization.message;
  return os;
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_QUANTIZATION_H
