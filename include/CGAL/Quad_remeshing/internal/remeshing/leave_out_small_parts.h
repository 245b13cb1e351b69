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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_LEAVE_OUT_SMALL_PARTS_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_LEAVE_OUT_SMALL_PARTS_H

#include <CGAL/license/Quad_remeshing.h>

// Closed parts of a surface that are smaller than a quad, as marching cubes and scans leave them:
// six quads, the fewest of a closed mesh, would be much smaller than all others.

#include <CGAL/Quad_remeshing/internal/remeshing/Marked_surface.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// x times 2^exponent, without overflow: infinite where it is too large.
inline double times_power_of_two(const double x, const int exponent)
{
  if(!(x > 0) || std::ilogb(x) + exponent < std::numeric_limits<double>::min_exponent)
    return 0;
  return std::ilogb(x) + exponent < std::numeric_limits<double>::max_exponent - 1
           ? std::ldexp(x, exponent) : std::numeric_limits<double>::infinity();
}

class Small_parts
  : private Remeshing_types
{
public:
  // \param threshold the area below which closed parts are left out; by default the area of one
  //        of `number_of_quads`, unless the part is not much smaller than the largest one
  Small_parts(Marked_surface& surface, const std::optional<double>& threshold,
              const double number_of_quads)
    : m_surface(surface),
      m_part(surface.mesh.add_property_map<Face, std::size_t>("f:part", 0).first)
  {
    constexpr double much = 100; // by which a part is smaller than the largest one
    const std::vector<double> areas =
      has_finite_points(surface.mesh) ? areas_of_parts() : std::vector<double>(); // refused later
    if(areas.size() < 2)
      return;
    const double largest = *std::max_element(areas.begin(), areas.end());
    const double least = threshold
      ? (std::min)(largest, times_power_of_two(*threshold, -2 * m_exponent))
      : (std::min)(largest / much,
                   std::accumulate(areas.begin(), areas.end(), 0.) / number_of_quads);
    std::vector<char> is_closed(areas.size(), true);
    for(const Halfedge h : surface.mesh.halfedges())
      if(surface.mesh.is_border(h))
        is_closed[m_part[surface.mesh.face(surface.mesh.opposite(h))]] = false;
    double sum = 0;
    for(std::size_t i = 0; i < areas.size(); ++i)
      if(is_closed[i] && areas[i] < least) {
        m_small.push_back(i);
        sum += areas[i];
      }
    m_area = times_power_of_two(sum, 2 * m_exponent);
  }

  std::size_t number() const { return m_small.size(); }
  double area() const { return m_area; } // of them all

  // Takes them from the surface, whose faces know their originals then.
  void leave_out()
  {
    Mesh& mesh = m_surface.mesh;
    if(m_small.empty())
      return;
    auto original = mesh.add_property_map<Face, std::size_t>("f:original", 0).first;
    for(const Face f : mesh.faces())
      original[f] = std::size_t(f);
    CGAL::Polygon_mesh_processing::remove_connected_components(mesh, m_small, m_part);
    mesh.collect_garbage();
    for(const Face f : mesh.faces())
      m_surface.originals.push_back(original[f]);
    mesh.remove_property_map(original);
  }

private:
  std::vector<double> areas_of_parts()
  {
    const Mesh& mesh = m_surface.mesh;
    std::vector<double> result(CGAL::Polygon_mesh_processing::connected_components(mesh, m_part));
    double size = 0;
    for(const Point& p : mesh.points())
      for(int c = 0; c < 3; ++c)
        size = (std::max)(size, std::abs(p[c]));
    m_exponent = size > 0 ? std::ilogb(size) : 0;
    const auto scaled = [&](const Vertex v) {
      const Point& p = mesh.point(v);
      return Point(std::ldexp(p.x(), -m_exponent), std::ldexp(p.y(), -m_exponent),
                   std::ldexp(p.z(), -m_exponent));
    };
    for(const Face f : mesh.faces()) {
      const Halfedge h = mesh.halfedge(f);
      const Vector normal = CGAL::normal(scaled(mesh.source(h)), scaled(mesh.target(h)),
                                         scaled(mesh.target(mesh.next(h))));
      result[m_part[f]] += std::hypot(normal.x(), normal.y(), normal.z()) / 2;
    }
    return result;
  }

  Marked_surface& m_surface;
  Mesh::Property_map<Face, std::size_t> m_part;
  int m_exponent = 0; // areas are measured in units of 2^(2 * exponent)
  std::vector<std::size_t> m_small; // parts
  double m_area = 0;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_LEAVE_OUT_SMALL_PARTS_H
