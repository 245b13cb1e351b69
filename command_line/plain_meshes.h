// Meshes without texture coordinates: what is written after an extraction of quads.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_PLAIN_MESHES_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_PLAIN_MESHES_H

#include "Model.h"
#include "maps/map_quads.h"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

// Throws `Failure` if it is not the name of a file that quads can be written to.
void check_quad_file(const std::string& filename);

// Throws `Failure` if there are any, after all files were written.
void check_inverted_quads(std::size_t number, const std::string& filename,
                          const std::string& remedy = "");

// Warns of quads that are inverted, and names the first, as the file that was written counts them.
void write_inverted_quads(std::ostream& os, std::size_t number,
                          const std::vector<std::size_t>& first, const std::string& filename);

// The same for quads that are folded.
void check_folded_quads(std::size_t number, const std::string& filename);
void write_folded_quads(std::ostream& os, std::size_t number,
                        const std::vector<std::size_t>& first, const std::string& filename);

// Of vertices that had to leave the surface or its features.
void write_displacement(std::ostream& os, std::size_t number, double largest);

// The features inside as 'l' elements of the OBJ format, of vertices as the mesh counts them.
std::string lines_of_features(const Mesh& quads, const Edge_bool_map& is_feature);

// In the format that the suffix of the file's name asks for: OFF, OBJ, which is also that of standard
// streams, or PLY, which has all numbers that hang on the mesh, too. OBJ files have the features.
// Throws `Failure`.
std::string text_of_quads(const Mesh& quads, const Edge_bool_map& is_feature,
                          const std::string& filename);
std::string text_of_quads(const Quad_soup& quads, const std::string& filename);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_PLAIN_MESHES_H
