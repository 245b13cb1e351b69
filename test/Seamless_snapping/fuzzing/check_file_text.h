// What must hold of any text that is taken for a file: it is refused, and the mesh is untouched; or
// it is read as a valid mesh, which comes back whole when it is written.

#ifndef SEAMLESS_SNAPPING_TEST_CHECK_FILE_TEXT_H
#define SEAMLESS_SNAPPING_TEST_CHECK_FILE_TEXT_H

#include "../obj_models.h"

#include <CGAL/Seamless_snapping/IO/PLY.h>

#include <cstddef>
#include <sstream>
#include <string>

enum class File_format { OBJ, PLY };

inline SS::IO::File_status read_text(const std::string& text, const File_format format,
                                     const bool weld, Surface_model& model)
{
  std::istringstream is(text);
  const auto np = SS::parameters::edge_is_constrained_map(model.feature_map).weld_borders(weld);
  return format == File_format::OBJ ? SS::IO::read_OBJ(is, model.mesh, model.uv_map, np)
                                    : SS::IO::read_PLY(is, model.mesh, model.uv_map, np);
}

inline std::string written_text(const File_format format, const Surface_model& model)
{
  std::ostringstream os;
  const auto np = SS::parameters::edge_is_constrained_map(model.feature_map);
  CHECK(format == File_format::OBJ ? SS::IO::write_OBJ(os, model.mesh, model.uv_map, np)
                                   : SS::IO::write_PLY(os, model.mesh, model.uv_map, np));
  return os.str();
}

// Coordinates that make some corners differ, and others agree.
inline void change_uvs(Surface_model& model)
{
  std::size_t i = 0;
  for(const auto f : faces(model.mesh))
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, model.mesh), model.mesh))
      if(++i % 3 != 0)
        put(model.uv_map, h, Kernel::Point_2(double(i * i % 7) / 10, i % 5 == 0 ? 1e300 : -0.));
}

// Returns whether the text was read.
inline bool check_file_text(const std::string& text, const File_format format, const bool weld)
{
  Surface_model model;
  if(!read_text(text, format, weld, model)) {
    CHECK(model.mesh.is_empty());
    return false;
  }
  for(int i = 0; i < 2; ++i) {
    Surface_model again;
    CHECK(read_text(written_text(format, model), format, false, again));
    CHECK(content(again) == content(model));
    change_uvs(model);
  }
  CHECK(is_valid_but_for_isolated_vertices(model.mesh));
  return true;
}

#endif // SEAMLESS_SNAPPING_TEST_CHECK_FILE_TEXT_H
