#include "patches.h"

#include "Failure.h"
#include "Options.h"
#include "files.h"
#include "pictures/quad_picture.h"
#include "words.h"

#include <CGAL/Quad_remeshing/quad_patches.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <iterator>
#include <locale>
#include <map>
#include <optional>
#include <ostream>
#include <sstream>
#include <vector>

namespace QR = CGAL::Quad_remeshing;

namespace {

using Patches = QR::Quad_patches<Mesh>;
using Vertex = Mesh::Vertex_index;

std::string text_of_patches(const Mesh& quads, const Patches& patches)
{
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os.precision(17);
  std::map<Vertex, std::size_t> numbers;
  for(const Vertex v : quads.vertices()) {
    os << "v " << quads.point(v) << "\n";
    numbers.emplace(v, numbers.size() + 1);
  }
  std::vector<Vertex> grid;
  for(std::size_t p = 0; p < patches.patches.size(); ++p) {
    const auto& patch = patches.patches[p];
    grid.clear();
    QR::vertices_of_patch(patch, quads, std::back_inserter(grid));
    os << "g patch_" << p + 1 << "\n";
    const std::size_t row = patch.width + 1;
    for(std::size_t j = 0; j < patch.height; ++j)
      for(std::size_t i = j * row; i < j * row + patch.width; ++i) {
        os << "f";
        for(const std::size_t k : {i, i + 1, i + row + 1, i + row})
          os << " " << numbers[grid[k]];
        os << "\n";
      }
  }
  return os.str();
}

Edge_bool_map edges_between(Mesh& quads, const Patches& patches)
{
  const Edge_bool_map result = quads.add_property_map<Edge, bool>("e:between_patches", false).first;
  for(const auto& patch : patches.patches) {
    Halfedge h = patch.corner;
    for(const std::size_t length : {patch.width, patch.height, patch.width, patch.height})
      for(std::size_t i = 1; i <= length; ++i) {
        result[quads.edge(h)] = true;
        h = i < length ? quads.next(quads.opposite(quads.next(h))) : quads.next(h);
      }
  }
  return result;
}

bool is_picture(const std::string& filename)
{
  return !is_special_file(filename) && suffix_of(filename) == "svg";
}

} // namespace

void add_patches_to(Options& options, std::string& filename)
{
  options.add("patches", "FILE", filename,
              "also divide the quads into rectangular patches; write these patches as .obj, with a group of "
              "quads, row by row, for each patch, or draw them as .svg");
}

void check_patch_file(const std::string& filename)
{
  if(!filename.empty() && !is_special_file(filename) && suffix_of(filename) != "obj" &&
     !is_picture(filename))
    throw Failure(USAGE, "'" + filename + "': patches are written to .obj files, and drawn as .svg");
}

std::optional<Patch_counts> write_patches(Mesh& quads, const Edge_bool_map& is_feature,
                                          const std::string& filename)
{
  if(filename.empty())
    return std::nullopt;
  const Patches patches =
    QR::quad_patches(quads, QR::parameters::edge_is_constrained_map(is_feature));
  if(!patches)
    throw Failure(NOT_SOLVED, filename + ": " + to_string(patches.status) + ": " + patches.message);
  write_file(filename, is_picture(filename) ? quad_picture(quads, edges_between(quads, patches))
                                            : text_of_patches(quads, patches));
  return Patch_counts{patches.patches.size(), patches.number_of_t_junctions};
}

void write_summary(std::ostream& os, const std::optional<Patch_counts>& counts)
{
  if(counts)
    os << counted(counts->number_of_patches, "patch") << ", "
       << counted(counts->number_of_t_junctions, "T-junction") << "\n";
}

nlohmann::json json_of(const std::optional<Patch_counts>& counts)
{
  if(!counts)
    return nullptr;
  return {{"number_of_patches", counts->number_of_patches},
          {"number_of_t_junctions", counts->number_of_t_junctions}};
}
