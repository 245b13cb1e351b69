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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SPREAD_ROUNDING_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SPREAD_ROUNDING_H

#include <CGAL/license/Seamless_snapping.h>

// Roundings of the size of a face would turn faces beside the cuts if only the vertices of the cuts
// moved. So they are spread over the surface first: all vertices move, by the displacement whose
// Dirichlet energy in the domain is least among those that give the cuts their rounded
// translations, the cones their coordinates, and the aligned edges their levels. What follows is
// exact; this is not, and need not be.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Linear_snapping/internal/linear/Range_space_solver.h>
#include <CGAL/Linear_snapping/internal/linear/Sparse_cholesky.h>
#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/complex/integer_rounding.h>
#include <CGAL/Seamless_snapping/internal/mesh/Flat_surface.h>

#include <boost/container/small_vector.hpp>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant: the displacement of a corner is g x + c, where x belongs to a vertex of the mesh. If
// only some roundings are given, changes of the other translations and levels are unknowns, too.
template <typename Group>
class Rounding_spreader
{
  using Cuts = Surface_cuts<Group, Corner_index>;
  using Vector = typename Cut_complex<Group>::Vector;
  using Element = typename Group::Element;
  using Matrix = Eigen::SparseMatrix<double>;
  using Solver = Sparse_cholesky<Matrix>;
  static constexpr std::size_t dimension = Group::dimension;
  static constexpr std::size_t number_of_functionals = std::size_t(Group::number_of_functionals);

  // Unknowns times their factors, and a number.
  struct Form
  {
    boost::container::small_vector<std::pair<std::size_t, double>, 4> terms;
    double constant = 0;

    void add(const Form& other, const double factor)
    {
      for(const auto& [unknown, f] : other.terms)
        terms.emplace_back(unknown, factor * f);
      constant += factor * other.constant;
    }
  };
  using Form_vector = std::array<Form, dimension>;

  struct Place
  {
    std::size_t vertex;
    Element element;
    Form_vector offset;
  };

  // u(sector) = g u(here) + t, after the rounding.
  struct Link
  {
    Sector_index sector;
    Element element;
    Form_vector translation;
  };

  using Roundings = std::vector<Rounding<Group> >;

public:
  Rounding_spreader(Flat_surface& surface, const Cuts& cuts)
    : m_surface(surface), m_cuts(cuts), m_complex(cuts.complex),
      m_first_translation(dimension * surface.number_of_vertices()),
      m_first_level(m_first_translation + dimension * m_complex.number_of_branches()),
      m_number_of_unknowns(m_first_level + m_complex.number_of_chains()),
      m_is_fixed(number_of_functionals * surface.number_of_vertices())
  {
    weigh_edges();
    find_sectors();
    for(std::size_t f = 0; f < m_weights.size() / 3; ++f)
      if(is_free(f))
        add_face(f);
    m_free_faces.swap(m_triplets);
  }

  // The displacement that makes the roundings: all of the complex, or some. Returns false if it
  // can't be computed.
  bool compute(const Roundings& roundings)
  {
    m_further.reset();
    m_rhs = Eigen::VectorXd::Zero(Eigen::Index(m_number_of_unknowns));
    m_triplets = m_free_faces;
    link_sectors(roundings);
    m_places.assign(m_complex.number_of_sectors(), {});
    for(std::size_t v = 0; v < m_complex.number_of_vertices(); ++v)
      place_sectors(v);
    fix_coordinates(roundings);
    for(std::size_t f = 0; f < m_weights.size() / 3; ++f)
      if(!is_free(f))
        add_face(f);
    add_conditions();
    return factorize(roundings) && solve();
  }

  // As computed last, but with these roundings of the complex, too. Takes less time.
  bool compute_further(const Roundings& roundings)
  {
    if(!m_further)
      m_further.emplace(m_solver, m_rhs);
    for(const Rounding<Group>& r : roundings) {
      const Form f = change(r);
      m_further->add({f.terms.begin(), f.terms.end()}, r.rounded - r.value - f.constant);
    }
    m_solution = m_further->solution();
    return m_solution.allFinite();
  }

