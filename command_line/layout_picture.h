// A picture of a layout on the surface: each patch in a color unlike that of its neighbors, and the
// arcs, as far as nothing hides them.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_LAYOUT_PICTURE_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_LAYOUT_PICTURE_H

#include "Model.h"
#include "depth_buffer.h"

#include <CGAL/Seamless_snapping/copy_to_face_graph.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <set>
#include <utility>
#include <vector>

class Layout_picture
{
  using Graph = CGAL::Seamless_snapping::Motorcycle_graph<Mesh>;
  using Face = Mesh::Face_index;
  using Vertex = Mesh::Vertex_index;
  using Point = Kernel::Point_3;

public:
  explicit Layout_picture(const Graph& graph)
  {
    namespace SS = CGAL::Seamless_snapping;
    m_patches = m_mesh.add_property_map<Face, std::size_t>("f:patch").first;
    m_is_arc = m_mesh.add_property_map<Edge, bool>("e:arc").first;
    SS::refine_along_arcs(graph, m_mesh, SS::parameters::default_values(),
                          SS::parameters::face_patch_map(m_patches)
                            .edge_is_constrained_map(m_is_arc));
    choose_colors(graph);
    for(const Vertex v : m_mesh.vertices())
      m_box += CGAL::Bbox_2(across(m_mesh.point(v)), up(m_mesh.point(v)),
                            across(m_mesh.point(v)), up(m_mesh.point(v)));
  }

  void write(std::ostream& os) const
  {
    const double width = m_box.xmax() - m_box.xmin(), height = m_box.ymax() - m_box.ymin();
    const double ratio = height / (std::max)((std::max)(width, height), 1e-300);
    os.precision(6);
    os << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << size << ' '
       << (std::max)(size * ratio, 1.)
       << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<g stroke-width=\"0.5\">\n";
    Depth_buffer buffer(0, 0, std::size_t(size));
    std::vector<std::pair<double, Face> > order;
    const bool is_closed = CGAL::is_closed(m_mesh);
    for(const Face f : m_mesh.faces()) {
      if(is_closed && depth(normal(f)) <= 0)
        continue; // others hide it
      const std::vector<Point> points = corners(f);
      double sum = 0;
      for(const Point& p : points)
        sum += depth(p);
      order.emplace_back(sum / double(points.size()), f);
    }
    std::sort(order.begin(), order.end());
    for(const auto& [unused, f] : order)
      write_face(os, f, buffer);
    os << "</g>\n<path fill=\"none\" stroke=\"#222\" stroke-width=\"1.6\" stroke-linecap=\"round\" "
          "d=\"";
    for(const Edge e : m_mesh.edges())
      if(m_is_arc[e])
        write_edge(os, e, buffer);
    os << "\"/>\n</svg>\n";
  }

private:
  static constexpr double size = 900;

  // Seen from (1, -2, 1), roughly.
  static double across(const Point& p) { return 0.894 * p.x() + 0.447 * p.y(); }
  static double up(const Point& p) { return 0.913 * p.z() - 0.183 * p.x() + 0.365 * p.y(); }

  template <typename Point_or_vector>
  static double depth(const Point_or_vector& p)
  { return 0.408 * p.x() - 0.816 * p.y() + 0.408 * p.z(); }

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

  Depth_buffer::Point pixel(const Point& p) const
  {
    const double extent = (std::max)(m_box.xmax() - m_box.xmin(), m_box.ymax() - m_box.ymin());
    const double scale = (size - 4) / (std::max)(extent, 1e-300);
    return {2 + scale * (across(p) - m_box.xmin()), 2 + scale * (m_box.ymax() - up(p)),
            scale * depth(p)};
  }

  // The first one that no neighbor has, as long as there is one.
  void choose_colors(const Graph& graph)
  {
    constexpr std::size_t n = 6;
    m_colors.assign(graph.number_of_patches(), n);
    for(std::size_t p = 0; p < m_colors.size(); ++p) {
      std::set<std::size_t> taken;
      for(const auto& cycle : graph.patch_cycles(p))
        for(const std::size_t h : cycle) {
          const std::size_t q = graph.patch(graph.opposite(h));
          if(q != graph.null_patch)
            taken.insert(m_colors[q]);
        }
      std::size_t color = 0;
      while(taken.count(color) != 0 && color + 1 < n)
        ++color;
      m_colors[p] = color;
    }
  }

  // Lit from above.
  void write_face(std::ostream& os, const Face f, Depth_buffer& buffer) const
  {
    static constexpr std::array<std::array<int, 3>, 6> colors = {{
      {{158, 202, 225}}, {{253, 208, 162}}, {{161, 217, 155}}, {{252, 187, 161}},
      {{202, 189, 220}}, {{225, 222, 150}}}};
    const std::vector<Point> points = corners(f);
    for(std::size_t i = 2; i < points.size(); ++i)
      buffer.add({pixel(points[0]), pixel(points[i - 1]), pixel(points[i])});
    const Kernel::Vector_3 n = normal(f);
    const double length = (std::max)(std::sqrt(n.squared_length()), 1e-300);
    const double light = (0.2 * n.x() - 0.4 * n.y() + 0.9 * n.z()) / length;
    const double brightness = 0.78 + 0.22 * light;
    os << "<path d=\"";
    char command = 'M';
    for(const Point& p : points) {
      os << command << pixel(p).x << ' ' << pixel(p).y;
      command = 'L';
    }
    const auto& color = colors[m_colors[m_patches[f]]];
    os << "Z\" style=\"fill:rgb(";
    const auto write_color = [&] {
      for(std::size_t k = 0; k < 3; ++k)
        os << (k > 0 ? "," : "") << int(brightness * color[k]);
    };
    write_color();
    os << ");stroke:rgb(";
    write_color();
    os << ")\"/>\n";
  }

  void write_edge(std::ostream& os, const Edge e, const Depth_buffer& buffer) const
  {
    const Point a = m_mesh.point(m_mesh.vertex(e, 0)), b = m_mesh.point(m_mesh.vertex(e, 1));
    constexpr int n = 4; // parts that are hidden or seen by themselves
    for(int k = 0; k < n; ++k) {
      const auto at = [&](const double t) { return pixel(a + t / n * (b - a)); };
      if(!buffer.is_visible(at(k + 0.5), 0.01 * size))
        continue;
      const auto p = at(k), q = at(k + 1);
      os << 'M' << p.x << ' ' << p.y << 'L' << q.x << ' ' << q.y;
    }
  }

  Mesh m_mesh; // refined along the arcs
  Mesh::Property_map<Face, std::size_t> m_patches;
  Edge_bool_map m_is_arc;
  std::vector<std::size_t> m_colors; // per patch
  CGAL::Bbox_2 m_box;
};

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_LAYOUT_PICTURE_H
