// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_INTEGER_ROUNDING_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_INTEGER_ROUNDING_H

#include <CGAL/license/Seamless_snapping.h>

// From a parametrization to the integer-grid map near by: which integers the translations of the
// branches, the cones, and the levels of the aligned chains are rounded to, so that these agree.
// Rounding each on its own would contradict itself wherever branches meet. Instead, the complex is
// solved on the grid of the integers: all that it asks for holds there, whatever is rounded.
//
// The nodes that need not be integers, that is all but cones and ends of slits, would disturb this
// by their own rounding. They are moved to the origin first, by what makes no difference to
// translations: where branches meet without such a point, all sectors are shifted by the
// coordinates of the first, turned as the branches turn them.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/complex/Grid_coordinates.h>
#include <CGAL/Seamless_snapping/internal/complex/row_origins.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename Group>
class Integer_rounding
{
  using Complex = Cut_complex<Group>;
  using Vector = typename Complex::Vector;
  using Element = typename Group::Element;
  static constexpr std::size_t dimension = Group::dimension;

public:
  // \param points sectors that are to have integer coordinates; ascending
  Integer_rounding(const Complex& complex, const std::vector<Sector_index>& points)
    : m_complex(complex), m_points(points), m_links(complex), m_shifted(complex)
  {
    for(std::size_t v = 0; v < complex.number_of_vertices(); ++v)
      if(complex.is_node[v])
        move_to_origin(v);
  }

  // Keeps a rounding as it is.
  void fix(const Rounding<Group>& rounding) { m_shifted.equations.push_back(rounding.equation); }

  // The equations that make the map an integer-grid map; or the reason why there are none.
  std::optional<Refusal> run(const Number_format& format, std::vector<Rounding<Group> >& roundings);

private:
  void move_to_origin(const std::size_t v)
  {
    const Sector_index first = m_complex.first_sector[v], end = m_complex.first_sector[v + 1];
    std::vector<char> is_reached(std::size_t(end - first), false);
    for(Sector_index s = first; s != end; ++s)
      if(!is_reached[std::size_t(s - first)])
        move_to_origin(s, first, end, is_reached);
  }

  // All sectors around the vertex that branches link to `root`: the border may divide them. But not
  // if one of them is a point.
  void move_to_origin(const Sector_index root, const Sector_index first, const Sector_index end,
                      std::vector<char>& is_reached)
  {
    std::vector<std::pair<Sector_index, Element> > sectors(1, {root, Group::identity()});
    is_reached[std::size_t(root - first)] = true;
    std::array<bool, std::size_t(Group::number_of_functionals)> is_fixed{};
    for(std::size_t i = 0; i < sectors.size(); ++i) {
      const auto [s, g] = sectors[i];
      for(const int f : m_links.functionals(s))
        is_fixed[std::size_t(Group::act(Group::inverse(g), f).index)] = true;
      if(m_links.is_pinned(s))
        is_fixed.fill(true);
      for(const auto& link : m_links.links(s))
        if(link.sector >= first && link.sector < end &&
           !is_reached[std::size_t(link.sector - first)]) {
          is_reached[std::size_t(link.sector - first)] = true;
          sectors.emplace_back(link.sector, Group::compose(link.element, g));
        }
    }
    if(std::any_of(sectors.begin(), sectors.end(), [&](const auto& reached) {
         return std::binary_search(m_points.begin(), m_points.end(), reached.first);
       }))
      return;
    const Vector origin = add_origin(root, is_fixed);
    for(const auto& [s, g] : sectors) {
      const Vector shift = Group::apply(g, origin);
      for(std::size_t c = 0; c < dimension; ++c)
        m_shifted.coordinates[std::size_t(s)][c] -= shift[c];
    }
  }

