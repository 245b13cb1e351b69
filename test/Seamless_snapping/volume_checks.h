// Maps of volumes as property maps, and what holds for each that is snapped.

#ifndef SEAMLESS_SNAPPING_TEST_VOLUME_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_VOLUME_CHECKS_H

#include "checking.h"
#include "floating_point_traps.h"
#include "volume_generator.h"
#include "volume_reference.h"

#include <CGAL/Seamless_snapping/is_volume_seamless.h>
#include <CGAL/Seamless_snapping/snap_volume_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace Snapping = CGAL::Seamless_snapping;
namespace parameters = Snapping::parameters;
using Snapping::Snapping_report;
using Snapping::Outcome;
using volume_generator::Charts;
using volume_generator::Cube_complex;
using volume_reference::Point;
using volume_reference::Tet_map;

// The corners as a property map of points.
template <typename Number>
struct Corner_map
{
  using Point_3 = typename CGAL::Simple_cartesian<Number>::Point_3;
  using key_type = std::size_t;
  using value_type = Point_3;
  using reference = Point_3;
  using category = boost::read_write_property_map_tag;

  Tet_map* map;
  std::size_t* number_of_writings = nullptr;

  friend Point_3 get(const Corner_map& m, const std::size_t i)
  {
    const Point& p = m.map->corners[i];
    return Point_3(Number(p[0]), Number(p[1]), Number(p[2]));
  }
  friend void put(const Corner_map& m, const std::size_t i, const Point_3& p)
  {
    m.map->corners[i] = {{double(p.x()), double(p.y()), double(p.z())}};
    if(m.number_of_writings != nullptr)
      ++*m.number_of_writings;
  }
};

using Double_map = Corner_map<double>;

template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
Snapping_report snap(Tet_map& map, const NamedParameters& np = CGAL::parameters::default_values())
{
  const Floating_point_traps traps;
  return Snapping::snap_volume_to_seamless(map.cells, Double_map{&map}, np);
}

inline bool is_seamless(Tet_map map)
{
  const Floating_point_traps traps;
  return Snapping::is_volume_seamless(map.cells, Double_map{&map});
}

// Snaps, and compares with what the rational check finds.
inline Snapping_report snap_and_check(Tet_map& map, const std::string& name)
{
  const Tet_map before = map;
  const Snapping_report report = snap(map);
  CHECK_IN(name + ": " + report.message, bool(report));
  CHECK_IN(name, volume_reference::check(map).is_exact() == bool(report));
  CHECK_IN(name, is_seamless(before) == volume_reference::check(before).is_exact());
  CHECK_IN(name, is_seamless(map) == bool(report));
  const double change = volume_reference::largest_change(before, map);
  CHECK_IN(name + ": change " + std::to_string(change / report.grid_step) + " steps",
           change <= 2 * report.violation_before + 8 * report.grid_step);
  CHECK_IN(name, std::abs(change - report.largest_change) <= 1e-12 * change);
  CHECK_IN(name, volume_reference::lost_cells(before, map) == report.lost_faces.size());
  return report;
}

inline Tet_map box_map(const unsigned int seed)
{
  Cube_complex box{"box", {}, [](int, const volume_generator::Lattice_point p) {
    return volume_generator::Key(p.begin(), p.end());
  }};
  volume_generator::add_box(box, 0, 3, 2, 2);
  return volume_generator::Tetrahedra_builder(box, Charts::BLOCKS, seed).build();
}

#endif // SEAMLESS_SNAPPING_TEST_VOLUME_CHECKS_H
