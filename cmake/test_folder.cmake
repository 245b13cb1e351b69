# What the folders of tests use in common, in a build of the whole project.

# A test, run in its folder; the environment names a folder with more data.
function(seamless_snapping_test name)
  add_test(NAME ${name} COMMAND "${${name}_COMMAND}"
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
  set_tests_properties(${name} PROPERTIES LABELS "${PROJECT_NAME}" TIMEOUT 1500
    ENVIRONMENT "SEAMLESS_SNAPPING_DATA_DIR=${SEAMLESS_SNAPPING_DATA_DIR}")
endfunction()

# Tests that share much are compiled together, as tests_of_GROUP; with precompiled PART, if it is
# not empty. A compiler takes up to 2.5 GB for each group.
function(seamless_snapping_tests group part)
  string(REGEX REPLACE "_Tests$" "" prefix "${PROJECT_NAME}")
  string(TOLOWER "test_${prefix}_" prefix)
  set(sources ${ARGN})
  list(TRANSFORM sources REPLACE "(.+)" "${prefix}\\1.cpp")
  seamless_snapping_programs(tests_of_${group} "${part}" ${sources})
  foreach(name IN LISTS ARGN)
    seamless_snapping_test(${prefix}${name})
  endforeach()
endfunction()
