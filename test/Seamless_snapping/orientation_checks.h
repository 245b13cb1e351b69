// What the tests of the orientation of faces share: signs in rational arithmetic, before and after, against
// what the report says.

#ifndef SEAMLESS_SNAPPING_TEST_ORIENTATION_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_ORIENTATION_CHECKS_H

#include "surface_checks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace orientation_checks {

namespace SS = CGAL::Seamless_snapping;

// Of all faces, in order.
template <typename Graph, typename UVMap>
std::vector<int> signs(const Graph& g, const UVMap& uv)
{
  std::vector<int> result;
  for(const auto f : faces(g))
    result.push_back(exact_check::face_orientation(f, g, uv));
  return result;
}

// The faces that had one kind of sign and are not positive now.
inline std::vector<std::size_t> not_positive(const std::vector<int>& before,
                                             const std::vector<int>& after, bool were_positive)
{
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < before.size(); ++i)
    if((before[i] > 0) == were_positive && after[i] <= 0)
      result.push_back(i);
  return result;
}

inline bool are_all_positive(const std::vector<int>& signs)
{
  return std::all_of(signs.begin(), signs.end(), [](int sign) { return sign > 0; });
}

// Totals over all runs.
struct Tally
{
  std::size_t runs = 0, lost = 0, moves = 0, weights = 0, program = 0, remaining = 0;
  std::size_t flips = 0, repaired_flips = 0;
  double largest_growth = 0, rms_growth = 0; // of the changes, by repairs

  void add(const SS::Snapping_report& report)
  {
    ++runs;
    lost += report.number_of_lost_faces;
    moves += report.number_of_faces_repaired_by_moves;
    weights += report.number_of_faces_repaired_by_weights;
    program += report.number_of_faces_repaired_by_program;
    remaining += report.lost_faces.size();
    repaired_flips += report.number_of_repaired_flips;
    flips += report.number_of_repaired_flips + report.remaining_flips.size();
    if(report.number_of_lost_faces > 0) {
      largest_growth =
        (std::max)(largest_growth, report.largest_change / report.largest_change_before_repair);
      rms_growth = (std::max)(rms_growth, report.rms_change / report.optimal_rms_change);
    }
  }

  void print(const std::string& name) const
  {
    std::cout << name << ": " << runs << " runs, " << lost << " faces lost, repaired by moves " << moves
              << ", by weights " << weights << ", by programs " << program << ", remaining "
              << remaining << "; flips " << flips << ", repaired " << repaired_flips
              << "; largest change times " << largest_growth << ", rms change times " << rms_growth
              << std::endl;
  }
};

// Snaps, and checks that the result is exact and that the report tells the truth about orientations.
template <typename Graph, typename UVMap, typename NP, typename IsAligned>
SS::Snapping_report snap(const Graph& g, UVMap uv, const NP& np, const IsAligned& is_aligned,
                         const std::string& context, bool repair_flips = false)
{
  using namespace surface_checks;
  const std::vector<int> before = signs(g, uv);
  const Bits bits_before = all_bits(g, uv);
  const SS::Snapping_report report = SS::snap_to_seamless(g, uv, np.repair_flips(repair_flips));
  const std::vector<int> after = signs(g, uv);
  CHECK_IN(context + ": " + report.message, bool(report));
  CHECK_IN(context, exact_check::check_edges(g, uv, is_aligned).is_exact());
  CHECK_IN(context, SS::is_seamless(g, uv, np));
  CHECK_IN(context, report.lost_faces == not_positive(before, after, true));
  CHECK_IN(context, report.number_of_lost_faces
                      == report.number_of_faces_repaired_by_moves
                           + report.number_of_faces_repaired_by_weights
                           + report.number_of_faces_repaired_by_program + report.lost_faces.size());
  if(repair_flips) {
    CHECK_IN(context, report.remaining_flips == not_positive(before, after, false));
  } else {
    CHECK_IN(context, report.remaining_flips.empty() && report.number_of_repaired_flips == 0);
  }
  const double change = largest_difference(bits_before, all_bits(g, uv));
  CHECK_IN(context, std::abs(report.largest_change - change) <= 1e-12 * change);
  return report;
}

} // namespace orientation_checks

#endif // SEAMLESS_SNAPPING_TEST_ORIENTATION_CHECKS_H