  // The energy of the computed displacement: the changes of edge vectors.
  double energy() const
  {
    double result = 0;
    for(std::size_t i = 0; i < m_weights.size(); ++i) {
      const Vector a = displacement(place(i - i % 3 + (i + 1) % 3)),
                   b = displacement(place(i - i % 3 + (i + 2) % 3));
      for(int k = 0; k < Group::number_of_functionals; ++k)
        result += m_weights[i] / 2 * std::pow(Group::value(k, a) - Group::value(k, b), 2);
    }
    return result;
  }

  // The faces that it turns over, up to rounding.
  std::size_t number_of_flips() const
  {
    std::size_t result = 0;
    for(Corner_index first = 0; first < m_surface.number_of_corners(); first += 3) {
      Uv_triangle before, after;
      for(std::size_t i = 0; i < 3; ++i) {
        const Vector d = displacement(place(std::size_t(first) + i));
        before[i] = m_surface.uv(first + Corner_index(i));
        after[i] = {{before[i][0] + d[0], before[i][1] + d[1]}};
      }
      result += orientation(before) == CGAL::POSITIVE && orientation(after) != CGAL::POSITIVE ? 1
                                                                                             : 0;
    }
    return result;
  }

  // Once the displacement is computed.
  Vector operator()(const Sector_index s) const { return displacement(m_places[std::size_t(s)]); }

  // Moves all corners by the displacement, once it is computed.
  void move()
  {
    for(Corner_index h = 0; h < m_surface.number_of_corners(); ++h) {
      const Uv u = m_surface.uv(h);
      const Vector d = displacement(place(std::size_t(h)));
      m_surface.set_uv(h, {u[0] + d[0], u[1] + d[1]});
    }
  }

private:
  static Form unknown_and_number(const std::size_t unknown, const double x)
  { return {{{unknown, 1.}}, x}; }

  static Form_vector apply(const Element g, const Form_vector& v)
  {
    Form_vector result;
    for(std::size_t c = 0; c < dimension; ++c)
      for(std::size_t d = 0; d < dimension; ++d)
        if(const auto m = Group::matrix(g)[c][d]; m != 0)
          result[c].add(v[d], m);
    return result;
  }

  static Form functional(const int f, const Form_vector& v)
  {
    Form result;
    for(std::size_t c = 0; c < dimension; ++c)
      if(const auto factor = Group::functional(f)[c]; factor != 0)
        result.add(v[c], factor);
    return result;
  }

  // The cotangent of each corner in the domain is the weight of the opposite edge. It is the same
  // for faces of either orientation; those of nearly degenerate ones are bounded, by the same area
  // for all three, so that the energy is not negative.
  void weigh_edges()
  {
    for(Corner_index first = 0; first < m_surface.number_of_corners(); first += 3) {
      std::array<Uv, 3> sides; // opposite to the corners
      for(Corner_index i = 0; i < 3; ++i) {
        const Uv a = m_surface.uv(m_surface.next(first + i)),
                 b = m_surface.uv(m_surface.prev(first + i));
        sides[std::size_t(i)] = Group::to_cartesian({b[0] - a[0], b[1] - a[1]});
      }
      double squares = 0;
      for(const Uv& e : sides)
        squares += e[0] * e[0] + e[1] * e[1];
      const double cross = std::abs(sides[0][0] * sides[1][1] - sides[0][1] * sides[1][0]);
      const double bounded = (std::max)(cross, thinnest * squares);
      for(std::size_t k = 0; k < 3; ++k) {
        const Uv &a = sides[(k + 1) % 3], &b = sides[(k + 2) % 3];
        m_weights.push_back(squares > 0 ? -(a[0] * b[0] + a[1] * b[1]) / bounded : 0);
      }
    }
  }

  void find_sectors()
  {
    m_sectors.assign(std::size_t(m_surface.number_of_corners()), -1);
    for(std::size_t s = 0; s < m_complex.number_of_sectors(); ++s)
      for(const auto h : m_cuts.corners[s])
        m_sectors[std::size_t(h)] = Sector_index(s);
  }

