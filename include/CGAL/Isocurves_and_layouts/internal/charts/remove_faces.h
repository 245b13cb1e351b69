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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_REMOVE_FACES_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_REMOVE_FACES_H

#include <CGAL/license/Isocurves_and_layouts.h>

// A chart mesh without some of its faces: their places become holes. And vertices on the border,
// around which there may be several fans of faces: they become several vertices.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

template <typename Group>
class Fan_splitter
{
public:
  explicit Fan_splitter(Basic_chart_mesh<Group>& mesh)
    : m_mesh(mesh), m_is_done(mesh.corners.size(), false)
  { }

  void run()
  {
    for(std::size_t v = 0; v < m_mesh.is_border.size(); ++v)
      if(m_mesh.is_border[v]) {
        m_mesh.corner_at_vertex[v] = no_index;
        m_mesh.is_singular[v] = false;
      }
    for(std::size_t i = 0; i < m_mesh.corners.size(); ++i)
      if(!m_is_done[i] && m_mesh.is_border[m_mesh.vertex(Corner_index(i))])
        number_fan(Corner_index(i));
  }

private:
  // The first fan of a vertex keeps its number.
  void number_fan(const Corner_index h)
  {
    std::size_t v = m_mesh.vertex(h);
    if(m_mesh.corner_at_vertex[v] != no_index) {
      v = m_mesh.corner_at_vertex.size();
      m_mesh.corner_at_vertex.push_back(no_index);
      m_mesh.is_border.push_back(true);
      m_mesh.is_singular.push_back(false);
    }
    Corner_index first = h;
    while(m_mesh.clockwise(first) != no_index)
      first = m_mesh.clockwise(first);
    m_mesh.corner_at_vertex[v] = first;
    for_each_corner(m_mesh, v, [&](const Corner_index c) {
      m_is_done[std::size_t(c)] = true;
      m_mesh.corners[std::size_t(c)].vertex = Flat_vertex_index(v);
    });
  }

  Basic_chart_mesh<Group>& m_mesh;
  std::vector<char> m_is_done; // per corner
};

template <typename Group>
class Face_remover
{
  using Mesh = Basic_chart_mesh<Group>;

public:
  // `faces` in ascending order.
  Face_remover(const Mesh& mesh, const std::vector<std::size_t>& faces)
    : m_original(mesh), m_new_index(mesh.corners.size() / 3, 0)
  {
    for(const std::size_t f : faces)
      m_new_index[f] = no_index;
    for(std::size_t f = 0; f < m_new_index.size(); ++f)
      if(m_new_index[f] != no_index) {
        m_new_index[f] = std::int32_t(m_kept.size());
        m_kept.push_back(std::int32_t(f));
      }
  }

  // The faces that are left, by their former numbers.
  const std::vector<std::int32_t>& kept() const { return m_kept; }

  Mesh run() const
  {
    Mesh mesh = m_original;
    for(std::size_t i = 0; i < m_original.corners.size(); ++i)
      if(m_new_index[i / 3] == no_index)
        mesh.is_border[m_original.vertex(Corner_index(i))] = true;
    mesh.corners.resize(3 * m_kept.size());
    for(std::size_t i = 0; i < mesh.corners.size(); ++i) {
      Chart_corner& c = mesh.corners[i];
      c = m_original.corner(3 * m_kept[i / 3] + Corner_index(i % 3));
      c.opposite = new_corner(c.opposite);
      if(c.opposite == no_index)
        c.transition = no_index;
    }
    for(Corner_index& h : mesh.corner_at_vertex)
      h = new_corner(h);
    Fan_splitter<Group>(mesh).run();
    return mesh;
  }

private:
  Corner_index new_corner(const Corner_index h) const
  {
    const std::int32_t f = h == no_index ? no_index : m_new_index[std::size_t(h / 3)];
    return f == no_index ? no_index : 3 * f + h % 3;
  }

  const Mesh& m_original;
  std::vector<std::int32_t> m_new_index; // per face
  std::vector<std::int32_t> m_kept;
};

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_REMOVE_FACES_H
