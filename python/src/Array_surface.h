// A mesh made of arrays: triangles, and what hangs on their corners and vertices.

#ifndef SEAMLESS_SNAPPING_PYTHON_ARRAY_SURFACE_H
#define SEAMLESS_SNAPPING_PYTHON_ARRAY_SURFACE_H

#include "arrays.h"
#include "maps/surface_types.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

// Copies of the caller's arrays; those that were not passed are empty. Numbers of vertices are rows
// of `points` if there are any.
struct Surface_arrays
{
  Surface_arrays(const Integers& triangles, const std::optional<Doubles>& points,
                 const std::optional<Doubles>& uv, const std::optional<Integers>& features);

  std::size_t number_of_triangles() const { return triangles.size() / 3; }
  std::size_t number_of_features() const { return features.size() / 2; }

  std::vector<std::int64_t> triangles, features;
  std::vector<double> points, uv;
};

// Face i is triangle i. Vertices are in the order of the rows that have faces. If the faces around a
// row form several fans, each further fan has a vertex of its own, after all others.
class Array_surface
{
public:
  // Throws `Refused` if the triangles are no oriented surface, or a feature is no edge.
  // \param arrays are freed
  // \param weld whether border edges are joined that lie in the same place
  explicit Array_surface(Surface_arrays&& arrays, bool weld = false);
  Array_surface(const Array_surface&) = delete;
  Array_surface& operator=(const Array_surface&) = delete;

  Mesh mesh;
  Uv_map uv_map = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  Edge_bool_map is_feature = mesh.add_property_map<Edge, bool>("e:feature", false).first;

  std::size_t row(const Mesh::Vertex_index v) const { return m_rows[std::size_t(v)]; }
  // Points to corner `k` of a triangle.
  Halfedge corner(const std::size_t triangle, const std::size_t k) const
  { return m_corners[3 * triangle + k]; }
  std::size_t number_of_corner(const std::size_t triangle, const Halfedge h) const
  { return corner(triangle, 0) == h ? 0 : corner(triangle, 1) == h ? 1 : 2; }
  // Barycentric coordinates in the order of a triangle's row, from those that begin with the source
  // of its first halfedge.
  std::array<double, 3>
  in_order_of_row(const std::pair<Mesh::Face_index, std::array<double, 3> >& location) const
  {
    const auto& [f, w] = location;
    const std::size_t k = number_of_corner(std::size_t(f), mesh.prev(mesh.halfedge(f)));
    return {{w[(3 - k) % 3], w[(4 - k) % 3], w[(5 - k) % 3]}};
  }
  std::size_t number_of_triangles() const { return m_corners.size() / 3; }

  const std::vector<std::size_t>& rows() const { return m_rows; }
  std::size_t number_of_coinciding_border_edges() const
  { return m_number_of_coinciding_border_edges; }

  // Marks border edges as features, too.
  void add_border();
  // Exchanges u and v if most of the area is flipped in the plane.
  void turn_if_mirrored();
  bool is_mirrored() const { return m_is_mirrored; }
  // The coordinates of all corners, as the caller has them.
  void write_uv(double* uv) const;

private:
  std::size_t m_number_of_coinciding_border_edges = 0;
  bool m_is_mirrored = false; // u and v are exchanged here
  std::vector<std::size_t> m_rows; // per vertex
  std::vector<Halfedge> m_corners;
};

// The rows of vertices, for messages; nothing if each vertex is its row.
std::vector<std::size_t> renamed(const std::vector<std::size_t>& rows);

#endif // SEAMLESS_SNAPPING_PYTHON_ARRAY_SURFACE_H
