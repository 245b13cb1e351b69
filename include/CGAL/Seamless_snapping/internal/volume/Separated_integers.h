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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SEPARATED_INTEGERS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SEPARATED_INTEGERS_H

#include <CGAL/license/Seamless_snapping.h>

// Integer solutions of the system of places that keep differences at least 1.

#include <CGAL/Linear_snapping/internal/linear/Kernel_lattice.h>
#include <CGAL/Linear_snapping/internal/linear/System_builder.h>
#include <CGAL/Seamless_snapping/internal/volume/Separation_finder.h>
#include <CGAL/Seamless_snapping/internal/volume/Signed_union_find.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Two columns that are equal in one system of coordinates of several charts, up to a sign.
struct Tie
{
  std::size_t a, b;
  int sign;
};

// How charts are joined: each may move by integers, so that the translations between the charts of
// a spanning tree may stay as they are.
struct Chart_ties
{
  std::vector<std::int64_t> origin; // per column: the origin of the first chart; empty if it is 0
  std::vector<Tie> ties;            // of columns, less their origins
};

// The equations of the system for columns, less their origins. If rows or ties make two columns
// equal, up to a sign, one unknown stands for both. If they make a column 0, none does.
class Tied_system
{
public:
  using Vector = Entries<std::int64_t>;

  Tied_system(const Integer_system& system, const std::vector<Tie>& ties,
              const std::vector<Separation>& separations)
    : m_columns(system.number_of_columns()), m_unknown(system.number_of_columns())
  {
    std::iota(m_unknown.begin(), m_unknown.end(), Column_index(0));
    for(const Tie& tie : ties)
      m_columns.unite(tie.a, tie.b, tie.sign);
    std::vector<std::size_t> rows(system.number_of_rows());
    std::iota(rows.begin(), rows.end(), std::size_t(0));
    for(std::size_t before = rows.size() + 1; rows.size() < before; ) {
      before = rows.size();
      rows.erase(std::remove_if(rows.begin(), rows.end(), [&](const std::size_t i)
                                { return tie(tied(system.row(i))); }), rows.end());
    }
    number_unknowns(system, rows, separations);
    System_builder builder(m_number_of_linked_unknowns);
    for(const std::size_t i : rows)
      builder.add_row(tied(system.row(i)));
    m_system = builder.take();
  }

  const Integer_system& system() const { return m_system.system; }

  // A sum of columns in the unknowns.
  template <typename Row>
  Vector tied(const Row& row)
  {
    Vector result;
    for(const Entry<std::int64_t>& e : row)
      for_unknown(std::size_t(e.column), [&](const std::size_t k, const int sign)
                  { result.push_back({Column_index(k), sign * e.coefficient}); });
    sort_and_sum(result);
    return result;
  }

  // The other unknowns are in no row, and in no difference.
  std::size_t number_of_linked_unknowns() const { return m_number_of_linked_unknowns; }

  // The weights of unknowns, and the values that come nearest to a target.
  void find_target(const std::vector<double>& weights, const std::vector<double>& target,
                   const std::vector<std::int64_t>& origin,
                   std::vector<double>& weights_of_unknowns,
                   std::vector<double>& target_of_unknowns)
  {
    weights_of_unknowns.assign(m_number_of_unknowns, 0);
    target_of_unknowns.assign(m_number_of_unknowns, 0);
    for(std::size_t j = 0; j < origin.size(); ++j)
      for_unknown(j, [&](const std::size_t k, const int sign) {
        weights_of_unknowns[k] += weights[j];
        target_of_unknowns[k] += weights[j] * sign * (target[j] - static_cast<double>(origin[j]));
      });
    for(std::size_t k = 0; k < m_number_of_unknowns; ++k)
      target_of_unknowns[k] /= weights_of_unknowns[k];
  }

