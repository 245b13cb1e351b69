// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Isocurves_and_layouts package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_ADD_WALLS_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_ADD_WALLS_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Walls as curves, from corner to corner, or closed; and oblique borders likewise.

#include <CGAL/Isocurves_and_layouts/internal/layout/Curve_set.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout_domain.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Segment_walker.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Vertex_rays.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

class Wall_builder
{
public:
  Wall_builder(const Layout_domain& domain, Curve_set& curves)
    : m_domain(domain), m_mesh(domain.mesh), m_curves(curves),
      m_is_done(domain.mesh.corners.size(), false)
  {
    m_limits.is_stop = [&domain](const std::size_t v) { return domain.is_start(v); };
  }

  void run()
  {
    for(std::size_t v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(m_domain.is_start(v) && m_domain.is_on_wall[v])
        add_walls_from(v);
    for(std::size_t i = 0; i < m_mesh.corners.size(); ++i)
      if(m_domain.is_wall[i] && !m_is_done[i])
        add_walls_from(m_mesh.vertex(Corner_index(i)));
    if(m_domain.has_oblique_border)
      add_oblique_borders();
  }

private:
  void add_walls_from(const std::size_t v)
  {
    const Vertex_rays rays = rays_from_vertex(m_mesh, v);
    for(std::size_t k = 0; k < rays.size(); ++k) {
      const Corner_index h = edge_of_ray(rays[k]);
      if(h != no_index && m_domain.is_wall[std::size_t(h)] && !m_is_done[std::size_t(h)])
        add_wall(v, slots_of_vertex(m_domain, v).first_ray + std::int32_t(k), rays[k]);
    }
  }

  void add_wall(const std::size_t v, const std::int32_t slot, const Vertex_ray& ray)
  {
    const Curve_index c = m_curves.add_curve(v, slot);
    Segment_walker walker(m_mesh, m_limits, ray);
    while(walker.advance() == Isocurve_status::CONTINUES) {
      const Chart_segment& segment = walker.segment();
      const Corner_index h = segment.along, g = m_mesh.opposite(h);
      m_is_done[std::size_t(h)] = true;
      if(g != no_index)
        m_is_done[std::size_t(g)] = true;
      m_curves.add_segment(c, segment, [](const Chord&, const Chord&, Flat_face_index) { },
                           [](Curve_index, Segment_index) { });
    }
    Layout_curve& wall = m_curves[c];
    const Curve_segment& last = wall.segments.back();
    const bool is_border = m_mesh.is_border_edge(last.along);
    wall.is_wall = true;
    wall.is_closed = walker.status() == Isocurve_status::CLOSED;
    wall.is_right_outside = is_border && last.exit.halfedge == last.along;
    wall.is_left_outside = is_border && last.exit.halfedge != last.along;
    wall.twice_length =
      m_curves.length_at_vertex(c, Segment_index(wall.segments.size() - 1)).doubled();
  }

  // Those that begin at starts come first: what is left then is closed.
  void add_oblique_borders()
  {
    for(const bool is_closed : {false, true})
      for(Corner_index h = 0; h < m_mesh.number_of_halfedges(); ++h)
        if(m_domain.is_oblique(h) && !m_is_done[std::size_t(h)] &&
           (is_closed || m_domain.is_start(m_mesh.source(h))))
          add_oblique_border(h, is_closed);
  }

  // With the surface at the left.
  void add_oblique_border(const Corner_index first, const bool is_closed)
  {
    const Curve_index c = m_curves.add_curve(m_mesh.source(first), 0);
    Corner_index h = first;
    std::size_t end = 0;
    do {
      m_is_done[std::size_t(h)] = true;
      m_curves.add_border_edge(c, h);
      end = m_mesh.vertex(h);
      h = border_edge_from(m_mesh, end);
    } while(!m_domain.is_start(end) && h != first);
    Layout_curve& border = m_curves[c];
    border.is_wall = border.is_oblique = border.is_right_outside = true;
    border.is_closed = is_closed;
    border.twice_length = Exact_level(2 * double(border.segments.size()));
  }

  const Layout_domain& m_domain;
  const Chart_mesh& m_mesh;
  Curve_set& m_curves;
  Walk_limits m_limits;
  std::vector<char> m_is_done; // per corner
};

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_ADD_WALLS_H
