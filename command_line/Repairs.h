// From a file to a triangle mesh that is an oriented surface; and what had to be repaired for that.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_REPAIRS_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_REPAIRS_H

#include "Model.h"
#include "Options.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <iosfwd>
#include <string>

// In the order in which they are made.
struct Repairs
{
  std::size_t file_points = 0, file_faces = 0;
  bool is_indexed = true;             // faces share points; if not, welding is no repair
  std::size_t degenerate_faces = 0;   // removed: fewer than three different corners
  std::size_t merged_points = 0;      // moved to the place of another one, as was asked
  std::size_t welded_points = 0;      // which became one with another in the same place
  std::size_t duplicate_faces = 0;    // removed: the corners of another face
  std::size_t unused_points = 0;      // of no face
  std::size_t cut_edges = 0;          // of three faces or more
  std::size_t one_sided_edges = 0;    // cut, as no way to turn the faces fits
  std::size_t bowtie_vertices = 0;    // copies of vertices that fans of faces had met in
  std::size_t faces_of_flat_pieces = 0; // removed: pieces none of whose faces has an area
  std::size_t first_face_of_flat_pieces = 0; // its number in the file
  std::size_t turned_faces = 0;
  std::size_t triangulated_faces = 0; // of more than three corners
  std::size_t split_diagonals = 0;    // at a new point, as other edges have the same ends
  std::size_t filled_holes = 0;       // as was asked
  std::size_t faces_of_filled_holes = 0;

  std::size_t vertices = 0, faces = 0, pieces = 0, border_loops = 0;
  std::size_t faces_without_area = 0; // that are kept
  std::size_t near_points = 0;        // of the border, almost in the place of others across a gap
  double distance_of_near_points = 0; // the largest of these
  std::size_t T_junctions = 0;        // points of the border inside of edges of the border
  std::size_t unused_segments = 0;    // of 'l' elements that are not asked for

  // In words, separated by commas; empty if nothing was repaired. Points of no face are no fault.
  std::string in_words() const;
};

struct Plain_reading_options
{
  bool features = false; // 'l' elements are features
  bool strict = false;
  double merge = 0; // points no farther apart than this
  double fill_holes = 0; // of at most so many edges
  bool verbose = false; // tells of each step; else only of large files

  void add_to(Options& options);
};

// Reads the mesh and its features, without coordinates. Throws `Failure`, also of what would have
// to be repaired where the options are strict.
Repairs read_plain_model(const std::string& filename, const Plain_reading_options& options,
                         Model& model);

// What was read, and what became of it.
void write_repairs(std::ostream& os, const std::string& filename, const Repairs& repairs);
nlohmann::json json_of(const Repairs& repairs);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_REPAIRS_H
