# Builds and runs test/Seamless_snapping/consumer against the installed package, or with the package
# as a sub-folder. Run by ctest, with the variables that package_tests.cmake passes.

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
if(WAY STREQUAL "installed")
  run("${CMAKE_COMMAND}" --install "${PACKAGE_BINARY_DIR}" --prefix "${WORK_DIR}/prefix")
  set(package "-DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix")
else()
  set(package "-DPACKAGE_SOURCE_DIR=${PACKAGE_SOURCE_DIR}")
endif()

run("${CMAKE_COMMAND}"
  -S "${PACKAGE_SOURCE_DIR}/test/Seamless_snapping/consumer"
  -B "${WORK_DIR}/build"
  -G "${GENERATOR}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
  "-DCGAL_DIR=${CGAL_DIR}"
  -DCMAKE_BUILD_TYPE=Debug
  -DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON
  "${package}")
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build")
run("${WORK_DIR}/build/consumer")
