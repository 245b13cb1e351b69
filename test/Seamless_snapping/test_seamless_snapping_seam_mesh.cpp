// Tests the surface function on what CGAL's own parametrizers leave in the mesh beneath a
// CGAL::Seam_mesh: orbifold embeddings, seamless up to rounding, for all cone layouts that rotate
// by multiples of 90 degrees. Their corners are read by the lines that the user manual shows.

#include "floating_point_traps.h"
#include "surface_checks.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Orbifold_Tutte_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/property_map/property_map.hpp>

#include <list>
#include <random>
#include <unordered_map>

namespace SMP = CGAL::Surface_mesh_parameterization;

using namespace surface_checks;

using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Seam_edge_map = Mesh::Property_map<Edge, bool>;
using Seam_vertex_map = Mesh::Property_map<Vertex, bool>;
using Seam_mesh = CGAL::Seam_mesh<Mesh, Seam_edge_map, Seam_vertex_map>;
using Seam_vertex = boost::graph_traits<Seam_mesh>::vertex_descriptor;
using Seam_halfedge = boost::graph_traits<Seam_mesh>::halfedge_descriptor;

// A ball of uneven triangles: an icosahedron whose edges are split at random.
Mesh ball(int splits, unsigned int seed)
{
  std::mt19937_64 random(seed);
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point_3>(mesh);
  for(int i = 0; i < splits; ++i) {
    const auto e = Edge(std::uint32_t(random() % mesh.number_of_edges()));
    const auto h = mesh.halfedge(e);
    const Point_3 p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h));
    const auto split = CGAL::Euler::split_edge(h, mesh);
    const double x = p.x() + q.x(), y = p.y() + q.y(), z = p.z() + q.z();
    const double length = std::sqrt(x * x + y * y + z * z);
    mesh.point(mesh.target(split)) = Point_3(x / length, y / length, z / length);
    CGAL::Euler::split_face(split, mesh.next(h), mesh);
    const auto g = mesh.opposite(h);
    CGAL::Euler::split_face(g, mesh.next(mesh.next(g)), mesh);
  }
  return mesh;
}

Vertex nearest_vertex(const Mesh& mesh, const Point_3& p)
{
  return *std::min_element(mesh.vertices().begin(), mesh.vertices().end(), [&](auto v, auto w) {
    return CGAL::squared_distance(mesh.point(v), p) < CGAL::squared_distance(mesh.point(w), p);
  });
}

// The parametrizer writes one halfedge per vertex of the seam mesh only.
UV_map uv_of_all_corners(Mesh& mesh, const Seam_mesh& seam_mesh, const UV_map& seam_uv)
{
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(h))
      put(uv, h, get(seam_uv, target(Seam_halfedge(h), seam_mesh).hd));
  return uv;
}

// Of a surface that is cut anyhow, the two sides of the cut get other lengths: the message says so,
// and which maps are seamless; it does not advise a larger tolerance.
void test_free_border(const unsigned int seed)
{
  const std::string context = "free border, seed " + std::to_string(seed);
  Mesh mesh = ball(300, seed);
  const auto seam_edges = mesh.add_property_map<Edge, bool>("e:on_seam", false).first;
  const auto seam_vertices = mesh.add_property_map<Vertex, bool>("v:on_seam", false).first;
  Seam_mesh seam_mesh(mesh, seam_edges, seam_vertices);
  const std::vector<Vertex> ends{nearest_vertex(mesh, { 1, 0, 0 }),
                                 nearest_vertex(mesh, { 0, 1, 0 }),
                                 nearest_vertex(mesh, { -1, 0, 0 })};
  std::list<Edge> seam;
  SMP::compute_shortest_paths_between_cones(mesh, ends.begin(), ends.end(), seam);
  for(const Edge e : seam)
    seam_mesh.add_seam(mesh.vertex(e, 0), mesh.vertex(e, 1));
  const UV_map seam_uv =
    mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:seam_uv").first;
  const auto border = CGAL::Polygon_mesh_processing::longest_border(seam_mesh).first;
  const auto error =
    SMP::parameterize(seam_mesh, SMP::LSCM_parameterizer_3<Seam_mesh>(), border, seam_uv);
  CHECK_IN(context, error == SMP::OK);
  const auto uv = uv_of_all_corners(mesh, seam_mesh, seam_uv);
  const auto report = CGAL::Seamless_snapping::snap_to_seamless(mesh, uv);
  CHECK_IN(context, report.status == SS::Outcome::NOT_SEAMLESS);
  CHECK_IN(context + ": " + report.message,
           report.message.find("leave the border of a cut surface free") != std::string::npos);
  CHECK_IN(context, report.message.find("raise the tolerance") == std::string::npos);
}

