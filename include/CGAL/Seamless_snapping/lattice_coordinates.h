// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_LATTICE_COORDINATES_H
#define CGAL_SEAMLESS_SNAPPING_LATTICE_COORDINATES_H

#include <CGAL/license/Seamless_snapping.h>

// To the lattice coordinates that parametrizations of symmetry 3 and 6 have, and back.

#include <CGAL/Seamless_snapping/internal/mesh/check_uv_map.h>
#include <CGAL/Seamless_snapping/types/Rotational_symmetry.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Seamless_snapping {

namespace internal {

constexpr double lattice_height = 0.86602540378443864676; // of its triangle: sqrt(3) / 2

// Replaces the coordinates of all corners.
template <typename TriangleMesh, typename HalfedgeUVMap, typename Conversion>
void convert_coordinates(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                         const Conversion& conversion)
{
  if constexpr(check_uv_map<TriangleMesh, HalfedgeUVMap>()) {
    using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;
    using Number = std::decay_t<decltype(std::declval<const Point&>().x())>;
    for(const auto f : faces(tmesh))
      for(const auto h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh)) {
        const Point p = get(uv_map, h);
        const std::pair<double, double> q = conversion(double(p.x()), double(p.y()));
        put(uv_map, h, Point(Number(q.first), Number(q.second)));
      }
  }
}

} // namespace internal

/*!
\ingroup PkgSeamlessSnappingSymmetry

converts a parametrization from Cartesian coordinates \f$ (x, y) \f$ to lattice coordinates, those
of \f$ N = 3, 6 \f$: \f$ (x - y / \sqrt 3, 2 y / \sqrt 3) \f$, rounded. Orientations stay, but for
those of faces that are nearly degenerate. Corners with the same coordinates keep the same.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh` and of `ReadWritePropertyMap`,
        whose corners share no place in memory

\param tmesh the mesh
\param uv_map the coordinates of each corner

\par Complexity
Linear in the number of faces.

\sa `convert_to_cartesian_coordinates()`
*/
template <typename TriangleMesh, typename HalfedgeUVMap>
void convert_to_lattice_coordinates(const TriangleMesh& tmesh, HalfedgeUVMap uv_map)
{
  internal::convert_coordinates(tmesh, uv_map, [](const double x, const double y) {
    const double b = y / internal::lattice_height;
    return std::make_pair(x - b / 2, b);
  });
}

/*!
\ingroup PkgSeamlessSnappingSymmetry

converts a parametrization from lattice coordinates \f$ (a, b) \f$ to Cartesian ones:
\f$ (a + b / 2, b \sqrt 3 / 2) \f$, rounded. What is exactly seamless in lattice coordinates is not,
in general, in these: convert for pictures and measurements, not to go on from there.

Parameters and complexity are those of `convert_to_lattice_coordinates()`.

\sa `convert_to_lattice_coordinates()`
*/
template <typename TriangleMesh, typename HalfedgeUVMap>
void convert_to_cartesian_coordinates(const TriangleMesh& tmesh, HalfedgeUVMap uv_map)
{
  internal::convert_coordinates(tmesh, uv_map, [](const double a, const double b) {
    return std::make_pair(a + b / 2, b * internal::lattice_height);
  });
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_LATTICE_COORDINATES_H