  // The columns, with the integers next to their targets for unknowns that nothing links.
  std::vector<std::int64_t> columns(std::vector<std::int64_t> unknowns,
                                    const std::vector<double>& target_of_unknowns,
                                    std::vector<std::int64_t> origin)
  {
    for(std::size_t k = unknowns.size(); k < m_number_of_unknowns; ++k)
      unknowns.push_back(std::llround(target_of_unknowns[k]));
    for(std::size_t j = 0; j < origin.size(); ++j)
      for_unknown(j, [&](const std::size_t k, const int sign) { origin[j] += sign * unknowns[k]; });
    return origin;
  }

private:
  // Calls f(unknown, sign) if one stands for a column.
  template <typename F>
  void for_unknown(const std::size_t column, const F& f)
  {
    if(const auto [root, sign] = m_columns.find(column); !m_columns.is_zero(root))
      f(std::size_t(m_unknown[root]), sign);
  }

  // The linked ones first.
  void number_unknowns(const Integer_system& system, const std::vector<std::size_t>& rows,
                       const std::vector<Separation>& separations)
  {
    std::vector<char> is_linked(m_unknown.size(), 0); // per root
    const auto link = [&](const auto& row) {
      for(const Entry<std::int64_t>& e : tied(row))
        is_linked[std::size_t(e.column)] = 1;
    };
    for(const std::size_t i : rows)
      link(system.row(i));
    for(const Separation& s : separations)
      link(s);
    for(const bool linked : {true, false}) {
      m_number_of_linked_unknowns = m_number_of_unknowns;
      for(std::size_t j = 0; j < m_unknown.size(); ++j)
        if((is_linked[j] != 0) == linked && m_columns.root(j) == j && !m_columns.is_zero(j))
          m_unknown[j] = Column_index(m_number_of_unknowns++);
    }
  }

  // Returns whether ties say all that a row says.
  bool tie(const Vector& row)
  {
    if(row.size() == 1)
      m_columns.set_zero(std::size_t(row[0].column));
    if(row.size() == 2 && std::abs(row[0].coefficient) == std::abs(row[1].coefficient))
      m_columns.unite(std::size_t(row[0].column), std::size_t(row[1].column),
                      row[0].coefficient == row[1].coefficient ? -1 : 1);
    else if(row.size() > 1)
      return false;
    return true;
  }

  Signed_union_find m_columns;
  std::vector<Column_index> m_unknown; // per root; the root itself while rows are tied
  std::size_t m_number_of_unknowns = 0, m_number_of_linked_unknowns = 0;
  Scaled_system m_system;
};

// Chooses integers one after another, each time the one that costs all others least, measured by
// the least-squares distance from the map. If a difference would get below 1, it becomes 1 at once.
// Invariant: the solutions that are left are `m_point` plus the integer combinations of the vectors
// of a basis. `m_optimum` are the real coefficients of the one nearest to the map, and `m_answers`
// tells how they change as one of them does.
class Separated_integers
{
public:
  using Vector = Entries<std::int64_t>;
  using Image = std::vector<std::int64_t>; // per vector of the basis

  // \param basis of all integer solutions
  // \param weights, target per column
  // \param images of the vectors of the basis, per difference
  Separated_integers(const std::vector<Vector>& basis, const std::vector<double>& weights,
                     const std::vector<double>& target, const std::vector<Image>& images)
    : m_basis(basis), m_images(images), m_point(target.size(), 0), m_values(images.size(), 0),
      m_is_open(basis.size(), 1)
  {
    const Eigen::Index size = Eigen::Index(basis.size());
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
    m_optimum = Eigen::VectorXd::Zero(size);
    std::vector<std::vector<std::pair<Eigen::Index, double> > > users(target.size());
    for(Eigen::Index k = 0; k < size; ++k)
      for(const Entry<std::int64_t>& e : basis[std::size_t(k)]) {
        users[std::size_t(e.column)].emplace_back(k, double(e.coefficient));
        m_optimum[k] += weights[std::size_t(e.column)] * double(e.coefficient) *
                        target[std::size_t(e.column)];
      }
    for(std::size_t j = 0; j < users.size(); ++j)
      for(const auto& [k, a] : users[j])
        for(const auto& [l, b] : users[j])
          normal(k, l) += weights[j] * a * b;
    m_answers = normal.llt().solve(Eigen::MatrixXd::Identity(size, size));
    m_optimum = m_answers * m_optimum;
  }

