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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUANTIZE_SURFACE_IMPL_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUANTIZE_SURFACE_IMPL_H

#include <CGAL/license/Quad_remeshing.h>

// From a chart mesh to its quantization, step by step, with all checks. Nothing here depends on the
// mesh data structure.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/quantization/Integer_mesh.h>
#include <CGAL/Quad_remeshing/internal/quantization/Part_quantizer.h>
#include <CGAL/Quad_remeshing/internal/quantization/Wall_slider.h>
#include <CGAL/Quad_remeshing/internal/quantization/coarsen.h>
#include <CGAL/Quad_remeshing/internal/quantization/move_from_origin.h>
#include <CGAL/Quad_remeshing/internal/quantization/quads_needed.h>
#include <CGAL/Quad_remeshing/internal/quantization/quantize_complex.h>
#include <CGAL/Quad_remeshing/internal/quantization/quantize_surface.h>
#include <CGAL/Quad_remeshing/internal/quantization/release_features.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

inline bool check_options(const Quantization_options& options, Report& report)
{
  const double largest = (std::min)(std::ldexp(1., 28), options.maximum_number);
  if(!(options.maximum_feature_loss >= 0 && options.maximum_feature_loss <= 1))
    return refuse(report, Outcome::INVALID_ARGUMENT,
                  term("maximum_feature_loss") + " must be at least 0 and at most 1");
  return options.is_coarsest ||
         (options.number_of_quads >= 1 && options.number_of_quads <= largest) ||
         refuse(report, Outcome::INVALID_ARGUMENT,
                "the target is " + (std::isnan(options.number_of_quads)
                                      ? "no number of" : short_number(options.number_of_quads)) +
                  " quads" +
                  remedy("it must be at least 1 and at most 2^28, and at most maximum_number; see "
                         "target_number_of_quads and target_edge_length"));
}

class Surface_coarsener
{
public:
  // \param result tells why there is no coarse surface
  Surface_coarsener(const Chart_mesh& mesh, const std::vector<char>& is_feature,
                    const std::function<Message(std::size_t)>& vertex_name,
                    Quantization& result)
    : m_mesh(mesh), m_is_feature(is_feature), m_vertex_name(vertex_name), m_result(result)
  { }

  bool run(Coarse_surface& surface)
  {
    if(!check_faces() || !read_integers(surface.input) || !add_border_steps(surface))
      return false;
    surface.complex = make_coarse_complex(surface.input);
    m_result.number_of_coarse_vertices = surface.complex.number_of_vertices();
    m_result.number_of_coarse_faces = std::size_t(surface.complex.number_of_faces());
    return true;
  }

private:
  bool check_faces()
  {
    m_result.nonpositive_faces = nonpositive_faces(m_mesh);
    return are_positive(m_mesh, m_result.nonpositive_faces, m_result);
  }

  bool read_integers(Integer_mesh& input)
  {
    Integer_reader reader(m_mesh, m_is_feature);
    if(!reader.read(input))
      return refuse(m_result, Outcome::TOO_LARGE,
                  "the coordinates around " + m_vertex_name(reader.unrepresentable_vertex) +
                    " have more bits than integers of 64 bits can hold beside the largest "
                    "coordinate" +
                    remedy("add twice the largest one to all, and snap the map by "
                           "snap_to_seamless()"));
    m_result.number_of_unaligned_features = reader.number_of_unaligned_features;
    return true;
  }

  bool add_border_steps(Coarse_surface& surface)
  {
    Corner_index first_near_by = no_index;
    std::size_t number_near_by = 0;
    for(Corner_index h = 0; h < surface.input.number_of_halfedges(); ++h) {
      if(!Border_steps::is_needed(surface.input, h))
        continue;
      ++m_result.number_of_unaligned_border_edges;
      if(Border_steps::is_nearly_aligned(surface.input.corner(h).vector) && number_near_by++ == 0)
        first_near_by = h;
    }
    if(number_near_by > 0)
      return refuse(m_result, Outcome::NOT_ALIGNED,
                    counted(number_near_by, "border edge") +
                      (number_near_by == 1 ? " lies" : " lie") +
                      " on isocurves nearly, but not exactly, the first leads from " +
                      m_vertex_name(m_mesh.source(first_near_by)) + " to " +
                      m_vertex_name(m_mesh.vertex(first_near_by)) +
                      remedy("snap with align_border(true)"));
    surface.steps.add_to(surface.input);
    const Intrinsic_complex complex = make_complex(surface.input);
    const std::string problem =
      defect(complex, angles_around_vertices(complex), &Intrinsic_corner::vector);
    return problem.empty() ||
           refuse(m_result, Outcome::NOT_POSITIVE,
                  "the map has " + problem + ", once its coordinates are rounded to 59 bits");
  }

