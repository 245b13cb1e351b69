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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUANTIZE_SURFACE_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUANTIZE_SURFACE_H

#include <CGAL/license/Quad_remeshing.h>

// From the faces of a map to its quantization.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Quad_remeshing/internal/quantization/Border_steps.h>
#include <CGAL/Quad_remeshing/internal/quantization/Intrinsic_complex.h>
#include <CGAL/Quad_remeshing/internal/support/Work.h>
#include <CGAL/Quad_remeshing/types/Quantization.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

struct Quantization_options
{
  double number_of_quads = 0;
  double maximum_number = (std::numeric_limits<double>::max)(); // of quads; more are refused
  double maximum_feature_loss = 0; // the part of the features' length that may be released
  bool is_coarsest = false; // as few as are found
  bool needs_face_graph = false; // of more quads, if there is none of so many
  std::shared_ptr<Work> work = std::make_shared<Work>(); // that all searches share
};

// What is the same whatever number of quads is wanted.
struct Coarse_surface
{
  Integer_mesh input;        // with the steps of the border
  Border_steps steps;
  Intrinsic_complex complex; // without units
};

// Invariant: the units of the complex are feasible.
struct Quantized_surface
{
  std::shared_ptr<const Coarse_surface> coarse;
  Intrinsic_complex complex;
  bool is_for_face_graph = false; // without the quads around vertices of one edge
};

// \param is_feature per corner, or empty
// \param vertex_name for messages
Quantization quantize_surface(const Chart_mesh& mesh, const std::vector<char>& is_feature,
                              const Quantization_options& options,
                              const std::function<std::string(std::size_t)>& vertex_name);

// Of the same surface, of another number of quads.
// \pre there is a quantization
Quantization quantize_again(const Quantization& quantization, const Quantization_options& options);

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Quad_remeshing/internal/quantization/quantize_surface_impl.h>
#endif

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUANTIZE_SURFACE_H
