#include "Topology.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

struct Figure
{
  const char* name;
  std::ptrdiff_t of_input, of_quads;
};

std::vector<Figure> figures(const Topologies& t)
{
  return {{"parts", std::ptrdiff_t(t.of_input.number_of_parts),
           std::ptrdiff_t(t.of_quads.number_of_parts)},
          {"border loops", std::ptrdiff_t(t.of_input.number_of_border_loops),
           std::ptrdiff_t(t.of_quads.number_of_border_loops)},
          {"the Euler characteristic", t.of_input.euler_characteristic,
           t.of_quads.euler_characteristic}};
}

nlohmann::json json_of(const Topology& topology)
{
  return {{"parts", topology.number_of_parts},
          {"border_loops", topology.number_of_border_loops},
          {"euler_characteristic", topology.euler_characteristic}};
}

} // namespace

std::vector<Halfedge> border_loops(const Mesh& mesh)
{
  std::vector<Halfedge> loops;
  std::vector<bool> is_known(mesh.num_halfedges());
  for(const Halfedge h : mesh.halfedges()) {
    if(!mesh.is_border(h) || is_known[h])
      continue;
    loops.push_back(h);
    for(const Halfedge next : CGAL::halfedges_around_face(h, mesh))
      is_known[next] = true;
  }
  return loops;
}

Topology::Topology(const Mesh& mesh)
  : number_of_border_loops(border_loops(mesh).size())
{
  std::vector<std::size_t> part(mesh.num_faces());
  number_of_parts = PMP::connected_components(
    mesh, boost::make_iterator_property_map(part.begin(), get(boost::face_index, mesh)));
  const auto vertices = std::count_if(mesh.vertices_begin(), mesh.vertices_end(),
                                      [&](const auto v) { return !mesh.is_isolated(v); });
  euler_characteristic =
    vertices - std::ptrdiff_t(mesh.number_of_edges()) + std::ptrdiff_t(mesh.number_of_faces());
}

std::string note(const Topologies& topologies, const std::string& cause)
{
  std::string result;
  for(const Figure& f : figures(topologies))
    if(f.of_input != f.of_quads)
      result += (result.empty() ? "note: " + cause + " changes " : ", ") + std::string(f.name) +
                " from " + std::to_string(f.of_input) + " to " + std::to_string(f.of_quads);
  return result.empty() ? result : result + "\n";
}

nlohmann::json json_of(const std::optional<Topologies>& topologies)
{
  if(!topologies)
    return nullptr;
  return {{"of_input", json_of(topologies->of_input)}, {"of_quads", json_of(topologies->of_quads)}};
}

std::size_t number_of_irregular_vertices(const Mesh& quads)
{
  return std::size_t(
    std::count_if(quads.vertices_begin(), quads.vertices_end(),
                  [&](const auto v) { return !quads.is_border(v) && quads.degree(v) != 4; }));
}
