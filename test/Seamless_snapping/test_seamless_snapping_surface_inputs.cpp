// Tests of the surface function: transitions that the caller gives, edges too short to tell how
// they turn, inputs that have to be refused untouched, and degenerate ones that have not.

#include "interruptions.h"
#include "surface_checks.h"

#include <CGAL/Seamless_snapping/seam_transitions.h>

#include <CGAL/boost/graph/generators.h>

#include <limits>
#include <random>
#include <set>

using namespace surface_checks;
using SS::Outcome;
using test_meshes::Named_mesh;
using uv_noise::Noise;

using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;
using Point_2 = Kernel::Point_2;
using UV_map = Mesh::Property_map<Halfedge, Point_2>;
using Known = Truth<Mesh, UV_map>;

Named_mesh<Kernel> named_mesh(const std::string& name, unsigned int seed)
{
  for(Named_mesh<Kernel>& named : test_meshes::all_meshes<Kernel>())
    if(named.name == name) {
      test_meshes::warp(named, seed);
      return named;
    }
  CHECK_IN("no mesh " + name, false);
  return Named_mesh<Kernel>();
}

// Must be refused for this reason, with a message that has these words, and without a trace.
template <typename Graph, typename UV, typename NP>
void expect_refusal(const Graph& mesh, UV uv, const NP& np, Outcome status,
                    const std::vector<std::string>& words, const std::string& context)
{
  const Bits before = all_bits(mesh, uv);
  const SS::Snapping_report report = SS::snap_to_seamless(mesh, uv, np);
  CHECK_IN(context, !report);
  CHECK_IN(context + ": " + report.message, report.status == status);
  CHECK_IN(context, all_bits(mesh, uv) == before);
  for(const std::string& word : words)
    CHECK_IN(context + ": no '" + word + "' in: " + report.message,
             report.message.find(word) != std::string::npos);
}

// --- given transitions ---------------------------------------------------------------------------

struct Given
{
  Mesh::Property_map<Edge, bool> is_cut;
  Mesh::Property_map<Halfedge, int> rotation;

  Given(Mesh& mesh, const Known& known)
    : is_cut(mesh.add_property_map<Edge, bool>("e:given", false).first)
    , rotation(mesh.add_property_map<Halfedge, int>("h:given", 0).first)
  {
    for(const auto h : mesh.halfedges()) {
      is_cut[mesh.edge(h)] = known.is_cut(h);
      rotation[h] = known.rotation(h) + 4 * (int(h) % 5 - 2); // any representative will do
    }
  }
};

Halfedge some_cut(const Mesh& mesh, const Known& known, int rotation = -1)
{
  for(const auto h : mesh.halfedges())
    if(known.is_cut(h) && (rotation < 0 || known.rotation(h) == rotation))
      return h;
  return Mesh::null_halfedge();
}

Halfedge some_uncut(const Mesh& mesh, const Known& known)
{
  for(const auto h : mesh.halfedges())
    if(is_interior(mesh, h) && !known.is_cut(h))
      return h;
  return Mesh::null_halfedge();
}

std::string vertex_name(const Mesh& mesh, Halfedge h)
{
  return std::to_string(std::size_t(mesh.target(h)));
}

void test_right_transitions(const Named_mesh<Kernel>& original, unsigned int seed)
{
  Named_mesh<Kernel> named = original;
  test_meshes::warp(named, seed);
  Mesh& mesh = named.mesh;
  const UV_map uv = test_meshes::uv_map(mesh);
  const Known known(mesh, uv);
  const double noise = 1e-9 * known.extent;
  if(!known.is_clear_with(noise))
    return;
  uv_noise::perturb(mesh, uv, noise, seed, seed % 2 == 0 ? Noise::per_sector : Noise::per_corner);
  const Given given(mesh, known);

  const auto try_with = [&](const auto& np, const std::string& context) {
    Named_mesh<Kernel> copy = named;
    const UV_map copy_uv = test_meshes::uv_map(copy.mesh);
    check_transitions(mesh, known, SS::seam_transitions(mesh, uv, np), context);
    CHECK_IN(context, bool(SS::snap_to_seamless(copy.mesh, copy_uv, np)));
    CHECK_IN(context, SS::is_seamless(copy.mesh, copy_uv, np));
    CHECK_IN(context, edges_that_gape(copy.mesh, copy_uv, known) == 0);
    const auto rotation = [&](auto h) { return known.rotation(h); };
    CHECK_IN(context, exact_check::check_edges(copy.mesh, copy_uv, exact_check::No_edge_aligned(),
                                               rotation).is_exact());
    CHECK_IN(context, SS::snap_to_seamless(copy.mesh, copy_uv, np).status
                        == Outcome::ALREADY_EXACT);
    return all_bits(copy.mesh, copy_uv);
  };
  const Bits read = try_with(SS::parameters::default_values(), named.name + ", read");
  const Bits cuts = try_with(SS::parameters::edge_is_cut_map(given.is_cut), named.name + ", cuts");
  const Bits rotations = try_with(SS::parameters::halfedge_rotation_map(given.rotation),
                                  named.name + ", rotations");
  const Bits both = try_with(
    SS::parameters::edge_is_cut_map(given.is_cut).halfedge_rotation_map(given.rotation),
    named.name + ", cuts and rotations");
  CHECK_IN(named.name, read == cuts && read == rotations && read == both);

  // every edge may be a cut: then none is merged
  Named_mesh<Kernel> copy = named;
  const UV_map copy_uv = test_meshes::uv_map(copy.mesh);
  const auto all = SS::parameters::edge_is_cut_map(
    CGAL::Static_boolean_property_map<Edge, true>());
  const SS::Snapping_report report = SS::snap_to_seamless(copy.mesh, copy_uv, all);
  CHECK_IN(named.name + ", all cut", bool(report) && report.run.number_of_merged_edges == 0);
  CHECK_IN(named.name + ", all cut", exact_check::check_edges(copy.mesh, copy_uv).is_exact());
}

