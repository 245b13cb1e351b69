// The quads of a map: of its own integers, or of a quantization. The program and the Python module
// make the same attempts in the same order.

#ifndef SEAMLESS_SNAPPING_MAPS_MAP_QUADS_H
#define SEAMLESS_SNAPPING_MAPS_MAP_QUADS_H

#include "surface_types.h"

#include <CGAL/Quad_remeshing/types/Extraction_report.h>
#include <CGAL/Quad_remeshing/types/Remeshing_report.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

struct Quad_soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t> > polygons;
};

// What is asked for.
struct Map_quad_options
{
  double number = 0;                        // of quads; 0 for the cells of the map as it is
  double grid_scale = 1;                    // without a number
  std::optional<double> rounding = {};      // 0.01; with a number 0.5, or any distance
  bool allow_holes = false, soup = false, repair_flips = false, verbose = false;
  double tolerance = 1e-4;
  int untangling_iterations = 400;
  // makes a map of the edges to align, with the border if asked to
  std::function<Edge_bool_map(bool with_border)> alignment = {};
  bool align_border = false;                // for integers that are near in the map
  std::function<void(const std::string& step)> tell = [](const std::string&) { };
};

// The quads, and how they were made.
struct Map_quads
{
  CGAL::Quad_remeshing::Extraction_report report;
  Quad_soup soup; // if a soup was asked for; else a mesh
  Mesh mesh;
  Edge_bool_map is_feature;
  // of snapping to integers, unless there is a quantization
  CGAL::Seamless_snapping::Snapping_report snapped;
  CGAL::Seamless_snapping::Snapping_report repaired; // of the map that was extracted or quantized
  Message integers;                                  // which they are
  Message why_rounded;                               // if there was to be a quantization
  std::optional<CGAL::Quad_remeshing::Remeshing_report> smoothed;

  bool is_rounded() const { return snapped.run.number_of_faces > 0; }
  // The part of the area in the domain.
  double part_left_out() const
  {
    return report.number_of_cut_cells == 0 ? 0 : 1 - double(report.number_of_faces) / report.area;
  }
};

// A map that can't be snapped.
struct Not_snapped
{
  CGAL::Seamless_snapping::Snapping_report report;
};

// Makes quads of a map. With a number of quads, the function takes
// - the integers that are near in the map itself, if these exist and make about the number;
// - or a quantization, also if it can't make so few, so that it never makes more quads than for a
//   larger number, and if fewer quads are inverted in it;
// - or, if faces are flipped, integers at any distance.
// Without a number, the function takes a quantization of about as many quads as the map has cells if
// repairs of flipped faces leave inverted quads, or no mesh.
// If the border is not meant to be aligned, a quantization comes last, because it follows the border
// edge by edge: if there are no quads otherwise, or they leave out more than half of the area.
// \param uv_map is snapped, or has other coordinates afterwards
// Throws `Not_snapped`.
Map_quads make_map_quads(const Map_quad_options& options, Mesh& mesh, Uv_map uv_map,
                         Edge_bool_map is_feature);

#endif // SEAMLESS_SNAPPING_MAPS_MAP_QUADS_H
