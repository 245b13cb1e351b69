// Tests of isocurve tracing: curves on exactly seamless maps end properly and are the same
// backwards, to the last bit, in all data structures, with one thread and with several.

#include "Isocurve_walker.h"
#include "Polyhedron_copy.h"
#include "floating_point_traps.h"
#include "test_data.h"
#include "test_meshes.h"
#include "tracing_checks.h"

#include <CGAL/Isocurves_and_layouts/isocurve_constraints.h>
#include <CGAL/Isocurves_and_layouts/trace_isocurve.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <filesystem>
#include <iterator>
#include <random>

using namespace tracing_checks;

// --- threads -------------------------------------------------------------------------------------

bool are_identical(const Curve& a, const Curve& b)
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

// Separatrices traced by several threads, where TBB is linked, are those of one, in the same order.
void test_threads(const Mesh& mesh, const UV_map& uv)
{
  const auto np = parameters::maximum_number(200);
  std::vector<Curve> one, many;
  IL::trace_all_separatrices(mesh, uv, std::back_inserter(one), np);
  IL::trace_all_separatrices<CGAL::Parallel_if_available_tag>(mesh, uv, std::back_inserter(many),
                                                              np);
  if(!CHECK_EQUAL(one.size(), many.size()))
    return;
  std::size_t different = 0;
  for(std::size_t i = 0; i < one.size(); ++i)
    different += are_identical(one[i], many[i]) ? 0 : 1;
  CHECK_EQUAL(different, std::size_t(0));
}

// --- curves on exact maps ------------------------------------------------------------------------

// 4 - index curves leave a singular vertex, four a regular one.
void test_numbers_of_directions(const Mesh& mesh, const UV_map& uv, const Tracer& tracer)
{
  std::map<Mesh::Vertex_index, int> index;
  const auto seams = IL::seam_transitions(mesh, uv);
  for(const auto& [v, i] : seams.singular_vertices())
    index[v] = i;
  std::size_t wrong = 0;
  for(const auto v : mesh.vertices())
    if(!mesh.is_isolated(v) && !CGAL::is_border(v, mesh) &&
       is_unfolded(mesh, uv, mesh.halfedge(v))) {
      const int n = int(tracer.outgoing(v).size());
      wrong += n != 4 - index[v] ? 1 : 0; // also of 720 degrees, which don't show in the rotations
      wrong += tracer.is_singular(v) != (n != 4) ? 1 : 0;
    }
  CHECK_EQUAL(wrong, std::size_t(0));
}

// The curves from a corner meet the opposite edge one after the other, counterclockwise, in faces
// of either orientation. Returns how many successive ones there are in flipped faces.
std::size_t test_order_of_directions(const Mesh& mesh, const UV_map& uv, const Tracer& tracer)
{
  std::size_t wrong = 0, flipped = 0;
  for(const auto v : mesh.vertices()) {
    const auto outgoing = tracer.outgoing(v);
    const auto crossing = [&](const std::size_t i) {
      const Mesh::Halfedge_index h = outgoing[i].first.halfedge;
      const bool is_horizontal =
        outgoing[i].second == Direction::PLUS_U || outgoing[i].second == Direction::MINUS_U;
      const int c = is_horizontal ? 1 : 0;
      const Exact_rational p(uv[h][c]), q(uv[mesh.next(h)][c]), r(uv[mesh.prev(h)][c]);
      return Exact_rational((q - p) / (q - r)); // 0 at the first edge of the corner, 1 at the last
    };
    for(std::size_t i = 1; i < outgoing.size(); ++i) {
      const Mesh::Halfedge_index h = outgoing[i].first.halfedge;
      if(h != outgoing[i - 1].first.halfedge)
        continue;
      wrong += crossing(i - 1) > crossing(i) ? 1 : 0; // equal in a degenerate face
      flipped += CGAL::orientation(uv[mesh.prev(h)], uv[h], uv[mesh.next(h)]) == CGAL::RIGHT_TURN
                   ? 1 : 0;
    }
  }
  CHECK_EQUAL(wrong, std::size_t(0));
  return flipped;
}