void test_wrong_transitions()
{
  Named_mesh<Kernel> named = named_mesh("divided cube", 3);
  Mesh& mesh = named.mesh;
  const UV_map uv = test_meshes::uv_map(mesh);
  const Known known(mesh, uv);
  Given given(mesh, known);
  const Halfedge cut = some_cut(mesh, known, 1), uncut = some_uncut(mesh, known);
  const auto np =
    SS::parameters::edge_is_cut_map(given.is_cut).halfedge_rotation_map(given.rotation);
  const auto rotations_only = SS::parameters::halfedge_rotation_map(given.rotation);

  for(const bool is_exact : { true, false }) {
    const std::string context = is_exact ? "exact map" : "inexact map";
    if(!is_exact)
      uv_noise::perturb(mesh, uv, 1e-9 * known.extent, 1);
    given.rotation[cut] += 1;
    expect_refusal(mesh, uv, np, Outcome::INVALID_ROTATIONS, { vertex_name(mesh, cut) },
                   context + ", rotations of one edge that are not inverse");
    CHECK_IN(context, !SS::seam_transitions(mesh, uv, np));
    given.rotation[mesh.opposite(cut)] -= 1;
    expect_refusal(mesh, uv, np, Outcome::NOT_SEAMLESS, { vertex_name(mesh, cut) },
                   context + ", a wrong rotation");
    CHECK_IN(context, !SS::is_seamless(mesh, uv, np));
    given.rotation[cut] -= 1;
    given.rotation[mesh.opposite(cut)] += 1;

    given.is_cut[mesh.edge(cut)] = false;
    expect_refusal(mesh, uv, np, Outcome::INVALID_ROTATIONS, { vertex_name(mesh, cut) },
                   context + ", a rotation without a cut");
    CHECK_IN(context, !SS::is_seamless(mesh, uv, np));
    const auto cuts_only = SS::parameters::edge_is_cut_map(given.is_cut);
    expect_refusal(mesh, uv, cuts_only, Outcome::NOT_SEAMLESS, { vertex_name(mesh, cut) },
                   context + ", a cut that is said to be none");
    CHECK_IN(context, !SS::is_seamless(mesh, uv, cuts_only));
    given.is_cut[mesh.edge(cut)] = true;

    // whichever of both halfedges has the rotation
    for(const Halfedge h : { uncut, mesh.opposite(uncut) }) {
      given.rotation[h] += 1;
      expect_refusal(mesh, uv, rotations_only, Outcome::INVALID_ROTATIONS,
                     { vertex_name(mesh, h) }, context + ", one halfedge of no cut turned");
      CHECK_IN(context, !SS::is_seamless(mesh, uv, rotations_only));
      CHECK_IN(context, !SS::is_seamless(mesh, uv, np));
      given.rotation[h] -= 1;
    }
    given.rotation[uncut] += 1;
    given.rotation[mesh.opposite(uncut)] -= 1;
    expect_refusal(mesh, uv, rotations_only, Outcome::NOT_SEAMLESS,
                   { vertex_name(mesh, uncut) }, context + ", no cut turned");
    given.rotation[uncut] -= 1;
    given.rotation[mesh.opposite(uncut)] += 1;
  }
}

// --- short edges ---------------------------------------------------------------------------------

