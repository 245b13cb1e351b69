// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Hexahedral_meshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_IO_HEXAHEDRA_TEXTS_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_IO_HEXAHEDRA_TEXTS_H

#include <CGAL/license/Hexahedral_meshing.h>

// Meshes of hexahedra as texts.

#include <CGAL/Hexahedral_meshing/types/Hexahedral_mesh.h>
#include <CGAL/Seamless_snapping/internal/IO/decimal_numbers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

inline void append_points(const Hexahedral_mesh& mesh, const char* const end, std::string& text)
{
  for(const auto& p : mesh.points) {
    for(std::size_t c = 0; c < 3; ++c) {
      append_number(p[c], text);
      text += c < 2 ? " " : end;
    }
  }
}

// The indices of an element, from `first` on.
template <typename Element>
void append_indices(const Element& element, const std::int64_t first, const std::string& end,
                    std::string& text)
{
  for(std::size_t k = 0; k < element.size(); ++k)
    text += (k > 0 ? " " : "") + std::to_string(element[k] + first);
  text += end;
}

// The reference of element i in files.
inline std::int32_t reference(const std::vector<std::int32_t>& references, const std::size_t i)
{
  return i < references.size() ? references[i] : 1;
}

inline std::string MEDIT_text(const Hexahedral_mesh& mesh)
{
  std::string text = "MeshVersionFormatted 2\nDimension 3\nVertices\n" +
                     std::to_string(mesh.points.size()) + "\n";
  append_points(mesh, " 0\n", text);
  const auto append = [&](const char* const name, const auto& elements,
                          const std::vector<std::int32_t>& references) {
    if(elements.empty())
      return;
    text += name + ("\n" + std::to_string(elements.size())) + "\n";
    for(std::size_t i = 0; i < elements.size(); ++i)
      append_indices(elements[i], 1, " " + std::to_string(reference(references, i)) + "\n", text);
  };
  append("Edges", mesh.edges, mesh.curves);
  append("Quadrilaterals", mesh.quadrilaterals, mesh.patches);
  append("Hexahedra", mesh.hexahedra, {});
  return text + "End\n";
}

// Hexahedra come first, then quadrilaterals and edges; their references are data of cells.
inline std::string VTK_text(const Hexahedral_mesh& mesh)
{
  std::string cells, types, references;
  std::size_t number = 0, size = 0;
  const auto append = [&](const auto& elements, const char* const type,
                          const std::vector<std::int32_t>& of_elements) {
    for(std::size_t i = 0; i < elements.size(); ++i) {
      cells += std::to_string(elements[i].size()) + " ";
      append_indices(elements[i], 0, "\n", cells);
      types += type;
      references += std::to_string(reference(of_elements, i)) + "\n";
      size += 1 + elements[i].size();
    }
    number += elements.size();
  };
  append(mesh.hexahedra, "12\n", {});
  append(mesh.quadrilaterals, "9\n", mesh.patches);
  append(mesh.edges, "3\n", mesh.curves);
  std::string text = "# vtk DataFile Version 3.0\nhexahedra\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                     "POINTS " + std::to_string(mesh.points.size()) + " double\n";
  append_points(mesh, "\n", text);
  const std::string of_cells = std::to_string(number);
  return text + "CELLS " + of_cells + " " + std::to_string(size) + "\n" + cells + "CELL_TYPES " +
         of_cells + "\n" + types + "CELL_DATA " + of_cells +
         "\nSCALARS reference int 1\nLOOKUP_TABLE default\n" + references;
}

// Faces and edges, named by sorted vertices; each face is listed as the first hexahedron that has
// it sees it from outside.
class OVM_writer
{
public:
  explicit OVM_writer(const Hexahedral_mesh& mesh)
    : m_mesh(mesh)
  {
    for(std::size_t i = 0; i < mesh.hexahedra.size(); ++i)
      for(std::size_t f = 0; f < 6; ++f) {
        const Face face = face_of(i, f);
        m_faces.push_back({sorted(face), 6 * i + f});
        for(std::size_t k = 0; k < 4; ++k)
          m_edges.push_back(std::minmax(face[k], face[(k + 1) % 4]));
      }
    std::sort(m_faces.begin(), m_faces.end()); // of two the first one comes first
    m_faces.erase(std::unique(m_faces.begin(), m_faces.end(), [](const auto& a, const auto& b)
                              { return a.first == b.first; }), m_faces.end());
    std::sort(m_edges.begin(), m_edges.end());
    m_edges.erase(std::unique(m_edges.begin(), m_edges.end()), m_edges.end());
  }

