// Tests of faces that are not positive in the input: repaired if asked, left alone if not.

#ifndef SEAMLESS_SNAPPING_TEST_ORIENTATION_FLIPS_H
#define SEAMLESS_SNAPPING_TEST_ORIENTATION_FLIPS_H

#include "orientation_checks.h"
#include "untangling_checks.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace orientation_flips {

using namespace orientation_checks;

// Folds some free vertices over.
inline std::size_t fold(Named& named, unsigned int seed)
{
  const Mesh& mesh = named.mesh;
  const auto uv = test_meshes::uv_map(named.mesh);
  const std::vector<bool> aligned = are_aligned(named);
  const uv_noise::Cuts<Mesh, UV_map> cuts(mesh, uv);
  std::mt19937_64 random(seed);
  std::vector<Mesh::Halfedge_index> corners;
  std::size_t result = 0;
  for(const auto v : mesh.vertices()) {
    uv_noise::corners_in_turn(mesh.halfedge(v), mesh, cuts, corners);
    if(random() % 4 != 0 || mesh.is_border(v) || aligned[std::size_t(v)]
       || !std::all_of(corners.begin(), corners.end(), [&](auto h) { return cuts.is_passable(h); }))
      continue;
    for(const auto h : corners)
      uv[h] = uv[h] + Kernel::Vector_2(0.375, 0.125);
    ++result;
  }
  return result;
}

// Moves half of the free vertices by up to the given distance each, in u and in v.
inline void tangle(Named& named, const double distance, const unsigned int seed)
{
  const Mesh& mesh = named.mesh;
  const auto uv = test_meshes::uv_map(named.mesh);
  const std::vector<bool> aligned = are_aligned(named);
  const uv_noise::Cuts<Mesh, UV_map> cuts(mesh, uv);
  untangling_checks::Numbers random(seed);
  std::vector<Mesh::Halfedge_index> corners;
  std::vector<std::pair<Mesh::Halfedge_index, Kernel::Vector_2> > shifts; // cuts read the map
  for(const auto v : mesh.vertices()) {
    uv_noise::corners_in_turn(mesh.halfedge(v), mesh, cuts, corners);
    if(random.below(2) != 0 || mesh.is_border(v) || aligned[std::size_t(v)]
       || !std::all_of(corners.begin(), corners.end(), [&](auto h) { return cuts.is_passable(h); }))
      continue;
    const double x = random(distance), y = random(distance);
    for(const auto h : corners)
      shifts.emplace_back(h, Kernel::Vector_2(x, y));
  }
  for(const auto& [h, by] : shifts)
    uv[h] = uv[h] + by;
}

// The angles around each vertex, in full turns; borders need not have whole numbers.
inline std::vector<double> turns(const Mesh& mesh, const UV_map& uv)
{
  std::vector<double> result(mesh.number_of_vertices(), 0);
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(h)) {
      const Kernel::Vector_2 a = uv[mesh.next(h)] - uv[h], b = uv[mesh.prev(h)] - uv[h];
      const double angle = std::atan2(CGAL::to_double(a.x() * b.y() - a.y() * b.x()),
                                      CGAL::to_double(a * b));
      result[std::size_t(mesh.target(h))] += angle / (2 * std::acos(-1.));
    }
  return result;
}

