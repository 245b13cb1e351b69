# What the compiler says of meshes and maps that public functions can't take, and of named
# parameters that do nothing: the remedy, once for each line "// error: " of the sources in
# test/Seamless_snapping/refused_types, and no other error. They are compiled together, because they
# share their headers. Run by ctest, with the variables SOURCES and COMMAND, which checks the syntax
# of a source.

cmake_minimum_required(VERSION 3.16...3.29)

set(command ${COMMAND} -w)
set(expected "")
foreach(source IN LISTS SOURCES)
  file(STRINGS "${source}" errors REGEX "^// error: ")
  list(APPEND expected ${errors})
  list(APPEND command -include "${source}")
endforeach()
execute_process(COMMAND "${CMAKE_COMMAND}" -E env LC_ALL=C ${command} -x c++ /dev/null
  RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
if(status EQUAL 0)
  message(FATAL_ERROR "it compiles")
endif()
string(REGEX MATCHALL "error: [^\n]*" errors "${out}")
list(TRANSFORM expected REPLACE "^// error: " "")
list(LENGTH errors number)
list(LENGTH expected expected_number)
if(NOT number EQUAL expected_number)
  message(FATAL_ERROR "${number} errors:\n${out}")
endif()
# Compilers differ in their order.
foreach(message IN LISTS expected)
  set(found "")
  foreach(error IN LISTS errors)
    string(FIND "${error}" "${message}" position)
    if(NOT position EQUAL -1 AND error MATCHES "static.assert")
      set(found "${error}")
    endif()
  endforeach()
  list(FIND errors "${found}" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "no '${message}':\n${out}")
  endif()
  list(REMOVE_AT errors ${position})
endforeach()
