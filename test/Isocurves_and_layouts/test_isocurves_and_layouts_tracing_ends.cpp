// How isocurves start and end: at bounds, at marked vertices, along edges, at degenerate faces; and
// what is refused. All assertions of CGAL are checked in this program, in each type of build.

#define CGAL_DEBUG // before any header

#include "floating_point_traps.h"
#include "test_meshes.h"
#include "tracing_checks.h"

#include <CGAL/Isocurves_and_layouts/isocurve_constraints.h>
#include <CGAL/Isocurves_and_layouts/trace_isocurve.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions_behaviour.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <iterator>
#include <set>

using namespace tracing_checks;

// Starts of all kinds, all over the mesh.
std::vector<Start> starts_on(const Mesh& mesh, const UV_map& uv)
{
  std::vector<Start> result;
  for(const auto h : mesh.halfedges()) {
    if(mesh.is_border(h))
      continue;
    const auto a = uv[mesh.prev(h)], b = uv[h], c = uv[mesh.next(h)];
    result.push_back(Start::at_vertex(h));
    result.push_back(Start::on_edge(h, Exact_rational(1) / 4));
    result.push_back(Start::in_face(h, a.x() / 4 + b.x() / 4 + c.x() / 2,
                                    a.y() / 4 + b.y() / 4 + c.y() / 2));
  }
  return result;
}

// --- bounds --------------------------------------------------------------------------------------

void test_maximum_number()
{
  Mesh mesh = test_meshes::make_mesh<Kernel>(test_meshes::disc(5, 1), 1, 1);
  const UV_map uv = test_meshes::uv_map(mesh);
  const Tracer tracer(mesh, uv);
  for(const auto v : mesh.vertices())
    for(const auto& [start, direction] : tracer.outgoing(v)) {
      const auto full = tracer.trace(start, direction);
      CHECK_EQUAL(full.status, Status::BORDER);
      for(std::size_t n = 1; n < full.number_of_crossings; ++n) {
        const auto part = tracer.trace(start, direction, parameters::maximum_number(n));
        CHECK_EQUAL(part.status, Status::MAXIMUM_NUMBER);
        CHECK_EQUAL(part.points.size(), n + 1);
      }
      const auto measured = tracer.trace(start, direction, parameters::maximum_length(1e9));
      CHECK(measured.length > 0.99 && measured.length < 5.01);
      CHECK_EQUAL(measured.length, std::round(measured.length));
      // the function for one curve gives the same
      std::vector<IL::Isocurve_point<Mesh> > points;
      const auto end = IL::trace_isocurve(mesh, uv, start, direction, std::back_inserter(points));
      CHECK_EQUAL(end.status, full.status);
      CHECK_EQUAL(points.size(), full.points.size());
    }
}

// A curve ends at the first point that is as far along it as the bound, which it still reports; a
// target there counts first.
void test_maximum_length()
{
  auto all = test_meshes::all_meshes<Kernel>();
  test_meshes::warp(all.front(), 3);
  const Mesh& mesh = all.front().mesh; // one chart: lengths are differences of coordinates
  const UV_map uv = test_meshes::uv_map(all.front().mesh);
  const Tracer tracer(mesh, uv);
  std::map<Place, std::size_t> number;
  for(const Start& start : starts_on(mesh, uv))
    for(int direction = 0; direction < 4; ++direction) {
      const auto full = tracer.trace(start, Direction(direction), parameters::maximum_length(1e9));
      const std::size_t running = std::size_t(direction % 2);
      double before = 0;
      for(std::size_t i = 1; i < full.points.size(); ++i) {
        const auto& point = full.points[i];
        const double here = std::abs(IL::isocurve_uv(point, mesh, uv)[running] -
                                     IL::isocurve_uv(full.points.front(), mesh, uv)[running]);
        const auto bound = parameters::maximum_length((before + here) / 2);
        const auto part = tracer.trace(start, Direction(direction), bound);
        const bool is_last = i + 1 == full.points.size();
        CHECK_EQUAL(part.points.size(), i + 1);
        CHECK_EQUAL(part.status, is_last ? full.status : Status::MAXIMUM_LENGTH);
        CHECK(std::abs(part.length - here) < 1e-12);
        if(point.place() == Place::VERTEX)
          CHECK_EQUAL(tracer.trace(start, Direction(direction),
                                   bound.target_vertex(mesh.target(point.halfedge()))).status,
                      Status::TARGET);
        ++number[point.place()];
        before = here;
      }
    }
  CHECK(number[Place::EDGE] > 0 && number[Place::VERTEX] > 0);
}

