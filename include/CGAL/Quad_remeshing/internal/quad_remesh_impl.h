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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUAD_REMESH_IMPL_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUAD_REMESH_IMPL_H

#include <CGAL/license/Quad_remeshing.h>

// The steps from a surface to its quads.

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
#include <CGAL/Quad_remeshing/internal/remeshing/leave_out_small_parts.h>
#include <CGAL/Quad_remeshing/internal/remeshing/mend_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/shape_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/smooth_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/vertex_far_away.h>
#include <CGAL/Quad_remeshing/quad_remesh.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
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

  // Releases the features within a number of edges around the corners of inverted and folded quads,
  // or, if there are none, of thin quads. Returns whether there are any; from here on, the report
  // counts them.
  bool release_features_at_bad_quads(const double edges)
  {
    const double radius = edges * std::sqrt(m_run.area() / double(m_run.report.number_of_quads));
    const std::size_t before = m_run.report.number_of_released_edges;
    const bool has_bad = m_run.report.number_of_bad_quads() > 0;
    const std::vector<Point>& places = has_bad ? m_bad_places : m_thin_places;
    for(const auto e : m_run.mesh().edges()) {
      const auto h = m_run.mesh().halfedge(e);
      const Kernel::Segment_3 s(m_run.mesh().point(m_run.mesh().source(h)),
                                m_run.mesh().point(m_run.mesh().target(h)));
      if(m_run.surface.is_feature()[e] &&
         std::any_of(places.begin(), places.end(), [&](const Point& p)
                     { return CGAL::squared_distance(p, s) < radius * radius; }))
        m_run.release(h);
    }
    const std::size_t number = m_run.report.number_of_released_edges - before;
    if(number > 0)
      Progress::tell([&] {
        return counted(places.size() / 4, has_bad ? "folded or inverted quad" : "thin quad") +
               "; again without " + counted(number, "feature edge") + " near by";
      });
    return number > 0;
  }

  // Also edges that earlier attempts have released.
  void count_released_edges(const Remeshing_report& earlier)
  {
    m_run.report.number_of_released_edges += earlier.number_of_released_edges;
    m_run.report.length_of_released_edges += earlier.length_of_released_edges;
  }

  const Remeshing_report& report() const { return m_run.report; }

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

  // Takes the quantization whose quads are best before they are mended: all are shaped roughly, and
  // the best two as usual.
  bool make_best_quads()
  {
    add_larger_numbers();
    if(m_choices.size() < 2)
      return make_quads();
    const std::size_t fewest = m_choices.front().quantization.number_of_quads;
    m_least_number = (std::max)(double(fewest), m_run.options.quantization.number_of_quads);
    const Surface_samples samples(m_run.mesh(), number_of_samples);
    keep_best_choices(samples, 2, [&](Quad_shaper& shaper, Quad_smoother& smoother)
                                  { shape(shaper, smoother, rounds_to_choose); });
    keep_best_choices(samples, 1, [&](Quad_shaper& shaper, Quad_smoother& smoother)
                                  { shape_and_improve(shaper, smoother); });
    m_run.set_state(m_choices.front());
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

  // So many, by the quads that `move(shaper, smoother)` gives their shape.
  template <typename Move>
  void keep_best_choices(const Surface_samples& samples, const std::size_t number,
                         const Move& move)
  {
    std::vector<std::pair<double, std::size_t> > order;
    for(std::size_t i = 0; i < m_choices.size(); ++i)
      shape_choice(m_choices[i], move, [&](const Quad_smoother& smoother)
                                       { order.emplace_back(badness(smoother, samples), i); });
    std::sort(order.begin(), order.end());
    std::vector<State> best;
    for(std::size_t k = 0; k < number && k < order.size(); ++k)
      best.push_back(std::move(m_choices[order[k].second]));
    if(!best.empty())
      m_choices = std::move(best);
  }

  // Less for quads that are nearer to rectangles and to the surface, and for fewer ones.
  double badness(const Quad_smoother& smoother, const Surface_samples& samples) const
  {
    const CGAL::Bbox_3 box = CGAL::bbox_3(m_run.mesh().points().begin(),
                                          m_run.mesh().points().end());
    const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
    const double distance = (std::max)(smoother.measure_distance(),
                                       samples.largest_distance(m_quads));
    return 2 * distance / diagonal - smoother.shapes().mean_scaled_jacobian +
           0.05 * double(smoother.number_of_inverted_quads()) +
           0.3 * double(m_quads.number_of_faces()) / m_least_number;
  }

  // Gives the quads of a choice a shape by `move(shaper, smoother)`, and calls `measure(smoother)`.
  template <typename Move, typename Measure>
  void shape_choice(const State& choice, const Move& move, const Measure& measure)
  {
    m_run.set_state(choice);
    m_quads.clear_without_removing_property_maps();
    m_quads.set_recycle_garbage(false);
    if(!extract())
      return;
    Quad_smoother smoother(m_quads, locator());
    const Feature_lines lines(m_run.surface);
    Quad_shaper shaper(m_quads, m_is_feature, m_run.mesh(), lines, smoother);
    move(shaper, smoother);
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
    shape_choice(first,
                 [&](Quad_shaper& shaper, Quad_smoother& smoother)
                 { shape(shaper, smoother, rounds_to_choose); },
                 [&](const Quad_smoother& smoother)
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
  double m_least_number = 1; // of quads, that is wanted and can be made
  double m_jacobian_of_fewest = 1; // of the choices, in a rough shape
  std::vector<Point> m_bad_places; // the corners of quads that are inverted or folded
  std::vector<Point> m_thin_places; // of others
};

// By others, with their features.
inline void replace_quads(const Surface_to_remesh::Mesh& others,
                          const Surface_to_remesh::Feature_map& is_feature_of_others,
                          Surface_to_remesh::Mesh& quads,
                          const Surface_to_remesh::Feature_map& is_feature)
{
  quads.clear_without_removing_property_maps();
  const auto write = [&](const auto& halfedges) {
    is_feature[quads.edge(halfedges.second)] =
      is_feature_of_others[others.edge(halfedges.first)];
  };
  CGAL::copy_face_graph(others, quads,
                        CGAL::parameters::halfedge_to_halfedge_output_iterator(
                          boost::make_function_output_iterator(write)));
}

// Makes quads once more, by `make(quads, is_feature)`, which take the place of the present quads
// if `is_better(report, best)`; returns whether they do. The steps of both are reported, in their
// order.
template <typename Make, typename Is_better>
bool make_others(const Make& make, const Is_better& is_better, Surface_to_remesh::Mesh& quads,
                 const Surface_to_remesh::Feature_map& is_feature, Remeshing_report& best)
{
  using Mesh = Surface_to_remesh::Mesh;
  Mesh mesh;
  const auto is_kept = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  Remeshing_report report = make(mesh, is_kept);
  std::vector<std::pair<std::string, double> > steps = best.step_times;
  steps.insert(steps.end(), report.step_times.begin(), report.step_times.end());
  const bool replaces = is_better(report, best);
  if(replaces) {
    replace_quads(mesh, is_kept, quads, is_feature);
    best = std::move(report);
  }
  best.step_times = std::move(steps);
  return replaces;
}

// By which the median edge differs from its wanted length: less matters less than shape, and more
// than the second one is forced, as where very few quads are wanted.
constexpr double good_deviation = 0.5, forced_deviation = 1.5; // as parts of the wanted edge length

// Compares results that may have released features.
class Is_better
{
public:
  // \param unit of numbers of quads, where there are to be few
  explicit Is_better(const Surface_to_remesh& surface,
                     const double unit = std::numeric_limits<double>::infinity())
    : m_length_of_features(surface.length_of_features()), m_unit(unit)
  { }

  bool operator()(const Remeshing_report& a, const Remeshing_report& b) const
    { return badness(a) < badness(b); }

private:
  std::tuple<bool, std::size_t, double> badness(const Remeshing_report& r) const
  {
    const double released =
      m_length_of_features > 0 ? r.length_of_released_edges / m_length_of_features : 0;
    const double deviation = std::clamp(r.median_size_deviation.value_or(0), good_deviation,
                                        forced_deviation);
    return {!r, r.number_of_bad_quads(), (released + deviation) / 2 - r.mean_scaled_jacobian +
                                              double(r.number_of_quads) / m_unit};
  }

  double m_length_of_features, m_unit;
};

// By default, half of an edge of the quads, where these are to be of one size.
inline double border_tolerance(const Surface_to_remesh& surface, const Remeshing_options& options)
{
  const double number = options.number_wanted() / (surface.mirror() ? 2 : 1);
  const double length = number > 0 && !surface.has_sizes_that_vary()
    ? surface.unscaled(std::sqrt(area_in_squares(surface) / number)) : 0;
  return options.border_tolerance.value_or(length / 2);
}

// Also without features near bad quads, which the surface loses; it gets its map.
inline Remeshing_report remesh_surface(Surface_to_remesh& surface,
                                       const Remeshing_options& options,
                                       Surface_to_remesh::Mesh& quads,
                                       const Surface_to_remesh::Feature_map& is_feature)
{
  using Mesh = Surface_to_remesh::Mesh;
  surface.straighten_border(border_tolerance(surface, options));
  const Is_better is_better(surface);
  const Work& work = *options.quantization.work;
  std::optional<Surface_locator> locator;
  Remeshing_report before; // an attempt: what has been released
  constexpr double most_edges = 8; // of quads, around a bad one
  constexpr double good_jacobian = 0.9; // a mean scaled Jacobian
  constexpr double bad_jacobian = 0.8; // also where there are more quads than wanted
  double edges = 1; // of quads, around the bad ones: features there are released next
  bool may_try_again = true;
  int attempts_for_shape = 0;
  const auto is_bad = [&](const Remeshing_report& r) {
    const bool is_forced = options.quantization.is_coarsest ||
      double(r.number_of_quads) >= 1.1 * options.quantization.number_of_quads;
    const bool is_distorted = r.mean_scaled_jacobian < (is_forced ? bad_jacobian : good_jacobian) &&
                              attempts_for_shape == 0;
    const bool has_other_sizes = r.median_size_deviation.value_or(0) > good_deviation &&
                                 attempts_for_shape < 2 && !is_forced;
    return r && (r.number_of_bad_quads() > 0 || is_distorted || has_other_sizes);
  };
  const auto attempt = [&](Mesh& mesh, const Surface_to_remesh::Feature_map& is_kept) {
    Quad_remesher remesher(surface, locator, options, mesh, is_kept);
    remesher.run();
    remesher.count_released_edges(before);
    const Remeshing_report report = remesher.report();
    may_try_again = false;
    for(; is_bad(report) && !may_try_again && edges <= most_edges; edges *= 2)
      may_try_again = remesher.release_features_at_bad_quads(edges);
    before = remesher.report();
    return report;
  };
  const double most_work = work.left();
  Remeshing_report best = attempt(quads, is_feature);
  const double of_attempt = most_work - work.left();
  bool is_spent = false;
  while(may_try_again && is_bad(best)) {
    is_spent = work.left() < of_attempt / 4;
    if(is_spent)
      break;
    attempts_for_shape += best.number_of_bad_quads() == 0;
    make_others(attempt, is_better, quads, is_feature, best);
  }
  best.number_of_corners_left_out = surface.number_of_corners_left_out();
  if(is_spent || !work.is_left())
    add_note(best, words_for_spent_work);
  return best;
}

// The search for quads: the first result is made of a surface with room between its features and
// with straight borders. What the best result lacks tells which moves are tried, in the order of
// their table. The best quads stay.
class Quad_search
{
  enum class Room { NONE, IN_LONG_TRIANGLES, IN_ALL_TRIANGLES }; // by dividing these

  // What may mend the flaws of the best result.
  struct Move
  {
    const char* choice;                // in words
    bool (Quad_search::*mends)() const; // whether the best result asks for it
    Room room;
    bool has_straight_border;
    std::optional<double> part; // of the way to the largest number of quads; else as many as wanted
    bool (Quad_search::*may_take)(const Remeshing_report&) const; // even if it is better
  };

  static constexpr std::array<Move, 7> moves()
  {
    using S = Quad_search;
    const Room room = Room::IN_LONG_TRIANGLES;
    return {{
      {"room in all triangles", &S::has_flaws, Room::IN_ALL_TRIANGLES, true, {}, &S::is_any},
      {"the border as it is", &S::has_flaws_at_border, room, false, {}, &S::has_hardly_more_quads},
      {"the best of several maps", &S::is_coarse_and_bad, room, true, 0., &S::has_fewer_bad},
      {"some more quads", &S::has_few_and_bad, room, true, 0.3, &S::has_none_bad},
      {"more quads", &S::has_few_and_bad, room, true, 0.6, &S::has_none_bad},
      {"nearly as many quads as may be", &S::has_few_and_bad, room, true, 1., &S::has_none_bad},
      {"the input as it is", &S::has_no_quads, Room::NONE, false, {}, &S::is_any}
    }};
  }

public:
  Quad_search(const Marked_surface& input, const std::optional<Mirror>& mirror,
              const Remeshing_options& options, Surface_to_remesh::Mesh& quads,
              const Surface_to_remesh::Feature_map& is_feature)
    : m_input(input), m_mirror(mirror), m_options(options), m_quads(quads),
      m_is_feature(is_feature)
  { }

  Remeshing_report run()
  {
    Surface_to_remesh surface(m_input, m_mirror);
    m_is_changed = surface.refine(true);
    m_number_of_faces = surface.mesh().number_of_faces();
    m_best = remesh_surface(surface, m_options, m_quads, m_is_feature);
    m_is_changed = m_is_changed || surface.number_of_corners_left_out() > 0;
    for(const Move& move : moves())
      if((this->*move.mends)())
        run(move);
    if(m_best && !work().is_left())
      add_note(m_best, words_for_spent_work);
    return m_best;
  }

private:
  const Work& work() const { return *m_options.quantization.work; }

  bool has_flaws() const
  {
    constexpr double good_shape = 0.95; // a mean scaled Jacobian
    return work().is_mostly_left() &&
           (!m_best || m_best.number_of_released_edges > 0 ||
            m_best.number_of_bad_quads() > 0 || m_best.number_of_displaced_vertices > 0 ||
            m_best.mean_scaled_jacobian < good_shape);
  }

  bool has_flaws_at_border() const
  {
    constexpr double fair_shape = 0.9; // a mean scaled Jacobian
    return work().is_mostly_left() && m_best && m_best.number_of_corners_left_out > 0 &&
           (m_best.number_of_bad_quads() > 0 || m_best.number_of_displaced_vertices > 0 ||
            m_best.mean_scaled_jacobian < fair_shape);
  }

  // More quads may have room around cones and between features.
  bool has_few_and_bad() const
  {
    constexpr std::size_t few = 2000; // quads in all
    return work().is_left() && m_best && m_best.number_of_bad_quads() > 0 &&
           m_best.number_of_quads <= few;
  }

  // For few quads, the map is chosen by their shape; for as few as can be, by their number.
  bool is_coarse_and_bad() const
  { return m_options.quantization.is_coarsest && has_few_and_bad(); }

  bool has_no_quads() const { return work().is_left() && !m_best && m_is_changed; }

  bool is_any(const Remeshing_report&) const { return true; }

  bool has_hardly_more_quads(const Remeshing_report& r) const
  { return double(r.number_of_quads) <= 1.2 * double(m_best.number_of_quads); }

  bool has_none_bad(const Remeshing_report& r) const
  { return r && r.number_of_bad_quads() == 0; }

  bool has_fewer_bad(const Remeshing_report& r) const
  { return r && r.number_of_bad_quads() < m_best.number_of_bad_quads(); }

  // A part of the way from the fewest quads to nearly the largest number that is a success, or to
  // twice the fewest quads if these are more. No part: as few as can be.
  double number_of_quads(const double part) const
  {
    constexpr double nearly = 0.95; // of a number: quantizations may have some more quads
    if(part == 0)
      return 1;
    const double fewest = double(m_fewest->number_of_quads);
    double largest = 2 * fewest;
    if(!m_options.quantization.is_coarsest) {
      const double of_success = largest_number_of_quads(
        m_input.mesh, m_options.quantization.number_of_quads, m_fewest->number_of_forced_quads);
      if(fewest < nearly * of_success)
        largest = of_success;
    }
    return fewest + part * (nearly * largest - fewest);
  }

  // Quads that were made before stay if they are better, or if the new quads are more
  // where there are to be as few as can be.
  void run(const Move& move)
  {
    Surface_to_remesh surface(m_input, m_mirror);
    if(move.room != Room::NONE)
      surface.refine(move.room == Room::IN_LONG_TRIANGLES);
    if(move.room == Room::IN_ALL_TRIANGLES && surface.mesh().number_of_faces() <= m_number_of_faces)
      return;
    Remeshing_options options = m_options;
    if(!move.has_straight_border)
      options.border_tolerance = 0;
    if(move.part) {
      if(!m_fewest)
        m_fewest = m_best;
      options.quantization.is_coarsest = false;
      options.quantization.number_of_quads = number_of_quads(*move.part);
    }
    Progress::tell([&] { return std::string("again, with ") + move.choice; });
    const double unit = m_best && options.quantization.is_coarsest
      ? double(m_best.number_of_quads) : std::numeric_limits<double>::infinity();
    const Is_better is_better(surface, unit);
    const auto replaces = [&](const Remeshing_report& a, const Remeshing_report& b)
    { return double(a.number_of_quads) <= unit && (this->*move.may_take)(a) && is_better(a, b); };
    const bool is_taken = make_others([&](auto& mesh, const auto& is_kept)
                                      { return remesh_surface(surface, options, mesh, is_kept); },
                                      replaces, m_quads, m_is_feature, m_best);
    if(is_taken && move.part) {
      m_best.message = m_fewest->message; // which tells why there are so many
      add_note(m_best, std::to_string(m_fewest->number_of_quads) + " quads were found, too, " +
                       std::to_string(m_fewest->number_of_bad_quads()) +
                       " of them inverted or folded");
    }
  }

  const Marked_surface& m_input;
  const std::optional<Mirror>& m_mirror;
  const Remeshing_options& m_options;
  Surface_to_remesh::Mesh& m_quads;
  Surface_to_remesh::Feature_map m_is_feature;
  Remeshing_report m_best;
  std::optional<Remeshing_report> m_fewest; // before more quads than wanted are tried
  std::size_t m_number_of_faces = 0; // of the first surface
  bool m_is_changed = false; // the first surface is not the input as it is
};

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
double growth_by(const Mirror& mirror, const Marked_surface& input)
{
  return 2 * area_in_squares(Surface_to_remesh(input, mirror)) /
         area_in_squares(Surface_to_remesh(input, std::nullopt));
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Remeshing_report remesh(Marked_surface& input, const std::optional<Mirror>& mirror,
                        const Remeshing_options& options, Surface_to_remesh::Mesh& quads,
                        const Surface_to_remesh::Feature_map& is_feature)
{
  if(const auto h = halfedge_from_far_away(input.mesh)) {
    const auto& p = input.mesh.point(input.mesh.source(*h));
    return refused<Remeshing_report>(
      Outcome::INVALID_ARGUMENT,
      name_of_face(std::size_t(input.mesh.face(*h))) + " has a vertex at (" +
        short_number(p.x()) + ", " + short_number(p.y()) + ", " + short_number(p.z()) +
        "), which is a million times as far away as nearly all others" +
        remedy("move it, or remove it"));
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Small_parts small_parts(input, options.area_threshold,
                          options.quantization.is_coarsest
                            ? infinity : options.quantization.number_of_quads);
  small_parts.leave_out();
  Remeshing_report report = Quad_search(input, mirror, options, quads, is_feature).run();
  report.number_of_parts_left_out = small_parts.number();
  report.area_of_parts_left_out = small_parts.area();
  const auto& parts = report.parts_of_other_size;
  report.has_too_many_quads =
    report && !options.quantization.is_coarsest &&
    (has_too_many_quads(quads, options.quantization.number_of_quads,
                        report.number_of_forced_quads) ||
     std::any_of(parts.begin(), parts.end(),
                 [](const Part_of_other_size& part) { return part.has_too_many_quads; }));
  return report;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Remeshing_report smooth(const Marked_surface& input, const Quantization& quantization,
                        const Remeshing_options& options, Surface_to_remesh::Mesh& quads,
                        const Surface_to_remesh::Feature_map& is_feature)
{
  Surface_to_remesh surface(input, std::nullopt);
  std::optional<Surface_locator> locator;
  return Quad_remesher(surface, locator, options, quads, is_feature).run_on_quads(quantization);
}

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
namespace parametrization {
CGAL_QUAD_REMESHING_PARAMETRIZE()
} // namespace parametrization
#endif

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUAD_REMESH_IMPL_H
