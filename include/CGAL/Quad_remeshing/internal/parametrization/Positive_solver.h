// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_POSITIVE_SOLVER_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_POSITIVE_SOLVER_H

#include <CGAL/license/Quad_remeshing.h>

// From a field to coordinates whose faces are positive: a least-squares solution, stiffening,
// untangling, and, if alignment leaves no such coordinates, the release of edges.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Map_part.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Parametrization_options.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Surface_complex.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Quad_remeshing/internal/parametrization/poisson.h>
#include <CGAL/Seamless_snapping/internal/complex/Free_coordinates.h>
#include <CGAL/Seamless_snapping/internal/untangling/untangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

inline void tell_flips(const std::size_t number)
{ Progress::tell_each_second([&] { return counted(number, "flipped face") + " in the map"; }); }

inline bool has_features(const Triangle_surface& surface)
{
  for(Corner_index h = 0; h < surface.number_of_halfedges(); ++h)
    if(surface.is_aligned[h] && !surface.is_border_edge(h))
      return true;
  return false;
}

// Solves, stiffens and solves again; returns the free unknowns of the solution with the fewest
// flipped faces. Where flips can't be avoided the weights grow until the system can't be solved any
// more, which ends it. A round is as much work for one flip as for many: where they are few on a
// large surface, `mend(unknowns)` changes what is around them, and returns how many it left.
// \param system with the coefficients 0
template <typename Mend, typename Report>
std::vector<double>
solve_with_stiffening(const Triangle_surface& surface, const std::vector<double>& angles,
                      const Surface_complex& complex,
                      const Free_coordinates<Quarter_turns>& coordinates,
                      const Coordinate_table& table, const long number_of_rounds,
                      const Mend& mend, Sparse_system& system, Report& report)
{
  constexpr std::size_t faces_of_a_flip = 2000; // fewer flips of a large surface are few
  const std::size_t few_flips =
    is_large(surface) ? std::size_t(surface.number_of_faces()) / faces_of_a_flip : 0;
  std::vector<double> weights(surface.number_of_faces(), 1), best;
  for(long round = 0; ; ++round, system.set_zero()) {
    std::vector<double> unknowns;
    try {
      factor_poisson(surface, complex, table, weights, system);
      unknowns = solve_poisson(
        surface,
        [&](const Corner_index h) { return wanted_difference(surface, angles, h); },
        complex, table, weights, system);
    } catch(Refusal& refusal) {
      if(round > 0)
        return best;
      refusal.message += remedy(has_features(surface) ? "mark fewer features, or remesh the input"
                                                      : "remesh the input");
      throw;
    }
    const Coordinates uv = coordinates.evaluate(unknowns);
    const std::size_t flips = number_of_flips(surface, complex, uv);
    if(round < number_of_rounds && flips > 0)
      stiffen(surface, complex, uv, weights);
    report.number_of_stiffening_rounds += round > 0 ? 1 : 0;
    tell_flips(flips);
    if(round == 0 || flips < report.number_of_flipped_faces) {
      best.swap(unknowns);
      report.number_of_flipped_faces = flips;
      unknowns = best;
      const std::size_t left = flips > 0 && flips <= few_flips ? mend(unknowns) : flips;
      if(left < flips) {
        best.swap(unknowns);
        report.number_of_flipped_faces = left;
      }
    }
    if(round == number_of_rounds || report.number_of_flipped_faces == 0)
      return best;
  }
}

// The free unknowns of coordinates that meet all constraints, up to roundings.
// \param system factorized for weights of 1
inline std::vector<double>
unknowns_of(const Triangle_surface& surface, const Coordinates& uv, const Surface_complex& complex,
            const Coordinate_table& table, Sparse_system& system)
{
  const auto difference = [&](const Corner_index h) {
    const auto &p = uv[complex.sector(surface.prev(h))], &q = uv[complex.sector(h)];
    return std::array<double, 2>{q[0] - p[0], q[1] - p[1]};
  };
  return solve_poisson(surface, difference, complex, table,
                       std::vector<double>(surface.number_of_faces(), 1), system);
}

// The shortest of some edges that are aligned and can be released: borders have to stay straight.
class Shortest_feature
{
public:
  explicit Shortest_feature(const Triangle_surface& surface) : m_surface(surface) { }

  void consider(const Corner_index h)
  {
    if(m_surface.is_aligned[h] && !m_surface.is_border_edge(h) &&
       (m_best == no_index || m_surface.length[h] < m_surface.length[m_best]))
      m_best = h;
  }

