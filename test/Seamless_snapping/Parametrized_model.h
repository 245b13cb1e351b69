// A parametrized mesh from an OBJ file, and those of its feature and border edges that lie on
// isocurves up to noise: files mark others too.

#ifndef SEAMLESS_SNAPPING_TEST_PARAMETRIZED_MODEL_H
#define SEAMLESS_SNAPPING_TEST_PARAMETRIZED_MODEL_H

#include <CGAL/Seamless_snapping/IO/OBJ.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

struct Parametrized_model
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
  using Aligned_map = Mesh::Property_map<Mesh::Edge_index, bool>;

  Mesh mesh;
  UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  Aligned_map is_aligned = mesh.add_property_map<Mesh::Edge_index, bool>("e:aligned", false).first;
  CGAL::Seamless_snapping::IO::File_status status;

  explicit Parametrized_model(const std::string& filename)
    : status(CGAL::Seamless_snapping::IO::read_OBJ(
        filename, mesh, uv,
        CGAL::Seamless_snapping::parameters::edge_is_constrained_map(is_aligned)))
  {
    const double tolerance = 1e-6 * extent();
    for(const Mesh::Edge_index e : mesh.edges()) {
      Mesh::Halfedge_index h = mesh.halfedge(e);
      h = mesh.is_border(h) ? mesh.opposite(h) : h;
      const Kernel::Vector_2 d = uv[h] - uv[mesh.prev(h)];
      is_aligned[e] = (is_aligned[e] || mesh.is_border(e))
                      && (std::min)(std::abs(d.x()), std::abs(d.y())) <= tolerance;
    }
  }

  std::vector<Kernel::Point_2> values() const { return { uv.begin(), uv.end() }; }

private:
  double extent() const
  {
    CGAL::Bbox_2 box;
    for(const Mesh::Halfedge_index h : mesh.halfedges())
      if(!mesh.is_border(h))
        box += uv[h].bbox();
    return (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  }
};

#endif // SEAMLESS_SNAPPING_TEST_PARAMETRIZED_MODEL_H
