// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Isocurves_and_layouts package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_MAKE_LAYOUT_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_MAKE_LAYOUT_H

#include <CGAL/license/Isocurves_and_layouts.h>

// From the faces of a map to its layout.

#include <CGAL/Isocurves_and_layouts/internal/layout/Curve_race.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout.h>
#include <CGAL/Isocurves_and_layouts/internal/layout/Layout_domain.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Linear_snapping/types/Report.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

struct Layout_input
{
  Chart_mesh mesh;
  std::vector<char> is_feature; // per corner, or empty
  std::vector<char> is_given;   // per vertex, or empty
  bool align_border;            // the border has to lie on isocurves
  Race_options options;
  std::function<Message(std::size_t)> vertex_name;
};

// The data to which a layout refers. They stay in their place.
struct Layout_data
  : public Report
{
  Layout_domain domain;
  std::unique_ptr<Curve_race> race; // none unless there is a layout
  std::size_t number_of_segments = 0; // that were visited, also then
  Layout layout;
  std::vector<std::size_t> nonpositive_faces;
};

// Fills in the data, of which it needs nothing.
void make_layout(Layout_input&& input, Layout_data& data);

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Isocurves_and_layouts/internal/layout/make_layout_impl.h>
#endif

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_LAYOUT_MAKE_LAYOUT_H