  // No index if there is none.
  Corner_index halfedge() const { return m_best; }

private:
  const Triangle_surface& m_surface;
  Corner_index m_best = no_index;
};

// The field can follow two edges of a face at most. Returns the edges that were released.
inline std::vector<Corner_index> release_third_edges(Triangle_surface& surface)
{
  std::vector<Corner_index> released;
  for(Corner_index h = 0; h < surface.number_of_halfedges(); h += 3) {
    Shortest_feature best(surface);
    for(Corner_index g = h; g < h + 3; ++g)
      best.consider(g);
    if(surface.is_aligned[h] && surface.is_aligned[h + 1] && surface.is_aligned[h + 2] &&
       best.halfedge() != no_index)
      released.push_back(release_edge(surface, best.halfedge()));
  }
  return released;
}

// How many edges to release at once for each face: twice as many each time that the faces have not
// become fewer, because all of the surface is solved for again.
class Release_size
{
public:
  static constexpr std::size_t most = 64; // feature edges that are released at once

  std::size_t get() const { return m_number; }

  // Returns whether the faces have become fewer.
  bool update(const std::size_t number_of_faces)
  {
    const bool is_less = number_of_faces < m_fewest_faces;
    m_number = is_less ? 1 : (std::min)(2 * m_number, most);
    m_fewest_faces = (std::min)(m_fewest_faces, number_of_faces);
    return is_less;
  }

private:
  std::size_t m_fewest_faces = static_cast<std::size_t>(-1), m_number = 1;
};

// Invariant: the edges that were released are aligned no more, all others are as they were.
template <typename Report>
class Positive_solver
{
  using Coordinate_rows = Free_coordinates<Quarter_turns>;

public:
  // \param surface loses the alignment of the edges that are released
  Positive_solver(Triangle_surface& surface, const std::vector<char>& is_cut,
                  const std::vector<Quarter_turns::Element>& rotation,
                  const std::vector<double>& angles, const std::vector<int>& index,
                  const Parametrization_options& options, const Make_solver make_solver,
                  Report& report)
    : m_surface(surface), m_is_cut(is_cut), m_rotation(rotation), m_angles(angles),
      m_index(index), m_options(options), m_solver(report.seconds_in_solvers, make_solver),
      m_report(report)
  { }

  void run(const std::size_t number_of_untangling_iterations)
  {
    m_iterations_left = double(number_of_untangling_iterations);
    Release_size number_of_edges; // per stuck face
    for(std::size_t round = 0; ; ++round) {
      make_complex_of_faces_with_area();
      const Coordinates reached = m_uv; // in the last round, before attempts close by
      const double multiplications_before = m_solver.multiplications;
      std::optional<Sparse_system> system(std::in_place, m_rows->number_of_unknowns(), m_solver);
      std::vector<double> unknowns = solve_with_stiffening(
        m_surface, m_angles, *m_complex, *m_rows, *m_table,
        round == 0 ? m_options.number_of_stiffening_rounds : 0,
        [&](std::vector<double>& u) {
          if(round == 0) // else the system is used once more
            m_solver.reset(); // frees memory
          const std::size_t left = stiffen_near_flips(u);
          if(left == 0 || !m_options.may_release || m_iterations_left == 0)
            return left;
          untangle(u, Untangling::CLOSE_BY);
          return number_of_flips(m_surface, *m_complex, m_uv);
        },
        *system, m_report);
      if(round == 0)
        m_report.number_of_flips_before_untangling = m_report.number_of_flipped_faces;
      else if(m_report.number_of_flipped_faces > 0)
        keep_better(reached, *system, unknowns);
      if(round > 0)
        spend(cost_of_complex() + (m_solver.multiplications - multiplications_before) /
                                    multiplications_over_a_triangle);
      std::vector<std::size_t> stuck;
      const double iterations_before = m_iterations_left;
      m_uv = m_rows->evaluate(unknowns);
      m_solver.reset(); // frees memory
      system.reset();
      if(number_of_flips(m_surface, *m_complex, m_uv) > 0)
        stuck = untangle(unknowns, m_options.may_release ? Untangling::NEAR_BY
                                                         : Untangling::ANGLES_FIRST);
      if(!number_of_edges.update(stuck.size())) // what has not helped counts threefold
        m_iterations_left -=
          (std::min)(m_iterations_left, 2 * (iterations_before - m_iterations_left));
      tell_flips(stuck.size());
      const bool is_last = round == largest_number_of_rounds || m_iterations_left == 0;
      if(!stuck.empty() && m_options.may_release && !is_last &&
         release(stuck, number_of_edges.get()))
        continue;
      if(!stuck.empty() && m_options.may_release)
        untangle(unknowns, Untangling::ANGLES_FIRST);
      return;
    }
  }

