// Rotational symmetries of order 1, 2, 3, and 6: maps with noise become exact, checked in rationals
// by code that shares nothing with the package, and keep their cuts, cones, and orientations; all
// kinds of constraints hold; results are as close as can be, and the same in all charts; a wrong
// symmetry is refused, and the right one named.

#include "checking.h"
#include "exact_reference.h"
#include "hexagonal_data.h"
#include "hexagonal_maps.h"
#include "net_of_cuts.h"
#include "random_complexes.h"
#include "test_meshes.h"

#include <CGAL/Seamless_snapping/internal/complex/Complex_solver.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>
#include <CGAL/Seamless_snapping/types/surface_constraints.h>

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

namespace SS = CGAL::Seamless_snapping;
namespace internal = SS::internal;
using namespace hexagonal_maps;

// --- maps ----------------------------------------------------------------------------------------

// Cuts, rotations, and cones are those of the clean map.
template <int N>
void check_transitions(const Mesh& mesh, const UV_map clean, const UV_map uv,
                       const std::string& context)
{
  const auto seams = SS::seam_transitions(mesh, uv, symmetry<N>());
  CHECK_IN(context, bool(seams));
  for(const Halfedge h : mesh.halfedges())
    if(is_interior(mesh, h)) {
      CHECK_IN(context, seams.is_cut(h) == is_cut(mesh, clean, h));
      CHECK_IN(context, seams.rotation(h) == turns<N>(mesh, clean, h));
    }
  std::map<Vertex, int> indices;
  for(const Vertex v : mesh.vertices())
    if(!mesh.is_border(v) && mesh.degree(v) != 6)
      indices[v] = (6 - int(mesh.degree(v))) * N / 6;
  const auto& singular = seams.singular_vertices();
  CHECK_IN(context, (std::map<Vertex, int>(singular.begin(), singular.end())) == indices);
}

// With noise: exact, no face lost, changes no larger than a few times the noise.
template <int N>
double snap_noisy(const Mesh& mesh, const UV_map clean, UV_map uv, const double noise,
                  const unsigned int seed, const std::string& context)
{
  std::mt19937 random(seed);
  for(const Halfedge h : mesh.halfedges())
    uv[h] = clean[h];
  perturb(mesh, uv, noise, random);
  const std::vector<int> before = signs(mesh, uv);
  const bool has_cuts = std::any_of(mesh.edges().begin(), mesh.edges().end(), [&](const auto e) {
    return is_interior(mesh, mesh.halfedge(e)) && is_cut(mesh, clean, mesh.halfedge(e));
  });
  CHECK_IN(context, is_exact<N>(mesh, uv) == !has_cuts);
  CHECK_IN(context, SS::is_seamless(mesh, uv, symmetry<N>()) == !has_cuts);
  const auto report = SS::snap_to_seamless(mesh, uv, symmetry<N>());
  CHECK_IN(context + ": " + report.message,
           report.status == (has_cuts ? SS::Outcome::SNAPPED
                                      : SS::Outcome::ALREADY_EXACT));
  CHECK_IN(context, report.lost_faces.empty());
  CHECK_IN(context, is_exact<N>(mesh, uv));
  CHECK_IN(context, SS::is_seamless(mesh, uv, symmetry<N>()));
  CHECK_IN(context, SS::measure_seamlessness(mesh, uv, symmetry<N>()).violation == 0);
  const std::vector<int> after = signs(mesh, uv);
  for(std::size_t i = 0; i < before.size(); ++i)
    CHECK_IN(context, before[i] <= 0 || after[i] > 0);
  check_transitions<N>(mesh, clean, uv, context);
  CHECK_IN(context, report.rms_change <= 1.01 * report.optimal_rms_change + 1e-15);
  return report.largest_change / noise;
}

