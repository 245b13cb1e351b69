// Quads of a map: of its own integers, or of a quantization.

#include "Array_surface.h"
#include "Call.h"
#include "functions.h"
#include "quad_arrays.h"
#include "reports.h"

#include <CGAL/Quad_remeshing/extract_grid_mesh.h>
#include <CGAL/Quad_remeshing/quad_remesh.h>
#include <CGAL/Quad_remeshing/quantize.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace QR = CGAL::Quad_remeshing;

namespace {

struct Wishes
{
  std::size_t number = 0; // of quads; 0 for those of the map as it is
  double grid_scale = 1;
  std::optional<double> rounding;
  bool align_border = false, repair_flips = false, allow_holes = false;
};

struct Result
{
  QR::Report report;
  std::string integers; // which they are
  std::vector<std::size_t> nonpositive_faces;
  std::size_t number_of_inverted_quads = 0, number_of_cut_cells = 0;
  double area = 0, largest_rounding = 0;
  bool is_smoothed = false;
  Quad_mesh quads;

  double part_left_out() const
  { return number_of_cut_cells == 0 ? 0 : 1 - double(quads.mesh.number_of_faces()) / area; }
};

// The attempts that the program makes for a number of quads, in the same order.
class Quad_maker
{
public:
  Quad_maker(Array_surface& surface, const Wishes& wishes)
    : m_surface(surface), m_wishes(wishes), m_uv(6 * surface.number_of_triangles())
  { surface.write_uv(m_uv.data()); }

  std::optional<Result> run()
  {
    if(m_wishes.number == 0)
      return extract_rounded(m_wishes.rounding.value_or(0.01));
    return make_number();
  }

private:
  std::optional<Result> make_number()
  {
    constexpr double tolerance = 0.05;
    const double wanted = double(m_wishes.number);
    std::optional<Result> near_by = extract_near_by();
    const bool is_aligned = has_aligned_border();
    QR::Quantization quantization;
    if(is_aligned)
      quantization = quantize();
    const double least = double(quantization.number_of_quads);
    const bool is_near =
      near_by && near_by->report &&
      std::abs(double(near_by->quads.mesh.number_of_faces()) / wanted - 1) <= tolerance;
    if(is_near && !(quantization && least > (1 + tolerance) * wanted))
      return near_by;
    if(quantization)
      return extract_quantized(quantization);
    std::optional<Result> result =
      extract_rounded(m_wishes.rounding.value_or(std::numeric_limits<double>::infinity()));
    result->integers = "at any distance, because " +
                       (is_aligned ? "there is no quantization: " + quantization.message.str()
                                   : std::string("most of the border lies on no isocurve"));
    if(is_aligned || (result->report && result->part_left_out() <= 0.5))
      return result;
    if(const QR::Quantization other = quantize())
      return extract_quantized(other);
    return result;
  }

  // What is aligned: all features, and the border where it is nearly so.
  Edge_bool_map alignment(const bool with_border)
  {
    Mesh& mesh = m_surface.mesh;
    const Edge_bool_map result = mesh.add_property_map<Edge, bool>(std::string(), false).first;
    const QR::Seamlessness survey = QR::measure_seamlessness(mesh, m_surface.uv_map);
    const double tolerance = std::clamp(100 * survey.violation, 1e-9 * survey.extent,
                                        1e-4 * survey.extent);
    for(const Edge e : mesh.edges())
      result[e] = m_surface.is_feature[e] ||
                  (with_border && mesh.is_border(e) && misalignment(e) <= tolerance);
    return result;
  }

  double misalignment(const Edge e) const
  {
    const Mesh& mesh = m_surface.mesh;
    Halfedge h = mesh.halfedge(e);
    if(mesh.is_border(h))
      h = mesh.opposite(h);
    const Kernel::Vector_2 change = m_surface.uv_map[h] - m_surface.uv_map[mesh.prev(h)];
    return (std::min)(std::abs(change.x()), std::abs(change.y()));
  }

  // Whether the border is meant to lie on isocurves: most of it does.
  bool has_aligned_border()
  {
    const Edge_bool_map is_aligned = alignment(true);
    std::size_t number = 0, number_of_others = 0;
    for(const Edge e : m_surface.mesh.edges())
      if(m_surface.mesh.is_border(e))
        ++(is_aligned[e] ? number : number_of_others);
    return 3 * number_of_others <= number;
  }

  double scale() const
  {
    if(m_wishes.number == 0)
      return m_wishes.grid_scale;
    const auto [area, exponent] = m_surface.area_in_domain(m_wishes.allow_holes);
    if(!(area > 0))
      throw Refused(QR::Outcome::NOT_POSITIVE,
                    "the coordinates enclose no area, or none beside a much larger coordinate; "
                    "parametrize() computes others");
    return std::ldexp(std::sqrt(double(m_wishes.number) / area), -exponent);
  }

  QR::Snapping_report snap_to_integers(const double rounding)
  {
    return QR::snap_to_seamless(
      m_surface.mesh, m_surface.uv_map,
      QR::parameters::edge_is_constrained_map(alignment(m_wishes.align_border))
        .repair_flips(m_wishes.repair_flips ? QR::Flip_repair::UNTANGLE : QR::Flip_repair::NONE)
        .integer_grid(true).rounding_tolerance(rounding).grid_scale(scale()));
  }

  // Nothing if no integers are near, or faces are flipped there.
  std::optional<Result> extract_near_by()
  {
    const QR::Snapping_report snapped = snap_to_integers(m_wishes.rounding.value_or(0.5));
    std::optional<Result> result;
    if(snapped && snapped.lost_faces.empty() && snapped.remaining_flips.empty()) {
      result.emplace();
      result->integers = "those nearest in the map";
      result->largest_rounding = snapped.largest_rounding;
      extract_map(*result);
    }
    m_surface.read_uv(m_uv.data());
    return result;
  }

