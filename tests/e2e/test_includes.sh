#!/bin/bash
# cmake/check_includes.sh passes this repository and finds each kind of wrong arrow.
set -euo pipefail

root="$(cd "$(dirname "$0")/../.." && pwd)"
check="$root/cmake/check_includes.sh"
tree="$(mktemp -d)"
trap 'rm -rf "$tree"' EXIT

"$check" "$root"

# expect RESULT FILE LINE: a tree with only that line in that file passes or fails.
expect() {
  local expected=$1 file=$2 line=$3 got=passes
  rm -rf "${tree:?}"/*
  mkdir -p "$tree/$(dirname "$file")"
  echo "$line" >"$tree/$file"
  "$check" "$tree" 2>/dev/null || got=fails
  [[ $got == "$expected" ]] || { echo "$file with $line $got" >&2; exit 1; }
}

expect passes core/closure/a.cpp '#include "core/valve/valve.h"'
expect passes clients/cli/a.cpp '#include "io/json/valve_json.h"'
expect passes server/endpoints/a.cpp '#include "server/answer.h"'
expect fails core/valve/a.cpp '#include "core/closure/closure.h"'
expect fails core/repair/a.h '  #  include "core/closure/closure.h"'
expect fails core/closure/a.cpp '#include "core/metrics/measure.h"'
expect fails core/metrics/a.cpp '#include "search/search.h"'
expect fails search/a.cpp '#include "io/json/valve_json.h"'
expect fails io/json/a.cpp '#include "server/http.h"'
expect fails server/a.cpp '#include "clients/cli/files.h"'
expect fails clients/cli/a.cpp '#include "server/http.h"'
expect fails io/json/a.cpp '#include "tests/scenes/small_valve.h"'
expect fails core/valve/a.cpp '#include "valve.h"'
expect fails core/valve/a.cpp '#include <nlohmann/json.hpp>'
expect fails search/a.cpp '#include <nlohmann/json.hpp>'
expect fails io/json/a.cpp '#include <nlopt.hpp>'
expect fails core/closure/a.cpp '#include <clipper.hpp>'
expect fails search/a.cpp '#include <sqlite3.h>'
expect passes io/store/a.cpp '#include <sqlite3.h>'
expect fails core/valve/a.cpp '#include <chrono>'
expect fails core/valve/a.cpp '#pragma omp parallel for'
expect passes search/parallel.h '#pragma omp parallel for'
expect passes search/studies/a.cpp '#include "search/plans/objective.h"'
expect passes search/plans/a.cpp '#include "search/evaluator.h"'
expect fails search/plans/a.cpp '#include "search/studies/findings.h"'
expect fails search/a.cpp '#include "search/plans/objective.h"'
expect fails io/mesh/a.cpp '#include "search/evaluator.h"'
expect fails io/json/a.cpp '#include "io/picture/svg.h"'
expect fails io/exchange/a.cpp '#include "io/store/subject.h"'
expect fails io/mesh/a.cpp '#include "io/picture/import_picture.h"'
expect fails io/store/a.cpp '#include "io/picture/svg.h"'
expect passes server/endpoints/a.cpp '#include "server/jobs/job_board.h"'
expect fails server/jobs/a.cpp '#include "server/endpoints/jobs.h"'
expect fails core/colour/a.cpp '#include <string>'
expect passes lab/comparators/a.cpp '#include "core/closure/model.h"'
expect passes lab/cli/a.cpp '#include "clients/cli/files.h"'
for folder in core/closure search search/plans search/studies io/json io/picture server clients/cli lab/rivals; do
  expect fails "$folder/a.cpp" '#include "lab/closures/closure_study.h"'
done
expect fails lab/comparators/a.cpp '#include "search/search.h"'
expect fails lab/closures/a.cpp '#include "clients/cli/files.h"'
expect fails lab/comparators/a.cpp '#include <chrono>'
expect fails lab/comparators/a.cpp '#pragma omp parallel for'
