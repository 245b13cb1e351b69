// From triangles to quads.

#include "Array_surface.h"
#include "Call.h"
#include "functions.h"
#include "plain_surfaces.h"
#include "quad_arrays.h"
#include "reports.h"

#include <CGAL/Quad_remeshing/find_symmetry_plane.h>
#include <CGAL/Quad_remeshing/quad_remesh.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace QR = CGAL::Quad_remeshing;

namespace {

using Location = std::pair<Mesh::Face_index, std::array<double, 3> >;
using Sizing_map = Mesh::Property_map<Mesh::Vertex_index, double>;

// What the caller asks for.
struct Wishes
{
  std::size_t number_of_quads;
  std::optional<double> edge_length;
  bool coarsest;
  std::optional<std::size_t> maximum_number;
  double feature_loss;
  std::optional<double> curvature, border_tolerance, area_threshold;
  double adaptivity;
  std::optional<std::array<double, 4> > plane;
  bool finds_plane;
};

struct Located_quads
{
  Mesh mesh;
  Edge_bool_map is_feature = mesh.add_property_map<Edge, bool>("e:feature", false).first;
  Mesh::Property_map<Mesh::Vertex_index, Location> of_vertex =
    mesh.add_property_map<Mesh::Vertex_index, Location>("v:location").first;
  Mesh::Property_map<Mesh::Face_index, Location> of_face =
    mesh.add_property_map<Mesh::Face_index, Location>("f:location").first;
  QR::Remeshing_report report;
  std::optional<Kernel::Plane_3> plane;
};

std::optional<Kernel::Plane_3> plane_of(const Wishes& wishes, const Mesh& mesh)
{
  if(wishes.plane) {
    const auto& [a, b, c, d] = *wishes.plane;
    return Kernel::Plane_3(a, b, c, d);
  }
  if(!wishes.finds_plane)
    return std::nullopt;
  const auto plane = QR::find_symmetry_plane(mesh);
  if(!plane)
    throw Refused(QR::Outcome::INVALID_ARGUMENT,
                  "symmetry: the vertices are not symmetric, exactly, by a plane across a coordinate "
                  "axis" + remedy("pass 'x', 'y', 'z', or the four numbers of a plane to mirror one "
                                  "half"));
  return plane;
}

// The number of squares on the surface with sides of the wanted length.
double number_of_squares(const double length, const Mesh& mesh, const Sizing_map& sizes)
{
  double result = 0;
  for(const auto f : mesh.faces()) {
    double size = length;
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      size *= std::cbrt(sizes[v]);
    result += CGAL::Polygon_mesh_processing::face_area(f, mesh) / size / size;
  }
  return result;
}

// The largest number of quads, by default a hundred times the number wanted. Throws `Refused` if so
// many are wanted that the length must be a mistake of units, or less than one.
std::size_t most_quads(const Wishes& wishes, const Mesh& mesh, const Sizing_map& sizes)
{
  constexpr double most_by_default = 1e7, least_maximum = 1e5;
  double wanted = double(wishes.number_of_quads);
  if(wishes.edge_length) {
    wanted = number_of_squares(*wishes.edge_length, mesh, sizes);
    const double most = double(wishes.maximum_number.value_or(std::size_t(most_by_default)));
    if(!(wanted <= most))
      throw Refused(QR::Outcome::INVALID_ARGUMENT,
                    "edge_length makes more than " + std::to_string(std::size_t(most)) +
                      " quads" + remedy("pass a larger one, or a larger maximum"));
    if(wanted < 1)
      throw Refused(QR::Outcome::INVALID_ARGUMENT,
                    "edge_length makes less than one quad" + remedy("pass a smaller one"));
  }
  return wishes.maximum_number.value_or(
    std::size_t((std::max)(100 * wanted, least_maximum)));
}

struct Remeshing
{
  void run()
  {
    surface.emplace(std::move(arrays), weld.value_or(false));
    check_closed_seams(*surface, weld);
    make_quads();
    result.emplace(quads.mesh, quads.is_feature);
    for(const auto v : quads.mesh.vertices()) {
      faces_of_vertices.push_back(std::int64_t(quads.of_vertex[v].first));
      weights_of_vertices.push_back(surface->in_order_of_row(quads.of_vertex[v]));
    }
    for(const auto f : quads.mesh.faces())
      faces_of_quads.push_back(std::int64_t(quads.of_face[f].first));
  }

