// Exactly seamless maps of any triangle mesh with N = 6: each face becomes a triangle of the
// triangular lattice, so that a vertex is a cone unless six faces meet at it. Where faces have two
// colors, so that neighbors differ, N = 3 will do. Knows nothing of the package: lattice
// coordinates are the complex numbers of random_complexes.h.

#ifndef SEAMLESS_SNAPPING_TEST_HEXAGONAL_MAPS_H
#define SEAMLESS_SNAPPING_TEST_HEXAGONAL_MAPS_H

#include "random_complexes.h"

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>
#include <CGAL/Seamless_snapping/types/Rotational_symmetry.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/subdivision_method_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <random>
#include <string>
#include <vector>

namespace hexagonal_maps {

using random_complexes::turned;
using Rational = CGAL::Exact_rational;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Mesh::Halfedge_index;
using Vertex = Mesh::Vertex_index;
using UV_map = Mesh::Property_map<Halfedge, Kernel::Point_2>;
using Vector = std::array<double, 2>;
using Exact_vector = std::array<Rational, 2>;

// --- meshes --------------------------------------------------------------------------------------

inline Mesh subdivided(Mesh mesh, const unsigned int times)
{
  CGAL::Subdivision_method_3::Loop_subdivision(mesh,
                                               CGAL::parameters::number_of_iterations(times));
  return mesh;
}

// 12 cones of index 1/6.
inline Mesh icosahedron()
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Kernel::Point_3>(mesh);
  return mesh;
}

// Six cones of index 1/3, and faces of two colors.
inline Mesh octahedron()
{
  Mesh mesh;
  std::array<Vertex, 6> v;
  for(int i = 0; i < 6; ++i) {
    std::array<double, 3> p{{0, 0, 0}};
    p[std::size_t(i / 2)] = i % 2 == 0 ? 1 : -1;
    v[std::size_t(i)] = mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  }
  for(int i = 0; i < 8; ++i) {
    const Vertex a = v[std::size_t(i & 1)], b = v[std::size_t(2 + (i >> 1 & 1))],
                 c = v[std::size_t(4 + (i >> 2 & 1))];
    const bool is_even = ((i & 1) + (i >> 1 & 1) + (i >> 2 & 1)) % 2 == 0;
    is_even ? mesh.add_face(a, b, c) : mesh.add_face(a, c, b);
  }
  return mesh;
}

