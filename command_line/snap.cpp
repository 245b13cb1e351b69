// seamless snap IN OUT: makes the parametrization in a file exactly seamless.

#include "Failure.h"
#include "Options.h"
#include "Progress.h"
#include "Summary.h"
#include "commands.h"
#include "files.h"
#include "json_report.h"
#include "measures.h"
#include "pictures/picture.h"
#include "snap_model.h"
#include "words.h"

#include <CGAL/Real_timer.h>

#include <filesystem>
#include <iostream>
#include <limits>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace SS = CGAL::Seamless_snapping;

namespace {

struct Snap_options
{
  Seam_options seams;
  std::string input, output, report, picture;
  bool overwrite = false;

  // Returns whether there is something to do.
  bool parse(const Arguments& arguments)
  {
    Options options("snap IN OUT",
                    "Makes the texture coordinates of a triangle mesh exactly seamless: across each\n"
                    "edge, the coordinates of both sides differ by a rotation by a multiple of 90\n"
                    "degrees and a translation. It moves them by about the size of their errors.\n"
                    "\n"
                    "Files are .obj files, .ply files with a list 'texcoord' for each face, or - for\n"
                    "the standard streams. A .ply file with s and t, or u and v, for each vertex is\n"
                    "read, too. If OUT has the format of IN, all else in the file stays as it is;\n"
                    "otherwise materials, normals, colors and the like are lost. For tetrahedral\n"
                    "meshes, see 'seamless snap IN.hexex --help'.\n");
    options.add_file("input", input);
    options.add_file("output", output);
    seams.add_to(options);
    seams.add_repair_to(options);
    options.add("float", seams.reading.in_float,
                "make the coordinates exact as 32-bit floats, for programs that read floats");
    options.add("overwrite", overwrite, "let OUT replace IN");
    options.add("report", "R.json", report, "write all measurements to a file, as JSON");
    options.add("picture", "FILE", picture,
                "draw the domain, and the largest gaps before and after, as .svg");
    options.add_alias("svg", "picture");
    if(!options.parse(arguments))
      return false;
    seams.check(options);
    seams.check_repair(options);
    check_format(input);
    check_format(output);
    check_picture(picture);
    check_outputs({input}, {output, report, picture},
                  overwrite ? Overwriting::ASKED_FOR : Overwriting::NOT_ASKED_FOR);
    return true;
  }
};

// Throws `Failure` unless the result is exact. The summary tells what was done till then.
void snap(const Snap_options& options, Model& model, const Alignment& alignment, Summary& summary)
{
  CGAL::Real_timer timer;
  timer.start();
  const Progress progress("snapping " + counted(model.mesh.number_of_faces(), "face"),
                          options.seams.reading.verbose);
  summary.report = model.is_float ? snap_in_float(model, alignment, options.seams)
                                  : snap_in_double(model, alignment, options.seams);
  summary.has_report = true;
  summary.snapping_time = timer.time();
  check_snapped(summary.report, model, options.seams.tolerance);
  summary.after = measure(model, alignment);
  if(!summary.after.is_exact())
    throw Failure(NOT_SOLVED, options.input + ": the result is not exact; please report this");
}

void write_results(const Snap_options& options, const Model& model, const Uv_map& old_uv_map,
                   Summary& summary)
{
  CGAL::Real_timer timer;
  timer.start();
  write_file(options.output, text_of_model(model, options.output));
  summary.writing_time = timer.time();
  if(!options.picture.empty())
    write_file(options.picture,
               picture(model, old_uv_map, options.seams.tolerance,
                       std::filesystem::path(options.input).filename().string()));
  std::ostream& os = summary_stream({options.output, options.report, options.picture});
  if(changes_format(model, options.output))
    os << "note: only the mesh of " << options.input << ", its coordinates, and its features are in "
       << options.output
       << (suffix_of(options.output) == suffix_of(options.input)
             ? ", which has coordinates at corners in place of vertices\n"
             : ", which is of another format\n");
  write_snap(os, summary);
  if(summary.report.status == SS::Outcome::SNAPPED && !summary.report.message.empty())
    os << "note: " << in_words_of_user(summary.report.message, model) << std::endl;
}

// Large blocks that were freed are used again. Else the system takes them back, and clears pages for
// the next ones, which for large files takes as long as snapping does.
void keep_freed_memory()
{
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, (std::numeric_limits<int>::max)());
#endif
}

} // namespace

void snap(const Arguments& arguments)
{
  keep_freed_memory();
  if(is_volume(arguments))
    return snap_volume(arguments);
  Snap_options options;
  if(!options.parse(arguments))
    return;
  CGAL::Real_timer timer;
  timer.start();
  Model model;
  read_or_tell(options.report, "exact",
               [&] { read_model(options.input, options.seams.reading, model); });
  const Alignment alignment(model, options.seams);
  Summary summary(model, alignment);
  summary.notes_on_reading += note_on_features(options.seams.features, model);
  summary.reading_time = timer.time();
  summary.before = measure(model, alignment);
  const Uv_map old_uv_map = options.picture.empty() ? model.uv_map : copy_of_uv_map(model);
  const auto work = [&] {
    snap(options, model, alignment, summary);
    write_results(options, model, old_uv_map, summary);
    if(summary.report.status == SS::Outcome::FLIPS_REMAIN)
      throw Failure(STILL_FLIPPED,
                    options.input + ": " + in_words_of_user(summary.report, model));
  };
  run_and_tell(work, [&](const Exit status, const std::string& message) {
    if(!options.report.empty())
      write_report(options.report, summary, is_written(status), message);
  });
}
