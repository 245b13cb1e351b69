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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_ONE_BLAS_THREAD_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_ONE_BLAS_THREAD_H

#include <CGAL/license/Linear_snapping.h>

// Keeps OpenBLAS, if the program has it, from using several threads. On the small blocks of sparse
// factors these gain nothing, and on a machine with other work they wait for each other, many times
// as long as they compute; and sums would depend on their number.

#include <mutex>

#if defined(__ELF__) && defined(__GNUC__)
extern "C" { // null in programs without it
__attribute__((weak)) int openblas_get_num_threads();
__attribute__((weak)) void openblas_set_num_threads(int);
}
#endif

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// The number of threads is one for the whole process: the first guard keeps it, and the last one
// sets it again, whatever threads they are in.
class One_blas_thread
{
public:
#if defined(__ELF__) && defined(__GNUC__)
  One_blas_thread()
  {
    const std::lock_guard<std::mutex> lock(state().mutex);
    if(has_threads() && state().guards++ == 0) {
      state().threads = openblas_get_num_threads();
      openblas_set_num_threads(1);
    }
  }

  ~One_blas_thread()
  {
    const std::lock_guard<std::mutex> lock(state().mutex);
    if(has_threads() && --state().guards == 0)
      openblas_set_num_threads(state().threads);
  }

  One_blas_thread(const One_blas_thread&) = delete;
  One_blas_thread& operator=(const One_blas_thread&) = delete;

private:
  struct State
  {
    std::mutex mutex;
    int guards = 0, threads = 1;
  };

  static State& state()
  {
    static State result;
    return result;
  }

  static bool has_threads()
  { return openblas_get_num_threads != nullptr && openblas_set_num_threads != nullptr; }
#else
  One_blas_thread() { } // not trivial, so that guards are no unused variables
#endif
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_ONE_BLAS_THREAD_H
