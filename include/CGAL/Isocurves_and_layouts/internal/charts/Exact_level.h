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

#ifndef CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_EXACT_LEVEL_H
#define CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_EXACT_LEVEL_H

#include <CGAL/license/Isocurves_and_layouts.h>

// The constant component of an isocurve, exactly. It starts as a component of a corner, and every
// cut adds a translation. As long as all these lie on the grid, it stays a single `double`;
// coordinates that no constraint concerns lie on no grid, so that it may take two of them; a point
// anywhere on an edge needs a rational number.

#include <CGAL/Isocurves_and_layouts/internal/charts/axis_directions.h>
#include <CGAL/Linear_snapping/internal/exact/Exact_difference.h>

#include <CGAL/Exact_rational.h>

#include <memory>
#include <utility>

namespace CGAL {
namespace Isocurves_and_layouts {
namespace internal {

inline Exact_rational exact_value(const double x) { return Exact_rational(x); }
inline Exact_rational exact_value(const Exact_difference& x)
{
  return Exact_rational(Exact_rational(x.rounded) + Exact_rational(x.error));
}

// The value is m_nearest + m_rest, where m_nearest is the `double` nearest to it; unless it needs
// more than two of them: then it is *m_rational. Needs rounding to nearest.
class Exact_level
{
public:
  Exact_level() = default;
  explicit Exact_level(const double value) : m_nearest(value) { }
  explicit Exact_level(const Exact_difference& value)
    : m_nearest(value.rounded), m_rest(value.error)
  { }
  explicit Exact_level(const Exact_rational& value) { set(value); }

  // The sign of `coordinate` less the level. Where `coordinate` differs from the nearest number,
  // the rest can't change the order.
  int side_of(const double coordinate) const
  {
    if(m_rational != nullptr)
      return side_of_rational(coordinate);
    const int side = compare(coordinate, m_nearest);
    return side != 0 ? side : compare(0, m_rest);
  }

  // The side of a component that may need two numbers.
  int side_of(const Exact_difference& component) const
  {
    if(m_rational != nullptr)
      return side_of_rational(component);
    const int side = compare(component.rounded, m_nearest);
    return side != 0 ? side : compare(component.error, m_rest);
  }

  // Becomes sign * level + translation.
  void transform(const int sign, const Exact_difference& translation)
  {
    if(m_rational != nullptr)
      return set(Exact_rational(Exact_rational(sign) * *m_rational + exact_value(translation)));
    if(sign < 0) {
      m_nearest = -m_nearest;
      m_rest = -m_rest;
    }
    const Exact_difference sum(m_nearest, -translation.rounded);
    if(m_rest == 0 && translation.error == 0) {
      m_nearest = sum.rounded;
      m_rest = sum.error;
    } else {
      add_small_parts(sum, translation);
    }
  }

  void transform(const int sign, const Exact_level& translation)
  {
    if(translation.m_rational == nullptr)
      transform(sign, Exact_difference(translation.m_nearest, -translation.m_rest));
    else
      set(Exact_rational(Exact_rational(sign) * exact() + *translation.m_rational));
  }

  double approximation() const { return m_nearest; }

  // Whether the approximation is the value.
  bool is_double() const { return m_rational == nullptr && m_rest == 0; }

  // 2^1023 is not exceeded.
  Exact_level doubled() const
  {
    if(m_rational != nullptr)
      return Exact_level(Exact_rational(2 * *m_rational));
    Exact_level result(2 * m_nearest);
    result.m_rest = 2 * m_rest;
    return result;
  }

  Exact_level minus(const Exact_level& other) const
  {
    if(is_double() && other.is_double())
      return Exact_level(Exact_difference(m_nearest, other.m_nearest));
    return Exact_level(Exact_rational(exact() - other.exact()));
  }

  Exact_level negated() const { return Exact_level().minus(*this); }

  Exact_rational exact() const
  {
    if(m_rational != nullptr)
      return *m_rational;
    return Exact_rational(Exact_rational(m_nearest) + Exact_rational(m_rest));
  }

  // The sign of a - b. Rounding to the nearest number does not change the order.
  friend int compare(const Exact_level& a, const Exact_level& b)
  {
    if(a.m_rational != nullptr || b.m_rational != nullptr)
      return static_cast<int>(CGAL::compare(a.exact(), b.exact()));
    const int nearest = compare(a.m_nearest, b.m_nearest);
    return nearest != 0 ? nearest : compare(a.m_rest, b.m_rest);
  }

  friend bool operator==(const Exact_level& a, const Exact_level& b)
  {
    if(a.m_rational == nullptr && b.m_rational == nullptr)
      return a.m_nearest == b.m_nearest && a.m_rest == b.m_rest;
    return a.exact() == b.exact();
  }

  friend double nearest_double(const Exact_level& level) { return level.m_nearest; }

private:
  // The rest of the sum of four numbers after the sum of the two large numbers.
  void add_small_parts(const Exact_difference& sum, const Exact_difference& translation)
  {
    const Exact_difference rests(m_rest, -translation.error);
    const Exact_difference small_parts(sum.error, -rests.rounded);
    if(rests.error == 0 && small_parts.error == 0) {
      const Exact_difference total(sum.rounded, -small_parts.rounded);
      m_nearest = total.rounded;
      m_rest = total.error;
    } else {
      set(Exact_rational(exact() + exact_value(translation)));
    }
  }

  void set(const Exact_rational& value)
  {
    const double first = CGAL::to_double(value);
    const Exact_rational remainder(value - Exact_rational(first));
    const double second = CGAL::to_double(remainder);
    const bool fits = (remainder == Exact_rational(second));
    const Exact_difference total(first, -second);
    m_nearest = total.rounded;
    m_rest = fits ? total.error : 0;
    m_rational = fits ? nullptr : std::make_shared<const Exact_rational>(value);
  }

  template <typename Component>
  int side_of_rational(const Component& component) const
  {
    const std::pair<double, double> interval = CGAL::to_interval(*m_rational);
    if(nearest_double(component) < interval.first)
      return -1;
    if(nearest_double(component) > interval.second)
      return 1;
    return static_cast<int>(CGAL::compare(exact_value(component), *m_rational));
  }

  double m_nearest = 0;
  double m_rest = 0;
  std::shared_ptr<const Exact_rational> m_rational;
};

} // namespace internal
} // namespace Isocurves_and_layouts
} // namespace CGAL

#endif // CGAL_ISOCURVES_AND_LAYOUTS_INTERNAL_CHARTS_EXACT_LEVEL_H
