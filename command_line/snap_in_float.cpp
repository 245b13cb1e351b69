#include "snap_model.h"

#include <CGAL/Seamless_snapping/snap_to_seamless.h>

namespace SS = CGAL::Seamless_snapping;

using Float_point = CGAL::Simple_cartesian<float>::Point_2;

SS::Snapping_report snap_in_float(Model& model, const Alignment& alignment,
                                  const Seam_options& options)
{
  const auto float_map = model.mesh.add_property_map<Halfedge, Float_point>("h:float_uv").first;
  for(const Halfedge h : model.mesh.halfedges())
    float_map[h] = Float_point(static_cast<float>(model.uv_map[h].x()),
                               static_cast<float>(model.uv_map[h].y()));
  const SS::Snapping_report report =
    SS::snap_to_seamless(model.mesh, float_map, snapping_parameters(alignment, options));
  for(const Halfedge h : model.mesh.halfedges())
    model.uv_map[h] = Kernel::Point_2(float_map[h].x(), float_map[h].y());
  return report;
}
