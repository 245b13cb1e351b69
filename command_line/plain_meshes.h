// Meshes without texture coordinates: what programs read before a parametrization, and write after
// an extraction of quads.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_PLAIN_MESHES_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_PLAIN_MESHES_H

#include "Model.h"

#include <cstddef>
#include <string>
#include <vector>

// Triangulated. Throws `Failure`.
void read_mesh(const std::string& filename, Mesh& mesh);

// Marks edges that are sharper than the angle, in degrees, as features.
void mark_features(double angle, Mesh& mesh, Edge_bool_map& is_feature);

struct Quad_soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t> > polygons;
};

// In the format that the suffix of the file's name asks for, OFF or OBJ. Throws `Failure`.
std::string text_of_quads(const Mesh& quads, const std::string& filename);
std::string text_of_quads(const Quad_soup& quads, const std::string& filename);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_PLAIN_MESHES_H
