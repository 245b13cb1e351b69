# Compiles and runs the test of rounding with each compiler at each level of optimization. Run by
# ctest, with the variables that package_tests.cmake passes.

foreach(compiler IN LISTS COMPILERS)
  foreach(level IN ITEMS 0 1 2 3)
    set(program "${WORK_DIR}/rounding_O${level}")
    execute_process(
      COMMAND "${compiler}" -std=c++17 -O${level} -DNDEBUG -I "${INCLUDE_DIR}" "${SOURCE}"
              -o "${program}"
      RESULT_VARIABLE compiled)
    execute_process(COMMAND "${program}" RESULT_VARIABLE passed)
    if(NOT compiled EQUAL 0 OR NOT passed EQUAL 0)
      message(FATAL_ERROR "failed: ${compiler} -O${level}")
    endif()
  endforeach()
endforeach()
