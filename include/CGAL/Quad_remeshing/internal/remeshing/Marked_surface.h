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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_MARKED_SURFACE_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_MARKED_SURFACE_H

#include <CGAL/license/Quad_remeshing.h>

// A triangle mesh with its features, and the directions and sizes of its quads.

#include <CGAL/Quad_remeshing/internal/cells/inverted_quads.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The types of surfaces to be remeshed and of their quads.
struct Remeshing_types
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_3;
  using Vector = Kernel::Vector_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Vertex = Mesh::Vertex_index;
  using Edge = Mesh::Edge_index;
  using Face = Mesh::Face_index;
  using Halfedge = Mesh::Halfedge_index;
  using Feature_map = Mesh::Property_map<Edge, bool>;
  using Quad = Quad_in_space;
};

inline bool has_finite_points(const Remeshing_types::Mesh& mesh)
{
  return std::all_of(mesh.points().begin(), mesh.points().end(), [](const auto& p)
    { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); });
}

// The angle of a face at the target of a halfedge, in degrees.
inline double angle_to_next(const Remeshing_types::Mesh& mesh, const Remeshing_types::Halfedge h)
{
  return CGAL::approximate_angle(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                 mesh.point(mesh.target(mesh.next(h))));
}

// Between walls, in degrees: nearer to two quarter turns than to one.
constexpr double flat_corner = 135; // degrees; a larger angle is no corner

// A mesh, and what is known of its elements. Vertices that are added on edges get the size in
// between, and parts of edges and faces what is known of these.
struct Marked_surface
  : public Remeshing_types
{
  using Sizing_map = Mesh::Property_map<Vertex, double>;

  Marked_surface() = default;
  // The maps belong to the mesh: the copy finds its own maps again.
  Marked_surface(const Marked_surface& other)
    : mesh(other.mesh), directions(other.directions), originals(other.originals)
  { }
  Marked_surface& operator=(const Marked_surface&) = delete;

  // An edge that quads follow.
  bool is_wall(const Halfedge h) const
  { return is_feature[mesh.edge(h)] || mesh.is_border(mesh.edge(h)); }

  // Whether a triangle is half of a quad between walls: a rectangle in the map if it is not
  // divided, because there is no room for cones.
  bool is_half_of_quad(const Face f) const
  {
    const Halfedge inner = only_inner_side(mesh.halfedge(f));
    return inner != Mesh::null_halfedge() &&
           only_inner_side(mesh.opposite(inner)) == mesh.opposite(inner);
  }

  // Returns the new halfedge to the new vertex; `h` goes on from there.
  Halfedge split_edge(const Halfedge h, const Point& point, const double size)
  {
    const Halfedge part = CGAL::Euler::split_edge(h, mesh);
    mesh.point(mesh.target(part)) = point;
    sizes[mesh.target(part)] = size;
    is_feature[mesh.edge(part)] = bool(is_feature[mesh.edge(h)]);
    return part;
  }

  // The direction of crosses in a face; 0 where none is given.
  Vector direction(const Face f) const
  { return directions ? (*directions)[originals[std::size_t(f)]] : Vector(0, 0, 0); }

  // To be called for each face that is added: the next one is a part of `whole`.
  void mark_part_of(const Face whole)
  { originals.push_back(std::size_t(originals[std::size_t(whole)])); }

  Mesh mesh;
  Feature_map is_feature = mesh.add_property_map<Edge, bool>("e:is_feature", false).first;
  // of quads, in a unit of their own
  Sizing_map sizes = mesh.add_property_map<Vertex, double>("v:size", 1).first;
  // of crosses, per face of the input; null if all are 0
  std::shared_ptr<const std::vector<Vector> > directions;
  // per face: the number of the one of the input that it is a part of
  std::vector<std::size_t> originals;

private:
  // Null if there is none or another one.
  Halfedge only_inner_side(const Halfedge first) const
  {
    Halfedge result = Mesh::null_halfedge();
    for(const Halfedge h : mesh.halfedges_around_face(first))
      if(!is_wall(h)) {
        if(result != Mesh::null_halfedge())
          return Mesh::null_halfedge();
        result = h;
      }
    return result;
  }
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_MARKED_SURFACE_H
