// What snapping is measured by, and which edges it is asked to align.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_MEASURES_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_MEASURES_H

#include "Model.h"
#include "Options.h"
#include "maps/map_measures.h"

#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <cstddef>
#include <string>

// The options of all subcommands that look at seams.
struct Seam_options
{
  Reading_options reading;
  bool align_border = false;
  bool features = false;
  bool repair_flips = false, repairs_flips_near_by = false; // the second one is no option
  int untangling_iterations = 400;
  double tolerance = 1e-4;
  bool has_tolerance = false; // given on the command line

  void add_to(Options& options);
  void add_repair_to(Options& options);
  CGAL::Seamless_snapping::Flip_repair flip_repair() const;
  void check(const Options& options); // after parsing
  void check_repair(const Options& options) const;
};

// What the options ask to align: edges that lie on an isocurve up to the tolerance.
struct Alignment
{
  Alignment(Model& model, const Seam_options& options);

  Edge_bool_map is_aligned;
  std::size_t number_of_aligned_edges = 0;
  std::size_t number_of_left_out_edges = 0; // which lie on no isocurve
};

CGAL::Seamless_snapping::Seamlessness measure(const Model& model, const Alignment& alignment);

// Names a coordinate that is a million times larger than most, if there are few of these; else empty.
std::string note_on_far_coordinate(const Model& model);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_MEASURES_H
