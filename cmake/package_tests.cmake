# Tests of the package as a whole: its programs, headers, installation, manual and form. Those with
# a COST take long: they start early, so that no other test has to wait for them in the end.

# Everything builds, also what no other test runs. No other test runs meanwhile.
add_test(NAME build COMMAND "${CMAKE_COMMAND}" --build "${PROJECT_BINARY_DIR}" --config "$<CONFIG>")
set_tests_properties(build PROPERTIES LABELS package RUN_SERIAL ON)

file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/include" include/*.h)
set(public_headers ${headers})
list(FILTER public_headers EXCLUDE REGEX "/internal/")
# The library has what these compile.
foreach(list IN ITEMS headers public_headers)
  list(FILTER ${list} EXCLUDE REGEX "_impl\\.h$")
endforeach()
if(NOT SEAMLESS_SNAPPING_CHECK_ALL_HEADERS)
  set(headers ${public_headers})
endif()

# What is included first, after the licence, is compiled as if it were alone: a header that another
# one includes so is not compiled once more. Only includes without a condition count.
set(headers_to_compile ${headers})
list(FILTER headers_to_compile EXCLUDE REGEX "^CGAL/license/")
foreach(header IN LISTS headers)
  set(file "${PROJECT_SOURCE_DIR}/include/${header}")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  file(STRINGS "${file}" directives LIMIT_COUNT 4 REGEX "^ *#")
  if(directives MATCHES "^#ifndef .*;#define .*;#include <CGAL/license/.*;#include <(CGAL/.*)>")
    list(REMOVE_ITEM headers_to_compile "${CMAKE_MATCH_1}")
  endif()
endforeach()

# What another compiler makes of headers and of programs is tested, too, where there is one.
set(compilers "${CMAKE_CXX_COMPILER}")
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(other_compiler g++)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(other_compiler clang++)
  endif()
  find_program(OTHER_COMPILER ${other_compiler})
  if(OTHER_COMPILER)
    list(APPEND compilers "${OTHER_COMPILER}")
  endif()
endif()
list(GET compilers -1 other_compiler)

# What the compiler of all programs makes of a source without code for it: with the flags of the
# precompiled headers, which are those of all programs, or these would not be taken.
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
  separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND flags -frounding-math) # as CGAL has it
  endif()
  set(target seamless_snapping_precompiled)
  set(definitions "$<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>")
  set(dirs "$<FILTER:$<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>,EXCLUDE,^/usr/include$>")
  set(syntax_check "${CMAKE_CXX_COMPILER}" -std=gnu++17 -fsyntax-only ${flags}
    "$<TARGET_PROPERTY:${target},COMPILE_OPTIONS>"
    "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>"
    "$<$<BOOL:${dirs}>:-isystem;$<JOIN:${dirs},;-isystem;>>"
    -include "${PROJECT_BINARY_DIR}/CMakeFiles/${target}.dir/cmake_pch.hxx")
endif()