// The two sectors of its target, which lies on a branch, take the coordinates of the edge's other
// end, or nearly.
void shrink_cut_edge(const Mesh& mesh, const UV_map& uv, const Known& known, Halfedge h,
                     double length)
{
  const Halfedge sides[2] = { h, mesh.prev(mesh.opposite(h)) };
  const Point_2 ends[2] = { uv[mesh.prev(h)], uv[mesh.opposite(h)] };
  for(int side = 0; side < 2; ++side) {
    const auto d = uv[sides[side]] - ends[side];
    const Point_2 p(ends[side].x() + length * d.x(), ends[side].y() + length * d.y());
    Halfedge corner = sides[side];
    uv[corner] = p;
    if(side == 0) // away from the edge, up to the next cut
      while(!known.is_cut(mesh.next(corner)))
        uv[corner = mesh.opposite(mesh.next(corner))] = p;
    else
      while(!known.is_cut(corner))
        uv[corner = mesh.prev(mesh.opposite(corner))] = p;
  }
}

// Shrinks cut edges to points (or nearly), where one end is a vertex on a branch. Returns them,
// pointing there.
std::vector<Halfedge> shrink_cut_edges(Mesh& mesh, const UV_map& uv, const Known& known,
                                       double length)
{
  std::vector<Halfedge> shrunk;
  std::set<Mesh::Vertex_index> used;
  for(const auto h : mesh.halfedges()) {
    const auto v = mesh.target(h);
    int cuts = 0;
    for(const auto k : CGAL::halfedges_around_target(h, mesh))
      cuts += known.is_cut(k) ? 1 : 0;
    if(!known.is_cut(h) || cuts != 2 || known.indices().count(v) != 0
       || mesh.is_border(v) || used.count(v) != 0 || used.count(mesh.source(h)) != 0)
      continue;
    // not to the centre of the rotation, where the edge would be no cut any more
    if(uv[mesh.prev(h)] == uv[mesh.opposite(h)])
      continue;
    used.insert({ v, mesh.source(h) });
    shrink_cut_edge(mesh, uv, known, h, length);
    shrunk.push_back(h);
  }
  return shrunk;
}

// Around regular vertices all isocurves close, if the rotations are right.
std::vector<SS::Cycle_constraint<Mesh> >
cycles_around_targets(const Mesh& mesh, const std::vector<Halfedge>& halfedges)
{
  std::vector<SS::Cycle_constraint<Mesh> > result;
  for(const Halfedge h : halfedges) {
    result.push_back({ mesh.next(h), 0, { h } });
    for(auto k = mesh.prev(mesh.opposite(h)); k != h; k = mesh.prev(mesh.opposite(k)))
      result.back().path.push_back(k);
  }
  return result;
}

// The violation is that of the rotations that are read, also where an edge takes that of its
// branch.
void check_violation(const Mesh& mesh, const UV_map& uv, const std::string& context)
{
  const auto transitions = SS::seam_transitions(mesh, uv);
  if(!transitions) // told by other tests
    return;
  double violation = 0;
  for(const auto h : mesh.halfedges()) {
    const auto g = mesh.opposite(h);
    if(!is_interior(mesh, h))
      continue;
    const auto edge = uv[h] - uv[mesh.prev(h)], image = uv[mesh.prev(g)] - uv[g];
    const auto rotated = square_complex::rotated({{edge.x(), edge.y()}}, transitions.rotation(h));
    violation = (std::max)({ violation, std::abs(rotated[0] - image.x()),
                             std::abs(rotated[1] - image.y()) });
  }
  CHECK_IN(context, std::abs(transitions.violation() - violation)
                      <= 1e-6 * violation + 1e-15 * transitions.extent());
}

void test_short_edges(unsigned int seed)
{
  std::size_t shrunk = 0;
  for(const std::string name : { "divided cube", "divided torus", "genus 2 of translations",
                                 "closed cut around a disc, rotation", "two islands",
                                 "divided tetrahedron" }) {
    for(const double length : { 0., 0x1p-40 }) {
      for(const double relative : { 0., 1e-10, 1e-7 }) {
        const std::string context = name + ", edges of length " + std::to_string(length)
                                    + ", noise " + std::to_string(relative * 1e9) + "e-9, seed "
                                    + std::to_string(seed);
        Named_mesh<Kernel> named = named_mesh(name, seed);
        Mesh& mesh = named.mesh;
        const UV_map uv = test_meshes::uv_map(mesh);
        const Known known(mesh, uv);
        Named_mesh<Kernel> whole = named;
        const UV_map whole_uv = test_meshes::uv_map(whole.mesh);
        const std::vector<Halfedge> short_edges = shrink_cut_edges(mesh, uv, known, length);
        shrunk += short_edges.size();
        CHECK_IN(context, exact_check::check_edges(mesh, uv).is_exact());
        const auto rotation = [&](auto h) { return known.rotation(h); };
        CHECK_IN(context, exact_check::check_edges(mesh, uv, exact_check::No_edge_aligned(),
                                                   rotation).is_exact());
        const double noise = relative * known.extent;
        // per sector of the map before it shrank
        Named_mesh<Kernel> noisy = named_mesh(name, seed);
        const UV_map noisy_uv = test_meshes::uv_map(noisy.mesh);
        uv_noise::perturb(noisy.mesh, noisy_uv, noise, seed);
        for(const auto h : mesh.halfedges())
          uv[h] = uv[h] + (noisy_uv[h] - whole_uv[h]);
        check_violation(mesh, uv, context);
        if(length == 0 || noise > 1e-11)
          check_transitions(mesh, known, SS::seam_transitions(mesh, uv), context, false);
        const auto snapped = snap_and_check(named, context);
        CHECK_IN(context, snapped.report.largest_change <= 8 * noise);
        const auto cycles = cycles_around_targets(mesh, short_edges);
        CHECK_IN(context, SS::is_seamless(mesh, uv, SS::parameters::cycle_constraints(cycles)));

        // with all transitions known, nothing is left to guess
        const Given given(mesh, known);
        const auto np =
          SS::parameters::edge_is_cut_map(given.is_cut).halfedge_rotation_map(given.rotation);
        CHECK_IN(context, bool(SS::snap_to_seamless(mesh, uv, np)));
        CHECK_IN(context, SS::is_seamless(mesh, uv, np));
        check_transitions(mesh, known, SS::seam_transitions(mesh, uv, np), context + ", given",
                          false);
      }
    }
  }
  CHECK(shrunk > 0);
}

