#include "closing.h"

#include "Surface_soup.h"
#include "Topology.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

struct Triangulation_visitor : public PMP::Triangulate_faces::Default_visitor<Mesh>
{
  explicit Triangulation_visitor(std::vector<std::size_t>& file_faces) : m_file_faces(&file_faces)
  { }

  void before_subface_creations(const Mesh::Face_index f) { m_of = (*m_file_faces)[f]; }

  void after_subface_created(const Mesh::Face_index f)
  {
    m_file_faces->resize((std::max)(m_file_faces->size(), std::size_t(f) + 1));
    (*m_file_faces)[f] = m_of;
  }

private:
  std::vector<std::size_t>* m_file_faces; // visitors are copied
  std::size_t m_of = 0;
};

// Whether a face crosses or touches itself, seen along its normal.
bool meets_itself(const Mesh& mesh, const Mesh::Face_index f)
{
  using Plane_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const Kernel::Vector_3 n = PMP::compute_face_normal(f, mesh);
  if(n == CGAL::NULL_VECTOR)
    return false;
  const Kernel::Vector_3 u =
    CGAL::cross_product(n, n.x() * n.x() < 0.5 ? Kernel::Vector_3(1, 0, 0)
                                               : Kernel::Vector_3(0, 1, 0));
  const Kernel::Vector_3 v = CGAL::cross_product(n, u);
  std::vector<Plane_kernel::Point_2> corners;
  for(const auto w : mesh.vertices_around_face(mesh.halfedge(f))) {
    const Kernel::Vector_3 p = mesh.point(w) - CGAL::ORIGIN;
    corners.emplace_back(p * u, p * v);
  }
  return !CGAL::is_simple_2(corners.begin(), corners.end());
}

// The edges that have the same two ends as another edge.
std::vector<Edge> double_edges(const Mesh& mesh)
{
  using Ends = std::pair<Mesh::Vertex_index, Mesh::Vertex_index>;
  std::vector<std::pair<Ends, Edge> > edges;
  for(const Edge e : mesh.edges())
    edges.emplace_back(std::minmax(mesh.vertex(e, 0), mesh.vertex(e, 1)), e);
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> result;
  for(std::size_t i = 0; i < edges.size(); ++i)
    if((i > 0 && edges[i - 1].first == edges[i].first) ||
       (i + 1 < edges.size() && edges[i + 1].first == edges[i].first))
      result.push_back(edges[i].second);
  return result;
}

// Whether an edge divides a face of the file.
bool is_diagonal(const Edge e, const Model& model)
{
  const Halfedge h = model.mesh.halfedge(e), g = model.mesh.opposite(h);
  return !model.mesh.is_border(e) &&
         model.file_faces[model.mesh.face(h)] == model.file_faces[model.mesh.face(g)];
}

// Whether the other diagonal of the two triangles at an edge lies inside them, and no edge has the
// same ends yet.
bool may_flip(const Edge e, const Mesh& mesh)
{
  const Halfedge h = mesh.halfedge(e), g = mesh.opposite(h);
  const auto a = mesh.source(h), b = mesh.target(h);
  const auto c = mesh.target(mesh.next(h)), d = mesh.target(mesh.next(g));
  if(c == d || mesh.halfedge(c, d) != Mesh::null_halfedge())
    return false;
  const auto normal = [&](const auto u, const auto v, const auto w) {
    return CGAL::cross_product(mesh.point(v) - mesh.point(u), mesh.point(w) - mesh.point(u));
  };
  const Kernel::Vector_3 n = normal(a, b, c) + normal(b, a, d);
  return normal(c, d, b) * n > 0 && normal(d, c, a) * n > 0;
}

