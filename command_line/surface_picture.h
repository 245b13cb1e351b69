// A picture of a surface, lit from above: its faces, and lines and points on it as far as nothing
// hides them.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_SURFACE_PICTURE_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_SURFACE_PICTURE_H

#include "Model.h"
#include "depth_buffer.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Invariant: the buffer has all faces, so that lines and points can be drawn.
class Surface_picture
{
  using Face = Mesh::Face_index;
  using Vertex = Mesh::Vertex_index;
  using Point = Kernel::Point_3;

public:
  using Color = std::array<int, 3>;

  template <typename ColorOfFace>
  Surface_picture(const Mesh& mesh, const ColorOfFace& color)
    : m_mesh(mesh), m_is_closed(CGAL::is_closed(mesh)), m_buffer(0, 0, std::size_t(size))
  {
    for(const Vertex v : mesh.vertices())
      m_box += CGAL::Bbox_2(across(mesh.point(v)), up(mesh.point(v)), across(mesh.point(v)),
                            up(mesh.point(v)));
    m_svg.precision(6);
    m_svg << "<g stroke-width=\"0.5\">\n";
    for(const Face f : faces_from_behind()) {
      const std::vector<Point> points = corners(f);
      for(std::size_t i = 2; i < points.size(); ++i)
        m_buffer.add({pixel(points[0]), pixel(points[i - 1]), pixel(points[i])});
      add_face(f, color(f));
    }
    m_svg << "</g>\n";
  }

  template <typename Predicate>
  void add_edges(const Predicate& is_wanted, const double width, const std::string& color)
  {
    m_svg << "<path fill=\"none\" stroke=\"" << color << "\" stroke-width=\"" << width
          << "\" stroke-linecap=\"round\" d=\"";
    for(const Edge e : m_mesh.edges())
      if(is_wanted(e) && may_be_seen(e))
        add_edge(e);
    m_svg << "\"/>\n";
  }

  template <typename Predicate>
  void add_vertices(const Predicate& is_wanted, const double radius, const std::string& color)
  {
    m_svg << "<g fill=\"" << color << "\">\n";
    for(const Vertex v : m_mesh.vertices()) {
      const Depth_buffer::Point p = pixel(m_mesh.point(v));
      if(is_wanted(v) && m_buffer.is_visible(p, slack))
        m_svg << "<circle cx=\"" << p.x << "\" cy=\"" << p.y << "\" r=\"" << radius << "\"/>\n";
    }
    m_svg << "</g>\n";
  }

  // On the average, in pixels.
  double edge_length() const
  {
    double sum = 0;
    for(const Edge e : m_mesh.edges())
      sum += std::sqrt(CGAL::squared_distance(m_mesh.point(m_mesh.vertex(e, 0)),
                                              m_mesh.point(m_mesh.vertex(e, 1))));
    return scale() * sum / double((std::max)(m_mesh.number_of_edges(), Mesh::size_type(1)));
  }

  std::string svg() const
  {
    const double width = m_box.xmax() - m_box.xmin(), height = m_box.ymax() - m_box.ymin();
    const double ratio = height / (std::max)((std::max)(width, height), 1e-300);
    std::ostringstream os;
    os << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << size << ' '
       << (std::max)(size * ratio, 1.) << "\">\n"
       << "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" << m_svg.str() << "</svg>\n";
    return os.str();
  }

private:
  static constexpr double size = 900;
  static constexpr double slack = 0.004 * size;

  // Seen from (1, -2, 1), roughly.
  static double across(const Point& p) { return 0.894 * p.x() + 0.447 * p.y(); }
  static double up(const Point& p) { return 0.913 * p.z() - 0.183 * p.x() + 0.365 * p.y(); }

  template <typename Point_or_vector>
  static double depth(const Point_or_vector& p)
  { return 0.408 * p.x() - 0.816 * p.y() + 0.408 * p.z(); }

  double scale() const
  {
    const double extent = (std::max)(m_box.xmax() - m_box.xmin(), m_box.ymax() - m_box.ymin());
    return (size - 4) / (std::max)(extent, 1e-300);
  }

  Depth_buffer::Point pixel(const Point& p) const
  {
    return {2 + scale() * (across(p) - m_box.xmin()), 2 + scale() * (m_box.ymax() - up(p)),
            scale() * depth(p)};
  }

  std::vector<Point> corners(const Face f) const
  {
    std::vector<Point> result;
    for(const Vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(f)))
      result.push_back(m_mesh.point(v));
    return result;
  }

  Kernel::Vector_3 normal(const Face f) const
  {
    const std::vector<Point> points = corners(f);
    Kernel::Vector_3 result(0, 0, 0);
    for(std::size_t i = 2; i < points.size(); ++i)
      result = result + CGAL::cross_product(points[i - 1] - points[0], points[i] - points[0]);
    return result;
  }

  // Of a closed surface, others hide the faces that look away.
  bool may_be_seen(const Face f) const { return !m_is_closed || depth(normal(f)) > 0; }

  bool may_be_seen(const Edge e) const
  {
    const Halfedge h = m_mesh.halfedge(e);
    return !m_is_closed || may_be_seen(m_mesh.face(h)) ||
           may_be_seen(m_mesh.face(m_mesh.opposite(h)));
  }

  std::vector<Face> faces_from_behind() const
  {
    std::vector<std::pair<double, Face> > order;
    for(const Face f : m_mesh.faces()) {
      if(!may_be_seen(f))
        continue;
      const std::vector<Point> points = corners(f);
      double sum = 0;
      for(const Point& p : points)
        sum += depth(p);
      order.emplace_back(sum / double(points.size()), f);
    }
    std::sort(order.begin(), order.end());
    std::vector<Face> result;
    for(const auto& [unused, f] : order)
      result.push_back(f);
    return result;
  }

  void add_face(const Face f, const Color& color)
  {
    const Kernel::Vector_3 n = normal(f);
    const double length = (std::max)(std::sqrt(n.squared_length()), 1e-300);
    const double light = (0.2 * n.x() - 0.4 * n.y() + 0.9 * n.z()) / length;
    const double brightness = 0.78 + 0.22 * light;
    m_svg << "<path d=\"";
    char command = 'M';
    for(const Point& point : corners(f)) {
      const Depth_buffer::Point p = pixel(point);
      m_svg << command << p.x << ' ' << p.y;
      command = 'L';
    }
    m_svg << "Z\" style=\"fill:rgb(";
    const auto write_color = [&] {
      for(std::size_t k = 0; k < 3; ++k)
        m_svg << (k > 0 ? "," : "") << int(brightness * color[k]);
    };
    write_color();
    m_svg << ");stroke:rgb(";
    write_color();
    m_svg << ")\"/>\n";
  }

  void add_edge(const Edge e)
  {
    const Point a = m_mesh.point(m_mesh.vertex(e, 0)), b = m_mesh.point(m_mesh.vertex(e, 1));
    constexpr int n = 4; // parts that are hidden or seen by themselves
    for(int k = 0; k < n; ++k) {
      const auto at = [&](const double t) { return pixel(a + t / n * (b - a)); };
      if(!m_buffer.is_visible(at(k + 0.5), slack))
        continue;
      const auto p = at(k), q = at(k + 1);
      m_svg << 'M' << p.x << ' ' << p.y << 'L' << q.x << ' ' << q.y;
    }
  }

  const Mesh& m_mesh;
  bool m_is_closed;
  CGAL::Bbox_2 m_box;
  Depth_buffer m_buffer;
  std::ostringstream m_svg;
};

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_SURFACE_PICTURE_H
