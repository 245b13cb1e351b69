// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_SUPERNODAL_CHOLESKY_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_SUPERNODAL_CHOLESKY_H

#include <CGAL/license/Seamless_snapping.h>

// A sparse Cholesky factorization that works on dense blocks, for the big systems of surface
// meshes: Eigen's simplicial factorization handles one scalar at a time, and takes several times as
// long where cones and handles couple the two coordinates. It is the multifrontal method
// [Liu 1992]; ordering and dense kernels are Eigen's.

#include <CGAL/Eigen_matrix.h>
#include <CGAL/Eigen_sparse_matrix.h>
#include <CGAL/Eigen_vector.h>

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {
namespace parameterization {

class Supernodal_cholesky
{
  using Sparse = Eigen::SparseMatrix<double>; // of column-major order
  using Dense = Eigen::MatrixXd;
  using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

  // Adjacent columns of the factor with (almost) the same rows below them.
  struct Supernode
  {
    int first;               // column
    int size;                // number of columns
    int parent;              // supernode, -1 for a root
    std::vector<int> rows;   // below the columns, ascending
    Dense panel;             // of the factor: `size` columns, `size + rows.size()` rows
  };

public:
  // Factors the symmetric matrix whose lower triangle is given. Returns false if it is not positive
  // definite, as far as the rounding errors let it tell.
  bool compute(const Sparse& matrix)
  {
    const Sparse permuted = order(matrix);
    find_supernodes(permuted);
    return factorize(permuted);
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const
  {
    Eigen::VectorXd x = m_permutation * b;
    Eigen::VectorXd below;
    for(const Supernode& s : m_supernodes) {
      auto top = x.segment(s.first, s.size);
      s.panel.topRows(s.size).triangularView<Eigen::Lower>().solveInPlace(top);
      below.noalias() = s.panel.bottomRows(rows_below(s)) * top;
      for(std::size_t i = 0; i < s.rows.size(); ++i)
        x[s.rows[i]] -= below[static_cast<Eigen::Index>(i)];
    }
    for(auto it = m_supernodes.rbegin(); it != m_supernodes.rend(); ++it) {
      const Supernode& s = *it;
      below.resize(rows_below(s));
      for(std::size_t i = 0; i < s.rows.size(); ++i)
        below[static_cast<Eigen::Index>(i)] = x[s.rows[i]];
      auto top = x.segment(s.first, s.size);
      top.noalias() -= s.panel.bottomRows(rows_below(s)).transpose() * below;
      s.panel.topRows(s.size).triangularView<Eigen::Lower>().transpose().solveInPlace(top);
    }
    return m_permutation.transpose() * x;
  }

private:
  static Eigen::Index rows_below(const Supernode& s)
  {
    return static_cast<Eigen::Index>(s.rows.size());
  }

  // Fills `m_permutation` by a fill-reducing ordering in which each subtree of the elimination tree
  // is contiguous, and `m_parent` by that tree. Returns the permuted lower triangle.
  Sparse order(const Sparse& matrix)
  {
    Permutation inverse;
    Eigen::AMDOrdering<int>()(matrix.selfadjointView<Eigen::Lower>(), inverse);
    const Permutation fill_reducing = inverse.inverse();
    Sparse upper(matrix.rows(), matrix.cols());
    upper.selfadjointView<Eigen::Upper>()
      = matrix.selfadjointView<Eigen::Lower>().twistedBy(fill_reducing);
    const std::vector<int> parent = elimination_tree(upper);
    const Permutation post = postorder(parent);

    m_parent.assign(parent.size(), -1);
    for(std::size_t j = 0; j < parent.size(); ++j)
      if(parent[j] != -1)
        m_parent[static_cast<std::size_t>(post.indices()[static_cast<Eigen::Index>(j)])]
          = post.indices()[parent[j]];
    m_permutation = post * fill_reducing;
    Sparse lower(matrix.rows(), matrix.cols());
    lower.selfadjointView<Eigen::Lower>()
      = matrix.selfadjointView<Eigen::Lower>().twistedBy(m_permutation);
    return lower;
  }

  static std::vector<int> elimination_tree(const Sparse& upper)
  {
    const std::size_t n = static_cast<std::size_t>(upper.cols());
    std::vector<int> parent(n, -1), ancestor(n, -1);
    for(int k = 0; k < upper.cols(); ++k)
      for(Sparse::InnerIterator it(upper, k); it; ++it)
        for(int i = static_cast<int>(it.row()); i != -1 && i < k; ) {
          int& next = ancestor[static_cast<std::size_t>(i)];
          if(next == -1)
            parent[static_cast<std::size_t>(i)] = k;
          i = std::exchange(next, k);
        }
    return parent;
  }

  static Permutation postorder(const std::vector<int>& parent)
  {
    const int n = static_cast<int>(parent.size());
    std::vector<int> first_child(parent.size(), -1), sibling(parent.size(), -1), stack;
    for(int j = n - 1; j >= 0; --j)
      if(const int p = parent[static_cast<std::size_t>(j)]; p != -1)
        sibling[static_cast<std::size_t>(j)]
          = std::exchange(first_child[static_cast<std::size_t>(p)], j);
    Permutation post(n);
    int count = 0;
    for(int root = 0; root < n; ++root) {
      if(parent[static_cast<std::size_t>(root)] != -1)
        continue;
      stack.push_back(root);
      while(!stack.empty()) {
        const int j = stack.back();
        const int child = std::exchange(first_child[static_cast<std::size_t>(j)], -1);
        if(child != -1) {
          for(int c = child; c != -1; c = sibling[static_cast<std::size_t>(c)])
            stack.push_back(c);
        } else {
          post.indices()[j] = count++;
          stack.pop_back();
        }
      }
    }
    return post;
  }

  // The number of entries below the diagonal of each column of the factor.
  std::vector<int> column_counts(const Sparse& lower) const
  {
    const Sparse rows = lower.transpose(); // row k of the matrix as a column
    std::vector<int> count(m_parent.size(), 0), mark(m_parent.size(), -1);
    for(int k = 0; k < rows.cols(); ++k) {
      mark[static_cast<std::size_t>(k)] = k;
      for(Sparse::InnerIterator it(rows, k); it; ++it)
        for(std::size_t i = static_cast<std::size_t>(it.row()); mark[i] != k;
            i = static_cast<std::size_t>(m_parent[i])) {
          ++count[i];
          mark[i] = k;
        }
    }
    return count;
  }

  // Merging a supernode with its parent stores zeros, but makes blocks larger.
  static bool is_worth_merging(const Supernode& child, const int child_rows,
                               const Supernode& parent, const int parent_rows)
  {
    const double width = child.size + parent.size;
    const double zeros = double(child.size) * (parent.size + parent_rows - child_rows);
    const double entries = width * (width + parent_rows);
    return width <= 8 || zeros < (width <= 48 ? 0.25 : 0.05) * entries;
  }

  void find_supernodes(const Sparse& lower)
  {
    const std::vector<int> count = column_counts(lower);
    m_supernodes.clear();
    for(int j = 0; j < static_cast<int>(count.size()); ++j) {
      Supernode node{j, 1, -1, {}, {}};
      const int rows = count[static_cast<std::size_t>(j)];
      // All columns of a supernode are ancestors of each other: the last one decides.
      while(!m_supernodes.empty()) {
        const Supernode& child = m_supernodes.back();
        const std::size_t last = static_cast<std::size_t>(node.first - 1);
        if(m_parent[last] != node.first || !is_worth_merging(child, count[last], node, rows))
          break;
        node.first = child.first;
        node.size += child.size;
        m_supernodes.pop_back();
      }
      m_supernodes.push_back(std::move(node));
    }
    find_rows(lower);
  }

  void find_rows(const Sparse& lower)
  {
    std::vector<int> supernode_of(m_parent.size()), mark(m_parent.size(), -1);
    std::vector<std::vector<int> > children(m_supernodes.size());
    for(std::size_t i = 0; i < m_supernodes.size(); ++i)
      std::fill_n(supernode_of.begin() + m_supernodes[i].first, m_supernodes[i].size,
                  static_cast<int>(i));
    for(std::size_t i = 0; i < m_supernodes.size(); ++i) {
      Supernode& s = m_supernodes[i];
      const int end = s.first + s.size;
      const auto add = [&](const int row)
      {
        int& m = mark[static_cast<std::size_t>(row)];
        if(row >= end && m != static_cast<int>(i)) {
          m = static_cast<int>(i);
          s.rows.push_back(row);
        }
      };
      for(int j = s.first; j < end; ++j)
        for(Sparse::InnerIterator it(lower, j); it; ++it)
          add(static_cast<int>(it.row()));
      for(const int c : children[i])
        for(const int row : m_supernodes[static_cast<std::size_t>(c)].rows)
          add(row);
      std::sort(s.rows.begin(), s.rows.end());
      if(!s.rows.empty()) {
        s.parent = supernode_of[static_cast<std::size_t>(s.rows.front())];
        children[static_cast<std::size_t>(s.parent)].push_back(static_cast<int>(i));
      }
    }
  }

  // Each supernode sums up its columns of the matrix and what its children leave, eliminates its
  // own columns, and leaves a dense update of the rows below to its parent.
  bool factorize(const Sparse& lower)
  {
    std::vector<std::vector<std::pair<const Supernode*, Dense> > > updates(m_supernodes.size());
    std::vector<int> local(m_parent.size());
    for(std::size_t i = 0; i < m_supernodes.size(); ++i) {
      Supernode& s = m_supernodes[i];
      for(int j = 0; j < s.size; ++j)
        local[static_cast<std::size_t>(s.first + j)] = j;
      for(std::size_t r = 0; r < s.rows.size(); ++r)
        local[static_cast<std::size_t>(s.rows[r])] = s.size + static_cast<int>(r);

      s.panel.setZero(s.size + rows_below(s), s.size);
      Dense update = Dense::Zero(rows_below(s), rows_below(s));
      for(int j = 0; j < s.size; ++j)
        for(Sparse::InnerIterator it(lower, s.first + j); it; ++it)
          s.panel(local[static_cast<std::size_t>(it.row())], j) += it.value();
      for(const auto& child : updates[i])
        add_update(child.first->rows, child.second, local, s, update);
      updates[i].clear();
      updates[i].shrink_to_fit();

      if(!eliminate(s, update))
        return false;
      if(s.parent != -1)
        updates[static_cast<std::size_t>(s.parent)].emplace_back(&s, std::move(update));
    }
    return true;
  }

  static void add_update(const std::vector<int>& rows, const Dense& source,
                         const std::vector<int>& local, Supernode& s, Dense& update)
  {
    const Eigen::Index n = static_cast<Eigen::Index>(rows.size());
    for(Eigen::Index c = 0; c < n; ++c) {
      const int column = local[static_cast<std::size_t>(rows[static_cast<std::size_t>(c)])];
      const bool in_panel = column < s.size;
      double* const to = in_panel ? &s.panel(0, column) : &update(0, column - s.size);
      const int first_row = in_panel ? 0 : s.size;
      for(Eigen::Index r = c; r < n; ++r)
        to[local[static_cast<std::size_t>(rows[static_cast<std::size_t>(r)])] - first_row]
          += source(r, c);
    }
  }

  static bool eliminate(Supernode& s, Dense& update)
  {
    auto diagonal = s.panel.topRows(s.size);
    Eigen::Ref<Dense, 0, Eigen::OuterStride<> > block(diagonal);
    const Eigen::LLT<Eigen::Ref<Dense, 0, Eigen::OuterStride<> > > factor(block);
    if(factor.info() != Eigen::Success)
      return false;
    if(!s.rows.empty()) {
      auto below = s.panel.bottomRows(rows_below(s));
      diagonal.triangularView<Eigen::Lower>().transpose()
        .template solveInPlace<Eigen::OnTheRight>(below);
      update.selfadjointView<Eigen::Lower>().rankUpdate(below, -1);
    }
    return true;
  }

  Permutation m_permutation;
  std::vector<int> m_parent; // the elimination tree, per column
  std::vector<Supernode> m_supernodes;
};

// A model of `SparseLinearAlgebraWithFactorTraits_d` for symmetric positive definite systems.
class Supernodal_solver_traits
{
public:
  using NT = double;
  using Index = Eigen::Index;
  using Matrix = CGAL::Eigen_sparse_matrix<NT>;
  using Vector = CGAL::Eigen_vector<NT>;

  bool factor(const Matrix& matrix, NT& scale)
  {
    scale = 1;
    return m_factor.compute(matrix.eigen_object());
  }

  bool linear_solver(const Vector& b, Vector& x)
  {
    x = m_factor.solve(b.eigen_object());
    return true;
  }

  bool linear_solver(const Matrix& matrix, const Vector& b, Vector& x, NT& scale)
  {
    return factor(matrix, scale) && linear_solver(b, x);
  }

private:
  Supernodal_cholesky m_factor;
};

} // namespace parameterization
} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_PARAMETERIZATION_SUPERNODAL_CHOLESKY_H
