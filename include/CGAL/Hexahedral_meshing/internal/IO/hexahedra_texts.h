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

#include <CGAL/Hexahedral_meshing/internal/hexahedra/Hexahedron.h>
#include <CGAL/Hexahedral_meshing/types/Hexahedral_mesh.h>
#include <CGAL/Seamless_snapping/internal/IO/decimal_numbers.h>

#include <boost/container_hash/hash.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
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

// Edges and faces in the order in which hexahedra have them first. Each face is listed as its first
// hexahedron sees it from outside.
class OVM_writer
{
public:
  std::string text(const Hexahedral_mesh& mesh)
  {
    std::string cells;
    for(const Hexahedron& h : mesh.hexahedra) {
      std::array<std::int64_t, 6> halffaces;
      for(std::size_t f = 0; f < 6; ++f) // at two opposite corners
        halffaces[f] = halfface(facet_at(h, f < 3 ? 0 : 6, f % 3));
      cells += "6 ";
      append_indices(halffaces, 0, "\n", cells);
    }
    const std::string patches =
      property("FProp int \"patch\"", mesh.quadrilaterals, mesh.patches, m_faces,
               [&](const Face& face) { return halfface(face) / 2; });
    const std::string curves =
      property("EProp int \"curve\"", mesh.edges, mesh.curves, m_edges,
               [&](const Edge& edge) { return halfedge(edge) / 2; });
    std::string text = "OVM ASCII\nVertices\n" + std::to_string(mesh.points.size()) + "\n";
    append_points(mesh, "\n", text);
    return text + "Edges\n" + std::to_string(m_edges.size()) + "\n" + m_edge_text + "Faces\n" +
           std::to_string(m_faces.size()) + "\n" + m_face_text + "Polyhedra\n" +
           std::to_string(mesh.hexahedra.size()) + "\n" + cells + curves + patches;
  }

private:
  template <typename Element>
  using Numbers = std::unordered_map<Element, std::int64_t, boost::hash<Element> >;
  using Edge = std::array<std::int32_t, 2>;
  using Face = std::array<std::int32_t, 4>;

  std::int64_t halfedge(const Edge& edge)
  {
    const auto [place, is_new] = m_edges.emplace(sorted(edge), std::int64_t(m_edges.size()));
    if(is_new)
      append_indices(place->first, 0, "\n", m_edge_text);
    return 2 * place->second + (edge[0] > edge[1]);
  }

  // The second hexahedron of a face sees its other side.
  std::int64_t halfface(const Face& face)
  {
    const auto [place, is_new] = m_faces.emplace(sorted(face), std::int64_t(m_faces.size()));
    if(!is_new)
      return 2 * place->second + 1;
    std::array<std::int64_t, 4> halfedges;
    for(std::size_t k = 0; k < 4; ++k)
      halfedges[k] = halfedge({face[k], face[(k + 1) % 4]});
    m_face_text += "4 ";
    append_indices(halfedges, 0, "\n", m_face_text);
    return 2 * place->second;
  }

  // The references of some edges or faces; 0 for all others.
  template <typename Element, typename NumberOf>
  static std::string property(const std::string& name, const std::vector<Element>& elements,
                              const std::vector<std::int32_t>& references,
                              const Numbers<Element>& all, const NumberOf& number_of)
  {
    std::vector<std::int32_t> values;
    for(std::size_t i = 0; i < elements.size(); ++i) {
      const auto number = std::size_t(number_of(elements[i])); // may be a new one
      values.resize(all.size(), 0);
      values[number] = reference(references, i);
    }
    values.resize(all.size(), 0);
    std::string text = name + "\n";
    for(const std::int32_t x : values)
      text += std::to_string(x) + "\n";
    return text;
  }

  Numbers<Edge> m_edges; // by ascending vertices
  Numbers<Face> m_faces;
  std::string m_edge_text, m_face_text;
};

inline std::string OVM_text(const Hexahedral_mesh& mesh)
{
  return OVM_writer().text(mesh);
}

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_IO_HEXAHEDRA_TEXTS_H
