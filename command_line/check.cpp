// seamless check IN: tells whether the parametrization in a file is exactly seamless.

#include "Failure.h"
#include "Options.h"
#include "Summary.h"
#include "commands.h"
#include "files.h"
#include "json_report.h"
#include "measures.h"

#include <iostream>
#include <string>

namespace {

// What a mesh would be whose border edges coincide.
std::string what_welding_gives(const Model& model, Seam_options options)
{
  const std::string begin = "cut open, as if along its seams; welded it would ";
  const std::string end = "; use --weld, or --open if the cuts are borders";
  options.reading.weld = true;
  Model welded;
  try {
    read_again(model, options.reading, welded);
  } catch(const Failure& failure) {
    return begin + "be refused (" + failure.what() + ")" + end;
  }
  const bool is_exact = measure(welded, Alignment(welded, options)).is_exact();
  return begin + (is_exact ? "be exactly seamless" : "not be exactly seamless") + end;
}

} // namespace

void check(const Arguments& arguments)
{
  if(is_volume(arguments))
    return check_volume(arguments);
  Options options("check IN",
                  "Tells whether the texture coordinates of a triangle mesh are exactly seamless:\n"
                  "across each edge, the coordinates of both sides differ by a rotation by a\n"
                  "multiple of 90 degrees and a translation.\n"
                  "\n"
                  "IN is a .obj file, a .ply file with a list 'texcoord' for each face, or with s and\n"
                  "t, or u and v, for each vertex, or - for the standard input. For tetrahedral\n"
                  "meshes, see 'seamless check IN.hexex --help'.\n");
  std::string input, report;
  bool keeps_open = false;
  Seam_options seam_options;
  options.add_file("input", input);
  seam_options.add_to(options);
  options.add("float", seam_options.reading.in_float,
              "check the coordinates after rounding to 32-bit floats");
  options.add("open", keeps_open, "treat border edges between the same points as borders, not as cuts");
  options.add("report", "R.json", report, "write all measurements to a file, as JSON");
  options.exclude({"weld", "open"});
  if(!options.parse(arguments))
    return;
  seam_options.check(options);
  check_outputs({input}, {report});

  Model model;
  read_or_tell(report, "exact", [&] { read_model(input, seam_options.reading, model); });
  const Alignment alignment(model, seam_options);
  Summary summary(model, alignment);
  summary.notes_on_reading += note_on_features(seam_options.features, model);
  summary.before = measure(model, alignment);
  bool is_exact = summary.before.is_exact();
  std::string message = is_exact ? "" : input + ": not exactly seamless";
  const Misfits misfits = count_misfits(model.mesh, model.uv_map, seam_options.tolerance);
  if(misfits.number_of_misfits > 0)
    message += ": " + to_text(misfits);
  if(summary.coinciding_border_edges > 0 && !seam_options.reading.weld && !keeps_open) {
    message += (is_exact ? input + ": " : ", and ") + what_welding_gives(model, seam_options);
    is_exact = false; // what this says of the seams is unknown
  }
  write_check(summary_stream({report}), summary);
  if(!report.empty())
    write_report(report, summary, is_exact, message);
  if(!is_exact)
    throw Failure(NOT_SOLVED, message);
}
