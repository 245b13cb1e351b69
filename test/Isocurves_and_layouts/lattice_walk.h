// Isocurves of exactly seamless maps, walked in rationals by code that knows nothing of levels: a
// point, a vector that is turned along with charts, and the intersection with the edges of a face.
// And the comparison with what the package traces, for four and six directions.

#ifndef SEAMLESS_SNAPPING_TEST_LATTICE_WALK_H
#define SEAMLESS_SNAPPING_TEST_LATTICE_WALK_H

#include "checking.h"
#include "hexagonal_maps.h"

#include <CGAL/Isocurves_and_layouts/Isocurve_tracer.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lattice_walk {

namespace IL = CGAL::Isocurves_and_layouts;
using namespace hexagonal_maps;

// Direction k of D, counterclockwise.
template <int D>
Exact_vector direction_vector(const int k)
{
  return turned<D>(k, Exact_vector{{Rational(1), Rational(0)}});
}

template <int D>
IL::Isocurve_direction direction_name(const int k)
{
  using Direction = IL::Isocurve_direction;
  constexpr std::array<Direction, 4> four{
    {Direction::PLUS_U, Direction::PLUS_V, Direction::MINUS_U, Direction::MINUS_V}};
  constexpr std::array<Direction, 6> six{
    {Direction::PLUS_U, Direction::PLUS_V, Direction::MINUS_U_PLUS_V, Direction::MINUS_U,
     Direction::MINUS_V, Direction::PLUS_U_MINUS_V}};
  return D == 4 ? four[std::size_t(k)] : six[std::size_t(k)];
}

template <int D>
Exact_vector vector_of(const IL::Isocurve_direction direction)
{
  for(int k = 0; k < D; ++k)
    if(direction_name<D>(k) == direction)
      return direction_vector<D>(k);
  return {};
}

inline Rational cross(const Exact_vector& a, const Exact_vector& b)
{
  return Rational(a[0] * b[1] - a[1] * b[0]);
}

inline Exact_vector sum(const Exact_vector& a, const Rational& s, const Exact_vector& b)
{
  return {{Rational(a[0] + s * b[0]), Rational(a[1] + s * b[1])}};
}

inline Exact_vector exact_point(const Kernel::Point_2& p)
{
  return {{Rational(p.x()), Rational(p.y())}};
}

// What a walk meets: a vertex, or the inside of an edge.
struct Stop
{
  bool is_vertex;
  Halfedge halfedge;  // points to the vertex, or is of the face that the walk leaves
  Exact_vector point; // and direction, in the chart of its face
  Exact_vector direction;
  Rational length;    // from the start, in steps of the direction
  bool is_along_edge; // the way there
};

template <int N>
class Reference_walk
{
public:
  Reference_walk(const Mesh& mesh, const UV_map uv)
    : m_mesh(mesh), m_uv(uv), m_turns(2 * mesh.number_of_edges(), 0)
  {
    for(const Halfedge h : mesh.halfedges())
      if(is_interior(mesh, h))
        m_turns[std::size_t(h)] = exact_turns(h);
  }

  // To the next edge or vertex; nothing at the border.
  std::optional<Stop> from_face(const Halfedge in_face, const Exact_vector& p,
                                const Exact_vector& d, const Rational& length) const
  {
    Halfedge h = in_face;
    for(int i = 0; i < 3; ++i, h = m_mesh.next(h)) {
      const Exact_vector a = sum(point(m_mesh.prev(h)), Rational(-1), p);
      const Exact_vector b = sum(point(h), Rational(-1), p);
      if(!(cross(d, a) < 0 && cross(d, b) >= 0 && cross(a, b) > 0))
        continue; // the walk leaves between a, at its right, and b, at its left
      const Exact_vector e = sum(b, Rational(-1), a);
      const Rational s(cross(a, e) / cross(d, e));
      return Stop{cross(d, b) == 0, h, sum(p, s, d), d, Rational(length + s), false};
    }
    return std::nullopt;
  }

  std::optional<Stop> next(const Stop& stop) const
  {
    return stop.is_vertex ? from_vertex(stop.halfedge, stop.direction, stop.length)
                          : from_edge(stop);
  }

  // Around the vertex to the face that the direction leads into: counterclockwise as far as that
  // goes, then clockwise.
  std::optional<Stop> from_vertex(const Halfedge corner, const Exact_vector& direction,
                                  const Rational& length) const
  {
    Halfedge h = corner;
    Exact_vector d = direction;
    do {
      if(leads_into(h, d))
        return leave(h, d, length);
      if(m_mesh.is_border(m_mesh.opposite(h)))
        break;
      d = turned<N>(m_turns[std::size_t(h)], d);
      h = m_mesh.prev(m_mesh.opposite(h));
    } while(h != corner);
    h = corner;
    d = direction;
    while(!m_mesh.is_border(m_mesh.opposite(m_mesh.next(h)))) {
      d = turned<N>(m_turns[std::size_t(m_mesh.next(h))], d);
      h = m_mesh.opposite(m_mesh.next(h));
      if(leads_into(h, d))
        return leave(h, d, length);
      if(h == corner)
        break;
    }
    return std::nullopt;
  }

