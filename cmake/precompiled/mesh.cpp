// The mesh, compiled for all programs that use the precompiled headers.

#include "mesh.h"

namespace CGAL {

SEAMLESS_SNAPPING_INSTANTIATE_MESH()

} // namespace CGAL
