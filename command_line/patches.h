// Patches of quads, as splines are fitted to.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_PATCHES_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_PATCHES_H

#include "Model.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>

class Options;

void add_patches_to(Options& options, std::string& filename);
void check_patch_file(const std::string& filename);

struct Patch_counts
{
  std::size_t number_of_patches = 0, number_of_t_junctions = 0;
};

// Divides quads into rectangles, with features between these, and writes them with a group for each,
// or a picture of them. Nothing without a name. Throws `Failure`.
std::optional<Patch_counts> write_patches(Mesh& quads, const Edge_bool_map& is_feature,
                                          const std::string& filename);
void write_summary(std::ostream& os, const std::optional<Patch_counts>& counts);

// Null where there are none.
nlohmann::json json_of(const std::optional<Patch_counts>& counts);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_PATCHES_H
