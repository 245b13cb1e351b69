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

#ifndef CGAL_HEXAHEDRAL_MESHING_IO_HEXAHEDRA_H
#define CGAL_HEXAHEDRAL_MESHING_IO_HEXAHEDRA_H

#include <CGAL/license/Hexahedral_meshing.h>

// Meshes of hexahedra, to the formats of MEDIT, VTK, and OpenVolumeMesh.

#include <CGAL/Hexahedral_meshing/internal/IO/hexahedra_texts.h>
#include <CGAL/Hexahedral_meshing/types/Hexahedral_mesh.h>
#include <CGAL/Seamless_snapping/internal/IO/file_access.h>
#include <CGAL/Seamless_snapping/types/File_status.h>

namespace CGAL {
namespace Hexahedral_meshing {
namespace IO {

/*!
\ingroup PkgHexahedralMeshingIO

\brief writes a hexahedral mesh to a stream or a file in the MEDIT format (`.mesh`).

The references of quadrilaterals are the numbers of their patches, and the references of edges are
the numbers of their curves. Gmsh reads such files, too. Numbers have as many digits as it takes to
read them back bit for bit. This package has no reader for hexahedra.

\tparam Target a class derived from `std::ostream`, or one that converts to `std::string`

\param output the output stream, or the name of the file
\param mesh the mesh

\return an object that converts to `true` if the mesh was written, and that holds the reason
         otherwise: a number is not finite, or the file cannot be written

\pre the vertices of all hexahedra, quadrilaterals, and edges exist

\par Complexity
Linear in the size of the mesh.
*/
template <typename Target>
File_status write_MEDIT(Target&& output, const Hexahedral_mesh& mesh)
{
  return internal::status_of_writing([&] {
    internal::write_text(output, internal::MEDIT_text(mesh));
  });
}

/*!
\ingroup PkgHexahedralMeshingIO

\brief writes a hexahedral mesh to a stream or a file in the legacy format of VTK (`.vtk`), as text.

The numbers of patches and curves are the data `reference` of cells.

\tparam Target a class derived from `std::ostream`, or one that converts to `std::string`

\param output the output stream, or the name of the file
\param mesh the mesh

\return the same as `write_MEDIT()`

\pre the vertices of all hexahedra, quadrilaterals, and edges exist

\par Complexity
Linear in the size of the mesh.
*/
template <typename Target>
File_status write_VTK(Target&& output, const Hexahedral_mesh& mesh)
{
  return internal::status_of_writing([&] {
    internal::write_text(output, internal::VTK_text(mesh));
  });
}

/*!
\ingroup PkgHexahedralMeshingIO

\brief writes a hexahedral mesh to a stream or a file in the format of OpenVolumeMesh (`.ovm`), as
text.

The file has all edges and faces. The properties `patch` of faces and `curve` of edges are the
numbers of patches and curves, or zero.

\tparam Target a class derived from `std::ostream`, or one that converts to `std::string`

\param output the output stream, or the name of the file
\param mesh the mesh

\return the same as `write_MEDIT()`

\pre the vertices of all hexahedra, quadrilaterals, and edges exist

\par Complexity
\f$ O(n \log n) \f$ in the number \f$ n \f$ of hexahedra, for sorting edges and faces.
*/
template <typename Target>
File_status write_OVM(Target&& output, const Hexahedral_mesh& mesh)
{
  return internal::status_of_writing([&] {
    internal::write_text(output, internal::OVM_text(mesh));
  });
}

} // namespace IO
} // namespace Hexahedral_meshing
} // namespace CGAL

#endif // CGAL_HEXAHEDRAL_MESHING_IO_HEXAHEDRA_H
