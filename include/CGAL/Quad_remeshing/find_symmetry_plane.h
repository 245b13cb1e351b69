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

// Finds a plane across a coordinate axis by which the vertices of a mesh are symmetric.

#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// By how much points differ from their mirror images by planes across the axes.
class Mirror_search
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel> >;

public:
  using Point = Kernel::Point_3;

  struct Result
  {
    int axis;
    double coordinate, distance; // of the image of a point from the nearest point, at most
  };

  // \pre there is a point
  explicit Mirror_search(const std::vector<Point>& points)
    : m_points(points), m_box(CGAL::bbox_3(points.begin(), points.end())),
      m_tree(points.begin(), points.end())
  { }

  double diagonal() const
  { return std::hypot(m_box.x_span(), m_box.y_span(), m_box.z_span()); }

  // The plane by which images are nearest in the mean, in relation to the extent along its axis;
  // nothing if an image is farther from the nearest point than `largest`.
  // \param rounding a plane that is no farther from the origin goes through it
  std::optional<Result> nearest(const double largest, const double rounding) const
  {
    Result result{-1, 0, 0};
    double least = std::numeric_limits<double>::infinity();
    for(int axis = 0; axis < 3; ++axis) {
      const double extent = m_box.max(axis) - m_box.min(axis);
      if(extent == 0)
        continue;
      for(const double first : {(m_box.min(axis) + m_box.max(axis)) / 2, mean(axis)}) {
        double coordinate = middle_of_pairs(axis, first);
        if(std::abs(coordinate) <= rounding)
          coordinate = 0;
        const double distance = mean_distance(axis, coordinate) / extent;
        if(distance < least) {
          least = distance;
          result = {axis, coordinate, 0};
        }
      }
    }
    if(result.axis >= 0)
      result.distance = largest_distance(result.axis, result.coordinate, largest);
    return result.axis >= 0 && result.distance <= largest ? std::optional(result) : std::nullopt;
  }

private:
  double mean(const int axis) const
  {
    double sum = 0;
    for(const Point& p : m_points)
      sum += p[axis] / double(m_points.size());
    return sum;
  }

  static Point image(const Point& p, const int axis, const double coordinate)
  {
    std::array<double, 3> q{p.x(), p.y(), p.z()};
    q[std::size_t(axis)] = 2 * coordinate - q[std::size_t(axis)];
    return Point(q[0], q[1], q[2]);
  }

  // Some thousand points, each as many places from the next, stand for all.
  std::size_t stride() const
  {
    constexpr std::size_t most = 2000;
    return 1 + m_points.size() / most;
  }

  // The median of the middles between points and the points nearest to their images: a few points
  // that have no image do not move it.
  double middle_of_pairs(const int axis, const double coordinate) const
  {
    std::vector<double> middles;
    for(std::size_t i = 0; i < m_points.size(); i += stride()) {
      const Search search(m_tree, image(m_points[i], axis, coordinate));
      middles.push_back((m_points[i][axis] + search.begin()->first[axis]) / 2);
    }
    const auto middle = middles.begin() + std::ptrdiff_t(middles.size() / 2);
    std::nth_element(middles.begin(), middle, middles.end());
    return *middle;
  }

  // The mean distance of images from the nearest points. One point that sticks out hardly counts.
  double mean_distance(const int axis, const double coordinate) const
  {
    double sum = 0;
    for(std::size_t i = 0; i < m_points.size(); i += stride()) {
      const Search search(m_tree, image(m_points[i], axis, coordinate));
      sum += std::sqrt(search.begin()->second) * double(stride()) / double(m_points.size());
    }
    return sum;
  }

  // The largest distance of an image from the nearest point, or one that is larger than `most`.
  double largest_distance(const int axis, const double coordinate, const double most) const
  {
    double result = 0;
    for(std::size_t i = 0; i < m_points.size() && result <= most; ++i) {
      const Search search(m_tree, image(m_points[i], axis, coordinate));
      result = (std::max)(result, std::sqrt(search.begin()->second));
    }
    return result;
  }

  const std::vector<Point>& m_points;
  CGAL::Bbox_3 m_box;
  Search::Tree m_tree;
};

