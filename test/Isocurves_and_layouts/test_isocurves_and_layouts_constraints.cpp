// Connection, cycle, and corner constraints on surfaces: random ones on the meshes of the data
// folder, checked by composing the transitions of their paths in rational arithmetic, which shares
// no code with the library; contradictions, unreachable right-hand sides, and paths that are none.

#include "Parametrized_model.h"
#include "checking.h"
#include "exact_seamless_check.h"
#include "floating_point_traps.h"
#include "random_constraints.h"
#include "reduced_seamless_system.h"
#include "test_data.h"

#include <CGAL/Isocurves_and_layouts/isocurve_constraints.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace IL = CGAL::Isocurves_and_layouts;
namespace parameters = CGAL::Isocurves_and_layouts::parameters;

using Kernel = Parametrized_model::Kernel;
using Mesh = Parametrized_model::Mesh;
using Halfedge = Mesh::Halfedge_index;
using Connection = IL::Connection_constraint<Mesh>;
using Cycle = IL::Cycle_constraint<Mesh>;
using Corner = IL::Corner_constraint<Mesh>;
using exact_reference::Rational;

// Random paths ask for large changes.
constexpr double any_distance = std::numeric_limits<double>::infinity();

struct Model : Parametrized_model
{
  IL::Seam_transitions<Mesh> transitions = IL::seam_transitions(mesh, uv); // before snapping
  std::vector<Mesh::Vertex_index> singular;

  explicit Model(const std::string& filename) : Parametrized_model(filename)
  {
    if(!CHECK(bool(status)))
      std::cerr << filename << ": " << status << std::endl;
    for(const auto& vertex : transitions.singular_vertices())
      singular.push_back(vertex.first);
  }

  bool has_cut_of_no_length() const
  {
    const auto& cuts = transitions.cut_halfedges();
    return std::any_of(cuts.begin(), cuts.end(),
                       [&](Halfedge h) { return uv[h] == uv[mesh.prev(h)]; });
  }
};

// What holds already.
template <typename NamedParameters>
void check_left_alone(Model& model, const NamedParameters& np)
{
  CHECK(IL::is_seamless(model.mesh, model.uv, np));
  const auto values = model.values();
  CHECK(IL::snap_to_seamless(model.mesh, model.uv, np).status ==
        IL::Outcome::ALREADY_EXACT);
  CHECK(model.values() == values);
}

// --- tests ---------------------------------------------------------------------------------------

void test_random_constraints(const std::filesystem::path& path, std::uint64_t seed,
                             std::size_t connections, std::size_t cycles)
{
  const std::string name = path.stem().string();
  Model model(path.string());
  random_constraints::Generator<Mesh> random(model.mesh, model.transitions, seed);
  const std::vector<Connection> connection_constraints = random.connections(connections);
  const std::vector<Cycle> cycle_constraints = random.cycles(cycles);
  const auto np = parameters::connection_constraints(connection_constraints)
                             .cycle_constraints(cycle_constraints)
                             .connection_tolerance(any_distance)
                             .edge_is_constrained_map(model.is_aligned);
  const IL::Snapping_report report = IL::snap_to_seamless(model.mesh, model.uv, np);
  if(!CHECK(bool(report)))
    std::cerr << name << ", seed " << seed << ": " << report << std::endl;
  const auto check = exact_check::check_edges(
      model.mesh, model.uv, [&](Mesh::Edge_index e) { return model.is_aligned[e]; });
  CHECK_EQUAL(check.inexact_edges, 0u);
  CHECK_EQUAL(check.inexact_aligned_edges, 0u);
  for(const Connection& c : connection_constraints)
    CHECK(random_constraints::is_connected(model.mesh, model.uv, model.transitions, c));
  for(const Cycle& c : cycle_constraints)
    CHECK(random_constraints::is_connected(model.mesh, model.uv, model.transitions, c));
  auto rotations = model.mesh.add_property_map<Halfedge, int>("h:rotation", 0).first;
  for(const Halfedge h : model.mesh.halfedges())
    rotations[h] = model.transitions.rotation(h);
  check_left_alone(model, np.halfedge_rotation_map(rotations));
  // Constraints may collapse cuts: their rotations are those of the rest of the branch, if any.
  const bool is_seamless = IL::is_seamless(model.mesh, model.uv, np);
  CHECK(is_seamless || model.has_cut_of_no_length());
  CHECK_EQUAL(is_seamless, IL::snap_to_seamless(model.mesh, model.uv, np).status
                             == IL::Outcome::ALREADY_EXACT);
  std::cout << name << ", seed " << seed << ": largest change "
            << report.largest_change / report.extent << " of the extent, redundant "
            << report.linear_solver.number_of_redundant_constraints << ", non-unit pivots "
            << report.linear_solver.number_of_non_unit_pivots << std::endl;
}

