# Writes the manual page of the program seamless to OUTPUT, from what PROGRAM says with --help.

function(read_help)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} --help OUTPUT_VARIABLE text RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "seamless ${ARGN} --help: ${status}")
  endif()
  set(help "${text}" PARENT_SCOPE)
endfunction()

# Text as it stands: what roff would take for its own is escaped.
function(append_section title text)
  string(REPLACE "\\" "\\e" text "${text}")
  string(REPLACE "-" "\\-" text "${text}")
  string(REGEX REPLACE "(^|\n)([.'])" "\\1\\\\&\\2" text "${text}")
  set(page "${page}.SH ${title}\n.nf\n${text}.fi\n" PARENT_SCOPE)
endfunction()

set(page ".TH SEAMLESS 1 \"\" \"Seamless_snapping ${VERSION}\"\n.SH NAME\n\
seamless \\- meshes of quads and hexahedra, and exactly seamless parametrizations\n")
read_help()
append_section(DESCRIPTION "${help}")
string(REGEX MATCHALL "\n  [a-z]+ " commands "${help}")
foreach(command IN LISTS commands ITEMS "snap IN.hexex" "check IN.hexex")
  string(STRIP "${command}" command)
  string(REPLACE " " ";" words "${command}")
  read_help(${words})
  string(REGEX REPLACE "\nExit status: .*" "" help "${help}")
  string(TOUPPER "${command}" title)
  append_section("SEAMLESS ${title}" "${help}")
endforeach()
file(WRITE "${OUTPUT}" "${page}")
