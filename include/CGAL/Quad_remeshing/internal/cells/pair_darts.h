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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_PAIR_DARTS_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_PAIR_DARTS_H

#include <CGAL/license/Quad_remeshing.h>

// All darts and their twins. Which darts are traced does not depend on the number of threads: first
// those in the first half of the directions of their own charts, which in a single chart is one of
// each pair; then those whose twin has not been found this way.

#include <CGAL/Quad_remeshing/internal/cells/Dart_tracer.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// What can be wrong with a dart.
struct Dart_failure
{
  bool is_obstacle = false;  // it meets a vertex that it can't pass
  bool is_ambiguous = false; // two darts have the same twin: an internal error
  std::size_t vertex = 0;

  explicit operator bool() const { return is_obstacle || is_ambiguous; }
};

// Gives darts whose twin is known to that twin. Twins are an involution if and only if this
// succeeds for all.
inline bool complete_twins(Grid_darts& darts)
{
  for(std::size_t d = 0; d < darts.size(); ++d) {
    if(darts.twins[d] < 0)
      continue;
    const std::size_t t = std::size_t(darts.twins[d]);
    if(darts.twins[t] == untraced_dart) {
      darts.twins[t] = Dart_index(d);
      if(darts.is_feature(d))
        darts.mark_feature(t);
    } else if(darts.twins[t] != Dart_index(d)) {
      return false;
    }
  }
  return true;
}

template <typename ConcurrencyTag, typename Group>
Dart_failure pair_darts(const Basic_chart_mesh<Group>& mesh, const Lattice_points& points,
                        const std::vector<char>& is_feature, Grid_darts& darts)
{
  const std::vector<Chunk> chunks = chunks_of(points.size());
  std::vector<Dart_failure> failures(chunks.size());
  for(const bool is_first_round : {true, false}) {
    for_each_chunk<ConcurrencyTag>(chunks, [&](const Chunk& chunk) {
      Basic_dart_tracer<Group> tracer(mesh, points, darts, is_feature);
      for(std::size_t p = chunk.begin; p < chunk.end; ++p)
        for(std::size_t k = 0; k < darts.degree(p); ++k) {
          const std::size_t d = darts.first(p) + k;
          if(is_first_round ? k >= std::size_t(Group::order / 2) : darts.twins[d] != untraced_dart)
            continue;
          darts.twins[d] = tracer.trace(p, int(k));
          if(tracer.ran_along_feature())
            darts.mark_feature(d);
          if(darts.twins[d] == untraced_dart && !failures[chunk.index])
            failures[chunk.index] = {true, false, tracer.obstacle()};
        }
    });
    for(const Dart_failure& failure : failures)
      if(failure)
        return failure;
    if(!complete_twins(darts))
      return {false, true, 0};
  }
  return {};
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_PAIR_DARTS_H
