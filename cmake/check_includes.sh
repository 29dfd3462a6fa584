#!/bin/bash
# check_includes.sh [ROOT]: fails if an #include goes against the arrows of ARCHITECTURE.md.
set -euo pipefail
cd "${1:-$(dirname "$0")/..}"

# Folder, then the folders whose headers it may include besides its own.
readonly arrows='
core/valve    :
core/repair   : core/valve
core/closure  : core/valve
core/metrics  : core/closure core/valve
core/presets  : core/closure core/valve
search        : core
io            : search core
server        : io search core
clients/cli   : io search core bench/comparators bench/rivals
bench/comparators : core
bench/rivals  : core
'
# Pattern of what only one folder may include, then that folder.
readonly reserved='
nlopt           : search bench/rivals
clipper[.]hpp   : core/metrics
cairo           : io/picture
httplib[.]h     : server clients/cli
CLI/            : clients/cli server
nlohmann/       : io server clients/cli
sqlite3[.]h     : io/store
pagmo/          : bench/rivals
dlib/           : bench/rivals
'
# core and the comparators are pure: no threads, clock, randomness, files or streams.
readonly impure='^(thread|mutex|atomic|future|condition_variable|chrono|ctime|time[.]h|random|filesystem|fstream|iostream|omp[.]h)$'

# within FILE FOLDER...: whether FILE lies in one of the folders.
within() {
  local file=$1 folder
  shift
  for folder in "$@"; do [[ $file == "$folder"/* ]] && return 0; done
  return 1
}

wrong=0
complain() {
  echo "$1" >&2
  wrong=1
}

# Every include as "file:line:text".
includes() { grep -rnE --include='*.h' --include='*.cpp' '^[[:space:]]*#[[:space:]]*include' "$1" || true; }

while IFS=: read -r folder allowed; do
  read -r folder <<<"$folder"
  read -ra allowed <<<"$allowed"
  [[ -d $folder ]] || continue
  while IFS=: read -r file line text; do
    [[ $text =~ \"([^\"]+)\" ]] || continue
    within "${BASH_REMATCH[1]}" "$folder" "${allowed[@]}" ||
      complain "$file:$line: $folder may not include ${BASH_REMATCH[1]}"
  done < <(includes "$folder")
done < <(grep : <<<"$arrows")

while IFS=: read -r pattern owners; do
  read -r pattern <<<"$pattern"
  read -ra owners <<<"$owners"
  while IFS=: read -r file line text; do
    [[ $text =~ \<($pattern[^>]*)\> ]] || continue
    within "$file" "${owners[@]}" ||
      complain "$file:$line: only ${owners[*]} may include <${BASH_REMATCH[1]}>"
  done < <(for root in core search io server clients bench/comparators bench/rivals; do [[ -d $root ]] && includes "$root"; done)
done < <(grep : <<<"$reserved")

for root in core bench/comparators; do
  [[ -d $root ]] || continue
  while IFS=: read -r file line text; do
    [[ $text =~ \<([^>]+)\> ]] || continue
    [[ ! ${BASH_REMATCH[1]} =~ $impure ]] ||
      complain "$file:$line: $root may not include <${BASH_REMATCH[1]}>"
  done < <(includes "$root")
done

for root in core search io server clients bench; do
  [[ -d $root ]] || continue
  while IFS=: read -r file line _; do
    [[ $file == search/parallel.h ]] || complain "$file:$line: OpenMP only in search/parallel.h"
  done < <(grep -rnE --include='*.h' --include='*.cpp' '#[[:space:]]*pragma[[:space:]]+omp' "$root" || true)
done
exit "$wrong"
