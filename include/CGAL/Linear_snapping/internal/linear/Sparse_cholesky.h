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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SPARSE_CHOLESKY_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SPARSE_CHOLESKY_H

#include <CGAL/license/Linear_snapping.h>

// The solver of large sparse systems that need not be exact: CHOLMOD of SuiteSparse if the build
// system finds it and defines CGAL_SEAMLESS_SNAPPING_USE_SUITESPARSE, else Eigen's own. CHOLMOD
// works on dense blocks, which pays if the factor is dense: on large meshes, and if cones couple
// the two coordinates.

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <vector>

#ifdef CGAL_SEAMLESS_SNAPPING_USE_SUITESPARSE
#include <Eigen/CholmodSupport>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <numeric>

#if defined(__ELF__) && defined(__GNUC__)
extern "C" { // null in programs without it
__attribute__((weak)) int openblas_get_num_threads();
__attribute__((weak)) void openblas_set_num_threads(int);
__attribute__((weak)) int openblas_get_parallel();
__attribute__((weak)) int omp_get_max_active_levels();
__attribute__((weak)) void omp_set_max_active_levels(int);
}
#endif
#endif

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// From so many unknowns on, METIS is worth the time that it takes to order them.
constexpr int very_large_system = 500000;

// Works on single numbers, which takes less time where the factor has few.
template <typename Matrix>
class Simplicial_cholesky : public Eigen::SimplicialLDLT<Matrix>
{
public:
  // The multiplications of blocks that a factorization of the pattern analyzed last takes. A
  // multiplication of single numbers takes three times as long.
  double number_of_multiplications()
  { return 3 * this->m_nonZerosPerCol.template cast<double>().squaredNorm(); }

  using Eigen::SimplicialLDLT<Matrix>::analyzePattern;
  void analyzePattern(const Matrix& matrix, const std::vector<int>& /* blocks */)
  { analyzePattern(matrix); }
};

#ifdef CGAL_SEAMLESS_SNAPPING_USE_SUITESPARSE

// Keeps OpenBLAS and OpenMP, if the program has them, from using several threads. On the small
// blocks of sparse factors these gain nothing, and on a machine with other work they wait for each
// other, many times as long as they compute; and sums would depend on their number. CHOLMOD asks
// OpenMP for four, however many there are.
//
// The number of threads of OpenBLAS is one for the whole process: the first guard keeps it, and the
// last one sets it again, whatever threads they are in. OpenMP has its levels for each thread.
//
// An OpenBLAS without threads shares its memory between callers without a lock: factorizations of
// two threads at a time would fail, or have wrong numbers. Guards then wait for each other.
class One_blas_thread
{
public:
#if defined(__ELF__) && defined(__GNUC__)
  One_blas_thread()
  {
    if(has_levels()) {
      m_levels = omp_get_max_active_levels();
      omp_set_max_active_levels(0);
    }
    if(is_sequential())
      m_turn = std::unique_lock<std::recursive_mutex>(state().turn);
    const std::lock_guard<std::mutex> lock(state().mutex);
    if(has_threads() && state().guards++ == 0) {
      state().threads = openblas_get_num_threads();
      openblas_set_num_threads(1);
    }
  }

  ~One_blas_thread()
  {
    if(has_levels())
      omp_set_max_active_levels(m_levels);
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
    std::recursive_mutex turn;
    int guards = 0, threads = 1;
  };

  static State& state()
  {
    static State result;
    return result;
  }

  static bool has_threads()
  { return openblas_get_num_threads != nullptr && openblas_set_num_threads != nullptr; }

  static bool is_sequential()
  { return openblas_get_parallel != nullptr && openblas_get_parallel() == 0; }

  static bool has_levels()
  { return omp_get_max_active_levels != nullptr && omp_set_max_active_levels != nullptr; }

  int m_levels = 1;
  std::unique_lock<std::recursive_mutex> m_turn;
#else
  One_blas_thread() { } // not trivial, so that guards are no unused variables
#endif
};

// METIS keeps its random numbers in one place for all threads: in several at a time, the order
// would depend on chance. This is one mutex for matrices of all types.
inline std::mutex& turn_of_metis()
{
  static std::mutex result;
  return result;
}

