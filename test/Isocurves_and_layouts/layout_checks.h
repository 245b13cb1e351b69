// What a layout must be, checked in rationals on what the public class tells, the mesh, and the
// map.

#ifndef SEAMLESS_SNAPPING_TEST_LAYOUT_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_LAYOUT_CHECKS_H

#include "checking.h"

#include <CGAL/Isocurves_and_layouts/copy_to_face_graph.h>
#include <CGAL/Isocurves_and_layouts/Motorcycle_graph.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace layout_checks {

namespace IL = CGAL::Isocurves_and_layouts;
using CGAL::Exact_rational;

template <typename Mesh, typename UVMap, typename FeatureMap>
class Checker
{
  using Graph = IL::Motorcycle_graph<Mesh>;
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;

public:
  Checker(const Mesh& mesh, const UVMap& uv, const FeatureMap& features, const Graph& graph,
          const std::string& context)
    : m_mesh(mesh), m_uv(uv), m_features(features), m_graph(graph), m_context(context)
  { }

  void run()
  {
    CHECK_IN(m_context + ": " + m_graph.message(), bool(m_graph));
    if(!m_graph)
      return;
    check_half_arcs();
    check_patches();
    check_numbers();
    check_nodes();
    check_paths();
    check_walls();
    check_refinement();
    check_copy();
  }

  // That each curve ends at one that has come there before: for motorcycle graphs only. Where four
  // arcs meet at a point, they don't tell which curve they belong to.
  void check_order()
  {
    for(std::size_t n = 0; n < m_graph.number_of_nodes(); ++n) {
      const auto halves = m_graph.half_arcs_around_node(n);
      if(m_graph.node_kind(n) != IL::Layout_node::JUNCTION || halves.size() != 3)
        continue;
      Exact_rational stem(-1), through(-1);
      bool is_clear = true;
      for(const std::size_t h : halves) {
        const std::size_t arriving = Graph::opposite(h);
        const auto [end, distance] = follow(h);
        is_clear = is_clear && end != UNCLEAR && !m_graph.arc_is_constrained(Graph::arc(h)) &&
                   !is_beside_cut_patch(h);
        if(continuation(arriving) == none)
          stem = distance;
        else if(end == START && (through < 0 || distance < through))
          through = distance;
      }
      if(is_clear)
        CHECK_IN(m_context, through > 0 && through <= stem);
    }
  }

private:
  static constexpr std::size_t none = std::size_t(-1);

  // Which side of its patch a half-arc belongs to.
  std::pair<std::size_t, std::size_t> side(const std::size_t h) const
  { return m_sides.at(h); }

  bool runs_straight(const std::size_t h) const
  {
    const std::size_t g = m_graph.next(h);
    return m_graph.patch(h) != Graph::null_patch && !is_cut(m_graph.patch(h)) &&
           side(h) == side(g);
  }

  bool is_cut(const std::size_t p) const
  { return p != Graph::null_patch && m_graph.patch_is_cut(p); }

  bool is_beside_cut_patch(const std::size_t h) const
  { return is_cut(m_graph.patch(h)) || is_cut(m_graph.patch(Graph::opposite(h))); }

  // The half-arc straight on behind h, if there is one.
  std::size_t continuation(const std::size_t h) const
  {
    if(runs_straight(h))
      return m_graph.next(h);
    const std::size_t p = m_previous.at(Graph::opposite(h));
    return runs_straight(p) ? Graph::opposite(p) : none;
  }

  enum End { START, STOP, UNCLEAR };

