# What most programs include, and the solver, which is the same in all of them, compiled once for programs
# that are optimized and once for those that are compiled faster: functions of precompiled headers keep the
# optimization they were compiled with.

function(add_precompiled target)
  add_library(${target} OBJECT "${PROJECT_SOURCE_DIR}/cmake/precompiled/solver.cpp")
  seamless_snapping_options(${target})
  target_precompile_headers(${target} PRIVATE
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
    "${PROJECT_SOURCE_DIR}/cmake/precompiled/solver.h")
endfunction()

add_precompiled(seamless_snapping_precompiled)
add_precompiled(seamless_snapping_precompiled_faster)
seamless_snapping_compile_faster(seamless_snapping_precompiled_faster)

# For a program of the usual options, with those of seamless_snapping_compile_faster() if it is FASTER.
function(seamless_snapping_use_precompiled target)
  set(precompiled seamless_snapping_precompiled)
  if("FASTER" IN_LIST ARGN)
    string(APPEND precompiled _faster)
    seamless_snapping_compile_faster(${target})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${precompiled})
  target_link_libraries(${target} PRIVATE ${precompiled})
endfunction()
