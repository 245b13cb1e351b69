// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Linear_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_KERNEL_LATTICE_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_KERNEL_LATTICE_H

#include <CGAL/license/Linear_snapping.h>

// The Hermite normal form of a sparse integer matrix by unimodular column operations, of which only
// the operations are kept. Starting with the unit vectors as a basis of Z^n, the lattice is
// intersected with the kernel of one row after the other. As the basis is reduced all along, its
// entries stay small, unlike the entries of an eliminated matrix.

#include <CGAL/Linear_snapping/internal/linear/Integer_system.h>
#include <CGAL/Linear_snapping/internal/linear/lattice_reduction.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// a - factor b
template <typename Integer>
Entries<Integer> difference_with_multiple(const Entries<Integer>& a, const Integer& factor,
                                          const Entries<Integer>& b)
{
  const Integer zero(0);
  Entries<Integer> result;
  result.reserve(a.size() + b.size());
  auto i = a.begin();
  for(const Entry<Integer>& e : b) {
    for(; i != a.end() && i->column < e.column; ++i)
      result.push_back(*i);
    const bool shared = i != a.end() && i->column == e.column;
    Integer value = difference_with_product(shared ? i->coefficient : zero, factor, e.coefficient);
    if(shared)
      ++i;
    if(value != 0)
      result.push_back({e.column, std::move(value)});
  }
  result.insert(result.end(), i, a.end());
  return result;
}

// The result of one row: the vector that all earlier rows map to 0 and this row to `gcd`. The
// row is a combination of earlier ones if gcd is 0.
template <typename Integer>
struct Echelon_step
{
  Row_index row;
  Integer gcd;
  Entries<Integer> vector;
};

// Invariant: the echelon vectors and the basis vectors together are a basis of Z^n, and the rows
// treated so far map all basis vectors to 0: so the basis spans all integer vectors of the kernel.
// With 64-bit integers the constructor throws `Integer_overflow` where an exact value does not fit.
template <typename Integer>
class Kernel_lattice
{
public:
  using Vector = Entries<Integer>;
  using Step = Echelon_step<Integer>;

  // \param most_work multiplications of words in reductions, which cost most; more throw
  //        `Work_exceeded`
  // \pre 64-bit integers are for systems that have no others
  Kernel_lattice(const Integer_system& system, const double most_work)
    : m_work_left(most_work),
      m_rows(system.number_of_rows()), m_vectors(system.number_of_columns()),
      m_users(system.number_of_columns()), m_lengths(system.number_of_columns(), 1.),
      m_marks(system.number_of_columns(), 0)
  {
    for(std::size_t i = 0; i < m_rows.size(); ++i)
      if constexpr(std::is_same<Integer, Exact_integer>::value)
        m_rows[i] = system.exact_row(i).entries;
      else
        m_rows[i].assign(system.row(i).begin(), system.row(i).end());
    for(std::size_t i = 0; i < m_vectors.size(); ++i) {
      m_vectors[i].push_back({Column_index(i), Integer(1)});
      m_users[i].push_back(i);
    }
    std::vector<char> is_done(system.number_of_rows(), 0);
    for(std::size_t i = 0; i < is_done.size(); ++i) {
      intersect_with_kernel(next_row(is_done));
      Progress::tell_each_second([&] { return counted(i + 1, "row") + " of " +
                                              std::to_string(is_done.size()) + " solved"; });
    }
    m_vectors.erase(std::remove_if(m_vectors.begin(), m_vectors.end(),
                                   [](const Vector& v) { return v.empty(); }), m_vectors.end());
  }

  // In the order in which rows were treated.
  std::vector<Step>& steps() { return m_steps; }
  std::vector<Vector>& basis() { return m_vectors; }
  double work_left() const { return m_work_left; }

private:
  struct Image { std::size_t vector; Integer value; double size; };

