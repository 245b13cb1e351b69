#ifndef SEAMLESS_SNAPPING_BENCHMARK_NAIVE_EXTRACTION_H
#define SEAMLESS_SNAPPING_BENCHMARK_NAIVE_EXTRACTION_H

// Quads as code extracts them that decides in floating point, with a tolerance: the points of the
// grid, and a march along each of their darts. What it loses is counted; nothing is repaired.

#include <CGAL/Isocurves_and_layouts/internal/charts/build_chart_mesh.h>
#include <CGAL/Quad_remeshing/internal/cells/Integer_decisions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace naive_extraction {

namespace I = CGAL::Quad_remeshing::internal;
using I::Chart_mesh;
using I::Corner_index;
using I::Uv;

constexpr double tolerance = 1e-9; // of barycentric coordinates

struct Counts
{
  std::size_t points = 0, darts = 0;
  std::size_t lost = 0;   // darts that arrive at no point
  std::size_t uneven = 0; // points at which not as many darts arrive as leave
};

class Extraction
{
public:
  explicit Extraction(const Chart_mesh& mesh) : m_mesh(mesh) { }

  Counts run()
  {
    for(Corner_index h = 0; h < m_mesh.number_of_halfedges(); h += 3)
      find_points(h);
    m_counts.points = m_points.size();
    std::vector<std::array<std::size_t, 2> > numbers(m_points.size()); // left, arrived
    for(const auto& point : m_points)
      for_darts(point.first, [&](const Corner_index face, const Uv& start, const int direction) {
        ++m_counts.darts;
        ++numbers[point.second][0];
        const std::size_t end = march(face, start, direction);
        if(end < numbers.size())
          ++numbers[end][1];
        else
          ++m_counts.lost;
      });
    for(const auto& n : numbers)
      m_counts.uneven += n[0] != n[1] ? 1 : 0;
    return m_counts;
  }

private:
  // A vertex, an edge, or a face, and rounded coordinates in its chart.
  using Key = std::tuple<int, Corner_index, long, long>;

  // Of the corners of a face, at a point.
  std::array<double, 3> weights(const Corner_index face, const Uv& p) const
  {
    const Uv &a = m_mesh.uv(face), &b = m_mesh.uv(face + 1), &c = m_mesh.uv(face + 2);
    const auto area = [](const Uv& x, const Uv& y, const Uv& z) {
      return (y[0] - x[0]) * (z[1] - x[1]) - (y[1] - x[1]) * (z[0] - x[0]);
    };
    const double whole = area(a, b, c);
    return {area(p, b, c) / whole, area(a, p, c) / whole, area(a, b, p) / whole};
  }

  // The place of a point of the closed face.
  Key key(const Corner_index face, const Uv& p) const
  {
    const std::array<double, 3> w = weights(face, p);
    for(Corner_index k = 0; k < 3; ++k)
      if(w[std::size_t(k)] > 1 - 2 * tolerance)
        return {0, Corner_index(m_mesh.vertex(face + k)), 0, 0};
    for(Corner_index k = 0; k < 3; ++k)
      if(w[std::size_t(k)] < tolerance) { // on the edge opposite to corner k
        const Corner_index h = Chart_mesh::prev(face + k), g = m_mesh.edge_key(h);
        const Uv q = h == g ? p : across(h, p);
        return {1, g, std::lround(q[0]), std::lround(q[1])};
      }
    return {2, face, std::lround(p[0]), std::lround(p[1])};
  }

  Uv across(const Corner_index h, const Uv& p) const
  {
    const Corner_index g = m_mesh.opposite(h);
    const Uv& from = m_mesh.uv(h);
    const Uv& to = m_mesh.uv(Chart_mesh::prev(g));
    const Uv d = I::Quarter_turns::apply(m_mesh.rotation(h), Uv{p[0] - from[0], p[1] - from[1]});
    return {to[0] + d[0], to[1] + d[1]};
  }