  // Chooses all integers, some differences first. Returns the differences that are below 1 all the
  // same.
  std::vector<std::size_t> run(const std::vector<std::size_t>& first)
  {
    for(const std::size_t i : first)
      if(is_free(i) && value(i) < 1 + first_margin)
        choose_difference(i);
    while(true) {
      std::size_t least = m_values.size();
      double least_value = 1 - precision;
      for(std::size_t i = 0; i < m_values.size(); ++i)
        if(const double v = is_free(i) ? value(i) : 1; v < least_value) {
          least = i;
          least_value = v;
        }
      if(least < m_values.size())
        choose_difference(least);
      else if(!choose_cheapest())
        break;
    }
    std::vector<std::size_t> result;
    for(std::size_t i = 0; i < m_values.size(); ++i)
      if(m_values[i] < 1)
        result.push_back(i);
    return result;
  }

  const std::vector<std::int64_t>& point() const { return m_point; }

private:
  static constexpr double precision = 1e-6, first_margin = 0.5;

  bool is_free(const std::size_t i) const
  {
    return std::any_of(m_images[i].begin(), m_images[i].end(),
                       [](const std::int64_t a) { return a != 0; });
  }

  double value(const std::size_t i) const
  {
    double result = static_cast<double>(m_values[i]);
    for(std::size_t k = 0; k < m_basis.size(); ++k)
      result += static_cast<double>(m_images[i][k]) * m_optimum[Eigen::Index(k)];
    return result;
  }

  // The least value of at least 1.
  void choose_difference(const std::size_t i)
  {
    const std::size_t k = make_coefficient(i);
    const std::int64_t step = std::abs(m_images[i][k]), missing = 1 - m_values[i];
    const std::int64_t steps = missing >= 0 ? (missing + step - 1) / step : -(-missing / step);
    choose(k, m_images[i][k] > 0 ? steps : -steps);
  }

  // Changes the basis by Euclid's algorithm: then one coefficient alone decides a difference.
  std::size_t make_coefficient(const std::size_t i)
  {
    const Image& image = m_images[i];
    while(true) {
      std::size_t least = m_basis.size();
      for(std::size_t k = 0; k < m_basis.size(); ++k)
        if(image[k] != 0 &&
           (least == m_basis.size() || std::abs(image[k]) < std::abs(image[least])))
          least = k;
      bool is_alone = true;
      for(std::size_t k = 0; k < m_basis.size(); ++k)
        if(k != least && image[k] != 0) {
          subtract(k, image[k] / image[least], least);
          is_alone = is_alone && image[k] == 0;
        }
      if(is_alone)
        return least;
    }
  }

  // Vector k of the basis becomes that less a multiple of vector l.
  void subtract(const std::size_t k, const std::int64_t factor, const std::size_t l)
  {
    m_basis[k] = difference_with_multiple(m_basis[k], factor, m_basis[l]);
    for(Image& image : m_images)
      image[k] -= factor * image[l];
    const Eigen::Index a = Eigen::Index(k), b = Eigen::Index(l);
    const double f = static_cast<double>(factor);
    m_optimum[b] += f * m_optimum[a];
    m_answers.row(b) += f * m_answers.row(a);
    m_answers.col(b) += f * m_answers.col(a);
  }

  // Returns false if all are chosen.
  bool choose_cheapest()
  {
    std::size_t best = m_basis.size();
    double least_cost = 0;
    for(std::size_t k = 0; k < m_basis.size(); ++k) {
      if(m_is_open[k] == 0)
        continue;
      const double d = std::round(m_optimum[Eigen::Index(k)]) - m_optimum[Eigen::Index(k)];
      const double cost = d * d / m_answers(Eigen::Index(k), Eigen::Index(k));
      if(best == m_basis.size() || cost < least_cost) {
        best = k;
        least_cost = cost;
      }
    }
    if(best == m_basis.size())
      return false;
    choose(best, std::llround(m_optimum[Eigen::Index(best)]));
    return true;
  }

  void choose(const std::size_t k, const std::int64_t x)
  {
    const Eigen::Index a = Eigen::Index(k);
    const Eigen::VectorXd answer = m_answers.col(a) / m_answers(a, a);
    m_optimum += (static_cast<double>(x) - m_optimum[a]) * answer;
    m_answers -= answer * m_answers.row(a).eval();
    m_is_open[k] = 0;
    for(const Entry<std::int64_t>& e : m_basis[k])
      m_point[std::size_t(e.column)] += x * e.coefficient;
    for(std::size_t i = 0; i < m_values.size(); ++i)
      m_values[i] += x * std::exchange(m_images[i][k], 0);
  }

