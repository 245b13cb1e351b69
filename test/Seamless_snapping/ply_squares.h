// Texts of PLY files with coordinates per corner, in text form and as bytes.

#ifndef SEAMLESS_SNAPPING_TEST_PLY_SQUARES_H
#define SEAMLESS_SNAPPING_TEST_PLY_SQUARES_H

#include "checking.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

// A file as MeshLab writes it, in text form; the square of two triangles has a seam as its
// diagonal.
inline const std::string head =
  "ply\nformat ascii 1.0\ncomment VCGLIB generated\ncomment TextureFile a b.png\n"
  "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
  "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
  "property int texnumber\nend_header\n";
inline const std::string body = "0 0 0 255\n1 0 0 255\n1 1 0.0 255 \n0 1 0 255\n"
                         "3 0 1 2 6 0 0 1.0 0 1 1 0 \n3 0 2 3 6 5 5 6 5 6 6 0 \n";

inline std::string replaced(std::string text, const std::string& what, const std::string& by)
{
  const std::size_t i = text.find(what);
  if(CHECK(i != text.npos))
    text.replace(i, what.size(), by);
  return text;
}

// The square cut open along its diagonal.
inline const std::string cut_square =
  replaced(replaced(replaced(head, "vertex 4", "vertex 6"), "uchar int vertex",
                    "uchar uchar vertex"), "texnumber", "n") +
  "0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n0 0 0 1\n1 1 0 1\n"
  "3 0 1 2 6 0 0 1.0 0 1 1 0 \n3 4 5 3 6 5 5 6 5 6 6 0 \n";

// The values of `body` as bytes, by hand.
template <typename Index, typename Float>
std::string binary_square(const bool little)
{
  std::string text = "ply\r\nformat binary_" + std::string(little ? "little" : "big")
                     + "_endian 1.0\r\nelement vertex 4\r\nproperty uchar red\r\n"
                       "property double x\r\nproperty float y\r\nproperty short z\r\n"
                       "element face 2\r\nproperty list int "
                     + (sizeof(Float) == 4 ? "float32" : "float64") + " texcoord\r\n"
                     + "property list char " + (sizeof(Index) == 1 ? "uint8" : "ushort")
                     + " vertex_index\r\nelement other 1\r\nproperty list uchar short x\r\n"
                       "end_header\r\n";
  const auto add = [&text, little](auto value) {
    std::string bytes(sizeof(value), '\0');
    std::memcpy(&bytes[0], &value, sizeof(value));
    const std::uint16_t one = 1;
    if((*reinterpret_cast<const unsigned char*>(&one) == 1) != little)
      std::reverse(bytes.begin(), bytes.end());
    text += bytes;
  };
  const double points[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for(const auto& p : points) {
    add(std::uint8_t(10)); // a new line
    add(p[0]);
    add(static_cast<float>(p[1]));
    add(std::int16_t(0));
  }
  const double uvs[2][6] = {{0, 0, 1, 0, 1, 1}, {5, 5, 6, 5, 6, 6}};
  const int triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
  for(int f = 0; f < 2; ++f) {
    add(std::int32_t(6));
    for(const double x : uvs[f])
      add(static_cast<Float>(x));
    add(std::int8_t(3));
    for(const int v : triangles[f])
      add(static_cast<Index>(v));
  }
  add(std::uint8_t(2));
  add(std::int16_t(-1));
  add(std::int16_t(7));
  return text;
}

#endif // SEAMLESS_SNAPPING_TEST_PLY_SQUARES_H