// Parametrizations made by solvers, as many constraints on each as in Table 3.
void test_files()
{
  for(const std::filesystem::path& path : test_data::fifth_of_further_files("uv", ".obj"))
    test_random_constraints(path, 1, 100, 10);
}

double rounded_to_sixteenths(double x)
{
  return std::round(16 * x) / 16;
}

void check_refused(Model& model, const std::vector<Corner>& constraints, IL::Outcome status,
                   const std::string& message)
{
  const auto values = model.values();
  const IL::Snapping_report report =
    IL::snap_to_seamless(model.mesh, model.uv, parameters::corner_constraints(constraints));
  CHECK_EQUAL(IL::to_string(report.status), std::string(IL::to_string(status)));
  if(!CHECK(report.message.find(message) != std::string::npos))
    std::cerr << report.message << std::endl;
  CHECK(model.values() == values);
}

Corner
pin(Halfedge corner, int component, const Rational& value, const Rational& factor = Rational(1))
{
  Corner result;
  result.terms.push_back({ corner, component, factor });
  result.right_hand_side = value;
  return result;
}

void test_corner_constraints(const std::string& name)
{
  Model model(test_data::package_file(name));
  const Halfedge a = model.mesh.halfedge(model.singular[0]),
                 b = model.mesh.halfedge(model.singular[1]);
  const double at_a = rounded_to_sixteenths(model.uv[a].x());
  const Corner pin_a = pin(a, 0, Rational(at_a));
  // twice the spacing of b from a is a multiple of 1/8, whatever the chart
  Corner spacing =
      pin(b, 1, Rational(rounded_to_sixteenths(model.uv[b].y() - model.uv[a].y()) * 2), 2);
  spacing.terms.push_back({ a, 1, Rational(-2) });

  Corner contradiction = pin_a;
  contradiction.right_hand_side += 1;
  check_refused(model, { pin_a, spacing, contradiction }, IL::Outcome::INCONSISTENT,
                "corner constraint 0, corner constraint 2");
  check_refused(model, {pin(b, 1, Rational(1), Rational(3))},
                IL::Outcome::NOT_REPRESENTABLE, "right-hand sides");
  check_refused(model, {pin(a, 2, Rational(0))}, IL::Outcome::INVALID_ARGUMENT,
                "component 2");

  const std::vector<Corner> constraints = { pin_a, spacing, pin_a };
  const auto np = parameters::corner_constraints(constraints);
  const IL::Snapping_report report = IL::snap_to_seamless(model.mesh, model.uv, np);
  if(!CHECK(bool(report)))
    std::cerr << name << ": " << report << std::endl;
  CHECK(exact_check::check_edges(model.mesh, model.uv).is_exact());
  CHECK_EQUAL(model.uv[a].x(), at_a);
  CHECK(Rational(Rational(2) * exact_check::exact_difference(model.uv[b], model.uv[a])[1]) ==
        spacing.right_hand_side);
  CHECK(IL::is_seamless(model.mesh, model.uv, np));
  CHECK(!IL::is_seamless(model.mesh, model.uv,
                         parameters::corner_constraints(std::vector<Corner>(1, contradiction))));
}

// How u|component changes along a closed path without rotation, or 0 if the path turns it.
double drift(const Model& model, const std::vector<Halfedge>& path, Halfedge corner, int component)
{
  exact_check::Exact_vector u = { Rational(model.uv[corner].x()), Rational(model.uv[corner].y()) };
  exact_check::Exact_vector direction = { Rational(1), Rational(0) };
  for(const Halfedge h : path)
    random_constraints::cross(h, model.mesh, model.uv, model.transitions.rotation(h), u, direction);
  if(direction[0] != 1)
    return 0;
  const double before = component == 0 ? model.uv[corner].x() : model.uv[corner].y();
  return CGAL::to_double(u[std::size_t(component)]) - before;
}

