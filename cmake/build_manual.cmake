# Builds the manuals into OUTPUT_DIR; any warning is an error. Run by ctest.

if(NOT DOXYGEN)
  message("SKIPPED: doxygen is not installed")
  return()
endif()

find_program(PERL perl) # runs outside_of_CGAL/filter.pl
if(NOT PERL)
  message("SKIPPED: perl is not installed")
  return()
endif()

file(MAKE_DIRECTORY "${OUTPUT_DIR}")
execute_process(
  COMMAND "${CMAKE_COMMAND}" -E env "SEAMLESS_SNAPPING_MANUAL_DIR=${OUTPUT_DIR}" "${DOXYGEN}"
  WORKING_DIRECTORY "${PACKAGE_SOURCE_DIR}/doc"
  RESULT_VARIABLE result OUTPUT_QUIET)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "doxygen warned, or failed")
endif()
