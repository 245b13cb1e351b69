#include "Surface_soup.h"

#include "Failure.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/functional/hash.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <queue>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

// For each point the first one in the same place.
std::vector<std::size_t> first_points(const Polygon_soup& soup)
{
  std::vector<std::size_t> order(soup.points.size()), result(soup.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](const std::size_t i, const std::size_t j) {
    return soup.points[i] < soup.points[j];
  });
  for(std::size_t k = 0; k < order.size(); ++k) {
    const bool is_new = k == 0 || soup.points[order[k]] != soup.points[order[k - 1]];
    result[order[k]] = is_new ? order[k] : result[order[k - 1]];
  }
  return result;
}

// Counts points of no face. Returns whether faces share points.
bool are_points_shared(const Polygon_soup& soup, Repairs& repairs)
{
  std::vector<std::size_t> uses(soup.points.size(), 0);
  for(const auto& polygon : soup.polygons)
    for(const std::size_t v : polygon.vertices)
      ++uses[v];
  repairs.unused_points = static_cast<std::size_t>(std::count(uses.begin(), uses.end(), 0u));
  return std::any_of(uses.begin(), uses.end(), [](const std::size_t n) { return n > 1; });
}

// Replaces the points of the faces by others, and counts those that no face has any more.
void replace_points(const std::vector<std::size_t>& by, Surface_soup& surface, Repairs& repairs)
{
  std::vector<char> is_replaced(by.size(), 0);
  for(Polygon& polygon : surface.polygons)
    for(std::size_t& v : polygon)
      if(by[v] != v) {
        is_replaced[v] = 1;
        v = by[v];
      }
  repairs.welded_points +=
    std::size_t(std::count(is_replaced.begin(), is_replaced.end(), char(1)));
}

// From the least vertex on.
Polygon rotated(Polygon polygon)
{
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  return polygon;
}

// From the least vertex on, in the direction of its lesser neighbor: the same for all polygons with
// the same sides.
Polygon canonical(Polygon polygon)
{
  polygon = rotated(std::move(polygon));
  if(polygon[1] > polygon.back())
    std::reverse(polygon.begin() + 1, polygon.end());
  return polygon;
}

// Without corners that follow on others in the same place.
Polygon simplified(Polygon polygon, const std::vector<std::size_t>& places)
{
  const auto is_same = [&](const std::size_t v, const std::size_t w)
    { return places[v] == places[w]; };
  polygon.erase(std::unique(polygon.begin(), polygon.end(), is_same), polygon.end());
  while(polygon.size() > 1 && is_same(polygon.front(), polygon.back()))
    polygon.pop_back();
  return polygon;
}

std::size_t number_of_different_corners(Polygon polygon)
{
  std::sort(polygon.begin(), polygon.end());
  return std::size_t(std::unique(polygon.begin(), polygon.end()) - polygon.begin());
}

// Removes faces that have less than three different corners.
void remove_degenerate_faces(const Polygon_soup& soup, Surface_soup& surface, Repairs& repairs)
{
  for(std::size_t f = 0; f < soup.polygons.size(); ++f) {
    Polygon polygon = simplified(soup.polygons[f].vertices, surface.places);
    if(number_of_different_corners(polygon) < 3) {
      ++repairs.degenerate_faces;
      continue;
    }
    surface.polygons.push_back(std::move(polygon));
    surface.file_faces.push_back(f);
  }
}

// No polygon mesh has a face with a corner twice.
void check_corners(const Polygon_soup& soup, const Surface_soup& surface)
{
  for(std::size_t i = 0; i < surface.polygons.size(); ++i)
    if(number_of_different_corners(surface.polygons[i]) < surface.polygons[i].size())
      refuse(soup, surface.file_faces[i], "the face meets itself in a corner");
}

struct Side
{
  std::array<std::size_t, 2> key; // the sides that are compared have the same
  std::size_t source, target, face;
};

std::array<std::size_t, 2> sorted(const std::size_t v, const std::size_t w)
{
  return {{(std::min)(v, w), (std::max)(v, w)}};
}