// An aligned edge from q to p, a cycle at p, a connection along the same path from q to the third
// corner r, and p - r = 1: no three of these contradict each other.
void test_contradiction(const std::string& name, std::uint64_t seed)
{
  Model model(test_data::package_file(name));
  random_constraints::Generator<Mesh> random(model.mesh, model.transitions, seed);
  Halfedge p;
  for(const Mesh::Edge_index e : model.mesh.edges())
    if(model.is_aligned[e])
      p = model.mesh.halfedge(e);
  p = model.mesh.is_border(p) ? model.mesh.opposite(p) : p;
  const Halfedge q = model.mesh.prev(p), r = model.mesh.next(p);
  const Kernel::Vector_2 d = model.uv[p] - model.uv[q];
  const int component = std::abs(d.x()) < std::abs(d.y()) ? 0 : 1;

  std::vector<Halfedge> loop;
  for(int i = 0; i < 1000 && std::abs(drift(model, loop, p, component)) < 0.01; ++i) {
    const Cycle cycle = random.cycle();
    loop = IL::shortest_face_path(model.mesh, p, cycle.corner);
    const auto back = IL::shortest_face_path(model.mesh, cycle.corner, p);
    loop.insert(loop.end(), cycle.path.begin(), cycle.path.end());
    loop.insert(loop.end(), back.begin(), back.end());
  }
  CHECK(std::abs(drift(model, loop, p, component)) >= 0.01);
  const std::vector<Connection> connections = { { q, r, component, loop } };
  const std::vector<Cycle> cycles = { { p, component, loop } };
  Corner difference = pin(p, component, Rational(1));
  difference.terms.push_back({ r, component, Rational(-1) });
  const std::vector<Corner> corners = { difference };

  const auto np = parameters::edge_is_constrained_map(model.is_aligned)
                             .connection_constraints(connections)
                             .cycle_constraints(cycles)
                             .connection_tolerance(any_distance)
                             .corner_constraints(corners);
  const auto values = model.values();
  const auto reduced = reduced_system::reduced_seamless_system(model.mesh, model.uv, np);
  const IL::Snapping_report report = IL::snap_to_seamless(model.mesh, model.uv, np);
  CHECK(report.status == IL::Outcome::INCONSISTENT);
  CHECK(exact_reference::is_contradiction(reduced.system, report.certificate));
  for(const std::string constraint : { "connection constraint 0", "cycle constraint 0",
                                       "corner constraint 0", "the alignment of " })
    if(!CHECK(report.message.find(constraint) != std::string::npos))
      std::cerr << report << std::endl;
  CHECK(model.values() == values);

  // Each three of them have a solution.
  for(std::size_t left_out = 0; left_out < 4; ++left_out) {
    Model three(test_data::package_file(name));
    if(left_out == 3)
      for(const Mesh::Edge_index e : three.mesh.edges())
        three.is_aligned[e] = false;
    CHECK(bool(IL::snap_to_seamless(
      three.mesh, three.uv,
      parameters::edge_is_constrained_map(three.is_aligned)
                 .connection_constraints(left_out == 0 ? std::vector<Connection>() : connections)
                 .cycle_constraints(left_out == 1 ? std::vector<Cycle>() : cycles)
                 .connection_tolerance(any_distance)
                 .corner_constraints(left_out == 2 ? std::vector<Corner>() : corners))));
  }
}

void test_invalid_paths(const std::string& name)
{
  Model model(test_data::package_file(name));
  random_constraints::Generator<Mesh> random(model.mesh, model.transitions, 1);
  Connection good = random.connection();
  while(good.path.size() < 4)
    good = random.connection();
  std::vector<Connection> bad(4, good);
  std::swap(bad[0].path[1], bad[0].path[2]);
  bad[1].path.pop_back();
  bad[2].a = Mesh::null_halfedge();
  bad[3].path[1] = Mesh::null_halfedge();
  const std::string messages[4] = { "step 1 of the path of connection constraint 0",
                                    "does not end in the face", "a corner that is not in a face",
                                    "is a null halfedge" };
  const auto values = model.values();
  for(std::size_t i = 0; i < bad.size(); ++i) {
    const std::vector<Connection> constraints(1, bad[i]);
    const IL::Snapping_report report =
      IL::snap_to_seamless(model.mesh, model.uv, parameters::connection_constraints(constraints));
    CHECK_EQUAL(IL::to_string(report.status), std::string("invalid argument"));
    if(!CHECK(report.message.find(messages[i]) != std::string::npos))
      std::cerr << report.message << std::endl;
    CHECK(model.values() == values);
  }
}

