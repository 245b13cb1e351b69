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

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/internal/support/Step_timer.h>
#include <CGAL/Quad_remeshing/approximate_seamless_parametrization.h>
#include <CGAL/Quad_remeshing/internal/cells/inverted_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/add_mirror_image.h>
#include <CGAL/Quad_remeshing/internal/remeshing/collapse_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/divide_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/even_out_border.h>
#include <CGAL/Quad_remeshing/internal/remeshing/improve_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/mend_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/shape_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/smooth_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_samples.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Upper_sides.h>
#include <CGAL/Quad_remeshing/internal/support/Work.h>
#include <CGAL/Quad_remeshing/quad_remesh.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Invariant: `m_report` tells why the last step failed, if it did.
class Quad_remesher
{
  using Mesh = Surface_to_remesh::Mesh;
  using Feature_map = Surface_to_remesh::Feature_map;
  using Point = Surface_to_remesh::Kernel::Point_3;

public:
  Quad_remesher(Surface_to_remesh& surface, const Remeshing_options& options, Mesh& quads,
                const Feature_map& is_feature)
    : m_surface(surface), m_options(options), m_quads(quads), m_is_feature(is_feature),
      m_work(*options.quantization.work), m_timer(m_report)
  { }

  void run()
  {
    if(check_lengths() && check_mirror() && quantize_a_map() && make_best_quads())
      change_points([&](const double x) { return m_surface.unscaled(x); });
  }

  // Those within a number of edges of quads around the corners of inverted ones, or, without such,
  // of thin ones. Returns whether there are any; the report counts them from here on.
  bool release_features_at_bad_quads(const double edges)
  {
    const double area = area_in_squares(surface_mesh(), 1, CGAL::parameters::default_values());
    const double radius = edges * std::sqrt(area / double(m_report.number_of_quads));
    const std::size_t before = m_report.number_of_released_edges;
    const bool is_inverted = m_report.number_of_inverted_quads > 0;
    const std::vector<Point>& places = is_inverted ? m_inverted_places : m_thin_places;
    for(const auto e : surface_mesh().edges()) {
      const auto h = surface_mesh().halfedge(e);
      const Surface_to_remesh::Kernel::Segment_3 s(surface_mesh().point(surface_mesh().source(h)),
                                                   surface_mesh().point(surface_mesh().target(h)));
      if(m_surface.is_feature()[e] &&
         std::any_of(places.begin(), places.end(), [&](const Point& p)
                     { return CGAL::squared_distance(p, s) < radius * radius; }))
        release(h);
    }
    const std::size_t number = m_report.number_of_released_edges - before;
    if(number > 0)
      Progress::tell([&] {
        return counted(places.size() / 4, is_inverted ? "inverted quad" : "thin quad") +
               "; again without " + counted(number, "feature edge") + " near by";
      });
    return number > 0;
  }

  // Also edges that earlier attempts have released.
  void count_released_edges(const Remeshing_report& earlier)
  {
    m_report.number_of_released_edges += earlier.number_of_released_edges;
    m_report.length_of_released_edges += earlier.length_of_released_edges;
  }

  const Remeshing_report& report() const { return m_report; }

  // Of quads that have been extracted already, in the size of the input.
  Remeshing_report run_on_quads(const Quantization& quantization)
  {
    if(!check_lengths())
      return m_report;
    change_points([&](const double x) { return m_surface.scaled(x); });
    take_over(quantization);
    smooth();
    change_points([&](const double x) { return m_surface.unscaled(x); });
    return m_report;
  }

private:
  const Mesh& surface_mesh() const { return m_surface.mesh(); }

  // What all steps know of the surface; the first one writes the transitions.
  auto features_and_transitions() const
  {
    return parameters::edge_is_constrained_map(m_surface.is_feature())
                      .edge_is_cut_map(m_surface.is_cut())
                      .halfedge_rotation_map(m_surface.rotations());
  }

  // Products of lengths that differ by more are 0 or infinite.
  bool check_lengths()
  {
    constexpr double largest_ratio = 1e50;
    double least = std::numeric_limits<double>::infinity(), longest = 0;
    std::size_t face = 0;
    for(const auto f : surface_mesh().faces())
      for(const auto h : surface_mesh().halfedges_around_face(surface_mesh().halfedge(f))) {
        const double l = m_surface.length(h);
        if(l > longest) {
          longest = l;
          face = m_surface.original(f);
        }
        least = l > 0 ? (std::min)(least, l) : least;
      }
    return !(longest > largest_ratio * least) ||
           refuse(m_report, Outcome::INVALID_ARGUMENT,
                  "face " + std::to_string(face) + " has an edge more than 1e50 times as long as "
                  "the shortest one of the mesh; remove the vertex that is far away");
  }

