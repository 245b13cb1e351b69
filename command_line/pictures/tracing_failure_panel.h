// One panel of a picture of a failure: the faces around the place where a traced isocurve ends,
// unfolded into one chart. Across a cut a face is put where its transition puts it, by the source
// of the edge, which is what naive code does; where the map is not exactly seamless, the faces then
// do not fit.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_FAILURE_PANEL_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_FAILURE_PANEL_H

#include "tracing_pieces.h"

#include <CGAL/Isocurves_and_layouts/trace_isocurve.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <map>
#include <ostream>
#include <string>

// p -> R p + t, with R a number of quarter turns.
struct Placement
{
  int turns = 0;
  Uv_vector t{{0, 0}};

  static Uv_vector rotated(const Uv_vector& p, int k)
  {
    switch(k & 3) {
    case 0: return p;
    case 1: return {{-p[1], p[0]}};
    case 2: return {{-p[0], -p[1]}};
    default: return {{p[1], -p[0]}};
    }
  }

  Uv_vector operator()(const Uv_vector& p) const
  {
    const auto r = rotated(p, turns);
    return {{r[0] + t[0], r[1] + t[1]}};
  }
};

template <typename TriangleMesh, typename HalfedgeUVMap>
class Tracing_failure_panel
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Halfedge = typename Graph_traits::halfedge_descriptor;
  using Face = typename Graph_traits::face_descriptor;
  using Vertex = typename Graph_traits::vertex_descriptor;
  using Transitions = CGAL::Seamless_snapping::Seam_transitions<TriangleMesh>;
  using Curve = CGAL::Isocurves_and_layouts::Isocurve<TriangleMesh>;
  using Point = CGAL::Isocurves_and_layouts::Isocurve_point<TriangleMesh>;
  using Vector = Uv_vector;

public:
  // `center` points to the corner that is shown in the middle; its chart is that of the panel.
  Tracing_failure_panel(const TriangleMesh& mesh, HalfedgeUVMap uv_map,
                        const Transitions& transitions, Halfedge center)
    : m_mesh(mesh), m_uv_map(uv_map), m_transitions(transitions), m_middle(uv(center))
  {
    for(const Halfedge h : CGAL::halfedges_around_face(halfedge(face(center, mesh), mesh), mesh))
      m_radius = (std::max)(m_radius, 0.9 * distance(uv(h), uv(prev(h, mesh))));
    unfold(face(center, mesh));
  }

  // A square of side 2 `size` around `x`, `y`.
  void write(std::ostream& os, const Curve& curve, const Vertex* expected, double x, double y,
             double size)
  {
    m_x = x;
    m_y = y;
    m_scale = size / m_radius;
    const std::string clip = "clip" + std::to_string(int(x)) + "_" + std::to_string(int(y));
    os << "<clipPath id=\"" << clip << "\"><rect x=\"" << x - size << "\" y=\"" << y - size
       << "\" width=\"" << 2 * size << "\" height=\"" << 2 * size << "\" rx=\"6\"/></clipPath>\n"
       << "<g clip-path=\"url(#" << clip << ")\"><rect x=\"" << x - size << "\" y=\"" << y - size
       << "\" width=\"" << 2 * size << "\" height=\"" << 2 * size << "\" fill=\"#fff\"/>\n";
    for(const auto& placed : m_placements)
      write_face(os, placed.first, placed.second);
    for(const auto& placed : m_placements)
      write_boundary(os, placed.first, placed.second);
    if(expected != nullptr)
      write_vertex(os, *expected);
    for(std::size_t i = 1; i < curve.points.size(); ++i)
      write_segment(os, curve.points[i - 1], curve.points[i]);
    if(CGAL::Isocurves_and_layouts::is_failure(curve.status))
      write_failure(os, curve.points.back());
    os << "</g><rect x=\"" << x - size << "\" y=\"" << y - size << "\" width=\"" << 2 * size
       << "\" height=\"" << 2 * size << "\" rx=\"6\" fill=\"none\" stroke=\"#999\"/>\n";
  }

