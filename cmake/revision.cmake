# Writes OUTPUT from INPUT, if it changed, with version and revision of the sources: cmake -D SOURCE=... -D COAPT_VERSION=... -D INPUT=...
# -D OUTPUT=... [-D REVISION=...] -P revision.cmake. Of an archive without history the commit stands in revision.txt.
set(COAPT_REVISION "${REVISION}")
find_program(GIT git)
if(NOT COAPT_REVISION AND GIT AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --short=12 HEAD OUTPUT_VARIABLE COAPT_REVISION
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${GIT} -C ${SOURCE} status --porcelain --untracked-files=no OUTPUT_VARIABLE changes ERROR_QUIET)
  if(COAPT_REVISION AND changes)
    string(APPEND COAPT_REVISION "+changes")
  endif()
endif()
if(NOT COAPT_REVISION)
  file(READ ${SOURCE}/cmake/revision.txt archived)
  string(REGEX MATCH "^[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]"
         COAPT_REVISION "${archived}")
endif()
if(NOT COAPT_REVISION)
  set(COAPT_REVISION unknown)
endif()
configure_file(${INPUT} ${OUTPUT} @ONLY)
