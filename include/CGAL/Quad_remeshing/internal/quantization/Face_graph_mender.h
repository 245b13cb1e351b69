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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_FACE_GRAPH_MENDER_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_FACE_GRAPH_MENDER_H

#include <CGAL/license/Quad_remeshing.h>

// Quads that are no face graph, as some vertices have an edge to themselves or two to another one,
// become one where such edges get longer by one unit: the strip of quads across each is doubled.
// Strips may wind around the surface many times; where one is long, the cheapest strip of triangles
// is taken that crosses the same edge of the complex.

#include <CGAL/Quad_remeshing/internal/cells/Cell_extractor.h>
#include <CGAL/Quad_remeshing/internal/cells/Line_between_quads.h>
#include <CGAL/Quad_remeshing/internal/quantization/Intrinsic_complex.h>
#include <CGAL/Quad_remeshing/internal/quantization/Strip_moves.h>
#include <CGAL/Quad_remeshing/internal/support/Work.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

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
      Chart_mesh mesh; // that of the extractor goes
      if(!extractor.template run<CGAL::Sequential_tag>([&] { mesh = extractor.mesh(); }))
        return false;
      constexpr double of_extraction = 2; // for each quad and each triangle
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
  // Of quads, around or from border to border.
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

  // Those that mend most vertices for their length, until one is doubled for each vertex. Returns
  // whether anything has changed.
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

  // Where the cheapest strip crosses an edge of the complex next to that of two quads, that edge of
  // quads need not get longer: so each round tries another one, and the last ones none.
  bool move_near_by(const std::vector<Face_on_line>& faces, Strip_moves& moves) const
  {
    if(m_round >= most_rounds / 2)
      return false;
    const Face_on_line& f = faces[std::size_t(m_round / 2) % faces.size()];
    return m_round % 2 == 0 ? moves.change(f.exit, f.left)
                            : moves.change(f.entry, reversed(f.left));
  }

  static constexpr int most_rounds = 16;

  Intrinsic_complex& m_complex;
  const std::vector<double>& m_scales;
  Work& m_work;
  int m_round = 0;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_FACE_GRAPH_MENDER_H
