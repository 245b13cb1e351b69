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

#ifndef CGAL_HEXAHEDRAL_MESHING_EXTRACT_HEXAHEDRA_H
#define CGAL_HEXAHEDRAL_MESHING_EXTRACT_HEXAHEDRA_H

#include <CGAL/license/Hexahedral_meshing.h>

// The hexahedra that an exactly seamless integer-grid map of a tetrahedral mesh describes.

#include <CGAL/Hexahedral_meshing/internal/hexahedra/extract.h>
#include <CGAL/Hexahedral_meshing/types/Hexahedra_report.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/volume/snap_volume.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {

/// \cond SKIP_IN_MANUAL
namespace internal {

constexpr std::size_t default_maximum_number_of_hexahedra = 100000000;

// Checks the points of the vertices of the volume. Returns a refusal if they are wrong.
template <typename PointRange>
std::optional<Refusal> read_points(const PointRange& range, const Flat_volume& volume,
                                   std::vector<Uvw>& points)
{
  for(const std::int64_t name : volume.vertex_names) {
    if(name >= static_cast<std::int64_t>(range.size()))
      return invalid_cells("there is no point for vertex " + std::to_string(name));
    const auto& p = *(std::begin(range) + static_cast<std::ptrdiff_t>(name));
    points.push_back({static_cast<double>(p[0]), static_cast<double>(p[1]),
                      static_cast<double>(p[2])});
    for(const double x : points.back())
      if(!(std::abs(x) <= largest_uvw))
        return Refusal(Outcome::NOT_FINITE, "the point of vertex " + std::to_string(name) +
                                              " is NaN, infinite, or beyond 1e300; correct it");
  }
  return std::nullopt;
}

template <typename Point>
Point point_of(const Uvw& p)
{
  if constexpr(std::is_constructible<Point, double, double, double>::value)
    return Point(p[0], p[1], p[2]);
  else
    return Point{{p[0], p[1], p[2]}};
}

// Room for more elements, in ranges that can reserve it.
template <typename Range>
auto reserve_more(Range& range, const std::size_t number, int)
  -> decltype(range.reserve(number))
{ range.reserve(range.size() + number); }

template <typename Range>
void reserve_more(Range&, std::size_t, long)
{ }

// Appends; where one of the ranges throws, the others are as they were.
template <typename PointRange, typename HexahedronRange>
void append_hexahedra(const Hexahedral_mesh& mesh, PointRange& points, HexahedronRange& hexahedra)
{
  using Output = typename HexahedronRange::value_type;
  using Index = typename Output::value_type;
  const std::size_t first = points.size(), first_hexahedron = hexahedra.size();
  try {
    reserve_more(points, mesh.points.size(), 0);
    reserve_more(hexahedra, mesh.hexahedra.size(), 0);
    for(const Uvw& p : mesh.points)
      points.push_back(point_of<typename PointRange::value_type>(p));
    for(const auto& h : mesh.hexahedra) {
      std::array<Index, 8> indices;
      for(std::size_t k = 0; k < 8; ++k)
        indices[k] = static_cast<Index>(first + std::size_t(h[k]));
      if constexpr(std::is_same<Output, std::array<Index, 8> >::value)
        hexahedra.push_back(indices);
      else
        hexahedra.push_back(Output(indices.begin(), indices.end()));
    }
  } catch(...) {
    points.resize(first);
    hexahedra.resize(first_hexahedron);
    throw;
  }
}

// The place of each vertex: corners in the caller's order.
template <typename LocationMap>
void put_locations(const Extraction& extraction, const std::size_t first,
                   const LocationMap& location_map)
{
  const Flat_volume& volume = extraction.volume;
  for(std::size_t v = 0; v < extraction.cells.size(); ++v) {
    const std::size_t cell = std::size_t(extraction.cells[v]);
    std::array<double, 4> weights;
    for(std::size_t i = 0; i < 4; ++i)
      weights[volume.key(4 * cell + i) % 4] = extraction.weights[v][i];
    put(location_map, first + v, std::make_pair(volume.key(4 * cell) / 4, weights));
  }
}

// \param plain a plain chain, which may have more than this reads
template <typename ConcurrencyTag, typename PointRange, typename TetrahedronRange,
          typename CornerUVWMap, typename Parameters>
Hexahedra_report extract_soup(const PointRange& points, const TetrahedronRange& tetrahedra,
                              CornerUVWMap uvw_map, Extraction_options options,
                              const Parameters& plain, Extraction& extraction)
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_same<ConcurrencyTag, CGAL::Parallel_tag>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
#endif
  options.is_parallel = !std::is_same<ConcurrencyTag, CGAL::Sequential_tag>::value;
  Hexahedra_report report;
  Flat_volume& volume = extraction.volume;
  std::optional<Refusal> refusal;
  {
    Tetrahedra cells;
    using Aligned =
      CGAL::Named_function_parameters<bool, CGAL::internal_np::align_boundary_t, Parameters>;
    refusal = read_volume(tetrahedra, uvw_map, Aligned(true, plain), cells, volume, {},
                          Cells_to_read::ALL);
  }
  if(!refusal)
    refusal = read_points(points, volume, extraction.points);
  if(!refusal) {
    read_coordinates(uvw_map, volume);
    refusal = extract(options, extraction, report);
  }
  if(refusal)
    refuse(report, *refusal);
  return report;
}

} // namespace internal
/// \endcond

