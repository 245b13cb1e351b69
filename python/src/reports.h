// What functions report, as dictionaries of Python: the names are those of the members.

#ifndef SEAMLESS_SNAPPING_PYTHON_REPORTS_H
#define SEAMLESS_SNAPPING_PYTHON_REPORTS_H

#include "Array_surface.h"
#include "Call.h"
#include "arrays.h"
#include "maps/map_measures.h"

#include <CGAL/Linear_snapping/types/Linear_report.h>
#include <CGAL/Linear_snapping/types/Report.h>
#include <CGAL/Seamless_snapping/types/Snapping_report.h>

#include <string>
#include <utility>
#include <vector>

// The parts of a message: kind, words, and the number of an element or None.
inline py::list parts_of(const Message& message)
{
  py::list result;
  for(const Message::Part& part : message.parts()) {
    const char* const kind = part.kind == Message::TEXT     ? "text"
                             : part.kind == Message::TERM   ? "term"
                             : part.kind == Message::REMEDY ? "remedy"
                                                            : "element";
    result.append(py::make_tuple(kind, part.words, part.kind < Message::FACE
                                   ? py::object(py::none()) : py::object(py::int_(part.index))));
  }
  return result;
}

inline py::dict dict_of(const std::vector<std::pair<std::string, double> >& step_times)
{
  py::dict result;
  for(const auto& [step, seconds] : step_times)
    result[py::str(step)] = (result.contains(step) ? result[py::str(step)].cast<double>() : 0)
                            + seconds;
  return result;
}

// \param surface whose vertices the message is about
inline py::dict dict_of(const CGAL::Linear_snapping::Report& report,
                        const Array_surface* const surface = nullptr)
{
  using namespace py::literals;
  return py::dict("success"_a = bool(report), "status"_a = to_string(report.status),
                  "message"_a = surface == nullptr ? report.message
                                  : with_rows(report.message, renamed(surface->rows())));
}

inline void add_distances(py::dict& result, const CGAL::Linear_snapping::Linear_report& report)
{
  result["extent"] = report.extent;
  result["violation_before"] = report.violation_before;
  result["largest_change"] = report.largest_change;
  result["mean_change"] = report.mean_change;
  result["step_times"] = dict_of(report.step_times);
}

// For maps that are not seamless.
inline void add_misfits(py::dict& result, const Misfits& misfits)
{
  if(misfits.number_of_misfits == 0)
    return;
  result["number_of_cut_edges"] = misfits.number_of_cut_edges;
  result["number_of_misfits"] = misfits.number_of_misfits;
  result["looks_like_atlas"] = misfits.looks_like_atlas();
}

// \param faces what the elements of the mesh are called: faces or cells
inline py::dict dict_of(const CGAL::Seamless_snapping::Snapping_report& report,
                        const std::string& faces, const Array_surface* const surface = nullptr)
{
  const CGAL::Linear_snapping::Report& outcome = report;
  py::dict result = dict_of(outcome, surface);
  add_distances(result, report);
  result["largest_rounding"] = report.largest_rounding;
  result[py::str("lost_" + faces)] = report.lost_faces;
  result["remaining_flips"] = report.remaining_flips;
  result["number_of_repaired_flips"] = report.run.number_of_repaired_flips;
  return result;
}

#endif // SEAMLESS_SNAPPING_PYTHON_REPORTS_H
