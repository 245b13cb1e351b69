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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_UV_SURFACE_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_UV_SURFACE_H

#include <CGAL/license/Seamless_snapping.h>

// A mesh, a uv map, and indices of vertices as one: all functions that the steps of snapping need.
// These are templates of a `Surface` with the functions below: of this one, or of a copy in plain
// arrays, a `Flat_surface`.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/write_all_or_nothing.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/adaptor/transformed.hpp>

#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

template <class TM, class SEM, class SVM>
class Seam_mesh;

namespace Seamless_snapping {
namespace internal {

// The conditions of all public functions with a uv map on the types of mesh and map. The remedy is
// in the compiler's message.
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
                  "each corner has its own coordinates, and the halfedge in its face that points "
                  "to it is the key");
    static_assert(!has_halfedges || has_points,
                  "the values of the uv map must be two-dimensional points of a kernel, such as "
                  "CGAL::Simple_cartesian<double>::Point_2: no Point_3, and no containers");
    return has_halfedges && has_points;
  }
}

// Checks the map of a public function.
template <typename TriangleMesh, typename HalfedgeUVMap>
constexpr bool check_uv_map()
{
  constexpr bool is_seam_mesh = Is_seam_mesh<TriangleMesh>::value;
  static_assert(!is_seam_mesh,
                "the seams of a Seam_mesh are borders, and nothing has to match there: pass the "
                "underlying mesh, with get(uv, target(hd(h), seam_mesh).hd) as the coordinates of "
                "each halfedge h, where hd is the halfedge_descriptor of the Seam_mesh");
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  if constexpr(is_seam_mesh)
    return false;
  else
    return check_map_of_corners<HalfedgeUVMap, Halfedge>();
}

template <typename HalfedgeUVMap, typename Halfedge>
Uv get_uv(const HalfedgeUVMap& uv_map, const Halfedge h)
{
  if constexpr(check_map_of_corners<HalfedgeUVMap, Halfedge>()) {
    const auto& p = get(uv_map, h);
    return {static_cast<double>(p.x()), static_cast<double>(p.y())};
  }
}

// For members of the same names as the graph's functions.
template <typename Halfedge, typename Graph>
Halfedge opposite_in(const Graph& graph, const Halfedge h) { return opposite(h, graph); }
template <typename Halfedge, typename Graph>
Halfedge next_in(const Graph& graph, const Halfedge h) { return next(h, graph); }
template <typename Halfedge, typename Graph>
Halfedge prev_in(const Graph& graph, const Halfedge h) { return prev(h, graph); }
template <typename Halfedge, typename Graph>
bool is_border_in(const Graph& graph, const Halfedge h) { return is_border(h, graph); }

// For what needs none.
struct No_indices { };

// The names of vertices in messages; none if these are their indices. Index maps with names have an
// overload.
template <typename VertexIndexMap>
const std::vector<std::size_t>* vertex_names(const VertexIndexMap&) { return nullptr; }

// As a graph, halfedges have faces or are on the border; a halfedge stands for the corner of its
// face at its target, too. It refers to the mesh.
template <typename TriangleMesh, typename HalfedgeUVMap, typename VertexIndexMap>
class Uv_surface
{
  using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;

public:
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using Number = typename Map_number<HalfedgeUVMap>::type;

  // \param has_given_indices whether the indices are the caller's, and may be wrong
  Uv_surface(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
             const VertexIndexMap& vertex_indices, const bool has_given_indices = false)
    : m_tmesh(tmesh), m_uv_map(uv_map), m_vertex_indices(vertex_indices),
      m_has_given_indices(has_given_indices)
  { }

  std::size_t number_of_vertices() const { return std::size_t(num_vertices(m_tmesh)); }
  std::size_t number_of_edges() const { return std::size_t(num_edges(m_tmesh)); }
  // num_faces() counts removed ones too
  std::size_t number_of_faces() const { return std::size_t(faces(m_tmesh).size()); }

  // Ranges of halfedges; of a vertex, one towards it, or the null one.
  auto one_per_face() const { return faces(m_tmesh) | halfedges_of(); }
  auto one_per_edge() const { return edges(m_tmesh) | halfedges_of(); }
  auto one_per_vertex() const { return vertices(m_tmesh) | halfedges_of(); }
  static Halfedge null_halfedge() { return boost::graph_traits<TriangleMesh>::null_halfedge(); }

