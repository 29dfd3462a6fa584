# What CPack runs on the files before it packs them: libraries come in, and nothing tells when or by whom it was made.
foreach(command "/usr/bin/python3;${CMAKE_CURRENT_LIST_DIR}/bundle_libraries.py;.;lib/coapt"
                "chmod;-R;u=rwX,go=rX;."
                "find;.;-exec;touch;--no-dereference;--date=@$ENV{SOURCE_DATE_EPOCH};{};+")
  execute_process(COMMAND ${command} WORKING_DIRECTORY ${CPACK_TEMPORARY_INSTALL_DIRECTORY} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
