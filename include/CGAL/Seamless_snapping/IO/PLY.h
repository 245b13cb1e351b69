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

#ifndef CGAL_SEAMLESS_SNAPPING_IO_PLY_H
#define CGAL_SEAMLESS_SNAPPING_IO_PLY_H

#include <CGAL/license/Seamless_snapping.h>

// Triangle meshes with coordinates per corner, from and to the PLY format.

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_parser.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_rewriter.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_text_builder.h>
#include <CGAL/Seamless_snapping/internal/IO/text_and_mesh.h>
#include <CGAL/Seamless_snapping/types/File_status.h>

#include <istream>
#include <ostream>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Seamless_snapping {
namespace IO {

/*!
\ingroup PkgSeamlessSnappingIO

\brief reads a triangle mesh with coordinates per corner from a stream in the PLY format.

The file holds a list `texcoord` of six numbers for each face, as MeshLab writes it ("wedge" texture
coordinates), in text or binary form. Elements `edge` with the properties `vertex1` and `vertex2`
are the feature edges. All other elements and properties are skipped. A file with coordinates per
vertex is refused: they can't tell the two sides of a seam apart.

All else is as with `read_OBJ()`: named parameters, the order of vertices and faces, what is
refused; but messages name faces and vertices by their indices, which count from 0, and no lines.

\tparam TriangleMesh a model of `MutableFaceGraph`
\tparam HalfedgeUVMap a model of `HalfedgeUVMap` for `TriangleMesh` and of `ReadWritePropertyMap`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param is the input stream
\param tmesh the mesh that the triangles are added to
\param uv_map receives for each halfedge of the new faces the coordinates of the corner at its
       target
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of `read_OBJ()`

\returns an object that converts to `true` if the mesh was read, and that holds the reason otherwise

\par Complexity
That of `read_OBJ()`.
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
File_status read_PLY(std::istream& is, TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::read_mesh<internal::PLY_parser>(is, tmesh, uv_map, np);
}

/*!
\ingroup PkgSeamlessSnappingIO

\brief reads a triangle mesh with coordinates per corner from a file in the PLY format.

Parameters, named parameters, and result are those of the function that reads from a stream.
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
File_status read_PLY(const std::string& filename, TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::read_mesh<internal::PLY_parser>(filename, tmesh, uv_map, np);
}

/*!
\ingroup PkgSeamlessSnappingIO

\brief writes a triangle mesh with coordinates per corner to a stream in the binary PLY format.

Numbers are `double`s, so that what is written reads back bit for bit. Template parameters,
parameters, named parameters, and result are those of `write_OBJ()`.

\pre All faces are triangles.

\par Complexity
Linear in the size of the mesh.
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
File_status write_PLY(std::ostream& os, const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                      const std::string& comments,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  if constexpr(internal::check_uv_map<TriangleMesh, HalfedgeUVMap>())
    return internal::write_mesh(os, [&] {
      return internal::build_PLY_text(tmesh, uv_map, comments, internal::strip(np));
    });
}

/*!
\ingroup PkgSeamlessSnappingIO
\brief writes a triangle mesh with coordinates per corner to a file in the binary PLY format.
Parameters, named parameters, and result are those of the function that writes to a stream.
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
File_status write_PLY(const std::string& filename, const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                      const std::string& comments,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  if constexpr(internal::check_uv_map<TriangleMesh, HalfedgeUVMap>())
    return internal::write_mesh(filename, [&] {
      return internal::build_PLY_text(tmesh, uv_map, comments, internal::strip(np));
    });
}

/*!
\ingroup PkgSeamlessSnappingIO

\brief copies a file in the PLY format with other texture coordinates, and all else as it is.

Replaced are the numbers of the lists `texcoord` that differ from those of the mesh, and the type of
these lists if it is `float` and does not hold the numbers: then it becomes `double`. Template
parameters, parameters, named parameters, and result are those of `rewrite_OBJ()`.

\par Complexity
Linear in the size of the file.
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
File_status rewrite_PLY(std::istream& original, std::ostream& os, const TriangleMesh& tmesh,
                        HalfedgeUVMap uv_map,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::rewrite_mesh<internal::PLY_parser, internal::PLY_rewriter>(
    original, os, tmesh, uv_map, np);
}

/*!
\ingroup PkgSeamlessSnappingIO
\brief copies a file in the PLY format with other texture coordinates, and all else as it is.
Parameters, named parameters, and result are those of the function on streams. The two names may be
the same.
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
File_status rewrite_PLY(const std::string& original, const std::string& filename,
                        const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::rewrite_mesh<internal::PLY_parser, internal::PLY_rewriter>(
    original, filename, tmesh, uv_map, np);
}

/// \cond SKIP_IN_MANUAL
// Without comments; `File` is a stream or the name of a file.
template <typename File, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<!std::is_convertible_v<const NamedParameters&, std::string>, int> = 0>
File_status write_PLY(File&& file, const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  return write_PLY(file, tmesh, uv_map, std::string(), np);
}
/// \endcond

} // namespace IO
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_IO_PLY_H
