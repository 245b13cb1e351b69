// What the pictures of `seamless trace` share.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_TYPES_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_TYPES_H

#include "../Model.h"

#include <CGAL/Isocurves_and_layouts/trace_isocurve.h>

#include <iomanip>
#include <ostream>
#include <string>

namespace IL = CGAL::Isocurves_and_layouts;
namespace parameters = CGAL::Isocurves_and_layouts::parameters;

using Vertex = Mesh::Vertex_index;
using Curve = IL::Isocurve<Mesh>;
using Tracer = IL::Isocurve_tracer<Mesh>;

// The two maps of a comparison.
struct Pair_of_maps
{
  const Mesh& mesh;
  Uv_map inexact, exact;
  double tolerance;
};

inline void write_head(std::ostream& os, double width, double height)
{
  os << std::fixed << std::setprecision(2)
     << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' '
     << height << "\" font-family=\"sans-serif\" font-size=\"17\" fill=\"#333\">\n"
        "<defs><marker id=\"arrow\" viewBox=\"0 0 10 10\" refX=\"8\" refY=\"5\" markerWidth=\"6\" "
        "markerHeight=\"6\" orient=\"auto\"><path d=\"M0 0L10 5L0 10Z\" fill=\"#d55e00\"/></marker>"
        "</defs>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
}

inline void write_text(std::ostream& os, double x, double y, const std::string& text,
                       const std::string& style)
{
  os << "<text x=\"" << x << "\" y=\"" << y << "\" " << style << ">" << text << "</text>\n";
}

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_TRACING_TYPES_H
