#include "snap_model.h"

#include <CGAL/Seamless_snapping/snap_to_seamless.h>

namespace SS = CGAL::Seamless_snapping;

SS::Snapping_report snap_in_double(Model& model, const Alignment& alignment,
                                   const Seam_options& options)
{
  return SS::snap_to_seamless(model.mesh, model.uv_map, snapping_parameters(alignment, options));
}