  bool is_free(const std::size_t face) const
  {
    return m_sectors[3 * face] < 0 && m_sectors[3 * face + 1] < 0 && m_sectors[3 * face + 2] < 0;
  }

  void link_sectors(const Roundings& roundings)
  {
    m_links.assign(m_complex.number_of_sectors(), {});
    std::vector<Form_vector> translations(m_complex.number_of_branches());
    for(std::size_t b = 0; b < translations.size(); ++b) {
      const auto& pair = m_complex.pairs[b].front();
      const Vector turned =
        Group::apply(m_complex.element[b], m_complex.coordinates[std::size_t(pair.plus)]);
      for(std::size_t c = 0; c < dimension; ++c)
        translations[b][c] = unknown_and_number(
          m_first_translation + dimension * b + c,
          m_complex.coordinates[std::size_t(pair.minus)][c] - turned[c]);
    }
    for(const Rounding<Group>& r : roundings)
      if(r.kind == Rounding<Group>::BRANCH)
        translations[r.index][std::size_t(r.equation.terms.front().coordinate)] = {{}, r.rounded};
    for(std::size_t b = 0; b < m_complex.number_of_branches(); ++b) {
      const Element g = m_complex.element[b], back = Group::inverse(g);
      Form_vector s;
      for(std::size_t c = 0; c < dimension; ++c)
        s[c].add(apply(back, translations[b])[c], -1);
      for(const auto& pair : m_complex.pairs[b]) {
        m_links[std::size_t(pair.plus)].push_back({pair.minus, g, translations[b]});
        m_links[std::size_t(pair.minus)].push_back({pair.plus, back, s});
      }
    }
  }

  // All sectors of a vertex in terms of the first; or, beyond a part of the border, of another one.
  // The latter case has no variable of its own, and the part stays where it is put by chance: cuts
  // don't lead there.
  void place_sectors(const std::size_t v)
  {
    const Sector_index first = m_complex.first_sector[v], end = m_complex.first_sector[v + 1];
    std::vector<char> is_placed(std::size_t(end - first), false);
    for(Sector_index root = first; root != end; ++root) {
      if(is_placed[std::size_t(root - first)])
        continue;
      m_places[std::size_t(root)] = {m_surface.vertex(m_cuts.corners[root].front()),
                                     Group::identity(), {}};
      is_placed[std::size_t(root - first)] = true;
      std::vector<Sector_index> sectors(1, root);
      for(std::size_t i = 0; i < sectors.size(); ++i)
        for(const Link& link : m_links[std::size_t(sectors[i])])
          if(link.sector >= first && link.sector < end &&
             !is_placed[std::size_t(link.sector - first)]) {
            is_placed[std::size_t(link.sector - first)] = true;
            m_places[std::size_t(link.sector)] = place_behind(sectors[i], link);
            sectors.push_back(link.sector);
          }
    }
  }

  Place place_behind(const Sector_index here, const Link& link) const
  {
    const Place& p = m_places[std::size_t(here)];
    const Vector u = Group::apply(link.element, m_complex.coordinates[std::size_t(here)]);
    const Vector& now = m_complex.coordinates[std::size_t(link.sector)];
    Place q{p.vertex, Group::compose(link.element, p.element), apply(link.element, p.offset)};
    for(std::size_t i = 0; i < dimension; ++i) {
      q.offset[i].add(link.translation[i], 1);
      q.offset[i].constant += u[i] - now[i];
    }
    return q;
  }

  // Points, and the levels along whole chains.
  void fix_coordinates(const Roundings& roundings)
  {
    m_is_fixed.assign(m_is_fixed.size(), false);
    m_fixed.clear();
    m_has_level.assign(m_complex.number_of_chains(), false);
    for(const Rounding<Group>& r : roundings) {
      const auto& term = r.equation.terms.front();
      if(r.kind == Rounding<Group>::POINT)
        fix(term.sector, term.coordinate, r.rounded);
      else if(r.kind == Rounding<Group>::CHAIN) {
        m_has_level[r.index] = true;
        for(const Sector_index s : m_complex.links[r.index])
          fix(s, m_complex.functional[r.index], r.rounded);
      }
    }
  }

