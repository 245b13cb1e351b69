// seamless remesh IN OUT: from a triangle mesh to a quad mesh.

#include "Failure.h"
#include "Options.h"
#include "Summary.h"
#include "commands.h"
#include "files.h"
#include "plain_meshes.h"
#include "quad_picture.h"

#include <CGAL/Seamless_snapping/quad_remesh.h>

#include <cstddef>
#include <iostream>
#include <string>

namespace SS = CGAL::Seamless_snapping;

namespace {

struct Remesh_options
{
  std::string input, output, picture;
  double number = 10000, edge_length = 0, feature_angle = 0, curvature = 0;
  bool coarsest = false, verbose = false;

  // Returns whether there is something to do.
  bool parse(const Arguments& arguments)
  {
    Options options("remesh IN OUT",
                    "Remeshes a triangle mesh with quads only, aligned to borders. IN is a file of\n"
                    "any format that CGAL reads (.off, .obj, .ply, .stl and others); OUT is a .obj\n"
                    "or .off file.\n");
    options.add_file("input", input);
    options.add_file("output", output);
    options.add("quads", "N", number, "about how many quads to make (default: 10000)");
    options.add("edge-length", "L", edge_length, "instead, how long to make their edges");
    options.add("coarsest", coarsest, "instead, make as few quads as are found");
    options.add("feature-angle", "DEGREES", feature_angle, "keep edges that are sharper");
    options.add("curvature", "STRENGTH", curvature, "how strongly to follow the curvature");
    options.add("picture", "FILE", picture, "write a picture of the quads as .svg");
    options.add("verbose", verbose, "tell of each step");
    if(!options.parse(arguments))
      return false;
    if(!(number >= 1))
      throw Failure(USAGE, "the number of quads must be at least 1");
    if(options.is_given("edge-length") && !(edge_length > 0))
      throw Failure(USAGE, "the length of edges must be positive");
    if(suffix_of(output) != "obj" && suffix_of(output) != "off")
      throw Failure(USAGE, "'" + output + "': quads are written to .obj and .off files");
    check_picture(picture);
    check_outputs({input}, {output, picture}, false);
    return true;
  }
};

} // namespace

void remesh(const Arguments& arguments)
{
  Remesh_options options;
  if(!options.parse(arguments))
    return;
  Mesh mesh, quads;
  read_mesh(options.input, mesh);
  Edge_bool_map is_feature = mesh.add_property_map<Edge, bool>("e:feature", false).first;
  if(options.feature_angle > 0)
    mark_features(options.feature_angle, mesh, is_feature);
  const auto parameters =
    SS::parameters::edge_is_constrained_map(is_feature).curvature_alignment(options.curvature)
                   .coarsest(options.coarsest).verbose(options.verbose)
                   .target_number_of_quads(static_cast<std::size_t>(options.number));
  Edge_bool_map is_kept = quads.add_property_map<Edge, bool>("e:feature", false).first;
  const auto output = SS::parameters::edge_is_constrained_map(is_kept);
  const SS::Remeshing_report report =
    options.edge_length > 0
      ? SS::quad_remesh(mesh, quads, parameters.target_edge_length(options.edge_length), output)
      : SS::quad_remesh(mesh, quads, parameters, output);
  if(!report)
    throw Failure(NOT_SOLVED, options.input + ": " + to_string(report.status) + ": " +
                                report.message);
  write_file(options.output, text_of_quads(quads, options.output));
  if(!options.picture.empty())
    write_file(options.picture, quad_picture(quads, is_kept));
  summary_stream({options.output, options.picture})
    << report.number_of_quads << " quads, " << report.number_of_vertices << " vertices, "
    << report.number_of_cones << " cones\n"
    << "scaled Jacobian: least " << report.least_scaled_jacobian << ", mean "
    << report.mean_scaled_jacobian << "\n"
    << "largest distance from the input: " << report.largest_distance << "\n";
  if(report.number_of_released_edges > 0)
    summary_stream({options.output, options.picture}) << report.number_of_released_edges
                                     << " feature edges are not kept, as faces would be flipped\n";
}
