// A tetrahedral mesh made of arrays: cells, coordinates of their corners, and features.

#ifndef SEAMLESS_SNAPPING_PYTHON_ARRAY_VOLUME_H
#define SEAMLESS_SNAPPING_PYTHON_ARRAY_VOLUME_H

#include "arrays.h"

#include <CGAL/Seamless_snapping/snap_volume_to_seamless.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

// Coordinates of the corners: a model of `ReadWritePropertyMap`.
struct Corner_map
{
  using key_type = std::size_t;
  using value_type = CGAL::Simple_cartesian<double>::Point_3;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  friend value_type get(const Corner_map& map, const std::size_t i)
  { return {map.data[3 * i], map.data[3 * i + 1], map.data[3 * i + 2]}; }
  friend void put(const Corner_map& map, const std::size_t i, const value_type& p)
  {
    for(int c = 0; c < 3; ++c)
      map.data[3 * i + std::size_t(c)] = p[c];
  }

  double* data;
};

// Copies of the caller's arrays.
struct Array_volume
{
  Array_volume(const Integers& cells, const Doubles& coordinates,
               const std::optional<Integers>& facets, const std::optional<Integers>& edges)
    : tetrahedra(rows_of<4>(cells)), uvw(copy_of(coordinates)), feature_facets(rows_of<3>(facets)),
      feature_edges(rows_of<2>(edges))
  { }

  Corner_map uvw_map() { return {uvw.data()}; }

  // The features, as named parameters.
  auto parameters() const
  {
    return CGAL::Seamless_snapping::parameters::feature_facets(feature_facets)
             .feature_edges(feature_edges);
  }

  std::vector<std::array<std::int64_t, 4> > tetrahedra;
  std::vector<double> uvw; // of the corners
  std::vector<std::array<std::int64_t, 3> > feature_facets;
  std::vector<std::array<std::int64_t, 2> > feature_edges;
};

#endif // SEAMLESS_SNAPPING_PYTHON_ARRAY_VOLUME_H
