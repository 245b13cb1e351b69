// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Linear_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_LINEAR_SNAPPING_TYPES_REPORT_H
#define CGAL_LINEAR_SNAPPING_TYPES_REPORT_H

#include <CGAL/license/Linear_snapping.h>

// How a function ends, in one vocabulary for all of them.

#include <CGAL/Linear_snapping/types/Message.h>

#include <ostream>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Linear_snapping {

/*!
\ingroup PkgLinearSnappingRef

The outcome of a function. All functions use the same name for the same condition. The first four
outcomes are successes: the result has been written, or was there already. After any other outcome
the data of the caller are as before, bit for bit.
*/
enum class Outcome
{
  SUCCESS,            ///< the result was written, by a function that snaps nothing
  ALREADY_EXACT,      ///< all constraints held exactly before; nothing was written
  SNAPPED,            ///< values were moved, and now all constraints hold exactly
  /// all constraints hold exactly, but some faces that `repair_flips` asked for, or some cells of
  /// an integer grid, are not positive. `Snapping_report::largest_change` is 0 if nothing was
  /// written
  FLIPS_REMAIN,

  INVALID_ARGUMENT,   ///< no face, sizes that do not match, a parameter out of its range
  NOT_TRIANGULAR,     ///< a face of the mesh is not a triangle
  /// the faces around a vertex form more than one fan; a facet of a volume belongs to more than two
  /// cells; or the faces of a soup are no oriented surface
  NOT_MANIFOLD,
  NOT_FINITE,         ///< a value is NaN or infinite; or a coordinate of a mesh is beyond 1e300
  NOT_SEAMLESS,       ///< the sides of an edge differ; for snapping, by more than the tolerance
  NOT_POSITIVE,       ///< faces are flipped or degenerate in the domain
  /// an edge that is to lie on an isocurve does not; for snapping, by more than the tolerance
  NOT_ALIGNED,
  /// a connection or cycle constraint misses by more than its tolerance
  NOT_CONNECTED,
  /// a translation, a cone, or an aligned edge is not at an integer; for snapping, it is farther
  /// from its integer than the tolerance
  NOT_INTEGER,
  INVALID_ROTATIONS,  ///< the rotations given by the caller do not fit together
  INVALID_CONES,      ///< given indices do not add up to \f$ 4 \chi \f$, or one is 4 or more
  INVALID_ALIGNMENT,  ///< the alignment asked for would collapse a face
  INCONSISTENT,       ///< the constraints contradict each other
  /// the constraints have solutions, but the function found none nearby in the number type
  NOT_REPRESENTABLE,
  /// there are more cells or pieces of curves than allowed, an elimination takes too long, or
  /// numbers are too large
  TOO_LARGE,
  TOO_COARSE,         ///< parts of the surface are too small for the grid to enclose them by cells
  NO_FACE_GRAPH,      ///< the cells form no face graph: they have loops or double edges
  SOLVER_FAILED,      ///< a sparse linear system could not be solved
  INEXACT_ARITHMETIC, ///< floating point arithmetic does not follow IEEE 754
  INTERNAL_ERROR      ///< the result failed its own exact verification and was discarded
};

/*!
\ingroup PkgLinearSnappingRef
returns the outcome in words.
*/
inline const char* to_string(const Outcome outcome)
{
  switch(outcome) {
  case Outcome::SUCCESS:            return "success";
  case Outcome::ALREADY_EXACT:      return "already exact";
  case Outcome::SNAPPED:            return "snapped";
  case Outcome::FLIPS_REMAIN:       return "exact, but flips remain";
  case Outcome::INVALID_ARGUMENT:   return "invalid argument";
  case Outcome::NOT_TRIANGULAR:     return "not triangular";
  case Outcome::NOT_MANIFOLD:       return "not manifold";
  case Outcome::NOT_FINITE:         return "not finite";
  case Outcome::NOT_SEAMLESS:       return "not seamless";
  case Outcome::NOT_POSITIVE:       return "not positive";
  case Outcome::NOT_ALIGNED:        return "not aligned";
  case Outcome::NOT_CONNECTED:      return "not connected";
  case Outcome::NOT_INTEGER:        return "not integer";
  case Outcome::INVALID_ROTATIONS:  return "invalid rotations";
  case Outcome::INVALID_CONES:      return "invalid cones";
  case Outcome::INVALID_ALIGNMENT:  return "invalid alignment";
  case Outcome::INCONSISTENT:       return "inconsistent";
  case Outcome::NOT_REPRESENTABLE:  return "not representable";
  case Outcome::TOO_LARGE:          return "too large";
  case Outcome::TOO_COARSE:         return "too coarse";
  case Outcome::NO_FACE_GRAPH:      return "no face graph";
  case Outcome::SOLVER_FAILED:      return "solver failed";
  case Outcome::INEXACT_ARITHMETIC: return "inexact arithmetic";
  case Outcome::INTERNAL_ERROR:     break;
  }
  return "internal error";
}

/*!
\ingroup PkgLinearSnappingRef
writes the outcome in words.
*/
inline std::ostream& operator<<(std::ostream& os, const Outcome outcome)
{
  return os << to_string(outcome);
}

/*!
\ingroup PkgLinearSnappingRef

The base class of all reports: the outcome, and a message with the reason and the place. It
converts to `true` if and only if the result has been written, or was there already.
*/
struct Report
{
  Outcome status = Outcome::SUCCESS; ///< the outcome
  /// on failure: the place, the reason, and the remedy. After success, it can hold a note, for
  /// example that border edges coincide or that faces are not positive
  Message message;

  /// \cond SKIP_IN_MANUAL
  explicit Report(const Outcome s = Outcome::SUCCESS, Message m = {})
    : status(s), message(std::move(m))
  { }
  /// \endcond

  /// returns `true` if and only if the outcome is one of the first four.
  explicit operator bool() const { return status <= Outcome::FLIPS_REMAIN; }
};

/*!
\ingroup PkgLinearSnappingRef
The exception of functions that return no report.
*/
struct Invalid_input
  : public std::invalid_argument
{
  Message message; ///< the place, the reason, and the remedy

  /// \cond SKIP_IN_MANUAL
  explicit Invalid_input(const Message& m) : std::invalid_argument(m.str()), message(m) { }
  /// \endcond
};

/*!
\ingroup PkgLinearSnappingRef
writes the outcome and, if there is one, the message.
*/
inline std::ostream& operator<<(std::ostream& os, const Report& report)
{
  os << report.status;
  if(!report.message.empty())
    os << ": " << report.message;
  return os;
}

} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_TYPES_REPORT_H