// Vertices away from seams are moved to their neighbors' other sides. Returns how many successive
// curves there are in flipped faces.
std::size_t test_order_in_folds(const Mesh& original, const UV_map& original_uv)
{
  Mesh mesh = original;
  UV_map uv = square_complex::uv_map(mesh);
  std::size_t i = 0;
  for(const auto v : mesh.vertices()) {
    const auto around = CGAL::halfedges_around_target(mesh.halfedge(v), mesh);
    if(i++ % 5 != 0 || mesh.is_isolated(v) || CGAL::is_border(v, mesh) ||
       std::any_of(around.begin(), around.end(), [&](const auto h)
                   { return original_uv[h] != original_uv[*around.begin()] ||
                            original_uv[mesh.prev(h)] != original_uv[mesh.opposite(h)]; }))
      continue;
    const auto opposite = mesh.next(mesh.opposite(mesh.prev(mesh.halfedge(v))));
    for(const auto h : around)
      uv[h] = uv[opposite];
  }
  const Tracer tracer(mesh, uv);
  CHECK(tracer.is_exact());
  return tracer ? test_order_of_directions(mesh, uv, tracer) : 0;
}

// Curves that start at random points of edges and faces.
void test_other_starts(const Mesh& mesh, const UV_map& uv, const Tracer& tracer, const int number)
{
  std::mt19937_64 random(11);
  std::size_t bad = 0;
  for(int i = 0; i < number; ++i) {
    auto h = Mesh::Halfedge_index(Mesh::size_type(random() % mesh.number_of_halfedges()));
    h = mesh.is_border(h) ? mesh.opposite(h) : h;
    const Direction direction = Direction(random() % 4);
    const auto limit = parameters::maximum_number(100);
    const Exact_rational t(Exact_rational(int(random() % 6) + 1) / 7);
    const auto curve = tracer.trace(Start::on_edge(h, t), direction, limit);
    bad += is_good(tracer, curve, mesh, uv) || curve.status == Status::CONSTANT_ON_FACE ? 0 : 1;

    const auto a = uv[mesh.prev(h)], b = uv[h], c = uv[mesh.next(h)];
    const auto inner = tracer.trace(
      Start::in_face(h, a.x() / 4 + b.x() / 4 + c.x() / 2, a.y() / 4 + b.y() / 4 + c.y() / 2),
      direction, limit);
    bad += is_good(tracer, inner, mesh, uv) || inner.status == Status::CONSTANT_ON_FACE ? 0 : 1;
    bad += inner.points.front().place() == Place::FACE ? 0 : 1;
  }
  CHECK_EQUAL(bad, std::size_t(0));
}

// Every vertex of a curve is hit when it is the target, from either end.
bool hits_its_vertices(const Tracer& tracer, const IL::Isocurve<Mesh>& curve, const Mesh& mesh)
{
  for(std::size_t i = 1; i < curve.points.size(); ++i) {
    const auto& point = curve.points[i];
    if(point.place() != Place::VERTEX)
      continue;
    const auto v = mesh.target(point.halfedge());
    const auto again = tracer.trace(curve.start, curve.direction, parameters::target_vertex(v));
    const auto back = tracer.trace(Start::at_vertex(point.halfedge()),
                                   IL::reversed(point.direction()),
                                   parameters::target_vertex(mesh.target(curve.start.halfedge)));
    if(again.status != Status::TARGET || back.status != Status::TARGET)
      return false;
  }
  return true;
}