// All closed curves of a torus are as long as one of its sides, wherever they start.
void test_closed_length()
{
  Mesh mesh = test_meshes::make_mesh<Kernel>(test_meshes::torus(4, 3), 2);
  const UV_map uv = test_meshes::uv_map(mesh);
  const Tracer tracer(mesh, uv);
  for(const Start& start : starts_on(mesh, uv))
    for(int direction = 0; direction < 4; ++direction) {
      const auto curve = tracer.trace(start, Direction(direction), parameters::maximum_length(9));
      CHECK_EQUAL(curve.status, Status::CLOSED);
      CHECK(std::abs(curve.length - 0.25 * (direction % 2 == 0 ? 4 : 3)) < 1e-12);
    }
}

// Curves end at the first vertex that is marked; the marks of no other vertices are looked at.
void test_stops()
{
  Mesh mesh = test_meshes::make_mesh<Kernel>(test_meshes::torus(4, 3), 2);
  const UV_map uv = test_meshes::uv_map(mesh);
  const Tracer tracer(mesh, uv);
  std::set<Vertex> asked;
  const auto is_stop = boost::make_function_property_map<Vertex>([&](const Vertex v) {
    asked.insert(v);
    return v.idx() % 3 == 0;
  });
  for(const bool exactly : {true, false})
    for(const auto v : mesh.vertices())
      for(const auto& [start, direction] : tracer.outgoing(v)) {
        asked.clear();
        const auto curve = tracer.trace(
          start, direction, parameters::vertex_is_constrained_map(is_stop).decide_exactly(exactly));
        std::set<Vertex> met;
        std::size_t stops = 0;
        for(std::size_t i = 1; i < curve.points.size(); ++i) {
          const auto w = mesh.target(curve.points[i].halfedge());
          stops += w.idx() % 3 == 0 ? 1 : 0;
          met.insert(w);
        }
        CHECK_EQUAL(stops, std::size_t(curve.status == Status::TARGET ? 1 : 0));
        CHECK(curve.status == Status::TARGET || curve.status == Status::CLOSED);
        CHECK(asked == met);
      }
}

// --- starts --------------------------------------------------------------------------------------

// The start is kept where the curve runs along the edge, and is where it closes.
void test_starts_along_edges()
{
  std::size_t number = 0, closed = 0;
  for(auto& named : test_meshes::all_meshes<Kernel>()) {
    const Mesh& mesh = named.mesh;
    const UV_map uv = test_meshes::uv_map(named.mesh);
    const Tracer tracer(mesh, uv);
    for(const auto h : mesh.halfedges()) {
      if(mesh.is_border(h))
        continue;
      const auto a = uv[mesh.prev(h)], b = uv[h];
      if(a.x() != b.x() && a.y() != b.y())
        continue;
      const auto p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h));
      for(const int turn : {0, 2}) {
        const auto curve = tracer.trace(Start::on_edge(h, Exact_rational(1) / 4),
                                        Direction(turn + (a.x() == b.x() ? 1 : 0)));
        ++number;
        const auto& first = curve.points.front();
        const auto x = IL::isocurve_uv(first, mesh, uv);
        CHECK(x[0] == a.x() + (b.x() - a.x()) / 4 && x[1] == a.y() + (b.y() - a.y()) / 4);
        CHECK(IL::isocurve_point_3(first, mesh, uv, mesh.points()) == p + 0.25 * (q - p));
        CHECK(IL::isocurve_parameter(first, mesh, uv) == Exact_rational(1) / 4);
        CHECK(is_good(tracer, curve, mesh, uv));
        if(curve.status == Status::CLOSED) {
          ++closed;
          CHECK(curve.points.back().place() == Place::EDGE && curve.points.back().halfedge() == h);
        }
      }
    }
  }
  CHECK(number > 0 && closed > 0);
}

// Where a coordinate is constant on all faces around a vertex, no isocurve leaves it.
void test_constant_coordinate()
{
  Mesh mesh = test_meshes::make_mesh<Kernel>(test_meshes::disc(3, 3), 1);
  const UV_map uv = test_meshes::uv_map(mesh);
  for(const auto h : mesh.halfedges())
    uv[h] = Kernel::Point_2(uv[h].x(), 0);
  const Tracer tracer(mesh, uv);
  CHECK(tracer.is_exact());
  for(const auto h : mesh.halfedges()) {
    if(mesh.is_border(h))
      continue;
    const auto from_vertex = tracer.trace(Start::at_vertex(h), Direction::PLUS_U);
    CHECK_EQUAL(from_vertex.status, CGAL::is_border(mesh.target(h), mesh)
                                      ? Status::BORDER : Status::CONSTANT_ON_FACE);
    const auto from_edge = tracer.trace(Start::on_edge(h, Exact_rational(1) / 2),
                                        Direction::PLUS_U);
    CHECK_EQUAL(from_edge.status, Status::CONSTANT_ON_FACE);
    CHECK_EQUAL(from_vertex.points.size() + from_edge.points.size(), std::size_t(2));
  }
}

