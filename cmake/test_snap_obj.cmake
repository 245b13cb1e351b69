# What snap_obj does to files: none is lost to another, links and pipes stay what they are, and a
# report is JSON whatever it tells of. Run by ctest, with the variables SNAP_OBJ, INPUT, WORK_DIR.

function(expect what)
  if(NOT (${ARGN}))
    message(SEND_ERROR "${what}")
  endif()
endfunction()

function(snap expected_status)
  execute_process(COMMAND "${SNAP_OBJ}" ${ARGN} WORKING_DIRECTORY "${WORK_DIR}"
    RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT status EQUAL expected_status)
    message(SEND_ERROR "snap_obj ${ARGN}: status ${status}, not ${expected_status}:\n${out}")
  endif()
endfunction()

function(expect_same_content a b)
  file(SHA256 "${WORK_DIR}/${a}" hash_a)
  file(SHA256 "${WORK_DIR}/${b}" hash_b)
  if(NOT hash_a STREQUAL hash_b)
    message(SEND_ERROR "${a} and ${b} differ")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${WORK_DIR}/folder")
configure_file("${INPUT}" "${WORK_DIR}/in.obj" COPYONLY)
configure_file("${INPUT}" "${WORK_DIR}/in_place.obj" COPYONLY)

snap(0 in.obj out.obj --report out.json --svg out.svg)
snap(0 in_place.obj in_place.obj)
expect_same_content(in_place.obj out.obj)

# two names of one file
file(CREATE_LINK in.obj "${WORK_DIR}/link_to_in.obj" SYMBOLIC)
file(CREATE_LINK new.obj "${WORK_DIR}/link_to_new.obj" SYMBOLIC)
foreach(option IN ITEMS --report --svg)
  snap(2 in.obj new.obj ${option} in.obj)
  snap(2 in.obj new.obj ${option} link_to_in.obj)
  snap(2 in.obj new.obj ${option} new.obj)
  snap(2 in.obj new.obj ${option} ./folder/../new.obj)
  snap(2 in.obj new.obj ${option} link_to_new.obj)
endforeach()
snap(2 in.obj new.obj --report new.json --svg new.json)
file(SHA256 "${INPUT}" original)
file(SHA256 "${WORK_DIR}/in.obj" hash)
expect("the input has changed" hash STREQUAL original)
expect("something was written in spite of wrong usage" NOT EXISTS ${WORK_DIR}/new.obj)

# the target of a link is replaced, not the link
file(WRITE "${WORK_DIR}/folder/target.obj" "earlier")
file(CREATE_LINK folder/target.obj "${WORK_DIR}/link.obj" SYMBOLIC)
file(CREATE_LINK folder/created.obj "${WORK_DIR}/link_to_nothing.obj" SYMBOLIC)
foreach(link IN ITEMS link.obj link_to_nothing.obj)
  snap(0 in.obj ${link})
  expect("${link} is no link any more" IS_SYMLINK ${WORK_DIR}/${link})
endforeach()
expect_same_content(folder/target.obj out.obj)
expect_same_content(folder/created.obj out.obj)

# nothing to write to; and no file is used for text that is not finished
snap(4 in.obj folder)
snap(4 in.obj folder/missing/out.obj)
file(WRITE "${WORK_DIR}/kept.obj.unfinished" "someone's")
snap(0 in.obj kept.obj)
file(READ "${WORK_DIR}/kept.obj.unfinished" content)
expect("a file named '.unfinished' was overwritten" content STREQUAL someone's)
file(GLOB_RECURSE unfinished "${WORK_DIR}/*.unfinished*")
expect("left behind: ${unfinished}" unfinished STREQUAL ${WORK_DIR}/kept.obj.unfinished)

find_program(SHELL sh)
find_program(MKFIFO mkfifo)
if(SHELL AND MKFIFO)
  execute_process(COMMAND "${MKFIFO}" "${WORK_DIR}/pipe")
  execute_process(
    COMMAND "${SHELL}" -c "cat pipe > through_pipe.obj & '${SNAP_OBJ}' in.obj pipe; s=$?; \
      test -p pipe || kill $!; wait; exit $s"
    WORKING_DIRECTORY "${WORK_DIR}" RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  expect("snap_obj in.obj pipe: ${status}" status EQUAL 0)
  expect_same_content(through_pipe.obj out.obj)

  # a name that is not UTF-8
  execute_process(
    COMMAND "${SHELL}" -c
      "'${SNAP_OBJ}' \"$(printf 'missing_\\351.obj')\" new.obj --report bad.json"
    WORKING_DIRECTORY "${WORK_DIR}" RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  expect("snap_obj of a missing file: ${status}" status EQUAL 3)
  expect("no report on a name that is not UTF-8" EXISTS ${WORK_DIR}/bad.json)
endif()
