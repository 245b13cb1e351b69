// The side from which a picture shows a surface: from above its front, where that is told by its
// form.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_NATURAL_VIEW_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_NATURAL_VIEW_H

#include "../Model.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

// A parallel projection. Files have the z-axis or the y-axis upwards: it is the one along which the
// surface stands better. Of eight directions around it, the first shows the surface, unless its
// outline is larger from another one.
class Natural_view
{
  using Point = Kernel::Point_3;
  using Vector = Kernel::Vector_3;

public:
  explicit Natural_view(const Mesh& mesh)
  {
    const Axes z_up{Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)};
    const Axes y_up{Vector(1, 0, 0), Vector(0, 0, -1), Vector(0, 1, 0)};
    const Axes upright = width_of_stand(mesh, y_up) > width_of_stand(mesh, z_up) ? y_up : z_up;
    constexpr double much_larger = 1.1;
    double largest = 0;
    Axes best = upright;
    for(int k = 0; k < 8; ++k) {
      m_axes = k == 0 ? upright : turned(upright, k);
      const double area = area_of_outline(mesh) * (k == 0 ? much_larger : 1);
      if(area > largest) {
        largest = area;
        best = m_axes;
      }
    }
    m_axes = best;
  }

  // In the picture: from (1, -2, 1), roughly, in the axes of the surface.
  double across(const Point& p) const
  { return dot(p, 0) * 0.894 + dot(p, 1) * 0.447; }
  double up(const Point& p) const
  { return 0.913 * dot(p, 2) - 0.183 * dot(p, 0) + 0.365 * dot(p, 1); }
  double depth(const Point& p) const { return depth(p - Point(0, 0, 0)); }
  double depth(const Vector& v) const
  { return 0.408 * (v * m_axes[0]) - 0.816 * (v * m_axes[1]) + 0.408 * (v * m_axes[2]); }

  // Of a face with that unit normal, from above.
  double light(const Vector& n) const
  { return 0.2 * (n * m_axes[0]) - 0.4 * (n * m_axes[1]) + 0.9 * (n * m_axes[2]); }

private:
  using Axes = std::array<Vector, 3>; // to the right, to the back, upwards
  // Many points of an outline lie on a line, up to rounding errors: with predicates that have some,
  // too, a hull is not always convex, which CGAL refuses where it checks its results.
  using Hull_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point_2 = Hull_kernel::Point_2;

  double dot(const Point& p, const std::size_t i) const
  { return (p - Point(0, 0, 0)) * m_axes[i]; }

  static Axes turned(const Axes& axes, const int eighths)
  {
    const double angle = eighths * std::acos(0.) / 2, c = std::cos(angle), s = std::sin(angle);
    return {c * axes[0] + s * axes[1], c * axes[1] - s * axes[0], axes[2]};
  }

  static CGAL::Polygon_2<Hull_kernel> hull(const std::vector<Point_2>& points)
  {
    CGAL::Polygon_2<Hull_kernel> result;
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(result));
    return result;
  }

  double area_of_outline(const Mesh& mesh) const
  {
    std::vector<Point_2> points;
    for(const auto v : mesh.vertices())
      points.emplace_back(across(mesh.point(v)), up(mesh.point(v)));
    return hull(points).area();
  }

  // How much of the outline seen from above is between the lowest points, on which the surface
  // stands; 0 if its middle is not above them.
  static double width_of_stand(const Mesh& mesh, const Axes& axes)
  {
    std::vector<std::array<double, 3> > points;
    std::array<double, 3> middle{};
    double lowest = 0, highest = 0;
    for(const auto v : mesh.vertices()) {
      const Vector p = mesh.point(v) - Point(0, 0, 0);
      points.push_back({p * axes[0], p * axes[1], p * axes[2]});
      for(std::size_t c = 0; c < 3; ++c)
        middle[c] += points.back()[c] / double(mesh.number_of_vertices());
      lowest = points.size() == 1 ? points.back()[2] : (std::min)(lowest, points.back()[2]);
      highest = points.size() == 1 ? points.back()[2] : (std::max)(highest, points.back()[2]);
    }
    std::vector<Point_2> all, low;
    for(const auto& p : points) {
      all.emplace_back(p[0], p[1]);
      if(p[2] <= lowest + 0.1 * (highest - lowest))
        low.push_back(all.back());
    }
    const CGAL::Polygon_2<Hull_kernel> stand = hull(low);
    if(stand.size() < 3 || !stand.has_on_bounded_side(Point_2(middle[0], middle[1])))
      return 0;
    return stand.area() / hull(all).area();
  }

  Axes m_axes;
};

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_NATURAL_VIEW_H
