// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_REMOVE_FACES_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_REMOVE_FACES_H

#include <CGAL/license/Seamless_snapping.h>

// A chart mesh without some of its faces. Their places become holes; a vertex around which several
// fans of faces remain becomes several.

#include <CGAL/Seamless_snapping/internal/tracing/Chart_mesh.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

class Face_remover
{
public:
  // `faces` in ascending order.
  Face_remover(const Chart_mesh& mesh, const std::vector<std::size_t>& faces)
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

  Chart_mesh run() const
  {
    Chart_mesh mesh = m_original;
    mesh.corners.resize(3 * m_kept.size());
    for(std::size_t i = 0; i < mesh.corners.size(); ++i) {
      Chart_corner& c = mesh.corners[i];
      c = m_original.corner(3 * m_kept[i / 3] + Corner_index(i % 3));
      c.opposite = new_corner(c.opposite);
      if(c.opposite == no_index)
        c.transition = no_index;
    }
    number_vertices(mesh);
    return mesh;
  }

private:
  Corner_index new_corner(const Corner_index h) const
  {
    const std::int32_t f = h == no_index ? no_index : m_new_index[std::size_t(h / 3)];
    return f == no_index ? no_index : 3 * f + h % 3;
  }

  // The first fan of a vertex keeps its number.
  static void number_vertices(Chart_mesh& mesh)
  {
    mesh.corner_at_vertex.assign(mesh.corner_at_vertex.size(), no_index);
    std::vector<char> is_numbered(mesh.corners.size(), false);
    for(std::size_t i = 0; i < mesh.corners.size(); ++i)
      if(!is_numbered[i])
        number_fan(mesh, Corner_index(i), is_numbered);
  }

  static void number_fan(Chart_mesh& mesh, const Corner_index h, std::vector<char>& is_numbered)
  {
    std::size_t v = mesh.vertex(h);
    if(mesh.corner_at_vertex[v] != no_index) {
      v = mesh.corner_at_vertex.size();
      mesh.corner_at_vertex.push_back(no_index);
      mesh.is_border.push_back(true);
      mesh.is_singular.push_back(false);
    }
    mesh.corner_at_vertex[v] = h;
    const auto number = [&](const Corner_index c) {
      is_numbered[std::size_t(c)] = true;
      mesh.corners[std::size_t(c)].vertex = Chart_vertex_index(v);
    };
    number(h);
    Corner_index c = mesh.counterclockwise(h);
    for(; c != no_index && c != h; c = mesh.counterclockwise(c))
      number(c);
    if(c == h)
      return;
    mesh.is_border[v] = true;
    mesh.is_singular[v] = false;
    for(c = mesh.clockwise(h); c != no_index; c = mesh.clockwise(c))
      number(c);
  }

  const Chart_mesh& m_original;
  std::vector<std::int32_t> m_new_index; // per face
  std::vector<std::int32_t> m_kept;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_REMOVE_FACES_H
