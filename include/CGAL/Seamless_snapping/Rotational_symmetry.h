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

#ifndef CGAL_SEAMLESS_SNAPPING_ROTATIONAL_SYMMETRY_H
#define CGAL_SEAMLESS_SNAPPING_ROTATIONAL_SYMMETRY_H

#include <CGAL/license/Seamless_snapping.h>

// The symmetry of a parametrization, and the lattice coordinates that N = 3 and N = 6 need.

#include <CGAL/Seamless_snapping/internal/mesh/check_uv_map.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingSymmetry

The rotations that the transitions of a parametrization may have: by multiples of \f$ 360 / N \f$
degrees. Objects are values of the named parameter `rotational_symmetry`.

For \f$ N = 1, 2, 4 \f$ coordinates are Cartesian. For \f$ N = 3, 6 \f$ they are <em>lattice
coordinates</em>: \f$ (a, b) \f$ stands for the point \f$ a + b \omega \f$, where \f$ \omega \f$ is
the unit vector at 60 degrees. The rotations are integer matrices then; that by 60 degrees takes
\f$ (a, b) \f$ to \f$ (-b, a + b) \f$. In Cartesian coordinates no such map can be exact: the
image of \f$ (x, y) \ne 0 \f$ is
\f$ (x / 2 - \sqrt 3 y / 2, \sqrt 3 x / 2 + y / 2) \f$, and \f$ \sqrt 3 \f$ is irrational,
so that not all four numbers are floating point numbers.

Isocurves run in three directions for \f$ N = 3, 6 \f$: where \f$ a \f$, \f$ b \f$, or
\f$ a + b \f$ is constant. These are the components 0, 1, and 2 of constraints. Tolerances and
violations are those of the largest of the three; changes, which `Snapping_report` tells, are those
of Cartesian coordinates.

\tparam N 1, 2, 3, 4, or 6

\sa `convert_to_lattice_coordinates()`
*/
template <int N>
struct Rotational_symmetry
{
  static_assert(N == 1 || N == 2 || N == 3 || N == 4 || N == 6,
                "the order of a rotational symmetry is 1, 2, 3, 4, or 6");
};

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
\tparam HalfedgeUVMap a model of `ReadWritePropertyMap` as for `snap_to_seamless()`, whose corners
        share no place in memory

\param tmesh the mesh
\param uv_map the coordinates of each corner

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

\tparam TriangleMesh a model of `FaceListGraph`
\tparam HalfedgeUVMap a model of `ReadWritePropertyMap` as for `snap_to_seamless()`, whose corners
        share no place in memory

\param tmesh the mesh
\param uv_map the coordinates of each corner

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

#endif // CGAL_SEAMLESS_SNAPPING_ROTATIONAL_SYMMETRY_H
