// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_COARSEN_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_COARSEN_H

#include <CGAL/license/Quad_remeshing.h>

// From the mesh to a coarse complex of the same surface: as few vertices as possible, which are
// cones, corners, the ends of features, and vertices that can't be removed; and round triangles.

#include <CGAL/Quad_remeshing/internal/quantization/Polygon_filler.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

class Vertex_remover
{
public:
  Vertex_remover(const Integer_mesh& input, Intrinsic_complex& complex)
    : m_complex(complex), m_filler(input, complex)
  { }

  // Removes the vertex, if that is possible and it has at most so many faces.
  bool remove(const std::size_t v, const std::size_t largest_degree)
  {
    if(!m_complex.is_regular[v] || !find_star(v, largest_degree))
      return false;
    const bool is_border = m_complex.is_border[v];
    if(m_walls.empty() && !is_border)
      remove_inside();
    else if(is_border && m_walls.size() == 1 && is_straight(0, m_corners.size()))
      remove_on_wall(0, m_corners.size(), true);
    else if(!is_border && m_walls.size() == 2 && is_straight(m_walls[0], m_walls[1]))
      remove_on_feature();
    else
      return false;
    m_complex.corner_at_vertex[v] = no_index;
    return true;
  }

private:
  // The corners at v, counterclockwise, the turns from their charts to the chart of the first, and
  // which of them have a wall as first edge. Returns false if a face has v twice: then its star is
  // no disc.
  bool find_star(const std::size_t v, const std::size_t largest_degree)
  {
    m_corners.clear();
    m_turns.clear();
    m_walls.clear();
    Quarter_turns::Element turn = Quarter_turns::identity();
    const Corner_index first = m_complex.corner_at_vertex[v];
    Corner_index c = first;
    do {
      if(m_corners.size() == largest_degree)
        return false;
      if(m_complex.corner(Intrinsic_complex::next(c)).is_wall)
        m_walls.push_back(m_corners.size());
      m_corners.push_back(c);
      m_turns.push_back(turn);
      turn = Quarter_turns::compose(turn, Quarter_turns::inverse(m_complex.corner(c).rotation));
      c = m_complex.counterclockwise(c);
    } while(c != no_index && c != first);
    return std::none_of(m_corners.begin(), m_corners.end(), [&](const Corner_index h) {
      return m_complex.vertex(Intrinsic_complex::next(h)) == v ||
             m_complex.vertex(Intrinsic_complex::prev(h)) == v;
    });
  }

  std::size_t index(const std::size_t i) const { return i % m_corners.size(); }
  Corner_index corner(const std::size_t i) const { return m_corners[index(i)]; }

  // From the chart of corner i to the chart of corner `first`, counterclockwise from there.
  Quarter_turns::Element turn(const std::size_t first, const std::size_t i) const
  {
    return Quarter_turns::compose(Quarter_turns::inverse(m_turns[index(first)]), m_turns[index(i)]);
  }

  // Whether the first edge of corner `first` goes on straight in the last edge before corner `end`.
  bool is_straight(const std::size_t first, const std::size_t end) const
  {
    const Grid_vector& out =
      m_complex.corner(Intrinsic_complex::next(corner(first))).vector;
    const Grid_vector in =
      rotated(turn(first, end - 1), m_complex.corner(corner(end - 1)).vector);
    return are_opposite(out, negated(in));
  }

  void remove_inside()
  {
    m_filler.clear();
    for(std::size_t i = 0; i < m_corners.size(); ++i)
      m_filler.add_side(Intrinsic_complex::prev(m_corners[i]), m_turns[i]);
    fill(0, m_corners.size(), 2);
  }

  void remove_on_feature()
  {
    const std::size_t a = m_walls[0], b = m_walls[1];
    remove_on_wall(a, b, true);
    remove_on_wall(b, a + m_corners.size(), false);
  }

  // The fan from corner `first` to the one before corner `end`. Of two fans, the first one is
  // linked by the wall that leads to v, and the second one by the other side of that.
  void remove_on_wall(const std::size_t first, const std::size_t end, const bool is_first_fan)
  {
    m_filler.clear();
    for(std::size_t i = first; i < end; ++i)
      m_filler.add_side(Intrinsic_complex::prev(corner(i)), turn(first, i));
    const Corner_index in = corner(end - 1), out = Intrinsic_complex::next(corner(first));
    m_filler.add_merged_side(in, turn(first, end - 1), out, is_first_fan ? in : out);
    fill(first, end, 1);
  }

