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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUANTIZE_SURFACE_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUANTIZE_SURFACE_H

#include <CGAL/license/Quad_remeshing.h>

// From the faces of a map to its quantization.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Quad_remeshing/internal/cells/Surface_parts.h>
#include <CGAL/Quad_remeshing/internal/quantization/Integer_mesh.h>
#include <CGAL/Quad_remeshing/internal/quantization/Intrinsic_complex.h>
#include <CGAL/Quad_remeshing/internal/support/Work.h>
#include <CGAL/Quad_remeshing/types/Quantization.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Border edges that lie on no isocurve. Outside of each, a triangle with a right angle is added,
// whose two other edges lie on isocurves; in space, it lies on the edge. So the border of the quads
// consists of isocurves, and is the border of the surface nevertheless.
class Border_steps
{
public:
  // Edges that are nearly on an isocurve are meant to be on it. Their steps would be so low that
  // they force quads that nobody wants.
  static constexpr double least_slope = 1e-4; // the slope of a border edge that is not aligned

  static bool is_needed(const Integer_mesh& mesh, const Corner_index h)
  {
    const Grid_vector& v = mesh.corner(h).vector;
    return mesh.is_border_edge(h) && v[0] != 0 && v[1] != 0;
  }

  static bool is_nearly_aligned(const Grid_vector& v)
  {
    const double x = std::abs(double(v[0])), y = std::abs(double(v[1]));
    return (std::min)(x, y) < least_slope * (std::max)(x, y);
  }

  void add_to(Integer_mesh& mesh)
  {
    m_number_of_faces = std::size_t(mesh.number_of_faces());
    for(Corner_index h = 0, n = mesh.number_of_halfedges(); h < n; ++h)
      if(is_needed(mesh, h))
        add_step(mesh, h);
  }

  std::size_t number_of_faces_inside() const { return m_number_of_faces; }

  // The point as a point of the input.
  Face_point inside(const Face_point& at) const
  {
    if(std::size_t(at.face) < m_number_of_faces)
      return at;
    const Step& step = m_steps[std::size_t(at.face) - m_number_of_faces];
    return point_on_edge(step.edge, at.weights[2] + step.foot * at.weights[1]);
  }

private:
  struct Step
  {
    Corner_index edge;
    double foot; // of the height on the edge, from its source to its target
  };

  // The corners of the triangle are at the source of the edge, outside, and at the target.
  void add_step(Integer_mesh& mesh, const Corner_index h)
  {
    const std::size_t source = mesh.source(h);
    const Flat_vertex_index target = mesh.corner(h).vertex;
    const auto outside = Flat_vertex_index(mesh.number_of_vertices());
    const Grid_vector v = mesh.corner(h).vector;
    const bool is_first_along_u = (v[0] > 0) == (v[1] > 0); // so that it lies to the right
    const Grid_vector along_u{v[0], 0}, along_v{0, v[1]};
    const Corner_index first = mesh.number_of_halfedges();
    const auto add = [&](const Flat_vertex_index vertex, const Grid_vector& vector) {
      Integer_corner corner;
      corner.vertex = vertex;
      corner.vector = vector;
      corner.is_wall = mesh.number_of_halfedges() != first;
      mesh.corners.push_back(corner);
    };
    add(Flat_vertex_index(source), negated(v));
    add(outside, is_first_along_u ? along_u : along_v);
    add(target, is_first_along_u ? along_v : along_u);
    mesh.corners[std::size_t(first)].opposite = h;
    mesh.corners[std::size_t(h)].opposite = first;
    mesh.corners[std::size_t(h)].is_wall = false;
    mesh.corner_at_vertex[source] = first;
    mesh.corner_at_vertex.push_back(first + 1);
    mesh.is_border.push_back(true);
    mesh.part.push_back(mesh.part[std::size_t(h / 3)]);
    const double leg = double(v[is_first_along_u ? 0 : 1]) / std::hypot(double(v[0]), double(v[1]));
    m_steps.push_back({h, leg * leg});
  }

  std::size_t m_number_of_faces = 0;
  std::vector<Step> m_steps;
};

struct Quantization_options
{
  double number_of_quads = 0;
  double maximum_number = (std::numeric_limits<double>::max)(); // of quads; more are refused
  double maximum_feature_loss = 0; // the part of the features' length that may be released
  bool is_coarsest = false; // as few as are found
  bool needs_face_graph = false; // of more quads, if there is none of so many
  std::shared_ptr<Work> work = std::make_shared<Work>(); // that all searches share
};

// The data that do not depend on the wanted number of quads.
struct Coarse_surface
{
  Integer_mesh input;        // with the steps of the border
  Border_steps steps;
  Intrinsic_complex complex; // without units
};

// Invariant: the units of the complex are feasible.
struct Quantized_surface
{
  std::shared_ptr<const Coarse_surface> coarse;
  Intrinsic_complex complex;
  bool is_for_face_graph = false; // without the quads around vertices of one edge
};

// \param is_feature per corner, or empty
// \param vertex_name for messages
Quantization quantize_surface(const Chart_mesh& mesh, const std::vector<char>& is_feature,
                              const Quantization_options& options,
                              const std::function<Message(std::size_t)>& vertex_name);

// Quantizes the surface again, for another number of quads.
// \pre there is a quantization
Quantization quantize_again(const Quantization& quantization, const Quantization_options& options);

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#ifndef CGAL_SEAMLESS_SNAPPING_COMPILED
#include <CGAL/Quad_remeshing/internal/quantization/quantize_surface_impl.h>
#endif

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUANTIZE_SURFACE_H
