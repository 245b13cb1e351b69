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

#include <CGAL/Isocurves_and_layouts/internal/charts/nonpositive_faces.h>
#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/counted.h>
#include <CGAL/Quad_remeshing/internal/quantization/Face_graph_search.h>
#include <CGAL/Quad_remeshing/internal/quantization/coarsen.h>
#include <CGAL/Quad_remeshing/internal/quantization/quantize_complex.h>
#include <CGAL/Quad_remeshing/internal/quantization/quantize_surface.h>
#include <CGAL/Quad_remeshing/internal/quantization/read_integer_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

inline bool check_options(const Quantization_options& options, Report& report)
{
  const double largest = (std::min)(std::ldexp(1., 28), options.maximum_number);
  return options.is_coarsest ||
         (options.number_of_quads >= 1 && options.number_of_quads <= largest) ||
         refuse(report, Outcome::INVALID_ARGUMENT,
                "the target is " + short_number(options.number_of_quads) +
                  " quads; it must be at least 1 and at most 2^28, and at most maximum_number");
}

inline Intrinsic_complex make_coarse_complex(const Integer_mesh& input)
{
  Intrinsic_complex complex = make_complex(input);
  internal::coarsen(input, complex);
  return compacted(complex);
}

class Surface_coarsener
{
public:
  // \param result tells why there is no coarse surface
  Surface_coarsener(const Chart_mesh& mesh, const std::vector<char>& is_feature,
                    const std::function<std::string(std::size_t)>& vertex_name,
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
    return are_positive(m_result.nonpositive_faces, m_result);
  }

  bool read_integers(Integer_mesh& input)
  {
    Integer_reader reader(m_mesh, m_is_feature);
    if(!reader.read(input))
      return refuse(m_result, Outcome::TOO_LARGE,
                  "the coordinates around vertex " + m_vertex_name(reader.unrepresentable_vertex) +
                    " have more bits than integers of 64 bits can hold beside the largest "
                    "coordinate; snap the map by snap_to_seamless()");
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
                      " on isocurves nearly, but not exactly, the first leads from vertex " +
                      m_vertex_name(m_mesh.source(first_near_by)) + " to vertex " +
                      m_vertex_name(m_mesh.vertex(first_near_by)) +
                      "; snap with align_border(true)");
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
  const std::function<std::string(std::size_t)>& m_vertex_name;
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
  }

  bool run()
  {
    const std::vector<int> angles = angles_around_vertices(m_coarse->complex);
    Quantized_complex found = find_quads();
    m_result.first_scale = found.first_scale;
    m_result.number_of_moves = found.number_of_moves;
    m_result.number_of_long_edges = found.number_of_long_edges;
    m_result.number_of_quads = std::size_t(std::llround(found.number_of_quads));
    if(!defect(found.complex, angles, &Intrinsic_corner::units).empty())
      return refuse(m_result, Outcome::INTERNAL_ERROR, "the integers are not feasible");
    if(!m_options.is_coarsest && has_more_than_wanted()) {
      m_result.number_of_forced_quads = number_of_forced_quads();
      add_note(words_for_number());
    }
    if(const std::size_t n = m_result.number_of_unaligned_border_edges; n > 0)
      add_note(counted(n, "border edge") + (n == 1 ? " lies" : " lie") +
               " on no isocurve, and two sides of quads follow " + (n == 1 ? "it" : "each"));
    if(found.number_of_quads > m_options.maximum_number)
      return refuse(m_result, Outcome::TOO_LARGE,
                    "there would be " + std::to_string(m_result.number_of_quads) + " quads: " +
                      words_for_number() + ". That is more than maximum_number: raise it, or ask "
                      "for about as many, or mark fewer features");
    m_result.set_surface(std::make_shared<const Quantized_surface>(
      Quantized_surface{m_coarse, std::move(found.complex), m_options.needs_face_graph}));
    return true;
  }

