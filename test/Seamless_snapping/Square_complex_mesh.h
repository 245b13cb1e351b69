// Turns a Square_complex into a CGAL::Surface_mesh: every square is divided into n x n cells of two
// triangles. The connectivity is written directly, since calling add_face() for millions of faces
// is slow and refuses the multiple edges that coarse surfaces of few squares have.

#ifndef SEAMLESS_SNAPPING_TEST_SQUARE_COMPLEX_MESH_H
#define SEAMLESS_SNAPPING_TEST_SQUARE_COMPLEX_MESH_H

#include "Square_complex.h"

#include <CGAL/Kernel_traits.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace square_complex {

template <typename Mesh>
using Point_2_of = typename CGAL::Kernel_traits<typename Mesh::Point>::Kernel::Point_2;

// The uv map "h:uv" and the feature edges "e:feature" of a mesh; made if they aren't there yet.
template <typename Mesh>
typename Mesh::template Property_map<typename Mesh::Halfedge_index, Point_2_of<Mesh> >
uv_map(Mesh& mesh)
{
  using Halfedge = typename Mesh::Halfedge_index;
  return mesh.template add_property_map<Halfedge, Point_2_of<Mesh> >("h:uv", Point_2_of<Mesh>(0, 0))
    .first;
}

template <typename Mesh>
typename Mesh::template Property_map<typename Mesh::Edge_index, bool> feature_map(Mesh& mesh)
{
  return mesh.template add_property_map<typename Mesh::Edge_index, bool>("e:feature", false).first;
}

// Numbers the vertices and edges of the divided complex, in closed form but for one table entry per
// corner and per side of the squares.
class Subdivision
{
public:
  using Index = std::uint32_t;

  Subdivision(const Square_complex& complex, int n)
    : m_complex(complex)
    , m_n(static_cast<Index>(n))
  {
    number_corners();
    for(int i = 0; i < complex.number_of_squares(); ++i) {
      m_first_vertex.push_back(m_vertices);
      m_first_edge.push_back(m_edges);
      m_vertices += (m_n - 1) * (m_n - 1);
      m_edges += 3 * m_n * m_n - 2 * m_n;
      for(int s = 0; s < 4; ++s) {
        m_first_side_vertex.push_back(m_vertices);
        m_first_side_edge.push_back(m_edges);
        if(owns(i, s)) {
          m_vertices += m_n - 1;
          m_edges += m_n;
        }
      }
    }
  }

  Index number_of_vertices() const { return m_vertices; }
  Index number_of_edges() const { return m_edges; }

  // The vertex at (a,b)/n of square i.
  Index vertex(int i, Index a, Index b) const
  {
    if(b == 0)
      return a == m_n ? corner(i, 1) : side_vertex(i, 0, a);
    if(a == m_n)
      return b == m_n ? corner(i, 2) : side_vertex(i, 1, b);
    if(b == m_n)
      return a == 0 ? corner(i, 3) : side_vertex(i, 2, m_n - a);
    if(a == 0)
      return side_vertex(i, 3, m_n - b);
    return m_first_vertex[index(i)] + (b - 1) * (m_n - 1) + (a - 1);
  }

  // Halfedges of square i. Edge e has the halfedges 2e and 2e + 1.
  Index rightwards(int i, Index a, Index b) const // (a,b) to (a+1,b)
  {
    if(b == 0)
      return side_halfedge(i, 0, a);
    if(b == m_n)
      return side_halfedge(i, 2, m_n - 1 - a) ^ 1;
    return 2 * (m_first_edge[index(i)] + (b - 1) * m_n + a);
  }

  Index upwards(int i, Index a, Index b) const // (a,b) to (a,b+1)
  {
    if(a == m_n)
      return side_halfedge(i, 1, b);
    if(a == 0)
      return side_halfedge(i, 3, m_n - 1 - b) ^ 1;
    return 2 * (m_first_edge[index(i)] + m_n * (m_n - 1) + (a - 1) * m_n + b);
  }

  Index diagonal(int i, Index a, Index b) const // (a,b) to (a+1,b+1)
  {
    return 2 * (m_first_edge[index(i)] + 2 * m_n * (m_n - 1) + b * m_n + a);
  }

  // The k-th halfedge along side s, inside square i.
  Index side_halfedge(int i, int s, Index k) const
  {
    if(owns(i, s))
      return 2 * (m_first_side_edge[side_index(i, s)] + k);
    const Side o = m_complex.across(i, s);
    return 2 * (m_first_side_edge[side_index(o.square, o.side)] + m_n - 1 - k) + 1;
  }

