// A picture of a connection and of a cycle, in the way of Fig. 4 of the paper: isocurves that miss
// what they should meet by a rounding error, and the same curves after snapping with constraints.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_CONSTRAINT_FIGURE_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_CONSTRAINT_FIGURE_H

#include "tracing_overview.h"
#include "tracing_types.h"

#include <CGAL/Seamless_snapping/seam_transitions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

// Where curves pass a vertex, relative to it: they run to the right, in this distance above it.
// Seen so close, the edges of the vertex are straight lines.
class Passes_at_vertex
{
  using Vector = std::array<double, 2>;

public:
  Passes_at_vertex(const Mesh& mesh, const Uv_map& uv_map, const IL::Seam_transitions<Mesh>& seams,
                   const Curve& curve, const Vertex v)
  {
    const auto& points = curve.points;
    for(std::size_t i = 1; i < points.size(); ++i) {
      const bool arrives = points[i].place() == IL::Isocurve_place::VERTEX;
      Halfedge corner = points[i].halfedge();
      if(!arrives && points[i - 1].place() == IL::Isocurve_place::EDGE)
        corner = mesh.next(mesh.opposite(points[i - 1].halfedge()));
      if(mesh.target(corner) != v)
        continue;
      const int direction = int(points[i].direction());
      const auto p = uv_map[corner];
      const double beside = points[i].approximate_constant_coordinate() -
                            (direction % 2 == 0 ? p.y() : p.x());
      const double sign = (direction == 0 || direction == 3) ? 1 : -1;
      if(!arrives && std::abs(beside) > 1e-9)
        continue;
      if(m_heights.empty())
        collect_edges(mesh, uv_map, seams, corner, direction);
      m_heights.push_back(arrives ? 0 : sign * beside);
    }
  }

  // The largest of the first few.
  double distance() const
  {
    double result = 0;
    for(std::size_t i = 0; i < (std::min)(m_heights.size(), std::size_t(3)); ++i)
      result = (std::max)(result, std::abs(m_heights[i]));
    return result;
  }

  void write(std::ostream& os, const double x, const double y, const double radius,
             const double scale, const bool starts_here) const
  {
    const std::string clip = "clip" + std::to_string(int(x)) + "_" + std::to_string(int(y));
    os << "<clipPath id=\"" << clip << "\"><circle cx=\"" << x << "\" cy=\"" << y << "\" r=\""
       << radius << "\"/></clipPath>\n<g clip-path=\"url(#" << clip << ")\"><circle cx=\"" << x
       << "\" cy=\"" << y << "\" r=\"" << radius << "\" fill=\"#e3e9f0\"/>\n";
    for(const Vector& e : m_edges)
      line(os, x, y, x + 2 * radius * e[0], y - 2 * radius * e[1], "#9aa7b5", 1.2);
    if(starts_here)
      line(os, x, y, x + radius, y, "#0072b2", 3);
    for(std::size_t i = 0; i < (std::min)(m_heights.size(), std::size_t(3)); ++i) {
      const double height = y - scale * m_heights[i];
      const bool misses = m_heights[i] != 0;
      line(os, x - radius, height, x, height, "#0072b2", 3);
      if(misses)
        line(os, x, height, x + radius, height, "#d55e00", 3);
    }
    os << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"6\" fill=\"#009e73\"/></g>\n"
       << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"" << radius
       << "\" fill=\"none\" stroke=\"#666\" stroke-width=\"1.5\"/>\n";
  }

private:
  static void line(std::ostream& os, double x0, double y0, double x1, double y1, const char* color,
                   double width)
  {
    os << "<path stroke=\"" << color << "\" stroke-width=\"" << width << "\" d=\"M" << x0 << ' '
       << y0 << 'L' << x1 << ' ' << y1 << "\"/>\n";
  }

