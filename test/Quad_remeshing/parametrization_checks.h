// What each result of approximate_seamless_parametrization() has to be: topology and index theorem
// in integers, transitions measured in rational arithmetic, exact after snap_to_seamless(), and
// untouched coordinates after a refusal.

#ifndef SEAMLESS_SNAPPING_TEST_PARAMETRIZATION_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_PARAMETRIZATION_CHECKS_H

#include "checking.h"
#include "exact_seamless_check.h"

#include <CGAL/Quad_remeshing/approximate_seamless_parametrization.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace QR = CGAL::Quad_remeshing;
namespace parameters = CGAL::Quad_remeshing::parameters;
using QR::Outcome;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Uv_map = Mesh::Property_map<Halfedge, Point_2>;
using Report = QR::Parametrization_report<Vertex>;

inline Uv_map new_uv_map(Mesh& mesh)
{
  return mesh.add_property_map<Halfedge, Point_2>("h:new_uv", Point_2(-7, 7)).first;
}

inline bool is_untouched(const Mesh& mesh, const Uv_map& uv)
{
  for(const Halfedge h : mesh.halfedges())
    if(uv[h] != Point_2(-7, 7))
      return false;
  return true;
}

// Isolated vertices don't count.
inline std::ptrdiff_t euler_characteristic_of_faces(const Mesh& mesh)
{
  std::ptrdiff_t chi = std::ptrdiff_t(mesh.number_of_faces());
  for(const Vertex v : mesh.vertices())
    chi += mesh.is_isolated(v) ? 0 : 1;
  return chi - std::ptrdiff_t(mesh.number_of_edges());
}

inline void check_topology(const Mesh& mesh, const Report& report)
{
  CHECK_EQUAL(report.number_of_faces, std::size_t(mesh.number_of_faces()));
  CHECK_EQUAL(report.euler_characteristic, euler_characteristic_of_faces(mesh));
  CHECK_EQUAL(report.euler_characteristic,
              2 * std::ptrdiff_t(report.number_of_components) - 2 * report.genus
              - std::ptrdiff_t(report.number_of_border_loops));
  std::ptrdiff_t sum = report.border_turning;
  for(const auto& cone : report.cones) {
    CHECK(cone.second != 0);
    CHECK(!mesh.is_border(cone.first));
    sum += cone.second;
  }
  CHECK_EQUAL(sum, 4 * euler_characteristic_of_faces(mesh));
}

// The turns that the transitions make around a vertex agree with the index that was reported.
inline void check_cones(const Mesh& mesh, const Uv_map& uv, const Report& report)
{
  const QR::Seam_transitions<Mesh> transitions = QR::seam_transitions(mesh, uv);
  if(!CHECK(bool(transitions))) {
    std::cerr << "    " << transitions.message() << std::endl;
    return;
  }
  std::map<Vertex, int> index(report.cones.begin(), report.cones.end());
  for(const Vertex v : mesh.vertices()) {
    if(mesh.is_border(v) || mesh.is_isolated(v))
      continue;
    // Counterclockwise: from a face across the halfedge that points to v.
    int turns = 0;
    for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
      turns += transitions.rotation(h);
    CHECK_EQUAL(((turns - index[v]) % 4 + 4) % 4, 0);
  }
}

template <typename IsAligned, typename NamedParameters>
void check_result(Mesh& mesh, Uv_map uv, const Report& report, const IsAligned& is_aligned,
                  const NamedParameters& alignment)
{
  if(!CHECK_EQUAL(int(report.status), int(Outcome::SUCCESS))) {
    std::cerr << "    " << report << std::endl;
    return;
  }
  check_topology(mesh, report);
  check_cones(mesh, uv, report);

  const exact_check::Result before = exact_check::check(mesh, uv, is_aligned);
  CHECK(report.extent > 0);
  CHECK(before.largest_violation <= 1e-12 * report.extent);
  CHECK(before.edges_off_identity <= report.number_of_cut_edges);
  CHECK_EQUAL(before.aligned_edges, report.number_of_aligned_edges);
  CHECK_EQUAL(before.degenerate_faces + before.flipped_faces, report.number_of_flipped_faces);

  const QR::Snapping_report snapped = QR::snap_to_seamless(mesh, uv, alignment);
  if(!CHECK(bool(snapped)))
    std::cerr << "    " << snapped << std::endl;
  const exact_check::Result after = exact_check::check(mesh, uv, is_aligned);
  CHECK_EQUAL(after.inexact_edges, std::size_t(0));
  CHECK_EQUAL(after.inexact_aligned_edges, std::size_t(0));
  CHECK(QR::is_seamless(mesh, uv, alignment));
}

// What is told of the transitions.
struct Transitions
{
  explicit Transitions(Mesh& mesh)
    : is_cut(mesh.add_property_map<Mesh::Edge_index, bool>("e:told_cut", true).first),
      rotation(mesh.add_property_map<Halfedge, int>("h:told_rotation", 7).first)
  { }

  template <typename NamedParameters>
  auto with(const NamedParameters& np) const
  { return np.edge_is_cut_map(is_cut).halfedge_rotation_map(rotation); }

