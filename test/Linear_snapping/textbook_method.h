// The method as the paper prints it, for reference: Algorithms 1 to 5 on dense matrices, each a
// function of its own. Shares no code with the package.
//
// Three things are not as printed. Pivots are sought in each column below the rows that have one
// already, since Algorithm 1 skips a row together with a column that has no pivot, and then fails
// on matrices of deficient rank. Eq. (2) is replaced by (2') of the addendum. And rows with a zero
// where another row's pivot is are left alone: by the letter they would be multiplied by that
// pivot, and divided by it right after.
//
// What it claims: a solution of every homogeneous system, unless an implied value leaves the range
// of the fixed point numbers (Sec. 7); of an inhomogeneous one if each right-hand side in the final
// matrix is divisible by its pivot (addendum B).

#ifndef SEAMLESS_SNAPPING_TEST_TEXTBOOK_METHOD_H
#define SEAMLESS_SNAPPING_TEST_TEXTBOOK_METHOD_H

#include "exact_reference.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace textbook {

// C x = b. The coefficients grow: `Integer` should be of any length.
template <typename Integer>
struct Dense_system
{
  std::size_t columns = 0;
  std::vector<std::vector<Integer> > c; // rows
  std::vector<Integer> b;
};

// The final matrix: rows without a pivot are gone.
template <typename Integer>
struct Echelon_form
{
  Dense_system<Integer> system;
  std::vector<std::size_t> pivots; // the column of each row's pivot
  bool is_consistent = true;
  Integer largest = Integer(0);    // absolute value after Algorithm 1 or 2

  const Integer& pivot(std::size_t row) const { return system.c[row][pivots[row]]; }
};

template <typename Integer>
Integer absolute(const Integer& a)
{
  return a < 0 ? Integer(-a) : a;
}

// Without denominators.
template <typename Integer>
Dense_system<Integer> dense_system(const exact_reference::System& system)
{
  Dense_system<Integer> result;
  result.columns = system.columns;
  for(std::size_t r = 0; r < system.rows.size(); ++r) {
    const exact_reference::Row row = exact_reference::merged(system.rows[r]);
    exact_reference::Rationals numbers(1, system.b[r]);
    for(const auto& entry : row)
      numbers.push_back(entry.coefficient);
    const exact_reference::Integer scale = exact_reference::common_denominator(numbers);
    result.c.emplace_back(system.columns, Integer(0));
    for(const auto& entry : row)
      result.c.back()[entry.column] =
        Integer(exact_reference::scaled_to_integer(entry.coefficient, scale));
    result.b.push_back(Integer(exact_reference::scaled_to_integer(system.b[r], scale)));
  }
  return result;
}

// --- Sec. 4.1 ------------------------------------------------------------------------------------

template <typename Integer>
void divide_by_common_divisor(std::vector<Integer>& row, Integer& b, std::size_t first)
{
  Integer divisor = absolute(b);
  for(std::size_t j = first; j < row.size() && divisor != 1; ++j)
    if(row[j] != 0)
      divisor = CGAL::gcd(divisor, absolute(row[j]));
  if(divisor == 0 || divisor == 1)
    return;
  for(std::size_t j = first; j < row.size(); ++j)
    if(row[j] != 0)
      row[j] = CGAL::integral_division(row[j], divisor);
  b = CGAL::integral_division(b, divisor);
}

// C_i <- C_kl C_i - C_il C_k from column `first` on, which makes C_il vanish.
template <typename Integer>
void eliminate(Dense_system<Integer>& system, std::size_t i, std::size_t k, std::size_t l,
               std::size_t first)
{
  std::vector<Integer>& row = system.c[i];
  const std::vector<Integer>& by = system.c[k];
  const Integer pivot = by[l], factor = row[l];
  for(std::size_t j = first; j < system.columns; ++j) {
    if(row[j] != 0)
      row[j] *= pivot;
    if(j >= l && by[j] != 0)
      row[j] -= Integer(factor * by[j]);
  }
  system.b[i] = Integer(pivot * system.b[i]) - Integer(factor * system.b[k]);
  divide_by_common_divisor(row, system.b[i], first);
}

