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

// The least number of quads, not below the wanted one, that a face graph can hold. A coarse mesh
// may have quads that meet themselves, or each other twice. Then strips of quads are doubled; or
// there are fewer quads, each divided into four or sixteen, which always helps, except for quads
// around vertices of one edge, which are left out.
//
// The numbers that are tried are steps of a ladder that doesn't depend on the wanted number, so
// that the result grows with it, up to the tolerances.

#include <CGAL/Quad_remeshing/internal/cells/Cell_extractor.h>
#include <CGAL/Quad_remeshing/internal/cells/Line_between_quads.h>
#include <CGAL/Quad_remeshing/internal/quantization/Intrinsic_complex.h>
#include <CGAL/Quad_remeshing/internal/quantization/Strip_moves.h>
#include <CGAL/Quad_remeshing/internal/quantization/quads_needed.h>
#include <CGAL/Quad_remeshing/internal/quantization/quantize_complex.h>
#include <CGAL/Quad_remeshing/internal/support/Work.h>

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

// Quads that are no face graph, as some vertices have an edge to themselves or two to another one,
// become one where such edges get longer by one unit: the strip of quads across each is doubled.
// Strips may wind around the surface many times; where one is long, the cheapest strip of triangles
// is taken that crosses the same edge of the complex.

// Invariant: the units stay feasible.
class Face_graph_mender
{
public:
  // \param scales wanted units per step of the input's grid, per part
  // \param work receives what it takes
  Face_graph_mender(Intrinsic_complex& complex, const std::vector<double>& scales, Work& work)
    : m_complex(complex), m_scales(scales), m_work(work)
  { }

  // In 16 rounds at most, each of which extracts the quads. Returns whether they are a face graph
  // then, once folded ones are left out.
  bool run()
  {
    for(m_round = 0; m_round < most_rounds; ++m_round) {
      Extraction_options options;
      options.leave_out_folded_cells = true;
      Quad_extractor extractor(make_chart_mesh(m_complex), {}, options,
                               [](const Corner_index) { return std::string(); });
      Chart_mesh mesh; // the mesh of the extractor goes
      if(!extractor.template run<CGAL::Sequential_tag>([&] { mesh = extractor.mesh(); }))
        return false;
      constexpr double of_extraction = 2; // the work for each quad and each triangle
      m_work.spend(of_extraction * double(extractor.complex().cells.size() +
                                          m_complex.corners.size() / 3));
      std::vector<Strip> strips = strips_across_double_edges(extractor.complex());
      if(strips.empty())
        return true;
      if(!double_strips(mesh, extractor.complex(), strips))
        return false;
    }
    return false;
  }

private:
  // A strip of quads, which closes or leads from border to border.
  struct Strip
  {
    std::size_t point, dart;           // one dart across it, and where that begins
    std::size_t length = 0;            // in quads
    std::vector<std::size_t> vertices; // with double edges across it
  };

  static std::vector<Strip> strips_across_double_edges(const Cell_complex& quads)
  {
    const auto vertices =
      Cell_vertices::make<CGAL::Sequential_tag>(quads.points.size(), quads.darts,
                                                [&](const auto d) { return quads.is_gap(d); });
    std::vector<Strip> result;
    std::vector<std::size_t> strip_of; // per dart, from 1 on
    for(std::size_t v = 0; v < vertices.size(); ++v)
      for(const std::size_t d : double_edges(quads, vertices, v)) {
        strip_of.resize(quads.darts.size(), 0);
        if(strip_of[d] == 0) {
          result.push_back({vertices.point(v), d, 0, {}});
          for_each_dart_across(quads, d, [&](const std::size_t e) {
            strip_of[e] = result.size();
            result.back().length += quads.has_cell(e) ? 1 : 0;
          });
        }
        result[strip_of[d] - 1].vertices.push_back(v);
      }
    return result;
  }

  // In the strip of quads that the dart is across, to both sides of it.
  template <typename Visit>
  static void for_each_dart_across(const Cell_complex& quads, const std::size_t dart,
                                   const Visit& visit)
  {
    const std::size_t twin = quads.twin(dart);
    for(const std::size_t first : {dart, twin}) {
      std::size_t d = first;
      visit(d);
      while(quads.has_cell(d)) {
        const std::size_t opposite = quads.next(quads.next(d));
        visit(opposite);
        if(quads.darts.twins[opposite] < 0)
          break;
        d = quads.twin(opposite);
        if(d == first)
          return;
        visit(d);
      }
    }
  }

