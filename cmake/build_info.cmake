# SPDX-License-Identifier: Apache-2.0
# Run at every build: writes OUTPUT from INPUT with the sources' commit; an unchanged file stays untouched.
# Without a repository of their own (an archive, a copy inside another repository) sources have the commit that
# `git archive` wrote into archive_commit, or none.
file(REAL_PATH ${CMAKE_CURRENT_LIST_DIR}/.. sources)
set(COMMIT unknown)
execute_process(COMMAND git rev-parse --show-toplevel WORKING_DIRECTORY ${sources} OUTPUT_VARIABLE top
                ERROR_VARIABLE reason OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_STRIP_TRAILING_WHITESPACE
                RESULT_VARIABLE failed)
if(NOT failed)
  file(REAL_PATH "${top}" top)
endif()
if(NOT failed AND top STREQUAL sources)
  execute_process(COMMAND git describe --always --dirty --abbrev=40 --exclude=* WORKING_DIRECTORY ${sources}
                  OUTPUT_VARIABLE described ERROR_VARIABLE reason OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed)
  if(NOT failed)
    set(COMMIT ${described})
  endif()
else()
  file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/archive_commit archived REGEX "^[0-9a-f]+$")
  if(archived)
    set(COMMIT ${archived})
  endif()
endif()
if(failed AND EXISTS ${sources}/.git) # such as sources of another user's
  message(STATUS "Commit: unknown, since git says: ${reason}")
endif()
configure_file(${INPUT} ${OUTPUT} @ONLY)