  const Surface_complex& complex() const { return *m_complex; }
  Coordinates take() { return std::move(m_uv); }

  // One halfedge of each edge that was released.
  const std::vector<Corner_index>& released() const { return m_released; }

private:
  // Takes from what may be spent: after the first solution, all that follows from releases.
  // \param work in iterations over a face
  void spend(const double work)
  {
    const double iterations = work / double(m_surface.number_of_faces());
    m_iterations_left -= (std::min)(iterations, m_iterations_left);
    m_iterations += iterations;
    m_report.number_of_untangling_iterations = std::size_t(std::ceil(m_iterations));
  }

  // Solves with stiffening for what is around the flips that are left, and holds the rest: twice as
  // far around each time that they have not become fewer. Leaves the fewest, and returns how many.
  std::size_t stiffen_near_flips(std::vector<double>& unknowns)
  {
    constexpr int most_rounds = 12; // rounds of stiffening near flips
    std::size_t edges = 20;
    const auto wanted = [&](const Corner_index h)
    { return wanted_difference(m_surface, m_angles, h); };
    std::vector<double> weights(m_surface.number_of_faces(), 1);
    Coordinates best = m_rows->evaluate(unknowns), last = best;
    std::size_t fewest = number_of_flips(m_surface, *m_complex, best);
    for(int round = 0; round < most_rounds && fewest > 0; ++round) {
      stiffen(m_surface, *m_complex, last, weights);
      const std::vector<std::size_t> faces =
        faces_near_flips(m_surface, *m_complex, best, edges);
      if(2 * faces.size() > std::size_t(m_surface.number_of_faces()))
        return fewest;
      const Map_part part(m_surface, m_index, *m_complex, *m_table, unknowns.size(), best, faces);
      std::vector<double> next = unknowns;
      try {
        Timed_solver solver(m_report.seconds_in_solvers, m_solver.make);
        Sparse_system system(part.map().number_of_unknowns, solver);
        part.add(part.solve_poisson(faces, wanted, weights, system), next);
      } catch(const Refusal&) {
        return fewest; // as over all faces
      }
      last = m_rows->evaluate(next);
      const std::size_t flips = number_of_flips(m_surface, *m_complex, last);
      if(flips < fewest) {
        fewest = flips;
        best = last;
        unknowns.swap(next);
      } else {
        edges *= 2;
      }
    }
    return fewest;
  }

  // The cost of making the complex, or a system of it.
  double cost_of_complex() const
  {
    return 2 * double(m_surface.number_of_faces()) +
           double(m_table->number_of_terms_of_sums()) / 4;
  }

  void make_complex()
  {
    m_complex.emplace(m_surface, m_is_cut, m_rotation, m_angles);
    m_rows.emplace(m_complex->complex());
    m_table.emplace(*m_rows, m_complex->number_of_sectors());
  }

  // Releases edges where the constraints leave faces no area: many at once where no iterations are
  // left, so that there are few rounds.
  void make_complex_of_faces_with_area()
  {
    Release_size number_of_edges; // per face
    make_complex();
    if(m_options.may_release)
      for(std::vector<std::size_t> faces = degenerate_faces(); !faces.empty();
          faces = degenerate_faces()) {
        number_of_edges.update(faces.size());
        if(!release(faces, m_iterations_left > 0 ? number_of_edges.get() : Release_size::most))
          return;
        make_complex();
        spend(cost_of_complex());
      }
  }

  // The result of untangling before edges were released satisfies the remaining constraints: goes
  // on from there if it has fewer flips.
  void keep_better(const Coordinates& uv, Sparse_system& system,
                   std::vector<double>& unknowns)
  {
    std::vector<double> reached = unknowns_of(m_surface, uv, *m_complex, *m_table, system);
    const std::size_t flips =
      number_of_flips(m_surface, *m_complex, m_rows->evaluate(reached));
    if(flips < m_report.number_of_flipped_faces) {
      m_report.number_of_flipped_faces = flips;
      unknowns.swap(reached);
    }
  }

