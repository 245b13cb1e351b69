// Isocurves of maps with rotational symmetries of order 1, 3, and 6 are traced as rationals say,
// along all directions, from vertices, edges, and faces; and as constraints they meet the cones
// again that noise made them miss.

#include "checking.h"
#include "hexagonal_data.h"
#include "hexagonal_maps.h"
#include "lattice_walk.h"
#include "random_complexes.h"
#include "tracing_checks.h"

#include <CGAL/Isocurves_and_layouts/isocurve_constraints.h>
#include <CGAL/Isocurves_and_layouts/trace_isocurve.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/FPU.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace IL = CGAL::Isocurves_and_layouts;
using namespace hexagonal_maps;

using Start = IL::Isocurve_start<Mesh>;
using Status = IL::Isocurve_status;

// Moves vertices at no cut by numbers with all bits, so that u + v is in general no double.
void scatter(const Mesh& mesh, UV_map uv, const double size, std::mt19937& random)
{
  std::uniform_real_distribution<double> number(-size, size);
  for(const Vertex v : mesh.vertices()) {
    const Vector d{{number(random), number(random) / 3}};
    bool is_at_cut = false;
    for(const Halfedge h : CGAL::halfedges_around_target(v, mesh))
      is_at_cut = is_at_cut || (is_interior(mesh, h) && is_cut(mesh, uv, h));
    if(!is_at_cut)
      for(const Halfedge h : CGAL::halfedges_around_target(v, mesh))
        if(!mesh.is_border(h))
          uv[h] = moved(uv[h], d);
  }
}

// Moves vertices at no cut off the axes, so little that u + v is rounded to what it was.
void nudge(const Mesh& mesh, UV_map uv, std::mt19937& random)
{
  for(const Vertex v : mesh.vertices()) {
    const double by = std::ldexp(int(random() % 5) - 2, -70);
    const auto nudged = [&](const double x) { return x == 0 ? by : x; };
    bool is_at_cut = false;
    for(const Halfedge h : CGAL::halfedges_around_target(v, mesh))
      is_at_cut = is_at_cut || !is_interior(mesh, h) || is_cut(mesh, uv, h) ||
                  is_cut(mesh, uv, mesh.opposite(h));
    if(!is_at_cut)
      for(const Halfedge h : CGAL::halfedges_around_target(v, mesh))
        uv[h] = Kernel::Point_2(nudged(uv[h].x()), nudged(uv[h].y()));
  }
}

// From vertices, points on edges, and points in faces, each in all directions.
template <int N, int D>
std::map<Status, std::size_t> check_isocurves(const IL::Isocurve_tracer<Mesh, D>& tracer,
                                              const Mesh& mesh, const UV_map uv,
                                              const std::size_t maximum, const std::string& name)
{
  const lattice_walk::Reference_walk<N> walk(mesh, uv);
  std::map<Status, std::size_t> ends;
  const auto check = [&](const Start& start, const IL::Isocurve_direction direction,
                         const std::optional<lattice_walk::Stop>& first) {
    const std::string context = name + ", from halfedge " + std::to_string(start.halfedge) +
                                ", place " + std::to_string(int(start.place)) + ", direction " +
                                std::to_string(int(direction));
    const auto curve =
      tracer.trace(start, direction, IL::parameters::maximum_number(maximum).maximum_length(1e9));
    ++ends[curve.status];
    lattice_walk::check_points(tracer, mesh, uv, walk, curve, first, context);
    CHECK_IN(context, tracing_checks::is_good(tracer, curve, mesh, uv));
    for(const auto& point : curve.points) { // rounded, and exact in the chart of the halfedge
      const Vector u = IL::isocurve_uv(point, mesh, uv);
      const int f = int(point.direction()) > 3 ? 2 : 1 - int(point.direction()) % 2;
      CHECK_IN(context, std::abs(random_complexes::value(f, u) -
                                 CGAL::to_double(point.constant_coordinate())) < 1e-12);
    }
  };
  for(const Vertex v : mesh.vertices())
    for(const auto& [start, direction] : tracer.outgoing(v))
      check(start, direction,
            walk.from_vertex(start.halfedge, lattice_walk::vector_of<D>(direction), Rational(0)));
  std::size_t i = 0;
  for(const Halfedge h : mesh.halfedges()) {
    if(mesh.is_border(h) || ++i % 21 != 0)
      continue;
    const Exact_vector a = lattice_walk::exact_point(uv[mesh.prev(h)]);
    const Exact_vector p =
      lattice_walk::sum(a, Rational(1) / 3, exact_vector(uv[mesh.prev(h)], uv[h]));
    const Kernel::Point_2 q = CGAL::centroid(uv[h], uv[mesh.next(h)], uv[mesh.prev(h)]);
    for(int k = 0; k < D; ++k) {
      const auto direction = lattice_walk::direction_name<D>(k);
      const Exact_vector d = lattice_walk::direction_vector<D>(k);
      check(Start::on_edge(h, Rational(1) / 3), direction, walk.from_edge_point(h, p, d));
      check(Start::in_face(h, q.x(), q.y()), direction,
            walk.from_face(h, lattice_walk::exact_point(q), d, Rational(0)));
    }
  }
  return ends;
}

