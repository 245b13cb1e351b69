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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_RUN_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_RUN_H

#include <CGAL/license/Quad_remeshing.h>

// The common data of the steps of remeshing: the surface, options, and results.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/Step_timer.h>
#include <CGAL/Quad_remeshing/internal/Remeshing_options.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Surface_to_remesh.h>
#include <CGAL/Quad_remeshing/internal/support/Work.h>
#include <CGAL/Quad_remeshing/quantize.h>
#include <CGAL/Quad_remeshing/types/Remeshing_report.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// In units of its sizes.
inline double area_in_squares(const Surface_to_remesh& surface)
{ return area_in_squares(surface.mesh(), 1, parameters::vertex_sizing_map(surface.sizes())); }

// From here on, it is no feature: no field can follow it without flips, or quads are inverted next
// to it.
inline void release(const Surface_to_remesh::Halfedge h, Surface_to_remesh& surface,
                    Remeshing_report& report)
{
  surface.is_feature()[surface.mesh().edge(h)] = false;
  ++report.number_of_released_edges;
  report.length_of_released_edges += surface.unscaled(surface.length(h));
}

// What has come of a surface so far, in one attempt to make quads.
// Invariant: `report` tells why the last step failed, if it did.
struct Remeshing_run
  : public Remeshing_types
{
  // What the steps up to a quantization change, but for the map.
  struct State
  {
    Remeshing_report report;
    Quantization quantization;
    std::vector<char> is_feature; // per edge
  };

  Remeshing_run(Surface_to_remesh& input, const Remeshing_options& wanted)
    : surface(input), options(wanted), work(*wanted.quantization.work), timer(report)
  { }

  const Mesh& mesh() const { return surface.mesh(); }

  double area() const
  { return area_in_squares(mesh(), 1, CGAL::parameters::default_values()); }

  // What all steps know of the surface; the first one writes the transitions.
  auto features_and_transitions() const
  {
    return parameters::edge_is_constrained_map(surface.is_feature())
                      .edge_is_cut_map(surface.is_cut())
                      .halfedge_rotation_map(surface.rotations());
  }

  void release(const Halfedge h) { internal::release(h, surface, report); }

  // Releases the features that force quads. The map stays; only quads need not follow them.
  void release_features_of_quantization()
  {
    const Flat_numbering<Mesh> numbering(mesh());
    const auto point = [&](const std::size_t v) {
      const Point& p = mesh().point(numbering.vertices_in_order()[v]);
      return std::array<double, 3>{surface.unscaled(p.x()), surface.unscaled(p.y()),
                                   surface.unscaled(p.z())};
    };
    for(const std::vector<std::size_t>& f : quantization.released_features) {
      Released_feature released{point(f.front()), point(f.back()), 0};
      for(std::size_t i = 1; i < f.size(); ++i) {
        const Halfedge h = mesh().halfedge(numbering.vertices_in_order()[f[i - 1]],
                                           numbering.vertices_in_order()[f[i]]);
        surface.is_feature()[mesh().edge(h)] = false;
        released.length += surface.unscaled(surface.length(h));
      }
      report.released_features.push_back(released);
    }
  }

  bool take(Quantization found)
  {
    quantization = std::move(found);
    timer.finish("quantization");
    report.number_of_forced_quads = quantization.number_of_forced_quads *
                                    (surface.mirror() ? 2 : 1);
    return quantization || refuse(report, quantization);
  }

  State state() const
  {
    State result{report, quantization, {}};
    for(const auto e : mesh().edges())
      result.is_feature.push_back(surface.is_feature()[e]);
    return result;
  }

  // Times add up.
  void set_state(State state)
  {
    auto times = std::move(report.step_times);
    report = std::move(state.report);
    report.step_times = std::move(times);
    quantization = std::move(state.quantization);
    std::size_t i = 0;
    for(const auto e : mesh().edges())
      surface.is_feature()[e] = bool(state.is_feature[i++]);
  }

  Surface_to_remesh& surface;
  Remeshing_options options;
  Work& work;
  Remeshing_report report;
  Quantization quantization;
  Step_timer timer;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_RUN_H
