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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_CELLS_CELL_OUTPUTS_H
#define CGAL_QUAD_REMESHING_INTERNAL_CELLS_CELL_OUTPUTS_H

#include <CGAL/license/Quad_remeshing.h>

// The outputs of cells: a mesh, or points and lists of their indices. Each output first takes the
// places of all points, while the surface is known, and then writes the cells, or refuses.

#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Quad_remeshing/internal/cells/Cell_extractor.h>
#include <CGAL/Quad_remeshing/internal/cells/Surface_parts.h>
#include <CGAL/Quad_remeshing/internal/cells/inverted_quads.h>
#include <CGAL/Seamless_snapping/internal/mesh/write_cells.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/container/small_vector.hpp>
#include <boost/container/vector.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The parameters of a mesh of cells that is written.
constexpr auto cell_mesh_parameters =
  named<CGAL::internal_np::cone_index, CGAL::internal_np::edge_is_constrained,
        CGAL::internal_np::vertex_location, CGAL::internal_np::vertex_point>;

// The points of the grid in space, and the output of the cells.

using Places = boost::container::vector<Place>;

// The index of the cone at a point, in turns of the group; 0 where there is none.
template <typename Group>
int cone_index(const Basic_chart_mesh<Group>& mesh, const Cell_complex& complex,
               const std::size_t p)
{
  const Lattice_point& point = complex.points[p];
  return point.place == Lattice_place::VERTEX && mesh.is_singular[mesh.vertex(point.corner)]
           ? Group::order - int(complex.darts.degree(p)) : 0;
}

// The cells for `Cell_writer`.
class Cells_to_write
{
public:
  Cells_to_write(const Cell_complex& complex, const Cell_vertices& vertices)
    : m_complex(complex), m_vertices(vertices)
  { }

  std::size_t number_of_vertices() const { return m_vertices.size(); }
  std::size_t number_of_cells() const { return m_complex.cells.size(); }
  std::size_t number_of_darts() const { return m_complex.darts.size(); }
  bool is_edge(const std::size_t d) const { return m_complex.is_edge(d); }
  std::size_t twin(const std::size_t d) const { return m_complex.twin(d); }
  Cell_index cell(const std::size_t d) const { return m_complex.cells.cell(d); }

  // Around cells, and the holes that folded cells leave; a dart of the border is followed by the
  // one at the other end of the fan around its target.
  std::size_t next(const std::size_t d) const
  {
    if(m_complex.has_cell(d))
      return m_complex.next(d);
    if(m_complex.is_folded(d)) {
      std::size_t following = m_complex.next(d);
      while(!is_edge(following))
        following = m_complex.next(following);
      return following;
    }
    std::size_t last = twin(d);
    while(!m_complex.is_gap(last))
      last = m_complex.darts.counterclockwise(last);
    return last;
  }

  std::size_t target(const std::size_t d) const
  { return m_vertices.vertex(m_complex.has_cell(d) ? m_complex.next(d) : twin(d)); }

private:
  const Cell_complex& m_complex;
  const Cell_vertices& m_vertices;
};

template <typename ConcurrencyTag, typename Group>
bool is_face_graph(Cell_extractor<Group>& extractor, const Cell_vertices& vertices)
{
  constexpr bool is_square = Cell_shape<Group>::is_square;
  const Cell_complex& complex = extractor.complex();
  const std::size_t v = vertex_with_double_edges<ConcurrencyTag>(complex, vertices);
  if(v == vertices.size())
    return true;
  const std::size_t tip = find_first<ConcurrencyTag>(vertices.size(), [&](const std::size_t w)
    { return complex.darts.degree(vertices.point(w)) == 1; });
  const Message how = tip == vertices.size()
    ? remedy(extractor.options().how_to_refine) + ", or "
    : "; point " + std::to_string(tip) + " has only one edge, at any scale" +
        remedy(is_square ? "quantize() with needs_face_graph(true), which leaves out its quad, or "
                         : "");
  return refuse(
    extractor.report(), Outcome::NO_FACE_GRAPH,
    "the " + std::string(Cell_shape<Group>::plural()) + " around point " + std::to_string(v) +
      " of the grid meet themselves, or each other twice, which no face graph can hold" +
      how + term(is_square ? "call extract_quad_soup()" : "call extract_triangle_soup()"));
}

