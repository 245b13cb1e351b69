// Snapping a map of a tetrahedral mesh, and measuring one.

#include "Array_volume.h"
#include "Call.h"
#include "functions.h"
#include "reports.h"

#include <CGAL/Seamless_snapping/is_volume_seamless.h>
#include <CGAL/Seamless_snapping/snap_volume_to_seamless.h>

#include <memory>
#include <optional>
#include <utility>

namespace SS = CGAL::Seamless_snapping;

namespace {

std::pair<Doubles, py::dict>
snap_volume(const Integers& tetrahedra, const Doubles& uvw, const std::optional<Integers>& facets,
            const std::optional<Integers>& edges, const bool align_boundary, const double tolerance,
            const bool repair_flips, const bool integer_grid, const double grid_scale,
            const double rounding, const py::object& progress)
{
  struct Volume_snapping
  {
    void run()
    {
      report = SS::snap_volume_to_seamless(
        volume.tetrahedra, volume.uvw_map(),
        volume.parameters().align_boundary(align_boundary).tolerance(tolerance)
          .repair_flips(repair_flips ? SS::Flip_repair::UNTANGLE : SS::Flip_repair::NONE)
          .integer_grid(integer_grid).grid_scale(grid_scale).rounding_tolerance(rounding));
    }

    Array_volume volume;
    bool align_boundary;
    double tolerance;
    bool repair_flips, integer_grid;
    double grid_scale, rounding;
    SS::Snapping_report report = SS::Snapping_report();
  };
  const std::shared_ptr<Volume_snapping> snapping(
    new Volume_snapping{{tetrahedra, uvw, facets, edges}, align_boundary, tolerance, repair_flips,
                        integer_grid, grid_scale, rounding});
  const double seconds = run_apart(progress, snapping);
  py::dict dict = ::dict_of(snapping->report, "cells");
  dict["seconds_in_core"] = seconds;
  return {to_array<double>(std::move(snapping->volume.uvw), {tetrahedra.shape(0), 4, 3}), dict};
}

py::dict measure_volume(const Integers& tetrahedra, const Doubles& uvw,
                        const std::optional<Integers>& facets, const std::optional<Integers>& edges,
                        const bool align_boundary)
{
  using namespace py::literals;
  struct Volume_measurement
  {
    void run()
    {
      const auto np = volume.parameters().align_boundary(align_boundary);
      measured = SS::measure_volume_seamlessness(volume.tetrahedra, volume.uvw_map(), np);
      is_integer_grid = SS::is_volume_integer_grid_map(volume.tetrahedra, volume.uvw_map(), np);
    }

    Array_volume volume;
    bool align_boundary;
    SS::Volume_seamlessness measured = {};
    bool is_integer_grid = false;
  };
  const std::shared_ptr<Volume_measurement> measurement(
    new Volume_measurement{{tetrahedra, uvw, facets, edges}, align_boundary});
  run_apart(py::none(), measurement);
  const SS::Volume_seamlessness& s = measurement->measured;
  return py::dict("exact"_a = s.is_exact(), "integer_grid"_a = measurement->is_integer_grid,
                  "number_of_interior_facets"_a = s.number_of_interior_facets,
                  "number_of_mismatched_facets"_a = s.number_of_mismatched_facets,
                  "number_of_inexact_facets"_a = s.number_of_inexact_facets,
                  "number_of_aligned_facets"_a = s.number_of_aligned_facets,
                  "number_of_aligned_edges"_a = s.number_of_aligned_edges,
                  "number_of_misalignments"_a = s.number_of_misalignments,
                  "number_of_flipped_cells"_a = s.number_of_flipped_cells,
                  "number_of_degenerate_cells"_a = s.number_of_degenerate_cells,
                  "extent"_a = s.extent, "violation"_a = s.violation,
                  "misalignment"_a = s.misalignment);
}

} // namespace

void add_volumes(py::module_& module)
{
  module.def("snap_volume", snap_volume);
  module.def("measure_volume", measure_volume);
}
