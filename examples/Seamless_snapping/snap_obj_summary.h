// What snap_obj.cpp tells of its work: as a table, and as JSON.

#ifndef SEAMLESS_SNAPPING_EXAMPLES_SNAP_OBJ_SUMMARY_H
#define SEAMLESS_SNAPPING_EXAMPLES_SNAP_OBJ_SUMMARY_H

#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/Snapping_report.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>

struct Summary
{
  std::size_t vertices = 0, faces = 0, border_edges = 0, features = 0;
  std::size_t split_vertices = 0;
  std::size_t aligned_edges = 0, left_out_edges = 0;
  CGAL::Seamless_snapping::Seamlessness before, after;
  CGAL::Seamless_snapping::Snapping_report report;
  bool has_report = false;
  double reading_time = 0, snapping_time = 0, writing_time = 0;
};

// Status and message of a failure; the library counts vertices from 0.
inline std::string to_text(const CGAL::Seamless_snapping::Snapping_report& report)
{
  std::ostringstream os;
  os << report;
  if(report.message.find("vert") != std::string::npos)
    os << " (vertices counted from 0; the file counts from 1)";
  return os.str();
}

inline std::string to_text(double x)
{
  std::ostringstream os;
  os << std::setprecision(3) << x;
  return os.str();
}

// `relative` to `extent` in brackets
inline std::string to_text(double x, double extent)
{
  return x == 0 || extent == 0 ? to_text(x) : to_text(x) + " (" + to_text(x / extent) + ")";
}

template <typename A, typename B>
void write_row(std::ostream& os, const char* name, const A& a, const B& b)
{
  os << "  " << std::left << std::setw(26) << name << std::right << std::setw(24) << a
     << std::setw(24) << b << '\n';
}

inline std::ostream& operator<<(std::ostream& os, const Summary& s)
{
  const auto& r = s.report;
  os << s.faces << " faces, " << s.vertices << " vertices, " << s.border_edges
     << " border edges, " << s.features << " feature edges\n"
     << r.run.number_of_cut_edges << " cut edges in " << r.run.number_of_cut_branches
     << " branches, " << r.run.number_of_nodes << " nodes, " << r.run.number_of_singular_vertices
     << " singular vertices\n";
  if(s.split_vertices > 0)
    os << "note: " << s.split_vertices
       << " vertices were added where the faces around a vertex form several fans\n";
  if(s.aligned_edges + s.left_out_edges > 0)
    os << s.aligned_edges << " edges are kept on isocurves, in " << r.run.number_of_align_branches
       << " branches\n";
  if(s.left_out_edges > 0)
    os << "note: " << s.left_out_edges << " edges are left out, as they lie on no isocurve\n";

  os << '\n';
  write_row(os, "", "before", "after");
  write_row(os, "inexact edges", s.before.number_of_inexact_edges, s.after.number_of_inexact_edges);
  write_row(os, "largest violation", to_text(s.before.violation, s.before.extent),
            to_text(s.after.violation, s.after.extent));
  if(s.aligned_edges > 0) {
    write_row(os, "misaligned edges", s.before.number_of_misaligned_edges,
              s.after.number_of_misaligned_edges);
    write_row(os, "largest misalignment", to_text(s.before.misalignment, s.before.extent),
              to_text(s.after.misalignment, s.after.extent));
  }
  write_row(os, "flipped faces", s.before.number_of_flipped_faces, s.after.number_of_flipped_faces);
  write_row(os, "degenerate faces", s.before.number_of_degenerate_faces,
            s.after.number_of_degenerate_faces);
  os << "  (in brackets: relative to the extent " << to_text(s.before.extent) << ")\n\n"
     << CGAL::Seamless_snapping::to_string(r.status) << ": largest change "
     << to_text(r.largest_change, r.extent) << ", mean change " << to_text(r.mean_change, r.extent)
     << "\n" << "time: reading " << to_text(s.reading_time) << " s, snapping "
     << to_text(s.snapping_time) << " s, writing and reading back " << to_text(s.writing_time)
     << " s" << std::endl;
  return os;
}

inline nlohmann::json to_json(const CGAL::Seamless_snapping::Seamlessness& s)
{
  return {{"inexact_edges", s.number_of_inexact_edges},
          {"violation", s.violation},
          {"misaligned_edges", s.number_of_misaligned_edges},
          {"misalignment", s.misalignment},
          {"flipped_faces", s.number_of_flipped_faces},
          {"degenerate_faces", s.number_of_degenerate_faces}};
}

inline nlohmann::json to_json(const Summary& s, bool success, const std::string& message)
{
  const auto& r = s.report;
  nlohmann::json steps = nlohmann::json::array();
  for(const auto& [name, seconds] : r.run.step_times)
    steps.push_back({{"step", name}, {"seconds", seconds}});
  return {{"exact", success},
          {"message", message},
          {"status", s.has_report ? CGAL::Seamless_snapping::to_string(r.status) : "not snapped"},
          {"mesh", {{"vertices", s.vertices}, {"faces", s.faces}, {"border_edges", s.border_edges},
                    {"feature_edges", s.features}, {"split_vertices", s.split_vertices}}},
          {"alignment", {{"aligned_edges", s.aligned_edges},
                         {"left_out_edges", s.left_out_edges}}},
          {"extent", s.before.extent},
          {"before", to_json(s.before)},
          {"after", to_json(s.after)},
          {"seams", {{"cut_edges", r.run.number_of_cut_edges},
                     {"merged_edges", r.run.number_of_merged_edges},
                     {"cut_branches", r.run.number_of_cut_branches},
                     {"align_branches", r.run.number_of_align_branches},
                     {"nodes", r.run.number_of_nodes},
                     {"singular_vertices", r.run.number_of_singular_vertices}}},
          {"system", {{"unknowns", r.linear_solver.number_of_unknowns},
                      {"constraints", r.linear_solver.number_of_constraints},
                      {"redundant_constraints", r.linear_solver.number_of_redundant_constraints},
                      {"non_unit_pivots", r.linear_solver.number_of_non_unit_pivots},
                      {"multiprecision", r.linear_solver.multiprecision}}},
          {"change", {{"grid_step", r.run.grid_step}, {"largest", r.largest_change},
                      {"mean", r.mean_change}, {"rms", r.rms_change}}},
          {"seconds", {{"reading", s.reading_time}, {"snapping", s.snapping_time},
                       {"writing", s.writing_time}, {"steps", steps}}}};
}

// Names of files in messages may hold bytes that are not UTF-8; JSON cannot.
inline std::string to_text(const nlohmann::json& json)
{
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

#endif // SEAMLESS_SNAPPING_EXAMPLES_SNAP_OBJ_SUMMARY_H