# Each header compiles alone, without a warning, but for what the library holds: by clang, if it is
# there, because it takes half of the time of g++, which compiles all public headers in two_units
# below. The compiler's own folder must not be named again: <cstdlib> and its like would not be
# found any more.
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(include_dirs "$<TARGET_PROPERTY:Seamless_snapping,INTERFACE_INCLUDE_DIRECTORIES>")
  set(include_dirs
    "$<FILTER:${include_dirs},EXCLUDE,^(/usr/include|${PROJECT_SOURCE_DIR}/include)$>")
  set(definitions "$<TARGET_PROPERTY:Seamless_snapping,INTERFACE_COMPILE_DEFINITIONS>")
  set(header_compiler "${CMAKE_CXX_COMPILER}")
  set(header_options -std=c++17 -fsyntax-only -Wall -Wextra -pedantic -Wshadow
    -Wconversion -Wno-sign-conversion -Werror) # for g++, the first does not contain the second
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND OTHER_COMPILER)
    set(header_compiler "${OTHER_COMPILER}")
  else()
    list(APPEND header_options ${option_for_speed})
  endif()
  list(APPEND header_options "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>"
    "$<$<BOOL:${include_dirs}>:-isystem;$<JOIN:${include_dirs},;-isystem;>>")
  # What most of them include from elsewhere is precompiled, unless all headers are tested: then
  # nothing comes before a header.
  set(after_elsewhere "")
  if(NOT SEAMLESS_SNAPPING_CHECK_ALL_HEADERS)
    set(elsewhere CGAL/Exact_integer.h CGAL/Exact_rational.h CGAL/Named_function_parameters.h
      CGAL/boost/graph/Euler_operations.h CGAL/boost/graph/helpers.h
      CGAL/boost/graph/named_params_helper.h Eigen/SparseCholesky)
    list(TRANSFORM elsewhere REPLACE "(.+)" "#include <\\1>\n")
    list(JOIN elsewhere "" elsewhere)
    set(source "${PROJECT_BINARY_DIR}/headers/elsewhere.h")
    file(GENERATE OUTPUT "${source}" CONTENT "${elsewhere}")
    set(elsewhere_options ${header_options})
    list(REMOVE_ITEM elsewhere_options -fsyntax-only)
    # Templates that these headers use are instantiated once, and not for each header that follows.
    set(option -fpch-instantiate-templates) # of clang, from version 11 on
    execute_process(COMMAND "${header_compiler}" -Werror ${option} -fsyntax-only -x c++ /dev/null
      RESULT_VARIABLE lacks_option OUTPUT_QUIET ERROR_QUIET)
    if(NOT lacks_option)
      list(APPEND elsewhere_options ${option})
    endif()
    add_test(NAME headers_from_elsewhere
      COMMAND "${header_compiler}" "${elsewhere_options}" -x c++-header "${source}"
        -o "${source}.gch" COMMAND_EXPAND_LISTS)
    set_tests_properties(headers_from_elsewhere PROPERTIES LABELS headers COST 1000
      FIXTURES_SETUP headers_from_elsewhere)
    set(after_elsewhere -include "${source}")
  endif()

  foreach(header IN LISTS headers_to_compile)
    string(REGEX REPLACE "^CGAL/|\\.h$" "" name "${header}")
    string(REPLACE "/" "_" name "header_${name}")
    set(source "${PROJECT_BINARY_DIR}/headers/${name}.cpp")
    file(GENERATE OUTPUT "${source}" CONTENT "#include <${header}>\n")
    add_test(NAME "${name}"
      COMMAND "${header_compiler}" "${header_options}" -I "${PROJECT_SOURCE_DIR}/include"
        -DCGAL_SEAMLESS_SNAPPING_COMPILED "${after_elsewhere}" "${source}" COMMAND_EXPAND_LISTS)
    set_tests_properties("${name}" PROPERTIES LABELS headers)
    if(after_elsewhere)
      set_tests_properties("${name}" PROPERTIES FIXTURES_REQUIRED headers_from_elsewhere)
    endif()
  endforeach()

  set(folder "${PROJECT_SOURCE_DIR}/test/Seamless_snapping/refused_types")
  add_test(NAME refused_types
    COMMAND "${CMAKE_COMMAND}"
      "-DSOURCES=${folder}/refused_types.cpp;${folder}/refused_parameters.cpp"
      "-DCOMMAND=${syntax_check}"
      -P "${PROJECT_SOURCE_DIR}/cmake/test_refused_types.cmake")
  set_tests_properties(refused_types PROPERTIES LABELS headers)

  # Within CGAL, too, and all of them, with the other compiler.
  add_test(NAME into_cgal
    COMMAND "${CMAKE_COMMAND}"
      "-DPACKAGE_SOURCE_DIR=${PROJECT_SOURCE_DIR}"
      "-DWORK_DIR=${PROJECT_BINARY_DIR}/into_cgal"
      "-DINCLUDE_DIRS=${include_dirs}"
      "-DCOMPILER=${other_compiler}"
      "-DOPTIONS=-std=c++17;-Wall;-Wextra;-Werror;\
$<$<BOOL:${include_dirs}>:-isystem;$<JOIN:${include_dirs},;-isystem;>>"
      -P "${PROJECT_SOURCE_DIR}/cmake/test_into_cgal.cmake")
  set_tests_properties(into_cgal PROPERTIES LABELS package COST 900
    SKIP_REGULAR_EXPRESSION "SKIPPED")
endif()

# A benchmark prints a table that tells something in each column, but for some that may be 0. In
# tables without lines, `number` columns are numbers; it is 0 where tables have lines.
function(seamless_snapping_benchmark_table name number may_be_zero)
  if(TARGET ${name})
    add_test(NAME table_of_${name}
      COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:${name}>" "-DARGUMENTS=${ARGN}"
        "-DCOLUMNS=${number}" "-DMAY_BE_ZERO=${may_be_zero}"
        -P "${PROJECT_SOURCE_DIR}/cmake/test_benchmark.cmake")
    set_tests_properties(table_of_${name} PROPERTIES LABELS package)
  endif()
endfunction()

# The table of the manual is always tested, the others where all benchmarks are built.
set(built_benchmark dataset_statistics)
find_package(Boost QUIET COMPONENTS program_options)
if(NOT SEAMLESS_SNAPPING_BUILD_BENCHMARKS AND TARGET Boost::program_options)
  add_executable(${built_benchmark} benchmark/Seamless_snapping/${built_benchmark}.cpp)
  seamless_snapping_options(${built_benchmark})
  seamless_snapping_use_precompiled(${built_benchmark})
  target_include_directories(${built_benchmark} PRIVATE benchmark/Linear_snapping)
  target_link_libraries(${built_benchmark} PRIVATE Boost::program_options)
