# The installed program runs, its manual page tells all commands, and the licence is there. Run by
# ctest, with PROGRAM, MAN_PAGE, LICENSE and VERSION.

execute_process(COMMAND "${PROGRAM}" --version OUTPUT_VARIABLE out)
if(NOT out STREQUAL "seamless ${VERSION}\n")
  message(SEND_ERROR "--version: ${out}")
endif()

file(READ "${MAN_PAGE}" page)
foreach(text IN ITEMS ".SH NAME\nseamless " "Seamless_snapping ${VERSION}" "Exit status:"
                      ".SH SEAMLESS SNAP\n" "\n  \\-\\-repair\\-flips " ".SH SEAMLESS BODY\n"
                      ".SH SEAMLESS SNAP IN.HEXEX\n")
  string(FIND "${page}" "${text}" position)
  if(position EQUAL -1)
    message(SEND_ERROR "not in the manual page: ${text}")
  endif()
endforeach()

file(READ "${LICENSE}" licence)
if(NOT licence MATCHES "GNU GENERAL PUBLIC LICENSE")
  message(SEND_ERROR "${LICENSE} is no licence")
endif()