  // The edges of a glued side belong to one of the two squares.
  bool owns(int i, int s) const
  {
    const Side o = m_complex.across(i, s);
    return o.is_border() || i < o.square || (i == o.square && s < o.side);
  }

private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  static std::size_t side_index(int i, int s) { return index(4 * i + (s & 3)); }

  Index corner(int i, int s) const { return m_corner_vertex[side_index(i, s)]; }

  Index side_vertex(int i, int s, Index k) const // k = 0, ..., n - 1
  {
    if(k == 0)
      return corner(i, s);
    if(owns(i, s))
      return m_first_side_vertex[side_index(i, s)] + k - 1;
    const Side o = m_complex.across(i, s);
    return m_first_side_vertex[side_index(o.square, o.side)] + m_n - k - 1;
  }

  // The corner next to c around their vertex, across the side that ends there, ...
  Side next_corner(const Side& c) const { return m_complex.across(c.square, c.side + 3); }

  // ... and across the side that starts there.
  Side previous_corner(const Side& c) const
  {
    const Side o = m_complex.across(c.square, c.side);
    return { o.square, (o.side + 1) & 3 };
  }

  void number_corners()
  {
    const Index none = static_cast<Index>(-1);
    m_corner_vertex.assign(index(4 * m_complex.number_of_squares()), none);
    for(int i = 0; i < m_complex.number_of_squares(); ++i)
      for(int s = 0; s < 4; ++s)
        if(corner(i, s) == none)
          number_corners_around({ i, s }, m_vertices++);
  }

  void number_corners_around(const Side& start, Index vertex)
  {
    Side c = start;
    do {
      m_corner_vertex[side_index(c.square, c.side)] = vertex;
      c = next_corner(c);
    } while(!c.is_border() && (c.square != start.square || c.side != start.side));
    if(c.is_border())
      for(c = previous_corner(start); !c.is_border(); c = previous_corner(c))
        m_corner_vertex[side_index(c.square, c.side)] = vertex;
  }

  const Square_complex& m_complex;
  Index m_n;
  Index m_vertices = 0, m_edges = 0;
  std::vector<Index> m_corner_vertex;                 // per corner
  std::vector<Index> m_first_vertex, m_first_edge;    // per square
  std::vector<Index> m_first_side_vertex, m_first_side_edge; // per side
};

template <typename Mesh>
class Mesh_builder
{
  using Index = Subdivision::Index;
  using Vertex = typename Mesh::Vertex_index;
  using Halfedge = typename Mesh::Halfedge_index;
  using Edge = typename Mesh::Edge_index;
  using Face = typename Mesh::Face_index;
  using Point_2 = Point_2_of<Mesh>;
  using FT = typename CGAL::Kernel_traits<typename Mesh::Point>::Kernel::FT;

public:
  Mesh_builder(const Square_complex& complex, int n, double scale, Mesh& mesh)
    : m_complex(complex)
    , m_numbers(complex, n)
    , m_n(static_cast<Index>(n))
    , m_scale(scale)
    , m_mesh(mesh)
  {
    allocate();
    m_uv = uv_map(mesh);
    m_feature = feature_map(mesh);
    for(int i = 0; i < complex.number_of_squares(); ++i) {
      for(Index b = 0; b < m_n; ++b)
        for(Index a = 0; a < m_n; ++a)
          add_cell(i, a, b);
      mark_features(i);
    }
    link_border();
  }

private:
  // A point of the square's grid, in steps of 1/n.
  struct Grid_point
  {
    Index a, b;
  };

  void allocate()
  {
    const Index faces = 2 * m_n * m_n * static_cast<Index>(m_complex.number_of_squares());
    m_mesh.reserve(m_numbers.number_of_vertices(), m_numbers.number_of_edges(), faces);
    for(Index v = 0; v < m_numbers.number_of_vertices(); ++v)
      m_mesh.add_vertex();
    for(Index e = 0; e < m_numbers.number_of_edges(); ++e)
      m_mesh.add_edge();
    for(Index f = 0; f < faces; ++f)
      m_mesh.add_face();
  }

