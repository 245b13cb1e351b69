# Several programs as one source, so that what they share is compiled once: their includes, then the
# code of each in a namespace of its own. The program that is called is the one whose name it has.
# Run while building, with the variables OUTPUT, FIRST (headers) and SOURCES.

cmake_minimum_required(VERSION 3.16...3.29)

set(includes "")
foreach(header IN LISTS FIRST)
  string(APPEND includes "#include \"${header}\"\n")
endforeach()
set(programs "")
set(calls "")
foreach(source IN LISTS SOURCES)
  get_filename_component(name "${source}" NAME_WE)
  file(READ "${source}" text)
  string(FIND "${text}" "\n#include " last_include REVERSE)
  math(EXPR begin "${last_include} + 1")
  string(SUBSTRING "${text}" 0 ${begin} head)
  string(SUBSTRING "${text}" ${begin} -1 text)
  string(FIND "${text}" "\n" end)
  math(EXPR end "${end} + 1")
  string(SUBSTRING "${text}" 0 ${end} line)
  string(SUBSTRING "${text}" ${end} -1 text)
  string(APPEND includes "#line 1 \"${source}\"\n${head}${line}")
  string(REGEX REPLACE "[^\n]" "" line_ends "${head}${line}")
  string(LENGTH "${line_ends}" number)
  math(EXPR number "${number} + 1")
  set(arguments "argc, argv")
  if(text MATCHES "\nint main\\(\\)")
    set(arguments "")
  endif()
  string(REPLACE "\nint main(" "\nint program(" text "${text}")
  string(APPEND programs
    "namespace ${name} {\n#line ${number} \"${source}\"\n${text}} // namespace ${name}\n\n")
  string(APPEND calls
    "  if(name == \"${name}\")\n    return ${name}::program(${arguments});\n")
endforeach()
file(WRITE "${OUTPUT}" "${includes}
#include <iostream>
#include <string>

${programs}int main(int argc, char** argv)
{
  std::string name = argc > 0 ? argv[0] : \"\";
  name.erase(0, name.rfind('/') + 1);
${calls}  std::cerr << \"There is no program \" << name << std::endl;
  return 1;
}
")