  // Straight on along h: whether that leads to a node where curves start; and how far it goes.
  std::pair<End, Exact_rational> follow(std::size_t h) const
  {
    Exact_rational length(0);
    for(;;) {
      length += m_graph.arc_length(Graph::arc(h));
      const std::size_t n = m_graph.target(h);
      if(m_graph.node_kind(n) != IL::Layout_node::JUNCTION)
        return {START, length};
      if(m_graph.half_arcs_around_node(n).size() != 3 ||
         m_graph.arc_is_constrained(Graph::arc(h)) || // which may be closed
         is_beside_cut_patch(h))                      // where sides are not told
        return {UNCLEAR, length};
      h = continuation(h);
      if(h == none)
        return {STOP, length};
    }
  }

  void check_half_arcs()
  {
    for(std::size_t h = 0; h < 2 * m_graph.number_of_arcs(); ++h) {
      const std::size_t g = m_graph.next(h);
      CHECK_IN(m_context, m_graph.target(h) == m_graph.source(g));
      CHECK_IN(m_context, m_graph.patch(h) == m_graph.patch(g));
      CHECK_IN(m_context, m_previous.emplace(g, h).second);
      CHECK_IN(m_context, m_graph.arc_is_isocurve(Graph::arc(h))
                            ? m_graph.arc_length(Graph::arc(h)) > 0
                            : m_graph.arc_length(Graph::arc(h)) == 0 &&
                                m_graph.arc_is_constrained(Graph::arc(h)));
    }
  }

  // Each patch has one cycle of half-arcs, in four sides, the opposite ones of the same length; or
  // it is cut, and has cycles only.
  void check_patches()
  {
    std::set<std::size_t> around_cut_patches;
    std::size_t number_of_cut_patches = 0;
    for(std::size_t p = 0; p < m_graph.number_of_patches(); ++p) {
      if(m_graph.patch_is_cut(p)) {
        ++number_of_cut_patches;
        check_cut_patch(p, around_cut_patches);
        continue;
      }
      std::array<Exact_rational, 4> lengths;
      std::vector<std::size_t> cycle;
      for(std::size_t s = 0; s < 4; ++s) {
        for(const std::size_t h : m_graph.patch_side(p, s)) {
          lengths[s] += m_graph.arc_length(Graph::arc(h));
          cycle.push_back(h);
          CHECK_IN(m_context, m_graph.patch(h) == p);
          CHECK_IN(m_context, m_sides.emplace(h, std::make_pair(p, s)).second);
          CHECK_IN(m_context, m_graph.arc_is_isocurve(Graph::arc(h)));
        }
        CHECK_IN(m_context, lengths[s] > 0);
      }
      CHECK_IN(m_context, lengths[0] == lengths[2] && lengths[0] == m_graph.patch_width(p));
      CHECK_IN(m_context, lengths[1] == lengths[3] && lengths[1] == m_graph.patch_height(p));
      for(std::size_t i = 0; i < cycle.size(); ++i)
        CHECK_IN(m_context, m_graph.next(cycle[i]) == cycle[(i + 1) % cycle.size()]);
      CHECK_IN(m_context, m_graph.patch_cycles(p).size() == 1 &&
                            m_graph.patch_cycles(p).front() == cycle &&
                            m_graph.patch_euler_characteristic(p) == 1);
    }
    CHECK_EQUAL(m_graph.number_of_cut_patches(), number_of_cut_patches);
    std::size_t outside = 0;
    for(std::size_t h = 0; h < 2 * m_graph.number_of_arcs(); ++h)
      outside += m_graph.patch(h) == Graph::null_patch ? 1 : 0;
    CHECK_IN(m_context, m_sides.size() + around_cut_patches.size() + outside ==
                          2 * m_graph.number_of_arcs());
  }

