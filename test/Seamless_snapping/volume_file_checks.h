// Files in the HEXEX format, and the fractions in them.

#ifndef SEAMLESS_SNAPPING_TEST_VOLUME_FILE_CHECKS_H
#define SEAMLESS_SNAPPING_TEST_VOLUME_FILE_CHECKS_H

#include "checking.h"

#include <CGAL/Seamless_snapping/IO/HEXEX.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace Snapping = CGAL::Seamless_snapping;

inline void test_files()
{
  namespace IO = Snapping::IO;
  const std::string cell = "0 1 2 3  0 0 0  1/3 0 0\t0 -6/4 0\r\n0 0 1e0\n";
  const std::string head = "4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1\n";
  const std::string tail = "1\n0 1 2 0.5\n1 1 1\n0\n1 2\n0 1 3\n";
  std::istringstream is(head + cell + tail);
  IO::HEXEX_mesh mesh;
  CHECK(bool(IO::read_HEXEX(is, mesh)));
  CHECK_EQUAL(mesh.number_of_rounded_coordinates, std::size_t(1));
  CHECK_EQUAL(mesh.uvw[1][0], 1. / 3);
  CHECK_EQUAL(mesh.uvw[2][1], -1.5);
  CHECK(mesh.feature_vertices.size() == 1 && mesh.feature_edges.size() == 1);
  CHECK((mesh.walls == std::vector<std::array<std::int32_t, 3> >{{{0, 1, 2}}}));
  CHECK((mesh.feature_facets == std::vector<std::array<std::int32_t, 3> >{{{0, 1, 3}}}));
  CHECK_EQUAL(mesh.unknown_line, std::size_t(0));
  mesh.uvw[3][2] = 0.1;
  std::ostringstream written;
  CHECK(bool(IO::write_HEXEX(written, mesh)));
  std::istringstream reread(written.str());
  IO::HEXEX_mesh copy;
  CHECK(bool(IO::read_HEXEX(reread, copy)) && copy.uvw == mesh.uvw && copy.points == mesh.points &&
        copy.feature_facets == mesh.feature_facets && copy.tetrahedra == mesh.tetrahedra);
  for(const auto& [text, line] :
      std::vector<std::pair<std::string, std::size_t> >{
        {"x", 1}, {"4\n0 0", 2}, {"99999999999\n", 1}, {head + "0 1 2 4", 7},
        {head + "0 1 2 3 0 0 0 0 0 0 0 0 0 0 0 1/0", 7}, {head + "0 1 2 3 nan", 7},
        {head + cell + "1\n0 1", 10}, {head + cell + "0 1 0\n5 6\n", 10}}) {
    std::istringstream bad(text);
    const auto status = IO::read_HEXEX(bad, mesh);
    CHECK_IN(text, !status && status.line == line);
    CHECK(mesh.uvw == copy.uvw);
  }
  std::istringstream unknown(head + cell + "some more\n");
  CHECK(bool(IO::read_HEXEX(unknown, mesh)));
  CHECK_EQUAL(mesh.unknown_line, std::size_t(9));
}

// Halfway between two doubles, the one whose last bit is 0.
inline void test_rounding_of_fractions()
{
  const auto nearest = [](const std::string& p, const std::string& q) {
    return Snapping::internal::nearest_double(
      CGAL::Exact_rational(CGAL::Exact_rational(CGAL::Exact_integer(p)) /
                           CGAL::Exact_rational(CGAL::Exact_integer(q))));
  };
  CHECK_EQUAL(nearest("9007199254740993", "1"), 9007199254740992.);
  CHECK_EQUAL(nearest("9007199254740995", "1"), 9007199254740996.);
  CHECK_EQUAL(nearest("90071992547409931", "10"), 9007199254740994.);
  CHECK_EQUAL(nearest("18014398509481983", "18014398509481984"), 1.);
  CHECK_EQUAL(nearest("36028797018963967", "36028797018963968"), 1.);
  CHECK_EQUAL(nearest("1", "3"), 1. / 3);
  CHECK_EQUAL(nearest("2", "3"), 2. / 3);
  CHECK_EQUAL(nearest("1" + std::string(400, '0'), "1"), std::numeric_limits<double>::infinity());
}

#endif // SEAMLESS_SNAPPING_TEST_VOLUME_FILE_CHECKS_H
