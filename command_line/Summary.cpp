#include "Summary.h"

#include "Failure.h"
#include "json_report.h"
#include "words.h"

#include <nlohmann/json.hpp>

#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>

namespace {

std::string to_text(double x)
{
  std::ostringstream os;
  os << std::setprecision(3) << x;
  return os.str();
}

// `relative` to `extent` in brackets
std::string to_text(double x, double extent)
{
  return x == 0 || extent == 0 ? to_text(x) : to_text(x) + " (" + to_text(x / extent) + ")";
}

template <typename A, typename B>
void write_row(std::ostream& os, const char* name, const A& a, const B& b)
{
  os << "  " << std::left << std::setw(26) << name << std::right << std::setw(24) << a
     << std::setw(24) << b << '\n';
}

void write_mesh(std::ostream& os, const Summary& s)
{
  os << counted(s.faces, "face") << ", " << counted(s.vertices, "vertex") << ", "
     << counted(s.border_edges, "border edge") << ", " << counted(s.features, "feature edge")
     << "\n";
  os << s.notes_on_reading;
  if(s.left_out_edges > 0)
    os << "note: " << counted(s.left_out_edges, "edge") << is_or_are(s.left_out_edges)
       << "left out: no isocurve is there\n";
}

void write_note_on_area(std::ostream& os, const Summary& s,
                        const CGAL::Seamless_snapping::Seamlessness& measured)
{
  if(measured.number_of_degenerate_faces == s.faces)
    os << "note: no face has an area in the domain: this is no map\n";
}

nlohmann::json json_of(const CGAL::Seamless_snapping::Seamlessness& s)
{
  return {{"inexact_edges", s.number_of_inexact_edges},
          {"violation", s.violation},
          {"misaligned_edges", s.number_of_misaligned_edges},
          {"misalignment", s.misalignment},
          {"flipped_faces", s.number_of_flipped_faces},
          {"degenerate_faces", s.number_of_degenerate_faces}};
}

// What was measured: nothing of a result where there is none.
nlohmann::json json_of(const Summary& s, bool success, const std::string& message)
{
  nlohmann::json result = {
    {"exact", success},
    {"message", message},
    {"status", s.has_report ? CGAL::Linear_snapping::to_string(s.report.status) : "not snapped"},
    {"mesh", {{"vertices", s.vertices}, {"faces", s.faces}, {"border_edges", s.border_edges},
              {"feature_edges", s.features}, {"split_vertices", s.split_vertices},
              {"welded_edges", s.welded_edges},
              {"coinciding_border_edges", s.coinciding_border_edges}}},
    {"alignment", {{"aligned_edges", s.aligned_edges}, {"left_out_edges", s.left_out_edges}}},
    {"extent", s.before.extent},
    {"before", json_of(s.before)}};
  if(!s.has_report)
    return result;
  const auto& r = s.report;
  result["seconds"] = {{"reading", s.reading_time}, {"snapping", s.snapping_time},
                       {"steps", json_of_steps(r.step_times)}};
  if(!r)
    return result;
  result["after"] = json_of(s.after);
  result["seams"] = {{"cut_edges", r.run.number_of_cut_edges},
                     {"merged_edges", r.run.number_of_merged_edges},
                     {"cut_branches", r.run.number_of_cut_branches},
                     {"align_branches", r.run.number_of_align_branches},
                     {"nodes", r.run.number_of_nodes},
                     {"singular_vertices", r.run.number_of_singular_vertices},
                     {"edges_decided_by_surroundings",
                      r.run.number_of_edges_decided_by_surroundings}};
  result["system"] = {{"unknowns", r.linear_solver.number_of_unknowns},
                      {"constraints", r.linear_solver.number_of_constraints},
                      {"redundant_constraints", r.linear_solver.number_of_redundant_constraints},
                      {"non_unit_pivots", r.linear_solver.number_of_non_unit_pivots},
                      {"multiprecision", r.linear_solver.multiprecision}};
  result["change"] = {{"grid_step", if_known(r.grid_step > 0, r.grid_step)},
                      {"largest_of_a_coordinate", r.largest_change},
                      {"mean_at_seams", r.mean_change}, {"rms_at_seams", r.rms_change}};
  result["seconds"]["writing"] = s.writing_time;
  return result;
}

} // namespace

Summary::Summary(const Model& model, const Alignment& alignment)
  : vertices(model.mesh.number_of_vertices()), faces(model.mesh.number_of_faces()),
    split_vertices(model.number_of_split_vertices), welded_edges(model.number_of_welded_edges),
    coinciding_border_edges(model.number_of_coinciding_border_edges),
    aligned_edges(alignment.number_of_aligned_edges),
    left_out_edges(alignment.number_of_left_out_edges), notes_on_reading(::notes_on_reading(model))
{
  for(const Edge e : model.mesh.edges()) {
    border_edges += model.mesh.is_border(e) ? 1 : 0;
    features += model.is_feature[e] ? 1 : 0;
  }
}

