// What the subcommands that look at seams tell of their work: as a table, and as JSON.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_SUMMARY_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_SUMMARY_H

#include "measures.h"

#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <cstddef>
#include <iosfwd>
#include <string>

struct Summary
{
  Summary(const Model& model, const Alignment& alignment);

  std::size_t vertices, faces, border_edges = 0, features = 0;
  std::size_t split_vertices, welded_edges, coinciding_border_edges;
  std::size_t aligned_edges, left_out_edges;
  std::string notes_on_reading;
  CGAL::Seamless_snapping::Seamlessness before, after;
  CGAL::Seamless_snapping::Snapping_report report;
  bool has_report = false;
  double reading_time = 0, snapping_time = 0, writing_time = 0;
};

// Status and message.
std::string in_words_of_user(const CGAL::Seamless_snapping::Snapping_report& report,
                             const Model& model);

// Throws `Failure` unless the model was snapped: why not, and what its cut edges look like.
void check_snapped(const CGAL::Seamless_snapping::Snapping_report& report, const Model& model,
                   double tolerance);

// "208 of 300 cut edges don't fit", and what that looks like.
std::string to_text(const Misfits& misfits);

// The tables of `seamless snap` and `seamless check`.
void write_snap(std::ostream& os, const Summary& summary);
void write_check(std::ostream& os, const Summary& summary);

// As JSON.
void write_report(const std::string& filename, const Summary& summary, bool success,
                  const std::string& message);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_SUMMARY_H
