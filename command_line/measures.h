// What snapping is measured by, and which edges it is asked to align.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_MEASURES_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_MEASURES_H

#include "Model.h"
#include "Options.h"

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

// Cut edges, and how many of them no rotation by a multiple of 90 degrees fits up to the tolerance.
struct Misfits
{
  std::size_t number_of_cut_edges = 0, number_of_misfits = 0;
  std::size_t number_of_edges = 0; // inside
  std::size_t number_of_gross_misfits = 0; // which are off by more than an eighth of their length

  // In an atlas, charts are laid out and scaled independently: hardly an edge fits by chance. Where
  // a solver was not asked to close the seams, most edges don't fit either, but are not far off.
  // Nor is each triangle a chart of its own anywhere else.
  bool looks_like_atlas() const
  {
    return number_of_gross_misfits > 0 && (number_of_cut_edges == number_of_edges ||
                                           2 * number_of_gross_misfits > number_of_cut_edges);
  }
};

Misfits count_misfits(const Model& model, double tolerance);

// Names a coordinate that is a million times larger than most, if there are few of these; else empty.
std::string note_on_far_coordinate(const Model& model);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_MEASURES_H