  const Chart_mesh& m_mesh;
  const std::vector<char>& m_is_feature;
  const std::function<Message(std::size_t)>& m_vertex_name;
  Quantization& m_result;
};

// Invariant: the result tells why there are no units, if it is no success.
class Unit_finder
{
public:
  Unit_finder(std::shared_ptr<const Coarse_surface> coarse, const Quantization_options& options,
              Quantization& result)
    : m_coarse(std::move(coarse)), m_options(options), m_result(result)
  {
    if(m_options.is_coarsest)
      m_options.number_of_quads = 1;
    share_out();
  }

  bool run()
  {
    std::vector<Intrinsic_complex> parts = split_into_parts(m_coarse->complex);
    bool has_reached_maximum = false;
    std::size_t number = 0;
    for(std::size_t i = 0; i < parts.size(); ++i) {
      const std::vector<int> angles = angles_around_vertices(parts[i]);
      Part_quantizer quantizer(m_coarse->input, parts[i], options_of_part(i));
      Quantized_complex found = quantizer.find_quads();
      if(!defect(found.complex, angles, &Intrinsic_corner::units).empty())
        return refuse(m_result, Outcome::INTERNAL_ERROR, "the integers are not feasible");
      m_first_numbers.push_back(quantizer.first_number_of_quads());
      m_needed.push_back(quads_needed(parts[i]));
      number += count(i, found);
      has_reached_maximum = has_reached_maximum || found.has_reached_maximum;
      parts[i] = std::move(found.complex);
    }
    m_result.number_of_quads = number;
    add_notes();
    if(has_too_many())
      return refuse(m_result, Outcome::TOO_LARGE,
                    "there would be " + std::to_string(m_result.number_of_quads) + " quads: " +
                      words_for_number() +
                      term(". That is more than maximum_number: raise it, or ask for about as "
                           "many, mark fewer features, or release some by maximum_feature_loss"));
    if(has_reached_maximum)
      return refuse(m_result, Outcome::TOO_LARGE,
                    "quads meet themselves, or each other twice, and no mesh of at most " +
                      std::to_string(std::llround(m_options.maximum_number)) +
                      " quads was found" + term(", which is maximum_number: raise it"));
    m_result.set_surface(std::make_shared<const Quantized_surface>(
      Quantized_surface{m_coarse, joined(parts), m_options.needs_face_graph}));
    return true;
  }

  // The numbers of the first quantization that is tried in each part, a face graph or not.
  std::vector<double> first_numbers_of_quads()
  {
    const std::vector<Intrinsic_complex> parts = split_into_parts(m_coarse->complex);
    std::vector<double> result;
    for(std::size_t i = 0; i < parts.size(); ++i)
      result.push_back(
        Part_quantizer(m_coarse->input, parts[i], options_of_part(i)).first_number_of_quads());
    return result;
  }

  std::vector<double> wanted_scales() const
  {
    std::vector<double> result;
    for(std::size_t i = 0; i < m_area.size(); ++i)
      result.push_back(std::sqrt(options_of_part(i).number_of_quads / m_area[i]));
    return result;
  }

private:
  // The quads wanted in each part: as many as its area tells, whatever other parts there are.
  void share_out()
  {
    const Integer_mesh& input = m_coarse->input;
    const Intrinsic_complex& complex = m_coarse->complex;
    const double largest = *std::max_element(input.steps.begin(), input.steps.end());
    m_area.resize(input.steps.size());
    m_wanted = m_area;
    double sum = 0; // in squares of the largest step, so that none is too large
    for(Corner_index h = 0; h < complex.number_of_halfedges(); h += 3) {
      const auto part = std::size_t(complex.part[std::size_t(h / 3)]);
      const double step = input.steps[part] / largest;
      const double area =
        approximate_cross(complex.corner(h).vector, complex.corner(h + 1).vector) / 2;
      m_area[part] += area;
      m_wanted[part] += step * step * area;
      sum += step * step * area;
    }
    for(double& x : m_wanted)
      x *= m_options.number_of_quads / sum;
  }

  // No part has less than a quad.
  Quantization_options options_of_part(const std::size_t part) const
  {
    Quantization_options result = m_options;
    result.number_of_quads = m_options.is_coarsest ? 1. : (std::max)(1., m_wanted[part]);
    return result;
  }

