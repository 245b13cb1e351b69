// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_QUAD_EXTRACTOR_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_QUAD_EXTRACTOR_H

#include <CGAL/license/Seamless_snapping.h>

// From a chart mesh to the cells of the grid, step by step, with all checks. Nothing here depends
// on the mesh data structure.

#include <CGAL/Seamless_snapping/Extraction_report.h>
#include <CGAL/Seamless_snapping/internal/quads/cells_with_border.h>
#include <CGAL/Seamless_snapping/internal/quads/check_cells.h>
#include <CGAL/Seamless_snapping/internal/quads/measure_grid.h>
#include <CGAL/Seamless_snapping/internal/quads/pair_darts.h>
#include <CGAL/Seamless_snapping/internal/quads/Quad_complex.h>
#include <CGAL/Seamless_snapping/internal/tracing/nonpositive_faces.h>
#include <CGAL/Seamless_snapping/internal/tracing/remove_faces.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_transitions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

struct Extraction_options
{
  double scale = 1;
  std::size_t maximum_number = 100000000; // of quads
  bool allow_holes = false;
};

// More darts than this have no 32-bit index.
constexpr std::size_t largest_number_of_quads = std::size_t(1) << 28;

class Quad_extractor
{
public:
  // `is_feature` tells of corners whether their edge is one; or is empty. `vertex_name` is for
  // messages.
  Quad_extractor(Chart_mesh&& mesh, std::vector<char>&& is_feature,
                 const Extraction_options& options,
                 const std::function<std::string(std::size_t)>& vertex_name)
    : m_mesh(std::move(mesh)), m_is_feature(std::move(is_feature)), m_options(options),
      m_vertex_name(vertex_name)
  { }

  template <typename ConcurrencyTag>
  bool run()
  {
    return scale() && check_faces() && check_integers() && check_size() && measure_parts() &&
           make_cells<ConcurrencyTag>() && check_cells();
  }

  Extraction_report& report() { return m_report; }
  const Chart_mesh& mesh() const { return m_mesh; }
  const Quad_complex& complex() const { return *m_complex; }

  // The number of a face in the input.
  std::size_t original_face(const std::size_t f) const
  { return m_kept_faces.empty() ? f : std::size_t(m_kept_faces[f]); }

private:
  bool fail(const Extraction_status status, const std::string& message)
  {
    m_report.status = status;
    m_report.message = message;
    return false;
  }

  std::string edge_name(const Corner_index h) const
  {
    return "the edge from vertex " + m_vertex_name(m_mesh.source(h)) +
           " to vertex " + m_vertex_name(m_mesh.vertex(h));
  }

  // Exactly, or not at all.
  bool scale()
  {
    const double k = m_options.scale;
    if(!(k > 0 && std::isfinite(k)))
      return fail(Extraction_status::INVALID_ARGUMENT, "grid_scale must be positive and finite");
    for(std::size_t i = 0; i < m_mesh.corners.size(); ++i)
      for(double& u : m_mesh.corners[i].uv) {
        const double product = u * k;
        if(std::abs(product) > largest_grid_coordinate)
          return fail(Extraction_status::TOO_LARGE,
                      "a coordinate of vertex " + m_vertex_name(m_mesh.vertex(Corner_index(i))) +
                        " is beyond 2^46, where units can't be counted safely; move or shrink the "
                        "map");
        if(k != 1 && (std::fma(u, k, -product) != 0 || (u != 0 && std::abs(product) < 1e-200)))
          return fail(Extraction_status::INVALID_ARGUMENT,
                      "a coordinate of vertex " + m_vertex_name(m_mesh.vertex(Corner_index(i))) +
                        " can't be multiplied by grid_scale exactly; scale by a power of two, or "
                        "scale before the map is made exact, by snap_to_seamless() with "
                        "grid_scale");
        u = product;
      }
    if(k != 1)
      scale_transitions();
    return true;
  }

  void scale_transitions()
  {
    for(std::size_t i = 0; i < m_mesh.corners.size(); ++i) {
      const Corner_index h = Corner_index(i);
      if(m_mesh.corner(h).transition == no_index)
        continue;
      Chart_transition& t = m_mesh.transitions[std::size_t(m_mesh.corner(h).transition)];
      const Uv from = Quarter_turns::apply(t.rotation, m_mesh.uv(Chart_mesh::prev(h)));
      const Uv& to = m_mesh.uv(m_mesh.opposite(h));
      t.translation = {{Exact_difference(to[0], from[0]), Exact_difference(to[1], from[1])}};
    }
  }