/*!
\ingroup PkgHexahedralMeshingRef

extracts the mesh of hexahedra that an integer-grid map of a tetrahedral mesh describes: the
preimage of the grid of integers.

The map must be exactly seamless with integer translations. Singular edges must lie on lines of the
grid, and boundary facets in planes of the grid. All cells must be positive in the domain, or all
negative. Then the result is a mesh of hexahedra only that fills the tetrahedral mesh. The number of
hexahedra is the volume of the map. An inner edge has four hexahedra around it, unless it is
singular in the map. The function checks the conditions first and the results last, exactly. All
decisions in between are signs of determinants, which are exact, too. There is no tolerance, and
nothing is repaired. Parts of the mesh that touch only in edges or vertices are separated in the
result: their common vertices are doubled.

The result is the same, to the bit, for any number of threads. Nothing is written unless the
extraction succeeds.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_if_available_tag`, or
        `CGAL::Parallel_tag`, which does not compile unless TBB is linked
\tparam PointRange a random access range of three-dimensional points, whose coordinates `p[0]`,
        `p[1]`, and `p[2]` convert to `double`
\tparam TetrahedronRange a range as `snap_volume_to_seamless()` takes it
\tparam CornerUVWMap a model of `ReadablePropertyMap`, otherwise as `snap_volume_to_seamless()`
takes it
\tparam HexahedronPointRange a model of `BackInsertionSequence` of points that can be constructed
        from three `double`s, or of `std::array<double, 3>`
\tparam HexahedronRange a model of `BackInsertionSequence` whose value type is
        `std::array<Index, 8>`, or a container of indices that is constructed from two iterators
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points of the vertices of the tetrahedra
\param tetrahedra the cells: the indices of four points each
\param uvw_map the coordinates of each corner: the value of key `4 * i + k` belongs to vertex `k` of
       cell `i`
\param hexahedron_points the function appends the points of the hexahedra
\param hexahedra the function appends the hexahedra: indices of eight points each, around the bottom
       and likewise around the top, counterclockwise as seen from above, as in the formats of VTK
       and MEDIT
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
        below

\cgalNamedParamsBegin
  \cgalParamNBegin{feature_facets}
    \cgalParamDescription{further facets that lie in planes of the grid}
    \cgalParamType{a range of ranges of 3 vertex indices}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{feature_edges}
    \cgalParamDescription{edges that lie on lines of the grid}
    \cgalParamType{a range of ranges of 2 vertex indices}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{cell_neighbors}
    \cgalParamDescription{for each cell, the 4 cells on the other sides of the facets opposite to
                          its vertices, or negative numbers; see `snap_volume_to_seamless()`}
    \cgalParamType{a range of ranges of 4 integers}
    \cgalParamDefault{found by common vertices}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number}
    \cgalParamDescription{the number of hexahedra above which the extraction is refused}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{100 million}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_location_map}
    \cgalParamDescription{receives the place of each new point: a cell, and barycentric coordinates
                          in it, in the order of the vertices of the cell}
    \cgalParamType{a class model of `WritablePropertyMap` with `std::size_t` as key type, the index
                   of the point, and `std::pair<std::size_t, std::array<double, 4> >` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the outcome and counts; converts to `true` if and only if the hexahedra were written.
        Otherwise `Hexahedra_report::status` is
        - `NOT_MANIFOLD`, `INVALID_ARGUMENT`, `INEXACT_ARITHMETIC`: as for
          `snap_volume_to_seamless()`; or a vertex has no point;
        - `NOT_FINITE`: a coordinate is NaN or infinite, of the map or of a point;
        - `NOT_POSITIVE`: a cell is flipped or degenerate in the domain;
        - `NOT_SEAMLESS`: the two sides of a facet differ by no rotation, exactly;
        - `NOT_ALIGNED`: no coordinate is constant on a facet of the boundary or on a feature facet,
          or more than one changes along a feature edge;
        - `NOT_INTEGER`: a translation is no integer, or a facet of the boundary, a feature, or a
          singular edge is off the grid;
        - `TOO_LARGE`: there would be more hexahedra than `maximum_number`, or a coordinate is
          beyond \f$ 2^{46} \f$;
        - `TOO_COARSE`: a hexahedron has a vertex twice, or two hexahedra share more than one
          quadrilateral, edge, or vertex;
        - `INTERNAL_ERROR`: the result failed the check at the end.
        .
        The message names the place and the remedy.

\par Complexity
Linear in the number of cells, of hexahedra, and of cells that walks from centers of hexahedra to
their corners pass; with a logarithmic factor if a cell contains many vertices of hexahedra.

\sa `snap_volume_to_seamless()`
\sa `is_volume_integer_grid_map()`
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename PointRange,
          typename TetrahedronRange, typename CornerUVWMap, typename HexahedronPointRange,
          typename HexahedronRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Hexahedra_report extract_hexahedra(const PointRange& points, const TetrahedronRange& tetrahedra,
                                   CornerUVWMap uvw_map, HexahedronPointRange& hexahedron_points,
                                   HexahedronRange& hexahedra,
                                   const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Protect_exact_arithmetic protect;
  if(const auto refusal = internal::inexact_arithmetic())
    return internal::refused<Hexahedra_report>(*refusal);
  using CGAL::parameters::get_parameter;
  constexpr auto read =
    internal::named<CGAL::internal_np::cell_neighbors, CGAL::internal_np::feature_edges,
                    CGAL::internal_np::feature_facets, CGAL::internal_np::maximum_number,
                    CGAL::internal_np::vertex_location>;
  const auto& plain = internal::strip(np, read);
  const auto location_map = get_parameter(plain, CGAL::internal_np::vertex_location);
  constexpr bool keeps_locations = internal::is_given<decltype(location_map)>;
  const internal::Extraction_options options{
    internal::chosen(plain, CGAL::internal_np::maximum_number,
                     internal::default_maximum_number_of_hexahedra),
    false, keeps_locations, false};
  internal::Extraction extraction;
  const Hexahedra_report report = internal::extract_soup<ConcurrencyTag>(
    points, tetrahedra, uvw_map, options, plain, extraction);
  if(!report)
    return report;
  const std::size_t first = hexahedron_points.size();
  internal::append_hexahedra(extraction.mesh, hexahedron_points, hexahedra);
  if constexpr(keeps_locations)
    internal::put_locations(extraction, first, location_map);
  return report;
}

} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_EXTRACT_HEXAHEDRA_H
