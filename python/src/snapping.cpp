// Snapping a map of a surface, and measuring one.

#include "Array_surface.h"
#include "Call.h"
#include "functions.h"
#include "reports.h"

#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace SS = CGAL::Seamless_snapping;

namespace {

struct Snapping
{
  void run()
  {
    surface.emplace(std::move(arrays), weld);
    surface->turn_if_mirrored();
    if(align_border)
      surface->add_border();
    report = SS::snap_to_seamless(
      surface->mesh, surface->uv_map,
      SS::parameters::edge_is_constrained_map(surface->is_feature).tolerance(tolerance)
        .repair_flips(repair_flips ? SS::Flip_repair::UNTANGLE : SS::Flip_repair::NONE));
    if(report.status == SS::Outcome::NOT_SEAMLESS)
      misfits = count_misfits(surface->mesh, surface->uv_map, tolerance);
    result.resize(6 * surface->number_of_triangles());
    surface->write_uv(result.data());
  }

  Surface_arrays arrays;
  bool align_border;
  double tolerance;
  bool repair_flips, weld;
  std::optional<Array_surface> surface = std::nullopt;
  SS::Snapping_report report = SS::Snapping_report();
  Misfits misfits = {};
  std::vector<double> result = {};
};

// Coordinates of the corners, and the report.
std::pair<Doubles, py::dict>
snap(const Integers& triangles, const Doubles& uv, const std::optional<Doubles>& points,
     const std::optional<Integers>& features, const bool align_border, const double tolerance,
     const bool repair_flips, const bool weld, const py::object& progress)
{
  const std::shared_ptr<Snapping> snapping(
    new Snapping{{triangles, points, uv, features}, align_border, tolerance, repair_flips, weld});
  const double seconds = run_apart(progress, snapping);
  py::dict dict = dict_of(snapping->report, "faces", &*snapping->surface);
  dict["number_of_cut_edges"] = snapping->report.run.number_of_cut_edges;
  dict["number_of_merged_edges"] = snapping->report.run.number_of_merged_edges;
  dict["number_of_changed_cones"] = snapping->report.run.number_of_changed_cones;
  add_misfits(dict, snapping->misfits);
  dict["seconds_in_core"] = seconds;
  dict["mirrored"] = snapping->surface->is_mirrored();
  return {to_array<double>(std::move(snapping->result), {triangles.shape(0), 3, 2}), dict};
}

py::dict dict_of(const SS::Seamlessness& s)
{
  using namespace py::literals;
  return py::dict("exact"_a = s.is_exact(),
                  "number_of_interior_edges"_a = s.number_of_interior_edges,
                  "number_of_mismatched_edges"_a = s.number_of_mismatched_edges,
                  "number_of_inexact_edges"_a = s.number_of_inexact_edges,
                  "number_of_aligned_edges"_a = s.number_of_aligned_edges,
                  "number_of_misaligned_edges"_a = s.number_of_misaligned_edges,
                  "number_of_flipped_faces"_a = s.number_of_flipped_faces,
                  "number_of_degenerate_faces"_a = s.number_of_degenerate_faces,
                  "extent"_a = s.extent, "violation"_a = s.violation,
                  "misalignment"_a = s.misalignment);
}

struct Measurement
{
  void run()
  {
    Array_surface surface(std::move(arrays), weld);
    if(align_border)
      surface.add_border();
    measured = SS::measure_seamlessness(
      surface.mesh, surface.uv_map,
      SS::parameters::edge_is_constrained_map(surface.is_feature));
    const auto transitions = SS::seam_transitions(surface.mesh, surface.uv_map);
    has_transitions = bool(transitions);
    if(has_transitions)
      for(const auto& [v, index] : transitions.singular_vertices())
        cones.push_back({{std::int64_t(surface.row(v)), index}});
  }

  Surface_arrays arrays;
  bool align_border, weld;
  SS::Seamlessness measured = {};
  std::vector<std::array<std::int64_t, 2> > cones = {};
  bool has_transitions = false;
};

py::dict measure(const Integers& triangles, const Doubles& uv, const std::optional<Doubles>& points,
                 const std::optional<Integers>& features, const bool align_border, const bool weld)
{
  const std::shared_ptr<Measurement> measurement(
    new Measurement{{triangles, points, uv, features}, align_border, weld});
  run_apart(py::none(), measurement);
  py::dict result = dict_of(measurement->measured);
  result["cones"] = measurement->has_transitions
                      ? py::object(to_array(std::move(measurement->cones))) : py::none();
  return result;
}

} // namespace

void add_snapping(py::module_& module)
{
  module.def("snap", snap);
  module.def("measure", measure);
}
