// Isocurves a segment at a time, as the layout walks along them. The tests compare them with their
// own walks.

#ifndef SEAMLESS_SNAPPING_TEST_ISOCURVE_WALKER_H
#define SEAMLESS_SNAPPING_TEST_ISOCURVE_WALKER_H

#include <CGAL/Isocurves_and_layouts/Isocurve_tracer.h>
#include <CGAL/Isocurves_and_layouts/internal/tracing/Segment_walker.h>
#include <CGAL/Isocurves_and_layouts/types/isocurve_types.h>
#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Seamless_snapping/internal/mesh/read_flat_mesh.h>

#include <CGAL/Exact_rational.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Isocurves_and_layouts {

namespace internal {

// The length of the curve from its start to a point of a segment.
inline Exact_rational length_up_to(const Chart_segment& segment, const Exact_rational& running)
{
  const Exact_rational difference(running - segment.origin.exact());
  return Exact_rational(running_sign(segment.direction) * difference);
}

// Where a member function hides the one of the mesh.
template <typename TriangleMesh, typename Halfedge>
auto face_of_halfedge(const Halfedge h, const TriangleMesh& tmesh)
{
  return face(h, tmesh);
}

} // namespace internal

// The part of an isocurve in one face, or along one edge, with exact coordinates in the chart of
// `face()`. It is valid as long as the tracer is.
template <typename TriangleMesh>
class Isocurve_segment
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

public:
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

  Isocurve_segment(const TriangleMesh& tmesh, const internal::Chart_mesh& mesh,
                   const internal::Flat_numbering<TriangleMesh>& numbering,
                   const internal::Chart_segment& segment)
    : m_tmesh(&tmesh), m_mesh(&mesh), m_numbering(&numbering), m_segment(segment)
  { }
  const internal::Chart_segment& chart_segment() const { return m_segment; }

  // Returns the face that the segment lies in. If it lies along an edge, this is one of the two
  // faces of the edge.
  face_descriptor face() const
  { return internal::face_of_halfedge(entry(), *m_tmesh); }

  // Returns the element at which the segment begins.
  Isocurve_place entry_place() const { return m_segment.entry.place; }

  // Returns a halfedge of `face()`: that which points to the vertex, or which lies on the edge, at
  // which the segment begins.
  halfedge_descriptor entry() const { return halfedge(m_segment.entry.halfedge); }

  // Returns the element at which the segment ends.
  Isocurve_place exit_place() const { return m_segment.exit.place; }

  // Returns a halfedge of `face()`: that which points to the vertex, or which lies on the edge, at
  // which the segment ends.
  halfedge_descriptor exit() const { return halfedge(m_segment.exit.halfedge); }

  // Returns `true` if the segment lies along an edge: then it belongs to both faces of the edge.
  bool is_along_edge() const { return m_segment.along != internal::no_index; }

  // Returns the halfedge of `face()` on which the segment lies, in either direction.
  // \pre `is_along_edge()`
  halfedge_descriptor edge_halfedge() const { return halfedge(m_segment.along); }

  // Returns the direction of the curve.
  Isocurve_direction direction() const
  { return internal::isocurve_direction<internal::Quarter_turns>(m_segment.direction); }

  // Returns the constant coordinate of the curve.
  Exact_rational constant_coordinate() const { return m_segment.level.exact(); }

  // Returns the other coordinate at the beginning of the segment, and at its end.
  Exact_rational from() const { return running_at(*m_mesh, m_segment, m_segment.entry); }
  Exact_rational to() const { return running_at(*m_mesh, m_segment, m_segment.exit); }

  // Returns the length of the curve in the domain, from its start to the beginning of the segment,
  // and to its end. The way back in flipped faces is subtracted.
  Exact_rational length_before() const { return length_up_to(m_segment, from()); }
  Exact_rational length_after() const { return length_up_to(m_segment, to()); }

private:
  halfedge_descriptor halfedge(const internal::Corner_index h) const
  { return m_numbering->halfedges_of_corners()[std::size_t(h)]; }

  const TriangleMesh* m_tmesh;
  const internal::Chart_mesh* m_mesh;
  const internal::Flat_numbering<TriangleMesh>* m_numbering;
  internal::Chart_segment m_segment;
};

// Walks along an isocurve of an exactly seamless parametrization, from a vertex. A copy goes on
// independently.
template <typename TriangleMesh>
class Isocurve_walker
{
public:
  using Tracer = Isocurve_tracer<TriangleMesh>;
  using Start = Isocurve_start<TriangleMesh>;
  using Segment = Isocurve_segment<TriangleMesh>;

  // \pre a ray leaves the vertex in this direction
  Isocurve_walker(const Tracer& tracer, const Start& start, const Isocurve_direction direction)
    : m_tracer(&tracer)
  {
    const internal::Protect_exact_arithmetic protect;
    internal::Vertex_ray ray{internal::no_index, 0, internal::Ray_kind::THROUGH_FACE};
    if(tracer.is_exact() &&
       find_ray(tracer.chart_mesh(), tracer.chart_start(start).halfedge,
                internal::chart_direction<internal::Quarter_turns>(direction), ray))
      m_walker.emplace(tracer.chart_mesh(), internal::no_limits(), ray);
  }

  // Goes on to the next segment, which the first call finds at the start, or returns how the curve
  // ends.
  Isocurve_status advance()
  {
    const internal::Protect_exact_arithmetic protect;
    return m_walker ? m_walker->advance() : Isocurve_status::NOT_EXACT;
  }

  // Returns the result of the last call of `advance()`.
  Isocurve_status status() const
  { return m_walker ? m_walker->status() : Isocurve_status::NOT_EXACT; }

  // \pre a call of `advance()` has returned `Isocurve_status::CONTINUES`
  Segment segment() const
  {
    return Segment(m_tracer->mesh(), m_tracer->chart_mesh(), m_tracer->correspondence(),
                   m_walker->segment());
  }

private:
  const Tracer* m_tracer;
  std::optional<internal::Segment_walker> m_walker;
};

// The index among `tracer.outgoing()` of the way back, at the vertex at which a segment ends.
template <typename TriangleMesh>
std::size_t outgoing_index(const Isocurve_tracer<TriangleMesh>& tracer,
                           const Isocurve_segment<TriangleMesh>& arrival)
{
  const internal::Protect_exact_arithmetic protect;
  const internal::Chart_segment& segment = arrival.chart_segment();
  return internal::slot_of_arrival(tracer.chart_mesh(), segment, segment.direction);
}

// The segments of an isocurve from its start, at most `number`.
template <typename TriangleMesh>
std::vector<Isocurve_segment<TriangleMesh> >
isocurve_segments(const Isocurve_tracer<TriangleMesh>& tracer,
                  const Isocurve_start<TriangleMesh>& start, const Isocurve_direction direction,
                  const std::size_t number = (std::numeric_limits<std::size_t>::max)())
{
  std::vector<Isocurve_segment<TriangleMesh> > result;
  Isocurve_walker<TriangleMesh> walker(tracer, start, direction);
  while(result.size() < number && walker.advance() == Isocurve_status::CONTINUES)
    result.push_back(walker.segment());
  return result;
}

} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // SEAMLESS_SNAPPING_TEST_ISOCURVE_WALKER_H
