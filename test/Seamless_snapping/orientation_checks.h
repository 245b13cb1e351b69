// What the tests of the orientation of faces share: signs in rational arithmetic, before and after,
// against what the report says; and what is known of the small test meshes.

#ifndef SEAMLESS_SNAPPING_TEST_ORIENTATION_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_ORIENTATION_CHECKS_H

#include "surface_checks.h"

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace orientation_checks {

using namespace surface_checks;

// Of all faces, in order.
template <typename Graph, typename UVMap>
std::vector<int> signs(const Graph& g, const UVMap& uv)
{
  std::vector<int> result;
  for(const auto f : faces(g))
    result.push_back(exact_check::face_orientation(f, g, uv));
  return result;
}

// The faces that had one kind of sign and are not positive now.
inline std::vector<std::size_t> not_positive(const std::vector<int>& before,
                                             const std::vector<int>& after, bool were_positive)
{
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < before.size(); ++i)
    if((before[i] > 0) == were_positive && after[i] <= 0)
      result.push_back(i);
  return result;
}

inline bool are_all_positive(const std::vector<int>& signs)
{
  return std::all_of(signs.begin(), signs.end(), [](int sign) { return sign > 0; });
}

// Totals over all runs.
struct Tally
{
  std::size_t runs = 0, lost = 0, moves = 0, program = 0, remaining = 0;
  std::size_t flips = 0, repaired_flips = 0, iterations = 0;
  double largest_growth = 0, rms_growth = 0; // of the changes, by repairs

  void add(const SS::Snapping_report& report)
  {
    ++runs;
    lost += report.run.number_of_lost_faces;
    moves += report.run.number_of_faces_repaired_by_moves;
    program += report.run.number_of_faces_repaired_by_program;
    remaining += report.lost_faces.size();
    repaired_flips += report.run.number_of_repaired_flips;
    iterations = (std::max)(iterations, report.run.number_of_untangling_iterations);
    flips += report.run.number_of_repaired_flips + report.remaining_flips.size();
    if(report.run.number_of_lost_faces > 0) {
      largest_growth =
        (std::max)(largest_growth, report.largest_change / report.run.largest_change_before_repair);
      rms_growth = (std::max)(rms_growth, report.rms_change / report.optimal_rms_change);
    }
  }

  void print(const std::string& name) const
  {
    std::cout << name << ": " << runs << " runs, " << lost << " faces lost, repaired by moves "
              << moves << ", by programs " << program << ", remaining " << remaining << "; flips "
              << flips << ", repaired " << repaired_flips << " in " << iterations
              << " iterations at most; largest change times "
              << largest_growth << ", rms change times " << rms_growth << std::endl;
  }
};

// Snaps, and checks that the result is exact and that the report tells the truth about
// orientations.
// \param repair false, true, or the number of a `Flip_repair`
template <typename Graph, typename UVMap, typename NP, typename IsAligned>
SS::Snapping_report snap(const Graph& g, UVMap uv, const NP& np, const IsAligned& is_aligned,
                         const std::string& context,
                         const int repair = 0)
{
  const std::vector<int> before = signs(g, uv);
  const Bits bits_before = all_bits(g, uv);
  const SS::Snapping_report report =
    SS::snap_to_seamless(g, uv, np.repair_flips(SS::Flip_repair(repair)));
  const std::vector<int> after = signs(g, uv);
  CHECK_IN(context + ": " + report.message, bool(report));
  CHECK_IN(context, exact_check::check_edges(g, uv, is_aligned).is_exact());
  CHECK_IN(context, SS::is_seamless(g, uv, np));
  CHECK_IN(context, report.lost_faces == not_positive(before, after, true));
  CHECK_IN(context,
           report.run.number_of_lost_faces ==
             report.run.number_of_faces_repaired_by_moves +
               report.run.number_of_faces_repaired_by_program +
               report.run.number_of_faces_repaired_by_untangling + report.lost_faces.size());
  if(repair != 0) {
    CHECK_IN(context, report.remaining_flips == not_positive(before, after, false));
  } else {
    CHECK_IN(context, report.remaining_flips.empty() && report.run.number_of_repaired_flips == 0);
  }
  const bool is_told = report.message.find("(face ") != std::string::npos ||
                       report.message.find("(the first is face ") != std::string::npos;
  CHECK_IN(context, is_told == !(report.lost_faces.empty() && report.remaining_flips.empty()));
  CHECK_IN(context, (report.status == SS::Outcome::FLIPS_REMAIN) ==
                      (repair != 0 && is_told));
  const double change = largest_difference(bits_before, all_bits(g, uv));
  CHECK_IN(context, std::abs(report.largest_change - change) <= 1e-12 * change);
  return report;
}

