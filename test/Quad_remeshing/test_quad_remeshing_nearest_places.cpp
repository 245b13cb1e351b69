// Tests of searches for the nearest place, against all triangles and segments one by one, in exact
// numbers: also for slivers, and for those that have no area or no length.

#include <CGAL/Quad_remeshing/internal/remeshing/Nearest_place_tree.h>

#include "checking.h"
#include "random_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <set>
#include <vector>

namespace internal = CGAL::Quad_remeshing::internal;
using internal::Space_segment;
using internal::Space_triangle;
using internal::Space_vector;
using random_numbers::Random;
using Exact = random_numbers::Rational;
using Exact_vector = std::array<Exact, 3>;

constexpr unsigned int seed = 1;

Exact_vector exact(const Space_vector& p) { return {p[0], p[1], p[2]}; }

Exact squared_length(const Exact_vector& v)
{
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

Exact dot(const Exact_vector& a, const Exact_vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Exact_vector minus(const Exact_vector& a, const Exact_vector& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Exact squared_distance(const Exact_vector& p, const Space_segment& s)
{
  const Exact_vector side = minus(exact(s[1]), exact(s[0])), d = minus(p, exact(s[0]));
  const Exact along = dot(d, side), length = squared_length(side);
  if(along <= 0)
    return squared_length(d);
  if(along >= length)
    return squared_length(minus(p, exact(s[1])));
  return squared_length(d) - along * along / length;
}

// The least over the sides, and over the plane where the foot of the perpendicular is inside: by
// its barycentric coordinates, from a system of two equations.
Exact squared_distance(const Exact_vector& p, const Space_triangle& t)
{
  Exact least = squared_distance(p, Space_segment{t[0], t[1]});
  least = (std::min)(least, squared_distance(p, Space_segment{t[1], t[2]}));
  least = (std::min)(least, squared_distance(p, Space_segment{t[2], t[0]}));
  const Exact_vector u = minus(exact(t[1]), exact(t[0])), v = minus(exact(t[2]), exact(t[0]));
  const Exact_vector d = minus(p, exact(t[0]));
  const Exact determinant = dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
  if(determinant == 0)
    return least;
  const Exact x = (dot(d, u) * dot(v, v) - dot(d, v) * dot(u, v)) / determinant;
  const Exact y = (dot(d, v) * dot(u, u) - dot(d, u) * dot(u, v)) / determinant;
  if(x >= 0 && y >= 0 && x + y <= 1)
    least = (std::min)(least, Exact(squared_length(d) - x * dot(d, u) - y * dot(d, v)));
  return least;
}

// Some on a grid, so that elements meet, and places are equally near.
Space_vector random_point(Random& random, const bool is_on_grid)
{
  Space_vector p;
  for(double& x : p) {
    x = std::uniform_real_distribution<double>(-1, 1)(random);
    if(is_on_grid)
      x = std::round(2 * x) / 2;
  }
  return p;
}

// Every second one is a sliver, or a point.
template <typename Element>
Element random_element(Random& random, const bool is_on_grid)
{
  Element result;
  for(Space_vector& p : result)
    p = random_point(random, is_on_grid);
  const int kind = random_numbers::below(random, 6);
  if(kind == 0)
    result.back() = internal::between(result[0], result[1], 0.3); // collinear, up to rounding
  if(kind == 1)
    result.back() = result[0];
  if(kind == 2)
    std::fill(result.begin(), result.end(), result[0]);
  return result;
}

// Floating point chooses among places that are as near up to rounding; so these are compared by
// what rounding can be.
template <typename Element>
void test_nearest(Random& random, const std::size_t number, const bool is_on_grid)
{
  constexpr double rounding = 1e-12;
  std::vector<Element> elements;
  for(std::size_t i = 0; i < number; ++i)
    elements.push_back(random_element<Element>(random, is_on_grid));
  const internal::Nearest_place_tree<Element> tree(elements);
  CHECK(!tree.empty());
  for(int i = 0; i < 10; ++i) {
    const Space_vector p = random_point(random, is_on_grid && i % 2 == 0);
    Exact least = squared_distance(exact(p), elements[0]);
    for(const Element& e : elements)
      least = (std::min)(least, squared_distance(exact(p), e));
    const double distance = std::sqrt(CGAL::to_double(least));
    const auto found = tree.nearest(p);
    CHECK(found.element < number);
    CHECK(std::abs(std::sqrt(found.squared_distance) - distance) < rounding);
    const auto lies_there = [&](const Space_vector& q) {
      return std::abs(internal::norm(internal::vector_to(p, q)) - distance) < rounding;
    };
    CHECK(lies_there(found.point));
    CHECK(CGAL::to_double(squared_distance(exact(found.point), elements[found.element])) <
          rounding * rounding);
    const Space_vector corner = elements[std::size_t(i) % number][0];
    CHECK(lies_there(tree.nearest(p, corner)));
    CHECK(lies_there(tree.nearest(p, found.point)));
  }
}

// All whose boxes meet that of a segment, once each.
void test_boxes(Random& random)
{
  std::vector<Space_triangle> elements;
  for(int i = 0; i < 100; ++i)
    elements.push_back(random_element<Space_triangle>(random, i % 2 == 0));
  const internal::Nearest_place_tree<Space_triangle> tree(elements);
  const Space_segment s{random_point(random, true), random_point(random, false)};
  std::multiset<std::size_t> visited, expected;
  tree.visit_near(s, [&](const std::size_t i) { visited.insert(i); });
  const auto meets = [&](const Space_triangle& t, const std::size_t c) {
    const auto [least, largest] = std::minmax({t[0][c], t[1][c], t[2][c]});
    return least <= (std::max)(s[0][c], s[1][c]) && (std::min)(s[0][c], s[1][c]) <= largest;
  };
  for(std::size_t i = 0; i < elements.size(); ++i)
    if(meets(elements[i], 0) && meets(elements[i], 1) && meets(elements[i], 2))
      expected.insert(i);
  for(const std::size_t i : expected)
    CHECK(visited.count(i) == 1);
  for(const std::size_t i : visited) // those of a leaf may come together
    CHECK(visited.count(i) == 1 && i < elements.size());
}

int main()
{
  std::cout << "seed " << seed << std::endl;
  Random random(seed);
  for(int i = 0; i < 300; ++i)
    for(const std::size_t number : {1, 4, 5, 30}) {
      test_nearest<Space_segment>(random, number, i % 2 == 0);
      test_nearest<Space_triangle>(random, number, i % 2 == 0);
    }
  for(int i = 0; i < 100; ++i)
    test_boxes(random);
  const internal::Nearest_place_tree<Space_triangle> none;
  CHECK(none.empty());
  none.visit_near({}, [](const std::size_t) { CHECK(false); });
  return report_checks();
}
