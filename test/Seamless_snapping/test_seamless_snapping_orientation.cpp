// Tests of the orientation of faces: none that is positive may lose it by snapping where an exact
// solution near by keeps it. Small exact maps without flips are made thin in places, and disturbed
// by about the height of the slivers. The map without noise then is such a solution, for all faces
// at once, so that whatever is positive in the disturbed map must stay so.

#include "orientation_checks.h"
#include "orientation_data.h"
#include "orientation_flips.h"
#include "slivers.h"

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using namespace orientation_checks;

// The number of seam vertices that are no node and have moved as a whole: without that, each side
// takes half of the gap, in opposite directions.
std::size_t moved_seam_vertices(Named& named, const Known<Kernel>& known,
                                const std::vector<Kernel::Point_2>& before, const UV_map& after,
                                double precision)
{
  const Mesh& mesh = named.mesh;
  const std::vector<bool> aligned = are_aligned(named);
  std::size_t result = 0;
  for(const auto v : mesh.vertices()) {
    std::vector<Mesh::Halfedge_index> cuts;
    int holonomy = 0;
    for(const auto h : CGAL::halfedges_around_target(v, mesh))
      if(known.edge_is_cut[mesh.edge(h)]) {
        cuts.push_back(h);
        holonomy += known.rotations[h];
      }
    if(cuts.size() != 2 || holonomy % 4 != 0 || mesh.is_border(v) || aligned[std::size_t(v)])
      continue;
    const auto h = cuts[0], other = mesh.prev(mesh.opposite(h));
    const auto d = after[h] - before[std::size_t(h)];
    const auto d_other = after[other] - before[std::size_t(other)];
    const auto turned = square_complex::rotated({ { d.x(), d.y() } }, known.rotations[h]);
    result += std::abs(turned[0] + d_other.x()) > precision
                  || std::abs(turned[1] + d_other.y()) > precision
                ? 1 : 0;
  }
  return result;
}

struct Totals : Tally
{
  std::size_t moved_seam_vertices = 0;
};

void test_noise(Named& named, unsigned int seed, double noise, const std::string& context,
                Totals& totals)
{
  Mesh& mesh = named.mesh;
  const auto uv = test_meshes::uv_map(mesh);
  const auto features = test_meshes::feature_map(mesh);
  const Known<Kernel> known(mesh, uv);
  CHECK_IN(context, exact_check::check_edges(mesh, uv).is_exact());
  CHECK_IN(context, are_all_positive(signs(mesh, uv)));
  const bool per_sector = seed % 2 == 0;
  uv_noise::perturb(mesh, uv, noise, seed,
                    per_sector ? uv_noise::Noise::per_sector : uv_noise::Noise::per_corner);
  const std::vector<Kernel::Point_2> before = points(mesh, uv);
  const auto np = SS::parameters::edge_is_constrained_map(features)
                    .align_border(named.align_border)
                    .edge_is_cut_map(known.edge_is_cut)
                    .halfedge_rotation_map(known.rotations)
                    .tolerance(1e-1);
  const auto report =
    snap(mesh, uv, np, is_aligned(mesh, features, named.align_border), context);
  CHECK_IN(context, report.lost_faces.empty());
  totals.add(report);
  if(per_sector)
    totals.moved_seam_vertices +=
      moved_seam_vertices(named, known, before, uv, 1e-3 * report.largest_change);
}

// --- slivers at random ---------------------------------------------------------------------------

constexpr double sliver_height = 0x1p-20;

void test_slivers(Named named, unsigned int rarity, unsigned int seed, double noise, Totals& totals)
{
  const std::string context = named.name + ", one of " + std::to_string(rarity) + ", seed "
                              + std::to_string(seed) + ", noise " + std::to_string(noise);
  test_meshes::warp(named, seed);
  const std::vector<bool> stays = are_aligned(named);
  slivers::make_slivers(named.mesh, test_meshes::uv_map(named.mesh), sliver_height, rarity, seed,
                        [&](const auto v, const auto&) { return !stays[std::size_t(v)]; });
  test_noise(named, seed, noise * sliver_height, context, totals);
}

bool has_free_vertices(const Named& named)
{
  Mesh mesh = named.mesh;
  const uv_noise::Cuts<Mesh, UV_map> cuts(mesh, test_meshes::uv_map(mesh));
  const auto is_free = [&](const auto v) {
    const auto around = CGAL::halfedges_around_target(v, mesh);
    return std::all_of(around.begin(), around.end(), [&](auto h) { return cuts.is_passable(h); });
  };
  return std::any_of(mesh.vertices().begin(), mesh.vertices().end(), is_free);
}

