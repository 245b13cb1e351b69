// The mesh that most programs use, and how they fill it: declared here, it is compiled once, in
// mesh.cpp.

#ifndef SEAMLESS_SNAPPING_PRECOMPILED_MESH_H
#define SEAMLESS_SNAPPING_PRECOMPILED_MESH_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/array.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace seamless_snapping_precompiled {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertices = std::vector<Mesh::Vertex_index>;
using Three_vertices = std::array<Mesh::Vertex_index, 3>;
using Three_vertices_of_mesh = boost::array<Mesh::Vertex_index, 3>; // in CGAL 5
using Uv_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Edge_bool_map = Mesh::Property_map<Mesh::Edge_index, bool>;

} // namespace seamless_snapping_precompiled

#define SEAMLESS_SNAPPING_INSTANTIATE_PROPERTY(PREFIX, TYPE)                                       \
  PREFIX template class Properties::Property_array<TYPE>;

#define SEAMLESS_SNAPPING_INSTANTIATE_ADD_FACE(PREFIX, RANGE)                                      \
  PREFIX template seamless_snapping_precompiled::Mesh::Face_index                                  \
  Euler::add_face(const RANGE&, seamless_snapping_precompiled::Mesh&);

// Not all members of the classes can be instantiated: of the array of `bool`, the virtual ones.
#define SEAMLESS_SNAPPING_INSTANTIATE_MESH(PREFIX)                                                 \
  PREFIX template void Properties::Property_array<bool>::reserve(std::size_t);                     \
  PREFIX template void Properties::Property_array<bool>::resize(std::size_t);                      \
  PREFIX template void Properties::Property_array<bool>::shrink_to_fit();                          \
  PREFIX template void Properties::Property_array<bool>::push_back();                              \
  PREFIX template Properties::Base_property_array* Properties::Property_array<bool>::clone()       \
    const;                                                                                         \
  PREFIX template bool Properties::Property_array<bool>::transfer(                                 \
    const Properties::Base_property_array&);                                                       \
  PREFIX template bool Properties::Property_array<bool>::transfer(                                 \
    const Properties::Base_property_array&, std::size_t, std::size_t);                             \
  SEAMLESS_SNAPPING_INSTANTIATE_PROPERTY(PREFIX, seamless_snapping_precompiled::Kernel::Point_2)   \
  SEAMLESS_SNAPPING_INSTANTIATE_PROPERTY(PREFIX, seamless_snapping_precompiled::Kernel::Point_3)   \
  SEAMLESS_SNAPPING_INSTANTIATE_PROPERTY(                                                          \
    PREFIX, seamless_snapping_precompiled::Mesh::Vertex_connectivity)                              \
  SEAMLESS_SNAPPING_INSTANTIATE_PROPERTY(                                                          \
    PREFIX, seamless_snapping_precompiled::Mesh::Halfedge_connectivity)                            \
  SEAMLESS_SNAPPING_INSTANTIATE_PROPERTY(                                                          \
    PREFIX, seamless_snapping_precompiled::Mesh::Face_connectivity)                                \
  PREFIX template Surface_mesh<seamless_snapping_precompiled::Kernel::Point_3>::Surface_mesh();    \
  PREFIX template Surface_mesh<seamless_snapping_precompiled::Kernel::Point_3>&                    \
  Surface_mesh<seamless_snapping_precompiled::Kernel::Point_3>::operator=(                         \
    const seamless_snapping_precompiled::Mesh&);                                                   \
  PREFIX template void                                                                             \
  Surface_mesh<seamless_snapping_precompiled::Kernel::Point_3>::collect_garbage();                 \
  PREFIX template std::pair<seamless_snapping_precompiled::Edge_bool_map, bool>                    \
  Surface_mesh<seamless_snapping_precompiled::Kernel::Point_3>::add_property_map<SM_Edge_index>(   \
    std::string, bool);                                                                            \
  PREFIX template std::pair<seamless_snapping_precompiled::Uv_map, bool>                           \
  Surface_mesh<seamless_snapping_precompiled::Kernel::Point_3>::add_property_map<                  \
    SM_Halfedge_index>(std::string, seamless_snapping_precompiled::Kernel::Point_2);               \
  SEAMLESS_SNAPPING_INSTANTIATE_ADD_FACE(PREFIX, seamless_snapping_precompiled::Three_vertices)    \
  SEAMLESS_SNAPPING_INSTANTIATE_ADD_FACE(                                                          \
    PREFIX, seamless_snapping_precompiled::Three_vertices_of_mesh)                                 \
  SEAMLESS_SNAPPING_INSTANTIATE_ADD_FACE(PREFIX, seamless_snapping_precompiled::Vertices)

namespace CGAL {

SEAMLESS_SNAPPING_INSTANTIATE_MESH(extern)

} // namespace CGAL

#endif // SEAMLESS_SNAPPING_PRECOMPILED_MESH_H
