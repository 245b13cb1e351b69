// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_MESH_TEXTS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_MESH_TEXTS_H

#include <CGAL/license/Seamless_snapping.h>

// From a mesh with its property maps to the text of a file: the steps of `write_OBJ()` and of
// `write_PLY()`.

#include <CGAL/Seamless_snapping/internal/IO/Distinct_uvs.h>
#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_header.h>
#include <CGAL/Seamless_snapping/internal/IO/decimal_numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

struct Corner_to_write
{
  std::size_t vertex; // in the order of the mesh
  Distinct_uvs::UV uv;
};

class OBJ_text
{
public:
  explicit OBJ_text(const std::size_t number_of_vertices)
    : m_distinct(number_of_vertices)
  { }

  void add_point(const std::array<double, 3>& point) { add_statement("v", point, m_points); }

  void add_face(const std::vector<Corner_to_write>& corners)
  {
    m_faces += 'f';
    for(const Corner_to_write& corner : corners) {
      const std::size_t number = m_distinct.uvs().size();
      const std::size_t vt = m_distinct.insert(corner.vertex, corner.uv);
      if(vt == number)
        add_statement("vt", corner.uv, m_uvs);
      m_faces += ' ' + std::to_string(corner.vertex + 1) + '/' + std::to_string(vt + 1);
    }
    m_faces += '\n';
  }

  void add_edge(const std::size_t v, const std::size_t w)
  {
    m_edges += "l " + std::to_string(v + 1) + ' ' + std::to_string(w + 1) + '\n';
  }

  std::string text(const std::string& comments) const
  {
    std::string head;
    if(!comments.empty())
      head = "# ";
    for(const char c : comments) {
      head += (c == '\r') ? ' ' : c;
      if(c == '\n')
        head += "# ";
    }
    return (comments.empty() ? head : head + '\n') + m_points + m_uvs + m_faces + m_edges;
  }

private:
  template <typename Numbers>
  static void add_statement(const char* const keyword, const Numbers& numbers, std::string& text)
  {
    text += keyword;
    for(const double x : numbers) {
      text += ' ';
      append_number(x, text);
    }
    text += '\n';
  }

  Distinct_uvs m_distinct;
  std::string m_points, m_uvs, m_faces, m_edges;
};

// In binary form.
class PLY_text
{
public:
  explicit PLY_text(const std::size_t number_of_vertices)
  {
    if(number_of_vertices > std::size_t((std::numeric_limits<std::int32_t>::max)()))
      throw File_refusal(0, "the mesh has too many vertices for the PLY format; nothing is "
                            "written");
  }

  void add_point(const std::array<double, 3>& point)
  {
    ++m_number_of_points;
    for(const double x : point)
      add_number(x);
  }

  void add_face(const std::vector<Corner_to_write>& corners)
  {
    ++m_number_of_faces;
    m_body += static_cast<char>(corners.size());
    for(const Corner_to_write& corner : corners)
      add_index(corner.vertex);
    m_body += static_cast<char>(2 * corners.size());
    for(const Corner_to_write& corner : corners)
      for(const double x : corner.uv)
        add_number(x);
  }

  void add_edge(const std::size_t v, const std::size_t w)
  {
    ++m_number_of_edges;
    add_index(v);
    add_index(w);
  }

  std::string text(const std::string& comments) const
  {
    std::string head = "ply\nformat binary_little_endian 1.0\n";
    for(std::size_t begin = 0; begin < comments.size(); ) {
      const std::size_t end = (std::min)(comments.find_first_of("\r\n", begin), comments.size());
      head += "comment " + comments.substr(begin, end - begin) + "\n";
      begin = end + 1;
    }
    head += "element vertex " + std::to_string(m_number_of_points)
            + "\nproperty double x\nproperty double y\nproperty double z\nelement face "
            + std::to_string(m_number_of_faces)
            + "\nproperty list uchar int vertex_indices\nproperty list uchar double texcoord\n";
    if(m_number_of_edges > 0)
      head += "element edge " + std::to_string(m_number_of_edges)
              + "\nproperty int vertex1\nproperty int vertex2\n";
    return head + "end_header\n" + m_body;
  }

private:
  void add_number(const double x)
  {
    if(!std::isfinite(x))
      throw File_refusal(0, "a coordinate is not finite; nothing is written");
    append_bytes(x, PLY_format::LITTLE_ENDIAN_BYTES, m_body);
  }

  void add_index(const std::size_t i)
  {
    append_bytes(static_cast<std::int32_t>(i), PLY_format::LITTLE_ENDIAN_BYTES, m_body);
  }

  std::string m_body;
  std::size_t m_number_of_points = 0, m_number_of_faces = 0, m_number_of_edges = 0;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_MESH_TEXTS_H
