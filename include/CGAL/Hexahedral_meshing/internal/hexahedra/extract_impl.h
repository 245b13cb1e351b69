// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Hexahedral_meshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_EXTRACT_IMPL_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_EXTRACT_IMPL_H

#include <CGAL/license/Hexahedral_meshing.h>

// The steps of the extraction: conditions, vertices, hexahedra, points, conclusions.

#include <CGAL/Hexahedral_meshing/internal/hexahedra/Corner_finder.h>
#include <CGAL/Hexahedral_meshing/internal/hexahedra/Feature_elements.h>
#include <CGAL/Hexahedral_meshing/internal/hexahedra/Grid_conditions.h>
#include <CGAL/Hexahedral_meshing/internal/hexahedra/Grid_map.h>
#include <CGAL/Hexahedral_meshing/internal/hexahedra/Grid_vertices.h>
#include <CGAL/Hexahedral_meshing/internal/hexahedra/Hexahedra_topology.h>
#include <CGAL/Hexahedral_meshing/internal/hexahedra/extract.h>

#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Seamless_snapping/internal/volume/Signed_union_find.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

// The barycentric coordinates of a point in a cell, each with a small relative error. If one is
// zero, it is exactly zero.
inline std::array<double, 4> barycentric_coordinates(const Cell_sides& sides, const Cell_point& at)
{
  constexpr double largest_error = 1e-10; // relative to the volume of the cell
  std::array<double, 4> result{};
  double sum = 0, error = 0;
  for(int i = 0; i < 4; ++i) {
    double bound = 0;
    if((at.facets >> i & 1) == 0)
      result[std::size_t(i)] = sides.value(i, at.p, bound);
    sum += result[std::size_t(i)];
    error += bound;
  }
  if(!(error <= largest_error * sum)) {
    using Number = CGAL::Exact_rational;
    std::array<Number, 4> exact;
    Number total(0);
    for(std::size_t i = 0; i < 4; ++i) {
      Uvw_tetrahedron u = sides.corners();
      u[i] = at.p;
      total += exact[i] = exact_determinant<Number>(u);
    }
    for(std::size_t i = 0; i < 4; ++i)
      result[i] = CGAL::to_double(Number(exact[i] / total));
    return result;
  }
  for(double& x : result)
    x /= sum;
  return result;
}

template <typename ConcurrencyTag>
class Hexahedra_extraction
{
public:
  Hexahedra_extraction(const Extraction_options& options, Extraction& extraction,
                       Hexahedra_report& report)
    : m_options(options), m_extraction(extraction), m_volume(extraction.volume),
      m_mesh(extraction.mesh), m_report(report)
  { }

  std::optional<Refusal> run()
  {
    Grid_conditions conditions(m_volume);
    if(auto refusal = conditions.check())
      return refusal;
    if(auto refusal = read_volume_of_map(conditions))
      return refusal;
    const Grid_map map(m_volume, conditions.take_elements());
    {
      const Grid_vertices vertices(map, ConcurrencyTag());
      if(vertices.size() > largest_number)
        return too_large(double(vertices.size()), largest_number);
      find_mirrored_cells();
      if(!find_hexahedra(map, vertices))
        return error_of_ours("a walk from a center to a corner has no end");
      find_points(map, vertices);
      if(m_options.keeps_features) {
        m_extraction.complex = Feature_complex_finder(m_volume).run();
        Feature_element_finder(map, vertices).run(m_extraction.complex, m_is_mirrored, m_mesh);
      }
    }
    return conclude(conditions);
  }

private:
  // So that numbers of vertices have 31 bits.
  static constexpr std::size_t largest_number = (std::size_t(1) << 31) - 2;

  static Refusal too_large(const double number, const std::size_t limit)
  {
    return {Outcome::TOO_LARGE, "there would be about " + short_number(number) +
                                  " hexahedra, and no more than " + std::to_string(limit) +
                                  " are allowed" +
                                  remedy("scale the map down, or raise maximum_number")};
  }

  static Refusal error_of_ours(const std::string& what)
  {
    return {Outcome::INTERNAL_ERROR, what + "; the hexahedra were discarded; please report this"};
  }

  // Under the conditions, it is an integer.
  std::optional<Refusal> read_volume_of_map(const Grid_conditions& conditions)
  {
    const auto [volume, error] = conditions.volume();
    const std::size_t limit = (std::min)(m_options.maximum_number, largest_number);
    if(!(volume < double(limit) + 0.5))
      return too_large(volume, limit);
    const double number = std::round(volume);
    if(!(std::abs(volume - number) + error < 0.5))
      return error_of_ours("the volume of the map is not found to be an integer");
    m_report.number_of_hexahedra = std::size_t(number);
    return std::nullopt;
  }

