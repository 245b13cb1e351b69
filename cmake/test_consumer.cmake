# Builds and runs a program in the project test/Seamless_snapping/consumer: with the installed
# packages a short one; the last program of README.md with the lowest package alone, as a
# sub-folder, without GMP. Run by ctest, with the variables that package_tests.cmake passes.

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}\n${out}${err}")
  endif()
  set(out "${out}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
set(without_gmp "")
if(WAY STREQUAL "installed")
  run("${CMAKE_COMMAND}" --install "${PACKAGE_BINARY_DIR}" --prefix "${WORK_DIR}/prefix"
    --component Seamless_snapping_headers)
  set(package "-DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix")
  set(source "${PACKAGE_SOURCE_DIR}/test/Seamless_snapping/consumer/check_square.cpp")
  set(expected "exactly seamless\n")
  file(GLOB_RECURSE licences "${WORK_DIR}/prefix/*/LICENSE")
  if(licences STREQUAL "")
    message(SEND_ERROR "the licence is not installed")
  endif()
else()
  file(READ "${PACKAGE_SOURCE_DIR}/README.md" text)
  string(FIND "${text}" "\n```cpp\n" begin REVERSE)
  string(SUBSTRING "${text}" ${begin} -1 text)
  if(NOT text MATCHES "^\n```cpp\n([^`]*)```\n\n```text\n([^`]*)```")
    message(FATAL_ERROR "README.md lacks a program and what it prints")
  endif()
  set(expected "${CMAKE_MATCH_2}")
  set(source "${WORK_DIR}/app.cpp")
  file(WRITE "${source}" "${CMAKE_MATCH_1}")
  set(package "-DPACKAGE_SOURCE_DIR=${PACKAGE_SOURCE_DIR}")
  set(without_gmp -DCGAL_DISABLE_GMP=ON)
  string(APPEND CXX_FLAGS " -DCMAKE_OVERRIDDEN_DEFAULT_ENT_BACKEND=BOOST_BACKEND")
endif()

run("${CMAKE_COMMAND}"
  -S "${PACKAGE_SOURCE_DIR}/test/Seamless_snapping/consumer"
  -B "${WORK_DIR}/build"
  "-DSOURCE=${source}"
  -G "${GENERATOR}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
  "-DCGAL_DIR=${CGAL_DIR}"
  -DCMAKE_BUILD_TYPE=Debug # with all assertions of CGAL, but no need of a debugger
  -DCMAKE_CXX_FLAGS_DEBUG=
  -DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON
  "${package}" ${without_gmp})
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build")
run("${WORK_DIR}/build/app")
if(NOT out STREQUAL expected)
  message(SEND_ERROR "the program prints\n${out}instead of\n${expected}")
endif()

# Nothing of a sub-folder is installed with the project, unless it asks for that.
if(WAY STREQUAL "subdirectory")
  foreach(install IN ITEMS OFF ON)
    run("${CMAKE_COMMAND}" -S "${PACKAGE_SOURCE_DIR}/test/Seamless_snapping/consumer"
      -B "${WORK_DIR}/build" -DSEAMLESS_SNAPPING_INSTALL=${install})
    run("${CMAKE_COMMAND}" --install "${WORK_DIR}/build" --prefix "${WORK_DIR}/${install}")
    set(header "${WORK_DIR}/${install}/include/CGAL/Linear_snapping/snap_to_linear_constraints.h")
    if(NOT EXISTS "${WORK_DIR}/${install}/bin/app")
      message(SEND_ERROR "the program of the project is not installed")
    endif()
    if((install AND NOT EXISTS "${header}") OR (NOT install AND EXISTS "${header}"))
      message(SEND_ERROR "SEAMLESS_SNAPPING_INSTALL=${install} has no effect")
    endif()
    if(EXISTS "${WORK_DIR}/${install}/include/CGAL/Seamless_snapping")
      message(SEND_ERROR "headers of a package that is left out are installed")
    endif()
  endforeach()
endif()
