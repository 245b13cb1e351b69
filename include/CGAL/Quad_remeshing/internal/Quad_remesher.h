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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUAD_REMESHER_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUAD_REMESHER_H

#include <CGAL/license/Quad_remeshing.h>

// The quads of a quantization, which are shaped, mended, and counted.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/Remeshing_run.h>
#include <CGAL/Quad_remeshing/internal/cells/inverted_quads.h>
#include <CGAL/Quad_remeshing/internal/measure_quads_impl.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_locator.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_samples.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Upper_sides.h>
#include <CGAL/Quad_remeshing/internal/remeshing/add_mirror_image.h>
#include <CGAL/Quad_remeshing/internal/remeshing/collapse_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/divide_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/even_out_border.h>
#include <CGAL/Quad_remeshing/internal/remeshing/mend_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/shape_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/smooth_quads.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

class Quad_remesher
  : private Remeshing_types
{
public:
  // \param locator that of the surface, once it is needed
  Quad_remesher(Remeshing_run& run, std::optional<Surface_locator>& locator, Mesh& quads,
                const Feature_map& is_feature)
    : m_run(run), m_locator(locator), m_quads(quads), m_is_feature(is_feature)
  { }

  // Makes the quads of the quantization.
  void run()
  {
    if(make_quads())
      change_points([&](const double x) { return m_run.surface.unscaled(x); });
  }

  // The corners of inverted and folded quads, or, if there are none, of thin ones.
  const std::vector<Point>& places_of_flaws() const
  { return m_run.report.number_of_bad_quads() > 0 ? m_bad_places : m_thin_places; }

  // Moves the vertices of quads that have been extracted already, in the size of the input.
  void run_on_quads(const Quantization& quantization)
  {
    change_points([&](const double x) { return m_run.surface.scaled(x); });
    take_over(quantization);
    smooth();
    change_points([&](const double x) { return m_run.surface.unscaled(x); });
  }

private:
  // Makes quads; of a half, as many as form a mesh with their mirror image.
  bool make_quads()
  {
    constexpr int most_rounds = 12; // numbers of quads for one half of a mirrored mesh
    for(int round = 0; round < most_rounds; ++round) {
      if(!extract())
        return false;
      const double number_in_half = double(m_quads.number_of_faces());
      if(smooth()) {
        if(round > 0)
          add_note(m_run.report, "of fewer quads, one half would meet its image twice");
        return true;
      }
      Quantization_options options = m_run.options.quantization;
      options.is_coarsest = false;
      options.number_of_quads = 1.5 * number_in_half;
      if(!m_run.take(quantize_again(m_run.quantization, options)))
        return false;
    }
    return refuse(m_run.report, Outcome::NO_FACE_GRAPH,
                  "the quads of one half meet their mirror images twice; ask for more quads");
  }

  const Surface_locator& locator()
  { return m_locator ? *m_locator : m_locator.emplace(m_run.mesh()); }

  static double work_of(const Quad_smoother& smoother)
  {
    constexpr double of_search = 2; // the work of a search for the nearest point on the surface
    return of_search * double(smoother.number_of_searches());
  }

  bool has_work(const Quad_smoother& smoother) const
  { return m_run.work.is_left_for_shape(work_of(smoother)); }

  bool extract()
  {
    m_run.release_features_of_quantization();
    const Extraction_report extracted = extract_quad_mesh(
      m_run.quantization, m_run.mesh(), m_quads, CGAL::parameters::default_values(),
      parameters::edge_is_constrained_map(m_is_feature));
    m_run.timer.finish("extraction");
    if(!extracted)
      return refuse(m_run.report, extracted);
    take_over(m_run.quantization);
    return true;
  }

  void take_over(const Quantization& quantization)
  {
    if(quantization.number_of_unaligned_border_edges > 0)
      Border_evener(m_quads, m_is_feature, m_run.mesh()).run();
    m_run.report.message = quantization.message;
    m_run.report.parts_of_other_size = quantization.parts_of_other_size;
    for(Part_of_other_size& part : m_run.report.parts_of_other_size)
      part.face = m_run.surface.original(part.face);
    if(m_run.surface.mirror() && !m_run.report.message.empty())
      m_run.report.message += ", for each half";
  }

  // Vertices stay on features and borders. Returns whether the quads are a mesh, also with their
  // mirror image where they are to have one.
  bool smooth()
  {
    m_quads.set_recycle_garbage(false); // so that each number is of one quad
    Quad_smoother smoother(m_quads, locator());
    Upper_sides upper_sides(m_quads, m_is_feature, m_run.surface, smoother);
    const Feature_lines lines(m_run.surface);
    Quad_shaper shaper(m_quads, m_is_feature, m_run.mesh(), lines, smoother);
    const bool is_improved = shape_and_improve(shaper, smoother);
    if(is_improved && !m_run.surface.mirror())
      mend(upper_sides, smoother);
    m_run.work.spend(work_of(smoother) + double(upper_sides.number_of_walks()));
    m_run.timer.finish("smoothing");
    m_run.report.median_size_deviation =
      median_size_deviation(m_run.surface, m_run.options.number_wanted(), m_quads, smoother);
    m_run.report.largest_distance = m_run.surface.unscaled(
      (std::max)(smoother.measure_distance(),
                 Surface_samples(m_run.mesh(), number_of_samples).largest_distance(m_quads)));
    if(m_run.surface.mirror())
      m_quads.collect_garbage();
    std::vector<bool> is_folded; // the image has the same order
    for(const auto f : m_quads.faces())
      is_folded.push_back(upper_sides.is_folded(f));
    if(m_run.surface.mirror() && !Mirror_image(m_run.surface, m_quads, m_is_feature).add())
      return false;
    if(m_run.options.has_single_precision)
      change_points(rounded_to<float>);
    count();
    std::size_t i = 0;
    for(const auto f : m_quads.faces()) {
      const auto quad = smoother.quad(f);
      const bool has_inverted_corner = is_inverted(quad);
      const bool is_bad = has_inverted_corner || is_folded[i % is_folded.size()];
      if(has_inverted_corner)
        count_inverted_quad(i, m_run.report);
      else if(is_bad)
        count_quad(i, m_run.report.number_of_folded_quads, m_run.report.first_folded_quads);
      if(is_bad || is_thin(scaled_jacobian(quad)))
        for(const Space_vector& p : quad)
          (is_bad ? m_bad_places : m_thin_places).push_back(to_point(p));
      ++i;
    }
    static_cast<Quad_shapes&>(m_run.report) = smoother.shapes();
    m_run.timer.finish("measurement");
    return true;
  }

  // All but what is left to mend. Where the work is spent, in as few rounds as there are. Returns
  // false if the quads stay as they are for want of rounds or of hope.
  bool shape_and_improve(Quad_shaper& shaper, Quad_smoother& smoother)
  {
    shape(shaper, smoother,
          m_run.work.is_left() ? shaping_rounds * m_run.options.number_of_smoothing_rounds : 1);
    if(m_run.options.number_of_smoothing_rounds == 0 || is_hopeless(smoother))
      return false;
    int edits = 0;
    do {
      shaper.shape_thin_quads();
    } while(edits++ < most_edits && edit(smoother));
    return true;
  }

  // Changes the quads at inverted or thin ones where moves of vertices alone don't help. Returns
  // whether there was something to change.
  bool edit(Quad_smoother& smoother)
  {
    Quad_collapser collapser(m_quads, m_is_feature, smoother, false);
    return collapser.remove_vertices_of_two_edges() > 0 ||
           (has_work(smoother) &&
            (collapser.run() > 0 || Quad_divider(m_quads, m_is_feature, smoother).run() > 0));
  }

  // To mend so many quads takes long, and leaves a bad shape. There is work left for an attempt
  // without the features there.
  bool is_hopeless(const Quad_smoother& smoother) const
  {
    const auto is_on_feature = [&](const Mesh::Vertex_index v)
    { return !m_quads.is_border(v) && !lines_at_vertex(m_quads, m_is_feature, v).empty(); };
    const auto is_to_mend = [&](const Mesh::Face_index f) {
      const auto vertices = CGAL::vertices_around_face(m_quads.halfedge(f), m_quads);
      return is_inverted(smoother.quad(f)) &&
             std::any_of(vertices.begin(), vertices.end(), is_on_feature);
    };
    const auto faces = m_quads.faces();
    return m_run.work.is_half_left() &&
           20 * std::size_t(std::count_if(faces.begin(), faces.end(), is_to_mend)) >
             m_quads.number_of_faces();
  }

  // Vertices move; see `Quad_smoother` and `Quad_shaper`.
  void shape(Quad_shaper& shaper, Quad_smoother& smoother, const std::size_t most_rounds)
  {
    if(m_run.options.number_of_smoothing_rounds == 0)
      return;
    const auto is_held = [&](const Mesh::Vertex_index v)
    { return !lines_at_vertex(m_quads, m_is_feature, v).empty(); };
    smoother.unfold(is_held);
    smoother.smooth(m_run.options.number_of_smoothing_rounds, is_held);
    shaper.shape_all(most_rounds);
  }

  // Not where there is to be a mirror image: vertices on the plane have to stay there.
  void mend(Upper_sides& upper_sides, Quad_smoother& smoother)
  {
    upper_sides.update(); // and after each step, which moves the places below
    if(m_run.options.has_single_precision)
      change_points(rounded_to<float>);
    Quad_mender mender(m_quads, m_is_feature, smoother, m_run.options.has_single_precision);
    mender.run(false);
    for(int i = 0; i < most_mending_rounds && has_work(smoother) && upper_sides.update() > 0;
        ++i) {
      Quad_collapser(m_quads, m_is_feature, smoother, m_run.options.has_single_precision).run();
      upper_sides.update();
      mender.run(true);
    }
    if(has_work(smoother))
      mender.relax([&] { return upper_sides.update(); });
    m_run.report.number_of_displaced_vertices = mender.number_of_displaced_vertices();
    m_run.report.largest_displacement = m_run.surface.unscaled(mender.largest_displacement());
  }

  template <typename Change>
  void change_points(const Change& change)
  {
    for(const auto v : m_quads.vertices()) {
      const Point& p = m_quads.point(v);
      m_quads.point(v) = Point(change(p.x()), change(p.y()), change(p.z()));
    }
  }

  void count()
  {
    m_run.report.number_of_quads = m_quads.number_of_faces();
    m_run.report.number_of_vertices = m_quads.number_of_vertices();
    for(const auto v : m_quads.vertices())
      if(!m_quads.is_border(v) && m_quads.degree(v) != 4)
        ++m_run.report.number_of_irregular_vertices;
  }

  static constexpr std::size_t number_of_samples = 5000; // of the distance from the quads
  static constexpr int most_edits = 5; // rounds of collapsing and dividing quads
  static constexpr int most_mending_rounds = 4; // of moving vertices off features or surface
  static constexpr std::size_t shaping_rounds = 4; // for each of smoothing, at most

  Remeshing_run& m_run;
  std::optional<Surface_locator>& m_locator;
  Mesh& m_quads;
  Feature_map m_is_feature;
  std::vector<Point> m_bad_places; // the corners of quads that are inverted or folded
  std::vector<Point> m_thin_places; // of others
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUAD_REMESHER_H