  // All edges that are less than a half turn away, seen from the corner.
  void collect_edges(const Mesh& mesh, const Uv_map& uv_map,
                     const IL::Seam_transitions<Mesh>& seams, const Halfedge corner,
                     const int direction)
  {
    int d = direction;
    const std::size_t half = (mesh.degree(mesh.target(corner)) + 1) / 2;
    Halfedge h = corner;
    for(std::size_t i = 0; i < half && !mesh.is_border(h); ++i) { // counterclockwise
      add_edge(uv_map[h], uv_map[mesh.prev(h)], d);
      d = (d + seams.rotation(h)) % 4;
      h = mesh.prev(mesh.opposite(h));
    }
    h = corner;
    d = direction;
    for(std::size_t i = 0; i < half && !mesh.is_border(h); ++i) {
      add_edge(uv_map[h], uv_map[mesh.next(h)], d);
      d = (d + seams.rotation(mesh.next(h))) % 4;
      h = mesh.opposite(mesh.next(h));
    }
  }

  void add_edge(const Kernel::Point_2& from, const Kernel::Point_2& to, const int direction)
  {
    Vector e{{to.x() - from.x(), to.y() - from.y()}};
    const double length = std::hypot(e[0], e[1]);
    for(int k = 0; k < direction; ++k) // clockwise, until the direction is that of u
      e = {{e[1], -e[0]}};
    m_edges.push_back({{e[0] / length, e[1] / length}});
  }

  std::vector<Vector> m_edges;
  std::vector<double> m_heights;
};

class Constraint_figure
{
public:
  Constraint_figure(std::ostream& os, const Pair_of_maps& maps, const Tracer& inexact,
                    const Tracer& exact)
    : m_os(os), m_maps(maps), m_inexact(inexact), m_exact(exact),
      m_inexact_seams(IL::seam_transitions(maps.mesh, maps.inexact,
                                           parameters::tolerance(maps.tolerance))),
      m_exact_seams(IL::seam_transitions(maps.mesh, maps.exact))
  { }

  // Of each kind the curve that can be seen best, among those that go right on the exact map.
  void write(const std::vector<Curve>& failures)
  {
    write_head(m_os, 1400, 1110);
    const std::string style = "font-size=\"22\" text-anchor=\"middle\" fill=";
    write_text(m_os, 360, 44, "inexact", style + "\"#d55e00\"");
    write_text(m_os, 1040, 44, "exact", style + "\"#009e73\"");
    double y = 90;
    for(const IL::Isocurve_status status :
        {IL::Isocurve_status::MISSED_TARGET, IL::Isocurve_status::SPIRALS}) {
      const Curve* best = nullptr;
      std::size_t most = 0;
      for(const Curve& curve : failures)
        if(curve.status == status && number_of_visible_points(curve) > most && goes_right(curve)) {
          best = &curve;
          most = number_of_visible_points(curve);
        }
      if(best != nullptr)
        write_row(*best, y);
      y += 500;
    }
    write_legend();
    m_os << "</svg>\n";
  }

private:
  using Overview = Tracing_overview<Mesh, Uv_map>;

  void write_legend()
  {
    m_os << "<circle cx=\"50\" cy=\"1080\" r=\"6\" fill=\"#222\"/>"
            "<circle cx=\"250\" cy=\"1080\" r=\"6\" fill=\"#009e73\"/>"
            "<path stroke-width=\"3\" stroke=\"#0072b2\" d=\"M470 1080h30\"/>"
            "<path stroke-width=\"3\" stroke=\"#d55e00\" d=\"M640 1080h30\"/>\n";
    write_text(m_os, 66, 1086, "start of the curve", "");
    write_text(m_os, 266, 1086, "vertex to be met", "");
    write_text(m_os, 510, 1086, "isocurve", "");
    write_text(m_os, 680, 1086, "its way on, after it has missed the vertex", "");
  }

  // On faces turned to the viewer; 0 for curves whose start or end is out of sight, and for those
  // along edges of the mesh.
  std::size_t number_of_visible_points(const Curve& curve) const
  {
    const auto& points = curve.points;
    const std::vector<Curve> none;
    const Overview view(m_maps.mesh, m_maps.inexact, none, 0);
    if(!view.is_visible(points.front().halfedge()) || !view.is_visible(points.back().halfedge()))
      return 0;
    std::size_t result = 0, at_vertex = 0;
    for(const auto& point : points) {
      result += view.is_visible(point.halfedge()) ? 1 : 0;
      at_vertex += is_at_vertex(point) ? 1 : 0;
    }
    return 2 * at_vertex > points.size() ? 0 : result;
  }

