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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SEARCH_TREE_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SEARCH_TREE_H

#include <CGAL/license/Quad_remeshing.h>

// The tree that finds nearest places on the surface that is remeshed. CGAL 6 has renamed its
// traits, and the primitive of triangles.

#include <CGAL/Quad_remeshing/internal/remeshing/Surface_to_remesh.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/version_macros.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

#if CGAL_VERSION_NR >= 1060000000
template <typename Primitive>
using Search_tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Surface_to_remesh::Kernel, Primitive> >;

template <typename Iterator>
using Triangle_primitive = CGAL::AABB_triangle_primitive_3<Surface_to_remesh::Kernel, Iterator>;
#else
template <typename Primitive>
using Search_tree = CGAL::AABB_tree<CGAL::AABB_traits<Surface_to_remesh::Kernel, Primitive> >;

template <typename Iterator>
using Triangle_primitive = CGAL::AABB_triangle_primitive<Surface_to_remesh::Kernel, Iterator>;
#endif

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SEARCH_TREE_H
