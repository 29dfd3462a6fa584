#!/bin/bash
# check_debs.sh DEBS [DATABASE...]: the packages in the folder DEBS, in a Debian of their own below /var/tmp, which is made by
# mmdebstrap from this machine's sources of apt, has no compiler, and goes with the script:
#
#   1. nothing but coapt: seconds and megabytes to the first ranked plan
#   2. all packages, and the tests of debian/tests
#   3. each DATABASE (jobs.sqlite of 0.1 or 0.2, with the files beside it) under the service: its jobs and valves are there, and still
#      after the same version was installed again
#   4. removed, the database stays; purged, nothing stays but the service's user
#
# Needs root, and the network for what the packages depend on. KEEP=yes leaves the Debian where it is.
set -euo pipefail
[[ $# -ge 1 && -d $1 ]] || { sed -n '2,12s/^# \{0,1\}//p' "$0" >&2; exit 2; }
# shellcheck source=tests/packages/bare_debian.sh
source "$(dirname "$0")/bare_debian.sh"

source=$(cd "$(dirname "$0")/../.." && pwd)
debs=$(realpath "$1")
shift
databases=()
for file in "$@"; do databases+=("$(realpath "$file")"); done

# shellcheck disable=SC2016  # expanded there
has_none_of() { within sh -c 'for program; do ! command -v "$program" || exit 1; done' sh "$@"; }
# paths PACKAGE: where its file lies in that Debian; of all without an argument.
paths() { for deb in "$debs/${1-}${1+_}"*.deb; do echo "/debs/${deb##*/}"; done; }
packages_of() { for deb in "$debs"/*.deb; do dpkg-deb --field "$deb" Package; done; }

make_root() {
  make_bare bookworm
  printf '#!/bin/sh\nexit 101\n' >"$root/usr/sbin/policy-rc.d"
  chmod +x "$root/usr/sbin/policy-rc.d"
  mkdir "$root/debs"
  cp "$debs"/*.deb "$root/debs/"
  has_none_of gcc g++ cc python3 || fail "the Debian to start from has compilers"
}

to_the_first_plan() {
  local coapt before start installed
  coapt=$(paths coapt)
  before=$(megabytes)
  within apt-get install --print-uris -qq -y --no-install-recommends "$coapt" | awk '/^.http/ { sum += $3 } END { printf "to download: %.1f MB, ", sum / 1e6 }'
  du --bytes "$debs"/coapt_*.deb | awk '{ printf "and coapt itself, %.1f MB\n", $1 / 1e6 }'
  start=$EPOCHREALTIME
  apt_install "$coapt"
  installed=$EPOCHREALTIME
  within apt-get clean
  echo "installed: $(($(megabytes) - before)) MB more than the $before MB of the Debian without it"
  within sh -c 'cd /tmp && coapt plan human-functional-mr --evaluations 60 --region-points 65 --plans 1 -o report.html 2>/dev/null' || [[ $? -eq 4 ]]
  echo "seconds: $(seconds "$start" "$installed") to install, $(seconds "$start" "$EPOCHREALTIME") to the first ranked plan, together"
}

# The tests of debian/tests/control, each with the packages that it depends on; those of ours are there.
run_tests() {
  local line name='' depends
  mkdir -p "$root/tests"
  cp -r "$source/debian/tests/." "$root/tests/"
  while read -r -u 3 line; do
    case $line in
      Tests:*) name=${line#Tests: } ;;
      Depends:*)
        IFS=', ' read -ra depends <<<"${line#Depends: }"
        say "test $name"
        apt_install "${depends[@]}"
        within sh -ec "folder=\$(mktemp -d) && AUTOPKGTEST_TMP=\$folder /tests/$name" </dev/null || fail "the test $name"
        ;;
    esac
  done 3<"$root/tests/control"
}

# serve COMMAND...: with the service on the database of the package, as its unit would start it.
serve() {
  local status=0
  within install -o _coapt -g _coapt -m 0400 /etc/coapt/token /tmp/token
  # Without the shell of within, so that what is killed is the service.
  chroot "$root" /usr/bin/setpriv --reuid=_coapt --regid=_coapt --clear-groups /usr/bin/coapt-server --port 8090 --db /var/lib/coapt/jobs.sqlite --token-file /tmp/token 2>"$root/tmp/messages" &
  local server=$!
  within curl --silent --fail --output /dev/null --retry 30 --retry-delay 1 --retry-connrefused http://127.0.0.1:8090/healthz/live || status=$?
  [[ $status -ne 0 ]] || "$@" || status=$?
  kill "$server"
  wait "$server" || status=$?
  [[ $status -eq 0 ]] || cat "$root/tmp/messages"
  return "$status"
}

# Each job and each valve of a database, asked for by its name.
ask_for_all() {
  local kind name
  while IFS='|' read -r kind name; do
    within sh -c "curl --silent --fail --output /dev/null -H \"Authorization: Bearer \$(cat /etc/coapt/token)\" http://127.0.0.1:8090/v1/$kind/$name" ||
      { echo "$kind/$name is gone"; return 1; }
  done <"$root/tmp/names"
  echo "$(wc -l <"$root/tmp/names") jobs and valves are there"
}

upgrade() {
  local database=$1 file
  rm -rf "${root:?}"/var/lib/coapt/*
  for file in "$database" "$database"-plans "$database"-studies; do
    [[ ! -e $file ]] || within install -o _coapt -g _coapt -m 0600 /dev/stdin "/var/lib/coapt/jobs.sqlite${file#"$database"}" <"$file"
  done
  python3 - "$database" >"$root/tmp/names" <<'END'
import sqlite3
import sys

store = sqlite3.connect(f"file:{sys.argv[1]}?mode=ro", uri=True)
for kind in ("jobs", "valves"):
    for (name,) in store.execute(f"SELECT id FROM {kind}"):
        print(f"{kind}|{name}")
END
  serve ask_for_all || fail "$database under the new service"
  apt_install --reinstall "${all[@]}"
  serve ask_for_all || fail "$database after a second installation"
}

remove_and_purge() {
  local packages left
  mapfile -t packages < <(packages_of)
  within apt-get remove -qq -y "${packages[@]}" >/dev/null
  [[ -s $root/var/lib/coapt/jobs.sqlite && -s $root/etc/coapt/token ]] || fail "removed, the service left no database"
  has_none_of coapt coapt-farm coapt-live coapt-server || fail "removed, programs are there"
  # By dpkg, which minds no package that has left nothing behind.
  within dpkg --purge "${packages[@]}" >/dev/null 2>&1
  left=$(cd "$root" && find . -xdev -name '*coapt*' -not -path './debs/*' -not -path './proc/*' -not -path './tmp/*' -not -path './tests/*' \
    -not -path './var/log/*')
  [[ -z $left ]] || fail "purged, this is left: $left"
  echo "left: nothing but $(grep -c '^_coapt:' "$root/etc/passwd") user"
}

mapfile -t all < <(paths)

say "a Debian without compilers"
make_root
say "from nothing to a plan"
to_the_first_plan
say "all packages"
apt_install "${all[@]}"
run_tests
for database in "${databases[@]}"; do
  say "upgrade from $database"
  upgrade "$database"
done
say "remove and purge"
[[ -s $root/var/lib/coapt/jobs.sqlite ]] || serve true
remove_and_purge
say "passed"
