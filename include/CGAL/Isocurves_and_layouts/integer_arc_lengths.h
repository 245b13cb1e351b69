// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Isocurves_and_layouts package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTEGER_ARC_LENGTHS_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTEGER_ARC_LENGTHS_H

#include <CGAL/license/Isocurves_and_layouts.h>

// Lengths of arcs as integers: what quantizations of layouts start from, and what they must keep.

#include <CGAL/Isocurves_and_layouts/Motorcycle_graph.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {

namespace internal {

template <typename TriangleMesh>
bool bounds_rectangle(const Motorcycle_graph<TriangleMesh>& graph, const std::size_t arc)
{
  for(const std::size_t h : {2 * arc, 2 * arc + 1})
    if(graph.patch(h) != graph.null_patch && !graph.patch_is_cut(graph.patch(h)))
      return true;
  return false;
}

} // namespace internal

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

The lengths of the arcs of a layout, as integers.
*/
struct Integer_arc_lengths
{
  std::vector<Exact_integer> lengths; ///< per arc, in multiples of the unit; 0 if it bounds no
                                      ///< rectangle
  Exact_rational unit{1};             ///< a power of two
};

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

returns the lengths of all arcs that bound rectangles, in multiples of a unit: the largest power of
two of which all of them are integer multiples. There always is one, since the coordinates of their
ends are dyadic numbers. (Arcs between patches that are cut can have any length.) These lengths
solve what a quantization of the layout has to solve, at a scale that is far too fine; see
`are_lengths_consistent()`.

\pre `bool(graph)`

\par Complexity
Linear in the number of arcs, times the bits of their lengths.
*/
template <typename TriangleMesh>
Integer_arc_lengths integer_arc_lengths(const Motorcycle_graph<TriangleMesh>& graph)
{
  using Fraction_traits = CGAL::Fraction_traits<Exact_rational>;
  typename Fraction_traits::Numerator_type numerator;
  typename Fraction_traits::Denominator_type denominator;
  Integer_arc_lengths result;
  bool is_first = true;
  // The unit is the least power of two that any length is an odd multiple of.
  for(std::size_t a = 0; a < graph.number_of_arcs(); ++a) {
    if(!internal::bounds_rectangle(graph, a))
      continue;
    typename Fraction_traits::Decompose()(graph.arc_length(a), numerator, denominator);
    Exact_rational unit(Exact_rational(1) / Exact_rational(denominator));
    for(; Exact_integer(numerator % 2) == 0; numerator = Exact_integer(numerator / 2))
      unit = Exact_rational(unit * 2);
    if(is_first || unit < result.unit)
      result.unit = unit;
    is_first = false;
  }
  result.lengths.assign(graph.number_of_arcs(), Exact_integer(0));
  for(std::size_t a = 0; a < graph.number_of_arcs(); ++a)
    if(internal::bounds_rectangle(graph, a)) {
      typename Fraction_traits::Decompose()(Exact_rational(graph.arc_length(a) / result.unit),
                                            numerator, denominator);
      result.lengths[a] = numerator;
    }
  return result;
}

/*!
\ingroup PkgIsocurvesAndLayoutsLayouts

returns whether other lengths of the arcs also make rectangles of all patches that are rectangles:
whether opposite sides have the same length. With positive integers, each of these can then be
filled by a grid of quads that fits those of its neighbors. The number of all quads is the sum of
the products of width and height.

\tparam Length a number type with exact sums
\param graph the layout
\param lengths one length per arc

\pre `bool(graph)`, and `lengths.size() == graph.number_of_arcs()`

\par Complexity
Linear in the number of arcs.
*/
template <typename TriangleMesh, typename Length>
bool are_lengths_consistent(const Motorcycle_graph<TriangleMesh>& graph,
                            const std::vector<Length>& lengths)
{
  const auto length_of_side = [&](const std::size_t p, const std::size_t side) {
    Length sum(0);
    for(const std::size_t h : graph.patch_side(p, side))
      sum += lengths[graph.arc(h)];
    return sum;
  };
  for(std::size_t p = 0; p < graph.number_of_patches(); ++p)
    if(length_of_side(p, 0) != length_of_side(p, 2) || length_of_side(p, 1) != length_of_side(p, 3))
      return false;
  return true;
}

} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTEGER_ARC_LENGTHS_H