// A corner of a face that has neither end of an edge, or none.
Halfedge far_corner(const Mesh& mesh, Halfedge edge)
{
  for(const auto f : mesh.faces()) {
    const auto around = CGAL::vertices_around_face(mesh.halfedge(f), mesh);
    if(std::none_of(around.begin(), around.end(), [&](auto v) {
         return v == mesh.source(edge) || v == mesh.target(edge);
       }))
      return mesh.halfedge(f);
  }
  return Mesh::null_halfedge();
}

// An exact edge at a cone, much shorter than noise elsewhere: it turns by itself, though just one
// other cut ends at the cone.
void test_short_edges_at_cones()
{
  int count = 0;
  for(Named_mesh<Kernel>& original : test_meshes::all_meshes<Kernel>()) {
    const Known known(original.mesh, test_meshes::uv_map(original.mesh));
    const auto cuts = [&](Halfedge h) {
      int result = 0;
      for(const auto k : CGAL::halfedges_around_target(h, original.mesh))
        result += known.is_cut(k) ? 1 : 0;
      return result;
    };
    for(const auto h : original.mesh.halfedges()) {
      const auto cone = known.indices().find(original.mesh.source(h));
      const Halfedge noisy = far_corner(original.mesh, h);
      if(!known.is_cut(h) || cone == known.indices().end() || cone->second % 4 == 0
         || cuts(original.mesh.opposite(h)) != 2 || cuts(h) != 2
         || known.indices().count(original.mesh.target(h)) != 0
         || original.mesh.is_border(original.mesh.target(h)) || !noisy.is_valid())
        continue;
      Named_mesh<Kernel> named = original;
      const UV_map uv = test_meshes::uv_map(named.mesh);
      shrink_cut_edge(named.mesh, uv, known, h, 0x1p-13);
      CHECK_IN(named.name, exact_check::check_edges(named.mesh, uv).is_exact());
      uv[noisy] = uv[noisy] + Kernel::Vector_2(1e-4 * known.extent, 0);
      check_transitions(named.mesh, known,
                        SS::seam_transitions(named.mesh, uv, SS::parameters::tolerance(1e-3)),
                        named.name + ", short edge at a cone", false);
      ++count;
    }
  }
  CHECK(count > 0);
}

// --- refusals ------------------------------------------------------------------------------------

void test_bad_numbers()
{
  const double infinity = std::numeric_limits<double>::infinity();
  for(const double bad : { std::nan(""), infinity, -infinity, 1.1e300, -1e308 }) {
    for(const bool second : { false, true }) {
      Named_mesh<Kernel> named = named_mesh("box with three holes", 1);
      const UV_map uv = test_meshes::uv_map(named.mesh);
      const Halfedge h = named.mesh.halfedge(Mesh::Face_index(17));
      uv[h] = second ? Point_2(uv[h].x(), bad) : Point_2(bad, uv[h].y());
      expect_refusal(named.mesh, uv, SS::parameters::default_values(), Outcome::NOT_FINITE,
                     { "face 17", "vertex " + vertex_name(named.mesh, h) },
                     "coordinate " + std::to_string(bad));
      CHECK(SS::seam_transitions(named.mesh, uv).failure() == Outcome::NOT_FINITE);
      if(std::abs(bad) > 1e308 || std::isnan(bad))
        CHECK(!SS::is_seamless(named.mesh, uv));
    }
  }
  // at a corner between two edges of the border
  Mesh triangle;
  const Halfedge corner = CGAL::make_triangle(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0),
                                              Kernel::Point_3(0, 1, 0), triangle);
  const UV_map triangle_uv = test_meshes::uv_map(triangle);
  for(const double bad : { std::nan(""), infinity, 1.1e300 }) {
    triangle_uv[corner] = Point_2(bad, 0);
    CHECK(SS::snap_to_seamless(triangle, triangle_uv).status == Outcome::NOT_FINITE);
  }
  // not read on the border
  Named_mesh<Kernel> named = named_mesh("box with three holes", 1);
  const UV_map uv = test_meshes::uv_map(named.mesh);
  for(const auto h : named.mesh.halfedges())
    if(named.mesh.is_border(h))
      uv[h] = Point_2(std::nan(""), infinity);
  uv_noise::perturb(named.mesh, uv, 1e-9, 1);
  snap_and_check(named, "NaN on the border");
}