  // A border that lies on no isocurve is part of it, or a vertex of one.
  void check_cut_patch(const std::size_t p, std::set<std::size_t>& found)
  {
    bool touches_border = false;
    for(const auto& cycle : m_graph.patch_cycles(p))
      for(std::size_t i = 0; i < cycle.size(); ++i) {
        CHECK_IN(m_context, m_graph.patch(cycle[i]) == p && found.insert(cycle[i]).second &&
                              m_graph.next(cycle[i]) == cycle[(i + 1) % cycle.size()]);
        touches_border =
          touches_border || !m_graph.arc_is_isocurve(Graph::arc(cycle[i])) ||
          (m_graph.node_place(m_graph.source(cycle[i])) == IL::Isocurve_place::VERTEX &&
           has_oblique_border_edge(
             target(m_graph.node_halfedge(m_graph.source(cycle[i])), m_mesh)));
      }
    CHECK_IN(m_context, touches_border && m_graph.patch_area(p) > 0);
    for(std::size_t s = 0; s < 4; ++s)
      CHECK_IN(m_context, m_graph.patch_side(p, s).empty());
  }

  // Of a face of the mesh: whether no coordinate is constant along it.
  bool is_oblique(const Halfedge h) const
  {
    const auto a = get(m_uv, prev(h, m_mesh)), b = get(m_uv, h);
    return a.x() != b.x() && a.y() != b.y();
  }

  bool has_oblique_border_edge(
    const typename boost::graph_traits<Mesh>::vertex_descriptor v) const
  {
    for(const auto h : CGAL::halfedges_around_target(v, m_mesh))
      for(const auto g : {h, opposite(h, m_mesh)})
        if(CGAL::is_border(g, m_mesh) && is_oblique(opposite(g, m_mesh)))
          return true;
    return false;
  }

  Exact_rational area() const
  {
    Exact_rational twice(0);
    for(const auto f : faces(m_mesh)) {
      const Halfedge h = halfedge(f, m_mesh);
      const auto a = get(m_uv, h), b = get(m_uv, next(h, m_mesh)), c = get(m_uv, prev(h, m_mesh));
      const Exact_rational x(a.x()), y(a.y());
      twice += (Exact_rational(b.x()) - x) * (Exact_rational(c.y()) - y) -
               (Exact_rational(b.y()) - y) * (Exact_rational(c.x()) - x);
    }
    return Exact_rational(twice / 2);
  }

  // As each rectangle has one cycle, all of them are discs if and only if these characteristics
  // agree. Areas of rectangles come from lengths, those of others from their faces.
  void check_numbers()
  {
    Exact_rational sum(0);
    std::ptrdiff_t found = std::ptrdiff_t(m_graph.number_of_nodes()) -
                           std::ptrdiff_t(m_graph.number_of_arcs());
    for(std::size_t p = 0; p < m_graph.number_of_patches(); ++p) {
      sum += m_graph.patch_is_cut(p) ? m_graph.patch_area(p)
                                     : Exact_rational(m_graph.patch_width(p) *
                                                      m_graph.patch_height(p));
      found += m_graph.patch_euler_characteristic(p);
    }
    CHECK_IN(m_context, sum == area());
    std::ptrdiff_t expected = std::ptrdiff_t(faces(m_mesh).size()) -
                              std::ptrdiff_t(edges(m_mesh).size());
    for(const auto v : vertices(m_mesh))
      expected += halfedge(v, m_mesh) != boost::graph_traits<Mesh>::null_halfedge() ? 1 : 0;
    CHECK_EQUAL(found, expected);
  }

  double angle(const Halfedge h) const
  {
    const auto p = get(m_uv, h), q = get(m_uv, next(h, m_mesh)), r = get(m_uv, prev(h, m_mesh));
    const double ax = q.x() - p.x(), ay = q.y() - p.y(), bx = r.x() - p.x(), by = r.y() - p.y();
    return std::atan2(ax * by - ay * bx, ax * bx + ay * by) / std::acos(0.);
  }

