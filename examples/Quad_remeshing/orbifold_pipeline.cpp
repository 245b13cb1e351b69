// From a mesh to exactly seamless parametrizations: computes the four types of orbifold Tutte
// embeddings of a sphere, which are seamless up to rounding, and snaps them. Each type has a
// rotational symmetry of its own. In the end, makes a mesh of triangles from one map, with nearly
// all vertices of valence six. Writes all results as OBJ and OFF files, if a folder is given.

#include <CGAL/Quad_remeshing/extract_grid_mesh.h>
#include <CGAL/Quad_remeshing/is_integer_grid_map.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Orbifold_Tutte_parameterizer_3.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <list>
#include <string>
#include <unordered_map>
#include <vector>

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace QR = CGAL::Quad_remeshing;
namespace SS = CGAL::Seamless_snapping;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using Halfedge = Mesh::Halfedge_index;
using UV_map = Mesh::Property_map<Halfedge, Point_2>;

using Seam_edge_map = Mesh::Property_map<Edge, bool>;
using Seam_vertex_map = Mesh::Property_map<Vertex, bool>;
using Seam_mesh = CGAL::Seam_mesh<Mesh, Seam_edge_map, Seam_vertex_map>;
using Seam_vertex = boost::graph_traits<Seam_mesh>::vertex_descriptor;
using Seam_halfedge = boost::graph_traits<Seam_mesh>::halfedge_descriptor;

Mesh make_sphere()
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point_3>(mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(3));
  for(Vertex v : vertices(mesh)) {
    const Kernel::Vector_3 p = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + p / std::sqrt(p.squared_length());
  }
  return mesh;
}

// Parametrizes `mesh`, cut along shortest paths between the cones; one coordinate pair per corner.
bool parametrize(Mesh& mesh, const std::vector<Vertex>& cones, SMP::Orbifold_type type,
                  UV_map corner_uv_map)
{
  Seam_edge_map seam_edges = mesh.add_property_map<Edge, bool>("e:on_seam", false).first;
  Seam_vertex_map seam_vertices = mesh.add_property_map<Vertex, bool>("v:on_seam", false).first;
  Seam_mesh seam_mesh(mesh, seam_edges, seam_vertices);

  std::list<Edge> seam;
  SMP::compute_shortest_paths_between_cones(mesh, cones.begin(), cones.end(), seam);
  for(Edge e : seam)
    seam_mesh.add_seam(source(e, mesh), target(e, mesh));

  std::unordered_map<Seam_vertex, int> indices;
  for(Seam_vertex v : vertices(seam_mesh))
    indices.emplace(v, int(indices.size()));
  std::unordered_map<Seam_vertex, SMP::Cone_type> cone_types;
  SMP::locate_cones(seam_mesh, cones.begin(), cones.end(), cone_types);

  UV_map seam_uv_map = mesh.add_property_map<Halfedge, Point_2>("h:seam_uv").first;
  const Seam_halfedge border =
    CGAL::Polygon_mesh_processing::longest_border(seam_mesh).first;
  SMP::Orbifold_Tutte_parameterizer_3<Seam_mesh> parametrizer(type);
  const SMP::Error_code error =
    parametrizer.parameterize(seam_mesh, border, cone_types, seam_uv_map,
                               boost::make_assoc_property_map(indices));

  // A vertex of the seam mesh is one of the halfedges of a sector: all corners get its value.
  for(Halfedge h : halfedges(mesh))
    put(corner_uv_map, h, get(seam_uv_map, target(Seam_halfedge(h), seam_mesh)));

  mesh.remove_property_map(seam_uv_map);
  mesh.remove_property_map(seam_edges);
  mesh.remove_property_map(seam_vertices);
  if(error != SMP::OK)
    std::cerr << SMP::get_error_message(error) << std::endl;
  return error == SMP::OK;
}

