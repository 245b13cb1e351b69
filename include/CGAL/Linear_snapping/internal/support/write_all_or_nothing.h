// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Linear_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_WRITE_ALL_OR_NOTHING_H
#define CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_WRITE_ALL_OR_NOTHING_H

#include <CGAL/license/Linear_snapping.h>

// Writes exact coordinates to a map of the caller, all or nothing. If the map throws, or does not
// keep new values, which would void the verification, the old values are written back.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Linear_snapping {
namespace internal {

// The number type of the points in a map.
template <typename PointMap>
struct Map_number
{
  using Point = typename boost::property_traits<PointMap>::value_type;
  using type = std::decay_t<decltype(std::declval<const Point&>().x())>;
  static_assert(std::is_same<type, double>::value || std::is_same<type, float>::value,
                "the coordinates in the map must be of type float or double");
};

template <typename Corner, typename Coordinates>
struct Corner_change
{
  Corner corner;
  Coordinates before, after;
};

// Returns a refusal if the map does not keep what is written to it.
// \param change(i) a `Corner_change`, for i from 0 to n - 1
// \param get(corner) the coordinates in the map
// \param put(change, coordinates) writes them to the map
template <typename Change, typename Get, typename Put>
std::optional<Refusal> write_all_or_nothing(const std::size_t n, const Change& change,
                                            const Get& get, const Put& put)
{
  std::size_t end = 0; // behind the last value that was written, perhaps in part
  const auto take_back = [&] { // the last first, as corners may share a place
    for(; end > 0; --end)
      put(change(end - 1), change(end - 1).before);
  };
  bool is_kept = true;
  try {
    while(end < n) {
      ++end;
      put(change(end - 1), change(end - 1).after);
    }
    for(std::size_t i = 0; i < n; ++i) // after all is written, as corners may share a place
      is_kept = is_kept && get(change(i).corner) == change(i).after;
  } catch(...) { // by the map
    take_back();
    throw;
  }
  if(is_kept)
    return std::nullopt;
  take_back();
  return Refusal(Outcome::INTERNAL_ERROR,
                 "the map does not keep new values, and its old values were written back; each "
                 "corner needs its own place in memory, with the precision of the points' number "
                 "type");
}

} // namespace internal
} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_INTERNAL_SUPPORT_WRITE_ALL_OR_NOTHING_H
