#include "snap_model.h"

#include <CGAL/Seamless_snapping/snap_to_seamless.h>

namespace SS = CGAL::Seamless_snapping;

SS::Snapping_report snap_in_double(Model& model, const Alignment& alignment,
                                   const Seam_options& options)
{
  return SS::snap_to_seamless(model.mesh, model.uv_map,
                              SS::parameters::edge_is_constrained_map(alignment.is_aligned)
                                             .tolerance(options.tolerance)
                                             .repair_flips(options.flip_repair())
                                             .number_of_untangling_iterations(options.untangling_iterations)
                                             .verbose(options.reading.verbose));
}