  bool find_hexahedra(const Grid_map& map, const Grid_vertices& vertices)
  {
    const auto parts = results_of_chunks<std::vector<Hexahedron>, ConcurrencyTag>(
      map.number_of_cells(), [&](const Chunk& chunk) {
        std::vector<Hexahedron> result;
        Corner_finder corners(map, vertices);
        for(std::size_t c = chunk.begin; c < chunk.end; ++c)
          add_hexahedra(map, std::int32_t(c), corners, result);
        return result;
      }, cells_of_chunk);
    m_mesh.hexahedra.reserve(m_report.number_of_hexahedra);
    for(const std::vector<Hexahedron>& part : parts)
      m_mesh.hexahedra.insert(m_mesh.hexahedra.end(), part.begin(), part.end());
    return have_vertices(m_mesh.hexahedra);
  }

  // Whether all vertices were found.
  template <typename Elements>
  static bool have_vertices(const Elements& elements)
  {
    return std::all_of(elements.begin(), elements.end(), [](const auto& element) {
      return *std::min_element(element.begin(), element.end()) >= 0;
    });
  }

  void add_hexahedra(const Grid_map& map, const std::int32_t cell, Corner_finder& corners,
                     std::vector<Hexahedron>& result) const
  {
    const Cell_sides sides = map.sides(cell);
    corners.enter(cell, sides);
    for_each_grid_point(sides, cell, {0.5, 0.5, 0.5}, [&](const Cell_point& center) {
      if(!map.is_in_place(center))
        return;
      result.emplace_back();
      for(std::size_t k = 0; k < 8; ++k) {
        Uvw corner = center.p;
        for(std::size_t c = 0; c < 3; ++c)
          corner[c] += double(coordinate_of_corner(k, c)) - 0.5;
        result.back()[k] = corners.vertex(center.p, corner);
      }
      if(m_is_mirrored[std::size_t(cell)] != 0)
        std::swap_ranges(result.back().begin(), result.back().begin() + 4,
                         result.back().begin() + 4);
    });
  }

  void find_points(const Grid_map& map, const Grid_vertices& vertices)
  {
    m_report.number_of_vertices = vertices.size();
    m_mesh.points.resize(vertices.size());
    if(m_options.keeps_locations) {
      m_extraction.cells.resize(vertices.size());
      m_extraction.weights.resize(vertices.size());
    }
    for_each_chunk<ConcurrencyTag>(chunks_of(map.number_of_cells(), cells_of_chunk),
                                   [&](const Chunk& chunk) {
      for(std::size_t c = chunk.begin; c < chunk.end; ++c) {
        if(vertices.begin_of_cell(c) == vertices.end_of_cell(c))
          continue;
        const Cell_sides sides = map.sides(std::int32_t(c));
        for(std::size_t v = vertices.begin_of_cell(c); v < vertices.end_of_cell(c); ++v)
          find_point(sides, v, {std::int32_t(c), vertices.point(v),
                                sides.facets_at(vertices.point(v))});
      }
    });
  }

  void find_point(const Cell_sides& sides, const std::size_t v, const Cell_point& at)
  {
    const std::array<double, 4> weights = barycentric_coordinates(sides, at);
    Uvw& point = m_mesh.points[v];
    point = {0, 0, 0};
    for(std::size_t i = 0; i < 4; ++i)
      for(std::size_t c = 0; c < 3 && weights[i] != 0; ++c)
        point[c] += weights[i] * point_of_corner(4 * std::size_t(at.cell) + i)[c];
    if(m_options.keeps_locations) {
      m_extraction.cells[v] = at.cell;
      m_extraction.weights[v] = weights;
    }
  }

  const Uvw& point_of_corner(const std::size_t i) const
  { return m_extraction.points[std::size_t(m_volume.vertices[i])]; }

  // There, corners are listed in the other order, so that hexahedra are positive in space.
  void find_mirrored_cells()
  {
    const std::size_t size = m_volume.number_of_cells();
    Signed_union_find components(size);
    for(std::size_t f = 0; f < m_volume.opposite.size(); ++f)
      if(m_volume.opposite[f] > Corner_index(f))
        components.unite(f / 4, std::size_t(m_volume.opposite[f] / 4));
    std::vector<double> volume(size, 0); // in space, per root
    for(std::size_t c = 0; c < size; ++c) {
      Uvw_tetrahedron x;
      for(std::size_t i = 0; i < 4; ++i)
        x[i] = point_of_corner(4 * c + i);
      volume[components.root(c)] += six_times_volume(x);
    }
    m_is_mirrored.resize(size);
    for(std::size_t c = 0; c < size; ++c)
      m_is_mirrored[c] = volume[components.root(c)] < 0;
  }