  void find_points(const Corner_index face)
  {
    std::array<long, 2> low, high;
    for(std::size_t c = 0; c < 2; ++c) {
      const auto range =
        std::minmax({m_mesh.uv(face)[c], m_mesh.uv(face + 1)[c], m_mesh.uv(face + 2)[c]});
      low[c] = long(std::ceil(range.first - tolerance));
      high[c] = long(std::floor(range.second + tolerance));
    }
    for(long y = low[1]; y <= high[1]; ++y)
      for(long x = low[0]; x <= high[0]; ++x) {
        const Uv p{double(x), double(y)};
        const std::array<double, 3> w = weights(face, p);
        if(*std::min_element(w.begin(), w.end()) > -tolerance)
          m_points.emplace(key(face, p), m_points.size());
      }
  }

  // Calls f(face, start, direction) for each axis that leads into a face around the point.
  template <typename Function>
  void for_darts(const Key& key, const Function& f) const
  {
    const auto& [place, index, x, y] = key;
    const Uv p{double(x), double(y)};
    if(place == 0) {
      I::for_each_corner(m_mesh, std::size_t(index), [&](const Corner_index h)
                         { for_darts_of_face(h - h % 3, m_mesh.uv(h), f); });
    } else if(place == 1) {
      for_darts_of_face(index - index % 3, p, f);
      const Corner_index g = m_mesh.opposite(index);
      if(g != I::no_index)
        for_darts_of_face(g - g % 3, across(index, p), f);
    } else {
      for_darts_of_face(index, p, f);
    }
  }

  template <typename Function>
  void for_darts_of_face(const Corner_index face, const Uv& p, const Function& f) const
  {
    const std::array<double, 3> here = weights(face, p);
    for(int direction = 0; direction < 4; ++direction) {
      const std::array<double, 3> there = weights(face, I::unit_step(p, direction));
      bool leads_into = true;
      for(std::size_t k = 0; k < 3; ++k) {
        const double slope = there[k] - here[k];
        const bool starts_there = here[k] < tolerance; // on the edge opposite to corner k
        const bool runs_along = starts_there && std::abs(slope) < tolerance;
        // along an edge: by one of its two faces
        leads_into = leads_into && (!starts_there || slope > 0 || runs_along) &&
                     (!runs_along || m_mesh.edge_key(Chart_mesh::prev(face + Corner_index(k))) ==
                                       Chart_mesh::prev(face + Corner_index(k)));
      }
      if(leads_into)
        f(face, p, direction);
    }
  }

  // The point where a unit step ends; or the number of points.
  std::size_t march(Corner_index face, const Uv& start, const int direction) const
  {
    Uv p = start, end = I::unit_step(start, direction);
    Corner_index entry = I::no_index;
    for(int i = 0; i < 1000; ++i) {
      const std::array<double, 3> here = weights(face, p), there = weights(face, end);
      if(*std::min_element(there.begin(), there.end()) > -tolerance) {
        const auto found = m_points.find(key(face, {std::round(end[0]), std::round(end[1])}));
        return found == m_points.end() ? m_points.size() : found->second;
      }
      double least = 2;
      Corner_index exit = I::no_index;
      for(Corner_index k = 0; k < 3; ++k) {
        const double a = here[std::size_t(k)], b = there[std::size_t(k)];
        const Corner_index h = Chart_mesh::prev(face + k);
        if(h == entry || !(b < a) || b > -tolerance)
          continue;
        const double t = (std::max)(0., a / (a - b));
        if(t < least) {
          least = t;
          exit = h;
        }
      }
      if(exit == I::no_index || m_mesh.opposite(exit) == I::no_index)
        break;
      const Uv q{p[0] + least * (end[0] - p[0]), p[1] + least * (end[1] - p[1])};
      p = across(exit, q);
      end = across(exit, end);
      entry = m_mesh.opposite(exit);
      face = entry - entry % 3;
    }
    return m_points.size();
  }

  const Chart_mesh& m_mesh;
  std::map<Key, std::size_t> m_points;
  Counts m_counts;
};

} // namespace naive_extraction

#endif // SEAMLESS_SNAPPING_BENCHMARK_NAIVE_EXTRACTION_H
