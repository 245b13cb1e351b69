// What goes wrong with isocurves where seams are inexact (Sec. 6.2 of the paper), on maps with
// noise and on maps as a solver computed them; none of it is left after snapping. And what
// constraints add to that: isocurves that connections ask for meet their vertices exactly, those
// that cycles ask for close exactly; without constraints they pass by, after noise of 1e-10 of the
// extent.
//
// The constraints are random ones that the shape of a map allows: isocurves are traced until they
// pass near a singular vertex, or near their start. A first snapping moves the map to where they
// meet it. Those that do must do so again after noise and another snapping.

#include "floating_point_traps.h"
#include "test_data.h"
#include "test_meshes.h"
#include "tracing_candidates.h"

#include <CGAL/Isocurves_and_layouts/isocurve_constraints.h>
#include <CGAL/Seamless_snapping/is_seamless.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <map>
#include <ostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace tracing_checks;

// --- failures ------------------------------------------------------------------------------------

// One fixed case of each: a mesh, which noise, and what a naive tracer reports there; no failure
// is left once the noise has been snapped away.
void test_failures()
{
  const std::vector<std::pair<std::string, std::vector<Status> > > cases = {
    {"divided cube", {Status::STUCK_AT_CUT, Status::FELL_INTO_GAP, Status::MISSED_TARGET}},
    {"closed cut around a disc, rotation", {Status::NO_WAY_OUT, Status::SEVERAL_WAYS_OUT}},
    {"disc with aligned border", {Status::FELL_OFF_BORDER}},
    {"torus", {Status::SPIRALS}}};
  std::map<std::string, std::size_t> index;
  auto all = test_meshes::all_meshes<Kernel>();
  for(std::size_t i = 0; i < all.size(); ++i)
    index[all[i].name] = i;
  for(const auto& [name, expected] : cases) {
    auto& named = all[index.at(name)];
    Mesh& mesh = named.mesh;
    const UV_map uv = test_meshes::uv_map(mesh);
    CHECK(naive_ends(mesh, uv, 1e-6).rbegin()->first < Status::STUCK_AT_CUT);
    if(expected.front() == Status::NO_WAY_OUT)
      perturb_other_charts(mesh, uv, 1e-9, 1);
    else
      uv_noise::perturb(mesh, uv, 1e-9, 1);
    Counts ends = naive_ends(mesh, uv, 1e-6);
    std::cout << name << " with noise, in floating point: " << ends << std::endl;
    for(const Status status : expected)
      CHECK(ends[status] > 0);

    CHECK(IL::snap_to_seamless(mesh, uv, parameters::align_border(named.align_border)));
    const Tracer tracer(mesh, uv);
    std::size_t bad = 0;
    for(const auto v : mesh.vertices())
      for(const auto& [start, direction] : tracer.outgoing(v))
        bad += is_good(tracer, tracer.trace(start, direction), mesh, uv) ? 0 : 1;
    CHECK_EQUAL(bad, std::size_t(0));
  }
}

// Products of coordinates of such sizes underflow or overflow; the curves are the same.
void test_failures_of_any_size()
{
  for(const int exponent : {-560, 560}) {
    auto all = test_meshes::all_meshes<Kernel>();
    for(std::size_t i = 0; i < all.size(); i += 4) {
      Mesh& mesh = all[i].mesh;
      const UV_map uv = test_meshes::uv_map(mesh);
      uv_noise::perturb(mesh, uv, 1e-9, 1);
      const Counts ends = naive_ends(mesh, uv, 1e-6);
      for(const auto h : mesh.halfedges())
        uv[h] = Kernel::Point_2(std::ldexp(uv[h].x(), exponent), std::ldexp(uv[h].y(), exponent));
      CHECK_IN(all[i].name, naive_ends(mesh, uv, 1e-6) == ends);
    }
  }
}

// The maps as the producer computed them, whose seams are off by 1e-16 of the extent, without any
// noise: curves from all vertices fail in every way.
void test_failures_of_computed_maps()
{
  Counts naive;
  for(const auto& file : test_data::package_files()) {
    Mesh mesh;
    UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
    CHECK(IL::IO::read_OBJ(file.string(), mesh, uv));
    const Tracer tracer(mesh, uv);
    for(const auto v : mesh.vertices())
      for(const auto& [start, direction] : tracer.outgoing(v))
        ++naive[tracer.trace(start, direction,
                             parameters::maximum_number(300).decide_exactly(false)).status];
  }
  std::cout << "computed maps, in floating point: " << naive << std::endl;
  for(int i = int(Status::STUCK_AT_CUT); i < IL::number_of_isocurve_statuses; ++i)
    if(!CHECK(naive[Status(i)] > 0))
      std::cerr << "  no curve " << Status(i) << std::endl;
}

