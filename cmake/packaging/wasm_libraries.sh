#!/bin/bash
# wasm_libraries.sh FOLDER: NLopt for WebAssembly in FOLDER (include, lib), without what is under the LGPL, from Debian's source; nothing if it is there. The
# source is fetched by apt, which checks its signature, into a place of its own: the machine's lists stay as they are.
set -euo pipefail

root="$(cd "$(dirname "$0")/../.." && pwd)"
mkdir -p "$1"
into="$(cd "$1" && pwd)"
[[ ! -e $into/lib/libnlopt.a ]] || exit 0

release="$(. /etc/os-release && echo "$VERSION_CODENAME")"
mirror="$(apt-get indextargets --format '$(REPO_URI)' "Codename: $release" 'Component: main' | head -n 1)"
source="$into/source"
mkdir -p "$source/lists/partial"
echo "deb-src ${mirror:-http://deb.debian.org/debian} $release main" >"$source/sources.list"
apt=(apt-get -q -o "Dir::Etc::sourcelist=$source/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$source/lists"
     -o APT::Sandbox::User=root)
cd "$source"
"${apt[@]}" update
"${apt[@]}" source --download-only nlopt
mkdir -p nlopt
tar -xzf nlopt_*.orig.tar.gz -C nlopt --strip-components=1

cmake -S nlopt -B build -G Ninja -DCMAKE_TOOLCHAIN_FILE="$root/cmake/wasm.cmake" -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_C_FLAGS="-ffp-contract=off -w" -DCMAKE_INSTALL_PREFIX="$into" -DBUILD_SHARED_LIBS=OFF \
  -DNLOPT_CXX=OFF -DNLOPT_FORTRAN=OFF -DNLOPT_PYTHON=OFF -DNLOPT_OCTAVE=OFF -DNLOPT_MATLAB=OFF -DNLOPT_GUILE=OFF \
  -DNLOPT_SWIG=OFF -DNLOPT_TESTS=OFF -DHAVE_GETPID=0 -DHAVE_GETTID_SYSCALL=0
cmake --build build
cmake --install build
# Luksan's algorithms alone are under the LGPL, and no search uses them (clients/engine/planner.cpp).
llvm-ar-19 d "$into/lib/libnlopt.a" plis.c.obj plip.c.obj pnet.c.obj mssubs.c.obj pssubs.c.obj
