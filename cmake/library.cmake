# libcoapt: core and search as one library, found by find_package(coapt) as coapt::coapt. With COAPT_SHARED a shared one, which exports
# what their headers declare (libcoapt.map); the programs hold the same objects in either case.
if(COAPT_SHARED)
  add_library(libcoapt SHARED)
  set_target_properties(libcoapt PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}
                                            LINK_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/libcoapt.map)
  target_link_options(libcoapt PRIVATE -Wl,--version-script,${CMAKE_CURRENT_LIST_DIR}/libcoapt.map
                                       -Wl,--no-undefined -Wl,-Bsymbolic-functions)
else()
  add_library(libcoapt STATIC)
endif()
get_property(COAPT_LIBRARY_FOLDERS DIRECTORY ${CMAKE_SOURCE_DIR}/core PROPERTY SUBDIRECTORIES)
foreach(folder ${COAPT_LIBRARY_FOLDERS} ${CMAKE_SOURCE_DIR}/search)
  get_property(parts DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(part ${parts})
    target_sources(libcoapt PRIVATE $<TARGET_OBJECTS:${part}>)
    set_target_properties(${part} PROPERTIES COAPT_EXPORTED ${COAPT_SHARED})
  endforeach()
endforeach()
# Types of Eigen are read there: what holds them cannot be more visible than they are.
set_target_properties(coapt_headers PROPERTIES COAPT_EXPORTED ${COAPT_SHARED})
set_target_properties(libcoapt PROPERTIES OUTPUT_NAME coapt EXPORT_NAME coapt LINKER_LANGUAGE CXX)
target_compile_features(libcoapt PUBLIC cxx_std_20)
# The headers include each other as "core/..." and "search/...".
target_include_directories(libcoapt INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/coapt>)
# Eigen allocates what it aligns to more than 16 bytes in another way: a program compiled with -mavx must not.
target_compile_definitions(libcoapt INTERFACE $<INSTALL_INTERFACE:EIGEN_MAX_ALIGN_BYTES=16>)
target_link_libraries(libcoapt PUBLIC Eigen3::Eigen OpenMP::OpenMP_CXX PRIVATE PkgConfig::NLOPT)

include(CMakePackageConfigHelpers)
set(COAPT_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/coapt)
configure_file(${CMAKE_CURRENT_LIST_DIR}/coaptConfig.cmake.in ${CMAKE_BINARY_DIR}/coaptConfig.cmake @ONLY)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/coaptConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(TARGETS libcoapt EXPORT coapt COMPONENT library)
install(EXPORT coapt NAMESPACE coapt:: FILE coaptTargets.cmake DESTINATION ${COAPT_PACKAGE_DIR} COMPONENT library)
install(FILES ${CMAKE_BINARY_DIR}/coaptConfig.cmake ${CMAKE_BINARY_DIR}/coaptConfigVersion.cmake
        DESTINATION ${COAPT_PACKAGE_DIR} COMPONENT library)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/core ${CMAKE_SOURCE_DIR}/search
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/coapt COMPONENT library FILES_MATCHING PATTERN "*.h")
