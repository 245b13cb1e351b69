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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_POINT_STARS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_POINT_STARS_H

#include <CGAL/license/Seamless_snapping.h>

// The mesh for repairs of orientations: the faces around the points of the domain whose coordinates
// repairs may change. To the steps of repairs, faces are triples of indices; the mesh is
// read when they ask, and nowhere else.

#include <CGAL/Linear_snapping/internal/exact/Uv.h>
#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Sectors, and vertices that belong to none: first the sectors, then the other vertices in the
// order in which they are met.
using Point_index = Sector_index;
using Face_index = std::int32_t; // in the order in which they are met

// Coordinates of points under way. Points that were met later have the coordinates of the input.
using Uv_state = std::vector<Uv>;

// A face as it was in the input.
struct Domain_face
{
  std::array<Point_index, 3> points; // counterclockwise
  Uv_triangle input;
  bool was_positive;
};

// A face, and which of its corners is meant.
struct Face_corner
{
  Face_index face;
  std::size_t position;
};

// Invariant: the points of faces that were met have indices below `size()`.
class Point_stars
{
public:
  explicit Point_stars(const std::size_t number_of_sectors)
    : m_number_of_sectors(number_of_sectors)
  { }

  Point_stars(const Point_stars&) = delete;
  Point_stars& operator=(const Point_stars&) = delete;
  virtual ~Point_stars() = default;

  std::size_t number_of_sectors() const { return m_number_of_sectors; }
  std::size_t size() const { return m_number_of_sectors + m_free_inputs.size(); }
  std::size_t number_of_faces() const { return m_faces.size(); } // that were met
  const Domain_face& domain_face(const Face_index f) const { return m_faces[std::size_t(f)]; }

  // \pre p is not a sector
  const Uv& free_input(const Point_index p) const
  { return m_free_inputs[std::size_t(p) - m_number_of_sectors]; }

  // The corners of a point. Meets their faces.
  virtual std::vector<Face_corner> star(Point_index p) = 0;

  // Faces at sectors that may lose their positive orientation, or have none, when no coordinate
  // moves by more than `reach`; some come several times.
  virtual std::vector<Face_index> faces_at_risk(double reach) = 0;

  // All faces that may not be positive.
  virtual std::vector<Face_index> possible_flips() = 0;

  // Meets all faces.
  virtual void meet_all_faces() = 0;

  // The largest change of a functional, and so of a coordinate, of a corner of a sector.
  virtual double largest_move(const Uv_state& state) const = 0;

  // The numbers of some faces in the order of iteration over all faces of the mesh.
  virtual std::vector<std::size_t> numbers_in_mesh(const std::vector<Face_index>& some) const = 0;

protected:
  std::vector<Domain_face> m_faces;
  std::vector<Uv> m_free_inputs; // per point that is not a sector

private:
  std::size_t m_number_of_sectors;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_ORIENTATION_POINT_STARS_H