  // The mesh is one half then, and has half of the quads.
  bool check_mirror()
  {
    const std::optional<Mirror>& mirror = m_surface.mirror();
    if(!mirror)
      return true;
    if(!mirror->is_valid())
      return refuse(m_report, Outcome::INVALID_ARGUMENT, "symmetry_plane is no plane");
    if(surface_mesh().number_of_faces() == 0)
      return refuse(m_report, Outcome::INVALID_ARGUMENT,
                    "no part of the surface is on the positive side of symmetry_plane, or it meets "
                    "itself along it");
    Quantization_options& options = m_options.quantization;
    options.number_of_quads = (std::max)(1., options.number_of_quads / 2);
    options.maximum_number /= 2;
    return true;
  }

  // Of a half, as many as make a mesh with their mirror image.
  bool make_quads()
  {
    constexpr int most_rounds = 12;
    for(int round = 0; round < most_rounds; ++round) {
      if(!extract())
        return false;
      const double number_in_half = double(m_quads.number_of_faces());
      if(smooth()) {
        if(round > 0)
          m_report.message += (m_report.message.empty() ? "" : "; ") +
                              std::string("of fewer quads, one half would meet its image twice");
        return true;
      }
      m_options.quantization.is_coarsest = false;
      m_options.quantization.number_of_quads = 1.5 * number_in_half;
      if(!take(quantize_again(m_quantization, m_options.quantization)))
        return false;
    }
    return refuse(m_report, Outcome::NO_FACE_GRAPH,
                  "the quads of one half meet their mirror images twice; ask for more quads");
  }

  // Of the quantizations that were kept, the one whose quads are best before they are mended: all
  // are shaped roughly, and the best two as usual.
  bool make_best_quads()
  {
    add_larger_numbers();
    if(m_choices.size() < 2)
      return make_quads();
    const std::size_t fewest = m_choices.front().quantization.number_of_quads;
    const Surface_samples samples(surface_mesh(), number_of_samples);
    keep_best_choices(samples, 2, [&](const Feature_lines& lines, Quad_smoother& smoother)
                                  { shape(lines, smoother, rounds_to_choose); });
    keep_best_choices(samples, 1, [&](const Feature_lines& lines, Quad_smoother& smoother)
                                  { shape_and_improve(lines, smoother); });
    set_state(m_choices.front());
    m_quads.clear_without_removing_property_maps();
    if(!make_quads())
      return false;
    const std::size_t number = m_choices.front().quantization.number_of_quads;
    if(fewest < number && double(number) > 1.1 * m_options.quantization.number_of_quads)
      m_report.message = counted(fewest, "quad") + " were found, too, but in a worse shape";
    return true;
  }