  Surface_arrays arrays;
  std::vector<double> directions, sizes; // of faces and of vertices, if there are any
  Wishes wishes;
  std::optional<bool> weld;
  std::optional<Array_surface> surface = std::nullopt;
  Located_quads quads = Located_quads();
  std::optional<Quad_arrays> result = std::nullopt;
  std::vector<std::int64_t> faces_of_vertices = {}, faces_of_quads = {};
  std::vector<std::array<double, 3> > weights_of_vertices = {};

private:
  void make_quads()
  {
    Mesh& mesh = surface->mesh;
    const auto size = mesh.add_property_map<Mesh::Vertex_index, double>("v:size", 1.).first;
    if(!sizes.empty())
      for(const auto v : mesh.vertices())
        size[v] = sizes[surface->row(v)];
    quads.plane = plane_of(wishes, mesh);
    const auto np =
      QR::parameters::edge_is_constrained_map(surface->is_feature)
                     .curvature_alignment(wishes.curvature)
                     .face_direction_map(direction_map(mesh, directions))
                     .curvature_adaptivity(wishes.adaptivity).vertex_sizing_map(size)
                     .border_tolerance(wishes.border_tolerance)
                     .area_threshold(wishes.area_threshold).symmetry_plane(quads.plane)
                     .minimize_number_of_quads(wishes.coarsest)
                     .maximum_feature_loss(wishes.feature_loss)
                     .target_number_of_quads(wishes.number_of_quads)
                     .maximum_number(most_quads(wishes, mesh, size));
    const auto make = [&](const auto& all) {
      quads.report = QR::quad_remesh(mesh, quads.mesh, all,
                                     QR::parameters::edge_is_constrained_map(quads.is_feature)
                                                    .vertex_location_map(quads.of_vertex)
                                                    .face_location_map(quads.of_face));
    };
    wishes.edge_length ? make(np.target_edge_length(*wishes.edge_length)) : make(np);
  }
};

py::list list_of(const std::vector<QR::Released_feature>& features)
{
  using namespace py::literals;
  py::list result;
  for(const auto& f : features)
    result.append(py::dict("source"_a = f.source, "target"_a = f.target, "length"_a = f.length));
  return result;
}

py::list list_of(const std::vector<QR::Part_of_other_size>& parts)
{
  using namespace py::literals;
  py::list result;
  for(const auto& p : parts)
    result.append(py::dict("triangle"_a = p.face, "number_of_quads"_a = p.number_of_quads,
                           "number_wanted"_a = p.number_wanted,
                           "number_needed"_a = p.number_needed,
                           "has_too_many_quads"_a = p.has_too_many_quads));
  return result;
}

py::dict dict_of(const QR::Remeshing_report& report, const Array_surface& surface)
{
  py::dict result = ::dict_of(report, &surface);
  result["number_of_quads"] = report.number_of_quads;
  result["number_of_vertices"] = report.number_of_vertices;
  result["number_of_irregular_vertices"] = report.number_of_irregular_vertices;
  result["number_of_forced_quads"] = report.number_of_forced_quads;
  result["has_too_many_quads"] = report.has_too_many_quads;
  result["parts_of_other_size"] = list_of(report.parts_of_other_size);
  result["number_of_parts_left_out"] = report.number_of_parts_left_out;
  result["area_of_parts_left_out"] = report.area_of_parts_left_out;
  result["released_features"] = list_of(report.released_features);
  result["number_of_inverted_quads"] = report.number_of_inverted_quads;
  result["first_inverted_quads"] = report.first_inverted_quads;
  result["number_of_folded_quads"] = report.number_of_folded_quads;
  result["first_folded_quads"] = report.first_folded_quads;
  result["number_of_displaced_vertices"] = report.number_of_displaced_vertices;
  result["largest_displacement"] = report.largest_displacement;
  result["largest_distance"] = report.largest_distance;
  result["largest_distance_of_input"] = report.largest_distance_of_input;
  result["edge_lengths"] = report.edge_lengths;
  result["median_size_deviation"] = report.median_size_deviation;
  result["least_scaled_jacobian"] = report.least_scaled_jacobian;
  result["mean_scaled_jacobian"] = report.mean_scaled_jacobian;
  result["number_of_flipped_faces"] = report.number_of_flipped_faces;
  result["number_of_released_edges"] = report.number_of_released_edges;
  result["length_of_released_edges"] = report.length_of_released_edges;
  result["remaining_flips"] = report.remaining_flips;
  result["step_times"] = ::dict_of(report.step_times);
  return result;
}

// Points, quads, and the report, with what ties the quads to the input.
py::tuple quad_remesh(const Doubles& points, const Integers& triangles,
                      const std::optional<Integers>& features,
                      const std::optional<Doubles>& directions, const std::optional<Doubles>& sizes,
                      const Wishes& wishes, const std::optional<bool> weld,
                      const py::object& progress)
{
  const std::shared_ptr<Remeshing> remeshing(new Remeshing{
    {triangles, points, std::nullopt, features}, copy_of(directions), copy_of(sizes), wishes, weld});
  const double seconds = run_apart(progress, remeshing);
  const Located_quads& quads = remeshing->quads;
  Quad_arrays& result = *remeshing->result;
  py::dict report = dict_of(quads.report, *remeshing->surface);
  report["seconds_in_core"] = seconds;
  report["has_area_threshold"] = wishes.area_threshold.has_value();
  if(quads.plane)
    report["symmetry_plane"] = std::array<double, 4>{
      {quads.plane->a(), quads.plane->b(), quads.plane->c(), quads.plane->d()}};
  report["feature_edges"] = to_array(std::move(result.features));
  report["faces_of_vertices"] = to_array(std::move(remeshing->faces_of_vertices));
  report["weights_of_vertices"] = to_array(std::move(remeshing->weights_of_vertices));
  report["faces_of_quads"] = to_array(std::move(remeshing->faces_of_quads));
  return py::make_tuple(to_array(std::move(result.points)), to_array(std::move(result.polygons)),
                        report);
}

} // namespace

void add_remeshing(py::module_& module)
{
  py::class_<Wishes>(module, "Wishes")
    .def(py::init([](const std::size_t number, const std::optional<double> length,
                     const bool coarsest, const std::optional<std::size_t> maximum,
                     const double loss, const std::optional<double> curvature,
                     const std::optional<double> tolerance, const std::optional<double> threshold,
                     const double adaptivity,
                     const std::optional<std::array<double, 4> >& plane, const bool finds_plane) {
      return Wishes{number, length, coarsest, maximum, loss, curvature, tolerance, threshold,
                    adaptivity, plane, finds_plane};
    }), py::kw_only(), py::arg("number_of_quads"), py::arg("edge_length"), py::arg("coarsest"),
        py::arg("maximum_number"), py::arg("feature_loss"), py::arg("curvature"),
        py::arg("border_tolerance"), py::arg("area_threshold"), py::arg("adaptivity"), py::arg("plane"),
        py::arg("finds_plane"));
  module.def("quad_remesh", quad_remesh);
}
