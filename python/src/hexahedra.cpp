// Hexahedra of a map of a tetrahedral mesh, and their shapes.

#include "Array_volume.h"
#include "Call.h"
#include "functions.h"
#include "reports.h"

#include <CGAL/Hexahedral_meshing/hexahedral_mesh.h>
#include <CGAL/Hexahedral_meshing/measure_hexahedra.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace HM = CGAL::Hexahedral_meshing;

namespace {

py::dict dict_of(const HM::Hexahedron_shapes& shapes)
{
  using namespace py::literals;
  return py::dict("number_of_hexahedra"_a = shapes.number_of_hexahedra,
                  "least_scaled_jacobian"_a = shapes.least_scaled_jacobian,
                  "mean_scaled_jacobian"_a = shapes.mean_scaled_jacobian,
                  "number_by_tenths"_a = shapes.number_by_tenths,
                  "nonpositive_hexahedra"_a = shapes.nonpositive_hexahedra);
}

struct Meshing
{
  void run()
  {
    const auto np = volume.parameters().tolerance(tolerance).number_of_iterations(rounds)
                      .target_number_of_hexahedra(number);
    report = maximum ? HM::hexahedral_mesh(points, volume.tetrahedra, volume.uvw_map(), mesh,
                                           np.maximum_number(*maximum))
                     : HM::hexahedral_mesh(points, volume.tetrahedra, volume.uvw_map(), mesh, np);
  }

  std::vector<std::array<double, 3> > points;
  Array_volume volume;
  std::size_t number; // 0 for the hexahedra of the map as it is
  std::optional<std::size_t> maximum;
  double tolerance;
  std::size_t rounds;
  HM::Hexahedral_mesh mesh = {};
  HM::Hexahedral_meshing_report report = HM::Hexahedral_meshing_report();
};

template <std::size_t N>
py::array_t<std::int64_t> rows_of_points(const std::vector<std::array<std::int32_t, N> >& indices)
{
  std::vector<std::array<std::int64_t, N> > result(indices.size());
  for(std::size_t i = 0; i < indices.size(); ++i)
    std::copy(indices[i].begin(), indices[i].end(), result[i].begin());
  return to_array(std::move(result));
}

py::array_t<std::int64_t> array_of(const std::vector<std::int32_t>& numbers)
{ return to_array(std::vector<std::int64_t>(numbers.begin(), numbers.end())); }

py::dict dict_of(const HM::Hexahedral_meshing_report& report, const HM::Hexahedral_mesh& mesh)
{
  const HM::Report& outcome = report;
  py::dict result = ::dict_of(outcome);
  result.attr("update")(dict_of(report.shapes));
  result["number_of_vertices"] = report.number_of_vertices;
  result["number_of_edges"] = report.number_of_edges;
  result["number_of_quadrilaterals"] = report.number_of_quadrilaterals;
  result["number_of_boundary_quadrilaterals"] = report.number_of_boundary_quadrilaterals;
  result["number_of_double_edges"] = report.number_of_double_edges;
  result["irregular_edges"] = report.irregular_edges;
  result["grid_scale"] = report.grid_scale;
  result["number_of_attempts"] = report.number_of_attempts;
  result["reason_for_more"] = report.reason_for_more;
  result["shapes_before"] = dict_of(report.shapes_before);
  result["quadrilaterals"] = rows_of_points(mesh.quadrilaterals);
  result["patches"] = array_of(mesh.patches);
  result["feature_facets"] = array_of(mesh.feature_facets);
  result["edges"] = rows_of_points(mesh.edges);
  result["curves"] = array_of(mesh.curves);
  result["feature_edges"] = array_of(mesh.feature_edges);
  return result;
}

py::tuple hexahedra(const Doubles& points, const Integers& tetrahedra, const Doubles& uvw,
                    const std::optional<Integers>& facets, const std::optional<Integers>& edges,
                    const std::size_t number, const std::optional<std::size_t> maximum,
                    const double tolerance, const std::size_t rounds, const py::object& progress)
{
  const std::shared_ptr<Meshing> meshing(
    new Meshing{rows_of<3>(points), {tetrahedra, uvw, facets, edges}, number, maximum, tolerance,
                rounds});
  const double seconds = run_apart(progress, meshing);
  HM::Hexahedral_mesh& mesh = meshing->mesh;
  py::dict report = dict_of(meshing->report, mesh);
  report["seconds_in_core"] = seconds;
  return py::make_tuple(to_array(std::move(mesh.points)), rows_of_points(mesh.hexahedra), report);
}

py::dict measure_hexahedra(const Doubles& points, const Integers& hexahedra)
{
  struct Shape_measurement
  {
    void run() { shapes = HM::measure_hexahedra(points, hexahedra); }

    std::vector<std::array<double, 3> > points;
    std::vector<std::array<std::int64_t, 8> > hexahedra;
    HM::Hexahedron_shapes shapes = {};
  };
  const std::shared_ptr<Shape_measurement> measurement(
    new Shape_measurement{rows_of<3>(points), rows_of<8>(hexahedra)});
  run_apart(py::none(), measurement);
  return dict_of(measurement->shapes);
}

} // namespace

void add_hexahedra(py::module_& module)
{
  module.def("hexahedra", hexahedra);
  module.def("measure_hexahedra", measure_hexahedra);
}
