// Does not compile: passes to each public function a named parameter that it does not read, a
// container in place of a property map, and numbers that are not to be converted.
//
// error: the function does not read this named parameter
// error: the function does not read this named parameter
// error: the function does not read this named parameter
// error: the function does not read this named parameter
// error: the function does not read this named parameter
// error: the function does not read this named parameter
// error: the function does not read this named parameter
// error: the function does not read this named parameter
// error: the function does not read this named parameter
// error: the function does not read this named parameter
// error: the function does not read this named parameter
// error: the function does not read this named parameter
// error: the function does not read this named parameter
// error: the function does not read this named parameter
// error: the function does not read this named parameter
// error: the function does not read this named parameter
// error: this named parameter takes a property map, not a container
// error: convert coefficients and right-hand sides to CGAL::Exact_rational
// error: the constraints must be Linear_constraints or a sparse matrix of Eigen

#include <CGAL/Hexahedral_meshing/extract_hexahedra.h>
#include <CGAL/Isocurves_and_layouts/Motorcycle_graph.h>
#include <CGAL/Isocurves_and_layouts/copy_to_face_graph.h>
#include <CGAL/Isocurves_and_layouts/trace_isocurve.h>
#include <CGAL/Linear_snapping/snap_to_linear_constraints.h>
#include <CGAL/Quad_remeshing/approximate_seamless_parametrization.h>
#include <CGAL/Quad_remeshing/extract_grid_mesh.h>
#include <CGAL/Quad_remeshing/measure_quad_shapes.h>
#include <CGAL/Quad_remeshing/quad_remesh.h>
#include <CGAL/Quad_remeshing/quantize.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/is_volume_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_soup_to_seamless.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <iterator>
#include <vector>

namespace QR = CGAL::Quad_remeshing;
namespace parameters = QR::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Uv_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;

// An exact number that is none of CGAL's two.
struct Fraction
{
  explicit operator CGAL::Exact_rational() const;
};

void call_all(Mesh& mesh, const Uv_map uv, const QR::Quantization& quantization,
              const QR::Motorcycle_graph<Mesh>& graph, const QR::Isocurve_start<Mesh>& start)
{
  Mesh output;
  std::vector<double> x;
  const auto number = parameters::target_number_of_quads(3);
  const QR::Linear_constraints<> constraints(0);
  QR::snap_to_linear_constraints(constraints, x, number);
  QR::snap_to_seamless(mesh, uv, number);
  std::vector<std::array<int, 3> > triangles;
  std::vector<std::array<int, 4> > tetrahedra;
  std::vector<Kernel::Point_2> corners;
  std::vector<Kernel::Point_3> uvw;
  QR::snap_soup_to_seamless(triangles, CGAL::make_property_map(corners), number);
  QR::is_volume_seamless(tetrahedra, CGAL::make_property_map(uvw), number);
  std::vector<std::vector<std::size_t> > hexahedra;
  CGAL::Hexahedral_meshing::extract_hexahedra(uvw, tetrahedra, CGAL::make_property_map(uvw), uvw,
                                              hexahedra, parameters::verbose(true));
  QR::IO::write_OBJ("", mesh, uv, number);
  std::vector<QR::Isocurve_point<Mesh> > points;
  QR::trace_isocurve(mesh, uv, start, QR::Isocurve_direction::PLUS_U, std::back_inserter(points),
                     number);
  QR::motorcycle_graph(mesh, uv, number);
  QR::copy_to_face_graph(graph, output, parameters::default_values(), number);
  QR::approximate_seamless_parametrization(mesh, uv, number);
  QR::extract_quad_mesh(mesh, uv, output, number);
  QR::extract_quad_mesh(quantization, mesh, output, number);
  QR::measure_quad_shapes(mesh, number);
  QR::quantize(mesh, uv, number.tolerance(1e-3));
  QR::quantize_again(quantization, mesh, number.tolerance(1e-3));
  QR::quad_remesh(mesh, output, number.tolerance(1e-3));

  QR::seam_transitions(mesh, uv, parameters::edge_is_cut_map(std::vector<bool>()));

  QR::Linear_constraints<Fraction> fractions(1);
  QR::snap_to_linear_constraints(fractions, x);
  QR::snap_to_linear_constraints(Eigen::MatrixXd(1, 1), x);
}