  bool is_at_vertex(const IL::Isocurve_point<Mesh>& point) const
  {
    if(point.place() != IL::Isocurve_place::EDGE)
      return true;
    const double t =
      CGAL::to_double(IL::isocurve_parameter(point, m_maps.mesh, m_maps.inexact));
    return t < 1e-6 || t > 1 - 1e-6;
  }

  // The vertex that a curve should have met.
  Vertex expected_end(const Curve& curve) const
  {
    const Mesh& mesh = m_maps.mesh;
    return curve.status == IL::Isocurve_status::SPIRALS
             ? mesh.target(curve.points.front().halfedge())
             : mesh.target(mesh.next(mesh.opposite(curve.points.back().halfedge())));
  }

  bool goes_right(const Curve& curve) const
  {
    const Curve exact = traced(m_exact, curve, true, 4 * curve.points.size());
    return (exact.status == IL::Isocurve_status::CLOSED ||
            exact.status == IL::Isocurve_status::SINGULAR_VERTEX) &&
           m_maps.mesh.target(exact.points.back().halfedge()) == expected_end(curve);
  }

  Curve traced(const Tracer& tracer, const Curve& curve, const bool exactly,
               const std::size_t number) const
  {
    return tracer.trace(curve.start, curve.direction,
                        parameters::maximum_number(number).decide_exactly(exactly).near_distance(0.));
  }

  void write_row(const Curve& curve, const double y)
  {
    const bool spirals = curve.status == IL::Isocurve_status::SPIRALS;
    const Mesh& mesh = m_maps.mesh;
    const std::size_t n = curve.points.size();
    const Vertex start = mesh.target(curve.points.front().halfedge());
    const Vertex end = expected_end(curve);
    write_text(m_os, 40, y, spirals ? "An isocurve that should close forms a spiral."
                                    : "An isocurve that should meet a vertex misses it.", "");
    Curve on = traced(m_inexact, curve, false, 4 * n);
    const Passes_at_vertex passes(mesh, m_maps.inexact, m_inexact_seams, on, end);
    Curve rest = on;
    rest.status = curve.status;
    rest.points.erase(rest.points.begin(), rest.points.begin() + std::ptrdiff_t(n - 1));
    on.points.resize(n);
    on.status = IL::Isocurve_status::TARGET;
    const double scale = 20 / passes.distance();
    write_surface(m_maps.inexact, {on, rest}, start, end, 360, y);
    passes.write(m_os, 150, y + 370, 90, scale, spirals);
    std::ostringstream distance;
    distance.precision(1);
    distance << std::scientific << passes.distance();
    write_text(m_os, 255, y + 440,
               "It passes the vertex at a distance of " + distance.str() + ".", "");

    const Curve exact = traced(m_exact, curve, true, 4 * n);
    write_surface(m_maps.exact, {exact}, start, end, 1040, y);
    Passes_at_vertex(mesh, m_maps.exact, m_exact_seams, exact, end)
      .write(m_os, 830, y + 370, 90, scale, spirals);
    write_text(m_os, 935, y + 440, spirals ? "It closes exactly." : "It meets the vertex exactly.",
               "");
  }

  void write_surface(const Uv_map& uv_map, const std::vector<Curve>& curves, const Vertex start,
                     const Vertex end, const double x, const double y)
  {
    const Overview overview(m_maps.mesh, uv_map, curves, 2.6);
    overview.write_projection(m_os, x, y + 200, 600);
    overview.write_vertex(m_os, start, "r=\"6\" fill=\"#222\"", x, y + 200, 600);
    overview.write_vertex(m_os, end, "r=\"6\" fill=\"#009e73\"", x, y + 200, 600);
  }

  std::ostream& m_os;
  const Pair_of_maps& m_maps;
  const Tracer &m_inexact, &m_exact;
  IL::Seam_transitions<Mesh> m_inexact_seams, m_exact_seams;
};

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_CONSTRAINT_FIGURE_H
