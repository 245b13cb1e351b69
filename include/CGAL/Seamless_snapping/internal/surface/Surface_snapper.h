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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SURFACE_SNAPPER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SURFACE_SNAPPER_H

#include <CGAL/license/Seamless_snapping.h>

// The steps of the surface function, one after the other: transitions, sectors, branches, the reduced
// system, its solution on a grid, the coordinates of all sectors, writing, and verification.

#include <CGAL/Seamless_snapping/Snapping_report.h>
#include <CGAL/Seamless_snapping/internal/Step_timer.h>
#include <CGAL/Seamless_snapping/internal/algebra/solve_on_grid.h>
#include <CGAL/Seamless_snapping/internal/surface/Align_edges.h>
#include <CGAL/Seamless_snapping/internal/surface/Branches.h>
#include <CGAL/Seamless_snapping/internal/surface/Constraint_list.h>
#include <CGAL/Seamless_snapping/internal/surface/Orientation_repair.h>
#include <CGAL/Seamless_snapping/internal/surface/Path_rotations.h>
#include <CGAL/Seamless_snapping/internal/surface/Reduced_system.h>
#include <CGAL/Seamless_snapping/internal/surface/Sector_map.h>
#include <CGAL/Seamless_snapping/internal/surface/Snapped_uv_map.h>
#include <CGAL/Seamless_snapping/internal/surface/local_grids.h>
#include <CGAL/Seamless_snapping/internal/surface/read_transitions.h>
#include <CGAL/Seamless_snapping/internal/surface/snapped_coordinates.h>
#include <CGAL/Seamless_snapping/internal/surface/write_coordinates.h>
#include <CGAL/Seamless_snapping/internal/surface/write_free_vertices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
class Surface_snapper
{
  using Sectors = Sector_map<TriangleMesh, HalfedgeUVMap>;
  using Coordinates = Sector_coordinates<TriangleMesh, HalfedgeUVMap>;
  using System = Reduced_system<TriangleMesh, HalfedgeUVMap>;
  using Snapped = Snapped_coordinates<TriangleMesh, HalfedgeUVMap>;
  using Vertex_index_map = std::decay_t<decltype(
    CGAL::get_initialized_vertex_index_map(std::declval<const TriangleMesh&>(),
                                           std::declval<const NamedParameters&>()))>;
  using Rotation_lookup = Path_rotations<TriangleMesh>;
  using Repair = Orientation_repair<TriangleMesh, HalfedgeUVMap, Vertex_index_map>;

public:
  Surface_snapper(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map, const NamedParameters& np)
    : m_tmesh(tmesh), m_uv_map(uv_map), m_np(np),
      m_vertex_indices(CGAL::get_initialized_vertex_index_map(tmesh, np)),
      m_timer(m_report.run, CGAL::parameters::choose_parameter(
                          CGAL::parameters::get_parameter(np, CGAL::internal_np::verbose), false)),
      m_repairs_flips(CGAL::parameters::choose_parameter(
                        CGAL::parameters::get_parameter(np, CGAL::internal_np::repair_flips), false))
  { }

  Snapping_report run()
  {
    const Transition_data<TriangleMesh> transitions = read_transitions(m_tmesh, m_uv_map, m_np);
    fill_in(transitions);
    m_timer.finish("transitions");
    if(failed(transitions.status, transitions.message))
      return m_report;

    const Align_edges<TriangleMesh> align_edges =
      read_align_edges(m_tmesh, m_uv_map, transitions.extent, m_np);
    const Constraint_list<TriangleMesh> constraints(m_tmesh, m_np);
    m_report.violation_before = (std::max)(transitions.violation, align_edges.violation());
    if(failed(align_edges.status(), align_edges.message()) ||
       failed(constraints.status(), constraints.message()))
      return m_report;
    m_was_exact =
      transitions.is_exact && align_edges.is_exact() &&
      constraints_hold(m_tmesh, m_uv_map, constraints, Rotation_lookup(m_tmesh, transitions, constraints));
    if(m_was_exact && !(m_repairs_flips && has_flips(m_tmesh, m_uv_map)))
      return m_report;

    Sectors sectors(m_tmesh, m_uv_map, transitions, align_edges, constraints.corners(),
                    m_vertex_indices);
    m_timer.finish("sectors");

    const Branches branches(sectors);
    m_report.run.number_of_singular_vertices = sectors.number_of_singular_vertices();
    fill_in(sectors, branches);
    m_timer.finish("branches");

    Grid grid = Grid::finest(Number_format::of<typename Uv_number<HalfedgeUVMap>::type>(),
                             sectors.largest_coordinate());
    if(constraints.empty()) // these may link anything
      magnify_small_parts(sectors, branches, grid);
    if(m_was_exact) {
      finish({input_of_sectors(sectors), grid, 0}, transitions, align_edges, constraints, sectors,
             branches);
      return m_report;
    }
    while(!snap_on(grid, transitions, align_edges, constraints, sectors, branches)) {}
    return m_report;
  }

private:
  bool failed(const Snapping_status status, const std::string& message)
  {
    m_report.status = status;
    m_report.message = message;
    return status != Snapping_status::ALREADY_EXACT;
  }

