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

// One attempt to make quads of a surface: from its map to quads that are shaped, mended, and
// counted.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/Map_quantizer.h>
#include <CGAL/Quad_remeshing/internal/Remeshing_run.h>
#include <CGAL/Quad_remeshing/internal/cells/inverted_quads.h>
#include <CGAL/Quad_remeshing/internal/has_too_many_quads.h>
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

#include <CGAL/Bbox_3.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

class Quad_remesher
  : private Remeshing_types
{
  using State = Remeshing_run::State;

public:
  // \param locator that of the surface, once it is needed
  Quad_remesher(Surface_to_remesh& surface, std::optional<Surface_locator>& locator,
                const Remeshing_options& options, Mesh& quads, const Feature_map& is_feature)
    : m_run(surface, options), m_locator(locator), m_quads(quads), m_is_feature(is_feature)
  { }

  void run()
  {
    if(check_lengths() && check_tolerances() && check_mirror() &&
       Map_quantizer(m_run, m_choices).run() && make_best_quads())
      change_points([&](const double x) { return m_run.surface.unscaled(x); });
  }

  const Remeshing_report& report() const { return m_run.report; }

  // The corners of inverted and folded quads, or, if there are none, of thin ones.
  const std::vector<Point>& places_of_flaws() const
  { return m_run.report.number_of_bad_quads() > 0 ? m_bad_places : m_thin_places; }

  // Moves the vertices of quads that have been extracted already, in the size of the input.
  Remeshing_report run_on_quads(const Quantization& quantization)
  {
    if(!check_lengths())
      return m_run.report;
    change_points([&](const double x) { return m_run.surface.scaled(x); });
    take_over(quantization);
    smooth();
    change_points([&](const double x) { return m_run.surface.unscaled(x); });
    return m_run.report;
  }

private:
  // Products of lengths that differ by more are 0 or infinite.
  bool check_lengths()
  {
    constexpr double largest_ratio = 1e50; // of edge lengths: squares of their products stay finite
    double least = std::numeric_limits<double>::infinity(), longest = 0;
    std::size_t face = 0;
    for(const auto f : m_run.mesh().faces())
      for(const auto h : m_run.mesh().halfedges_around_face(m_run.mesh().halfedge(f))) {
        const double l = m_run.surface.length(h);
        if(l > longest) {
          longest = l;
          face = m_run.surface.original(f);
        }
        least = l > 0 ? (std::min)(least, l) : least;
      }
    return !(longest > largest_ratio * least) ||
           refuse(m_run.report, Outcome::INVALID_ARGUMENT,
                  name_of_face(face) + " has an edge more than 1e50 times as long as the shortest "
                  "one of the mesh" + remedy("remove the vertex that is far away"));
  }

  bool check_tolerances()
  {
    const bool is_negative = !(m_run.options.border_tolerance.value_or(0) >= 0);
    return (!is_negative && m_run.options.area_threshold.value_or(0) >= 0) ||
           refuse(m_run.report, Outcome::INVALID_ARGUMENT,
                  term(is_negative ? "border_tolerance" : "area_threshold") +
                    " must not be negative");
  }

  // The mesh is one half then, and has half of the quads.
  bool check_mirror()
  {
    const std::optional<Mirror>& mirror = m_run.surface.mirror();
    if(!mirror)
      return true;
    if(!mirror->is_valid())
      return refuse(m_run.report, Outcome::INVALID_ARGUMENT,
                    term("symmetry_plane") + " is no plane");
    if(m_run.mesh().number_of_faces() == 0)
      return refuse(m_run.report, Outcome::INVALID_ARGUMENT,
                    "no part of the surface is on the positive side of " + term("symmetry_plane") +
                      ", or it meets itself along it");
    Quantization_options& options = m_run.options.quantization;
    options.number_of_quads = (std::max)(1., options.number_of_quads / 2);
    options.maximum_number /= 2;
    return true;
  }

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
          m_run.report.message +=
            (m_run.report.message.empty() ? "" : "; ") +
            std::string("of fewer quads, one half would meet its image twice");
        return true;
      }
      m_run.options.quantization.is_coarsest = false;
      m_run.options.quantization.number_of_quads = 1.5 * number_in_half;
      if(!m_run.take(quantize_again(m_run.quantization, m_run.options.quantization)))
        return false;
    }
    return refuse(m_run.report, Outcome::NO_FACE_GRAPH,
                  "the quads of one half meet their mirror images twice; ask for more quads");
  }

  // Takes the quantization whose quads are best in a rough shape, before they are mended.
  bool make_best_quads()
  {
    add_larger_numbers();
    if(m_choices.size() < 2)
      return make_quads();
    const std::size_t fewest = m_choices.front().quantization.number_of_quads;
    const double least_number =
      (std::max)(double(fewest), m_run.options.quantization.number_of_quads);
    const Surface_samples samples(m_run.mesh(), number_of_samples);
    const State* best = &m_choices.front();
    double least = std::numeric_limits<double>::infinity();
    for(const State& choice : m_choices)
      shape_roughly(choice, [&](const Quad_smoother& smoother) {
        if(const double now = badness(smoother, samples, least_number); now < least) {
          least = now;
          best = &choice;
        }
      });
    m_run.set_state(*best);
    m_quads.clear_without_removing_property_maps();
    if(!make_quads())
      return false;
    const std::size_t number = m_run.quantization.number_of_quads;
    if(fewest < number && double(number) > 1.1 * m_run.options.quantization.number_of_quads)
      m_run.report.message =
        counted(fewest, "quad") + " were found, too, but " +
        (m_jacobian_of_fewest <= m_run.report.mean_scaled_jacobian
           ? "in a worse shape or farther from the surface, with a mean scaled Jacobian of " +
             short_number(m_jacobian_of_fewest) + " at first"
           : "farther from the surface, or with inverted quads") +
        remedy("minimize_number_of_quads(true) makes as few as are found");
    return true;
  }

  // Less for quads that are nearer to rectangles and to the surface, and for fewer ones.
  // \param least_number of quads, that is wanted and can be made
  double badness(const Quad_smoother& smoother, const Surface_samples& samples,
                 const double least_number) const
  {
    const CGAL::Bbox_3 box = CGAL::bbox_3(m_run.mesh().points().begin(),
                                          m_run.mesh().points().end());
    const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
    const double distance = (std::max)(smoother.measure_distance(),
                                       samples.largest_distance(m_quads));
    return 2 * distance / diagonal - smoother.shapes().mean_scaled_jacobian +
           0.05 * double(smoother.number_of_inverted_quads()) +
           0.3 * double(m_quads.number_of_faces()) / least_number;
  }

  // Calls measure(smoother) for the quads of a choice.
  template <typename Measure>
  void shape_roughly(const State& choice, const Measure& measure)
  {
    m_run.set_state(choice);
    m_quads.clear_without_removing_property_maps();
    m_quads.set_recycle_garbage(false);
    if(!extract())
      return;
    Quad_smoother smoother(m_quads, locator());
    const Feature_lines lines(m_run.surface);
    Quad_shaper shaper(m_quads, m_is_feature, m_run.mesh(), lines, smoother);
    shape(shaper, smoother, rounds_to_choose);
    measure(smoother);
    m_run.work.spend(work_of(smoother));
    m_run.timer.finish("smoothing");
  }

  // Between features or cones, few quads may have a bad shape where a few more have a good one:
  // larger numbers of the same map are choices, too. They stay below the largest number that is a
  // success, unless the fewest quads do not.
  void add_larger_numbers()
  {
    constexpr double good_shape = 0.9; // a mean scaled Jacobian
    constexpr int most_steps = 5; // of a tenth
    if(m_choices.empty())
      return;
    const State first = m_choices.front();
    shape_roughly(first, [&](const Quad_smoother& smoother)
                         { m_jacobian_of_fewest = smoother.shapes().mean_scaled_jacobian; });
    const bool is_good = m_jacobian_of_fewest >= good_shape;
    Quantization_options options = m_run.options.quantization;
    options.maximum_feature_loss = 0; // the features that it lets go are released already
    const double number = (std::max)(options.number_of_quads,
                                     double(first.quantization.number_of_quads));
    const double most = largest_number_of_quads(m_run.mesh(), options.number_of_quads,
                                                first.quantization.number_of_forced_quads);
    for(int i = 1; !is_good && i <= most_steps && m_choices.size() < Map_quantizer::most_choices &&
                   m_run.work.is_left(); ++i) {
      options.number_of_quads = (1 + 0.1 * i) * number;
      State larger = first;
      larger.quantization = quantize_again(first.quantization, options);
      larger.quantization.released_features = first.quantization.released_features;
      const double of_larger = double(larger.quantization.number_of_quads);
      if(larger.quantization &&
         of_larger > double(m_choices.back().quantization.number_of_quads) &&
         (of_larger <= most || number > most))
        m_choices.push_back(larger);
    }
    m_run.timer.finish("quantization");
    m_run.set_state(first);
    m_quads.clear_without_removing_property_maps();
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

  static constexpr std::size_t number_of_samples = 5000; // of the distance of a choice
  static constexpr std::size_t rounds_to_choose = 4; // for the rough shape of each choice
  static constexpr int most_edits = 5; // rounds of collapsing and dividing quads
  static constexpr int most_mending_rounds = 4; // of moving vertices off features or surface
  static constexpr std::size_t shaping_rounds = 4; // for each of smoothing, at most

  Remeshing_run m_run;
  std::optional<Surface_locator>& m_locator;
  std::vector<State> m_choices; // quads are made of the best one
  Mesh& m_quads;
  Feature_map m_is_feature;
  double m_jacobian_of_fewest = 1; // of the choices, in a rough shape
  std::vector<Point> m_bad_places; // the corners of quads that are inverted or folded
  std::vector<Point> m_thin_places; // of others
};


} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUAD_REMESHER_H