// A curve that meets a vertex fulfils the connection to it along the edges that it crosses.
void test_face_paths(const Mesh& mesh, const UV_map& uv,
                     const std::vector<IL::Isocurve<Mesh> >& curves)
{
  std::vector<IL::Connection_constraint<Mesh> > connections;
  std::vector<IL::Cycle_constraint<Mesh> > cycles;
  for(const auto& curve : curves) {
    if(curve.status == Status::CLOSED)
      cycles.push_back(IL::cycle_along_isocurve(mesh, curve));
    else if(curve.points.back().place() == Place::VERTEX)
      connections.push_back(IL::connection_along_isocurve(mesh, curve));
  }
  CHECK(IL::is_seamless(mesh, uv, parameters::connection_constraints(connections)
                                             .cycle_constraints(cycles)));
}

// --- segments ------------------------------------------------------------------------------------

using Segment = IL::Isocurve_segment<Mesh>;

// Whether a segment and a point of the curve, which it ends at, agree.
bool ends_at(const Segment& segment, const IL::Isocurve_point<Mesh>& point, const Mesh& mesh,
             const UV_map& uv)
{
  if(segment.exit_place() != point.place() || segment.exit() != point.halfedge() ||
     segment.direction() != point.direction() ||
     segment.constant_coordinate() != point.constant_coordinate())
    return false;
  const int r = int(segment.direction()) % 2 == 0 ? 0 : 1;
  const auto a = uv[mesh.prev(point.halfedge())], b = uv[point.halfedge()];
  const Exact_rational t(
    point.place() == Place::EDGE ? IL::isocurve_parameter(point, mesh, uv) : Exact_rational(1));
  return segment.to() ==
         Exact_rational(a[r]) + t * (Exact_rational(b[r]) - Exact_rational(a[r]));
}

// Whether two segments follow each other: the same point of the mesh, seen from both.
bool are_linked(const Segment& a, const Segment& b, const Mesh& mesh)
{
  if(a.exit_place() != b.entry_place() || a.length_after() != b.length_before())
    return false;
  return a.exit_place() == Place::VERTEX ? mesh.target(a.exit()) == mesh.target(b.entry())
                                         : mesh.opposite(a.exit()) == b.entry();
}

// Whether two segments at a vertex take the same way: one face, or one edge, of which they may see
// both sides.
bool take_the_same_way(const Segment& a, const Segment& b, const Mesh& mesh)
{
  if(a.is_along_edge() != b.is_along_edge())
    return false;
  return a.is_along_edge() ? mesh.edge(a.edge_halfedge()) == mesh.edge(b.edge_halfedge())
                           : a.face() == b.face();
}

// At a vertex that a curve passes, as many curves leave to its left as to its right, if there is no
// border; and the one that leads back takes the same way.
bool goes_straight_on(const Segment& a, const Segment& b, const Tracer& tracer, const Mesh& mesh)
{
  const Vertex v = mesh.target(a.exit());
  const auto outgoing = tracer.outgoing(v);
  std::vector<Segment> first;
  for(const auto& [start, direction] : outgoing)
    for(const Segment& segment : IL::isocurve_segments(tracer, start, direction)) {
      first.push_back(segment);
      break;
    }
  const std::size_t n = outgoing.size(), back = IL::outgoing_index(tracer, a);
  if(first.size() != n || back >= n || !take_the_same_way(a, first[back], mesh))
    return false;
  bool found = false;
  for(std::size_t i = 0; i < n; ++i)
    if(take_the_same_way(b, first[i], mesh) && i != back &&
       (CGAL::is_border(v, mesh) || (back + n / 2) % n == i))
      found = true;
  return found;
}

