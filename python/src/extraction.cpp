// Quads of a map: of its own integers, or of a quantization.

#include "Array_surface.h"
#include "Call.h"
#include "functions.h"
#include "quad_arrays.h"
#include "reports.h"
#include "maps/map_measures.h"
#include "maps/map_quads.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace {

struct Extraction
{
  void run()
  {
    surface.emplace(std::move(arrays), weld);
    surface->turn_if_mirrored();
    options.alignment = [this](const bool with_border) { return alignment(with_border); };
    try {
      made = make_map_quads(options, surface->mesh, surface->uv_map, surface->is_feature);
      quads.emplace(made.mesh, made.is_feature);
    } catch(const Not_snapped& refusal) {
      made.snapped = refusal.report;
      static_cast<CGAL::Linear_snapping::Report&>(made.report) = refusal.report;
      if(refusal.report.status == CGAL::Linear_snapping::Outcome::NOT_SEAMLESS)
        misfits = count_misfits(surface->mesh, surface->uv_map, options.tolerance);
    }
  }

  Surface_arrays arrays;
  Map_quad_options options;
  bool weld;
  std::optional<Array_surface> surface = std::nullopt;
  Map_quads made = Map_quads();
  Misfits misfits = {};
  std::optional<Quad_arrays> quads = std::nullopt;

private:
  // All features, and the border where it is nearly on isocurves.
  Edge_bool_map alignment(const bool with_border)
  {
    Mesh& mesh = surface->mesh;
    const Edge_bool_map result = mesh.add_property_map<Edge, bool>(std::string(), false).first;
    const double tolerance = tolerance_of_alignment(mesh, surface->uv_map);
    for(const Edge e : mesh.edges())
      result[e] = surface->is_feature[e] ||
                  (with_border && mesh.is_border(e) &&
                   misalignment(mesh, surface->uv_map, e) <= tolerance);
    return result;
  }
};

py::tuple extract_quads(const Doubles& points, const Integers& triangles, const Doubles& uv,
                        const std::optional<Integers>& features, const std::size_t number,
                        const double grid_scale, const std::optional<double> rounding,
                        const bool align_border, const bool repair_flips, const bool allow_holes,
                        const bool weld, const py::object& progress)
{
  Map_quad_options options;
  options.number = double(number); // 0 for the cells of the map as it is
  options.grid_scale = grid_scale;
  options.rounding = rounding;
  options.align_border = align_border;
  options.repair_flips = repair_flips;
  options.allow_holes = allow_holes;
  const std::shared_ptr<Extraction> extraction(
    new Extraction{{triangles, points, uv, features}, options, weld});
  const double seconds = run_apart(progress, extraction);
  const Map_quads& made = extraction->made;
  py::dict report = ::dict_of(made.report, &*extraction->surface);
  add_misfits(report, extraction->misfits);
  report["seconds_in_core"] = seconds;
  report["integers"] = with_rows(made.integers, renamed(extraction->surface->rows()));
  report["nonpositive_faces"] = made.report.nonpositive_faces;
  report["number_of_inverted_quads"] = made.report.number_of_inverted_quads;
  report["number_of_folded_quads"] =
    made.smoothed ? py::cast(made.smoothed->number_of_folded_quads) : py::none();
  report["number_of_cut_cells"] = made.report.number_of_cut_cells;
  report["largest_rounding"] = made.snapped.largest_rounding;
  report["smoothed"] = made.smoothed.has_value();
  if(!extraction->quads)
    return py::make_tuple(py::none(), py::none(), report);
  Quad_arrays& quads = *extraction->quads;
  report["feature_edges"] = to_array(std::move(quads.features));
  report["other_polygons"] = quads.others;
  return py::make_tuple(to_array(std::move(quads.points)), to_array(std::move(quads.polygons)),
                        report);
}

} // namespace

void add_extraction(py::module_& module)
{
  module.def("extract_quads", extract_quads);
}
