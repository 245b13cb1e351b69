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

#ifndef CGAL_SEAMLESS_SNAPPING_IO_OBJ_H
#define CGAL_SEAMLESS_SNAPPING_IO_OBJ_H

#include <CGAL/license/Seamless_snapping.h>

// Triangle meshes with coordinates per corner, from and to the OBJ format. CGAL's own reader drops
// the texture coordinates, and refuses files with feature edges.

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_parser.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_rewriter.h>
#include <CGAL/Seamless_snapping/internal/IO/mesh_texts.h>
#include <CGAL/Seamless_snapping/internal/IO/text_and_mesh.h>
#include <CGAL/Seamless_snapping/types/File_status.h>

#include <string>
#include <type_traits>

namespace CGAL {
namespace Seamless_snapping {
namespace IO {

/*!
\ingroup PkgSeamlessSnappingIO

\brief reads a triangle mesh with coordinates per corner from a stream or a file in the OBJ format.

The statements `v` (points), `vt` (coordinates), and `f` (triangles whose corners are `v/vt` or
`v/vt/vn`) are read; `l` (polylines along edges of the mesh) are the feature edges. Other statements
are skipped. The numbers become the nearest ones of the number types of `uv_map` and of the vertex
point map, independent of the locale and of the rounding mode. The color of a point and the third
coordinate of a texture are dropped; so are indices `vn`, and those `vt` of `l` elements, which only
have to be integers other than 0.

The mesh is as in the file: vertices and faces come in its order (where `tmesh` has no removed
elements, whose places new ones may take), `target(halfedge(f, tmesh), tmesh)` is the first corner
of face `f`, vertices without faces are kept, no face is reversed. There is one exception: where the
faces around a vertex form several fans, which no halfedge data structure can hold, the fan that
comes first in the file keeps the vertex and each other fan gets a copy, after all other vertices.

Many programs write the mesh cut open along the seams, with vertices doubled: a vertex then has one
pair of coordinates. Such seams are borders, and nothing makes them match, unless `weld_borders` is
`true`: then two border edges between the same points (their numbers agree exactly) that run in
opposite directions become one. The vertices at their ends become one too: the first of them in the
file; the others get no vertex. Vertices that lie in one place without such an edge stay apart, as
do three border edges or more between the same points, and two that run in the same direction: what
belongs together is then unknown. The result counts the edges that were welded, and those that still
coincide.

A file is refused, with the line and the reason, if it has a statement of the above kinds that is
malformed, a number that is not finite, an index out of range, a point with a weight other than 1,
coordinates `vt` with one number only, a face that is no triangle, a corner without coordinates, an
edge with more than two faces or with two faces that are not oriented
consistently (before welding or after it), an `l` element that is no edge of the mesh (if
`edge_is_constrained_map` is given), or no face at all. The mesh and the maps are then left as they
were.

The stream is left at its end. It may have been asked to throw exceptions: only one for `badbit` is
thrown, if reading fails.

As with other readers of \cgal, the data are added to what is in `tmesh`.

\tparam Source a class derived from `std::istream`, or one that converts to `std::string`
\tparam TriangleMesh a model of `MutableFaceGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh` and of `ReadWritePropertyMap`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param source the input stream, or the name of the file
\param tmesh the mesh that the triangles are added to
\param uv_map receives for each halfedge of the new faces the coordinates of the corner at its
       target
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{receives for each new edge whether it is part of an `l` element}
    \cgalParamType{a class model of `ReadWritePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{`l` elements are not looked at, except for their syntax}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{receives the points of the new vertices}
    \cgalParamType{a class model of `ReadWritePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a
                   three-dimensional point as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{weld_borders}
    \cgalParamDescription{whether border edges between the same points are made one, for meshes
                          that were cut open along their seams}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns an object that converts to `true` if the mesh was read, and that holds the reason and the
         line otherwise

\par Complexity
Linear in the size of the file where the degrees of vertices are bounded (for each face that is
added, the faces around its vertices are visited), but for a logarithmic factor where edges, and
with `weld_borders` points, are sorted. The whole text is held in memory.
*/
template <typename Source, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
File_status read_OBJ(Source&& source, TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                    const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::read_mesh<internal::OBJ_parser>(source, tmesh, uv_map, np);
}

/*!
\ingroup PkgSeamlessSnappingIO

\brief writes a triangle mesh with coordinates per corner to a stream or a file in the OBJ format.

What is written reads back bit for bit: each number is the shortest decimal that, taken for a
`double`, gives the number again; this holds for negative zero and subnormal numbers as well. A
`float` is written as the `double` of the same value, so that it is the same number for readers of
either type. Corners at a vertex share a `vt` statement if they agree bit for bit, corners at
different vertices never do. The numbers are independent of the locale and of the rounding mode.

Vertices and faces are written in the order of `vertices(tmesh)` and `faces(tmesh)`, the corners of
a face starting at `target(halfedge(f, tmesh), tmesh)`. If a coordinate is not finite, nothing is
written.

\tparam Target a class derived from `std::ostream`, or one that converts to `std::string`
\tparam TriangleMesh a model of `FaceListGraph`, `VertexListGraph`, and `EdgeListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param output the output stream, or the name of the file. If the status says that the file cannot be
       written to, for example as there is no space left, it may hold a part of the text.
\param tmesh the mesh
\param uv_map the coordinates of the corner at the target of each halfedge that is not on the border
\param comments text for the head of the file, of one or more lines; this argument can be left out
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{tells for each edge whether to write it as an `l` element}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{no `l` elements are written}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a
                   three-dimensional point as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns an object that converts to `true` if the mesh was written, and that holds the reason
         otherwise

\pre All faces are triangles.

\par Complexity
Linear in the size of the mesh, as long as each vertex has few different coordinates.
*/
template <typename Target, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
File_status write_OBJ(Target&& output, const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                     const std::string& comments,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  if constexpr(internal::check_uv_map<TriangleMesh, HalfedgeUVMap>())
    return internal::write_mesh(output, [&] {
      return internal::text_of_surface<internal::OBJ_text>(tmesh, uv_map, comments,
                                                          internal::strip(np));
    });
}

/*!
\ingroup PkgSeamlessSnappingIO

\brief copies a file in the OBJ format with other texture coordinates, and all else as it is.

While `write_OBJ()` writes what the mesh holds, this function keeps the whole file to the byte:
order, materials, groups, smoothing, normals, colors, polylines, comments, and the digits of
numbers. Replaced are the numbers of `vt` statements that differ from those of the mesh, and, where
corners that shared a statement have different coordinates now, the indices of `f` and `l`
statements: further `vt` statements then follow the one that was shared. What is written reads back
bit for bit, as with `write_OBJ()`.

\tparam Source,Target as for `read_OBJ()` and `write_OBJ()`
\tparam TriangleMesh a model of `FaceListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param original a stream, or the name of the file, from which the mesh was read by `read_OBJ()`,
       into an empty mesh
\param output the output stream, or the name of the file, which may be that of the original
\param tmesh the mesh, with the faces and points of the file
\param uv_map the coordinates of the corner at the target of each halfedge that is not on the border
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map` of
       `write_OBJ()`, and the one listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{weld_borders}
    \cgalParamDescription{whether the faces of the file that is written share the vertices that
                          `read_OBJ()` makes one if asked to; the statements of the other vertices
                          stay, but no face uses them}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns an object that converts to `true` if the file was written, and that holds the reason
         otherwise: the original cannot be read, the faces of the mesh are not those of the file, or
         a coordinate is not finite. Then nothing is written.

\par Complexity
Linear in the size of the file, as long as each vertex has few different coordinates.
*/
template <typename Source, typename Target, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
File_status rewrite_OBJ(Source&& original, Target&& output, const TriangleMesh& tmesh,
                        HalfedgeUVMap uv_map,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::rewrite_mesh<internal::OBJ_parser, internal::OBJ_rewriter>(
    original, output, tmesh, uv_map, np);
}

/// \cond SKIP_IN_MANUAL
// Without comments.
template <typename Target, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<!std::is_convertible_v<const NamedParameters&, std::string>, int> = 0>
File_status write_OBJ(Target&& output, const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  return write_OBJ(output, tmesh, uv_map, std::string(), np);
}
/// \endcond

} // namespace IO
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_IO_OBJ_H