  // From a point inside of an edge.
  std::optional<Stop> from_edge_point(const Halfedge h, const Exact_vector& p,
                                      const Exact_vector& d) const
  {
    const Exact_vector source = point(m_mesh.prev(h));
    const Exact_vector e = sum(point(h), Rational(-1), source);
    if(cross(e, d) > 0)
      return from_face(h, p, d, Rational(0));
    if(cross(e, d) < 0)
      return from_edge(Stop{false, h, p, d, Rational(0), false});
    const bool is_forward = e[0] * d[0] + e[1] * d[1] > 0;
    const Halfedge end = is_forward ? h : m_mesh.prev(h);
    const Exact_vector way = sum(point(end), Rational(-1), p);
    return Stop{true, end, point(end), d, Rational(d[0] != 0 ? way[0] / d[0] : way[1] / d[1]),
                true};
  }

private:
  Exact_vector point(const Halfedge h) const { return exact_point(m_uv[h]); }

  int exact_turns(const Halfedge h) const
  {
    const Halfedge o = m_mesh.opposite(h);
    const Exact_vector here = exact_vector(m_uv[m_mesh.prev(h)], m_uv[h]);
    const Exact_vector there = exact_vector(m_uv[o], m_uv[m_mesh.prev(o)]);
    for(int k = 0; k < N; ++k)
      if(turned<N>(k, here) == there)
        return k;
    CHECK(false);
    return 0;
  }

  bool leads_into(const Halfedge h, const Exact_vector& d) const
  {
    const Exact_vector a = sum(point(m_mesh.next(h)), Rational(-1), point(h));
    const Exact_vector b = sum(point(m_mesh.prev(h)), Rational(-1), point(h));
    return cross(a, d) >= 0 && (cross(d, b) > 0 || is_along_border(h, d));
  }

  bool is_along_border(const Halfedge h, const Exact_vector& d) const
  {
    const Exact_vector b = sum(point(m_mesh.prev(h)), Rational(-1), point(h));
    return m_mesh.is_border(m_mesh.opposite(h)) && cross(d, b) == 0 &&
           b[0] * d[0] + b[1] * d[1] > 0;
  }

  std::optional<Stop> leave(const Halfedge h, const Exact_vector& d, const Rational& length) const
  {
    const Halfedge end = is_along_border(h, d) ? m_mesh.prev(h) : m_mesh.next(h);
    const Exact_vector way = sum(point(end), Rational(-1), point(h));
    if(cross(way, d) != 0)
      return from_face(h, point(h), d, length);
    const Rational s(d[0] != 0 ? way[0] / d[0] : way[1] / d[1]);
    return Stop{true, end, point(end), d, Rational(length + s), true};
  }

  std::optional<Stop> from_edge(const Stop& stop) const
  {
    const Halfedge h = stop.halfedge, o = m_mesh.opposite(h);
    if(m_mesh.is_border(o))
      return std::nullopt;
    const int k = m_turns[std::size_t(h)];
    const Exact_vector from_source = sum(stop.point, Rational(-1), point(m_mesh.prev(h)));
    return from_face(o, sum(point(o), Rational(1), turned<N>(k, from_source)),
                     turned<N>(k, stop.direction), stop.length);
  }

  const Mesh& m_mesh;
  const UV_map m_uv;
  std::vector<int> m_turns;
};

// The coordinate that is constant in a direction.
inline Rational level_of(const IL::Isocurve_direction direction, const Exact_vector& p)
{
  using Direction = IL::Isocurve_direction;
  switch(direction) {
  case Direction::PLUS_U:
  case Direction::MINUS_U: return p[1];
  case Direction::PLUS_V:
  case Direction::MINUS_V: return p[0];
  default:                 return Rational(p[0] + p[1]);
  }
}

// Whether the points of an isocurve behind its start are those of a walk that has made its first
// stop, up to a vertex of the border, and end where that does.
template <int N, int D>
void check_points(const IL::Isocurve_tracer<Mesh, D>& tracer, const Mesh& mesh, const UV_map uv,
                  const Reference_walk<N>& walk, const IL::Isocurve<Mesh>& curve,
                  std::optional<Stop> stop, const std::string& context)
{
  using Status = IL::Isocurve_status;
  const bool closes_elsewhere = // it is the start once more, where the walk does not stop
    curve.status == Status::CLOSED && curve.start.place != IL::Isocurve_place::VERTEX;
  const std::size_t end = curve.points.size() - (closes_elsewhere ? 1 : 0);
  for(std::size_t i = 1; i < end; ++i) {
    CHECK_IN(context, bool(stop));
    if(!stop)
      return;
    const auto& point = curve.points[i];
    const Halfedge h = point.halfedge();
    CHECK_IN(context, (point.place() == IL::Isocurve_place::VERTEX) == stop->is_vertex);
    CHECK_IN(context, stop->is_vertex ? mesh.target(h) == mesh.target(stop->halfedge)
                                      : h == stop->halfedge);
    CHECK_IN(context, point.constant_coordinate() ==
                        level_of(point.direction(),
                                 stop->is_vertex ? exact_point(uv[h]) : stop->point));
    if(!stop->is_along_edge) {
      CHECK_IN(context, mesh.face(h) == mesh.face(stop->halfedge));
      CHECK_IN(context, vector_of<D>(point.direction()) == stop->direction);
    }
    if(stop->is_vertex && mesh.is_border(mesh.target(stop->halfedge)))
      return;
    if(stop->is_vertex && tracer.is_singular(mesh.target(stop->halfedge))) {
      CHECK_IN(context, i + 1 == end && curve.status == Status::SINGULAR_VERTEX);
      return;
    }
    stop = walk.next(*stop);
  }
  CHECK_IN(context, curve.status == Status::MAXIMUM_NUMBER || curve.status == Status::CLOSED ||
                      (curve.status == Status::BORDER && !stop));
}

} // namespace lattice_walk

#endif // SEAMLESS_SNAPPING_TEST_LATTICE_WALK_H