// Twice the coordinate of the plane across an axis by which the points are symmetric, if each has
// an image among them, exactly. It lies in the middle between the outermost points. Points that all
// lie on a plane are not taken for images of themselves.
inline std::optional<double>
find_doubled_offset(const std::vector<Mirror_search::Point>& sorted, const int axis)
{
  const auto [lowest, highest] =
    std::minmax_element(sorted.begin(), sorted.end(),
                        [&](const auto& p, const auto& q) { return p[axis] < q[axis]; });
  const Exact_difference sum((*highest)[axis], -(*lowest)[axis]);
  if(!sum.is_valid() || sum.error != 0 || (*lowest)[axis] == (*highest)[axis])
    return std::nullopt;
  std::vector<Mirror_search::Point> images;
  for(const Mirror_search::Point& p : sorted) {
    const Exact_difference image(sum.rounded, p[axis]);
    if(image.error != 0)
      return std::nullopt;
    std::array<double, 3> q{p.x(), p.y(), p.z()};
    q[std::size_t(axis)] = image.rounded;
    images.emplace_back(q[0], q[1], q[2]);
  }
  std::sort(images.begin(), images.end());
  return images == sorted ? std::optional<double>(sum.rounded) : std::nullopt;
}

} // namespace internal

/*!
\ingroup PkgQuadRemeshingRemeshing

finds a plane perpendicular to a coordinate axis by which the vertices of a mesh are symmetric.

A plane is exact if the image of each vertex is a vertex. The function first looks for exact planes,
beginning with the x-axis. If there is none, it takes the plane for which the mean distance of the
images from vertices is least, in relation to the extent of the mesh along the axis. A few vertices
without an image do not change the choice. The function returns this plane if all images are within
the tolerance. It does not find a plane on which all vertices lie. The faces need not be
symmetric.

`quad_remesh()` makes quads that are exactly symmetric by any plane.

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
  \cgalParamNBegin{tolerance}
    \cgalParamDescription{how far images of vertices may be from vertices, in relation to the
                          diagonal of the bounding box. Six printed digits need about the default.
                          With infinity, the function returns the nearest plane.}
    \cgalParamType{`double`}
    \cgalParamDefault{1e-5}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the plane, for the parameter `symmetry_plane` of `quad_remesh()`, if there is one

\par Complexity
At most six sorts, and for each vertex at most twelve searches for the vertex nearest to its image.

\sa `quad_remesh()`
*/
template <typename TriangleMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto find_symmetry_plane(const TriangleMesh& tmesh,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Protect_exact_arithmetic protect;
  constexpr auto read =
    internal::named<CGAL::internal_np::tolerance, CGAL::internal_np::vertex_point>;
  const auto& parameters = internal::strip(np, read);
  const auto point_map = internal::chosen(parameters, CGAL::internal_np::vertex_point,
                                          CGAL::get_const_property_map(CGAL::vertex_point, tmesh));
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)> >::value_type;
  using Kernel = typename CGAL::Kernel_traits<Point>::Kernel;
  using FT = typename Kernel::FT;
  const auto plane = [](const int axis, const double coordinate) {
    const auto unit = [&](const int i) { return FT(i == axis ? 1 : 0); };
    return std::optional(typename Kernel::Plane_3(unit(0), unit(1), unit(2), FT(0 - coordinate)));
  };
  std::vector<internal::Mirror_search::Point> points;
  for(const auto v : vertices(tmesh)) {
    const auto& p = get(point_map, v);
    points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
  if(points.empty())
    return decltype(plane(0, 0))();
  std::sort(points.begin(), points.end());
  for(int axis = 0; axis < 3; ++axis)
    if(const auto doubled = internal::find_doubled_offset(points, axis);
       doubled && CGAL::to_double(FT(*doubled / 2)) == *doubled / 2)
      return plane(axis, *doubled / 2);

  constexpr double six_digits = 1e-5;
  const double tolerance = internal::chosen(parameters, CGAL::internal_np::tolerance, six_digits);
  if(!(tolerance > 0))
    return decltype(plane(0, 0))();
  const internal::Mirror_search search(points);
  const double diagonal = search.diagonal();
  const auto found = search.nearest(tolerance * diagonal, six_digits * diagonal);
  return found ? plane(found->axis, found->coordinate) : decltype(plane(0, 0))();
}

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_FIND_SYMMETRY_PLANE_H
