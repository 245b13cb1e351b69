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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_MAKE_LAYOUT_IMPL_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_MAKE_LAYOUT_IMPL_H

#include <CGAL/license/Isocurves_and_layouts.h>

// From a chart mesh to its layout, step by step, with all checks. Nothing here depends on the mesh
// data structure.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/remove_faces.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout_domain.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/build_layout.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/make_layout.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/make_patches.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/Report.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

class Layout_maker
{
public:
  Layout_maker(Layout_input&& input, Layout_data& data)
    : m_is_feature(std::move(input.is_feature)), m_align_border(input.align_border),
      m_is_given(std::move(input.is_given)), m_options(input.options),
      m_vertex_name(input.vertex_name), m_data(data), m_domain(data.domain)
  {
    m_domain.mesh = std::move(input.mesh);
  }

  void run()
  {
    if(check_faces() && check_walls()) {
      mark_starts(m_is_given, m_domain);
      add_seeds(m_domain);
      if(!race() || !build())
        m_data.race.reset();
    }
  }

private:
  bool check_faces()
  {
    m_data.nonpositive_faces = nonpositive_faces(m_domain.mesh);
    return are_positive(m_domain.mesh, m_data.nonpositive_faces, m_data);
  }

  bool check_walls()
  {
    split_fans();
    const Chart_mesh& mesh = m_domain.mesh;
    mark_walls(m_is_feature, m_align_border, m_domain);
    std::size_t number = 0;
    Corner_index first = no_index;
    for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h)
      if(m_domain.is_wall[std::size_t(h)] && mesh.represents_edge(h) && !is_on_isocurve(mesh, h)) {
        first = number == 0 ? h : first;
        ++number;
      }
    if(number == 0)
      return true;
    const bool is_border_edge = mesh.is_border_edge(first);
    return refuse(m_data, Outcome::NOT_ALIGNED,
                  std::to_string(number) + (number == 1 ? " border or feature edge does"
                                                        : " border or feature edges do") +
                    " not lie on isocurves, the first is " + name_of_edge(first) +
                    (is_border_edge
                       ? ", on the border; call snap_to_seamless() with align_border(true)"
                       : "; call snap_to_seamless() with the same edge_is_constrained_map") +
                    ", on a map that is nearly aligned there");
  }

  // Each fan gets a vertex of its own, which is given if the one of the mesh is.
  void split_fans()
  {
    Chart_mesh& mesh = m_domain.mesh;
    if(std::find(mesh.is_border.begin(), mesh.is_border.end(), true) == mesh.is_border.end())
      return;
    std::vector<char> is_given_corner;
    if(!m_is_given.empty())
      for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h)
        is_given_corner.push_back(m_is_given[mesh.vertex(h)]);
    Fan_splitter<Quarter_turns>(mesh).run();
    if(m_is_given.empty())
      return;
    m_is_given.assign(mesh.number_of_vertices(), false);
    for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h)
      if(is_given_corner[std::size_t(h)])
        m_is_given[mesh.vertex(h)] = true;
  }

  bool race()
  {
    m_data.race = std::make_unique<Curve_race>(m_domain, m_options);
    const bool has_ended = m_data.race->run();
    m_data.number_of_segments = m_data.race->number_of_segments();
    return has_ended ||
           refuse(m_data, Outcome::TOO_LARGE,
                  "the curves cross faces, or each other, more than " +
                    std::to_string(m_options.maximum_number) +
                    " times; raise maximum_number, or let curves end where they meet others");
  }

  bool build()
  {
    Layout_builder builder(m_domain, *m_data.race);
    if(!builder.run() ||
       !Patch_maker(m_domain, m_data.race->curves(), builder.layout()).run())
      return refuse(m_data, Outcome::INTERNAL_ERROR, "the curves do not bound rectangles");
    m_data.layout = std::move(builder.layout());
    note_cut_patches();
    return true;
  }

  void note_cut_patches()
  {
    const Chart_mesh& mesh = m_domain.mesh;
    std::size_t edges = 0, cut = 0;
    Corner_index first = no_index;
    for(Corner_index h = mesh.number_of_halfedges(); h-- > 0;)
      if(m_domain.is_oblique(h)) {
        first = h;
        ++edges;
      }
    for(const Layout_patch& patch : m_data.layout.patches)
      cut += patch.is_cut ? 1 : 0;
    if(edges > 0)
      m_data.message = std::to_string(edges) +
                       (edges == 1 ? " border edge does" : " border edges do") +
                       " not lie on isocurves, the first is " + name_of_edge(first) + "; there, " +
                       std::to_string(cut) +
                       (cut == 1 ? " patch is not a rectangle" : " patches are not rectangles");
  }

  std::string name_of_edge(const Corner_index h) const
  {
    return "that from vertex " + m_vertex_name(m_domain.mesh.source(h)) + " to vertex " +
           m_vertex_name(m_domain.mesh.vertex(h));
  }

  std::vector<char> m_is_feature;
  bool m_align_border;
  std::vector<char> m_is_given;
  Race_options m_options;
  std::function<std::string(std::size_t)> m_vertex_name;
  Layout_data& m_data;
  Layout_domain& m_domain;
};

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
void make_layout(Layout_input&& input, Layout_data& data)
{ Layout_maker(std::move(input), data).run(); }

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_MAKE_LAYOUT_IMPL_H