// By their keys, and those of the same key by their faces. Few keys begin with the same point.
void sort_by_key(std::vector<Side>& sides)
{
  std::vector<std::size_t> number_before(1, 0); // per point
  for(const Side& s : sides) {
    if(number_before.size() < s.key[0] + 2)
      number_before.resize(s.key[0] + 2, 0);
    ++number_before[s.key[0] + 1];
  }
  std::partial_sum(number_before.begin(), number_before.end(), number_before.begin());
  std::vector<Side> sorted(sides.size());
  std::vector<std::size_t> next = number_before;
  for(const Side& s : sides)
    sorted[next[s.key[0]]++] = s;
  for(std::size_t v = 0; v + 1 < number_before.size(); ++v)
    std::sort(sorted.begin() + std::ptrdiff_t(number_before[v]),
              sorted.begin() + std::ptrdiff_t(number_before[v + 1]),
              [](const Side& a, const Side& b)
                { return std::tie(a.key, a.face) < std::tie(b.key, b.face); });
  sides.swap(sorted);
}

// Calls `visit` with the begin and the end of each range of sides of the same key, which are sorted.
template <typename Visit>
void for_each_key(std::vector<Side>& sides, const Visit& visit)
{
  for(auto begin = sides.begin(); begin != sides.end(); ) {
    const auto end = std::find_if(begin, sides.end(),
                                  [&](const Side& s) { return s.key != begin->key; });
    visit(begin, end);
    begin = end;
  }
}

// Of all polygons, sorted by their points, or by what is given in place of these.
std::vector<Side> all_sides(const Surface_soup& surface, const std::vector<std::size_t>& names = {})
{
  const auto name = [&](const std::size_t v) { return names.empty() ? v : names[v]; };
  std::vector<Side> sides;
  sides.reserve(3 * surface.polygons.size());
  for(std::size_t f = 0; f < surface.polygons.size(); ++f) {
    const Polygon& polygon = surface.polygons[f];
    for(std::size_t k = 0; k < polygon.size(); ++k) {
      const std::size_t v = polygon[k], w = polygon[(k + 1) % polygon.size()];
      sides.push_back({sorted(name(v), name(w)), v, w, f});
    }
  }
  sort_by_key(sides);
  return sides;
}

// Whether as many run one way as the other, as those of closed bodies do.
template <typename Iterator>
bool are_balanced(const Iterator begin, const Iterator end)
{
  return 2 * std::count_if(begin, end, [](const Side& s) { return s.source == s.key[0]; }) ==
         end - begin;
}

using Faces_by_corners = std::map<Polygon, std::vector<std::size_t> >;

// The faces that are there twice, turned either way, where two closed bodies meet. In a piece of
// which all faces are, the two are no bodies, but the sides of a surface.
std::vector<char> walls_of_bodies(const Surface_soup& surface, const Faces_by_corners& by_corners)
{
  std::vector<char> result(surface.polygons.size(), 0);
  for(const auto& [corners, faces] : by_corners)
    if(faces.size() == 2 &&
       rotated(surface.polygons[faces[0]]) != rotated(surface.polygons[faces[1]]))
      result[faces[0]] = result[faces[1]] = 1;
  if(std::find(result.begin(), result.end(), 1) == result.end())
    return result;
  std::vector<Side> sides = all_sides(surface);
  boost::disjoint_sets_with_storage<> pieces(surface.polygons.size());
  for_each_key(sides, [&](const auto begin, const auto end) {
    const bool may_be_wall = are_balanced(begin, end);
    for(auto it = begin; it != end; ++it) {
      pieces.union_set(begin->face, it->face);
      if(!may_be_wall)
        result[it->face] = 0;
    }
  });
  std::vector<char> has_others(surface.polygons.size(), 0);
  for(std::size_t f = 0; f < surface.polygons.size(); ++f)
    if(!result[f])
      has_others[pieces.find_set(f)] = 1;
  for(std::size_t f = 0; f < surface.polygons.size(); ++f)
    result[f] = char(result[f] && has_others[pieces.find_set(f)]);
  return result;
}

// Those that may have the same corners as others: most have another hash.
Faces_by_corners faces_like_others(const Surface_soup& surface)
{
  std::vector<std::pair<std::size_t, std::size_t> > hashes;
  for(std::size_t f = 0; f < surface.polygons.size(); ++f)
    hashes.emplace_back(boost::hash<Polygon>()(canonical(surface.polygons[f])), f);
  std::sort(hashes.begin(), hashes.end());
  Faces_by_corners result;
  for(std::size_t i = 0; i < hashes.size(); ++i)
    if((i > 0 && hashes[i].first == hashes[i - 1].first) ||
       (i + 1 < hashes.size() && hashes[i].first == hashes[i + 1].first))
      result[canonical(surface.polygons[hashes[i].second])].push_back(hashes[i].second);
  return result;
}

