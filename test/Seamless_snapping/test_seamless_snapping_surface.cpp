// Tests of the surface function on small surfaces with every kind of cut, node, branch, border and
// alignment: exactness, transitions, merged edges, and the distance from the exact optimum;
// and where uv maps keep their values.

#include "surface_checks.h"

#include "exact_reference.h"
#include "full_seamless_system.h"
#include "test_data.h"

#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Timer.h>

#include <limits>
#include <memory>
#include <random>
#include <stdexcept>
#include <utility>

using namespace surface_checks;
using test_meshes::Named_mesh;
using uv_noise::Noise;

// The factor between noise and change. The optimum of least squares may concentrate changes.
constexpr double largest_factor = 8;

// Disturbs a warped test mesh by relative noise, snaps it, and checks all that can be known.
template <typename K>
void test_noise(const Named_mesh<K>& original, unsigned int seed, double relative, Noise kind)
{
  const std::string context = original.name + ", seed " + std::to_string(seed) + ", noise "
                              + std::to_string(std::log10(relative))
                              + (kind == Noise::per_corner ? " per corner" : "");
  Named_mesh<K> named = original;
  auto& mesh = named.mesh;
  const auto uv = test_meshes::uv_map(mesh);
  test_meshes::warp(named, seed);
  using Mesh = std::decay_t<decltype(mesh)>;
  const Truth<Mesh, std::decay_t<decltype(uv)> > truth(mesh, uv);
  check_sum_of_indices(mesh, truth, context);

  const double noise = relative * truth.extent;
  uv_noise::perturb(mesh, uv, noise, seed, kind);
  // rounding to the number type is noise, too
  const double eps = double(std::numeric_limits<typename K::FT>::epsilon()) * truth.extent;
  const bool is_clear = truth.is_clear_with(noise + eps);
  if(is_clear)
    check_transitions(mesh, truth, SS::seam_transitions(mesh, uv), context);

  const Snapped<K> snapped = snap_and_check(named, context);
  CHECK_IN(context, snapped.report.largest_change <= largest_factor * (noise + eps)
                      || !is_clear);
  if(!is_clear)
    return;
  CHECK_IN(context, edges_that_gape(mesh, uv, truth) == 0);
  const auto rotation = [&](auto h) { return truth.rotation(h); };
  const auto aligned = is_aligned(mesh, test_meshes::feature_map(mesh), named.align_border);
  CHECK_IN(context, exact_check::check_edges(mesh, uv, aligned, rotation).is_exact());
  check_transitions(mesh, truth, SS::seam_transitions(mesh, uv), context + ", snapped");
}

template <typename K>
void test_random_noise(int rounds, double finest, double coarsest, const std::string& what)
{
  CGAL::Timer timer;
  timer.start();
  std::size_t runs = 0;
  for(const Named_mesh<K>& named : test_meshes::all_meshes<K>()) {
    for(int round = 0; round < rounds; ++round) {
      const unsigned int seed = 1 + static_cast<unsigned int>(runs);
      std::mt19937_64 random(seed);
      const double exponent = finest + (coarsest - finest) * double(random() % 1000) / 999;
      test_noise(named, seed, std::pow(10., exponent),
                 random() % 2 == 0 ? Noise::per_sector : Noise::per_corner);
      ++runs;
    }
  }
  std::cout << what << ": seeds 1 to " << runs << ", " << timer.time() << " s" << std::endl;
}

// What became of the comparisons with the optimum.
struct Optimum_tally
{
  std::size_t compared = 0;
  std::size_t unclear = 0;   // the noise hides which edges are cuts
  std::size_t too_large = 0; // for the reference
  std::size_t repaired = 0;  // faces were lost, and repaired
  double worst = 0;
};

