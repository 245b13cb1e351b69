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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_DEFAULT_SOLVER_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_DEFAULT_SOLVER_H

#include <CGAL/license/Quad_remeshing.h>

// The solver of all sparse systems unless the caller names another one.

#include <CGAL/Linear_snapping/internal/linear/Sparse_cholesky.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Eigen_sparse_matrix.h>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {
namespace parametrization {

using Default_solver =
  CGAL::Eigen_solver_traits<Sparse_cholesky<CGAL::Eigen_sparse_matrix<double>::EigenType> >;

} // namespace parametrization
} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_DEFAULT_SOLVER_H