private:
  Vector uv(Halfedge h) const
  {
    const auto& p = get(m_uv_map, h);
    return {{p.x(), p.y()}};
  }

  static double distance(const Vector& a, const Vector& b)
  {
    return std::hypot(a[0] - b[0], a[1] - b[1]);
  }

  // From face to face, as far as the panel shows.
  void unfold(Face first)
  {
    m_placements.emplace(first, Placement());
    for(std::deque<Face> queue(1, first); !queue.empty(); queue.pop_front()) {
      const Face f = queue.front();
      const Placement here = m_placements.at(f);
      for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
        const Halfedge g = opposite(h, m_mesh);
        const bool is_near = distance(here(uv(h)), m_middle) < 1.5 * m_radius ||
                             distance(here(uv(prev(h, m_mesh))), m_middle) < 1.5 * m_radius;
        if(is_border(g, m_mesh) || !is_near || m_placements.count(face(g, m_mesh)) != 0)
          continue;
        Placement there;
        there.turns = here.turns - m_transitions.rotation(h);
        const Vector source = here(uv(prev(h, m_mesh))), turned = there(uv(g));
        there.t = {{source[0] - turned[0], source[1] - turned[1]}};
        m_placements.emplace(face(g, m_mesh), there);
        queue.push_back(face(g, m_mesh));
      }
    }
  }

  Vector on_panel(const Vector& p) const
  {
    return {{m_x + m_scale * (p[0] - m_middle[0]), m_y - m_scale * (p[1] - m_middle[1])}};
  }

  void write_line(std::ostream& os, const Vector& a, const Vector& b, const char* style) const
  {
    const Vector p = on_panel(a), q = on_panel(b);
    os << "<path d=\"M" << p[0] << ' ' << p[1] << 'L' << q[0] << ' ' << q[1]
       << "\" fill=\"none\" stroke-linecap=\"round\" " << style << "/>\n";
  }

  void write_face(std::ostream& os, Face f, const Placement& here) const
  {
    os << "<path fill=\"#8aa4c0\" fill-opacity=\"0.28\" stroke=\"#b4bfca\" d=\"";
    char command = 'M';
    for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
      const Vector p = on_panel(here(uv(h)));
      os << command << p[0] << ' ' << p[1];
      command = 'L';
    }
    os << "Z\"/>\n";
  }

  void write_boundary(std::ostream& os, Face f, const Placement& here) const
  {
    for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
      const bool at_border = is_border(opposite(h, m_mesh), m_mesh);
      if(at_border || m_transitions.is_cut(h))
        write_line(os, here(uv(prev(h, m_mesh))), here(uv(h)),
                   at_border ? "stroke=\"#222\" stroke-width=\"3\""
                             : "stroke=\"#e69f00\" stroke-width=\"2.2\"");
    }
  }

  void write_vertex(std::ostream& os, Vertex v) const
  {
    for(const Halfedge h : CGAL::halfedges_around_target(halfedge(v, m_mesh), m_mesh)) {
      if(is_border(h, m_mesh) || m_placements.count(face(h, m_mesh)) == 0)
        continue;
      const Vector p = on_panel(m_placements.at(face(h, m_mesh))(uv(h)));
      os << "<circle cx=\"" << p[0] << "\" cy=\"" << p[1] << "\" r=\"6\" fill=\"#009e73\"/>\n";
    }
  }

  void write_segment(std::ostream& os, const Point& from, const Point& to) const
  {
    const auto placed = m_placements.find(face(to.halfedge(), m_mesh));
    if(placed == m_placements.end())
      return;
    const Placement& here = placed->second;
    const Uv_segment piece = curve_piece(from, to, m_mesh, m_uv_map);
    write_line(os, here(piece.first), here(piece.second),
               "stroke=\"#0072b2\" stroke-width=\"3\"");
  }

  // The end, and where the curve should go on.
  void write_failure(std::ostream& os, const Point& end) const
  {
    const Placement here = m_placements.at(face(end.halfedge(), m_mesh));
    const Vector p = CGAL::Isocurves_and_layouts::isocurve_uv(end, m_mesh, m_uv_map);
    const Vector d = Placement::rotated({{0.45 * m_radius, 0}}, int(end.direction()));
    const Vector tip{{p[0] + d[0], p[1] + d[1]}};
    write_line(os, here(p), here(tip),
               "stroke=\"#d55e00\" stroke-width=\"2.5\" stroke-dasharray=\"6 5\" "
               "marker-end=\"url(#arrow)\"");
    const Vector q = on_panel(here(p));
    os << "<circle cx=\"" << q[0] << "\" cy=\"" << q[1]
       << "\" r=\"5\" fill=\"#fff\" stroke=\"#d55e00\" stroke-width=\"2.5\"/>\n";
  }

  const TriangleMesh& m_mesh;
  HalfedgeUVMap m_uv_map;
  const Transitions& m_transitions;
  Vector m_middle;
  double m_radius = 0;
  std::map<Face, Placement> m_placements;
  double m_x = 0, m_y = 0, m_scale = 1;
};

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_FAILURE_PANEL_H
