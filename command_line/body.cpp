// seamless body OUT: writes a surface of a given genus, to try the parametrization on.

#include "Failure.h"
#include "Options.h"
#include "Progress.h"
#include "commands.h"
#include "files.h"
#include "handle_body.h"
#include "words.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/boost/graph/IO/OBJ.h>

#include <cmath>
#include <sstream>
#include <string>

void make_body(const Arguments& arguments)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

  Handle_body_options body;
  std::string output;
  Options options("body OUT",
                  "Writes a surface of a given genus to try things on: a flat box with a row of\n"
                  "holes, rounded or not. OUT is a .off or .obj file, or - for the standard output,\n"
                  "as OFF.\n");
  options.add_file("output", output);
  options.add("genus", "G", body.genus, {0, 1000}, "the number of holes (default: 2)");
  options.add("sharp", body.is_sharp, "keep the sharp edges of the box");
  options.add("borders", "N", body.number_of_borders, {0, 2},
              "the number of ends of the body that are cut off, so that they are open (default: 0)");
  options.add("edge-length", "L", body.edge_length, {0.001, 1000},
              "the length of edges of the triangles (default: 0.25)");
  if(!options.parse(arguments))
    return;
  const std::string suffix = is_special_file(output) ? "off" : suffix_of(output);
  if(suffix != "off" && suffix != "obj")
    throw Failure(USAGE, "'" + output + "': surfaces are written to .off and .obj files");
  check_outputs({}, {output});
  const double number = expected_number_of_faces(body);
  check_number_of_faces("edge-length", number, "triangles",
                        by_edge_length(number * body.edge_length * body.edge_length));

  const Progress progress("making about " + std::to_string(std::llround(number)) + " triangles");
  Mesh mesh;
  make_handle_body(body, mesh);
  std::ostringstream os;
  os.precision(17);
  const bool good = suffix == "off" ? CGAL::IO::write_OFF(os, mesh) : CGAL::IO::write_OBJ(os, mesh);
  if(!good)
    throw Failure(UNWRITABLE, "cannot write '" + output + "'");
  write_file(output, os.str());
  summary_stream({output}) << output << ": " << counted(mesh.number_of_faces(), "face") << std::endl;
}
