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

#ifndef CGAL_SEAMLESS_SNAPPING_SNAP_VOLUME_TO_SEAMLESS_H
#define CGAL_SEAMLESS_SNAPPING_SNAP_VOLUME_TO_SEAMLESS_H

#include <CGAL/license/Seamless_snapping.h>

// The volume function: makes an approximately seamless parametrization of a tetrahedral mesh
// exactly seamless. And its input from triangulations and complexes of mesh generation.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/volume/snap_volume.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <CGAL/Named_function_parameters.h>
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

moves an approximately seamless parametrization of a tetrahedral mesh to a nearby one that is
exactly seamless, as hexahedral meshing needs it.

Each cell has coordinates \f$ u, v, w \f$ at each of its corners. After success, for each interior
facet there is one of the 24 rotations of the cube \f$ R \f$ such that
\f[ R (\mathbf{u}(b) - \mathbf{u}(a)) = \mathbf{u}'(b) - \mathbf{u}'(a) \f]
holds in exact arithmetic for any two of its vertices \f$ a, b \f$. Here \f$ \mathbf{u} \f$ and
\f$ \mathbf{u}' \f$ are the coordinates in the charts of the two cells. If the transition is the
identity, both sides have the same coordinates, bit for bit. On each boundary facet and each feature
facet, one coordinate is constant; along each feature edge, two are. All coordinates remain ordinary
floating point numbers.

The mesh may have any number of components of any topology, with or without boundary. Components may
touch along edges and at vertices. Charts may be arranged in any way. The function computes
cuts, rotations, singular curves, and alignments from the coordinates. If several rotations fit a
thin facet equally well, the facets around its edges decide.

The result approximates the least-squares optimum: the exact parametrization that minimizes the sum
of squared changes of the sectors (see \ref SSnappingVolumesMethod). A parametrization that is exact
already does not change. Otherwise, corners at vertices without constraints change only to prevent
a flipped cell. The function verifies the result exactly before it writes it; on failure, the map is
as before.

\tparam TetrahedronRange a range with a member function `size()`, whose elements are ranges of 4
        vertex indices, also with `size()`: `std::vector<std::array<int, 4> >`, for instance
\tparam CornerUVWMap a model of `ReadWritePropertyMap` with `std::size_t` as key type and as value
        type a three-dimensional point with coordinates `x()`, `y()` and `z()` of type `double` or
        `float`, which can be constructed from three of them
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tetrahedra the cells: integers from 0 to \f$ 2^{31} - 2 \f$ for the vertices, in either
       orientation; see below
\param uvw_map the coordinates of each corner: key `4 * i + k` is vertex `k` of cell `i`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
        below

