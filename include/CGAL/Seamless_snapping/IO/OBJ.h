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

The function reads the statements `v` (points), `vt` (coordinates), `f` (triangles with corners
`v/vt` or `v/vt/vn`), and `l` (polylines along edges of the mesh: the feature edges). It skips all
other statements, and drops colors of points, third coordinates of textures, and normals. It adds
the data to the content of `tmesh`, as other readers of \cgal do.

Vertices and faces keep the order of the file, and `target(halfedge(f, tmesh), tmesh)` is the first
corner of face `f`. Vertices without faces are kept, and no face is reversed. There is one
exception: if the faces around a vertex form several fans, each further fan gets a copy of the
vertex, after all other vertices.

If the file is refused, the mesh and the maps stay as they are, and the status says why, and in
which line:
- a statement of these kinds is malformed, or a number is not finite;
- an index is out of range, or an `l` element is no edge of the mesh (only with
  `edge_is_constrained_map`);
- a point has a weight other than 1, or a `vt` has only one number;
- a face is no triangle, or has a corner without coordinates;
- an edge has more than two faces, or two faces that are not oriented consistently;
- the file has no face.

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
    \cgalParamDescription{receives `true` for each new edge that is part of an `l` element}
    \cgalParamType{a class model of `ReadWritePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{only the syntax of `l` elements is checked}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{receives the points of the new vertices}
    \cgalParamType{a class model of `ReadWritePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a
                   three-dimensional point as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{weld_borders}
    \cgalParamDescription{whether to join border edges between the same points, for meshes that were
                          cut open along their seams}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
    \cgalParamExtra{Two border edges are joined if their points agree exactly and they run in
                    opposite directions. Their vertices become one, the first of them in the file.
                    Vertices that coincide without such an edge stay apart. So do three or more
                    border edges between the same points, because it is not known which of them
                    belong together. The status counts the edges that were joined, and the border
                    edges that still coincide.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return a status that converts to `true` if the mesh was read; otherwise it holds the reason and
         the line

\par Numbers
Numbers are rounded to the nearest number of the types of `uv_map` and of the vertex point map,
independent of the locale and of the rounding mode.

\par Streams
The stream is left at its end. If it was asked to throw exceptions, only the exception for `badbit`
is thrown, if reading fails.

\par Complexity
\f$ O(n \log n) \f$ in the size \f$ n \f$ of the file, if the degrees of vertices are bounded. The
whole text is held in memory.
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

Numbers read back bit for bit: each is the shortest decimal that, read as a `double`, gives the
number again. This includes negative zero and subnormal numbers. A `float` is written as the
`double` of the same value, so that readers of either type get the same number. The text does not
depend on the locale or the rounding mode. Corners at a vertex share a `vt` statement if they agree
bit for bit. Corners at different vertices never do.

Vertices and faces are written in the order of `vertices(tmesh)` and `faces(tmesh)`, the corners of
a face starting at `target(halfedge(f, tmesh), tmesh)`. If a coordinate is not finite, nothing is
written.

\tparam Target a class derived from `std::ostream`, or one that converts to `std::string`
\tparam TriangleMesh a model of `FaceListGraph`, `VertexListGraph`, and `EdgeListGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param output the output stream, or the name of the file. If writing fails, for example because the
       disk is full, the file may hold a part of the text.
\param tmesh the mesh
\param uv_map the coordinates of the corner at the target of each halfedge that is not on the border
\param comments text for the head of the file, of one or more lines; this argument can be left out
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges to be written as `l` elements}
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

\return a status that converts to `true` if the mesh was written; otherwise it holds the reason

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
      return internal::text_of_surface<internal::OBJ_text>(
        tmesh, uv_map, comments, internal::strip(np, internal::file_parameters));
    });
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