  // The row that concerns the fewest basis vectors: the sparser the basis, the longer it stays so.
  std::size_t next_row(std::vector<char>& is_done) const
  {
    std::size_t best = 0, best_cost = (std::numeric_limits<std::size_t>::max)();
    for(std::size_t i = 0; i < is_done.size(); ++i) {
      if(is_done[i])
        continue;
      std::size_t cost = 0;
      for(const Entry<Integer>& e : m_rows[i])
        cost += m_users[std::size_t(e.column)].size();
      if(cost < best_cost) {
        best_cost = cost;
        best = i;
      }
    }
    is_done[best] = 1;
    return best;
  }

  void intersect_with_kernel(const std::size_t row)
  {
    std::vector<Image> images = nonzero_images(row);
    if(images.empty()) {
      m_steps.push_back({Row_index(row), Integer(0), Vector()});
      return;
    }
    std::vector<std::size_t> affected;
    for(const Image& image : images)
      affected.push_back(image.vector);
    while(images.size() > 1)
      combine(images);
    const std::size_t pivot = images.front().vector;
    m_steps.push_back({Row_index(row), images.front().value, std::move(m_vectors[pivot])});
    m_vectors[pivot].clear();
    affected.erase(std::find(affected.begin(), affected.end(), pivot));
    reduce(affected);
  }

  // Row times basis vector, where it isn't 0.
  std::vector<Image> nonzero_images(const std::size_t row)
  {
    std::vector<std::size_t> candidates;
    for(const Entry<Integer>& e : m_rows[row]) {
      std::vector<std::size_t>& users = m_users[std::size_t(e.column)];
      users.erase(std::remove_if(users.begin(), users.end(), [&](const std::size_t v)
                                 { return find_entry(m_vectors[v], e.column) == nullptr; }),
                  users.end());
      std::sort(users.begin(), users.end());
      users.erase(std::unique(users.begin(), users.end()), users.end());
      candidates.insert(candidates.end(), users.begin(), users.end());
    }
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    std::vector<Image> result;
    for(const std::size_t v : candidates) {
      Integer sum(0);
      for(const Entry<Integer>& e : m_rows[row])
        if(const Entry<Integer>* const found = find_entry(m_vectors[v], e.column))
          sum = difference_with_product(sum, Integer(-e.coefficient), found->coefficient);
      if(sum != 0)
        result.push_back({v, sum, logarithm(sum)});
    }
    return result;
  }

  static double logarithm(const Integer& a)
  {
    const Scaled_double s = to_scaled_double(a);
    return std::log2(std::abs(s.mantissa)) + static_cast<double>(s.exponent);
  }

  // One division step, of the vector with the largest image by the one that pays most: many bits
  // less in the image for little growth of the vector.
  void combine(std::vector<Image>& images)
  {
    const auto largest =
      std::max_element(images.begin(), images.end(), [this](const Image& a, const Image& b) {
        return std::make_pair(a.size, m_lengths[a.vector]) <
               std::make_pair(b.size, m_lengths[b.vector]);
      });
    std::iter_swap(largest, images.end() - 1);
    Image& image = images.back();
    const double length = m_lengths[image.vector];
    double best_price = (std::numeric_limits<double>::max)();
    std::size_t best = 0;
    for(std::size_t i = 0; i + 1 < images.size(); ++i) {
      const double quotient = std::exp2((std::min)(image.size - images[i].size, 300.));
      const double nearest = std::floor(quotient + 0.5);
      const double rest = std::abs(quotient - nearest) / quotient;
      const double growth = std::log2(1 + nearest * nearest * m_lengths[images[i].vector] / length);
      const double price = growth / (std::min)(50., 1 - std::log2(rest + 1e-15));
      if(price < best_price) {
        best_price = price;
        best = i;
      }
    }
    divide(image, images[best]);
    if(image.value == 0)
      images.pop_back();
  }

