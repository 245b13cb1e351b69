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
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

class Surface_quantizer
{
public:
  Surface_quantizer(const Chart_mesh& mesh, const std::vector<char>& is_feature,
                    const Quantization_options& options,
                    const std::function<std::string(std::size_t)>& vertex_name)
    : m_mesh(mesh), m_is_feature(is_feature), m_options(options), m_vertex_name(vertex_name)
  { }

  Quantization run()
  {
    try {
      if(check_options() && check_faces() && check_border() && read_integers()) {
        make_coarse();
        find_units();
      }
    } catch(const Integer_overflow&) {
      refuse(m_result, Outcome::TOO_LARGE,
             "the coordinates and the edges of a coarse triangulation differ too much in size for "
             "integers of 64 bits; pass the map through snap_to_seamless()");
    }
    return std::move(m_result);
  }

private:
  bool check_options()
  {
    if(m_options.is_coarsest)
      m_options.number_of_quads = 1;
    return (m_options.number_of_quads >= 1 && m_options.number_of_quads <= std::ldexp(1., 28)) ||
           refuse(m_result, Outcome::INVALID_ARGUMENT,
                  "the target is " + short_number(m_options.number_of_quads) +
                    " quads; it must be at least 1 and at most 2^28");
  }

  bool check_faces()
  {
    m_result.nonpositive_faces = nonpositive_faces(m_mesh);
    return are_positive(m_result.nonpositive_faces, m_result);
  }

  bool check_border()
  {
    Corner_index first = no_index;
    for(Corner_index h = 0; h < m_mesh.number_of_halfedges(); ++h) {
      if(m_mesh.opposite(h) != no_index || is_on_isocurve(m_mesh, h))
        continue;
      first = first == no_index ? h : first;
      ++m_result.number_of_unaligned_border_edges;
    }
    return first == no_index ||
           refuse(m_result, Outcome::NOT_ALIGNED,
                  counted(m_result.number_of_unaligned_border_edges, "border edge") +
                    (m_result.number_of_unaligned_border_edges == 1 ? " doesn't lie"
                                                                    : " don't lie") +
                    " on isocurves, the first leads from vertex " +
                    m_vertex_name(m_mesh.source(first)) + " to vertex " +
                    m_vertex_name(m_mesh.vertex(first)) +
                    "; parametrize and snap with align_border(true)");
  }

  bool read_integers()
  {
    Integer_reader reader(m_mesh, m_is_feature);
    if(!reader.read(m_surface.input))
      return refuse(m_result, Outcome::TOO_LARGE,
                  "the coordinates around vertex " + m_vertex_name(reader.unrepresentable_vertex) +
                    " have more bits than integers of 64 bits can hold beside the largest "
                    "coordinate; snap the map by snap_to_seamless()");
    m_result.number_of_unaligned_features = reader.number_of_unaligned_features;
    const Intrinsic_complex complex = make_complex(m_surface.input);
    const std::string problem =
      defect(complex, angles_around_vertices(complex), &Intrinsic_corner::vector);
    return problem.empty() ||
           refuse(m_result, Outcome::NOT_POSITIVE,
                  "the map has " + problem + ", once its coordinates are rounded to 59 bits");
  }

  void make_coarse()
  {
    Intrinsic_complex complex = make_complex(m_surface.input);
    internal::coarsen(m_surface.input, complex);
    m_surface.complex = compacted(complex);
    m_result.number_of_coarse_vertices = m_surface.complex.number_of_vertices();
    m_result.number_of_coarse_faces = std::size_t(m_surface.complex.number_of_faces());
  }

  // Units per step of each part's grid. Steps, which are powers of two, are measured by the largest
  // one, so that no square is too large.
  std::vector<double> scales(const double number_of_quads) const
  {
    std::vector<double> result(m_surface.input.steps);
    const double largest = *std::max_element(result.begin(), result.end());
    for(double& s : result)
      s /= largest;
    double area = 0;
    const Intrinsic_complex& complex = m_surface.complex;
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
    result.complex = m_surface.complex;
    Complex_quantizer quantizer(m_surface.input, result.complex, scales(number_of_quads));
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
    return Face_graph_search<decltype(quantize_to)>(quantize_to).run(m_options.number_of_quads);
  }

  bool find_units()
  {
    const std::vector<int> angles = angles_around_vertices(m_surface.complex);
    Quantized_complex found = find_quads();
    m_result.first_scale = found.first_scale;
    m_result.number_of_moves = found.number_of_moves;
    m_result.number_of_long_edges = found.number_of_long_edges;
    m_result.number_of_quads = std::size_t(std::llround(found.number_of_quads));
    if(!defect(found.complex, angles, &Intrinsic_corner::units).empty())
      return refuse(m_result, Outcome::INTERNAL_ERROR, "the integers are not feasible");
    if(!m_options.is_coarsest && found.number_of_quads > 1.1 * m_options.number_of_quads)
      m_result.message = "no " + std::string(m_options.needs_face_graph ? "mesh" : "arrangement") +
                         " of fewer quads was found";
    m_surface.complex = std::move(found.complex);
    m_surface.is_for_face_graph = m_options.needs_face_graph;
    m_result.set_surface(std::make_shared<const Quantized_surface>(std::move(m_surface)));
    return true;
  }

  const Chart_mesh& m_mesh;
  const std::vector<char>& m_is_feature;
  Quantization_options m_options;
  std::function<std::string(std::size_t)> m_vertex_name;
  Quantization m_result;
  Quantized_surface m_surface;
};

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Quantization quantize_surface(const Chart_mesh& mesh, const std::vector<char>& is_feature,
                              const Quantization_options& options,
                              const std::function<std::string(std::size_t)>& vertex_name)
{ return Surface_quantizer(mesh, is_feature, options, vertex_name).run(); }

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUANTIZE_SURFACE_IMPL_H
