// Connection, cycle, and corner constraints on surfaces: random ones on the meshes of the data folder,
// checked by composing the transitions of their paths in rational arithmetic, which shares no code with
// the library; contradictions, unreachable right-hand sides, and paths that are none.

#include "checking.h"
#include "exact_seamless_check.h"
#include "random_constraints.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace CS = CGAL::Seamless_snapping;
namespace parameters = CGAL::Seamless_snapping::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Mesh::Halfedge_index;
using UV_map = Mesh::Property_map<Halfedge, Kernel::Point_2>;
using Connection = CS::Connection_constraint<Mesh>;
using Cycle = CS::Cycle_constraint<Mesh>;
using Corner = CS::Corner_constraint<Mesh>;
using exact_reference::Rational;

struct Model
{
  Mesh mesh;
  UV_map uv;
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature;
  std::vector<Mesh::Vertex_index> singular;

  explicit Model(const std::string& name)
    : uv(mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first),
      is_feature(mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first)
  {
    const auto status = CS::IO::read_OBJ("../../data/" + name + ".obj", mesh, uv,
                                         parameters::edge_is_constrained_map(is_feature));
    if(!CHECK(bool(status)))
      std::cerr << status << std::endl;
    const auto transitions = CS::seam_transitions(mesh, uv);
    for(const auto& vertex : transitions.singular_vertices())
      singular.push_back(vertex.first);
  }

  std::vector<Kernel::Point_2> values() const { return {uv.begin(), uv.end()}; }
};

// --- tests -----------------------------------------------------------------------------------------

void test_random_constraints(const std::string& name, std::uint64_t seed,
                             std::size_t connections, std::size_t cycles)
{
  Model model(name);
  random_constraints::Generator<Mesh> random(model.mesh, model.uv, seed);
  const std::vector<Connection> connection_constraints = random.connections(connections);
  const std::vector<Cycle> cycle_constraints = random.cycles(cycles);
  const auto np = parameters::connection_constraints(connection_constraints)
                             .cycle_constraints(cycle_constraints)
                             .edge_is_constrained_map(model.is_feature);
  const CS::Snapping_report report = CS::snap_to_seamless(model.mesh, model.uv, np);
  if(!CHECK(bool(report)))
    std::cerr << name << ", seed " << seed << ": " << report << std::endl;
  const auto check = exact_check::check_edges(model.mesh, model.uv,
                                              [&](Mesh::Edge_index e) { return model.is_feature[e]; });
  CHECK_EQUAL(check.inexact_edges, 0u);
  CHECK_EQUAL(check.inexact_aligned_edges, 0u);
  for(const Connection& c : connection_constraints)
    CHECK(random_constraints::is_connected(model.mesh, model.uv, c));
  for(const Cycle& c : cycle_constraints)
    CHECK(random_constraints::is_cyclic(model.mesh, model.uv, c));
  CHECK(CS::is_seamless(model.mesh, model.uv, np));
  // what holds is left alone
  const auto values = model.values();
  CHECK(CS::snap_to_seamless(model.mesh, model.uv, np).status == CS::Snapping_status::ALREADY_EXACT);
  CHECK(model.values() == values);
  std::cout << name << ", seed " << seed << ": largest change " << report.largest_change / report.extent
            << " of the extent, redundant " << report.number_of_redundant_constraints
            << ", non-unit pivots " << report.number_of_non_unit_pivots << std::endl;
}

double rounded_to_sixteenths(double x)
{
  return std::round(16 * x) / 16;
}

void check_refused(Model& model, const std::vector<Corner>& constraints, CS::Snapping_status status,
                   const std::string& message)
{
  const auto values = model.values();
  const CS::Snapping_report report =
    CS::snap_to_seamless(model.mesh, model.uv, parameters::corner_constraints(constraints));
  CHECK_EQUAL(CS::to_string(report.status), std::string(CS::to_string(status)));
  if(!CHECK(report.message.find(message) != std::string::npos))
    std::cerr << report.message << std::endl;
  CHECK(model.values() == values);
}

