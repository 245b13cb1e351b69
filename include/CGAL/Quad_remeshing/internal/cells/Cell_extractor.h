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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_CELL_EXTRACTOR_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_CELL_EXTRACTOR_H

#include <CGAL/license/Quad_remeshing.h>

// From a chart mesh to the cells of the grid, step by step, with all checks. Nothing here depends
// on the mesh data structure.

#include <CGAL/Isocurves_and_layouts/internal/charts/Chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Isocurves_and_layouts/internal/charts/remove_faces.h>
#include <CGAL/Linear_snapping/internal/exact/locale_free_decimals.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/cells/Cell_complex.h>
#include <CGAL/Quad_remeshing/internal/cells/Dart_tracer.h>
#include <CGAL/Quad_remeshing/internal/cells/Grid_cells.h>
#include <CGAL/Quad_remeshing/internal/cells/Surface_parts.h>
#include <CGAL/Quad_remeshing/types/Extraction_report.h>

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
namespace Quad_remeshing {
namespace internal {

// The theorem on the cells, checked exactly for each part of the surface whose border
// lies on the grid: as many corners as cells of its area have, and the surface's Euler
// characteristic.
struct Cell_counts
{
  std::ptrdiff_t points = 0, darts = 0, cells = 0;
  std::size_t corners = 0, open_darts = 0; // corners of cells

  std::ptrdiff_t euler_characteristic() const { return points - darts / 2 + cells; }

  Cell_counts& operator+=(const Cell_counts& more)
  {
    points += more.points;
    darts += more.darts;
    cells += more.cells;
    corners += more.corners;
    open_darts += more.open_darts;
    return *this;
  }
};

inline void add_point(const Grid_darts& darts, const Grid_cells& cells, const std::size_t p,
                      Cell_counts& c)
{
  ++c.points;
  for(std::size_t d = darts.first(p); d < darts.first(p + 1); ++d) {
    ++c.darts;
    c.open_darts += darts.twins[d] < 0 ? 1 : 0;
    if(cells.cell(d) == no_cell)
      continue;
    ++c.corners;
    c.cells += cells.first_dart(std::size_t(cells.cell(d))) == d ? 1 : 0;
  }
}

template <typename ConcurrencyTag>
std::vector<Cell_counts> count_cells(const Lattice_points& points, const Grid_darts& darts,
                                     const Grid_cells& cells, const Surface_parts& parts)
{
  return sums_of_parts<Cell_counts, ConcurrencyTag>(
    points.size(), parts.size(),
    [&](const std::size_t p) { return parts.part_of_face(face_of(points[p].corner)); },
    [&](const std::size_t p, Cell_counts& counts) { add_point(darts, cells, p, counts); });
}

// The first part whose cells are not discs; or the number of parts. `is_area_right` tells whether
// that is all that is wrong there.
template <typename Group>
std::size_t first_bad_part(const Surface_parts& parts, const std::vector<Cell_counts>& counts,
                           bool& is_area_right)
{
  std::size_t i = 0;
  for(is_area_right = true; i < parts.size(); ++i) {
    const Surface_part& part = parts[i];
    const Cell_counts& count = counts[i];
    const Exact_rational corners(Cell_shape<Group>::corners_of_unit * part.twice_area / 2);
    if(part.number_of_unaligned_edges > 0) {
      is_area_right = corners >= Exact_rational(count.corners);
      if(!is_area_right)
        break;
      continue;
    }
    is_area_right = count.open_darts == 0 && corners == Exact_rational(count.corners);
    if(!is_area_right || count.euler_characteristic() != part.euler_characteristic)
      break;
  }
  return i;
}

struct Extraction_options
{
  double scale = 1;
  std::size_t maximum_number = 100000000; // of cells
  bool allow_holes = false;
  bool leave_out_folded_cells = false; // around points of one edge
  std::string how_to_refine = scale_up; // for remedies
  std::string how_to_coarsen = "shrink the map by grid_scale";
};

// More darts than this have no 32-bit index.
constexpr std::size_t largest_number_of_cells = std::size_t(1) << 28;

// \tparam Group the group of the directions of the grid's lines
template <typename Group>
class Cell_extractor
{
  using Mesh = Basic_chart_mesh<Group>;
  using Shape = Cell_shape<Group>;

public:
  // `is_feature` tells of corners whether their edge is one; or is empty. `vertex_name` is for
  // messages: it is called with a corner of the mesh.
  Cell_extractor(Mesh&& mesh, std::vector<char>&& is_feature,
                 const Extraction_options& options,
                 const std::function<Message(Corner_index)>& vertex_name)
    : m_mesh(std::move(mesh)), m_is_feature(std::move(is_feature)), m_options(options),
      m_vertex_name(vertex_name)
  { }

