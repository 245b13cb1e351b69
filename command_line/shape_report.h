// How well the quads of a remeshing are shaped, and how near they are to the input.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_SHAPE_REPORT_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_SHAPE_REPORT_H

#include "Model.h"
#include "words.h"

#include <CGAL/Quad_remeshing/quad_remesh.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <vector>

// The scaled Jacobians of the quads among the faces, as of a remeshing.
inline CGAL::Quad_remeshing::Remeshing_report measure_jacobians(const Mesh& mesh)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CGAL::Quad_remeshing::Remeshing_report result;
  result.least_scaled_jacobian = result.largest_aspect_ratio = 1;
  double sum = 0, number = 0;
  for(const auto f : mesh.faces()) {
    if(mesh.degree(f) != 4)
      continue;
    std::vector<Kernel::Point_3> p;
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      p.push_back(mesh.point(v));
    const Kernel::Vector_3 normal = CGAL::cross_product(p[2] - p[0], p[3] - p[1]);
    double least = 1, shortest = infinity, longest = 0; // squares of lengths
    for(std::size_t i = 0; i < 4; ++i) {
      const Kernel::Vector_3 a = p[(i + 1) % 4] - p[i], b = p[(i + 3) % 4] - p[i];
      shortest = (std::min)(shortest, a.squared_length());
      longest = (std::max)(longest, a.squared_length());
      const double scale =
        std::sqrt(a.squared_length() * b.squared_length() * normal.squared_length());
      least = (std::min)(least, scale > 0 ? CGAL::cross_product(a, b) * normal / scale : -1);
    }
    result.least_scaled_jacobian = (std::min)(result.least_scaled_jacobian, least);
    result.largest_aspect_ratio = (std::max)(result.largest_aspect_ratio,
                                             shortest > 0 ? std::sqrt(longest / shortest)
                                                          : infinity);
    result.number_of_long_quads += longest > 100 * shortest ? 1 : 0;
    result.number_of_thin_quads += least < 0.1 ? 1 : 0;
    sum += least;
    ++number;
  }
  result.mean_scaled_jacobian = number > 0 ? sum / number : 1;
  return result;
}

inline void write_jacobians(std::ostream& os,
                            const CGAL::Quad_remeshing::Remeshing_report& report)
{
  os << "scaled Jacobian: least " << report.least_scaled_jacobian << ", mean "
     << report.mean_scaled_jacobian << "; less than 0.1: "
     << counted(report.number_of_thin_quads, "quad") << ". Longest side of a quad over its shortest: "
     << "at most " << report.largest_aspect_ratio << "; more than 10: "
     << counted(report.number_of_long_quads, "quad") << "\n";
}

// \param diagonal that of the input
inline void write_shape(std::ostream& os, const CGAL::Quad_remeshing::Remeshing_report& report,
                        const double diagonal)
{
  write_jacobians(os, report);
  os << "largest distance from the input: " << report.largest_distance << ", that is "
     << report.largest_distance / diagonal << " of its diagonal; of the input from the quads: "
     << report.largest_distance_of_input << ", that is "
     << report.largest_distance_of_input / diagonal << "\n";
}

inline nlohmann::json json_of_jacobians(const CGAL::Quad_remeshing::Remeshing_report& report)
{
  return {{"least_scaled_jacobian", report.least_scaled_jacobian},
          {"mean_scaled_jacobian", report.mean_scaled_jacobian},
          {"number_of_thin_quads", report.number_of_thin_quads},
          {"number_of_long_quads", report.number_of_long_quads},
          {"largest_aspect_ratio", if_known(std::isfinite(report.largest_aspect_ratio),
                                            report.largest_aspect_ratio)}};
}

inline nlohmann::json json_of_shape(const CGAL::Quad_remeshing::Remeshing_report& report,
                                    const double diagonal)
{
  nlohmann::json result = json_of_jacobians(report);
  result.update(nlohmann::json{
    {"largest_distance", report.largest_distance},
    {"relative_largest_distance", report.largest_distance / diagonal},
    {"largest_distance_of_input", report.largest_distance_of_input},
    {"relative_largest_distance_of_input", report.largest_distance_of_input / diagonal},
    {"diagonal", diagonal}});
  return result;
}

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_SHAPE_REPORT_H
