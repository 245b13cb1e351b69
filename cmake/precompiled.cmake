# What most programs include, precompiled; and compiled once, the solver, which is the same in all
# of them, and the functions on surfaces for the types that most of them use.

add_library(seamless_snapping_precompiled OBJECT
  "${PROJECT_SOURCE_DIR}/cmake/precompiled/files.cpp"
  "${PROJECT_SOURCE_DIR}/cmake/precompiled/mesh.cpp"
  "${PROJECT_SOURCE_DIR}/cmake/precompiled/remeshing.cpp"
  "${PROJECT_SOURCE_DIR}/cmake/precompiled/solver.cpp"
  "${PROJECT_SOURCE_DIR}/cmake/precompiled/surface.cpp"
  "${PROJECT_SOURCE_DIR}/cmake/precompiled/symmetries.cpp")
seamless_snapping_options(seamless_snapping_precompiled)
# All programs have the same definitions, hence the same headers: some run in parallel.
find_package(TBB QUIET)
include(CGAL_TBB_support)
if(TARGET CGAL::TBB_support)
  target_link_libraries(seamless_snapping_precompiled PUBLIC CGAL::TBB_support)
endif()
target_precompile_headers(seamless_snapping_precompiled PRIVATE
  <CGAL/Exact_integer.h>
  <CGAL/Exact_predicates_inexact_constructions_kernel.h>
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
  "${PROJECT_SOURCE_DIR}/cmake/precompiled/mesh.h"
  "${PROJECT_SOURCE_DIR}/cmake/precompiled/files.h"
  "${PROJECT_SOURCE_DIR}/cmake/precompiled/solver.h"
  "${PROJECT_SOURCE_DIR}/cmake/precompiled/surface.h")

function(seamless_snapping_use_precompiled target)
  target_precompile_headers(${target} REUSE_FROM seamless_snapping_precompiled)
  target_link_libraries(${target} PRIVATE seamless_snapping_precompiled)
endfunction()

# For sources of a target that share what only a few programs need: it is in the library, and they
# include its header, which would take time in all others. It has to be included after the
# precompiled headers, which no option of the compiler does.
function(seamless_snapping_share target header)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS ARGN)
    set(unit "${CMAKE_CURRENT_BINARY_DIR}/with_${header}/${source}")
    file(GENERATE OUTPUT "${unit}" CONTENT
      "#include \"${Seamless_snapping_SOURCE_DIR}/cmake/precompiled/${header}.h\"\n\
#include \"${CMAKE_CURRENT_SOURCE_DIR}/${source}\"\n")
    list(REMOVE_ITEM sources "${source}")
    list(APPEND sources "${unit}")
  endforeach()
  set_target_properties(${target} PROPERTIES SOURCES "${sources}")
endfunction()
