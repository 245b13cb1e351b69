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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_CHART_JOINER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_CHART_JOINER_H

#include <CGAL/license/Seamless_snapping.h>

// Joins the charts of a volume whose producer gave each hexahedron, or each cell, its own.

#include <CGAL/Linear_snapping/internal/exact/Grid.h>
#include <CGAL/Linear_snapping/internal/support/Lists.h>
#include <CGAL/Seamless_snapping/internal/volume/Flat_volume.h>
#include <CGAL/Seamless_snapping/internal/volume/Signed_union_find.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_alignment.h>
#include <CGAL/Seamless_snapping/internal/volume/Volume_sectors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// So many more charts than components are kept as they are: the system is small, and its optimum is
// that of the charts of the input.
constexpr std::size_t largest_number_of_kept_charts = 32;

// The transitions and alignments in other charts, and these.
struct Joined_charts
{
  Volume_charts charts;
  Volume_constraints constraints; // elements, cuts, coordinates, and directions only
};

// A chart is a class of cells between which no cut runs. A spanning forest of the charts takes each
// to that of its root. The facets that it crosses are no cuts any more, and so is any other facet
// that is the last cut at a regular edge: around the edge, rotations multiply to the identity, and
// the transition leaves the edge in place, so that it is the identity in each exact map.
class Chart_joiner
{
  using Group = Cube_rotations;

public:
  Chart_joiner(const Flat_volume& volume, const Volume_constraints& constraints)
    : m_volume(volume), m_transitions(constraints.transitions),
      m_alignment(constraints.alignment), m_charts(volume.number_of_cells())
  { }

  // Returns false if there are few charts.
  bool run(Joined_charts& result)
  {
    if(m_transitions.number_of_cuts <= largest_number_of_kept_charts)
      return false;
    find_charts();
    if(span() <= largest_number_of_kept_charts)
      return false;
    join_at_edges();
    set(result.constraints.alignment);
    result.constraints.transitions.element.swap(m_element);
    result.constraints.transitions.is_cut.swap(m_is_cut);
    result.charts = std::move(m_charts);
    return true;
  }

private:
  // The cut facets at an edge, so far: their number, and the exclusive or of their places.
  struct Edge
  {
    std::int32_t number_of_cuts = 0, places = 0;
  };

  static constexpr std::int32_t unknown = -1, border = -2;

  std::size_t chart_of(const Corner_index f) const { return m_charts.chart(std::size_t(f)); }
  Corner_index facet(const std::size_t i) const { return m_volume.open_facets[i]; }
  Corner_index other(const std::size_t i) const { return m_volume.opposite[std::size_t(facet(i))]; }

  void find_charts()
  {
    m_is_cut = m_transitions.is_cut;
    m_place.assign(m_volume.opposite.size(), -1);
    for(std::size_t i = 0; i < m_is_cut.size(); ++i)
      if(m_is_cut[i] != 0)
        m_place[std::size_t(facet(i))] = m_place[std::size_t(other(i))] = std::int32_t(i);
    Signed_union_find classes(m_volume.number_of_cells());
    for(std::size_t f = 0; f < m_volume.opposite.size(); ++f)
      if(m_volume.opposite[f] > Corner_index(f) && m_place[f] < 0)
        classes.unite(f / 4, std::size_t(m_volume.opposite[f] / 4));
    const std::size_t number_of_charts = classes.number(m_charts.chart_of_cell);
    m_charts.elements.assign(number_of_charts, -1);
    m_charts.shifts.assign(number_of_charts, Uvw{});
    m_charts.roots.assign(number_of_charts, -1);
  }

  // Turns and moves charts along a spanning forest. Returns how many it reaches from others.
  std::size_t span()
  {
    const Lists<Corner_index> facets( // cut facets, by the chart of their cells
      m_charts.roots.size(), [&](const auto& add) {
        for(std::size_t i = 0; i < m_is_cut.size(); ++i)
          if(m_is_cut[i] != 0)
            for(const Corner_index f : {facet(i), other(i)})
              add(chart_of(f), f);
      });
    std::vector<std::size_t> queue;
    for(std::size_t root = 0; root < m_charts.roots.size(); ++root) {
      if(m_charts.elements[root] >= 0)
        continue;
      m_charts.elements[root] = Group::identity();
      m_charts.roots[root] = std::int32_t(root);
      std::size_t i = queue.size();
      for(queue.push_back(root); i < queue.size(); ++i)
        for(const Corner_index f : facets[queue[i]])
          if(const std::size_t chart = chart_of(m_volume.opposite[std::size_t(f)]);
             m_charts.elements[chart] < 0) {
            fit(f);
            m_tree.push_back(std::size_t(m_place[std::size_t(f)]));
            queue.push_back(chart);
          }
    }
    return m_tree.size();
  }

