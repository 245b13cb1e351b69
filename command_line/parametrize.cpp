// seamless parametrize IN OUT: from a plain triangle mesh to an exactly seamless parametrization.

#include "Failure.h"
#include "Model.h"
#include "Options.h"
#include "commands.h"
#include "files.h"
#include "picture.h"
#include "plain_meshes.h"

#include <CGAL/Seamless_snapping/approximate_seamless_parameterization.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <filesystem>
#include <iostream>
#include <string>

namespace SS = CGAL::Seamless_snapping;

namespace {

struct Parametrize_options
{
  std::string input, output, approximate, svg;
  double feature_angle = 0; // in degrees; 0: no features
  double curvature = 0;
  bool align_border = false;
  bool overwrite = false;

  // Returns whether there is something to do.
  bool parse(const Arguments& arguments)
  {
    Options options("parametrize IN OUT",
                    "Computes an exactly seamless parametrization of a triangle mesh. IN is a file\n"
                    "of any format that CGAL reads (.off, .obj, .ply, .stl and others); what it\n"
                    "holds besides points and faces is not kept. OUT is a .obj or .ply file, or -\n"
                    "for the standard output, in the OBJ format.\n");
    options.add_file("input", input);
    options.add_file("output", output);
    options.add("feature-angle", "DEGREES", feature_angle, "align edges that are sharper");
    options.add("align-border", align_border, "align border edges");
    options.add("curvature", "STRENGTH", curvature, "how strongly to follow the curvature");
    options.add("approximate", "APPROX", approximate, "write the input of the snapping, too");
    options.add("overwrite", overwrite, "let OUT replace IN");
    options.add("svg", "PICTURE.svg", svg, "draw the domain, and the largest gaps before and after");
    if(!options.parse(arguments))
      return false;
    check_format(output);
    if(!approximate.empty())
      check_format(approximate);
    check_outputs({input}, {output, approximate, svg}, overwrite);
    return true;
  }
};

} // namespace

void parametrize(const Arguments& arguments)
{
  Parametrize_options options;
  if(!options.parse(arguments))
    return;
  std::ostream& os = summary_stream({options.output, options.approximate, options.svg});
  Model model;
  read_mesh(options.input, model.mesh);
  if(options.feature_angle > 0)
    mark_features(options.feature_angle, model.mesh, model.is_feature);

  const auto alignment = SS::parameters::edge_is_constrained_map(model.is_feature)
                                        .align_border(options.align_border);
  const auto made = SS::approximate_seamless_parameterization(
    model.mesh, model.uv_map,
    alignment.curvature_alignment(options.curvature).release_alignment(true));
  if(!made)
    throw Failure(NOT_SOLVED, options.input + ": " + made.message);
  os << made.number_of_faces << " faces, genus " << made.genus << ", "
     << made.number_of_border_loops << " border loops, " << made.cones.size() << " cones, "
     << made.number_of_flipped_faces << " flipped faces, violation "
     << made.violation / made.extent << " of the extent" << std::endl;
  for(const auto& [v, w] : made.released_edges) {
    os << "not aligned, as faces would be flipped: the edge of the vertices " << v.idx() << " and "
       << w.idx() << "\n";
    model.is_feature[model.mesh.edge(model.mesh.halfedge(v, w))] = false;
  }
  if(!options.approximate.empty())
    write_file(options.approximate, text_of_model(model, options.approximate));

  const Uv_map old_uv_map = copy_of_uv_map(model);
  const auto snapped = SS::snap_to_seamless(model.mesh, model.uv_map, alignment);
  if(!snapped)
    throw Failure(NOT_SOLVED, options.input + ": " + snapped.message);
  if(!SS::is_seamless(model.mesh, model.uv_map, alignment))
    throw Failure(NOT_SOLVED, options.input + ": the result is not exact; please report this");
  write_file(options.output, text_of_model(model, options.output));
  if(!options.svg.empty())
    write_file(options.svg, picture(model, old_uv_map, 1e-4,
                                    std::filesystem::path(options.input).filename().string()));
  os << "exactly seamless: largest change " << snapped.largest_change / snapped.extent
     << " of the extent" << std::endl;
}
