// Tests of untangling without meshes: derivatives against differences of the energy, steps of the
// minimizer against Newton's equations and the rules of its line search, put together in another
// way; angles of stars that are known; and that nothing is kept that has more flips.

#ifndef SEAMLESS_SNAPPING_TEST_UNTANGLING_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_UNTANGLING_CHECKS_H

#include "checking.h"

#include <CGAL/Seamless_snapping/internal/untangling/untangle.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace untangling_checks {

namespace internal = CGAL::Seamless_snapping::internal;
using internal::Uv;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using Function = std::function<double(const Vector&)>;

// In [-size, size], the same with all standard libraries.
class Numbers
{
public:
  explicit Numbers(const unsigned int seed) : m_random(seed) { }
  double operator()(const double size) { return size * (double(m_random()) / 2147483648. - 1); }
  unsigned int below(const unsigned int n) { return unsigned(m_random()) % n; }

private:
  std::mt19937 m_random;
};

// --- the energy ----------------------------------------------------------------------------------

// As published: (|J|^2 + 1 + det^2) over the regularized determinant.
inline double energy(const double a, const double b, const double c, const double d,
                     const double regularization)
{
  const double det = a * d - b * c;
  const double chi = (det + std::hypot(det, regularization)) / 2;
  return (a * a + b * b + c * c + d * d + 1 + det * det) / chi;
}

inline Vector gradient(const Function& f, const Vector& x, const double step)
{
  Vector result(x.size());
  for(Eigen::Index i = 0; i < x.size(); ++i) {
    const Vector by = step * Vector::Unit(x.size(), i);
    result[i] = (8 * (f(x + by) - f(x - by)) - (f(x + 2 * by) - f(x - 2 * by))) / (12 * step);
  }
  return result;
}

inline Matrix hessian(const Function& f, const Vector& x, const double step)
{
  Matrix result(x.size(), x.size());
  for(Eigen::Index i = 0; i < x.size(); ++i)
    result.col(i) = gradient([&](const Vector& y) { return gradient(f, y, step)[i]; }, x, step);
  return result;
}

inline void test_derivatives()
{
  Numbers numbers(1);
  std::size_t flipped = 0, indefinite = 0;
  for(int i = 0; i < 400; ++i) {
    const double regularization = std::ldexp(1., -(i % 8));
    const internal::Distortion<double> distortion(regularization);
    Eigen::Vector4d j;
    for(Eigen::Index k = 0; k < 4; ++k)
      j[k] = numbers(2);
    const std::string context = "derivatives, " + std::to_string(i);
    const auto f = [&](const Vector& x) { return energy(x[0], x[1], x[2], x[3], regularization); };
    const double here = f(j);
    CHECK_IN(context, std::abs(distortion(j) - here) <= 1e-9 * here);

    Eigen::Vector4d first;
    Eigen::Matrix4d second;
    distortion.derivatives(j, first, second);
    const double step = 0.01 * std::hypot(internal::determinant<double>(j), regularization);
    const Vector g = gradient(f, j, step);
    CHECK_IN(context, (first - g).norm() <= 1e-4 * (g.norm() + here));
    const Matrix h = hessian(f, j, step);
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(h);
    const Matrix positive_part = solver.eigenvectors() *
                                 solver.eigenvalues().cwiseMax(0).asDiagonal() *
                                 solver.eigenvectors().transpose();
    CHECK_IN(context, (second - positive_part).norm() <= 1e-3 * h.norm());
    CHECK_IN(context, Eigen::LLT<Matrix>(second).info() == Eigen::Success); // positive definite
    flipped += internal::determinant<double>(j) < 0 ? 1 : 0;
    indefinite += solver.eigenvalues()[0] < -1e-3 * h.norm() ? 1 : 0;
  }
  CHECK(flipped > 100 && indefinite > 100);
}