  // How many arcs there are at a border vertex at which curves start: one along each border edge,
  // and along each axis between both.
  std::size_t expected_degree(const typename boost::graph_traits<Mesh>::vertex_descriptor v) const
  {
    Halfedge first = halfedge(v, m_mesh); // the corner next to the first border edge
    while(!CGAL::is_border(opposite(next(first, m_mesh), m_mesh), m_mesh))
      first = opposite(next(first, m_mesh), m_mesh);
    std::size_t axes = 0;
    for(Halfedge h = first;; h = prev(opposite(h, m_mesh), m_mesh)) {
      axes += std::size_t(quadrant(h, prev(h, m_mesh)) + 4 - quadrant(h, next(h, m_mesh))) % 4;
      if(CGAL::is_border(opposite(h, m_mesh), m_mesh))
        return 1 + axes + (is_oblique(h) ? 1 : 0);
    }
  }

  // That of the vector from one corner to another; each with the axis at its clockwise end.
  int quadrant(const Halfedge from, const Halfedge to) const
  {
    const auto p = get(m_uv, from), q = get(m_uv, to);
    if(q.y() >= p.y() && q.x() > p.x())
      return 0;
    if(q.y() > p.y())
      return 1;
    return q.x() < p.x() ? 2 : 3;
  }

  // As many arcs as quarter turns at inner vertices, one more on the border; at others, three or
  // four. On the border there can be more where that lies on no isocurve.
  void check_nodes()
  {
    std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, std::size_t> nodes;
    for(std::size_t n = 0; n < m_graph.number_of_nodes(); ++n) {
      const auto halves = m_graph.half_arcs_around_node(n);
      for(const std::size_t h : halves)
        CHECK_IN(m_context, m_graph.source(h) == n);
      for(std::size_t i = 0; i < halves.size(); ++i) // counterclockwise
        CHECK_IN(m_context, m_graph.next(Graph::opposite(halves[(i + 1) % halves.size()])) ==
                              halves[i]);
      if(m_graph.node_kind(n) == IL::Layout_node::JUNCTION)
        CHECK_IN(m_context, halves.size() == 3 || halves.size() == 4 ||
                              (halves.size() > 4 && has_oblique_border_edge(target(
                                                      m_graph.node_halfedge(n), m_mesh))));
      if(m_graph.node_place(n) == IL::Isocurve_place::VERTEX)
        CHECK_IN(m_context, nodes.emplace(target(m_graph.node_halfedge(n), m_mesh), n).second);
    }
    for(const auto v : vertices(m_mesh)) {
      if(halfedge(v, m_mesh) == boost::graph_traits<Mesh>::null_halfedge())
        continue;
      double sum = 0;
      bool is_border = false;
      for(const auto h : CGAL::halfedges_around_target(v, m_mesh)) {
        is_border = is_border || CGAL::is_border(h, m_mesh);
        sum += CGAL::is_border(h, m_mesh) ? 0 : angle(h);
      }
      const long turns = std::lround(sum);
      const auto node = nodes.find(v);
      if(is_border && has_oblique_border_edge(v)) {
        if(node != nodes.end() && m_graph.node_kind(node->second) != IL::Layout_node::JUNCTION) {
          const std::size_t degree = m_graph.half_arcs_around_node(node->second).size();
          CHECK_IN(m_context, degree == expected_degree(v) ||
                                (degree == 2 &&
                                 m_graph.node_kind(node->second) == IL::Layout_node::SEED));
        }
        continue;
      }
      CHECK_IN(m_context, std::abs(sum - double(turns)) < 1e-3);
      const bool is_regular = turns == (is_border ? 2 : 4);
      CHECK_IN(m_context, is_regular || node != nodes.end());
      if(node == nodes.end() || m_graph.node_kind(node->second) == IL::Layout_node::JUNCTION)
        continue;
      const std::size_t degree = m_graph.half_arcs_around_node(node->second).size();
      CHECK_IN(m_context, degree == std::size_t(turns) + (is_border ? 1 : 0) ||
                            (degree == 2 && m_graph.number_of_cut_patches() > 0 &&
                             m_graph.node_kind(node->second) == IL::Layout_node::SEED));
    }
  }