void test_orbifold(SMP::Orbifold_type type, std::size_t number_of_cones, unsigned int seed)
{
  const std::string context =
    "orbifold " + std::to_string(int(type)) + ", seed " + std::to_string(seed);
  Mesh mesh = ball(300, seed);
  CHECK_IN(context, CGAL::is_triangle_mesh(mesh) && CGAL::is_valid_polygon_mesh(mesh));
  const auto seam_edges = mesh.add_property_map<Edge, bool>("e:on_seam", false).first;
  const auto seam_vertices = mesh.add_property_map<Vertex, bool>("v:on_seam", false).first;
  Seam_mesh seam_mesh(mesh, seam_edges, seam_vertices);

  // along the equator, so that the paths between them have no edge in common
  const Point_3 places[] = { { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 } };
  std::vector<Vertex> cones;
  for(std::size_t i = 0; i < number_of_cones; ++i)
    cones.push_back(nearest_vertex(mesh, places[i]));
  std::list<Edge> seam;
  SMP::compute_shortest_paths_between_cones(mesh, cones.begin(), cones.end(), seam);
  for(const Edge e : seam)
    seam_mesh.add_seam(mesh.vertex(e, 0), mesh.vertex(e, 1));

  std::unordered_map<Seam_vertex, int> indices;
  int index = 0;
  for(const Seam_vertex v : vertices(seam_mesh))
    indices[v] = index++;
  std::unordered_map<Seam_vertex, SMP::Cone_type> cone_types;
  SMP::locate_cones(seam_mesh, cones.begin(), cones.end(), cone_types);

  const UV_map seam_uv =
    mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:seam_uv").first;
  const SMP::Error_code error =
    SMP::Orbifold_Tutte_parameterizer_3<Seam_mesh>(type, SMP::Mean_value)
      .parameterize(seam_mesh, CGAL::Polygon_mesh_processing::longest_border(seam_mesh).first,
                    cone_types, seam_uv, boost::make_assoc_property_map(indices));
  CHECK_IN(context, error == SMP::OK);
  const auto uv = uv_of_all_corners(mesh, seam_mesh, seam_uv);

  const auto transitions = SS::seam_transitions(mesh, uv);
  CHECK_IN(context + ": " + transitions.message(), bool(transitions));
  for(const auto h : transitions.cut_halfedges())
    CHECK_IN(context, seam_edges[mesh.edge(h)]);
  CHECK_IN(context, transitions.merged_halfedges().empty());
  int sum = 0;
  for(const auto& singular : transitions.singular_vertices()) {
    sum += singular.second;
    CHECK_IN(context, std::find(cones.begin(), cones.end(), singular.first) != cones.end());
  }
  CHECK_IN(context, sum == 8);
  CHECK_IN(context, transitions.singular_vertices().size() == cones.size());

  test_meshes::Named_mesh<Kernel> named{ context, false, mesh };
  const auto snapped = snap_and_check(named, context);
  CHECK_IN(context, snapped.report.status == SS::Outcome::SNAPPED);
  CHECK_IN(context, snapped.report.largest_change <= 1e-12 * snapped.report.extent);
  std::cout << context << ": violation " << snapped.report.violation_before << ", change "
            << snapped.report.largest_change << std::endl;

  const auto report = CGAL::Seamless_snapping::snap_to_seamless(mesh, uv);
  CHECK_IN(context, report.status == snapped.report.status && SS::is_seamless(mesh, uv));
}

int main()
{
  const Floating_point_traps traps; // for all functions that are called
  std::cout.precision(3);
  for(unsigned int seed = 1; seed <= 10; ++seed) {
    test_orbifold(SMP::Square, 3, seed);
    test_orbifold(SMP::Parallelogram, 4, seed);
  }
  for(unsigned int seed = 1; seed <= 3; ++seed)
    test_free_border(seed);
  return report_checks();
}