// What is large, but no more than what is accepted, leaves all figures finite.
void test_large_numbers()
{
  for(const double large : { 1e160, 1e200, 1e300, -1e300 }) {
    Named_mesh<Kernel> named = named_mesh("box with three holes", 1);
    const UV_map uv = test_meshes::uv_map(named.mesh);
    uv_noise::perturb(named.mesh, uv, 1e-9, 1);
    const Halfedge h = named.mesh.halfedge(Mesh::Face_index(17));
    uv[h] = Point_2(large, uv[h].y());
    const auto report =
      SS::snap_to_seamless(named.mesh, uv, SS::parameters::tolerance(10));
    const std::string context = "coordinate " + std::to_string(large);
    CHECK_IN(context, bool(report));
    CHECK_IN(context, SS::is_seamless(named.mesh, uv));
    CHECK_IN(context, report.largest_change > 0 && std::isfinite(report.largest_change));
    for(const double figure : { report.extent, report.violation_before, report.mean_change,
                                report.rms_change, report.optimal_rms_change })
      CHECK_IN(context + ": " + report.message, figure > 0 && std::isfinite(figure));
  }
}

void test_quads()
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(int i = 0; i < 6; ++i)
    v.push_back(mesh.add_vertex(Kernel::Point_3(i / 2, i % 2, 0)));
  mesh.add_face(v[0], v[2], v[1]);
  mesh.add_face(v[1], v[2], v[3]);
  mesh.add_face(v[2], v[4], v[5], v[3]);
  expect_refusal(mesh, test_meshes::uv_map(mesh), SS::parameters::align_border(true),
                 Outcome::NOT_TRIANGULAR, { "face 2", "4" }, "a quad");

  // as many corners as triangles would have, if removed ones counted
  Mesh quads;
  for(int i = 0; i < 3; ++i) {
    v.clear();
    for(int corner = 0; corner < 4; ++corner)
      v.push_back(quads.add_vertex());
    quads.add_face(v);
  }
  const auto removed = quads.add_face(quads.add_vertex(), quads.add_vertex(), quads.add_vertex());
  CGAL::Euler::remove_face(quads.halfedge(removed), quads);
  expect_refusal(quads, test_meshes::uv_map(quads), SS::parameters::default_values(),
                 Outcome::NOT_TRIANGULAR, { "face 0", "4" }, "quads beside garbage");
}

// A digon and a quad: on average, they have three corners. The quad folds round an edge to a vertex
// that is in no other face.
void test_digon()
{
  Mesh mesh;
  Mesh::Vertex_index v[3];
  for(auto& vertex : v)
    vertex = mesh.add_vertex();
  const Halfedge there = mesh.add_edge(v[0], v[1]), back = mesh.add_edge(v[1], v[0]);
  const Halfedge out = mesh.add_edge(v[1], v[2]), in = mesh.opposite(out);
  const auto digon = mesh.add_face(), quad = mesh.add_face();
  const auto link = [&](Mesh::Face_index f, const std::vector<Halfedge>& around) {
    for(std::size_t i = 0; i < around.size(); ++i) {
      mesh.set_next(around[i], around[(i + 1) % around.size()]);
      mesh.set_face(around[i], f);
      mesh.set_halfedge(mesh.target(around[i]), around[i]);
    }
    mesh.set_halfedge(f, around[0]);
  };
  link(digon, { there, back });
  link(quad, { mesh.opposite(back), out, in, mesh.opposite(there) });
  CHECK(mesh.is_valid(false));
  expect_refusal(mesh, test_meshes::uv_map(mesh), SS::parameters::default_values(),
                 Outcome::NOT_TRIANGULAR, { "face 0", "2 corners" }, "a digon and a quad");
}