// Removes all other faces. Returns how many.
std::size_t keep_faces(const std::vector<char>& is_kept, Surface_soup& surface)
{
  std::size_t n = 0;
  for(std::size_t i = 0; i < is_kept.size(); ++i)
    if(is_kept[i]) {
      surface.polygons[n] = surface.polygons[i];
      if(!surface.is_turned.empty())
        surface.is_turned[n] = surface.is_turned[i];
      surface.file_faces[n++] = surface.file_faces[i];
    }
  surface.polygons.resize(n);
  surface.file_faces.resize(n);
  surface.is_turned.resize(surface.is_turned.empty() ? 0 : n);
  return is_kept.size() - n;
}

// Keeps the first of the faces that have the same corners, but both faces of a wall.
void remove_duplicate_faces(Surface_soup& surface, Repairs& repairs)
{
  const Faces_by_corners by_corners = faces_like_others(surface);
  if(by_corners.empty())
    return;
  std::vector<char> is_kept(surface.polygons.size(), 1);
  const std::vector<char> is_wall = walls_of_bodies(surface, by_corners);
  for(const auto& [corners, faces] : by_corners)
    for(const std::size_t f : faces)
      is_kept[f] = char(f == faces.front() || is_wall[f]);
  repairs.duplicate_faces = keep_faces(is_kept, surface);
}

// Makes two border edges between the same places one, as those of a mesh that was cut open. Bodies
// that only touch, each closed, stay apart.
void weld_borders(Surface_soup& surface, Repairs& repairs)
{
  std::vector<Side> sides = all_sides(surface), border;
  for_each_key(sides, [&](const auto begin, const auto end) {
    if(end - begin == 1)
      border.push_back({sorted(surface.places[begin->source], surface.places[begin->target]),
                        begin->source, begin->target, begin->face});
  });
  if(border.empty())
    return;
  sort_by_key(border);
  const std::size_t n = surface.places.size();
  boost::disjoint_sets_with_storage<> sets(n);
  for_each_key(border, [&](const auto begin, const auto end) {
    if(end - begin != 2 || begin->face == (end - 1)->face) // which belong together is unknown
      return;
    const Side &a = *begin, &b = *(begin + 1);
    const bool is_same_direction = surface.places[a.source] == surface.places[b.source];
    sets.union_set(a.source, is_same_direction ? b.source : b.target);
    sets.union_set(a.target, is_same_direction ? b.target : b.source);
  });
  std::vector<std::size_t> first(n, n), by(n);
  for(std::size_t v = 0; v < n; ++v) {
    std::size_t& first_of_set = first[sets.find_set(v)];
    first_of_set = (std::min)(first_of_set, v);
    by[v] = first_of_set;
  }
  replace_points(by, surface, repairs);
}

// Adds the points of the faces, in the order of the file.
void add_points(const Polygon_soup& soup, Surface_soup& surface)
{
  std::vector<std::size_t> new_index(soup.points.size(), 0);
  for(const Polygon& polygon : surface.polygons)
    for(const std::size_t v : polygon)
      new_index[v] = 1;
  for(std::size_t v = 0; v < new_index.size(); ++v)
    if(new_index[v] == 1) {
      new_index[v] = surface.points.size();
      surface.points.emplace_back(soup.points[v][0], soup.points[v][1], soup.points[v][2]);
      surface.file_points.push_back(v);
    }
  for(Polygon& polygon : surface.polygons)
    for(std::size_t& v : polygon)
      v = new_index[v];
}

using Shared_side = std::array<Side, 2>; // of two faces

bool has_one_direction(const Shared_side& s) { return s[0].source == s[1].source; }

// The faces of each piece in the order of their distances from its first one.
struct Face_trees
{
  std::vector<std::size_t> entered_by; // per face: the number of a shared side, or `none`
  std::vector<char> is_turned; // per face: as it has to be to fit the one it is reached from

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  bool fits(const Shared_side& s) const
  { return has_one_direction(s) == (is_turned[s[0].face] != is_turned[s[1].face]); }
};

