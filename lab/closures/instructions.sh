#!/bin/bash
# instructions.sh [VALVE] [SCENES]: machine instructions of a closure by function, where clocks are too noisy to compare
# two versions. Runs `coapt-lab bench closures` under callgrind, which has AVX2 at most; the start of the program is taken off.
set -euo pipefail

coapt="$(dirname "$0")/../../build/release/bin/coapt-lab"
valve="${1:-human-normal}"
scenes="${2:-10}"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

# count N FILE: instructions of N closures.
count() {
  valgrind --tool=callgrind --callgrind-out-file="$2" "$coapt" bench closures "$valve" --count "$1" --threads 1 \
    --no-accuracy 2>&1 | awk '/Collected/ { print $4 }'
}

one="$(count 1 "$folder/one")"
all="$(count "$((scenes + 1))" "$folder/all")"
echo "$valve: $(((all - one) / scenes / 1000)) thousand instructions a closure (AVX2)"
callgrind_annotate "$folder/all" | grep -E '^ *[0-9,]+ \(' | sed -n '2,13p' | cut -c1-140