// CHOLMOD would print each failure to the standard output, which belongs to the caller.
template <typename Matrix>
class Sparse_cholesky : public Eigen::CholmodDecomposition<Matrix>
{
  using Base = Eigen::CholmodDecomposition<Matrix>;

public:
  Sparse_cholesky() { this->cholmod().print = 0; }

  void compute(const Matrix& matrix)
  {
    analyzePattern(matrix);
    factorize(matrix);
  }

  // If much is filled in, CHOLMOD would try METIS as well. On large matrices, this takes several
  // times as long as the following factorizations gain. On very large ones it is worth its time
  // again: the factor has a third less numbers.
  void analyzePattern(const Matrix& matrix)
  {
    constexpr int large = 110000;
    this->cholmod().nmethods = matrix.cols() > large && matrix.cols() <= very_large_system ? 1 : 0;
    this->cholmod().method[0].ordering = CHOLMOD_AMD;
    const std::lock_guard<std::mutex> turn(turn_of_metis());
    Base::analyzePattern(matrix);
  }

  // For very large ones: METIS, or AMD where that is better or the library has no METIS, orders
  // blocks of unknowns, as the coordinates of one point, which are fewer.
  // \param blocks the number of each unknown's block, from 0
  void analyzePattern(const Matrix& matrix, const std::vector<int>& blocks)
  {
    std::vector<int> columns(blocks.size());
    std::iota(columns.begin(), columns.end(), 0);
    const auto sort_columns = [&](const std::vector<int>& key_of_block) {
      std::stable_sort(columns.begin(), columns.end(), [&](const int i, const int j) {
        return key_of_block[std::size_t(blocks[std::size_t(i)])] <
               key_of_block[std::size_t(blocks[std::size_t(j)])];
      });
    };
    std::vector<int> key(std::size_t(*std::max_element(blocks.begin(), blocks.end())) + 1);
    std::iota(key.begin(), key.end(), 0);
    sort_columns(key);

    const std::lock_guard<std::mutex> turn(turn_of_metis());
    this->cholmod().nmethods = 2;
    this->cholmod().method[0].ordering = CHOLMOD_METIS;
    this->cholmod().method[1].ordering = CHOLMOD_AMD;
    Base::analyzePattern(matrix_of_blocks(matrix, blocks, columns, key.size()));
    const int* const order = static_cast<const int*>(this->m_cholmodFactor->Perm);
    for(std::size_t k = 0; k < key.size(); ++k)
      key[std::size_t(order[k])] = int(k);
    sort_columns(key);
    cholmod_free_factor(&this->m_cholmodFactor, &this->cholmod());
    this->cholmod().nmethods = 1;
    this->cholmod().method[0].ordering = CHOLMOD_GIVEN;
    cholmod_sparse view = Eigen::viewAsCholmod(matrix.template selfadjointView<Eigen::Lower>());
    this->m_cholmodFactor = cholmod_analyze_p(&view, columns.data(), nullptr, 0,
                                              &this->cholmod());
  }

  void factorize(const Matrix& matrix)
  {
    const One_blas_thread guard;
    Base::factorize(matrix);
  }

  // The cost of a factorization of the pattern that was analyzed last.
  double number_of_multiplications() { return this->cholmod().fl; }

  template <typename Right_hand_side>
  typename Right_hand_side::PlainObject solve(const Right_hand_side& b) const
  {
    const One_blas_thread guard;
    return Base::solve(b);
  }

private:
  // The pairs of blocks with entries between them: the lower triangle, as in the matrix.
  // \param columns sorted by their blocks
  static Matrix matrix_of_blocks(const Matrix& matrix, const std::vector<int>& blocks,
                                 const std::vector<int>& columns, const std::size_t number)
  {
    std::vector<Eigen::Triplet<double> > entries;
    std::vector<int> last(number, -1); // block that has an entry with this one
    for(const int j : columns)
      for(typename Matrix::InnerIterator entry(matrix, j); entry; ++entry) {
        const int i = blocks[std::size_t(entry.row())], k = blocks[std::size_t(j)];
        if(last[std::size_t(i)] != k)
          entries.emplace_back((std::max)(i, k), (std::min)(i, k), 1);
        last[std::size_t(i)] = k;
      }
    Matrix result{Eigen::Index(number), Eigen::Index(number)};
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }
};

#else

template <typename Matrix>
using Sparse_cholesky = Simplicial_cholesky<Matrix>;

#endif

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_SPARSE_CHOLESKY_H
