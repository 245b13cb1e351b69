// A picture of a surface, lit from above: its faces, from behind, each with the lines along its
// edges, so that what comes later hides both; and points on it as far as nothing hides them.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_SURFACE_PICTURE_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_SURFACE_PICTURE_H

#include "../Model.h"
#include "Natural_view.h"
#include "depth_buffer.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Edges that are drawn, and how.
struct Line_style
{
  std::function<bool(Edge)> is_wanted;
  double width;
  std::string color;
};

// On the average, in the units of the mesh.
inline double edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(const Edge e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)),
                                            mesh.point(mesh.vertex(e, 1))));
  return sum / double((std::max)(mesh.number_of_edges(), Mesh::size_type(1)));
}

// Invariant: the buffer has all that is drawn, so that points can be added.
class Surface_picture
{
  using Face = Mesh::Face_index;
  using Vertex = Mesh::Vertex_index;
  using Point = Kernel::Point_3;

public:
  using Color = std::array<int, 3>;

  // Of `styles`, functions of the number of pixels that a unit has, the first is also that of
  // outlines inside of faces that are bent.
  template <typename ColorOfFace, typename StylesOfScale>
  Surface_picture(const Mesh& mesh, const ColorOfFace& color, const StylesOfScale& styles)
    : m_mesh(mesh), m_is_closed(CGAL::is_closed(mesh)), m_view(mesh),
      m_buffer(0, 0, std::size_t(size))
  {
    for(const Vertex v : mesh.vertices())
      m_box += Kernel::Point_2(m_view.across(mesh.point(v)), m_view.up(mesh.point(v))).bbox();
    m_svg.precision(6);
    m_svg << "<g stroke-width=\"0.5\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    const std::vector<Line_style> lines = styles(scale());
    for(const Piece& piece : pieces_from_behind()) {
      for(std::size_t i = 2; i < piece.corners.size(); ++i)
        m_buffer.add({pixel(piece.corners[0].point), pixel(piece.corners[i - 1].point),
                      pixel(piece.corners[i].point)});
      add_piece(piece, color(piece.face), lines);
    }
    m_svg << "</g>\n";
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

  std::string svg() const
  {
    std::ostringstream os;
    os << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << size << ' '
       << 2 * margin + scale() * (m_box.ymax() - m_box.ymin()) << "\">\n"
       << "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" << m_svg.str() << "</svg>\n";
    return os.str();
  }

private:
  static constexpr double size = 900;
  static constexpr double slack = 0.004 * size;
  static constexpr double margin = 6; // in which dots at the silhouette fit

  double scale() const
  {
    const double extent = (std::max)(m_box.xmax() - m_box.xmin(), m_box.ymax() - m_box.ymin());
    return (size - 2 * margin) / (std::max)(extent, 1e-300);
  }

  Depth_buffer::Point pixel(const Point& p) const
  {
    return {margin + scale() * (m_view.across(p) - m_box.xmin()),
            margin + scale() * (m_box.ymax() - m_view.up(p)), scale() * m_view.depth(p)};
  }

  // A corner, and the side that leads to it: an edge, or one between two triangles of a face, which
  // is an outline if the other one is hidden.
  struct Corner
  {
    Point point;
    Vertex vertex;
    Halfedge side;
    bool is_outline;
  };

  // A face, or one triangle of it.
  struct Piece
  {
    Face face;
    std::vector<Corner> corners;
  };

  std::vector<Corner> corners(const Face f) const
  {
    std::vector<Corner> result;
    for(const Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f)))
      result.push_back({m_mesh.point(m_mesh.target(h)), m_mesh.target(h), h, false});
    return result;
  }

  static Kernel::Vector_3 normal(const std::vector<Corner>& corners)
  {
    Kernel::Vector_3 result(0, 0, 0);
    for(std::size_t i = 2; i < corners.size(); ++i)
      result = result + CGAL::cross_product(corners[i - 1].point - corners[0].point,
                                            corners[i].point - corners[0].point);
    return result;
  }

  // Of a closed surface, others hide the triangles that look away. A face that is bent can have
  // some of both kinds.
  void add_pieces(const Face f, std::vector<Piece>& pieces) const
  {
    const std::vector<Corner> whole = corners(f);
    std::vector<Piece> triangles;
    std::vector<char> is_seen(whole.size() + 1, 0); // of the triangle before corner i
    for(std::size_t i = 2; i < whole.size(); ++i)
      is_seen[i] = !m_is_closed || m_view.depth(normal({whole[0], whole[i - 1], whole[i]})) > 0;
    for(std::size_t i = 2; i < whole.size(); ++i)
      if(is_seen[i]) {
        Corner first = whole[0], second = whole[i - 1];
        if(i + 1 < whole.size())
          first.side = Mesh::null_halfedge(), first.is_outline = !is_seen[i + 1];
        if(i > 2)
          second.side = Mesh::null_halfedge(), second.is_outline = !is_seen[i - 1];
        triangles.push_back({f, {first, second, whole[i]}});
      }
    if(triangles.size() + 2 == whole.size())
      pieces.push_back({f, whole});
    else
      pieces.insert(pieces.end(), triangles.begin(), triangles.end());
  }

  std::vector<Piece> pieces_from_behind() const
  {
    std::vector<Piece> pieces;
    for(const Face f : m_mesh.faces())
      add_pieces(f, pieces);
    const auto mean_depth = [this](const Piece& piece) {
      double sum = 0;
      for(const Corner& c : piece.corners)
        sum += m_view.depth(c.point);
      return sum / double(piece.corners.size());
    };
    std::stable_sort(pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
      return mean_depth(a) < mean_depth(b);
    });
    return pieces;
  }

  void write_point(std::ostream& os, const char command, const Point& point) const
  {
    const Depth_buffer::Point p = pixel(point);
    os << command << p.x << ' ' << p.y;
  }

  // The stroke of the area closes the seams to its neighbors.
  void add_piece(const Piece& piece, const Color& color, const std::vector<Line_style>& lines)
  {
    const Kernel::Vector_3 n = normal(corners(piece.face));
    const double length = (std::max)(std::sqrt(n.squared_length()), 1e-300);
    const double light = m_view.light(n / length);
    const double brightness = 0.78 + 0.22 * light;
    std::ostringstream rgb;
    for(std::size_t k = 0; k < 3; ++k)
      rgb << (k > 0 ? "," : "rgb(") << int(brightness * color[k]);
    m_svg << "<path d=\"";
    char command = 'M';
    for(const Corner& c : piece.corners)
      write_point(m_svg, std::exchange(command, 'L'), c.point);
    m_svg << "Z\" style=\"fill:" << rgb.str() << ");stroke:" << rgb.str() << ")\"/>\n";

    for(const Line_style& line : lines) {
      std::ostringstream way;
      way.precision(6);
      const auto is_drawn = [&](const Corner& c) {
        return c.side != Mesh::null_halfedge() ? line.is_wanted(m_mesh.edge(c.side))
                                               : c.is_outline && &line == &lines[0];
      };
      const std::size_t count = piece.corners.size();
      for(std::size_t i = 0; i < count; ++i) {
        const Corner& c = piece.corners[i];
        if(is_drawn(c)) {
          write_point(way, 'M', piece.corners[(i + count - 1) % count].point);
          write_point(way, 'L', c.point);
        } else if(!is_drawn(piece.corners[(i + 1) % count]) && is_end(c, line)) {
          write_point(way, 'M', c.point); // the round end, of which the area has taken some
          write_point(way, 'L', c.point);
        }
      }
      if(!way.str().empty())
        m_svg << "<path fill=\"none\" stroke=\"" << line.color << "\" stroke-width=\""
              << line.width << "\" d=\"" << way.str() << "\"/>\n";
    }
  }

  // Whether a line ends at a corner.
  bool is_end(const Corner& c, const Line_style& line) const
  {
    for(const Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(c.vertex)))
      if(line.is_wanted(m_mesh.edge(h)))
        return true;
    return false;
  }

  const Mesh& m_mesh;
  bool m_is_closed;
  Natural_view m_view;
  CGAL::Bbox_2 m_box;
  Depth_buffer m_buffer;
  std::ostringstream m_svg;
};

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_SURFACE_PICTURE_H
