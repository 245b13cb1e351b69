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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_CHECK_UV_MAP_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_CHECK_UV_MAP_H

#include <CGAL/license/Seamless_snapping.h>

// What each public function that takes a uv map asks of the types of mesh and map, with the remedy
// in the compiler's message.

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace CGAL {

template <class TM, class SEM, class SVM>
class Seam_mesh;

namespace Seamless_snapping {
namespace internal {

template <typename TriangleMesh>
struct Is_seam_mesh
  : public std::false_type
{ };

template <class TM, class SEM, class SVM>
struct Is_seam_mesh<CGAL::Seam_mesh<TM, SEM, SVM> >
  : public std::true_type
{ };

// The type of the coordinates of a point.
template <typename Point>
using Coordinate = std::decay_t<decltype(std::declval<const Point&>().x(),
                                         std::declval<const Point&>().y())>;

template <typename Map, typename = void>
struct Is_property_map
  : public std::false_type
{ };

template <typename Map>
struct Is_property_map<Map, std::void_t<typename boost::property_traits<Map>::key_type> >
  : public std::true_type
{ };

template <typename Point, typename = void>
struct Has_two_coordinates
  : public std::false_type
{ };

template <typename Point>
struct Has_two_coordinates<Point, std::void_t<Coordinate<Point> > >
  : public std::is_constructible<Point, Coordinate<Point>, Coordinate<Point> >
{ };

// Whether `Map` holds the coordinates of corners. If not, compiling fails with the reason, and with
// nothing else where the caller goes on only `if constexpr` it does.
template <typename Map, typename Halfedge>
constexpr bool check_map_of_corners()
{
  if constexpr(!Is_property_map<Map>::value) {
    static_assert(sizeof(Map) == 0,
                  "the uv map must be a property map: take one of the mesh, as of "
                  "Surface_mesh::add_property_map<Halfedge_index, Point_2>(), or wrap a container, "
                  "as by boost::make_assoc_property_map()");
    return false;
  } else {
    using Traits = boost::property_traits<Map>;
    constexpr bool has_halfedges = std::is_convertible_v<Halfedge, typename Traits::key_type>;
    constexpr bool has_points = Has_two_coordinates<typename Traits::value_type>::value;
    static_assert(has_halfedges,
                  "the keys of the uv map must be halfedges of the mesh, or integers for a soup: "
                  "each corner has coordinates of its own, those of the halfedge that points to it "
                  "in its face");
    static_assert(!has_halfedges || has_points,
                  "the values of the uv map must be two-dimensional points of a kernel, such as "
                  "CGAL::Simple_cartesian<double>::Point_2: no Point_3, and no containers");
    return has_halfedges && has_points;
  }
}

// The same for a public function.
template <typename TriangleMesh, typename HalfedgeUVMap>
constexpr bool check_uv_map()
{
  constexpr bool is_seam_mesh = Is_seam_mesh<TriangleMesh>::value;
  static_assert(!is_seam_mesh,
                "the seams of a Seam_mesh are borders, where nothing needs to match: pass the mesh "
                "beneath it, with get(uv, target(hd(h), seam_mesh).hd) as the coordinates of each "
                "halfedge h, where hd is the halfedge_descriptor of the Seam_mesh");
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  if constexpr(is_seam_mesh)
    return false;
  else
    return check_map_of_corners<HalfedgeUVMap, Halfedge>();
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_CHECK_UV_MAP_H
