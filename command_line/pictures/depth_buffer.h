// What hides what in a picture of triangles: the depth of the nearest triangle at each pixel.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_DEPTH_BUFFER_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_DEPTH_BUFFER_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

class Depth_buffer
{
public:
  // Place in pixels, and depth: larger is nearer.
  struct Point
  {
    double x, y, depth;
  };

  // Of the pixels from (0, 0) to (size, size), relative to `left` and `top`.
  Depth_buffer(const double left, const double top, const std::size_t size)
    : m_left(left), m_top(top), m_size(size),
      m_depth(size * size, -std::numeric_limits<double>::infinity())
  { }

  void add(const std::array<Point, 3>& triangle)
  {
    const auto& [a, b, c] = triangle;
    const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if(area == 0)
      return;
    const auto [x0, x1] = std::minmax({a.x, b.x, c.x});
    const auto [y0, y1] = std::minmax({a.y, b.y, c.y});
    for(std::size_t j = index(y0 - m_top); j <= index(y1 - m_top); ++j)
      for(std::size_t i = index(x0 - m_left); i <= index(x1 - m_left); ++i) {
        const double x = m_left + double(i) + 0.5, y = m_top + double(j) + 0.5;
        const double v = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / area;
        const double w = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / area;
        if(v < 0 || w < 0 || v + w > 1)
          continue;
        double& nearest = m_depth[j * m_size + i];
        nearest = (std::max)(nearest, a.depth + v * (b.depth - a.depth) + w * (c.depth - a.depth));
      }
  }

  // Whether no triangle is nearer by more than `slack`.
  bool is_visible(const Point& p, const double slack) const
  {
    return p.depth >= m_depth[index(p.y - m_top) * m_size + index(p.x - m_left)] - slack;
  }

private:
  std::size_t index(const double pixel) const
  {
    return std::size_t((std::min)((std::max)(std::floor(pixel), 0.), double(m_size - 1)));
  }

  double m_left, m_top;
  std::size_t m_size;
  std::vector<double> m_depth;
};

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_DEPTH_BUFFER_H