  // A point in the chart of a face.
  std::array<double, 2> in_chart(const typename Graph::Location& location) const
  {
    const Halfedge h = halfedge(location.first, m_mesh);
    const auto a = get(m_uv, prev(h, m_mesh)), b = get(m_uv, h), c = get(m_uv, next(h, m_mesh));
    const auto& w = location.second;
    return {w[0] * a.x() + w[1] * b.x() + w[2] * c.x(), w[0] * a.y() + w[1] * b.y() + w[2] * c.y()};
  }

  // What a location lies on: its vertices of positive weight.
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, double>
  support(const typename Graph::Location& location) const
  {
    const Halfedge h = halfedge(location.first, m_mesh);
    std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, double> result;
    const std::array<Halfedge, 3> corners = {prev(h, m_mesh), h, next(h, m_mesh)};
    for(std::size_t k = 0; k < 3; ++k)
      if(location.second[k] != 0)
        result[target(corners[k], m_mesh)] = location.second[k];
    return result;
  }

  // The path leads from node to node, each time along a straight line in one face, and is as long
  // as the arc, if that lies on an isocurve; but for the rounding of its points. `result` is the
  // length in a face that holds both.
  bool step_length(const typename Graph::Location& a, const typename Graph::Location& b,
                   const bool is_isocurve, double& result) const
  {
    const auto on_a = support(a), on_b = support(b);
    for(const auto f : faces_around(a))
      if(holds(f, on_a) && holds(f, on_b)) {
        const auto p = in_chart(f, on_a), q = in_chart(f, on_b);
        const double du = std::abs(p[0] - q[0]), dv = std::abs(p[1] - q[1]);
        if(is_isocurve && (std::min)(du, dv) > 1e-6 * ((std::max)(du, dv) + 1))
          continue; // another face with the same vertices
        result = is_isocurve ? (std::max)(du, dv) : std::hypot(du, dv);
        return true;
      }
    return false;
  }

  std::vector<typename boost::graph_traits<Mesh>::face_descriptor>
  faces_around(const typename Graph::Location& a) const
  {
    std::vector<typename boost::graph_traits<Mesh>::face_descriptor> result(1, a.first);
    for(const auto h : CGAL::halfedges_around_face(halfedge(a.first, m_mesh), m_mesh))
      for(const auto g : CGAL::halfedges_around_target(h, m_mesh))
        if(!CGAL::is_border(g, m_mesh))
          result.push_back(face(g, m_mesh));
    return result;
  }

