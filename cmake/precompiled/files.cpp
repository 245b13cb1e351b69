// Readers of files, compiled for all programs that use the precompiled headers.

#include "files.h"

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

SEAMLESS_SNAPPING_INSTANTIATE_FILES()

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL
