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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUAD_SEARCH_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUAD_SEARCH_H

#include <CGAL/license/Quad_remeshing.h>

// The search for quads: which surfaces and numbers are tried, and which result is the best one.

#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/Map_quantizer.h>
#include <CGAL/Quad_remeshing/internal/Quad_remesher.h>
#include <CGAL/Quad_remeshing/internal/check_input.h>
#include <CGAL/Quad_remeshing/internal/largest_number_of_quads.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// What the best result lacks tells which moves are tried, in the order of their table. A move makes
// a candidate, of which quads are made as long as features are released near what is bad.
class Quad_search
  : private Remeshing_types
{
  enum class Room { NONE, IN_LONG_TRIANGLES, IN_ALL_TRIANGLES }; // by dividing these

  struct Move
  {
    const char* choice;                // in words
    bool (Quad_search::*mends)() const; // whether the best result asks for it
    Room room;
    bool has_straight_border;
    std::optional<double> part; // of the way to the largest number of quads; else as many as wanted
    bool is_slightly_larger = false;
  };

  static constexpr std::array<Move, 9> moves()
  {
    using S = Quad_search;
    const Room room = Room::IN_LONG_TRIANGLES;
    return {{
      {"room in long triangles", &S::is_missing, room, true, {}},
      {"room in all triangles", &S::has_flaws, Room::IN_ALL_TRIANGLES, true, {}},
      {"the border as it is", &S::has_flaws_at_border, room, false, {}},
      {"slightly more quads", &S::has_many_and_some_bad, room, true, {}, true},
      {"the best of several maps", &S::is_coarse_and_bad, room, true, 0.},
      {"some more quads", &S::has_few_and_bad, room, true, 0.3},
      {"more quads", &S::has_few_and_bad, room, true, 0.6},
      {"nearly as many quads as may be", &S::has_few_and_bad, room, true, 1.},
      {"the input as it is", &S::has_no_quads, Room::NONE, false, {}}
    }};
  }

  // A surface to make quads of, and how.
  struct Candidate
  {
    Candidate(const Marked_surface& input, const std::optional<Mirror>& mirror,
              const Remeshing_options& options)
      : surface(input, mirror), run(surface, options)
    { }

    Surface_to_remesh surface; // features are released
    Remeshing_run run;
    std::optional<Surface_locator> locator; // made once it is needed
    std::optional<Remeshing_report> result; // the best one since the last release
    std::vector<Point> flaws;               // of the result
    double radius = 1;                      // edges of quads; features so near are released next
  };

public:
  Quad_search(const Marked_surface& input, const std::optional<Mirror>& mirror,
              const Remeshing_options& options, Mesh& quads, const Feature_map& is_feature)
    : m_input(input), m_mirror(mirror), m_options(options), m_quads(quads),
      m_is_feature(is_feature)
  {
    const CGAL::Bbox_3 box = CGAL::bbox_3(input.mesh.points().begin(), input.mesh.points().end());
    m_diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
  }

  Remeshing_report run()
  {
    for(const Move& move : moves())
      if((this->*move.mends)())
        run(move);
    if(m_fewest)
      tell_of_fewest();
    if(m_is_spent || !work().is_left())
      add_note(*m_best, words_for_spent_work);
    m_best->step_times = std::move(m_step_times);
    return *m_best;
  }

private:
  const Work& work() const { return *m_options.quantization.work; }

  bool is_missing() const { return !m_best; }

  bool has_flaws() const
  {
    constexpr double good_shape = 0.95; // a mean scaled Jacobian
    return work().is_mostly_left() &&
           (!*m_best || m_best->number_of_released_edges > 0 ||
            m_best->number_of_bad_quads() > 0 || m_best->number_of_displaced_vertices > 0 ||
            m_best->mean_scaled_jacobian < good_shape);
  }

  bool has_flaws_at_border() const
  {
    return work().is_mostly_left() && *m_best && m_best->number_of_corners_left_out > 0 &&
           (m_best->number_of_bad_quads() > 0 || m_best->number_of_displaced_vertices > 0 ||
            m_best->mean_scaled_jacobian < fair_shape);
  }

  // More quads may have room around cones and between features.
  bool has_few_and_bad() const
  {
    return work().is_left() && *m_best && m_best->number_of_bad_quads() > 0 &&
           m_best->number_of_quads <= Map_quantizer::few;
  }

  // Other quads of the same map may have nothing bad.
  bool has_many_and_some_bad() const
  {
    constexpr double some = 0.005; // of the quads; more have another reason than chance
    return work().is_left() && *m_best && !m_mirror && !m_options.quantization.is_coarsest &&
           m_best->number_of_bad_quads() > 0 && m_best->number_of_quads > Map_quantizer::few &&
           double(m_best->number_of_bad_quads()) <= some * double(m_best->number_of_quads);
  }

  // For few quads, the map is chosen by their shape; for as few as can be, by their number.
  bool is_coarse_and_bad() const
  { return m_options.quantization.is_coarsest && has_few_and_bad(); }

  bool has_no_quads() const { return work().is_left() && !*m_best && m_is_changed; }

  void run(const Move& move)
  {
    Candidate candidate(m_input, m_mirror, m_options);
    const bool is_divided = move.room != Room::NONE &&
                            candidate.surface.refine(move.room == Room::IN_LONG_TRIANGLES);
    const std::size_t number_of_faces = candidate.surface.mesh().number_of_faces();
    if(move.room == Room::IN_ALL_TRIANGLES && number_of_faces <= m_number_of_faces)
      return;
    if(move.part) {
      Quantization_options& options = candidate.run.options.quantization;
      options.is_coarsest = false;
      options.number_of_quads = number_of_quads(*move.part);
    }
    if(move.has_straight_border)
      candidate.surface.straighten_border(border_tolerance(candidate));
    if(!m_best) {
      m_number_of_faces = number_of_faces;
      m_length_of_features = candidate.surface.length_of_features();
      m_is_changed = is_divided || candidate.surface.number_of_corners_left_out() > 0;
    } else
      Progress::tell([&] { return std::string("again, with ") + move.choice; });
    const double work_before = work().left();
    if(!has_valid_input(candidate.run)) {
      compare(candidate.run.report);
      return;
    }
    if(m_mirror) { // one half has half of the quads
      Quantization_options& options = candidate.run.options.quantization;
      options.number_of_quads = (std::max)(1., options.number_of_quads / 2);
      options.maximum_number /= 2;
    }
    if(move.is_slightly_larger) {
      make_slightly_more(candidate);
      return;
    }
    make_all(candidate);
    const double work_of_attempt = work_before - work().left();
    bool helps = true; // the last release
    while(is_to_release(*candidate.result, helps) && is_to_release(*m_best, helps) &&
          release_features(candidate)) {
      if(work().left() < work_of_attempt / 4) {
        m_is_spent = true;
        return;
      }
      const auto before = badness(*m_best);
      make_all(candidate);
      helps = badness(*m_best) < before;
    }
  }

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

  // By default, half of an edge of the quads, where these are to be of one size.
  static double border_tolerance(const Candidate& candidate)
  {
    const Surface_to_remesh& surface = candidate.surface;
    const double number = candidate.run.options.number_wanted() / (surface.mirror() ? 2 : 1);
    const double length = number > 0 && !surface.has_sizes_that_vary()
      ? surface.unscaled(std::sqrt(area_in_squares(surface) / number)) : 0;
    return candidate.run.options.border_tolerance.value_or(length / 2);
  }

  // Quads of the candidate's quantizations. If the first ones are the best so far, and as long as
  // the best ones have a bad shape, others are made, and larger numbers of the same map if few.
  void make_all(Candidate& candidate)
  {
    constexpr double step = 0.1; // a part of few quads, to the next number
    reset_report(candidate);
    Map_quantizer quantizer(candidate.run);
    std::vector<Remeshing_run::State> states = quantizer.run();
    candidate.result.reset();
    if(states.empty()) {
      compare(candidate.run.report);
      candidate.result = candidate.run.report;
      return;
    }
    const Remeshing_run::State fewest = states.front();
    const std::size_t most = states.back().quantization.number_of_quads;
    if(!make(candidate, std::move(states.front())))
      return;
    for(std::size_t i = 1; i < states.size() && is_to_choose(); ++i)
      make(candidate, std::move(states[i]));
    if(quantizer.are_few(fewest.quantization.number_of_quads))
      make_larger(candidate, quantizer, fewest, most, step, &Quad_search::is_to_choose);
  }

  // Quads of slightly larger numbers only, because the candidate's own quantizations are known.
  void make_slightly_more(Candidate& candidate)
  {
    constexpr double step = 0.02; // a part of many quads, to the next number
    reset_report(candidate);
    Map_quantizer quantizer(candidate.run);
    const std::vector<Remeshing_run::State> states = quantizer.run();
    if(!states.empty())
      make_larger(candidate, quantizer, states.front(),
                  states.back().quantization.number_of_quads, step,
                  &Quad_search::has_many_and_some_bad);
  }

  // Quads of larger numbers, as long as the best ones ask for them.
  // \param fewest the smallest number of the candidate's map
  // \param most quads that are known
  void make_larger(Candidate& candidate, Map_quantizer& quantizer,
                   const Remeshing_run::State& fewest, std::size_t most, const double step,
                   bool (Quad_search::*is_to_enlarge)() const)
  {
    constexpr int most_steps = 5; // to larger numbers
    for(int i = 1; i <= most_steps && (this->*is_to_enlarge)(); ++i) {
      Remeshing_run::State larger = quantizer.larger(fewest, 1 + step * i);
      candidate.run.timer.finish("quantization");
      if(larger.quantization && larger.quantization.number_of_quads > most) {
        most = larger.quantization.number_of_quads;
        make(candidate, std::move(larger));
      }
    }
  }

  // The report as it is before there are quads.
  static void reset_report(Candidate& candidate)
  {
    Remeshing_report& report = candidate.run.report;
    Remeshing_report result;
    result.number_of_released_edges = report.number_of_released_edges;
    result.length_of_released_edges = report.length_of_released_edges;
    result.number_of_corners_left_out = candidate.surface.number_of_corners_left_out();
    report = result;
  }

  // Whether the best quads ask for others of the same surface. As few as can be may have any shape.
  bool is_to_choose() const
  {
    return work().is_left() &&
           (!*m_best || m_best->number_of_bad_quads() > 0 ||
            (!m_options.quantization.is_coarsest && is_distorted(*m_best)));
  }

  // Returns whether the quads of the state become the best ones.
  bool make(Candidate& candidate, Remeshing_run::State state)
  {
    Progress::tell([&] {
      return "the shape of " + counted(state.quantization.number_of_quads, "quad");
    });
    candidate.run.set_state(std::move(state));
    Mesh quads;
    const auto is_feature = quads.add_property_map<Edge, bool>("e:is_feature", false).first;
    Quad_remesher remesher(candidate.run, candidate.locator, quads, is_feature);
    remesher.run();
    Remeshing_report& result = candidate.run.report;
    const bool is_best = compare(result);
    if(is_best)
      take(quads, is_feature);
    if(!candidate.result || badness(result) < badness(*candidate.result)) {
      candidate.result = result;
      candidate.flaws = remesher.places_of_flaws();
    }
    return is_best;
  }

  // Whether the result becomes the best one.
  bool compare(Remeshing_report& result)
  {
    result.has_too_many_quads = has_too_many_quads(result);
    m_step_times.insert(m_step_times.end(), result.step_times.begin(), result.step_times.end());
    result.step_times.clear();
    if(result && (!m_fewest || result.number_of_quads < m_fewest->number_of_quads))
      m_fewest = result;
    if(m_best && !(badness(result) < badness(*m_best)))
      return false;
    m_best = result;
    return true;
  }

  // If the best quads are more than wanted, although fewer were found.
  void tell_of_fewest()
  {
    Remeshing_report& best = *m_best;
    const std::size_t fewest = m_fewest->number_of_quads;
    if(!best || best.number_of_quads <= fewest || !has_more_than_wanted(best))
      return;
    best.message = m_fewest->message; // which tells why there are so many
    add_note(best, counted(fewest, "quad") + " were found, too, " +
             (m_fewest->number_of_bad_quads() > 0
                ? std::to_string(m_fewest->number_of_bad_quads()) + " of them inverted or folded"
                : "but in a worse shape or farther from the surface, with a mean scaled Jacobian "
                  "of " + short_number(m_fewest->mean_scaled_jacobian)) +
             (m_options.quantization.is_coarsest ? "" :
                remedy("minimize_number_of_quads(true) makes as few as are found")));
  }

  void take(const Mesh& quads, const Feature_map& is_feature)
  {
    m_quads.clear_without_removing_property_maps();
    const auto write = [&](const auto& halfedges) {
      m_is_feature[m_quads.edge(halfedges.second)] = is_feature[quads.edge(halfedges.first)];
    };
    CGAL::copy_face_graph(quads, m_quads,
                          CGAL::parameters::halfedge_to_halfedge_output_iterator(
                            boost::make_function_output_iterator(write)));
  }

  bool has_too_many_quads(const Remeshing_report& r) const
  {
    const Quantization_options& wanted = m_options.quantization;
    const auto& parts = r.parts_of_other_size;
    const double number = double(r.number_of_quads);
    return r && !wanted.is_coarsest &&
           ((number > 2 * wanted.number_of_quads && // else the topology does not matter
             number > largest_number_of_quads(m_input.mesh, wanted.number_of_quads,
                                              r.number_of_forced_quads)) ||
            std::any_of(parts.begin(), parts.end(), [](const Part_of_other_size& part)
                        { return part.has_too_many_quads; }));
  }

  // A success comes first, and few bad quads; then quads near rectangles and to the surface, not
  // more than wanted, of the wanted size, along all features.
  std::tuple<bool, bool, std::size_t, double> badness(const Remeshing_report& r) const
  {
    const bool is_coarsest = m_options.quantization.is_coarsest;
    const double released =
      m_length_of_features > 0 ? r.length_of_released_edges / m_length_of_features : 0;
    const double deviation = std::clamp(r.median_size_deviation.value_or(0), good_deviation,
                                        forced_deviation);
    const double number = (std::max)(double(r.number_of_quads),
                                     is_coarsest ? 1 : m_options.quantization.number_of_quads);
    const double score = r.mean_scaled_jacobian - (released + deviation) / 2 -
                         (is_coarsest ? 1 : price_of_number) * std::log(number) -
                         2 * r.largest_distance / m_diagonal;
    const bool is_success = r && r.number_of_bad_quads() == 0 && !r.has_too_many_quads;
    return {!r, !is_success, r.number_of_bad_quads(), -score};
  }

  bool has_more_than_wanted(const Remeshing_report& r) const
  {
    return m_options.quantization.is_coarsest ||
           double(r.number_of_quads) >= about_as_many * m_options.quantization.number_of_quads;
  }

  // Where more quads than wanted are forced, they have less room for their shape.
  bool is_distorted(const Remeshing_report& r) const
  {
    constexpr double forced_shape = 0.8; // a mean scaled Jacobian where more are forced
    return r.mean_scaled_jacobian < (has_more_than_wanted(r) ? forced_shape : fair_shape);
  }

  // Whether quads may be better without features at the flaws of the result.
  // \param helps whether the last release has made the best result better
  bool is_to_release(const Remeshing_report& r, const bool helps) const
  {
    const bool has_other_sizes = r.median_size_deviation.value_or(0) > good_deviation &&
                                 !has_more_than_wanted(r);
    return r && (r.number_of_bad_quads() > 0 || r.has_too_many_quads ||
                 (helps && (has_other_sizes || is_distorted(r))));
  }

  // Near the flaws of the result, in a circle that grows until there are features in it. Returns
  // whether there are any.
  static bool release_features(Candidate& candidate)
  {
    constexpr double largest_radius = 8; // edges of quads
    Surface_to_remesh& surface = candidate.surface;
    const Mesh& mesh = surface.mesh();
    Remeshing_report& result = candidate.run.report;
    const double length = std::sqrt(area_in_squares(mesh, 1, CGAL::parameters::default_values()) /
                                    double(candidate.result->number_of_quads));
    const std::size_t before = result.number_of_released_edges;
    for(; candidate.radius <= largest_radius && result.number_of_released_edges == before;
        candidate.radius *= 2) {
      const double radius = candidate.radius * length;
      for(const Edge e : mesh.edges()) {
        const Halfedge h = mesh.halfedge(e);
        const Kernel::Segment_3 s(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
        if(surface.is_feature()[e] &&
           std::any_of(candidate.flaws.begin(), candidate.flaws.end(), [&](const Point& p)
                       { return CGAL::squared_distance(p, s) < radius * radius; }))
          release(h, surface, result);
      }
    }
    const std::size_t number = result.number_of_released_edges - before;
    if(number > 0)
      Progress::tell([&] {
        return counted(candidate.flaws.size() / 4, candidate.result->number_of_bad_quads() > 0
                                                     ? "folded or inverted quad" : "thin quad") +
               "; again without " + counted(number, "feature edge") + " near by";
      });
    return number > 0;
  }

  static constexpr double price_of_number = 0.3; // in mean scaled Jacobians, of e times as many
  static constexpr double fair_shape = 0.9; // a mean scaled Jacobian
  // By which the median edge differs from its wanted length: less matters less than shape, and more
  // than the second one is forced, as where very few quads are wanted.
  static constexpr double good_deviation = 0.5, forced_deviation = 1.5; // parts of the wanted edge

  const Marked_surface& m_input;
  const std::optional<Mirror>& m_mirror;
  const Remeshing_options& m_options;
  Mesh& m_quads;
  Feature_map m_is_feature;
  std::optional<Remeshing_report> m_best;
  std::optional<Remeshing_report> m_fewest; // of all results, the one with the fewest quads
  std::vector<std::pair<std::string, double> > m_step_times;
  double m_diagonal;                 // of the input's box
  double m_length_of_features = 0;   // of the first surface, before any are released
  std::size_t m_number_of_faces = 0; // of the first surface
  bool m_is_changed = false; // the first surface is not the input as it is
  bool m_is_spent = false;   // the work, before all features could be released
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUAD_SEARCH_H