  std::vector<Vector> m_basis;
  std::vector<Image> m_images;        // per difference; 0 for coefficients that are chosen
  std::vector<std::int64_t> m_point;  // per column
  std::vector<std::int64_t> m_values; // per difference: its value at the point
  std::vector<char> m_is_open;        // per vector of the basis: its coefficient is not chosen yet
  Eigen::VectorXd m_optimum;
  Eigen::MatrixXd m_answers;
};

inline std::int64_t value_of(const Separation& separation, const std::vector<std::int64_t>& x)
{
  std::int64_t result = 0;
  for(const Entry<std::int64_t>& e : separation)
    result += e.coefficient * x[std::size_t(e.column)];
  return result;
}

// The images of the differences for the vectors of a basis; each once, because many are equal.
inline std::vector<Separated_integers::Image>
distinct_images(const std::vector<Separated_integers::Vector>& basis,
                const std::vector<Separation>& separations, Tied_system& tied)
{
  std::vector<Separated_integers::Image> result;
  for(const Separation& separation : separations) {
    const Separation s = tied.tied(separation);
    result.emplace_back();
    for(const Separated_integers::Vector& v : basis) {
      result.back().push_back(0);
      for(const Entry<std::int64_t>& e : s)
        if(const auto* const found = find_entry(v, e.column); found != nullptr)
          result.back().back() += e.coefficient * found->coefficient;
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// Changes integers such that differences are at least 1, if some are not. Returns how many stay
// below 1: they cost cells.
// \param weights, target per column
inline std::size_t separate_integers(const Scaled_system& system, const Chart_ties& ties,
                                     const std::vector<double>& weights,
                                     const std::vector<double>& target,
                                     const std::vector<Separation>& separations,
                                     std::vector<std::int64_t>& x)
{
  constexpr std::size_t largest_number_of_rows = 10000;
  constexpr std::size_t largest_dimension = 1500; // of the basis: a choice takes its square
  constexpr double most_work = 1e9; // multiplications of the reduction of the basis
  constexpr int largest_number_of_tries = 20;
  const auto number_of_joined = [&] {
    return std::size_t(std::count_if(separations.begin(), separations.end(),
                                     [&](const Separation& s) { return value_of(s, x) < 1; }));
  };
  if(number_of_joined() == 0)
    return 0;
  try {
    Tied_system tied(system.system, ties.ties, separations);
    const std::size_t rows = tied.system().number_of_rows();
    if(rows > largest_number_of_rows ||
       tied.number_of_linked_unknowns() > rows + largest_dimension)
      return number_of_joined();
    const std::vector<Separated_integers::Vector> basis =
      std::move(Kernel_lattice<std::int64_t>(tied.system(), most_work).basis());
    const std::vector<Separated_integers::Image> images = distinct_images(basis, separations, tied);
    std::vector<std::int64_t> origin(ties.origin);
    origin.resize(x.size(), 0);
    std::vector<double> weights_of_unknowns, target_of_unknowns;
    tied.find_target(weights, target, origin, weights_of_unknowns, target_of_unknowns);
    const std::vector<double> target_of_linked(
      target_of_unknowns.begin(),
      target_of_unknowns.begin() + std::ptrdiff_t(tied.number_of_linked_unknowns()));
    std::vector<std::size_t> first; // differences that come too late in the order of their values
    std::size_t least = images.size() + 1;
    for(int i = 0; i < largest_number_of_tries && least > 0; ++i) {
      Separated_integers integers(basis, weights_of_unknowns, target_of_linked, images);
      const std::vector<std::size_t> joined = integers.run(first);
      if(joined.size() < least) {
        least = joined.size();
        x = tied.columns(integers.point(), target_of_unknowns, origin);
      }
      first.insert(first.begin(), joined.begin(), joined.end());
    }
  } catch(const Integer_overflow&) { // x stays as it is
  } catch(const Work_exceeded&) {
  }
  return number_of_joined();
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SEPARATED_INTEGERS_H
