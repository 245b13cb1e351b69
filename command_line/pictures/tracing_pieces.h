// The piece of a traced isocurve between two of its points, in the chart of the face that it
// crosses.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_PIECES_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_PIECES_H

#include <CGAL/Isocurves_and_layouts/trace_isocurve.h>

#include <array>
#include <cstddef>
#include <utility>

using Uv_vector = std::array<double, 2>;
using Uv_segment = std::pair<Uv_vector, Uv_vector>;

template <typename Mesh, typename UVMap>
Uv_segment curve_piece(const CGAL::Isocurves_and_layouts::Isocurve_point<Mesh>& from,
                       const CGAL::Isocurves_and_layouts::Isocurve_point<Mesh>& to, const Mesh& mesh,
                       const UVMap& uv_map)
{
  using Place = CGAL::Isocurves_and_layouts::Isocurve_place;
  const auto uv = [&](const auto h) -> Uv_vector {
    return {{get(uv_map, h).x(), get(uv_map, h).y()}};
  };
  const auto f = face(to.halfedge(), mesh);
  const Uv_vector end = CGAL::Isocurves_and_layouts::isocurve_uv(to, mesh, uv_map);
  if(from.place() == Place::VERTEX)
    for(const auto h : CGAL::halfedges_around_face(to.halfedge(), mesh))
      if(target(h, mesh) == target(from.halfedge(), mesh))
        return {uv(h), end};
  const auto h = opposite(from.halfedge(), mesh);
  if(from.place() != Place::EDGE || face(h, mesh) != f)
    return {CGAL::Isocurves_and_layouts::isocurve_uv(from, mesh, uv_map), end};
  // where the isocurve through the end meets the edge, seen from this side
  const std::size_t c = int(to.direction()) % 2 == 0 ? 1 : 0;
  const Uv_vector a = uv(prev(h, mesh)), b = uv(h);
  const double s = a[c] == b[c] ? 0.5 : (end[c] - a[c]) / (b[c] - a[c]);
  return {{{a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])}}, end};
}

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_PIECES_H
