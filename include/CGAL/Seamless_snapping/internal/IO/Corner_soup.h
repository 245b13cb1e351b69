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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_CORNER_SOUP_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_CORNER_SOUP_H

#include <CGAL/license/Seamless_snapping.h>

// The content of a file, in any format: points, coordinates, faces, and polylines, with their
// lines.

#include <CGAL/Seamless_snapping/types/File_status.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The index of a point, coordinates, or a line. It is half as long as an address, because the first
// access to memory takes as much time as parsing in large files.
using Soup_index = std::uint32_t;
constexpr Soup_index largest_soup_index = static_cast<Soup_index>(-2); // -1 stands for none

// A segment of a polyline. All indices count from 0.
struct Soup_segment
{
  std::array<std::size_t, 2> vertices;
  std::size_t line; // counted from 1; 0 in files that are not made of lines
};

template <typename PointNumber, typename UVNumber>
struct Corner_soup
{
  struct Triangle
  {
    std::array<Soup_index, 3> vertices;
    std::array<Soup_index, 3> uvs;
    Soup_index line; // 0 in files that are not made of lines
  };

  std::vector<std::array<PointNumber, 3> > points;
  std::vector<std::array<UVNumber, 2> > uvs;
  std::vector<Triangle> triangles;
  std::vector<Soup_segment> segments;
  std::vector<std::size_t> vertex_names; // for messages, per point; empty: as in the file

  const std::vector<Triangle>& faces() const { return triangles; }
};

// Without coordinates, and with faces of any number of corners: plain meshes.
template <>
struct Corner_soup<double, void>
{
  struct Polygon
  {
    std::vector<std::size_t> vertices;
    std::size_t line = 0;
  };

  std::vector<std::array<double, 3> > points;
  std::vector<Polygon> polygons;
  std::vector<Soup_segment> segments;

  const auto& faces() const { return polygons; }
};

// The changes of the vertices, and changes that would have been possible.
struct Vertex_changes : IO::File_status
{
  std::vector<std::size_t> file_vertices; // the index in the file of each new vertex of the mesh
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_CORNER_SOUP_H