// The sum of squared changes of all sectors against that of the exact optimum of the full system,
// which knows nothing of nodes and branches.
void test_against_optimum(const Named_mesh<Kernel>& original, unsigned int seed, double relative,
                          Noise kind, Optimum_tally& tally)
{
  const std::string context = original.name + " against the optimum, seed " + std::to_string(seed);
  Named_mesh<Kernel> named = original;
  auto& mesh = named.mesh;
  const auto uv = test_meshes::uv_map(mesh);
  test_meshes::warp(named, seed);
  using Mesh = std::decay_t<decltype(mesh)>;
  const Truth<Mesh, std::decay_t<decltype(uv)> > truth(mesh, uv);
  const double noise = relative * truth.extent;
  if(!truth.is_clear_with(noise))
    return void(++tally.unclear);
  uv_noise::perturb(mesh, uv, noise, seed, kind);

  const auto full = exact_check::full_system(
    mesh, uv, [&](auto h) { return truth.rotation(h); },
    is_aligned(mesh, test_meshes::feature_map(mesh), named.align_border),
    [&](auto e) { return truth.is_cut(halfedge(e, mesh)); });
  if(full.system.columns > 400) // the reference takes cubic time
    return void(++tally.too_large);
  const auto optimum = exact_reference::optimum_in_closed_form(full.system, full.xbar);
  CHECK_IN(context, optimum.feasible);

  const Snapped<Kernel> snapped = snap_and_check(named, context);
  const auto values = full.values(uv);
  CHECK_IN(context, exact_reference::exactly_satisfies(full.system, values));
  const double best = std::sqrt(CGAL::to_double(optimum.value));
  const double found =
    std::sqrt(CGAL::to_double(exact_reference::squared_distance(values, full.xbar)));
  // rounding to the grid, or of corners that are only merged, adds a step or so to each unknown
  double largest = 0;
  for(const auto& x : full.xbar)
    largest = (std::max)(largest, std::abs(CGAL::to_double(x)));
  const double step =
    (std::max)(snapped.report.grid_step, std::numeric_limits<double>::epsilon() * largest);
  const double rounding = step * std::sqrt(double(full.system.columns));
  if(snapped.report.run.number_of_lost_faces > 0)
    return void(++tally.repaired); // repairs cost distance
  ++tally.compared;
  tally.worst = (std::max)(tally.worst, (found - 1.001 * best) / rounding);
  CHECK_IN(context, found <= 1.001 * best + 2 * rounding);
  const double optimal = snapped.report.optimal_rms_change;
  CHECK_IN(context, snapped.report.rms_change <= 1.001 * optimal + 2 * step);
  CHECK_IN(context, snapped.report.rms_change >= optimal - 1e-6 * optimal - step / 1024);
}

void test_optimality()
{
  CGAL::Timer timer;
  timer.start();
  Optimum_tally tally;
  unsigned int seed = 0;
  for(const Named_mesh<Kernel>& named : test_meshes::all_meshes<Kernel>()) {
    for(const double relative : { 1e-6, 1e-9, 1e-12, 1e-15 }) {
      ++seed;
      for(const auto& [noise, turn] : {std::make_pair(Noise::per_sector, 0u),
                                       std::make_pair(Noise::per_corner, 1u)})
        if(test_data::are_tests_long() || (seed + seed / 4) % 2 == turn)
          test_against_optimum(named, seed, relative, noise, tally);
    }
  }
  std::cout << "optima: seeds 1 to " << seed << ", " << tally.compared << " compared, "
            << tally.unclear << " unclear, " << tally.too_large << " too large, " << tally.repaired
            << " with repairs; up to " << tally.worst
            << " grid steps per unknown above 1.001 times the optimum, " << timer.time() << " s"
            << std::endl;
}