  Mesh::Property_map<Mesh::Edge_index, bool> is_cut;
  Mesh::Property_map<Halfedge, int> rotation;
};

// What is told of the transitions is what the coordinates do.
inline void check_transitions(const Mesh& mesh, const Uv_map& uv, const Transitions& told,
                              const Report& report)
{
  if(!report)
    return;
  std::size_t number_of_cuts = 0;
  double violation = 0;
  for(const auto e : mesh.edges()) {
    number_of_cuts += told.is_cut[e] ? 1 : 0;
    const Halfedge h = mesh.halfedge(e), g = mesh.opposite(h);
    if(mesh.is_border(e)) {
      CHECK(!told.is_cut[e]);
      continue;
    }
    CHECK_EQUAL((told.rotation[h] + told.rotation[g]) % 4, 0);
    double x = uv[h].x() - uv[mesh.prev(h)].x(), y = uv[h].y() - uv[mesh.prev(h)].y();
    for(int i = 0; i < told.rotation[h]; ++i) {
      std::swap(x, y);
      x = -x;
    }
    violation = (std::max)({violation, std::abs(x + (uv[g].x() - uv[mesh.prev(g)].x())),
                            std::abs(y + (uv[g].y() - uv[mesh.prev(g)].y()))});
    if(!told.is_cut[e]) {
      CHECK_EQUAL(told.rotation[h], 0);
      CHECK(uv[h] == uv[mesh.prev(g)] && uv[g] == uv[mesh.prev(h)]);
    }
  }
  CHECK_EQUAL(number_of_cuts, report.number_of_cut_edges);
  CHECK_EQUAL(violation, report.violation);
}

inline void check_parametrization(const std::string& name, Mesh mesh, const bool may_flip = false)
{
  std::cout << name << std::endl;
  const Uv_map uv = new_uv_map(mesh);
  const Transitions told(mesh);
  const auto np = told.with(parameters::default_values());
  const Report report = QR::approximate_seamless_parametrization(mesh, uv, np);
  CHECK(may_flip || report.number_of_flipped_faces == 0);
  check_transitions(mesh, uv, told, report);
  check_result(mesh, uv, report, exact_check::No_edge_aligned(), np);
}

template <typename EdgeIsConstrainedMap>
void check_alignment(const std::string& name, Mesh mesh, const EdgeIsConstrainedMap is_feature,
                     const bool align_border)
{
  std::cout << name << ", aligned" << std::endl;
  const Uv_map uv = new_uv_map(mesh);
  const Transitions told(mesh);
  const auto alignment =
    told.with(parameters::edge_is_constrained_map(is_feature).align_border(align_border));
  const auto is_aligned = [&](const Mesh::Edge_index e)
  {
    return get(is_feature, e) || (align_border && mesh.is_border(e));
  };
  const Report report = QR::approximate_seamless_parametrization(mesh, uv, alignment);
  check_transitions(mesh, uv, told, report);
  check_result(mesh, uv, report, is_aligned, alignment);
}

inline void check_snappable(const std::string& name, const Report& report, Mesh& mesh, Uv_map uv)
{
  if(!CHECK(bool(report)))
    std::cerr << "    " << name << ": " << report << std::endl;
  const QR::Snapping_report snapped = QR::snap_to_seamless(mesh, uv);
  if(!CHECK(bool(snapped)))
    std::cerr << "    " << name << ": " << snapped << std::endl;
  CHECK(QR::is_seamless(mesh, uv));
}

inline void check_given_cones(const std::string& name, Mesh mesh,
                              const std::vector<std::pair<int, int> >& cones)
{
  std::cout << name << std::endl;
  const Uv_map uv = new_uv_map(mesh);
  auto index = mesh.add_property_map<Vertex, int>("v:index", 0).first;
  for(const auto& cone : cones)
    index[Vertex(Mesh::size_type(cone.first))] = cone.second;
  const Report report = QR::approximate_seamless_parametrization(
    mesh, uv, parameters::cone_index_map(index));
  check_result(mesh, uv, report, exact_check::No_edge_aligned(), parameters::default_values());
  CHECK_EQUAL(report.cones.size(), cones.size());
  for(const auto& cone : report.cones)
    CHECK_EQUAL(cone.second, index[cone.first]);
}

template <typename NamedParameters>
void check_refused(const std::string& name, Mesh mesh, const Outcome expected,
                   const NamedParameters& np, const std::string& part_of_message = "")
{
  const Uv_map uv = new_uv_map(mesh);
  const Report report = QR::approximate_seamless_parametrization(mesh, uv, np);
  if(!CHECK_EQUAL(std::string(to_string(report.status)), std::string(to_string(expected)))
     || !CHECK(report.message.find(part_of_message) != std::string::npos))
    std::cerr << "    " << name << ": " << report << std::endl;
  CHECK(!report);
  CHECK(!report.message.empty());
  CHECK(is_untouched(mesh, uv));
}

#endif // SEAMLESS_SNAPPING_TEST_PARAMETRIZATION_CHECKS_H