std::size_t face_across(const Shared_side& s, const std::size_t face)
{ return s[s[0].face == face ? 1 : 0].face; }

Face_trees face_trees(const std::vector<Shared_side>& shared, const std::size_t number_of_faces)
{
  std::vector<std::size_t> last(number_of_faces + 1, 0), shared_of(2 * shared.size()); // per face
  for(const Shared_side& s : shared)
    for(const Side& side : s)
      ++last[side.face];
  std::partial_sum(last.begin(), last.end(), last.begin());
  std::vector<std::size_t> first(last);
  for(std::size_t s = shared.size(); s-- > 0; )
    for(const Side& side : shared[s])
      shared_of[--first[side.face]] = s;
  Face_trees result{std::vector<std::size_t>(number_of_faces, Face_trees::none),
                    std::vector<char>(number_of_faces, 0)};
  std::vector<char> is_reached(number_of_faces, 0);
  std::vector<std::size_t> reached;
  for(std::size_t start = 0; start < number_of_faces; ++start) {
    if(is_reached[start])
      continue;
    is_reached[start] = 1;
    reached.assign(1, start);
    for(std::size_t i = 0; i < reached.size(); ++i)
      for(std::size_t k = first[reached[i]]; k < last[reached[i]]; ++k) {
        const std::size_t s = shared_of[k];
        const std::size_t f = face_across(shared[s], reached[i]);
        if(is_reached[f])
          continue;
        is_reached[f] = 1;
        result.entered_by[f] = s;
        result.is_turned[f] = char(result.is_turned[reached[i]] != has_one_direction(shared[s]));
        reached.push_back(f);
      }
  }
  return result;
}

// Gives corners at one point that no side in `joined` connects points of their own: then faces
// around a point are one fan.
void take_apart(const std::vector<Shared_side>& joined, Surface_soup& surface)
{
  std::vector<std::size_t> first_corner(1, 0);
  for(const Polygon& polygon : surface.polygons)
    first_corner.push_back(first_corner.back() + polygon.size());
  const auto corner = [&](const std::size_t f, const std::size_t v) {
    const Polygon& polygon = surface.polygons[f];
    return first_corner[f] +
           std::size_t(std::find(polygon.begin(), polygon.end(), v) - polygon.begin());
  };
  boost::disjoint_sets_with_storage<> sets(first_corner.back());
  for(const Shared_side& s : joined)
    for(const std::size_t v : s[0].key)
      sets.union_set(corner(s[0].face, v), corner(s[1].face, v));
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> point_of_set(first_corner.back(), none);
  std::vector<char> is_taken(surface.points.size(), 0);
  for(std::size_t f = 0; f < surface.polygons.size(); ++f)
    for(std::size_t k = 0; k < surface.polygons[f].size(); ++k) {
      std::size_t& v = surface.polygons[f][k];
      std::size_t& point = point_of_set[sets.find_set(first_corner[f] + k)];
      if(point == none && is_taken[v]) {
        point = surface.points.size();
        surface.points.push_back(surface.points[v]);
        surface.file_points.push_back(surface.file_points[v]);
      } else if(point == none) {
        point = v;
        is_taken[v] = 1;
      }
      v = point;
    }
}

bool is_inside_out(const Surface_soup& surface)
{
  double volume = 0;
  for(const Polygon& polygon : surface.polygons)
    for(std::size_t k = 2; k < polygon.size(); ++k)
      volume += CGAL::determinant(surface.points[polygon[0]] - surface.points[0],
                                  surface.points[polygon[k - 1]] - surface.points[0],
                                  surface.points[polygon[k]] - surface.points[0]);
  return volume < 0;
}