#ifdef NDEBUG // else CGAL asserts that the indices are as they should
void test_bad_indices()
{
  Named_mesh<Kernel> named = named_mesh("divided cube", 1);
  const Mesh& mesh = named.mesh;
  const UV_map uv = test_meshes::uv_map(named.mesh);
  uv_noise::perturb(named.mesh, uv, 1e-9, 1);
  const auto indices = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  const auto np = SS::parameters::vertex_index_map(indices);
  const std::size_t n = mesh.number_of_vertices();
  const auto refuse_with = [&](const std::string& context, const auto& index_of) {
    for(const auto v : mesh.vertices())
      put(indices, v, index_of(std::size_t(v)));
    expect_refusal(mesh, uv, np, Outcome::INVALID_ARGUMENT, {"vertex_index_map"}, context);
    CHECK_IN(context,
             SS::seam_transitions(mesh, uv, np).failure() == Outcome::INVALID_ARGUMENT);
  };
  refuse_with("indices that were not set", [](std::size_t) { return std::size_t(-1); });
  refuse_with("no different indices", [](std::size_t) { return std::size_t(0); });
  refuse_with("two vertices of one index", [&](std::size_t i) { return i == 0 ? n - 1 : i; });
  refuse_with("an index out of range", [&](std::size_t i) { return i == 0 ? n : i; });
  for(const auto v : mesh.vertices())
    put(indices, v, n - 1 - std::size_t(v));
  CHECK(bool(SS::snap_to_seamless(mesh, uv, np)));
}
#endif

void test_not_seamless()
{
  for(const double error : { 1., 1e-2, 2e-4 }) {
    for(const std::string name : { "divided cube", "disc", "cylinder", "pair of pants" }) {
      Named_mesh<Kernel> named = named_mesh(name, 1);
      const UV_map uv = test_meshes::uv_map(named.mesh);
      const Known known(named.mesh, uv);
      const Halfedge h = some_uncut(named.mesh, known);
      uv[h] = Point_2(uv[h].x() + 1.01 * error * known.extent, uv[h].y());
      const std::string context = name + ", off by " + std::to_string(error);
      expect_refusal(named.mesh, uv, SS::parameters::default_values(),
                     Outcome::NOT_SEAMLESS, { vertex_name(named.mesh, h), "tolerance" },
                     context);
      CHECK_IN(context, !SS::is_seamless(named.mesh, uv));
      CHECK_IN(context,
               SS::snap_to_seamless(named.mesh, uv).violation_before >= error * known.extent);
      expect_refusal(named.mesh, uv, SS::parameters::tolerance(error / 2).verbose(false),
                     Outcome::NOT_SEAMLESS, {}, context + ", tolerance / 2");
      for(const double nonsense : { -1., std::numeric_limits<double>::quiet_NaN() })
        expect_refusal(named.mesh, uv, SS::parameters::tolerance(nonsense),
                       Outcome::INVALID_ARGUMENT, { "tolerance" }, context);
      if(error < 1e-3) {
        CHECK_IN(context, bool(SS::snap_to_seamless(named.mesh, uv,
                                                    SS::parameters::tolerance(4 * error))));
        CHECK_IN(context, exact_check::check_edges(named.mesh, uv).is_exact());
      }
    }
  }
}

void test_not_aligned()
{
  Named_mesh<Kernel> named = named_mesh("divided torus", 1);
  const UV_map uv = test_meshes::uv_map(named.mesh);
  const auto features = test_meshes::feature_map(named.mesh);
  const Known known(named.mesh, uv);
  Halfedge worst;
  double most = 0;
  for(const auto h : named.mesh.halfedges()) {
    const auto d = uv[h] - uv[named.mesh.prev(h)];
    const double off = (std::min)(std::abs(d.x()), std::abs(d.y()));
    if(off > most) {
      most = off;
      worst = h;
    }
  }
  features[named.mesh.edge(worst)] = true;
  const auto np = SS::parameters::edge_is_constrained_map(features);
  CHECK(!SS::is_seamless(named.mesh, uv, np));
  for(const double noise : { 0., 1e-9 }) {
    uv_noise::perturb(named.mesh, uv, noise, 1);
    expect_refusal(named.mesh, uv, np, Outcome::NOT_ALIGNED,
                   { vertex_name(named.mesh, worst),
                     vertex_name(named.mesh, named.mesh.opposite(worst)) }, "slanted feature");
    CHECK(bool(SS::snap_to_seamless(named.mesh, uv))); // not asked, not refused
  }
}