// Algorithm 1. Returns the pivot columns of the first rows; the other rows are zero.
template <typename Integer>
std::vector<std::size_t> algorithm_1(Dense_system<Integer>& system)
{
  std::vector<std::size_t> pivots;
  for(std::size_t column = 0; column < system.columns; ++column) {
    const std::size_t k = pivots.size();
    std::size_t l = k;
    while(l < system.c.size() && system.c[l][column] == 0)
      ++l;
    if(l == system.c.size())
      continue;
    std::swap(system.c[k], system.c[l]);
    std::swap(system.b[k], system.b[l]);
    for(std::size_t i = k + 1; i < system.c.size(); ++i)
      if(system.c[i][column] != 0)
        eliminate(system, i, k, column, column);
    pivots.push_back(column);
  }
  return pivots;
}

// Algorithm 2.
template <typename Integer>
void algorithm_2(Dense_system<Integer>& system, const std::vector<std::size_t>& pivots)
{
  for(std::size_t k = pivots.size(); k-- > 1;)
    for(std::size_t i = k; i-- > 0;)
      if(system.c[i][pivots[k]] != 0)
        eliminate(system, i, k, pivots[k], pivots[i]);
}

template <typename Integer>
Integer largest_coefficient(const Dense_system<Integer>& system)
{
  Integer result(0);
  for(const auto& row : system.c)
    for(const Integer& a : row)
      if(a > result || -a > result)
        result = absolute(a);
  return result;
}

template <typename Integer>
Echelon_form<Integer> reduced_echelon_form(Dense_system<Integer> system)
{
  for(std::size_t i = 0; i < system.c.size(); ++i)
    divide_by_common_divisor(system.c[i], system.b[i], 0);
  Echelon_form<Integer> result;
  result.pivots = algorithm_1(system);
  const std::ptrdiff_t rank = std::ptrdiff_t(result.pivots.size());
  result.is_consistent = std::all_of(system.b.begin() + rank, system.b.end(),
                                     [](const Integer& b) { return b == 0; });
  system.c.resize(result.pivots.size());
  system.b.resize(result.pivots.size());
  result.largest = largest_coefficient(system);
  if(result.is_consistent) {
    algorithm_2(system, result.pivots);
    result.largest = (std::max)(result.largest, largest_coefficient(system));
  }
  result.system = std::move(system);
  return result;
}

// --- Sec. 4.3 ------------------------------------------------------------------------------------

// The numbers F_delta: the multiples of delta 2^-52 between -delta and delta.
class Fixed_point
{
public:
  explicit Fixed_point(const std::vector<double>& xbar)
  {
    double largest = 0;
    for(const double x : xbar)
      largest = (std::max)(largest, std::abs(x));
    const double fraction = std::frexp(largest, &m_exponent); // in [1/2,1): K is the ceiling
    m_exponent += fraction == 0.5 ? 0 : 1;
    m_delta = std::ldexp(1., m_exponent);
  }

  double delta() const { return m_delta; }
  double step() const { return std::ldexp(m_delta, -52); }
  bool contains(double x) const { return -m_delta < x && x < m_delta; } // for multiples of step()

  double operator()(double x) const
  {
    return x < 0 ? (x - m_delta) + m_delta : (x + m_delta) - m_delta;
  }

  // Whether a/b is one of the numbers, and then which.
  template <typename Integer>
  bool quotient(const Integer& a, const Integer& b, double& result) const
  {
    Integer numerator(a), denominator(b);
    for(int e = m_exponent - 52; e != 0; e += e < 0 ? 1 : -1)
      (e < 0 ? numerator : denominator) *= 2;
    const Integer steps(numerator / denominator);
    result = CGAL::to_double(steps) * step();
    return Integer(steps * denominator) == numerator && contains(result);
  }

private:
  int m_exponent;
  double m_delta;
};

// Algorithm 4.
template <typename Integer>
double make_div(double x, const std::vector<Integer>& divisors, const Fixed_point& fixed_point)
{
  Integer multiple(1);
  for(const Integer& d : divisors) {
    const Integer common = CGAL::gcd(multiple, absolute(d));
    multiple *= CGAL::integral_division(absolute(d), common);
  }
  // Exact where it matters: beyond 2^53 the quotient is rounded to 0.
  const double d = CGAL::to_double(multiple);
  const double quotient = fixed_point(x / d);
  return quotient == 0 ? 0 : quotient * d;
}

