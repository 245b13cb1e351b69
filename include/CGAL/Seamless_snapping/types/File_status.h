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

#ifndef CGAL_SEAMLESS_SNAPPING_TYPES_FILE_STATUS_H
#define CGAL_SEAMLESS_SNAPPING_TYPES_FILE_STATUS_H

#include <CGAL/license/Seamless_snapping.h>

// The result of functions that read and write files.

#include <CGAL/Linear_snapping/types/Message.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

inline std::string note_on_coinciding_border_edges(const std::size_t number)
{
  return (number == 1 ? std::string("1 border edge coincides with others")
                      : std::to_string(number) + " border edges coincide") +
         ": is this a mesh that was cut open?";
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgSeamlessSnappingIO

The status of functions that read and write files. It converts to `true` if and only if the mesh was
read or written completely.

\code{.cpp}
const auto status = CGAL::Seamless_snapping::IO::read_OBJ("torus.obj", tmesh, uv_map);
if(!status)
  std::cerr << status.message << std::endl; // line 17: face has 4 corners; triangulate ...
\endcode
*/
struct File_status
{
  Message message;      ///< empty on success; else the fault and the line
  std::size_t line = 0; ///< the number of the faulty line, from 1; 0 if the fault is in no line
  /*!
  The number of vertices that the reader added because the faces around a vertex of the file form
  several fans.
  */
  std::size_t number_of_split_vertices = 0;
  /*!
  The number of edges that the reader welded: pairs of border edges of the file between the same
  points.
  */
  std::size_t number_of_welded_edges = 0;
  /*!
  The number of border edges of the new mesh that lie between the same two points as another border
  edge. If there are any, the mesh was possibly cut open along its seams. The parameter
  `weld_borders` closes them.
  */
  std::size_t number_of_coinciding_border_edges = 0;

  /// returns `true` if and only if the mesh was read or written completely.
  explicit operator bool() const { return message.empty(); }
};

/*!
\ingroup PkgSeamlessSnappingIO
writes the message on failure; else "ok", and a note on coinciding border edges, if there are any.
*/
inline std::ostream& operator<<(std::ostream& os, const File_status& status)
{
  if(!status)
    return os << status.message;
  os << "ok";
  if(status.number_of_coinciding_border_edges > 0)
    os << "; "
       << internal::note_on_coinciding_border_edges(status.number_of_coinciding_border_edges);
  return os;
}

} // namespace IO
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_TYPES_FILE_STATUS_H
