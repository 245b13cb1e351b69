// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SURFACE_TO_REMESH_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SURFACE_TO_REMESH_H

#include <CGAL/license/Quad_remeshing.h>

// The surface that quads are to cover, with its features: a copy of the input, as some faces have
// to be split first.

#include <CGAL/Quad_remeshing/internal/cells/inverted_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Mirror.h>
#include <CGAL/Quad_remeshing/internal/remeshing/refine_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The types of surfaces to be remeshed and of their quads.
struct Remeshing_types
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Vertex = Mesh::Vertex_index;
  using Edge = Mesh::Edge_index;
  using Face = Mesh::Face_index;
  using Halfedge = Mesh::Halfedge_index;
  using Feature_map = Mesh::Property_map<Edge, bool>;
  using Quad = Quad_in_space;
};

// Invariant: no triangle with an area has three sides that are features or border, which no map
// without flips aligns. Such ones are divided into nine, and their neighbors so that there are
// triangles only. The copy is the input times a power of two, of a size near 1, so that squares of
// lengths are neither too large nor too small. With a mirror, it is the half above.
class Surface_to_remesh
  : public Remeshing_types
{
public:
  using Uv_map = Mesh::Property_map<Halfedge, Kernel::Point_2>;
  using Direction_map = Mesh::Property_map<Face, Kernel::Vector_3>;
  using Rotation_map = Mesh::Property_map<Halfedge, int>;
  using Sizing_map = Mesh::Property_map<Vertex, double>;

  // Fills in the mesh, its features, the directions of crosses, and the sizes of quads at vertices,
  // where these are not false, 0, and 1.
  using Reader = std::function<void(Mesh&, Feature_map, Direction_map, Sizing_map)>;

  // \param mirror on whose upper side the surface is to be
  Surface_to_remesh(const Reader& read, const std::optional<Mirror>& mirror)
    : m_mesh(), m_is_feature(m_mesh.add_property_map<Edge, bool>("e:is_feature", false).first),
      m_uv_map(m_mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first),
      m_directions(m_mesh.add_property_map<Face>("f:direction", Kernel::Vector_3(0, 0, 0)).first),
      m_is_cut(m_mesh.add_property_map<Edge, bool>("e:is_cut", false).first),
      m_rotations(m_mesh.add_property_map<Halfedge, int>("h:rotation", 0).first),
      m_sizes(m_mesh.add_property_map<Vertex, double>("v:size", 1).first)
  {
    read(m_mesh, m_is_feature, m_directions, m_sizes);
    scale();
    for(const Face f : m_mesh.faces())
      m_originals.push_back(std::size_t(f));
    if(!CGAL::is_triangle_mesh(m_mesh))
      return;
    if(mirror)
      keep_half(m_mirror.emplace(mirror->scaled(-m_exponent)));
    divide(std::vector<Face>(m_mesh.faces().begin(), m_mesh.faces().end()));
  }

  Surface_to_remesh(const Surface_to_remesh&) = delete; // the maps belong to the mesh
  Surface_to_remesh& operator=(const Surface_to_remesh&) = delete;

  // Divides long triangles, and large ones unless these are to stay; returns whether there are any.
  bool refine(const bool has_large_faces)
  {
    return CGAL::is_triangle_mesh(m_mesh) &&
           Surface_refiner(m_mesh, has_large_faces, m_is_feature, m_directions, m_sizes,
                           m_originals).run();
  }

  const Mesh& mesh() const { return m_mesh; }
  Feature_map is_feature() const { return m_is_feature; }
  Uv_map uv_map() const { return m_uv_map; }
  Direction_map directions() const { return m_directions; }
  Feature_map is_cut() const { return m_is_cut; }
  Rotation_map rotations() const { return m_rotations; }
  Sizing_map sizes() const { return m_sizes; }

  bool has_sizes_that_vary() const
  {
    return std::adjacent_find(m_sizes.begin(), m_sizes.end(), std::not_equal_to<>()) !=
           m_sizes.end();
  }

  // In the scale of the mesh, which is on its upper side.
  const std::optional<Mirror>& mirror() const { return m_mirror; }

  // A length in the size of the input.
  double unscaled(const double x) const { return std::ldexp(x, m_exponent); }

  double scaled(const double x) const { return std::ldexp(x, -m_exponent); }

  // In the scale of the mesh, without over- and underflow.
  double length(const Halfedge h) const
  {
    const auto edge = m_mesh.point(m_mesh.target(h)) - m_mesh.point(m_mesh.source(h));
    return std::hypot(edge.x(), edge.y(), edge.z());
  }

  double length_of_features() const
  {
    double sum = 0;
    for(const Edge e : m_mesh.edges())
      if(m_is_feature[e])
        sum += length(m_mesh.halfedge(e));
    return unscaled(sum);
  }

  // The number of a face in the input.
  std::size_t original(const std::size_t face) const { return m_originals[face]; }

private:
  void scale()
  {
    double size = 0;
    for(const auto v : m_mesh.vertices())
      for(int c = 0; c < 3; ++c)
        size = (std::max)(size, std::abs(m_mesh.point(v)[c]));
    if(!(size > 0 && std::isfinite(size)))
      return;
    m_exponent = std::ilogb(size);
    const auto scaled = [&](const double x) { return std::ldexp(x, -m_exponent); };
    for(const auto v : m_mesh.vertices()) {
      Kernel::Point_3& p = m_mesh.point(v);
      p = Kernel::Point_3(scaled(p.x()), scaled(p.y()), scaled(p.z()));
    }
  }

  // Keeps nothing of a surface that meets itself along the plane.
  void keep_half(const Mirror& mirror)
  {
    const Half_surface half(m_mesh, m_is_feature, mirror);
    std::vector<std::pair<Kernel::Point_3, double> > vertices;
    for(const Half_surface::Place& p : half.places())
      vertices.emplace_back(half.point(p),
                            (1 - p.t) * m_sizes[p.source] + p.t * m_sizes[p.target]);
    std::vector<Kernel::Vector_3> directions;
    for(const Half_surface::Triangle& t : half.triangles())
      directions.push_back(m_directions[t.face]);
    m_mesh.clear_without_removing_property_maps();
    m_originals.clear();
    for(const auto& [point, size] : vertices)
      m_sizes[m_mesh.add_vertex(point)] = size;
    for(const Half_surface::Triangle& t : half.triangles()) {
      std::array<Vertex, 3> v;
      for(std::size_t i = 0; i < 3; ++i)
        v[i] = Vertex(Mesh::size_type(t.vertices[i]));
      const Face f = m_mesh.add_face(v[0], v[1], v[2]);
      if(f == Mesh::null_face()) {
        m_mesh.clear_without_removing_property_maps();
        return;
      }
      m_directions[f] = directions[m_originals.size()];
      m_originals.push_back(std::size_t(t.face));
      for(std::size_t i = 0; i < 3; ++i)
        if(t.is_feature[i])
          m_is_feature[m_mesh.edge(m_mesh.halfedge(v[i], v[(i + 1) % 3]))] = true;
    }
  }

  // Divides all sides of the triangles with three aligned sides, and the edges of tips, into three
  // parts, and leads edges from the centers of all faces around to their corners.
  void divide(const std::vector<Face>& faces)
  {
    const auto area = [&](const Face f) {
      const Halfedge h = m_mesh.halfedge(f);
      return std::sqrt(CGAL::squared_area(m_mesh.point(m_mesh.source(h)),
                                          m_mesh.point(m_mesh.target(h)),
                                          m_mesh.point(m_mesh.target(m_mesh.next(h)))));
    };
    double square = 0;
    for(const Face f : faces)
      square += area(f) / Surface_refiner::number_of_squares;
    const double least_length = 3 * std::sqrt(square); // thirds would be small against quads
    std::set<Edge> sides;
    for(const Face f : faces) {
      if(!has_area(f) ||
         (is_half_of_quad(m_mesh, [&](const Halfedge h) { return is_aligned(h); }, f) &&
          area(f) < Surface_refiner::squares_of_half * square))
        continue;
      const bool has_aligned_sides = has_aligned_sides_only(f);
      for(const Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f))) {
        if(has_aligned_sides || is_side_opposite_to_flat_corner(h))
          sides.insert(m_mesh.edge(h));
        else if(is_aligned(h) && CGAL::squared_distance(m_mesh.point(m_mesh.source(h)),
                                                        m_mesh.point(m_mesh.target(h))) >
                                   least_length * least_length)
          insert_edges_of_tip(h, sides);
      }
    }
    for(const Edge e : sides)
      divide_side(e);
    for(const Face f : faces)
      if(m_mesh.degree(f) > 3)
        divide_at_center(f);
  }

  bool is_aligned(const Halfedge h) const
  { return m_is_feature[m_mesh.edge(h)] || m_mesh.is_border(m_mesh.edge(h)); }

  bool has_aligned_sides_only(const Face f) const
  {
    const auto sides = m_mesh.halfedges_around_face(m_mesh.halfedge(f));
    return std::all_of(sides.begin(), sides.end(), [&](const Halfedge h) { return is_aligned(h); });
  }

  // Whether the two other sides are aligned, and nearly one straight line: they can't be on the
  // same isocurve where they are sides of one face.
  bool is_side_opposite_to_flat_corner(const Halfedge h) const
  {
    constexpr double flat = 135; // degrees: nearer to two quarter turns than to one
    const Halfedge next = m_mesh.next(h), previous = m_mesh.prev(h);
    return is_aligned(next) && is_aligned(previous) &&
           CGAL::approximate_angle(m_mesh.point(m_mesh.source(next)),
                                   m_mesh.point(m_mesh.target(next)),
                                   m_mesh.point(m_mesh.target(previous))) > flat;
  }

  // Where a narrow sector of faces begins at `h`, whose target is between features or border: the
  // field is opened there, which is to be far from the other ends of the edges.
  void insert_edges_of_tip(Halfedge h, std::set<Edge>& sides) const
  {
    std::vector<Edge> edges{m_mesh.edge(h)};
    double angle = 0;
    do {
      const Halfedge next = m_mesh.next(h);
      angle += CGAL::approximate_angle(m_mesh.point(m_mesh.source(h)),
                                       m_mesh.point(m_mesh.target(h)),
                                       m_mesh.point(m_mesh.target(next)));
      edges.push_back(m_mesh.edge(next));
      h = m_mesh.opposite(next);
    } while(!is_aligned(h) && angle < narrow_tip);
    if(angle < narrow_tip)
      sides.insert(edges.begin(), edges.end());
  }

  bool has_area(const Face f) const
  {
    const Halfedge h = m_mesh.halfedge(f);
    return !CGAL::collinear(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h)),
                            m_mesh.point(m_mesh.target(m_mesh.next(h))));
  }

  void divide_side(const Edge e)
  {
    const Halfedge h = m_mesh.halfedge(e);
    const Kernel::Point_3 first = m_mesh.point(m_mesh.source(h));
    const Kernel::Vector_3 third = (m_mesh.point(m_mesh.target(h)) - first) / 3;
    const double size = m_sizes[m_mesh.source(h)];
    const double third_of_size = (m_sizes[m_mesh.target(h)] - size) / 3;
    for(const int i : {1, 2}) {
      const Halfedge part = CGAL::Euler::split_edge(h, m_mesh);
      m_mesh.point(m_mesh.target(part)) = first + i * third;
      m_sizes[m_mesh.target(part)] = size + i * third_of_size;
      m_is_feature[m_mesh.edge(part)] = bool(m_is_feature[e]);
    }
  }

  void divide_at_center(const Face f)
  {
    const double n = static_cast<double>(m_mesh.degree(f));
    std::array<double, 3> center{};
    double size = 0, count = 0; // the mean of equal sizes is exact: they are not to vary
    for(const auto v : m_mesh.vertices_around_face(m_mesh.halfedge(f))) {
      for(int c = 0; c < 3; ++c)
        center[std::size_t(c)] += m_mesh.point(v)[c] / n;
      size += (m_sizes[v] - size) / ++count;
    }
    const Halfedge h = CGAL::Euler::add_center_vertex(m_mesh.halfedge(f), m_mesh);
    m_mesh.point(m_mesh.target(h)) = Kernel::Point_3(center[0], center[1], center[2]);
    m_sizes[m_mesh.target(h)] = size;
    const std::size_t original = m_originals[f];
    m_originals.resize(m_mesh.number_of_faces(), original);
    for(const Halfedge g : m_mesh.halfedges_around_target(h))
      m_directions[m_mesh.face(g)] = m_directions[f];
  }

  static constexpr double narrow_tip = 50; // degrees, as `parametrization::narrow_sector`

  Mesh m_mesh;
  Feature_map m_is_feature;
  Uv_map m_uv_map;
  Direction_map m_directions;
  Feature_map m_is_cut;     // these two are known once there are coordinates
  Rotation_map m_rotations;
  Sizing_map m_sizes;
  std::optional<Mirror> m_mirror;
  std::vector<std::size_t> m_originals; // per face
  int m_exponent = 0;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_SURFACE_TO_REMESH_H