endif()
set(data "${PROJECT_SOURCE_DIR}/test/Seamless_snapping/data")
seamless_snapping_benchmark_table(dataset_statistics 0
  "flips;lost;still lost;flips after" "${data}" --noise 1e-7 --features)
seamless_snapping_benchmark_table(connection_growth 0 "" "${data}/genus2.obj" --repeats 1)
seamless_snapping_benchmark_table(exact_comparison 0 "bits" "${data}/genus0.obj"
  --time-limit 2)
seamless_snapping_benchmark_table(parametrization_table 0 "genus;borders;aligned;flips"
  "${data}/genus0.obj" "${data}/genus2_border.obj" --align-border)
seamless_snapping_benchmark_table(quad_comparison 0 "inverted" "${data}/genus2.obj" --quads 1000
  --blender none)
seamless_snapping_benchmark_table(remeshing_growth 0 "" "${data}/genus2.obj"
  --subdivide 0 --subdivide 1)
seamless_snapping_benchmark_table(size_table 0 "" "${data}/genus2.obj" --quads 500)
seamless_snapping_benchmark_table(tracing_speed 7 "" "${data}" --runs 1)
seamless_snapping_benchmark_table(layout_speed 8 "" "${data}/genus2.obj" --runs 1 --faces 20000
  --nodes 20)
seamless_snapping_benchmark_table(extraction_speed 7 "" "${data}/genus2.obj" --runs 1 --quads 20000
  --faces 20000 --nodes 20)
seamless_snapping_benchmark_table(volume_scaling 0 "adjacency;lost" --cubes 4 --repeats 1)