// At which angle each side's face lies around their edge; the same for faces with the same corners.
template <typename Iterator>
std::vector<double> angles(const Surface_soup& surface, const Iterator begin, const Iterator end)
{
  const Kernel::Point_3 p = surface.points[begin->key[0]];
  const Kernel::Vector_3 along = surface.points[begin->key[1]] - p;
  Kernel::Vector_3 axis(1, 0, 0);
  if(std::abs(along.x()) > std::abs(along.y()))
    axis = Kernel::Vector_3(0, 1, 0);
  const Kernel::Vector_3 u = CGAL::cross_product(along, axis), v = CGAL::cross_product(along, u);
  const double length = CGAL::approximate_sqrt(along.squared_length());
  std::vector<double> result;
  for(auto it = begin; it != end; ++it) {
    double angle = 0, farthest = -1;
    for(const std::size_t w : rotated(surface.polygons[it->face])) {
      const double x = (surface.points[w] - p) * u, y = (surface.points[w] - p) * v / length,
                   distance = x * x + y * y;
      if(distance > farthest) {
        farthest = distance;
        angle = std::atan2(y, x);
      }
    }
    result.push_back(std::isfinite(angle) ? angle : 0);
  }
  return result;
}

// Pairs of sides of one edge with the inside of a body between them: around the edge, a body begins
// at faces that run against it, and ends at others.
template <typename Iterator>
std::vector<Shared_side> sides_of_bodies(const Surface_soup& surface, const Iterator begin,
                                         const Iterator end, const bool is_turned)
{
  const std::vector<double> angle = angles(surface, begin, end);
  const auto ends_body = [&](const std::size_t i)
    { return (begin[std::ptrdiff_t(i)].source == begin->key[0]) != is_turned; };
  std::vector<std::size_t> around(angle.size()), open;
  std::iota(around.begin(), around.end(), std::size_t(0));
  std::stable_sort(around.begin(), around.end(), [&](const std::size_t i, const std::size_t j)
    { return std::make_pair(angle[i], !ends_body(i)) < std::make_pair(angle[j], !ends_body(j)); });
  std::vector<Shared_side> result;
  std::vector<char> is_paired(angle.size(), 0);
  for(const bool is_first_turn : {true, false})
    for(const std::size_t i : around) {
      if(!ends_body(i)) {
        if(is_first_turn)
          open.push_back(i);
      } else if(!open.empty() && !is_paired[i]) {
        is_paired[i] = 1;
        result.push_back({begin[std::ptrdiff_t(open.back())], begin[std::ptrdiff_t(i)]});
        open.pop_back();
      }
    }
  return result;
}

// Takes closed bodies apart that share edges or walls.
void separate_bodies(Surface_soup& surface, std::vector<Side>& sides)
{
  bool are_bodies = false;
  for_each_key(sides, [&](const auto begin, const auto end) {
    are_bodies = are_bodies || (end - begin > 2 && are_balanced(begin, end));
  });
  if(!are_bodies)
    return;
  std::vector<Shared_side> joined;
  const bool is_turned = is_inside_out(surface);
  for_each_key(sides, [&](const auto begin, const auto end) {
    if(end - begin == 2) {
      joined.push_back({*begin, *(begin + 1)});
    } else if(end - begin > 2 && are_balanced(begin, end)) {
      for(const Shared_side& pair : sides_of_bodies(surface, begin, end, is_turned))
        joined.push_back(pair);
    }
  });
  take_apart(joined, surface);
  sides = all_sides(surface);
}

// The shortest closed way along shared sides, or from border to border, that crosses a loop of
// faces an odd number of times: cut along it, the surface stays in one piece, without this loop.
// After 300,000 steps, it is the shortest one so far: ways between borders are tried first, and
// then those across every 16th side of the loop, as neighbors have much the same.
class Shortest_cut
{
public:
  // \param is_on_border per point
  // \param is_crossed per shared side: whether the loop leads across it
  Shortest_cut(const Surface_soup& surface, const std::vector<Shared_side>& shared,
               const std::vector<char>& is_on_border, const std::vector<char>& is_crossed)
    : m_surface(surface), m_shared(shared), m_is_on_border(is_on_border), m_is_crossed(is_crossed),
      m_sides_of(surface.points.size() + 1)
  {
    for(std::size_t s = 0; s < shared.size(); ++s)
      for(const std::size_t v : shared[s][0].key)
        m_sides_of[node(v)].push_back(s);
  }

  using Numbers = std::set<std::size_t, std::greater<> >;