private:
  void add_note(const std::string& note)
  { m_result.message += (m_result.message.empty() ? "" : "; ") + note; }

  // Units per step of each part's grid. Steps, which are powers of two, are measured by the largest
  // one, so that no square is too large.
  std::vector<double> scales(const double number_of_quads) const
  {
    std::vector<double> result(m_coarse->input.steps);
    const double largest = *std::max_element(result.begin(), result.end());
    for(double& s : result)
      s /= largest;
    double area = 0;
    const Intrinsic_complex& complex = m_coarse->complex;
    for(Corner_index h = 0; h < complex.number_of_halfedges(); h += 3) {
      const double step = result[std::size_t(complex.part[std::size_t(h / 3)])];
      area += step * step *
              approximate_cross(complex.corner(h).vector, complex.corner(h + 1).vector) / 2;
    }
    for(double& s : result)
      s *= std::sqrt(number_of_quads / area);
    return result;
  }

  // About so many quads, or as few as are found.
  Quantized_complex quantize(const double number_of_quads, const bool is_coarsest) const
  {
    Quantized_complex result;
    result.complex = m_coarse->complex;
    Complex_quantizer quantizer(m_coarse->input, result.complex, scales(number_of_quads));
    quantizer.start();
    result.first_scale = quantizer.growth;
    quantizer.improve();
    if(!is_coarsest)
      quantizer.adjust(number_of_quads);
    result.number_of_moves = quantizer.number_of_moves;
    result.number_of_long_edges = quantizer.number_of_long_edges();
    result.number_of_quads = internal::number_of_quads(result.complex);
    return result;
  }

  Quantized_complex find_quads() const
  {
    if(!m_options.needs_face_graph)
      return quantize(m_options.number_of_quads, m_options.is_coarsest);
    const auto quantize_to = [&](const double number) { return quantize(number, false); };
    return Face_graph_search<decltype(quantize_to)>(quantize_to, m_options.maximum_number)
      .run(m_options.number_of_quads);
  }

  bool has_more_than_wanted() const
  { return double(m_result.number_of_quads) > 1.1 * m_options.number_of_quads; }

  // So many fewer are found for the same map where features are no walls.
  std::size_t number_of_forced_quads() const
  {
    const auto without = std::make_shared<Coarse_surface>();
    without->input = m_coarse->input;
    bool has_features = false;
    for(Integer_corner& corner : without->input.corners)
      if(corner.is_wall && corner.opposite != no_index) {
        corner.is_wall = false;
        has_features = true;
      }
    if(!has_features)
      return 0;
    without->complex = make_coarse_complex(without->input);
    const double number = Unit_finder(without, m_options, m_result).find_quads().number_of_quads;
    const std::size_t rounded = std::size_t(std::llround(number));
    return rounded < m_result.number_of_quads ? m_result.number_of_quads - rounded : 0;
  }

  std::string words_for_number() const
  {
    const std::size_t forced = m_result.number_of_forced_quads;
    return "no " + std::string(m_options.needs_face_graph ? "mesh" : "arrangement") +
           " of fewer quads was found" +
           (forced > 0 ? "; features force " + std::to_string(forced) : "");
  }

  std::shared_ptr<const Coarse_surface> m_coarse;
  Quantization_options m_options;
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
           "integers of 64 bits; pass the map through snap_to_seamless()");
  }
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Quantization quantize_surface(const Chart_mesh& mesh, const std::vector<char>& is_feature,
                              const Quantization_options& options,
                              const std::function<std::string(std::size_t)>& vertex_name)
{
  Quantization result;
  const auto run = [&] {
    const auto coarse = std::make_shared<Coarse_surface>();
    if(check_options(options, result) &&
       Surface_coarsener(mesh, is_feature, vertex_name, result).run(*coarse))
      Unit_finder(coarse, options, result).run();
  };
  refuse_overflow(run, result);
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
    refuse_overflow([&] { Unit_finder(quantization.surface().coarse, options, result).run(); },
                    result);
  return result;
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUANTIZE_SURFACE_IMPL_H