template <int N>
void test_map(Mesh mesh, const std::string& name)
{
  const std::string context = name + ", N = " + std::to_string(N);
  std::mt19937 random(1);
  const UV_map clean = uv_map(mesh);
  const UV_map uv = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:noisy").first;
  unfold(mesh, clean);
  warp<N>(mesh, clean, 0.125, random);
  CHECK_IN(context, is_exact<N>(mesh, clean) && SS::is_seamless(mesh, clean, symmetry<N>()));
  check_transitions<N>(mesh, clean, clean, context);
  const std::vector<Kernel::Point_2> points = all_points(mesh, clean);
  const auto report = SS::snap_to_seamless(mesh, clean, symmetry<N>());
  CHECK_IN(context, report.status == SS::Outcome::ALREADY_EXACT);
  CHECK_IN(context, all_points(mesh, clean) == points);
  double growth = 0;
  for(const int exponent : {-20, -30, -40})
    for(unsigned int seed = 1; seed <= 5; ++seed)
      growth = (std::max)(growth, snap_noisy<N>(mesh, clean, uv, std::ldexp(1., exponent), seed,
                                                context + ", noise 2^" + std::to_string(exponent) +
                                                  ", seed " + std::to_string(seed)));
  std::cout << context << ": " << mesh.number_of_faces() << " faces; largest change " << growth
            << " times the noise; seeds 1 to 5" << std::endl;
}

// A single edge between two corners, off by one unit in the last place, is seen.
template <int N>
void test_single_changes(Mesh mesh)
{
  const UV_map uv = uv_map(mesh);
  unfold(mesh, uv);
  std::mt19937 random(4);
  warp<N>(mesh, uv, 0.125, random);
  for(const Halfedge h : mesh.halfedges()) {
    const Kernel::Point_2 before = uv[h];
    uv[h] = Kernel::Point_2(before.x(), std::nextafter(before.y(), 100.));
    CHECK(SS::is_seamless(mesh, uv, symmetry<N>()) == is_exact<N>(mesh, uv));
    CHECK((SS::measure_seamlessness(mesh, uv, symmetry<N>()).number_of_inexact_edges == 0) ==
          is_exact<N>(mesh, uv));
    uv[h] = before;
  }
}

// --- N = 1 and N = 2 -----------------------------------------------------------------------------

template <int N>
void test_square_map(const square_complex::Square_complex& complex, const int divisions,
                     const std::string& name)
{
  const std::string context = name + ", N = " + std::to_string(N);
  Mesh mesh = test_meshes::make_mesh<Kernel>(complex, divisions);
  const UV_map uv = test_meshes::uv_map(mesh);
  CHECK_IN(context, is_exact<N>(mesh, uv) && SS::is_seamless(mesh, uv, symmetry<N>()));
  for(unsigned int seed = 1; seed <= 5; ++seed) {
    const std::vector<Kernel::Point_2> clean = all_points(mesh, uv);
    const auto clean_seams = SS::seam_transitions(mesh, uv, symmetry<N>());
    std::vector<int> rotations;
    for(const Halfedge h : mesh.halfedges())
      rotations.push_back(clean_seams.rotation(h));
    uv_noise::perturb(mesh, uv, 1e-6, seed);
    CHECK_IN(context, !SS::is_seamless(mesh, uv, symmetry<N>()));
    const auto report = SS::snap_to_seamless(mesh, uv, symmetry<N>());
    CHECK_IN(context + report.message, report.status == SS::Outcome::SNAPPED);
    CHECK_IN(context, is_exact<N>(mesh, uv) && report.lost_faces.empty());
    const auto seams = SS::seam_transitions(mesh, uv, symmetry<N>());
    for(const Halfedge h : mesh.halfedges())
      CHECK_IN(context, seams.rotation(h) == rotations[std::size_t(h)]);
    for(const Halfedge h : mesh.halfedges())
      uv[h] = clean[std::size_t(h)];
  }
}

// --- constraints ---------------------------------------------------------------------------------