// Two triangles whose edge vectors differ by less than a rounded difference shows.
void test_last_bits()
{
  for(int rotation = 0; rotation < 4; ++rotation) {
    for(const double tiny : { 0x1p-60, -0x1p-1000, 0x1p-1074 }) {
      Named_mesh<Kernel> named{ "two triangles, rotation " + std::to_string(rotation), false,
                                Mesh() };
      Mesh& mesh = named.mesh;
      Mesh::Vertex_index v[4];
      for(auto& vertex : v)
        vertex = mesh.add_vertex();
      mesh.add_face(v[0], v[1], v[2]);
      mesh.add_face(v[1], v[0], v[3]);
      const Halfedge h = mesh.halfedge(v[0], v[1]), g = mesh.opposite(h);
      const UV_map uv = test_meshes::uv_map(mesh);
      const auto set = [&](Halfedge corner, double x, double y, int k) {
        const auto p = square_complex::rotated({ { x, y } }, k);
        uv[corner] = Point_2(p[0], p[1]);
      };
      set(mesh.prev(h), tiny, 0, 0);
      set(h, 1, 0, 0);
      set(mesh.next(h), 0, 1, 0);
      set(g, 8, 3, rotation);
      set(mesh.prev(g), 9, 3, rotation);
      set(mesh.next(g), 8, 2, rotation);
      CHECK_IN(named.name, !SS::is_seamless(mesh, uv));
      CHECK_IN(named.name, SS::measure_seamlessness(mesh, uv).number_of_inexact_edges == 1);
      if(std::isnormal(tiny)) // else it is lost where lengths are scaled
        CHECK_IN(named.name, SS::measure_seamlessness(mesh, uv).violation == std::abs(tiny));
      snap_and_check(named, named.name);
    }
  }
}

// Corners on no interior edge, which nothing but constraints reads.
void test_constraints_on_bad_numbers()
{
  Named_mesh<Kernel> named = named_mesh("disc", 1);
  const UV_map uv = test_meshes::uv_map(named.mesh);
  std::size_t count = 0;
  for(const auto h : named.mesh.halfedges()) {
    const auto beyond = named.mesh.opposite(h), behind = named.mesh.opposite(named.mesh.next(h));
    if(named.mesh.is_border(h) || !named.mesh.is_border(beyond) || !named.mesh.is_border(behind))
      continue;
    const Point_2 before = uv[h];
    const std::vector<SS::Connection_constraint<Mesh> > connections = { { h, h, 0, {} } };
    const std::vector<SS::Corner_constraint<Mesh> > corners = {
      { { { h, 0, CGAL::Exact_rational(1) } }, CGAL::Exact_rational(before.x()) } };
    CHECK(SS::is_seamless(named.mesh, uv, SS::parameters::corner_constraints(corners)));
    uv[h] = Point_2(std::nan(""), 0);
    CHECK(!SS::is_seamless(named.mesh, uv, SS::parameters::corner_constraints(corners)));
    CHECK(!SS::is_seamless(named.mesh, uv, SS::parameters::connection_constraints(connections)));
    uv[h] = before;
    ++count;
  }
  CHECK(count > 0);
}

// --- what is accepted ----------------------------------------------------------------------------

void test_nearly_nothing()
{
  Mesh empty;
  CHECK(SS::is_seamless(empty, test_meshes::uv_map(empty)));
  CHECK(bool(SS::seam_transitions(empty, test_meshes::uv_map(empty))));
  for(int i = 0; i < 2; ++i) { // without, and with a vertex
    const auto refused = SS::snap_to_seamless(empty, test_meshes::uv_map(empty));
    CHECK(refused.status == Outcome::INVALID_ARGUMENT);
    empty.add_vertex();
  }

  Named_mesh<Kernel> named = named_mesh("cube with creases", 1);
  uv_noise::perturb(named.mesh, test_meshes::uv_map(named.mesh), 1e-9, 1);
  for(int i = 0; i < 3; ++i)
    named.mesh.add_vertex();
  snap_and_check(named, "vertices without faces");

  const UV_map named_uv = test_meshes::uv_map(named.mesh);
  const Halfedge noisy = named.mesh.halfedge(Mesh::Face_index(0));
  named_uv[noisy] = named_uv[noisy] + Kernel::Vector_2(1e-9, 0);
  const Halfedge alone = named.mesh.add_edge(Mesh::Vertex_index(0), Mesh::Vertex_index(1));
  const auto features = test_meshes::feature_map(named.mesh);
  features[named.mesh.edge(alone)] = true;
  const auto np = SS::parameters::edge_is_constrained_map(features).align_border(true);
  CHECK(SS::snap_to_seamless(named.mesh, named_uv, np).status == Outcome::SNAPPED);
  CHECK(SS::is_seamless(named.mesh, named_uv, np));
  CHECK(SS::measure_seamlessness(named.mesh, named_uv, np).is_exact());

  Named_mesh<Kernel> single{ "a triangle", true, Mesh() };
  single.mesh.add_face(single.mesh.add_vertex(), single.mesh.add_vertex(),
                       single.mesh.add_vertex());
  // three aligned sides of one triangle: it must collapse, and does
  const UV_map uv = test_meshes::uv_map(single.mesh);
  const Halfedge h = single.mesh.halfedge(*single.mesh.faces().begin());
  uv[h] = Point_2(1, 1e-7);
  uv[single.mesh.next(h)] = Point_2(1 + 1e-7, 1);
  uv[single.mesh.prev(h)] = Point_2(1 + 2e-7, 2);
  snap_and_check(single, "a thin triangle with three aligned sides");
}

