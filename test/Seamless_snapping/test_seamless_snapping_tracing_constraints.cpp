// Isocurves on maps that are snapped with constraints: those that connections ask for meet their
// vertices exactly, those that cycles ask for close exactly. Left without constraints, after noise
// of 1e-10 of the extent, they pass by.
//
// The constraints are random ones that the shape of a map allows: isocurves are traced until they
// pass near a singular vertex, or near their start. A first snapping moves the map to where they
// meet it. Those that do must do so again after noise and another snapping.

#include "tracing_constraints.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

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

#ifndef SEAMLESS_SNAPPING_DATA_DIR
#define SEAMLESS_SNAPPING_DATA_DIR ""
#endif
#ifndef SEAMLESS_SNAPPING_PACKAGE_DATA_DIR
#define SEAMLESS_SNAPPING_PACKAGE_DATA_DIR ""
#endif

using namespace tracing_checks;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Start = SS::Isocurve_start<Mesh>;
using Tracer = SS::Isocurve_tracer<Mesh>;
using Curve = SS::Isocurve<Mesh>;
using Pass = Near_pass<Mesh>;
using Random = std::mt19937_64;
using CGAL::Exact_rational;

// Curves are followed for so many crossings; as a candidate, a curve may pass by at this part of an
// edge's length; noise is smaller than the clearance by far.
constexpr std::size_t maximum_number = 1000;
constexpr double near = 0.05;
constexpr double clearance = 1e-4;
constexpr double noise = 1e-10; // of the extent

struct Model
{
  Mesh mesh;
  UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  std::vector<Vertex> ends; // of connections: singular vertices, or any if there are none
  std::vector<char> is_end; // per vertex
  double edge_length = 0;   // in the domain, on average
  double extent = 0;

  bool is_unfolded(const Vertex v) const
  { return tracing_checks::is_unfolded(mesh, uv, mesh.halfedge(v)); }
};

bool read(const std::filesystem::path& path, Model& model)
{
  const Mesh& mesh = model.mesh;
  if(!CHECK(SS::IO::read_OBJ(path.string(), model.mesh, model.uv)) ||
     !CHECK(SS::snap_to_seamless(mesh, model.uv)))
    return false;
  const Tracer tracer(mesh, model.uv);
  std::vector<Vertex> regular;
  for(const Vertex v : mesh.vertices())
    if(!mesh.is_isolated(v) && !CGAL::is_border(v, mesh))
      (tracer.is_singular(v) ? model.ends : regular).push_back(v);
  if(model.ends.size() < 2)
    for(std::size_t i = 0; i < 40; ++i)
      model.ends.push_back(regular[i * regular.size() / 40]);
  model.is_end.assign(mesh.num_vertices(), false);
  for(const Vertex v : model.ends)
    model.is_end[v] = true;
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(h))
      model.edge_length += std::sqrt(CGAL::squared_distance(model.uv[h], model.uv[mesh.prev(h)])) /
                           double(mesh.number_of_halfedges());
  model.extent = SS::seam_transitions(mesh, model.uv).extent();
  return true;
}

// Vertices on whose side it depends how a curve goes on.
std::vector<char> critical_vertices(const Model& model, const Tracer& tracer)
{
  std::vector<char> result(model.mesh.num_vertices(), false);
  for(const Vertex v : model.mesh.vertices())
    if(!model.mesh.is_isolated(v))
      result[v] = tracer.is_singular(v) || CGAL::is_border(v, model.mesh) || !model.is_unfolded(v);
  return result;
}

// --- the two kinds of constraints ----------------------------------------------------------------

struct Connections
{
  using Constraint = SS::Connection_constraint<Mesh>;
  static constexpr Status expected = Status::TARGET, failure = Status::MISSED_TARGET;

  static auto as_parameter(const std::vector<Constraint>& constraints)
  { return parameters::connection_constraints(constraints); }

  static Constraint constraint(const Pass& pass, const Mesh& mesh)
  {
    return {pass.curve.start.halfedge, pass.corner, constant_component(pass.curve.direction),
            SS::isocurve_face_path(mesh, pass.curve)};
  }

  static Vertex target(const Pass& pass, const Mesh& mesh) { return mesh.target(pass.corner); }