// --- one set of constraints ----------------------------------------------------------------------

struct Results
{
  std::size_t asked = 0;             // so many constraints
  std::size_t possible = 0;          // whose isocurves go as they ask for
  std::size_t exact = 0;             // and do so again, without and with the constraints
  std::size_t exact_without = 0;
  std::size_t failed_naively = 0;

  Results& operator+=(const Results& other)
  {
    asked += other.asked;
    possible += other.possible;
    exact += other.exact;
    exact_without += other.exact_without;
    failed_naively += other.failed_naively;
    return *this;
  }
};

std::ostream& operator<<(std::ostream& os, const Results& r)
{
  return os << r.asked << " asked for, " << r.possible << " possible, " << r.exact
            << " exact with constraints, " << r.exact_without << " without, " << r.failed_naively
            << " fail in floating point";
}

template <typename Kind>
class Trial
{
  using Constraint = typename Kind::Constraint;

public:
  explicit Trial(Model& model) : m_model(model), m_mesh(model.mesh), m_uv(model.uv) { }

  Results run(const std::size_t number, Random& random)
  {
    const auto original = values();
    collect(number, random);
    m_results.asked = m_constraints.size();
    if(snap(m_constraints, 10 * near_distance * m_model.edge_length)) {
      keep_possible_ones();
      disturb(m_mesh, m_uv, noise * m_model.extent, random);
      m_results.failed_naively = count(Kind::failure, false);
      const auto noisy = values();
      snap({}, 1000 * noise * m_model.extent);
      m_results.exact_without = count(Kind::expected, true);
      set_values(noisy);
      snap(m_constraints, 1000 * noise * m_model.extent);
      CHECK(IL::is_seamless(m_mesh, m_uv, Kind::as_parameter(m_constraints)));
      m_results.exact = count(Kind::expected, true);
    }
    set_values(original);
    return m_results;
  }

private:
  void collect(const std::size_t number, Random& random)
  {
    const Tracer tracer(m_mesh, m_uv);
    Near_pass pass;
    for(std::size_t i = 0; i < 5 * number && m_passes.size() < number; ++i)
      if(Kind::find_candidate(m_model, tracer, random, pass)) {
        m_passes.push_back(pass);
        m_constraints.push_back(Kind::constraint(pass.curve, m_mesh));
      }
  }

  // Coordinates change by no more than constraints ask for.
  bool snap(const std::vector<Constraint>& constraints, const double change)
  {
    const auto report = IL::snap_to_seamless(m_mesh, m_uv, Kind::as_parameter(constraints));
    if(!CHECK(report) || !CHECK(report.largest_change <= change))
      std::cerr << report << ", largest change " << report.largest_change << " of " << change
                << std::endl;
    if constexpr(Kind::expected == Status::TARGET)
      if(!constraints.empty())
        check_intercepted(constraints);
    return bool(report);
  }

  // The connections whose isocurves end before, or go elsewhere, are found. In flipped faces these
  // turn back, and no length tells how far to follow them.
  void check_intercepted(const std::vector<Constraint>& constraints) const
  {
    if(IL::measure_seamlessness(m_mesh, m_uv).number_of_flipped_faces > 0)
      return;
    const Tracer tracer(m_mesh, m_uv);
    std::vector<std::size_t> expected, found;
    for(const auto& connection : IL::intercepted_connections(tracer, constraints))
      found.push_back(connection.index);
    for(std::size_t i = 0; i < m_passes.size(); ++i)
      if(trace(tracer, m_passes[i], true).status != Kind::expected)
        expected.push_back(i);
    CHECK(found == expected);
  }

  void keep_possible_ones()
  {
    const Tracer tracer(m_mesh, m_uv);
    const auto is_critical = critical_vertices(m_model, tracer);
    std::vector<Near_pass> passes;
    passes.swap(m_passes);
    m_constraints.clear();
    for(Near_pass& pass : passes) {
      pass.curve = trace(tracer, pass, true);
      pass.corner = pass.curve.points.back().halfedge();
      if(pass.curve.status != Kind::expected ||
         !is_clear(pass.curve, m_mesh, m_uv, clearance * m_model.edge_length, is_critical))
        continue;
      m_constraints.push_back(Kind::constraint(pass.curve, m_mesh));
      m_passes.push_back(pass);
    }
    m_results.possible = m_passes.size();
  }