  // Returns the number of quads in a part.
  std::size_t count(const std::size_t part, const Quantized_complex& found)
  {
    constexpr double most = 9; // times as many quads, of a third of the length
    m_result.first_scale = (std::max)(m_result.first_scale, found.first_scale);
    m_result.number_of_moves += found.number_of_moves;
    m_result.number_of_long_edges += found.number_of_long_edges;
    const auto number = std::size_t(std::llround(found.number_of_quads));
    const double ratio = double(number) / m_wanted[part];
    if(!m_options.is_coarsest && !(ratio <= most && ratio >= 1 / most)) {
      const auto& parts = m_coarse->input.part;
      const auto first = std::find(parts.begin(), parts.end(), std::int32_t(part));
      m_result.parts_of_other_size.push_back(
        {std::size_t(first - parts.begin()), number, m_wanted[part],
         m_needed[part].by_topology(), false});
    }
    return number;
  }

  void add_notes()
  {
    auto& parts = m_result.parts_of_other_size;
    const bool has_more = !m_options.is_coarsest && has_more_than_wanted();
    if(has_more || std::any_of(parts.begin(), parts.end(), [](const Part_of_other_size& part)
                               { return has_too_many_quads(part); })) {
      const std::size_t forced = number_of_forced_quads();
      if(has_more) {
        m_result.number_of_forced_quads = forced;
        add_note(m_result, words_for_number() + words_for_remedy());
      }
    }
    for(Part_of_other_size& part : parts)
      part.has_too_many_quads = has_too_many_quads(part);
    if(const std::size_t n = m_result.number_of_unaligned_border_edges; n > 0)
      add_note(m_result, counted(n, "border edge") + (n == 1 ? " lies" : " lie") +
               " on no isocurve, and two sides of quads follow " + (n == 1 ? "it" : "each"));
    if(!m_options.work->is_left())
      add_note(m_result, words_for_spent_work);
  }

  bool has_more_than_wanted() const
  { return double(m_result.number_of_quads) > about_as_many * m_options.number_of_quads; }

  bool has_too_many() const
  { return double(m_result.number_of_quads) > m_options.maximum_number; }

  // So many fewer are in the first quantization that is tried where features are no walls. Numbers
  // that make a face graph would not compare: where one is found is more chance. Parts of another
  // size learn how many they need for their features.
  std::size_t number_of_forced_quads()
  {
    const std::vector<Feature_chain> features = feature_chains(m_coarse->input);
    if(features.empty())
      return 0;
    const auto without =
      std::make_shared<const Coarse_surface>(without_features(*m_coarse, features));
    std::vector<double> more = Unit_finder(without, m_options, m_result).first_numbers_of_quads();
    std::transform(m_first_numbers.begin(), m_first_numbers.end(), more.begin(), more.begin(),
                   std::minus<>());
    for(Part_of_other_size& part : m_result.parts_of_other_size) {
      const double forced = more[std::size_t(m_coarse->input.part[part.face])];
      part.number_needed =
        (std::max)(part.number_needed, std::size_t(std::llround((std::max)(0., forced))));
    }
    const double sum = std::accumulate(more.begin(), more.end(), 0.);
    return std::size_t(std::llround((std::max)(0., sum)));
  }

  std::string words_for_number() const
  {
    const std::size_t forced = m_result.number_of_forced_quads;
    Quads_needed needed;
    for(const Quads_needed& of_part : m_needed)
      needed += of_part;
    return "no " + std::string(m_options.needs_face_graph ? "mesh" : "arrangement") +
           " of fewer quads, down to the number wanted, was found" +
           (forced > 0 ? "; features force about " + std::to_string(forced) + " of the quads"
                       : "") + needed.in_words(m_options.number_of_quads);
  }

  // The remedy if more than half of the quads are forced.
  Message words_for_remedy() const
  {
    return 2 * m_result.number_of_forced_quads > m_result.number_of_quads &&
               m_options.maximum_feature_loss == 0
             ? remedy("some features can be released by maximum_feature_loss") : Message();
  }

  std::shared_ptr<const Coarse_surface> m_coarse;
  Quantization_options m_options;
  Quantization& m_result;
  std::vector<double> m_area;   // per part: in steps of its grid
  std::vector<double> m_wanted; // per part: quads
  // per part that is quantized
  std::vector<double> m_first_numbers; // of quads, of the first quantization that was tried
  std::vector<Quads_needed> m_needed;
};

// If features force quads, releases the features that force most quads for their length. Each round
// may lose twice as much as all before. The result is the first round with about as many quads as
// wanted, or else the round with the fewest quads.
class Feature_releaser
{
public:
  Feature_releaser(const Quantization_options& options, Quantization& result)
    : m_options(options), m_result(result)
  { }