  // A curve from a random end that meets or nearly meets another one.
  static bool find_candidate(const Model& model, const Tracer& tracer, Random& random, Pass& pass)
  {
    const Mesh& mesh = model.mesh;
    const Vertex v = model.ends[random() % model.ends.size()];
    const auto outgoing = tracer.outgoing(v);
    if(outgoing.empty())
      return false;
    const auto& [start, direction] = outgoing[random() % outgoing.size()];
    const Curve curve = tracer.trace(start, direction, parameters::maximum_number(maximum_number));
    if(find_near_pass(curve, mesh, model.uv, near * model.edge_length,
                      [&](const auto h, Direction)
                      { return mesh.target(h) != v && model.is_end[mesh.target(h)]; }, pass))
      return true;
    pass = {curve, curve.points.back().halfedge()};
    return curve.status == Status::SINGULAR_VERTEX && model.is_end[mesh.target(pass.corner)];
  }
};

struct Cycles
{
  using Constraint = SS::Cycle_constraint<Mesh>;
  static constexpr Status expected = Status::CLOSED, failure = Status::SPIRALS;

  static auto as_parameter(const std::vector<Constraint>& constraints)
  { return parameters::cycle_constraints(constraints); }

  // The start is a regular vertex; the path goes on around it.
  static Constraint constraint(const Pass& pass, const Mesh& mesh)
  {
    auto path = SS::isocurve_face_path(mesh, pass.curve);
    if(pass.curve.status != Status::CLOSED)
      for(auto h = pass.corner; h != pass.curve.start.halfedge; h = mesh.prev(mesh.opposite(h)))
        path.push_back(h);
    return {pass.curve.start.halfedge, constant_component(pass.curve.direction), path};
  }

  static Vertex target(const Pass&, const Mesh&) { return Mesh::null_vertex(); }

  // A random curve that crosses an edge twice, at about the same place: a curve from an end of this
  // edge may return to it.
  static bool find_candidate(const Model& model, const Tracer& tracer, Random& random, Pass& pass)
  {
    const Mesh& mesh = model.mesh;
    const Vertex v(Mesh::size_type(random() % mesh.number_of_vertices()));
    const auto outgoing = tracer.outgoing(v);
    if(outgoing.empty())
      return false;
    const auto& [start, direction] = outgoing[random() % outgoing.size()];
    const Curve curve = tracer.trace(start, direction, parameters::maximum_number(maximum_number));
    std::map<std::pair<Mesh::Halfedge_index, Direction>, double> levels;
    for(const auto& point : curve.points) {
      const double level = point.approximate_constant_coordinate();
      const auto [first, is_new] = levels.insert({{point.halfedge(), point.direction()}, level});
      if(!is_new && point.place() == Place::EDGE &&
         std::abs(first->second - level) <= near * model.edge_length)
        return find_return(model, tracer, point.halfedge(), point.direction(), pass);
    }
    return curve.status == Status::CLOSED &&
           find_return(model, tracer, start.halfedge, direction, pass);
  }

  // Whether the curve from the target of `h` returns to it.
  static bool find_return(const Model& model, const Tracer& tracer, const Mesh::Halfedge_index h,
                          const Direction direction, Pass& pass)
  {
    const Mesh& mesh = model.mesh;
    const Vertex v = mesh.target(h);
    if(tracer.is_singular(v) || CGAL::is_border(v, mesh) || !model.is_unfolded(v))
      return false;
    const auto seams = SS::seam_transitions(mesh, model.uv);
    const auto leads_back = [&](Mesh::Halfedge_index g, const Direction d) {
      int turns = int(d);
      if(mesh.target(g) != v)
        return false;
      for(; g != h; g = mesh.prev(mesh.opposite(g)))
        turns += seams.rotation(g);
      return turns % 4 == int(direction);
    };
    const Curve curve = tracer.trace(Start::at_vertex(h), direction,
                                     parameters::maximum_number(maximum_number));
    pass = {curve, curve.points.back().halfedge()};
    return curve.status == Status::CLOSED ||
           find_near_pass(curve, mesh, model.uv, near * model.edge_length, leads_back, pass);
  }
};

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
    if(snap(m_constraints, 10 * near * m_model.edge_length)) {
      keep_possible_ones();
      disturb(m_mesh, m_uv, noise * m_model.extent, random);
      m_results.failed_naively = count(Kind::failure, false);
      const auto noisy = values();
      snap({}, 1000 * noise * m_model.extent);
      m_results.exact_without = count(Kind::expected, true);
      set_values(noisy);
      snap(m_constraints, 1000 * noise * m_model.extent);
      CHECK(SS::is_seamless(m_mesh, m_uv, Kind::as_parameter(m_constraints)));
      m_results.exact = count(Kind::expected, true);
    }
    set_values(original);
    return m_results;
  }

