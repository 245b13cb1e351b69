#include "map_quads.h"

#include "map_measures.h"

#include <CGAL/Quad_remeshing/extract_grid_mesh.h>
#include <CGAL/Quad_remeshing/quad_remesh.h>
#include <CGAL/Quad_remeshing/quantize.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace QR = CGAL::Quad_remeshing;

namespace {

class Map_quad_maker
{
public:
  Map_quad_maker(const Map_quad_options& options, Mesh& mesh, const Uv_map uv_map,
                 const Edge_bool_map is_feature)
    : m_options(options), m_mesh(mesh), m_uv_map(uv_map), m_is_feature(is_feature)
  {
    for(const Halfedge h : mesh.halfedges())
      m_input.push_back(uv_map[h]);
  }

  Map_quads run()
  {
    if(m_options.number > 0)
      return make_number_of_quads();
    Map_quads result = extract_rounded(m_options.rounding.value_or(0.01));
    if(m_options.repair_flips && result.repaired.run.number_of_repaired_flips > 0 &&
       !m_options.soup && !is_good(result))
      quantize_repaired(result);
    return result;
  }

private:
  static bool is_good(const Map_quads& result)
  { return result.report && result.report.number_of_inverted_quads == 0; }

  // Repairs of flips can leave cones no space for their quads, because the integers of the map hold
  // these cones where they are. A quantization of about as many quads moves them.
  void quantize_repaired(Map_quads& result)
  {
    const auto [area, exponent] = area_in_domain(m_mesh, m_uv_map, true);
    const double number = std::round(std::ldexp(area, 2 * exponent));
    restore();
    Map_quads other;
    const std::string why = ", because repairs of flipped faces leave " +
      (result.report
         ? QR::counted(result.report.number_of_inverted_quads, "quad") + " inverted in the map"
         : "the map no mesh of quads");
    if(number >= 1 && has_aligned_border())
      if(const QR::Quantization quantization = quantize(number, other))
        extract_quantized(quantization, other, why);
    if(is_good(other))
      result = std::move(other);
  }

  Map_quads make_number_of_quads()
  {
    constexpr double tolerance = 0.05;
    Map_quads near_by = extract_near_by();
    const double number = static_cast<double>(near_by.report.number_of_faces);
    const bool is_near =
      near_by.report && std::abs(number / m_options.number - 1) <= tolerance;
    const bool is_aligned = has_aligned_border();
    Map_quads result;
    QR::Quantization quantization;
    if(is_aligned)
      quantization = quantize(m_options.number, result);
    const double least = static_cast<double>(quantization.number_of_quads);
    const bool is_chosen = is_near && !(quantization && least > (1 + tolerance) * m_options.number);
    const std::size_t number_inverted = near_by.report.number_of_inverted_quads;
    if(quantization && !(is_chosen && number_inverted == 0))
      extract_quantized(quantization, result);
    const bool is_better = quantization && result.report &&
                           result.report.number_of_inverted_quads < number_inverted;
    if(is_chosen && !is_better)
      return near_by;
    if(quantization)
      return result;
    return make_at_any_distance(is_aligned, quantization);
  }

  Map_quads make_at_any_distance(const bool is_aligned, const QR::Quantization& quantization)
  {
    restore();
    Map_quads result =
      extract_rounded(m_options.rounding.value_or(std::numeric_limits<double>::infinity()));
    result.why_rounded = is_aligned ? "there is no quantization: " + quantization.message
                                    : Message("most of the border lies on no isocurve");
    result.integers = "at any distance, because " + result.why_rounded;
    if(is_aligned || (result.report && result.part_left_out() <= 0.5))
      return result;
    restore();
    Map_quads last;
    if(const QR::Quantization other = quantize(m_options.number, last)) {
      extract_quantized(other, last);
      return last;
    }
    return result;
  }

  void restore()
  {
    std::size_t i = 0;
    for(const Halfedge h : m_mesh.halfedges())
      m_uv_map[h] = m_input[i++];
  }

  // Whether the border is meant to lie on isocurves: most of it does.
  bool has_aligned_border() const
  {
    const Edge_bool_map is_aligned = m_options.alignment(true);
    std::size_t number = 0, number_of_others = 0;
    for(const Edge e : m_mesh.edges())
      if(m_mesh.is_border(e))
        ++(is_aligned[e] ? number : number_of_others);
    return 3 * number_of_others <= number;
  }

  auto snapping_parameters(const Edge_bool_map is_aligned, const QR::Flip_repair repair) const
  {
    return QR::parameters::edge_is_constrained_map(is_aligned).tolerance(m_options.tolerance)
      .repair_flips(repair).number_of_untangling_iterations(m_options.untangling_iterations)
      .verbose(m_options.verbose);
  }

  // The repair that the caller asks for.
  QR::Flip_repair flip_repair() const
  { return m_options.repair_flips ? QR::Flip_repair::UNTANGLE : QR::Flip_repair::NONE; }

  // The area in the domain becomes the number of quads, but for that of holes. It is known before the
  // seams are, whose refusal users are to see.
  double scale() const
  {
    if(m_options.number == 0)
      return m_options.grid_scale;
    const auto [area, exponent] = area_in_domain(m_mesh, m_uv_map, m_options.allow_holes);
    if(area > 0)
      return std::ldexp(std::sqrt(m_options.number / area), -exponent);
    QR::Snapping_report report;
    report.status = QR::Outcome::NOT_POSITIVE;
    report.message =
      "the coordinates enclose no area, or none beside a much larger coordinate" +
      Message(Message::REMEDY, "approximate_seamless_parametrization() computes others");
    throw Not_snapped{report};
  }

