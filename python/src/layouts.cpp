// Layouts, and isocurves: what is found on an exactly seamless map.

#include "Array_surface.h"
#include "Call.h"
#include "functions.h"
#include "reports.h"

#include <CGAL/Isocurves_and_layouts/Motorcycle_graph.h>
#include <CGAL/Isocurves_and_layouts/trace_isocurve.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace IL = CGAL::Isocurves_and_layouts;

namespace {

// Places on the surface: a triangle, and barycentric coordinates in the order of its row.
struct Places
{
  std::vector<std::int64_t> faces;
  std::vector<std::array<double, 3> > weights;

  void add(const Array_surface& surface, const IL::Motorcycle_graph<Mesh>::Location& location)
  {
    faces.push_back(std::int64_t(location.first));
    weights.push_back(surface.in_order_of_row(location));
  }

  void write(py::dict& result, const std::string& name)
  {
    result[py::str(name + "_faces")] = to_array(std::move(faces));
    result[py::str(name + "_weights")] = to_array(std::move(weights));
  }
};

struct Layout_arrays
{
  Places nodes, path;
  std::vector<std::int64_t> node_kinds, node_vertices, path_offsets{0}, patch_halves,
    patch_offsets{0};
  std::vector<std::array<std::int64_t, 2> > arcs, arc_patches;
  std::vector<std::array<std::int64_t, 4> > patch_corners;
  std::vector<double> arc_lengths;
  std::vector<std::array<double, 2> > patch_sizes;
  std::vector<std::int8_t> arc_is_constrained, patch_is_cut;

  Layout_arrays() = default;

  Layout_arrays(const Array_surface& surface, const IL::Motorcycle_graph<Mesh>& graph)
  {
    for(std::size_t n = 0; n < graph.number_of_nodes(); ++n) {
      nodes.add(surface, graph.node_location(n));
      node_kinds.push_back(int(graph.node_kind(n)));
      const bool is_vertex = graph.node_place(n) == IL::Isocurve_place::VERTEX;
      node_vertices.push_back(
        is_vertex ? std::int64_t(surface.row(surface.mesh.target(graph.node_halfedge(n)))) : -1);
    }
    for(std::size_t a = 0; a < graph.number_of_arcs(); ++a)
      add_arc(surface, graph, a);
    for(std::size_t p = 0; p < graph.number_of_patches(); ++p)
      add_patch(graph, p);
  }

  py::dict dict()
  {
    py::dict result;
    nodes.write(result, "node");
    path.write(result, "path");
    result["node_kinds"] = to_array(std::move(node_kinds));
    result["node_vertices"] = to_array(std::move(node_vertices));
    result["path_offsets"] = to_array(std::move(path_offsets));
    result["arcs"] = to_array(std::move(arcs));
    result["arc_patches"] = to_array(std::move(arc_patches));
    result["arc_lengths"] = to_array(std::move(arc_lengths));
    result["arc_is_constrained"] = to_array(std::move(arc_is_constrained));
    result["patch_half_arcs"] = to_array(std::move(patch_halves));
    result["patch_offsets"] = to_array(std::move(patch_offsets));
    result["patch_corners"] = to_array(std::move(patch_corners));
    result["patch_sizes"] = to_array(std::move(patch_sizes));
    result["patch_is_cut"] = to_array(std::move(patch_is_cut));
    return result;
  }

private:
  void add_arc(const Array_surface& surface, const IL::Motorcycle_graph<Mesh>& graph,
               const std::size_t a)
  {
    const auto patch = [&](const std::size_t h)
      { return graph.patch(h) == graph.null_patch ? -1 : std::int64_t(graph.patch(h)); };
    arcs.push_back({{std::int64_t(graph.source(2 * a)), std::int64_t(graph.target(2 * a))}});
    arc_patches.push_back({{patch(2 * a), patch(2 * a + 1)}});
    arc_lengths.push_back(CGAL::to_double(graph.arc_length(a)));
    arc_is_constrained.push_back(graph.arc_is_constrained(a));
    for(const auto& location : graph.arc_path(a))
      path.add(surface, location);
    path_offsets.push_back(std::int64_t(path.faces.size()));
  }

