// The table of the words in which the program says what the library calls by other names.

#include "words.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace {

using Message = CGAL::Linear_snapping::Message;

std::string_view name_of_command;

// What the library says of its parameters and functions, and what stands for it here: in one
// command, or in all that have no row of their own above. If the words are empty, nothing does.
struct Row
{
  std::string_view theirs, ours, command = "";
};

constexpr std::string_view in_quads = "quads", in_hexes = "hexes", in_layout = "layout";
constexpr std::string_view only_right_angles =
  ", but this program makes maps exact for N = 4, rotations by multiples of 90 degrees, only";

constexpr Row rows[] = {
  // seams and alignments
  {": pass rotational_symmetry(Rotational_symmetry<3>())", only_right_angles},
  {": pass rotational_symmetry(Rotational_symmetry<6>())", only_right_angles},
  {", in which it cannot be exact: apply convert_to_lattice_coordinates(), and pass "
   "rotational_symmetry(Rotational_symmetry<3>())", only_right_angles},
  {", in which it cannot be exact: apply convert_to_lattice_coordinates(), and pass "
   "rotational_symmetry(Rotational_symmetry<6>())", only_right_angles},
  {"raise the tolerance", "raise --tolerance"},
  {", or, for facets of the boundary, pass align_boundary(false)",
   "; for features, give --ignore-features", in_hexes},
  {", or, for facets of the boundary, pass align_boundary(false)",
   ", or, for facets of the boundary, give --free-boundary; for features, --ignore-features"},
  {"call snap_to_seamless() first", "run 'seamless snap' first"},
  {"call snap_to_seamless() with align_border(true)", "run 'seamless snap' with --align-border"},
  {"call snap_to_seamless() with the same edge_is_constrained_map",
   "run 'seamless snap' with --features"},
  {"snap with align_border(true)", "run 'seamless snap' with --align-border"},
  {"see CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices()",
   "'seamless parametrize' takes them apart"},
  {"approximate_seamless_parametrization() computes some", "'seamless parametrize' computes some"},
  {"approximate_seamless_parametrization() computes others",
   "'seamless parametrize' computes others"},
  {"CGAL::Polygon_mesh_processing::orient_polygon_soup() cuts it",
   "'seamless parametrize' cuts such edges, and computes other coordinates"},
  {"set target_edge_length to about the length of an edge", "scale the mesh to about the size 1"},
  {"the connection_tolerance of", "twice --near, or"},
  {"see whether its path is the one that is meant, and raise the tolerance if so",
   "see whether its path is the one that is meant, and raise --near if so"},

  // flips
  {"repair them by snap_to_seamless() with repair_flips(true)", "repair them by --repair-flips",
   in_layout},
  {"repair them by snap_to_seamless() with repair_flips(true)",
   "repair them by 'seamless snap' with --repair-flips"},
  {"repair them by repair_integer_grid(), or leave out the cells around them: allow_holes(true)",
   "try --repair-flips, or leave out the quads around them by --allow-holes"},
  {"the search for repairs ended at number_of_untangling_iterations: raise it",
   "the search for repairs has come to its bound", in_hexes},
  {"the search for repairs ended at number_of_untangling_iterations: raise it",
   "the search for repairs ended at --untangling-iterations: raise it"},
  {"Flip_repair::UNTANGLE changes more of the map",
   "with --number, more of the map changes", in_hexes},
  {"Flip_repair::UNTANGLE changes more of the map", "--repair-flips changes more of the map"},
  {"repair these first, by Flip_repair::UNTANGLE without integer_grid",
   "repair these first, by 'seamless snap' with --repair-flips", in_hexes},
  {"repair these first, by Flip_repair::UNTANGLE without integer_grid",
   "repair these first, by --repair-flips without --integer-grid"},
  {"snap_volume_to_seamless() with repair_flips(Flip_repair::UNTANGLE) makes cells positive if it "
   "can",
   "'seamless snap' with --repair-flips makes cells positive if it can"},

  // integers
  {"scale the map up by grid_scale", "ask for more hexahedra by --number", in_hexes},
  {"scale the map up by grid_scale", "scale the map up by --grid-scale or --number", in_quads},
  {"scale the map up by grid_scale", "scale the map up by --grid-scale"},
  {"the rounding_tolerance is", "without --number it may move by", in_hexes},
  {"the rounding_tolerance is", "--rounding is"},
  {"raise rounding_tolerance to at least this distance, or scale the map up by "
   "grid_scale",
   "ask for a number of hexahedra by --number, which rounds at any distance", in_hexes},
  {"raise rounding_tolerance to at least this distance, or scale the map up by "
   "grid_scale",
   "ask for a number of quads by --number, which finds integers for each map without flips, or "
   "raise --rounding to at least this distance", in_quads},
  {"raise rounding_tolerance to at least this distance, or scale the map up by "
   "grid_scale",
   "raise --rounding to at least this distance, or scale the map up by --grid-scale"},
  {"call snap_to_seamless() with integer_grid(true) first", "ask for a number of quads by --number"},
  {", or double the map: grid_scale(2)", ", or double the map by --grid-scale 2"},
  {"double the map, grid_scale(2), if the cones are half-integers, or use std::vector<std::size_t> "
   "for polygons", "double the map by --grid-scale 2"},
  {"snap_to_seamless() with integer_grid(true) and align_border(true) moves it to the grid",
   "--align-border moves it to the grid"},
  {"snap_volume_to_seamless() makes the map exactly seamless",
   "'seamless snap' makes the map exactly seamless"},
  {"snap_volume_to_seamless() with integer_grid(true) makes an integer-grid map",
   "'seamless snap' with --integer-grid makes an integer-grid map"},
  {"snap_volume_to_seamless() aligns it", "'seamless snap' aligns it"},
  {"scale by a power of two, or scale before the map is made exact, by snap_to_seamless() with "
   "grid_scale", "scale by a power of two, or scale before 'seamless snap'"},
  {"add twice the largest one to all, and snap the map by snap_to_seamless()",
   "add twice the largest one to all, and run 'seamless snap'"},
  {"pass the map through snap_to_seamless()", "run 'seamless snap' on the map"},

  // numbers of quads and hexahedra
  {"it must be at least 1 and at most 2^28, and at most maximum_number; see target_number_of_quads "
   "and target_edge_length",
   "it must be at least 1 and at most 2^28, and at most --maximum-number; see --number, "
   "--edge-length, and --sizes"},
  {"raise maximum_number, or shrink the map by grid_scale",
   "shrink the map by --grid-scale, or ask for fewer by --number"},
  {"shrink the map by grid_scale", "shrink the map by --grid-scale or --number"},
  {"raise maximum_number, or ask for fewer quads", "ask for fewer quads"},
  {"raise maximum_number, or let curves end where they meet others",
   "let curves end where they meet others: leave out --base-complex"},
  {"raise maximum_number", "raise --maximum-number"},
  {"scale the map down, or raise maximum_number",
   "ask for fewer by --number, or raise --maximum-number"},
  {". That is more than maximum_number: raise it, or ask for about as many, mark fewer features, "
   "or release some by maximum_feature_loss",
   ": ask for about as many, or mark fewer features", in_quads},
  {". That is more than maximum_number: raise it, or ask for about as many, mark fewer features, "
   "or release some by maximum_feature_loss",
   ". That is more than --maximum-number: raise it, or ask for about as many, mark fewer features, "
   "or release some by --feature-loss"},
  {", which is maximum_number: raise it", "", in_quads},
  {", which is maximum_number: raise it", ", which is --maximum-number: raise it"},
  {"some features can be released by maximum_feature_loss", "", in_quads},
  {"some features can be released by maximum_feature_loss",
   "some features can be released by --feature-loss"},
  {"minimize_number_of_quads(true) makes as few as are found",
   "--coarsest makes as few as are found"},
  {"let vertex_sizing_map and curvature_adaptivity vary sizes less",
   "let --sizes and --adaptivity vary sizes less"},
  {"quad_remesh() makes meshes of quads only", "'seamless remesh' makes meshes of quads only"},
  {"quantize to more quads, or with needs_face_graph(true)", "ask for more quads by --number"},
  {"quantize() with needs_face_graph(true), which leaves out its quad, or ",
   "make about as many quads by --number, which leaves out its quad, or "},
  {"call extract_quad_soup()", "try --soup or 'seamless remesh'"},

  // parameters
  {"area_threshold", "--area-threshold"},
  {"border_tolerance", "--border-tolerance"},
  {"curvature_adaptivity", "--adaptivity"},
  {"curvature_alignment", "--curvature"},
  {"grid_scale", "--grid-scale"},
  {"maximum_feature_loss", "--feature-loss"},
  {"symmetry_plane", "--symmetry"},
  {"target_edge_length", "--edge-length"}
};

} // namespace

void speak_for(const std::string_view command) { name_of_command = command; }

std::string words_of_program(const Message::Part& part)
{
  const auto row = std::find_if(std::begin(rows), std::end(rows), [&](const Row& r) {
    return r.theirs == part.words && (r.command.empty() || r.command == name_of_command);
  });
  return row == std::end(rows) ? part.words : std::string(row->ours);
}

std::string in_words_of_user(const Message& message)
{
  return message.str(words_of_program, [](const Message::Part& part) { return part.index; });
}
