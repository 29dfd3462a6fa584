#!/bin/bash
# run_arm64.sh TEST...: runs test programs of the preset arm64 under emulation, and says how long each took.
set -euo pipefail
cd "$(dirname "$0")/../.."
failed=()
for test in "$@"; do
  start=$SECONDS
  OMP_NUM_THREADS=$(nproc) qemu-aarch64 -L build/arm64-root "build/arm64/bin/$test" --gtest_brief=1 || failed+=("$test")
  echo "$test: $((SECONDS - start)) s"
done
[[ ${#failed[@]} -eq 0 ]] || { echo "run_arm64.sh: failed: ${failed[*]}" >&2; exit 1; }