  void add_patch(const IL::Motorcycle_graph<Mesh>& graph, const std::size_t p)
  {
    const bool is_cut = graph.patch_is_cut(p);
    patch_is_cut.push_back(is_cut);
    patch_sizes.push_back({{CGAL::to_double(graph.patch_width(p)),
                            CGAL::to_double(graph.patch_height(p))}});
    std::array<std::int64_t, 4> corners{{-1, -1, -1, -1}};
    for(std::size_t side = 0; side < 4 && !is_cut; ++side)
      corners[side] = std::int64_t(graph.source(graph.patch_side(p, side).front()));
    patch_corners.push_back(corners);
    for(const auto& cycle : graph.patch_cycles(p))
      patch_halves.insert(patch_halves.end(), cycle.begin(), cycle.end());
    patch_offsets.push_back(std::int64_t(patch_halves.size()));
  }
};

struct Layout
{
  void run()
  {
    surface.emplace(std::move(arrays));
    surface->turn_if_mirrored();
    const auto np = IL::parameters::edge_is_constrained_map(surface->is_feature);
    const IL::Motorcycle_graph<Mesh> graph =
      base_complex ? IL::motorcycle_graph(surface->mesh, surface->uv_map,
                                          np.curve_stop_policy(IL::Run_to_nodes()))
                   : IL::motorcycle_graph(surface->mesh, surface->uv_map, np);
    message = graph.message();
    if(!graph)
      throw Refused(graph.status(), message, renamed(surface->rows()));
    result = Layout_arrays(*surface, graph);
  }

  Surface_arrays arrays;
  bool base_complex;
  std::optional<Array_surface> surface = std::nullopt;
  Message message = {};
  Layout_arrays result = {};
};

py::dict layout(const Doubles& points, const Integers& triangles, const Doubles& uv,
                const std::optional<Integers>& features, const bool base_complex)
{
  const std::shared_ptr<Layout> made(new Layout{{triangles, points, uv, features}, base_complex});
  run_apart(py::none(), made);
  py::dict dict = made->result.dict();
  dict["message"] = with_rows(made->message, renamed(made->surface->rows()));
  return dict;
}

using Tracer = IL::Isocurve_tracer<Mesh>;
using Start = std::pair<Tracer::Start, IL::Isocurve_direction>;

// The starts of curves: at all singular vertices, at vertices, or at places in triangles.
std::vector<Start> starts_at_vertices(const Tracer& tracer, const Array_surface& surface,
                                      std::optional<std::vector<std::int64_t> > rows)
{
  std::vector<char> is_wanted(surface.mesh.number_of_vertices(), 0);
  if(rows) {
    std::sort(rows->begin(), rows->end());
    for(const auto v : surface.mesh.vertices())
      is_wanted[v] = std::binary_search(rows->begin(), rows->end(), std::int64_t(surface.row(v)));
  } else {
    for(const auto v : surface.mesh.vertices())
      is_wanted[v] = tracer.is_singular(v);
  }
  std::vector<Start> result;
  for(const auto v : surface.mesh.vertices())
    if(is_wanted[v])
      for(const auto& [start, direction] : tracer.outgoing(v))
        result.emplace_back(start, direction);
  return result;
}

// The place in the plane, if it lies in the triangle: rounding might put it beside.
std::optional<Kernel::Point_2> place_in_plane(const Array_surface& surface, const std::size_t face,
                                              const double* const weights)
{
  using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  double x = 0, y = 0;
  std::array<Exact_kernel::Point_2, 3> corners;
  for(std::size_t k = 0; k < 3; ++k) {
    const Kernel::Point_2& p = surface.uv_map[surface.corner(face, k)];
    corners[k] = {p.x(), p.y()};
    x += weights[k] * p.x();
    y += weights[k] * p.y();
  }
  for(std::size_t k = 0; k < 3; ++k)
    if(CGAL::orientation(corners[k], corners[(k + 1) % 3], Exact_kernel::Point_2(x, y)) !=
       CGAL::orientation(corners[0], corners[1], corners[2]))
      return std::nullopt;
  return Kernel::Point_2(x, y);
}

std::vector<Start> starts_in_faces(const Array_surface& surface,
                                   const std::vector<std::int64_t>& faces,
                                   const std::vector<double>& weights)
{
  std::vector<Start> result;
  for(std::size_t i = 0; i < faces.size(); ++i) {
    const std::size_t f = std::size_t(faces[i]);
    const auto p = place_in_plane(surface, f, weights.data() + 3 * i);
    if(!p)
      throw Refused(IL::Outcome::INVALID_ARGUMENT,
                    row_of(i, "start") + " lies on the border of its triangle, up to rounding, or "
                      "the triangle has no area in the plane" +
                      remedy("pass positive weights, or a vertex"));
    for(int d = 0; d < 4; ++d)
      result.emplace_back(Tracer::Start::in_face(surface.corner(f, 0), p->x(), p->y()),
                          IL::Isocurve_direction(d));
  }
  return result;
}

struct Curve_arrays
{
  Places path;
  std::vector<std::int64_t> offsets{0}, directions;
  std::vector<std::string> ends;