// A part that nothing links to the rest is snapped on a grid of its own, however small: as if it
// were alone, but for the last bits, which floating point may choose otherwise. (The common grid is
// up to 2^12 times as coarse.)
void test_local_grids()
{
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  std::vector<Mesh> inputs, alone;
  std::vector<double> steps;
  unsigned int seed = 0;
  for(Named_mesh<Kernel>& named : test_meshes::all_meshes<Kernel>()) {
    const auto uv = test_meshes::uv_map(named.mesh);
    const Truth<Mesh, std::decay_t<decltype(uv)> > truth(named.mesh, uv);
    uv_noise::perturb(named.mesh, uv, 0x1p-44 * truth.extent, ++seed);
    for(const auto h : named.mesh.halfedges()) // 1 down to 2^-12
      uv[h] = Kernel::Point_2(std::ldexp(uv[h].x(), -int(4 * (seed % 4))),
                              std::ldexp(uv[h].y(), -int(4 * (seed % 4))));
    inputs.push_back(named.mesh);
    alone.push_back(named.mesh);
    const auto report = SS::snap_to_seamless(alone.back(), test_meshes::uv_map(alone.back()));
    CHECK_IN(named.name, bool(report));
    steps.push_back(report.grid_step);
  }
  for(std::size_t i = 0; i + 1 < inputs.size(); ++i) {
    Mesh together = inputs[i];
    together += inputs[i + 1];
    const auto uv = test_meshes::uv_map(together);
    const auto report = SS::snap_to_seamless(together, uv);
    CHECK_IN("parts " + std::to_string(i), bool(report));
    CHECK_IN("parts " + std::to_string(i), exact_check::check_edges(together, uv).is_exact());
    double largest = 0; // in steps of the part
    for(const auto h : together.halfedges()) {
      const Mesh::size_type n = inputs[i].number_of_halfedges(), index = h.idx();
      const std::size_t part = index < n ? i : i + 1;
      const Mesh::Halfedge_index other(index < n ? index : index - n);
      const auto p = test_meshes::uv_map(alone[part])[other];
      largest = (std::max)({largest, std::abs(uv[h].x() - p.x()) / steps[part],
                            std::abs(uv[h].y() - p.y()) / steps[part]});
    }
    CHECK_IN("parts " + std::to_string(i) + ", by " + std::to_string(largest) + " steps",
             largest <= 64);
  }
}

// Seams of coordinates with 32 bits, as files have them, are exact in these.
void test_float_coordinates()
{
  using Mesh = CGAL::Surface_mesh<Float_kernel::Point_3>;
  unsigned int seed = 0;
  for(Named_mesh<Float_kernel>& named : test_meshes::all_meshes<Float_kernel>()) {
    Mesh& mesh = named.mesh;
    const auto uv = test_meshes::uv_map(mesh);
    const Truth<Mesh, std::decay_t<decltype(uv)> > truth(mesh, uv);
    uv_noise::perturb(mesh, uv, 1e-6 * truth.extent, ++seed);
    CHECK_IN(named.name, bool(SS::snap_to_seamless(mesh, uv)));
    CHECK_IN(named.name, SS::is_seamless(mesh, uv));
    CHECK_IN(named.name, exact_check::check_edges(mesh, uv).is_exact());
  }
}

// A translation of 1e-9 beside noise of 1e-17 is a cut; beside noise of its own size it is none.
void test_tiny_translation()
{
  for(unsigned int seed = 1; seed <= 50; ++seed) {
    Named_mesh<Kernel> named = test_meshes::tiny_translation<Kernel>();
    auto& mesh = named.mesh;
    const auto uv = test_meshes::uv_map(mesh);
    using Mesh = std::decay_t<decltype(mesh)>;
    const Truth<Mesh, std::decay_t<decltype(uv)> > truth(mesh, uv);
    const std::string context = "tiny translation, seed " + std::to_string(seed);
    CHECK_IN(context, truth.smallest_translation < 1e-9 * truth.extent);
    const Named_mesh<Kernel> exact = named;

    uv_noise::perturb(mesh, uv, 1e-16 * truth.extent, seed, Noise::per_sector);
    check_transitions(mesh, truth, SS::seam_transitions(mesh, uv), context);
    snap_and_check(named, context);
    check_transitions(mesh, truth, SS::seam_transitions(mesh, uv), context + ", snapped");

    named = exact;
    uv_noise::perturb(named.mesh, test_meshes::uv_map(named.mesh), truth.smallest_translation,
                      seed, Noise::per_corner);
    const SS::Snapping_report report = snap_and_check(named, context + ", drowned").report;
    CHECK_IN(context, report.run.number_of_cut_edges == 0);
    CHECK_IN(context, report.run.number_of_merged_edges > 0);
  }
}