  // By what the sector is moved, so that coordinates become 0 and the fixed functionals stay. Adds
  // the equations of the former.
  template <typename IsFixed>
  Vector add_origin(const Sector_index s, const IsFixed& is_fixed)
  {
    const Vector& u = m_complex.coordinates[std::size_t(s)];
    Vector origin{};
    const auto move = [&](const std::size_t c) {
      origin[c] = u[c];
      m_shifted.equations.push_back({{{s, int(c), Exact_rational(1)}}, Exact_rational(0)});
    };
    const auto number = std::count(is_fixed.begin(), is_fixed.end(), true);
    if(number > 1)
      return origin;
    if(!is_fixed[0])
      move(0);
    if(is_fixed[0] || number == 0)
      move(1);
    if(number == 1 && !is_fixed[0] && !is_fixed[1]) // u + v stays
      origin[1] = -origin[0];
    return origin;
  }

  void collect(const Reduced_system<Group>& system, const Linear_solver& solver,
               const Linear_solution& solution, std::vector<Rounding<Group> >& roundings) const
  {
    const auto value = [&](const Column_index column) -> double {
      const Component_index k = solver.component(column);
      const double x = static_cast<double>(solution.x[std::size_t(column)]);
      return k < 0 ? 0 : x * solution.grids[std::size_t(k)].step();
    };
    for(const Sector_index s : m_points)
      for(std::size_t c = 0; c < dimension; ++c) {
        const Column_index column = system.unknown(s) + Column_index(c);
        const double u = m_complex.coordinates[std::size_t(s)][c];
        const double rounded = solver.component(column) < 0 ? std::round(u) : value(column);
        roundings.push_back({Rounding<Group>::POINT, std::size_t(s), rounded, u,
                             {{{s, int(c), Exact_rational(1)}}, Exact_rational(rounded)}});
      }
    for(std::size_t b = 0; b < m_complex.number_of_branches(); ++b)
      for(std::size_t c = 0; c < dimension; ++c) {
        double rounded;
        if(system.translation(b) >= 0) {
          rounded = value(system.translation(b) + Column_index(c));
        } else {
          const auto& pair = m_complex.pairs[b].front();
          rounded = value(system.unknown(pair.minus) + Column_index(c));
          for(std::size_t d = 0; d < dimension; ++d)
            rounded -= Group::matrix(m_complex.element[b])[c][d] *
                       value(system.unknown(pair.plus) + Column_index(d));
        }
        roundings.push_back(translation_is(b, c, rounded));
      }
    for(std::size_t i = 0; i < m_complex.number_of_chains(); ++i) {
      const int f = m_complex.functional[i];
      const Sector_index s = m_complex.links[i].front();
      const Vector at_node{value(system.unknown(s)), value(system.unknown(s) + 1)};
      const double rounded =
        system.level(i) >= 0 ? value(system.level(i)) : Group::value(f, at_node);
      typename Complex::Equation equation{{}, Exact_rational(rounded)};
      for(std::size_t c = 0; c < dimension; ++c)
        if(Group::functional(f)[c] != 0)
          equation.terms.push_back({s, int(c), Exact_rational(Group::functional(f)[c])});
      const double level = Group::value(f, m_complex.coordinates[std::size_t(s)]);
      roundings.push_back({Rounding<Group>::CHAIN, i, rounded, level,
                           std::move(equation)});
    }
  }

  // Component c of u- - g u+, at the beginning of the branch.
  Rounding<Group> translation_is(const std::size_t b, const std::size_t c,
                                 const double rounded) const
  {
    const auto& pair = m_complex.pairs[b].front();
    const auto& row = Group::matrix(m_complex.element[b])[c];
    typename Complex::Equation equation{{{pair.minus, int(c), Exact_rational(1)}},
                                        Exact_rational(rounded)};
    double t = m_complex.coordinates[std::size_t(pair.minus)][c];
    for(std::size_t d = 0; d < dimension; ++d)
      if(row[d] != 0) {
        equation.terms.push_back({pair.plus, int(d), Exact_rational(-row[d])});
        t -= row[d] * m_complex.coordinates[std::size_t(pair.plus)][d];
      }
    return {Rounding<Group>::BRANCH, b, rounded, t, std::move(equation)};
  }

  const Complex& m_complex;
  const std::vector<Sector_index>& m_points;
  Sector_links<Group> m_links;
  Complex m_shifted;
};