  void fix(const Sector_index s, const int f, const double value)
  {
    const Place& p = m_places[std::size_t(s)];
    const Signed_functional of_vertex = Group::act(Group::inverse(p.element), f);
    const std::size_t i = number_of_functionals * p.vertex + std::size_t(of_vertex.index);
    m_is_fixed[i] = true;
    Form& fixed = m_fixed[i];
    fixed = {{}, of_vertex.sign *
                   (value - Group::value(f, m_complex.coordinates[std::size_t(s)]))};
    fixed.add(functional(f, p.offset), -of_vertex.sign);
  }

  // f(g x + c): a functional of x, up to the sign, and the change of translations.
  Form form(const Place& p, const int f) const
  {
    const Signed_functional of_vertex = Group::act(Group::inverse(p.element), f);
    Form result = functional(f, p.offset);
    result.add(form_of_vertex(p.vertex, of_vertex.index), of_vertex.sign);
    return result;
  }

  // If u + v is fixed, but not both, u is the unknown.
  Form form_of_vertex(const std::size_t vertex, const int f) const
  {
    const std::size_t first = number_of_functionals * vertex;
    const bool has_fixed_sum = number_of_functionals > dimension && m_is_fixed[first + dimension];
    if(m_is_fixed[first + std::size_t(f)])
      return m_fixed.at(first + std::size_t(f));
    Form result;
    if(f == 2) {
      result.add(form_of_vertex(vertex, 0), 1);
      result.add(form_of_vertex(vertex, 1), 1);
    } else if(has_fixed_sum && (f == 1 || m_is_fixed[first + 1])) {
      result = m_fixed.at(first + dimension);
      result.add(form_of_vertex(vertex, 1 - f), -1);
    } else {
      return unknown_and_number(dimension * vertex + std::size_t(f), 0);
    }
    return result;
  }

  Place place(const std::size_t corner) const
  {
    const Sector_index s = m_sectors[corner];
    return s < 0 ? Place{m_surface.vertex(Corner_index(corner)), Group::identity(), {}}
                 : m_places[std::size_t(s)];
  }

  // 1/2 weight |d - d'|^2 for each edge.
  void add_face(const std::size_t face)
  {
    for(int k = 0; k < Group::number_of_functionals; ++k) {
      std::array<Form, 3> forms;
      for(std::size_t i = 0; i < 3; ++i)
        forms[i] = form(place(3 * face + i), k);
      for(std::size_t i = 0; i < 3; ++i) {
        Form difference = forms[(i + 1) % 3];
        difference.add(forms[(i + 2) % 3], -1);
        add_square(m_weights[3 * face + i], difference);
      }
    }
  }

  // The change of the quantity that is rounded.
  Form change(const Rounding<Group>& r) const
  {
    const auto& term = r.equation.terms.front();
    switch(r.kind) {
    case Rounding<Group>::BRANCH:
      return unknown_and_number(m_first_translation + dimension * r.index +
                                  std::size_t(term.coordinate), 0);
    case Rounding<Group>::CHAIN:
      return unknown_and_number(m_first_level + r.index, 0);
    default:
      return form(m_places[std::size_t(term.sector)], term.coordinate);
    }
  }