# The other benchmarks compile, where they are not built: all together.
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND NOT SEAMLESS_SNAPPING_BUILD_BENCHMARKS)
  file(GLOB benchmarks CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/benchmark/*/*.cpp")
  set(folders ${packages})
  list(TRANSFORM folders REPLACE "(.+)"
    "-I;${PROJECT_SOURCE_DIR}/benchmark/\\1;-I;${PROJECT_SOURCE_DIR}/test/\\1")
  list(FILTER benchmarks EXCLUDE REGEX "/${built_benchmark}\\.cpp$")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${benchmarks})
  set(source "${PROJECT_BINARY_DIR}/headers/benchmarks.cpp")
  execute_process(COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${source}" "-DSOURCES=${benchmarks}"
    "-DFIRST=${PROJECT_SOURCE_DIR}/cmake/precompiled/remeshing.h"
    -P "${PROJECT_SOURCE_DIR}/cmake/programs_in_one.cmake")
  add_test(NAME benchmarks COMMAND "${syntax_check}" "${folders}" "${source}"
    COMMAND_EXPAND_LISTS)
  set_tests_properties(benchmarks PROPERTIES LABELS headers COST 700)
endif()

# Two translation units that include all public headers twice go into one program: nothing is
# defined twice. As both are the same, one is a copy of the other one's object.
list(FILTER public_headers EXCLUDE REGEX "^CGAL/license/")
list(TRANSFORM public_headers REPLACE "(.+)" "#include <\\1>\n")
list(JOIN public_headers "" includes)
set(unit "${PROJECT_BINARY_DIR}/headers/two_units")
file(GENERATE OUTPUT "${unit}.cpp" CONTENT "${includes}${includes}")
file(GENERATE OUTPUT "${unit}_main.cpp" CONTENT "int main() { return 0; }\n")
add_library(seamless_snapping_all_headers OBJECT "${unit}.cpp")
seamless_snapping_options(seamless_snapping_all_headers)
seamless_snapping_use_precompiled(seamless_snapping_all_headers)
set(copy "${unit}_copy${CMAKE_CXX_OUTPUT_EXTENSION}")
add_custom_command(OUTPUT "${copy}" DEPENDS $<TARGET_OBJECTS:seamless_snapping_all_headers>
  COMMAND "${CMAKE_COMMAND}" -E copy $<TARGET_OBJECTS:seamless_snapping_all_headers> "${copy}")
set_source_files_properties("${copy}" PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
add_executable(test_seamless_snapping_two_units "${unit}_main.cpp" "${copy}"
  $<TARGET_OBJECTS:seamless_snapping_all_headers>)
target_link_libraries(test_seamless_snapping_two_units PRIVATE seamless_snapping_precompiled)
add_test(NAME test_seamless_snapping_two_units COMMAND test_seamless_snapping_two_units)
set_tests_properties(test_seamless_snapping_two_units PROPERTIES LABELS headers)

# A project of its own finds the package where it is installed, or takes it in as a sub-folder, for
# which it has the other compiler.
set(compiler_installed "${CMAKE_CXX_COMPILER}")
set(flags_installed "${CMAKE_CXX_FLAGS} ${option_for_speed}")
set(compiler_subdirectory "${other_compiler}")
set(flags_subdirectory "")
foreach(way IN ITEMS installed subdirectory)
  add_test(NAME consumer_${way}
    COMMAND "${CMAKE_COMMAND}"
      "-DWAY=${way}"
      "-DPACKAGE_SOURCE_DIR=${PROJECT_SOURCE_DIR}"
      "-DPACKAGE_BINARY_DIR=${PROJECT_BINARY_DIR}"
      "-DWORK_DIR=${PROJECT_BINARY_DIR}/consumer_${way}"
      "-DGENERATOR=${CMAKE_GENERATOR}"
      "-DCOMPILER=${compiler_${way}}"
      "-DCXX_FLAGS=${flags_${way}}"
      "-DCGAL_DIR=${CGAL_DIR}"
      -P "${PROJECT_SOURCE_DIR}/cmake/test_consumer.cmake")
  set_tests_properties(consumer_${way} PROPERTIES LABELS package COST 800)
endforeach()

# A package is configured, with its tests and all, without those above it.
foreach(without IN ITEMS SEAMLESS_SNAPPING ISOCURVES_AND_LAYOUTS QUAD_REMESHING HEXAHEDRAL_MESHING)
  string(TOLOWER "configured_without_${without}" name)
  add_test(NAME ${name}
    COMMAND "${CMAKE_COMMAND}" -S "${PROJECT_SOURCE_DIR}" -B "${PROJECT_BINARY_DIR}/${name}"
      -G "${CMAKE_GENERATOR}" "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}" "-DCGAL_DIR=${CGAL_DIR}"
      -DCMAKE_BUILD_TYPE=Release -DSEAMLESS_SNAPPING_WITH_${without}=OFF)
  set_tests_properties(${name} PROPERTIES LABELS package)
endforeach()

# What README.md shows is so.
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(program_dir "")
  if(TARGET seamless)
    set(program_dir "$<TARGET_FILE_DIR:seamless>")
  endif()
  set(include_path "$<TARGET_PROPERTY:CGAL::CGAL,INTERFACE_INCLUDE_DIRECTORIES>")
  add_test(NAME readme
    COMMAND "${CMAKE_COMMAND}"
      "-DPACKAGE_SOURCE_DIR=${PROJECT_SOURCE_DIR}"
      "-DWORK_DIR=${PROJECT_BINARY_DIR}/readme"
      "-DCOMPILER=${CMAKE_CXX_COMPILER}"
      "-DINCLUDE_PATH=$<JOIN:$<FILTER:${include_path},EXCLUDE,^/usr/include$>,:>"
      "-DPROGRAM_DIR=${program_dir}"
      "-DSYNTAX_CHECK=${syntax_check};\
-include;${PROJECT_SOURCE_DIR}/cmake/precompiled/remeshing.h"
      -P "${PROJECT_SOURCE_DIR}/cmake/test_readme.cmake")
  set_tests_properties(readme PROPERTIES LABELS package COST 900 SKIP_REGULAR_EXPRESSION "SKIPPED")
endif()

# Rounding and exact differences, with options and compilers of all kinds.
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  add_test(NAME compiler_options
    COMMAND "${CMAKE_COMMAND}"
      "-DCOMPILERS=${compilers}"
      "-DINCLUDE_DIR=${PROJECT_SOURCE_DIR}/include"
      "-DTEST_DIR=${PROJECT_SOURCE_DIR}/test/Linear_snapping"
      "-DPROCESSOR=${CMAKE_SYSTEM_PROCESSOR}"
      "-DWORK_DIR=${PROJECT_BINARY_DIR}"
      -P "${PROJECT_SOURCE_DIR}/cmake/test_compiler_options.cmake")
  set_tests_properties(compiler_options PROPERTIES LABELS package COST 800)
endif()

# The manual builds without a warning.
find_program(DOXYGEN doxygen)
add_test(NAME manual
  COMMAND "${CMAKE_COMMAND}"
    "-DDOXYGEN=${DOXYGEN}"
    "-DPACKAGE_SOURCE_DIR=${PROJECT_SOURCE_DIR}"
    "-DOUTPUT_DIR=${PROJECT_BINARY_DIR}/manual"
    -P "${PROJECT_SOURCE_DIR}/cmake/build_manual.cmake")
set_tests_properties(manual PROPERTIES LABELS package SKIP_REGULAR_EXPRESSION "SKIPPED")

# The form that CGAL asks of its packages.
add_test(NAME lint COMMAND "${PROJECT_SOURCE_DIR}/scripts/lint")
set_tests_properties(lint PROPERTIES LABELS package)
