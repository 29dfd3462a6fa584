# What the programs link besides Eigen and JSON.
find_package(PkgConfig REQUIRED)
find_package(OpenMP REQUIRED)
find_package(CLI11 REQUIRED)
if(NOT COAPT_FUZZ)
  find_package(Boost REQUIRED)  # headers
endif()
find_package(Threads REQUIRED)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo)
pkg_check_modules(HTTPLIB REQUIRED IMPORTED_TARGET cpp-httplib)
pkg_check_modules(CRYPTO REQUIRED IMPORTED_TARGET libcrypto)
pkg_check_modules(ZLIB REQUIRED IMPORTED_TARGET zlib)
pkg_check_modules(LZMA REQUIRED IMPORTED_TARGET liblzma)
find_package(BZip2 REQUIRED)  # Debian 12 has no bzip2.pc
pkg_check_modules(SQLITE REQUIRED IMPORTED_TARGET sqlite3)
# nlopt_cxx holds everything; Debian's plain nlopt lacks AGS and StoGO, and find_package may pick either.
pkg_check_modules(NLOPT REQUIRED IMPORTED_TARGET nlopt_cxx)
add_library(NLopt::nlopt_cxx ALIAS PkgConfig::NLOPT)
if(NOT COAPT_FUZZ)
  find_package(DCMTK CONFIG REQUIRED)
  pkg_check_modules(PQ REQUIRED IMPORTED_TARGET libpq)
  find_package(GTest REQUIRED)
endif()