// Counts inverted quads before they are written. Triangles and other polygons do not count.
template <typename Group>
void count_inverted_quads(const Cell_vertices& vertices, const Places& places,
                          Cell_extractor<Group>& extractor)
{
  if(!Cell_shape<Group>::is_square)
    return;
  const Cell_complex& complex = extractor.complex();
  for(std::size_t c = 0; c < complex.cells.size(); ++c) {
    Quad_in_space quad;
    std::size_t n = 0;
    complex.cells.for_darts(c, [&](const std::size_t d) {
      if(n < 4)
        quad[n] = places[vertices.point(vertices.vertex(d))];
      ++n;
    });
    if(n == 4 && is_inverted(quad))
      count_inverted_quad(c, extractor.report());
  }
}

// Adds the quads to a graph, and fills the maps that are given; or refuses.
// \tparam Location of a point on the input
template <typename Location, typename QuadMesh, typename NamedParameters>
class Cell_mesh_output
{
public:
  Cell_mesh_output(QuadMesh& quads, const NamedParameters& np) : m_quads(quads), m_np(np) { }

  template <typename ConcurrencyTag, typename Group, typename Embedding>
  void locate(const Cell_extractor<Group>& extractor, const Embedding& embedding)
  {
    const Cell_complex& complex = extractor.complex();
    m_places = embedding.template places<ConcurrencyTag>(complex.points);
    const auto location_map = this->location_map();
    if constexpr(is_given<decltype(location_map)>)
      for(std::size_t p = 0; p < complex.points.size(); ++p)
        m_locations.push_back(embedding.location(complex.points[p]));
    const auto cone_map = this->cone_map();
    if constexpr(is_given<decltype(cone_map)>)
      for(std::size_t p = 0; p < complex.points.size(); ++p)
        m_cones.push_back(cone_index(extractor.mesh(), complex, p));
  }

  template <typename ConcurrencyTag, typename Group>
  void write(Cell_extractor<Group>& extractor)
  {
    const Cell_complex& complex = extractor.complex();
    const auto vertices =
      Cell_vertices::make<ConcurrencyTag>(m_places.size(), complex.darts,
                                          [&](const auto d) { return complex.is_gap(d); });
    if(!is_face_graph<ConcurrencyTag>(extractor, vertices))
      return;
    extractor.report().number_of_vertices = vertices.size();
    move_points_of_folded_cells(complex, vertices);
    count_inverted_quads(vertices, m_places, extractor);
    const Cells_to_write cells(complex, vertices);
    Cell_writer<QuadMesh, Cells_to_write> writer(cells, m_quads);
    add_vertices(vertices, writer);
    writer.add_edges_and_faces(
      [&](const auto e, const std::size_t d) {
        const auto map =
          CGAL::parameters::get_parameter(m_np, CGAL::internal_np::edge_is_constrained);
        if constexpr(is_given<decltype(map)>)
          put(map, e, complex.darts.is_feature(d) || complex.is_border(d));
      },
      [](const auto, std::size_t) { });
  }

private:
  auto location_map() const
  { return CGAL::parameters::get_parameter(m_np, CGAL::internal_np::vertex_location); }
  auto cone_map() const
  { return CGAL::parameters::get_parameter(m_np, CGAL::internal_np::cone_index); }

  // The opposite point takes the place of the one that is left out with the cell.
  void move_points_of_folded_cells(const Cell_complex& complex, const Cell_vertices& vertices)
  {
    for(const Cell_complex::Folded_cell& folded : complex.folded_cells())
      if(folded.is_opposite_free) {
        const std::size_t p = vertices.point(complex.origin(vertices, folded.rest[1]));
        m_places[p] = m_places[folded.point];
        if(!m_locations.empty())
          m_locations[p] = m_locations[folded.point];
      }
  }

