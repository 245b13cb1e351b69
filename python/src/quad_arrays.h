// A mesh of quads, and the arrays that it goes to Python as.

#ifndef SEAMLESS_SNAPPING_PYTHON_QUAD_ARRAYS_H
#define SEAMLESS_SNAPPING_PYTHON_QUAD_ARRAYS_H

#include "Array_surface.h"

#include <array>
#include <cstdint>
#include <vector>

struct Quad_arrays
{
  Quad_arrays(const Mesh& mesh, const Edge_bool_map& is_feature)
  {
    std::vector<std::int64_t> number(mesh.num_vertices(), 0);
    for(const auto v : mesh.vertices()) {
      number[v] = std::int64_t(points.size());
      const Kernel::Point_3& p = mesh.point(v);
      points.push_back({{p.x(), p.y(), p.z()}});
    }
    for(const auto f : mesh.faces()) {
      std::vector<std::int64_t> corners;
      for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
        corners.push_back(number[v]);
      if(corners.size() == 4)
        polygons.push_back({{corners[0], corners[1], corners[2], corners[3]}});
      else
        others.push_back(corners);
    }
    for(const auto e : mesh.edges())
      if(is_feature[e])
        features.push_back({{number[mesh.vertex(e, 0)], number[mesh.vertex(e, 1)]}});
  }

  std::vector<std::array<double, 3> > points;
  std::vector<std::array<std::int64_t, 4> > polygons;
  std::vector<std::vector<std::int64_t> > others; // around cones between the lines of the grid
  std::vector<std::array<std::int64_t, 2> > features;
};

#endif // SEAMLESS_SNAPPING_PYTHON_QUAD_ARRAYS_H