// The segments of a curve are what its points say, and exact lengths add up.
bool has_good_segments(const Curve& curve, const Tracer& tracer, const Mesh& mesh,
                       const UV_map& uv)
{
  IL::Isocurve_walker<Mesh> walker(tracer, curve.start, curve.direction);
  std::vector<Segment> segments;
  Exact_rational length(0);
  while(walker.status() == Status::CONTINUES && segments.size() + 1 < curve.points.size() &&
        IL::Isocurve_walker<Mesh>(walker).advance() == Status::CONTINUES) { // of a copy
    walker.advance();
    const Segment& segment = segments.emplace_back(walker.segment());
    const int sign = int(segment.direction()) < 2 ? 1 : -1;
    if(segment.length_before() != length ||
       !ends_at(segment, curve.points[segments.size()], mesh, uv))
      return false;
    length += sign * (segment.to() - segment.from());
    if(segment.length_after() != length)
      return false;
    if(segments.size() == 1)
      continue;
    const Segment& before = segments[segments.size() - 2];
    if(!are_linked(before, segment, mesh) ||
       (before.exit_place() == Place::VERTEX && !goes_straight_on(before, segment, tracer, mesh)))
      return false;
  }
  std::size_t number = 0;
  for(const Segment& segment : IL::isocurve_segments(tracer, curve.start, curve.direction,
                                                       curve.points.size() - 1))
    number += segment.length_after() == segments[number].length_after() ? 1 : 0;
  const bool is_bounded = curve.status == Status::MAXIMUM_NUMBER;
  return number == segments.size() && segments.size() + 1 == curve.points.size() &&
         (is_bounded || walker.advance() == curve.status);
}

void test_segments(const Mesh& mesh, const UV_map& uv, const Tracer& tracer)
{
  const auto limit = parameters::maximum_number(60);
  std::size_t bad = 0;
  for(const auto v : mesh.vertices())
    for(const auto& [start, direction] : tracer.outgoing(v))
      bad += has_good_segments(tracer.trace(start, direction, limit), tracer, mesh, uv) ? 0 : 1;
  CHECK_EQUAL(bad, std::size_t(0));
}

// --- synthetic meshes ----------------------------------------------------------------------------

void test_synthetic_meshes()
{
  for(const bool warped : {false, true})
    for(auto& named : test_meshes::all_meshes<Kernel>()) {
      if(warped)
        test_meshes::warp(named, 3);
      const Mesh& mesh = named.mesh;
      const UV_map uv = test_meshes::uv_map(named.mesh);
      const Tracer tracer(mesh, uv);
      CHECK(tracer.is_exact());
      Counts ends;
      std::size_t bad = 0, missed = 0;
      std::vector<IL::Isocurve<Mesh> > curves;
      for(const auto v : mesh.vertices())
        for(const auto& [start, direction] : tracer.outgoing(v)) {
          const auto& curve = curves.emplace_back(tracer.trace(start, direction));
          ++ends[curve.status];
          bad += is_good(tracer, curve, mesh, uv) ? 0 : 1;
          missed += hits_its_vertices(tracer, curve, mesh) ? 0 : 1;
        }
      if(!CHECK_EQUAL(bad + missed, std::size_t(0)))
        std::cerr << "  in " << named.name << (warped ? ", warped: " : ": ") << ends << std::endl;
      // unwarped, all curves follow the squares: they close where nothing is in the way
      CHECK(warped || ends[Status::MAXIMUM_NUMBER] == 0);
      test_numbers_of_directions(mesh, uv, tracer);
      test_other_starts(mesh, uv, tracer, 100);
      test_segments(mesh, uv, tracer);
      test_face_paths(mesh, uv, curves);
      test_threads(mesh, uv);
    }
}

// --- data structures -----------------------------------------------------------------------------

// Coordinates of type float give the same curves.
void test_floats()
{
  using Float_kernel = CGAL::Simple_cartesian<float>;
  auto doubles = test_meshes::all_meshes<Kernel>();
  auto floats = test_meshes::all_meshes<Float_kernel>();
  for(std::size_t i = 0; i < doubles.size(); ++i) {
    const Tracer tracer(doubles[i].mesh, test_meshes::uv_map(doubles[i].mesh));
    const IL::Isocurve_tracer<CGAL::Surface_mesh<Float_kernel::Point_3> > other(
      floats[i].mesh, test_meshes::uv_map(floats[i].mesh));
    const auto a = tracer.separatrices();
    const auto b = other.separatrices();
    CHECK_EQUAL(a.size(), b.size());
    for(std::size_t j = 0; j < (std::min)(a.size(), b.size()); ++j)
      CHECK(a[j].status == b[j].status && a[j].points.size() == b[j].points.size());
  }
}

