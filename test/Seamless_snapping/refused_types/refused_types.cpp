// Does not compile: passes meshes and maps of types that won't do to all public functions that take
// a uv map, and named parameters without those that they are for. The compiler is to say why, once
// for each type and parameter, and nothing else, which cmake/test_refused_types.cmake checks.
//
// error: pass the underlying mesh, with get(uv, target(hd(h), seam_mesh).hd)
// error: the uv map must be a property map
// error: the keys of the uv map must be halfedges of the mesh
// error: the values of the uv map must be two-dimensional points of a kernel
// error: the values of the uv map must be two-dimensional points of a kernel
// error: the values of the uv map must be two-dimensional points of a kernel
// error: rounding_tolerance is for integer_grid: give that, too
// error: number_of_untangling_iterations is for repair_flips: give that, too
// error: repair_flips takes a Flip_repair or a bool, not a number

#include <CGAL/Isocurves_and_layouts/Motorcycle_graph.h>
#include <CGAL/Isocurves_and_layouts/trace_isocurve.h>
#include <CGAL/Quad_remeshing/approximate_seamless_parametrization.h>
#include <CGAL/Quad_remeshing/extract_grid_mesh.h>
#include <CGAL/Quad_remeshing/is_integer_grid_map.h>
#include <CGAL/Quad_remeshing/quantize.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/IO/PLY.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <array>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace QR = CGAL::Quad_remeshing;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Seam_mesh = CGAL::Seam_mesh<Mesh, Mesh::Property_map<Mesh::Edge_index, bool>,
                                  Mesh::Property_map<Mesh::Vertex_index, bool> >;
template <typename Value>
using Map = Mesh::Property_map<Mesh::Halfedge_index, Value>;

template <typename M, typename Uv_map>
void call_all(M& mesh, Uv_map uv)
{
  QR::snap_to_seamless(mesh, uv);
  QR::snap_to_seamless(mesh, uv, QR::parameters::integer_grid(true));
  QR::snap_to_seamless(mesh, uv, QR::parameters::rounding_tolerance(1.));
  QR::snap_to_seamless(mesh, uv, QR::parameters::number_of_untangling_iterations(9));
  QR::snap_to_seamless(mesh, uv, QR::parameters::repair_flips(2));
  QR::is_seamless(mesh, uv);
  QR::measure_seamlessness(mesh, uv);
  QR::seam_transitions(mesh, uv);
  QR::measure_integer_grid(mesh, uv);
  QR::is_integer_grid_map(mesh, uv);
  QR::approximate_seamless_parametrization(mesh, uv);
  QR::convert_to_lattice_coordinates(mesh, uv);
  QR::convert_to_cartesian_coordinates(mesh, uv);
  QR::quantize(mesh, uv);
  QR::motorcycle_graph(mesh, uv);

  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 4> > quads;
  std::vector<std::array<std::size_t, 3> > triangles;
  Mesh output;
  QR::extract_quad_mesh(mesh, uv, output);
  QR::extract_quad_soup(mesh, uv, points, quads);
  QR::extract_triangle_mesh(mesh, uv, output);
  QR::extract_triangle_soup(mesh, uv, points, triangles);

  std::stringstream stream;
  const std::string name;
  QR::IO::read_OBJ(stream, mesh, uv);
  QR::IO::read_OBJ(name, mesh, uv);
  QR::IO::write_OBJ(stream, mesh, uv);
  QR::IO::write_OBJ(name, mesh, uv, name);
  QR::IO::read_PLY(stream, mesh, uv);
  QR::IO::read_PLY(name, mesh, uv);
  QR::IO::write_PLY(stream, mesh, uv);
  QR::IO::write_PLY(name, mesh, uv, name);

  std::vector<QR::Isocurve<M> > curves;
  QR::trace_all_separatrices(mesh, uv, std::back_inserter(curves));
}

// Curves of a seam mesh can't even be started.
template <typename Uv_map>
void trace(const Mesh& mesh, Uv_map uv, const QR::Isocurve_start<Mesh>& start,
           const QR::Isocurve_point<Mesh>& point)
{
  std::vector<QR::Isocurve_point<Mesh> > points;
  QR::trace_isocurve(mesh, uv, start, QR::Isocurve_direction::PLUS_U, std::back_inserter(points));
  QR::isocurve_parameter(point, mesh, uv);
  QR::isocurve_uv(point, mesh, uv);
  QR::isocurve_point_3(point, mesh, uv, get(CGAL::vertex_point, mesh));
}

template void call_all(Seam_mesh&, Map<Kernel::Point_2>);
template void call_all(Mesh&, std::map<Mesh::Halfedge_index, Kernel::Point_2>);
template void call_all(Mesh&, Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2>);
template void call_all(Mesh&, Map<Kernel::Point_3>);
template void call_all(Mesh&, Map<std::array<double, 2> >);
template void call_all(Mesh&, Map<std::vector<double> >);
template void trace(const Mesh&, Map<Kernel::Point_3>, const QR::Isocurve_start<Mesh>&,
                    const QR::Isocurve_point<Mesh>&);
