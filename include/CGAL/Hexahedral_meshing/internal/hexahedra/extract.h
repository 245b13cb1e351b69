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

#ifndef CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_EXTRACT_H
#define CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_EXTRACT_H

#include <CGAL/license/Hexahedral_meshing.h>

// Hexahedra in plain arrays: what is the same for all types of callers.

#include <CGAL/Hexahedral_meshing/internal/hexahedra/Feature_complex.h>
#include <CGAL/Hexahedral_meshing/types/Hexahedra_report.h>
#include <CGAL/Hexahedral_meshing/types/Hexahedral_mesh.h>
#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Seamless_snapping/internal/volume/Flat_volume.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Hexahedral_meshing {
namespace internal {

struct Extraction_options
{
  std::size_t maximum_number; // of hexahedra
  bool is_parallel, keeps_locations, keeps_features;
};

// The input and the result.
struct Extraction
{
  Flat_volume volume;      // all cells, with an aligned boundary
  std::vector<Uvw> points; // per vertex of the volume
  Hexahedral_mesh mesh;
  // per vertex of the mesh, if locations are kept: a cell, and barycentric coordinates there
  std::vector<std::int32_t> cells;
  std::vector<std::array<double, 4> > weights;
  Feature_complex complex; // if features are kept
};

// Extracts, and fills in the numbers of the report. Returns why there is nothing, if so.
std::optional<Refusal> extract(const Extraction_options& options, Extraction& extraction,
                               Hexahedra_report& report);

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Hexahedral_meshing/internal/hexahedra/extract_impl.h>
#endif

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_EXTRACT_H
