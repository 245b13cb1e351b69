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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_REFUSAL_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_REFUSAL_H

#include <CGAL/license/Linear_snapping.h>

// The failure of a step: outcome, place, reason, and remedy, which become the report. Also makes
// the parts of messages.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/types/Report.h>

#include <CGAL/Exact_integer.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// Invariant: the outcome is no success.
struct Refusal
  : public Report
{
  using Certificate = std::vector<std::pair<std::size_t, CGAL::Exact_integer> >;

  Refusal(const Outcome outcome, Message words, Certificate c = {})
    : Report(outcome, std::move(words)), certificate(std::move(c))
  { }

  Certificate certificate; // see `Linear_report`
};

// Writes to a report why something can't be done, and returns `false`.
inline bool refuse(Report& report, const Report& refusal)
{
  report = refusal;
  return false;
}

inline bool refuse(Report& report, const Outcome outcome, const Message& message)
{
  return refuse(report, Report(outcome, message));
}

// A report that says no more than that.
template <typename Any_report, typename... Refusals>
Any_report refused(const Refusals&... refusal)
{
  Any_report report;
  refuse(report, refusal...);
  return report;
}

inline std::optional<Refusal> inexact_arithmetic()
{
  if(is_arithmetic_exact())
    return std::nullopt;
  return Refusal(Outcome::INEXACT_ARITHMETIC, inexact_arithmetic_message());
}

inline Message name_of_face(const std::size_t f, const std::string& noun = "face")
{ return {Message::FACE, noun, f}; }

inline Message name_of_vertex(const std::size_t v, const std::string& noun = "vertex")
{ return {Message::VERTEX, noun, v}; }

// "cell 3", "row 3"
inline Message name_of_element(const std::string& noun, const std::size_t i)
{ return {Message::ELEMENT, noun, i}; }

// Words with names of parameters and functions.
inline Message term(const std::string& words) { return {Message::TERM, words}; }

// The begin of what the caller can do.
inline Message remedy(const std::string& words) { return {Message::REMEDY, words}; }

// Remedies of several functions.
constexpr const char* raise_tolerance = "raise the tolerance";
constexpr const char* scale_up = "scale the map up by grid_scale";
constexpr const char* duplicate_vertices =
  "see CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices()";

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_REFUSAL_H
