// From a triangle mesh to an exactly seamless map, and sharp edges.

#include "Array_surface.h"
#include "Call.h"
#include "functions.h"
#include "plain_surfaces.h"
#include "reports.h"

#include <CGAL/Quad_remeshing/approximate_seamless_parametrization.h>
#include <CGAL/Quad_remeshing/remove_feature_noise.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace QR = CGAL::Quad_remeshing;

namespace {

using Vertex_pair = std::array<std::int64_t, 2>;

Vertex_pair rows_of_edge(const Array_surface& surface, const Edge e)
{
  return {{std::int64_t(surface.row(surface.mesh.vertex(e, 0))),
           std::int64_t(surface.row(surface.mesh.vertex(e, 1)))}};
}

// Edges inside that are sharper than an angle in degrees, as pairs of vertices.
struct Edge_detection
{
  void run()
  {
    Array_surface surface(std::move(arrays), weld.value_or(false));
    check_closed_seams(surface, weld);
    const std::vector<Kernel::Point_3> as_given(surface.mesh.points().begin(),
                                                surface.mesh.points().end());
    scale_near_one(surface.mesh);
    PMP::detect_sharp_edges(surface.mesh, angle, surface.is_feature);
    std::copy(as_given.begin(), as_given.end(), surface.mesh.points().begin());
    for(const Edge e : surface.mesh.edges())
      surface.is_feature[e] = surface.is_feature[e] && !surface.mesh.is_border(e);
    QR::remove_feature_noise(surface.mesh, surface.is_feature, least_length);
    for(const Edge e : surface.mesh.edges())
      if(surface.is_feature[e])
        result.push_back(rows_of_edge(surface, e));
  }

  Surface_arrays arrays;
  double angle, least_length;
  std::optional<bool> weld;
  std::vector<Vertex_pair> result = {};
};

py::array_t<std::int64_t> sharp_edges(const Doubles& points, const Integers& triangles,
                                      const double angle, const double least_length,
                                      const std::optional<bool> weld)
{
  const std::shared_ptr<Edge_detection> detection(new Edge_detection{
    {triangles, points, std::nullopt, std::nullopt}, angle, least_length, weld});
  run_apart(py::none(), detection);
  return to_array(std::move(detection->result));
}

// A triangle can be aligned along two of its edges at most.
void release_one_of_three(Array_surface& surface, std::vector<Vertex_pair>& released)
{
  const Mesh& mesh = surface.mesh;
  for(const auto f : mesh.faces()) {
    const auto around = mesh.halfedges_around_face(mesh.halfedge(f));
    if(std::all_of(around.begin(), around.end(),
                   [&](const Halfedge h) { return surface.is_feature[mesh.edge(h)]; })) {
      const Edge e = mesh.edge(mesh.halfedge(f));
      surface.is_feature[e] = false;
      released.push_back(rows_of_edge(surface, e));
    }
  }
}

struct Parametrization
{
  void run()
  {
    surface.emplace(std::move(arrays), weld.value_or(false));
    check_closed_seams(*surface, weld);
    if(align_border)
      surface->add_border();
    make_map();
  }

  Surface_arrays arrays;
  bool align_border;
  double curvature;
  std::vector<double> directions; // of the faces, if there are any
  std::optional<bool> weld;
  std::optional<Array_surface> surface = std::nullopt;
  QR::Parametrization_report<Mesh::Vertex_index> made =
    QR::Parametrization_report<Mesh::Vertex_index>();
  QR::Snapping_report snapped = QR::Snapping_report();
  std::vector<Vertex_pair> released = {};
  std::vector<double> uv = {};
  double seconds = 0;

private:
  void make_map()
  {
    Mesh& mesh = surface->mesh;
    release_one_of_three(*surface, released);
    const auto is_cut = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
    const auto rotation = get(CGAL::dynamic_halfedge_property_t<int>(), mesh);
    const auto transitions = QR::parameters::edge_is_constrained_map(surface->is_feature)
                               .edge_is_cut_map(is_cut).halfedge_rotation_map(rotation);
    made = QR::approximate_seamless_parametrization(
      mesh, surface->uv_map,
      transitions.curvature_alignment(curvature).release_alignment(true)
        .face_direction_map(direction_map(mesh, directions)));
    if(!made)
      return;
    for(const auto& [v, w] : made.released_edges) {
      surface->is_feature[mesh.edge(mesh.halfedge(v, w))] = false;
      released.push_back({{std::int64_t(surface->row(v)), std::int64_t(surface->row(w))}});
    }
    snapped = QR::snap_to_seamless(mesh, surface->uv_map, transitions);
    if(!snapped)
      return;
    CGAL::Real_timer timer;
    timer.start();
    if(!QR::is_seamless(mesh, surface->uv_map,
                        QR::parameters::edge_is_constrained_map(surface->is_feature)))
      snapped.status = QR::Outcome::INTERNAL_ERROR;
    snapped.step_times.emplace_back("verification of the result", timer.time());
    uv.resize(6 * surface->number_of_triangles());
    surface->write_uv(uv.data());
  }
};

py::dict dict_of(Parametrization&& map)
{
  const Array_surface& surface = *map.surface;
  const QR::Report& last = map.made ? static_cast<const QR::Report&>(map.snapped) : map.made;
  py::dict result = ::dict_of(last, &surface);
  std::vector<Vertex_pair> cones;
  for(const auto& [v, index] : map.made.cones)
    cones.push_back({{std::int64_t(surface.row(v)), index}});
  result["cones"] = to_array(std::move(cones));
  result["released_edges"] = to_array(std::move(map.released));
  result["seconds_in_core"] = map.seconds;
  result["genus"] = map.made.genus;
  result["number_of_components"] = map.made.number_of_components;
  result["number_of_border_loops"] = map.made.number_of_border_loops;
  result["number_of_flipped_faces"] = map.made.number_of_flipped_faces;
  result["extent"] = map.made.extent;
  result["violation_before"] = map.made.violation;
  result["largest_change"] = map.snapped.largest_change;
  auto step_times = map.made.step_times;
  step_times.insert(step_times.end(), map.snapped.step_times.begin(),
                    map.snapped.step_times.end());
  result["step_times"] = ::dict_of(step_times);
  return result;
}

std::pair<Doubles, py::dict>
parametrize(const Doubles& points, const Integers& triangles,
            const std::optional<Integers>& features, const bool align_border,
            const double curvature, const std::optional<Doubles>& directions,
            const std::optional<bool> weld, const py::object& progress)
{
  const std::shared_ptr<Parametrization> map(new Parametrization{
    {triangles, points, std::nullopt, features}, align_border, curvature, copy_of(directions),
    weld});
  map->seconds = run_apart(progress, map);
  const bool has_map = map->snapped && !map->uv.empty();
  Doubles uv = has_map ? Doubles(to_array<double>(std::move(map->uv), {triangles.shape(0), 3, 2}))
                       : Doubles(std::vector<py::ssize_t>{0, 3, 2});
  return {std::move(uv), dict_of(std::move(*map))};
}

} // namespace

void add_parametrization(py::module_& module)
{
  module.def("sharp_edges", sharp_edges);
  module.def("parametrize", parametrize);
}
