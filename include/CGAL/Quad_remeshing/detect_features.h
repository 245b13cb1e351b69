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

#ifndef CGAL_QUAD_REMESHING_DETECT_FEATURES_H
#define CGAL_QUAD_REMESHING_DETECT_FEATURES_H

#include <CGAL/license/Quad_remeshing.h>

// Tells whether the sharp edges of a mesh are the edges of a part, or the net of a scan.

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Feature_net.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The surface beside sharp edges. Needles have normals by chance, and so have sharp sides: the face
// on the far side, across the longest side or from it, stands in for a needle at the edge.
template <typename TriangleMesh, typename EdgeIsSharpMap, typename VertexPointMap>
class Sharp_edge_sides
{
  using Vector = CGAL::Simple_cartesian<double>::Vector_3;
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using Edge = typename boost::graph_traits<TriangleMesh>::edge_descriptor;

public:
  Sharp_edge_sides(const TriangleMesh& mesh, const EdgeIsSharpMap& is_sharp,
                   const VertexPointMap& point_map)
    : m_mesh(mesh), m_is_sharp(is_sharp), m_point_map(point_map)
  { }

  // Whether the surface on both sides, for some steps from face to face, bends by much less than at
  // the edge. No step crosses a sharp edge or the border, except from a needle at the edge.
  bool are_smooth(const Edge e) const
  {
    const Halfedge h = halfedge(e, m_mesh), g = opposite(h, m_mesh);
    const Side here = side(h), there = side(g);
    if(here.first_normal == CGAL::NULL_VECTOR || there.first_normal == CGAL::NULL_VECTOR)
      return false;
    constexpr double part = 0.5; // half of the angle is as far from the edge as from a plane
    const double bend = angle(here.first_normal, there.first_normal);
    return here.largest_bend <= part * bend && there.largest_bend <= part * bend;
  }

private:
  struct Side
  {
    Vector first_normal = CGAL::NULL_VECTOR; // of the first face that is no needle
    double largest_bend = 0;
  };

  struct Reached
  {
    Halfedge halfedge; // of the face, on the way to it
    Vector normal;     // of the last face on the way that is no needle
    int steps;
  };

  Side side(const Halfedge h) const
  {
    constexpr int most_steps = 4; // "several edges": the neighbors of neighbors, and theirs
    Side result;
    std::vector<Reached> reached{{h, CGAL::NULL_VECTOR, 0}};
    for(std::size_t i = 0; i < reached.size(); ++i) {
      Reached& here = reached[i];
      if(const Vector own = normal(here.halfedge); own != CGAL::NULL_VECTOR) {
        if(here.normal != CGAL::NULL_VECTOR)
          result.largest_bend = (std::max)(result.largest_bend, angle(here.normal, own));
        else if(result.first_normal == CGAL::NULL_VECTOR)
          result.first_normal = own;
        here.normal = own;
      }
      if(here.steps < most_steps)
        add_neighbors(Reached(here), reached);
    }
    return result;
  }

  void add_neighbors(const Reached& here, std::vector<Reached>& reached) const
  {
    const bool is_at_needle = here.normal == CGAL::NULL_VECTOR;
    for(const Halfedge g : {next(here.halfedge, m_mesh), prev(here.halfedge, m_mesh)}) {
      const Halfedge across = opposite(g, m_mesh);
      const bool may_cross = is_at_needle ? is_longest(g) || is_longest(here.halfedge)
                                          : !get(m_is_sharp, edge(g, m_mesh));
      if(may_cross && !CGAL::is_border(edge(g, m_mesh), m_mesh) &&
         std::none_of(reached.begin(), reached.end(), [&](const Reached& r)
                      { return face(r.halfedge, m_mesh) == face(across, m_mesh); }))
        reached.push_back({across, here.normal, here.steps + 1});
    }
  }

  bool is_longest(const Halfedge h) const
  {
    const double square = vector(h).squared_length();
    return square >= vector(next(h, m_mesh)).squared_length() &&
           square >= vector(prev(h, m_mesh)).squared_length();
  }

  Vector vector(const Halfedge h) const // to the target
  {
    const auto &p = get(m_point_map, source(h, m_mesh)), &q = get(m_point_map, target(h, m_mesh));
    return Vector(CGAL::to_double(q.x() - p.x()), CGAL::to_double(q.y() - p.y()),
                  CGAL::to_double(q.z() - p.z()));
  }

  // The normal of a face, of length 1; or 0, if it is a needle.
  Vector normal(const Halfedge h) const
  {
    constexpr double least_sine = 1e-3; // of the angle at a corner
    const std::array<Vector, 3> sides{vector(h), vector(next(h, m_mesh)), vector(prev(h, m_mesh))};
    const Vector n = CGAL::cross_product(sides[0], sides[1]);
    double longest = 0;
    for(const Vector& v : sides)
      longest = (std::max)(longest, v.squared_length());
    const double size = std::sqrt(n.squared_length());
    return size > least_sine * longest ? n / size : Vector(CGAL::NULL_VECTOR);
  }