  std::string text() const
  {
    std::string text = "OVM ASCII\nVertices\n" + std::to_string(m_mesh.points.size()) + "\n";
    append_points(m_mesh, "\n", text);
    text += "Edges\n" + std::to_string(m_edges.size()) + "\n";
    for(const auto& [a, b] : m_edges)
      append_indices(std::array<std::int32_t, 2>{{a, b}}, 0, "\n", text);
    text += "Faces\n" + std::to_string(m_faces.size()) + "\n";
    for(const auto& [key, name] : m_faces) {
      const Face face = face_of(name / 6, name % 6);
      std::array<std::int64_t, 4> halfedges;
      for(std::size_t k = 0; k < 4; ++k)
        halfedges[k] = halfedge(face[k], face[(k + 1) % 4]);
      text += "4 ";
      append_indices(halfedges, 0, "\n", text);
    }
    text += "Polyhedra\n" + std::to_string(m_mesh.hexahedra.size()) + "\n";
    for(std::size_t i = 0; i < m_mesh.hexahedra.size(); ++i) {
      std::array<std::int64_t, 6> halffaces;
      for(std::size_t f = 0; f < 6; ++f)
        halffaces[f] = halfface(i, f);
      text += "6 ";
      append_indices(halffaces, 0, "\n", text);
    }
    return text + property("EProp int \"curve\"", m_mesh.edges, m_mesh.curves, m_edges.size(),
                           [&](const auto& e) { return halfedge(e[0], e[1]); }) +
           property("FProp int \"patch\"", m_mesh.quadrilaterals, m_mesh.patches, m_faces.size(),
                    [&](const auto& q) { return 2 * (find(q) - m_faces.begin()); });
  }

private:
  using Face = std::array<std::int32_t, 4>;

  Face face_of(const std::size_t i, const std::size_t f) const
  {
    // counterclockwise as seen from outside
    constexpr std::size_t corners[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                           {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};
    Face result;
    for(std::size_t k = 0; k < 4; ++k)
      result[k] = m_mesh.hexahedra[i][corners[f][k]];
    return result;
  }

  static Face sorted(Face face)
  {
    std::sort(face.begin(), face.end());
    return face;
  }

  std::int64_t halfedge(const std::int32_t a, const std::int32_t b) const
  {
    const auto found = std::lower_bound(m_edges.begin(), m_edges.end(),
                                        std::pair<std::int32_t, std::int32_t>(std::minmax(a, b)));
    return 2 * (found - m_edges.begin()) + (a > b);
  }

  std::vector<std::pair<Face, std::size_t> >::const_iterator find(const Face& face) const
  {
    return std::lower_bound(m_faces.begin(), m_faces.end(),
                            std::pair<Face, std::size_t>(sorted(face), 0));
  }

  std::int64_t halfface(const std::size_t i, const std::size_t f) const
  {
    const auto found = find(face_of(i, f));
    return 2 * (found - m_faces.begin()) + (found->second != 6 * i + f);
  }

  // The references of some edges or faces; 0 for all others.
  template <typename Elements, typename Half>
  static std::string property(const std::string& name, const Elements& elements,
                              const std::vector<std::int32_t>& references,
                              const std::size_t size, const Half& half)
  {
    std::vector<std::int32_t> values(size, 0);
    for(std::size_t i = 0; i < elements.size(); ++i)
      values[std::size_t(half(elements[i]) / 2)] = reference(references, i);
    std::string text = name + "\n";
    for(const std::int32_t x : values)
      text += std::to_string(x) + "\n";
    return text;
  }

  const Hexahedral_mesh& m_mesh;
  std::vector<std::pair<Face, std::size_t> > m_faces; // sorted vertices, and 6 i + f
  std::vector<std::pair<std::int32_t, std::int32_t> > m_edges;
};

inline std::string OVM_text(const Hexahedral_mesh& mesh)
{
  return OVM_writer(mesh).text();
}

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_IO_HEXAHEDRA_TEXTS_H
