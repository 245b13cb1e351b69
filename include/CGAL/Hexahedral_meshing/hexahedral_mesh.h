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

#ifndef CGAL_HEXAHEDRAL_MESHING_HEXAHEDRAL_MESH_H
#define CGAL_HEXAHEDRAL_MESHING_HEXAHEDRAL_MESH_H

#include <CGAL/license/Hexahedral_meshing.h>

// From an approximately seamless map of a tetrahedral mesh to hexahedra, in one call.

#include <CGAL/Hexahedral_meshing/extract_hexahedra.h>
#include <CGAL/Hexahedral_meshing/internal/hexahedra/Hexahedron.h>
#include <CGAL/Hexahedral_meshing/internal/shape/move_vertices.h>
#include <CGAL/Hexahedral_meshing/measure_hexahedra.h>
#include <CGAL/Hexahedral_meshing/types/Hexahedral_mesh.h>
#include <CGAL/Hexahedral_meshing/types/Hexahedral_meshing_report.h>
#include <CGAL/Seamless_snapping/snap_volume_to_seamless.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {

/// \cond SKIP_IN_MANUAL
namespace internal {

// A parameter in front of a chain: it counts, whether the chain has it or not.
template <typename Value, typename Tag, typename NP>
auto with(const NP& np, const Tag, const Value& value)
{
  return CGAL::Named_function_parameters<Value, Tag, NP>(value, np);
}

// Replaces elements by their indices in the caller's range of features, or by -1.
// \param corners_of(element) returns its corners
template <typename Range, typename CornersOf>
void find_features(const Range& range, const Flat_volume& volume, const CornersOf& corners_of,
                   std::vector<std::int32_t>& elements)
{
  using Names = std::vector<std::int64_t>; // of vertices, ascending
  std::map<Names, std::int32_t> indices;
  std::int32_t index = 0;
  if constexpr(is_given<Range>)
    for(const auto& feature : range)
      indices.emplace(sorted(Names(std::begin(feature), std::end(feature))), index++);
  for(std::int32_t& element : elements) {
    Names names;
    for(const Corner_index corner : corners_of(std::size_t(element)))
      names.push_back(volume.vertex_names[std::size_t(volume.vertex(corner))]);
    const auto found = indices.find(sorted(names));
    element = found != indices.end() ? found->second : -1;
  }
}

template <typename NamedParameters>
void find_features(const NamedParameters& np, Extraction& extraction)
{
  using CGAL::parameters::get_parameter_reference;
  const Flat_volume& volume = extraction.volume;
  find_features(get_parameter_reference(np, CGAL::internal_np::feature_facets), volume,
                [&](const std::size_t i) { return corners_of_facet(volume.aligned_facets[i]); },
                extraction.mesh.feature_facets);
  find_features(get_parameter_reference(np, CGAL::internal_np::feature_edges), volume,
                [&](const std::size_t i) {
                  const Flat_volume::Aligned_edge& line = extraction.complex.lines[i];
                  return std::array<Corner_index, 2>{{line.a, line.b}};
                }, extraction.mesh.feature_edges);
}

// The integers for a number of hexahedra: tries one scale after the other.
template <typename ConcurrencyTag, typename PointRange, typename TetrahedronRange,
          typename NamedParameters>
class Integer_search
{
  using Point_3 = CGAL::Simple_cartesian<double>::Point_3;

public:
  Integer_search(const PointRange& points, const TetrahedronRange& tetrahedra,
                 std::vector<Point_3> uvw, const NamedParameters& np, Extraction& extraction,
                 Hexahedral_meshing_report& report)
    : m_points(points), m_tetrahedra(tetrahedra), m_uvw(std::move(uvw)), m_np(np),
      m_extraction(extraction), m_report(report),
      m_target(chosen(np, CGAL::internal_np::target_number_of_hexahedra, std::size_t(0))),
      m_most(chosen(np, CGAL::internal_np::maximum_number,
                    m_target > 0 ? most_per_target * m_target
                                 : default_maximum_number_of_hexahedra))
  { }