  // Calls locate() as soon as the points are known, the last time at which the mesh is.
  template <typename ConcurrencyTag, typename Locate>
  bool run(const Locate& locate)
  {
    if(!find_points<ConcurrencyTag>())
      return false;
    locate();
    return find_cells<ConcurrencyTag>();
  }

  Extraction_report& report() { return m_report; }
  const Extraction_options& options() const { return m_options; }
  const Mesh& mesh() const { return m_mesh; }
  const Cell_complex& complex() const { return *m_complex; }

  // The number of a face in the input.
  std::size_t original_face(const std::size_t f) const
  { return m_kept_faces.empty() ? f : std::size_t(m_kept_faces[f]); }

private:
  template <typename ConcurrencyTag>
  bool find_points();
  template <typename ConcurrencyTag>
  bool find_cells();

  Message vertex_name(const Corner_index h) const
  {
    return m_vertex_name(Corner_index(3 * original_face(face_of(h)) + std::size_t(h) % 3));
  }

  Message edge_name(const Corner_index h) const
  { return "the edge from " + vertex_name(Mesh::prev(h)) + " to " + vertex_name(h); }

  // Exactly, or not at all.
  template <typename ConcurrencyTag>
  bool scale()
  {
    const double k = m_options.scale;
    if(!(k > 0 && std::isfinite(k)))
      return refuse(m_report, Outcome::INVALID_ARGUMENT,
                    term("grid_scale") + " must be positive and finite");
    const auto is_bad = [&](const std::size_t i) {
      const Uv& u = m_mesh.corners[i].uv;
      return is_beyond_limit(u[0] * k) || is_beyond_limit(u[1] * k) ||
             !is_product_exact(u[0], k) || !is_product_exact(u[1], k);
    };
    const std::size_t i = find_first<ConcurrencyTag>(m_mesh.corners.size(), is_bad);
    if(i < m_mesh.corners.size())
      return refuse_scale(Corner_index(i));
    if(k == 1)
      return true;
    for(Chart_corner& corner : m_mesh.corners)
      corner.uv = {corner.uv[0] * k, corner.uv[1] * k};
    scale_transitions();
    return true;
  }

  static bool is_beyond_limit(const double u) { return std::abs(u) > largest_grid_coordinate; }

  static bool is_product_exact(const double u, const double k)
  {
    const double product = u * k;
    return k == 1 || (std::fma(u, k, -product) == 0 && (u == 0 || std::abs(product) >= 1e-200));
  }

  bool refuse_scale(const Corner_index h)
  {
    const Uv& u = m_mesh.uv(h);
    const Message coordinate = "a coordinate of " + vertex_name(h);
    if(is_beyond_limit(u[0] * m_options.scale) || is_beyond_limit(u[1] * m_options.scale))
      return refuse(m_report, Outcome::TOO_LARGE,
                    coordinate + " is beyond 2^46, where units can't be counted safely" +
                      remedy("move or shrink the map"));
    return refuse(m_report, Outcome::INVALID_ARGUMENT,
                  coordinate + " can't be multiplied by " + term("grid_scale") + " exactly" +
                    remedy("scale by a power of two, or scale before the map is made exact, by "
                           "snap_to_seamless() with grid_scale"));
  }

