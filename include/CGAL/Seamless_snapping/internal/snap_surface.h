// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAP_SURFACE_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAP_SURFACE_H

#include <CGAL/license/Seamless_snapping.h>

// The function `snap_to_seamless()`, a step a line: what each step returns is all that the next
// ones know of it.

#include <CGAL/Seamless_snapping/Snapping_report.h>
#include <CGAL/Seamless_snapping/internal/Step_timer.h>
#include <CGAL/Seamless_snapping/internal/complex/Complex_solver.h>
#include <CGAL/Seamless_snapping/internal/complex/is_exact.h>
#include <CGAL/Seamless_snapping/internal/mesh/explain_refusal.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_cut_complex.h>
#include <CGAL/Seamless_snapping/internal/mesh/write_coordinates.h>
#include <CGAL/Seamless_snapping/internal/orientation/Orientation_repair.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
class Surface_snapper
{
  using Vertex_index_map = std::decay_t<decltype(
    CGAL::get_initialized_vertex_index_map(std::declval<const TriangleMesh&>(),
                                           std::declval<const NamedParameters&>()))>;
  using Cuts = Surface_cuts<Group, TriangleMesh>;
  using Points = Movable_points<Group, TriangleMesh, HalfedgeUVMap, Vertex_index_map>;

public:
  Surface_snapper(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map, const NamedParameters& np)
    : m_tmesh(tmesh)
    , m_uv_map(uv_map)
    , m_np(np)
    , m_vertex_indices(CGAL::get_initialized_vertex_index_map(tmesh, np))
    , m_timer(m_report.run,
              CGAL::parameters::choose_parameter(
                  CGAL::parameters::get_parameter(np, CGAL::internal_np::verbose), false))
    , m_repairs_flips(CGAL::parameters::choose_parameter(
          CGAL::parameters::get_parameter(np, CGAL::internal_np::repair_flips), false))
  { }

  Snapping_report run()
  {
    if(std::optional<Refusal> refusal = snap()) {
      m_report.status = refusal->status;
      m_report.message = std::move(refusal->message);
      m_report.certificate = std::move(refusal->certificate);
    }
    m_timer.finish("end");
    return std::move(m_report);
  }

private:
  std::optional<Refusal> snap()
  {
    if(faces(m_tmesh).size() == 0)
      return Refusal{Snapping_status::INVALID_ARGUMENT, "the mesh has no face; was it read?", {}};
    const auto transitions = read_transitions<Group>(m_tmesh, m_uv_map, m_np);
    fill_in(transitions);
    m_timer.finish("transitions");
    if(transitions.refusal)
      return transitions.refusal;

    const auto aligned_edges =
      read_aligned_edges<Group>(m_tmesh, m_uv_map, transitions.extent, m_np);
    m_report.violation_before = (std::max)(transitions.violation, aligned_edges.violation());
    const Constraint_list<TriangleMesh> constraints(m_tmesh, m_np);
    if(aligned_edges.refusal() || constraints.refusal())
      return aligned_edges.refusal() ? aligned_edges.refusal() : constraints.refusal();

    const Cuts cuts = read_cut_complex(m_tmesh, m_uv_map, m_vertex_indices, transitions,
                                       aligned_edges, constraints);
    fill_in(cuts);
    m_timer.finish("cut complex");

    const bool was_exact = transitions.is_exact && is_exact(cuts.complex, cuts.complex.coordinates);
    if(was_exact && !(m_repairs_flips && has_flips(m_tmesh, m_uv_map)))
      return std::nullopt;
    m_timer.finish("verification of the input");

    Complex_solver<Group> solver(
      cuts.complex, Number_format::of<typename Uv_number<HalfedgeUVMap>::type>());
    m_report.linear_solver = solver.linear_solver().figures();
    m_timer.finish("elimination");
    Snapped_coordinates<Group> snapped{cuts.complex.coordinates, 0, solver.coarsest_step(), -1};
    if(!was_exact)
      if(const auto refusal = solver.solve(snapped))
        return explained(*refusal, cuts, constraints, solver.system(), m_tmesh, m_vertex_indices);
    m_timer.finish("solution");

    Points points(m_tmesh, cuts, m_uv_map, m_vertex_indices, solver);
    Orientation_repair<Points, HalfedgeUVMap>(points, m_uv_map, solver, m_repairs_flips)
      .run(snapped.coordinates, m_report);
    m_timer.finish("orientation");
    if(was_exact && m_report.run.number_of_repaired_flips == 0)
      return std::nullopt; // nothing moves

    if(!is_exact(cuts.complex, snapped.coordinates))
      return Refusal{Snapping_status::INTERNAL_ERROR,
                     "the result failed its exact verification and "
                     "was discarded; please report this",
                     {}};
    m_timer.finish("verification");
    return write(cuts, points, snapped);
  }

  void fill_in(const Transition_data<TriangleMesh>& transitions)
  {
    m_report.run.number_of_faces = faces(m_tmesh).size(); // num_faces() counts removed ones too
    m_report.run.number_of_cut_edges = transitions.number_of_cuts;
    m_report.run.number_of_merged_edges = transitions.edges.size() - transitions.number_of_cuts;
    m_report.run.number_of_edges_decided_by_surroundings =
      transitions.number_of_edges_decided_by_surroundings;
    m_report.extent = transitions.extent;
    m_report.violation_before = transitions.violation;
  }

  void fill_in(const Cuts& cuts)
  {
    const Cut_complex<Group>& complex = cuts.complex;
    m_report.run.number_of_singular_vertices = cuts.number_of_singular_vertices;
    m_report.run.number_of_sectors = complex.number_of_sectors();
    m_report.run.number_of_nodes =
      std::size_t(std::count(complex.is_node.begin(), complex.is_node.end(), true));
    m_report.run.number_of_cut_branches = complex.number_of_branches();
    m_report.run.number_of_align_branches = complex.number_of_chains();
  }

  std::optional<Refusal> write(const Cuts& cuts, const Points& points,
                               const Snapped_coordinates<Group>& snapped)
  {
    Corner_changes figures(snapped.unit);
    Coordinate_writer<Group, TriangleMesh, HalfedgeUVMap, Points> writer(cuts, points, m_uv_map);
    if(!writer.write(snapped.coordinates, figures))
      return Refusal{Snapping_status::INTERNAL_ERROR, "the uv map does not keep what is written to "
                     "it; each corner needs a place of its own, and the full precision of the "
                     "points' number type", {}};
    figures.fill_in(m_report, snapped.optimal_squares);
    m_report.run.grid_step = snapped.unit;
    m_report.status = Snapping_status::SNAPPED;
    m_timer.finish("writing");
    return std::nullopt;
  }

  const TriangleMesh& m_tmesh;
  HalfedgeUVMap m_uv_map;
  const NamedParameters& m_np;
  Vertex_index_map m_vertex_indices;
  Snapping_report m_report;
  Step_timer m_timer;
  bool m_repairs_flips;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAP_SURFACE_H