// --- edges of no length --------------------------------------------------------------------------

// Moves a vertex that lies in a single chart to the next one along an edge. Where it lies on a cut,
// returns `false`.
bool contract(const Mesh& mesh, const UV_map uv, const IL::Seam_transitions<Mesh>& seams,
              const Mesh::Halfedge_index h)
{
  const auto g = mesh.opposite(h);
  if(CGAL::is_border(mesh.source(h), mesh))
    return false;
  for(const auto corner : CGAL::halfedges_around_target(g, mesh))
    if(seams.is_cut(corner))
      return false;
  for(const auto corner : CGAL::halfedges_around_target(g, mesh))
    uv[corner] = uv[h];
  return true;
}

// Whether the curve runs along the edge of a halfedge.
bool runs_along(const Mesh& mesh, const Curve& curve, const Mesh::Halfedge_index h)
{
  const auto is_vertex = [&](const auto& point, const Vertex v)
  { return point.place() == Place::VERTEX && mesh.target(point.halfedge()) == v; };
  for(std::size_t i = 1; i < curve.points.size(); ++i)
    for(const auto& side : {h, mesh.opposite(h)})
      if(is_vertex(curve.points[i - 1], mesh.source(side)) &&
         is_vertex(curve.points[i], mesh.target(side)))
        return true;
  return false;
}

// An edge without length in the domain makes no vertex singular or regular; but one of 720 degrees
// at its end is no longer told from a regular one. Curves run along it, in both directions, or end
// where a coordinate is constant on its faces.
void test_contracted_edges()
{
  std::size_t number = 0, singular = 0;
  Counts ends_along_edge;
  for(auto& named : test_meshes::all_meshes<Kernel>()) {
    const Mesh& mesh = named.mesh;
    const UV_map uv = test_meshes::uv_map(named.mesh);
    const Tracer before(mesh, uv);
    const auto seams = IL::seam_transitions(mesh, uv);
    std::set<Vertex> rotating;
    for(const auto& [v, index] : seams.singular_vertices())
      if(index % 4 != 0)
        rotating.insert(v);
    for(const auto h : mesh.halfedges()) {
      std::vector<Kernel::Point_2> kept;
      for(const auto g : mesh.halfedges())
        kept.push_back(uv[g]);
      if(mesh.is_border(h) || !contract(mesh, uv, seams, h))
        continue;
      const Tracer after(mesh, uv);
      if(!CHECK(after.is_exact()))
        return;
      std::size_t wrong = 0;
      for(const auto v : mesh.vertices()) {
        const bool is_end = v == mesh.source(h) || v == mesh.target(h);
        const bool expected = is_end ? rotating.count(v) != 0 : before.is_singular(v);
        wrong += after.is_singular(v) != expected ? 1 : 0;
      }
      for(const auto v : {mesh.source(h), mesh.target(h)})
        for(const auto& [start, direction] : after.outgoing(v)) {
          const auto curve = after.trace(start, direction);
          wrong += IL::is_failure(curve.status) || !is_symmetric(after, curve, mesh, uv) ? 1 : 0;
          if(runs_along(mesh, curve, h))
            ++ends_along_edge[curve.status];
        }
      if(!CHECK_EQUAL(wrong, std::size_t(0)))
        std::cerr << "  in " << named.name << std::endl;
      singular += before.is_singular(mesh.target(h)) ? 1 : 0;
      ++number;
      for(const auto g : mesh.halfedges())
        uv[g] = kept[std::size_t(g)];
    }
  }
  CHECK(number > 0 && singular > 0);
  for(const Status status : {Status::CLOSED, Status::SINGULAR_VERTEX, Status::BORDER})
    CHECK(ends_along_edge[status] > 0);
}

// --- border vertices -----------------------------------------------------------------------------

