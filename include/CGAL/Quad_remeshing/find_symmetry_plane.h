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

#ifndef CGAL_QUAD_REMESHING_FIND_SYMMETRY_PLANE_H
#define CGAL_QUAD_REMESHING_FIND_SYMMETRY_PLANE_H

#include <CGAL/license/Quad_remeshing.h>

// Which plane a mesh is symmetric by.

#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Twice the coordinate of the plane across an axis by which the points are symmetric, if each has
// an image among them, exactly. It lies in the middle between the outermost points. Points that all
// lie on a plane are not taken for images of themselves.
inline std::optional<double>
find_doubled_offset(const std::vector<std::array<double, 3> >& sorted, const std::size_t axis)
{
  const auto [lowest, highest] =
    std::minmax_element(sorted.begin(), sorted.end(),
                        [&](const auto& p, const auto& q) { return p[axis] < q[axis]; });
  const Exact_difference sum((*highest)[axis], -(*lowest)[axis]);
  if(!sum.is_valid() || sum.error != 0 || (*lowest)[axis] == (*highest)[axis])
    return std::nullopt;
  std::vector<std::array<double, 3> > images(sorted);
  for(std::array<double, 3>& p : images) {
    const Exact_difference image(sum.rounded, p[axis]);
    if(image.error != 0)
      return std::nullopt;
    p[axis] = image.rounded;
  }
  std::sort(images.begin(), images.end());
  return images == sorted ? std::optional<double>(sum.rounded) : std::nullopt;
}

} // namespace internal

/*!
\ingroup PkgQuadRemeshingQuads

finds a plane by which the vertices of a mesh are symmetric: each has an image among them, exactly.
A plane that all vertices lie on is not meant. Planes perpendicular to a coordinate axis are looked
for, first to the x-axis. Whether the faces are symmetric does not matter.

\tparam TriangleMesh a model of `VertexListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh a mesh with at least one vertex
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `tmesh`, whose coordinates are doubles or
                          floats}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
                   `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the plane, for the parameter `symmetry_plane` of `quad_remesh()`, if there is one

\par Complexity
The vertices are sorted six times at most.

\sa `quad_remesh()`
*/
template <typename TriangleMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto find_symmetry_plane(const TriangleMesh& tmesh,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Protect_exact_arithmetic protect;
  const auto point_map = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(internal::strip(np), CGAL::internal_np::vertex_point),
    CGAL::get_const_property_map(CGAL::vertex_point, tmesh));
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)> >::value_type;
  using Kernel = typename CGAL::Kernel_traits<Point>::Kernel;
  using FT = typename Kernel::FT;
  std::vector<std::array<double, 3> > points;
  for(const auto v : vertices(tmesh)) {
    const auto& p = get(point_map, v);
    points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  }
  std::sort(points.begin(), points.end());
  std::optional<typename Kernel::Plane_3> result;
  for(std::size_t axis = 0; axis < 3 && !points.empty() && !result; ++axis)
    if(const auto doubled = internal::find_doubled_offset(points, axis);
       doubled && CGAL::to_double(FT(*doubled / 2)) == *doubled / 2) {
      const auto unit = [&](const std::size_t i) { return FT(i == axis ? 1 : 0); };
      result = typename Kernel::Plane_3(unit(0), unit(1), unit(2), FT(-*doubled / 2));
    }
  return result;
}

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_FIND_SYMMETRY_PLANE_H