// Outside of the class, so that programs that share a library can share this, too.
template <typename Group>
std::optional<Refusal> Integer_rounding<Group>::run(const Number_format& format,
                                                    std::vector<Rounding<Group> >& roundings)
{
  const Reduced_system<Group> system(m_shifted);
  const Linear_solver solver(system.rows(), system.weights(), format,
                             system.number_of_representable_columns(), false);
  if(!solver.is_consistent())
    return Refusal(Outcome::INCONSISTENT, {}, solver.certificate());
  const Coordinate_components<Group> components(m_shifted, system, solver);
  const std::vector<Grid> integers(solver.number_of_components(), Grid(format, 0));
  const Target_shifts<Group> no_shifts;
  const Grid_coordinates<Group> coordinates(m_shifted, integers, no_shifts);
  const Linear_target target{
    integers, Linear_target_builder<Group>(m_shifted, system, components, coordinates).build()};
  Linear_solution solution;
  if(solver.solve(target, solution) >= 0 ||
     std::any_of(solution.grids.begin(), solution.grids.end(),
                 [](const Grid& grid) { return grid.exponent() < 0; }))
    return Refusal(Outcome::NOT_REPRESENTABLE, {});
  collect(system, solver, solution, roundings);
  return std::nullopt;
}

// If integers are far, coordinates that are rounded independently stretch and shrink the faces
// between them. So integers are chosen one after another, as Bommes, Zimmer and Kobbelt do
// (Mixed-Integer Quadrangulation, 2009): the nearest first, and the map follows before the next
// ones are. What is chosen is exact: there always are integers for the rest.

// A part of those that are left is chosen at a time, and all that nothing keeps from being integers
// any more. So n of them take at most 4 log(n) + 4 steps, each a solution of the factorized system
// or, for those that move others, some more. How these respond to each other is a dense matrix: to
// bound it, all but so many are chosen at once.
constexpr std::size_t parts_of_roundings = 4;
constexpr std::size_t most_that_follow = 4000;
constexpr double nearly_integer = 1e-4;

// \param spreader of the complex
// \param roundings all of them; receives others. Distances stay distances from the complex.
// \return whether there are others
template <typename Group, typename Spreader>
bool round_one_after_another(const Cut_complex<Group>& complex,
                             const std::vector<Sector_index>& points, const Number_format& format,
                             Spreader& spreader, std::vector<Rounding<Group> >& roundings)
{
  Cut_complex<Group> moved = complex;
  std::vector<Rounding<Group> > now = roundings, chosen, more;
  std::vector<std::size_t> left(now.size());
  std::iota(left.begin(), left.end(), std::size_t(0));
  for(;;) {
    std::sort(left.begin(), left.end(), [&](const std::size_t i, const std::size_t j) {
      return std::make_pair(now[i].distance(), i) < std::make_pair(now[j].distance(), j);
    });
    std::size_t part = (left.size() + parts_of_roundings - 1) / parts_of_roundings, n = 0;
    if(left.size() > most_that_follow)
      part = (std::max)(part, left.size() - most_that_follow);
    more.clear();
    for(; n < left.size() && (n < part || now[left[n]].distance() < nearly_integer); ++n) {
      more.push_back(now[left[n]]);
      more.back().value = roundings[left[n]].value;
    }
    left.erase(left.begin(), left.begin() + std::ptrdiff_t(n));
    if(left.empty())
      break;
    if(!(chosen.empty() ? spreader.compute(more) : spreader.compute_further(more)))
      return false;
    chosen.insert(chosen.end(), more.begin(), more.end());
    for(std::size_t s = 0; s < moved.number_of_sectors(); ++s) {
      const auto d = spreader(Sector_index(s));
      for(std::size_t c = 0; c < Group::dimension; ++c)
        moved.coordinates[s][c] = complex.coordinates[s][c] + d[c];
    }
    Integer_rounding<Group> rounding(moved, points);
    for(const Rounding<Group>& r : chosen)
      rounding.fix(r);
    now.clear();
    if(rounding.run(format, now))
      return false;
  }
  for(std::size_t i = 0; i < roundings.size(); ++i) {
    now[i].value = roundings[i].value;
    roundings[i] = std::move(now[i]);
  }
  return true;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_INTEGER_ROUNDING_H