Corner pin(Halfedge corner, int component, const Rational& value, const Rational& factor = Rational(1))
{
  Corner result;
  result.terms.push_back({ corner, component, factor });
  result.right_hand_side = value;
  return result;
}

void test_corner_constraints(const std::string& name)
{
  Model model(name);
  const Halfedge a = model.mesh.halfedge(model.singular[0]), b = model.mesh.halfedge(model.singular[1]);
  const double at_a = rounded_to_sixteenths(model.uv[a].x());
  const Corner pin_a = pin(a, 0, Rational(at_a));
  // twice the spacing of b from a is a multiple of 1/8, whatever the chart
  Corner spacing = pin(b, 1, Rational(rounded_to_sixteenths(model.uv[b].y() - model.uv[a].y()) * 2), 2);
  spacing.terms.push_back({ a, 1, Rational(-2) });

  Corner contradiction = pin_a;
  contradiction.right_hand_side += 1;
  check_refused(model, { pin_a, spacing, contradiction }, CS::Snapping_status::INCONSISTENT,
                "corner constraint 0, corner constraint 2");
  check_refused(model, { pin(b, 1, Rational(1), Rational(3)) }, CS::Snapping_status::NOT_REPRESENTABLE,
                "right-hand sides");
  check_refused(model, { pin(a, 2, Rational(0)) }, CS::Snapping_status::INVALID_ARGUMENT, "component 2");

  const std::vector<Corner> constraints = { pin_a, spacing, pin_a };
  const auto np = parameters::corner_constraints(constraints);
  const CS::Snapping_report report = CS::snap_to_seamless(model.mesh, model.uv, np);
  if(!CHECK(bool(report)))
    std::cerr << name << ": " << report << std::endl;
  CHECK(exact_check::check_edges(model.mesh, model.uv).is_exact());
  CHECK_EQUAL(model.uv[a].x(), at_a);
  CHECK(Rational(Rational(2) * exact_check::exact_difference(model.uv[b], model.uv[a])[1]) ==
        spacing.right_hand_side);
  CHECK(CS::is_seamless(model.mesh, model.uv, np));
  CHECK(!CS::is_seamless(model.mesh, model.uv,
                         parameters::corner_constraints(std::vector<Corner>(1, contradiction))));
}

void test_invalid_paths(const std::string& name)
{
  Model model(name);
  random_constraints::Generator<Mesh> random(model.mesh, model.uv, 1);
  Connection good = random.connection();
  while(good.path.size() < 4)
    good = random.connection();
  std::vector<Connection> bad(3, good);
  std::swap(bad[0].path[1], bad[0].path[2]);
  bad[1].path.pop_back();
  bad[2].a = Mesh::null_halfedge();
  const std::string messages[3] = { "step 1 of the path of connection constraint 0",
                                    "does not end in the face", "a corner that is not in a face" };
  const auto values = model.values();
  for(std::size_t i = 0; i < bad.size(); ++i) {
    const std::vector<Connection> constraints(1, bad[i]);
    const CS::Snapping_report report =
      CS::snap_to_seamless(model.mesh, model.uv, parameters::connection_constraints(constraints));
    CHECK_EQUAL(CS::to_string(report.status), std::string("invalid argument"));
    if(!CHECK(report.message.find(messages[i]) != std::string::npos))
      std::cerr << report.message << std::endl;
    CHECK(model.values() == values);
  }
}

int main()
{
  for(const std::string name : { "genus0", "genus1", "genus2", "genus3", "genus0_border",
                                 "genus2_features", "genus2_features_border" })
    for(std::uint64_t seed = 1; seed <= 3; ++seed)
      test_random_constraints(name, seed, 20, 4);
  test_corner_constraints("genus0");
  test_corner_constraints("genus2");
  test_invalid_paths("genus2");
  return report_checks();
}