// The regularized determinant is the positive solution of x (x - d) = (r / 2)^2, for a determinant
// d and the regularization r; far below zero, too.
inline void test_regularized_determinant()
{
  for(double regularization = 1; regularization >= 1e-10; regularization /= 10)
    for(const double d : {-3., -1e-3, -1e-8, 0., 1e-8, 2.}) {
      const double chi = internal::Distortion<double>(regularization).chi(d);
      const double wanted = regularization * regularization / 4;
      CHECK(chi > 0);
      CHECK(std::abs(chi * (chi - d) - wanted) <= 1e-14 * (wanted + (d > 0 ? d * d : 0)));
    }
  const internal::Distortion<double> distortion(1e-10); // least for rotations
  CHECK(std::abs(distortion({0.6, -0.8, 0.8, 0.6}) - 4) < 1e-12);
}

// --- the minimizer -------------------------------------------------------------------------------

// Points that are sums of few unknowns, some of them of the same ones, turned: as at cuts; and
// triangles of any of them, with shapes that have nothing to do with where they are.
inline internal::Constrained_triangles random_triangles(Numbers& numbers,
                                                        const std::size_t number_of_points)
{
  internal::Constrained_triangles map;
  map.number_of_unknowns = number_of_points + 2;
  for(std::size_t p = 0; p < number_of_points; ++p) {
    map.start.push_back({{numbers(2), numbers(2)}});
    std::array<internal::Sparse_row, 2> rows;
    for(internal::Sparse_row& row : rows) {
      for(unsigned int i = 0; i <= numbers.below(3); ++i)
        row.emplace_back(numbers.below(unsigned(map.number_of_unknowns)),
                         numbers.below(2) == 0 ? 1. : -1.);
      internal::normalize(row);
    }
    map.rows.push_back(rows);
    map.vertex.push_back(p);
  }
  map.angle.assign(number_of_points, std::nan(""));
  for(std::size_t t = 0; t < 2 * number_of_points; ++t) {
    const std::size_t p = numbers.below(unsigned(number_of_points));
    const std::size_t a = 1 + numbers.below(unsigned(number_of_points) - 2);
    const std::size_t b = a + 1 + numbers.below(unsigned(number_of_points - a - 1));
    map.triangles.push_back({{{p, (p + a) % number_of_points, (p + b) % number_of_points}},
                             internal::Reference_shape({{1 + numbers(0.5), numbers(0.5)}},
                                                       {{numbers(0.5), 1 + numbers(0.5)}})});
  }
  // unknowns that no triangle depends on are left out
  std::vector<std::size_t> number_of(map.number_of_unknowns, map.number_of_unknowns);
  map.number_of_unknowns = 0;
  for(const auto& triangle : map.triangles)
    for(const std::size_t p : triangle.points)
      for(const internal::Sparse_row& row : map.rows[p])
        for(const auto& term : row)
          if(number_of[term.first] == number_of.size())
            number_of[term.first] = map.number_of_unknowns++;
  for(auto& rows : map.rows)
    for(internal::Sparse_row& row : rows)
      for(auto& term : row)
        term.first = (std::min)(number_of[term.first], map.number_of_unknowns - 1);
  return map;
}

// The energy of all triangles, as a function of all unknowns, and its derivatives.
struct Energy
{
  const internal::Constrained_triangles& map;

  // du/dx, du/dy, dv/dx, dv/dy, by the inverse of the shape's matrix
  Eigen::Vector4d jacobian(const std::size_t t, const Vector& x) const
  {
    const auto u =
      map.triangle(t, std::vector<double>(x.data(), x.data() + x.size()));
    Eigen::Matrix2d edges;
    edges << u[1][0] - u[0][0], u[2][0] - u[0][0], u[1][1] - u[0][1], u[2][1] - u[0][1];
    const Eigen::Matrix2d j = edges * map.triangles[t].shape.inverse;
    return {j(0, 0), j(0, 1), j(1, 0), j(1, 1)};
  }