  template <typename Face, typename Support>
  bool holds(const Face f, const Support& on) const
  {
    std::size_t number = 0;
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh))
      number += on.count(target(h, m_mesh));
    return number >= on.size();
  }

  template <typename Face, typename Support>
  std::array<double, 2> in_chart(const Face f, const Support& on) const
  {
    std::array<double, 2> result{};
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
      const auto i = on.find(target(h, m_mesh));
      if(i == on.end())
        continue;
      result[0] += i->second * get(m_uv, h).x();
      result[1] += i->second * get(m_uv, h).y();
    }
    return result;
  }

  static bool comes_near_vertex(const typename Graph::Location& location)
  {
    return std::any_of(location.second.begin(), location.second.end(),
                       [](const double w) { return w != 0 && w < 1e-9; });
  }

  void check_paths()
  {
    m_oblique_length = 0;
    for(std::size_t a = 0; a < m_graph.number_of_arcs(); ++a) {
      const auto path = m_graph.arc_path(a);
      CHECK_IN(m_context, path.size() >= 2 &&
                            path.front() == m_graph.node_location(m_graph.source(2 * a)) &&
                            path.back() == m_graph.node_location(m_graph.target(2 * a)));
      if(std::any_of(path.begin(), path.end(), comes_near_vertex)) {
        m_oblique_length = -1e300;
        continue; // rounding may move such a point to another edge
      }
      double length = 0;
      bool is_path = true;
      const bool is_isocurve = m_graph.arc_is_isocurve(a);
      for(std::size_t i = 0; i + 1 < path.size(); ++i) {
        double step = 0;
        is_path = is_path && step_length(path[i], path[i + 1], is_isocurve, step);
        length += step;
      }
      if(!is_isocurve) {
        CHECK_IN(m_context, is_path);
        m_oblique_length += length;
        continue;
      }
      const double expected = CGAL::to_double(m_graph.arc_length(a));
      CHECK_IN(m_context, is_path && std::abs(length - expected) < 1e-6 * (expected + 1));
    }
  }

  // The chart of a face that holds all these locations, and them in it.
  bool common_chart(const std::vector<typename Graph::Location>& locations,
                    std::vector<std::array<double, 2> >& points) const
  {
    for(const auto f : faces_around(locations.front())) {
      points.clear();
      for(const auto& location : locations) {
        const auto on = support(location);
        if(holds(f, on))
          points.push_back(in_chart(f, on));
      }
      if(points.size() == locations.size())
        return true;
    }
    return false;
  }

  // A mesh whose faces are separated by arcs, into as many parts as patches, of the same areas.
  void check_refinement()
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    using Refined = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
    using Face = Refined::Face_index;
    Refined refined;
    auto locations =
      refined.add_property_map<Refined::Vertex_index, typename Graph::Location>("v:location").first;
    auto is_arc = refined.add_property_map<Refined::Edge_index, bool>("e:arc").first;
    auto patches = refined.add_property_map<Face, std::size_t>("f:patch").first;
    CHECK_IN(m_context, IL::refine_along_arcs(m_graph, refined, IL::parameters::default_values(),
                                              IL::parameters::vertex_location_map(locations)
                                                .edge_is_constrained_map(is_arc)
                                                .face_patch_map(patches)));
    CHECK_IN(m_context, CGAL::is_valid_polygon_mesh(refined));
    auto parts = refined.add_property_map<Face, std::size_t>("f:part").first;
    const std::size_t number =
      PMP::connected_components(refined, parts,
                                CGAL::parameters::edge_is_constrained_map(is_arc));
    CHECK_EQUAL(number, m_graph.number_of_patches());
    std::map<std::size_t, std::size_t> part_of_patch;
    std::vector<double> areas(m_graph.number_of_patches(), 0);
    bool is_near_vertex = false;
    for(const Face f : refined.faces()) {
      CHECK_IN(m_context, part_of_patch.emplace(patches[f], parts[f]).first->second == parts[f]);
      std::vector<typename Graph::Location> corners;
      for(const auto v : refined.vertices_around_face(refined.halfedge(f)))
        corners.push_back(locations[v]);
      is_near_vertex =
        is_near_vertex || std::any_of(corners.begin(), corners.end(), comes_near_vertex);
      std::vector<std::array<double, 2> > points;
      if(is_near_vertex || !common_chart(corners, points)) {
        is_near_vertex = true;
        continue;
      }
      const auto& p = points.front();
      for(std::size_t i = 2; i < points.size(); ++i)
        areas[patches[f]] += ((points[i - 1][0] - p[0]) * (points[i][1] - p[1]) -
                              (points[i - 1][1] - p[1]) * (points[i][0] - p[0])) / 2;
    }
    CHECK_IN(m_context, part_of_patch.size() == number);
    check_topology(refined, is_arc, patches);
    for(std::size_t p = 0; p < areas.size() && !is_near_vertex; ++p) {
      const double expected = CGAL::to_double(m_graph.patch_area(p));
      CHECK_IN(m_context, std::abs(areas[p] - expected) < 1e-6 * (expected + 1));
    }
  }

  // Of each patch, without its border: faces, edges, and vertices.
  template <typename Refined, typename IsArc, typename Patches>
  void check_topology(const Refined& refined, const IsArc& is_arc, const Patches& patches)
  {
    std::vector<std::ptrdiff_t> numbers(m_graph.number_of_patches(), 0);
    for(const auto f : refined.faces())
      ++numbers[patches[f]];
    for(const auto e : refined.edges())
      if(!is_arc[e])
        --numbers[patches[refined.face(refined.halfedge(e))]];
    for(const auto v : refined.vertices()) {
      bool is_inside = true;
      for(const auto h : refined.halfedges_around_target(refined.halfedge(v)))
        is_inside = is_inside && !is_arc[refined.edge(h)];
      if(is_inside)
        ++numbers[patches[refined.face(refined.halfedge(v))]];
    }
    for(std::size_t p = 0; p < numbers.size(); ++p)
      CHECK_EQUAL(numbers[p], m_graph.patch_euler_characteristic(p));
  }

  bool is_simple() const
  {
    for(std::size_t p = 0; p < m_graph.number_of_patches(); ++p)
      if(m_graph.patch_cycles(p).size() != 1 || m_graph.patch_euler_characteristic(p) != 1)
        return false;
    std::set<std::pair<std::size_t, std::size_t> > ends;
    for(std::size_t a = 0; a < m_graph.number_of_arcs(); ++a) {
      const auto pair = std::minmax({m_graph.source(2 * a), m_graph.target(2 * a)});
      if(pair.first == pair.second || m_graph.patch(2 * a) == m_graph.patch(2 * a + 1) ||
         !ends.insert(pair).second)
        return false;
    }
    return true;
  }

  void check_copy()
  {
    using Patches = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
    Patches patches;
    const bool is_copied = IL::copy_to_face_graph(m_graph, patches);
    CHECK_IN(m_context, is_copied == is_simple());
    if(!is_copied) {
      CHECK_IN(m_context, patches.is_empty());
      return;
    }
    CHECK_IN(m_context, CGAL::is_valid_polygon_mesh(patches));
    CHECK_IN(m_context, patches.number_of_vertices() == m_graph.number_of_nodes() &&
                          patches.number_of_edges() == m_graph.number_of_arcs() &&
                          patches.number_of_faces() == m_graph.number_of_patches());
  }

  // All border and feature edges are on constrained arcs, by their length; the latter is rounded
  // where they lie on no isocurve.
  void check_walls()
  {
    Exact_rational expected(0), found(0);
    double oblique_length = 0;
    for(const auto e : edges(m_mesh)) {
      Halfedge h = halfedge(e, m_mesh);
      if(!CGAL::is_border_edge(h, m_mesh) && !get(m_features, e))
        continue;
      h = CGAL::is_border(h, m_mesh) ? opposite(h, m_mesh) : h;
      const auto a = get(m_uv, prev(h, m_mesh)), b = get(m_uv, h);
      if(is_oblique(h)) {
        oblique_length += std::hypot(b.x() - a.x(), b.y() - a.y());
        continue;
      }
      expected += CGAL::abs(Exact_rational(Exact_rational(a.x()) - Exact_rational(b.x()))) +
                  CGAL::abs(Exact_rational(Exact_rational(a.y()) - Exact_rational(b.y())));
    }
    for(std::size_t a = 0; a < m_graph.number_of_arcs(); ++a)
      if(m_graph.arc_is_constrained(a))
        found += m_graph.arc_length(a);
    CHECK_IN(m_context, found == expected);
    if(m_oblique_length >= 0)
      CHECK_IN(m_context, std::abs(m_oblique_length - oblique_length) <= 1e-9 * oblique_length);
  }

  const Mesh& m_mesh;
  const UVMap& m_uv;
  const FeatureMap& m_features;
  const Graph& m_graph;
  const std::string m_context;
  double m_oblique_length = 0; // of arcs; negative if not known
  std::map<std::size_t, std::size_t> m_previous;
  std::map<std::size_t, std::pair<std::size_t, std::size_t> > m_sides; // patch and side
};

