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
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout_domain.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Refined_faces.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/build_layout.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/make_layout.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/Report.h>

#include <CGAL/Exact_rational.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

// From arcs to patches, with all checks: rectangles; and what touches an oblique border, of any
// shape.

class Patch_maker
{
public:
  // The half-arcs of the layout are linked.
  Patch_maker(const Layout_domain& domain, const Curve_set& curves, Layout& layout)
    : m_domain(domain), m_mesh(domain.mesh), m_curves(curves), m_layout(layout)
  { }

  // Returns false if the arcs make no partition, which can't be.
  bool run()
  {
    if(!add_cycles() || (m_domain.has_oblique_border && !join_cycles()))
      return false;
    for(Layout_patch& patch : m_layout.patches)
      if(!patch.is_cut && !make_rectangle(patch))
        return false;
    return has_right_euler_characteristic();
  }

private:
  // Each is a patch, for now.
  bool add_cycles()
  {
    for(Half_arc_index h = 0; h < Half_arc_index(m_layout.half_arcs.size()); ++h) {
      const Half_arc& half = m_layout.half(h);
      if(half.patch == no_index && !half.is_outside && !add_cycle(h))
        return false;
    }
    return true;
  }

  bool add_cycle(const Half_arc_index first)
  {
    std::vector<Half_arc_index> cycle;
    Half_arc_index h = first;
    do {
      Half_arc& half = m_layout.half_arcs[std::size_t(h)];
      if(half.is_outside)
        return false;
      half.patch = Patch_index(m_layout.patches.size());
      cycle.push_back(h);
      h = half.next;
    } while(h != first);
    m_layout.patches.emplace_back();
    m_layout.patches.back().cycles.push_back(std::move(cycle));
    return true;
  }

  // Cycles around the same part of the surface become one patch.
  bool join_cycles()
  {
    const Refined_faces faces(m_mesh, m_curves, m_layout);
    if(!faces.is_covered())
      return false;
    const std::size_t n = m_layout.patches.size();
    boost::disjoint_sets_with_storage<> sets(n);
    for(const auto& [a, b] : faces.joined_patches())
      sets.union_set(a, b);
    std::vector<Patch_index> numbers(n, no_index);
    std::vector<Layout_patch> patches;
    for(std::size_t p = 0; p < n; ++p) {
      Patch_index& number = numbers[sets.find_set(p)];
      if(number == no_index) {
        number = Patch_index(patches.size());
        patches.emplace_back();
      }
      patches[std::size_t(number)].cycles.push_back(std::move(m_layout.patches[p].cycles[0]));
    }
    const auto new_number = [&](const Patch_index p)
      { return numbers[sets.find_set(std::size_t(p))]; };
    m_layout.patches = std::move(patches);
    for(Half_arc& half : m_layout.half_arcs)
      if(half.patch != no_index)
        half.patch = new_number(half.patch);
    std::vector<Patch_index> patch_of_cell;
    for(std::size_t c = 0; c < faces.cells().number_of_cells(); ++c)
      patch_of_cell.push_back(new_number(Patch_index(faces.patch_of_cell(c))));
    for(Layout_patch& patch : m_layout.patches)
      patch.is_cut = touches_oblique_border(patch);
    measure_topology(faces, patch_of_cell);
    measure_areas(faces, patch_of_cell);
    return true;
  }

  // At a vertex of the border, where curves end but need not start, the angle can be 270 degrees
  // and more.
  bool touches_oblique_border(const Layout_patch& patch) const
  {
    for(const auto& cycle : patch.cycles)
      for(const Half_arc_index h : cycle)
        if(m_layout.arc(h).is_oblique || m_layout.half(h).turns > 2)
          return true;
    return false;
  }

