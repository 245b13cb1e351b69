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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_UNTANGLING_DISTORTION_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_UNTANGLING_DISTORTION_H

#include <CGAL/license/Seamless_snapping.h>

// Minimizes the distortion of some triangles over some of the unknowns, by Newton's method with a
// positive definite Hessian, while the regularization that lets triangles turn over is taken away.

#include <CGAL/Linear_snapping/internal/linear/Sparse_cholesky.h>
#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>
#include <CGAL/Seamless_snapping/internal/untangling/Constrained_triangles.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The distortion of a triangle as a function of its Jacobian, in the form of [Garanzha et al. 2021]
// that is finite, but large, where the triangle is flipped. Templates, here and below, so that
// programs that don't untangle needn't compile them.

// du/dx, du/dy, dv/dx, dv/dy, for x and y of the reference shape.
template <typename FT>
using Jacobian = Eigen::Matrix<FT, 4, 1>;

template <typename FT>
FT determinant(const Jacobian<FT>& j) { return j[0] * j[3] - j[1] * j[2]; }

// (|J|^2 + 1 + det^2 J) / chi(det J), where chi tends to the positive part of its argument with the
// regularization. It is least, 4, for rotations.
template <typename FT>
class Distortion
{
  using Vector = Eigen::Matrix<FT, 4, 1>;
  using Matrix = Eigen::Matrix<FT, 4, 4>;

public:
  explicit Distortion(const FT regularization) : m_squared(regularization * regularization) { }

  FT operator()(const Jacobian<FT>& j) const
  {
    const FT d = determinant(j);
    return numerator(j, d) / chi(d);
  }

  // The gradient, and the Hessian with its negative eigenvalues taken away.
  void derivatives(const Jacobian<FT>& j, Vector& gradient, Matrix& hessian) const
  {
    const FT d = determinant(j), root = std::sqrt(m_squared + d * d);
    const FT n = numerator(j, d), c = chi(d);
    const FT c1 = c / root, c2 = m_squared / (2 * root * root * root); // derivatives of chi
    const Vector d1(j[3], -j[2], -j[1], j[0]);                    // gradient of the determinant
    const Vector n1 = 2 * j + 2 * d * d1;                         // gradient of the numerator
    Matrix d2 = Matrix::Zero();
    d2(0, 3) = d2(3, 0) = 1;
    d2(1, 2) = d2(2, 1) = -1;

    gradient = n1 / c - (n * c1 / (c * c)) * d1;
    const FT slope = c1 / (c * c);
    hessian = (2 / c) * (Matrix::Identity() + d1 * d1.transpose())
            + (2 * d / c - n * slope) * d2
            - slope * (n1 * d1.transpose() + d1 * n1.transpose())
            + n * (2 * c1 * slope / c - c2 / (c * c)) * (d1 * d1.transpose());
    make_positive(hessian);
  }

  FT chi(const FT d) const
  {
    const FT root = std::sqrt(m_squared + d * d);
    return d > 0 ? (d + root) / 2 : m_squared / (2 * (root - d)); // without cancellation
  }

private:
  static FT numerator(const Jacobian<FT>& j, const FT d) { return j.squaredNorm() + 1 + d * d; }

  static void make_positive(Matrix& hessian)
  {
    // most are positive already, which takes much less time to see than eigenvalues
    const Matrix shifted = hessian - 1e-7 * hessian.trace() * Matrix::Identity();
    if(hessian.trace() > 0 && Eigen::LLT<Matrix>(shifted).info() == Eigen::Success)
      return;
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(hessian);
    const Vector& values = solver.eigenvalues(); // in increasing order
    const FT least = 1e-7 * values[3];
    if(values[0] >= least)
      return;
    hessian = solver.eigenvectors() * values.cwiseMax(least).asDiagonal()
            * solver.eigenvectors().transpose();
  }

  FT m_squared;
};

// The multiplications of a factorization that take as long as an iteration over a triangle.
inline constexpr double multiplications_over_a_triangle = 8000;

template <typename FT>
class Distortion_minimizer
{
  using Gradients = Eigen::Matrix<FT, 4, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<FT, Eigen::Dynamic, 1>;
  using Sparse_matrix = Eigen::SparseMatrix<FT>;

public:
  // \param chosen triangles
  // \param number_of per unknown: its number among the unknowns that may change, or -1
  // \param count how many may change
  Distortion_minimizer(const Constrained_triangles& map, const std::vector<std::size_t>& chosen,
                       const std::vector<int>& number_of, const std::size_t count,
                       const std::vector<FT>& unknowns)
    : m_count(Eigen::Index(count)), m_sum(Vector::Zero(m_count))
  {
    for(const std::size_t t : chosen)
      add(map, t, number_of, unknowns);
    make_pattern();
  }

