# cpack -G TGZ: the programs with the page, examples and documents, and the shared libraries that a bare Debian 12 has not
# (cmake/packaging/bundle_libraries.py). make tarball builds first.
set(CPACK_GENERATOR TGZ)
set(CPACK_PACKAGE_VENDOR "The coapt authors")
string(TOLOWER ${CMAKE_SYSTEM_NAME} COAPT_SYSTEM)
set(CPACK_PACKAGE_FILE_NAME coapt-${PROJECT_VERSION}-${COAPT_SYSTEM}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_SOURCE_DIR}/build/tarball)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/packaging/before_tarball.cmake)
set(CPACK_THREADS 0)
foreach(component coapt coapt-farm coapt-live coapt-server web examples documents)
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${CMAKE_BINARY_DIR};coapt;${component};/")
endforeach()
include(CPack)
