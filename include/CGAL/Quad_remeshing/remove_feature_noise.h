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

#ifndef CGAL_QUAD_REMESHING_REMOVE_FEATURE_NOISE_H
#define CGAL_QUAD_REMESHING_REMOVE_FEATURE_NOISE_H

#include <CGAL/license/Quad_remeshing.h>

// Unmarks feature edges that are noise.

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Feature_net.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// If two sides of a triangle are features or border and meet at a narrow angle, the shorter one is
// no feature if it is close to the other: at the size of quads, they are one. A line that
// only makes a spike there takes the third side. Not so of triangles without area, of which one may
// be the only feature between two faces that have one, and of the tip of a larger flat face, at a
// corner of three features at most.
template <typename TriangleMesh, typename EdgeIsConstrainedMap, typename VertexPointMap>
class Sliver_sides
{
  using Vector = CGAL::Simple_cartesian<double>::Vector_3;
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

public:
  // \param close a distance
  Sliver_sides(const TriangleMesh& mesh, const EdgeIsConstrainedMap& is_feature,
               const VertexPointMap& point_map, const double close)
    : m_mesh(mesh), m_is_feature(is_feature), m_point_map(point_map), m_close(close)
  { }

  void remove()
  {
    for(const auto f : faces(m_mesh))
      for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
        Halfedge shorter = opposite(h, m_mesh), longer = next(h, m_mesh);
        const Halfedge third = next(longer, m_mesh);
        if(next(third, m_mesh) != h || !is_aligned(shorter) || !is_aligned(longer))
          continue;
        if(vector(shorter).squared_length() > vector(longer).squared_length())
          std::swap(shorter, longer);
        if(CGAL::is_border(edge(shorter, m_mesh), m_mesh) || !is_sliver(shorter, longer) ||
           is_tip_of_larger_face(shorter, longer, third))
          continue;
        put(m_is_feature, edge(shorter, m_mesh), false);
        if(!is_aligned(third) && number_at_target(h) == 1 && number_at_target(shorter) > 0) {
          put(m_is_feature, edge(third, m_mesh), true);
          break; // or else, at the next corner, the third side would give way
        }
      }
  }

private:
  Vector vector(const Halfedge h) const // to the target
  {
    const auto &p = get(m_point_map, source(h, m_mesh)), &q = get(m_point_map, target(h, m_mesh));
    return Vector(CGAL::to_double(q.x() - p.x()), CGAL::to_double(q.y() - p.y()),
                  CGAL::to_double(q.z() - p.z()));
  }

  bool is_aligned(const Halfedge h) const
  { return CGAL::is_border(edge(h, m_mesh), m_mesh) || get(m_is_feature, edge(h, m_mesh)); }

  auto number_at_target(const Halfedge h) const
  {
    const auto around = CGAL::halfedges_around_target(h, m_mesh);
    return std::count_if(around.begin(), around.end(),
                         [&](const Halfedge g) { return is_aligned(g); });
  }

  static bool is_narrow(const Vector& a, const Vector& b)
  {
    constexpr double square_of_cosine = 0.75; // of 30 degrees
    const double product = a * b;
    return product > 0 &&
           product * product > square_of_cosine * a.squared_length() * b.squared_length();
  }

  // The end of one vector from the line of the other.
  static double squared_distance(const Vector& a, const Vector& line)
  { return a.squared_length() - (a * line) * (a * line) / line.squared_length(); }

  bool is_sliver(const Halfedge shorter, const Halfedge longer) const
  {
    const Vector a = vector(shorter), b = vector(longer);
    return is_narrow(a, b) && squared_distance(a, b) < m_close * m_close &&
           CGAL::cross_product(a, b) != CGAL::NULL_VECTOR;
  }

  bool is_tip_of_larger_face(const Halfedge shorter, const Halfedge longer,
                             const Halfedge third) const
  {
    return is_flat(third) && number_at_target(opposite(shorter, m_mesh)) <= 3 &&
           leads_away(shorter, vector(longer)) && leads_away(longer, vector(shorter));
  }

  bool is_flat(const Halfedge h) const
  {
    constexpr double least_cosine = 0.995; // of 6 degrees
    if(is_aligned(h) || !CGAL::is_triangle(opposite(h, m_mesh), m_mesh))
      return false;
    const Vector n = normal(h), m = normal(opposite(h, m_mesh));
    return n * m > least_cosine * std::sqrt(n.squared_length() * m.squared_length());
  }

  Vector normal(const Halfedge h) const
  { return CGAL::cross_product(vector(h), vector(next(h, m_mesh))); }

  // Whether the line of features that begins with an edge, in about its direction, gets farther
  // from another line than what is close.
  bool leads_away(Halfedge h, const Vector& line) const
  {
    constexpr int most_edges = 100;
    const Vector first = vector(h);
    Vector sum = first;
    for(int i = 0; i < most_edges; ++i) {
      if(squared_distance(sum, line) > m_close * m_close)
        return true;
      const auto around = CGAL::halfedges_around_source(target(h, m_mesh), m_mesh);
      const auto next = std::find_if(around.begin(), around.end(), [&](const Halfedge g)
                                     { return is_aligned(g) && is_narrow(first, vector(g)); });
      if(next == around.end())
        return false;
      h = *next;
      sum += vector(h);
    }
    return false;
  }

  const TriangleMesh& m_mesh;
  EdgeIsConstrainedMap m_is_feature;
  VertexPointMap m_point_map;
  double m_close;
};

} // namespace internal

