// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_DEFAULT_SOLVER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_DEFAULT_SOLVER_H

#include <CGAL/license/Seamless_snapping.h>

// The solver of all sparse systems unless the caller names another one: CHOLMOD of SuiteSparse
// where the build system has found it and defines CGAL_SEAMLESS_SNAPPING_USE_SUITESPARSE, and
// Eigen's own elsewhere. CHOLMOD works on dense blocks, which pays where cones couple the two
// coordinates.

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Eigen_sparse_matrix.h>

#ifdef CGAL_SEAMLESS_SNAPPING_USE_SUITESPARSE
#include <Eigen/CholmodSupport>
#else
#include <Eigen/SparseCholesky>
#endif

namespace CGAL {
namespace Seamless_snapping {
namespace internal {
namespace parameterization {

using Eigen_matrix_of_systems = CGAL::Eigen_sparse_matrix<double>::EigenType;

#ifdef CGAL_SEAMLESS_SNAPPING_USE_SUITESPARSE

// CHOLMOD would print each failure to the standard output, which belongs to the caller.
class Default_solver
  : public CGAL::Eigen_solver_traits<Eigen::CholmodDecomposition<Eigen_matrix_of_systems> >
{
public:
  Default_solver() { solver().cholmod().print = 0; }
};

#else

using Default_solver =
  CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Eigen_matrix_of_systems> >;

#endif

} // namespace parameterization
} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_DEFAULT_SOLVER_H
