#!/bin/bash
# reproducible.sh TARGET...: makes the targets (wheel, tarball) of the last commit twice, in clones of different paths, with other
# umasks, time zones, locales and numbers of processes, and fails if an artefact differs by a bit.
set -euo pipefail
[[ $# -ge 1 ]] || { sed -n '2,3s/^# \{0,1\}//p' "$0" >&2; exit 2; }
cd "$(dirname "$0")/../.."

place=build/reproducible
rm -rf "$place"
one=$place/one two=$place/a/longer/path/two
mkdir -p "$(dirname "$two")"
(umask 022 && git clone --quiet . "$one" && TZ=UTC LC_ALL=C CMAKE_BUILD_PARALLEL_LEVEL=$(nproc) make -C "$one" "$@")
(umask 077 && git clone --quiet . "$two" && TZ=Asia/Tokyo LC_ALL=C.UTF-8 CMAKE_BUILD_PARALLEL_LEVEL=1 make -C "$two" "$@")

differ=0 compared=0
for artefact in "$one"/build/{wheel/*.whl,tarball/*.tar.gz}*; do
  [[ -e $artefact ]] || continue
  other=$two/${artefact#"$one"/}
  compared=$((compared + 1))
  cmp "$artefact" "$other" || { differ=1; ! command -v diffoscope >/dev/null || diffoscope "$artefact" "$other" || true; }
done
# Each target leaves an artefact and its bill of materials.
[[ $compared -eq $((2 * $#)) ]] || { echo "reproducible.sh: $compared files to compare, not two of each target" >&2; exit 1; }
echo "$compared files compared"
exit "$differ"
