// A picture of a parametrization before and after it was snapped.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_PICTURE_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_PICTURE_H

#include "../Model.h"

#include <string>

// As SVG.
std::string picture(const Model& model, const Uv_map& old_uv_map, double tolerance,
                    const std::string& title);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_PICTURE_H
