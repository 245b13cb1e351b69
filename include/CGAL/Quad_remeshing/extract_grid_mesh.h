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

#ifndef CGAL_QUAD_REMESHING_EXTRACT_GRID_MESH_H
#define CGAL_QUAD_REMESHING_EXTRACT_GRID_MESH_H

#include <CGAL/license/Quad_remeshing.h>

// Quad and triangle meshes out of exactly seamless integer-grid maps.

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Quad_remeshing/internal/cells/cell_outputs.h>
#include <CGAL/Quad_remeshing/internal/cells/extract_cells.h>
#include <CGAL/Quad_remeshing/types/Extraction_report.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>
#include <CGAL/Seamless_snapping/types/Rotational_symmetry.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

namespace CGAL {
namespace Quad_remeshing {

/*!
\ingroup PkgQuadRemeshingQuads

extracts the quad mesh of an exactly seamless integer-grid map: its vertices are the points of the
surface with integer coordinates, and its edges are the pieces of isocurves between them.

\par Guarantee
If all translations are integers, all cones have integer coordinates, all border edges lie on
isocurves of integer coordinates, and all faces are positive in the domain, then the result is a
mesh of quads that is homeomorphic to the surface. The number of quads is the area of the map. An
inner vertex has valence \f$ 4 - i \f$ at a cone of index \f$ i \f$, and 4 elsewhere. The function
checks all these conditions before the extraction and all these results after it, exactly. It uses
no tolerance and repairs nothing; `repair_integer_grid()` does that. If the extraction fails,
nothing is written. The result is the same, to the bit, for any number of threads.

\par Other maps
- A cone of index \f$ i \f$ between the lines of the grid, for example at half-integers, gives a
  cell with \f$ 4 - i \f$ corners. `Extraction_report::number_of_other_polygons` counts such cells.
- If the border does not lie on the grid, the result consists of the whole cells. The report counts
  the others.
- A result with loops or double edges, as from a coarse grid, is no face graph, and refused.
  `extract_quad_soup()` returns it.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_if_available_tag`, or
        `CGAL::Parallel_tag`, which does not compile unless TBB is linked. Unless it is
        `CGAL::Sequential_tag`, several threads read the mesh and its property maps at the same
        time; one thread writes `quads`.
\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph`, `EdgeListGraph`, and
        `VertexListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`
\tparam QuadMesh a model of `MutableFaceGraph`
\tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh
\param uv_map the coordinates of each corner: halfedge `h` stands for the corner of `face(h)` at
       `target(h)`. Border halfedges are not read.
\param quads the mesh that the quads are added to
\param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `tmesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a
                   three-dimensional point as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{grid_scale}
    \cgalParamDescription{a positive factor: the function first multiplies all coordinates by it.
                          The products must be exact, as for powers of two. For other numbers, see
                          `snap_to_seamless()`.}
    \cgalParamType{`double`}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number}
    \cgalParamDescription{the number of quads above which the extraction is refused}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{100 million}
    \cgalParamExtra{More than \f$ 2^{28} \f$ quads are always refused.}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the feature edges. Feature edges on lines of the grid become edges of
                          quads.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no edge is constrained}
  \cgalParamNEnd
  \cgalParamNBegin{allow_holes}
    \cgalParamDescription{whether faces that are flipped or degenerate in the domain are taken for
                          holes, so that the cells that touch or contain them are left out.
                          Otherwise, they are refused; see `repair_integer_grid()`.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{receives the points of the new vertices}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and a
                   three-dimensional point as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, quads)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_location_map}
    \cgalParamDescription{receives for each new vertex its place on the input: a face and
                          barycentric coordinates, in the order of
                          `CGAL::Polygon_mesh_processing::Face_location`}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and
                   `std::pair<boost::graph_traits<TriangleMesh>::%face_descriptor,
                   std::array<double, 3> >` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{cone_index_map}
    \cgalParamDescription{receives for each new vertex the index of the cone there, in quarter
                          turns; 0 if there is none}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and `int` as
                   value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{receives for each new edge whether it runs along a feature edge, or is on
                          the border of the result}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%edge_descriptor` as key type and `bool` as value
                   type}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the outcome and counts; converts to `true` if and only if the quads were written.
        Otherwise `Extraction_report::status` is a status of `Seam_transitions::failure()`, or
        - `INVALID_ARGUMENT`: the mesh has no face, or the coordinates times `grid_scale` are not
          exact;
        - `NOT_FINITE`: a coordinate of a point is NaN or infinite;
        - `NOT_SEAMLESS`: the parametrization is not exactly seamless;
        - `NOT_INTEGER`: a translation is no integer, or a cone or a corner of the border lies on a
          line of the grid, but on no point of the grid;
        - `NOT_POSITIVE`: faces are flipped or degenerate in the domain;
        - `TOO_LARGE`: there would be more quads than `maximum_number`, the grid crosses edges of
          the mesh far more often than that, or a coordinate is beyond \f$ 2^{46} \f$;
        - `TOO_COARSE`: a part of the surface is too small to enclose whole cells of the grid;
        - `NO_FACE_GRAPH`: there are loops or double edges;
        - `INTERNAL_ERROR`: the result failed the check at the end.
        .
        The message names the place and the remedy.

\par Complexity
Linear in the number of faces, of quads, and of intersections of edges of the mesh with lines of the
grid; with a logarithmic factor if a face contains many vertices of quads.

\sa `extract_quad_soup()`
\sa `is_integer_grid_map()`
\sa `snap_to_seamless()`
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename TriangleMesh,
          typename HalfedgeUVMap, typename QuadMesh,
          typename NamedParameters1 = CGAL::parameters::Default_named_parameters,
          typename NamedParameters2 = CGAL::parameters::Default_named_parameters>
Extraction_report extract_quad_mesh(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                    QuadMesh& quads,
                                    const NamedParameters1& np1 =
                                      CGAL::parameters::default_values(),
                                    const NamedParameters2& np2 =
                                      CGAL::parameters::default_values())
{
  return internal::extract_cells<ConcurrencyTag, internal::Quarter_turns>(
    tmesh, uv_map, internal::strip(np1, internal::extraction_parameters),
    internal::cell_mesh_output(tmesh, quads, internal::strip(np2, internal::cell_mesh_parameters)));
}

/*!
\ingroup PkgQuadRemeshingQuads

extracts the same quads as `extract_quad_mesh()`, as points and lists of indices. Loops and double
edges are allowed here. The other template parameters are the same.

\tparam PointRange a model of `BackInsertionSequence` of three-dimensional points
\tparam PolygonRange a model of `BackInsertionSequence` whose value type is constructed from a pair
        of iterators over the indices of a polygon, in counterclockwise order, as
        `std::vector<std::size_t>` is; or is `std::array<Index, 4>`: then maps with cones between
        the lines of the grid are refused

\param tmesh the mesh
\param uv_map the coordinates of each corner, as for `extract_quad_mesh()`
\param points the points of the quads are added to it
\param polygons the quads, and the other cells, are added to it
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": the
       parameters of `extract_quad_mesh()` for `np1`

\return as `extract_quad_mesh()`, but never `NO_FACE_GRAPH`; `NOT_INTEGER` also if there are cells
        that `std::array` can't hold

\par Complexity
The complexity of `extract_quad_mesh()`.

\sa `extract_quad_mesh()`
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename TriangleMesh,
          typename HalfedgeUVMap, typename PointRange, typename PolygonRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Extraction_report extract_quad_soup(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                    PointRange& points, PolygonRange& polygons,
                                    const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::extract_cells<ConcurrencyTag, internal::Quarter_turns>(
    tmesh, uv_map, internal::strip(np, internal::extraction_parameters),
    internal::Cell_soup_output<PointRange, PolygonRange>(points, polygons));
}

namespace internal {

// Adds symmetry 6 to the parameters, unless they have one.
template <typename NamedParameters>
auto with_six_directions(const NamedParameters& all)
{
  const auto& np = strip(all, extraction_parameters + named<internal_np::rotational_symmetry>);
  const auto symmetry =
    CGAL::parameters::get_parameter(np, CGAL::internal_np::rotational_symmetry);
  if constexpr(is_given<decltype(symmetry)>)
    return np;
  else
    return strip(Named_parameters<std::decay_t<decltype(np)> >(np)
                   .rotational_symmetry(Rotational_symmetry<6>()));
}

} // namespace internal

/*!
\ingroup PkgQuadRemeshingQuads

extracts the triangle mesh that an exactly seamless integer-grid map in lattice coordinates
describes, as `snap_to_seamless()` makes them with `integer_grid(true)` and `rotational_symmetry` of
order 6 or 3: its vertices are the points of the surface with integer coordinates, its edges the
pieces of isocurves of \f$ u \f$, \f$ v \f$, and \f$ u + v \f$ between them. If the map
preserves angles, the triangles are nearly equilateral.

Conditions, checks, and exceptions are the same as for `extract_quad_mesh()`, with triangles and the
lattice in place of quads and the grid. The number of triangles is twice the area of the
map, in lattice coordinates, and a vertex has valence \f$ 6 - i \f$ at a cone of index \f$ i \f$,
in sixths of a turn, and 6 elsewhere inside.
- Only angles of 720 degrees and other multiples of 360 degrees can have a cone between the lines of
  the lattice; the cell around it has 6 or more corners.
- Loops and double edges come from cones of 60 and 120 degrees, too; `extract_triangle_soup()` gives
  them.

The other template parameters are the same.

\tparam OutputMesh a model of `MutableFaceGraph`

\param tmesh the mesh
\param uv_map the coordinates of each corner, as for `extract_quad_mesh()`
\param triangles the mesh that the triangles are added to
\param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters" among the one listed
       below, and the parameters of `extract_quad_mesh()`

\cgalNamedParamsBegin
  \cgalParamNBegin{rotational_symmetry}
    \cgalParamDescription{the angles by which charts are turned across cuts}
    \cgalParamType{`Rotational_symmetry<6>` or `Rotational_symmetry<3>`}
    \cgalParamDefault{`Rotational_symmetry<6>()`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters": the
       parameters of `extract_quad_mesh()` for `np2`; indices of cones are in sixths of a turn

\return the outcome and counts, as for `extract_quad_mesh()`

\par Complexity
Linear in the number of faces, of triangles that are written, and of intersections of edges of the
mesh with lines of the lattice; with a logarithmic factor if a face contains many of its points.

\sa `extract_triangle_soup()`
\sa `extract_quad_mesh()`
\sa `is_integer_grid_map()`
\sa `snap_to_seamless()`
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename TriangleMesh,
          typename HalfedgeUVMap, typename OutputMesh,
          typename NamedParameters1 = CGAL::parameters::Default_named_parameters,
          typename NamedParameters2 = CGAL::parameters::Default_named_parameters>
Extraction_report extract_triangle_mesh(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                        OutputMesh& triangles,
                                        const NamedParameters1& np1 =
                                          CGAL::parameters::default_values(),
                                        const NamedParameters2& np2 =
                                          CGAL::parameters::default_values())
{
  return internal::extract_cells<ConcurrencyTag, internal::Sixth_turns>(
    tmesh, uv_map, internal::with_six_directions(np1),
    internal::cell_mesh_output(tmesh, triangles,
                               internal::strip(np2, internal::cell_mesh_parameters)));
}

/*!
\ingroup PkgQuadRemeshingQuads

extracts the same triangles as `extract_triangle_mesh()`, as points and lists of indices. Loops and
double edges are allowed here. The other template parameters are the same.

\tparam PointRange a model of `BackInsertionSequence` of three-dimensional points
\tparam PolygonRange a model of `BackInsertionSequence` whose value type is constructed from a pair
        of iterators over the indices of a polygon, in counterclockwise order, as
        `std::vector<std::size_t>` is; or is `std::array<Index, 3>`: then maps with cones between
        the lines of the lattice are refused

\param tmesh the mesh
\param uv_map the coordinates of each corner, as for `extract_triangle_mesh()`
\param points the points of the triangles are added to it
\param polygons the triangles, and the other cells, are added to it
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": the
       parameters of `extract_triangle_mesh()` for `np1`

\return as `extract_quad_soup()`

\par Complexity
The complexity of `extract_triangle_mesh()`.

\sa `extract_triangle_mesh()`
*/
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename TriangleMesh,
          typename HalfedgeUVMap, typename PointRange, typename PolygonRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Extraction_report extract_triangle_soup(const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                                        PointRange& points, PolygonRange& polygons,
                                        const NamedParameters& np =
                                          CGAL::parameters::default_values())
{
  return internal::extract_cells<ConcurrencyTag, internal::Sixth_turns>(
    tmesh, uv_map, internal::with_six_directions(np),
    internal::Cell_soup_output<PointRange, PolygonRange>(points, polygons));
}

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_EXTRACT_GRID_MESH_H
