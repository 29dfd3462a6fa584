#!/bin/bash
# quick_start.sh [DIRECTORY]: a farm on this machine, to see one at work: a PostgreSQL of its own on a Unix socket, two workers, and the
# study of how general the thesis's findings are, with figures in DIRECTORY/generality (DIRECTORY: out/farm). All of it ends with the
# script; the results stay. Needs PostgreSQL 15 (Debian: postgresql-15) and coapt in PATH.
#
#   ANATOMIES=20 WORKERS=4 quick_start.sh
set -euo pipefail

directory=$(realpath -m "${1:-out/farm}")
postgres=${POSTGRES_BIN:-/usr/lib/postgresql/15/bin}
[[ -x $postgres/initdb ]] || { echo "quick_start.sh: no PostgreSQL in $postgres (Debian: apt install postgresql-15; elsewhere set POSTGRES_BIN)" >&2; exit 1; }
mkdir -p "$directory"

# PostgreSQL does not run as root.
as_postgres=()
[[ $(id -u) -ne 0 ]] || as_postgres=(setpriv --reuid=postgres --regid=postgres --init-groups)
database=$(mktemp -d /tmp/coapt-farm-XXXXXX)
workers=()
finish() {
  kill "${workers[@]}" 2>/dev/null || true
  wait
  "${as_postgres[@]}" "$postgres/pg_ctl" -D "$database/data" -m fast stop >/dev/null 2>&1 || true
  rm -rf "$database"
}
trap finish EXIT
[[ $(id -u) -ne 0 ]] || chown postgres "$database"
cd "$database"
# No TCP; the socket lies in a directory that is this user's alone.
"${as_postgres[@]}" "$postgres/initdb" -D "$database/data" -U coapt --auth=trust >"$directory/postgresql.log"
"${as_postgres[@]}" "$postgres/pg_ctl" -D "$database/data" -l "$database/log" -o "-h '' -k $database" -w start >>"$directory/postgresql.log"
export COAPT_FARM="postgresql:///postgres?host=$database&user=coapt"
cd "$directory"

coapt-farm init
for n in $(seq "${WORKERS:-2}"); do
  coapt-farm work --threads 1 --name "worker-$n" 2>"$directory/worker-$n.log" &
  workers+=($!)
done
coapt study generality --anatomies "${ANATOMIES:-4}" --farm "$COAPT_FARM" -o "$directory/generality"
coapt-farm status
