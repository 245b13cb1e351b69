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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_STEP_TIMER_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_STEP_TIMER_H

#include <CGAL/license/Linear_snapping.h>

// Writes the times of the steps of a function into its report, and tells the caller about each
// step.

#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

class Step_timer
{
public:
  template <typename Report>
  explicit Step_timer(Report& report)
    : m_step_times(report.step_times), m_start(Clock::now()), m_is_outermost(s_depth++ == 0)
  { }

  ~Step_timer() { --s_depth; }

  Step_timer(const Step_timer&) = delete;
  Step_timer& operator=(const Step_timer&) = delete;

  // Ends the step that began when the previous one ended. Steps within the step of another timer
  // are told if they take long.
  void finish(const char* step)
  {
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - m_start).count();
    m_start = now;
    const auto same = std::find_if(m_step_times.begin(), m_step_times.end(),
                                   [&](const auto& other) { return other.first == step; });
    const bool is_new = same == m_step_times.end();
    if(is_new)
      m_step_times.emplace_back(step, seconds);
    else
      same->second += seconds; // made again, for another part or on another grid
    if((is_new && m_is_outermost) || seconds > 0.1)
      Progress::tell([&] { return step + (": " + short_number(seconds * 1e3)) + " ms"; });
  }

private:
  using Clock = std::chrono::steady_clock;
  std::vector<std::pair<std::string, double> >& m_step_times;
  Clock::time_point m_start;
  bool m_is_outermost;
  inline static thread_local int s_depth = 0;
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_STEP_TIMER_H
