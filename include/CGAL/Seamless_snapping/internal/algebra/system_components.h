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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_SYSTEM_COMPONENTS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_SYSTEM_COMPONENTS_H

#include <CGAL/license/Seamless_snapping.h>

// Divides a system into parts that share no unknown. Each is solved on a grid of its own, as fine as its
// values allow, whatever the size of the others.

#include <CGAL/Seamless_snapping/internal/algebra/Integer_system.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

template <typename Integer>
struct System_component
{
  Integer_system<Integer> system;
  std::vector<std::size_t> columns; // of the whole system, by column of the component
  std::vector<std::size_t> rows;    // likewise
};

// How often all of the numbers can be halved.
template <typename Integer>
int common_number_of_halvings(const std::vector<Integer>& numbers)
{
  std::optional<int> count;
  for(const Integer& a : numbers) {
    if(a != 0)
      count = count ? (std::min)(*count, number_of_halvings(a)) : number_of_halvings(a);
    if(count && *count == 0)
      break;
  }
  return count ? *count : 0;
}

template <typename Integer>
std::vector<System_component<Integer> > system_components(const Integer_system<Integer>& system)
{
  const std::size_t number_of_rows = system.number_of_rows();
  std::vector<int> parent(system.number_of_columns()), rank(system.number_of_columns(), 0);
  boost::disjoint_sets<int*, int*> sets(rank.data(), parent.data());
  for(std::size_t j = 0; j < system.number_of_columns(); ++j)
    sets.make_set(int(j));
  for(std::size_t i = 0; i < number_of_rows; ++i)
    for(const Entry<Integer>* e = system.begin(i); e != system.end(i); ++e)
      sets.union_set(system.begin(i)->column, e->column);

  std::vector<System_component<Integer> > components;
  std::vector<int> component_of_set(system.number_of_columns(), -1);
  std::vector<Column_index> local(system.number_of_columns(), -1);
  const auto component_of_row = [&](const std::size_t i) {
    const bool is_empty = system.begin(i) == system.end(i);
    int* known = is_empty ? nullptr : &component_of_set[std::size_t(sets.find_set(system.begin(i)->column))];
    if(known != nullptr && *known >= 0)
      return std::size_t(*known);
    components.emplace_back();
    if(known != nullptr)
      *known = int(components.size()) - 1;
    return components.size() - 1;
  };
  for(std::size_t i = 0; i < number_of_rows; ++i) {
    System_component<Integer>& component = components[component_of_row(i)];
    component.rows.push_back(i);
    for(const Entry<Integer>* e = system.begin(i); e != system.end(i); ++e)
      if(local[std::size_t(e->column)] < 0) {
        local[std::size_t(e->column)] = Column_index(component.columns.size());
        component.columns.push_back(std::size_t(e->column));
      }
  }
  std::vector<Entry<Integer> > row;
  for(System_component<Integer>& component : components) {
    component.system = Integer_system<Integer>(component.columns.size());
    std::vector<Integer> right_hand_sides;
    for(const std::size_t i : component.rows)
      right_hand_sides.push_back(system.right_hand_side(i));
    const int halvings = common_number_of_halvings(right_hand_sides);
    component.system.set_right_hand_scale(system.right_hand_scale() - halvings);
    for(std::size_t k = 0; k < component.rows.size(); ++k) {
      row.assign(system.begin(component.rows[k]), system.end(component.rows[k]));
      for(Entry<Integer>& e : row)
        e.column = local[std::size_t(e.column)];
      std::sort(row.begin(), row.end(), [](const Entry<Integer>& a, const Entry<Integer>& b)
                { return a.column < b.column; });
      component.system.add_row(row, halved(right_hand_sides[k], halvings));
    }
  }
  return components;
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ALGEBRA_SYSTEM_COMPONENTS_H