  QR::Snapping_report snap_to_integers(const double rounding)
  {
    const Edge_bool_map is_aligned = m_options.alignment(m_options.align_border);
    m_options.tell("snapping " + std::to_string(m_mesh.number_of_faces()) + " faces");
    return QR::snap_to_seamless(
      m_mesh, m_uv_map,
      snapping_parameters(is_aligned, flip_repair()).integer_grid(true)
        .rounding_tolerance(rounding).grid_scale(scale()));
  }

  // Without quads if no integers are near, or faces are flipped there.
  Map_quads extract_near_by()
  {
    Map_quads result;
    result.snapped = result.repaired = snap_to_integers(m_options.rounding.value_or(0.5));
    result.report.status = QR::Outcome::NOT_INTEGER;
    if(result.snapped && result.snapped.lost_faces.empty() &&
       result.snapped.remaining_flips.empty())
      extract_map(result);
    result.integers = "the nearest to the map";
    restore();
    return result;
  }

  Map_quads extract_rounded(const double rounding)
  {
    Map_quads result;
    result.snapped = result.repaired = snap_to_integers(rounding);
    if(!result.snapped)
      throw Not_snapped{result.snapped};
    extract_map(result);
    result.integers = "the nearest to the map";
    return result;
  }

  // With the border aligned if it is so nearly. Flips are repaired near by without being asked for.
  QR::Quantization quantize(const double number, Map_quads& result)
  {
    const Edge_bool_map is_aligned = m_options.alignment(true);
    m_options.tell("quantizing");
    const auto snap_and_quantize = [&](const QR::Flip_repair repair) {
      result.repaired =
        QR::snap_to_seamless(m_mesh, m_uv_map, snapping_parameters(is_aligned, repair));
      if(!result.repaired)
        throw Not_snapped{result.repaired};
      return QR::quantize(m_mesh, m_uv_map,
                          QR::parameters::edge_is_constrained_map(m_is_feature)
                            .needs_face_graph(!m_options.soup)
                            .target_number_of_quads(static_cast<std::size_t>(number)));
    };
    const QR::Quantization quantization = snap_and_quantize(flip_repair());
    if(quantization.nonpositive_faces.empty() || m_options.repair_flips)
      return quantization;
    return snap_and_quantize(QR::Flip_repair::NEAR_BY);
  }

  // `input` is the mesh and its map, or a quantization and the mesh.
  template <typename NamedParameters, typename... Input>
  void extract(Map_quads& result, const NamedParameters& np, const Input&... input) const
  {
    m_options.tell("extracting quads");
    using Tag = CGAL::Parallel_if_available_tag;
    if(m_options.soup) {
      result.report =
        QR::extract_quad_soup<Tag>(input..., result.soup.points, result.soup.polygons, np);
      return;
    }
    result.is_feature = result.mesh.add_property_map<Edge, bool>("e:feature", false).first;
    result.report = QR::extract_quad_mesh<Tag>(
      input..., result.mesh, np, QR::parameters::edge_is_constrained_map(result.is_feature));
    result.mesh.collect_garbage();
  }

  void extract_map(Map_quads& result) const
  {
    extract(result,
            QR::parameters::edge_is_constrained_map(m_is_feature)
              .allow_holes(m_options.allow_holes), m_mesh, m_uv_map);
  }

  // Smooths the quads if some are inverted otherwise: if the map is much distorted, or two sides of a
  // quad follow one edge of the border.
  // \param why there is a quantization, if users do not expect one
  void extract_quantized(const QR::Quantization& quantization, Map_quads& result,
                         const std::string& why = "") const
  {
    result.integers = "of a quantization" + why;
    if(!quantization.message.empty())
      result.integers += "; " + quantization.message;
    extract(result, QR::parameters::default_values(), quantization, m_mesh);
    const std::size_t number = result.report.number_of_inverted_quads;
    const bool has_steps = quantization.number_of_unaligned_border_edges > 0;
    if(!result.report || m_options.soup || (number == 0 && !has_steps))
      return;
    smooth(quantization, result);
    result.integers += "; vertices are smoothed";
    if(has_steps)
      result.integers += ", and edges next to the border moved";
    if(number > 0)
      result.integers += ", because " + QR::counted(number, "quad") +
                         (number == 1 ? " was" : " were") + " inverted";
  }

  // Makes the quads of the same quantization in a better shape.
  void smooth(const QR::Quantization& quantization, Map_quads& result) const
  {
    m_options.tell("smoothing quads");
    result.mesh.clear();
    result.is_feature = result.mesh.add_property_map<Edge, bool>("e:feature", false).first;
    const QR::Remeshing_report made = QR::quad_remesh(
      quantization, m_mesh, result.mesh, QR::parameters::default_values(),
      QR::parameters::edge_is_constrained_map(result.is_feature));
    QR::Extraction_report& report = result.report;
    report.status = made.status;
    report.message = made.message;
    report.number_of_faces = made.number_of_quads;
    report.number_of_vertices = made.number_of_vertices;
    report.number_of_inverted_quads = made.number_of_inverted_quads;
    report.first_inverted_quads = made.first_inverted_quads;
    result.smoothed = made;
  }

  const Map_quad_options& m_options;
  Mesh& m_mesh;
  Uv_map m_uv_map;
  const Edge_bool_map m_is_feature;
  std::vector<Kernel::Point_2> m_input; // the coordinates as given
};

} // namespace

Map_quads make_map_quads(const Map_quad_options& options, Mesh& mesh, const Uv_map uv_map,
                         const Edge_bool_map is_feature)
{
  return Map_quad_maker(options, mesh, uv_map, is_feature).run();
}