std::ostream& operator<<(std::ostream& os, const std::map<Status, std::size_t>& ends)
{
  for(const auto& [status, number] : ends)
    os << ", " << number << " " << status;
  return os;
}

// Angles are multiples of 60 degrees: a ray leaves a vertex in each of its faces.
template <int N>
void check_rays(const IL::Isocurve_tracer<Mesh, 6>& tracer, const Mesh& mesh,
                const std::string& context)
{
  std::size_t number = 0;
  for(const Vertex v : mesh.vertices()) {
    if(mesh.is_border(v))
      continue;
    const bool is_singular = mesh.degree(v) != 6;
    CHECK_IN(context, tracer.is_singular(v) == is_singular);
    CHECK_IN(context, tracer.outgoing(v).size() == mesh.degree(v));
    number += is_singular ? mesh.degree(v) : 0;
    const auto rays = tracer.outgoing(v);
    for(std::size_t i = 1; i < rays.size(); ++i)
      CHECK_IN(context, rays[i].first.halfedge != rays[i - 1].first.halfedge ||
                          lattice_walk::vector_of<6>(rays[i].second) ==
                            turned<6>(1, lattice_walk::vector_of<6>(rays[i - 1].second)));
  }
  CHECK_IN(context, tracer.separatrices(IL::parameters::maximum_number(1)).size() == number);
}

template <int N>
void test_isocurves(Mesh mesh, const std::string& name)
{
  std::mt19937 random(1);
  const UV_map uv = uv_map(mesh);
  unfold(mesh, uv);
  for(const std::string kind : {"lattice", "nudged", "warped", "snapped", "scattered"}) {
    const std::string context = "isocurves, " + name + ", N = " + std::to_string(N) + ", " + kind;
    if(kind == "nudged")
      nudge(mesh, uv, random);
    if(kind == "warped")
      warp<N>(mesh, uv, 0.125, random);
    if(kind == "snapped") {
      perturb(mesh, uv, std::ldexp(1., -20), random);
      CHECK_IN(context, IL::snap_to_seamless(mesh, uv, symmetry<N>()));
    }
    if(kind == "scattered")
      scatter(mesh, uv, 0.03, random);
    const IL::Isocurve_tracer tracer(mesh, uv, symmetry<N>());
    CHECK_IN(context, tracer.is_exact());
    check_rays<N>(tracer, mesh, context);
    const auto ends = check_isocurves<N>(tracer, mesh, uv, 12, context);
    std::cout << context << ends << std::endl;
  }
}

// A map of translations is one of any symmetry: the directions u and v lead the same ways.
void test_isocurves_of_both_kinds()
{
  Mesh mesh = torus(6, 5);
  const UV_map uv = uv_map(mesh);
  unfold(mesh, uv);
  std::mt19937 random(3);
  warp<1>(mesh, uv, 0.125, random);
  const IL::Isocurve_tracer four(mesh, uv, symmetry<1>()), default_four(mesh, uv);
  const IL::Isocurve_tracer six(mesh, uv, symmetry<6>());
  check_isocurves<1>(four, mesh, uv, 20, "translations, four directions");
  check_isocurves<1>(six, mesh, uv, 20, "translations, six directions");
  for(const Halfedge h : mesh.halfedges())
    for(int d = 0; d < 4; ++d) {
      const auto direction = IL::Isocurve_direction(d);
      const auto a = four.trace(Start::at_vertex(h), direction);
      for(const auto& b : {default_four.trace(Start::at_vertex(h), direction),
                           six.trace(Start::at_vertex(h), direction)}) {
        CHECK(a.status == b.status && a.points.size() == b.points.size());
        for(std::size_t i = 0; i < (std::min)(a.points.size(), b.points.size()); ++i)
          CHECK(tracing_checks::are_same(a.points[i], b.points[i], mesh, uv) &&
                a.points[i].constant_coordinate() == b.points[i].constant_coordinate());
      }
    }
}