  // Those of its sides.
  Numbers run()
  {
    const std::size_t border = m_surface.points.size();
    search({border, false}, {border, true}, {});
    std::vector<std::size_t> crossed;
    for(std::size_t s = 0; s < m_shared.size(); ++s)
      if(m_is_crossed[s])
        crossed.push_back(s);
    for(std::size_t first = 0; first < stride; ++first)
      for(std::size_t i = first; i < crossed.size(); i += stride) {
        const auto& [v, w] = m_shared[crossed[i]][0].key;
        if(m_steps_left > 0 || m_best.empty())
          search({node(v), false}, {node(w), false}, {crossed[i]});
      }
    return m_best;
  }

private:
  using State = std::pair<std::size_t, bool>; // a node, and whether the loop was crossed
  struct Step
  {
    double distance;
    State before;
    std::size_t side;
  };

  // All points of the border are one.
  std::size_t node(const std::size_t v) const
  { return m_is_on_border[v] ? m_surface.points.size() : v; }

  std::size_t node_across(const std::size_t side, const std::size_t from) const
  {
    const auto& [v, w] = m_shared[side][0].key;
    return node(v) == from ? node(w) : node(v);
  }

  double length(const std::size_t side) const
  {
    const auto& [v, w] = m_shared[side][0].key;
    return CGAL::approximate_sqrt(CGAL::squared_distance(m_surface.points[v],
                                                         m_surface.points[w]));
  }

  // A way that ends with some sides, if it is shorter than the best one.
  void search(const State start, const State end, const Numbers& last)
  {
    using Entry = std::pair<double, State>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    std::map<State, Step> steps;
    const double length_of_last = last.empty() ? 0 : length(*last.begin());
    steps[start] = {0, start, 0};
    queue.emplace(0, start);
    for(; !queue.empty() && queue.top().second != end; --m_steps_left) {
      const auto [d, state] = queue.top();
      queue.pop();
      if(d > steps[state].distance)
        continue;
      for(const std::size_t s : m_sides_of[state.first]) {
        const Step step{d + length(s), state, s};
        const State to(node_across(s, state.first), state.second != bool(m_is_crossed[s]));
        const auto [found, is_new] = steps.try_emplace(to, step);
        if((is_new || step.distance < found->second.distance) &&
           step.distance + length_of_last < m_length) {
          found->second = step;
          queue.emplace(step.distance, to);
        }
      }
    }
    if(queue.empty())
      return;
    m_length = queue.top().first + length_of_last;
    m_best = last;
    for(State state = end; state != start; state = steps[state].before)
      if(const std::size_t s = steps[state].side; !m_best.insert(s).second)
        m_best.erase(s); // to a loop and back
  }

  const Surface_soup& m_surface;
  const std::vector<Shared_side>& m_shared;
  const std::vector<char>& m_is_on_border;
  const std::vector<char>& m_is_crossed;
  std::vector<std::vector<std::size_t> > m_sides_of; // per node
  static constexpr std::size_t stride = 16;
  long m_steps_left = 300000;
  double m_length = std::numeric_limits<double>::infinity();
  Numbers m_best;
};

// The shared sides that a loop of faces leads across, which does not fit at this one.
std::vector<char> loop_through(const std::size_t side, const std::vector<Shared_side>& shared,
                               const Face_trees& trees)
{
  std::vector<char> result(shared.size(), 0);
  result[side] = 1;
  for(const Side& s : shared[side])
    for(std::size_t f = s.face; trees.entered_by[f] != Face_trees::none;
        f = face_across(shared[trees.entered_by[f]], f))
      result[trees.entered_by[f]] ^= 1;
  return result;
}