  // If the Jacobian is 0, the distortion has no gradient. It has a minimum there if the
  // regularization is more than 1/2: its second order is 2 |J|^2 / r - 2 det J / r^2, and
  // |det J| is at most |J|^2 / 2. So all triangles of a patch can collapse, for good.
  // \param regularization to start with, at most 1
  // \return the number of iterations
  std::size_t run(const std::size_t largest_number_of_iterations, FT regularization)
  {
    std::size_t after_success = 0;
    for(std::size_t i = 0; i < largest_number_of_iterations; ++i) {
      Progress::tell_each_second([&] {
        return "untangling " + counted(m_terms.size(), "face") + ": iteration " +
               std::to_string(i + 1) + " of at most " +
               std::to_string(largest_number_of_iterations);
      });
      const FT before = energy(Vector::Zero(m_count), 0, regularization);
      const FT after = step(before, regularization);
      if(!(after < before) && regularization <= smallest_regularization)
        return i;
      const FT least = least_determinant();
      if(least > 0 && (++after_success > 10 || (before - after) < 1e-2 * before))
        return i + 1;
      regularization = next_regularization(before, after, least, regularization);
    }
    return largest_number_of_iterations;
  }

  // In units of an iteration over one triangle whose points are free. That takes the time of a few
  // thousand multiplications, as many as the factor of 50,000 such triangles has for each.
  double cost_of_iteration()
  {
    const double triangles = double(m_terms.size());
    const double of_factor = m_block_solver ? m_block_solver->number_of_multiplications()
                                            : m_solver.number_of_multiplications();
    return (std::max)(triangles,
                      (of_factor + 8 * double(m_places.size())) / multiplications_over_a_triangle);
  }

  // The cost of the pattern and its order of elimination, in the same units.
  double cost_of_start() const { return double(m_terms.size()) + double(m_places.size()) / 10; }

  // The changes of the unknowns that may change.
  const Vector& change() const { return m_sum; }

private:
  // The Jacobian changes by the gradients times the change of the unknowns.
  struct Term
  {
    FT area;
    Jacobian<FT> jacobian;
    std::vector<int> unknowns;
    Gradients gradients;
  };

  void add(const Constrained_triangles& map, const std::size_t t,
           const std::vector<int>& number_of, const std::vector<FT>& unknowns)
  {
    const auto& triangle = map.triangles[t];
    const Uv_triangle u = map.triangle(t, unknowns);
    Term term;
    term.area = triangle.shape.area;
    for(const std::size_t p : triangle.points)
      for(const Sparse_row& row : map.rows[p])
        for(const auto& entry : row)
          if(number_of[entry.first] >= 0)
            term.unknowns.push_back(number_of[entry.first]);
    std::sort(term.unknowns.begin(), term.unknowns.end());
    term.unknowns.erase(std::unique(term.unknowns.begin(), term.unknowns.end()),
                        term.unknowns.end());
    term.gradients = Gradients::Zero(4, Eigen::Index(term.unknowns.size()));

    const Eigen::Matrix2d& inverse = triangle.shape.inverse;
    for(Eigen::Index c = 0; c < 2; ++c)
      for(Eigen::Index d = 0; d < 2; ++d) {
        const std::array<FT, 3> weights{{-inverse(0, d) - inverse(1, d), inverse(0, d),
                                             inverse(1, d)}};
        term.jacobian[2 * c + d] = (u[1][std::size_t(c)] - u[0][std::size_t(c)]) * inverse(0, d) +
                                   (u[2][std::size_t(c)] - u[0][std::size_t(c)]) * inverse(1, d);
        for(std::size_t i = 0; i < 3; ++i)
          for(const auto& entry : map.rows[triangle.points[i]][std::size_t(c)])
            if(number_of[entry.first] >= 0)
              term.gradients(2 * c + d, place(term, number_of[entry.first])) +=
                weights[i] * entry.second;
      }
    m_terms.push_back(std::move(term));
  }

  static Eigen::Index place(const Term& term, const int unknown)
  {
    return std::lower_bound(term.unknowns.begin(), term.unknowns.end(), unknown) -
           term.unknowns.begin();
  }

  static Jacobian<FT> change_of(const Term& term, const Vector& direction)
  {
    Jacobian<FT> result = Jacobian<FT>::Zero();
    for(std::size_t i = 0; i < term.unknowns.size(); ++i)
      result += direction[term.unknowns[i]] * term.gradients.col(Eigen::Index(i));
    return result;
  }