  std::optional<Result> extract_rounded(const double rounding)
  {
    std::optional<Result> result(std::in_place);
    const QR::Snapping_report snapped = snap_to_integers(rounding);
    result->report = snapped;
    result->integers = "those nearest in the map";
    result->largest_rounding = snapped.largest_rounding;
    if(snapped)
      extract_map(*result);
    m_surface.read_uv(m_uv.data());
    return result;
  }

  // With the border aligned where it is nearly. Flips are repaired near by without being asked for.
  QR::Quantization quantize()
  {
    const Edge_bool_map is_aligned = alignment(true);
    const auto snap_and_quantize = [&](const QR::Flip_repair repair) {
      const QR::Snapping_report snapped = QR::snap_to_seamless(
        m_surface.mesh, m_surface.uv_map,
        QR::parameters::edge_is_constrained_map(is_aligned).repair_flips(repair));
      if(!snapped)
        throw Refused(snapped.status, snapped.message, renamed(m_surface.rows()));
      return QR::quantize(m_surface.mesh, m_surface.uv_map,
                          QR::parameters::edge_is_constrained_map(m_surface.is_feature)
                            .needs_face_graph(true).target_number_of_quads(m_wishes.number));
    };
    QR::Quantization result = snap_and_quantize(
      m_wishes.repair_flips ? QR::Flip_repair::UNTANGLE : QR::Flip_repair::NONE);
    if(!result.nonpositive_faces.empty() && !m_wishes.repair_flips)
      result = snap_and_quantize(QR::Flip_repair::NEAR_BY);
    m_quantized_uv.resize(m_uv.size());
    m_surface.write_uv(m_quantized_uv.data());
    m_surface.read_uv(m_uv.data());
    return result;
  }

  // `input` is the mesh and its map, or a quantization and the mesh.
  template <typename NamedParameters, typename... Input>
  void extract(Result& result, const NamedParameters& np, const Input&... input) const
  {
    const QR::Extraction_report report = QR::extract_quad_mesh<CGAL::Parallel_if_available_tag>(
      input..., result.quads.mesh, np,
      QR::parameters::edge_is_constrained_map(result.quads.is_feature));
    result.report = report;
    result.nonpositive_faces = report.nonpositive_faces;
    result.number_of_inverted_quads = report.number_of_inverted_quads;
    result.number_of_cut_cells = report.number_of_cut_cells;
    result.area = report.area;
    result.quads.mesh.collect_garbage();
  }

  void extract_map(Result& result) const
  {
    extract(result,
            QR::parameters::edge_is_constrained_map(m_surface.is_feature)
              .allow_holes(m_wishes.allow_holes), m_surface.mesh, m_surface.uv_map);
  }

  // Smooths quads where some are inverted otherwise: where the map is much distorted, and where two
  // sides of a quad follow one edge of the border.
  std::optional<Result> extract_quantized(const QR::Quantization& quantization)
  {
    std::optional<Result> result(std::in_place);
    m_surface.read_uv(m_quantized_uv.data());
    extract(*result, QR::parameters::default_values(), quantization, m_surface.mesh);
    const bool has_steps = quantization.number_of_unaligned_border_edges > 0;
    if(result->report && (result->number_of_inverted_quads > 0 || has_steps)) {
      result.emplace();
      const QR::Remeshing_report made = QR::quad_remesh(
        quantization, m_surface.mesh, result->quads.mesh, QR::parameters::default_values(),
        QR::parameters::edge_is_constrained_map(result->quads.is_feature));
      result->report = made;
      result->number_of_inverted_quads = made.number_of_inverted_quads;
      result->is_smoothed = true;
    }
    result->integers = "of a quantization";
    return result;
  }

  Array_surface& m_surface;
  const Wishes& m_wishes;
  std::vector<double> m_uv, m_quantized_uv; // of the corners: as given, and as last quantized
};

struct Extraction
{
  void run()
  {
    surface.emplace(std::move(arrays), weld);
    surface->turn_if_mirrored();
    result = Quad_maker(*surface, wishes).run();
    quads.emplace(result->quads);
  }

  Surface_arrays arrays;
  Wishes wishes;
  bool weld;
  std::optional<Array_surface> surface = std::nullopt;
  std::optional<Result> result = std::nullopt;
  std::optional<Quad_arrays> quads = std::nullopt;
};

py::tuple extract_quads(const Doubles& points, const Integers& triangles, const Doubles& uv,
                        const std::optional<Integers>& features, const std::size_t number,
                        const double grid_scale, const std::optional<double> rounding,
                        const bool align_border, const bool repair_flips, const bool allow_holes,
                        const bool weld, const py::object& progress)
{
  const std::shared_ptr<Extraction> extraction(new Extraction{
    {triangles, points, uv, features},
    {number, grid_scale, rounding, align_border, repair_flips, allow_holes}, weld});
  run_apart(progress, extraction);
  const Result& result = *extraction->result;
  Quad_arrays& quads = *extraction->quads;
  py::dict report = dict_of(result.report, &*extraction->surface);
  report["integers"] = result.integers;
  report["nonpositive_faces"] = result.nonpositive_faces;
  report["number_of_inverted_quads"] = result.number_of_inverted_quads;
  report["number_of_cut_cells"] = result.number_of_cut_cells;
  report["largest_rounding"] = result.largest_rounding;
  report["smoothed"] = result.is_smoothed;
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