\cgalNamedParamsBegin
  \cgalParamNBegin{align_boundary}
    \cgalParamDescription{whether each facet of the boundary is to lie in a plane of a constant
                          coordinate}
    \cgalParamType{Boolean}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{feature_facets}
    \cgalParamDescription{further facets that are to lie in planes of a constant coordinate. In
                          each, the function makes the coordinate constant that changes least.}
    \cgalParamType{a range of ranges of 3 vertex indices}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{feature_edges}
    \cgalParamDescription{edges along which two coordinates are to be constant, the two that change
                          least in the input}
    \cgalParamType{a range of ranges of 2 vertex indices}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{cell_neighbors}
    \cgalParamDescription{for each cell, the 4 cells on the other sides of the facets opposite to
                          its vertices, or a negative number if there is none. This saves a search.
                          All cells must then list their vertices in the same orientation. The
                          function checks this, and that neighbors name each other. Pass
                          `std::cref(neighbors)` to avoid a copy.}
    \cgalParamType{a range of ranges of 4 integers, each with a member function `size()`}
    \cgalParamDefault{found by common vertices}
  \cgalParamNEnd
  \cgalParamNBegin{tolerance}
    \cgalParamDescription{the largest violation of a transition or alignment in the input that
                          counts as noise, relative to the extent of the coordinates. A larger
                          violation is an error.}
    \cgalParamType{`double`}
    \cgalParamDefault{1e-4}
  \cgalParamNEnd
  \cgalParamNBegin{integer_grid}
    \cgalParamDescription{whether to make an integer-grid map: translations, the constant
                          coordinates of aligned facets and edges, and the coordinates across
                          singular edges become integers that agree with each other. If the nearest
                          integers are farther away than noise, the function moves charts if that
                          changes edges less (not with a rounding tolerance of 0), spreads the
                          change over the volume, and repairs cells that became flipped.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{grid_scale}
    \cgalParamDescription{a positive factor: the function first multiplies all coordinates by it}
    \cgalParamType{`double`}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{rounding_tolerance}
    \cgalParamDescription{the largest distance of a translation or a constant coordinate from its
                          integer. A larger distance is an error, because the map is then probably
                          not meant to be an integer-grid map. For a map of any scale, pass a large
                          value, such as 10 units of the grid. A call with this parameter does not
                          compile, unless `integer_grid` is passed, too.}
    \cgalParamType{`double`}
    \cgalParamDefault{0.01}
    \cgalParamExtra{The integers are the nearest, not the best. On a coarse grid, parts that are
                    narrower than a unit collapse, and their cells become flipped: see
                    `Snapping_report::lost_faces`.}
  \cgalParamNEnd
  \cgalParamNBegin{repair_flips}
    \cgalParamDescription{whether to give flipped and degenerate cells the orientation of most
                          cells. Their vertices move; transitions, alignments, and integers stay.
                          `Flip_repair::NEAR_BY`, or `true`, moves single vertices of these cells
                          and of their neighbors, and no cell becomes flipped on the way.
                          `Flip_repair::UNTANGLE` also moves more and more vertices around the
                          remaining flips.}
    \cgalParamType{Boolean, or `Flip_repair`}
    \cgalParamDefault{`false`}
    \cgalParamExtra{Repairs never cost a cell its orientation. If flips remain, the status is
                    `Outcome::FLIPS_REMAIN`, with `integer_grid` also without repairs.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_untangling_iterations}
    \cgalParamDescription{bounds the work of repairs: the largest number of passes over the vertices
                          around the cells. A call with this parameter does not compile, unless
                          `repair_flips` or `integer_grid` is passed, too.}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{400}
  \cgalParamNEnd
  \cgalParamNBegin{verbose}
    \cgalParamDescription{whether the function writes its progress to `std::cerr`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`; ignored if `visitor` is passed}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{receives the progress as lines of text, in the calling thread. If it
                          throws, the exception propagates, and the map is as before.}
    \cgalParamType{a model of `ProgressVisitor`, or `std::ref()` of one}
    \cgalParamDefault{with `verbose`, a visitor that writes to `std::cerr`; else none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the status and measurements. The report converts to `true` if and only if the
        parametrization is exactly seamless and aligned. If `repair_flips` or `integer_grid` was
        passed and cells stay flipped, the status is `FLIPS_REMAIN`, which converts to `true`. For
        volumes, the faces and edges of `Snapping_report` are cells and facets, nodes are the
        vertices in the constraint system, and branches are sheets of cut facets and levels of
        aligned facets. On failure, `Snapping_report::status` is
        - `NOT_MANIFOLD`: a facet belongs to more than two cells, or two cells have the same
          vertices and no neighbors were given;
        - `NOT_FINITE`: a coordinate is NaN, infinite, or beyond 1e300;
        - `NOT_SEAMLESS`: no rotation fits the two sides of a facet up to the tolerance; or an exact
          map would differ from the input by more than ten times its noise (or a tenth of the
          tolerance, if that is more), which is a sign of a wrong rotation;
        - `NOT_ALIGNED`: no coordinate is constant on a facet of the boundary, or on a feature, up
          to the tolerance;
        - `NOT_INTEGER`: a rounding to an integer-grid map is larger than the tolerance; or a
          singular edge has no coordinate axis; or so much collapses at the nearest integers that
          most cells become flipped, or the grid can't be told from the coordinates;
        - `INVALID_ARGUMENT`: there is no cell or more than \f$ 2^{27} \f$, a cell has a vertex
          twice or not 4 of them, a feature is no facet or edge of a cell, the neighbors don't fit
          the cells or are listed in different orientations, a tolerance is negative, or the scale
          is not positive;
        - `NOT_REPRESENTABLE`: coordinates would exceed the largest number; or, with `integer_grid`,
          a coordinate is beyond \f$ 2^{46} \f$, or
          \f$ 2^{17} \f$ for `float`s;
        - `INEXACT_ARITHMETIC`: the program was compiled with options like `-ffast-math`;
        - `INTERNAL_ERROR`: the result failed its verification; or `uvw_map` does not keep the
          values that the function writes. The function has then restored the old coordinates.
        .
        The message names the place and the remedy.

\par Orientation
Cells can list their vertices in either orientation. The orientation of most cells of a component
counts, or the orientation of the first cell if there is no majority. If a component is not
orientable, each cell keeps its orientation. A cell is flipped if its orientation in the domain
differs from the orientation of most cells of its component. A component that is mirrored as a whole
has no flips.

Cells keep their orientation if small moves of their vertices allow it.
`Snapping_report::lost_faces` lists the cells that had the orientation of most cells, and lost it.
Cells may be flipped or degenerate in the input.
`repair_flips` decreases the energy of Garanzha et al. \cgalCite{cgal:gkkprs-ffm-21}, vertex by
vertex.

\par Charts
If components have many charts, for example one for each hexahedron, the function joins these charts
to keep the system small. It does so if there are more than 32 charts, not counting one for each
component. The result then only comes close to the least-squares optimum.

\par Complexity
Linear in the number of cells, with a constant of a few passes over the facets. In addition, sparse
elimination of a system whose size depends on the topology of the cuts only: three unknowns for each
sector of a place (a place stands for all vertices at which the same sheets and levels meet in the
same way). With `integer_grid` and `repair_flips`, the function copies all cells. All iterations are
bounded.

\sa `is_volume_integer_grid_map()`
\sa `is_volume_seamless()`
\sa `snap_to_seamless()`
*/
template <typename TetrahedronRange, typename CornerUVWMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Snapping_report
snap_volume_to_seamless(const TetrahedronRange& tetrahedra, CornerUVWMap uvw_map,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Protect_exact_arithmetic protect;
  if(const auto refusal = internal::inexact_arithmetic())
    return internal::refused<Snapping_report>(*refusal);
  return internal::snap_volume(tetrahedra, uvw_map,
                               internal::strip(np, internal::volume_parameters));
}

/*!
\ingroup PkgSeamlessSnappingRef

The cells of a triangulation as the ranges that `snap_volume_to_seamless()` takes, and the handle of
each cell and vertex. Key `4 * i + k` of a map of corners is `cells[i]->vertex(k)`.

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
  /// the facets of the complex with a cell on both sides, such as facets between subdomains, by
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

returns the finite cells of a triangulation.

\tparam Triangulation a class derived from `CGAL::Triangulation_3`
\param triangulation the triangulation, to which the handles of the result refer

\pre there are at most \f$ 2^{27} \f$ finite cells

\par Complexity
Linear in the number of cells, in expectation: cells and vertices are hashed.
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
edges.

\tparam C3t3 a model of `MeshComplexWithFeatures_3InTriangulation_3`, such as
        `CGAL::Mesh_complex_3_in_triangulation_3`
\param c3t3 the complex, to whose triangulation the handles of the result refer

\pre there are at most \f$ 2^{27} \f$ cells

\par Complexity
Linear in the number of cells of the triangulation, in expectation: cells and vertices are hashed.
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

#endif // CGAL_SEAMLESS_SNAPPING_SNAP_VOLUME_TO_SEAMLESS_H
