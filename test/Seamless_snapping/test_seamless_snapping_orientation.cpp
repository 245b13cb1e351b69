// Tests of the orientation of faces: none that is positive may lose it by snapping where an exact
// solution near by keeps it. Signs are those of rational arithmetic, before and after.

#include "slivers.h"
#include "surface_checks.h"

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

using namespace surface_checks;

using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Named = test_meshes::Named_mesh<Kernel>;

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
std::vector<std::size_t> not_positive(const std::vector<int>& before, const std::vector<int>& after,
                                      bool were_positive)
{
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < before.size(); ++i)
    if((before[i] > 0) == were_positive && after[i] <= 0)
      result.push_back(i);
  return result;
}

// Totals over all runs.
struct Tally
{
  std::size_t runs = 0, lost = 0, moves = 0, remaining = 0, flips = 0, repaired_flips = 0;

  void add(const SS::Snapping_report& report)
  {
    ++runs;
    lost += report.number_of_lost_faces;
    moves += report.number_of_faces_repaired_by_moves;
    remaining += report.lost_faces.size();
    repaired_flips += report.number_of_repaired_flips;
    flips += report.number_of_repaired_flips + report.remaining_flips.size();
  }

  void print(const std::string& name) const
  {
    std::cout << name << ": " << runs << " runs, " << lost << " faces lost, repaired by moves "
              << moves << ", remaining " << remaining << "; flips " << flips << ", repaired "
              << repaired_flips << std::endl;
  }
};

// Snaps, and checks what the report says of orientations against exact signs.
template <typename Graph, typename UVMap, typename NP, typename IsAligned>
SS::Snapping_report snap(const Graph& g, UVMap uv, const NP& np, const IsAligned& is_aligned,
                         const std::string& context, bool repair_flips)
{
  const std::vector<int> before = signs(g, uv);
  const Bits bits_before = all_bits(g, uv);
  const SS::Snapping_report report = SS::snap_to_seamless(g, uv, np.repair_flips(repair_flips));
  const std::vector<int> after = signs(g, uv);
  CHECK_IN(context + ": " + report.message, bool(report));
  CHECK_IN(context, exact_check::check_edges(g, uv, is_aligned).is_exact());
  CHECK_IN(context, SS::is_seamless(g, uv, np));
  CHECK_IN(context, report.lost_faces == not_positive(before, after, true));
  CHECK_IN(context, report.number_of_lost_faces
                      == report.number_of_faces_repaired_by_moves + report.lost_faces.size());
  if(repair_flips) {
    CHECK_IN(context, report.remaining_flips == not_positive(before, after, false));
  } else {
    CHECK_IN(context, report.remaining_flips.empty() && report.number_of_repaired_flips == 0);
  }
  const double change = largest_difference(bits_before, all_bits(g, uv));
  CHECK_IN(context, std::abs(report.largest_change - change) <= 1e-12 * change);
  return report;
}

// --- slivers at random ---------------------------------------------------------------------------

bool has_free_vertices(const Mesh& mesh, const uv_noise::Cuts<Mesh, UV_map>& cuts)
{
  for(const auto v : mesh.vertices()) {
    bool is_free = !mesh.is_border(v);
    for(const auto h : CGAL::halfedges_around_target(v, mesh))
      is_free = is_free && cuts.is_passable(h);
    if(is_free)
      return true;
  }
  return false;
}

// Vertices on aligned edges stay where they are.
std::vector<bool> are_aligned(Named& named)
{
  const Mesh& mesh = named.mesh;
  const auto features = test_meshes::feature_map(named.mesh);
  std::vector<bool> result(mesh.number_of_vertices(), false);
  for(const auto e : mesh.edges())
    if(features[e] || (named.align_border && mesh.is_border(e)))
      for(const int end : {0, 1})
        result[std::size_t(mesh.vertex(e, end))] = true;
  return result;
}

// The map without noise is exact, near by, and has no flips: so no face has a reason to be lost.
void test_slivers(Named named, unsigned int seed, uv_noise::Noise kind, double relative_noise,
                  Tally& tally)
{
  Mesh& mesh = named.mesh;
  const auto uv = test_meshes::uv_map(mesh);
  const auto features = test_meshes::feature_map(mesh);
  const std::string context = named.name + ", seed " + std::to_string(seed) + ", noise "
                              + std::to_string(relative_noise);
  test_meshes::warp(named, seed);
  const double height = std::ldexp(1., -20);
  const std::vector<bool> stays = are_aligned(named);
  slivers::make_slivers(mesh, uv, height, 3, seed, [&](const auto v, const auto&) {
    return !stays[std::size_t(v)];
  });
  CHECK_IN(context, exact_check::check_edges(mesh, uv).is_exact());
  const auto exact = signs(mesh, uv);
  CHECK_IN(context, std::count(exact.begin(), exact.end(), 1) == long(exact.size()));
  uv_noise::perturb(mesh, uv, relative_noise * height, seed, kind);
  const auto np =
    SS::parameters::edge_is_constrained_map(features).align_border(named.align_border)
                   .tolerance(1e-2);
  const auto report = snap(mesh, uv, np, is_aligned(mesh, features, named.align_border), context,
                           false);
  tally.add(report);
}

void test_slivers()
{
  for(const bool has_free : {true, false}) {
    Tally tally;
    for(const Named& named : test_meshes::all_meshes<Kernel>()) {
      Mesh mesh = named.mesh;
      const auto uv = test_meshes::uv_map(mesh);
      if(has_free_vertices(mesh, uv_noise::Cuts<Mesh, UV_map>(mesh, uv)) != has_free)
        continue;
      for(unsigned int seed = 1; seed <= 8; ++seed)
        for(const double noise : {0.5, 2., 10.})
          test_slivers(named, seed,
                       seed % 2 == 0 ? uv_noise::Noise::per_sector : uv_noise::Noise::per_corner,
                       noise, tally);
    }
    tally.print(has_free ? "slivers" : "slivers, all vertices on cuts or the border");
    CHECK(tally.moves > 0);
  }
}

int main()
{
  test_slivers();
  return report_checks();
}