  // Doubles the strips that mend most vertices for their length, until one is doubled for each
  // vertex. Returns whether anything has changed.
  bool double_strips(const Chart_mesh& mesh, const Cell_complex& quads, std::vector<Strip>& strips)
  {
    std::stable_sort(strips.begin(), strips.end(), [](const Strip& s, const Strip& t)
      { return s.length * t.vertices.size() < t.length * s.vertices.size(); });
    const std::size_t long_length = (std::max)(std::size_t(16), quads.cells.size() / 64);
    const Line_between_quads line(mesh);
    Strip_moves moves(m_complex, m_scales, m_work);
    std::vector<char> is_mended(quads.darts.size(), false); // per vertex
    bool has_changed = false;
    for(const Strip& s : strips) {
      if(std::all_of(s.vertices.begin(), s.vertices.end(),
                     [&](const std::size_t v) { return bool(is_mended[v]); }))
        continue;
      const std::vector<Face_on_line> faces =
        line.faces(quads.points[s.point], int(s.dart - quads.darts.first(s.point)));
      if(faces.empty() || !((s.length > long_length && move_near_by(faces, moves)) ||
                            moves.move_along(faces)))
        continue;
      has_changed = true;
      for(const std::size_t v : s.vertices)
        is_mended[v] = true;
    }
    return has_changed;
  }

  // If the cheapest strip crosses an edge of the complex next to an edge of two quads, the edge of
  // the quads need not get longer: so each round tries another strip, and the last rounds none.
  bool move_near_by(const std::vector<Face_on_line>& faces, Strip_moves& moves) const
  {
    if(m_round >= most_rounds / 2)
      return false;
    const Face_on_line& f = faces[std::size_t(m_round / 2) % faces.size()];
    return m_round % 2 == 0 ? moves.change(f.exit, f.left)
                            : moves.change(f.entry, reversed(f.left));
  }

  static constexpr int most_rounds = 16; // rounds of doubling strips

  Intrinsic_complex& m_complex;
  const std::vector<double>& m_scales;
  Work& m_work;
  int m_round = 0;
};

// Divides each quad into factor x factor.
inline void refine(const std::int64_t factor, Intrinsic_complex& complex)
{
  for(Intrinsic_corner& corner : complex.corners)
    for(std::int64_t& coordinate : corner.units)
      coordinate = checked_product(factor, coordinate);
}

// A quantization of about a number of quads.
struct Quantized_complex
{
  Intrinsic_complex complex;
  double number_of_quads = 0;
  bool has_reached_maximum = false; // and no face graph was found below it
  double first_scale = 1;
  std::size_t number_of_moves = 0, number_of_long_edges = 0;
  std::vector<double> scales; // wanted units per step of the input's grid, per part

  // Once each quad is divided into four so often.
  double number_after(const int divisions) const
  { return std::ldexp(number_of_quads, 2 * divisions); }
};

// `quantize(number)` returns a Quantized_complex.
template <typename Quantize>
class Face_graph_search
{
  static constexpr int most_divisions = 2; // divisions of each quad into four
  static constexpr int steps_per_division = 56; // steps of 2.5 %
  // the first quads that can be divided are at times half as many again as in the next steps
  static constexpr int most_steps = (2 * most_divisions + 1) * steps_per_division / 2;
  static constexpr double tolerance = 0.05; // by which fewer quads than wanted may be found

public:
  // \param maximum_number of quads: what has more is neither checked nor searched on
  // \param stride in steps of 2.5 %, where quantizing takes long
  // \param work where none is left, numbers grow fourfold, and the first face graph is taken
  Face_graph_search(const Quantize& quantize, Work& work,
                    const double maximum_number = (std::numeric_limits<double>::max)(),
                    const int stride = 1)
    : m_quantize(quantize), m_work(work), m_maximum(maximum_number), m_stride(stride)
  { }