  // So many, by the quads that `move(lines, smoother)` gives their shape.
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
    const CGAL::Bbox_3 box = CGAL::bbox_3(surface_mesh().points().begin(),
                                          surface_mesh().points().end());
    const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
    const double distance = (std::max)(smoother.measure_distance(),
                                       samples.largest_distance(m_quads));
    return 2 * distance / diagonal - smoother.measure_shape().mean_scaled_jacobian +
           0.05 * double(smoother.number_of_inverted_quads()) +
           0.3 * double(m_quads.number_of_faces()) / m_options.quantization.number_of_quads;
  }

  // From here on, it is no feature: no field can follow it without flips, or quads are inverted
  // next to it.
  void release(const Mesh::Halfedge_index h)
  {
    m_surface.is_feature()[surface_mesh().edge(h)] = false;
    ++m_report.number_of_released_edges;
    m_report.length_of_released_edges += m_surface.unscaled(m_surface.length(h));
  }

  // Those that force quads. The map stays: only quads need not follow them.
  // \param features the vertices along each
  void release_features(const std::vector<std::vector<std::size_t> >& features)
  {
    const Flat_numbering<Mesh> numbering(surface_mesh());
    const auto point = [&](const std::size_t v) {
      const Point& p = surface_mesh().point(numbering.vertices_in_order()[v]);
      return std::array<double, 3>{m_surface.unscaled(p.x()), m_surface.unscaled(p.y()),
                                   m_surface.unscaled(p.z())};
    };
    for(const std::vector<std::size_t>& f : features) {
      Released_feature released{point(f.front()), point(f.back()), 0};
      for(std::size_t i = 1; i < f.size(); ++i) {
        const auto h = surface_mesh().halfedge(numbering.vertices_in_order()[f[i - 1]],
                                               numbering.vertices_in_order()[f[i]]);
        m_surface.is_feature()[surface_mesh().edge(h)] = false;
        released.length += norm(vector_to(point(f[i - 1]), point(f[i])));
      }
      m_report.released_features.push_back(released);
    }
  }

  bool sizes_vary() const
  { return m_options.curvature_adaptivity > 1 || m_surface.has_sizes_that_vary(); }

  // By default, so little that it hardly matters where the surface curves alike in all directions,
  // or without order; but over some tens of faces, edges and round parts direct the field. Faces
  // that are twice as small are followed over twice as many from a number on: a surface that is
  // given more finely has the same field.
  double curvature_alignment() const
  {
    constexpr double most_faces = 50000;
    const double part = most_faces / double(surface_mesh().number_of_faces());
    return m_options.curvature_alignment.value_or(sizes_vary() ? 0.
                                                               : 0.002 * (std::min)(1., part));
  }

  // Each map is made for a number of quads of this ladder, which all numbers near it share: were
  // there a map for each, more quads might be made where fewer are wanted.
  static double number_on_ladder(const int rung) { return std::ldexp(5000., rung); }

  static int nearest_rung(const double number_of_quads)
  {
    return (std::max)(lowest_rung,
                      int(std::lround(std::log2(number_of_quads / number_on_ladder(0)))));
  }

  // Of opposite cones: there are quads between them at that number.
  double least_cone_distance(const int rung) const
  {
    const double area = area_in_squares(surface_mesh(), 1, CGAL::parameters::default_values());
    return 2 * std::sqrt(area / number_on_ladder(rung));
  }

  // Of the map for the wanted number. Where that has more quads, and features neither force these
  // nor are released, of other maps, too: four for fewer quads, and those for more that may have
  // less than are known already. Of few quads, those of maps with up to a quarter more than the
  // fewest, or the wanted number, are kept to choose from. Sizes that are given need all cones. Half
  // of the work is left for the shape of quads.
  bool quantize_a_map()
  {
    constexpr int most_lower = 4;
    const double number =
      m_options.quantization.is_coarsest ? 1 : m_options.quantization.number_of_quads;
    if(m_surface.has_sizes_that_vary() || !(number >= 1))
      return make_map(0) && quantize();
    const State start = state();
    const int wanted = nearest_rung(number);
    if(!make_map(least_cone_distance(wanted)) ||
       (!quantize() && m_report.status != Outcome::TOO_LARGE))
      return false;
    const bool may_choose = 0.95 * number <= most_to_choose && !m_surface.mirror() &&
                            !m_options.quantization.is_coarsest;
    State best = state();
    if(may_choose && m_quantization)
      m_choices.push_back(best);
    const auto least = [&] { return double(best.quantization.number_of_quads); };
    const auto may_try = [&](const int rung) {
      return least() > 1.1 * number && best.quantization.number_of_forced_quads == 0 &&
             best.report.number_of_released_edges == 0 && rung >= lowest_rung &&
             rung >= wanted - most_lower &&
             (rung <= wanted || 0.67 * number_on_ladder(rung) < least()) && // 0.95 / sqrt(2)
             m_work.is_half_left();
    };
    const auto try_map = [&](const double least_cone_distance) {
      set_state(start);
      if(!parametrize(least_cone_distance) || !m_report.remaining_flips.empty() || !quantize())
        return;
      const State tried = state();
      if(may_choose)
        m_choices.push_back(tried);
      if(double(m_quantization.number_of_quads) < least())
        best = tried;
    };
    for(int i = 1; may_try(wanted + i) || may_try(wanted - i); ++i)
      for(const int rung : {wanted + i, wanted - i})
        if(may_try(rung))
          try_map(least_cone_distance(rung));
    if(m_options.quantization.is_coarsest && best.report.number_of_released_edges == 0 &&
       m_work.is_half_left())
      try_map(0);
    set_state(best);
    keep_choices(least() <= most_to_choose ? 1.25 * (std::max)(number, least()) : 0.);
    return bool(m_quantization);
  }

  // Those with at most so many quads; of these, the fewest.
  void keep_choices(const double most_quads)
  {
    const auto number = [](const State& s) { return s.quantization.number_of_quads; };
    m_choices.erase(std::remove_if(m_choices.begin(), m_choices.end(), [&](const State& s)
                                   { return double(number(s)) > most_quads; }), m_choices.end());
    std::stable_sort(m_choices.begin(), m_choices.end(), [&](const State& a, const State& b)
                     { return number(a) < number(b); });
    if(m_choices.size() > most_choices)
      m_choices.erase(m_choices.begin() + most_choices, m_choices.end());
  }

  // What the steps up to a quantization change, but for the map.
  struct State
  {
    Remeshing_report report;
    Quantization quantization;
    std::vector<char> is_feature; // per edge
  };

  State state() const
  {
    State result{m_report, m_quantization, {}};
    for(const auto e : surface_mesh().edges())
      result.is_feature.push_back(m_surface.is_feature()[e]);
    return result;
  }

  // Times add up.
  void set_state(const State& state)
  {
    auto times = std::move(m_report.step_times);
    m_report = state.report;
    m_report.step_times = std::move(times);
    m_quantization = state.quantization;
    std::size_t i = 0;
    for(const auto e : surface_mesh().edges())
      m_surface.is_feature()[e] = bool(state.is_feature[i++]);
  }

  // Gives the quads of a choice a shape by `move(lines, smoother)`, and calls `measure(smoother)`.
  template <typename Move, typename Measure>
  void shape_choice(const State& choice, const Move& move, const Measure& measure)
  {
    set_state(choice);
    m_quads.clear_without_removing_property_maps();
    m_quads.set_recycle_garbage(false);
    if(!extract())
      return;
    Quad_smoother smoother(m_quads, surface_mesh());
    move(Feature_lines(m_surface), smoother);
    measure(smoother);
    m_work.spend(work_of(smoother));
    m_timer.finish("smoothing");
  }

  // Between features, few quads may have a bad shape where a few more have a good one: larger
  // numbers of the same map are choices, too.
  void add_larger_numbers()
  {
    constexpr double good_shape = 0.9; // a mean scaled Jacobian
    constexpr int most_steps = 5; // of a tenth
    if(m_choices.empty() || !has_features())
      return;
    const State first = m_choices.front();
    bool is_good = true;
    shape_choice(first,
                 [&](const Feature_lines& lines, Quad_smoother& smoother)
                 { shape(lines, smoother, rounds_to_choose); },
                 [&](const Quad_smoother& smoother)
                 { is_good = smoother.measure_shape().mean_scaled_jacobian >= good_shape; });
    Quantization_options options = m_options.quantization;
    options.maximum_feature_loss = 0; // the features that it lets go are released already
    const double number = (std::max)(options.number_of_quads,
                                     double(first.quantization.number_of_quads));
    for(int i = 1; !is_good && i <= most_steps && m_choices.size() < most_choices &&
                   m_work.is_left(); ++i) {
      options.number_of_quads = (1 + 0.1 * i) * number;
      State larger = first;
      larger.quantization = quantize_again(first.quantization, options);
      larger.quantization.released_features = first.quantization.released_features;
      if(larger.quantization && larger.quantization.number_of_quads >
                                  m_choices.back().quantization.number_of_quads)
        m_choices.push_back(larger);
    }
    m_timer.finish("quantization");
    set_state(first);
    m_quads.clear_without_removing_property_maps();
  }

  bool has_features() const
  {
    const auto edges = surface_mesh().edges();
    return std::any_of(edges.begin(), edges.end(),
                       [&](const auto e) { return m_surface.is_feature()[e]; });
  }

  // An exactly seamless map without flips: where none was found with few cones, with all of them.
  // No map of a torus has one cone of each sign alone, but cones cancel down to that.
  bool make_map(const double least_cone_distance)
  {
    if(!parametrize(least_cone_distance))
      return false;
    if(!m_report.remaining_flips.empty() && least_cone_distance > 0 && m_work.is_left()) {
      m_known_fields.clear(); // repairs try more with all cones, also where the field is the same
      if(!parametrize(0))
        return false;
    }
    return m_report.remaining_flips.empty() ||
           refuse(m_report, Outcome::NOT_POSITIVE,
                  name_of_faces(m_report.remaining_flips, "flipped in the parametrization") +
                    (sizes_vary() ? "; let vertex_sizing_map and curvature_adaptivity vary sizes "
                                    "less" : "") +
                    "; mark fewer features if there are any, or remesh the input there, or its "
                    "border, or leave out that part");
  }

  // An exactly seamless map, and what stays flipped in it.
  bool parametrize(const double least_cone_distance)
  {
    const auto made = approximate_seamless_parametrization(
      surface_mesh(), m_surface.uv_map(),
      features_and_transitions().align_border(true).release_alignment(true)
                                .curvature_alignment(curvature_alignment())
                                .curvature_adaptivity(m_options.curvature_adaptivity)
                                .face_direction_map(m_surface.directions())
                                .vertex_sizing_map(m_surface.sizes())
                                .number_of_untangling_iterations(untangling_iterations(500))
                                .largest_cone_index(largest_cone_index)
                                .least_cone_distance(least_cone_distance)
                                .known_fields(&m_known_fields));
    m_timer.finish("parametrization");
    if(!made)
      return refuse(m_report, made.status, with_face_of_input(made.message));
    constexpr double of_map = 8; // for each face
    count_iterations(of_map + double(made.number_of_untangling_iterations));
    move_map_from_origin();
    for(const auto& [v, w] : made.released_edges)
      release(surface_mesh().halfedge(v, w));
    m_report.number_of_flipped_faces = made.number_of_flipped_faces;
    // where untangling has left flips already, all cones are tried next
    const bool is_hopeless = made.number_of_flipped_faces > 0 && least_cone_distance > 0;
    const auto snapped =
      snap_to_seamless(surface_mesh(), m_surface.uv_map(),
                       features_and_transitions()
                         .align_border(true)
                         .number_of_untangling_iterations(untangling_iterations(400))
                         .repair_flips(is_hopeless ? Flip_repair::NEAR_BY
                                                   : Flip_repair::UNTANGLE));
    m_timer.finish("snapping");
    if(!snapped)
      return refuse(m_report, snapped);
    count_iterations(double(snapped.run.number_of_untangling_iterations));
    m_report.remaining_flips = snapped.remaining_flips;
    m_report.remaining_flips.insert(m_report.remaining_flips.end(), snapped.lost_faces.begin(),
                                    snapped.lost_faces.end());
    for(std::size_t& face : m_report.remaining_flips)
      face = m_surface.original(face);
    std::sort(m_report.remaining_flips.begin(), m_report.remaining_flips.end());
    m_report.remaining_flips.erase(
      std::unique(m_report.remaining_flips.begin(), m_report.remaining_flips.end()),
      m_report.remaining_flips.end());
    return true;
  }

  // The parametrization counts the faces of the copy.
  std::string with_face_of_input(std::string message) const
  {
    const std::string words = "a vertex of face ";
    const std::size_t begin = message.find(words) + words.size();
    if(message.find(words) == message.npos)
      return message;
    const std::size_t length = message.find_first_not_of("0123456789", begin) - begin;
    return message.replace(begin, length, std::to_string(m_surface.original(
                                            std::stoul(message.substr(begin, length)))));
  }

  // Over all faces: those that may be spent on one map.
  std::size_t untangling_iterations(const std::size_t most) const
  {
    const double left = (std::min)(m_work.left(), Work::most_work) /
                        double(surface_mesh().number_of_faces());
    return (std::min)(most, std::size_t(std::ceil(left)));
  }

  static double work_of(const Quad_smoother& smoother)
  {
    constexpr double of_search = 2;
    return of_search * double(smoother.number_of_searches());
  }

  bool has_work(const Quad_smoother& smoother) const
  { return m_work.is_left_for_shape(work_of(smoother)); }

  void count_iterations(const double iterations)
  { m_work.spend(iterations * double(surface_mesh().number_of_faces())); }

  // To where all coordinates have bits of the same size, but for one. Near the origin, translations
  // may have finer bits than integers of 64 bits can hold beside the largest coordinate.
  void move_map_from_origin()
  {
    double largest = 0;
    for(const auto h : surface_mesh().halfedges())
      for(const double x : {m_surface.uv_map()[h].x(), m_surface.uv_map()[h].y()})
        largest = (std::max)(largest, std::abs(x));
    const double distance = std::ldexp(1., std::ilogb(largest) + 2);
    for(const auto h : surface_mesh().halfedges())
      m_surface.uv_map()[h] = Surface_to_remesh::Kernel::Point_2(
        m_surface.uv_map()[h].x() + distance, m_surface.uv_map()[h].y() + distance);
  }

  bool quantize()
  {
    return take(quantize_map(surface_mesh(), m_surface.uv_map(), strip(features_and_transitions()),
                             m_options.quantization));
  }

  bool take(Quantization quantization)
  {
    m_quantization = std::move(quantization);
    m_timer.finish("quantization");
    m_report.number_of_forced_quads = m_quantization.number_of_forced_quads *
                                      (m_surface.mirror() ? 2 : 1);
    return m_quantization || refuse(m_report, m_quantization);
  }

  bool extract()
  {
    release_features(m_quantization.released_features);
    const Extraction_report extracted = extract_quad_mesh(
      m_quantization, surface_mesh(), m_quads, CGAL::parameters::default_values(),
      parameters::edge_is_constrained_map(m_is_feature));
    m_timer.finish("extraction");
    if(!extracted)
      return refuse(m_report, extracted);
    take_over(m_quantization);
    return true;
  }

  void take_over(const Quantization& quantization)
  {
    if(quantization.number_of_unaligned_border_edges > 0)
      Border_evener(m_quads, m_is_feature, surface_mesh()).run();
    m_report.message = quantization.message;
    if(m_surface.mirror() && !m_report.message.empty())
      m_report.message += ", for each half";
  }

  // Vertices stay on features and borders. Returns whether the quads are a mesh, also with their
  // mirror image where they are to have one.
  bool smooth()
  {
    m_quads.set_recycle_garbage(false); // so that each number is of one quad
    Quad_smoother smoother(m_quads, surface_mesh());
    Upper_sides upper_sides(m_quads, m_is_feature, m_surface, smoother);
    shape_and_improve(Feature_lines(m_surface), smoother);
    if(m_options.number_of_smoothing_rounds > 0 && !m_surface.mirror())
      mend(upper_sides, smoother);
    m_work.spend(work_of(smoother));
    m_timer.finish("smoothing");
    if(m_surface.mirror())
      m_quads.collect_garbage();
    std::vector<bool> is_folded; // the image has the same order
    for(const auto f : m_quads.faces())
      is_folded.push_back(upper_sides.is_folded(f));
    if(m_surface.mirror() && !Mirror_image(m_surface, m_quads, m_is_feature).add())
      return false;
    if(m_options.has_single_precision)
      change_points(rounded_to<float>);
    count();
    std::size_t i = 0;
    for(const auto f : m_quads.faces()) {
      const bool is_bad = is_folded[i % is_folded.size()] || is_inverted(smoother.quad(f));
      const bool is_thin = smoother.is_thin(f);
      if(is_bad)
        count_inverted_quad(i, m_report);
      m_report.number_of_thin_quads += is_thin;
      if(is_bad || is_thin)
        for(const auto v : CGAL::vertices_around_face(m_quads.halfedge(f), m_quads))
          (is_bad ? m_inverted_places : m_thin_places).push_back(m_quads.point(v));
      ++i;
    }
    const Quad_smoother::Shape shape = smoother.measure_shape();
    m_report.least_scaled_jacobian = shape.least_scaled_jacobian;
    m_report.mean_scaled_jacobian = shape.mean_scaled_jacobian;
    m_timer.finish("measurement");
    return true;
  }

  // All but what is left to mend. Where the work is spent, in as few rounds as there are.
  void shape_and_improve(const Feature_lines& lines, Quad_smoother& smoother)
  {
    shape(lines, smoother,
          m_work.is_left() ? shaping_rounds * m_options.number_of_smoothing_rounds : 1);
    if(m_options.number_of_smoothing_rounds > 0)
      improve(lines, smoother);
  }

  // Vertices move; see `Quad_smoother` and `Quad_shaper`.
  void shape(const Feature_lines& lines, Quad_smoother& smoother, const std::size_t most_rounds)
  {
    const auto is_held = [&](const Mesh::Vertex_index v)
    { return !lines_at_vertex(m_quads, m_is_feature, v).empty(); };
    if(m_options.number_of_smoothing_rounds > 0)
      smoother.unfold(is_held);
    smoother.smooth(m_options.number_of_smoothing_rounds, is_held);
    if(m_options.number_of_smoothing_rounds > 0)
      Quad_shaper(m_quads, m_is_feature, surface_mesh(), lines, smoother).run(most_rounds);
  }

  // Quads that are inverted or thin.
  void improve(const Feature_lines& lines, Quad_smoother& smoother)
  {
    Quad_improver improver(m_quads, m_is_feature, lines, smoother);
    improver.move_vertices();
    if(improver.remove_vertices_of_two_edges() > 0)
      improver.move_vertices();
    if(!has_work(smoother))
      return;
    improver.move_vertices_of_flat_quads();
    if(Quad_collapser(m_quads, m_is_feature, smoother, false).run() > 0) {
      improver.move_vertices();
      improver.move_vertices_of_flat_quads();
    }
    Quad_divider divider(m_quads, m_is_feature, smoother);
    for(int i = 0; i < 3 && has_work(smoother) && divider.run() > 0; ++i) {
      improver.move_vertices();
      improver.move_vertices_of_flat_quads();
    }
    improver.remove_vertices_of_two_edges(); // whose quads may be flat by now
  }

  // Not where there is to be a mirror image: vertices on the plane have to stay there.
  void mend(Upper_sides& upper_sides, Quad_smoother& smoother)
  {
    upper_sides.update(); // and after each step, which moves the places below
    if(m_options.has_single_precision)
      change_points(rounded_to<float>);
    Quad_mender mender(m_quads, m_is_feature, smoother, m_options.has_single_precision);
    mender.run(false);
    for(int i = 0; i < most_mending_rounds && has_work(smoother) && upper_sides.update() > 0;
        ++i) {
      Quad_collapser(m_quads, m_is_feature, smoother, m_options.has_single_precision).run();
      upper_sides.update();
      mender.run(true);
    }
    if(has_work(smoother))
      mender.relax([&] { return upper_sides.update(); });
    m_report.number_of_displaced_vertices = mender.number_of_displaced_vertices();
    m_report.largest_displacement = m_surface.unscaled(mender.largest_displacement());
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
    m_report.number_of_quads = m_quads.number_of_faces();
    m_report.number_of_vertices = m_quads.number_of_vertices();
    for(const auto v : m_quads.vertices())
      if(!m_quads.is_border(v) && m_quads.degree(v) != 4)
        ++m_report.number_of_irregular_vertices;
  }

  static constexpr int lowest_rung = -12; // of about one quad
  static constexpr double most_to_choose = 1000; // quads
  static constexpr std::size_t most_choices = 8, number_of_samples = 5000, rounds_to_choose = 4;
  static constexpr int most_mending_rounds = 4;
  static constexpr std::size_t shaping_rounds = 4; // for each of smoothing, at most
  static constexpr int largest_cone_index = 2; // no face graph has a vertex of one edge

  Surface_to_remesh& m_surface;
  Remeshing_options m_options;
  Mesh& m_quads;
  Feature_map m_is_feature;
  Remeshing_report m_report;
  Quantization m_quantization;
  std::set<std::vector<int> > m_known_fields; // of maps: other cone distances may give the same
  std::vector<State> m_choices; // quads are made of the best one
  Work& m_work;
  std::vector<Point> m_inverted_places; // the corners of quads that are inverted or upside down
  std::vector<Point> m_thin_places; // of others
  Step_timer m_timer;
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

