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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_PARAMETRIZATION_OPTIONS_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_PARAMETRIZATION_OPTIONS_H

#include <CGAL/license/Quad_remeshing.h>

// The options of a parametrization.

#include <CGAL/Quad_remeshing/internal/parametrization/prescribe_alignment.h>

#include <cstddef>
#include <set>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

struct Parametrization_options
{
  double target_edge_length = 1;
  double curvature_alignment = 0;
  double curvature_adaptivity = 1;
  long number_of_stiffening_rounds = 5;
  unsigned int random_seed = 0;
  std::size_t number_of_untangling_iterations = 500;
  bool may_release = false; // edges from their alignment
  int largest_cone_index = 3;  // of the cones that the field decides
  double least_cone_distance = 0; // of opposite ones, in the size of the mesh
  std::set<std::vector<int> >* known_fields = nullptr; // turns of matchings not to be taken again
  std::vector<int> cone_index; // per vertex; empty: the field decides
  Prescribed_field directions; // empty: no face has one
  std::vector<double> log_size; // per vertex, in units of `target_edge_length`; empty: all are 0
};

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_PARAMETRIZATION_OPTIONS_H