  // The result; or a quantization that is none, or has more quads than the largest number. It is
  // not less than that for a smaller number, up to the tolerances.
  Quantized_complex run(const double wanted)
  {
    m_wanted = wanted;
    m_best = step_of(wanted);
    if(!is_reached())
      search();
    Quantized_complex result = at(m_best);
    if(const Face_graph& found = face_graph(m_best, m_divisions); found.exists) {
      result.complex = found.complex;
      result.number_of_quads = found.number_of_quads;
    }
    else
      result.has_reached_maximum =
        std::any_of(m_face_graphs.begin(), m_face_graphs.end(),
                    [&](const auto& g) { return g.second.number_of_quads > m_maximum; });
    return result;
  }

private:
  static int step_of(const double number)
  { return int(std::lround(std::log2(number) * steps_per_division / 2)); }
  static double number_at(const int step) { return std::exp2(2. * step / steps_per_division); }

  // Most often, the first face graph is enough. A division that has slightly fewer quads has a
  // worse shape, because all its lengths are even.
  bool is_reached()
  {
    const Face_graph& found = face_graph(m_best, 0);
    return found.exists && found.number_of_quads >= (1 - tolerance) * m_wanted &&
           found.number_of_quads <= about_as_many * m_wanted;
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
    if(begin > wanted) {
      try_divisions(0, 0);
      if(m_least <= (1 + tolerance) * coarsest && has_many_faces(at(0).complex))
        return;
      try_smaller_numbers();
    }
    if(at(begin).number_of_quads <= m_maximum)
      climb(begin);
  }

  // Numbers below the number of the coarsest quantization lead to about this number, too: the
  // search tries some of them for luck, the same ones whatever the wanted number is.
  void try_smaller_numbers()
  {
    const int interval = (std::max)(steps_per_division / 4, 4 * m_stride);
    for(int d = 0; d <= most_divisions; ++d) {
      try_divisions(0, d);
      for(int step = m_first - interval;
          step > 0 && step > m_first - 2 * steps_per_division && m_work.is_left();
          step -= interval)
        try_divisions(step, d);
    }
  }

  // Until nothing is left to be found: what lies far below its step doesn't count, since searches
  // that end before would not find it.
  void climb(const int begin)
  {
    constexpr double nothing = (std::numeric_limits<double>::max)();
    for(int step = begin; step < begin + most_steps + m_stride;
        step += m_work.is_left() ? m_stride : steps_per_division)
      for(int d = 0; d <= most_divisions; ++d) {
        const bool is_next_enough = step == begin && d > 0;
        if(m_least <= number_at(is_next_enough ? step + m_stride : step) ||
           (m_least < nothing && !m_work.is_left()))
          return;
        const int divided = (std::max)(m_first, step - d * steps_per_division);
        if(at(divided).number_after(d) >= (1 - tolerance) * number_at(step))
          try_divisions(divided, d);
      }
  }

  void try_divisions(const int step, const int divisions)
  {
    if(at(step).number_after(divisions) >= m_least)
      return;
    const Face_graph& found = face_graph(step, divisions);
    const double number = found.number_of_quads;
    if(number >= (1 - tolerance) * m_wanted && number < m_least &&
       (number > m_maximum || found.exists)) {
      m_least = number;
      m_best = step;
      m_divisions = divisions;
    }
  }

  // Each quad is divided into four so often, and strips are doubled.
  struct Face_graph
  {
    Intrinsic_complex complex;
    double number_of_quads = 0;
    bool exists = false;
  };

  const Face_graph& face_graph(const int step, const int divisions)
  {
    const auto [found, is_new] = m_face_graphs.try_emplace({step, divisions});
    Face_graph& result = found->second;
    const Quantized_complex& q = at(step);
    if(!is_new)
      return result;
    result.number_of_quads = q.number_after(divisions);
    if(result.number_of_quads > m_maximum)
      return result;
    result.complex = q.complex;
    refine(1 << divisions, result.complex);
    const double before = internal::number_of_quads(result.complex);
    result.exists = Face_graph_mender(result.complex, q.scales, m_work).run();
    result.number_of_quads += internal::number_of_quads(result.complex) - before;
    return result;
  }

  const Quantized_complex& at(const int step)
  {
    const auto found = m_known.find(step);
    return found != m_known.end()
             ? found->second : m_known.emplace(step, m_quantize(number_at(step))).first->second;
  }

  const Quantize& m_quantize;
  Work& m_work;
  std::map<int, Quantized_complex> m_known;                 // by step
  std::map<std::pair<int, int>, Face_graph> m_face_graphs;  // by step and divisions
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
