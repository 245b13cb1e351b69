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

\brief reads a triangle mesh with coordinates per corner from a stream or a file in the PLY format.

The file holds a list `texcoord` of six numbers for each face, as MeshLab writes it ("wedge" texture
coordinates), in text or binary form. Elements `edge` with the properties `vertex1` and `vertex2`
are the feature edges. The function skips all other elements and properties. It refuses a file with
coordinates per vertex, because they cannot represent the two sides of a seam.

Template parameters, parameters, named parameters, return value, order, and refusals are as for
`read_OBJ()`. Messages name faces and vertices by their indices, which count from 0, in place of
lines.

\par Complexity
The complexity of `read_OBJ()`.
*/
template <typename Source, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
File_status read_PLY(Source&& source, TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::read_mesh<internal::PLY_parser>(source, tmesh, uv_map, np);
}

/*!
\ingroup PkgSeamlessSnappingIO

\brief writes a triangle mesh with coordinates per corner to a stream or a file in the binary PLY
format.

Numbers are `double`s, and read back bit for bit. Template parameters, parameters, named parameters,
and return value are as for `write_OBJ()`.

\pre All faces are triangles.

\par Complexity
Linear in the size of the mesh.
*/
template <typename Target, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
File_status write_PLY(Target&& output, const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                      const std::string& comments,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  if constexpr(internal::check_uv_map<TriangleMesh, HalfedgeUVMap>())
    return internal::write_mesh(output, [&] {
      return internal::text_of_surface<internal::PLY_text>(
        tmesh, uv_map, comments, internal::strip(np, internal::file_parameters));
    });
}

/// \cond SKIP_IN_MANUAL
// Without comments.
template <typename Target, typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<!std::is_convertible_v<const NamedParameters&, std::string>, int> = 0>
File_status write_PLY(Target&& output, const TriangleMesh& tmesh, HalfedgeUVMap uv_map,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  return write_PLY(output, tmesh, uv_map, std::string(), np);
}
/// \endcond

} // namespace IO
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_IO_PLY_H
