// Snapping a map of a surface, and measuring one.

#include "Array_surface.h"
#include "Call.h"
#include "functions.h"
#include "reports.h"

#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace SS = CGAL::Seamless_snapping;

namespace {

py::dict dict_of(const SS::Snapping_report& report, const Array_surface& surface)
{
  py::dict result = ::dict_of(report, &surface);
  add_distances(result, report);
  result["largest_rounding"] = report.largest_rounding;
  result["lost_faces"] = report.lost_faces;
  result["remaining_flips"] = report.remaining_flips;
  result["number_of_cut_edges"] = report.run.number_of_cut_edges;
  result["number_of_merged_edges"] = report.run.number_of_merged_edges;
  result["number_of_repaired_flips"] = report.run.number_of_repaired_flips;
  result["number_of_changed_cones"] = report.run.number_of_changed_cones;
  return result;
}

// Coordinates of the corners, and the report.
std::pair<Doubles, py::dict>
snap(const Integers& triangles, const Doubles& uv, const std::optional<Doubles>& points,
     const std::optional<Integers>& features, const bool align_border, const double tolerance,
     const bool repair_flips, const bool weld, const py::object& progress)
{
  const Surface_arrays arrays(triangles, points, uv, features);
  std::optional<Array_surface> surface;
  SS::Snapping_report report;
  std::vector<double> result;
  Call(progress).run([&] {
    surface.emplace(arrays, weld);
    surface->turn_if_mirrored();
    if(align_border)
      surface->add_border();
    report = SS::snap_to_seamless(
      surface->mesh, surface->uv_map,
      SS::parameters::edge_is_constrained_map(surface->is_feature).tolerance(tolerance)
        .repair_flips(repair_flips ? SS::Flip_repair::UNTANGLE : SS::Flip_repair::NONE));
    result.resize(6 * arrays.number_of_triangles);
    surface->write_uv(result.data());
  });
  py::dict dict = dict_of(report, *surface);
  dict["mirrored"] = surface->is_mirrored();
  return {to_array<double>(std::move(result), {triangles.shape(0), 3, 2}), dict};
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

py::dict measure(const Integers& triangles, const Doubles& uv, const std::optional<Doubles>& points,
                 const std::optional<Integers>& features, const bool align_border, const bool weld)
{
  const Surface_arrays arrays(triangles, points, uv, features);
  SS::Seamlessness measured;
  std::vector<std::array<std::int64_t, 2> > cones;
  bool has_transitions = false;
  Call(py::none()).run([&] {
    Array_surface surface(arrays, weld);
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
  });
  py::dict result = dict_of(measured);
  result["cones"] = has_transitions ? py::object(to_array(std::move(cones))) : py::none();
  return result;
}

} // namespace

void add_snapping(py::module_& module)
{
  module.def("snap", snap);
  module.def("measure", measure);
}
