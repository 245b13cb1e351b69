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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_MAP_QUANTIZER_H
#define CGAL_QUAD_REMESHING_INTERNAL_MAP_QUANTIZER_H

#include <CGAL/license/Quad_remeshing.h>

// From a surface to the best quantizations of its maps.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/approximate_seamless_parametrization.h>
#include <CGAL/Quad_remeshing/internal/Remeshing_run.h>
#include <CGAL/Quad_remeshing/internal/largest_number_of_quads.h>
#include <CGAL/Quad_remeshing/internal/quantization/move_from_origin.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Makes maps of a surface, and integers for them.
class Map_quantizer
{
  using State = Remeshing_run::State;

public:
  explicit Map_quantizer(Remeshing_run& run) : m_run(run) { }

  static constexpr std::size_t few = 1000; // quads, of which several maps and numbers are compared

  // Whether the wanted quads, and those that were found, are so few that there are several
  // quantizations, and much larger ones, to choose.
  bool are_few(const std::size_t found) const
  {
    return number() <= double(few) && found <= few && !m_run.surface.mirror() &&
           !m_run.options.quantization.is_coarsest;
  }

  // Quantizes the map for the wanted number. If the result has more quads, and features neither
  // force them nor are released, also maps for more quads that may have fewer than the best result.
  // If quads are few, maps with up to a quarter more quads than the fewest, or than the wanted
  // number, are results, too. Given sizes need all cones. Half of the work is left for the shape of
  // quads. Returns the quantizations, the fewest quads first.
  std::vector<State> run()
  {
    std::vector<State> result;
    if(m_run.surface.has_sizes_that_vary() || !(number() >= 1)) {
      if(make_map(0) && quantize())
        result.push_back(m_run.state());
      return result;
    }
    const State start = m_run.state();
    const int wanted = nearest_rung(number());
    if(!make_map(least_cone_distance(wanted)) ||
       (!quantize() && m_run.report.status != Outcome::TOO_LARGE))
      return result;
    State best = m_run.state();
    if(m_run.quantization)
      result.push_back(best);
    const auto least = [&] { return double(best.quantization.number_of_quads); };
    const auto may_try = [&](const int rung) {
      return least() > about_as_many * number() && best.quantization.number_of_forced_quads == 0 &&
             best.report.number_of_released_edges == 0 &&
             0.67 * number_on_ladder(rung) < least() && // 0.95 / sqrt(2)
             m_run.work.is_half_left();
    };
    const auto try_map = [&](const double least_cone_distance) {
      m_run.set_state(start);
      if(!parametrize(least_cone_distance) || !m_run.report.remaining_flips.empty() ||
         !quantize())
        return;
      result.push_back(m_run.state());
      if(double(m_run.quantization.number_of_quads) < least())
        best = result.back();
    };
    for(int rung = wanted + 1; may_try(rung); ++rung)
      try_map(least_cone_distance(rung));
    if(m_run.options.quantization.is_coarsest && best.report.number_of_released_edges == 0 &&
       m_run.work.is_half_left())
      try_map(0);
    keep_few(result, are_few(best.quantization.number_of_quads)
                       ? 1.25 * (std::max)(number(), least()) : least());
    if(result.empty())
      m_run.set_state(std::move(best));
    return result;
  }

  // So many times the quads of a quantization, of the same map. They stay below the largest number
  // that is a success, unless the quantization does not.
  State larger(State state, const double factor) const
  {
    Quantization_options options = m_run.options.quantization;
    options.maximum_feature_loss = 0; // the features that it lets go are released already
    const double least = (std::max)(number(), double(state.quantization.number_of_quads));
    const double most = largest_number_of_quads(m_run.mesh(), number(),
                                                state.quantization.number_of_forced_quads);
    options.number_of_quads = factor * least;
    auto released = std::move(state.quantization.released_features);
    state.quantization = quantize_again(state.quantization, options);
    state.quantization.released_features = std::move(released);
    if(double(state.quantization.number_of_quads) > most && least <= most)
      state.quantization = Quantization();
    return state;
  }

private:
  double number() const
  {
    return m_run.options.quantization.is_coarsest ? 1 : m_run.options.quantization.number_of_quads;
  }

  bool sizes_vary() const
  { return m_run.options.curvature_adaptivity > 1 || m_run.surface.has_sizes_that_vary(); }

  // By default, so little that it hardly matters where the surface curves alike in all directions,
  // or without order; but over some tens of faces, edges and round parts direct the field. Faces
  // that are twice as small are followed over twice as many from a number on: a surface that is
  // given more finely has the same field.
  double curvature_alignment() const
  {
    constexpr double most_faces = 50000; // more faces follow the curvature less
    const double part = most_faces / double(m_run.mesh().number_of_faces());
    return m_run.options.curvature_alignment.value_or(
      sizes_vary() ? 0. : 0.002 * (std::min)(1., part));
  }

  // Each map is made for a number of quads of this ladder, which all numbers near it share: were
  // there a map for each, more quads might be made where fewer are wanted.
  static double number_on_ladder(const int rung) { return std::ldexp(5000., rung); }

  static int nearest_rung(const double number_of_quads)
  {
    return (std::max)(lowest_rung,
                      int(std::lround(std::log2(number_of_quads / number_on_ladder(0)))));
  }

  // The least distance of opposite cones: at that number, there are quads between them.
  double least_cone_distance(const int rung) const
  { return 2 * std::sqrt(m_run.area() / number_on_ladder(rung)); }