  bool check_integers()
  {
    for(std::size_t i = 0; i < m_mesh.corners.size(); ++i) {
      const std::int32_t t = m_mesh.corners[i].transition;
      if(t == no_index)
        continue;
      for(const Exact_difference& d : m_mesh.transitions[std::size_t(t)].translation)
        if(!is_integer(d))
          return fail(Extraction_status::NOT_INTEGER,
                      "the translation across " + edge_name(Corner_index(i)) + " is " +
                        short_number(distance_to_integer(d)) + " off an integer" +
                        make_integer());
    }
    for(std::size_t v = 0; v < m_mesh.is_singular.size(); ++v)
      if(m_mesh.is_singular[v] && !check_cone(v))
        return false;
    for(std::size_t i = 0; i < m_is_feature.size(); ++i) {
      const Corner_index h = Corner_index(i);
      m_report.number_of_unaligned_features +=
        m_is_feature[i] && m_mesh.edge_key(h) == h && !is_on_grid_line(m_mesh, h) ? 1 : 0;
    }
    return true;
  }

  static std::string make_integer()
  {
    return "; call snap_to_seamless() with integer_grid(true) first";
  }

  bool check_cone(const std::size_t v)
  {
    const Cone_place place = cone_place(m_mesh, v);
    ++m_report.number_of_cones;
    m_report.number_of_cones_in_cells += place == Cone_place::IN_CELL ? 1 : 0;
    return place != Cone_place::ON_LINE ||
           fail(Extraction_status::NOT_INTEGER,
                "the cone at vertex " + m_vertex_name(v) + " lies on a line of the grid, but on no "
                "point of it" + make_integer() + ", or double the map: grid_scale(2)");
  }

  bool check_faces()
  {
    m_report.nonpositive_faces = nonpositive_faces(m_mesh);
    const std::vector<std::size_t>& faces = m_report.nonpositive_faces;
    if(faces.empty()) {
      const std::vector<char>& is_border = m_mesh.is_border;
      if(std::find(is_border.begin(), is_border.end(), true) != is_border.end())
        Fan_splitter(m_mesh).run();
      return true;
    }
    if(!m_options.allow_holes)
      return fail(Extraction_status::NOT_POSITIVE,
                  std::to_string(faces.size()) + (faces.size() == 1 ? " face is" : " faces are") +
                    " flipped or degenerate in the domain, the first is face " +
                    std::to_string(faces.front()) + "; repair them by snap_to_seamless() with "
                    "repair_flips(true), or leave out the cells around them: allow_holes(true)");
    const Face_remover remover(m_mesh, faces);
    Chart_mesh rest = remover.run();
    if(!m_is_feature.empty())
      for(std::size_t i = 0; i < rest.corners.size(); ++i)
        m_is_feature[i] = m_is_feature[std::size_t(3 * remover.kept()[i / 3]) + i % 3];
    m_kept_faces = remover.kept();
    m_mesh = std::move(rest);
    return true;
  }

  // Lines of the grid are counted where they cross edges: slivers can be long without any area.
  bool check_size()
  {
    m_report.area = area(m_mesh);
    double crossings = 0;
    for(std::size_t i = 0; i < m_mesh.corners.size(); ++i) {
      const Uv &a = m_mesh.uv(Chart_mesh::prev(Corner_index(i))), &b = m_mesh.uv(Corner_index(i));
      crossings += std::abs(b[0] - a[0]) + std::abs(b[1] - a[1]);
    }
    const double largest = double((std::min)(m_options.maximum_number, largest_number_of_quads));
    const bool has_too_many_quads = m_report.area > largest;
    if(!has_too_many_quads && crossings <= 16 * (largest + double(m_mesh.corners.size())))
      return true;
    return fail(Extraction_status::TOO_LARGE,
                has_too_many_quads
                  ? "there would be " + std::to_string(m_report.area) +
                    " quads; raise maximum_number, or shrink the map by grid_scale"
                  : "the lines of the grid would cross edges of the mesh " +
                    std::to_string(crossings / 2) + " times; shrink the map by grid_scale");
  }