void test_slivers()
{
  for(const bool has_free : { true, false }) {
    Totals totals;
    for(const Named& named : test_meshes::all_meshes<Kernel>())
      if(has_free_vertices(named) == has_free)
        for(unsigned int seed = 1; seed <= 4; ++seed)
          for(const double noise : { 0.5, 2., 10., 100. })
            for(const unsigned int rarity : { 1u, 3u })
              test_slivers(named, rarity, seed, noise, totals);
    totals.print(has_free ? "slivers" : "slivers, all vertices on cuts or the border");
    CHECK(totals.moves > 0);
    CHECK(!has_free || totals.moved_seam_vertices > 0);
    CHECK(totals.remaining == 0);
  }
}

// --- slivers everywhere --------------------------------------------------------------------------

void test_squashed()
{
  Totals totals;
  const double height = 0x1p-16;
  for(Named& named : test_meshes::all_meshes<Kernel>()) {
    test_meshes::warp(named, 1);
    if(has_aligned(named) ||
       !squash(named, height)) // which coordinate is aligned is lost in the noise
      continue;
    for(unsigned int seed = 1; seed <= 8; ++seed)
      for(const double noise : { 0.01, 0.1, 1., 10. }) {
        Named copy = named;
        test_noise(copy, seed, noise * height,
                   named.name + ", squashed, seed " + std::to_string(seed) + ", noise "
                     + std::to_string(noise), totals);
      }
  }
  totals.print("squashed");
  CHECK(totals.program > 0);
  CHECK(totals.remaining == 0);
}

// More slivers at cones than programs take together: the rest is listed, and nothing else is lost.
void test_crowd()
{
  Totals totals;
  square_complex::Square_complex complex = test_meshes::tetrahedron();
  for(int i = 0; i < 12000; ++i)
    complex.append(test_meshes::tetrahedron());
  Named named{ "crowd", false, test_meshes::make_mesh<Kernel>(complex, 1) };
  squash(named, 0x1p-16);
  test_noise(named, 2, 0.3 * 0x1p-16, named.name, totals);
  totals.print(named.name);
  CHECK(totals.program > 0);
  CHECK(totals.remaining < totals.lost);
}

// --- aligned vertices ----------------------------------------------------------------------------

// Two squares beside each other, twice, with the border and the vertical line in the middle
// aligned. The vertex in the middle lies just above the lower border, which is noisy there: its
// common level comes out above. All vertices of the faces between are fixed, but the one in the
// middle can move along its line.
void test_move_along_isocurve()
{
  const std::string context = "move along an isocurve";
  const double h = 0x1p-20;
  square_complex::Square_complex complex = test_meshes::disc(2, 2);
  test_meshes::mark_segment(complex, 1, 0, 1, 2);
  Mesh mesh = test_meshes::make_mesh<Kernel>(complex, 1, 1.);
  const auto uv = test_meshes::uv_map(mesh);
  const auto features = test_meshes::feature_map(mesh);
  std::vector<Mesh::Halfedge_index> middle;
  for(const auto corner : mesh.halfedges()) {
    if(mesh.is_border(corner))
      continue;
    const auto p = uv[corner];
    if(p.y() == 0)
      uv[corner] = Kernel::Point_2(p.x(), p.x() == 1 ? -2 * h : 4 * h);
    if(p == Kernel::Point_2(1, 1)) {
      middle.push_back(corner);
      uv[corner] = Kernel::Point_2(1, h);
    }
  }
  CHECK_IN(context, middle.size() >= 4);
  CHECK_IN(context, are_all_positive(signs(mesh, uv)));
  const auto np = SS::parameters::edge_is_constrained_map(features).align_border(true);
  const auto report = snap(mesh, uv, np, is_aligned(mesh, features, true), context);
  CHECK_IN(context, report.run.number_of_faces_repaired_by_moves > 0);
  CHECK_IN(context, report.lost_faces.empty());
  for(const auto corner : middle)
    CHECK_IN(context, uv[corner].x() == 1 && uv[corner].y() > 2 * h && uv[corner].y() < 4 * h);
}

// --- other types, and failures -------------------------------------------------------------------

void test_other_types()
{
  const std::string context = "other types";
  Tally tally;
  for(unsigned int seed = 1; seed <= 4; ++seed) {
    auto mesh = test_meshes::make_mesh<Float_kernel>(test_meshes::torus(4, 3), 2);
    const auto uv = test_meshes::uv_map(mesh);
    const Known<Float_kernel> known(mesh, uv);
    const double height = 0x1p-13;
    slivers::make_slivers(mesh, uv, height, 1, seed, [](const auto&, const auto&) { return true; });
    CHECK_IN(context, exact_check::check_edges(mesh, uv).is_exact());
    uv_noise::perturb(mesh, uv, 3 * height, seed);
    auto copy = mesh;
    const auto np = SS::parameters::tolerance(0.1);
    tally.add(snap(mesh, uv,
                   np.edge_is_cut_map(known.edge_is_cut).halfedge_rotation_map(known.rotations),
                   exact_check::No_edge_aligned(), context));
    snap(copy, test_meshes::uv_map(copy), np, exact_check::No_edge_aligned(), context, true);
  }
  tally.print(context);
  CHECK(tally.lost > 0 && tally.remaining == 0);
}

