// A map of six directions that others have made, not of hexagonal_maps.h.

#ifndef SEAMLESS_SNAPPING_TEST_HEXAGONAL_DATA_H
#define SEAMLESS_SNAPPING_TEST_HEXAGONAL_DATA_H

#include "checking.h"
#include "hexagonal_maps.h"
#include "test_data.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

namespace hexagonal_maps {

// A torus, not snapped, in lattice coordinates. Returns false if there is no data.
inline bool read_torus(Mesh& mesh, const UV_map& uv)
{
  const auto path =
    test_data::further_data("uv/dir_torus_hexparam_translations.obj", "a torus with N = 6");
  if(path.empty())
    return false;
  CHECK(CGAL::Seamless_snapping::IO::read_OBJ(path.string(), mesh, uv));
  CGAL::Seamless_snapping::convert_to_lattice_coordinates(mesh, uv);
  return true;
}

} // namespace hexagonal_maps

#endif
