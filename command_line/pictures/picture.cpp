#include "picture.h"

#include "svg_picture.h"

#include <CGAL/Seamless_snapping/seam_transitions.h>

#include <sstream>
#include <string>

namespace SS = CGAL::Seamless_snapping;

std::string picture(const Model& model, const Uv_map& old_uv_map, const double tolerance,
                    const std::string& title)
{
  const SS::Seam_transitions<Mesh> transitions =
    SS::seam_transitions(model.mesh, old_uv_map, SS::parameters::tolerance(tolerance));
  std::ostringstream os;
  Svg_picture<Mesh, Uv_map, Uv_map>(model.mesh, old_uv_map, model.uv_map, transitions)
    .write(os, title);
  return os.str();
}
