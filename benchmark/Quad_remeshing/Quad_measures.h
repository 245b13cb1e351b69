// What quads are worth, whoever made them: shape, topology, and distance from the surface.

#ifndef QUAD_REMESHING_BENCHMARK_QUAD_MEASURES_H
#define QUAD_REMESHING_BENCHMARK_QUAD_MEASURES_H

#include <CGAL/Quad_remeshing/internal/cells/inverted_quads.h>
#include <CGAL/Quad_remeshing/internal/remeshing/smooth_quads.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/version_macros.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace benchmark {

using Kernel = CGAL::Quad_remeshing::internal::Remeshing_types::Kernel;
using Triangles = std::vector<Kernel::Triangle_3>;

#if CGAL_VERSION_NR >= 1060000000
using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Triangles::const_iterator>;
using Search_tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive> >;
#else
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Search_tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive> >;
#endif

// All polygons have the same number of corners, 3 or 4.
struct Polygon_soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t> > polygons;

  // A quad is divided along its shorter diagonal. Triangles without area are left out.
  Triangles triangles() const
  {
    Triangles result;
    const auto add = [&](const Kernel::Triangle_3& t) {
      if(!t.is_degenerate())
        result.push_back(t);
    };
    for(const auto& f : polygons) {
      const auto p = [&](const std::size_t i) { return points[f[i % f.size()]]; };
      const bool is_turned = f.size() == 4 && CGAL::squared_distance(p(1), p(3)) <
                                                CGAL::squared_distance(p(0), p(2));
      const std::size_t i = is_turned ? 1 : 0;
      add({p(i), p(i + 1), p(i + 2)});
      if(f.size() == 4)
        add({p(i), p(i + 2), p(i + 3)});
    }
    return result;
  }

  double diagonal() const
  {
    CGAL::Bbox_3 box;
    for(const Kernel::Point_3& p : points)
      box += p.bbox();
    return std::hypot(box.x_span(), box.y_span(), box.z_span());
  }
};

struct Topology_of_soup
{
  explicit Topology_of_soup(const Polygon_soup& soup)
  {
    std::map<std::pair<std::size_t, std::size_t>, int> sides; // of directed edges
    for(const auto& f : soup.polygons)
      for(std::size_t i = 0; i < f.size(); ++i)
        ++sides[{f[i], f[(i + 1) % f.size()]}];
    std::map<std::size_t, std::size_t> valences;
    std::map<std::size_t, bool> is_on_border;
    std::size_t number_of_edges = 0;
    for(const auto& [ends, count] : sides) {
      const bool has_opposite = sides.count({ends.second, ends.first}) != 0;
      is_manifold = is_manifold && count == 1;
      for(const std::size_t v : {ends.first, ends.second})
        is_on_border[v] = is_on_border[v] || !has_opposite;
      if(has_opposite && ends.second < ends.first)
        continue;
      ++number_of_edges;
      ++valences[ends.first];
      ++valences[ends.second];
    }
    for(const auto& [v, valence] : valences)
      number_of_irregular_vertices += !is_on_border[v] && valence != 4;
    euler_characteristic = std::ptrdiff_t(valences.size() + soup.polygons.size()) -
                           std::ptrdiff_t(number_of_edges);
  }

  bool is_manifold = true; // at edges
  std::ptrdiff_t euler_characteristic = 0;
  std::size_t number_of_irregular_vertices = 0;
};

struct Shape_of_quads
{
  // \pre there are quads
  explicit Shape_of_quads(const Polygon_soup& quads)
  {
    namespace internal = CGAL::Quad_remeshing::internal;
    std::vector<double> jacobians;
    for(const auto& f : quads.polygons) {
      internal::Quad_in_space q;
      for(std::size_t i = 0; i < 4; ++i)
        q[i] = {quads.points[f[i]].x(), quads.points[f[i]].y(), quads.points[f[i]].z()};
      number_of_inverted_quads += internal::is_inverted(q) ? 1 : 0;
      jacobians.push_back(internal::scaled_jacobian(q, internal::quad_normal(q)));
      mean_jacobian += jacobians.back() / double(quads.polygons.size());
    }
    std::sort(jacobians.begin(), jacobians.end());
    first_percentile = jacobians[jacobians.size() / 100];
  }

  std::size_t number_of_inverted_quads = 0;
  double mean_jacobian = 0, first_percentile = 0; // of the scaled Jacobian
};

// The largest distance of points of one surface, `step` apart, from another one.
inline double one_sided_distance(const Triangles& from, const Triangles& to, const double step)
{
  Search_tree tree(to.begin(), to.end());
  tree.accelerate_distance_queries();
  double largest = 0;
  for(const Kernel::Triangle_3& t : from) {
    const Kernel::Vector_3 a = t[1] - t[0], b = t[2] - t[0];
    const double side = std::sqrt((std::max)({a.squared_length(), b.squared_length(),
                                              (b - a).squared_length()}));
    const int n = (std::max)(1, int(std::ceil(side / step)));
    for(int i = 0; i <= n; ++i)
      for(int j = 0; i + j <= n; ++j)
        largest = (std::max)(
          largest, tree.squared_distance(t[0] + (double(i) / n) * a + (double(j) / n) * b));
  }
  return std::sqrt(largest);
}

// An estimate from below of the Hausdorff distance.
inline double distance(const Triangles& a, const Triangles& b, const double step)
{
  return (std::max)(one_sided_distance(a, b, step), one_sided_distance(b, a, step));
}

} // namespace benchmark

#endif // QUAD_REMESHING_BENCHMARK_QUAD_MEASURES_H