// Halfedges without a face begin and end no path.
void test_paths_on_border(const std::string& name)
{
  Model model(test_data::package_file(name));
  std::size_t count = 0;
  for(const Halfedge h : model.mesh.halfedges()) {
    if(!model.mesh.is_border(h))
      continue;
    const Halfedge inner = model.mesh.opposite(h);
    for(const auto& ends :
        {std::make_pair(h, inner), std::make_pair(inner, h), std::make_pair(h, h)})
      CHECK(IL::shortest_face_path(model.mesh, ends.first, ends.second).empty());
    ++count;
  }
  CHECK(count > 0);
}

// A pinned coordinate that only a fine grid holds concerns no others: neither the second one of the
// same corners, nor corners that are merged elsewhere.
void test_fine_pin(double value)
{
  Mesh mesh;
  CGAL::make_grid(3, 3, mesh, [](double x, double y) { return Kernel::Point_3(x, y, 0); }, true);
  auto uv = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  const double columns[4] = { -0.5, value * (1 + 1e-9), 0.7, 1 };
  Mesh::Vertex_index pinned, merged;
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    if(p.x() == 1 && p.y() == 1)
      pinned = v;
    if(p.x() == 2 && p.y() == 2)
      merged = v;
    for(const Halfedge h : CGAL::halfedges_around_target(v, mesh))
      uv[h] = Kernel::Point_2(columns[int(p.x())], p.y() / 3);
  }
  const Kernel::Point_2 before = uv[mesh.halfedge(merged)];
  uv[mesh.halfedge(merged)] = Kernel::Point_2(before.x() + 1e-12, before.y());

  const std::vector<Corner> constraints = { pin(mesh.halfedge(pinned), 0, Rational(value)) };
  const IL::Snapping_report report =
    IL::snap_to_seamless(mesh, uv, parameters::corner_constraints(constraints));
  if(!CHECK(bool(report)))
    std::cerr << value << ": " << report << std::endl;
  for(const Halfedge h : CGAL::halfedges_around_target(pinned, mesh))
    CHECK(uv[h] == Kernel::Point_2(value, 1. / 3));
  const Kernel::Point_2 after = uv[mesh.halfedge(merged)];
  CHECK(before.x() < after.x() && after.x() < before.x() + 1e-12 && after.y() == before.y());
  for(const Halfedge h : CGAL::halfedges_around_target(merged, mesh))
    CHECK(uv[h] == after);
}

// By how much a connection misses: in rational numbers, edge by edge.
double distance(const Model& model, const Connection& c)
{
  exact_check::Exact_vector u = { Rational(model.uv[c.a].x()), Rational(model.uv[c.a].y()) };
  exact_check::Exact_vector across = { Rational(1 - c.component), Rational(c.component) };
  for(const Halfedge h : c.path)
    random_constraints::cross(h, model.mesh, model.uv, model.transitions.rotation(h), u, across);
  return std::abs(CGAL::to_double(Rational(across[0] * (u[0] - Rational(model.uv[c.b].x())) +
                                           across[1] * (u[1] - Rational(model.uv[c.b].y())))));
}

// A path that is not meant is refused, with the distance by which it misses.
void test_distances(const std::string& name, std::uint64_t seed)
{
  Model model(test_data::package_file(name));
  random_constraints::Generator<Mesh> random(model.mesh, model.transitions, seed);
  Connection wrong = random.connection();
  while(distance(model, wrong) < 0.3 * model.transitions.extent())
    wrong = random.connection();
  const std::vector<Connection> connections = { random.connection(), wrong };
  const double largest = (std::max)(distance(model, connections[0]), distance(model, wrong));
  const double tolerance = largest / model.transitions.extent();
  const auto np = parameters::connection_constraints(connections);
  const auto values = model.values();
  const auto check = [&](const IL::Snapping_report& report, const bool is_refused) {
    CHECK(std::abs(report.connection_violation_before - largest) <= 1e-9 * largest);
    CHECK_EQUAL(report.status == IL::Outcome::NOT_CONNECTED, is_refused);
    CHECK_EQUAL(bool(report), !is_refused);
    if(!is_refused)
      return;
    CHECK(model.values() == values);
    const std::string worst = largest == distance(model, wrong) ? "1" : "0";
    if(!CHECK(report.message.find("connection constraint " + worst + " misses by") == 0))
      std::cerr << report << std::endl;
  };
  check(IL::snap_to_seamless(model.mesh, model.uv, np), true);
  check(IL::snap_to_seamless(model.mesh, model.uv, np.connection_tolerance(0.999 * tolerance)),
        true);
  check(IL::snap_to_seamless(model.mesh, model.uv, np.connection_tolerance(1.001 * tolerance)),
        false);
  for(const double invalid : { -1., std::numeric_limits<double>::quiet_NaN() })
    CHECK(IL::snap_to_seamless(model.mesh, model.uv, np.connection_tolerance(invalid)).status ==
          IL::Outcome::INVALID_ARGUMENT);
}