// Tori around the holes of a grid of squares, each cut into two triangles: without a cone where
// `number_of_holes` is 1 and the grid is closed both ways.
inline Mesh torus(const int m, const int n)
{
  Mesh mesh;
  std::vector<Vertex> v;
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < n; ++j) {
      const double a = 2 * std::acos(-1.) * i / m, b = 2 * std::acos(-1.) * j / n;
      v.push_back(mesh.add_vertex(Kernel::Point_3((3 + std::cos(b)) * std::cos(a),
                                                  (3 + std::cos(b)) * std::sin(a), std::sin(b))));
    }
  const auto at = [&](const int i, const int j) { return v[std::size_t(i % m * n + j % n)]; };
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < n; ++j) {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

// Two tori, each without one face, joined by a tube there: genus 2, with cones of many indices.
inline Mesh genus_2()
{
  Mesh mesh = torus(5, 4);
  const Mesh other = torus(5, 4);
  std::vector<Vertex> v;
  for(const Vertex w : other.vertices()) {
    const Kernel::Point_3& p = other.point(w);
    v.push_back(mesh.add_vertex(Kernel::Point_3(p.x() + 9, p.y(), p.z())));
  }
  const auto removed = *other.faces().begin();
  std::array<Vertex, 3> here, there;
  std::size_t k = 0;
  for(const Vertex w : CGAL::vertices_around_face(other.halfedge(removed), other)) {
    here[k] = w; // the first of the mesh are those of its first torus
    there[k++] = v[std::size_t(w)];
  }
  for(const auto f : other.faces())
    if(f != removed) {
      std::vector<Vertex> corners;
      for(const Vertex w : CGAL::vertices_around_face(other.halfedge(f), other))
        corners.push_back(v[std::size_t(w)]);
      mesh.add_face(corners);
    }
  CGAL::Euler::remove_face(mesh.halfedge(removed), mesh);
  for(std::size_t i = 0; i < 3; ++i) { // the second is seen from behind
    const std::size_t j = (i + 1) % 3;
    mesh.add_face(here[i], here[j], there[(3 - j) % 3]);
    mesh.add_face(here[i], there[(3 - j) % 3], there[(3 - i) % 3]);
  }
  return mesh;
}

// The same faces, not joined along some edges.
// \pre edges on the border are among these
inline Mesh cut_open(const Mesh& closed, const std::vector<char>& is_cut)
{
  const auto next_in_fan = [&](const Halfedge h) { return closed.prev(closed.opposite(h)); };
  Mesh mesh;
  std::vector<Vertex> corners(2 * closed.number_of_edges());
  for(const Halfedge h : closed.halfedges()) {
    if(closed.is_border(h) || corners[std::size_t(h)] != Vertex())
      continue;
    const Vertex v = mesh.add_vertex(closed.point(closed.target(h)));
    Halfedge first = h; // counterclockwise, to the first cut or all around
    while(!is_cut[std::size_t(closed.edge(first))] && next_in_fan(first) != h)
      first = next_in_fan(first);
    for(Halfedge g = first; corners[std::size_t(g)] == Vertex();
        g = closed.opposite(closed.next(g))) {
      corners[std::size_t(g)] = v;
      if(is_cut[std::size_t(closed.edge(closed.next(g)))])
        break;
    }
  }
  for(const auto f : closed.faces()) {
    const Halfedge h = closed.halfedge(f);
    mesh.add_face(corners[std::size_t(h)], corners[std::size_t(closed.next(h))],
                  corners[std::size_t(closed.prev(h))]);
  }
  return mesh;
}

// A part of the lattice, with border.
inline Mesh triangle(const int n)
{
  Mesh mesh;
  std::vector<std::vector<Vertex> > v(std::size_t(n) + 1);
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i + j <= n; ++i)
      v[std::size_t(j)].push_back(mesh.add_vertex(Kernel::Point_3(i + 0.5 * j, j, 0)));
  const auto at = [&](const int i, const int j) { return v[std::size_t(j)][std::size_t(i)]; };
  for(int j = 0; j < n; ++j)
    for(int i = 0; i + j < n; ++i) {
      mesh.add_face(at(i, j), at(i + 1, j), at(i, j + 1));
      if(i + j + 1 < n)
        mesh.add_face(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

// --- maps ----------------------------------------------------------------------------------------

inline UV_map uv_map(Mesh& mesh)
{
  return mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
}

inline Vector vector(const Kernel::Point_2& p, const Kernel::Point_2& q)
{
  return {{q.x() - p.x(), q.y() - p.y()}};
}

inline Kernel::Point_2 moved(const Kernel::Point_2& p, const Vector& by)
{
  return Kernel::Point_2(p.x() + by[0], p.y() + by[1]);
}

// Lays the faces out along a tree of neighbors.
inline void unfold(const Mesh& mesh, UV_map uv)
{
  std::vector<char> is_placed(mesh.number_of_faces(), false);
  std::deque<Halfedge> queue;
  const auto place = [&](const Halfedge h, const Kernel::Point_2& source,
                         const Kernel::Point_2& target) {
    is_placed[std::size_t(mesh.face(h))] = true;
    uv[mesh.prev(h)] = source;
    uv[h] = target;
    uv[mesh.next(h)] = moved(source, turned<6>(1, vector(source, target)));
    for(const Halfedge side : {h, mesh.next(h), mesh.prev(h)})
      queue.push_back(side);
  };
  for(const auto f : mesh.faces()) {
    if(!is_placed[std::size_t(f)])
      place(mesh.halfedge(f), Kernel::Point_2(0, 0), Kernel::Point_2(1, 0));
    for(; !queue.empty(); queue.pop_front()) {
      const Halfedge h = queue.front(), o = mesh.opposite(h);
      if(!mesh.is_border(o) && !is_placed[std::size_t(mesh.face(o))])
        place(o, uv[h], uv[mesh.prev(h)]);
    }
  }
}

// Of an exact map of few bits: the number of turns of the transition across a halfedge.
template <int N>
int turns(const Mesh& mesh, const UV_map uv, const Halfedge h)
{
  const Halfedge o = mesh.opposite(h);
  const Vector here = vector(uv[mesh.prev(h)], uv[h]), there = vector(uv[o], uv[mesh.prev(o)]);
  for(int k = 0; k < N; ++k)
    if(turned<N>(k, here) == there)
      return k;
  return -1;
}

inline bool is_interior(const Mesh& mesh, const Halfedge h)
{
  return !mesh.is_border(h) && !mesh.is_border(mesh.opposite(h));
}

inline bool is_cut(const Mesh& mesh, const UV_map uv, const Halfedge h)
{
  const Halfedge o = mesh.opposite(h);
  return uv[h] != uv[mesh.prev(o)] || uv[o] != uv[mesh.prev(h)];
}

// The corners of a vertex in turn; at a border vertex, from the border on.
inline std::vector<Halfedge> corners_in_turn(const Mesh& mesh, const Vertex v)
{
  Halfedge first = mesh.halfedge(v);
  for(const Halfedge h : CGAL::halfedges_around_target(first, mesh))
    if(mesh.is_border(mesh.opposite(h)))
      first = h;
  std::vector<Halfedge> result;
  Halfedge h = first;
  do {
    if(!mesh.is_border(h))
      result.push_back(h);
    h = mesh.opposite(mesh.next(h));
  } while(h != first);
  return result;
}

// Moves all vertices but cones by up to `size`, alike in all charts: a power of two, in steps of an
// eighth of it.
template <int N>
void warp(const Mesh& mesh, UV_map uv, const double size, std::mt19937& random)
{
  std::vector<int> rotations(2 * mesh.number_of_edges(), 0);
  for(const Halfedge h : mesh.halfedges())
    if(is_interior(mesh, h))
      rotations[std::size_t(h)] = turns<N>(mesh, uv, h);
  for(const Vertex v : mesh.vertices()) {
    const std::vector<Halfedge> corners = corners_in_turn(mesh, v);
    Vector d{{size * (int(random() % 17) - 8) / 8, size * (int(random() % 17) - 8) / 8}};
    const Vector start = d;
    std::vector<Vector> moves;
    for(const Halfedge h : corners) {
      moves.push_back(d);
      d = turned<N>(rotations[std::size_t(mesh.next(h))], d);
    }
    if(!mesh.is_border(v) && d != start)
      continue; // a cone
    for(std::size_t i = 0; i < corners.size(); ++i)
      uv[corners[i]] = moved(uv[corners[i]], moves[i]);
  }
}

// Moves every coordinate of an exact map by up to `size`; corners that no cut separates, alike. In
// steps of 2^-20 of it, which is a power of two.
inline void perturb(const Mesh& mesh, UV_map uv, const double size, std::mt19937& random)
{
  const auto number = [&]() { return std::ldexp(int(random() % (2u << 20)) - (1 << 20), -20); };
  for(const Vertex v : mesh.vertices()) {
    const std::vector<Halfedge> corners = corners_in_turn(mesh, v);
    if(corners.empty())
      continue;
    std::vector<char> starts; // whether a cut or the border is before
    for(const Halfedge h : corners) {
      const Halfedge before = mesh.opposite(h);
      starts.push_back(mesh.is_border(before) || is_cut(mesh, uv, h));
    }
    const std::size_t n = corners.size();
    std::size_t first = 0;
    while(first + 1 < n && !starts[first])
      ++first;
    Vector d{{0, 0}};
    for(std::size_t i = 0; i < n; ++i) {
      const std::size_t k = (first + i) % n;
      if(i == 0 || starts[k])
        d = {{size * number(), size * number()}};
      uv[corners[k]] = moved(uv[corners[k]], d);
    }
  }
}

// --- an exact check ------------------------------------------------------------------------------

inline Exact_vector exact_vector(const Kernel::Point_2& p, const Kernel::Point_2& q)
{
  return {{Rational(Rational(q.x()) - Rational(p.x())),
           Rational(Rational(q.y()) - Rational(p.y()))}};
}

// Whether some transition holds across each interior edge.
template <int N>
bool is_exact(const Mesh& mesh, const UV_map uv)
{
  for(const auto e : mesh.edges()) {
    const Halfedge h = mesh.halfedge(e), o = mesh.opposite(h);
    if(!is_interior(mesh, h) || !is_cut(mesh, uv, h))
      continue;
    const Exact_vector here = exact_vector(uv[mesh.prev(h)], uv[h]);
    const Exact_vector there = exact_vector(uv[o], uv[mesh.prev(o)]);
    bool is_some = false;
    for(int k = 0; k < N; ++k)
      is_some = is_some || turned<N>(k, here) == there;
    if(!is_some)
      return false;
  }
  return true;
}

// 1, 0, or -1 for each face.
inline std::vector<int> signs(const Mesh& mesh, const UV_map uv)
{
  std::vector<int> result;
  for(const auto f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    const Exact_vector a = exact_vector(uv[h], uv[mesh.next(h)]);
    const Exact_vector b = exact_vector(uv[h], uv[mesh.prev(h)]);
    const Rational area(a[0] * b[1] - a[1] * b[0]);
    result.push_back(area > 0 ? 1 : area < 0 ? -1 : 0);
  }
  return result;
}

// --- what the tests share ------------------------------------------------------------------------

template <int N>
auto symmetry()
{
  namespace SS = CGAL::Seamless_snapping;
  return SS::parameters::rotational_symmetry(SS::Rotational_symmetry<N>());
}

inline std::vector<Kernel::Point_2> all_points(const Mesh& mesh, const UV_map uv)
{
  std::vector<Kernel::Point_2> result;
  for(const Halfedge h : mesh.halfedges())
    result.push_back(uv[h]);
  return result;
}

struct Case
{
  std::string name;
  Mesh mesh;
};

inline std::vector<Case> meshes_of_three_directions()
{
  return {{"octahedron", octahedron()}, {"sphere with six cones", subdivided(octahedron(), 3)}};
}

inline std::vector<Case> meshes_of_six_directions()
{
  return {{"icosahedron", icosahedron()},
          {"sphere with twelve cones", subdivided(icosahedron(), 2)},
          {"torus", torus(9, 7)},
          {"genus 2", subdivided(genus_2(), 1)},
          {"triangle with border", triangle(6)}};
}

} // namespace hexagonal_maps

#endif // SEAMLESS_SNAPPING_TEST_HEXAGONAL_MAPS_H
