// Separatrices traced by several threads, where TBB is linked, are those of one, in the same order.

#include "test_meshes.h"
#include "tracing_checks.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <iostream>
#include <iterator>
#include <vector>

#ifndef SEAMLESS_SNAPPING_PACKAGE_DATA_DIR
#define SEAMLESS_SNAPPING_PACKAGE_DATA_DIR ""
#endif

using namespace tracing_checks;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;

bool are_same(const SS::Isocurve<Mesh>& a, const SS::Isocurve<Mesh>& b)
{
  if(a.status != b.status || a.number_of_crossings != b.number_of_crossings ||
     a.points.size() != b.points.size())
    return false;
  for(std::size_t i = 0; i < a.points.size(); ++i)
    if(a.points[i].halfedge() != b.points[i].halfedge() ||
       a.points[i].place() != b.points[i].place() ||
       a.points[i].direction() != b.points[i].direction() ||
       !(a.points[i].level() == b.points[i].level()))
      return false;
  return true;
}

std::size_t test_threads(const Mesh& mesh, const UV_map& uv)
{
  const auto np = parameters::maximum_number(2000);
  std::vector<SS::Isocurve<Mesh> > one, many;
  SS::trace_all_separatrices(mesh, uv, std::back_inserter(one), np);
  SS::trace_all_separatrices<CGAL::Parallel_if_available_tag>(mesh, uv, std::back_inserter(many),
                                                              np);
  if(!CHECK_EQUAL(one.size(), many.size()))
    return 0;
  std::size_t different = 0;
  for(std::size_t i = 0; i < one.size(); ++i)
    different += are_same(one[i], many[i]) ? 0 : 1;
  CHECK_EQUAL(different, std::size_t(0));
  return one.size();
}

int main()
{
#ifdef CGAL_LINKED_WITH_TBB
  std::cout << "with TBB" << std::endl;
#else
  std::cout << "without TBB" << std::endl;
#endif
  std::size_t number = 0;
  for(auto& named : test_meshes::all_meshes<Kernel>())
    number += test_threads(named.mesh, test_meshes::uv_map(named.mesh));
  for(const auto& file : files_in(SEAMLESS_SNAPPING_PACKAGE_DATA_DIR)) {
    Mesh mesh;
    UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
    if(CHECK(SS::IO::read_OBJ(file.string(), mesh, uv)) && CHECK(SS::snap_to_seamless(mesh, uv)))
      number += test_threads(mesh, uv);
  }
  std::cout << number << " curves" << std::endl;
  CHECK(number > 0);
  return report_checks();
}
