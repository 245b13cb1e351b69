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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_REFUSAL_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_REFUSAL_H

#include <CGAL/license/Seamless_snapping.h>

// Why a function can't do what it is asked for.

#include <CGAL/Seamless_snapping/Snapping_report.h>
#include <CGAL/Seamless_snapping/internal/exact/Protect_exact_arithmetic.h>

#include <CGAL/Exact_integer.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

struct Refusal
{
  Snapping_status status;
  std::string message;
  std::vector<std::pair<std::size_t, CGAL::Exact_integer> > certificate; // see `Snapping_report`
};

inline Snapping_report report_of(const Refusal& refusal)
{
  Snapping_report report;
  report.status = refusal.status;
  report.message = refusal.message;
  report.certificate = refusal.certificate;
  return report;
}

// Where the compiler was allowed to calculate inexactly.
inline std::optional<Refusal> inexact_arithmetic()
{
  if(is_arithmetic_exact())
    return std::nullopt;
  return Refusal{Snapping_status::INEXACT_ARITHMETIC, inexact_arithmetic_message(), {}};
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_REFUSAL_H
