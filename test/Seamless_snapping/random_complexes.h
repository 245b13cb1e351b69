// Random cut complexes with coordinates that are exact solutions, for any transition group; and
// whether coordinates are exact solutions of one, in rationals. Knows nothing of how the package
// turns vectors: lattice coordinates are complex numbers here.

#ifndef SEAMLESS_SNAPPING_TEST_RANDOM_COMPLEXES_H
#define SEAMLESS_SNAPPING_TEST_RANDOM_COMPLEXES_H

#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>

#include <CGAL/Exact_rational.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace random_complexes {

namespace internal = CGAL::Seamless_snapping::internal;
using Rational = CGAL::Exact_rational;

// Turned once by 360 / N degrees: u = a + b i for N = 1, 2, 4, where i^2 = -1, and u = a + b w for
// N = 3, 6, where w^2 = w - 1.
template <int N, typename Number>
std::array<Number, 2> turned_once(const std::array<Number, 2>& u)
{
  const Number a = u[0], b = u[1];
  switch(N) {
  case 1: return {{a, b}};
  case 2: return {{Number(-a), Number(-b)}};
  case 3: return {{Number(-a - b), a}}; // w^2 (a + b w) = -a - b + a w
  case 4: return {{Number(-b), a}};     // i (a + b i)
  default: return {{Number(-b), Number(a + b)}}; // w (a + b w) = -b + (a + b) w
  }
}

template <int N, typename Number>
std::array<Number, 2> turned(int turns, std::array<Number, 2> u)
{
  for(turns = (turns % N + N) % N; turns > 0; --turns)
    u = turned_once<N>(u);
  return u;
}

// The functionals, by what is constant along an isocurve: a, b, and for N = 3, 6 also a + b.
template <typename Number>
Number value(const int functional, const std::array<Number, 2>& u)
{
  return functional == 0 ? u[0] : functional == 1 ? u[1] : Number(u[0] + u[1]);
}

// The functional that is constant along an isocurve behind a number of turns: that whose absolute
// value is the same for all vectors. Two of them decide.
template <int N>
int functional_behind(const int turns, const int functional)
{
  for(int f = 0; f < (N == 3 || N == 6 ? 3 : 2); ++f) {
    bool is_same = true;
    for(const std::array<int, 2> u : {std::array<int, 2>{{5, 2}}, std::array<int, 2>{{-1, 7}}})
      is_same =
          is_same && std::abs(value(f, turned<N>(turns, u))) == std::abs(value(functional, u));
    if(is_same)
      return f;
  }
  return -1;
}

// The turns by 360 / N degrees of a branch.
template <int N>
int turns_of(const internal::Cut_complex<internal::Group_of_order<N> >& complex,
             const std::size_t branch)
{ return internal::Group_of_order<N>::turns(complex.element[branch], N); }

// A complex under construction. Each sector is the only one of its vertex.
template <int N>
class Generator
{
public:
  using Group = internal::Group_of_order<N>;
  using Complex = internal::Cut_complex<Group>;
  using Vector = std::array<double, 2>;
  using Sector = internal::Sector_index;

  explicit Generator(const unsigned int seed) : m_random(seed) { }

  Complex make(const std::size_t number_of_branches, const bool with_equations)
  {
    for(int i = 0; i < 3; ++i)
      add_sector(true);
    for(std::size_t i = 0; i < number_of_branches; ++i)
      switch(below(5)) {
      case 0: add_chain(); break;
      case 1: add_branch(node(), node(), false); break;
      case 2: add_branch(node(), add_sector(true), true); break;
      default: add_branch(node(), add_sector(true), false); break;
      }
    for(std::size_t i = 0; i < number_of_branches / 4; ++i)
      add_path();
    if(with_equations)
      add_equation();
    for(std::size_t v = 0; v <= m_complex.coordinates.size(); ++v)
      m_complex.first_sector.push_back(Sector(v));
    return m_complex;
  }

private:
  int below(const int n) { return int(m_random() % unsigned(n)); }

  // A multiple of 1/64 below 1, so that sums of hundreds are exact.
  double number() { return (below(128) - 64) / 64.; }

  Sector add_sector(const bool is_node) { return add_sector(is_node, {{number(), number()}}); }

  Sector add_sector(const bool is_node, const Vector& u)
  {
    m_complex.coordinates.push_back(u);
    m_complex.is_node.push_back(is_node);
    if(is_node)
      m_nodes.push_back(Sector(m_complex.coordinates.size()) - 1);
    return Sector(m_complex.coordinates.size()) - 1;
  }

  Sector node() { return m_nodes[std::size_t(below(int(m_nodes.size())))]; }
  const Vector& u(const Sector s) const { return m_complex.coordinates[std::size_t(s)]; }