  void run()
  {
    if(m_target > m_most) {
      m_report.status = Outcome::INVALID_ARGUMENT;
      m_report.message = std::to_string(m_target) + " hexahedra are wanted, but at most " +
                         std::to_string(m_most) + " are allowed" + remedy("raise maximum_number");
      return;
    }
    const double volume = volume_in_domain();
    double scale = 1;
    if(m_target > 0 && volume > 0 && std::isfinite(volume))
      scale = std::cbrt(double(m_target) / volume);
    do {
      m_report.grid_scale = scale;
      ++m_report.number_of_attempts;
      attempt(scale);
      if(m_report || !may_be_too_coarse())
        return;
      if(m_report.reason_for_more.empty())
        m_report.reason_for_more =
          to_string(m_report.status) + (": " + m_report.message.without_remedies());
      scale *= std::cbrt(2.);
    } while(m_target > 0 && scale * scale * scale * volume <= double(m_most));
    if(m_target > 0)
      m_report.message += "; with " + counted(m_report.number_of_attempts, "scale") +
                          ", for up to " + std::to_string(m_most) +
                          " hexahedra, none was without such faults" +
                          remedy("raise maximum_number");
  }

private:
  static constexpr std::size_t most_per_target = 64; // six times twice as many

  double volume_in_domain() const
  {
    double result = 0;
    for(std::size_t i = 0; i + 3 < m_uvw.size(); i += 4) {
      Uvw_tetrahedron u;
      for(std::size_t k = 0; k < 4; ++k)
        u[k] = {m_uvw[i + k].x(), m_uvw[i + k].y(), m_uvw[i + k].z()};
      result += std::abs(six_times_volume(u)) / 6; // cells may be listed in either orientation
    }
    return result;
  }

  // Whether a finer grid may help.
  bool may_be_too_coarse() const
  {
    return m_report.status == Outcome::NOT_INTEGER || m_report.status == Outcome::NOT_POSITIVE ||
           m_report.status == Outcome::TOO_COARSE;
  }

  void attempt(const double scale)
  {
    namespace np = CGAL::internal_np;
    std::vector<Point_3> uvw(m_uvw);
    const auto uvw_map = CGAL::make_property_map(uvw);
    const auto grid = with(with(with(m_np, np::integer_grid, true), np::grid_scale, scale),
                           np::align_boundary, true);
    const bool is_near = m_target == 0; // the map is near an integer-grid map
    Report& report = m_report;
    report = snap_volume(
      m_tetrahedra, uvw_map,
      with(with(grid, np::rounding_tolerance, is_near ? default_rounding_tolerance : any_distance),
           np::repair_flips, is_near ? Flip_repair::NONE : Flip_repair::UNTANGLE));
    if(report.status == Outcome::FLIPS_REMAIN)
      report.status = Outcome::NOT_POSITIVE; // the message tells which, and why
    if(!report)
      return;
    m_extraction = Extraction();
    static_cast<Hexahedra_report&>(m_report) = extract_soup<ConcurrencyTag>(
      m_points, m_tetrahedra, uvw_map, {m_most, false, false, true}, m_np,
      m_extraction);
  }

  static constexpr double any_distance = 1e9;

  const PointRange& m_points;
  const TetrahedronRange& m_tetrahedra;
  const std::vector<Point_3> m_uvw;
  const NamedParameters& m_np;
  Extraction& m_extraction;
  Hexahedral_meshing_report& m_report;
  const std::size_t m_target, m_most;
};

} // namespace internal
/// \endcond

