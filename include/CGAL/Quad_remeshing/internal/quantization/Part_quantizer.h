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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_PART_QUANTIZER_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_PART_QUANTIZER_H

#include <CGAL/license/Quad_remeshing.h>

// The units of one connected part of a surface. No part knows of another one: were there one scale
// for all, that at which the smallest one has room would make many quads of the others.

#include <CGAL/Quad_remeshing/internal/quantization/Face_graph_search.h>
#include <CGAL/Quad_remeshing/internal/quantization/Integer_mesh.h>
#include <CGAL/Quad_remeshing/internal/quantization/quantize_complex.h>
#include <CGAL/Quad_remeshing/internal/quantization/quantize_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Each connected part of a compact complex as a complex of its own.
inline std::vector<Intrinsic_complex> split_into_parts(const Intrinsic_complex& complex)
{
  std::vector<Flat_face_index> new_face;
  std::vector<Flat_vertex_index> new_vertex;
  std::vector<Intrinsic_complex> result(
    1 + std::size_t(*std::max_element(complex.part.begin(), complex.part.end())));
  const auto part_of = [&](const Corner_index h) -> Intrinsic_complex&
    { return result[std::size_t(complex.part[std::size_t(h / 3)])]; };
  const auto new_corner = [&](const Corner_index h)
    { return h == no_index ? no_index : 3 * new_face[std::size_t(h / 3)] + h % 3; };
  for(Flat_face_index f = 0; f < complex.number_of_faces(); ++f) {
    new_face.push_back(Flat_face_index(part_of(3 * f).part.size()));
    part_of(3 * f).part.push_back(0);
  }
  for(std::size_t v = 0; v < complex.number_of_vertices(); ++v) {
    Intrinsic_complex& part = part_of(complex.corner_at_vertex[v]);
    new_vertex.push_back(Flat_vertex_index(part.number_of_vertices()));
    part.corner_at_vertex.push_back(new_corner(complex.corner_at_vertex[v]));
    part.is_border.push_back(complex.is_border[v]);
    part.is_regular.push_back(complex.is_regular[v]);
  }
  for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h) {
    Intrinsic_corner corner = complex.corner(h);
    corner.opposite = new_corner(corner.opposite);
    corner.vertex = new_vertex[complex.vertex(h)];
    part_of(h).corners.push_back(corner);
  }
  return result;
}

// The complex of all parts.
inline Intrinsic_complex joined(const std::vector<Intrinsic_complex>& parts)
{
  Intrinsic_complex result;
  for(std::size_t i = 0; i < parts.size(); ++i) {
    const auto first_corner = result.number_of_halfedges();
    const auto first_vertex = Flat_vertex_index(result.number_of_vertices());
    for(Intrinsic_corner corner : parts[i].corners) {
      corner.opposite += corner.opposite == no_index ? 0 : first_corner;
      corner.vertex += first_vertex;
      result.corners.push_back(corner);
    }
    for(const Corner_index h : parts[i].corner_at_vertex)
      result.corner_at_vertex.push_back(first_corner + h);
    const auto append = [](auto& to, const auto& from)
      { to.insert(to.end(), from.begin(), from.end()); };
    append(result.is_border, parts[i].is_border);
    append(result.is_regular, parts[i].is_regular);
    result.part.insert(result.part.end(), parts[i].part.size(), std::int32_t(i));
  }
  return result;
}

class Part_quantizer
{
public:
  // \param complex of one part, compact
  // \param options with the number of quads that are wanted in this part
  Part_quantizer(const Integer_mesh& input, const Intrinsic_complex& complex,
                 const Quantization_options& options)
    : m_input(input), m_complex(complex), m_options(options),
      m_ladders(input, complex, {1.}, (std::max)(1, (std::min)(8, 8000 / number_of_faces())),
                *options.work)
  { }

  Quantized_complex find_quads()
  {
    if(!m_options.needs_face_graph)
      return quantize(m_options.number_of_quads, m_options.is_coarsest);
    const auto quantize_to = [&](const double number) { return quantize(number, false); };
    return Face_graph_search<decltype(quantize_to)>(quantize_to, *m_options.work,
                                                    m_options.maximum_number, stride())
      .run(m_options.number_of_quads);
  }

  // The number of the first quantization that is tried, a face graph or not.
  double first_number_of_quads()
  {
    if(m_first_number == 0)
      quantize(m_options.number_of_quads, m_options.is_coarsest);
    return m_first_number;
  }

private:
  Flat_face_index number_of_faces() const { return m_complex.number_of_faces(); }

  // Between numbers of quads that are tried, in steps of 2.5 %: where there are many faces, a
  // quantization takes long.
  int stride() const { return (std::max)(1, (std::min)(14, number_of_faces() / 700)); }

  // Units per step of the grid.
  double scale(const double number_of_quads) const
  { return std::sqrt(number_of_quads / number_of_quads_wanted(m_complex, {1.})); }

  // About so many quads, or as few as are found.
  Quantized_complex quantize(const double number_of_quads, const bool is_coarsest)
  {
    const double wanted = scale(number_of_quads);
    const double step = 28 * std::log2(number_of_quads) / stride(); // as the search counts
    Unit_ladders::Rung start = m_ladders.find(int(std::lround(step)) % m_ladders.size(), wanted);
    Quantized_complex result;
    result.complex = std::move(start.complex);
    result.first_scale = start.first_scale / wanted;
    result.number_of_moves = start.number_of_moves;
    result.scales = {wanted};
    Complex_quantizer quantizer(m_input, result.complex, result.scales, *m_options.work);
    result.number_of_moves += quantizer.improve();
    if(!is_coarsest) {
      result.number_of_moves += quantizer.adjust(number_of_quads);
      // Elsewhere, shear goes when quads are smoothed.
      if(has_thin_parts(result.complex, result.scales))
        result.number_of_moves += quantizer.improve(Cost_of_units::SHAPE);
    }
    result.number_of_long_edges = quantizer.number_of_long_edges();
    result.number_of_quads = internal::number_of_quads(result.complex);
    if(m_first_number == 0)
      m_first_number = result.number_of_quads;
    return result;
  }

  const Integer_mesh& m_input;
  const Intrinsic_complex& m_complex;
  Quantization_options m_options;
  // Numbers that are tried one after the other begin on different ones: else what is wrong with one
  // result, for a face graph, would be wrong with the next ones, too.
  Unit_ladders m_ladders;
  double m_first_number = 0; // of quads, of the first quantization that was tried
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_PART_QUANTIZER_H
