# scripts/into_cgal makes packages that compile within CGAL, and changes CGAL's lists, once only.
# Run by ctest, with the variables PACKAGE_SOURCE_DIR, WORK_DIR, INCLUDE_DIRS (of CGAL, where the
# compiler does not find it), COMPILER and OPTIONS.

cmake_minimum_required(VERSION 3.16...3.29)

find_program(BASH bash)
if(NOT BASH)
  message("SKIPPED: bash is not installed")
  return()
endif()

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}\n${out}")
  endif()
endfunction()

function(into_cgal folder)
  run("${CMAKE_COMMAND}" -E env "CGAL_INCLUDE_DIR=${CGAL_INCLUDE_DIR}"
    "${BASH}" "${PACKAGE_SOURCE_DIR}/scripts/into_cgal" "${folder}")
endfunction()

# `text` once and no more, on a line of its own
function(expect_once file text)
  file(STRINGS "${file}" lines)
  set(found 0)
  foreach(line IN LISTS lines)
    if(line STREQUAL text)
      math(EXPR found "${found} + 1")
    endif()
  endforeach()
  if(NOT found EQUAL 1)
    message(SEND_ERROR "${found} times in ${file}: ${text}")
  endif()
endfunction()

find_path(CGAL_INCLUDE_DIR CGAL/version.h HINTS ${INCLUDE_DIRS} /usr/include REQUIRED)
file(REMOVE_RECURSE "${WORK_DIR}")

# In a checkout, of which these files are all that counts.
set(checkout "${WORK_DIR}/checkout")
set(licences "${checkout}/Installation/include/CGAL/license/gpl_package_list.txt")
set(parameters STL_Extension/include/CGAL/STL_Extension/internal/parameters_interface.h)
set(packages "${checkout}/Documentation/doc/Documentation/packages.txt")
set(bibliography "${checkout}/Documentation/doc/biblio/cgal_manual.bib")
string(REGEX REPLACE "^STL_Extension/include" "${CGAL_INCLUDE_DIR}" installed "${parameters}")
file(WRITE "${licences}" "Surface_mesh_parameterization Planar Parameterization\n")
file(WRITE "${packages}"
  "\\package_listing{Surface_mesh_parameterization}\n\\package_listing{Heat_method_3}\n")
file(WRITE "${bibliography}" "@article{ cgal:other,\n}\n")
file(READ "${installed}" text)
file(WRITE "${checkout}/${parameters}" "${text}")
foreach(time IN ITEMS first second)
  into_cgal("${checkout}")
endforeach()
expect_once("${licences}" "Seamless_snapping Seamless Snapping")
expect_once("${licences}" "Linear_snapping Snapping to Linear Constraints")
expect_once("${packages}" "\\package_listing{Seamless_snapping}")
expect_once("${packages}" "\\package_listing{Quad_remeshing}")
expect_once("${bibliography}" "@article{ cgal:other,")
expect_once("${checkout}/${parameters}"
  "CGAL_add_named_parameter(weld_borders_t, weld_borders, weld_borders)")
file(STRINGS "${PACKAGE_SOURCE_DIR}/doc/biblio.bib" entries REGEX "^@")
list(GET entries 0 entry)
expect_once("${bibliography}" "${entry}")
foreach(package IN ITEMS Linear_snapping Seamless_snapping Isocurves_and_layouts Quad_remeshing
    Hexahedral_meshing)
  foreach(file IN ITEMS ${package}.txt PackageDescription.txt Doxyfile.in dependencies examples.txt
      fig)
    if(NOT EXISTS "${checkout}/${package}/doc/${package}/${file}")
      message(SEND_ERROR "no ${package}/doc/${package}/${file}")
    endif()
  endforeach()
endforeach()

# All headers, with two programs, of which one adds parameters to those that are given, and the
# other tells parameters from values. That no header includes one of a package above, lint checks.
set(cgal "${WORK_DIR}/cgal")
into_cgal("${cgal}")
set(command "${COMPILER}" ${OPTIONS}
  -I "${cgal}/STL_Extension/include" -I "${cgal}/Installation/include")
set(source "${WORK_DIR}/packages.cpp")
foreach(package IN ITEMS Linear_snapping Seamless_snapping Isocurves_and_layouts Quad_remeshing
    Hexahedral_meshing)
  set(root "${cgal}/${package}")
  file(GLOB_RECURSE headers RELATIVE "${root}/include" "${root}/include/*.h")
  foreach(header IN LISTS headers)
    file(APPEND "${source}" "#include <${header}>\n")
  endforeach()
  list(APPEND command -I "${root}/include")
endforeach()
file(GLOB programs "${cgal}/*/examples/*/snap_linear_constraints.cpp"
  "${cgal}/*/examples/*/orbifold_pipeline.cpp")
foreach(program IN LISTS programs)
  get_filename_component(name "${program}" NAME_WE)
  file(APPEND "${source}"
    "#define main main_of_${name}\n#include \"${program}\"\n#undef main\n")
endforeach()
run(${command} -fsyntax-only "${source}")