  Halfedge opposite(const Halfedge h) const { return opposite_in(m_tmesh, h); }
  Halfedge next(const Halfedge h) const { return next_in(m_tmesh, h); }
  Halfedge prev(const Halfedge h) const { return prev_in(m_tmesh, h); }
  bool is_border(const Halfedge h) const { return is_border_in(m_tmesh, h); }
  // \pre `h` has a face
  Halfedge first_in_face(const Halfedge h) const { return halfedge(face(h, m_tmesh), m_tmesh); }

  // The indices of the target and the source.
  std::size_t vertex(const Halfedge h) const
  { return std::size_t(get(m_vertex_indices, target(h, m_tmesh))); }
  std::size_t source(const Halfedge h) const { return vertex(opposite(h)); }
  const std::vector<std::size_t>* names() const { return vertex_names(m_vertex_indices); }

  // The coordinates of the corner of a halfedge.
  Uv uv(const Halfedge h) const { return get_uv(m_uv_map, h); }
  void set_uv(const Halfedge h, const Uv& uv)
  { put(m_uv_map, h, Point(static_cast<Number>(uv[0]), static_cast<Number>(uv[1]))); }

  // Points are compared where they are: copying them first would take as long again.
  bool have_same_uv(const Halfedge g, const Halfedge h) const
  {
    const auto& p = get(m_uv_map, g);
    const auto& q = get(m_uv_map, h);
    return (int(p.x() == q.x()) & int(p.y() == q.y())) != 0; // without branches
  }

  // Asks for the memory of coordinates ahead of their use, if the map refers to memory. On large
  // meshes, loops over the corners wait for little else.
  void prefetch(const Halfedge h) const
  {
#if defined(__GNUC__) || defined(__clang__)
    if constexpr(std::is_lvalue_reference<decltype(get(m_uv_map, h))>::value)
      __builtin_prefetch(&get(m_uv_map, h));
#endif
    (void)h;
  }

  Number_format format() const { return Number_format::of<Number>(); }
  double epsilon() const { return std::numeric_limits<Number>::epsilon(); }

  // Whether indices are as for CGAL's functions: different, and less than the number of vertices.
  // Callers can give others, which would be places outside of arrays.
  bool has_valid_indices() const
  {
    if(!m_has_given_indices)
      return true;
    std::vector<bool> is_taken(number_of_vertices(), false);
    for(const auto v : vertices(m_tmesh)) {
      const std::size_t i = std::size_t(get(m_vertex_indices, v));
      if(i >= is_taken.size() || is_taken[i])
        return false;
      is_taken[i] = true;
    }
    return true;
  }

private:
  struct Halfedge_of
  {
    const TriangleMesh* tmesh;

    template <typename Cell> // a face, an edge, or a vertex
    Halfedge operator()(const Cell& cell) const { return halfedge(cell, *tmesh); }
  };

  auto halfedges_of() const { return boost::adaptors::transformed(Halfedge_of{&m_tmesh}); }

  const TriangleMesh& m_tmesh;
  HalfedgeUVMap m_uv_map;
  VertexIndexMap m_vertex_indices;
  bool m_has_given_indices;
};

template <typename Surface>
Uv_triangle uv_triangle(const Surface& surface, const typename Surface::Halfedge corner)
{
  return {{surface.uv(corner), surface.uv(surface.next(corner)),
           surface.uv(surface.prev(corner))}};
}

// All halfedges towards the target of one, clockwise from it: calls `f(h)`.
template <typename Surface, typename F>
void for_each_around_target(const Surface& surface, const typename Surface::Halfedge first,
                            const F& f)
{
  typename Surface::Halfedge h = first;
  do {
    f(h);
    h = surface.opposite(surface.next(h));
  } while(h != first);
}

template <typename Surface>
bool lies_on_border(const Surface& surface, const typename Surface::Halfedge h)
{ return surface.is_border(h) || surface.is_border(surface.opposite(h)); }

template <typename Surface>
bool has_border_at_target(const Surface& surface, const typename Surface::Halfedge first)
{
  bool result = false;
  for_each_around_target(surface, first,
                         [&](const auto h) { result = result || surface.is_border(h); });
  return result;
}

// For messages.
template <typename Surface>
Message vertex_name(const Surface& surface, const typename Surface::Halfedge h,
                    const std::string& noun = "vertex")
{
  const std::size_t v = surface.vertex(h);
  return name_of_vertex(surface.names() == nullptr ? v : (*surface.names())[v], noun);
}

template <typename Surface>
Message edge_name(const Surface& surface, const typename Surface::Halfedge h)
{
  return "the edge between " + vertex_name(surface, surface.opposite(h), "vertices") + " and " +
         vertex_name(surface, h, "");
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_UV_SURFACE_H
