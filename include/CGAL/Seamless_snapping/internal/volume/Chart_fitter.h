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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_CHART_FITTER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_CHART_FITTER_H

#include <CGAL/license/Seamless_snapping.h>

// Where charts that are joined lie: such that the corners of sectors meet as well as they can.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Seamless_snapping/internal/volume/Flat_volume.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_sectors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Steps of conjugate gradients. Along the forest, inaccuracies add up; it is where its branches
// meet that corners are far apart. Few steps spread that over many charts: until none asks for a
// move of more than this part of the inaccuracy of the input.
constexpr int largest_number_of_chart_fitting_steps = 500;
constexpr double chart_fitting_precision = 0.02;

// Minimizes the sum of the squared distances of corners from the means of their sectors, each
// coordinate for itself.
class Chart_fitter
{
public:
  Chart_fitter(const Flat_volume& volume, const Volume_sectors& sectors, Volume_charts& charts)
    : m_volume(volume), m_sectors(sectors), m_charts(charts)
  { }

  // \param violation of the input
  void run(const double violation, const Number_format& format)
  {
    fit(chart_fitting_precision * violation);
    round(format);
  }

private:
  void fit(const double precision)
  {
    const std::size_t size = m_charts.shifts.size();
    std::vector<Uvw> r(size), z(size), p(size), q(size);
    m_weight.assign(size, 0);
    for_each_deviation(
      [&](const std::size_t i, const std::size_t c) {
        return m_charts.coordinate(m_volume.coordinates[i], i, c);
      },
      [&](const std::size_t i, const std::size_t c, const double x, const std::size_t n) {
        r[m_charts.chart(i)][c] -= x;
        m_weight[m_charts.chart(i)] += (1 - 1 / static_cast<double>(n)) / 3;
      });
    const double unit = largest(r); // keeps squares in range
    if(unit == 0)
      return;
    for(Uvw& x : r)
      for(double& y : x)
        y /= unit;
    Uvw rho = precondition(r, z);
    p = z;
    for(int step = 0; step < largest_number_of_chart_fitting_steps &&
                      unit * largest(z) > precision; ++step) {
      std::fill(q.begin(), q.end(), Uvw{});
      for_each_deviation(
        [&](const std::size_t i, const std::size_t c) { return p[m_charts.chart(i)][c]; },
        [&](const std::size_t i, const std::size_t c, const double x, std::size_t) {
          q[m_charts.chart(i)][c] += x;
        });
      const Uvw pq = products(p, q);
      Uvw length{}, former = rho;
      for(std::size_t c = 0; c < 3; ++c)
        length[c] = pq[c] > 0 ? rho[c] / pq[c] : 0;
      for(std::size_t k = 0; k < size; ++k)
        for(std::size_t c = 0; c < 3; ++c) {
          m_charts.shifts[k][c] += unit * (length[c] * p[k][c]);
          r[k][c] -= length[c] * q[k][c];
        }
      rho = precondition(r, z);
      for(std::size_t k = 0; k < size; ++k)
        for(std::size_t c = 0; c < 3; ++c)
          p[k][c] = z[k][c] + (former[c] > 0 ? rho[c] / former[c] : 0) * p[k][c];
    }
  }

  // To numbers such that coordinates of the input are exact where those of the system are.
  void round(const Number_format& format)
  {
    std::vector<double> largest(m_charts.shifts.size(), 0); // per root
    for(const Corner_index i : m_sectors.corners.elements())
      for(std::size_t c = 0; c < 3; ++c) {
        double& x = largest[m_charts.root(i)];
        x = (std::max)({x, std::abs(m_volume.uvw(i)[c]),
                        std::abs(m_charts.coordinate(m_volume.uvw(i), std::size_t(i), c))});
      }
    for(std::size_t k = 0; k < m_charts.shifts.size(); ++k) {
      // one bit more, as the solution may need a grid that is coarser
      const double size = largest[std::size_t(m_charts.roots[k])];
      const Grid grid(format, Grid::finest(format, size).exponent() + 1);
      for(double& x : m_charts.shifts[k]) {
        const Grid_value v = grid.split(x);
        x = grid.value(v.base + nearest_integer(v.offset));
      }
    }
  }

  // Calls f(i, c, x, n) for coordinate c of corner i, one of n of a sector; x is by how much that
  // of `values` differs from their mean.
  template <typename Values, typename F>
  void for_each_deviation(const Values& values, const F& f) const
  {
    for(std::size_t s = 0; s < m_sectors.corners.size(); ++s) {
      const auto corners = m_sectors.corners[s];
      for(std::size_t c = 0; corners.size() > 1 && c < 3; ++c) {
        const double first = values(std::size_t(corners.front()), c);
        double sum = 0;
        for(const Corner_index i : corners)
          sum += values(std::size_t(i), c) - first;
        const double mean = sum / static_cast<double>(corners.size());
        for(const Corner_index i : corners)
          f(std::size_t(i), c, values(std::size_t(i), c) - first - mean, corners.size());
      }
    }
  }

  // z = r / weights; returns the products of the two.
  Uvw precondition(const std::vector<Uvw>& r, std::vector<Uvw>& z) const
  {
    for(std::size_t k = 0; k < r.size(); ++k)
      for(std::size_t c = 0; c < 3; ++c)
        z[k][c] = m_weight[k] > 0 ? r[k][c] / m_weight[k] : 0;
    return products(r, z);
  }

  static double largest(const std::vector<Uvw>& a)
  {
    double result = 0;
    for(const Uvw& x : a)
      for(const double y : x)
        result = (std::max)(result, std::abs(y));
    return result;
  }

  static Uvw products(const std::vector<Uvw>& a, const std::vector<Uvw>& b)
  {
    Uvw result{};
    for(std::size_t k = 0; k < a.size(); ++k)
      for(std::size_t c = 0; c < 3; ++c)
        result[c] += a[k][c] * b[k][c];
    return result;
  }

  const Flat_volume& m_volume;
  const Volume_sectors& m_sectors;
  Volume_charts& m_charts;
  std::vector<double> m_weight; // per chart
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_CHART_FITTER_H