// Half of the free vertices anywhere: moves near by don't help any more, untangling does. All these
// maps have a solution without flips: that which they were made of.
inline void test_untangling(const unsigned int seed)
{
  Tally near_by, untangled;
  std::size_t remaining = 0; // of the first way, for the second
  std::size_t without_flips = 0, with_other_cones = 0;
  for(const Named& original : test_meshes::all_meshes<Kernel>())
    for(const double distance : { 1., 4. })
      for(const auto repair : { SS::Flip_repair::NEAR_BY, SS::Flip_repair::UNTANGLE }) {
        Named named = original;
        Mesh& mesh = named.mesh;
        const auto uv = test_meshes::uv_map(mesh);
        const auto features = test_meshes::feature_map(mesh);
        const Known<Kernel> known(mesh, uv);
        const std::string context = named.name + ", tangled by " + std::to_string(distance);
        if(!are_all_positive(signs(mesh, uv)))
          continue;
        const std::vector<double> turns_before = turns(mesh, uv);
        tangle(named, distance, seed);
        uv_noise::perturb(mesh, uv, 1e-9, 1);
        const auto np = SS::parameters::edge_is_constrained_map(features)
                          .align_border(named.align_border)
                          .edge_is_cut_map(known.edge_is_cut)
                          .halfedge_rotation_map(known.rotations);
        const auto report = snap(mesh, uv, np, is_aligned(mesh, features, named.align_border),
                                 context, int(repair));
        (repair == SS::Flip_repair::NEAR_BY ? near_by : untangled).add(report);
        if(repair == SS::Flip_repair::NEAR_BY)
          remaining = report.remaining_flips.size();
        else
          CHECK_IN(context, report.remaining_flips.size() <= remaining);
        if(are_all_positive(signs(mesh, uv))) {
          ++without_flips;
          const std::vector<double> turns_now = turns(mesh, uv);
          with_other_cones +=
            std::equal(turns_now.begin(), turns_now.end(), turns_before.begin(),
                       [](double a, double b) { return std::abs(a - b) < 0.5; }) ? 0 : 1;
        }
      }
  near_by.print("tangled, near by");
  untangled.print("tangled, untangled");
  std::cout << without_flips << " tangled maps without flips, " << with_other_cones
            << " of them with other cones" << std::endl;
  CHECK(20 * with_other_cones < without_flips);
  CHECK(untangled.flips > 300);
  CHECK(untangled.repaired_flips == untangled.flips);
}

inline void test_flips_of_exact_map()
{
  const std::string context = "flips of an exact map";
  Named named{ context, false, test_meshes::make_mesh<Kernel>(test_meshes::disc(4, 4), 1, 0.25) };
  const Mesh& mesh = named.mesh;
  const auto uv = test_meshes::uv_map(named.mesh);
  const std::size_t folds = fold(named, 3);
  const Bits bits = all_bits(mesh, uv);
  const auto np = SS::parameters::default_values();
  CHECK_IN(context, folds > 0 && !are_all_positive(signs(mesh, uv)));
  snap(mesh, uv, np, exact_check::No_edge_aligned(), context, false);
  CHECK_IN(context, all_bits(mesh, uv) == bits);
  const auto report = snap(mesh, uv, np, exact_check::No_edge_aligned(), context, true);
  CHECK_IN(context, report.status == SS::Outcome::SNAPPED);
  CHECK_IN(context, report.run.number_of_repaired_flips > 0);
  CHECK_IN(context, report.remaining_flips.empty() && are_all_positive(signs(mesh, uv)));
  const auto again = snap(mesh, uv, np, exact_check::No_edge_aligned(), context, true);
  CHECK_IN(context, again.status == SS::Outcome::ALREADY_EXACT);

}

// A map seen from behind: nothing to be done, and nothing done but to say so.
inline void test_mirrored_map()
{
  for(const int repair : { 1, 2 }) { // near by, and by untangling
    const std::string context = "mirrored map, repair " + std::to_string(repair);
    Mesh mesh = test_meshes::make_mesh<Kernel>(test_meshes::double_torus(), 2);
    const auto uv = test_meshes::uv_map(mesh);
    for(const auto h : mesh.halfedges())
      uv[h] = Kernel::Point_2(-uv[h].x(), uv[h].y());
    const Bits mirrored = all_bits(mesh, uv);
    const auto report = snap(mesh, uv, SS::parameters::default_values(),
                             exact_check::No_edge_aligned(), context, repair);
    CHECK_IN(context, report.status == SS::Outcome::FLIPS_REMAIN);
    CHECK_IN(context, report.remaining_flips.size() == mesh.number_of_faces());
    CHECK_IN(context, report.message.find("the map is mirrored") == 0);
    CHECK_IN(context, report.message.find("UNTANGLE") == std::string::npos);
    CHECK_IN(context, all_bits(mesh, uv) == mirrored);
  }
}

