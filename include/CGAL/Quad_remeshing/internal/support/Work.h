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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_SUPPORT_WORK_H
#define CGAL_QUAD_REMESHING_INTERNAL_SUPPORT_WORK_H

#include <CGAL/license/Quad_remeshing.h>

#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/types/Report.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The work that all searches together may still take. It is counted in iterations of untangling
// over a face, of about 3 microseconds: other work counts as the number of iterations that takes as
// long. So results don't depend on the machine.
class Work
{
public:
  explicit Work(const double most = most_work) : m_most(most), m_left(most) { }

  // For large surfaces more, because the shape of each quad takes some.
  // \param number of faces and quads
  static Work of_size(const double number)
  {
    constexpr double of_each = 100; // iterations for each face and quad
    return Work((std::max)(most_work, of_each * number));
  }

  void spend(const double work)
  {
    m_left -= work;
    Progress::tell_each_second([&] {
      return std::to_string(std::lround(100 * (1 - left() / m_most))) +
             " % of the bound of all searches is spent";
    });
  }
  double left() const { return (std::max)(m_left, 0.); }
  bool is_left() const { return m_left > 0; }
  bool is_mostly_left() const { return m_left > 0.7 * m_most; }
  bool is_half_left() const { return m_left > 0.5 * m_most; }

  // For the shape of quads, once so much is spent on it: some is kept for that.
  bool is_left_for_shape(const double work) const { return m_left + most_for_shape > work; }

  static constexpr double most_work = 20e6; // iterations, about a minute
  static constexpr double most_for_shape = 3e6; // iterations, kept for the shape of quads

private:
  double m_most;
  double m_left; // less than 0 where the last search took more
};

inline constexpr const char* words_for_spent_work =
  "searches have ended at the bound of their work";

// To what a report tells, once.
inline void add_note(Report& report, const Message& note)
{
  if(report.message.find(note) == std::string::npos)
    report.message += (report.message.empty() ? "" : "; ") + note;
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_SUPPORT_WORK_H