// --- where uv maps keep their values -------------------------------------------------------------

using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Mesh::Halfedge_index;
using Point_2 = Kernel::Point_2;

// Keeps the values of corners in places that they may share. Throws where others are asked for, and
// after some writing or reading.
struct Map_of_places
{
  using key_type = Halfedge;
  using value_type = Point_2;
  using reference = const Point_2&;
  using category = boost::lvalue_property_map_tag;

  std::shared_ptr<std::vector<Point_2> > values = std::make_shared<std::vector<Point_2> >();
  std::vector<std::size_t> places; // of halfedges
  std::shared_ptr<long> credit = std::make_shared<long>((std::numeric_limits<long>::max)());
  std::shared_ptr<long> reads = std::make_shared<long>((std::numeric_limits<long>::max)());

  void add(const Point_2& p)
  {
    places.push_back(values->size());
    values->push_back(p);
  }

  friend const Point_2& get(const Map_of_places& map, Halfedge h)
  {
    if(--*map.reads == 0)
      throw std::runtime_error("no more to read");
    return map.values->at(map.places[h]);
  }
  friend void put(const Map_of_places& map, Halfedge h, const Point_2& p)
  {
    if(--*map.credit == 0)
      throw std::runtime_error("no credit");
    map.values->at(map.places[h]) = p;
  }
};

void test_no_values_on_border()
{
  for(const Named_mesh<Kernel>& named : test_meshes::all_meshes<Kernel>()) {
    Mesh mesh = named.mesh;
    const auto uv = test_meshes::uv_map(mesh);
    uv_noise::perturb(mesh, uv, 1e-9, 1);
    Map_of_places map;
    for(const auto h : mesh.halfedges())
      if(mesh.is_border(h))
        map.places.push_back((std::numeric_limits<std::size_t>::max)());
      else
        map.add(uv[h]);
    const auto np = SS::parameters::align_border(named.align_border).repair_flips(true);
    bool is_read = false;
    try {
      CHECK_IN(named.name, bool(SS::seam_transitions(mesh, map)));
      CHECK_IN(named.name, bool(SS::snap_to_seamless(mesh, map, np)));
      CHECK_IN(named.name, SS::is_seamless(mesh, map, np));
    } catch(const std::out_of_range&) {
      is_read = true;
    }
    CHECK_IN(named.name, !is_read);
  }
}