// Aligned edges: all are along one of the three directions of the lattice, since nothing is warped.
template <int N>
void test_alignment(Mesh mesh, const std::string& name)
{
  const std::string context = "alignment, " + name;
  const UV_map uv = uv_map(mesh);
  unfold(mesh, uv);
  auto is_aligned = mesh.add_property_map<Mesh::Edge_index, bool>("e:aligned", false).first;
  std::map<Mesh::Edge_index, int> functionals;
  std::mt19937 random(9);
  for(const auto e : mesh.edges())
    if(random() % 4 == 0 || mesh.is_border(e)) {
      is_aligned[e] = true;
      const Halfedge h = mesh.is_border(mesh.halfedge(e)) ? mesh.opposite(mesh.halfedge(e))
                                                          : mesh.halfedge(e);
      const Vector v = vector(uv[mesh.prev(h)], uv[h]);
      functionals[e] = v[0] == 0 ? 0 : v[1] == 0 ? 1 : 2;
      CHECK_IN(context, random_complexes::value(functionals[e], v) == 0);
    }
  perturb(mesh, uv, std::ldexp(1., -20), random);
  const auto np = symmetry<N>().edge_is_constrained_map(is_aligned).align_border(true);
  const auto before = SS::measure_seamlessness(mesh, uv, np);
  CHECK_IN(context, before.number_of_misaligned_edges == functionals.size());
  CHECK_IN(context, before.misalignment > 0 && before.misalignment < 1e-5);
  CHECK_IN(context, !SS::is_seamless(mesh, uv, np));
  const auto report = SS::snap_to_seamless(mesh, uv, np);
  CHECK_IN(context + ": " + report.message, report.status == SS::Outcome::SNAPPED);
  CHECK_IN(context, report.lost_faces.empty() && report.run.number_of_align_branches > 0);
  CHECK_IN(context, is_exact<N>(mesh, uv) && SS::is_seamless(mesh, uv, np));
  CHECK_IN(context, report.rms_change <= 1.01 * report.optimal_rms_change);
  for(const auto& [e, f] : functionals) {
    const Halfedge h = mesh.is_border(mesh.halfedge(e)) ? mesh.opposite(mesh.halfedge(e))
                                                        : mesh.halfedge(e);
    const Exact_vector d = exact_vector(uv[mesh.prev(h)], uv[h]);
    CHECK_IN(context, random_complexes::value(f, d) == 0);
  }
}

void test_refused_alignment()
{
  Mesh mesh = triangle(2);
  const UV_map uv = uv_map(mesh);
  unfold(mesh, uv);
  std::mt19937 random(2);
  warp<6>(mesh, uv, 0.25, random);
  const auto report = SS::snap_to_seamless(mesh, uv, symmetry<6>().align_border(true));
  CHECK(report.status == SS::Outcome::NOT_ALIGNED);
  CHECK(report.message.find("u + v") != std::string::npos);
}

// Where a corner is in the chart at the end of a path, and which functional is that of its start.
template <int N>
void carry(const Mesh& mesh, const UV_map uv, const std::vector<int>& rotations,
           const std::vector<Halfedge>& path, Exact_vector& u, int& functional)
{
  for(const Halfedge h : path) {
    const Halfedge o = mesh.opposite(h);
    const Kernel::Point_2 here = uv[mesh.prev(h)], there = uv[o];
    const Exact_vector d{{Rational(u[0] - Rational(here.x())),
                          Rational(u[1] - Rational(here.y()))}};
    const int k = rotations[std::size_t(h)];
    const Exact_vector turned_d = turned<N>(k, d);
    u = {{Rational(turned_d[0] + Rational(there.x())),
          Rational(turned_d[1] + Rational(there.y()))}};
    functional = random_complexes::functional_behind<N>(k, functional);
  }
}

template <int N>
Rational mismatch(const Mesh& mesh, const UV_map uv, const std::vector<int>& rotations,
                  const SS::Connection_constraint<Mesh>& c)
{
  const auto point = [&](const Halfedge h) {
    return Exact_vector{{Rational(uv[h].x()), Rational(uv[h].y())}};
  };
  Exact_vector u = point(c.a);
  int f = c.component;
  carry<N>(mesh, uv, rotations, c.path, u, f);
  return Rational(random_complexes::value(f, u) - random_complexes::value(f, point(c.b)));
}

