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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_UNTANGLING_UNTANGLE_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_UNTANGLING_UNTANGLE_H

#include <CGAL/license/Seamless_snapping.h>

// Makes triangles positive by changing what is around them, as far around as it takes.

#include <CGAL/Seamless_snapping/internal/untangling/Constrained_triangles.h>
#include <CGAL/Seamless_snapping/internal/untangling/Distortion.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The choices if changes nearby would give vertices wrong angles.
enum class Untangling
{
  CLOSE_BY,      // nothing, nor what many triangles depend on
  NEAR_BY,       // the angles
  NEAR_BY_FIRST, // the angles, and large parts of the map where flips remain
  ANGLES_FIRST   // large parts of the map
};

// Invariant: the unknowns have the values of the fewest triangles that are not positive.
template <typename FT>
class Untangler
{
  // How far around, which unknowns may change, for how long, and whether vertices may get other
  // angles. Unknowns that many triangles depend on, as the translations of cuts are, make large
  // patches of small ones.
  struct Attempt
  {
    std::size_t rings, most_triangles_of_unknown, iterations; // successful ones take 10 to 40
    bool may_change_angles;
  };

public:
  explicit Untangler(const Constrained_triangles& map)
    : m_map(map), m_unknowns(map.number_of_unknowns, 0.),
      m_number_of(map.number_of_unknowns, -1), m_triangles_of(map.number_of_unknowns),
      m_angles(map.angle.size())
  {
    std::vector<std::size_t> all(map.triangles.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    add_angles(all, 1);
    for(std::size_t t = 0; t < map.triangles.size(); ++t)
      for_each_unknown(t, [&](const std::size_t i) {
        if(map.triangles[t].can_have_area &&
           (m_triangles_of[i].empty() || m_triangles_of[i].back() != t))
          m_triangles_of[i].push_back(t);
      });
  }

  // Returns the number of iterations, over as many triangles as there are, that would have cost as
  // much. A search that has begun is allowed 1e6 iterations over a triangle in any case.
  double run(const double largest_number_of_iterations, const Untangling how)
  {
    const std::size_t any = has_long_rows() ? 150 : static_cast<std::size_t>(-1);
    std::vector<Attempt> attempts{{4, 40, 30, false}};
    if(how != Untangling::CLOSE_BY)
      attempts.push_back({6, any, 40, how == Untangling::NEAR_BY});
    if(how == Untangling::NEAR_BY_FIRST)
      attempts.push_back({6, any, 40, true});
    if(how == Untangling::NEAR_BY_FIRST || how == Untangling::ANGLES_FIRST)
      attempts.push_back({40, any, 100, true});
    const double all = static_cast<double>(m_map.triangles.size());
    const double allowed = all * largest_number_of_iterations;
    double work = 0;
    for(const Attempt& attempt : attempts)
      for(const std::vector<std::size_t>& patch : patches(m_map.not_positive(m_unknowns), attempt))
        if(work < allowed)
          work += improve(patch, attempt, (std::max)(allowed - work, 1e6));
    return work / all;
  }

  const std::vector<FT>& unknowns() const { return m_unknowns; }

private:
  template <typename Function>
  void for_each_unknown(const std::size_t t, const Function& f) const
  {
    for(const std::size_t p : m_map.triangles[t].points)
      for(const Sparse_row& row : m_map.rows[p])
        for(const auto& entry : row)
          f(entry.first);
  }

  // Whether triangles depend on so many unknowns, as on the translations of cuts around hundreds of
  // handles, that a patch with all of these would take long: as dense as it is large.
  bool has_long_rows() const
  {
    constexpr std::size_t many = 30; // per triangle; without translations, there are six
    std::size_t sum = 0;
    for(const std::vector<std::size_t>& triangles : m_triangles_of)
      sum += triangles.size();
    return sum > many * m_map.triangles.size();
  }

  // The unknowns of the triangles and of the triangles around, in sets without a common triangle.
  std::vector<std::vector<std::size_t> > patches(const std::vector<std::size_t>& bad,
                                                 const Attempt& attempt) const
  {
    std::vector<char> is_chosen(m_unknowns.size(), false), is_near(m_map.triangles.size(), false);
    std::vector<std::size_t> front(bad), chosen;
    for(const std::size_t t : bad)
      is_near[t] = true;
    for(std::size_t r = 0; r < attempt.rings && !front.empty(); ++r) {
      std::vector<std::size_t> next;
      for(const std::size_t t : front)
        for_each_unknown(t, [&](const std::size_t i) {
          if(is_chosen[i] || m_triangles_of[i].size() > attempt.most_triangles_of_unknown)
            return;
          is_chosen[i] = true;
          chosen.push_back(i);
          for(const std::size_t u : m_triangles_of[i])
            if(!is_near[u]) {
              is_near[u] = true;
              next.push_back(u);
            }
        });
      front.swap(next);
    }
    return connected_parts(chosen, is_chosen);
  }

  std::vector<std::vector<std::size_t> > connected_parts(const std::vector<std::size_t>& chosen,
                                                         std::vector<char>& is_left) const
  {
    std::vector<std::vector<std::size_t> > result;
    for(const std::size_t seed : chosen) {
      if(!is_left[seed])
        continue;
      is_left[seed] = false;
      std::vector<std::size_t> part(1, seed);
      for(std::size_t k = 0; k < part.size(); ++k)
        for(const std::size_t t : m_triangles_of[part[k]])
          for_each_unknown(t, [&](const std::size_t i) {
            if(is_left[i]) {
              is_left[i] = false;
              part.push_back(i);
            }
          });
      result.push_back(std::move(part));
    }
    return result;
  }

  // Adds the angles of triangles, or takes them away.
  void add_angles(const std::vector<std::size_t>& triangles, const int sign)
  {
    for(const std::size_t t : triangles) {
      const Uv_triangle u = m_map.triangle(t, m_unknowns);
      for(std::size_t k = 0; k < 3; ++k)
        m_angles[m_map.vertex[m_map.triangles[t].points[k]]].add(u, k, sign);
    }
  }

  // The number of corners at vertices that have no fold, but other angles than they are to have.
  std::size_t number_of_wrong_angles(const std::vector<std::size_t>& triangles) const
  {
    std::size_t result = 0;
    for(const std::size_t t : triangles)
      for(const std::size_t p : m_map.triangles[t].points)
        result += m_angles[m_map.vertex[p]].is_wrong(m_map.angle[m_map.vertex[p]]) ? 1 : 0;
    return result;
  }

  // The numbers of triangles that are not positive, and of wrong angles.
  using Faults = std::pair<std::size_t, std::size_t>;

  Faults faults(const std::vector<std::size_t>& triangles) const
  {
    const auto bad = std::count_if(triangles.begin(), triangles.end(), [&](const std::size_t t) {
      return orientation(m_map.triangle(t, m_unknowns)) != CGAL::POSITIVE;
    });
    return {std::size_t(bad), number_of_wrong_angles(triangles)};
  }

  // \param values of the patch's unknowns
  void move(const std::vector<std::size_t>& patch, const std::vector<std::size_t>& triangles,
            const std::vector<FT>& values)
  {
    add_angles(triangles, -1);
    for(std::size_t k = 0; k < patch.size(); ++k)
      m_unknowns[patch[k]] = values[k];
    add_angles(triangles, 1);
  }

  std::vector<std::size_t> triangles_of(const std::vector<std::size_t>& patch) const
  {
    std::vector<std::size_t> result;
    for(const std::size_t i : patch)
      result.insert(result.end(), m_triangles_of[i].begin(), m_triangles_of[i].end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Values of a patch: first the values with the fewest faults, then the values that change least.
  struct Candidate
  {
    std::pair<Faults, FT> cost;
    std::vector<FT> values;

    void improve(const Candidate& other)
    {
      if(other.cost < cost)
        *this = other;
    }
  };

  // Returns what it cost, in iterations over a triangle.
  // \param allowed for each start
  double improve(const std::vector<std::size_t>& patch, const Attempt& attempt,
                 const double allowed)
  {
    const std::vector<std::size_t> triangles = triangles_of(patch);
    if(attempt.may_change_angles)
      for(const Found& found : m_found)
        if(found.iterations == attempt.iterations && found.patch == patch) {
          move(patch, triangles, found.values);
          return 0;
        }
    Candidate start{{faults(triangles), 0}, {}};
    for(std::size_t k = 0; k < patch.size(); ++k) {
      m_number_of[patch[k]] = int(k);
      start.values.push_back(m_unknowns[patch[k]]);
    }
    Candidate best = start, best_with_any_angles = start, next = start;
    double cost = 0;
    for(const FT regularization : regularizations) {
      Distortion_minimizer<FT> minimizer(m_map, triangles, m_number_of, patch.size(), m_unknowns);
      const double of_iteration = minimizer.cost_of_iteration();
      const double iterations = (std::min)(double(attempt.iterations), allowed / of_iteration);
      cost += minimizer.cost_of_start() +
              of_iteration * double(minimizer.run(std::size_t(iterations), regularization));
      for(std::size_t k = 0; k < patch.size(); ++k)
        next.values[k] = start.values[k] + minimizer.change()[Eigen::Index(k)];
      move(patch, triangles, next.values);
      const Faults after = faults(triangles);
      next.cost = {after, minimizer.change().cwiseAbs().maxCoeff()};
      best_with_any_angles.improve(next);
      if(attempt.may_change_angles || after.second <= start.cost.first.second)
        best.improve(next);
      if(after.first > 0 || after.second == 0)
        break; // another start is for other angles
      move(patch, triangles, start.values);
    }
    move(patch, triangles, best.values);
    if(!attempt.may_change_angles && best.values == start.values)
      m_found.push_back({attempt.iterations, patch, best_with_any_angles.values});
    for(const std::size_t i : patch)
      m_number_of[i] = -1;
    return cost;
  }

  // To start with. From 1 on, triangles can collapse; but what comes out mostly changes less.
  static constexpr std::array<FT, 2> regularizations{{0.45, 1}};

  // The result for a patch that had to keep its angles, and so stayed as it was. If the next
  // attempt may change angles, it need not search again.
  struct Found
  {
    std::size_t iterations;
    std::vector<std::size_t> patch;
    std::vector<FT> values;
  };

  const Constrained_triangles& m_map;
  std::vector<Found> m_found;
  std::vector<FT> m_unknowns;
  std::vector<int> m_number_of; // per unknown: its number in the patch, or -1
  std::vector<std::vector<std::size_t> > m_triangles_of; // per unknown
  std::vector<Angle_sum> m_angles; // per vertex
};

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
extern template class Distortion_minimizer<double>;
extern template class Untangler<double>;
#endif

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_UNTANGLING_UNTANGLE_H
