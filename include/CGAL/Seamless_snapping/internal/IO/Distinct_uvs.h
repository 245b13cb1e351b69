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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_DISTINCT_UVS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_DISTINCT_UVS_H

#include <CGAL/license/Seamless_snapping.h>

// Coordinates of corners that share a place, for writing: equal ones are held once.

#include <array>
#include <cstddef>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Coordinates under keys from 0 to n - 1. Equal coordinates under one key are held once.
class Distinct_uvs
{
public:
  using UV = std::array<double, 2>;

  explicit Distinct_uvs(std::size_t number_of_keys)
    : m_first(number_of_keys, none)
  { }

  // Returns the index of the coordinates `uv` under `key`; for new coordinates, it is the number of
  // coordinates so far.
  std::size_t insert(std::size_t key, const UV& uv)
  {
    std::size_t i = m_first[key];
    while(i != none && std::memcmp(&m_uvs[i], &uv, sizeof(UV)) != 0) // tells 0 from -0
      i = m_next[i];
    if(i == none) {
      i = m_uvs.size();
      m_uvs.push_back(uv);
      m_next.push_back(m_first[key]);
      m_first[key] = i;
    }
    return i;
  }

  const std::vector<UV>& uvs() const { return m_uvs; }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::vector<UV> m_uvs;
  std::vector<std::size_t> m_first; // per key, the last that was inserted
  std::vector<std::size_t> m_next;  // per element, the one under the same key inserted before it
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_DISTINCT_UVS_H
