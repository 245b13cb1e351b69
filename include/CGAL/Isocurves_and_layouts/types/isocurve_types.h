// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Isocurves_and_layouts package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_TYPES_ISOCURVE_TYPES_H
#define CGAL_ISOCURVES_AND_LAYOUTS_TYPES_ISOCURVE_TYPES_H

#include <CGAL/license/Isocurves_and_layouts.h>

// The words for isocurves: their directions, the elements that their points lie on, their ends, and
// the stop policies of layouts.

#include <CGAL/Isocurves_and_layouts/internal/packages_below.h>
#include <CGAL/Linear_snapping/types/Report.h>

#include <ostream>

namespace CGAL {
namespace Isocurves_and_layouts {

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

The directions of isocurves in a chart: along \f$ +u, +v, -u, -v \f$, and in the lattice
coordinates of `Rotational_symmetry` also along \f$ v - u \f$ and \f$ u - v \f$. In lattice
coordinates, `PLUS_U`, `PLUS_V`, `MINUS_U_PLUS_V`, `MINUS_U`, `MINUS_V`, and `PLUS_U_MINUS_V` are 60
degrees apart, in this order. In a face that is flipped in the domain a direction tells the sides:
at the left of `PLUS_U`, seen on the surface, \f$ v \f$ is larger.
*/
enum class Isocurve_direction
{
  PLUS_U,         ///< \f$ v \f$ is constant, \f$ u \f$ grows
  PLUS_V,         ///< \f$ u \f$ is constant, \f$ v \f$ grows
  MINUS_U,        ///< \f$ v \f$ is constant, \f$ u \f$ falls
  MINUS_V,        ///< \f$ u \f$ is constant, \f$ v \f$ falls
  MINUS_U_PLUS_V, ///< \f$ u + v \f$ is constant, \f$ u \f$ falls and \f$ v \f$ grows
  PLUS_U_MINUS_V  ///< \f$ u + v \f$ is constant, \f$ u \f$ grows and \f$ v \f$ falls
};

/*!
\ingroup PkgIsocurvesAndLayoutsTracing
returns the opposite direction.
*/
inline Isocurve_direction reversed(const Isocurve_direction direction)
{
  const int i = int(direction);
  return Isocurve_direction(i < 4 ? (i + 2) % 4 : 9 - i);
}

/*!
\ingroup PkgIsocurvesAndLayoutsTracing
The element of the mesh on which a point of an isocurve lies.
*/
enum class Isocurve_place
{
  VERTEX, ///< a vertex
  EDGE,   ///< the inside of an edge
  FACE    ///< the inside of a face
};

/*!
\ingroup PkgIsocurvesAndLayoutsTracing

The end of a traced isocurve. The ends from `STUCK_AT_CUT` on occur in floating point only: they are
the failures that Mandad and Campen \cgalCite{cgal:mc-ecstsp-19} list.
*/
enum class Isocurve_status
{
  CONTINUES,        ///< the curve goes on; no function returns this
  TARGET,           ///< it has met a vertex that was given
  SINGULAR_VERTEX,  ///< it has met a singular vertex, or a border vertex (of 360 degrees or more)
                    ///< at which several continuations are straight
  BORDER,           ///< it has met the border, and does not continue along it
  CLOSED,           ///< it has closed exactly
  MAXIMUM_NUMBER,   ///< it has crossed as many edges and vertices as were allowed
  MAXIMUM_LENGTH,   ///< it has become as long as was allowed, or longer by a part of a face
  CONSTANT_ON_FACE, ///< it has met degenerate faces on which its coordinate is constant
  NOT_EXACT,        ///< the parametrization is not exactly seamless, so that nothing was traced
  STUCK_AT_CUT,     ///< behind a cut edge, it points back onto the edge, again and again
  FELL_INTO_GAP,    ///< the place behind a cut edge lies beside the edge
  NO_WAY_OUT,       ///< no direction leads on from a regular vertex
  SEVERAL_WAYS_OUT, ///< several directions lead on from a regular vertex
  FELL_OFF_BORDER,  ///< it has left the surface over a border edge along which it should run
  MISSED_TARGET,    ///< it has passed by a vertex that it should meet
  SPIRALS           ///< it has returned beside its start, instead of closing
};

/*!
\ingroup PkgIsocurvesAndLayoutsTracing
returns `true` for the ends that can only occur if a parametrization is not exactly seamless.
*/
inline bool is_failure(const Isocurve_status status)
{
  return status >= Isocurve_status::NOT_EXACT;
}

using Linear_snapping::to_string; // and of isocurves:

/*!
\ingroup PkgIsocurvesAndLayoutsTracing
returns the status in words.
*/
inline const char* to_string(const Isocurve_status status)
{
  switch(status) {
  case Isocurve_status::CONTINUES:        return "continues";
  case Isocurve_status::TARGET:           return "target";
  case Isocurve_status::SINGULAR_VERTEX:  return "singular vertex";
  case Isocurve_status::BORDER:           return "border";
  case Isocurve_status::CLOSED:           return "closed";
  case Isocurve_status::MAXIMUM_NUMBER:   return "maximum number";
  case Isocurve_status::MAXIMUM_LENGTH:   return "maximum length";
  case Isocurve_status::CONSTANT_ON_FACE: return "constant on a face";
  case Isocurve_status::NOT_EXACT:        return "not exact";
  case Isocurve_status::STUCK_AT_CUT:     return "stuck at a cut";
  case Isocurve_status::FELL_INTO_GAP:    return "fell into a gap";
  case Isocurve_status::NO_WAY_OUT:       return "no way out";
  case Isocurve_status::SEVERAL_WAYS_OUT: return "several ways out";
  case Isocurve_status::FELL_OFF_BORDER:  return "fell off the border";
  case Isocurve_status::MISSED_TARGET:    return "missed its target";
  case Isocurve_status::SPIRALS:          break;
  }
  return "spirals";
}

/// \cond SKIP_IN_MANUAL
constexpr int number_of_isocurve_statuses = static_cast<int>(Isocurve_status::SPIRALS) + 1;
/// \endcond

/*!
\ingroup PkgIsocurvesAndLayoutsTracing
writes the status in words.
*/
inline std::ostream& operator<<(std::ostream& os, const Isocurve_status status)
{
  return os << to_string(status);
}

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

The stop policy of motorcycle graphs: each curve ends at the first curve that it meets, which can be
the curve itself.
*/
struct Stop_at_curves
{
  /// returns `true`.
  template <typename Meeting>
  bool operator()(const Meeting&) const { return true; }
};

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

The stop policy of base complexes: each curve runs on to a node, or to a border or feature. Such
curves can be very long; see `maximum_number` of `motorcycle_graph()`.
*/
struct Run_to_nodes
{
  /// returns `false`.
  template <typename Meeting>
  bool operator()(const Meeting&) const { return false; }
};

} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_TYPES_ISOCURVE_TYPES_H