  void add(const Array_surface& surface, const Tracer::Curve& curve)
  {
    for(const auto& point : curve.points) {
      const Halfedge h = point.halfedge();
      const std::size_t f = std::size_t(surface.mesh.face(h));
      path.faces.push_back(std::int64_t(f));
      path.weights.push_back(weights(surface, f, point));
    }
    offsets.push_back(std::int64_t(path.faces.size()));
    directions.push_back(int(curve.direction));
    ends.push_back(to_string(curve.status));
  }

private:
  static std::array<double, 3> weights(const Array_surface& surface, const std::size_t f,
                                       const IL::Isocurve_point<Mesh>& point)
  {
    const Halfedge h = point.halfedge();
    std::array<double, 3> result{{0, 0, 0}};
    const std::size_t k = surface.number_of_corner(f, h);
    if(point.place() == IL::Isocurve_place::VERTEX) {
      result[k] = 1;
    } else if(point.place() == IL::Isocurve_place::EDGE) {
      const double t =
        CGAL::to_double(IL::isocurve_parameter(point, surface.mesh, surface.uv_map));
      result[k] = t;
      result[(k + 2) % 3] = 1 - t;
    } else {
      const std::array<double, 2> uv = IL::isocurve_uv(point, surface.mesh, surface.uv_map);
      const Kernel::Point_2 p(uv[0], uv[1]);
      std::array<Kernel::Point_2, 3> c;
      for(std::size_t i = 0; i < 3; ++i)
        c[i] = surface.uv_map[surface.corner(f, i)];
      const double area = CGAL::area(c[0], c[1], c[2]);
      result = {{CGAL::area(p, c[1], c[2]) / area, CGAL::area(c[0], p, c[2]) / area,
                 CGAL::area(c[0], c[1], p) / area}};
    }
    return result;
  }
};

struct Tracing
{
  void run()
  {
    const Array_surface surface(std::move(arrays));
    const Tracer tracer(surface.mesh, surface.uv_map);
    if(!tracer.is_exact())
      throw Refused(IL::Outcome::NOT_SEAMLESS,
                    "the coordinates are not exactly seamless" +
                      remedy("pass them through snap() first"));
    const std::vector<Start> starts = faces.empty() ? starts_at_vertices(tracer, surface, vertices)
                                                    : starts_in_faces(surface, faces, weights);
    for(const auto& [start, direction] : starts) {
      result.add(surface,
                 maximum_length ? tracer.trace(start, direction,
                                               IL::parameters::maximum_length(*maximum_length))
                                : tracer.trace(start, direction));
      CGAL::Linear_snapping::internal::Progress::tell_each_second([&]
        { return std::to_string(result.ends.size()) + " curves"; });
    }
  }

  Surface_arrays arrays;
  std::optional<std::vector<std::int64_t> > vertices;
  std::vector<std::int64_t> faces;
  std::vector<double> weights;
  std::optional<double> maximum_length;
  Curve_arrays result = {};
};

py::dict trace(const Integers& triangles, const Doubles& uv,
               const std::optional<Integers>& vertices, const std::optional<Integers>& faces,
               const std::optional<Doubles>& weights, const std::optional<double> maximum_length,
               const py::object& progress)
{
  const std::shared_ptr<Tracing> tracing(new Tracing{
    {triangles, std::nullopt, uv, std::nullopt},
    vertices ? std::optional<std::vector<std::int64_t> >(copy_of(*vertices)) : std::nullopt,
    copy_of(faces), copy_of(weights), maximum_length});
  run_apart(progress, tracing);
  Curve_arrays& result = tracing->result;
  py::dict dict;
  result.path.write(dict, "path");
  dict["offsets"] = to_array(std::move(result.offsets));
  dict["directions"] = to_array(std::move(result.directions));
  dict["ends"] = result.ends;
  return dict;
}

} // namespace

void add_layouts(py::module_& module)
{
  module.def("layout", layout);
  module.def("trace", trace);
}
