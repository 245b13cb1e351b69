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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_FACE_GRAPH_MENDER_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_FACE_GRAPH_MENDER_H

#include <CGAL/license/Quad_remeshing.h>

// Quads that are no face graph, as some vertices have an edge to themselves or two to another one,
// become one where such edges get longer by one unit: the strip of quads across each is doubled.
// Strips may wind around the surface many times; where one is long, the cheapest strip of triangles
// is taken that crosses the same edge of the complex.

#include <CGAL/Quad_remeshing/internal/cells/Cell_extractor.h>
#include <CGAL/Quad_remeshing/internal/quantization/Strip_moves.h>
#include <CGAL/Quad_remeshing/internal/quantization/make_chart_mesh.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The line between two lines of the grid, through the triangles of a complex: where the quads along
// it are doubled, all edges that it crosses get one unit longer. It meets no vertex, as these lie
// on the grid.
class Line_between_quads
{
  using Group = Quarter_turns;

public:
  explicit Line_between_quads(const Chart_mesh& mesh) : m_mesh(mesh) { }

  // That through the midpoint of dart k of a point. Faces are appended; returns false, and appends
  // none, if the dart leaves the surface.
  bool find(const Lattice_point& point, const int k, std::vector<Strip_face>& faces) const
  {
    Place place = start_of_dart(point, k);
    const Uv end = unit_step<Group>(place.point, place.direction);
    Uv middle{(place.point[0] + end[0]) / 2, (place.point[1] + end[1]) / 2};
    Corner_index entry = no_index;
    for(Corner_index h; (h = exit_towards(place, middle, entry)) != no_index;) {
      entry = m_mesh.opposite(h);
      if(entry == no_index)
        return false;
      middle = across(h, middle);
      place = {entry, across(h, place.point), turned(place.direction, m_mesh.rotation(h))};
    }
    add_faces({place.corner, middle, turned(place.direction, 1)}, faces);
    return true;
  }

private:
  // On the surface, in the chart of the corner's face.
  struct Place
  {
    Corner_index corner;
    Uv point;
    Direction direction;
  };

  Place start_of_dart(const Lattice_point& p, const int k) const
  {
    switch(p.place) {
    case Lattice_place::VERTEX: {
      const Vertex_ray ray = rays_from_vertex(m_mesh, m_mesh.vertex(p.corner))[std::size_t(k)];
      return {ray.corner, m_mesh.uv(ray.corner), ray.direction};
    }
    case Lattice_place::EDGE:
      return {p.corner, p.uv, turned(Edge_directions(m_mesh, p.corner).first, k)};
    case Lattice_place::FACE:
      break;
    }
    return {p.corner, p.uv, k};
  }

  // The halfedge over which the way to `end` leaves the face, or no index if it ends there.
  Corner_index exit_towards(const Place& place, const Uv& end, const Corner_index entry) const
  {
    const Corner_index first = 3 * (place.corner / 3);
    for(Corner_index h = first; h < first + 3; ++h) {
      const Uv& source = m_mesh.uv(Chart_mesh::prev(h));
      const Uv& target = m_mesh.uv(h);
      if(h != entry && orientation({source, target, end}) == CGAL::NEGATIVE &&
         orientation({place.point, end, source}) != CGAL::POSITIVE &&
         orientation({place.point, end, target}) != CGAL::NEGATIVE)
        return h;
    }
    return no_index;
  }

  // In the chart behind the halfedge.
  Uv across(const Corner_index h, const Uv& u) const
  {
    return carried<Group>(u, m_mesh.rotation(h), m_mesh.uv(h),
                          m_mesh.uv(Chart_mesh::prev(m_mesh.opposite(h))));
  }

  // Those along the line, to both sides: around to the first one, or to the border.
  void add_faces(const Place& start, std::vector<Strip_face>& faces) const
  {
    const std::size_t first = faces.size();
    faces.push_back({way_out(start), no_index, unit_vector(turned(start.direction, 1))});
    if(!follow(start, start, faces)) {
      const Place back{start.corner, start.point, reversed(start.direction)};
      faces[first].entry = way_out(back);
      follow(back, back, faces);
    } else {
      faces[first].entry = faces.back().exit; // of the first face, which has come again
      faces.pop_back();
    }
  }

  // Appends the faces behind the first one. Returns whether the line closes.
  bool follow(Place place, const Place& start, std::vector<Strip_face>& faces) const
  {
    const Corner_index first = way_out(start);
    for(;;) {
      const Corner_index h = way_out(place), entry = m_mesh.opposite(h);
      if(entry == no_index)
        return false;
      Uv point = across(h, place.point);
      place = {entry, point, turned(place.direction, m_mesh.rotation(h))};
      const std::size_t running = running_component(place.direction);
      place.point[running] = m_mesh.uv(entry)[running]; // so that it stays small
      if(way_out(place) == first && place.direction == start.direction &&
         place.point[1 - running] == start.point[1 - running]) {
        faces.push_back({entry, entry, {}});
        return true;
      }
      faces.push_back({way_out(place), entry, unit_vector(turned(place.direction, 1))});
    }
  }