  // Makes the chart on the other side of a facet agree with the chart of its cell.
  void fit(const Corner_index from)
  {
    const std::size_t i = std::size_t(m_place[std::size_t(from)]);
    const std::size_t here = chart_of(from);
    const std::size_t there = chart_of(m_volume.opposite[std::size_t(from)]);
    const int g = m_transitions.element[i]; // from the side that the list names
    m_charts.elements[there] =
      Group::compose(m_charts.elements[here], facet(i) == from ? Group::inverse(g) : g);
    const Facet_sides sides = m_volume.sides(from);
    m_charts.roots[there] = m_charts.roots[here];
    Uvw& shift = m_charts.shifts[there];
    for(std::size_t k = 0; k < 3; ++k) {
      const Uvw a = Group::apply(m_charts.elements[here], sides.here[k]);
      const Uvw b = Group::apply(m_charts.elements[there], sides.there[k]);
      for(std::size_t c = 0; c < 3; ++c)
        shift[c] += (a[c] - b[c]) / 3;
    }
    for(std::size_t c = 0; c < 3; ++c)
      shift[c] += m_charts.shifts[here][c];
  }

  void join_at_edges()
  {
    for(std::size_t i = 0; i < m_is_cut.size(); ++i)
      m_element.push_back(Group::compose(
        m_charts.elements[chart_of(other(i))],
        Group::compose(m_transitions.element[i],
                       Group::inverse(m_charts.elements[chart_of(facet(i))]))));
    find_edges();
    std::vector<std::size_t> queue;
    queue.swap(m_tree);
    for(const Edge& edge : m_edges)
      push_last(edge, queue);
    for(std::size_t k = 0; k < queue.size(); ++k) {
      const std::size_t i = queue[k];
      if(m_is_cut[i] == 0)
        continue;
      m_is_cut[i] = 0;
      for(std::size_t j = 0; j < 3; ++j)
        if(m_edge[3 * i + j] >= 0) {
          Edge& edge = m_edges[std::size_t(m_edge[3 * i + j])];
          --edge.number_of_cuts;
          edge.places ^= std::int32_t(i);
          push_last(edge, queue);
        }
    }
  }

  void push_last(const Edge& edge, std::vector<std::size_t>& queue) const
  {
    if(edge.number_of_cuts == 1 && m_element[std::size_t(edge.places)] == Group::identity())
      queue.push_back(std::size_t(edge.places));
  }

  // Finds the edges of cut facets, with all facets around.
  void find_edges()
  {
    m_edge.assign(3 * m_is_cut.size(), unknown);
    for(std::size_t i = 0; i < m_is_cut.size(); ++i)
      for(std::size_t j = 0; m_is_cut[i] != 0 && j < 3; ++j) {
        if(m_edge[3 * i + j] != unknown)
          continue;
        const Corner_index third = corners_of_facet(facet(i))[j];
        Edge edge;
        const std::int32_t name = std::int32_t(m_edges.size());
        if(walk(facet(i), third, name, edge)) {
          m_edges.push_back(edge);
        } else { // names all that it has met, and all on the other side
          walk(facet(i), third, border, edge);
          walk(other(i), m_volume.across(facet(i), third), border, edge);
          m_edge[3 * i + j] = border;
        }
      }
  }

  // Names the edge for all cut facets around it, to the border at most. Returns whether there is
  // none.
  bool walk(const Corner_index start, const Corner_index third, const std::int32_t name, Edge& edge)
  {
    Facet_ring ring(m_volume, start, third);
    for(;;) {
      ring.turn();
      const std::int32_t i = m_place[std::size_t(ring.facet())];
      if(i >= 0) {
        m_edge[3 * std::size_t(i) + position(std::size_t(i), ring.third())] = name;
        ++edge.number_of_cuts;
        edge.places ^= i;
      }
      if(ring.is_closed())
        return true;
      if(!ring.can_cross())
        return false;
      ring.cross();
    }
  }

  // Which corner of the facet, as the list names it, is at the vertex of another one.
  std::size_t position(const std::size_t i, const Corner_index corner) const
  {
    const auto corners = corners_of_facet(facet(i));
    std::size_t result = 0;
    while(m_volume.vertex(corners[result]) != m_volume.vertex(corner))
      ++result;
    return result;
  }

  void set(Volume_alignment& result) const
  {
    const auto moved = [&](const Corner_index corner, const int k) {
      const int g = m_charts.elements[chart_of(corner)];
      return int(Group::source(Group::inverse(g), std::size_t(k)));
    };
    for(std::size_t i = 0; i < m_alignment.coordinate.size(); ++i)
      result.coordinate.push_back(moved(m_volume.aligned_facets[i], m_alignment.coordinate[i]));
    for(std::size_t i = 0; i < m_alignment.direction.size(); ++i)
      result.direction.push_back(moved(m_volume.aligned_edges[i].a, m_alignment.direction[i]));
  }

  const Flat_volume& m_volume;
  const Volume_transitions& m_transitions;
  const Volume_alignment& m_alignment;
  std::vector<std::int32_t> m_place;   // per facet: the place of its cut among the open ones, or -1
  Volume_charts m_charts;              // elements are -1 while they are not reached
  std::vector<std::size_t> m_tree;     // the facets that the forest crosses
  std::vector<int> m_element;          // per open facet, between the new charts
  std::vector<char> m_is_cut;          // per open facet
  std::vector<std::int32_t> m_edge;    // 3 per open facet: the edge opposite to its corner
  std::vector<Edge> m_edges;
};

// The places of charts that are joined: such that the corners of sectors meet as well as they can.

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

  // To numbers such that coordinates of the input are exact if the coordinates of the system are.
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
      // one bit more, because the solution may need a grid that is coarser
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

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_VOLUME_CHART_JOINER_H
