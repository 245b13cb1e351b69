// seamless check IN: tells whether the parametrization in a file is exactly seamless.

#include "Failure.h"
#include "Options.h"
#include "Summary.h"
#include "commands.h"
#include "files.h"
#include "measures.h"

#include <iostream>
#include <string>

void check(const Arguments& arguments)
{
  Options options("check IN",
                  "Tells whether the texture coordinates of a triangle mesh are exactly seamless:\n"
                  "whether, across each edge, the coordinates on both sides differ by a rotation by\n"
                  "a multiple of 90 degrees and a translation. IN is a .obj file, a .ply file with a\n"
                  "list 'texcoord' for each face, or - for the standard input.\n");
  std::string input, report;
  Seam_options seam_options;
  options.add_file("input", input);
  seam_options.add_to(options);
  options.add("float", seam_options.reading.in_float,
              "look at the coordinates as programs see them that read 32-bit floats");
  options.add("report", "R.json", report, "write all figures to a file");
  if(!options.parse(arguments))
    return;
  seam_options.check(options);
  check_outputs({input}, {report}, false);

  Model model;
  read_model(input, seam_options.reading, model);
  const Alignment alignment(model, seam_options);
  Summary summary(model, alignment);
  summary.before = measure(model, alignment);
  const bool is_exact = summary.before.is_exact();
  std::string message = is_exact ? "" : input + ": not exactly seamless";
  const Misfits misfits = count_misfits(model, seam_options.tolerance);
  if(misfits.number_of_misfits > 0)
    message += ": " + to_text(misfits);
  write_check(summary_stream({report}), summary);
  if(!report.empty())
    write_file(report, to_json(summary, is_exact, message));
  if(!is_exact)
    throw Failure(NOT_SOLVED, message);
}
