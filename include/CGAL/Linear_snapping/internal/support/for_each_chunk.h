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

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_FOR_EACH_CHUNK_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_FOR_EACH_CHUNK_H

#include <CGAL/license/Linear_snapping.h>

// Loops over ranges of indices, by one thread or by several. The result of a chunk must depend on
// its indices only: then the total result does not depend on the number of threads.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>

#include <CGAL/for_each.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

struct Chunk
{
  std::size_t index, begin, end;
};

constexpr std::size_t default_chunk_size = 4096;

inline std::vector<Chunk> chunks_of(const std::size_t n,
                                    const std::size_t size = default_chunk_size)
{
  std::vector<Chunk> chunks;
  for(std::size_t begin = 0; begin < n; begin += size)
    chunks.push_back({chunks.size(), begin, (std::min)(n, begin + size)});
  return chunks;
}

// Calls f(chunk) for each.
template <typename ConcurrencyTag, typename Function>
void for_each_chunk(std::vector<Chunk> chunks, const Function& f)
{
  CGAL::for_each<ConcurrencyTag>(chunks, [&](Chunk& chunk) {
    const Protect_exact_arithmetic protect; // threads have an environment of their own
    f(chunk);
    return true;
  });
}

// Calls f() and g(), at the same time if there are several threads.
template <typename ConcurrencyTag>
void call_both(const std::function<void()>& f, const std::function<void()>& g)
{
  std::array<const std::function<void()>*, 2> calls{&f, &g};
  CGAL::for_each<ConcurrencyTag>(calls, [](const std::function<void()>* const call) {
    const Protect_exact_arithmetic protect;
    (*call)();
    return true;
  });
}

// The results of f(chunk) for the chunks of 0, ..., n - 1, in their order.
template <typename Result, typename ConcurrencyTag, typename Function>
std::vector<Result> results_of_chunks(const std::size_t n, const Function& f,
                                      const std::size_t size = default_chunk_size)
{
  const std::vector<Chunk> chunks = chunks_of(n, size);
  std::vector<Result> results(chunks.size());
  for_each_chunk<ConcurrencyTag>(chunks,
                                 [&](const Chunk& chunk) { results[chunk.index] = f(chunk); });
  return results;
}

// Appends the ranges to a vector, in their order; returns where each of them lies there.
template <typename ConcurrencyTag, typename T>
std::vector<Chunk> append(const std::vector<std::vector<T> >& ranges,
                          boost::container::vector<T>& all)
{
  std::vector<Chunk> places;
  std::size_t end = all.size();
  for(const std::vector<T>& range : ranges) {
    places.push_back({places.size(), end, end + range.size()});
    end = places.back().end;
  }
  all.resize(end, boost::container::default_init);
  for_each_chunk<ConcurrencyTag>(places, [&](const Chunk& place) {
    const std::vector<T>& range = ranges[place.index];
    std::copy(range.begin(), range.end(), all.begin() + std::ptrdiff_t(place.begin));
  });
  return places;
}

// The first i below n for which f(i) is true, or n.
template <typename ConcurrencyTag, typename Function>
std::size_t find_first(const std::size_t n, const Function& f)
{
  const auto first_of_chunk = [&](const Chunk& chunk) {
    for(std::size_t i = chunk.begin; i < chunk.end; ++i)
      if(f(i))
        return i;
    return n;
  };
  for(const std::size_t i : results_of_chunks<std::size_t, ConcurrencyTag>(n, first_of_chunk))
    if(i < n)
      return i;
  return n;
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_FOR_EACH_CHUNK_H