// Flips of single free vertices anywhere in the domain, at any scale.
inline void test_flips_near_origin()
{
  for(const double x : { 0., 1e-10, 0.1 })
    for(const double scale : { 1., 0x1p-100, 0x1p100 }) {
      const std::string context =
        "flips at " + std::to_string(1e10 * x) + "e-10, scale " + std::to_string(std::log2(scale));
      Named named{ context, false,
                   test_meshes::make_mesh<Kernel>(test_meshes::disc(4, 4), 1, 0.25) };
      const Mesh& mesh = named.mesh;
      const auto uv = test_meshes::uv_map(named.mesh);
      const auto v = *std::find_if(mesh.vertices().begin(), mesh.vertices().end(),
                                   [&](auto w) { return !mesh.is_border(w); });
      const Kernel::Vector_2 to_place = Kernel::Point_2(x, x / 3) - uv[mesh.halfedge(v)];
      for(const auto h : mesh.halfedges()) {
        const auto fold = mesh.target(h) == v ? CGAL::NULL_VECTOR : Kernel::Vector_2(0.375, 0.125);
        const auto p = uv[h] + to_place - fold;
        uv[h] = Kernel::Point_2(scale * p.x(), scale * p.y());
      }
      CHECK_IN(context, !are_all_positive(signs(mesh, uv)));
      snap(mesh, uv, SS::parameters::default_values(), exact_check::No_edge_aligned(), context,
           true);
      CHECK_IN(context, are_all_positive(signs(mesh, uv)));
    }
}

// One wrong number, as after a broken read: the vertex comes back, and no other moves.
inline void test_far_vertex()
{
  for(const double x : { 1e10, -1e19, 1e100, 1e150 })
    for(const int coordinate : { 0, 1 }) {
      const std::string context = "a vertex far away, coordinate " + std::to_string(coordinate);
      Mesh mesh = test_meshes::make_mesh<Kernel>(test_meshes::double_torus(), 2);
      const auto uv = test_meshes::uv_map(mesh);
      const std::vector<Kernel::Point_2> before = points(mesh, uv);
      const uv_noise::Cuts<Mesh, UV_map> cuts(mesh, uv);
      std::vector<Mesh::Halfedge_index> corners;
      const auto v = *std::find_if(mesh.vertices().begin(), mesh.vertices().end(), [&](auto w) {
        uv_noise::corners_in_turn(mesh.halfedge(w), mesh, cuts, corners);
        return std::all_of(corners.begin(), corners.end(),
                           [&](auto h) { return cuts.is_passable(h); });
      });
      for(const auto h : CGAL::halfedges_around_target(v, mesh))
        uv[h] = coordinate == 0 ? Kernel::Point_2(x, uv[h].y()) : Kernel::Point_2(uv[h].x(), x);
      CHECK_IN(context, !are_all_positive(signs(mesh, uv)));
      const auto report = snap(mesh, uv, SS::parameters::default_values(),
                               exact_check::No_edge_aligned(), context, true);
      CHECK_IN(context, report.status == SS::Outcome::SNAPPED);
      CHECK_IN(context, are_all_positive(signs(mesh, uv)));
      for(const auto h : mesh.halfedges())
        CHECK_IN(context, mesh.target(h) == v || uv[h] == before[std::size_t(h)]);
    }
}