  // From the pair (a, b) to a new one. A cone has one sector on both sides.
  void add_branch(const Sector a, const Sector b, const bool is_cone)
  {
    const int turns = below(N);
    const Sector minus = is_cone ? a : b;
    const Vector turned_a = turned<N>(turns, u(a));
    const Vector t{{u(minus)[0] - turned_a[0], u(minus)[1] - turned_a[1]}};
    m_complex.element.push_back(Group::element(turns, N));
    m_complex.pairs.push_back({a, minus});
    const int inner = below(4);
    for(int i = 0; i <= inner; ++i) {
      const Sector plus = add_sector(i == inner);
      const Vector turned_plus = turned<N>(turns, u(plus));
      const Sector other =
        add_sector(i == inner, {{turned_plus[0] + t[0], turned_plus[1] + t[1]}});
      m_complex.pairs.push_back({plus, other});
    }
    m_complex.pairs.end_list();
  }

  void add_chain()
  {
    const int f = below(Group::number_of_functionals);
    const Sector first = node();
    const double level = value(f, u(first));
    m_complex.functional.push_back(f);
    m_complex.links.push_back(first);
    const int inner = below(4);
    for(int i = 0; i <= inner; ++i)
      m_complex.links.push_back(add_sector(i == inner, on_level(f, level)));
    m_complex.links.end_list();
  }

  Vector on_level(const int f, const double level)
  {
    Vector x{{number(), number()}};
    if(f == 0)
      x[0] = level;
    else
      x[1] = f == 1 ? level : level - x[0];
    return x;
  }

  void add_path()
  {
    const Sector a = node();
    typename Complex::Path path{a, -1, below(Group::number_of_functionals), {}};
    Vector x = u(a);
    int f = path.functional;
    for(int i = below(4); i > 0; --i) {
      const std::size_t b = std::size_t(below(int(m_complex.number_of_branches())));
      const bool is_along = below(2) == 0;
      const int turns = is_along ? turns_of<N>(m_complex, b) : -turns_of<N>(m_complex, b);
      const auto& pair = m_complex.pairs[b].front();
      const Vector here = u(is_along ? pair.plus : pair.minus);
      const Vector there = u(is_along ? pair.minus : pair.plus);
      x = turned<N>(turns, Vector{{x[0] - here[0], x[1] - here[1]}});
      x = {{x[0] + there[0], x[1] + there[1]}};
      f = functional_behind<N>(turns, f);
      path.crossings.push_back({internal::Branch_index(b), is_along});
    }
    path.b = add_sector(true, on_level(f, value(f, x)));
    m_complex.paths.push_back(path);
  }

  void add_equation()
  {
    typename Complex::Equation equation{{}, Rational(0)};
    for(int i = 0; i < 3; ++i) {
      const Sector s = node();
      const int c = below(2), factor = 1 + below(3);
      equation.terms.push_back({s, c, Rational(factor)});
      equation.right_hand_side += Rational(factor) * Rational(u(s)[std::size_t(c)]);
    }
    m_complex.equations.push_back(equation);
  }

  std::mt19937 m_random;
  Complex m_complex;
  std::vector<Sector> m_nodes;
};

// Whether coordinates satisfy all constraints, in rationals.
template <int N>
bool is_solution(const internal::Cut_complex<internal::Group_of_order<N> >& complex,
                 const std::vector<std::array<double, 2> >& coordinates)
{
  using Vector = std::array<Rational, 2>;
  const auto u = [&](const internal::Sector_index s) {
    const auto& x = coordinates[std::size_t(s)];
    return Vector{{Rational(x[0]), Rational(x[1])}};
  };
  const auto difference = [](const Vector& a, const Vector& b) {
    return Vector{{Rational(a[0] - b[0]), Rational(a[1] - b[1])}};
  };
  const auto translation = [&](const std::size_t b, const auto& pair) {
    return difference(u(pair.minus), turned<N>(turns_of<N>(complex, b), u(pair.plus)));
  };
  for(std::size_t b = 0; b < complex.number_of_branches(); ++b)
    for(const auto& p : complex.pairs[b])
      if(translation(b, p) != translation(b, complex.pairs[b].front()))
        return false;
  for(std::size_t c = 0; c < complex.number_of_chains(); ++c)
    for(const auto s : complex.links[c])
      if(value(complex.functional[c], u(s)) !=
         value(complex.functional[c], u(complex.links[c].front())))
        return false;
  for(const auto& path : complex.paths) {
    Vector x = u(path.a);
    int f = path.functional;
    for(const auto& crossing : path.crossings) {
      const std::size_t b = std::size_t(crossing.branch);
      const Vector t = translation(b, complex.pairs[b].front());
      const int turns = turns_of<N>(complex, b);
      if(crossing.is_along) {
        x = turned<N>(turns, x);
        x = {{Rational(x[0] + t[0]), Rational(x[1] + t[1])}};
      } else {
        x = turned<N>(-turns, difference(x, t));
      }
      f = functional_behind<N>(crossing.is_along ? turns : -turns, f);
    }
    if(value(f, x) != value(f, u(path.b)))
      return false;
  }
  for(const auto& equation : complex.equations) {
    Rational sum(0);
    for(const auto& term : equation.terms)
      sum += Rational(term.coefficient * u(term.sector)[std::size_t(term.coordinate)]);
    if(sum != equation.right_hand_side)
      return false;
  }
  return true;
}

} // namespace random_complexes

#endif // SEAMLESS_SNAPPING_TEST_RANDOM_COMPLEXES_H