  std::shared_ptr<const Coarse_surface> run(std::shared_ptr<const Coarse_surface> surface)
  {
    if(m_options.maximum_feature_loss == 0)
      return surface;
    constexpr int most_rounds = 8; // rounds of releasing features
    const double total = length_in_map(surface->input, feature_chains(surface->input));
    const double most = m_options.maximum_feature_loss * total;
    std::shared_ptr<const Coarse_surface> best = surface;
    std::vector<Feature_chain> released, kept_released;
    double first = 0, least = 0;
    for(int round = 0; round <= most_rounds; ++round) {
      Unit_finder finder(surface, m_options, m_result);
      const std::vector<double> numbers = finder.first_numbers_of_quads();
      const double number = std::accumulate(numbers.begin(), numbers.end(), 0.);
      if(round == 0 || number < least) {
        best = surface;
        kept_released = released;
        least = number;
      }
      first = round == 0 ? number : first;
      if(round == most_rounds ||
         (!m_options.is_coarsest && number <= about_as_many * m_options.number_of_quads))
        break;
      const double lost = length_in_map(surface->input, released);
      Costly_features costly(*surface, finder.wanted_scales());
      const auto found =
        costly.find(std::ldexp(most, round + 1 - most_rounds) - lost, most - lost);
      if(found.empty()) {
        if(round == 0)
          add_note(m_result, costly.exist()
                     ? "no feature is released: each that forces quads has a larger part of the "
                       "length than " + term("maximum_feature_loss") + " allows"
                     : "no feature is released: none seems to force quads");
        break;
      }
      surface = std::make_shared<const Coarse_surface>(without_features(*surface, found));
      released.insert(released.end(), found.begin(), found.end());
    }
    if(!kept_released.empty())
      report(best->input, kept_released, total, first - least);
    else if(!released.empty())
      add_note(m_result, "no feature is released: there would not be fewer quads");
    return best;
  }

private:
  void report(const Integer_mesh& input, const std::vector<Feature_chain>& released,
              const double total, const double saved)
  {
    for(const Feature_chain& chain : released) {
      std::vector<std::size_t> vertices{input.source(chain.front())};
      for(const Corner_index h : chain)
        vertices.push_back(input.vertex(h));
      m_result.released_features.push_back(vertices);
    }
    add_note(m_result, counted(released.size(), "feature") +
                         (released.size() == 1 ? " is" : " are") + " released, " +
                         short_number(100 * length_in_map(input, released) / total) +
                         " % of the length of all in the map, which saves about " +
                         std::to_string(std::llround(saved)) + " quads");
  }

  const Quantization_options& m_options;
  Quantization& m_result;
};

// Calls `run()`, and refuses where integers are too large.
template <typename Run>
void refuse_overflow(const Run& run, Quantization& result)
{
  try {
    run();
  } catch(const Integer_overflow&) {
    refuse(result, Outcome::TOO_LARGE,
           "the coordinates and the edges of a coarse triangulation differ too much in size for "
           "integers of 64 bits" + remedy("pass the map through snap_to_seamless()"));
  }
}

inline Quantization quantize_in_place(const Chart_mesh& mesh, const std::vector<char>& is_feature,
                                      const Quantization_options& options,
                                      const std::function<Message(std::size_t)>& vertex_name)
{
  Quantization result;
  const auto run = [&] {
    const auto coarse = std::make_shared<Coarse_surface>();
    if(check_options(options, result) &&
       Surface_coarsener(mesh, is_feature, vertex_name, result).run(*coarse))
      Unit_finder(Feature_releaser(options, result).run(coarse), options, result).run();
  };
  refuse_overflow(run, result);
  return result;
}

// Once more, away from the origin, where only its bits are in the way. With a coarse triangulation,
// the number of quads is too large, and no coordinate.
CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Quantization quantize_surface(const Chart_mesh& mesh, const std::vector<char>& is_feature,
                              const Quantization_options& options,
                              const std::function<Message(std::size_t)>& vertex_name)
{
  Quantization result = quantize_in_place(mesh, is_feature, options, vertex_name);
  if(result.status != Outcome::TOO_LARGE || result.number_of_coarse_faces > 0)
    return result;
  const std::optional<Chart_mesh> moved = moved_from_origin(mesh, is_feature);
  if(!moved)
    return result;
  const Quantization again = quantize_in_place(*moved, is_feature, options, vertex_name);
  if(again.status != Outcome::NOT_POSITIVE)
    return again;
  result.message += ", which was tried: " + again.message;
  return result;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Quantization quantize_again(const Quantization& quantization, const Quantization_options& options)
{
  Quantization result;
  result.number_of_coarse_vertices = quantization.number_of_coarse_vertices;
  result.number_of_coarse_faces = quantization.number_of_coarse_faces;
  result.number_of_unaligned_features = quantization.number_of_unaligned_features;
  result.number_of_unaligned_border_edges = quantization.number_of_unaligned_border_edges;
  if(check_options(options, result))
    refuse_overflow([&] {
      Unit_finder(Feature_releaser(options, result).run(quantization.surface().coarse), options,
                  result).run();
    }, result);
  return result;
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUANTIZE_SURFACE_IMPL_H
