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

#ifndef CGAL_QUAD_REMESHING_TYPES_QUAD_PATCHES_H
#define CGAL_QUAD_REMESHING_TYPES_QUAD_PATCHES_H

#include <CGAL/license/Quad_remeshing.h>

// The partition of a quad mesh into rectangular patches.

#include <CGAL/Linear_snapping/types/Report.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {

/*!
\ingroup PkgQuadRemeshingPatches

A rectangle of `width` times `height` quads of a mesh.

\tparam QuadMesh the type of the mesh
*/
template <typename QuadMesh>
struct Quad_patch
{
  /// a halfedge of the mesh
  using halfedge_descriptor = typename boost::graph_traits<QuadMesh>::halfedge_descriptor;

  halfedge_descriptor corner{}; ///< begins at a corner; the patch and its first row are at
                                ///< its left
  std::size_t width = 0;        ///< the number of quads in a row
  std::size_t height = 0;       ///< the number of rows
};

/*!
\ingroup PkgQuadRemeshingPatches

The result of `quad_patches()`. Converts to `bool`: `true` if and only if there are patches.

\tparam QuadMesh the type of the mesh
*/
template <typename QuadMesh>
struct Quad_patches
  : public Report
{
  std::vector<Quad_patch<QuadMesh> > patches; ///< all patches, which cover each quad once
  /// vertices of patches that lie inside of a side of another patch
  std::size_t number_of_t_junctions = 0;
};

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_TYPES_QUAD_PATCHES_H