  // Keeps the states with at most so many quads, the fewest first.
  static void keep_few(std::vector<State>& states, const double most_quads)
  {
    const auto number = [](const State& s) { return s.quantization.number_of_quads; };
    states.erase(std::remove_if(states.begin(), states.end(), [&](const State& s)
                                { return double(number(s)) > most_quads; }), states.end());
    std::stable_sort(states.begin(), states.end(), [&](const State& a, const State& b)
                     { return number(a) < number(b); });
  }

  // An exactly seamless map without flips: where none was found with few cones, with all of them.
  // No map of a torus has one cone of each sign alone, but cones cancel down to that.
  bool make_map(const double least_cone_distance)
  {
    if(!parametrize(least_cone_distance))
      return false;
    if(!m_run.report.remaining_flips.empty() && least_cone_distance > 0 && m_run.work.is_left()) {
      m_known_fields.clear(); // repairs try more with all cones, also where the field is the same
      if(!parametrize(0))
        return false;
    }
    return m_run.report.remaining_flips.empty() ||
           refuse(m_run.report, Outcome::NOT_POSITIVE,
                  name_of_faces(m_run.report.remaining_flips, "flipped in the parametrization") +
                    (sizes_vary() ? remedy("let vertex_sizing_map and curvature_adaptivity vary "
                                           "sizes less") : Message()) +
                    remedy(std::string(has_features() ? "mark fewer features, or " : "") +
                           "remesh the input there" + (has_border() ? ", or its border" : "") +
                           ", or leave out that part"));
  }

  // Also if all of them are released by now.
  bool has_features() const
  {
    return m_run.report.number_of_released_edges > 0 || m_run.surface.length_of_features() > 0;
  }

  bool has_border() const
  {
    const auto halfedges = m_run.mesh().halfedges();
    return std::any_of(halfedges.begin(), halfedges.end(),
                       [&](const auto h) { return m_run.mesh().is_border(h); });
  }

  // An exactly seamless map, and what stays flipped in it.
  bool parametrize(const double least_cone_distance)
  {
    const auto made = approximate_seamless_parametrization(
      m_run.mesh(), m_run.surface.uv_map(),
      m_run.features_and_transitions()
        .align_border(true).release_alignment(true)
        .vertex_point_map(m_run.surface.points_of_map())
        .curvature_alignment(curvature_alignment())
        .curvature_adaptivity(m_run.options.curvature_adaptivity)
        .face_direction_map(m_run.surface.directions()).vertex_sizing_map(m_run.surface.sizes())
        .number_of_untangling_iterations(untangling_iterations(500))
        .largest_cone_index(largest_cone_index).least_cone_distance(least_cone_distance)
        .known_fields(&m_known_fields));
    m_run.timer.finish("parametrization");
    if(!made) {
      Message message = made.message; // which counts the faces of the copy
      message.renumber(Message::FACE, [&](const std::size_t f)
                       { return m_run.surface.original(f); });
      return refuse(m_run.report, made.status, message);
    }
    constexpr double of_map = 8; // the work of a map, for each face
    count_iterations(of_map + double(made.number_of_untangling_iterations));
    move_from_origin(m_run.mesh(), m_run.surface.uv_map());
    for(const auto& [v, w] : made.released_edges)
      m_run.release(m_run.mesh().halfedge(v, w));
    m_run.report.number_of_flipped_faces = made.number_of_flipped_faces;
    // where untangling has left flips already, all cones are tried next
    const bool is_hopeless = made.number_of_flipped_faces > 0 && least_cone_distance > 0;
    const auto snapped =
      snap_to_seamless(m_run.mesh(), m_run.surface.uv_map(),
                       m_run.features_and_transitions()
                         .align_border(true)
                         .number_of_untangling_iterations(untangling_iterations(400))
                         .repair_flips(is_hopeless ? Flip_repair::NEAR_BY
                                                   : Flip_repair::UNTANGLE));
    m_run.timer.finish("snapping");
    if(!snapped)
      return refuse(m_run.report, snapped);
    count_iterations(double(snapped.run.number_of_untangling_iterations));
    std::vector<std::size_t>& flips = m_run.report.remaining_flips;
    flips = snapped.remaining_flips;
    flips.insert(flips.end(), snapped.lost_faces.begin(), snapped.lost_faces.end());
    for(std::size_t& face : flips)
      face = m_run.surface.original(face);
    std::sort(flips.begin(), flips.end());
    flips.erase(std::unique(flips.begin(), flips.end()), flips.end());
    return true;
  }

  // The iterations over all faces that may be spent on one map.
  std::size_t untangling_iterations(const std::size_t most) const
  {
    const double left = (std::min)(m_run.work.left(), Work::most_work) /
                        double(m_run.mesh().number_of_faces());
    return (std::min)(most, std::size_t(std::ceil(left)));
  }

  void count_iterations(const double iterations)
  { m_run.work.spend(iterations * double(m_run.mesh().number_of_faces())); }

  bool quantize()
  {
    return m_run.take(quantize_map(m_run.mesh(), m_run.surface.uv_map(),
                                   strip(m_run.features_and_transitions()),
                                   m_run.options.quantization));
  }

  static constexpr int lowest_rung = -12; // the rung of about one quad
  static constexpr int largest_cone_index = 2; // no face graph has a vertex of one edge

  Remeshing_run& m_run;
  std::set<std::vector<int> > m_known_fields; // of maps: other cone distances may give the same
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_MAP_QUANTIZER_H