  // Vertices, edges, and cells inside of each patch.
  void measure_topology(const Refined_faces& faces, const std::vector<Patch_index>& patch_of_cell)
  {
    const Polygon_complex& cells = faces.cells();
    std::vector<std::int32_t> patch_of_vertex(cells.number_of_vertices(), no_index);
    std::vector<char> is_on_arc(cells.number_of_vertices(), false);
    for(Layout_patch& patch : m_layout.patches)
      patch.euler_characteristic = 0;
    const auto count = [&](const Patch_index p, const int change)
      { m_layout.patches[std::size_t(p)].euler_characteristic += change; };
    for(const Patch_index p : patch_of_cell)
      count(p, 1);
    for(std::size_t d = 0; d < cells.number_of_darts(); ++d) {
      const std::size_t v = std::size_t(cells.targets[d]);
      if(faces.is_on_arc(d / 2)) {
        is_on_arc[v] = true;
        continue;
      }
      patch_of_vertex[v] = patch_of_cell[std::size_t(cells.cells[d])];
      if(d % 2 == 0)
        count(patch_of_vertex[v], -1);
    }
    for(std::size_t v = 0; v < cells.number_of_vertices(); ++v)
      if(!is_on_arc[v] && patch_of_vertex[v] != no_index)
        count(patch_of_vertex[v], 1);
  }

  // The areas of cut patches are sums over the darts around their cells, each in its face's chart.
  void measure_areas(const Refined_faces& faces, const std::vector<Patch_index>& patch_of_cell)
  {
    const auto cut_patch = [&](const std::int32_t dart) -> Layout_patch* {
      const std::int32_t cell = faces.cells().cells[std::size_t(dart)];
      if(cell == no_index)
        return nullptr;
      Layout_patch& patch = m_layout.patches[std::size_t(patch_of_cell[std::size_t(cell)])];
      return patch.is_cut ? &patch : nullptr;
    };
    const Exact_rational half(0.5);
    const Points_on_edges& points = faces.points_on_edges();
    for(Corner_index h = 0; h < m_mesh.number_of_halfedges(); ++h)
      for(std::int32_t i = 0; i <= points.number_on(h); ++i)
        if(Layout_patch* const patch = cut_patch(faces.dart_on_halfedge(h, i))) {
          const Exact_uv p = points.uv(h, i), q = points.uv(h, i + 1);
          patch->area += half * (p[0].exact() * q[1].exact() - p[1].exact() * q[0].exact());
        }
    for(std::size_t i = 0; i < faces.steps().size(); ++i) {
      const std::int32_t dart = 2 * faces.edge_of_step(i);
      if(dart < 0)
        continue;
      const Arc_step& step = faces.steps()[i];
      const Chord& chord = m_curves.chord(step.curve, step.segment);
      const Exact_rational change(faces.running_coordinate_of_step(step, false) -
                                  faces.running_coordinate_of_step(step, true));
      const Exact_rational level(half * chord.level.exact());
      const Exact_rational area(constant_component(chord.direction) == 1
                                  ? Exact_rational(level * change)
                                  : Exact_rational(-level * change));
      if(Layout_patch* const patch = cut_patch(dart))
        patch->area += area;
      if(Layout_patch* const patch = cut_patch(dart + 1))
        patch->area -= area;
    }
  }

  bool make_rectangle(Layout_patch& patch)
  {
    std::vector<Half_arc_index>& cycle = patch.cycles[0];
    const auto is_corner = [&](const Half_arc_index h) { return m_layout.half(h).turns == 1; };
    const auto last = std::find_if(cycle.begin(), cycle.end(), is_corner);
    if(patch.cycles.size() != 1 || patch.euler_characteristic != 1 || last == cycle.end())
      return false;
    std::rotate(cycle.begin(), std::next(last), cycle.end()); // the first one starts at a corner
    std::size_t side = 0;
    for(const Half_arc_index h : cycle) {
      if(m_layout.half(h).turns > 2 || side == 4)
        return false;
      patch.sides[side].push_back(h);
      side += is_corner(h) ? 1 : 0;
    }
    patch.width = length(patch.sides[0]);
    patch.height = length(patch.sides[1]);
    return side == 4 && patch.width == length(patch.sides[2]) &&
           patch.height == length(patch.sides[3]);
  }