  static double angle(const Vector& a, const Vector& b)
  { return std::acos((std::max)(-1., (std::min)(1., a * b))); }

  const TriangleMesh& m_mesh;
  EdgeIsSharpMap m_is_sharp;
  VertexPointMap m_point_map;
};

} // namespace internal

/*!
\ingroup PkgQuadRemeshingRemeshing

The numbers of sharp edges and of features that `detect_features()` has found.
*/
struct Detected_features
{
  /// The number of edges inside that are sharper than the angle.
  std::size_t number_of_sharp_edges = 0;
  /// The number of sharp edges that are features.
  std::size_t number_of_features = 0;
};

/*!
\ingroup PkgQuadRemeshingRemeshing

decides which sharp edges of a mesh are features. The sharp edges of CAD models are; the sharp edges
of scans, voxels, and marching cubes are mostly noise.

`CGAL::Polygon_mesh_processing::detect_sharp_edges()` finds the sharp edges; this function decides
for each connected component whether they are features. They are if more than half of their length
is <em>clear</em>. An edge is clear if both of these hold:
- It lies in a chain that is at least `4 * length` long. A chain is a loop, or it goes from one
  vertex at which features end or meet to the next. A shorter chain has no room for quads.
- Its two sides are smooth: if one goes from the edge into the surface, over up to four faces,
  without crossing a sharp edge, no edge bends the surface by more than half of the angle at the
  sharp edge. On scans, the angles beside a sharp edge are about as large as the angle at the edge.

The function decides for all sharp edges of a component together, because features with gaps are
worse for quads than none. `remove_feature_noise()` then removes single chains that are too short.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam EdgeIsFeatureMap a class model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh a mesh
\param angle_in_deg edges are sharp if the normals of their two faces form at least this angle, in
       degrees. 40 is a good angle for CAD models.
\param length the wanted length of edges of quads, in the unit of the points. If it is 0, chains of
       all lengths count.
\param is_feature is set to `true` for features, and stays as it is for all other edges.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `tmesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
                   `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{numbers of the vertices, from 0}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
                   `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the numbers of sharp edges and of features. Border edges are neither.

\pre `CGAL::is_triangle_mesh(tmesh)`

\par Complexity
Linear in the size of the mesh.

\sa `quad_remesh()`
\sa `remove_feature_noise()`
*/
template <typename TriangleMesh, typename EdgeIsFeatureMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Detected_features detect_features(const TriangleMesh& tmesh, const double angle_in_deg,
                                  const double length, EdgeIsFeatureMap is_feature,
                                  const NamedParameters& np = CGAL::parameters::default_values())
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  using Edge = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
  CGAL_precondition(CGAL::is_triangle_mesh(tmesh));
  constexpr auto read =
    internal::named<CGAL::internal_np::vertex_index, CGAL::internal_np::vertex_point>;
  const auto& stripped = internal::strip(np, read);
  const auto point_map =
    internal::chosen(stripped, CGAL::internal_np::vertex_point,
                     CGAL::get_const_property_map(CGAL::vertex_point, tmesh));
  const auto index_map = CGAL::get_initialized_vertex_index_map(tmesh, stripped);
  const auto is_sharp = get(CGAL::dynamic_edge_property_t<bool>(), tmesh);
  for(const Edge e : edges(tmesh))
    put(is_sharp, e, false);
  PMP::detect_sharp_edges(tmesh, angle_in_deg, is_sharp,
                          CGAL::parameters::vertex_point_map(point_map));
  const auto component = get(CGAL::dynamic_face_property_t<std::size_t>(), tmesh);
  std::vector<double> balance(PMP::connected_components(tmesh, component), 0); // clear - others
  const auto component_of = [&](const Edge e)
    { return get(component, face(halfedge(e, tmesh), tmesh)); };

  std::vector<Edge> sharp_edges;
  const internal::Feature_net net = internal::feature_net(tmesh, is_sharp, point_map, index_map,
                                                          sharp_edges);
  const internal::Sharp_edge_sides sides(tmesh, is_sharp, point_map);
  const std::vector<double> chain_lengths = net.chain_lengths();
  for(std::size_t i = 0; i < sharp_edges.size(); ++i) {
    const bool is_clear = chain_lengths[i] >= 4 * length && sides.are_smooth(sharp_edges[i]);
    balance[component_of(sharp_edges[i])] += (is_clear ? 1 : -1) * net.edge(i).length;
  }
  Detected_features result;
  result.number_of_sharp_edges = sharp_edges.size();
  for(const Edge e : sharp_edges)
    if(balance[component_of(e)] > 0) {
      put(is_feature, e, true);
      ++result.number_of_features;
    }
  return result;
}

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_DETECT_FEATURES_H
