// Cells of triangulations and of complexes in them, as the ranges that snapping of volumes takes.

#ifndef SEAMLESS_SNAPPING_TEST_TRIANGULATION_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_TRIANGULATION_CHECKS_H

#include "volume_checks.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <random>
#include <set>
#include <vector>

namespace triangulation_checks {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel>;

inline Delaunay random_triangulation(const unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Delaunay result;
  for(int i = 0; i < 60; ++i) {
    std::array<double, 3> p;
    for(double& x : p)
      x = coordinate(random);
    result.insert(Kernel::Point_3(p[0], p[1], p[2]));
  }
  return result;
}

// Part of a triangulation, as far as `cells_of_c3t3()` uses a complex.
struct Complex
{
  using Triangulation = Delaunay;
  using Cells = std::vector<Delaunay::Cell_handle>;
  struct Cell_iterator : Cells::const_iterator // converts to a handle, as that of CGAL does
  {
    operator Delaunay::Cell_handle() const { return **this; }
  };

  Cell_iterator cells_in_complex_begin() const { return {cells.begin()}; }
  Cell_iterator cells_in_complex_end() const { return {cells.end()}; }
  auto facets_in_complex_begin() const { return facets.begin(); }
  auto facets_in_complex_end() const { return facets.end(); }
  auto edges_in_complex_begin() const { return edges.begin(); }
  auto edges_in_complex_end() const { return edges.end(); }

  Cells cells;
  std::vector<Delaunay::Facet> facets;
  std::vector<Delaunay::Edge> edges;
};

// The numbers of cells, their vertices, and their neighbors are those of the handles.
inline void check_numbers(const Snapping::Triangulation_cells<Delaunay>& found)
{
  const std::set<Delaunay::Cell_handle> cells(found.cells.begin(), found.cells.end());
  const std::set<Delaunay::Vertex_handle> vertices(found.vertices.begin(), found.vertices.end());
  CHECK_EQUAL(cells.size(), found.cells.size());
  CHECK_EQUAL(vertices.size(), found.vertices.size());
  CHECK_EQUAL(found.tetrahedra.size(), found.cells.size());
  CHECK_EQUAL(found.neighbors.size(), found.cells.size());
  for(std::size_t i = 0; i < found.cells.size(); ++i)
    for(std::size_t k = 0; k < 4; ++k) {
      const auto vertex = found.cells[i]->vertex(int(k));
      const auto neighbor = found.cells[i]->neighbor(int(k));
      CHECK(found.vertices[std::size_t(found.tetrahedra[i][k])] == vertex);
      const int n = found.neighbors[i][k];
      CHECK(n < 0 ? cells.count(neighbor) == 0 : found.cells[std::size_t(n)] == neighbor);
    }
}

// A map that is twice the points, but for noise.
inline void check_snap(const Snapping::Triangulation_cells<Delaunay>& found,
                       const unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-1e-9, 1e-9);
  Tet_map map{found.tetrahedra, {}};
  for(const auto c : found.cells)
    for(int k = 0; k < 4; ++k) {
      const Kernel::Point_3& p = c->vertex(k)->point();
      map.corners.push_back({{2 * p.x() + noise(random), 2 * p.y() + noise(random),
                              2 * p.z() + noise(random)}});
    }
  const Tet_map before = map;
  const Snapping_report report = snap(map, parameters::cell_neighbors(found.neighbors)
                                                 .align_boundary(false));
  CHECK_IN(report.message, bool(report));
  CHECK(!volume_reference::check(before, false).is_exact());
  CHECK(volume_reference::largest_change(before, map) < 1e-8);
  const auto exact = volume_reference::check(map, false);
  CHECK(exact.is_exact() && exact.interior > 0 && exact.cuts == 0);
}

inline void test_cells_of_triangulation(const unsigned int seed)
{
  std::cout << "cells of a triangulation: seed " << seed << "\n";
  const Delaunay triangulation = random_triangulation(seed);
  const auto found = Snapping::cells_of_triangulation(triangulation);
  check_numbers(found);
  CHECK_EQUAL(found.cells.size(), triangulation.number_of_finite_cells());
  CHECK_EQUAL(found.vertices.size(), triangulation.number_of_vertices());
  for(const auto c : found.cells)
    CHECK(!triangulation.is_infinite(c));
  CHECK(found.interfaces.empty() && found.edges.empty());
  check_snap(found, seed);
}

// Cells below a height, all facets at which two sides of a plane meet, and one edge of each cell.
inline void test_cells_of_complex(const unsigned int seed)
{
  const Delaunay triangulation = random_triangulation(seed);
  const auto sum = [](const Delaunay::Cell_handle c, const int coordinate) {
    double result = 0;
    for(int k = 0; k < 4; ++k)
      result += c->vertex(k)->point()[coordinate];
    return result;
  };
  const auto is_inside = [&](const Delaunay::Cell_handle c)
    { return !triangulation.is_infinite(c) && sum(c, 2) < 1; };
  Complex complex;
  for(const auto c : triangulation.finite_cell_handles())
    if(is_inside(c)) {
      complex.cells.push_back(c);
      complex.edges.emplace_back(c, 1, 3);
    }
  std::vector<std::set<Delaunay::Vertex_handle> > interfaces;
  for(const auto& f : triangulation.finite_facets()) {
    const auto other = f.first->neighbor(f.second);
    const bool is_finite = !triangulation.is_infinite(f.first) && !triangulation.is_infinite(other);
    if(is_finite && (sum(f.first, 0) < 0) == (sum(other, 0) < 0))
      continue;
    complex.facets.push_back(f);
    if(is_inside(f.first) && is_inside(other)) {
      interfaces.emplace_back();
      for(int k = 0; k < 4; ++k)
        if(k != f.second)
          interfaces.back().insert(f.first->vertex(k));
    }
  }
  CHECK(!interfaces.empty() && interfaces.size() < complex.facets.size());

  const auto found = Snapping::cells_of_c3t3(complex);
  check_numbers(found);
  CHECK(found.cells == complex.cells);
  CHECK_EQUAL(found.interfaces.size(), interfaces.size());
  for(std::size_t i = 0; i < interfaces.size(); ++i) {
    std::set<Delaunay::Vertex_handle> vertices;
    for(const int v : found.interfaces[i])
      vertices.insert(found.vertices[std::size_t(v)]);
    CHECK(vertices == interfaces[i]);
  }
  CHECK_EQUAL(found.edges.size(), complex.cells.size());
  for(std::size_t i = 0; i < found.edges.size(); ++i)
    CHECK(found.edges[i][0] == found.tetrahedra[i][1] &&
          found.edges[i][1] == found.tetrahedra[i][3]);
  check_snap(found, seed);
}

} // namespace triangulation_checks

#endif // SEAMLESS_SNAPPING_TEST_TRIANGULATION_CHECKS_H
