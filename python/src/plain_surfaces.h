// Surfaces without coordinates, on which the functions work that make some.

#ifndef SEAMLESS_SNAPPING_PYTHON_PLAIN_SURFACES_H
#define SEAMLESS_SNAPPING_PYTHON_PLAIN_SURFACES_H

#include "Array_surface.h"

#include <optional>
#include <vector>

using Direction_map = Mesh::Property_map<Mesh::Face_index, Kernel::Vector_3>;

// Throws `Refused` if the surface is cut open along edges in the same place, and the caller has not
// said what to do about them.
void check_closed_seams(const Array_surface& surface, std::optional<bool> weld);

// Multiplies all points by a power of two, so that products of lengths neither overflow nor vanish.
void scale_near_one(Mesh& mesh);

// Directions of the faces, of a length near 1; 0 without any.
Direction_map direction_map(Mesh& mesh, const std::vector<double>& directions);

#endif // SEAMLESS_SNAPPING_PYTHON_PLAIN_SURFACES_H
