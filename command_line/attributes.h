// What hangs on the vertices, corners, and faces of a file, carried over to quads: of .ply files all
// properties that are numbers, and colors; of .obj files colors, texture coordinates, objects, groups,
// and materials.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_ATTRIBUTES_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_ATTRIBUTES_H

#include "Model.h"
#include "Repairs.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

using Location = std::pair<Mesh::Face_index, std::array<double, 3> >; // in the model's mesh

struct Located_quads
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, Location> of_vertex =
    mesh.add_property_map<Mesh::Vertex_index, Location>("v:location").first;
  Mesh::Property_map<Mesh::Face_index, Location> of_face =
    mesh.add_property_map<Mesh::Face_index, Location>("f:location").first;
  Edge_bool_map is_feature = mesh.add_property_map<Edge, bool>("e:feature", false).first;
  std::vector<Mesh::Face_index> written; // in this order; empty: in that of the mesh

  // Takes the numbers that faces have in the mesh for those in the file.
  void count_as_written(std::vector<std::size_t>& faces) const
  {
    for(std::size_t& f : faces)
      if(!written.empty())
        f = std::size_t(std::find(written.begin(), written.end(),
                                  Mesh::Face_index(Mesh::size_type(f))) - written.begin());
  }
};

// Whether CGAL reads the text of a .ply file as a mesh, with what hangs on it.
bool read_PLY_mesh(const std::string& text, Mesh& mesh);

// The quads with what hangs on the file of the model, if they are to be of the same format; else the
// quads alone. Floating-point numbers, colors, and texture coordinates are interpolated; integers are
// those of the nearest vertex, and what hangs on faces that of the face below the middle of a quad.
// \param input the file of the model, which is read again if it is no standard stream
std::string text_with_attributes(const Model& model, const std::string& input, Located_quads& quads,
                                 const std::string& filename);

// A number for each vertex of the model: that of a property of its .ply file, or of a text file with a
// number for each vertex of its file; 1 where no name is given. Throws `Failure`.
Mesh::Property_map<Mesh::Vertex_index, double>
read_sizes(const std::string& property_or_file, const std::string& input, const Repairs& repairs,
           Model& model);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_ATTRIBUTES_H
