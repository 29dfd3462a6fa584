#!/bin/bash
# start_workers.sh [--stop] HOSTS: workers of a farm on machines that ssh reaches. HOSTS is a file with a machine a line, and how many
# workers it is to run (1 if nothing is said); lines that begin with # are left out:
#
#   node1 8
#   node2 8
#
# The database's address, COAPT_FARM, goes over standard input, so that no list of processes shows its password. Workers go on when
# ssh has ended, write to coapt-work-N.log in the home directory, and end when no work is left. --stop ends those that run: they give
# back what they hold.
set -euo pipefail

stop=
if [[ ${1:-} == --stop ]]; then
  stop=yes
  shift
fi
[[ $# -eq 1 ]] || { sed -n '2,11s/^# \{0,1\}//p' "$0" >&2; exit 2; }
[[ -n $stop ]] || : "${COAPT_FARM:?is not set: the address of the farm database}"

failed=0
while read -r host workers _ <&3; do
  [[ -n $host && $host != \#* ]] || continue
  if [[ -n $stop ]]; then
    ssh "$host" 'pkill -TERM -u "$(id -u)" -x coapt-farm || true' || failed=1
    continue
  fi
  # read, then started without a terminal: each in a session of its own.
  ssh "$host" "read -r COAPT_FARM && export COAPT_FARM && command -v coapt-farm >/dev/null &&
    for n in \$(seq ${workers:-1}); do
      setsid nohup coapt-farm work --until-dry --threads 1 --name \"\$(hostname)-\$n\" >coapt-work-\$n.log 2>&1 </dev/null &
    done" <<<"$COAPT_FARM" || { echo "$host: no workers started" >&2; failed=1; }
done 3<"$1"
exit "$failed"