  void divide(Image& image, const Image& divisor)
  {
    Integer quotient(image.value / divisor.value);
    const Integer rest = difference_with_product(image.value, quotient, divisor.value);
    // to the nearest quotient
    const Integer size(CGAL::abs(rest));
    if(size > Integer(CGAL::abs(divisor.value) - size)) // without a sum that might overflow
      quotient = Integer(quotient + ((rest > 0) == (divisor.value > 0) ? 1 : -1));
    image.value = difference_with_product(image.value, quotient, divisor.value);
    if(image.value != 0)
      image.size = logarithm(image.value);
    replace(image.vector, difference_with_multiple(m_vectors[image.vector], quotient,
                                                   m_vectors[divisor.vector]));
  }

  void replace(const std::size_t v, Vector vector)
  {
    auto old = m_vectors[v].begin();
    double length = 0;
    for(const Entry<Integer>& e : vector) {
      while(old != m_vectors[v].end() && old->column < e.column)
        ++old;
      if(old == m_vectors[v].end() || old->column != e.column)
        m_users[std::size_t(e.column)].push_back(v);
      const double coefficient = CGAL::to_double(e.coefficient);
      length += coefficient * coefficient;
    }
    m_vectors[v] = std::move(vector);
    m_lengths[v] = length;
  }

  void reduce(std::vector<std::size_t>& selection)
  {
    std::sort(selection.begin(), selection.end(), [this](const std::size_t a, const std::size_t b)
              { return m_lengths[a] != m_lengths[b] ? m_lengths[a] < m_lengths[b] : a < b; });
    if(selection.size() <= largest_local_reduction) {
      reduce_now(selection);
      return;
    }
    // Many vectors at once cost more: only when it pays.
    if(longest(selection) > 1000 * m_length_after_reduction) {
      reduce_now(selection);
      m_length_after_reduction = longest(selection);
    }
  }

  double longest(const std::vector<std::size_t>& selection) const
  {
    double length = 0;
    for(const std::size_t v : selection)
      length = (std::max)(length, m_lengths[v]);
    return length;
  }

  // In the coordinates that the selected vectors use.
  void reduce_now(const std::vector<std::size_t>& selection)
  {
    std::vector<Column_index> columns;
    for(const std::size_t v : selection)
      for(const Entry<Integer>& e : m_vectors[v])
        columns.push_back(e.column);
    std::sort(columns.begin(), columns.end());
    columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
    for(std::size_t i = 0; i < columns.size(); ++i)
      m_marks[std::size_t(columns[i])] = i;
    std::vector<std::vector<Integer> > dense(selection.size(),
                                             std::vector<Integer>(columns.size(), Integer(0)));
    for(std::size_t k = 0; k < selection.size(); ++k)
      for(const Entry<Integer>& e : m_vectors[selection[k]])
        dense[k][m_marks[std::size_t(e.column)]] = e.coefficient;
    const std::vector<double> scale(columns.size(), 1.);
    m_work_left -= Lattice_reduction<Integer>(dense, scale).work();
    if(m_work_left < 0)
      throw Work_exceeded();
    for(std::size_t k = 0; k < selection.size(); ++k) {
      Vector vector;
      for(std::size_t i = 0; i < columns.size(); ++i)
        if(dense[k][i] != 0)
          vector.push_back({columns[i], dense[k][i]});
      replace(selection[k], std::move(vector));
    }
  }

  static constexpr std::size_t largest_local_reduction = 60;

  double m_work_left;
  std::vector<Entries<Integer> > m_rows;
  std::vector<Vector> m_vectors; // empty if it became an echelon vector
  std::vector<std::vector<std::size_t> > m_users; // a superset of the vectors with each column
  std::vector<double> m_lengths;                  // squared norms
  std::vector<std::size_t> m_marks;
  double m_length_after_reduction = 64;            // squared, of the longest vector
  std::vector<Step> m_steps;
};

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_LINEAR_KERNEL_LATTICE_H
