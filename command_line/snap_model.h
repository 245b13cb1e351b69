// Snapping in the numbers that the user's programs read.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_SNAP_MODEL_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_SNAP_MODEL_H

#include "measures.h"

#include <CGAL/Seamless_snapping/Snapping_report.h>

CGAL::Seamless_snapping::Snapping_report
snap_in_double(Model& model, const Alignment& alignment, const Seam_options& options);

// \pre the coordinates of the model are floats; they are afterwards
CGAL::Seamless_snapping::Snapping_report
snap_in_float(Model& model, const Alignment& alignment, const Seam_options& options);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_SNAP_MODEL_H
