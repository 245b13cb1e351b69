// Snapping with other rotations, compiled for all programs that share it.

#include "symmetries.h"

namespace CGAL {
namespace Seamless_snapping {

SEAMLESS_SNAPPING_INSTANTIATE_SYMMETRIES()

} // namespace Seamless_snapping
} // namespace CGAL
