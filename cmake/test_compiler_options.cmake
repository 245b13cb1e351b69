# Compiles and runs what depends on the compiler's options most, with each compiler. Run by ctest,
# with the variables that package_tests.cmake passes.

# Sets `result` to how the program ended: PASSED, FAILED, or REFUSED, by the compiler or at run
# time.
function(try result compiler)
  set(executable "${WORK_DIR}/compiler_options")
  execute_process(
    COMMAND "${compiler}" -std=c++17 -DNDEBUG -Wfatal-errors ${ARGN} -I "${INCLUDE_DIR}"
            "${TEST_DIR}/test_linear_snapping_arithmetic.cpp" -o "${executable}"
    RESULT_VARIABLE compiled ERROR_VARIABLE messages)
  set(how FAILED)
  if(NOT compiled EQUAL 0)
    if(messages MATCHES "compile without them")
      set(how REFUSED)
    endif()
  else()
    execute_process(COMMAND "${executable}" RESULT_VARIABLE status OUTPUT_VARIABLE messages)
    if(status EQUAL 0)
      set(how PASSED)
    elseif(status EQUAL 3)
      set(how REFUSED)
    endif()
  endif()
  if(how STREQUAL FAILED)
    message("${messages}")
  endif()
  set(${result} ${how} PARENT_SCOPE)
endfunction()

function(expect expected compiler)
  try(result "${compiler}" ${ARGN})
  message(STATUS "${compiler} ${ARGN}: ${result}")
  if(NOT result STREQUAL expected)
    message(SEND_ERROR "expected: ${expected}")
  endif()
endfunction()

foreach(compiler IN LISTS COMPILERS)
  # Exact differences and rounding survive the usual options, and are refused with those that break
  # them.
  foreach(level IN ITEMS 0 1 2 3)
    expect(PASSED "${compiler}" -O${level})
  endforeach()
  expect(PASSED "${compiler}" -O3 -march=native -ffp-contract=fast)
  foreach(option IN ITEMS -ffast-math -ffinite-math-only -funsafe-math-optimizations)
    expect(REFUSED "${compiler}" -O2 ${option})
  endforeach()
  if(PROCESSOR MATCHES "x86_64|AMD64" AND NOT compiler MATCHES "clang")
    expect(REFUSED "${compiler}" -O2 -mfpmath=387)
  endif()
endforeach()
