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

#ifndef CGAL_SEAMLESS_SNAPPING_IO_OBJ_H
#define CGAL_SEAMLESS_SNAPPING_IO_OBJ_H

#include <CGAL/license/Seamless_snapping.h>

// Triangle meshes with coordinates per corner, from and to the OBJ format. CGAL's own reader drops
// the texture coordinates, and refuses files with feature edges.

#include <CGAL/Seamless_snapping/parameters.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_mesh_builder.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_text_builder.h>

#include <cstddef>
#include <fstream>
#include <istream>
#include <ostream>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Seamless_snapping {
namespace IO {

/*!
\ingroup PkgSeamlessSnappingIO

What `read_OBJ()` and `write_OBJ()` return. Converts to `bool`: `true` if and only if the mesh was
read or written completely.

\code{.cpp}
const auto status = CGAL::Seamless_snapping::IO::read_OBJ("torus.obj", tmesh, uv_map);
if(!status)
  std::cerr << status.message << std::endl; // line 17: face has 4 corners; triangulate ...
\endcode
*/
struct OBJ_status
{
  std::string message;  ///< empty on success; else what is wrong, and in which line
  std::size_t line = 0; ///< the number of that line, counted from 1; 0 if it is not about a line
  /*!
  The number of vertices that were added by `read_OBJ()` because the faces around a vertex of the
  file form several fans.
  */
  std::size_t number_of_split_vertices = 0;

  /// returns `true` if and only if the mesh was read or written completely.
  explicit operator bool() const { return message.empty(); }
};

/*!
\ingroup PkgSeamlessSnappingIO
writes the message.
*/
inline std::ostream& operator<<(std::ostream& os, const OBJ_status& status)
{
  return os << (status ? "ok" : status.message);
}

/*!
\ingroup PkgSeamlessSnappingIO

\brief reads a triangle mesh with coordinates per corner from a stream in the OBJ format.

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

A file is refused, with the line and the reason, if it has a statement of the above kinds that is
malformed, a number that is not finite, an index out of range, a point with a weight other than 1,
coordinates `vt` with one number only, a face that is no triangle, a corner without coordinates, an
edge with more than two faces or with two faces that are not oriented
consistently, an `l` element that is no edge of the mesh (if `edge_is_constrained_map` is given), or
no face at all. The mesh and the maps are then left as they were.

The stream is left at its end. It may have been asked to throw exceptions: only one for `badbit` is
thrown, if reading fails.

As with other readers of \cgal, the data are added to what is in `tmesh`.

\tparam TriangleMesh a model of `MutableFaceGraph`
\tparam HalfedgeUVMap a model of `ReadWritePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and a two-dimensional
        point of a kernel whose number type is `double` or `float` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param is the input stream
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
\cgalNamedParamsEnd

\returns an object that converts to `true` if the mesh was read, and that holds the reason and the
         line otherwise

Runs in \f$ O(n \log n) \f$ time where the degrees of vertices are bounded (for each face that is
added, the faces around its vertices are visited), and needs the memory for the whole text.
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
OBJ_status read_OBJ(std::istream& is, TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                    const NamedParameters& np = CGAL::parameters::default_values())
{
  OBJ_status status;
  try {
    const std::string text = internal::text_of_stream(is);
    status.number_of_split_vertices =
      internal::build_mesh_from_OBJ(text, tmesh, uv_map, internal::strip(np));
  } catch(const internal::OBJ_refusal& refusal) {
    status.line = refusal.line();
    status.message = refusal.what();
    if(refusal.line() != 0)
      status.message = "line " + std::to_string(refusal.line()) + ": " + status.message;
  }
  return status;
}

/*!
\ingroup PkgSeamlessSnappingIO

\brief reads a triangle mesh with coordinates per corner from a file in the OBJ format.

Parameters, named parameters, and result are those of the function that reads from a stream.
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
OBJ_status read_OBJ(const std::string& filename, TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                    const NamedParameters& np = CGAL::parameters::default_values())
{
  std::ifstream is(filename, std::ios::binary);
  if(!is) {
    OBJ_status status;
    status.message = "cannot open '" + filename + "'";
    return status;
  }
  OBJ_status status = read_OBJ(is, tmesh, uv_map, np);
  if(is.bad())
    status.message = "cannot read '" + filename + "'";
  return status;
}

/*!
\ingroup PkgSeamlessSnappingIO

\brief writes a triangle mesh with coordinates per corner to a stream in the OBJ format.

What is written reads back bit for bit: each number is the shortest decimal that, taken for a
`double`, gives the number again; this holds for negative zero and subnormal numbers as well. A
`float` is written as the `double` of the same value, so that it is the same number for readers of
either type. Corners at a vertex share a `vt` statement if they agree bit for bit, corners at
different vertices never do. The numbers are independent of the locale and of the rounding mode.

Vertices and faces are written in the order of `vertices(tmesh)` and `faces(tmesh)`, the corners of
a face starting at `target(halfedge(f, tmesh), tmesh)`. If a coordinate is not finite, nothing is
written.

\tparam TriangleMesh a model of `FaceListGraph`, `VertexListGraph`, and `EdgeListGraph`
\tparam HalfedgeUVMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and a two-dimensional
        point of a kernel whose number type is `double` or `float` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param os the output stream
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
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
OBJ_status write_OBJ(std::ostream& os, const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                     const std::string& comments,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  OBJ_status status;
  std::string text;
  if(internal::build_OBJ_text(tmesh, uv_map, comments, internal::strip(np), text, status.message) &&
     !internal::write_text(os, text))
    status.message = "cannot write to the stream";
  return status;
}

/*!
\ingroup PkgSeamlessSnappingIO
\brief writes a triangle mesh with coordinates per corner to a file in the OBJ format.
Parameters, named parameters, and result are those of the function that writes to a stream. If the
status says that the file cannot be written to, for example as there is no space left, it may hold a
part of the text.
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
OBJ_status write_OBJ(const std::string& filename, const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                     const std::string& comments,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  OBJ_status status;
  std::string text;
  if(!internal::build_OBJ_text(tmesh, uv_map, comments, internal::strip(np), text, status.message))
    return status;
  std::ofstream os(filename, std::ios::binary); // not earlier, since this empties the file
  if(!os)
    status.message = "cannot open '" + filename + "' for writing";
  else if(!internal::write_text(os, text) || !os.rdbuf()->close())
    status.message = "cannot write to '" + filename + "'";
  return status;
}

/// \cond SKIP_IN_MANUAL
// Without comments; `File` is a stream or the name of a file.
template <typename File, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<!std::is_convertible_v<const NamedParameters&, std::string>, int> = 0>
OBJ_status write_OBJ(File&& file, const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  return write_OBJ(file, tmesh, uv_map, std::string(), np);
}
/// \endcond

} // namespace IO
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_IO_OBJ_H