// Takes faces apart but where two have an edge in common, and turns them to the direction of the
// first one of their piece. Surfaces of one side are cut along short ways; where that takes many, in
// the end where faces meet last that are reached in the order of their distance, as an order that
// goes into the depth makes long cuts.
void cut_and_turn(Surface_soup& surface)
{
  constexpr int most_ways = 100;
  std::vector<Side> sides = all_sides(surface);
  separate_bodies(surface, sides);
  std::vector<Shared_side> shared, joined;
  std::vector<char> is_on_border(surface.points.size(), 0);
  for_each_key(sides, [&](const auto begin, const auto end) {
    if(end - begin == 2)
      shared.push_back({*begin, *(begin + 1)});
    else
      is_on_border[begin->source] = is_on_border[begin->target] = 1;
  });
  for(int i = 0; ; ++i) {
    const Face_trees trees = face_trees(shared, surface.polygons.size());
    joined.clear();
    std::copy_if(shared.begin(), shared.end(), std::back_inserter(joined),
                 [&](const Shared_side& s) { return trees.fits(s); });
    if(joined.size() == shared.size() || i == most_ways) {
      surface.is_turned = trees.is_turned;
      break;
    }
    const auto side = std::find_if(shared.begin(), shared.end(),
                                   [&](const Shared_side& s) { return !trees.fits(s); });
    const std::vector<char> is_crossed =
      loop_through(std::size_t(side - shared.begin()), shared, trees);
    // the largest numbers first, so that those of others stay
    for(const std::size_t s : Shortest_cut(surface, shared, is_on_border, is_crossed).run()) {
      for(const std::size_t v : shared[s][0].key)
        is_on_border[v] = 1;
      shared.erase(shared.begin() + std::ptrdiff_t(s));
    }
  }
  take_apart(joined, surface);
  for(std::size_t f = 0; f < surface.polygons.size(); ++f)
    if(surface.is_turned[f])
      std::reverse(surface.polygons[f].begin(), surface.polygons[f].end());
}

// The edges at which faces came apart that had shared them, and the points. No two faces have an
// edge in the same direction; this may be left where fans wind through an edge more than once.
void check_and_count_cuts(const Surface_soup& surface, Repairs& repairs)
{
  std::vector<Side> sides = all_sides(surface, surface.file_points);
  std::set<std::size_t> ends; // of these edges
  const auto ends_of = [](const Side& s) { return std::make_pair(s.source, s.target); };
  for_each_key(sides, [&](const auto begin, const auto end) {
    std::sort(begin, end,
              [&](const Side& a, const Side& b) { return ends_of(a) < ends_of(b); });
    if(std::adjacent_find(begin, end, [&](const Side& a, const Side& b)
                            { return ends_of(a) == ends_of(b); }) != end)
      throw Failure(UNREADABLE, "the faces are no surface, even when cut apart");
    const bool is_one_sided = end - begin == 2 && sorted(begin->source, begin->target) !=
                                                    sorted((end - 1)->source, (end - 1)->target);
    repairs.cut_edges += end - begin > 2 ? 1 : 0;
    repairs.one_sided_edges += is_one_sided ? 1 : 0;
    if(end - begin > 2 || is_one_sided)
      ends.insert(begin->key.begin(), begin->key.end());
  });
  std::vector<char> is_seen(surface.places.size(), 0); // per point of the file
  for(const std::size_t v : surface.file_points) {
    repairs.bowtie_vertices += is_seen[v] && ends.count(v) == 0 ? 1 : 0;
    is_seen[v] = 1;
  }
}

bool has_area(const Surface_soup& surface, const Polygon& polygon)
{
  using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Exact_kernel::Point_3> corners;
  for(const std::size_t v : polygon) {
    const Kernel::Point_3& p = surface.points[v];
    corners.emplace_back(p.x(), p.y(), p.z());
  }
  for(std::size_t k = 2; k < corners.size(); ++k) // as those that follow on each other differ
    if(!CGAL::collinear(corners[k - 2], corners[k - 1], corners[k]))
      return true;
  return false;
}

// Pieces of one face and its back, as fins are once they are cut off: no map has such a piece, but
// the face is a sheet by itself.
void remove_backs(Surface_soup& surface, Repairs& repairs)
{
  std::vector<char> is_kept(surface.polygons.size(), 1);
  for(const auto& [corners, faces] : faces_like_others(surface))
    for(std::size_t i = 1; i < faces.size(); ++i)
      is_kept[faces[i]] = 0;
  repairs.duplicate_faces += keep_faces(is_kept, surface);
}

