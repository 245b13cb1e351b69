#ifndef SEAMLESS_SNAPPING_TEST_QUAD_REFERENCE_H
#define SEAMLESS_SNAPPING_TEST_QUAD_REFERENCE_H

// Integer-grid maps whose quads are known, and comparisons of quad meshes.

#include "Square_complex_mesh.h"
#include "checking.h"

#include <CGAL/Isocurves_and_layouts/Isocurve_tracer.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace quad_reference {

namespace IL = CGAL::Isocurves_and_layouts;

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
  void move_vertex(const IL::Seam_transitions<Mesh>& seams, const Halfedge h, Kernel::Vector_2 d)
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
    const auto seams = IL::seam_transitions(mesh, uv);
    const IL::Isocurve_tracer<Mesh> tracer(mesh, uv);
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

// Of another mesh, what each halfedge corresponds to; -1 where that is not known yet.
struct Correspondence
{
  std::vector<int> image, preimage;

  Correspondence(const Mesh& a, const Mesh& b)
    : image(a.number_of_halfedges() + a.number_of_removed_halfedges(), -1),
      preimage(b.number_of_halfedges() + b.number_of_removed_halfedges(), -1)
  { }

  // Lets g correspond to h, and what is around g to what is around h. Returns false, and changes
  // nothing, if that is not possible.
  bool extend(const Mesh& a, const Halfedge h, const Mesh& b, const Halfedge g)
  {
    std::vector<Halfedge> found;
    const auto match = [&](const Halfedge x, const Halfedge y) {
      if(image[x] == int(y))
        return true;
      if(image[x] != -1 || preimage[y] != -1 || a.is_border(x) != b.is_border(y))
        return false;
      image[x] = int(y);
      preimage[y] = int(x);
      found.push_back(x);
      return true;
    };
    bool is_possible = match(h, g);
    for(std::size_t i = 0; is_possible && i < found.size(); ++i) {
      const Halfedge x = found[i], y{Mesh::size_type(image[x])};
      is_possible = match(a.next(x), b.next(y)) && match(a.opposite(x), b.opposite(y));
    }
    if(!is_possible)
      for(const Halfedge x : found) {
        preimage[std::size_t(image[x])] = -1;
        image[x] = -1;
      }
    return is_possible;
  }
};

// The halfedges by the degrees at both ends, those of the rarest kind first.
inline std::vector<std::vector<Halfedge> > kinds_of_halfedges(const Mesh& mesh)
{
  std::map<std::array<int, 3>, std::vector<Halfedge> > kinds;
  for(const Halfedge h : mesh.halfedges())
    kinds[{int(mesh.degree(mesh.target(h))), int(mesh.degree(mesh.source(h))),
           mesh.is_border(h) ? 1 : 0}].push_back(h);
  std::vector<std::vector<Halfedge> > result;
  for(auto& kind : kinds)
    result.push_back(std::move(kind.second));
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.size() < b.size(); });
  return result;
}

inline bool are_isomorphic(const Mesh& a, const Mesh& b)
{
  if(a.number_of_halfedges() != b.number_of_halfedges())
    return false;
  Correspondence known(a, b);
  const auto kinds = kinds_of_halfedges(a), other_kinds = kinds_of_halfedges(b);
  if(kinds.size() != other_kinds.size())
    return false;
  for(std::size_t k = 0; k < kinds.size(); ++k)
    for(const Halfedge h : kinds[k]) // the first one of each connected part finds all of it
      if(known.image[h] == -1 &&
         std::none_of(other_kinds[k].begin(), other_kinds[k].end(),
                      [&](const Halfedge g) { return known.extend(a, h, b, g); }))
        return false;
  return true;
}

// --- geometry ------------------------------------------------------------------------------------

using Rounded_point = std::array<long, 3>;
using Rounded_quads = std::vector<std::vector<Rounded_point> >;

// The faces as cycles of points, rounded to multiples of 1e-6, in a canonical order. Midpoints of
// points with six decimals would lie where rounding changes: they are kept away from there.
inline Rounded_quads rounded_quads(const Mesh& mesh)
{
  const auto rounded = [](const double x) { return std::lround(1e6 * x + 0.3); };
  Rounded_quads result;
  for(const auto f : mesh.faces()) {
    std::vector<Rounded_point> corners;
    for(const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
      const Point_3& p = mesh.point(v);
      corners.push_back({rounded(p.x()), rounded(p.y()), rounded(p.z())});
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
