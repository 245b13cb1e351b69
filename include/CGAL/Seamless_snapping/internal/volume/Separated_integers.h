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

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

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
    for(std::size_t k = 0; k < m_is_open.size(); ++k)
      if(m_is_open[k] != 0 && m_images[i][k] != 0)
        return true;
    return false;
  }

  double value(const std::size_t i) const
  {
    double result = static_cast<double>(m_values[i]);
    for(std::size_t k = 0; k < m_is_open.size(); ++k)
      if(m_is_open[k] != 0)
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
        if(m_is_open[k] != 0 && image[k] != 0 &&
           (least == m_basis.size() || std::abs(image[k]) < std::abs(image[least])))
          least = k;
      bool is_alone = true;
      for(std::size_t k = 0; k < m_basis.size(); ++k)
        if(m_is_open[k] != 0 && k != least && image[k] != 0) {
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

  // Within what differences that depend on this coefficient only allow. Returns false if all are
  // chosen.
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
    const auto [least, largest] = range(best);
    std::int64_t x = std::int64_t(std::llround(m_optimum[Eigen::Index(best)]));
    x = (std::min)((std::max)(x, least), (std::max)(least, largest));
    choose(best, x);
    return true;
  }

  std::pair<std::int64_t, std::int64_t> range(const std::size_t k) const
  {
    constexpr std::int64_t infinity = (std::numeric_limits<std::int64_t>::max)() / 2;
    std::pair<std::int64_t, std::int64_t> result{-infinity, infinity};
    for(std::size_t i = 0; i < m_values.size(); ++i) {
      const std::int64_t a = m_images[i][k];
      if(a == 0)
        continue;
      bool is_last = true;
      for(std::size_t l = 0; l < m_basis.size() && is_last; ++l)
        is_last = l == k || m_is_open[l] == 0 || m_images[i][l] == 0;
      const double bound = static_cast<double>(1 - m_values[i]) / static_cast<double>(a);
      if(is_last && a > 0)
        result.first = (std::max)(result.first, std::int64_t(std::ceil(bound)));
      else if(is_last)
        result.second = (std::min)(result.second, std::int64_t(std::floor(bound)));
    }
    return result;
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
      m_values[i] += x * m_images[i][k];
  }

  std::vector<Vector> m_basis;
  std::vector<Image> m_images;        // per difference
  std::vector<std::int64_t> m_point;  // per column
  std::vector<std::int64_t> m_values; // per difference: that of the point
  std::vector<char> m_is_open;        // per vector of the basis: its coefficient is not chosen yet
  Eigen::VectorXd m_optimum;
  Eigen::MatrixXd m_answers;
};

// Whether integers keep a difference at least 1.
inline bool is_kept(const Separation& separation, const std::vector<std::int64_t>& x)
{
  std::int64_t value = 0;
  for(const Entry<std::int64_t>& e : separation)
    value += e.coefficient * x[std::size_t(e.column)];
  return value >= 1;
}

// What differences become for the vectors of a basis; each once, because levels make many equal.
inline std::vector<Separated_integers::Image>
distinct_images(const std::vector<Separated_integers::Vector>& basis,
                const std::vector<Separation>& separations)
{
  std::vector<Separated_integers::Image> result;
  for(const Separation& s : separations) {
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

// Changes integers such that differences are at least 1, if some are not. What stays joined is told
// by the cells that it costs.
// \param weights, target per column
inline void separate_integers(const Scaled_system& system, const std::vector<double>& weights,
                              const std::vector<double>& target,
                              const std::vector<Separation>& separations,
                              std::vector<std::int64_t>& x)
{
  constexpr std::size_t largest_number_of_rows = 10000; // the basis takes their square
  constexpr double most_work = 1e9; // multiplications of the reduction of the basis
  constexpr int largest_number_of_tries = 20;
  if(system.system.number_of_rows() > largest_number_of_rows ||
     std::all_of(separations.begin(), separations.end(),
                 [&](const Separation& s) { return is_kept(s, x); }))
    return;
  try {
    const std::vector<Separated_integers::Vector> basis =
      std::move(Kernel_lattice<std::int64_t>(system.system, most_work).basis());
    const std::vector<Separated_integers::Image> images = distinct_images(basis, separations);
    std::vector<std::size_t> first; // differences that come too late in the order of their values
    std::size_t least = images.size() + 1;
    for(int i = 0; i < largest_number_of_tries && least > 0; ++i) {
      Separated_integers integers(basis, weights, target, images);
      const std::vector<std::size_t> joined = integers.run(first);
      if(joined.size() < least) {
        least = joined.size();
        x = integers.point();
      }
      first.insert(first.begin(), joined.begin(), joined.end());
    }
  } catch(const Integer_overflow&) { // x stays as it is
  } catch(const Work_exceeded&) {
  }
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_SEPARATED_INTEGERS_H
