# find_package(coapt): target coapt::coapt, with the libraries that libcoapt was built against.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4)
find_dependency(OpenMP COMPONENTS CXX)
find_dependency(PkgConfig)
pkg_check_modules(CLIPPER QUIET REQUIRED IMPORTED_TARGET polyclipping)
pkg_check_modules(NLOPT QUIET REQUIRED IMPORTED_TARGET nlopt_cxx)
include(${CMAKE_CURRENT_LIST_DIR}/coaptTargets.cmake)