  // Over which the line leaves the face: it comes from the left of one end and the right of the
  // other.
  Corner_index way_out(const Place& place) const
  {
    const std::size_t c = constant_component(place.direction);
    const auto side = [&](const Corner_index corner)
      { return left_sign(place.direction) * compare(m_mesh.uv(corner)[c], place.point[c]); };
    Corner_index h = 3 * (place.corner / 3);
    while(!(side(Chart_mesh::prev(h)) < 0 && side(h) > 0))
      ++h;
    return h;
  }

  const Chart_mesh& m_mesh;
};

// Invariant: the units stay feasible.
class Face_graph_mender
{
public:
  Face_graph_mender(Intrinsic_complex& complex, const std::vector<double>& scales)
    : m_complex(complex), m_moves(complex, scales)
  { }

  // In 16 rounds at most, each of which extracts the quads. Returns whether they are a face graph
  // then, once folded ones are left out.
  bool run()
  {
    for(m_round = 0; m_round < most_rounds; ++m_round) {
      Extraction_options options;
      options.leave_out_folded_cells = true;
      Quad_extractor extractor(make_chart_mesh(m_complex), {}, options,
                               [](const Corner_index) { return std::string(); });
      Chart_mesh mesh; // that of the extractor goes
      if(!extractor.template run<CGAL::Sequential_tag>([&] { mesh = extractor.mesh(); }))
        return false;
      const std::vector<Strip> strips = strips_across_double_edges(extractor.complex());
      if(strips.empty() || !double_strips(mesh, extractor.complex(), strips))
        return strips.empty();
    }
    return false;
  }

private:
  // Of quads, around or from border to border.
  struct Strip
  {
    std::size_t point, dart;           // one dart across it, and where that begins
    std::size_t length = 0;            // in quads
    std::vector<std::size_t> vertices; // with double edges across it
  };

  static std::vector<Strip> strips_across_double_edges(const Cell_complex& quads)
  {
    const auto vertices =
      Cell_vertices::make<CGAL::Sequential_tag>(quads.points.size(), quads.darts,
                                                [&](const auto d) { return quads.is_gap(d); });
    std::vector<Strip> result;
    std::vector<std::size_t> strip_of; // per dart, from 1 on
    for(std::size_t v = 0; v < vertices.size(); ++v)
      for(const std::size_t d : double_edges(quads, vertices, v)) {
        strip_of.resize(quads.darts.size(), 0);
        if(strip_of[d] == 0) {
          result.push_back({vertices.point(v), d, 0, {}});
          for_each_dart_across(quads, d, [&](const std::size_t e) {
            strip_of[e] = result.size();
            result.back().length += quads.has_cell(e) ? 1 : 0;
          });
        }
        result[strip_of[d] - 1].vertices.push_back(v);
      }
    return result;
  }

  // In the strip of quads that the dart is across, to both sides of it.
  template <typename Visit>
  static void for_each_dart_across(const Cell_complex& quads, const std::size_t dart,
                                   const Visit& visit)
  {
    const std::size_t twin = quads.twin(dart);
    for(const std::size_t first : {dart, twin}) {
      std::size_t d = first;
      visit(d);
      while(quads.has_cell(d)) {
        const std::size_t opposite = quads.next(quads.next(d));
        visit(opposite);
        if(quads.darts.twins[opposite] < 0)
          break;
        d = quads.twin(opposite);
        if(d == first)
          return;
        visit(d);
      }
    }
  }

  // Those that mend most vertices for their length, until one is doubled for each vertex. Returns
  // whether anything has changed.
  bool double_strips(const Chart_mesh& mesh, const Cell_complex& quads, std::vector<Strip> strips)
  {
    std::stable_sort(strips.begin(), strips.end(), [](const Strip& s, const Strip& t)
      { return s.length * t.vertices.size() < t.length * s.vertices.size(); });
    const std::size_t long_length = (std::max)(std::size_t(16), quads.cells.size() / 64);
    const Line_between_quads line(mesh);
    std::vector<char> is_mended(quads.darts.size(), false); // per vertex
    bool has_changed = false;
    for(const Strip& s : strips) {
      if(std::all_of(s.vertices.begin(), s.vertices.end(),
                     [&](const std::size_t v) { return bool(is_mended[v]); }))
        continue;
      std::vector<Strip_face> faces;
      if(!line.find(quads.points[s.point], int(s.dart - quads.darts.first(s.point)), faces) ||
         !((s.length > long_length && move_near_by(faces)) || m_moves.move_along(faces)))
        continue;
      has_changed = true;
      for(const std::size_t v : s.vertices)
        is_mended[v] = true;
    }
    return has_changed;
  }

  // Where the cheapest strip crosses an edge of the complex next to that of two quads, that edge of
  // quads need not get longer: so each round tries another one, and the last ones none.
  bool move_near_by(const std::vector<Strip_face>& faces)
  {
    if(m_round >= most_rounds / 2)
      return false;
    const Strip_face& f = faces[std::size_t(m_round / 2) % faces.size()];
    return m_round % 2 == 0 ? m_moves.change(f.exit, f.change)
                            : m_moves.change(f.entry, negated(f.change));
  }

  static constexpr int most_rounds = 16;

  Intrinsic_complex& m_complex;
  Strip_moves m_moves;
  int m_round = 0;
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_FACE_GRAPH_MENDER_H