  // Returns the faces that are not positive afterwards. On large surfaces, what is around flips is
  // tried by itself first: unknowns such as the translations of cuts make patches of all faces.
  // If coordinates are long sums of these, edges are released before such a patch is tried.
  std::vector<std::size_t> untangle(std::vector<double>& unknowns, const Untangling how)
  {
    constexpr std::size_t edges_around = 10; // faces so near a flip are untangled first
    std::vector<std::size_t> faces(std::size_t(m_surface.number_of_faces()));
    const bool has_long_sums = m_table->has_long_sums();
    if(is_large(m_surface) || has_long_sums) {
      const std::vector<std::size_t> stuck =
        untangle(unknowns, how,
                 faces_near_flips(m_surface, *m_complex, m_rows->evaluate(unknowns), edges_around));
      if(stuck.empty() || how == Untangling::CLOSE_BY ||
         (has_long_sums && how == Untangling::NEAR_BY))
        return stuck;
    }
    std::iota(faces.begin(), faces.end(), std::size_t(0));
    return untangle(unknowns, how, faces);
  }

  std::vector<std::size_t> untangle(std::vector<double>& unknowns, const Untangling how,
                                    const std::vector<std::size_t>& faces)
  {
    const Map_part part(m_surface, m_index, *m_complex, *m_table, unknowns.size(),
                        m_rows->evaluate(unknowns), faces);
    Untangler<double> untangler(part.map());
    const double all = double(m_surface.number_of_faces()), of_part = double(faces.size());
    spend(untangler.run(m_iterations_left * all / of_part, how) * of_part);
    part.add(untangler.unknowns(), unknowns);
    m_uv = m_rows->evaluate(unknowns);
    std::vector<std::size_t> stuck = part.map().not_positive(untangler.unknowns());
    for(std::size_t& f : stuck)
      f = faces[f];
    return stuck;
  }

  // The faces with one u, or one v, at all corners by the constraints.
  std::vector<std::size_t> degenerate_faces() const
  {
    std::vector<std::size_t> result;
    const auto is_constant = [&](const Corner_index h, const std::size_t c) {
      return m_table->are_equal(m_complex->sector(h), m_complex->sector(m_surface.prev(h)), c);
    };
    for(Flat_face_index f = 0; f < m_surface.number_of_faces(); ++f)
      for(std::size_t c = 0; c < 2; ++c)
        if(is_constant(3 * f, c) && is_constant(3 * f + 1, c)) {
          result.push_back(std::size_t(f));
          break;
        }
    return result;
  }

  // Releases so many edges of each face, one after the other: the shortest feature of its own, or
  // else of a vertex; of one near by where large patches are not tried. Returns whether there is
  // one.
  bool release(const std::vector<std::size_t>& faces, const std::size_t edges_per_face)
  {
    const std::size_t before = m_released.size();
    const std::size_t most_vertices = m_table->has_long_sums() ? 100 : 3;
    for(std::size_t k = 0; k < faces.size() * edges_per_face; ++k) {
      const std::size_t f = faces[k / edges_per_face];
      Shortest_feature best(m_surface);
      std::vector<std::size_t> vertices;
      for(Corner_index h = Corner_index(3 * f); h < Corner_index(3 * f + 3); ++h) {
        best.consider(h);
        vertices.push_back(m_surface.vertex(h));
      }
      for(std::size_t i = 0; i < vertices.size() && best.halfedge() == no_index; ++i)
        for_each_corner(m_surface, vertices[i], [&](const Corner_index g) {
          best.consider(g);
          best.consider(m_surface.next(g));
          const std::size_t v = m_surface.source(g);
          if(vertices.size() < most_vertices &&
             std::find(vertices.begin(), vertices.end(), v) == vertices.end())
            vertices.push_back(v);
        });
      if(best.halfedge() != no_index)
        m_released.push_back(release_edge(m_surface, best.halfedge()));
    }
    return m_released.size() > before;
  }

  static constexpr std::size_t largest_number_of_rounds = 20; // rounds of untangling and release

  Triangle_surface& m_surface;
  const std::vector<char>& m_is_cut;
  const std::vector<Quarter_turns::Element>& m_rotation;
  const std::vector<double>& m_angles;
  const std::vector<int>& m_index; // per vertex
  const Parametrization_options& m_options;
  Timed_solver m_solver;
  Report& m_report;
  double m_iterations_left = 0, m_iterations = 0; // of untangling, over all faces
  std::optional<Surface_complex> m_complex;
  std::optional<Coordinate_rows> m_rows;
  std::optional<Coordinate_table> m_table; // of these
  Coordinates m_uv;
  std::vector<Corner_index> m_released;
};

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_POSITIVE_SOLVER_H
