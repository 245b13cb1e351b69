// What closes the faces of a mesh and its holes by triangles.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_CLOSING_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_CLOSING_H

#include "Model.h"
#include "Polygon_soup.h"
#include "Repairs.h"

#include <cstddef>

// Divides all faces into triangles, such that no two edges have the same ends; counts these faces.
// Throws `Failure` that names a face of the file.
void triangulate(const Polygon_soup& soup, Model& model, Repairs& repairs);

// Fills the holes that have at most so many edges, and counts them.
void fill_holes(std::size_t most_edges, Model& model, Repairs& repairs);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_CLOSING_H
