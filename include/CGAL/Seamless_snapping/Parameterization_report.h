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

#ifndef CGAL_SEAMLESS_SNAPPING_PARAMETERIZATION_REPORT_H
#define CGAL_SEAMLESS_SNAPPING_PARAMETERIZATION_REPORT_H

#include <CGAL/license/Seamless_snapping.h>

// What approximate_seamless_parameterization() returns: whether a parametrization was made and, if
// not, why; the topology, the cones and the quality of the result; where the time went.

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingParametrizing

The outcome of `approximate_seamless_parameterization()`. After any outcome but `PARAMETERIZED` the
caller's coordinates are untouched.
*/
enum class Parameterization_status
{
  PARAMETERIZED,     ///< the coordinates were written
  INVALID_ARGUMENT,  ///< no face, no extent, or a parameter out of its range
  NOT_TRIANGULAR,    ///< a face of the mesh is not a triangle
  NOT_MANIFOLD,      ///< the faces around a vertex form more than one fan
  NOT_FINITE,        ///< a coordinate of a point is NaN or infinite
  INVALID_CONES,     ///< given indices do not add up to \f$ 4 \chi \f$, or one is 4 or more
  INVALID_ALIGNMENT, ///< the alignment asked for would collapse a face
  SOLVER_FAILED,     ///< a sparse linear system could not be solved
  INTERNAL_ERROR     ///< a result failed its own verification and was discarded
};

/*!
\ingroup PkgSeamlessSnappingParametrizing
returns the status in words.
*/
inline const char* to_string(const Parameterization_status status)
{
  switch(status) {
  case Parameterization_status::PARAMETERIZED:     return "parameterized";
  case Parameterization_status::INVALID_ARGUMENT:  return "invalid argument";
  case Parameterization_status::NOT_TRIANGULAR:    return "not triangular";
  case Parameterization_status::NOT_MANIFOLD:      return "not manifold";
  case Parameterization_status::NOT_FINITE:        return "not finite";
  case Parameterization_status::INVALID_CONES:     return "invalid cones";
  case Parameterization_status::INVALID_ALIGNMENT: return "invalid alignment";
  case Parameterization_status::SOLVER_FAILED:     return "solver failed";
  case Parameterization_status::INTERNAL_ERROR:    break;
  }
  return "internal error";
}

/*!
\ingroup PkgSeamlessSnappingParametrizing

The status and the figures that `approximate_seamless_parameterization()` returns.
Converts to `bool`: `true` if and only if the coordinates were written.

\tparam VertexDescriptor the vertex descriptor of the mesh
*/
template <typename VertexDescriptor>
struct Parameterization_report
{
  /// \name Outcome
  /// @{
  Parameterization_status status = Parameterization_status::PARAMETERIZED; ///< the outcome
  std::string message; ///< on failure the reason and, as far as known, the place and the remedy
  /// @}

  /// \name Topology
  /// @{
  std::size_t number_of_faces = 0;        ///< faces of the mesh
  std::size_t number_of_components = 0;   ///< connected components
  std::size_t number_of_border_loops = 0; ///< closed sequences of border edges
  /*!
  The Euler characteristic \f$ \chi \f$ of the whole mesh, without isolated vertices: the sum of
  \f$ 2 - 2 g - b \f$ over its components, of genus \f$ g \f$ and with \f$ b \f$ border loops.
  */
  std::ptrdiff_t euler_characteristic = 0;
  std::ptrdiff_t genus = 0; ///< the sum of the genera of the components
  /// @}

  /// \name Field
  /// @{
  /*!
  The singular vertices in the interior, each with its index: in quarter turns, +1 for a corner of a
  cube (valence 3 of a quadrangulation), -1 for valence 5.
  */
  std::vector<std::pair<VertexDescriptor, int> > cones;
  /*!
  The number of quarter turns that the borders make, relative to the field: together with the
  indices of the cones it adds up to \f$ 4 \chi \f$, which has been verified in integers.
  */
  std::ptrdiff_t border_turning = 0;
  /// @}

  /// \name Parametrization
  /// @{
  std::size_t number_of_cut_edges = 0;        ///< interior edges that were cut open
  std::size_t number_of_cut_branches = 0;     ///< sequences of cut edges that share one transition
  std::size_t number_of_aligned_edges = 0;    ///< edges that were constrained to isocurves
  /// triangles whose area in the plane is not positive: those of no area are counted, which
  /// `Seamlessness` counts by themselves
  std::size_t number_of_flipped_faces = 0;
  std::size_t number_of_stiffening_rounds = 0; ///< solves that were spent on lowering this number
  std::size_t number_of_flips_before_untangling = 0; ///< what this number was without untangling
  /// what untangling took: iterations over as many faces as the mesh has, rounded up
  std::size_t number_of_untangling_iterations = 0;
  /// with `release_alignment`, the edges that are not aligned although they were to be, each by its
  /// vertices
  std::vector<std::pair<VertexDescriptor, VertexDescriptor> > released_edges;
  double extent = 0;    ///< the larger side of the bounding box of the coordinates
  double violation = 0; ///< largest difference of the sides of a cut edge after rotation
  /// @}

  /// \name Time
  /// @{
  /// the steps in the order in which they were made, with their wall-clock times in seconds
  std::vector<std::pair<std::string, double> > step_times;
  double seconds_in_solvers = 0; ///< the part of it that sparse factorizations and solves took
  /// @}

  /// returns `true` if and only if the coordinates were written.
  explicit operator bool() const { return status == Parameterization_status::PARAMETERIZED; }
};

/*!
\ingroup PkgSeamlessSnappingParametrizing
writes the status in words.
*/
inline std::ostream& operator<<(std::ostream& os, const Parameterization_status status)
{
  return os << to_string(status);
}

/*!
\ingroup PkgSeamlessSnappingParametrizing
writes the status and, if there is one, the message.
*/
template <typename VertexDescriptor>
std::ostream& operator<<(std::ostream& os, const Parameterization_report<VertexDescriptor>& report)
{
  os << report.status;
  if(!report.message.empty())
    os << ": " << report.message;
  return os;
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_PARAMETERIZATION_REPORT_H
