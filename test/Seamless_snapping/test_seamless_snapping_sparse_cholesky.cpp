// The sparse Cholesky factorization that parametrizations are computed with: small residuals on
// matrices of many shapes, agreement with Eigen's own, and indefinite matrices noticed.

#include "checking.h"

#include <CGAL/Seamless_snapping/internal/parameterization/Supernodal_cholesky.h>

#include <CGAL/Random.h>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using Sparse = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;
using CGAL::Seamless_snapping::internal::parameterization::Supernodal_cholesky;

// Symmetric and diagonally dominant, with the given edges and a margin on the diagonal.
class Matrix_builder
{
public:
  explicit Matrix_builder(const int n) : m_size(n), m_diagonal(std::size_t(n), 1e-3) { }

  void add_edge(const int i, const int j, const double value)
  {
    if(i == j)
      return;
    m_entries.emplace_back(i, j, value);
    m_entries.emplace_back(j, i, value);
    m_diagonal[std::size_t(i)] += std::abs(value);
    m_diagonal[std::size_t(j)] += std::abs(value);
  }

  Sparse matrix() const
  {
    auto entries = m_entries;
    for(int i = 0; i < m_size; ++i)
      entries.emplace_back(i, i, m_diagonal[std::size_t(i)]);
    Sparse result(m_size, m_size);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

private:
  int m_size;
  std::vector<double> m_diagonal;
  std::vector<Eigen::Triplet<double> > m_entries;
};

Sparse random_matrix(const int n, const int number_of_edges, CGAL::Random& random)
{
  Matrix_builder builder(n);
  for(int e = 0; e < number_of_edges; ++e)
    builder.add_edge(random.get_int(0, n), random.get_int(0, n), random.get_double(-1, 1));
  return builder.matrix();
}

// A square grid, and a few unknowns that are coupled to many of the others.
Sparse grid_matrix(const int n, const int number_of_dense_rows, CGAL::Random& random)
{
  Matrix_builder builder(n * n + number_of_dense_rows);
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      if(i + 1 < n)
        builder.add_edge(i * n + j, (i + 1) * n + j, -1);
      if(j + 1 < n)
        builder.add_edge(i * n + j, i * n + j + 1, -1);
    }
  for(int d = 0; d < number_of_dense_rows; ++d)
    for(int k = 0; k < 3 * n; ++k)
      builder.add_edge(n * n + d, random.get_int(0, n * n), random.get_double(-1, 1));
  return builder.matrix();
}

void check(const std::string& name, const Sparse& matrix)
{
  const Vector b = Vector::LinSpaced(matrix.rows(), -1, 2);
  Supernodal_cholesky factor;
  if(!CHECK(factor.compute(matrix)))
    std::cerr << "    " << name << std::endl;
  const Vector x = factor.solve(b);
  const double residual = (matrix * x - b).norm() / b.norm();
  const double difference = (x - Vector(Eigen::SimplicialLDLT<Sparse>(matrix).solve(b))).norm();
  if(!CHECK(residual <= 1e-10) || !CHECK(difference <= 1e-8 * x.norm()))
    std::cerr << "    " << name << ": " << residual << ", " << difference << std::endl;

  // Less than what the diagonal has in addition to the rest makes it indefinite.
  Sparse indefinite = matrix;
  indefinite.coeffRef(matrix.rows() / 2, matrix.rows() / 2) = -1;
  CHECK(!factor.compute(indefinite));
}

int main()
{
  const unsigned int seed = 7;
  std::cout << "seed " << seed << std::endl;
  CGAL::Random random(seed);
  check("one unknown", random_matrix(1, 0, random));
  check("diagonal", random_matrix(20, 0, random));
  for(int n = 2; n <= 60; ++n)
    check("random", random_matrix(n, random.get_int(1, 4 * n), random));
  check("several components", random_matrix(500, 300, random));
  check("dense", random_matrix(80, 4000, random));
  check("grid", grid_matrix(40, 0, random));
  check("grid with dense rows", grid_matrix(40, 5, random));
  return report_checks();
}