std::string in_words_of_user(const CGAL::Seamless_snapping::Snapping_report& report,
                             const Model& model)
{
  return to_string(report.status) +
         (report.message.empty() ? "" : ": " + in_words_of_user(report.message, model));
}

void check_snapped(const CGAL::Seamless_snapping::Snapping_report& report, const Model& model,
                   const double tolerance)
{
  if(report)
    return;
  if(const std::string far = note_on_far_coordinate(model); !far.empty())
    throw Failure(NOT_SOLVED, model.filename + ": " + to_string(report.status) + ": " + far);
  const Misfits misfits = count_misfits(model.mesh, model.uv_map, tolerance);
  CGAL::Seamless_snapping::Snapping_report told(report);
  if(misfits.looks_like_atlas()) // for which no remedy serves
    told.message = report.message.without_remedies();
  throw Failure(NOT_SOLVED, model.filename + ": " + in_words_of_user(told, model) +
                              (misfits.number_of_misfits > 0 ? "\n" + to_text(misfits) : ""));
}

std::string to_text(const Misfits& misfits)
{
  return std::to_string(misfits.number_of_misfits) + " of "
         + std::to_string(misfits.number_of_cut_edges) + " cut edges don't fit"
         + (misfits.looks_like_atlas()
              ? ": this looks like a texture atlas, whose charts are laid out independently, and a "
                "larger tolerance does not help. Only charts that are related by rotations by "
                "multiples of 90 degrees can be made exact; 'seamless parametrize' computes others"
              : "");
}

void write_snap(std::ostream& os, const Summary& s)
{
  const auto& r = s.report;
  write_mesh(os, s);
  os << counted(r.run.number_of_cut_edges, "cut edge") << " in "
     << counted(r.run.number_of_cut_branches, "branch") << ", "
     << counted(r.run.number_of_nodes, "node") << ", "
     << counted(r.run.number_of_singular_vertices, "singular vertex")
     << " (cones of 720 degrees are not counted)\n";
  if(r.run.number_of_edges_decided_by_surroundings > 0)
    os << "note: another rotation than the nearest one was taken for "
       << counted(r.run.number_of_edges_decided_by_surroundings, "edge")
       << ", which are short for the inaccuracy, by their surroundings\n";
  if(s.aligned_edges + s.left_out_edges > 0)
    os << counted(s.aligned_edges, "edge") << is_or_are(s.aligned_edges)
       << "kept on isocurves, in " << counted(r.run.number_of_align_branches, "branch") << "\n";

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
  write_note_on_area(os, s, s.after);
  os << "  (in brackets: relative to the extent " << to_text(s.before.extent) << ")\n\n"
     << CGAL::Linear_snapping::to_string(r.status) << ": largest change "
     << to_text(r.largest_change, r.extent) << " of a coordinate, mean "
     << to_text(r.mean_change, r.extent) << " of the coordinates at seams\n"
     << "time: reading " << to_text(s.reading_time) << " s, snapping " << to_text(s.snapping_time)
     << " s, writing and reading back " << to_text(s.writing_time) << " s" << std::endl;
}

void write_check(std::ostream& os, const Summary& s)
{
  write_mesh(os, s);
  os << s.before.number_of_inexact_edges << " inexact edges of "
     << s.before.number_of_interior_edges << ", largest violation "
     << to_text(s.before.violation, s.before.extent) << "\n";
  if(s.aligned_edges > 0)
    os << s.before.number_of_misaligned_edges << " misaligned edges of " << s.aligned_edges
       << ", largest misalignment " << to_text(s.before.misalignment, s.before.extent) << "\n";
  os << counted(s.before.number_of_flipped_faces, "flipped face") << ", "
     << counted(s.before.number_of_degenerate_faces, "degenerate face") << "\n";
  write_note_on_area(os, s, s.before);
  os << (s.before.is_exact() ? "exactly seamless" : "not exactly seamless")
     << (s.coinciding_border_edges > 0 ? ", but for the border edges that coincide" : "")
     << (s.left_out_edges > 0 ? (s.before.is_exact() ? ", but" : ", and") +
                                 std::string(" not aligned along what is left out") : "")
     << " (in brackets: relative to the extent " << to_text(s.before.extent) << ")" << std::endl;
}

void write_report(const std::string& filename, const Summary& summary, const bool success,
                  const std::string& message)
{
  write_json(filename, json_of(summary, success, message));
}