// Another data structure, whose halfedges come in another order, gives the same curves.
void test_polyhedron(const test_meshes::Named_mesh<Kernel>& named)
{
  Mesh mesh = named.mesh;
  test_meshes::Polyhedron_copy<Kernel> copy(mesh);
  const auto summary = [](const auto& curves) {
    std::multimap<std::size_t, Status> result;
    for(const auto& curve : curves)
      result.emplace(curve.points.size(), curve.status);
    return std::vector<std::pair<std::size_t, Status> >(result.begin(), result.end());
  };
  const Tracer tracer(mesh, test_meshes::uv_map(mesh));
  const IL::Isocurve_tracer<decltype(copy.polyhedron)> other(copy.polyhedron, copy.uv);
  CHECK_EQUAL(tracer.separatrices().size(), other.separatrices().size());
  auto a = summary(tracer.separatrices()), b = summary(other.separatrices());
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  CHECK(a == b);
}

// --- parametrizations that solvers made ----------------------------------------------------------

void test_file(const std::filesystem::path& path, Counts& naive, Counts& exact,
               std::size_t& curves_in_folds)
{
  Mesh mesh;
  UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  if(!CHECK(IL::IO::read_OBJ(path.string(), mesh, uv)))
    return;
  const auto limit = parameters::maximum_number(2000);
  for(const auto& curve : Tracer(mesh, uv).separatrices(limit.decide_exactly(false)))
    ++naive[curve.status];
  CHECK(IL::snap_to_seamless(mesh, uv));
  const Tracer tracer(mesh, uv);
  const auto curves = tracer.separatrices(limit);
  std::size_t bad = 0, number = 0;
  for(const auto& curve : curves) {
    ++exact[curve.status];
    bad += curve.status == Status::SINGULAR_VERTEX || curve.status == Status::BORDER ||
           curve.status == Status::MAXIMUM_NUMBER ? 0 : 1;
    if(curve.points.size() <= 2000 && ++number <= 20)
      bad += is_symmetric(tracer, curve, mesh, uv) ? 0 : 1;
    else if(number++ <= 20)
      bad += is_good(tracer, tracer.trace(curve.start, curve.direction,
                                          parameters::maximum_number(300)), mesh, uv) ? 0 : 1;
  }
  if(!CHECK_EQUAL(bad, std::size_t(0)))
    std::cerr << "  in " << path << std::endl;
  test_numbers_of_directions(mesh, uv, tracer);
  test_order_of_directions(mesh, uv, tracer);
  curves_in_folds += test_order_in_folds(mesh, uv);
  test_other_starts(mesh, uv, tracer, 20);
  test_threads(mesh, uv);
}

void test_files(const std::vector<std::filesystem::path>& files)
{
  Counts naive, exact;
  std::size_t curves_in_folds = 0;
  for(const auto& file : files)
    test_file(file, naive, exact, curves_in_folds);
  CHECK(files.empty() || curves_in_folds > files.size());
  std::cout << files.size() << " files\n  in floating point: " << naive
            << "\n  snapped, exactly:  " << exact << std::endl;
}

int main()
{
  const Floating_point_traps traps; // for all functions that are called
#ifdef CGAL_LINKED_WITH_TBB
  std::cout << "with TBB" << std::endl;
#else
  std::cout << "without TBB" << std::endl;
#endif
  test_synthetic_meshes();
  test_floats();
  for(const auto& named : test_meshes::all_meshes<Kernel>())
    test_polyhedron(named);
  test_files(test_data::package_files());
  test_files(test_data::fifth_of_further_files("uv", ".obj"));
  return report_checks();
}
