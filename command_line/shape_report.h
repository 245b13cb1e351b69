// How well the quads of a remeshing are shaped, and how near they are to the input.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_SHAPE_REPORT_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_SHAPE_REPORT_H

#include "Model.h"
#include "words.h"

#include <CGAL/Quad_remeshing/quad_remesh.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <ostream>

inline double diagonal(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

// \param diagonal that of the input
inline void write_shape(std::ostream& os, const CGAL::Quad_remeshing::Remeshing_report& report,
                        const double diagonal)
{
  os << "scaled Jacobian: least " << report.least_scaled_jacobian << ", mean "
     << report.mean_scaled_jacobian << "; less than 0.1: "
     << counted(report.number_of_thin_quads, "quad") << "\n"
     << "largest distance from the input: " << report.largest_distance << ", that is "
     << report.largest_distance / diagonal << " of its diagonal; of the input from the quads: "
     << report.largest_distance_of_input << ", that is "
     << report.largest_distance_of_input / diagonal << "\n";
}

inline nlohmann::json json_of_shape(const CGAL::Quad_remeshing::Remeshing_report& report,
                                    const double diagonal)
{
  return {{"least_scaled_jacobian", report.least_scaled_jacobian},
          {"mean_scaled_jacobian", report.mean_scaled_jacobian},
          {"number_of_thin_quads", report.number_of_thin_quads},
          {"largest_distance", report.largest_distance},
          {"relative_largest_distance", report.largest_distance / diagonal},
          {"largest_distance_of_input", report.largest_distance_of_input},
          {"relative_largest_distance_of_input", report.largest_distance_of_input / diagonal},
          {"diagonal", diagonal}};
}

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_SHAPE_REPORT_H
