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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_SUPPORT_PREFETCH_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_SUPPORT_PREFETCH_H

#include <CGAL/license/Seamless_snapping.h>

// Asks for memory ahead of its use. On large meshes, loops over the corners wait for little else.

#include <boost/property_map/property_map.hpp>

#include <type_traits>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

inline void prefetch_address(const void* address)
{
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

// The value of a key in a property map, if the map refers to memory.
template <typename PropertyMap, typename Key>
void prefetch(const PropertyMap& map, const Key& key)
{
  if constexpr(std::is_lvalue_reference<decltype(get(map, key))>::value)
    prefetch_address(&get(map, key));
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_SUPPORT_PREFETCH_H