// Connections and cycles that hold on the clean map, and pins of all three functionals.
template <int N>
void test_further_constraints(Mesh mesh, const std::string& name)
{
  const std::string context = "constraints, " + name;
  const UV_map uv = uv_map(mesh);
  unfold(mesh, uv);
  std::vector<int> rotations(2 * mesh.number_of_edges());
  for(const Halfedge h : mesh.halfedges())
    rotations[std::size_t(h)] = is_interior(mesh, h) ? turns<N>(mesh, uv, h) : 0;
  std::mt19937 random(3);
  std::vector<SS::Connection_constraint<Mesh> > connections;
  std::array<std::size_t, 3> number{{0, 0, 0}};
  for(int i = 0; i < 2000 && connections.size() < 12; ++i) {
    SS::Connection_constraint<Mesh> c;
    c.a = Halfedge(Halfedge::size_type(random() % mesh.number_of_halfedges()));
    c.b = Halfedge(Halfedge::size_type(random() % mesh.number_of_halfedges()));
    c.component = int(random() % 3);
    if(mesh.is_border(c.a) || mesh.is_border(c.b))
      continue;
    c.path = SS::shortest_face_path(mesh, c.a, c.b);
    if(mismatch<N>(mesh, uv, rotations, c) == 0 && c.path.size() > 3) {
      connections.push_back(c);
      ++number[std::size_t(c.component)];
    }
  }
  CHECK_IN(context, number[0] > 0 && number[1] > 0 && number[2] > 0);
  std::vector<SS::Corner_constraint<Mesh> > pins(1);
  const Halfedge corner = mesh.halfedge(*mesh.faces().begin());
  pins[0].terms = {{corner, 2, Rational(3)}};
  pins[0].right_hand_side = Rational(3) * (Rational(uv[corner].x()) + Rational(uv[corner].y()));
  perturb(mesh, uv, std::ldexp(1., -20), random);
  const auto np = symmetry<N>().connection_constraints(connections).corner_constraints(pins);
  CHECK_IN(context, !SS::is_seamless(mesh, uv, np));
  const auto report = SS::snap_to_seamless(mesh, uv, np);
  CHECK_IN(context + ": " + report.message, report.status == SS::Outcome::SNAPPED);
  CHECK_IN(context, is_exact<N>(mesh, uv) && SS::is_seamless(mesh, uv, np));
  for(const auto& c : connections)
    CHECK_IN(context, mismatch<N>(mesh, uv, rotations, c) == 0);
  CHECK_IN(context, Rational(3) * (Rational(uv[corner].x()) + Rational(uv[corner].y())) ==
                      pins[0].right_hand_side);
  // one that does not hold, and one that does not exist
  uv[corner] = Kernel::Point_2(uv[corner].x(), uv[corner].y() + 1e-9);
  CHECK_IN(context, !SS::is_seamless(mesh, uv, np));
  pins[0].terms[0].component = 3;
  const auto refused = SS::snap_to_seamless(mesh, uv, symmetry<N>().corner_constraints(pins));
  CHECK_IN(context, refused.status == SS::Outcome::INVALID_ARGUMENT);
}

// A loop around a torus along each of the three directions closes.
void test_cycles()
{
  Mesh mesh = torus(6, 6);
  const UV_map uv = uv_map(mesh);
  unfold(mesh, uv);
  std::mt19937 random(5);
  std::vector<SS::Cycle_constraint<Mesh> > cycles;
  const std::vector<int> no_rotations(2 * mesh.number_of_edges(), 0);
  // straight through the faces, crossing the edges of two directions in turn
  for(int side = 0; side < 3; ++side) {
    SS::Cycle_constraint<Mesh> cycle;
    Halfedge h = mesh.halfedge(*mesh.faces().begin());
    for(int i = 0; i < side; ++i)
      h = mesh.next(h);
    cycle.corner = h;
    const auto first = mesh.face(h);
    bool left = true;
    do {
      const Halfedge across = left ? mesh.next(h) : mesh.prev(h);
      cycle.path.push_back(across);
      h = mesh.opposite(across);
      left = !left;
    } while(mesh.face(h) != first);
    bool holds = false;
    for(int f = 0; f < 3 && !holds; ++f) {
      cycle.component = f;
      holds = mismatch<6>(mesh, uv, no_rotations, {cycle.corner, cycle.corner, f, cycle.path}) == 0;
    }
    CHECK(holds);
    if(holds)
      cycles.push_back(cycle);
  }
  std::array<bool, 3> has{{false, false, false}};
  for(const auto& c : cycles)
    has[std::size_t(c.component)] = true;
  CHECK(has[0] && has[1] && has[2]);
  perturb(mesh, uv, std::ldexp(1., -20), random);
  const auto np = symmetry<6>().cycle_constraints(cycles);
  const auto report = SS::snap_to_seamless(mesh, uv, np);
  CHECK(report.status == SS::Outcome::SNAPPED);
  CHECK(is_exact<6>(mesh, uv) && SS::is_seamless(mesh, uv, np));
  for(const auto& c : cycles)
    CHECK(mismatch<6>(mesh, uv, no_rotations, {c.corner, c.corner, c.component, c.path}) == 0);
}

// --- the metric ----------------------------------------------------------------------------------

