# What the compiler says of meshes and maps that public functions can't take, and of named
# parameters that do nothing: the remedy, once for each of test/Seamless_snapping/refused_types, and
# no other error. Run by ctest, with the variables SOURCE, COMPILER and OPTIONS.

cmake_minimum_required(VERSION 3.16...3.29)

execute_process(COMMAND "${CMAKE_COMMAND}" -E env LC_ALL=C "${COMPILER}" ${OPTIONS} -w "${SOURCE}"
  RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
if(status EQUAL 0)
  message(FATAL_ERROR "it compiles")
endif()
string(REGEX MATCHALL "error: [^\n]*" errors "${out}")
set(expected
  "pass the underlying mesh, with get\\(uv, target\\(hd\\(h\\), seam_mesh\\)\\.hd\\)"
  "the uv map must be a property map"
  "the keys of the uv map must be halfedges of the mesh"
  "the values of the uv map must be two-dimensional points of a kernel"
  "the values of the uv map must be two-dimensional points of a kernel"
  "the values of the uv map must be two-dimensional points of a kernel"
  "rounding_tolerance is for integer_grid: give that, too"
  "number_of_untangling_iterations is for repair_flips: give that, too"
  "repair_flips takes a Flip_repair or a bool, not a number")
list(LENGTH errors number)
list(LENGTH expected expected_number)
if(NOT number EQUAL expected_number)
  message(FATAL_ERROR "${number} errors:\n${out}")
endif()
foreach(i RANGE 1 ${number})
  math(EXPR i "${i} - 1")
  list(GET errors ${i} error)
  list(GET expected ${i} message)
  if(NOT error MATCHES "static.assert.*${message}")
    message(SEND_ERROR "no '${message}': ${error}")
  endif()
endforeach()