// A component whose coordinates are much smaller, down to its slivers, is treated on a grid of its
// own.
void test_small_component()
{
  const std::string context = "small component";
  Tally tally;
  for(unsigned int seed = 1; seed <= 8; ++seed) {
    square_complex::Square_complex complex = test_meshes::torus(3, 3);
    complex.append(test_meshes::torus(3, 3));
    Mesh mesh = test_meshes::make_mesh<Kernel>(complex, 2);
    const auto uv = test_meshes::uv_map(mesh);
    const Known<Kernel> known(mesh, uv);
    slivers::make_slivers(mesh, uv, sliver_height, 1, seed,
                          [](const auto&, const auto&) { return true; });
    uv_noise::perturb(mesh, uv, 3 * sliver_height, seed);
    for(const auto f : mesh.faces())
      for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
        if(2 * std::size_t(f) >= mesh.number_of_faces())
          uv[h] = Kernel::Point_2(0x1p-34 * uv[h].x(), 0x1p-34 * uv[h].y());
    tally.add(snap(mesh, uv, SS::parameters::edge_is_cut_map(known.edge_is_cut)
                               .halfedge_rotation_map(known.rotations),
                   exact_check::No_edge_aligned(), context));
  }
  tally.print(context);
  CHECK(tally.lost > 0 && tally.remaining == 0);
}

// A map that forgets what is written to one corner.
struct Forgetful_map
{
  using key_type = Mesh::Halfedge_index;
  using value_type = Kernel::Point_2;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  UV_map uv;
  key_type forgotten;

  friend value_type get(const Forgetful_map& map, key_type h) { return map.uv[h]; }
  friend void put(const Forgetful_map& map, key_type h, const value_type& p)
  {
    if(h != map.forgotten)
      map.uv[h] = p;
  }
};

// All or nothing, whichever of the corners that change is forgotten. Counts those of vertices that
// are on no cut.
std::size_t test_forgetful_map(unsigned int seed)
{
  const std::string context = "forgetful map, seed " + std::to_string(seed);
  Mesh mesh = test_meshes::make_mesh<Kernel>(test_meshes::torus(4, 3), 2);
  const auto uv = test_meshes::uv_map(mesh);
  const Known<Kernel> known(mesh, uv);
  slivers::make_slivers(mesh, uv, sliver_height, 1, seed,
                        [](const auto&, const auto&) { return true; });
  uv_noise::perturb(mesh, uv, 3 * sliver_height, seed);
  const auto np =
    SS::parameters::edge_is_cut_map(known.edge_is_cut).halfedge_rotation_map(known.rotations);
  const Bits bits = all_bits(mesh, uv);
  const std::vector<Kernel::Point_2> before = points(mesh, uv);
  CHECK_IN(context, bool(SS::snap_to_seamless(mesh, uv, np)));
  const std::vector<Kernel::Point_2> after = points(mesh, uv);
  std::size_t on_cuts = 0, elsewhere = 0;
  for(const auto h : mesh.halfedges()) {
    for(const auto g : mesh.halfedges())
      uv[g] = before[std::size_t(g)];
    if(before[std::size_t(h)] == after[std::size_t(h)])
      continue;
    const auto report = SS::snap_to_seamless(mesh, Forgetful_map{ uv, h }, np);
    CHECK_IN(context, report.status == SS::Outcome::INTERNAL_ERROR);
    CHECK_IN(context, all_bits(mesh, uv) == bits);
    const auto around = CGAL::halfedges_around_target(mesh.target(h), mesh);
    const bool is_on_cut = std::any_of(around.begin(), around.end(), [&](const auto g) {
      return known.edge_is_cut[mesh.edge(g)];
    });
    ++(is_on_cut ? on_cuts : elsewhere);
  }
  CHECK_IN(context, on_cuts > 0);
  return elsewhere;
}

void test_forgetful_map()
{
  std::size_t elsewhere = 0;
  for(unsigned int seed = 1; seed <= 8; ++seed)
    elsewhere += test_forgetful_map(seed);
  CHECK(elsewhere > 0);
}

int main()
{
  test_slivers();
  test_squashed();
  test_crowd();
  test_move_along_isocurve();
  orientation_flips::test_flips();
  test_other_types();
  test_small_component();
  test_forgetful_map();
  orientation_data::test_files();
  return report_checks();
}
