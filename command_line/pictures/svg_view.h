// Small tools for drawing parametrizations as SVG.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_SVG_VIEW_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_SVG_VIEW_H

#include "cut_gaps.h"

#include <cstddef>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

// A part of the plane, and the square of the picture that it is mapped to.
struct View
{
  Vector_uv center;
  double scale;
  Vector_uv middle;

  Vector_uv operator()(const Vector_uv& u) const
  {
    return {middle[0] + scale * (u[0] - center[0]), middle[1] - scale * (u[1] - center[1])};
  }
};

inline void write_points(std::ostream& os, const std::vector<Vector_uv>& points, const View& view)
{
  for(std::size_t i = 0; i < points.size(); ++i) {
    const Vector_uv p = view(points[i]);
    os << (i == 0 ? 'M' : 'L') << p[0] << ' ' << p[1];
  }
}

inline std::string escaped(const std::string& text)
{
  std::string result;
  for(const char c : text)
    result += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

inline std::string scientific(double x)
{
  std::ostringstream os;
  os << std::setprecision(2) << x;
  return os.str();
}

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_SVG_VIEW_H