// With noise, isocurves miss the cones that they met. As constraints, they meet them again.
void test_isocurve_constraints()
{
  Mesh mesh = subdivided(icosahedron(), 2);
  const UV_map uv = uv_map(mesh);
  unfold(mesh, uv);
  const auto count = [&](const bool decides_exactly) {
    std::vector<IL::Isocurve<Mesh> > curves;
    IL::trace_all_separatrices(
      mesh, uv, std::back_inserter(curves),
      symmetry<6>().decide_exactly(decides_exactly).maximum_number(100));
    std::map<Status, std::size_t> ends;
    for(const auto& curve : curves)
      ++ends[curve.status];
    return ends;
  };
  std::vector<IL::Connection_constraint<Mesh> > connections;
  std::array<std::size_t, 3> number{{0, 0, 0}};
  const IL::Isocurve_tracer tracer(mesh, uv, symmetry<6>());
  for(const auto& curve : tracer.separatrices())
    if(mesh.target(curve.points.back().halfedge()) < mesh.target(curve.points[0].halfedge())) {
      CHECK(curve.status == Status::SINGULAR_VERTEX);
      connections.push_back(IL::connection_along_isocurve(mesh, curve));
      ++number[std::size_t(connections.back().component)];
    }
  CHECK(number[0] > 0 && number[1] > 0 && number[2] > 0);
  CHECK_EQUAL((count(true)[Status::SINGULAR_VERTEX]), 60u);
  std::mt19937 random(8);
  perturb(mesh, uv, std::ldexp(1., -20), random);
  CHECK_EQUAL((count(true)[Status::NOT_EXACT]), 1u);
  const auto untraced =
    IL::intercepted_connections(IL::Isocurve_tracer(mesh, uv, symmetry<6>()), connections);
  if(CHECK_EQUAL(untraced.size(), connections.size()))
    CHECK_IN(untraced.front().message,
             untraced.front().message.find("not exactly seamless") != std::string::npos);
  const auto failures = count(false);
  CHECK(std::any_of(failures.begin(), failures.end(),
                    [](const auto& end) { return IL::is_failure(end.first); }));
  std::cout << "separatrices in floating point" << failures << std::endl;
  const auto report =
    IL::snap_to_seamless(mesh, uv, symmetry<6>().connection_constraints(connections));
  CHECK_IN(report.message, bool(report));
  CHECK(IL::intercepted_connections(IL::Isocurve_tracer(mesh, uv, symmetry<6>()), connections)
          .empty());
  CHECK_EQUAL((count(true)[Status::SINGULAR_VERTEX]), 60u);
}

// --- a real map ----------------------------------------------------------------------------------

void test_data_file()
{
  Mesh mesh;
  const UV_map uv = uv_map(mesh);
  if(!hexagonal_maps::read_torus(mesh, uv))
    return;
  CHECK(bool(IL::snap_to_seamless(mesh, uv, symmetry<6>())));
  const IL::Isocurve_tracer tracer(mesh, uv, symmetry<6>());
  CHECK(tracer.separatrices().empty());
  std::cout << "torus" << check_isocurves<6>(tracer, mesh, uv, 10, "data") << std::endl;
}

int main()
{
  const CGAL::Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
  for(const Case& c : meshes_of_six_directions())
    test_isocurves<6>(c.mesh, c.name);
  test_isocurves<3>(subdivided(octahedron(), 1), "octahedron");
  test_isocurves_of_both_kinds();
  test_isocurve_constraints();
  test_data_file();
  return report_checks();
}