  Exact_level length(const std::vector<Half_arc_index>& side) const
  {
    Exact_level sum(0.);
    for(const Half_arc_index h : side)
      sum = sum.minus(m_layout.arc(h).length.negated());
    return sum;
  }

  // A cell complex that covers the surface has the same Euler characteristic if and only if all
  // rectangles are disks, because each of them has a border.
  bool has_right_euler_characteristic() const
  {
    std::ptrdiff_t expected = std::ptrdiff_t(m_mesh.number_of_vertices()) +
                              std::ptrdiff_t(m_mesh.number_of_faces());
    for(Corner_index h = 0; h < m_mesh.number_of_halfedges(); ++h)
      expected -= m_mesh.represents_edge(h) ? 1 : 0;
    std::ptrdiff_t found =
      std::ptrdiff_t(m_layout.points.size()) - std::ptrdiff_t(m_layout.arcs.size());
    for(const Layout_patch& patch : m_layout.patches)
      found += patch.euler_characteristic;
    return found == expected;
  }

  const Layout_domain& m_domain;
  const Chart_mesh& m_mesh;
  const Curve_set& m_curves;
  Layout& m_layout;
};

class Layout_maker
{
public:
  Layout_maker(Layout_input&& input, Layout_data& data)
    : m_input(std::move(input)), m_data(data), m_domain(data.domain)
  {
    m_domain.mesh = std::move(m_input.mesh);
  }

  void run()
  {
    if(check_faces() && check_walls()) {
      mark_starts(m_input.is_given, m_domain);
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
    mark_walls(m_input.is_feature, m_input.align_border, m_domain);
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
                       ? ", on the border" +
                           remedy("call snap_to_seamless() with align_border(true)")
                       : remedy("call snap_to_seamless() with the same edge_is_constrained_map")) +
                    ", on a map that is nearly aligned there");
  }

  // Each fan gets a vertex of its own, which is given if the one of the mesh is.
  void split_fans()
  {
    Chart_mesh& mesh = m_domain.mesh;
    if(std::find(mesh.is_border.begin(), mesh.is_border.end(), true) == mesh.is_border.end())
      return;
    std::vector<char> is_given_corner;
    if(!m_input.is_given.empty())
      for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h)
        is_given_corner.push_back(m_input.is_given[mesh.vertex(h)]);
    Fan_splitter<Quarter_turns>(mesh).run();
    if(m_input.is_given.empty())
      return;
    m_input.is_given.assign(mesh.number_of_vertices(), false);
    for(Corner_index h = 0; h < mesh.number_of_halfedges(); ++h)
      if(is_given_corner[std::size_t(h)])
        m_input.is_given[mesh.vertex(h)] = true;
  }

  bool race()
  {
    m_data.race = std::make_unique<Curve_race>(m_domain, m_input.options);
    const bool has_ended = m_data.race->run();
    m_data.number_of_segments = m_data.race->number_of_segments();
    return has_ended ||
           refuse(m_data, Outcome::TOO_LARGE,
                  "the curves cross faces, or each other, more than " +
                    std::to_string(m_input.options.maximum_number) +
                    " times" +
                    remedy("raise maximum_number, or let curves end where they meet others"));
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

  Message name_of_edge(const Corner_index h) const
  {
    return "that from " + m_input.vertex_name(m_domain.mesh.source(h)) + " to " +
           m_input.vertex_name(m_domain.mesh.vertex(h));
  }

  Layout_input m_input;
  Layout_data& m_data;
  Layout_domain& m_domain;
};

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
void make_layout(Layout_input&& input, Layout_data& data)
{ Layout_maker(std::move(input), data).run(); }

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Refined_faces::Refined_faces(const Chart_mesh& mesh, const Curve_set& curves,
                             const Layout& layout)
  : m_mesh(mesh), m_curves(curves), m_layout(layout), m_on_edges(add_points())
{
  mark_inner_points();
  add_edges();
  for(Flat_face_index f = 0; f < mesh.number_of_faces(); ++f)
    cut_face(f);
  link_border();
  m_is_covered = spread_patches();
}

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_MAKE_LAYOUT_IMPL_H
