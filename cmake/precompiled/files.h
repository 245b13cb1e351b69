// Readers of files, as far as they don't know the mesh: declared here, they are compiled once, in
// files.cpp.

#ifndef SEAMLESS_SNAPPING_PRECOMPILED_FILES_H
#define SEAMLESS_SNAPPING_PRECOMPILED_FILES_H

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/IO/PLY.h>

#include <array>
#include <cstddef>
#include <vector>

namespace seamless_snapping_precompiled {

using Soup = CGAL::Seamless_snapping::internal::Corner_soup<double, double>;

} // namespace seamless_snapping_precompiled

#define SEAMLESS_SNAPPING_INSTANTIATE_FILES(PREFIX)                                                \
  PREFIX template class OBJ_parser<double, double>;                                                \
  PREFIX template class PLY_parser<double, double>;                                                \
  PREFIX template Soup_edges<seamless_snapping_precompiled::Soup::Triangle> connect_soup(          \
    bool, seamless_snapping_precompiled::Soup&, Vertex_changes&);                                  \
  PREFIX template Coinciding_sides find_coinciding_sides(                                          \
    const seamless_snapping_precompiled::Soup&, const std::vector<Side_index>&);                   \
  PREFIX template std::vector<std::size_t> welded_vertices(                                        \
    const seamless_snapping_precompiled::Soup&, const std::vector<std::array<Side_index, 2> >&);

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

SEAMLESS_SNAPPING_INSTANTIATE_FILES(extern)

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // SEAMLESS_SNAPPING_PRECOMPILED_FILES_H