// A vertex in the middle of an edge is joined to the corners on both sides.
void split(const Edge e, Model& model)
{
  Mesh& mesh = model.mesh;
  const Halfedge h = mesh.halfedge(e);
  const auto source = mesh.source(h), target = mesh.target(h);
  const std::size_t of_file = model.file_faces[mesh.face(h)];
  const Halfedge first = CGAL::Euler::split_edge(h, mesh); // from the source to the new vertex
  mesh.point(mesh.target(first)) = CGAL::midpoint(mesh.point(source), mesh.point(target));
  model.file_vertices.push_back(model.file_vertices[source]);
  for(const Halfedge g : {first, mesh.prev(mesh.opposite(first))}) {
    CGAL::Euler::split_face(g, mesh.next(mesh.next(g)), mesh);
    model.file_faces.push_back(of_file);
  }
}

// Two faces that meet at a vertex of their own, and faces around narrow tunnels, can get diagonals
// with the same ends, which no file of triangles can tell apart. Each is replaced by the other
// diagonal of its triangles if that lies inside of them; those that are left are split. Returns how
// many are split.
std::size_t replace_double_diagonals(Model& model)
{
  std::size_t number = 0;
  while(true) {
    std::vector<Edge> diagonals = double_edges(model.mesh);
    diagonals.erase(std::remove_if(diagonals.begin(), diagonals.end(),
                                   [&](const Edge e) { return !is_diagonal(e, model); }),
                    diagonals.end());
    if(diagonals.empty())
      return number;
    bool has_flipped = false;
    for(const Edge e : diagonals)
      if(may_flip(e, model.mesh)) {
        CGAL::Euler::flip_edge(model.mesh.halfedge(e), model.mesh);
        has_flipped = true;
      }
    if(has_flipped)
      continue;
    for(const Edge e : diagonals)
      split(e, model);
    number += diagonals.size();
  }
}

} // namespace

void triangulate(const Polygon_soup& soup, Model& model, Repairs& repairs)
{
  const Size_near_one size(model.mesh);
  for(const auto f : model.mesh.faces()) {
    repairs.triangulated_faces += model.mesh.degree(f) > 3 ? 1 : 0;
    if(model.mesh.degree(f) > 4 && meets_itself(model.mesh, f)) // no triangulation ends well there
      refuse(soup, model.file_faces[f], "the face has more than 4 corners, and meets itself");
  }
  PMP::triangulate_faces(model.mesh, CGAL::parameters::visitor(
                                       Triangulation_visitor(model.file_faces)));
  if(repairs.triangulated_faces > 0)
    repairs.split_diagonals = replace_double_diagonals(model);
  for(const auto f : model.mesh.faces())
    if(model.mesh.degree(f) > 3)
      refuse(soup, model.file_faces[f], "the face has more than 3 corners, and no area, so that it "
                                        "can't be triangulated");
}

// Holes of few edges are filled by the best of all triangulations, which takes the third power of
// their number: seconds for the most. Others are filled by triangles of the Delaunay triangulation,
// which may take CGAL for ever if the border lies on a grid.
void fill_holes(const std::size_t most_edges, Model& model, Repairs& repairs)
{
  constexpr std::size_t few = 500; // edges
  Mesh& mesh = model.mesh;
  const Size_near_one size(mesh);
  for(const Halfedge h : border_loops(mesh)) {
    const auto around = CGAL::halfedges_around_face(h, mesh);
    const auto number_of_edges = std::size_t(std::distance(around.begin(), around.end()));
    if(number_of_edges > most_edges)
      continue;
    const std::size_t of_file = model.file_faces[mesh.face(mesh.opposite(h))];
    std::vector<Mesh::Face_index> faces;
    PMP::triangulate_hole(
      mesh, h, std::back_inserter(faces),
      CGAL::parameters::use_delaunay_triangulation(number_of_edges > few));
    model.file_faces.resize(mesh.number_of_faces(), of_file); // as the neighbors, for attributes
    repairs.filled_holes += faces.empty() ? 0 : 1;
    repairs.faces_of_filled_holes += faces.size();
  }
}