// Removes the pieces none of whose faces has an area.
void remove_flat_pieces(const Polygon_soup& soup, Surface_soup& surface, Repairs& repairs)
{
  std::vector<std::size_t> faces_with_area;
  for(std::size_t f = 0; f < surface.polygons.size(); ++f)
    if(has_area(surface, surface.polygons[f]))
      faces_with_area.push_back(f);
  if(faces_with_area.size() == surface.polygons.size())
    return;
  boost::disjoint_sets_with_storage<> pieces(surface.polygons.size());
  std::vector<Side> sides = all_sides(surface);
  for_each_key(sides, [&](const auto begin, const auto end) {
    for(auto it = begin; it != end; ++it)
      pieces.union_set(begin->face, it->face);
  });
  std::vector<char> is_kept(surface.polygons.size(), 0); // per piece
  for(const std::size_t f : faces_with_area)
    is_kept[pieces.find_set(f)] = 1;
  Surface_soup kept;
  std::vector<std::size_t> new_index(surface.points.size(), 0);
  for(std::size_t f = 0; f < surface.polygons.size(); ++f)
    if(is_kept[pieces.find_set(f)]) {
      kept.polygons.push_back(surface.polygons[f]);
      kept.file_faces.push_back(surface.file_faces[f]);
      kept.is_turned.push_back(surface.is_turned[f]);
      for(const std::size_t v : surface.polygons[f])
        new_index[v] = 1;
    } else if(repairs.faces_of_flat_pieces++ == 0) {
      repairs.first_face_of_flat_pieces = surface.file_faces[f] + soup.first_number;
    }
  if(repairs.faces_of_flat_pieces == 0)
    return;
  if(kept.polygons.empty())
    throw Failure(UNREADABLE, "the faces have no area: the corners of each lie on a line");
  for(std::size_t v = 0; v < new_index.size(); ++v)
    if(new_index[v] == 1) {
      new_index[v] = kept.points.size();
      kept.points.push_back(surface.points[v]);
      kept.file_points.push_back(surface.file_points[v]);
    }
  for(Polygon& polygon : kept.polygons)
    for(std::size_t& v : polygon)
      v = new_index[v];
  kept.places.swap(surface.places);
  surface = std::move(kept);
}

} // namespace

void refuse(const Polygon_soup& soup, const std::size_t face, const std::string& why)
{
  const std::size_t line = soup.polygons[face].line;
  throw Failure(UNREADABLE, (line == 0 ? "face " + std::to_string(face + soup.first_number)
                                       : "line " + std::to_string(line)) + ": " + why);
}

std::size_t merge_points(const double distance, Polygon_soup& soup)
{
  using Cell = std::array<double, 3>; // of a grid, whose neighbors are the next numbers
  std::map<Cell, std::vector<std::size_t> > kept;
  double side = distance;
  for(const auto& point : soup.points)
    for(const double x : point)
      side = (std::max)(side, 1e-12 * std::abs(x)); // so that numbers of cells are exact
  std::size_t number = 0;
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    auto& point = soup.points[v];
    const auto cell = [&](const std::size_t neighbor) {
      Cell result;
      for(std::size_t c = 0, n = neighbor; c < 3; ++c, n /= 3)
        result[c] = std::floor(point[c] / side) + double(n % 3) - 1;
      return result;
    };
    constexpr std::size_t own = 13, number_of_cells = 27;
    std::optional<std::size_t> nearest;
    double least = distance;
    for(std::size_t i = 0; i < number_of_cells; ++i)
      if(const auto it = kept.find(cell(i)); it != kept.end())
        for(const std::size_t w : it->second) {
          const auto& other = soup.points[w];
          const double d =
            std::hypot(point[0] - other[0], point[1] - other[1], point[2] - other[2]);
          if(d <= least) {
            least = d;
            nearest = w;
          }
        }
    if(!nearest)
      kept[cell(own)].push_back(v);
    else if(point != soup.points[*nearest]) {
      point = soup.points[*nearest];
      ++number;
    }
  }
  return number;
}

Surface_soup make_surface(const Polygon_soup& soup, Repairs& repairs)
{
  Surface_soup surface;
  surface.places = first_points(soup);
  repairs.is_indexed = are_points_shared(soup, repairs);
  remove_degenerate_faces(soup, surface, repairs);
  if(surface.polygons.empty())
    throw Failure(UNREADABLE, "no face has three corners in different places, as points coincide");
  if(repairs.is_indexed)
    weld_borders(surface, repairs);
  else
    replace_points(surface.places, surface, repairs);
  check_corners(soup, surface);
  remove_duplicate_faces(surface, repairs);
  add_points(soup, surface);
  cut_and_turn(surface);
  check_and_count_cuts(surface, repairs);
  remove_backs(surface, repairs);
  remove_flat_pieces(soup, surface, repairs);
  return surface;
}
