// Snapping a map of a tetrahedral mesh, and measuring one.

#include "Call.h"
#include "functions.h"
#include "reports.h"

#include <CGAL/Seamless_snapping/is_volume_seamless.h>
#include <CGAL/Seamless_snapping/snap_volume_to_seamless.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace SS = CGAL::Seamless_snapping;

namespace {

// Rows of an array of integers.
template <std::size_t N>
struct Rows
{
  explicit Rows(const Integers& array)
    : first(reinterpret_cast<const std::array<std::int64_t, N>*>(array.data())),
      count(std::size_t(array.shape(0)))
  { }
  explicit Rows(const std::optional<Integers>& array)
    : first(array ? Rows(*array).first : nullptr), count(array ? Rows(*array).count : 0)
  { }

  const std::array<std::int64_t, N>* begin() const { return first; }
  const std::array<std::int64_t, N>* end() const { return first + count; }
  std::size_t size() const { return count; }
  const std::array<std::int64_t, N>& operator[](const std::size_t i) const { return first[i]; }

  const std::array<std::int64_t, N>* first;
  std::size_t count;
};

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

template <typename Work>
void run(const py::object& progress, const Work& work)
{
  Call(progress).run([&] {
    try {
      work();
    } catch(const std::invalid_argument& error) {
      throw Refused(SS::Outcome::INVALID_ARGUMENT, error.what());
    }
  });
}

std::pair<Doubles, py::dict>
snap_volume(const Integers& tetrahedra, const Doubles& uvw, const std::optional<Integers>& facets,
            const std::optional<Integers>& edges, const bool align_boundary, const double tolerance,
            const bool repair_flips, const bool integer_grid, const double grid_scale,
            const double rounding, const py::object& progress)
{
  std::vector<double> result(uvw.data(), uvw.data() + uvw.size());
  SS::Snapping_report report;
  run(progress, [&] {
    report = SS::snap_volume_to_seamless(
      Rows<4>(tetrahedra), Corner_map{result.data()},
      SS::parameters::align_boundary(align_boundary).feature_facets(Rows<3>(facets))
        .feature_edges(Rows<2>(edges)).tolerance(tolerance)
        .repair_flips(repair_flips ? SS::Flip_repair::UNTANGLE : SS::Flip_repair::NONE)
        .integer_grid(integer_grid).grid_scale(grid_scale).rounding_tolerance(rounding));
  });
  py::dict dict = dict_of(report);
  add_distances(dict, report);
  dict["largest_rounding"] = report.largest_rounding;
  dict["lost_cells"] = report.lost_faces;
  dict["remaining_flips"] = report.remaining_flips;
  dict["number_of_repaired_flips"] = report.run.number_of_repaired_flips;
  return {to_array<double>(std::move(result), {tetrahedra.shape(0), 4, 3}), dict};
}

py::dict measure_volume(const Integers& tetrahedra, const Doubles& uvw,
                        const std::optional<Integers>& facets, const std::optional<Integers>& edges,
                        const bool align_boundary)
{
  using namespace py::literals;
  SS::Volume_seamlessness s;
  bool is_integer_grid = false;
  const Corner_map map{const_cast<double*>(uvw.data())}; // which is only read
  run(py::none(), [&] {
    const auto np = SS::parameters::align_boundary(align_boundary)
                      .feature_facets(Rows<3>(facets)).feature_edges(Rows<2>(edges));
    s = SS::measure_volume_seamlessness(Rows<4>(tetrahedra), map, np);
    is_integer_grid = SS::is_volume_integer_grid_map(Rows<4>(tetrahedra), map, np);
  });
  return py::dict("exact"_a = s.is_exact(), "integer_grid"_a = is_integer_grid,
                  "number_of_interior_facets"_a = s.number_of_interior_facets,
                  "number_of_mismatched_facets"_a = s.number_of_mismatched_facets,
                  "number_of_inexact_facets"_a = s.number_of_inexact_facets,
                  "number_of_aligned_facets"_a = s.number_of_aligned_facets,
                  "number_of_aligned_edges"_a = s.number_of_aligned_edges,
                  "number_of_misalignments"_a = s.number_of_misalignments,
                  "number_of_flipped_cells"_a = s.number_of_flipped_cells,
                  "number_of_degenerate_cells"_a = s.number_of_degenerate_cells,
                  "extent"_a = s.extent, "violation"_a = s.violation,
                  "misalignment"_a = s.misalignment);
}

} // namespace

void add_volumes(py::module_& module)
{
  module.def("snap_volume", snap_volume);
  module.def("measure_volume", measure_volume);
}
