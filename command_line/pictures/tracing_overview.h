// Traced isocurves in the domain and, projected, on the surface, as SVG; and in space as polylines.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_OVERVIEW_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_OVERVIEW_H

#include "depth_buffer.h"
#include "tracing_pieces.h"

#include <CGAL/Isocurves_and_layouts/trace_isocurve.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

template <typename Mesh, typename UVMap>
class Tracing_overview
{
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  using Face = typename boost::graph_traits<Mesh>::face_descriptor;
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Curve = CGAL::Isocurves_and_layouts::Isocurve<Mesh>;
  using Vector = Uv_vector;

public:
  // \param most_points of each curve that are drawn
  Tracing_overview(const Mesh& mesh, UVMap uv_map, const std::vector<Curve>& curves,
                   const double line_width,
                   const std::size_t most_points = (std::numeric_limits<std::size_t>::max)())
    : m_mesh(mesh), m_uv_map(uv_map), m_curves(curves), m_line_width(line_width),
      m_most_points(most_points)
  { }

  // For a legend; nothing where all is drawn.
  std::string what_is_drawn() const
  {
    const bool is_all = std::all_of(m_curves.begin(), m_curves.end(), [&](const Curve& curve)
                                    { return curve.points.size() <= m_most_points; });
    return is_all ? "" : "the first " + std::to_string(m_most_points) + " points of each curve";
  }

  // The triangles of the domain, and the pieces of the curves in each.
  void write_domain(std::ostream& os, double x, double y, double size) const
  {
    CGAL::Bbox_2 box;
    for(const Face f : faces(m_mesh))
      for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh))
        box += get(m_uv_map, h).bbox();
    const auto place = fit(box, x, y, size);
    os << "<path fill=\"#eef1f5\" stroke=\"#c3cbd4\" stroke-width=\"0.5\" d=\"";
    for(const Face f : faces(m_mesh)) {
      char command = 'M';
      for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
        const Vector p = place({{get(m_uv_map, h).x(), get(m_uv_map, h).y()}});
        os << command << p[0] << ' ' << p[1];
        command = 'L';
      }
      os << 'Z';
    }
    os << "\"/>\n";
    for(const bool failed : {false, true})
      for(const Curve& curve : m_curves)
        if(CGAL::Isocurves_and_layouts::is_failure(curve.status) == failed)
          write_curve_in_domain(os, curve, failed, place);
  }

  // Faces from back to front, and the parts of the curves that no face hides.
  void write_projection(std::ostream& os, double x, double y, double size) const
  {
    std::vector<std::pair<double, Face> > order;
    const auto points = get(CGAL::vertex_point, m_mesh);
    const bool is_closed = CGAL::is_closed(m_mesh);
    for(const Face f : faces(m_mesh)) {
      if(is_closed && !is_visible(halfedge(f, m_mesh)))
        continue;
      double sum = 0;
      for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh))
        sum += depth(get(points, target(h, m_mesh)));
      order.emplace_back(sum, f);
    }
    std::sort(order.begin(), order.end());
    const auto place = fit(projected_box(), x, y, size);
    Depth_buffer buffer(x - size / 2, y - size / 2, std::size_t(size));
    os << "<g stroke=\"#aeb8c3\" stroke-width=\"0.4\">\n";
    for(const auto& [unused, f] : order)
      write_face(os, f, place, buffer);
    os << "</g>\n";
    for(const bool failed : {false, true})
      for(const Curve& curve : m_curves)
        if(CGAL::Isocurves_and_layouts::is_failure(curve.status) == failed)
          write_curve_in_space(os, curve, failed, place, buffer);
  }

  // Whether the face of a halfedge is turned to the viewer.
  bool is_visible(const Halfedge h) const { return depth(normal(h)) > 0; }

  // A dot on such a projection.
  void write_vertex(std::ostream& os, Vertex v, const char* style, double x, double y,
                    double size) const
  {
    const auto place = fit(projected_box(), x, y, size);
    const Vector p = place(flat(get(get(CGAL::vertex_point, m_mesh), v)));
    os << "<circle cx=\"" << p[0] << "\" cy=\"" << p[1] << "\" " << style << "/>\n";
  }

  // `v` and `l` statements of OBJ. Each edge has one, as of longer ones, Blender reads the first edge.
  void write_OBJ(std::ostream& os) const
  {
    os.precision(17);
    std::size_t next = 1;
    for(const Curve& curve : m_curves) {
      for(const auto& point : curve.points)
        os << "v " << space(point) << "\n";
      os << "# " << curve.status << "\n";
      for(std::size_t i = 1; i < curve.points.size(); ++i, ++next)
        os << "l " << next << ' ' << next + 1 << "\n";
      next += curve.points.empty() ? 0 : 1;
    }
  }

  // Vertices and edges of PLY, the edges with the status of their curve.
  void write_PLY(std::ostream& os) const
  {
    std::size_t n = 0, m = 0;
    for(const Curve& curve : m_curves) {
      n += curve.points.size();
      m += curve.points.empty() ? 0 : curve.points.size() - 1;
    }
    os << "ply\nformat ascii 1.0\nelement vertex " << n
       << "\nproperty double x\nproperty double y\nproperty double z\nelement edge " << m
       << "\nproperty int vertex1\nproperty int vertex2\nproperty uchar status\nend_header\n";
    os.precision(17);
    for(const Curve& curve : m_curves)
      for(const auto& point : curve.points)
        os << space(point) << "\n";
    std::size_t first = 0;
    for(const Curve& curve : m_curves) {
      for(std::size_t i = 1; i < curve.points.size(); ++i)
        os << first + i - 1 << ' ' << first + i << ' ' << int(curve.status) << "\n";
      first += curve.points.size();
    }
  }