  void fill_in(const Transition_data<TriangleMesh>& transitions)
  {
    m_report.run.number_of_faces = faces(m_tmesh).size(); // num_faces() counts removed ones too
    m_report.run.number_of_cut_edges = transitions.number_of_cuts;
    m_report.run.number_of_merged_edges = transitions.edges.size() - transitions.number_of_cuts;
    m_report.extent = transitions.extent;
    m_report.violation_before = transitions.violation;
  }

  void fill_in(const Sectors& sectors, const Branches& branches)
  {
    m_report.run.number_of_sectors = sectors.number_of_sectors();
    m_report.run.number_of_nodes =
      std::size_t(std::count(branches.is_node.begin(), branches.is_node.end(), true));
    m_report.run.number_of_cut_branches = branches.cut.size();
    m_report.run.number_of_align_branches = branches.aligned.size();
  }

  // Returns false, with a coarser grid, if that is needed: rare, for coordinates that grow past a power of two.
  bool snap_on(Grid& grid, const Transition_data<TriangleMesh>& transitions,
               const Align_edges<TriangleMesh>& align_edges,
               const Constraint_list<TriangleMesh>& constraints, const Sectors& sectors,
               const Branches& branches)
  {
    const Coordinates coordinates(sectors, m_uv_map, grid);
    const System system(sectors, branches, transitions, align_edges, constraints, coordinates, grid);
    m_report.linear_solver.number_of_unknowns = system.point().values.size();
    m_report.linear_solver.number_of_redundant_constraints = 0; // what follows adds to these
    m_report.linear_solver.number_of_non_unit_pivots = 0;
    m_report.linear_solver.number_of_coefficients = 0;
    m_report.linear_solver.number_of_eliminated_coefficients = 0;
    m_timer.finish("reduced system");

    Grid_solution solution{grid, {}, {}};
    const bool solved = std::visit([&](const auto& s) {
      m_report.linear_solver.number_of_constraints = s.number_of_rows();
      return solve_on_grid(s, system.point(), solution, m_report, m_timer);
    }, system.system());
    if(!solved) {
      explain(system, constraints);
      return true;
    }
    const Coordinates final_coordinates(sectors, m_uv_map, solution.grid);
    Snapped snapped(sectors, branches, system, final_coordinates, solution);
    if(!snapped.fits()) {
      if(solution.grid.exponent() >= grid.exponent()) {
        grid = Grid(grid.format(), solution.grid.exponent() + 1);
        return false;
      }
      m_report.status = Snapping_status::NOT_REPRESENTABLE; // right-hand sides forbid a coarser grid
      explain(system, constraints);
      return true;
    }
    m_timer.finish("coordinates");
    finish({snapped.take(), solution.grid, snapped.optimal_squares()}, transitions, align_edges,
           constraints, sectors, branches);
    return true;
  }

  // Coordinates of sectors that satisfy all constraints.
  struct Exact_solution
  {
    Uv_state uv;
    Grid grid;
    double optimal_squares;
  };

