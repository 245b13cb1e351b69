// A mesh with coordinates per corner, and the file it comes from.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_MODEL_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_MODEL_H

#include "maps/surface_types.h"
#include "formats/Mesh_text.h"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// The property maps belong to `mesh`, so that a model is neither copied nor moved.
struct Model
{
  Model() = default;
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  Mesh mesh;
  Uv_map uv_map = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  Edge_bool_map is_feature = mesh.add_property_map<Edge, bool>("e:feature", false).first;

  // Of the file; a model that does not come from one leaves these empty.
  std::string filename;
  formats::Mesh_text file;
  bool is_float = false; // whether the coordinates are floats
  bool is_mirrored = false; // u and v are exchanged here, as most of the area is flipped in the file
  std::vector<std::size_t> file_vertices; // for each vertex of the mesh, counted from 0
  std::vector<std::size_t> file_faces;    // the same for faces, where they differ
  std::size_t first_number = 1;           // by which the file counts
  std::size_t number_of_split_vertices = 0, number_of_welded_edges = 0,
              number_of_coinciding_border_edges = 0;
};

// Whether the file is a PLY file with coordinates at vertices: `Model::file` is the same mesh in the
// OBJ format then, but messages count as the file does.
bool has_coordinates_at_vertices(const Model& model);

// Of the bounding box.
double diagonal(const Mesh& mesh);

// While it lives, all points are multiplied by a power of two, such that products of lengths neither
// overflow nor vanish.
class Size_near_one
{
public:
  explicit Size_near_one(Mesh& mesh);
  ~Size_near_one();
  Size_near_one(const Size_near_one&) = delete;
  Size_near_one& operator=(const Size_near_one&) = delete;

  // A length in the size before.
  double unscaled(double length) const;

private:
  Mesh& m_mesh;
  int m_exponent;
  std::vector<Kernel::Point_3> m_points;
};

struct Reading_options
{
  bool weld = false;
  bool in_float = false; // reads coordinates as programs do that hold floats
  bool verbose = false; // tells of each step; else only of large files
};

// The format is that of the name's suffix; the standard input may be of any. Throws `Failure`.
void read_model(const std::string& filename, const Reading_options& options, Model& model);

// The file of another model, read with other options. Throws `Failure`.
void read_again(const Model& other, const Reading_options& options, Model& model);

// What to tell of mirrored maps, of border edges that coincide, of what was welded, and of vertices
// that were added; empty if there is nothing.
std::string notes_on_reading(const Model& model);

// That there are no features, if they are asked for; else nothing.
std::string note_on_features(bool are_asked_for, const Model& model);

// The model as a text in the format that the suffix of a name asks for: that of its file with other
// coordinates, if it is of this format; else what the mesh holds. Checks that it reads back as it is,
// floats also as doubles. Throws `Failure`.
std::string text_of_model(const Model& model, const std::string& filename);

// Whether that text holds no more than the mesh, since the file is of another format.
bool changes_format(const Model& model, const std::string& filename);

// Throws `Failure` if models cannot be written to files of the suffix of this name.
void check_format(const std::string& filename);

// A map of the mesh with the coordinates of now.
Uv_map copy_of_uv_map(Model& model);

// What the library says, in the words of the command line: vertices and faces, which the library
// counts from 0, as the file counts them, and options in place of named parameters.
std::string in_words_of_user(const Message& message, const Model& model);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_MODEL_H