private:
  using Point = CGAL::Isocurves_and_layouts::Isocurve_point<Mesh>;

  auto space(const Point& point) const
  {
    return CGAL::Isocurves_and_layouts::isocurve_point_3(point, m_mesh, m_uv_map,
                                                         get(CGAL::vertex_point, m_mesh));
  }

  CGAL::Bbox_2 projected_box() const
  {
    CGAL::Bbox_2 box;
    for(const auto v : vertices(m_mesh)) {
      const Vector q = flat(get(get(CGAL::vertex_point, m_mesh), v));
      box += CGAL::Bbox_2(q[0], q[1], q[0], q[1]);
    }
    return box;
  }

  // Seen from (1, -2, 1), roughly.
  template <typename Point_3>
  static Vector flat(const Point_3& p)
  { return {{0.894 * p.x() + 0.447 * p.y(), 0.913 * p.z() - 0.183 * p.x() + 0.365 * p.y()}}; }
  template <typename Point_or_vector_3>
  static double depth(const Point_or_vector_3& p)
  { return 0.408 * p.x() - 0.816 * p.y() + 0.408 * p.z(); }

  auto normal(const Halfedge h) const
  {
    const auto points = get(CGAL::vertex_point, m_mesh);
    const auto a = get(points, source(h, m_mesh)), b = get(points, target(h, m_mesh)),
               c = get(points, target(next(h, m_mesh), m_mesh));
    return CGAL::cross_product(b - a, c - a);
  }

  // Of a face lit from above.
  int brightness(const Face f) const
  {
    const auto n = normal(halfedge(f, m_mesh));
    const double length = std::sqrt(CGAL::to_double(n.squared_length()));
    const double light = (0.2 * n.x() - 0.4 * n.y() + 0.9 * n.z()) / (std::max)(length, 1e-300);
    return 205 + int(42 * (std::max)(light, 0.));
  }

  static auto fit(const CGAL::Bbox_2& box, double x, double y, double size)
  {
    const double width = box.xmax() - box.xmin(), height = box.ymax() - box.ymin();
    const double scale = size / (std::max)((std::max)(width, height), 1e-300);
    const Vector middle{{(box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2}};
    return [=](const Vector& p) -> Vector {
      return {{x + scale * (p[0] - middle[0]), y - scale * (p[1] - middle[1])}};
    };
  }

  std::size_t number_drawn(const Curve& curve) const
  { return (std::min)(curve.points.size(), m_most_points); }

  static const char* color(bool failed) { return failed ? "#d55e00" : "#0072b2"; }

  template <typename Place>
  void write_curve_in_domain(std::ostream& os, const Curve& curve, bool failed,
                             const Place& place) const
  {
    os << "<path fill=\"none\" stroke-width=\"" << m_line_width << "\" stroke=\"" << color(failed)
       << "\" d=\"";
    for(std::size_t i = 1; i < number_drawn(curve); ++i) {
      const Uv_segment piece = curve_piece(curve.points[i - 1], curve.points[i], m_mesh, m_uv_map);
      const Vector p = place(piece.first), q = place(piece.second);
      os << 'M' << p[0] << ' ' << p[1] << 'L' << q[0] << ' ' << q[1];
    }
    os << "\"/>\n";
    if(!failed)
      return;
    const Vector end =
      place(CGAL::Isocurves_and_layouts::isocurve_uv(curve.points.back(), m_mesh, m_uv_map));
    os << "<circle cx=\"" << end[0] << "\" cy=\"" << end[1]
       << "\" r=\"3.5\" fill=\"#fff\" stroke=\"#d55e00\" stroke-width=\"1.6\"/>\n";
  }

  template <typename Point_3, typename Place>
  static Depth_buffer::Point pixel(const Point_3& p, const Place& place)
  {
    const Vector q = place(flat(p));
    return {q[0], q[1], depth(p)};
  }

  template <typename Place>
  void write_face(std::ostream& os, Face f, const Place& place, Depth_buffer& buffer) const
  {
    const auto points = get(CGAL::vertex_point, m_mesh);
    std::array<Depth_buffer::Point, 3> corners;
    std::size_t i = 0;
    for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh))
      corners[i++] = pixel(get(points, target(h, m_mesh)), place);
    buffer.add(corners);
    const int gray = brightness(f);
    os << "<path fill=\"#" << std::hex << gray - 8 << gray - 4 << gray << std::dec << "\" d=\"M"
       << corners[0].x << ' ' << corners[0].y << 'L' << corners[1].x << ' ' << corners[1].y << 'L'
       << corners[2].x << ' ' << corners[2].y << "Z\"/>\n";
  }

  template <typename Place>
  void write_curve_in_space(std::ostream& os, const Curve& curve, const bool failed,
                            const Place& place, const Depth_buffer& buffer) const
  {
    const CGAL::Bbox_2 box = projected_box();
    const double slack = 0.01 * (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    os << "<path fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\" stroke-width=\""
       << m_line_width << "\" stroke=\"" << color(failed) << "\" d=\"";
    bool is_drawn = false;
    for(std::size_t i = 1; i < number_drawn(curve); ++i) {
      const auto a = space(curve.points[i - 1]), b = space(curve.points[i]);
      const std::size_t n = 4; // parts of a piece that are hidden or seen by themselves
      for(std::size_t k = 0; k < n; ++k) {
        const auto at = [&](const double t) { return pixel(a + t / double(n) * (b - a), place); };
        if(!buffer.is_visible(at(double(k) + 0.5), slack)) {
          is_drawn = false;
          continue;
        }
        const auto p = at(double(k)), q = at(double(k + 1));
        if(!is_drawn)
          os << 'M' << p.x << ' ' << p.y;
        os << 'L' << q.x << ' ' << q.y;
        is_drawn = true;
      }
    }
    os << "\"/>\n";
  }

  const Mesh& m_mesh;
  UVMap m_uv_map;
  const std::vector<Curve>& m_curves;
  double m_line_width;
  std::size_t m_most_points;
};

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_OVERVIEW_H