// A vertex and its neighbors inside, all at wrong places.
inline void test_far_vertices()
{
  std::size_t number = 0;
  for(unsigned int seed = 1; seed <= 20; ++seed)
    for(const double size : { 0.1, 10., 1e6 }) {
      const std::string context =
        "vertices far away, by " + std::to_string(size) + ", seed " + std::to_string(seed);
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> places(-size, size);
      Mesh mesh = test_meshes::make_mesh<Kernel>(test_meshes::disc(12, 12), 1, 0.25);
      const auto uv = test_meshes::uv_map(mesh);
      const auto is_inside = [&](auto w) { return !mesh.is_border(w); };
      std::vector<Mesh::Vertex_index> inside;
      std::copy_if(mesh.vertices().begin(), mesh.vertices().end(), std::back_inserter(inside),
                   is_inside);
      const auto v = inside[random() % inside.size()];
      std::vector<Mesh::Vertex_index> wrong(1, v);
      for(const auto w : CGAL::vertices_around_target(v, mesh))
        if(is_inside(w))
          wrong.push_back(w);
      for(const auto w : wrong) {
        const Kernel::Point_2 place(places(random), places(random));
        for(const auto h : CGAL::halfedges_around_target(w, mesh))
          uv[h] = place;
      }
      number += are_all_positive(signs(mesh, uv)) ? 0 : 1;
      const auto report = snap(mesh, uv, SS::parameters::default_values(),
                               exact_check::No_edge_aligned(), context, true);
      CHECK_IN(context + ": " + report.message, are_all_positive(signs(mesh, uv)));
    }
  CHECK(number > 50);
}

// The search ends where the caller wants it to, and says so.
inline void test_bound_of_search()
{
  std::size_t ended = 0;
  for(const unsigned int iterations : { 0u, 1u, 400u })
    for(const Named& original : test_meshes::all_meshes<Kernel>()) {
      Named named = original;
      tangle(named, 4, 1);
      const auto uv = test_meshes::uv_map(named.mesh);
      const auto report = SS::snap_to_seamless(
        named.mesh, uv, SS::parameters::repair_flips(SS::Flip_repair::UNTANGLE)
                          .number_of_untangling_iterations(iterations));
      const std::string context =
        named.name + ", " + std::to_string(iterations) + " iterations: " + report.message;
      CHECK_IN(context, report.run.number_of_untangling_iterations <= iterations);
      const bool is_told = report.message.find("raise it") != std::string::npos;
      CHECK_IN(context, !is_told || report.status == SS::Outcome::FLIPS_REMAIN);
      ended += iterations < 400 && is_told ? 1 : 0;
      CHECK_IN(context, iterations < 400 || !is_told);
    }
  CHECK(ended > 10);
}

// A face with two edges on one isocurve can't have an area: it is told, and nothing is searched.
inline void test_face_without_area()
{
  const std::string context = "face without area";
  Mesh mesh;
  const auto a = mesh.add_vertex(), b = mesh.add_vertex(), c = mesh.add_vertex();
  const auto f = mesh.add_face(a, b, c);
  const auto uv = test_meshes::uv_map(mesh);
  const Kernel::Point_2 places[] = { { 0, 0 }, { 1, 0 }, { 2, 0x1p-10 } };
  for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
    uv[h] = places[std::size_t(mesh.target(h))];
  const auto np = SS::parameters::align_border(true).tolerance(0.1);
  const auto is_aligned = [](auto) { return true; };
  const auto first = snap(mesh, uv, np, is_aligned, context, 2);
  CHECK_IN(context, first.status == SS::Outcome::FLIPS_REMAIN);
  CHECK_IN(context, first.lost_faces == std::vector<std::size_t>{ 0 });
  const auto second = snap(mesh, uv, np, is_aligned, context + ", again", 2);
  CHECK_IN(context, second.remaining_flips == std::vector<std::size_t>{ 0 });
  CHECK_IN(context, second.run.number_of_faces_without_area == 1);
  CHECK_IN(context, second.run.number_of_untangling_iterations == 0);
  CHECK_IN(context, second.message.find("no area") != std::string::npos);
}

// A face without area counts as one to be repaired.
inline void test_degenerate_face()
{
  const std::string context = "degenerate face";
  Named named{ context, false, test_meshes::make_mesh<Kernel>(test_meshes::disc(4, 4), 1, 0.25) };
  const Mesh& mesh = named.mesh;
  const auto uv = test_meshes::uv_map(named.mesh);
  const auto v = *std::find_if(mesh.vertices().begin(), mesh.vertices().end(),
                               [&](auto w) { return !mesh.is_border(w); });
  const auto corner = mesh.halfedge(v);
  const auto middle = CGAL::midpoint(uv[mesh.next(corner)], uv[mesh.prev(corner)]);
  for(const auto h : halfedges_around_target(v, mesh))
    uv[h] = middle;
  const auto before = SS::measure_seamlessness(mesh, uv);
  CHECK_IN(context, before.number_of_degenerate_faces == 1 && before.number_of_flipped_faces == 0);
  snap(mesh, uv, SS::parameters::default_values(), exact_check::No_edge_aligned(), context, true);
  CHECK_IN(context, are_all_positive(signs(mesh, uv)));
}

