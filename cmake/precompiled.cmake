# What most programs include, precompiled; and compiled once, what is the same in most of them: the
# mesh, readers of files, what does not depend on types, and the functions on surfaces for the types
# that most use.

# Of the library's sources, remeshing.cpp stands in for that of quads.
set(library_sources ${Seamless_snapping_compiled_SOURCES})
list(FILTER library_sources EXCLUDE REGEX "/quads\\.cpp$")
set(precompiled mesh)
if(SEAMLESS_SNAPPING_WITH_SEAMLESS_SNAPPING)
  list(APPEND precompiled files surface)
endif()
list(TRANSFORM precompiled PREPEND "${PROJECT_SOURCE_DIR}/cmake/precompiled/")
set(precompiled_headers ${precompiled})
list(TRANSFORM precompiled_headers APPEND .h)
list(TRANSFORM precompiled APPEND .cpp)
add_library(seamless_snapping_precompiled OBJECT ${library_sources} ${precompiled})
seamless_snapping_options(seamless_snapping_precompiled)
target_compile_definitions(seamless_snapping_precompiled
  PUBLIC CGAL_SEAMLESS_SNAPPING_COMPILED)
# Short sources are compiled together: to load the precompiled headers takes several seconds.
set_target_properties(seamless_snapping_precompiled PROPERTIES
  UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
set_source_files_properties(${precompiled} PROPERTIES UNITY_GROUP of_surfaces)
set(short_sources ${library_sources})
list(FILTER short_sources INCLUDE REGEX "/(linear|surfaces|layouts|volumes|hexahedra)\\.cpp$")
set_source_files_properties(${short_sources} PROPERTIES UNITY_GROUP of_library)
# All programs have the same definitions, hence the same headers: some run in parallel.
find_package(TBB QUIET)
include(CGAL_TBB_support)
if(TARGET CGAL::TBB_support)
  target_link_libraries(seamless_snapping_precompiled PUBLIC CGAL::TBB_support)
endif()
target_precompile_headers(seamless_snapping_precompiled PRIVATE
  <CGAL/Exact_integer.h>
  <CGAL/Exact_rational.h>
  <CGAL/Named_function_parameters.h>
  <CGAL/Simple_cartesian.h>
  <CGAL/Surface_mesh.h>
  <CGAL/boost/graph/generators.h>
  <CGAL/boost/graph/helpers.h>
  <Eigen/Sparse>
  <algorithm>
  <iostream>
  <map>
  <random>
  <sstream>
  <string>
  <vector>
  ${precompiled_headers})

function(seamless_snapping_use_precompiled target)
  target_precompile_headers(${target} REUSE_FROM seamless_snapping_precompiled)
  target_link_libraries(${target} PRIVATE seamless_snapping_precompiled)
endfunction()

# What only a few programs share.
if(SEAMLESS_SNAPPING_WITH_QUAD_REMESHING)
  add_library(seamless_snapping_remeshing OBJECT
    "${PROJECT_SOURCE_DIR}/cmake/precompiled/remeshing.cpp")
  seamless_snapping_options(seamless_snapping_remeshing)
  seamless_snapping_use_precompiled(seamless_snapping_remeshing)
endif()

# For sources of a target that share such parts. They include their headers, which would take time
# in all others; as these have to follow the precompiled headers, no option of the compiler includes
# them.
function(seamless_snapping_share target parts)
  set(includes "")
  foreach(part IN LISTS parts)
    target_link_libraries(${target} PRIVATE seamless_snapping_${part})
    string(APPEND includes
      "#include \"${Seamless_snapping_SOURCE_DIR}/cmake/precompiled/${part}.h\"\n")
  endforeach()
  list(JOIN parts "_and_" name)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS ARGN)
    set(unit "${CMAKE_CURRENT_BINARY_DIR}/with_${name}/${source}")
    file(GENERATE OUTPUT "${unit}" CONTENT
      "${includes}#include \"${CMAKE_CURRENT_SOURCE_DIR}/${source}\"\n")
    set_source_files_properties("${unit}" PROPERTIES UNITY_GROUP with_${name})
    list(REMOVE_ITEM sources "${source}")
    list(APPEND sources "${unit}")
  endforeach()
  set_target_properties(${target} PROPERTIES SOURCES "${sources}")
endfunction()