  double value(const Vector& x, const double regularization) const
  {
    double sum = 0;
    for(std::size_t t = 0; t < map.triangles.size(); ++t) {
      const Eigen::Vector4d j = jacobian(t, x);
      sum += map.triangles[t].shape.area * energy(j[0], j[1], j[2], j[3], regularization);
    }
    return sum;
  }

  double least_determinant(const Vector& x) const
  {
    double least = 1e300;
    for(std::size_t t = 0; t < map.triangles.size(); ++t)
      least = (std::min)(least, internal::determinant<double>(jacobian(t, x)));
    return least;
  }

  void derivatives(const Vector& x, const double regularization, Vector& first,
                   Matrix& second) const
  {
    first = Vector::Zero(x.size());
    second = Matrix::Zero(x.size(), x.size());
    for(std::size_t t = 0; t < map.triangles.size(); ++t) {
      const Eigen::Vector4d here = jacobian(t, x);
      Matrix changes(4, x.size()); // Jacobians are linear
      for(Eigen::Index i = 0; i < x.size(); ++i)
        changes.col(i) = jacobian(t, x + Vector::Unit(x.size(), i)) - here;
      Eigen::Vector4d g;
      Eigen::Matrix4d h;
      internal::Distortion<double>(regularization).derivatives(here, g, h);
      first += map.triangles[t].shape.area * (changes.transpose() * g);
      second += map.triangles[t].shape.area * (changes.transpose() * h * changes);
    }
  }
};

// Whether a step is the Newton step times the largest of 1, 1/2, 1/4 ... that gains enough.
inline void check_step(const Energy& energy, const Vector& x, const Vector& step,
                       const double regularization, const std::string& context)
{
  Vector first;
  Matrix second;
  energy.derivatives(x, regularization, first, second);
  // second * step = -length * first; there may be directions that change no triangle
  const Vector forces = second * step;
  const double length = std::exp2(std::round(std::log2(-first.dot(forces) / first.squaredNorm())));
  CHECK_IN(context, (forces + length * first).norm() <= 1e-5 * forces.norm());
  const double before = energy.value(x, regularization), slope = first.dot(step) / length;
  CHECK_IN(context, slope < 0 && length <= 1);
  const auto gains = [&](const double l) {
    return energy.value(x + (l / length) * step, regularization) <= before + 1e-4 * l * slope;
  };
  CHECK_IN(context, gains(length) && (length == 1 || !gains(2 * length)));
}

// The regularization for which the regularized least determinant falls by what the energy fell by,
// but at least by a tenth.
inline double next_regularization(const double before, const double after, const double least,
                                  const double regularization)
{
  const double chi = (least + std::hypot(least, regularization)) / 2;
  const double wanted = (std::min)(after / before, 0.9) * chi;
  const double square = 4 * wanted * (wanted - least);
  return (std::max)(1e-10, std::sqrt((std::max)(0., square)));
}

