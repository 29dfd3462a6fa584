#!/bin/bash
# golden.sh [COMPILER LEVEL]...: builds core, search and golden_test by each compiler at each level of optimisation, each in
# a folder of its own under build/, and runs the test. Without arguments: g++ and clang++, -O1 and -O3.
set -euo pipefail
cd "$(dirname "$0")/.."
[[ $# -gt 0 ]] || set -- g++ -O1 g++ -O3 clang++ -O1 clang++ -O3
mkdir -p build

while [[ $# -ge 2 ]]; do
  compiler=$1 level=$2
  shift 2
  folder=build/golden-$compiler$level
  cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_UNITY_BUILD=ON \
    -DCMAKE_CXX_FLAGS_RELEASE="$level -DNDEBUG" >"$folder.log" 2>&1 || { cat "$folder.log"; exit 1; }
  cmake --build "$folder" --target golden_test -j "${JOBS:-$(nproc)}"
  echo "$compiler $level:"
  "$folder/bin/golden_test"
done
