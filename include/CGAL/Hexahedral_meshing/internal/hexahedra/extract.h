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
#include <CGAL/Hexahedral_meshing/internal/hexahedra/Feature_elements.h>
#include <CGAL/Hexahedral_meshing/internal/hexahedra/Hexahedra_topology.h>
#include <CGAL/Hexahedral_meshing/types/Hexahedra_report.h>
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

struct Hexahedral_soup
{
  std::vector<Hexahedron> hexahedra;
  std::vector<Uvw> points;
  // per vertex, if they are kept: a cell of the volume, and barycentric coordinates there
  std::vector<std::int32_t> cells;
  std::vector<std::array<double, 4> > weights;
  // if they are kept
  Feature_complex complex;
  Feature_elements features;
};

// Extracts, and fills in the numbers of the report. Returns why there is nothing, if so.
// \param volume all cells, with an aligned boundary
// \param points per vertex of the volume
std::optional<Refusal> extract(const Flat_volume& volume, const std::vector<Uvw>& points,
                               const Extraction_options& options, Hexahedral_soup& soup,
                               Hexahedra_report& report);

} // namespace internal
} // namespace Hexahedral_meshing
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Hexahedral_meshing/internal/hexahedra/extract_impl.h>
#endif

#endif // CGAL_HEXAHEDRAL_MESHING_INTERNAL_HEXAHEDRA_EXTRACT_H
