# What the folders of tests use in common, in a build of the whole project.

# A test, run in its folder; the environment names a folder with more data.
function(seamless_snapping_test name)
  add_test(NAME ${name} COMMAND "${${name}_COMMAND}"
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
  set_tests_properties(${name} PROPERTIES LABELS "${PROJECT_NAME}" TIMEOUT 1500
    ENVIRONMENT "SEAMLESS_SNAPPING_DATA_DIR=${SEAMLESS_SNAPPING_DATA_DIR}")
endfunction()

# Tests that share much are compiled together, as tests_of_GROUP; with the precompiled PARTS, and
# with EXAMPLES of the package. A compiler takes up to 4 GB for each group.
function(seamless_snapping_tests group parts)
  cmake_parse_arguments(PARSE_ARGV 2 with "" "" EXAMPLES)
  get_filename_component(folder "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  set(examples ${with_EXAMPLES})
  list(TRANSFORM examples REPLACE "(.+)" "../../examples/${folder}/\\1.cpp")
  if(NOT SEAMLESS_SNAPPING_BUILD_EXAMPLES OR SEAMLESS_SNAPPING_SEPARATE_PROGRAMS OR WIN32)
    set(examples "") # or they are compiled in their own folder
  endif()
  string(REGEX REPLACE "_Tests$" "" prefix "${PROJECT_NAME}")
  string(TOLOWER "test_${prefix}_" prefix)
  set(sources ${with_UNPARSED_ARGUMENTS})
  list(TRANSFORM sources REPLACE "(.+)" "${prefix}\\1.cpp")
  seamless_snapping_programs(tests_of_${group} "${parts}" ${sources} ${examples})
  foreach(name IN LISTS with_UNPARSED_ARGUMENTS)
    seamless_snapping_test(${prefix}${name})
  endforeach()
endfunction()