template <typename Mesh, typename UVMap, typename FeatureMap>
void check_layout(const Mesh& mesh, const UVMap& uv, const FeatureMap& features,
                  const IL::Motorcycle_graph<Mesh>& graph, const std::string& context)
{
  Checker<Mesh, UVMap, FeatureMap>(mesh, uv, features, graph, context).run();
}

template <typename Mesh, typename UVMap, typename FeatureMap>
void check_motorcycle_graph(const Mesh& mesh, const UVMap& uv, const FeatureMap& features,
                            const IL::Motorcycle_graph<Mesh>& graph, const std::string& context)
{
  Checker<Mesh, UVMap, FeatureMap> checker(mesh, uv, features, graph, context);
  checker.run();
  if(graph)
    checker.check_order();
}

// Points of the vertices of the edge or face that a node lies in, or of the vertex that it is.
using Node_place = std::vector<std::array<double, 3> >;

// What does not depend on the numbering: between which places arcs run, their lengths, and whether
// they are constrained; sizes of patches; places, kinds, and degrees of nodes.
struct Shape
{
  std::vector<std::tuple<Node_place, Node_place, Exact_rational, bool> > arcs;
  std::vector<std::pair<Exact_rational, Exact_rational> > patches;
  std::vector<std::pair<Exact_rational, std::ptrdiff_t> > cut_patches;
  std::vector<std::tuple<Node_place, IL::Layout_node, std::size_t> > nodes;