// Turned by 60 degrees, the noisy map is snapped to the turned result, up to the rounding to the
// grid: also where faces are so thin that their orientation is repaired.
void test_turned_maps()
{
  double largest_difference = 0;
  std::size_t number_of_repairs = 0;
  for(unsigned int seed = 1; seed <= 100; ++seed) {
    const std::string context = "turned map, seed " + std::to_string(seed);
    Mesh mesh = subdivided(icosahedron(), 1);
    const UV_map uv = uv_map(mesh);
    unfold(mesh, uv);
    std::mt19937 random(seed);
    warp<6>(mesh, uv, 0.5, random); // many thin faces
    perturb(mesh, uv, std::ldexp(1., -4), random);
    const auto turned_uv = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:turned").first;
    const auto turn = [](const Kernel::Point_2& p) {
      const Vector v = turned<6>(1, Vector{{p.x(), p.y()}}); // no rounding: the bits are few
      return Kernel::Point_2(v[0], v[1]);
    };
    for(const Halfedge h : mesh.halfedges())
      turned_uv[h] = turn(uv[h]);
    const auto np = symmetry<6>().tolerance(0.2);
    const auto report = SS::snap_to_seamless(mesh, uv, np);
    const auto turned_report = SS::snap_to_seamless(mesh, turned_uv, np);
    CHECK_IN(context + report.message, report && turned_report);
    CHECK_IN(context, is_exact<6>(mesh, uv) && is_exact<6>(mesh, turned_uv));
    CHECK_IN(context, report.lost_faces == turned_report.lost_faces);
    CHECK_EQUAL(report.run.number_of_lost_faces, turned_report.run.number_of_lost_faces);
    number_of_repairs += report.run.number_of_lost_faces - report.lost_faces.size();
    for(const Halfedge h : mesh.halfedges()) {
      const Vector d = vector(turn(uv[h]), turned_uv[h]);
      largest_difference = (std::max)({largest_difference, std::abs(d[0]), std::abs(d[1])});
    }
  }
  std::cout << "turned maps: " << number_of_repairs << " repaired faces, largest difference "
            << largest_difference << ", seeds 1 to 100" << std::endl;
  CHECK(number_of_repairs > 0);
  CHECK(largest_difference < 1e-9); // noise is 2^-4
}

// The full system of a complex, in all its sectors, with the squares of all functionals as weights.
template <int N>
exact_reference::System full_system(
  const internal::Cut_complex<internal::Group_of_order<N> >& complex)
{
  constexpr std::size_t columns = N == 3 || N == 6 ? 3 : 2; // per sector: u, v, and u + v
  exact_reference::System system;
  system.columns = columns * complex.coordinates.size();
  using Row = exact_reference::Row;
  const auto add = [&](Row& row, const int sector, const std::array<Rational, 2>& form) {
    for(std::size_t c = 0; c < 2; ++c)
      row.push_back({columns * std::size_t(sector) + c, form[c]});
  };
  const auto unit = [](const std::size_t c) {
    return std::array<Rational, 2>{{Rational(c == 0), Rational(c == 1)}};
  };
  const auto negated = [](const std::array<Rational, 2>& f) {
    return std::array<Rational, 2>{{Rational(-f[0]), Rational(-f[1])}};
  };
  const auto functional = [&](const int f) {
    return std::array<Rational, 2>{{Rational(f != 1), Rational(f != 0)}};
  };
  // the form x -> form(turned x)
  const auto before_turns = [&](const int turns, const std::array<Rational, 2>& form) {
    std::array<Rational, 2> result;
    for(std::size_t c = 0; c < 2; ++c) {
      const auto x = turned<N>(turns, unit(c));
      result[c] = Rational(form[0] * x[0] + form[1] * x[1]);
    }
    return result;
  };
  // sign form(translation of a branch)
  const auto add_translation = [&](Row& row, const std::size_t b, const auto& pair,
                                   const std::array<Rational, 2>& form) {
    add(row, pair.minus, form);
    add(row, pair.plus, negated(before_turns(random_complexes::turns_of<N>(complex, b), form)));
  };
  for(std::size_t b = 0; b < complex.number_of_branches(); ++b)
    for(std::size_t i = 1; i < complex.pairs[b].size(); ++i)
      for(std::size_t c = 0; c < 2; ++c) {
        Row row;
        add_translation(row, b, complex.pairs[b][i], unit(c));
        add_translation(row, b, complex.pairs[b].front(), negated(unit(c)));
        system.add_row(row);
      }
  for(std::size_t c = 0; c < complex.number_of_chains(); ++c)
    for(std::size_t i = 1; i < complex.links[c].size(); ++i) {
      Row row;
      add(row, complex.links[c][i], functional(complex.functional[c]));
      add(row, complex.links[c].front(), negated(functional(complex.functional[c])));
      system.add_row(row);
    }
  for(const auto& path : complex.paths) {
    int f = path.functional;
    for(const auto& crossing : path.crossings) {
      const int g = random_complexes::turns_of<N>(complex, std::size_t(crossing.branch));
      f = random_complexes::functional_behind<N>(crossing.is_along ? g : -g, f);
    }
    Row row;
    std::array<Rational, 2> form = functional(f); // of the point behind
    add(row, path.b, negated(form));
    for(auto crossing = path.crossings.rbegin(); crossing != path.crossings.rend(); ++crossing) {
      const std::size_t b = std::size_t(crossing->branch);
      const int g = random_complexes::turns_of<N>(complex, b);
      if(crossing->is_along) {
        add_translation(row, b, complex.pairs[b].front(), form);
        form = before_turns(g, form);
      } else {
        form = before_turns(-g, form);
        add_translation(row, b, complex.pairs[b].front(), negated(form));
      }
    }
    add(row, path.a, form);
    system.add_row(row);
  }
  for(const auto& equation : complex.equations) {
    Row row;
    for(const auto& term : equation.terms)
      row.push_back({columns * std::size_t(term.sector) + std::size_t(term.coordinate),
                     term.coefficient});
    system.add_row(row, equation.right_hand_side);
  }
  for(std::size_t s = 0; s < complex.coordinates.size() && columns == 3; ++s)
    system.add_row({{3 * s, Rational(1)}, {3 * s + 1, Rational(1)}, {3 * s + 2, Rational(-1)}});
  return system;
}

