// A picture with an example of each failure of isocurves on an inexact map, and the same curve on
// an exact one, in the way of Fig. 3 of the paper.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_FAILURE_FIGURE_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_FAILURE_FIGURE_H

#include "tracing_failure_panel.h"
#include "tracing_types.h"

#include <CGAL/Seamless_snapping/seam_transitions.h>

#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <vector>

inline const char* explanation(const IL::Isocurve_status status)
{
  switch(status) {
  case IL::Isocurve_status::STUCK_AT_CUT:
    return "Stuck at a cut: behind it, the direction points back onto the edge.";
  case IL::Isocurve_status::FELL_INTO_GAP:
    return "Fallen into the gap: behind the cut, the place lies beside the edge.";
  case IL::Isocurve_status::NO_WAY_OUT:
    return "No way out of a regular vertex on a cut.";
  case IL::Isocurve_status::SEVERAL_WAYS_OUT:
    return "Several ways out of a regular vertex on a cut.";
  case IL::Isocurve_status::FELL_OFF_BORDER:
    return "Fallen off an aligned border.";
  case IL::Isocurve_status::MISSED_TARGET:
    return "Missed connection: the curve passes beside the vertex it should meet.";
  default:
    return "Spiral instead of a cycle: the curve returns beside its start.";
  }
}

// A failure at the left, the same curve on the exact map at the right.
inline void write_failure(std::ostream& os, const Pair_of_maps& maps, const Curve& curve,
                          const Curve& same, const double x, const double y)
{
  const auto inexact = IL::seam_transitions(maps.mesh, maps.inexact,
                                            parameters::tolerance(maps.tolerance));
  const auto exact = IL::seam_transitions(maps.mesh, maps.exact);
  write_text(os, x, y, explanation(curve.status), "");
  const bool spirals = curve.status == IL::Isocurve_status::SPIRALS;
  const bool has_expected = spirals || curve.status == IL::Isocurve_status::MISSED_TARGET;
  const Halfedge end = curve.points.back().halfedge();
  Vertex expected = maps.mesh.target(curve.start.halfedge);
  if(!spirals && has_expected)
    expected = maps.mesh.target(maps.mesh.next(maps.mesh.opposite(end)));
  Tracing_failure_panel<Mesh, Uv_map>(maps.mesh, maps.inexact, inexact, end)
    .write(os, curve, has_expected ? &expected : nullptr, x + 150, y + 170, 150);
  Tracing_failure_panel<Mesh, Uv_map>(maps.mesh, maps.exact, exact, end)
    .write(os, same, has_expected ? &expected : nullptr, x + 470, y + 170, 150);
}

inline void write_legend(std::ostream& os, const double y)
{
  os << "<path stroke-width=\"3\" stroke=\"#0072b2\" d=\"M40 " << y
     << "h26\"/><path stroke-width=\"3\" stroke=\"#e69f00\" d=\"M190 " << y
     << "h26\"/><path stroke-width=\"3\" stroke=\"#222\" d=\"M390 " << y
     << "h26\"/><circle cx=\"516\" cy=\"" << y << "\" r=\"6\" fill=\"#009e73\"/>"
     << "<circle cx=\"716\" cy=\"" << y
     << "\" r=\"5\" fill=\"#fff\" stroke=\"#d55e00\" stroke-width=\"2.5\"/>\n";
  write_text(os, 76, y + 6, "isocurve", "");
  write_text(os, 226, y + 6, "cut, both sides", "");
  write_text(os, 426, y + 6, "border", "");
  write_text(os, 532, y + 6, "vertex to be met", "");
  write_text(os, 732, y + 6, "failure, and the direction in which the isocurve should go on", "");
}

// The shortest curve of each kind of failure, two in a row.
inline void write_failures(std::ostream& os, const Pair_of_maps& maps,
                           const std::vector<Curve>& before, const Tracer& exact_tracer)
{
  std::map<IL::Isocurve_status, const Curve*> shortest;
  for(const Curve& curve : before)
    if(IL::is_failure(curve.status) && curve.points.size() > 1) {
      const Curve*& best = shortest[curve.status];
      if(best == nullptr || curve.points.size() < best->points.size())
        best = &curve;
    }
  const double height = 390 * double((shortest.size() + 1) / 2);
  write_head(os, 1400, height + 130);
  for(const double x : {40., 740.}) {
    const std::string style = "font-size=\"22\" text-anchor=\"middle\" fill=";
    write_text(os, x + 150, 44, "inexact", style + "\"#d55e00\"");
    write_text(os, x + 470, 44, "exact", style + "\"#009e73\"");
  }
  std::size_t i = 0;
  for(const auto& [status, curve] : shortest) {
    const Curve same = exact_tracer.trace(curve->start, curve->direction,
                                          parameters::maximum_number(10000));
    write_failure(os, maps, *curve, same, i % 2 == 0 ? 40 : 740, 86 + 390 * double(i / 2));
    ++i;
  }
  write_legend(os, height + 95);
  os << "</svg>\n";
}

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_FAILURE_FIGURE_H