// Two inner vertices of a disc in the same place, each with other noise at all corners but one,
// that is shared; signs of zeros are mixed.
void test_shared_places()
{
  Mesh mesh = test_meshes::make_mesh<Kernel>(test_meshes::disc(6, 6), 1);
  const auto uv = test_meshes::uv_map(mesh);
  std::vector<Mesh::Vertex_index> inner;
  for(const auto v : mesh.vertices())
    if(!mesh.is_border(v))
      inner.push_back(v);
  const auto a = inner.front(), b = inner.back();
  const Point_2 p = uv[mesh.halfedge(a)];
  std::mt19937_64 random(1);
  for(const auto h : mesh.halfedges()) {
    if(mesh.target(h) == a || mesh.target(h) == b)
      uv[h] = p + Kernel::Vector_2(1e-9 * uv_noise::symmetric_random(random), 0);
    else if(uv[h].x() == 0)
      uv[h] = Point_2(random() % 2 == 0 ? 0. : -0., uv[h].y());
  }
  Map_of_places map;
  for(const auto h : mesh.halfedges())
    map.add(uv[h]);
  const auto places = map.places;
  map.places[mesh.halfedge(a)] = map.places[mesh.halfedge(b)];
  const Bits before = all_bits(mesh, map);
  const auto np = SS::parameters::default_values();
  CHECK(SS::snap_to_seamless(mesh, map, np).status == SS::Outcome::INTERNAL_ERROR);
  CHECK(all_bits(mesh, map) == before);
  CHECK(SS::snap_to_seamless(mesh, map, SS::parameters::grid_scale(2.)).status ==
        SS::Outcome::INTERNAL_ERROR);
  CHECK(all_bits(mesh, map) == before);

  // nothing remains of what was written before something is thrown
  map.places = places;
  const Bits separate = all_bits(mesh, map);
  const auto values = *map.values;
  for(long* const countdown : { map.reads.get(), map.credit.get() }) {
    *map.values = values;
    long attempts = 0;
    for(bool is_done = false; !is_done; ++attempts) {
      *countdown = attempts + 1;
      try {
        is_done = bool(SS::snap_to_seamless(mesh, map, np));
      } catch(const std::runtime_error&) { }
      *countdown = (std::numeric_limits<long>::max)();
      CHECK((all_bits(mesh, map) == separate) == !is_done);
    }
    CHECK(attempts > 20);
  }

  // corners of one vertex may share a place
  for(const auto v : mesh.vertices())
    for(const auto h : CGAL::halfedges_around_target(v, mesh))
      if(!mesh.is_border(h))
        map.places[h] = map.places[mesh.is_border(mesh.halfedge(v)) ? h : mesh.halfedge(v)];
  CHECK(SS::is_seamless(mesh, map));
}

// --- small coordinates ---------------------------------------------------------------------------

// A vertex that no constraint links to the rest, close to the origin; `closest` of its corners is
// closer than the others. It is to take the mean of all. Returns the step of the grid.
double snap_vertex_at_origin(double ratio, std::size_t closest)
{
  const std::string context = "vertex at the origin, ratio " + std::to_string(ratio) + ", corner "
                              + std::to_string(closest);
  Mesh mesh = test_meshes::make_mesh<Kernel>(test_meshes::disc(4, 4), 1);
  const auto uv = test_meshes::uv_map(mesh);
  const auto v = *std::find_if(mesh.vertices().begin(), mesh.vertices().end(),
                               [&](auto w) { return !mesh.is_border(w); });
  const Kernel::Vector_2 to_origin = CGAL::ORIGIN - uv[mesh.halfedge(v)];
  for(const auto h : mesh.halfedges())
    uv[h] = uv[h] + to_origin;
  std::mt19937_64 random(1);
  double sum = 0;
  std::size_t i = 0;
  for(const auto h : CGAL::halfedges_around_target(v, mesh)) {
    const double x = 1e-9 * (1 + uv_noise::symmetric_random(random) / 4);
    uv[h] = i++ == closest ? Point_2(x / ratio, 0) : Point_2(x, 0);
    sum += uv[h].x();
  }
  const SS::Snapping_report report = SS::snap_to_seamless(mesh, uv);
  CHECK_IN(context, report.status == SS::Outcome::SNAPPED);
  CHECK_IN(context, SS::is_seamless(mesh, uv));
  const Point_2 p = uv[mesh.halfedge(v)];
  CHECK_IN(context, std::abs(p.x() - sum / double(i)) <= 1e-24 && p.y() == 0);
  return report.grid_step;
}

void test_vertex_at_origin()
{
  const double step = snap_vertex_at_origin(1, 0);
  for(const double ratio : { 2., 16., 1e3, 1e6, 1e15 })
    for(std::size_t closest = 0; closest < 6; ++closest)
      CHECK_EQUAL(snap_vertex_at_origin(ratio, closest), step);
}

int main()
{
  test_no_values_on_border();
  test_shared_places();
  test_vertex_at_origin();
  test_local_grids();
  test_float_coordinates();
  std::cout.precision(3);
  test_random_noise<Kernel>(test_data::trials(400), -15, -6, "noise");
  test_random_noise<Float_kernel>(test_data::trials(100), -7, -5.3, "noise on floats");
  test_tiny_translation();
  test_optimality();
  return report_checks();
}