/*!
\ingroup PkgQuadRemeshingRemeshing

unmarks feature edges that are noise.

`CGAL::Polygon_mesh_processing::detect_sharp_edges()` finds such edges on scans and on coarse models
of round shapes. `quad_remesh()` would keep each of them, at the price of irregular vertices and
badly shaped quads. The wanted edge length of the quads is a good `length` for this function.

A <em>chain</em> of feature edges is a loop, or leads from one point at which features end or meet
to the next. It has a <em>free end</em> if it ends inside the surface, away from other features. The
function unmarks, in this order, the shortest first:
- one of two sides of a sliver. Slivers have sharp edges by chance, because their normals are not
  reliable. If the other side would end there, the third side becomes a feature in its place. A
  narrow tip of a larger flat face is kept.
- chains with a free end that are shorter than `length`;
- all chains shorter than a multiple of `length`, if the features are a net of noise. They are a net
  of noise if many chains have a free end and many of the remaining chains are short.

After a chain has gone, its neighbors can form one longer chain, which may stay. Border edges are
neither unmarked nor counted. If noise bends most edges by more than the angle of the detection, the
features are a net without free ends, and stay. Smooth such a surface first, or use a larger angle.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam EdgeIsConstrainedMap a class model of `ReadWritePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh a mesh
\param is_feature the feature edges. The function sets noise to `false`, and some third sides of
       slivers to `true`.
\param length a length, in the unit of the points. If it isn't positive, nothing is removed.
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

\return the number of edges that are no longer features

\par Complexity
Linear in the size of the mesh, plus a pass over the features for each round. The number of rounds
is at most the number of chains, and small in practice.

\sa `detect_features()`
\sa `quad_remesh()`
*/
template <typename TriangleMesh, typename EdgeIsConstrainedMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t remove_feature_noise(const TriangleMesh& tmesh, EdgeIsConstrainedMap is_feature,
                                 const double length,
                                 const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr auto read =
    internal::named<CGAL::internal_np::vertex_index, CGAL::internal_np::vertex_point>;
  const auto& stripped = internal::strip(np, read);
  const auto point_map =
    internal::chosen(stripped, CGAL::internal_np::vertex_point,
                     CGAL::get_const_property_map(CGAL::vertex_point, tmesh));
  const auto index_map = CGAL::get_initialized_vertex_index_map(tmesh, stripped);
  if(!(length > 0))
    return 0;
  std::vector<typename boost::graph_traits<TriangleMesh>::edge_descriptor> features_before;
  for(const auto e : edges(tmesh))
    if(!CGAL::is_border(e, tmesh) && get(is_feature, e))
      features_before.push_back(e);
  internal::Sliver_sides(tmesh, is_feature, point_map, length / 3).remove();
  std::vector<typename boost::graph_traits<TriangleMesh>::edge_descriptor> features;
  internal::Feature_net net =
    internal::feature_net(tmesh, is_feature, point_map, index_map, features);
  net.remove_noise(length);
  for(std::size_t i = 0; i < features.size(); ++i)
    if(!net.edge(i).is_kept)
      put(is_feature, features[i], false);
  return std::size_t(std::count_if(features_before.begin(), features_before.end(),
                                   [&](const auto e) { return !get(is_feature, e); }));
}

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_REMOVE_FEATURE_NOISE_H
