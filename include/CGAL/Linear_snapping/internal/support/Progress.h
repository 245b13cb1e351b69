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

// How far a function has come, told to the caller.

#include <CGAL/Linear_snapping/types/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <chrono>
#include <functional>
#include <iostream>
#include <string>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// As long as it lives, its thread tells the visitor among the named parameters, or the error stream
// with `verbose`. Without any, those that are told already still are: so functions that call others
// need not hand a visitor on. What it throws ends the work: nothing is told once anything of the
// caller's has been written.
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

  // Tells what `words()` returns. What a visitor calls tells him nothing.
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