  template <typename Writer>
  void add_vertices(const Cell_vertices& vertices, Writer& writer)
  {
    auto point_map = chosen(m_np, CGAL::internal_np::vertex_point,
                            CGAL::get_property_map(CGAL::vertex_point, m_quads));
    using Point = typename boost::property_traits<decltype(point_map)>::value_type;
    const auto location_map = this->location_map();
    const auto cone_map = this->cone_map();
    for(std::size_t i = 0; i < vertices.size(); ++i) {
      const auto v = writer.new_vertex();
      const std::size_t p = vertices.point(i);
      put(point_map, v, point_at<Point>(m_places[p]));
      if constexpr(is_given<decltype(location_map)>)
        put(location_map, v, m_locations[p]);
      if constexpr(is_given<decltype(cone_map)>)
        put(cone_map, v, m_cones[p]);
    }
  }

  QuadMesh& m_quads;
  const NamedParameters& m_np;
  Places m_places; // of all points; so are the following, where they are asked for
  std::vector<Location> m_locations;
  std::vector<int> m_cones;
};

template <typename Polygon>
struct Is_array : public std::false_type
{ };

template <typename Index, std::size_t n>
struct Is_array<std::array<Index, n> > : public std::true_type
{
  static_assert(n == 3 || n == 4, "the cells are triangles or quads");
};

// The corners of a cell, from the index of the first vertex on.
template <typename Polygon>
Polygon polygon(const Cell_complex& complex, const Cell_vertices& vertices, const std::size_t cell,
                const std::size_t first)
{
  boost::container::small_vector<std::size_t, 16> corners;
  complex.cells.for_darts(cell, [&](const std::size_t d)
                          { corners.push_back(first + vertices.vertex(d)); });
  if constexpr(Is_array<Polygon>::value) {
    Polygon result{};
    for(std::size_t k = 0; k < result.size(); ++k)
      result[k] = typename Polygon::value_type(corners[k]);
    return result;
  } else {
    return Polygon(corners.begin(), corners.end());
  }
}

// Whether all cells can be stored as polygons of this type.
template <typename Polygon, typename Group>
bool fits(Extraction_report& report)
{
  using Shape = Cell_shape<Group>;
  if constexpr(Is_array<Polygon>::value)
    static_assert(std::tuple_size<Polygon>::value == std::size_t(Shape::number_of_corners),
                  "quads have four corners, triangles three");
  if(!Is_array<Polygon>::value || report.number_of_other_polygons == 0)
    return true;
  return refuse(report, Outcome::NOT_INTEGER,
                "the cells around " + counted(report.number_of_other_polygons, "cone") +
                  " are no " + Shape::plural() + ", which arrays of " +
                  std::to_string(Shape::number_of_corners) + " indices can't hold" +
                  remedy("double the map, grid_scale(2), if the cones are half-integers, or use "
                         "std::vector<std::size_t> for polygons"));
}

// Adds the quads to ranges of points and polygons; or refuses.
template <typename PointRange, typename PolygonRange>
class Cell_soup_output
{
public:
  Cell_soup_output(PointRange& points, PolygonRange& polygons)
    : m_points(points), m_polygons(polygons)
  { }

  template <typename ConcurrencyTag, typename Group, typename Embedding>
  void locate(const Cell_extractor<Group>& extractor, const Embedding& embedding)
  {
    m_places = embedding.template places<ConcurrencyTag>(extractor.complex().points);
  }

  template <typename ConcurrencyTag, typename Group>
  void write(Cell_extractor<Group>& extractor)
  {
    using Polygon = typename PolygonRange::value_type;
    const Cell_complex& complex = extractor.complex();
    if(!fits<Polygon, Group>(extractor.report()))
      return;
    const auto vertices =
      Cell_vertices::make<ConcurrencyTag>(m_places.size(), complex.darts,
                                          [&](const auto d) { return complex.is_gap(d); });
    extractor.report().number_of_vertices = vertices.size();
    count_inverted_quads(vertices, m_places, extractor);
    const std::size_t first = m_points.size();
    for(std::size_t i = 0; i < vertices.size(); ++i)
      m_points.push_back(point_at<typename PointRange::value_type>(m_places[vertices.point(i)]));
    for(std::size_t c = 0; c < complex.cells.size(); ++c)
      m_polygons.push_back(polygon<Polygon>(complex, vertices, c, first));
  }

private:
  PointRange& m_points;
  PolygonRange& m_polygons;
  Places m_places; // of all points
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_CELLS_CELL_OUTPUTS_H
