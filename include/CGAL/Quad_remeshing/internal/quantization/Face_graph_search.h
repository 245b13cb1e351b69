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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_FACE_GRAPH_SEARCH_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_FACE_GRAPH_SEARCH_H

#include <CGAL/license/Quad_remeshing.h>

// The least number of quads, not below the one wanted, that a face graph can hold. A coarse mesh
// may have quads that meet themselves, or each other twice. Then there are two ways: more quads, or
// fewer, each divided into four or sixteen; that helps always, but for quads around vertices of one
// edge, which are left out.
//
// The numbers that are tried are steps of a ladder that doesn't depend on what is wanted, so that
// the result grows with what is wanted, up to the tolerance.

#include <CGAL/Quad_remeshing/internal/cells/Cell_extractor.h>
#include <CGAL/Quad_remeshing/internal/quantization/make_chart_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Divides each quad into factor x factor.
inline void refine(const std::int64_t factor, Intrinsic_complex& complex)
{
  for(Intrinsic_corner& corner : complex.corners)
    for(std::int64_t& coordinate : corner.units)
      coordinate = checked_product(factor, coordinate);
}

// Whether the quads that the units describe are a face graph, once folded ones are left out.
inline bool has_face_graph(const Intrinsic_complex& complex)
{
  Extraction_options options;
  options.leave_out_folded_cells = true;
  Quad_extractor extractor(make_chart_mesh(complex), {}, options,
                           [](const Corner_index) { return std::string(); });
  if(!extractor.template run<CGAL::Sequential_tag>([] { }))
    return false;
  const Cell_complex& quads = extractor.complex();
  const auto vertices =
    Cell_vertices::make<CGAL::Sequential_tag>(quads.points.size(), quads.darts,
                                              [&](const auto d) { return quads.is_gap(d); });
  return vertex_with_double_edges<CGAL::Sequential_tag>(quads, vertices) == vertices.size();
}

// A quantization of about a number of quads.
class Quantized_complex
{
public:
  Intrinsic_complex complex;
  double number_of_quads = 0;
  double first_scale = 1;
  std::size_t number_of_moves = 0, number_of_long_edges = 0;

  // Once each quad is divided into four so often.
  double number_after(const int divisions) const
  { return std::ldexp(number_of_quads, 2 * divisions); }

  // The same for the face graph; what has been found out is kept.
  bool has_face_graph_after(const int divisions) const
  {
    if(divisions > m_most_bad && divisions < m_least_good) {
      Intrinsic_complex divided = complex;
      refine(1 << divisions, divided);
      (has_face_graph(divided) ? m_least_good : m_most_bad) = divisions;
    }
    return divisions >= m_least_good;
  }

private:
  mutable int m_most_bad = -1, m_least_good = (std::numeric_limits<int>::max)();
};

// `quantize(number)` returns a Quantized_complex.
template <typename Quantize>
class Face_graph_search
{
  static constexpr int most_divisions = 2;
  static constexpr int steps_per_division = 56; // of 2.5 %
  // the first quads that can be divided are at times half as many again as those of the next steps
  static constexpr int most_steps = (2 * most_divisions + 1) * steps_per_division / 2;
  static constexpr double tolerance = 0.05;

public:
  // \param maximum_number of quads: what has more is neither checked nor searched on
  // \param stride in steps of 2.5 %, where quantizing takes long
  explicit Face_graph_search(const Quantize& quantize,
                             const double maximum_number = (std::numeric_limits<double>::max)(),
                             const int stride = 1)
    : m_quantize(quantize), m_maximum(maximum_number), m_stride(stride)
  { }

  // The result, divided as often as it has to be; or an undivided one that is none, or has more
  // quads than the largest number. It is not less than that for a smaller number, up to the
  // tolerance.
  Quantized_complex run(const double wanted)
  {
    m_wanted = wanted;
    m_best = step_of(wanted);
    if(!is_reached(at(m_best)))
      search();
    Quantized_complex result = at(m_best);
    refine(1 << m_divisions, result.complex);
    result.number_of_quads = result.number_after(m_divisions);
    return result;
  }

private:
  static int step_of(const double number)
  { return int(std::lround(std::log2(number) * steps_per_division / 2)); }
  static double number_at(const int step) { return std::exp2(2. * step / steps_per_division); }

  // So that nothing better is left to be found: most often, the first one is so.
  bool is_reached(const Quantized_complex& q) const
  {
    return q.number_of_quads >= (1 - tolerance) * m_wanted &&
           q.number_of_quads <= number_at(m_best + 1) && q.has_face_graph_after(0);
  }

  void search()
  {
    if(at(m_best).number_of_quads / 4 > m_maximum) // the coarsest ones are hardly fewer
      return;
    const int wanted = m_best;
    const double coarsest = at(m_best = 0).number_of_quads;
    if(coarsest / 2 > m_maximum)
      return;
    m_first = step_of((std::max)(1., 0.9 * coarsest));
    const int begin = m_best = (std::max)(m_first, wanted);
    if(begin > wanted)
      try_smaller_numbers();
    if(at(begin).number_of_quads <= m_maximum)
      climb(begin);
  }

  // Numbers below those of the coarsest quantization lead to about that number, too: some of them
  // are tried for luck, the same ones whatever is wanted.
  void try_smaller_numbers()
  {
    const int interval = (std::max)(steps_per_division / 4, 4 * m_stride);
    for(int d = 0; d <= most_divisions; ++d) {
      try_divisions(0, d);
      for(int step = m_first - interval;
          step > 0 && step > m_first - 2 * steps_per_division; step -= interval)
        try_divisions(step, d);
    }
  }

  // Until nothing is left to be found: what lies far below its step doesn't count, since searches
  // that end before would not find it.
  void climb(const int begin)
  {
    for(int step = begin; step < begin + most_steps + m_stride; step += m_stride)
      for(int d = 0; d <= most_divisions; ++d) {
        const bool is_next_enough = step == begin && d > 0;
        if(m_least <= number_at(is_next_enough ? step + m_stride : step))
          return;
        const int divided = (std::max)(m_first, step - d * steps_per_division);
        if(at(divided).number_after(d) >= (1 - tolerance) * number_at(step))
          try_divisions(divided, d);
      }
  }

  void try_divisions(const int step, const int divisions)
  {
    const Quantized_complex& q = at(step);
    const double number = q.number_after(divisions);
    if(number >= (1 - tolerance) * m_wanted && number < m_least &&
       (number > m_maximum || q.has_face_graph_after(divisions))) {
      m_least = number;
      m_best = step;
      m_divisions = divisions;
    }
  }

  const Quantized_complex& at(const int step)
  {
    const auto found = m_known.find(step);
    return found != m_known.end()
             ? found->second : m_known.emplace(step, m_quantize(number_at(step))).first->second;
  }

  const Quantize& m_quantize;
  std::map<int, Quantized_complex> m_known; // by step
  double m_maximum;
  int m_stride;
  double m_wanted = 0, m_least = (std::numeric_limits<double>::max)();
  int m_first = 0; // the least step whose number may be reached
  int m_best = 0, m_divisions = 0;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_FACE_GRAPH_SEARCH_H