// Five by five vertices on isocurves, with a hole in the middle. Connections from the left to the
// right hold in every row. That of the third row is interrupted by the hole. The others lie beside
// the border or the hole: above or below by less than can be seen, which decides whether they are.
void test_interception(const bool is_inside)
{
  Mesh mesh;
  CGAL::make_grid(4, 4, mesh, [](double x, double y) { return Kernel::Point_3(x, y, 0); }, true);
  const auto vertex = [&](const double x, const double y) {
    for(const Mesh::Vertex_index v : mesh.vertices())
      if(mesh.point(v) == Kernel::Point_3(x, y, 0))
        return v;
    return Mesh::null_vertex();
  };
  const Halfedge center = CGAL::Euler::remove_center_vertex(mesh.halfedge(vertex(2, 2)), mesh);
  CGAL::Euler::remove_face(center, mesh);
  auto uv = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  const double inwards[5] = { 1, -1, 1, 1, -1 };
  for(const Halfedge h : mesh.halfedges()) {
    const Kernel::Point_3& p = mesh.point(mesh.target(h));
    const double noise = (is_inside ? 1e-10 : -1e-10) * inwards[int(p.y())];
    uv[h] = Kernel::Point_2(p.x(), p.x() == 4 ? p.y() + noise : p.y());
  }
  std::vector<Connection> connections;
  std::vector<std::size_t> expected;
  for(int y = 0; y < 5; ++y) {
    Halfedge ends[2] = { mesh.halfedge(vertex(0, y)), mesh.halfedge(vertex(4, y)) };
    for(Halfedge& h : ends)
      h = mesh.is_border(h) ? mesh.prev(mesh.opposite(h)) : h;
    connections.push_back({ ends[0], ends[1], 1,
                            IL::shortest_face_path(mesh, ends[0], ends[1]) });
    if(y == 2 || !is_inside)
      expected.push_back(std::size_t(y));
  }
  const auto report =
    IL::snap_to_seamless(mesh, uv, parameters::connection_constraints(connections));
  CHECK(report.status == IL::Outcome::SNAPPED);
  std::vector<std::size_t> found;
  for(const auto& connection :
      IL::intercepted_connections(IL::Isocurve_tracer(mesh, uv), connections)) {
    found.push_back(connection.index);
    CHECK_IN(connection.message,
             connection.message == "the isocurve of connection constraint " +
                                     std::to_string(connection.index) +
                                     " does not arrive at its end");
  }
  CHECK(found == expected);
}

int main()
{
  const Floating_point_traps traps; // for all functions that are called
  test_interception(true);
  test_interception(false);
  for(std::uint64_t seed = 1; seed <= 3; ++seed)
    test_distances("genus2", seed);
  test_paths_on_border("genus2_border");
  for(const double value : { 0.1, 1e-5, 1e-300 })
    test_fine_pin(value);
  for(const std::string name : { "genus0", "genus1", "genus2", "genus3", "genus0_border",
                                 "genus2_features", "genus2_features_border" })
    for(std::uint64_t seed = 1; seed <= 3; ++seed)
      test_random_constraints(test_data::package_file(name), seed, 20, 4);
  test_files();
  test_corner_constraints("genus0");
  test_corner_constraints("genus2");
  for(std::uint64_t seed = 1; seed <= 10; ++seed)
    test_contradiction("genus2_features", seed);
  test_invalid_paths("genus2");
  return report_checks();
}
