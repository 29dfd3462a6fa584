#!/bin/bash
# check_includes.sh [ROOT]: fails if an #include goes against the arrows of ARCHITECTURE.md.
set -euo pipefail
cd "${1:-$(dirname "$0")/..}"

# Folder, then the folders whose headers it may include besides its own. A slash at the end: files right in that folder.
readonly arrows='
core/valve       :
core/repair      : core/valve
core/closure     : core/valve
core/metrics     : core/closure core/valve
core/closed      : core/repair core/metrics core/closure core/valve
core/opened      : core/metrics core/closure core/valve
core/live        : core/closure core/valve
core/presets     : core/closure core/valve
search/          : core
search/plans     : core search/ search/fit
search/studies   : core search/ search/plans
search/fit       : core search/
search/preference : core search/ search/plans
search/training  : core search/
io/command_line  : core/valve
io/json          : core search
io/mesh          : core io/json
io/image         : core io/mesh
io/dicom         : core io/mesh io/image
io/exchange      : core search io/json io/mesh io/image
io/picture       : core search io/json io/mesh
io/store         : core search io/json
server/          : core search io server/endpoints server/jobs
server/jobs      : core search io server/
server/endpoints : core search io server/ server/jobs
clients/cli      : core search io
clients/engine   : core search io/json
clients/live     : core io clients/cli
clients/python   : core search io server/ server/jobs
lab/comparators  : core
lab/rivals       : core
lab/closures     : core search io
lab/lattices     : core search io lab/rivals
lab/verdicts     : core search lab/closures
lab/twins        : core search lab/closures
lab/diseases     : core search
lab/preference   : core search
lab/charts       : core search io lab/closures
lab/cli          : core search io clients/cli lab
'
# Pattern of what only one folder may include, then that folder.
readonly reserved='
nlopt           : search lab/rivals
clipper[.]hpp   : core/metrics
cairo           : io/picture
httplib[.]h     : server clients/cli
CLI/            : io/command_line
nlohmann/       : io server clients/cli clients/engine clients/live clients/python lab
sqlite3[.]h     : io/store
lzma[.]h        : io/mesh
dcmtk/          : io/dicom
boost/          : clients/live
pybind11/       : clients/python
pagmo/          : lab/rivals
dlib/           : lab/rivals
'
# core and the comparators are pure: no threads, clock, randomness, files or streams.
readonly impure='^(thread|mutex|atomic|future|condition_variable|chrono|ctime|time[.]h|random|filesystem|fstream|iostream|omp[.]h)$'

# within FILE FOLDER...: whether FILE lies in one of the folders.
within() {
  local file=$1 folder
  shift
  for folder in "$@"; do
    case $folder in
      */) [[ ${file%/*}/ == "$folder" ]] && return 0 ;;
      *) [[ $file == "$folder"/* ]] && return 0 ;;
    esac
  done
  return 1
}

wrong=0
complain() {
  echo "$1" >&2
  wrong=1
}

# Every include as "file:line:text".
includes() { grep -rnE --include='*.h' --include='*.cpp' '^[[:space:]]*#[[:space:]]*include' "$1" || true; }

folders=()
while IFS=: read -r folder allowed; do
  read -r folder <<<"$folder"
  read -ra allowed <<<"$allowed"
  folders+=("$folder")
  [[ -d $folder ]] || continue
  while IFS=: read -r file line text; do
    within "$file" "$folder" || continue
    [[ $text =~ \"([^\"]+)\" ]] || continue
    within "${BASH_REMATCH[1]}" "$folder" "${allowed[@]}" ||
      complain "$file:$line: $folder may not include ${BASH_REMATCH[1]}"
  done < <(includes "${folder%/}")
done < <(grep : <<<"$arrows")

for root in core search io server clients lab; do
  [[ -d $root ]] || continue
  while read -r file; do
    within "$file" "${folders[@]}" || complain "$file: its folder has no row in cmake/check_includes.sh"
  done < <(find "$root" -name node_modules -prune -o \( -name '*.h' -o -name '*.cpp' \) -print)
done

while IFS=: read -r pattern owners; do
  read -r pattern <<<"$pattern"
  read -ra owners <<<"$owners"
  while IFS=: read -r file line text; do
    [[ $text =~ \<($pattern[^>]*)\> ]] || continue
    within "$file" "${owners[@]}" ||
      complain "$file:$line: only ${owners[*]} may include <${BASH_REMATCH[1]}>"
  done < <(for root in core search io server clients lab; do [[ -d $root ]] && includes "$root"; done)
done < <(grep : <<<"$reserved")

for root in core lab/comparators; do
  [[ -d $root ]] || continue
  while IFS=: read -r file line text; do
    [[ $text =~ \<([^>]+)\> ]] || continue
    [[ ! ${BASH_REMATCH[1]} =~ $impure ]] ||
      complain "$file:$line: $root may not include <${BASH_REMATCH[1]}>"
  done < <(includes "$root")
done

for root in core search io server clients lab; do
  [[ -d $root ]] || continue
  while IFS=: read -r file line _; do
    [[ $file == search/parallel.h ]] || complain "$file:$line: OpenMP only in search/parallel.h"
  done < <(grep -rnE --include='*.h' --include='*.cpp' '#[[:space:]]*pragma[[:space:]]+omp' "$root" || true)
done
exit "$wrong"