// A merged vertex moves along x only: its y stays the zero that it was.
void test_signs_of_zeros()
{
  for(const double zero : { 0., -0. }) {
    Named_mesh<Kernel> named = named_mesh("disc", 1);
    const Mesh& mesh = named.mesh;
    const UV_map uv = test_meshes::uv_map(named.mesh);
    const auto v = *std::find_if(mesh.vertices().begin(), mesh.vertices().end(),
                                 [&](auto w) { return !mesh.is_border(w); });
    const double height = uv[mesh.halfedge(v)].y();
    for(const auto h : mesh.halfedges())
      uv[h] = Point_2(uv[h].x(), mesh.target(h) == v ? zero : uv[h].y() - height);
    uv[mesh.halfedge(v)] = uv[mesh.halfedge(v)] + Kernel::Vector_2(1e-9, zero);
    CHECK(SS::snap_to_seamless(mesh, uv).status == Outcome::SNAPPED);
    for(const auto h : CGAL::halfedges_around_target(v, mesh))
      CHECK(uv[h].y() == 0 && std::signbit(uv[h].y()) == std::signbit(zero));
  }
}

// Everything in one point, or nearly, where any rotation fits any edge.
void test_degenerate_faces(unsigned int seed)
{
  for(Named_mesh<Kernel>& named : test_meshes::all_meshes<Kernel>()) {
    for(const bool is_noisy : { false, true }) {
      const UV_map uv = test_meshes::uv_map(named.mesh);
      std::mt19937_64 random(seed);
      const double noise = is_noisy ? 0x1p-40 : 0.;
      for(const auto h : named.mesh.halfedges())
        uv[h] = Point_2(0.1 + noise * uv_noise::symmetric_random(random),
                        0.7 + noise * uv_noise::symmetric_random(random));
      const std::string context = named.name + " in one point, seed " + std::to_string(seed);
      const Bits before = all_bits(named.mesh, uv);
      const SS::Snapping_report report =
        SS::snap_to_seamless(named.mesh, uv, SS::parameters::tolerance(10.));
      CHECK_IN(context + ": " + report.message, bool(report));
      CHECK_IN(context, exact_check::check_edges(named.mesh, uv).is_exact());
      CHECK_IN(context, is_noisy || all_bits(named.mesh, uv) == before);
      CHECK_IN(context, report.largest_change <= 8 * noise);

      // no extent, and any violation will do
      const auto all = SS::parameters::edge_is_cut_map(
        CGAL::Static_boolean_property_map<Edge, true>()).tolerance(
        std::numeric_limits<double>::infinity());
      CHECK_IN(context, bool(SS::snap_to_seamless(named.mesh, uv, all)));
    }
  }
}

// With merged corners, repairs, notes, and a scale.
void test_interruptions(const unsigned int seed)
{
  for(const std::string name : {"disc", "torus", "disc with aligned border"}) {
    Named_mesh<Kernel> named = named_mesh(name, seed);
    UV_map uv = test_meshes::uv_map(named.mesh);
    std::mt19937_64 random(seed);
    for(const auto h : named.mesh.halfedges())
      uv[h] = uv[h] + 1e-7 * Kernel::Vector_2(uv_noise::symmetric_random(random),
                                              uv_noise::symmetric_random(random));
    const Mesh& mesh = named.mesh;
    const std::vector<Point_2> before(uv.begin(), uv.end());
    const auto test = [&](const auto& np) {
      interruptions::test(name, [&](const auto& visitor) {
        std::copy(before.begin(), before.end(), uv.begin());
        return bool(SS::snap_to_seamless(mesh, uv, np.visitor(visitor)));
      }, [&] { return std::equal(before.begin(), before.end(), uv.begin()); });
    };
    test(SS::parameters::default_values());
    test(SS::parameters::repair_flips(SS::Flip_repair::UNTANGLE));
    test(SS::parameters::grid_scale(3.));
  }
}

int main()
{
  unsigned int seed = 0;
  for(const Named_mesh<Kernel>& named : test_meshes::all_meshes<Kernel>())
    for(int round = 0; round < 10; ++round)
      test_right_transitions(named, ++seed);
  test_wrong_transitions();
  for(int round = 0; round < 10; ++round)
    test_short_edges(++seed);
  test_short_edges_at_cones();
  test_bad_numbers();
  test_constraints_on_bad_numbers();
  test_large_numbers();
  test_quads();
  test_digon();
#ifdef NDEBUG
  test_bad_indices();
#endif
  test_not_seamless();
  test_not_aligned();
  test_last_bits();
  test_nearly_nothing();
  test_signs_of_zeros();
  test_interruptions(++seed);
  for(int round = 0; round < 10; ++round)
    test_degenerate_faces(++seed);
  std::cout << "seeds 1 to " << seed << std::endl;
  return report_checks();
}
