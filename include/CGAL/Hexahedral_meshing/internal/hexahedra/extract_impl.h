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
#include <CGAL/Hexahedral_meshing/internal/hexahedra/Grid_conditions.h>
#include <CGAL/Hexahedral_meshing/internal/hexahedra/Grid_map.h>
#include <CGAL/Hexahedral_meshing/internal/hexahedra/Grid_vertices.h>
#include <CGAL/Hexahedral_meshing/internal/hexahedra/Hexahedra_topology.h>
#include <CGAL/Hexahedral_meshing/internal/hexahedra/extract.h>

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
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

// The barycentric coordinates of a point in a cell, each with a small relative error; those that
// are zero are exactly so.
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
      std::array<std::array<Number, 3>, 3> e;
      for(std::size_t j = 0; j < 3; ++j)
        for(std::size_t c = 0; c < 3; ++c)
          e[j][c] = Number(u[j + 1][c]) - Number(u[0][c]);
      exact[i] = inner_product(e[0], vector_product(e[1], e[2]));
      total += exact[i];
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
  Hexahedra_extraction(const Flat_volume& volume, const std::vector<Uvw>& points,
                       const Extraction_options& options, Hexahedral_soup& soup,
                       Hexahedra_report& report)
    : m_volume(volume), m_points(points), m_options(options), m_soup(soup), m_report(report)
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
        m_soup.complex = Feature_complex_finder(m_volume).run();
        m_soup.features =
          Feature_element_finder(map, vertices).run(m_soup.complex.lines, m_is_mirrored);
      }
    }
    return conclude(conditions);
  }