// --- small test meshes ---------------------------------------------------------------------------

template <typename K>
using Mesh_of = CGAL::Surface_mesh<typename K::Point_3>;
template <typename K>
using UV_map_of = typename Mesh_of<K>::template Property_map<typename Mesh_of<K>::Halfedge_index,
                                                             typename K::Point_2>;

using Mesh = Mesh_of<Kernel>;
using UV_map = UV_map_of<Kernel>;
using Named = test_meshes::Named_mesh<Kernel>;

// Of all halfedges, in order.
inline std::vector<Kernel::Point_2> points(const Mesh& mesh, const UV_map& uv)
{
  std::vector<Kernel::Point_2> result;
  for(const auto h : mesh.halfedges())
    result.push_back(uv[h]);
  return result;
}

// Vertices on aligned edges.
template <typename K>
std::vector<bool> are_aligned(test_meshes::Named_mesh<K>& named)
{
  const auto& mesh = named.mesh;
  const auto features = test_meshes::feature_map(named.mesh);
  std::vector<bool> result(mesh.number_of_vertices(), false);
  for(const auto e : mesh.edges())
    if(features[e] || (named.align_border && mesh.is_border(e)))
      for(const unsigned int end : {0u, 1u})
        result[std::size_t(mesh.vertex(e, end))] = true;
  return result;
}

inline bool has_aligned(Named& named)
{
  const std::vector<bool> aligned = are_aligned(named);
  return std::find(aligned.begin(), aligned.end(), true) != aligned.end();
}

// Cuts and rotations, which short edges don't tell any more once there is noise.
template <typename K>
struct Known
{
  using M = Mesh_of<K>;
  typename M::template Property_map<typename M::Edge_index, bool> edge_is_cut;
  typename M::template Property_map<typename M::Halfedge_index, int> rotations;

  Known(M& mesh, const UV_map_of<K>& uv)
    : edge_is_cut(
          mesh.template add_property_map<typename M::Edge_index, bool>("e:cut", false).first)
    , rotations(
          mesh.template add_property_map<typename M::Halfedge_index, int>("h:rotation", 0).first)
  {
    const Truth<M, UV_map_of<K> > truth(mesh, uv);
    for(const auto h : mesh.halfedges()) {
      edge_is_cut[mesh.edge(h)] = truth.is_cut(h);
      rotations[h] = truth.rotation(h);
    }
  }
};

// Maps whose transitions are translations and half turns stay seamless if one coordinate is scaled:
// then all faces are slivers, those at cones too, which no vertex can repair by itself.
inline bool squash(Named& named, double height)
{
  const auto uv = test_meshes::uv_map(named.mesh);
  const uv_noise::Cuts<Mesh, UV_map> cuts(named.mesh, uv);
  for(const auto h : named.mesh.halfedges())
    if(cuts.rotation(h) % 2 != 0)
      return false;
  for(const auto h : named.mesh.halfedges())
    uv[h] = Kernel::Point_2(uv[h].x(), height * uv[h].y());
  return true;
}

} // namespace orientation_checks

#endif // SEAMLESS_SNAPPING_TEST_ORIENTATION_CHECKS_H