inline void test_steps()
{
  std::size_t steps = 0, with_flips = 0;
  for(unsigned int seed = 1; seed <= 60; ++seed) {
    Numbers numbers(seed);
    const auto map = random_triangles(numbers, 4 + seed % 8);
    const std::size_t n = map.number_of_unknowns;
    std::vector<std::size_t> all(map.triangles.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    std::vector<int> number_of(n);
    std::iota(number_of.begin(), number_of.end(), 0);
    const Energy energy{map};
    Vector x = Vector::Zero(Eigen::Index(n));
    double regularization = 1;
    for(std::size_t i = 1; i <= 6; ++i) {
      internal::Distortion_minimizer<double> minimizer(map, all, number_of, n,
                                                       std::vector<double>(n, 0.));
      const std::size_t iterations = minimizer.run(i, 1.);
      const std::string context =
        "step " + std::to_string(i) + " of random triangles, seed " + std::to_string(seed);
      const Vector next = minimizer.change();
      if(iterations < i) { // ended before
        CHECK_IN(context, energy.least_determinant(next) > 0);
        break;
      }
      check_step(energy, x, next - x, regularization, context);
      const double before = energy.value(x, regularization);
      const double after = energy.value(next, regularization);
      const double least = energy.least_determinant(next);
      regularization = next_regularization(before, after, least, regularization);
      with_flips += least <= 0 ? 1 : 0;
      ++steps;
      x = next;
    }
  }
  std::cout << steps << " steps of Newton's method, " << with_flips << " to maps with flips"
            << std::endl;
  CHECK(steps > 100 && with_flips > 20);
}

// --- angles and flips ----------------------------------------------------------------------------

// A vertex, and a ring around it that goes around it some times; layers of 8 edges are larger and
// larger, and a last part closes it where it turns by less than a full turn.
inline std::vector<Uv> spiral(const double turns)
{
  std::vector<Uv> result;
  for(int i = 0; i <= int(8 * turns); ++i) {
    const double angle = i * internal::full_turn / 8, radius = 1 + i / 8;
    result.push_back({{radius * std::cos(angle), radius * std::sin(angle)}});
  }
  return result;
}

inline void test_angle_sums()
{
  for(const double turns : {0.25, 0.75, 1., 1.25, 2., 3.}) {
    const std::string context = "angles of " + std::to_string(turns) + " turns";
    const std::vector<Uv> ring = spiral(turns);
    const auto sum = [&](const Uv& center) {
      internal::Angle_sum result;
      for(std::size_t i = 0; i + 1 < ring.size(); ++i)
        result.add({{ring[i + 1], center, ring[i]}}, 1);
      return result;
    };
    const double wanted = turns * internal::full_turn;
    const auto whole = sum({{0, 0}});
    CHECK_IN(context, std::abs(whole.without_folds() - wanted) < 1e-12);
    CHECK_IN(context, !whole.is_wrong(wanted) && whole.is_wrong(wanted + internal::full_turn) &&
                        whole.is_wrong(wanted - internal::full_turn));
    // beside the innermost of some layers: a turn less, and as much in folds
    if(turns >= 2) {
      const auto folded = sum({{-1.05, 0.1}});
      CHECK_IN(context, std::abs(folded.without_folds() - wanted) < 1);
      CHECK_IN(context, !folded.is_wrong(wanted) && !folded.is_wrong(wanted + 10));
    }
    auto taken_away = whole;
    taken_away.add({{ring[1], {{0, 0}}, ring[0]}}, 1, -1);
    taken_away.add({{ring[1], {{0, 0}}, ring[0]}}, 1);
    CHECK_IN(context, std::abs(taken_away.without_folds() - wanted) < 1e-12);
  }
}

// A vertex in a fixed ring, anywhere. \param first and last radius of the ring's points
inline internal::Constrained_triangles fan(Numbers& numbers, const double first, const double last)
{
  internal::Constrained_triangles map;
  const std::size_t n = 4 + numbers.below(6);
  map.number_of_unknowns = 2;
  map.start.push_back({{numbers(4), numbers(4)}});
  map.rows.push_back({{internal::Sparse_row{{0, 1.}}, internal::Sparse_row{{1, 1.}}}});
  for(std::size_t i = 0; i < n; ++i) {
    const double radius = (first + last) / 2 + numbers((last - first) / 2);
    const double angle = internal::full_turn * double(i) / double(n);
    map.start.push_back({{radius * std::cos(angle), radius * std::sin(angle)}});
    map.rows.emplace_back();
    map.triangles.push_back({{{0, 1 + i, 1 + (i + 1) % n}},
                             internal::Reference_shape({{1 + numbers(0.5), numbers(0.5)}},
                                                       {{numbers(0.5), 1 + numbers(0.5)}})});
  }
  for(std::size_t i = 0; i <= n; ++i)
    map.vertex.push_back(i);
  map.angle.assign(n + 1, std::nan(""));
  return map;
}

// Rings around a point have a place for their vertex, which is found from anywhere. Others may have
// none: then, there are no more flips than before.
inline void test_fans()
{
  std::size_t repaired = 0, kept = 0;
  for(unsigned int seed = 1; seed <= 300; ++seed) {
    const std::string context = "fan, seed " + std::to_string(seed);
    Numbers numbers(seed);
    const bool has_place = seed % 2 == 0;
    const auto map = fan(numbers, has_place ? 0.2 : -2, 3);
    internal::Untangler<double> untangler(map);
    const std::size_t before = map.not_positive(untangler.unknowns()).size();
    untangler.run(100, internal::Untangling::NEAR_BY_FIRST);
    const std::size_t after = map.not_positive(untangler.unknowns()).size();
    CHECK_IN(context, has_place ? after == 0 : after <= before);
    const bool is_moved = untangler.unknowns() != std::vector<double>(2, 0.);
    CHECK_IN(context, is_moved == (after < before));
    repaired += before > 0 && after == 0 ? 1 : 0;
    kept += after > 0 && !is_moved ? 1 : 0;
  }
  std::cout << repaired << " fans repaired, " << kept << " with flips kept" << std::endl;
  CHECK(repaired > 100 && kept > 20);
}

// The first attempt, for which one iteration is allowed, gives no vertex another angle than it is
// to have; the last one may.
inline void test_wanted_angles()
{
  std::size_t tested = 0;
  for(unsigned int seed = 1; seed <= 40; ++seed) {
    const std::string context = "angle of a fan, seed " + std::to_string(seed);
    Numbers numbers(seed);
    auto map = fan(numbers, 0.2, 3);
    if(map.not_positive({0, 0}).empty())
      continue;
    const auto is_repaired = [&](const std::size_t iterations) {
      internal::Untangler<double> untangler(map);
      untangler.run(double(iterations), internal::Untangling::NEAR_BY_FIRST);
      return map.not_positive(untangler.unknowns()).empty();
    };
    map.angle[0] = internal::full_turn;
    if(!is_repaired(1))
      continue;
    map.angle[0] = 2 * internal::full_turn; // which a ring does not allow
    CHECK_IN(context, !is_repaired(1) && is_repaired(100));
    ++tested;
  }
  CHECK(tested > 20);
}

// An iteration over triangles with hundreds of unknowns counts for as many as take as long.
inline void test_cost_of_iterations()
{
  const auto used_iterations = [](const unsigned int seed, const std::size_t terms) {
    Numbers numbers(seed);
    auto map = fan(numbers, 0.2, 3);
    map.number_of_unknowns = 2 * terms;
    for(std::size_t c = 0; c < 2; ++c) {
      map.rows[0][c].clear(); // the coordinate of the middle is a mean
      for(std::size_t i = 0; i < terms; ++i)
        map.rows[0][c].emplace_back(c * terms + i, 1 / double(terms));
    }
    internal::Untangler<double> untangler(map);
    return untangler.run(100, internal::Untangling::NEAR_BY_FIRST);
  };
  std::size_t tested = 0;
  for(unsigned int seed = 1; seed <= 10; ++seed) {
    const double one = used_iterations(seed, 1), many = used_iterations(seed, 100);
    CHECK_IN("costs of a fan, seed " + std::to_string(seed), one == 0 ? many == 0
                                                                      : many > 20 * one);
    tested += one > 0;
  }
  CHECK(tested > 5);
}

inline void test_untangling_parts()
{
  test_derivatives();
  test_regularized_determinant();
  test_steps();
  test_angle_sums();
  test_fans();
  test_wanted_angles();
  test_cost_of_iterations();
}

} // namespace untangling_checks

#endif // SEAMLESS_SNAPPING_TEST_UNTANGLING_CHECKS_H
