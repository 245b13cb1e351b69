// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUADS_NEEDED_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUADS_NEEDED_H

#include <CGAL/license/Quad_remeshing.h>

// How many quads a connected part of a map takes at least, whatever the integers are.

#include <CGAL/Linear_snapping/internal/support/Refusal.h>
#include <CGAL/Quad_remeshing/internal/quantization/Intrinsic_complex.h>
#include <CGAL/Quad_remeshing/types/Quantization.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

constexpr std::size_t quads_of_handle = 9; // about as many as a torus takes
constexpr double about_as_many = 1.1; // times as many quads as wanted, at most

struct Quads_needed
{
  std::size_t cones = 0, border_corners = 0; // irregular vertices inside, and on the border
  std::size_t handles = 0;                   // of closed parts
  std::size_t by_cones = 0;                  // quads, exactly

  // The quads that handles take, too, in a mesh in which no two vertices have two edges.
  std::size_t by_topology() const { return (std::max)(by_cones, quads_of_handle * handles); }

  Quads_needed& operator+=(const Quads_needed& other)
  {
    cones += other.cones;
    border_corners += other.border_corners;
    handles += other.handles;
    by_cones += other.by_cones;
    return *this;
  }

  // Nothing if there is room for about twice as many quads as are needed, or if nothing needs any.
  std::string in_words(const double number_wanted) const
  {
    if(2 * double(by_topology()) <= number_wanted)
      return "";
    std::string result;
    const auto add = [&](const std::string& words)
      { result += (result.empty() ? "; " : " and ") + words; };
    if(cones > 0)
      add(counted(cones, "cone"));
    if(border_corners > 0)
      add(counted(border_corners, "corner") + " of the border");
    if(!result.empty())
      result += (cones + border_corners == 1 ? " takes" : " take") + std::string(" at least ") +
                counted(by_cones, "quad");
    if(handles > 0)
      add(counted(handles, "handle") + (handles == 1 ? " takes" : " take") + " about " +
          counted(quads_of_handle * handles, "quad"));
    return result;
  }
};

// Irregular vertices of the map are vertices of the quads. With I vertices inside, B on the border,
// and the Euler characteristic X, there are I + B / 2 - X quads: each has four sides, of which two
// are one edge inside.
inline Quads_needed quads_needed(const Intrinsic_complex& part)
{
  Quads_needed result;
  for(std::size_t v = 0; v < part.number_of_vertices(); ++v)
    if(!part.is_regular[v])
      ++(part.is_border[v] ? result.border_corners : result.cones);
  std::ptrdiff_t border_edges = 0;
  for(Corner_index h = 0; h < part.number_of_halfedges(); ++h)
    border_edges += part.corner(h).opposite == no_index ? 1 : 0;
  const auto faces = std::ptrdiff_t(part.number_of_faces());
  const std::ptrdiff_t characteristic =
    std::ptrdiff_t(part.number_of_vertices()) - (3 * faces + border_edges) / 2 + faces;
  if(border_edges == 0)
    result.handles = std::size_t((2 - characteristic) / 2);
  const std::ptrdiff_t least = std::ptrdiff_t(result.cones) +
                               std::ptrdiff_t(result.border_corners + 1) / 2 - characteristic;
  result.by_cones = std::size_t((std::max)(std::ptrdiff_t(1), least));
  return result;
}

inline bool has_too_many_quads(const Part_of_other_size& part)
{
  return double(part.number_of_quads) >
         2 * (std::max)(part.number_wanted, double(part.number_needed));
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_QUADS_NEEDED_H