// Makes quads once more, by `make(quads, is_feature)`, which take the place of those that there are
// if `is_better(report, best)`. The steps of both are reported, in their order.
template <typename Make, typename Is_better>
void make_others(const Make& make, const Is_better& is_better, Surface_to_remesh::Mesh& quads,
                 const Surface_to_remesh::Feature_map& is_feature, Remeshing_report& best)
{
  using Mesh = Surface_to_remesh::Mesh;
  Mesh mesh;
  const auto is_kept = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  Remeshing_report report = make(mesh, is_kept);
  std::vector<std::pair<std::string, double> > steps = best.step_times;
  steps.insert(steps.end(), report.step_times.begin(), report.step_times.end());
  if(is_better(report, best)) {
    replace_quads(mesh, is_kept, quads, is_feature);
    best = std::move(report);
  }
  best.step_times = std::move(steps);
}

// Compares results that may have released features.
class Is_better
{
public:
  explicit Is_better(const Surface_to_remesh& surface)
    : m_length_of_features(surface.length_of_features())
  { }

  bool operator()(const Remeshing_report& a, const Remeshing_report& b) const
    { return badness(a) < badness(b); }

private:
  std::tuple<bool, std::size_t, double> badness(const Remeshing_report& r) const
  {
    const double released =
      m_length_of_features > 0 ? r.length_of_released_edges / m_length_of_features : 0;
    return {!r, r.number_of_inverted_quads, released / 2 - r.mean_scaled_jacobian};
  }

