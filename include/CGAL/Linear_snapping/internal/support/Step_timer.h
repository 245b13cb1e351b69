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

// Times the steps of a function into its report and, if asked to, tells the error stream of each,
// and how far a long one has come.

#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>

#include <algorithm>
#include <chrono>
#include <iostream>
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
  explicit Step_timer(Report& report, const bool verbose = false)
    : m_step_times(report.step_times), m_verbose(verbose), m_start(Clock::now()),
      m_is_first(verbose && !s_is_verbose)
  {
    if(m_is_first) {
      s_is_verbose = true;
      s_told = m_start;
    }
  }

  ~Step_timer()
  {
    if(m_is_first)
      s_is_verbose = false;
  }

  Step_timer(const Step_timer&) = delete;
  Step_timer& operator=(const Step_timer&) = delete;

  // Tells what `words()` returns, wherever in the steps of a timer that is to tell, if nothing has
  // been told for so many seconds.
  template <typename Words>
  static void tell(const double seconds, const Words& words)
  {
    if(!s_is_verbose || Clock::now() - s_told < std::chrono::duration<double>(seconds))
      return;
    std::cerr << "    " + words() + "\n" << std::flush;
    s_told = Clock::now();
  }

  // Ends the step that began when the previous one ended.
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
    if(m_verbose && (is_new || seconds > 0.1))
      std::cerr << "  " << step << ": " << short_number(seconds * 1e3) << " ms" << std::endl;
  }

private:
  using Clock = std::chrono::steady_clock;
  std::vector<std::pair<std::string, double> >& m_step_times;
  bool m_verbose;
  Clock::time_point m_start;
  bool m_is_first; // of the timers that tell
  inline static thread_local bool s_is_verbose = false;
  inline static thread_local Clock::time_point s_told{};
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_STEP_TIMER_H