  void add_cell(int i, Index a, Index b)
  {
    const Index diagonal = m_numbers.diagonal(i, a, b);
    const Index face = 2 * (m_n * m_n * static_cast<Index>(i) + b * m_n + a);
    add_triangle(i, face, m_numbers.rightwards(i, a, b), { a + 1, b },
                 m_numbers.upwards(i, a + 1, b), { a + 1, b + 1 }, diagonal ^ 1, { a, b });
    add_triangle(i, face + 1, diagonal, { a + 1, b + 1 },
                 m_numbers.rightwards(i, a, b + 1) ^ 1, { a, b + 1 },
                 m_numbers.upwards(i, a, b) ^ 1, { a, b });
  }

  void add_triangle(int i, Index face, Index h0, Grid_point p0, Index h1, Grid_point p1, Index h2,
                    Grid_point p2)
  {
    const Face f(face);
    m_mesh.set_halfedge(f, Halfedge(h0));
    add_corner(i, f, Halfedge(h0), Halfedge(h1), p0);
    add_corner(i, f, Halfedge(h1), Halfedge(h2), p1);
    add_corner(i, f, Halfedge(h2), Halfedge(h0), p2);
  }

  void add_corner(int i, Face f, Halfedge h, Halfedge next, const Grid_point& p)
  {
    const Vertex v(m_numbers.vertex(i, p.a, p.b));
    m_mesh.set_face(h, f);
    m_mesh.set_next(h, next);
    m_mesh.set_target(h, v);
    m_mesh.set_halfedge(v, h);
    m_mesh.point(v) = place(i, p);
    m_uv[h] = coordinates(i, p);
  }

  Point_2 coordinates(int i, const Grid_point& p) const
  {
    const Square& square = m_complex.square(i);
    const double n = double(m_n);
    const Vector_2 turned = rotated({ { double(p.a), double(p.b) } }, square.rotation);
    return Point_2(FT((turned[0] + n * square.origin[0]) * m_scale),
                   FT((turned[1] + n * square.origin[1]) * m_scale));
  }

  typename Mesh::Point place(int i, const Grid_point& p) const
  {
    const Square& square = m_complex.square(i);
    const double a = double(p.a) / double(m_n), b = double(p.b) / double(m_n);
    const auto coordinate = [&](std::size_t d) {
      return FT(square.base[d] + a * square.along[d] + b * square.up[d]);
    };
    return typename Mesh::Point(coordinate(0), coordinate(1), coordinate(2));
  }

  void mark_features(int i)
  {
    for(int s = 0; s < 4; ++s)
      for(Index k = 0; k < m_n && m_complex.square(i).is_feature[static_cast<std::size_t>(s)]; ++k)
        m_feature[m_mesh.edge(Halfedge(m_numbers.side_halfedge(i, s, k)))] = true;
  }

  // A border halfedge goes on with the one that turning around its target finds.
  void link_border()
  {
    for(int i = 0; i < m_complex.number_of_squares(); ++i) {
      for(int s = 0; s < 4; ++s) {
        for(Index k = 0; k < m_n && m_complex.across(i, s).is_border(); ++k) {
          const Halfedge border(m_numbers.side_halfedge(i, s, k) ^ 1);
          const Grid_point start = start_of_side_edge(s, k);
          const Vertex v(m_numbers.vertex(i, start.a, start.b));
          Halfedge next = m_mesh.opposite(border);
          do {
            next = m_mesh.opposite(m_mesh.prev(next));
          } while(m_mesh.face(next) != Mesh::null_face());
          m_mesh.set_target(border, v);
          m_mesh.set_halfedge(v, border);
          m_mesh.set_next(border, next);
        }
      }
    }
  }

  Grid_point start_of_side_edge(int s, Index k) const
  {
    switch(s) {
      case 0: return { k, 0 };
      case 1: return { m_n, k };
      case 2: return { m_n - k, m_n };
      default: return { 0, m_n - k };
    }
  }

  const Square_complex& m_complex;
  const Subdivision m_numbers;
  const Index m_n;
  const double m_scale;
  Mesh& m_mesh;
  typename Mesh::template Property_map<Halfedge, Point_2> m_uv;
  typename Mesh::template Property_map<Edge, bool> m_feature;
};

// Fills an empty mesh. One step of the grid is `scale` long in the uv map: take a power of two.
template <typename Mesh>
void build_mesh(const Square_complex& complex, int n, double scale, Mesh& mesh)
{
  Mesh_builder<Mesh>(complex, n, scale, mesh);
}

} // namespace square_complex

#endif // SEAMLESS_SNAPPING_TEST_SQUARE_COMPLEX_MESH_H
