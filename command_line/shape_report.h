// How well the quads of a remeshing are shaped, and how near they are to the input.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_SHAPE_REPORT_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_SHAPE_REPORT_H

#include "words.h"

#include <CGAL/Quad_remeshing/quad_remesh.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <ostream>
#include <vector>

inline void write_shapes(std::ostream& os, const CGAL::Quad_remeshing::Quad_shapes& shapes)
{
  const auto write_quads = [&](const std::size_t number, const std::vector<std::size_t>& first) {
    os << counted(number, "quad");
    for(const std::size_t f : first)
      os << (f == first.front() ? " (" : ", ") << f;
    os << (first.empty() ? "" : first.size() < number ? ", ...)" : ")");
  };
  os << "scaled Jacobian: least " << shapes.least_scaled_jacobian << ", mean "
     << shapes.mean_scaled_jacobian << "; less than 0.1: ";
  write_quads(shapes.number_of_thin_quads, shapes.first_thin_quads);
  os << ". Longest side of a quad over its shortest: at most " << shapes.largest_aspect_ratio
     << "; more than 10: " << counted(shapes.number_of_long_quads, "quad") << "\n";
  if(shapes.number_of_degenerate_quads == 0)
    return;
  os << "warning: degenerate to most uses, with one side 100 times as long as another, or a side "
        "shorter than a millionth of the mean one: ";
  write_quads(shapes.number_of_degenerate_quads, shapes.first_degenerate_quads);
  os << "\n";
}

// \param diagonal that of the input
inline void write_shape(std::ostream& os, const CGAL::Quad_remeshing::Remeshing_report& report,
                        const double diagonal)
{
  write_shapes(os, report);
  os << "largest distance from the input: " << report.largest_distance << ", that is "
     << report.largest_distance / diagonal << " of its diagonal; of the input from the quads: "
     << report.largest_distance_of_input << ", that is "
     << report.largest_distance_of_input / diagonal << "\n";
}

inline nlohmann::json json_of_shapes(const CGAL::Quad_remeshing::Quad_shapes& shapes)
{
  return {{"least_scaled_jacobian", shapes.least_scaled_jacobian},
          {"mean_scaled_jacobian", shapes.mean_scaled_jacobian},
          {"number_of_thin_quads", shapes.number_of_thin_quads},
          {"first_thin_quads", shapes.first_thin_quads},
          {"number_of_long_quads", shapes.number_of_long_quads},
          {"number_of_degenerate_quads", shapes.number_of_degenerate_quads},
          {"first_degenerate_quads", shapes.first_degenerate_quads},
          {"largest_aspect_ratio", if_known(std::isfinite(shapes.largest_aspect_ratio),
                                            shapes.largest_aspect_ratio)}};
}

inline nlohmann::json json_of_shape(const CGAL::Quad_remeshing::Remeshing_report& report,
                                    const double diagonal)
{
  nlohmann::json result = json_of_shapes(report);
  result.update(nlohmann::json{
    {"largest_distance", report.largest_distance},
    {"relative_largest_distance", report.largest_distance / diagonal},
    {"largest_distance_of_input", report.largest_distance_of_input},
    {"relative_largest_distance_of_input", report.largest_distance_of_input / diagonal},
    {"diagonal", diagonal}});
  return result;
}

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_SHAPE_REPORT_H
