// Random sparse systems of linear equations of all the kinds that differ for the solver.

#ifndef SEAMLESS_SNAPPING_TEST_RANDOM_SYSTEMS_H
#define SEAMLESS_SNAPPING_TEST_RANDOM_SYSTEMS_H

#include "exact_reference.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>

namespace random_systems {

using exact_reference::Rational;
using exact_reference::Rationals;
using exact_reference::System;
using Random = std::mt19937_64;

inline int random_integer(Random& random, int low, int high)
{
  return low + int(random() % std::uint64_t(high - low + 1));
}

inline double random_real(Random& random) // in [-1,1)
{
  return static_cast<double>(static_cast<std::int64_t>(random())) * 0x1p-63;
}

enum class Kind { signs, small_numbers, halves_and_thirds, wide, huge, number_of_kinds };

inline Rational random_coefficient(Random& random, Kind kind)
{
  switch(kind) {
    case Kind::signs: return Rational(random() % 2 == 0 ? 1 : -1);
    case Kind::small_numbers: return Rational(random_integer(random, -4, 4));
    case Kind::halves_and_thirds:
      return Rational(random_integer(random, -9, 9)) / Rational(random_integer(random, 1, 6));
    case Kind::wide: return Rational(random_integer(random, -1000000, 1000000));
    default: return Rational(static_cast<long>(random() >> 3) - (1L << 60)); // overflow at once
  }
}

inline System random_homogeneous_system(Random& random, Kind kind, std::size_t columns,
                                        std::size_t rows)
{
  System system;
  system.columns = columns;
  for(std::size_t r = 0; r < rows; ++r) {
    exact_reference::Row row;
    const int most = random() % 8 == 0 ? int(columns) : 4;
    const int entries = random_integer(random, random() % 16 == 0 ? 0 : 2, (std::max)(2, most));
    for(int k = 0; k < entries; ++k)
      row.push_back({ random() % columns, random_coefficient(random, kind) });
    system.add_row(row);
  }
  return system;
}

// Appends sums of rows: redundant ones, of a consistent system.
inline void add_redundant_rows(Random& random, System& system, int count)
{
  for(int k = 0; k < count && !system.rows.empty(); ++k) {
    exact_reference::Row row;
    Rational b(0);
    for(int terms = random_integer(random, 1, 3); terms > 0; --terms) {
      const std::size_t r = random() % system.rows.size();
      const Rational factor(random_integer(random, -2, 2));
      for(const auto& entry : system.rows[r])
        row.push_back({ entry.column, Rational(factor * entry.coefficient) });
      b += factor * system.b[r];
    }
    system.add_row(row, b);
  }
}

enum class Right_hand_side { zero, of_grid_point, of_double, integer, thirds };

// Zero or solvable on a grid two times out of three.
inline Right_hand_side random_right_hand_side(Random& random)
{
  const int draw = random_integer(random, 0, 8);
  if(draw < 3)
    return Right_hand_side::zero;
  return draw < 6 ? Right_hand_side::of_grid_point : Right_hand_side(draw - 4);
}

inline void set_right_hand_side(Random& random, Right_hand_side kind, System& system)
{
  Rationals point;
  for(std::size_t c = 0; c < system.columns; ++c)
    point.push_back(Rational(random_integer(random, -64, 64)) / Rational(16));
  for(std::size_t r = 0; r < system.rows.size(); ++r) {
    switch(kind) {
      case Right_hand_side::zero: break;
      case Right_hand_side::of_grid_point:
        system.b[r] = exact_reference::residual(system, r, point) + system.b[r];
        break;
      case Right_hand_side::of_double: system.b[r] = Rational(random_real(random)); break;
      case Right_hand_side::integer: system.b[r] = Rational(random_integer(random, -9, 9)); break;
      default: system.b[r] = Rational(random_integer(random, -9, 9)) / Rational(3);
    }
  }
}

} // namespace random_systems

#endif // SEAMLESS_SNAPPING_TEST_RANDOM_SYSTEMS_H