// Flips of an exact map at nodes of cuts, which no vertex can repair by itself.
inline void test_flips_at_nodes()
{
  Tally tally;
  const double height = 0x1p-16;
  for(Named& named : test_meshes::all_meshes<Kernel>()) {
    if(named.name != "torus" && named.name.find("closed cut around a hole, tr") != 0)
      continue;
    CHECK(squash(named, height));
    for(unsigned int seed = 2; seed <= 16; seed += 2) {
      const std::string context = named.name + ", flips, seed " + std::to_string(seed);
      Named copy = named;
      const auto uv = test_meshes::uv_map(copy.mesh);
      const Known<Kernel> known(copy.mesh, uv);
      uv_noise::perturb(copy.mesh, uv, 2 * height, seed, uv_noise::Noise::per_sector);
      const auto np = SS::parameters::edge_is_cut_map(known.edge_is_cut)
                        .halfedge_rotation_map(known.rotations)
                        .tolerance(0.1);
      SS::snap_to_seamless(copy.mesh, uv, np); // what noise turned over remains so
      const auto report = snap(copy.mesh, uv, np, exact_check::No_edge_aligned(), context, true);
      CHECK_IN(context, report.remaining_flips.empty());
      tally.add(report);
    }
  }
  tally.print("flips at nodes");
  CHECK(tally.repaired_flips > 0);
}

// A map that is exact stays so where its constraints have no solution on one grid.
inline void test_flips_off_grid()
{
  const std::string context = "flips off the grid";
  Named named{ context, false, test_meshes::make_mesh<Kernel>(test_meshes::disc(4, 4), 1, 0.25) };
  const auto uv = test_meshes::uv_map(named.mesh);
  CHECK(fold(named, 3) > 0);
  const auto corner = named.mesh.prev(named.mesh.halfedge(*named.mesh.faces().begin()));
  const Kernel::Vector_2 to_origin = CGAL::ORIGIN - uv[corner];
  for(const auto h : named.mesh.halfedges())
    uv[h] = named.mesh.target(h) == named.mesh.target(corner) ? Kernel::Point_2(0x1p-80, 0)
                                                              : uv[h] + to_origin;
  const auto other = named.mesh.next(corner);
  const std::vector<SS::Corner_constraint<Mesh> > constraints = {
    { { { corner, 0, CGAL::Exact_rational(1) } }, CGAL::Exact_rational(0x1p-80) },
    { { { other, 0, CGAL::Exact_rational(1) } }, CGAL::Exact_rational(uv[other].x()) } };
  CHECK(uv[other].x() >= 0x1p-10);
  const auto report = snap(named.mesh, uv, SS::parameters::corner_constraints(constraints),
                           exact_check::No_edge_aligned(), context, true);
  CHECK(report.remaining_flips.empty());
}

// --- corners of the mesh that touch --------------------------------------------------------------

// Two discs of 2 x 2 squares that share a vertex, the second one in a chart of its own.
struct Bow_tie
{
  Mesh mesh;
  UV_map uv = test_meshes::uv_map(mesh);
  Mesh::Vertex_index shared = mesh.add_vertex();

  Bow_tie()
  {
    for(const int part : { 0, 1 }) {
      std::vector<Mesh::Vertex_index> v;
      for(int i = 0; i < 9; ++i)
        v.push_back(i == 8 * (1 - part) ? shared : mesh.add_vertex());
      const auto add = [&](int a, int b, int c) {
        const auto f = mesh.add_face(v[std::size_t(a)], v[std::size_t(b)], v[std::size_t(c)]);
        for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
          const int i = int(std::find(v.begin(), v.end(), mesh.target(h)) - v.begin());
          uv[h] = Kernel::Point_2(i % 3 + 8 * part, i / 3);
        }
      };
      for(const int i : { 0, 1, 3, 4 }) {
        add(i, i + 1, i + 4);
        add(i, i + 4, i + 3);
      }
    }
  }

  bool is_first(Mesh::Halfedge_index h) const { return uv[h].x() < 5; }
};

