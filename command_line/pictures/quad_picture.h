// A picture of a quad mesh: its edges, features and borders in bold, and its irregular vertices.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_QUAD_PICTURE_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_QUAD_PICTURE_H

#include "../Model.h"

#include <string>

// As SVG.
std::string quad_picture(const Mesh& quads, const Edge_bool_map& is_feature);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_QUAD_PICTURE_H
