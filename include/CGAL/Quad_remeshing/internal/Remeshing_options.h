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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_OPTIONS_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_OPTIONS_H

#include <CGAL/license/Quad_remeshing.h>

// The named parameters of `quad_remesh()` that are numbers.

#include <CGAL/Quad_remeshing/quantize.h>

#include <cstddef>
#include <optional>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

struct Remeshing_options
{
  Quantization_options quantization;
  std::optional<double> curvature_alignment;
  double curvature_adaptivity;
  std::optional<double> border_tolerance; // in the size of the input
  std::optional<double> area_threshold;   // the same
  std::size_t number_of_smoothing_rounds;
  bool has_single_precision; // the points of the quads

  // The wanted number of quads; 0 if no lengths are wanted.
  double number_wanted() const
  {
    return quantization.is_coarsest || curvature_adaptivity > 1 ? 0.
                                                                : quantization.number_of_quads;
  }
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_OPTIONS_H