  bool measure_parts()
  {
    m_parts = std::make_unique<Surface_parts>(m_mesh);
    Exact_rational twice_area{0};
    for(std::size_t i = 0; i < m_parts->size(); ++i) {
      twice_area += (*m_parts)[i].twice_area;
      m_report.number_of_unaligned_border_edges += (*m_parts)[i].number_of_unaligned_edges;
    }
    m_report.area = CGAL::to_double(twice_area) / 2;
    return true;
  }

  template <typename ConcurrencyTag>
  bool make_cells()
  {
    Lattice_points points = Lattice_points::make<ConcurrencyTag>(m_mesh);
    Grid_darts darts = Grid_darts::make<ConcurrencyTag>(m_mesh, points);
    const Dart_failure failure = pair_darts<ConcurrencyTag>(m_mesh, points, m_is_feature, darts);
    if(failure.is_obstacle)
      return fail(Extraction_status::NOT_INTEGER,
                  "a line of the grid meets vertex " + m_vertex_name(failure.vertex) +
                    ", which is a cone or a corner of the border, between two points of the grid" +
                    make_integer());
    if(failure)
      return fail(Extraction_status::INTERNAL_ERROR, "two darts have the same twin");
    m_complex = std::make_unique<Quad_complex>(m_mesh, std::move(points), std::move(darts));
    return true;
  }

  bool check_cells()
  {
    leave_out_cut_cells();
    const std::vector<Cell_counts> counts =
      count_cells(m_complex->points, m_complex->darts, m_complex->cells, *m_parts);
    bool is_area_right = true;
    const std::size_t part = first_bad_part(*m_parts, counts, is_area_right);
    if(part < m_parts->size()) {
      const bool may_be_coarse = is_area_right || counts[part].points == 0;
      return fail(may_be_coarse ? Extraction_status::TOO_COARSE : Extraction_status::INTERNAL_ERROR,
                  "the part of the surface that face " +
                    std::to_string(original_face((*m_parts)[part].first_face)) + " belongs to " +
                    (may_be_coarse ? "is too small for the grid; scale the map up by grid_scale"
                                   : "has cells of the wrong area"));
    }
    if(!check_valences())
      return fail(Extraction_status::INTERNAL_ERROR, "a vertex has a wrong number of darts");
    for(std::size_t c = 0; c < m_complex->cells.size(); ++c)
      m_report.number_of_other_polygons += m_complex->cells.degree(c) != 4 ? 1 : 0;
    m_report.number_of_faces = m_complex->cells.size();
    return m_report.number_of_faces > 0 ||
           fail(Extraction_status::TOO_COARSE,
                "the surface holds no whole cell of the grid; scale the map up by grid_scale");
  }

  // Four darts at a regular vertex; at others, their number is that of quarter turns, of which the
  // rotations around the vertex know the number modulo 4.
  bool check_valences() const
  {
    for(std::size_t p = 0; p < m_complex->points.size(); ++p) {
      const Lattice_point& point = m_complex->points[p];
      const std::size_t n = m_complex->darts.degree(p), v = m_mesh.vertex(point.corner);
      if(point.place != Lattice_place::VERTEX || m_mesh.is_border[v])
        continue;
      Quarter_turns::Element turns = Quarter_turns::element(int(n));
      for_each_corner(m_mesh, v, [&](const Corner_index c)
                      { turns = Quarter_turns::compose(m_mesh.rotation(c), turns); });
      if((n == 4) == bool(m_mesh.is_singular[v]) || turns != Quarter_turns::identity())
        return false;
    }
    return true;
  }

  void leave_out_cut_cells()
  {
    m_report.number_of_cut_cells = m_complex->cells.number_of_cut_cells();
    if(m_report.number_of_unaligned_border_edges == 0)
      return;
    const std::vector<char> is_cut = Border_cells(m_mesh, *m_complex).find();
    m_report.number_of_cut_cells += std::size_t(std::count(is_cut.begin(), is_cut.end(), true));
    m_complex->cells.remove(is_cut);
  }

  Chart_mesh m_mesh;
  std::vector<char> m_is_feature;
  Extraction_options m_options;
  std::function<std::string(std::size_t)> m_vertex_name;
  Extraction_report m_report;
  std::vector<std::int32_t> m_kept_faces; // empty: all
  std::unique_ptr<Surface_parts> m_parts;
  std::unique_ptr<Quad_complex> m_complex;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_QUADS_QUAD_EXTRACTOR_H