  // The first faces of the fan are filled, the others are not needed any more.
  void fill(const std::size_t first, const std::size_t end, const std::size_t number_of_unneeded)
  {
    m_faces.clear();
    for(std::size_t i = first; i < end; ++i)
      m_faces.push_back(corner(i) / 3);
    for(std::size_t i = 0; i < number_of_unneeded; ++i, m_faces.pop_back())
      for(Corner_index k = 0; k < 3; ++k)
        m_unneeded.push_back(3 * m_faces.back() + k);
    m_filler.fill(m_faces);
    for(const Corner_index h : m_unneeded)
      m_complex.corners[std::size_t(h)] = Intrinsic_corner();
    m_unneeded.clear();
  }

  Intrinsic_complex& m_complex;
  Polygon_filler m_filler;
  std::vector<Corner_index> m_corners, m_unneeded;
  std::vector<Quarter_turns::Element> m_turns; // per corner
  std::vector<std::size_t> m_walls;            // indices into m_corners
  std::vector<Flat_face_index> m_faces;
};

// Vertices with few faces first: their stars are cheap, and neighbors lose faces in turn. Returns
// the number of vertices that were removed.
inline std::size_t remove_vertices(const Integer_mesh& input, Intrinsic_complex& complex)
{
  Vertex_remover remover(input, complex);
  std::size_t sum = 0;
  for(const std::size_t largest_degree : {6, 8, 12, 1000000}) {
    std::size_t number = 1, removed = 1;
    while(50 * removed > number || (largest_degree > 12 && removed > 0)) {
      number = removed = 0;
      for(std::size_t v = 0; v < complex.number_of_vertices(); ++v)
        if(complex.is_regular[v] && complex.corner_at_vertex[v] != no_index) {
          ++number;
          removed += remover.remove(v, largest_degree) ? 1 : 0;
        }
      sum += removed;
    }
  }
  return sum;
}

// The faces and vertices that are still there, numbered anew.
inline Intrinsic_complex compacted(const Intrinsic_complex& complex)
{
  Intrinsic_complex result;
  std::vector<Flat_vertex_index> new_vertex(complex.number_of_vertices(), no_index);
  std::vector<Flat_face_index> new_face(complex.corners.size() / 3, no_index);
  for(Flat_face_index f = 0, n = 0; f < complex.number_of_faces(); ++f)
    if(complex.has_face(f)) {
      new_face[std::size_t(f)] = n++;
      result.part.push_back(complex.part[std::size_t(f)]);
    }
  const auto new_corner = [&](const Corner_index h)
    { return h == no_index ? no_index : 3 * new_face[std::size_t(h / 3)] + h % 3; };
  for(std::size_t v = 0; v < complex.number_of_vertices(); ++v)
    if(complex.corner_at_vertex[v] != no_index) {
      new_vertex[v] = Flat_vertex_index(result.corner_at_vertex.size());
      result.corner_at_vertex.push_back(new_corner(complex.corner_at_vertex[v]));
      result.is_border.push_back(complex.is_border[v]);
      result.is_regular.push_back(complex.is_regular[v]);
    }
  for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h)
    if(complex.has_face(h / 3)) {
      result.corners.push_back(complex.corner(h));
      result.corners.back().opposite = new_corner(complex.opposite(h));
      result.corners.back().vertex = new_vertex[complex.vertex(h)];
    }
  return result;
}

// One flip for each edge at the vertices that are still to be removed: their loops become other
// edges.
inline void flip_loops(const Integer_mesh& input, Intrinsic_complex& complex)
{
  Polygon_filler filler(input, complex);
  for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h)
    if(complex.has_face(h / 3) && complex.vertex(h) == complex.source(h) &&
       complex.is_regular[complex.vertex(h)] &&
       is_flippable(complex, h, &Intrinsic_corner::vector))
      flip(h, complex, filler);
}

inline void coarsen(const Integer_mesh& input, Intrinsic_complex& complex)
{
  remove_vertices(input, complex);
  do {
    make_delaunay(input, complex);
    flip_loops(input, complex);
  } while(remove_vertices(input, complex) > 0);
  make_delaunay(input, complex);
}

inline Intrinsic_complex make_coarse_complex(const Integer_mesh& input)
{
  Intrinsic_complex complex = make_complex(input);
  coarsen(input, complex);
  return compacted(complex);
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_COARSEN_H
