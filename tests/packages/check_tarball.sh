#!/bin/bash
# check_tarball.sh TARBALL [SUITE...]: unpacked in a bare Debian of each SUITE (bookworm, trixie) every program runs, a search ends with a
# ranked plan and a report, the service hands out its page, and no library is missing. Prints seconds and megabytes to the first plan.
set -euo pipefail
[[ $# -ge 1 && -f $1 ]] || { sed -n '2,3s/^# \{0,1\}//p' "$0" >&2; exit 2; }
# shellcheck source=tests/packages/bare_debian.sh
source "$(dirname "$0")/bare_debian.sh"

tarball=$(realpath "$1")
shift
[[ $# -gt 0 ]] || set -- bookworm trixie

check() {
  local before start unpacked folder
  make_bare "$1"
  before=$(megabytes)
  start=$EPOCHREALTIME
  within tar --extract --gzip --directory /opt <"$tarball"
  unpacked=$EPOCHREALTIME
  folder=$(cd "$root" && echo opt/coapt-*)
  echo "to download: $(awk -v bytes="$(stat --format %s "$tarball")" 'BEGIN { printf "%.1f", bytes / 1e6 }') MB; unpacked: $(($(megabytes) - before)) MB more than the $before MB of the Debian without it"
  within sh -c "cd /tmp && /$folder/bin/coapt plan human-functional-mr --evaluations 60 --region-points 65 --plans 1 -o report.html" >"$root/tmp/plan" 2>"$root/tmp/messages" ||
    [[ $? -eq 4 ]] || { cat "$root/tmp/messages"; fail "no plan"; }
  echo "seconds: $(seconds "$start" "$unpacked") to unpack, $(seconds "$unpacked" "$EPOCHREALTIME") to the first ranked plan, $(seconds "$start" "$EPOCHREALTIME") together"
  head -4 "$root/tmp/plan"
  grep -q '</html>' "$root/tmp/report.html"
  within sh -c "/$folder/bin/coapt close human-functional-mr --plan /$folder/share/doc/coapt/examples/plans/ring.json --render /tmp/closed.png" >/dev/null
  [[ -s $root/tmp/closed.png ]] || fail "no picture"
  for program in coapt-farm coapt-live coapt-server; do within "/$folder/bin/$program" --version | head -1; done
  serve "/$folder"
}

# The service of the folder is asked for its page, without a tool that a bare Debian has not.
serve() {
  local server answer
  # Without the shell of within, so that what is ended is the service.
  chroot "$root" /usr/bin/env -i LANG=C.UTF-8 "$1/bin/coapt-server" --port 8091 --db /tmp/jobs.sqlite 2>"$root/tmp/messages" &
  server=$!
  for _ in {1..150}; do
    answer=$({ exec 3<>/dev/tcp/127.0.0.1/8091 && printf 'GET / HTTP/1.1\r\nHost: 127.0.0.1:8091\r\n\r\n' >&3 && cat <&3; } 2>/dev/null) && break
    sleep 0.2
  done
  kill "$server"
  wait "$server" || fail "the service ends with status $?"
  [[ $answer == *"<title>"* ]] || { cat "$root/tmp/messages"; fail "the service has no page"; }
  echo "the service hands out its page"
}

for suite in "$@"; do
  say "$suite"
  (check "$suite")
  finish
  new_root
done
say "passed"