template <int N>
exact_reference::Rationals all_values(const std::vector<Vector>& coordinates)
{
  exact_reference::Rationals result;
  for(const Vector& u : coordinates) {
    result.push_back(Rational(u[0]));
    result.push_back(Rational(u[1]));
    if(N == 3 || N == 6)
      result.push_back(Rational(Rational(u[0]) + Rational(u[1])));
  }
  return result;
}

// Against the exact optimum in rationals: the sum of squared distances, to 1 % and more.
template <int N>
void test_closeness()
{
  using Group = internal::Group_of_order<N>;
  double worst = 1;
  for(unsigned int seed = 1; seed <= 60; ++seed) {
    const std::string context = "closeness, N = " + std::to_string(N) + ", seed " +
                                std::to_string(seed);
    auto complex = random_complexes::Generator<N>(seed).make(1 + seed % 8, seed % 2 == 0);
    std::mt19937 random(seed);
    for(Vector& u : complex.coordinates)
      for(double& x : u)
        x += std::ldexp(int(random() % 2001) - 1000, -30);
    internal::Complex_solver<Group> solver(complex, internal::Number_format::of<double>());
    internal::Snapped_coordinates<Group> snapped;
    CHECK_IN(context, !solver.solve(snapped));
    const exact_reference::System system = full_system<N>(complex);
    const auto before = all_values<N>(complex.coordinates);
    const auto after = all_values<N>(snapped.coordinates);
    CHECK_IN(context, exact_reference::exactly_satisfies(system, after));
    const auto optimum = exact_reference::optimum_in_closed_form(
      system, before, exact_reference::Rationals(before.size(), Rational(1)));
    CHECK_IN(context, optimum.feasible);
    const double least = CGAL::to_double(optimum.value);
    const double ratio =
      std::sqrt(CGAL::to_double(exact_reference::squared_distance(after, before)) / least);
    worst = (std::max)(worst, ratio);
    // the figure of the report; the squares of Cartesian lengths are half of those of N = 3 and 6
    const double reported =
      snapped.optimal_changes.root(1) * std::sqrt(N == 3 || N == 6 ? 2. : 1.);
    CHECK_IN(context, std::abs(reported / std::sqrt(least) - 1) < 1e-5);
  }
  std::cout << "closeness, N = " << N << ": at most " << worst
            << " times the optimum, seeds 1 to 60" << std::endl;
  CHECK(worst < 1.0001);
}