  std::string name_of_hexahedron(const std::int32_t i) const
  {
    Uvw middle{};
    for(const std::int32_t v : m_mesh.hexahedra[std::size_t(i)])
      for(std::size_t c = 0; c < 3; ++c)
        middle[c] += m_mesh.points[std::size_t(v)][c] / 8;
    return "the hexahedron at (" + short_number(middle[0]) + ", " + short_number(middle[1]) + ", " +
           short_number(middle[2]) + ")";
  }

  std::optional<Refusal> conclude(Grid_conditions& conditions)
  {
    if(m_mesh.hexahedra.size() != m_report.number_of_hexahedra)
      return error_of_ours("there are " + std::to_string(m_mesh.hexahedra.size()) +
                           " hexahedra, but the map has a volume of " +
                           std::to_string(m_report.number_of_hexahedra));
    const Hexahedra_topology topology =
      Topology_finder(m_mesh.hexahedra, m_mesh.points.size()).run(ConcurrencyTag(), m_report);
    if(topology.bad_hexahedron >= 0)
      return Refusal(Outcome::TOO_COARSE, name_of_hexahedron(topology.bad_hexahedron) +
                     " has a vertex twice, or four vertices in common with two others, because "
                     "the grid is too coarse there" + remedy(scale_up));
    const auto is_about = [](const double x, const std::size_t n)
    { return std::abs(x - double(n)) < 0.5; };
    if(topology.number_of_unused_vertices > 0)
      return error_of_ours("a vertex belongs to no hexahedron");
    if(!topology.is_boundary_closed ||
       !is_about(conditions.border_area(), m_report.number_of_boundary_quadrilaterals))
      return error_of_ours("the boundary of the hexahedra differs from the boundary of the map");
    if(m_options.keeps_features && !are_features_complete())
      return error_of_ours("the boundary or a feature is not found in the hexahedra");
    return check_edges(conditions);
  }

  bool are_features_complete() const
  {
    std::size_t number = 0; // of quadrilaterals on the boundary
    for(const std::int32_t i : m_mesh.feature_facets) {
      const Corner_index facet = m_volume.aligned_facets[std::size_t(i)];
      number += std::size_t(m_volume.opposite[std::size_t(facet)] == no_facet);
    }
    return number == m_report.number_of_boundary_quadrilaterals &&
           have_vertices(m_mesh.quadrilaterals) && have_vertices(m_mesh.edges);
  }

  // Edges with the same ends are one pair of vertices: then the others are fewer.
  std::optional<Refusal> check_edges(Grid_conditions& conditions)
  {
    const std::ptrdiff_t edges =
      std::ptrdiff_t(m_report.number_of_vertices + m_report.number_of_quadrilaterals) -
      std::ptrdiff_t(m_report.number_of_hexahedra) - conditions.euler_characteristic();
    const std::ptrdiff_t missing = edges - std::ptrdiff_t(m_report.number_of_edges);
    if(missing < 0)
      return error_of_ours("the hexahedra have another Euler characteristic than the cells");
    m_report.number_of_double_edges = std::size_t(missing);
    if(missing > 0)
      return std::nullopt;
    std::map<int, std::size_t> irregular = m_report.irregular_edges;
    for(const auto& [turns, length] : conditions.singular_lengths())
      if(!(std::abs(length - double(irregular[turns])) < 0.5))
        return error_of_ours("the edges with " + std::to_string(turns) + " hexahedra are not as "
                             "long as the singular edges of the map");
    if(irregular.size() != conditions.singular_lengths().size())
      return error_of_ours("an edge is singular that is not so in the map");
    return std::nullopt;
  }

  const Extraction_options& m_options;
  Extraction& m_extraction;
  const Flat_volume& m_volume;
  Hexahedral_mesh& m_mesh;
  Hexahedra_report& m_report;
  std::vector<char> m_is_mirrored; // per cell: the map mirrors its component
};

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
std::optional<Refusal> extract(const Extraction_options& options, Extraction& extraction,
                               Hexahedra_report& report)
{
  if(options.is_parallel)
    return Hexahedra_extraction<CGAL::Parallel_if_available_tag>(options, extraction, report).run();
  return Hexahedra_extraction<CGAL::Sequential_tag>(options, extraction, report).run();
}

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_EXTRACT_IMPL_H