template <typename Integer>
struct Summand
{
  Integer count;
  double x;
};

enum class Outcome
{
  EXACT,         // claimed, that is
  INCONSISTENT,
  NOT_DIVISIBLE, // a right-hand side by its pivot: Algorithm 4 is not meant for that
  OUT_OF_RANGE,  // an implied value
  TOO_LONG       // Algorithm 5 would go back and forth with very large coefficients
};

// Algorithm 5. As printed it doesn't end if the sum is out of range.
template <typename Integer>
Outcome safe_dot(const std::vector<Summand<Integer> >& summands, const Fixed_point& fixed_point,
                 double& r)
{
  const double delta = fixed_point.delta();
  std::vector<Summand<Integer> > positive, negative;
  for(const Summand<Integer>& s : summands)
    if(s.count != 0 && s.x != 0)
      ((s.count > 0) == (s.x > 0) ? positive : negative)
        .push_back({ absolute(s.count), (s.count > 0) == (s.x > 0) ? std::abs(s.x)
                                                                  : -std::abs(s.x) });
  r = 0;
  for(int steps = 0; !positive.empty() || !negative.empty(); ++steps) {
    const bool take_positive = !positive.empty() && (r < 0 || negative.empty());
    auto& set = take_positive ? positive : negative;
    Summand<Integer>& s = set.back();
    const double room = std::floor(((take_positive ? delta : -delta) - r) / s.x);
    const double k = (std::min)(CGAL::to_double(s.count), room);
    if(k < 1)
      return Outcome::OUT_OF_RANGE;
    if(steps == 1000000)
      return Outcome::TOO_LONG;
    r += k * s.x;
    s.count -= Integer(static_cast<long>(k));
    if(s.count == 0)
      set.pop_back();
  }
  return fixed_point.contains(r) ? Outcome::EXACT : Outcome::OUT_OF_RANGE;
}

// Eq. (2') for one row. Free variables are multiples of the pivot already.
template <typename Integer>
Outcome implied_value(const Echelon_form<Integer>& form, std::size_t row,
                      const Fixed_point& fixed_point, std::vector<double>& x)
{
  const std::size_t k = form.pivots[row];
  const double pivot = CGAL::to_double(form.pivot(row));
  Summand<Integer> b{ Integer(-1), 0 };
  if(!fixed_point.quotient(form.system.b[row], form.pivot(row), b.x))
    return Outcome::NOT_DIVISIBLE;
  std::vector<Summand<Integer> > summands(1, b);
  for(std::size_t i = k + 1; i < form.system.columns; ++i)
    if(form.system.c[row][i] != 0)
      summands.push_back({ form.system.c[row][i], x[i] / pivot });
  double sum = 0;
  const Outcome outcome = safe_dot(summands, fixed_point, sum);
  x[k] = -sum;
  return outcome;
}

// Algorithm 3. On failure the values are those from before.
template <typename Integer>
Outcome algorithm_3(const Echelon_form<Integer>& form, std::vector<double>& xbar)
{
  if(!form.is_consistent)
    return Outcome::INCONSISTENT;
  const Fixed_point fixed_point(xbar);
  std::vector<double> x(xbar);
  std::size_t row = form.pivots.size(); // the first whose pivot was passed
  for(std::size_t k = form.system.columns; k-- > 0;) {
    if(row > 0 && form.pivots[row - 1] == k) {
      const Outcome outcome = implied_value(form, --row, fixed_point, x);
      if(outcome != Outcome::EXACT)
        return outcome;
      continue;
    }
    std::vector<Integer> divisors;
    for(std::size_t i = 0; i < row; ++i)
      if(form.system.c[i][k] != 0)
        divisors.push_back(form.pivot(i));
    x[k] = make_div(xbar[k], divisors, fixed_point);
  }
  xbar.swap(x);
  return Outcome::EXACT;
}

} // namespace textbook

#endif // SEAMLESS_SNAPPING_TEST_TEXTBOOK_METHOD_H