/*!
\ingroup PkgHexahedralMeshingRef

computes a hexahedral mesh from a tetrahedral mesh with a seamless map.

The function makes the map an integer-grid map by `snap_volume_to_seamless()`, and extracts
hexahedra by `extract_hexahedra()`. Then it moves vertices to make hexahedra positive in space, if
possible.

On success, all that `extract_hexahedra()` guarantees holds. The mesh has the boundary and the
features of the input: quadrilaterals on the boundary and on feature facets, and edges on feature
edges and on sharp edges of the boundary. Vertices move inside, along the boundary of the
tetrahedra, along feature facets, and along the curves of these edges; vertices at the ends of
curves stay. Moves keep positive corners positive. `Hexahedron_shapes::nonpositive_hexahedra` of
`Hexahedral_meshing_report::shapes` lists the hexahedra that are not positive.

Without `target_number_of_hexahedra`, the function does not scale the map, and refuses it unless it
is near an integer-grid map. Most maps need the parameter.

\tparam ConcurrencyTag as for `extract_hexahedra()`
\tparam PointRange as for `extract_hexahedra()`
\tparam TetrahedronRange as for `extract_hexahedra()`
\tparam CornerUVWMap as for `extract_hexahedra()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points of the vertices of the tetrahedra
\param tetrahedra the cells: the indices of four points each
\param uvw_map the coordinates of each corner, seamless up to `tolerance`; it is only read
\param mesh receives the result; it is as before if the function fails
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below, and `feature_facets`, `feature_edges`, `cell_neighbors`, `tolerance`,
       `number_of_untangling_iterations`, `visitor`, and `verbose` of `snap_volume_to_seamless()`

\cgalNamedParamsBegin
  \cgalParamNBegin{target_number_of_hexahedra}
    \cgalParamDescription{about how many hexahedra to make. The function scales the map to this
                          volume first. If cells collapse, it doubles the number and tries again.}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{0: the function does not scale the map}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number}
    \cgalParamDescription{the number of hexahedra above which the function gives up; at least
                          `target_number_of_hexahedra`}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{64 times `target_number_of_hexahedra`; without this parameter, 100 million}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the largest number of rounds in which vertices move; 0 leaves all vertices
                          in their places}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{20}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the outcome, counts, and the shapes; converts to `true` if and only if the mesh was
        written. Otherwise, the status is the status of the step that failed:
        - a status of `snap_volume_to_seamless()`, for example `NOT_SEAMLESS`, `NOT_ALIGNED`, or,
          if the integers are too far without `target_number_of_hexahedra`, `NOT_INTEGER`;
        - a status of `extract_hexahedra()`: for example `NOT_POSITIVE` or `TOO_COARSE`, if cells
          collapse or hexahedra meet twice for each number of hexahedra up to `maximum_number`;
        - `INVALID_ARGUMENT`: `maximum_number` is less than `target_number_of_hexahedra`;
        - `TOO_LARGE`: there would be more hexahedra than `maximum_number`.
        .
        The message names the place and the remedy.

\par Complexity
The complexity of the steps, for each scale that the function tries. In addition, each round of
moves takes linear time to find hexahedra that are not positive, and time in the number of
hexahedra near these.

\sa `extract_hexahedra()`
\sa `snap_volume_to_seamless()`
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename PointRange,
          typename TetrahedronRange, typename CornerUVWMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Hexahedral_meshing_report
hexahedral_mesh(const PointRange& points, const TetrahedronRange& tetrahedra, CornerUVWMap uvw_map,
                Hexahedral_mesh& mesh,
                const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Protect_exact_arithmetic protect;
  if(const auto refusal = internal::inexact_arithmetic())
    return internal::refused<Hexahedral_meshing_report>(*refusal);
  constexpr auto read =
    internal::named<CGAL::internal_np::cell_neighbors, CGAL::internal_np::feature_edges,
                    CGAL::internal_np::feature_facets, CGAL::internal_np::maximum_number,
                    CGAL::internal_np::number_of_iterations,
                    CGAL::internal_np::target_number_of_hexahedra, CGAL::internal_np::tolerance,
                    CGAL::internal_np::untangling_iterations, CGAL::internal_np::verbose,
                    CGAL::internal_np::visitor>;
  const auto& plain = internal::strip(np, read);
  using Plain = std::decay_t<decltype(plain)>;
  std::vector<CGAL::Simple_cartesian<double>::Point_3> uvw;
  for(std::size_t i = 0; i < 4 * static_cast<std::size_t>(tetrahedra.size()); ++i) {
    const internal::Uvw u = internal::get_uvw(uvw_map, i);
    uvw.emplace_back(u[0], u[1], u[2]);
  }
  internal::Extraction extraction;
  Hexahedral_meshing_report report;
  internal::Integer_search<ConcurrencyTag, PointRange, TetrahedronRange, Plain>(
    points, tetrahedra, std::move(uvw), plain, extraction, report).run();
  if(!report)
    return report;
  internal::find_features(plain, extraction);
  Hexahedral_mesh& result = extraction.mesh;
  report.shapes_before = measure_hexahedra(result.points, result.hexahedra);
  report.shapes = report.shapes_before;
  const std::size_t rounds =
    internal::chosen(plain, CGAL::internal_np::number_of_iterations, std::size_t(20));
  if(!report.shapes.nonpositive_hexahedra.empty() && rounds > 0) {
    internal::move_vertices(extraction, rounds);
    report.shapes = measure_hexahedra(result.points, result.hexahedra);
  }
  mesh = std::move(result);
  return report;
}

} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_HEXAHEDRAL_MESH_H
