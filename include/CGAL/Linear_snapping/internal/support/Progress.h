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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_PROGRESS_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_PROGRESS_H

#include <CGAL/license/Linear_snapping.h>

// Tells the caller about the progress of a function.

#include <CGAL/Linear_snapping/types/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <chrono>
#include <functional>
#include <iostream>
#include <string>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// While an object lives, its thread reports to the visitor among the named parameters, or to the
// error stream with `verbose`. Without a visitor, the visitor of an outer object stays, so that
// functions that call others need not pass it on. An exception of the visitor ends the work.
// Therefore nothing is reported after data of the caller has been written.
class Progress
{
  using Clock = std::chrono::steady_clock;
  using Visitor = std::function<void(const std::string&)>;

public:
  template <typename NamedParameters>
  explicit Progress(const NamedParameters& np)
    : m_visitor(visitor(np)), m_outer(s_current)
  {
    if(m_visitor)
      s_current = this;
  }

  ~Progress() { s_current = m_outer; }

  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Reports the result of `words()`. Functions that the visitor itself calls report nothing to it.
  template <typename Words>
  static void tell(const Words& words)
  {
    struct Pause
    {
      Progress* const progress = s_current;
      Pause() { s_current = nullptr; }
      ~Pause() { s_current = progress; }
    } const pause;
    if(pause.progress == nullptr)
      return;
    pause.progress->m_visitor(words());
    pause.progress->m_told = Clock::now();
  }

  // Tells the words if nothing has been told for a second.
  template <typename Words>
  static void tell_each_second(const Words& words)
  {
    if(s_current != nullptr && Clock::now() - s_current->m_told >= interval)
      tell(words);
  }

  inline static Clock::duration interval = std::chrono::seconds(1); // tests shorten it

private:
  template <typename NamedParameters>
  static Visitor visitor([[maybe_unused]] const NamedParameters& np)
  {
    if constexpr(is_given<NamedParameters, CGAL::internal_np::visitor_t>)
      return CGAL::parameters::get_parameter(np, CGAL::internal_np::visitor);
    else
      return chosen(np, CGAL::internal_np::verbose, false) ? write_line : Visitor();
  }

  static void write_line(const std::string& line) { std::cerr << "  " + line + "\n" << std::flush; }

  Visitor m_visitor;
  Progress* m_outer;
  Clock::time_point m_told = Clock::now();
  inline static thread_local Progress* s_current = nullptr;
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_PROGRESS_H
