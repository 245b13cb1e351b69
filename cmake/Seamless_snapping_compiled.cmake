# The target Seamless_snapping::compiled, a library of what does not depend on the types of meshes
# and coordinates: programs that link it compile the rest only. It is built where it is linked.
# The linker takes what a program calls: each line here is a source of its own.

set(Linear_snapping_parts linear)
set(Seamless_snapping_parts surfaces volumes)
set(Isocurves_and_layouts_parts layouts)
set(Quad_remeshing_parts quads)
set(Hexahedral_meshing_parts hexahedra)
set(linear Linear_snapping/internal/exact/Uv
  Linear_snapping/internal/linear/Linear_solver
  Linear_snapping/internal/linear/System_builder
  Linear_snapping/internal/linear/snap_values
  Linear_snapping/types/Message)
set(surfaces Seamless_snapping/internal/complex/Free_unknowns
  Seamless_snapping/internal/mesh/estimate_seams
  Seamless_snapping/internal/mesh/hint_on_symmetry
  Seamless_snapping/internal/snapping/snap_flat_surface
  Seamless_snapping/internal/snapping/solve_complex)
set(volumes Seamless_snapping/internal/volume/volume_snappers)
set(layouts Isocurves_and_layouts/internal/layout/make_layout)
set(quads Quad_remeshing/internal/quantization/quantize_surface
  Quad_remeshing/internal/quad_remesh)
set(hexahedra Hexahedral_meshing/internal/hexahedra/extract
  Hexahedral_meshing/internal/shape/move_vertices)

if(NOT TARGET Seamless_snapping_compiled)
  set(Seamless_snapping_compiled_SOURCES "")
  set(parts "")
  foreach(package IN ITEMS Linear_snapping Seamless_snapping Isocurves_and_layouts Quad_remeshing
      Hexahedral_meshing)
    if(TARGET Seamless_snapping::${package})
      list(APPEND parts ${${package}_parts})
      set(last_package Seamless_snapping::${package})
    endif()
  endforeach()
  foreach(part IN LISTS parts)
    list(TRANSFORM ${part} REPLACE
      "(.+)" "#include <CGAL/\\1_impl.h>\n" OUTPUT_VARIABLE includes)
    list(JOIN includes "" includes)
    set(source "${CMAKE_CURRENT_BINARY_DIR}/Seamless_snapping_compiled/${part}.cpp")
    file(GENERATE OUTPUT "${source}" CONTENT "${includes}")
    list(APPEND Seamless_snapping_compiled_SOURCES "${source}")
  endforeach()
  add_library(Seamless_snapping_compiled STATIC EXCLUDE_FROM_ALL
    ${Seamless_snapping_compiled_SOURCES})
  add_library(Seamless_snapping::compiled ALIAS Seamless_snapping_compiled)
  target_link_libraries(Seamless_snapping_compiled PUBLIC ${last_package})
  if(TARGET Seamless_snapping::SuiteSparse_support)
    target_link_libraries(Seamless_snapping_compiled PUBLIC Seamless_snapping::SuiteSparse_support)
  endif()
  target_compile_definitions(Seamless_snapping_compiled PUBLIC CGAL_SEAMLESS_SNAPPING_COMPILED)
endif()