// \tparam N the order of the symmetry: charts are turned by multiples of 360 / N degrees
template <int N>
bool snap(const Mesh& mesh, UV_map uv_map)
{
  // Rotations by 120 and by 60 degrees are exact in coordinates of a triangular lattice only.
  if(N == 3 || N == 6)
    SS::convert_to_lattice_coordinates(mesh, uv_map);
  const auto np = SS::parameters::rotational_symmetry(SS::Rotational_symmetry<N>());
  const auto before = SS::measure_seamlessness(mesh, uv_map, np);
  std::cout << "  before: violation " << before.violation << ", "
            << before.number_of_inexact_edges << " inexact edges, "
            << before.number_of_flipped_faces << " flipped faces\n";

  const SS::Snapping_report report = SS::snap_to_seamless(mesh, uv_map, np);
  std::cout << "  " << report << ", largest change " << report.largest_change << "\n";

  const auto after = SS::measure_seamlessness(mesh, uv_map, np);
  std::cout << "  after:  violation " << after.violation << ", "
            << after.number_of_inexact_edges << " inexact edges, "
            << after.number_of_flipped_faces << " flipped faces\n";

  const auto seams = SS::seam_transitions(mesh, uv_map, np);
  for(const auto& [cone, index] : seams.singular_vertices())
    std::cout << "  cone at " << cone << ", angle " << 360 * (N - index) / N << " degrees\n";
  return report && SS::is_seamless(mesh, uv_map, np);
}

// The isocurves of integer levels of u, v, and u + v, as a mesh of about so many triangles.
bool extract_triangles(const Mesh& mesh, UV_map uv_map, double number, Mesh& triangles)
{
  SS::convert_to_lattice_coordinates(mesh, uv_map);
  const auto np = SS::parameters::rotational_symmetry(SS::Rotational_symmetry<6>());
  const double area = QR::measure_integer_grid(mesh, uv_map, np).area;
  const auto snapped = SS::snap_to_seamless(
    mesh, uv_map,
    np.integer_grid(true).grid_scale(std::sqrt(number / (2 * area))).rounding_tolerance(10.));
  std::cout << "  " << snapped << ", rounded by up to " << snapped.largest_rounding << "\n";
  const auto extracted = QR::extract_triangle_mesh(mesh, uv_map, triangles, np);
  std::cout << "  " << extracted << ", " << extracted.number_of_faces << " triangles\n";
  for(Vertex v : vertices(triangles))
    if(degree(v, triangles) != 6)
      std::cout << "  a vertex of valence " << degree(v, triangles) << "\n";
  return bool(extracted);
}

int main(int argc, char* argv[])
{
  Mesh mesh = make_sphere();
  UV_map uv_map = mesh.add_property_map<Halfedge, Point_2>("h:uv").first;
  std::cout << num_faces(mesh) << " faces" << std::endl;

  // The vertices of the icosahedron come first.
  const std::vector<Vertex> vertices_of_icosahedron(vertices(mesh).begin(),
                                                    std::next(vertices(mesh).begin(), 12));
  const auto& v = vertices_of_icosahedron;

  const std::vector<Vertex> three{v[0], v[3], v[11]}, four{v[0], v[3], v[7], v[11]};

  const auto write = [&](const std::string& name) {
    return argc < 2 || SS::IO::write_OBJ(std::string(argv[1]) + "/" + name + ".obj", mesh,
                                         uv_map);
  };

  std::cout << "Square, with three cones" << std::endl;
  bool all = parametrize(mesh, three, SMP::Square, uv_map) && snap<4>(mesh, uv_map) &&
             write("square");
  std::cout << "Diamond, with three cones" << std::endl;
  all = parametrize(mesh, three, SMP::Diamond, uv_map) && snap<3>(mesh, uv_map) &&
        write("diamond") && all;
  std::cout << "Triangle, with three cones" << std::endl;
  all = parametrize(mesh, three, SMP::Triangle, uv_map) && snap<6>(mesh, uv_map) &&
        write("triangle") && all;
  std::cout << "Parallelogram, with four cones" << std::endl;
  all = parametrize(mesh, four, SMP::Parallelogram, uv_map) && snap<2>(mesh, uv_map) &&
        write("parallelogram") && all;

  // Rotations by 180 degrees are rotations by multiples of 60 degrees.
  Mesh triangles;
  all = extract_triangles(mesh, uv_map, 2000, triangles) && all;
  if(argc > 1)
    all = CGAL::IO::write_OFF(std::string(argv[1]) + "/triangles.off", triangles) && all;
  return all ? EXIT_SUCCESS : EXIT_FAILURE;
}