  double m_length_of_features;
};

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Remeshing_report remesh(Surface_to_remesh& surface, const Remeshing_options& options,
                        Surface_to_remesh::Mesh& quads,
                        const Surface_to_remesh::Feature_map& is_feature)
{
  using Mesh = Surface_to_remesh::Mesh;
  const Is_better is_better(surface);
  const Work& work = *options.quantization.work;
  Remeshing_report before; // an attempt: what has been released
  constexpr double most_edges = 8, good_jacobian = 0.9;
  double edges = 1; // of quads, around the bad ones: features there are released next
  bool may_try_again = true;
  bool is_first = true;
  const auto is_bad = [&](const Remeshing_report& r) {
    const bool is_thin = is_first && r.mean_scaled_jacobian < good_jacobian &&
                         !options.quantization.is_coarsest &&
                         double(r.number_of_quads) < 1.1 * options.quantization.number_of_quads;
    return r && (r.number_of_inverted_quads > 0 || is_thin);
  };
  const auto attempt = [&](Mesh& mesh, const Surface_to_remesh::Feature_map& is_kept) {
    Quad_remesher remesher(surface, options, mesh, is_kept);
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
    is_first = false;
    make_others(attempt, is_better, quads, is_feature, best);
  }
  if(is_spent || !work.is_left())
    add_note(best, words_for_spent_work);
  return best;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Remeshing_report remesh_again(Surface_to_remesh& surface, const Remeshing_options& options,
                              const Remeshing_report& before, Surface_to_remesh::Mesh& quads,
                              const Surface_to_remesh::Feature_map& is_feature)
{
  Remeshing_report best = before;
  make_others([&](auto& mesh, const auto& is_kept)
              { return remesh(surface, options, mesh, is_kept); },
              Is_better(surface), quads, is_feature, best);
  return best;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Remeshing_report smooth(Surface_to_remesh& surface, const Quantization& quantization,
                        const Remeshing_options& options, Surface_to_remesh::Mesh& quads,
                        const Surface_to_remesh::Feature_map& is_feature)
{
  return Quad_remesher(surface, options, quads, is_feature).run_on_quads(quantization);
}

// The wanted length of an edge at a place.
inline double size_at(const Surface_to_remesh& input, const Space_vector& place,
                      const Quad_smoother& smoother)
{
  const auto& mesh = input.mesh();
  const auto face = smoother.nearest_face(place);
  const auto part = locate_in_face(Surface_to_remesh::Kernel::Point_3(place[0], place[1], place[2]),
                                   face, mesh, mesh.points()).second;
  const auto h = mesh.halfedge(face);
  return part[0] * input.sizes()[mesh.source(h)] + part[1] * input.sizes()[mesh.target(h)] +
         part[2] * input.sizes()[mesh.target(mesh.next(h))];
}

// \param unit of sizes; 0 where these are not known
inline void measure_edges(const Surface_to_remesh& input, const double unit,
                          const Surface_to_remesh::Mesh& quads, const Quad_smoother& smoother,
                          Remeshing_report& report)
{
  const bool sizes_vary = input.has_sizes_that_vary();
  std::vector<double> lengths, deviations;
  for(const auto e : quads.edges()) {
    const Space_vector p = smoother.point(quads.vertex(e, 0));
    const Space_vector q = smoother.point(quads.vertex(e, 1));
    lengths.push_back(norm(vector_to(p, q)));
    if(unit > 0) {
      const double size = sizes_vary ? size_at(input, between(p, q, 0.5), smoother)
                                     : *input.sizes().begin();
      const double ratio = lengths.back() / (unit * size);
      deviations.push_back((std::max)(ratio, 1 / ratio) - 1);
    }
  }
  std::sort(lengths.begin(), lengths.end());
  const std::size_t n = lengths.size();
  if(n > 0)
    report.edge_lengths = {input.unscaled(lengths[n / 10]), input.unscaled(lengths[n / 2]),
                           input.unscaled(lengths[n - 1 - n / 10])};
  if(!deviations.empty()) {
    std::nth_element(deviations.begin(), deviations.begin() + std::ptrdiff_t(n / 2),
                     deviations.end());
    report.median_size_deviation = deviations[n / 2];
  }
}

inline Nearest_faces nearest_faces(const Surface_to_remesh& input,
                                   const Surface_to_remesh::Mesh& quads,
                                   const Located_elements located, const Quad_smoother& smoother)
{
  const auto number = [&](const Space_vector& place, const Space_vector& side)
    { return input.original(smoother.nearest_face(place, side)); };
  Nearest_faces result;
  if(located.vertices) {
    const auto visit = [](const auto&...) { };
    result.of_vertices.resize(quads.num_vertices());
    for(const auto v : quads.vertices())
      result.of_vertices[v] = number(smoother.point(v), smoother.visit_star(v, visit).normal);
  }
  if(located.faces) {
    result.of_faces.resize(quads.num_faces());
    for(const auto f : quads.faces())
      result.of_faces[f] = number(place_of(middle(quads, f)), quad_normal(smoother.quad(f)));
  }
  return result;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Nearest_faces measure_quads(const Surface_to_remesh& input, const double number_wanted,
                            Surface_to_remesh::Mesh quads, const Located_elements located,
                            Remeshing_report& report)
{
  for(auto& p : quads.points())
    p = {input.scaled(p.x()), input.scaled(p.y()), input.scaled(p.z())};
  const Quad_smoother smoother(quads, input.mesh());
  const std::size_t number = (std::max)(20000u, input.mesh().number_of_faces());
  const Surface_samples samples(input.mesh(), number);
  report.largest_distance = input.unscaled(smoother.measure_distance());
  report.largest_distance_of_input = input.unscaled(samples.largest_distance(quads));
  const double unit = number_wanted > 0
    ? std::sqrt(area_in_squares(input) / number_wanted) : 0;
  measure_edges(input, unit, quads, smoother, report);
  return nearest_faces(input, quads, located, smoother);
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUAD_REMESH_IMPL_H