private:
  void collect(const std::size_t number, Random& random)
  {
    const Tracer tracer(m_mesh, m_uv);
    Pass pass;
    for(std::size_t i = 0; i < 5 * number && m_passes.size() < number; ++i)
      if(Kind::find_candidate(m_model, tracer, random, pass)) {
        m_passes.push_back(pass);
        m_constraints.push_back(Kind::constraint(pass, m_mesh));
      }
  }

  // Coordinates change by no more than constraints ask for.
  bool snap(const std::vector<Constraint>& constraints, const double change)
  {
    const auto report = SS::snap_to_seamless(m_mesh, m_uv, Kind::as_parameter(constraints));
    if(!CHECK(report) || !CHECK(report.largest_change <= change))
      std::cerr << report << ", largest change " << report.largest_change << " of " << change
                << std::endl;
    return bool(report);
  }

  void keep_possible_ones()
  {
    const Tracer tracer(m_mesh, m_uv);
    const auto seams = SS::seam_transitions(m_mesh, m_uv);
    const auto is_critical = critical_vertices(m_model, tracer);
    std::vector<Pass> passes;
    passes.swap(m_passes);
    m_constraints.clear();
    for(Pass& pass : passes) {
      pass.curve = trace(tracer, seams, pass, true);
      pass.corner = pass.curve.points.back().halfedge();
      if(pass.curve.status != Kind::expected ||
         !m_model.is_unfolded(m_mesh.target(pass.curve.start.halfedge)) ||
         !m_model.is_unfolded(m_mesh.target(pass.corner)) ||
         !is_clear(pass.curve, m_mesh, m_uv, clearance * m_model.edge_length, is_critical))
        continue;
      m_constraints.push_back(Kind::constraint(pass, m_mesh));
      m_passes.push_back(pass);
    }
    m_results.possible = m_passes.size();
  }

  Curve trace(const Tracer& tracer, const SS::Seam_transitions<Mesh>& seams, const Pass& pass,
              const bool exactly) const
  {
    const auto [start, direction] = same_start(tracer, m_mesh, seams, pass.curve);
    const auto np = parameters::maximum_number(2 * maximum_number).decide_exactly(exactly);
    const Vertex v = Kind::target(pass, m_mesh);
    return v == Mesh::null_vertex() ? tracer.trace(start, direction, np)
                                    : tracer.trace(start, direction, np.target_vertex(v));
  }

  // How many of the curves end in this way; exact ones also backwards.
  std::size_t count(const Status status, const bool exactly) const
  {
    const Tracer tracer(m_mesh, m_uv);
    const auto seams = SS::seam_transitions(m_mesh, m_uv);
    std::size_t result = 0;
    for(const Pass& pass : m_passes) {
      const Curve curve = trace(tracer, seams, pass, exactly);
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
  std::vector<Pass> m_passes;
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

Totals test_files(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  if(!folder.empty() && std::filesystem::is_directory(folder))
    for(const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if(entry.path().extension() == ".obj" && entry.path().parent_path().filename() != "refused")
        files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  Totals totals;
  for(const auto& file : files) {
    Model model;
    if(!read(file, model))
      continue;
    const std::size_t set_size = std::clamp<std::size_t>(model.ends.size() / 4, 1, 100);
    const Results connections = test_constraints<Connections>(model, 100, set_size);
    const Results cycles = test_constraints<Cycles>(model, 10, 1);
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
  std::cout << "random seed 1" << std::endl;
  const Totals totals = test_files(SEAMLESS_SNAPPING_PACKAGE_DATA_DIR);
  // that much is there to be tested
  CHECK(totals.connections.possible >= 1000 && totals.cycles.possible >= 50);
  CHECK(totals.connections.failed_naively >= 900 && totals.cycles.failed_naively >= 50);
  test_files(SEAMLESS_SNAPPING_DATA_DIR);
  return report_checks();
}
