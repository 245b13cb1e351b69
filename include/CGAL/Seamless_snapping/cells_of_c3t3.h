// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_CELLS_OF_C3T3_H
#define CGAL_SEAMLESS_SNAPPING_CELLS_OF_C3T3_H

#include <CGAL/license/Seamless_snapping.h>

// From three-dimensional triangulations and the complexes of mesh generation to the ranges that the
// functions on volumes take.

#include <CGAL/Unique_hash_map.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

/*!
\ingroup PkgSeamlessSnappingRef

The cells of a triangulation as the ranges that `snap_volume_to_seamless()` takes, and the handles
that tell which number is which cell or vertex. A map of corners has the key `4 * i + k` for
`cells[i]->vertex(k)`.

\tparam Triangulation_ a model of `TriangulationDataStructure_3`, or a class derived from
        `CGAL::Triangulation_3`
*/
template <typename Triangulation_>
struct Triangulation_cells
{
  using Triangulation = Triangulation_;                          ///< the triangulation
  using Cell_handle = typename Triangulation::Cell_handle;     ///< names a cell
  using Vertex_handle = typename Triangulation::Vertex_handle; ///< names a vertex

  /// per cell: its four vertices, by number
  std::vector<std::array<std::int32_t, 4> > tetrahedra;
  /// per cell: the four cells opposite to its vertices, by number, or -1; for the named parameter
  /// `cell_neighbors`
  std::vector<std::array<std::int32_t, 4> > neighbors;
  /// the facets of the complex with a cell on both sides, such as those between subdomains, by
  /// numbers of vertices; for the named parameter `feature_facets`
  std::vector<std::array<std::int32_t, 3> > interfaces;
  /// the edges of the complex, by numbers of vertices; for the named parameter `feature_edges`
  std::vector<std::array<std::int32_t, 2> > edges;
  std::vector<Cell_handle> cells;      ///< the cell of a number
  std::vector<Vertex_handle> vertices; ///< the vertex of a number
};

namespace internal {

template <typename Triangulation>
class Cell_collector
{
  using Result = Triangulation_cells<Triangulation>;
  using Cell_handle = typename Result::Cell_handle;
  using Vertex_handle = typename Result::Vertex_handle;

public:
  Cell_collector() : m_cell_number(-1), m_vertex_number(-1) { }

  void add(const Cell_handle c)
  {
    m_cell_number[c] = static_cast<std::int32_t>(m_result.cells.size());
    m_result.cells.push_back(c);
    m_result.tetrahedra.emplace_back();
    for(int k = 0; k < 4; ++k)
      m_result.tetrahedra.back()[std::size_t(k)] = number(c->vertex(k));
  }

  void add_interface(const Cell_handle c, const int i)
  {
    if(m_cell_number[c] >= 0 && m_cell_number[c->neighbor(i)] >= 0)
      m_result.interfaces.push_back({{number(c->vertex((i + 1) % 4)),
                                      number(c->vertex((i + 2) % 4)),
                                      number(c->vertex((i + 3) % 4))}});
  }

  void add_edge(const Vertex_handle a, const Vertex_handle b)
  {
    m_result.edges.push_back({{number(a), number(b)}});
  }

  // When all cells are there.
  Result take()
  {
    for(const Cell_handle c : m_result.cells) {
      m_result.neighbors.emplace_back();
      for(int k = 0; k < 4; ++k)
        m_result.neighbors.back()[std::size_t(k)] = m_cell_number[c->neighbor(k)];
    }
    return std::move(m_result);
  }

private:
  std::int32_t number(const Vertex_handle v)
  {
    std::int32_t& result = m_vertex_number[v];
    if(result < 0) {
      result = static_cast<std::int32_t>(m_result.vertices.size());
      m_result.vertices.push_back(v);
    }
    return result;
  }

  Result m_result;
  CGAL::Unique_hash_map<Cell_handle, std::int32_t> m_cell_number;
  CGAL::Unique_hash_map<Vertex_handle, std::int32_t> m_vertex_number;
};

} // namespace internal

/*!
\ingroup PkgSeamlessSnappingRef

returns the finite cells of a triangulation. \pre there are at most \f$ 2^{27} \f$ of them

\tparam Triangulation a class derived from `CGAL::Triangulation_3`
*/
template <typename Triangulation>
Triangulation_cells<Triangulation> cells_of_triangulation(const Triangulation& triangulation)
{
  internal::Cell_collector<Triangulation> collector;
  for(auto c = triangulation.finite_cells_begin(); c != triangulation.finite_cells_end(); ++c)
    collector.add(c);
  return collector.take();
}

/*!
\ingroup PkgSeamlessSnappingRef

returns the cells of a complex in a triangulation, the facets of the complex between them, and its
edges. \pre there are at most \f$ 2^{27} \f$ cells

\tparam C3t3 a model of `MeshComplexWithFeatures_3InTriangulation_3`, such as
        `CGAL::Mesh_complex_3_in_triangulation_3`
*/
template <typename C3t3>
Triangulation_cells<typename C3t3::Triangulation> cells_of_c3t3(const C3t3& c3t3)
{
  internal::Cell_collector<typename C3t3::Triangulation> collector;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    collector.add(c);
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
    collector.add_interface(f->first, f->second);
  for(auto e = c3t3.edges_in_complex_begin(); e != c3t3.edges_in_complex_end(); ++e)
    collector.add_edge(e->first->vertex(e->second), e->first->vertex(e->third));
  return collector.take();
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_CELLS_OF_C3T3_H