  void scale_transitions()
  {
    for(std::size_t i = 0; i < m_mesh.corners.size(); ++i) {
      const Corner_index h = Corner_index(i);
      if(m_mesh.corner(h).transition == no_index)
        continue;
      auto& t = m_mesh.transitions[std::size_t(m_mesh.corner(h).transition)];
      t = make_transition(m_mesh, h, t.rotation);
    }
  }

  bool check_integers()
  {
    if(!check_translations())
      return false;
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

  bool check_translations()
  {
    const auto is_bad = [](const Basic_chart_transition<Group>& t)
                        { return !is_integer(t.translation[0]) || !is_integer(t.translation[1]); };
    if(std::none_of(m_mesh.transitions.begin(), m_mesh.transitions.end(), is_bad))
      return true;
    for(std::size_t i = 0; i < m_mesh.corners.size(); ++i) {
      const std::int32_t t = m_mesh.corners[i].transition; // holes have transitions, but no corner
      if(t == no_index || !is_bad(m_mesh.transitions[std::size_t(t)]))
        continue;
      const auto& translation = m_mesh.transitions[std::size_t(t)].translation;
      return refuse(m_report, Outcome::NOT_INTEGER,
                    "the translation across " + edge_name(Corner_index(i)) + " is " +
                      short_number((std::max)(distance_to_integer(translation[0]),
                                              distance_to_integer(translation[1]))) +
                      " off an integer" + make_integer);
    }
    return true;
  }

  bool check_cone(const std::size_t v)
  {
    int lines = 0; // of the grid: as many in all charts, which differ by integers
    for(std::size_t c = 0; c < std::size_t(Group::number_of_functionals); ++c)
      lines += is_integer(m_mesh.component(m_mesh.corner_at_vertex[v], c)) ? 1 : 0;
    ++m_report.number_of_cones;
    m_report.number_of_cones_in_cells += lines == 0 ? 1 : 0;
    return lines != 1 ||
           refuse(m_report, Outcome::NOT_INTEGER,
                  "the cone at " + vertex_name(m_mesh.corner_at_vertex[v]) +
                    " lies on a line of the grid, but on no point of it" + make_integer +
                    term(", or double the map: grid_scale(2)"));
  }

  template <typename ConcurrencyTag>
  bool check_faces()
  {
    m_report.nonpositive_faces = nonpositive_faces<ConcurrencyTag>(m_mesh);
    const std::vector<std::size_t>& faces = m_report.nonpositive_faces;
    if(faces.empty()) {
      const std::vector<char>& is_border = m_mesh.is_border;
      if(std::find(is_border.begin(), is_border.end(), true) != is_border.end())
        Fan_splitter<Group>(m_mesh).run();
      return true;
    }
    if(!m_options.allow_holes)
      return are_positive(m_mesh, faces, m_report,
                          remedy("repair them by repair_integer_grid(), or leave out the cells "
                                 "around them: allow_holes(true)"));
    const Face_remover<Group> remover(m_mesh, faces);
    Mesh rest = remover.run();
    if(!m_is_feature.empty())
      for(std::size_t i = 0; i < rest.corners.size(); ++i)
        m_is_feature[i] = m_is_feature[std::size_t(3 * remover.kept()[i / 3]) + i % 3];
    m_kept_faces = remover.kept();
    m_mesh = std::move(rest);
    return true;
  }

  // Lines of the grid are counted where they cross edges: slivers can be long without any area.
  template <typename ConcurrencyTag>
  bool check_size()
  {
    const auto sizes = results_of_chunks<Grid_size, ConcurrencyTag>(
      m_mesh.corners.size() / 3,
      [&](const Chunk& faces) { return grid_size(m_mesh, faces.begin, faces.end); });
    double crossings = 0;
    for(const Grid_size& size : sizes) {
      m_report.area += Shape::cells_of_unit * size.area;
      crossings += size.crossings;
    }
    const double largest = double((std::min)(m_options.maximum_number, largest_number_of_cells));
    const bool has_too_many_cells = m_report.area > largest;
    if(!has_too_many_cells && crossings <= 16 * (largest + double(m_mesh.corners.size())))
      return true;
    return refuse(m_report, Outcome::TOO_LARGE,
                  has_too_many_cells
                    ? "there would be " + short_number(m_report.area) + " " + Shape::plural() +
                      remedy((m_options.maximum_number < largest_number_of_cells
                                ? "raise maximum_number, or " : "") + m_options.how_to_coarsen)
                    : "the lines of the grid would cross edges of the mesh " +
                      short_number(crossings / 2) + " times" + remedy(m_options.how_to_coarsen));
  }

  template <typename ConcurrencyTag>
  void measure_parts()
  {
    m_parts = std::make_unique<Surface_parts>(m_mesh, ConcurrencyTag());
    Exact_rational twice_area{0};
    for(std::size_t i = 0; i < m_parts->size(); ++i) {
      twice_area += (*m_parts)[i].twice_area;
      m_report.number_of_unaligned_border_edges += (*m_parts)[i].number_of_unaligned_edges;
    }
    m_report.area = Shape::cells_of_unit * (CGAL::to_double(twice_area) / 2);
  }

  template <typename ConcurrencyTag>
  bool make_darts()
  {
    const double expected =
      1.01 * m_report.area / Shape::cells_of_unit + 0.01 * double(m_mesh.is_border.size());
    Lattice_points points;
    call_both<ConcurrencyTag>(
      [&] { measure_parts<ConcurrencyTag>(); },
      [&] { points = Lattice_points::make<ConcurrencyTag>(m_mesh, std::size_t(expected)); });
    Grid_darts darts = Grid_darts::make<ConcurrencyTag>(m_mesh, points);
    const Dart_failure failure = pair_darts<ConcurrencyTag>(m_mesh, points, m_is_feature, darts);
    if(failure.is_obstacle)
      return refuse(m_report, Outcome::NOT_INTEGER,
                  "a line of the grid meets " +
                    vertex_name(m_mesh.corner_at_vertex[failure.vertex]) +
                    ", which is a cone or a corner of the border, between two points of the grid" +
                    make_integer);
    if(failure)
      return refuse(m_report, Outcome::INTERNAL_ERROR, "two darts have the same twin");
    m_complex = std::make_unique<Cell_complex>(std::move(points), std::move(darts));
    return find_first<ConcurrencyTag>(m_complex->points.size(), [&](const std::size_t p)
                                      { return !is_valence_right(p); }) == m_complex->points.size()
             || refuse(m_report, Outcome::INTERNAL_ERROR, "a vertex has a wrong number of darts");
  }

  template <typename ConcurrencyTag>
  bool check_cells()
  {
    if(!leave_out_cut_cells())
      return refuse(m_report, Outcome::INTERNAL_ERROR, "a cell around the border has a wrong side");
    const std::vector<Cell_counts> counts =
      count_cells<ConcurrencyTag>(m_complex->points, m_complex->darts, m_complex->cells, *m_parts);
    bool is_area_right = true;
    const std::size_t part = first_bad_part<Group>(*m_parts, counts, is_area_right);
    if(part < m_parts->size()) {
      const bool may_be_coarse = is_area_right || counts[part].points == 0;
      return refuse(m_report, may_be_coarse ? Outcome::TOO_COARSE : Outcome::INTERNAL_ERROR,
                    "the part of the surface that " +
                      name_of_face(std::size_t(original_face((*m_parts)[part].first_face))) +
                      (may_be_coarse
                         ? " belongs to is too small for the grid" + remedy(m_options.how_to_refine)
                         : " belongs to has cells of the wrong area"));
    }
    m_report.number_of_faces = m_complex->cells.size();
    for(const std::size_t n : results_of_chunks<std::size_t, ConcurrencyTag>(
          m_report.number_of_faces, [&](const Chunk& cells) { return other_polygons(cells); }))
      m_report.number_of_other_polygons += n;
    return m_report.number_of_faces > 0 ||
           refuse(m_report, Outcome::TOO_COARSE,
                  "the surface holds no whole cell of the grid" + remedy(m_options.how_to_refine));
  }

  // A dart in each direction at a regular vertex; at others, as many as turns of the group. The
  // rotations around the vertex know this number modulo a full turn.
  bool is_valence_right(const std::size_t p) const
  {
    const Lattice_point& point = m_complex->points[p];
    if(point.place != Lattice_place::VERTEX)
      return true;
    const std::size_t n = m_complex->darts.degree(p), v = m_mesh.vertex(point.corner);
    if(m_mesh.is_border[v])
      return true;
    typename Group::Element turns = Group::element(int(n));
    for_each_corner(m_mesh, v, [&](const Corner_index c)
                    { turns = Group::compose(m_mesh.rotation(c), turns); });
    return (n == std::size_t(Group::order)) != bool(m_mesh.is_singular[v]) &&
           turns == Group::identity();
  }

  std::size_t other_polygons(const Chunk& cells) const
  {
    std::size_t n = 0;
    for(std::size_t c = cells.begin; c < cells.end; ++c)
      n += m_complex->cells.degree(c) != std::size_t(Shape::number_of_corners) ? 1 : 0;
    return n;
  }

  bool leave_out_cut_cells()
  {
    m_report.number_of_cut_cells = m_complex->cells.number_of_cut_cells();
    if(m_report.number_of_unaligned_border_edges > 0) {
      const auto is_cut = Border_cells<Group>(m_mesh, *m_complex).find();
      if(!is_cut)
        return false;
      m_report.number_of_cut_cells += std::size_t(std::count(is_cut->begin(), is_cut->end(), true));
      m_complex->cells.remove(*is_cut);
      tell_of_cut_cells();
    }
    return true;
  }

  // Nothing is left out in silence.
  void tell_of_cut_cells()
  {
    Corner_index h = 0;
    while(m_mesh.opposite(h) != no_index || is_border_on_grid(m_mesh, h))
      ++h;
    m_report.message = "left out: " + counted(m_report.number_of_cut_cells, "piece") +
                       " of cells, because the border cuts them" +
                       (m_kept_faces.empty() ? ", first at " : " or holes do, first at ") +
                       edge_name(h) + remedy("snap_to_seamless() with integer_grid(true) and "
                                             "align_border(true) moves it to the grid");
  }

  const Message make_integer = remedy("call snap_to_seamless() with integer_grid(true) first");
  Mesh m_mesh;
  std::vector<char> m_is_feature;
  Extraction_options m_options;
  std::function<Message(Corner_index)> m_vertex_name;
  Extraction_report m_report;
  std::vector<std::int32_t> m_kept_faces; // empty: all
  std::unique_ptr<Surface_parts> m_parts;
  std::unique_ptr<Cell_complex> m_complex;
};

// Outside of the class, so that programs that share a library can share these, too.
template <typename Group>
template <typename ConcurrencyTag>
bool Cell_extractor<Group>::find_points()
{
  return scale<ConcurrencyTag>() && check_faces<ConcurrencyTag>() && check_integers() &&
         check_size<ConcurrencyTag>() && make_darts<ConcurrencyTag>();
}

template <typename Group>
template <typename ConcurrencyTag>
bool Cell_extractor<Group>::find_cells()
{
  call_both<ConcurrencyTag>(
    [&] {
      if(m_report.number_of_unaligned_border_edges == 0)
        m_mesh = Mesh(); // the largest of all that is in memory
    },
    [&] { m_complex->cells.find(); });
  if(!check_cells<ConcurrencyTag>())
    return false;
  if(m_options.leave_out_folded_cells)
    m_complex->leave_out_folded_cells();
  m_report.number_of_faces = m_complex->cells.size();
  return true;
}

using Quad_extractor = Cell_extractor<Quarter_turns>;

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_CELL_EXTRACTOR_H
