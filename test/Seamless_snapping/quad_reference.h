#ifndef SEAMLESS_SNAPPING_TEST_QUAD_REFERENCE_H
#define SEAMLESS_SNAPPING_TEST_QUAD_REFERENCE_H

// Integer-grid maps whose quads are known, and comparisons of quad meshes.

#include "Square_complex_mesh.h"
#include "checking.h"

#include <CGAL/Seamless_snapping/Isocurve_tracer.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace quad_reference {

namespace SS = CGAL::Seamless_snapping;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Point_2>;
using Halfedge = Mesh::Halfedge_index;
using Vertex = Mesh::Vertex_index;
using square_complex::Square_complex;

// A surface of squares, each of which the map makes `side` units wide; n times n cells of triangles
// in each. `side` / n should be a dyadic number.
struct Grid_map
{
  Mesh mesh;
  UV_map uv;
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature;

  Grid_map(const Square_complex& complex, const int side, const int n)
  {
    square_complex::build_mesh(complex, n, double(side) / n, mesh);
    uv = square_complex::uv_map(mesh);
    is_feature = square_complex::feature_map(mesh);
  }
  Grid_map(const Grid_map&) = delete;

  Point_2& at(const Halfedge h) { return uv[h]; }

  // All charts by the same vector.
  void shift(const double u, const double v)
  {
    for(const auto h : mesh.halfedges())
      if(!mesh.is_border(h))
        uv[h] = Point_2(uv[h].x() + u, uv[h].y() + v);
  }

  // The corner of h by d, and all others at its vertex accordingly. Numbers must have few bits.
  void move_vertex(const SS::Seam_transitions<Mesh>& seams, const Halfedge h, Kernel::Vector_2 d)
  {
    Halfedge g = h;
    do {
      uv[g] = uv[g] + d;
      for(int k = seams.rotation(g); k > 0; --k)
        d = Kernel::Vector_2(-d.y(), d.x());
      g = mesh.prev(mesh.opposite(g));
    } while(g != h);
  }

  bool is_on_feature(const Vertex v) const
  {
    for(const auto h : CGAL::halfedges_around_target(v, mesh))
      if(is_feature[mesh.edge(h)])
        return true;
    return false;
  }

  // Moves inner vertices that are no cones and not on features at random, by multiples of 2^-bits,
  // where faces stay positive.
  void perturb(const unsigned seed, const double reach, const int bits)
  {
    const auto seams = SS::seam_transitions(mesh, uv);
    const SS::Isocurve_tracer<Mesh> tracer(mesh, uv);
    std::mt19937_64 random(seed);
    const auto number = [&] {
      const double x = reach * (double(random() % 2000001) / 1000000 - 1);
      return std::ldexp(std::round(std::ldexp(x, bits)), -bits);
    };
    for(const auto v : mesh.vertices()) {
      const Kernel::Vector_2 d(number(), number());
      const Halfedge h = mesh.halfedge(v);
      if(mesh.is_isolated(v) || CGAL::is_border(v, mesh) || tracer.is_singular(v) ||
         is_on_feature(v))
        continue;
      move_vertex(seams, h, d);
      if(!is_positive_around(v))
        move_vertex(seams, h, -d);
    }
  }

  bool is_positive(const Halfedge h) const
  {
    return CGAL::orientation(uv[h], uv[mesh.next(h)], uv[mesh.prev(h)]) == CGAL::POSITIVE;
  }

  bool is_positive_around(const Vertex v) const
  {
    for(const auto h : CGAL::halfedges_around_target(v, mesh))
      if(!mesh.is_border(h) && !is_positive(h))
        return false;
    return true;
  }
};

// The quads themselves: the mesh of `side` times `side` cells in each square, without the
// diagonals.
inline Mesh expected_quads(const Square_complex& complex, const int side)
{
  Mesh mesh;
  square_complex::build_mesh(complex, side, 1, mesh);
  const UV_map uv = square_complex::uv_map(mesh);
  std::vector<Halfedge> diagonals;
  for(const auto e : mesh.edges()) {
    const Halfedge h = mesh.is_border(e.halfedge()) ? mesh.opposite(e.halfedge()) : e.halfedge();
    const Point_2 a = uv[mesh.prev(h)], b = uv[h];
    if(a.x() != b.x() && a.y() != b.y())
      diagonals.push_back(h);
  }
  for(const Halfedge h : diagonals)
    CGAL::Euler::join_face(h, mesh);
  mesh.collect_garbage();
  return mesh;
}

// --- isomorphism ---------------------------------------------------------------------------------