  friend bool operator==(const Shape& a, const Shape& b)
  {
    return a.arcs == b.arcs && a.patches == b.patches && a.cut_patches == b.cut_patches &&
           a.nodes == b.nodes;
  }
};

template <typename Mesh>
Node_place node_place(const IL::Motorcycle_graph<Mesh>& graph, const std::size_t n)
{
  const Mesh& mesh = graph.mesh();
  const auto points = get(CGAL::vertex_point, mesh);
  const auto h = graph.node_halfedge(n);
  Node_place result;
  const auto add = [&](const auto v) {
    const auto& p = get(points, v);
    result.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  };
  add(target(h, mesh));
  if(graph.node_place(n) != IL::Isocurve_place::VERTEX)
    add(source(h, mesh));
  if(graph.node_place(n) == IL::Isocurve_place::FACE)
    add(target(next(h, mesh), mesh));
  std::sort(result.begin(), result.end());
  return result;
}

template <typename Mesh>
Shape shape(const IL::Motorcycle_graph<Mesh>& graph)
{
  Shape result;
  for(std::size_t a = 0; a < graph.number_of_arcs(); ++a) {
    const auto ends = std::minmax({node_place(graph, graph.source(2 * a)),
                                   node_place(graph, graph.target(2 * a))});
    result.arcs.emplace_back(ends.first, ends.second, graph.arc_length(a),
                             graph.arc_is_constrained(a));
  }
  for(std::size_t p = 0; p < graph.number_of_patches(); ++p)
    if(graph.patch_is_cut(p))
      result.cut_patches.emplace_back(graph.patch_area(p), graph.patch_euler_characteristic(p));
    else
      result.patches.push_back(std::minmax({graph.patch_width(p), graph.patch_height(p)}));
  for(std::size_t n = 0; n < graph.number_of_nodes(); ++n)
    result.nodes.emplace_back(node_place(graph, n), graph.node_kind(n),
                              graph.half_arcs_around_node(n).size());
  std::sort(result.arcs.begin(), result.arcs.end());
  std::sort(result.patches.begin(), result.patches.end());
  std::sort(result.cut_patches.begin(), result.cut_patches.end());
  std::sort(result.nodes.begin(), result.nodes.end());
  return result;
}

} // namespace layout_checks

#endif // SEAMLESS_SNAPPING_TEST_LAYOUT_CHECKS_H
