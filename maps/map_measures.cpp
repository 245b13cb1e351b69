#include "map_measures.h"

#include <CGAL/Seamless_snapping/is_seamless.h>

#include <algorithm>
#include <cmath>

namespace SS = CGAL::Seamless_snapping;

namespace {

// How far the sides of an edge are from each other under the rotation that fits best.
double misfit(const Kernel::Vector_2& side, Kernel::Vector_2 other)
{
  double least = largest_component(side - other);
  for(int k = 1; k < 4; ++k) {
    other = other.perpendicular(CGAL::COUNTERCLOCKWISE);
    least = (std::min)(least, largest_component(side - other));
  }
  return least;
}

} // namespace

std::pair<double, int> area_in_domain(const Mesh& mesh, const Uv_map& uv_map,
                                      const bool only_positive)
{
  double largest = 0, area = 0;
  for(const Halfedge h : mesh.halfedges())
    if(!mesh.is_border(h))
      largest = (std::max)({largest, std::abs(uv_map[h].x()), std::abs(uv_map[h].y())});
  const int exponent = largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0;
  const auto scaled = [&](const Halfedge h) {
    return Kernel::Point_2(std::ldexp(uv_map[h].x(), -exponent),
                           std::ldexp(uv_map[h].y(), -exponent));
  };
  for(const auto f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    const double of_face = CGAL::area(scaled(h), scaled(mesh.next(h)), scaled(mesh.prev(h)));
    area += only_positive ? (std::max)(of_face, 0.) : of_face;
  }
  return {area, exponent};
}

double largest_component(const Kernel::Vector_2& v)
{
  return (std::max)(std::abs(v.x()), std::abs(v.y()));
}

double misalignment(const Mesh& mesh, const Uv_map& uv_map, const Edge e)
{
  double result = 0;
  for(const Halfedge h : {mesh.halfedge(e), mesh.opposite(mesh.halfedge(e))})
    if(!mesh.is_border(h)) {
      const Kernel::Vector_2 change = uv_map[h] - uv_map[mesh.prev(h)];
      result = (std::max)(result, (std::min)(std::abs(change.x()), std::abs(change.y())));
    }
  return result;
}

double tolerance_of_alignment(const Mesh& mesh, const Uv_map& uv_map)
{
  const SS::Seamlessness survey = SS::measure_seamlessness(mesh, uv_map);
  return (std::min)((std::max)(100 * survey.violation, 1e-9 * survey.extent),
                    1e-4 * survey.extent);
}

Misfits count_misfits(const Mesh& mesh, const Uv_map& uv_map, const double tolerance)
{
  const double largest = tolerance * SS::measure_seamlessness(mesh, uv_map).extent;
  Misfits result;
  for(const Edge e : mesh.edges()) {
    if(mesh.is_border(e))
      continue;
    ++result.number_of_edges;
    const Halfedge h = mesh.halfedge(e), g = mesh.opposite(h);
    const auto &a = uv_map[mesh.prev(h)], &b = uv_map[h];
    const auto &a_opposite = uv_map[g], &b_opposite = uv_map[mesh.prev(g)];
    if((std::max)(largest_component(a - a_opposite), largest_component(b - b_opposite)) <= largest)
      continue;
    ++result.number_of_cut_edges;
    const Kernel::Vector_2 side = b - a, opposite = b_opposite - a_opposite;
    const double distance = misfit(side, opposite);
    const double length = (std::max)(largest_component(side), largest_component(opposite));
    if(distance > largest) {
      ++result.number_of_misfits;
      result.number_of_gross_misfits += 8 * distance > length ? 1 : 0;
    }
  }
  return result;
}