// Numbers halfedges in an order that depends on the connectivity and the first one alone; the
// code lists what each is connected with.
inline std::vector<int> code_from(const Mesh& mesh, const Halfedge first)
{
  std::vector<int> number(mesh.number_of_halfedges() + mesh.number_of_removed_halfedges(), -1);
  std::deque<Halfedge> queue(1, first);
  std::vector<int> code;
  int n = 0;
  number[first] = n++;
  while(!queue.empty()) {
    const Halfedge h = queue.front();
    queue.pop_front();
    code.push_back(mesh.is_border(h) ? 1 : 0);
    for(const Halfedge g : {mesh.next(h), mesh.opposite(h)}) {
      if(number[g] == -1) {
        number[g] = n++;
        queue.push_back(g);
      }
      code.push_back(number[g]);
    }
  }
  return code;
}

// Halfedges to number a connected part from. Each is told by what its neighbors are told by, from
// the degrees on: those few are taken that are alike when this does not tell more. Where all are
// alike, as on a regular torus, a translation moves every vertex to every other, and one will do.
inline std::vector<Halfedge> first_halfedges(const Mesh& mesh, const std::vector<Halfedge>& members)
{
  using Key = std::array<int, 3>;
  constexpr std::size_t few = 100;
  std::vector<std::pair<Key, Halfedge> > keys;
  for(const Halfedge h : members)
    keys.emplace_back(Key{int(mesh.degree(mesh.target(h))), int(mesh.degree(mesh.source(h))),
                          mesh.is_border(h) ? 1 : 0}, h);
  std::vector<int> kind(mesh.number_of_halfedges() + mesh.number_of_removed_halfedges(), -1);
  for(std::size_t known_kinds = 0;;) {
    std::sort(keys.begin(), keys.end());
    std::vector<Halfedge> rarest;
    std::size_t number_of_kinds = 0;
    for(auto begin = keys.begin(), end = begin; begin != keys.end(); begin = end) {
      std::vector<Halfedge> alike;
      for(; end != keys.end() && end->first == begin->first; ++end) {
        kind[end->second] = int(number_of_kinds);
        alike.push_back(end->second);
      }
      if(rarest.empty() || alike.size() < rarest.size())
        rarest = std::move(alike);
      ++number_of_kinds;
    }
    if(number_of_kinds == 1) {
      const auto around = CGAL::halfedges_around_target(members.front(), mesh);
      return {around.begin(), around.end()};
    }
    if(rarest.size() <= few || number_of_kinds == known_kinds)
      return rarest;
    known_kinds = number_of_kinds;
    for(auto& key : keys) {
      const Halfedge h = key.second;
      key.first = {kind[h], kind[mesh.next(h)], kind[mesh.opposite(h)]};
    }
  }
}

// The code of each connected part: the smallest over the halfedges it may be numbered from.
inline std::vector<std::vector<int> > codes(const Mesh& mesh)
{
  std::vector<int> part(mesh.number_of_halfedges() + mesh.number_of_removed_halfedges(), -1);
  std::vector<std::vector<int> > result;
  for(const Halfedge start : mesh.halfedges()) {
    if(part[start] != -1)
      continue;
    std::vector<Halfedge> members;
    std::deque<Halfedge> queue(1, start);
    part[start] = int(result.size());
    while(!queue.empty()) {
      const Halfedge h = queue.front();
      queue.pop_front();
      members.push_back(h);
      for(const Halfedge g : {mesh.next(h), mesh.opposite(h)})
        if(part[g] == -1) {
          part[g] = int(result.size());
          queue.push_back(g);
        }
    }
    std::vector<int> best;
    for(const Halfedge h : first_halfedges(mesh, members)) {
      std::vector<int> code = code_from(mesh, h);
      if(best.empty() || code < best)
        best = std::move(code);
    }
    result.push_back(std::move(best));
  }
  std::sort(result.begin(), result.end());
  return result;
}

inline bool are_isomorphic(const Mesh& a, const Mesh& b)
{
  return a.number_of_halfedges() == b.number_of_halfedges() && codes(a) == codes(b);
}

// --- geometry ------------------------------------------------------------------------------------

using Rounded_point = std::array<long, 3>;
using Rounded_quads = std::vector<std::vector<Rounded_point> >;

// The faces as cycles of points, rounded to multiples of 1e-6, in a canonical order.
inline Rounded_quads rounded_quads(const Mesh& mesh)
{
  Rounded_quads result;
  for(const auto f : mesh.faces()) {
    std::vector<Rounded_point> corners;
    for(const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
      const Point_3& p = mesh.point(v);
      corners.push_back({std::lround(1e6 * p.x()), std::lround(1e6 * p.y()),
                         std::lround(1e6 * p.z())});
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.push_back(std::move(corners));
  }
  std::sort(result.begin(), result.end());
  return result;
}

inline int euler_characteristic(const Mesh& mesh)
{
  return int(mesh.number_of_vertices()) - int(mesh.number_of_edges()) + int(mesh.number_of_faces());
}

} // namespace quad_reference

#endif // SEAMLESS_SNAPPING_TEST_QUAD_REFERENCE_H