// At the end of a slit, a border vertex of 360 degrees, curves end that have two straight
// continuations, along both sides of the slit, or come from there; others go on.
void test_slit()
{
  // the squares of a grid around its center, slit from there to the right
  constexpr int n = 2;
  Mesh mesh;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  std::map<std::array<int, 3>, Vertex> vertex; // and the side of the slit
  const auto at = [&](const int i, const int j, const int k) {
    const int side = j == 0 && i > 0 ? k : 0;
    const auto found = vertex.find({i, j, side});
    return found != vertex.end() ? found->second
                                 : vertex[{i, j, side}] = mesh.add_vertex(Kernel::Point_3(i, j, 0));
  };
  for(int i = -n; i < n; ++i)
    for(int j = -n; j < n; ++j) {
      const int k = j < 0 ? 1 : 0;
      mesh.add_face(at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k));
      mesh.add_face(at(i, j, k), at(i + 1, j + 1, k), at(i, j + 1, k));
    }
  for(const auto h : mesh.halfedges())
    uv[h] = Kernel::Point_2(mesh.point(mesh.target(h)).x(), mesh.point(mesh.target(h)).y());
  const Tracer tracer(mesh, uv);
  CHECK(tracer.is_exact());
  const Vertex center = vertex[{0, 0, 0}];
  CHECK_EQUAL(tracer.outgoing(center).size(), std::size_t(5)); // both sides of the slit
  const auto number_of_ends = [&](const Vertex v) {
    std::size_t number = 0;
    for(const auto& [start, direction] : tracer.outgoing(v)) {
      const auto curve = tracer.trace(start, direction);
      const bool ends_at_center = mesh.target(curve.points.back().halfedge()) == center;
      CHECK_EQUAL(curve.status, ends_at_center ? Status::SINGULAR_VERTEX : Status::BORDER);
      number += ends_at_center ? 1 : 0;
    }
    return number;
  };
  for(const Vertex v : {vertex[{-1, 0, 0}], vertex[{1, 0, 0}], vertex[{1, 0, 1}]})
    CHECK_EQUAL(number_of_ends(v), std::size_t(1));
  for(const Vertex v : {vertex[{0, 1, 0}], vertex[{0, -1, 0}], vertex[{1, 1, 0}]})
    CHECK_EQUAL(number_of_ends(v), std::size_t(0));
}

bool is_strictly_inside(const Kernel::Point_2& p, const Kernel::Point_2& a,
                        const Kernel::Point_2& b, const Kernel::Point_2& c)
{
  return CGAL::left_turn(a, b, p) && CGAL::left_turn(b, c, p) && CGAL::left_turn(c, a, p);
}

// --- loops ---------------------------------------------------------------------------------------

// A loop has as many crossings in both directions and from any of its points, and exactly as many
// as edges and vertices.
void test_number_of_crossings()
{
  std::size_t number = 0;
  for(auto& named : test_meshes::all_meshes<Kernel>()) {
    const Mesh& mesh = named.mesh;
    const UV_map uv = test_meshes::uv_map(named.mesh);
    const Tracer tracer(mesh, uv);
    for(const auto h : mesh.halfedges()) {
      if(mesh.is_border(h))
        continue;
      // on isocurves through vertices, and between them
      const auto a = uv[mesh.prev(h)], b = uv[h], c = uv[mesh.next(h)];
      for(const Start& start :
          {Start::in_face(h, b.x(), (a.y() + c.y()) / 2),
           Start::in_face(h, (a.x() + c.x()) / 2, b.y()),
           Start::in_face(h, (a.x() + b.x() + 2 * c.x()) / 4, (a.y() + b.y() + 2 * c.y()) / 4),
           Start::on_edge(h, Exact_rational(1) / 2), Start::at_vertex(h)}) {
        if(start.place == Place::FACE &&
           !is_strictly_inside(Kernel::Point_2(start.uv[0], start.uv[1]), a, b, c))
          continue;
        for(int direction = 0; direction < 2; ++direction) {
          const auto there = tracer.trace(start, Direction(direction));
          if(there.status != Status::CLOSED)
            continue;
          const auto back = tracer.trace(start_at(there.points.front(), mesh, uv),
                                         IL::reversed(there.points.front().direction()));
          ++number;
          CHECK_EQUAL(back.status, Status::CLOSED);
          CHECK_EQUAL(back.number_of_crossings, there.number_of_crossings);
          const std::size_t on_face = start.place == Place::FACE ? 1 : 0;
          const std::size_t on_edge = starts_along_edge(there, mesh, uv) ? 1 : 0;
          CHECK_EQUAL(there.number_of_crossings, there.points.size() - 1 - on_face - on_edge);
        }
      }
    }
  }
  CHECK(number > 0);
}