inline void test_bow_tie()
{
  const std::string context = "bow tie";
  Bow_tie aligned;
  const Mesh& mesh = aligned.mesh;
  const auto features = test_meshes::feature_map(aligned.mesh);
  std::size_t fans[2] = { 0, 0 }, marked = 0;
  for(const auto h : CGAL::halfedges_around_target(aligned.shared, mesh)) {
    if(mesh.is_border(h))
      continue;
    ++fans[aligned.is_first(h) ? 0 : 1];
    if(mesh.is_border(mesh.opposite(h))) {
      features[mesh.edge(h)] = true;
      ++marked;
    }
  }
  CHECK_IN(context, fans[0] == 2 && fans[1] == 2 && marked == 2);
  uv_noise::perturb(aligned.mesh, aligned.uv, 1e-9, 1);
  snap(mesh, aligned.uv, SS::parameters::edge_is_constrained_map(features),
       is_aligned(mesh, features, false), context + ", aligned");

  // the shared vertex turns a face of the first disc over
  Bow_tie flipped;
  for(const auto h : flipped.mesh.halfedges())
    if(!flipped.mesh.is_border(h) && flipped.is_first(h) &&
       flipped.mesh.target(h) == flipped.shared)
      flipped.uv[h] = Kernel::Point_2(0.5, 0.75);
  const std::vector<Kernel::Point_2> before = points(flipped.mesh, flipped.uv);
  const auto report = snap(flipped.mesh, flipped.uv, SS::parameters::default_values(),
                           exact_check::No_edge_aligned(), context + ", flipped", true);
  CHECK_IN(context, report.run.number_of_repaired_flips > 0 && report.remaining_flips.empty());
  for(const auto h : flipped.mesh.halfedges())
    if(!flipped.mesh.is_border(h) && before[std::size_t(h)].x() > 5)
      CHECK_IN(context, flipped.uv[h] == before[std::size_t(h)]);
}

inline void test_flips_with_noise()
{
  Tally tally;
  for(const Named& original : test_meshes::all_meshes<Kernel>())
    for(const bool repair_flips : { false, true }) {
      Named named = original;
      Mesh& mesh = named.mesh;
      const auto uv = test_meshes::uv_map(mesh);
      const auto features = test_meshes::feature_map(mesh);
      const Known<Kernel> known(mesh, uv); // folds hide what is a cut
      const std::string context = named.name + ", with flips";
      fold(named, 1);
      uv_noise::perturb(mesh, uv, 1e-6, 1);
      const auto np = SS::parameters::edge_is_constrained_map(features)
                        .align_border(named.align_border)
                        .edge_is_cut_map(known.edge_is_cut)
                        .halfedge_rotation_map(known.rotations);
      const auto before = signs(mesh, uv);
      const auto report = snap(mesh, uv, np, is_aligned(mesh, features, named.align_border),
                               context, repair_flips);
      CHECK_IN(context, not_positive(before, signs(mesh, uv), true).empty());
      if(repair_flips)
        tally.add(report);
    }
  tally.print("flips");
  CHECK(tally.repaired_flips > 0);
}

inline void test_flips()
{
  test_flips_of_exact_map();
  untangling_checks::test_untangling_parts();
  for(unsigned int seed = 1; seed <= 4; ++seed)
    test_untangling(seed);
  test_mirrored_map();
  test_flips_near_origin();
  test_degenerate_face();
  test_far_vertex();
  test_far_vertices();
  test_bound_of_search();
  test_face_without_area();
  test_flips_at_nodes();
  test_flips_off_grid();
  test_bow_tie();
  test_flips_with_noise();
}

} // namespace orientation_flips

#endif // SEAMLESS_SNAPPING_TEST_ORIENTATION_FLIPS_H
