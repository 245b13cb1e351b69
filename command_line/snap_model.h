// Snapping in the numbers that the user's programs read.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_SNAP_MODEL_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_SNAP_MODEL_H

#include "measures.h"

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

// What the options say of snapping.
inline auto snapping_parameters(const Alignment& alignment, const Seam_options& options)
{
  return CGAL::Seamless_snapping::parameters::edge_is_constrained_map(alignment.is_aligned)
    .tolerance(options.tolerance)
    .repair_flips(options.flip_repair())
    .number_of_untangling_iterations(options.untangling_iterations)
    .verbose(options.reading.verbose);
}

CGAL::Seamless_snapping::Snapping_report
snap_in_double(Model& model, const Alignment& alignment, const Seam_options& options);

// \pre the coordinates of the model are floats; they are afterwards
CGAL::Seamless_snapping::Snapping_report
snap_in_float(Model& model, const Alignment& alignment, const Seam_options& options);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_SNAP_MODEL_H
