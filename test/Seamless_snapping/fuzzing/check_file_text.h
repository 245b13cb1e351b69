// What must hold of any text that is taken for a file: it is refused, and the mesh is untouched; or
// it is read as a valid mesh, which comes back whole however it is written.

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

inline std::string rewritten_text(const std::string& text, const File_format format,
                                  const bool weld, const Surface_model& model)
{
  std::istringstream is(text);
  std::ostringstream os;
  const auto np = SS::parameters::weld_borders(weld);
  const SS::IO::File_status status =
    format == File_format::OBJ ? SS::IO::rewrite_OBJ(is, os, model.mesh, model.uv_map, np)
                               : SS::IO::rewrite_PLY(is, os, model.mesh, model.uv_map, np);
  CHECK_EQUAL(status.message, "");
  return os.str();
}

inline std::string written_text(const File_format format, const Surface_model& model)
{
  std::ostringstream os;
  const auto np = SS::parameters::edge_is_constrained_map(model.feature_map);
  CHECK(format == File_format::OBJ ? SS::IO::write_OBJ(os, model.mesh, model.uv_map, np)
                                   : SS::IO::write_PLY(os, model.mesh, model.uv_map, np));
  return os.str();
}

// Points of corners and coordinates in the order of faces, whatever the vertices are.
inline std::vector<std::uint64_t> corners(const Surface_model& model)
{
  std::vector<std::uint64_t> result;
  for(const auto f : faces(model.mesh))
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, model.mesh), model.mesh)) {
      const auto p = model.mesh.point(target(h, model.mesh));
      const auto uv = get(model.uv_map, h);
      result.insert(result.end(), {bits(p.x()), bits(p.y()), bits(p.z()), bits(uv.x()),
                                   bits(uv.y())});
    }
  return result;
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
  if(!weld)
    CHECK_EQUAL(rewritten_text(text, format, weld, model), text);
  for(int i = 0; i < 2; ++i) {
    Surface_model again, rewritten;
    CHECK(read_text(written_text(format, model), format, false, again));
    CHECK(content(again) == content(model));
    CHECK(read_text(rewritten_text(text, format, weld, model), format, false, rewritten));
    CHECK(corners(rewritten) == corners(model));
    CHECK_EQUAL(content(rewritten).features.size(), content(model).features.size());
    change_uvs(model);
  }
  CHECK(is_valid_but_for_isolated_vertices(model.mesh));
  return true;
}

#endif // SEAMLESS_SNAPPING_TEST_CHECK_FILE_TEXT_H
