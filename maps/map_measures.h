// What a map of a surface is measured by before it is snapped.

#ifndef SEAMLESS_SNAPPING_MAPS_MAP_MEASURES_H
#define SEAMLESS_SNAPPING_MAPS_MAP_MEASURES_H

#include "surface_types.h"

#include <cstddef>
#include <utility>

// The sum of the areas of all faces, with signs, or of the positive faces. The coordinates are divided
// by a power of two near the largest one, so that the area of tiny or huge maps is neither 0 nor
// infinite. The second number is the exponent.
std::pair<double, int> area_in_domain(const Mesh& mesh, const Uv_map& uv_map,
                                      bool only_positive = false);

// The absolute value of the larger coordinate.
double largest_component(const Kernel::Vector_2& v);

// The lesser change of a coordinate along an edge, on the side on which it is larger.
double misalignment(const Mesh& mesh, const Uv_map& uv_map, Edge e);

// The change of a coordinate up to which an edge is meant to lie on an isocurve: a hundred times the
// inaccuracy of the seams, within bounds.
double tolerance_of_alignment(const Mesh& mesh, const Uv_map& uv_map);

// Cut edges, and how many of them no rotation by a multiple of 90 degrees fits up to the tolerance.
struct Misfits
{
  std::size_t number_of_cut_edges = 0, number_of_misfits = 0;
  std::size_t number_of_edges = 0; // inside
  std::size_t number_of_gross_misfits = 0; // which are off by more than an eighth of their length

  // In an atlas, charts are laid out and scaled independently: hardly an edge fits by chance. If a
  // solver was not asked to close the seams, most edges don't fit either, but are not far off. In
  // other maps, not each triangle is a chart of its own.
  bool looks_like_atlas() const
  {
    return number_of_gross_misfits > 0 && (number_of_cut_edges == number_of_edges ||
                                           2 * number_of_gross_misfits > number_of_cut_edges);
  }
};

// \param tolerance is relative to the extent of the coordinates
Misfits count_misfits(const Mesh& mesh, const Uv_map& uv_map, double tolerance);

#endif // SEAMLESS_SNAPPING_MAPS_MAP_MEASURES_H