  // The conditions that the unknowns do not satisfy by themselves: once around a vertex, nothing
  // changes; and chains have one level.
  void add_conditions()
  {
    for(std::size_t s = 0; s < m_places.size(); ++s)
      for(const Link& link : m_links[s]) {
        const Place& there = m_places[std::size_t(link.sector)];
        if(std::size_t(link.sector) > s || there.vertex != m_places[s].vertex)
          continue;
        const Place behind = place_behind(Sector_index(s), link);
        for(int k = 0; k < Group::number_of_functionals; ++k)
          add_condition(form(behind, k), form(there, k));
      }
    for(std::size_t i = 0; i < m_complex.number_of_chains(); ++i) {
      const int f = m_complex.functional[i];
      const auto level = [&](const Sector_index s) {
        return Group::value(f, m_complex.coordinates[std::size_t(s)]);
      };
      if(!m_has_level[i])
        for(const Sector_index s : m_complex.links[i])
          add_condition(form(m_places[std::size_t(s)], f),
                        unknown_and_number(m_first_level + i,
                                           level(m_complex.links[i].front()) - level(s)));
    }
  }

  void add_condition(Form a, const Form& b)
  {
    a.add(b, -1);
    add_square(weight_of_conditions, a);
  }

  // weight / 2 times the square of a form; of the matrix, the half that solvers read.
  void add_square(const double weight, const Form& form)
  {
    for(const auto& [u, s] : form.terms) {
      if(form.constant != 0)
        m_rhs[Eigen::Index(u)] -= weight * s * form.constant;
      for(const auto& [v, t] : form.terms)
        if(v <= u)
          m_triplets.emplace_back(int(u), int(v), weight * s * t);
    }
  }

  // The matrix is the same for all that round the same.
  bool factorize(const Roundings& roundings)
  {
    std::vector<std::pair<std::size_t, int> > rounded;
    for(const Rounding<Group>& r : roundings)
      rounded.emplace_back(3 * r.index + r.kind, r.equation.terms.front().coordinate);
    if(rounded == m_rounded)
      return true;
    m_rounded = std::move(rounded);
    const Eigen::Index n = m_rhs.size();
    double largest = 0;
    for(const auto& t : m_triplets)
      largest = (std::max)(largest, std::abs(t.value()));
    for(Eigen::Index i = 0; i < n; ++i) // the displacement of a part may be free otherwise
      m_triplets.emplace_back(int(i), int(i), weight_of_nothing + 1e-12 * largest);
    Matrix matrix(n, n);
    matrix.setFromTriplets(m_triplets.begin(), m_triplets.end());
    m_solver.compute(matrix);
    return m_solver.info() == Eigen::Success;
  }

  bool solve()
  {
    m_solution = m_solver.solve(m_rhs);
    return m_solver.info() == Eigen::Success && m_solution.allFinite();
  }

  Vector displacement(const Place& p) const
  {
    Vector result{};
    for(std::size_t c = 0; c < dimension; ++c) {
      const Form f = form(p, int(c));
      result[c] = f.constant;
      for(const auto& [unknown, factor] : f.terms)
        result[c] += factor * m_solution[Eigen::Index(unknown)];
    }
    return result;
  }

  // Twice the area of a face, relative to the squares of its sides, that weights are bounded by.
  static constexpr double thinnest = 1e-5;
  // Relative to edges of faces of good shape.
  static constexpr double weight_of_conditions = 1e6;
  // The weight of displacements as such, because the place of a chart has no meaning.
  static constexpr double weight_of_nothing = 1e-8;

  Flat_surface& m_surface;
  const Cuts& m_cuts;
  const Cut_complex<Group>& m_complex;
  std::size_t m_first_translation, m_first_level, m_number_of_unknowns; // vertices come first
  std::vector<Sector_index> m_sectors;     // per corner: -1 where it is in none
  std::vector<double> m_weights;           // per corner
  std::vector<std::vector<Link> > m_links; // per sector
  std::vector<Place> m_places;             // per sector
  std::vector<char> m_is_fixed;            // per functional of each vertex
  std::unordered_map<std::size_t, Form> m_fixed;
  std::vector<char> m_has_level;           // per chain
  std::vector<Eigen::Triplet<double> > m_triplets, m_free_faces;
  Eigen::VectorXd m_rhs, m_solution;
  std::vector<std::pair<std::size_t, int> > m_rounded; // by the matrix
  Solver m_solver;
  std::optional<Range_space_solver<Solver> > m_further; // roundings
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SNAPPING_SPREAD_ROUNDING_H