// --- refusals ------------------------------------------------------------------------------------

template <typename Function>
bool is_refused(const Function& function)
{
  try {
    function();
  } catch(const CGAL::Precondition_exception&) {
    return true;
  }
  return false;
}

void test_preconditions()
{
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) { });
  Mesh mesh = test_meshes::make_mesh<Kernel>(test_meshes::disc(3, 3), 1);
  const UV_map uv = test_meshes::uv_map(mesh);
  const Tracer tracer(mesh, uv);
  const auto trace = [&](const Start& start)
  { return is_refused([&] { tracer.trace(start, Direction::PLUS_U); }); };
  Mesh::Halfedge_index border, inner;
  for(const auto h : mesh.halfedges())
    (mesh.is_border(h) ? border : inner) = h;
  CHECK(!trace(Start::at_vertex(inner)) && trace(Start::at_vertex(border)));
  CHECK(trace(Start::in_face(border, 0, 0)) && trace(Start::in_face(inner, 100, 100)));
  CHECK(trace(Start::on_edge(border, Exact_rational(1) / 2)));
  CHECK(!trace(Start::on_edge(inner, Exact_rational(1) / 2)));
  for(const int t : {-1, 0, 1, 2})
    CHECK(trace(Start::on_edge(inner, Exact_rational(t))));

  const auto curve = tracer.trace(Start::at_vertex(inner), Direction::PLUS_U);
  Curve without_points = curve;
  without_points.points.clear();
  CHECK(!is_refused([&] { IL::connection_along_isocurve(mesh, curve); }));
  CHECK(is_refused([&] { IL::connection_along_isocurve(mesh, without_points); }));
  CHECK(is_refused([&] { IL::cycle_along_isocurve(mesh, without_points); }));

  for(const auto h : mesh.halfedges())
    uv[h] = Kernel::Point_2(double(h.idx() * h.idx() % 17), double(h.idx() % 5));
  const Tracer invalid(mesh, uv);
  CHECK(!invalid && !invalid.is_exact());
  CHECK(is_refused([&] { invalid.is_singular(Vertex(0)); }));
  CHECK(is_refused([&] { invalid.outgoing(Vertex(0)); }));
}

// On maps that are not exact, or not seamless at all, curves are refused by their status.
void test_inexact_maps()
{
  Mesh mesh = test_meshes::make_mesh<Kernel>(test_meshes::box(1, 1, 1), 2);
  const UV_map uv = test_meshes::uv_map(mesh);
  const auto is_refusal = [](const std::vector<Curve>& curves) {
    return curves.size() == 1 && curves.front().status == Status::NOT_EXACT &&
           curves.front().points.empty();
  };
  CHECK(IL::is_failure(Status::NOT_EXACT));
  const auto check = [&](const bool is_seamless) {
    const Tracer tracer(mesh, uv);
    CHECK(bool(tracer) == is_seamless && !tracer.is_exact());
    const Start start = Start::at_vertex(mesh.halfedge(Vertex(0)));
    const auto naive = parameters::decide_exactly(false);
    CHECK(is_refusal(tracer.separatrices()));
    CHECK(is_refusal({tracer.trace(start, Direction::PLUS_U)}));
    CHECK(is_refusal({tracer.trace(start, Direction::PLUS_U, naive)}) == !is_seamless);
    CHECK(is_refusal(tracer.separatrices(naive)) == !is_seamless);
    std::vector<Curve> curves;
    IL::trace_all_separatrices(mesh, uv, std::back_inserter(curves));
    CHECK(is_refusal(curves));
    std::vector<IL::Isocurve_point<Mesh> > points;
    CHECK(IL::trace_isocurve(mesh, uv, start, Direction::PLUS_U,
                             std::back_inserter(points)).status == Status::NOT_EXACT);
    CHECK(points.empty());
  };
  uv_noise::perturb(mesh, uv, 1e-9, 1);
  check(true);
  for(const auto h : mesh.halfedges())
    uv[h] = Kernel::Point_2(double(h.idx() * h.idx() % 17), double(h.idx() % 5));
  check(false);
}

int main()
{
  const Floating_point_traps traps; // for all functions that are called
  test_maximum_number();
  test_maximum_length();
  test_closed_length();
  test_stops();
  test_starts_along_edges();
  test_constant_coordinate();
  test_contracted_edges();
  test_slit();
  test_number_of_crossings();
  test_preconditions();
  test_inexact_maps();
  return report_checks();
}