// Systems with hundreds of cones of 120 degrees, or 60: each leaves a coefficient of 3, or none.
// Pivots without regard to these leave some of 10^10, which amplify the rounding to the grid.
template <int N>
void test_large_system(const unsigned int times)
{
  const std::string context = "large system, N = " + std::to_string(N);
  auto complex = random_complexes::net_of_cuts<N>(subdivided(icosahedron(), times), 1);
  using Solver = internal::Complex_solver<internal::Group_of_order<N> >;
  const auto format = internal::Number_format::of<double>();
  internal::Snapped_coordinates<internal::Group_of_order<N> > snapped;
  CHECK_IN(context, !Solver(complex, format).solve(snapped));
  CHECK_IN(context, random_complexes::is_solution<N>(complex, snapped.coordinates));
  complex.coordinates = snapped.coordinates;
  std::mt19937 random(1);
  for(Vector& u : complex.coordinates)
    for(double& x : u)
      x += std::ldexp(int(random() % 2001) - 1000, -36); // up to 1.5e-8
  CHECK_IN(context, !random_complexes::is_solution<N>(complex, complex.coordinates));
  Solver solver(complex, format);
  CHECK_IN(context, !solver.solve(snapped));
  CHECK_IN(context, random_complexes::is_solution<N>(complex, snapped.coordinates));
  double squares = 0;
  for(std::size_t s = 0; s < complex.coordinates.size(); ++s) {
    const double a = snapped.coordinates[s][0] - complex.coordinates[s][0];
    const double b = snapped.coordinates[s][1] - complex.coordinates[s][1];
    squares += a * a + a * b + b * b;
  }
  const double ratio = std::sqrt(squares) / snapped.optimal_changes.root(1);
  CHECK_IN(context, ratio > 0.99999 && ratio < 1.0001);
  const auto& figures = solver.linear_solver().figures();
  CHECK_EQUAL(figures.number_of_eliminations, 1u);
  CHECK_IN(context, figures.largest_coefficient < 100);
  std::cout << context << ": " << figures.number_of_constraints << " rows in "
            << figures.number_of_unknowns << " unknowns, " << ratio << " times the optimum"
            << std::endl;
}

// --- coordinates, and wrong symmetries -----------------------------------------------------------

void test_conversion()
{
  Mesh mesh = subdivided(icosahedron(), 1);
  const UV_map uv = uv_map(mesh);
  unfold(mesh, uv);
  const std::vector<Kernel::Point_2> lattice = all_points(mesh, uv);
  SS::convert_to_cartesian_coordinates(mesh, uv);
  for(const auto f : mesh.faces()) // equilateral, of side 1
    for(const Halfedge h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
      const Vector v = vector(uv[mesh.prev(h)], uv[h]);
      CHECK(std::abs(std::hypot(v[0], v[1]) - 1) < 1e-14);
    }
  CHECK(!is_exact<6>(mesh, uv));
  SS::convert_to_lattice_coordinates(mesh, uv);
  for(const Halfedge h : mesh.halfedges()) {
    const Vector d = vector(lattice[std::size_t(h)], uv[h]);
    CHECK(std::abs(d[0]) < 1e-13 && std::abs(d[1]) < 1e-13);
  }
  CHECK(SS::snap_to_seamless(mesh, uv, symmetry<6>()));
  CHECK(is_exact<6>(mesh, uv));
}

// Refused, untouched, and the message names the symmetry and, where need be, the conversion.
template <int N>
void check_hint(const Mesh& mesh, const UV_map uv, const std::vector<std::string>& words,
                const std::string& context)
{
  const std::vector<Kernel::Point_2> before = all_points(mesh, uv);
  const auto report = SS::snap_to_seamless(mesh, uv, symmetry<N>());
  CHECK_IN(context, report.status == SS::Outcome::NOT_SEAMLESS);
  for(const std::string& word : words)
    CHECK_IN(context + ": " + report.message, report.message.find(word) != std::string::npos);
  CHECK_IN(context, all_points(mesh, uv) == before);
  CHECK_IN(context, !SS::is_seamless(mesh, uv, symmetry<N>()));
  const auto seams = SS::seam_transitions(mesh, uv, symmetry<N>());
  CHECK_IN(context, !seams && seams.message() == report.message);
}