  Curve trace(const Tracer& tracer, const Near_pass& pass, const bool exactly) const
  {
    const auto np = parameters::maximum_number(2 * maximum_number).decide_exactly(exactly);
    const Vertex v = Kind::target(pass, m_mesh);
    return v == Mesh::null_vertex()
             ? tracer.trace(pass.curve.start, pass.curve.direction, np)
             : tracer.trace(pass.curve.start, pass.curve.direction, np.target_vertex(v));
  }

  // How many of the curves end in this way; exact ones also backwards.
  std::size_t count(const Status status, const bool exactly) const
  {
    const Tracer tracer(m_mesh, m_uv);
    std::size_t result = 0;
    for(const Near_pass& pass : m_passes) {
      const Curve curve = trace(tracer, pass, exactly);
      result += curve.status == status && (!exactly || is_exact(tracer, curve)) ? 1 : 0;
    }
    return result;
  }

  // The curve has the coordinate of the vertex at its end, and is the same backwards.
  bool is_exact(const Tracer& tracer, const Curve& curve) const
  {
    const auto& end = curve.points.back();
    const auto p = m_uv[end.halfedge()];
    const Exact_rational expected(constant_component(end.direction()) == 0 ? p.x() : p.y());
    return end.constant_coordinate() == expected && is_symmetric(tracer, curve, m_mesh, m_uv);
  }

  std::vector<Kernel::Point_2> values() const
  {
    std::vector<Kernel::Point_2> result;
    for(const auto h : m_mesh.halfedges())
      result.push_back(m_uv[h]);
    return result;
  }

  void set_values(const std::vector<Kernel::Point_2>& values)
  {
    std::size_t i = 0;
    for(const auto h : m_mesh.halfedges())
      m_uv[h] = values[i++];
  }

  const Model& m_model;
  const Mesh& m_mesh;
  UV_map m_uv;
  std::vector<Near_pass> m_passes;
  std::vector<Constraint> m_constraints;
  Results m_results;
};

// --- files ---------------------------------------------------------------------------------------

// Sets of so many constraints as leave a map some freedom, until there are `number` in all.
template <typename Kind>
Results test_constraints(Model& model, const std::size_t number, const std::size_t set_size)
{
  Random random(1);
  Results results;
  for(std::size_t i = 0; i < number && results.asked < number; i += set_size)
    results += Trial<Kind>(model).run((std::min)(set_size, number - results.asked), random);
  CHECK_EQUAL(results.exact, results.possible);
  CHECK_EQUAL(results.exact_without, std::size_t(0));
  return results;
}

struct Totals
{
  Results connections, cycles;
};

// \param number_of_cycles in each file, and a tenth of the number of connections
Totals test_files(const std::vector<std::filesystem::path>& files,
                  const std::size_t number_of_cycles)
{
  Totals totals;
  for(const auto& file : files) {
    Model model;
    if(!read(file, model))
      continue;
    const std::size_t set_size = std::clamp<std::size_t>(model.ends.size() / 4, 1, 100);
    const Results connections =
      test_constraints<Connections>(model, 10 * number_of_cycles, set_size);
    const Results cycles = test_constraints<Cycles>(model, number_of_cycles, 1);
    std::cout << file.filename().string() << "\n  connections: " << connections
              << "\n  cycles: " << cycles << std::endl;
    totals.connections += connections;
    totals.cycles += cycles;
  }
  std::cout << files.size() << " files\n  connections: " << totals.connections
            << "\n  cycles: " << totals.cycles << std::endl;
  return totals;
}

int main()
{
  const Floating_point_traps traps; // for all functions that are called
  test_failures();
  test_failures_of_any_size();
  test_failures_of_computed_maps();
  std::cout << "random seed 1" << std::endl;
  const Totals totals = test_files(test_data::package_files(), 10);
  // that much is there to be tested
  CHECK(totals.connections.possible >= 900 && totals.cycles.possible >= 45);
  CHECK(totals.connections.failed_naively >= 850 && totals.cycles.failed_naively >= 45);
  test_files(test_data::fifth_of_further_files("uv", ".obj"),
             std::size_t(test_data::trials(10)));
  return report_checks();
}
