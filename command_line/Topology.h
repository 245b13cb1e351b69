// What a mesh of quads has in common with the surface that it stands for, or has lost.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_TOPOLOGY_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_TOPOLOGY_H

#include "Model.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// A halfedge of each closed sequence of border edges. CGAL's own function has another name and place
// from CGAL 6.2 on.
std::vector<Halfedge> border_loops(const Mesh& mesh);

struct Topology
{
  explicit Topology(const Mesh& mesh);

  std::size_t number_of_parts, number_of_border_loops;
  std::ptrdiff_t euler_characteristic;
};

// Of a surface, and of the quads that were made of it.
struct Topologies
{
  Topology of_input, of_quads;
};

// In what they differ, after `cause`; else nothing.
std::string note(const Topologies& topologies, const std::string& cause);

nlohmann::json json_of(const std::optional<Topologies>& topologies);

// Vertices inside that have other than four edges.
std::size_t number_of_irregular_vertices(const Mesh& quads);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_TOPOLOGY_H