void test_wrong_symmetries()
{
  std::mt19937 random(6);
  Mesh sphere = subdivided(icosahedron(), 1);
  const UV_map uv = uv_map(sphere);
  unfold(sphere, uv);
  perturb(sphere, uv, std::ldexp(1., -30), random);
  check_hint<4>(sphere, uv, {"N = 6", "lattice", "Rotational_symmetry<6>"}, "60 degrees, N = 4");
  check_hint<1>(sphere, uv, {"N = 6", "lattice"}, "60 degrees, N = 1");
  check_hint<3>(sphere, uv, {"N = 6", "lattice"}, "60 degrees, N = 3");
  SS::convert_to_cartesian_coordinates(sphere, uv);
  const std::string convert = "convert_to_lattice_coordinates()";
  check_hint<4>(sphere, uv, {"N = 6", "Cartesian", convert}, "60 degrees, Cartesian, N = 4");
  check_hint<6>(sphere, uv, {"N = 6", "Cartesian", convert}, "60 degrees, Cartesian, N = 6");

  Mesh six = subdivided(octahedron(), 1);
  const UV_map six_uv = uv_map(six);
  unfold(six, six_uv);
  check_hint<4>(six, six_uv, {"N = 3", "lattice"}, "120 degrees, N = 4");
  CHECK(SS::is_seamless(six, six_uv, symmetry<6>()) && SS::is_seamless(six, six_uv, symmetry<3>()));

  // edges along the axes of a square map could be those of a lattice
  Mesh cube = test_meshes::make_mesh<Kernel>(test_meshes::box(1, 1, 1), 2);
  uv_noise::warp(cube, test_meshes::uv_map(cube), 0.125, 1, [](const Vertex) { return false; });
  check_hint<6>(cube, test_meshes::uv_map(cube), {"N = 4", "default"}, "90 degrees, N = 6");
  check_hint<2>(cube, test_meshes::uv_map(cube), {"N = 4", "default"}, "90 degrees, N = 2");
  Mesh tetrahedron = test_meshes::make_mesh<Kernel>(test_meshes::tetrahedron(), 2);
  check_hint<1>(tetrahedron, test_meshes::uv_map(tetrahedron), {"N = 2"}, "180 degrees, N = 1");

  // a map of no symmetry gets no hint
  for(const Halfedge h : sphere.halfedges())
    uv[h] = Kernel::Point_2(uv[h].x() + 0.1 * (std::size_t(h) % 7), uv[h].y());
  const auto report = SS::snap_to_seamless(sphere, uv, symmetry<6>());
  CHECK(report.status == SS::Outcome::NOT_SEAMLESS);
  CHECK(report.message.find("N = ") == std::string::npos);
  CHECK(report.message.find("tolerance") != std::string::npos);
}

// --- a real map ----------------------------------------------------------------------------------

void test_data_file()
{
  Mesh mesh;
  const UV_map uv = uv_map(mesh);
  if(!hexagonal_maps::read_torus(mesh, uv))
    return;
  CHECK(!is_exact<6>(mesh, uv));
  const std::vector<int> before = signs(mesh, uv);
  const auto report = SS::snap_to_seamless(mesh, uv, symmetry<6>());
  CHECK_IN(report.message, report.status == SS::Outcome::SNAPPED);
  CHECK(is_exact<6>(mesh, uv) && is_exact<1>(mesh, uv));
  CHECK(signs(mesh, uv) == before);
  CHECK_EQUAL(report.run.number_of_cut_edges, 67u);
}

int main()
{
  const CGAL::Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
  for(const Case& c : meshes_of_six_directions())
    test_map<6>(c.mesh, c.name);
  for(const Case& c : meshes_of_three_directions()) {
    test_map<6>(c.mesh, c.name);
    test_map<3>(c.mesh, c.name);
  }
  test_single_changes<6>(icosahedron());
  test_single_changes<3>(octahedron());
  test_square_map<1>(test_meshes::torus(3, 3), 2, "torus");
  test_square_map<1>(test_meshes::genus_2(), 3, "genus 2 of translations");
  test_square_map<2>(test_meshes::tetrahedron(), 4, "tetrahedron");
  test_alignment<6>(subdivided(icosahedron(), 1), "sphere with twelve cones");
  test_alignment<6>(torus(6, 5), "torus");
  test_alignment<6>(triangle(5), "triangle with border");
  test_alignment<3>(subdivided(octahedron(), 2), "sphere with six cones");
  test_refused_alignment();
  test_further_constraints<6>(subdivided(icosahedron(), 1), "sphere with twelve cones");
  test_further_constraints<6>(torus(6, 5), "torus");
  test_further_constraints<3>(subdivided(octahedron(), 2), "sphere with six cones");
  test_cycles();
  test_turned_maps();
  test_large_system<3>(3);
  test_large_system<3>(4);
  test_large_system<6>(4);
  test_closeness<3>();
  test_closeness<4>();
  test_closeness<6>();
  test_conversion();
  test_wrong_symmetries();
  test_data_file();
  return report_checks();
}