  // Repairs, verifies, and writes.
  void finish(Exact_solution solution, const Transition_data<TriangleMesh>& transitions,
              const Align_edges<TriangleMesh>& align_edges,
              const Constraint_list<TriangleMesh>& constraints, const Sectors& sectors,
              const Branches& branches)
  {
    const typename Repair::Solution solve_again(branches, transitions, align_edges, constraints,
                                                m_uv_map, solution.grid);
    Repair repair(sectors, transitions, align_edges, m_uv_map, m_vertex_indices, solve_again,
                  m_repairs_flips);
    repair.run(solution.uv, m_report);
    m_timer.finish("orientation");
    if(m_was_exact && m_report.run.number_of_repaired_flips == 0)
      return; // nothing moves

    if(!is_exact(sectors, transitions, align_edges, constraints, solution.uv))
      return fail("the result failed its exact verification and was discarded; please report this");
    m_timer.finish("verification");
    if(!write(sectors, repair.points(), solution))
      return fail("the uv map does not keep what is written to it; each corner needs a place of its "
                  "own, and the full precision of the points' number type");
    m_timer.finish("writing");
    m_report.run.grid_step = solution.grid.step();
    m_report.status = Snapping_status::SNAPPED;
  }

  bool is_exact(const Sectors& sectors, const Transition_data<TriangleMesh>& transitions,
                const Align_edges<TriangleMesh>& align_edges,
                const Constraint_list<TriangleMesh>& constraints, const Uv_state& uv) const
  {
    const Sector_uv snapped{uv};
    const Snapped_uv_map<TriangleMesh, HalfedgeUVMap, Sector_uv> snapped_uv(m_uv_map, sectors, snapped,
                                                                            !constraints.empty());
    return all_constraints_hold(sectors, transitions, align_edges, snapped) &&
           constraints_hold(m_tmesh, snapped_uv, constraints,
                            Rotation_lookup(m_tmesh, transitions, constraints));
  }

  // All or nothing.
  bool write(const Sectors& sectors, const typename Repair::Points& points,
             const Exact_solution& solution)
  {
    const Uv_state& uv = solution.uv;
    Change_statistics statistics(solution.grid.step());
    Free_vertex_writer<typename Repair::Points, HalfedgeUVMap> free_vertices(points, m_uv_map);
    Sector_writer<TriangleMesh, HalfedgeUVMap> sector_writer(sectors, m_uv_map);
    const auto take_back = [&]() {
      sector_writer.take_back();
      free_vertices.take_back();
    };
    try {
      free_vertices.write(uv, statistics);
      sector_writer.write(Sector_uv{uv}, statistics);
      if(!free_vertices.is_kept(uv) || !sector_writer.is_kept(Sector_uv{uv})) {
        take_back();
        return false;
      }
    } catch(...) { // by the map
      take_back();
      throw;
    }
    statistics.fill_in(m_report, solution.optimal_squares);
    return true;
  }

  void fail(const char* message)
  {
    m_report.status = Snapping_status::INTERNAL_ERROR;
    m_report.message = message;
  }

  // Translates a failure of the system into the constraints that the caller gave.
  void explain(const System& system, const Constraint_list<TriangleMesh>& constraints)
  {
    if(m_report.status == Snapping_status::NOT_REPRESENTABLE) {
      m_report.message = constraints.corner_constraints().empty()
        ? "the exact coordinates would exceed the largest number of their type; scale them down"
        : "the corner constraints have solutions, but none whose coordinates are multiples of "
          "one power of two that the number type can hold at the size of the coordinates; "
          "round their right-hand sides to fewer bits";
      return;
    }
    m_report.message = "constraints contradict each other:";
    std::set<std::string> names;
    for(const auto& multiple : m_report.certificate)
      names.insert(system.name_of_row(multiple.first, constraints, m_tmesh, m_vertex_indices));
    std::size_t count = 0;
    for(const std::string& name : names)
      if(++count <= 8)
        m_report.message += (count == 1 ? " " : ", ") + name;
    if(count > 8)
      m_report.message += ", and " + std::to_string(count - 8) + " more";
    m_report.message += "; remove or correct one of them";
  }

  const TriangleMesh& m_tmesh;
  HalfedgeUVMap m_uv_map;
  const NamedParameters& m_np;
  Vertex_index_map m_vertex_indices;
  Snapping_report m_report;
  Step_timer m_timer;
  bool m_repairs_flips;
  bool m_was_exact = false;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SURFACE_SURFACE_SNAPPER_H