  FT energy(const Vector& direction, const FT length,
                const FT regularization) const
  {
    const Distortion<FT> distortion(regularization);
    FT sum = 0;
    for(const Term& term : m_terms)
      sum += term.area * distortion(term.jacobian + length * change_of(term, direction));
    return sum;
  }

  // Returns the energy after the step.
  FT step(const FT before, const FT regularization)
  {
    Vector gradient;
    Vector direction = newton_direction(regularization, gradient);
    const FT slope = gradient.dot(direction);
    if(!direction.allFinite() || !(slope < 0))
      return before;
    for(FT length = 1; length > 1e-10; length /= 2) {
      const FT after = energy(direction, length, regularization);
      if(after <= before + 1e-4 * length * slope) {
        for(Term& term : m_terms)
          term.jacobian += length * change_of(term, direction);
        m_sum += length * direction;
        return after;
      }
    }
    return before;
  }

  Vector newton_direction(const FT regularization, Vector& gradient)
  {
    const Distortion<FT> distortion(regularization);
    gradient = Vector::Zero(m_count);
    m_hessian.coeffs().setZero();
    auto place_of_entry = m_places.begin();
    Eigen::Matrix<FT, 4, 1> first;
    Eigen::Matrix<FT, 4, 4> second;
    for(const Term& term : m_terms) {
      distortion.derivatives(term.jacobian, first, second);
      const Gradients scaled = term.area * second.lazyProduct(term.gradients);
      const Vector slopes = term.area * term.gradients.transpose() * first;
      for(std::size_t i = 0; i < term.unknowns.size(); ++i) {
        gradient[term.unknowns[i]] += slopes[Eigen::Index(i)];
        for(std::size_t j = 0; j <= i; ++j)
          m_hessian.valuePtr()[*place_of_entry++] +=
            term.gradients.col(Eigen::Index(i)).dot(scaled.col(Eigen::Index(j)));
      }
    }
    // translations change nothing, where all triangles of a component are chosen
    m_hessian.diagonal() = (1 + 1e-9) * m_hessian.diagonal();
    if(!m_block_solver) {
      m_solver.factorize(m_hessian);
      return m_solver.solve(-gradient);
    }
    m_block_solver->factorize(m_hessian);
    return m_block_solver->info() == Eigen::Success
             ? Vector(m_block_solver->solve(-gradient))
             : Vector::Constant(m_count, std::numeric_limits<FT>::quiet_NaN());
  }

  // Which entries the Hessian has, and where the entries of each term are.
  void make_pattern()
  {
    std::vector<Eigen::Triplet<FT> > entries;
    const auto for_each_entry = [&](const auto& f) {
      for(const Term& term : m_terms)
        for(std::size_t i = 0; i < term.unknowns.size(); ++i)
          for(std::size_t j = 0; j <= i; ++j)
            f(term.unknowns[i], term.unknowns[j]);
    };
    for_each_entry([&](const int i, const int j) { entries.emplace_back(i, j, 0); });
    m_hessian.resize(m_count, m_count);
    m_hessian.setFromTriplets(entries.begin(), entries.end());
    for_each_entry([&](const int i, const int j) {
      m_places.push_back(&m_hessian.coeffRef(i, j) - m_hessian.valuePtr());
    });
    m_solver.analyzePattern(m_hessian);
    if(m_solver.number_of_multiplications() > multiplications_over_a_triangle *
                                                double(m_terms.size()))
      m_block_solver.emplace().analyzePattern(m_hessian);
  }

  FT least_determinant() const
  {
    FT result = std::numeric_limits<FT>::infinity();
    for(const Term& term : m_terms)
      result = (std::min)(result, determinant(term.jacobian));
    return result;
  }

  // Such that chi of the least determinant falls by a part that depends on what the step gained
  // [Garanzha et al. 2021].
  static FT next_regularization(const FT before, const FT after, const FT least,
                                    const FT regularization)
  {
    const FT part = (std::max)(1 - after / before, 0.1);
    const FT wanted = (1 - part) * Distortion<FT>(regularization).chi(least);
    return least < wanted ? (std::max)(2 * std::sqrt(wanted * (wanted - least)),
                                       smallest_regularization)
                          : smallest_regularization;
  }

  static constexpr FT smallest_regularization = 1e-10;

  Eigen::Index m_count;
  Vector m_sum;
  std::vector<Term> m_terms;
  Sparse_matrix m_hessian;              // its lower triangle
  std::vector<std::ptrdiff_t> m_places; // among its values: of the entries of each term
  Simplicial_cholesky<Sparse_matrix> m_solver; // uses lower triangles
  // in place of it if factors take longer than triangles, for example because the translations of
  // cuts make long rows
  std::optional<Sparse_cholesky<Sparse_matrix> > m_block_solver;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_UNTANGLING_DISTORTION_H
