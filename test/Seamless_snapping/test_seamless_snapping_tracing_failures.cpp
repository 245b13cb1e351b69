// What goes wrong with isocurves where seams are inexact: each failure of Sec. 6.2 of the paper, on
// maps with noise and on maps as a solver computed them; none is left after snapping.

#include "test_meshes.h"
#include "tracing_checks.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#ifndef SEAMLESS_SNAPPING_PACKAGE_DATA_DIR
#define SEAMLESS_SNAPPING_PACKAGE_DATA_DIR ""
#endif

using namespace tracing_checks;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Tracer = SS::Isocurve_tracer<Mesh>;

// One fixed case of each: a mesh, which noise, and what a naive tracer reports there; no failure
// is left once the noise has been snapped away.
void test_failures()
{
  const std::vector<std::pair<std::string, std::vector<Status> > > cases = {
    {"divided cube", {Status::STUCK_AT_CUT, Status::FELL_INTO_GAP, Status::MISSED_TARGET}},
    {"closed cut around a disc, rotation", {Status::NO_WAY_OUT, Status::SEVERAL_WAYS_OUT}},
    {"disc with aligned border", {Status::FELL_OFF_BORDER}},
    {"torus", {Status::SPIRALS}}};
  std::map<std::string, std::size_t> index;
  auto all = test_meshes::all_meshes<Kernel>();
  for(std::size_t i = 0; i < all.size(); ++i)
    index[all[i].name] = i;
  for(const auto& [name, expected] : cases) {
    auto& named = all[index.at(name)];
    Mesh& mesh = named.mesh;
    const UV_map uv = test_meshes::uv_map(mesh);
    CHECK(naive_ends(mesh, uv, 1e-6).rbegin()->first < Status::STUCK_AT_CUT);
    if(expected.front() == Status::NO_WAY_OUT)
      perturb_other_charts(mesh, uv, 1e-9, 1);
    else
      uv_noise::perturb(mesh, uv, 1e-9, 1);
    Counts ends = naive_ends(mesh, uv, 1e-6);
    std::cout << name << " with noise, in floating point: " << ends << std::endl;
    for(const Status status : expected)
      CHECK(ends[status] > 0);

    CHECK(SS::snap_to_seamless(mesh, uv, parameters::align_border(named.align_border)));
    const Tracer tracer(mesh, uv);
    std::size_t bad = 0;
    for(const auto v : mesh.vertices())
      for(const auto& [start, direction] : tracer.outgoing(v))
        bad += is_good(tracer, tracer.trace(start, direction), mesh, uv) ? 0 : 1;
    CHECK_EQUAL(bad, std::size_t(0));
  }
}

// The maps as the producer computed them, whose seams are off by 1e-16 of the extent, without any
// noise: curves from all vertices fail in every way.
void test_failures_of_computed_maps()
{
  Counts naive;
  for(const auto& file : files_in(SEAMLESS_SNAPPING_PACKAGE_DATA_DIR)) {
    Mesh mesh;
    UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
    CHECK(SS::IO::read_OBJ(file.string(), mesh, uv));
    const Tracer tracer(mesh, uv);
    for(const auto v : mesh.vertices())
      for(const auto& [start, direction] : tracer.outgoing(v))
        ++naive[tracer.trace(start, direction,
                             parameters::maximum_number(300).decide_exactly(false)).status];
  }
  std::cout << "computed maps, in floating point: " << naive << std::endl;
  for(int i = int(Status::STUCK_AT_CUT); i < SS::number_of_isocurve_statuses; ++i)
    if(!CHECK(naive[Status(i)] > 0))
      std::cerr << "  no curve " << Status(i) << std::endl;
}

int main()
{
  test_failures();
  test_failures_of_computed_maps();
  return report_checks();
}