private:
  // So that numbers of vertices have 31 bits.
  static constexpr std::size_t largest_number = (std::size_t(1) << 31) - 2;

  static Refusal too_large(const double number, const std::size_t limit)
  {
    std::ostringstream message;
    message << "there would be about " << number << " hexahedra, and no more than " << limit
            << " are allowed";
    return {Outcome::TOO_LARGE,
            message.str() + remedy("scale the map down, or raise maximum_number")};
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
    m_soup.hexahedra.reserve(m_report.number_of_hexahedra);
    for(const std::vector<Hexahedron>& part : parts)
      m_soup.hexahedra.insert(m_soup.hexahedra.end(), part.begin(), part.end());
    return std::all_of(m_soup.hexahedra.begin(), m_soup.hexahedra.end(), [](const Hexahedron& h) {
      return *std::min_element(h.begin(), h.end()) >= 0;
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
          corner[c] += corner_of_cube[k][c] - 0.5;
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
    m_soup.points.resize(vertices.size());
    if(m_options.keeps_locations) {
      m_soup.cells.resize(vertices.size());
      m_soup.weights.resize(vertices.size());
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
    Uvw& point = m_soup.points[v];
    point = {0, 0, 0};
    for(std::size_t i = 0; i < 4; ++i)
      for(std::size_t c = 0; c < 3 && weights[i] != 0; ++c)
        point[c] += weights[i] * m_points[std::size_t(
                                   m_volume.vertex(4 * at.cell + Corner_index(i)))][c];
    if(m_options.keeps_locations) {
      m_soup.cells[v] = at.cell;
      m_soup.weights[v] = weights;
    }
  }

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
        x[i] = m_points[std::size_t(m_volume.vertices[4 * c + i])];
      volume[components.root(c)] += six_times_volume(x);
    }
    m_is_mirrored.resize(size);
    for(std::size_t c = 0; c < size; ++c)
      m_is_mirrored[c] = volume[components.root(c)] < 0;
  }

  std::string name_of_hexahedron(const std::int32_t i) const
  {
    Uvw middle{};
    for(const std::int32_t v : m_soup.hexahedra[std::size_t(i)])
      for(std::size_t c = 0; c < 3; ++c)
        middle[c] += m_soup.points[std::size_t(v)][c] / 8;
    std::ostringstream name;
    name << "the hexahedron at (" << middle[0] << ", " << middle[1] << ", " << middle[2] << ")";
    return name.str();
  }

  std::optional<Refusal> conclude(Grid_conditions& conditions)
  {
    if(m_soup.hexahedra.size() != m_report.number_of_hexahedra)
      return error_of_ours("there are " + std::to_string(m_soup.hexahedra.size()) +
                           " hexahedra, but the map has a volume of " +
                           std::to_string(m_report.number_of_hexahedra));
    const Hexahedra_topology topology =
      Topology_finder(m_soup.hexahedra, m_soup.points.size()).run(ConcurrencyTag());
    if(topology.bad_hexahedron >= 0)
      return Refusal(Outcome::TOO_COARSE, name_of_hexahedron(topology.bad_hexahedron) +
                     " has a vertex twice, or four vertices in common with two others, as the "
                     "grid is too coarse there" + remedy(scale_up));
    m_report.number_of_edges = topology.number_of_edges;
    m_report.number_of_quadrilaterals = topology.number_of_quadrilaterals;
    m_report.number_of_boundary_quadrilaterals = topology.boundary.size();
    m_report.irregular_edges = topology.irregular_edges;
    const auto is_about = [](const double x, const std::size_t n)
    { return std::abs(x - double(n)) < 0.5; };
    if(topology.number_of_unused_vertices > 0)
      return error_of_ours("a vertex belongs to no hexahedron");
    if(!topology.is_boundary_closed ||
       !is_about(conditions.border_area(), topology.boundary.size()))
      return error_of_ours("the boundary of the hexahedra is not that of the map");
    if(m_options.keeps_features && !are_features_complete())
      return error_of_ours("the boundary or a feature is not found in the hexahedra");
    return check_edges(conditions, topology);
  }

  bool are_features_complete() const
  {
    const Feature_elements& features = m_soup.features;
    std::size_t number = 0; // of quadrilaterals on the boundary
    for(const std::int32_t i : features.facets) {
      const Corner_index facet = m_volume.aligned_facets[std::size_t(i)];
      number += std::size_t(m_volume.opposite[std::size_t(facet)] == no_facet);
    }
    const auto is_found = [](const auto& element)
    { return *std::min_element(element.begin(), element.end()) >= 0; };
    return number == m_report.number_of_boundary_quadrilaterals &&
           std::all_of(features.quadrilaterals.begin(), features.quadrilaterals.end(), is_found) &&
           std::all_of(features.edges.begin(), features.edges.end(), is_found);
  }

  // Edges with the same ends are one pair of vertices: then the others are fewer.
  std::optional<Refusal> check_edges(Grid_conditions& conditions,
                                     const Hexahedra_topology& topology)
  {
    const std::ptrdiff_t edges =
      std::ptrdiff_t(m_report.number_of_vertices + topology.number_of_quadrilaterals) -
      std::ptrdiff_t(m_report.number_of_hexahedra) - conditions.euler_characteristic();
    const std::ptrdiff_t missing = edges - std::ptrdiff_t(topology.number_of_edges);
    if(missing < 0)
      return error_of_ours("the hexahedra have another Euler characteristic than the cells");
    m_report.number_of_double_edges = std::size_t(missing);
    if(missing > 0)
      return std::nullopt;
    std::map<int, std::size_t> irregular = topology.irregular_edges;
    for(const auto& [turns, length] : conditions.singular_lengths())
      if(!(std::abs(length - double(irregular[turns])) < 0.5))
        return error_of_ours("the edges with " + std::to_string(turns) + " hexahedra are not as "
                             "long as the singular edges of the map");
    if(irregular.size() != conditions.singular_lengths().size())
      return error_of_ours("an edge is singular that is not so in the map");
    return std::nullopt;
  }

  const Flat_volume& m_volume;
  std::vector<char> m_is_mirrored; // per cell: the map mirrors its component
  const std::vector<Uvw>& m_points;
  const Extraction_options& m_options;
  Hexahedral_soup& m_soup;
  Hexahedra_report& m_report;
};

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
std::optional<Refusal> extract(const Flat_volume& volume, const std::vector<Uvw>& points,
                               const Extraction_options& options, Hexahedral_soup& soup,
                               Hexahedra_report& report)
{
  if(options.is_parallel)
    return Hexahedra_extraction<CGAL::Parallel_if_available_tag>(volume, points, options, soup,
                                                                 report).run();
  return Hexahedra_extraction<CGAL::Sequential_tag>(volume, points, options, soup, report).run();
}

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_EXTRACT_IMPL_H
