// The constraint systems of a parametrization that solvers are compared on: the full one, Sec. 5.2,
// per corner or per sector, and the reduced one, Sec. 5.3; and systems C x = 0 from MatrixMarket
// files.

#ifndef SEAMLESS_SNAPPING_BENCHMARK_COMPARED_SYSTEMS_H
#define SEAMLESS_SNAPPING_BENCHMARK_COMPARED_SYSTEMS_H

#include "Parametrized_model.h"
#include "full_seamless_system.h"
#include "random_systems.h"
#include "reduced_seamless_system.h"
#include "snap_in_any_form.h"

#include <CGAL/Linear_snapping/snap_to_linear_constraints.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>

#include <Eigen/SparseCore>
#include <unsupported/Eigen/SparseExtra>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace compared_systems {

namespace CS = CGAL::Seamless_snapping;
using exact_reference::System;

struct Problem
{
  std::string model, kind;
  std::size_t nodes = 0;
  System system;
  std::vector<double> xbar;
};

// Without the variables that are in no row.
inline Problem compressed(const std::string& model, const std::string& kind, std::size_t nodes,
                          const System& system, const std::vector<double>& xbar)
{
  Problem result;
  result.model = model;
  result.kind = kind;
  result.nodes = nodes;
  std::vector<std::size_t> new_column(system.columns, system.columns);
  for(std::size_t r = 0; r < system.rows.size(); ++r) {
    exact_reference::Row row = exact_reference::merged(system.rows[r]);
    for(auto& entry : row) {
      std::size_t& column = new_column[entry.column];
      if(column == system.columns) {
        column = result.xbar.size();
        result.xbar.push_back(xbar[entry.column]);
      }
      entry.column = column;
    }
    result.system.add_row(row, system.b[r]);
  }
  result.system.columns = result.xbar.size();
  return result;
}

// Sec. 5.2: one equation (4) for each interior edge, one equation (5) for each aligned edge. Per
// corner, or per sector between cut edges, which leaves the equations of cut and aligned edges.
inline Problem full_problem(const Parametrized_model& model, const std::string& name,
                            std::size_t nodes, bool is_per_sector)
{
  const auto transitions = CS::seam_transitions(model.mesh, model.uv);
  const auto full = exact_check::full_system(
    model.mesh, model.uv, [&](auto h) { return transitions.rotation(h); },
    [&](auto e) { return bool(model.is_aligned[e]); },
    [&](auto e) { return !is_per_sector || transitions.is_cut(model.mesh.halfedge(e)); });
  std::vector<double> xbar;
  for(const auto& x : full.xbar)
    xbar.push_back(CGAL::to_double(x));
  return compressed(name, is_per_sector ? "sectors" : "corners", nodes, full.system, xbar);
}

// Of the kinds: "reduced", "sectors", "corners".
inline std::vector<Problem> problems_of_model(const std::string& file,
                                              const std::vector<std::string>& kinds)
{
  const std::string name = std::filesystem::path(file).stem().string();
  const Parametrized_model model(file);
  if(!model.status)
    throw std::runtime_error(file + ": " + model.status.message);
  const auto reduced = reduced_system::reduced_seamless_system(
    model.mesh, model.uv, CS::parameters::edge_is_constrained_map(model.is_aligned));
  std::vector<Problem> result;
  for(const std::string& kind : kinds)
    result.push_back(
      kind == "reduced"
        ? compressed(name, kind, reduced.number_of_nodes, reduced.system, reduced.xbar)
        : full_problem(model, name, reduced.number_of_nodes, kind == "sectors"));
  return result;
}

// Values: random ones, snapped, with noise of 1e-8.
inline Problem problem_of_matrix(const std::string& file)
{
  Eigen::SparseMatrix<int> matrix;
  if(!Eigen::loadMarket(matrix, file))
    throw std::runtime_error(file + ": can't be read");
  System system;
  system.columns = std::size_t(matrix.cols());
  system.rows.resize(std::size_t(matrix.rows()));
  system.b.assign(system.rows.size(), exact_reference::Rational(0));
  for(Eigen::Index c = 0; c < matrix.cols(); ++c)
    for(Eigen::SparseMatrix<int>::InnerIterator entry(matrix, c); entry; ++entry)
      system.rows[std::size_t(entry.row())].push_back(
        { std::size_t(c), exact_reference::Rational(entry.value()) });
  random_systems::Random random(1);
  std::vector<double> x(system.columns);
  std::generate(x.begin(), x.end(), [&] { return random_systems::random_real(random); });
  CS::snap_to_linear_constraints(matrix, x);
  for(double& value : x)
    value += 1e-8 * random_systems::random_real(random);
  return compressed(std::filesystem::path(file).stem().string(), "matrix", 0, system, x);
}

inline std::vector<Problem> problems_of_file(const std::string& file,
                                             const std::vector<std::string>& kinds)
{
  if(std::filesystem::path(file).extension() == ".mtx")
    return { problem_of_matrix(file) };
  return problems_of_model(file, kinds);
}

} // namespace compared_systems

#endif // SEAMLESS_SNAPPING_BENCHMARK_COMPARED_SYSTEMS_H
