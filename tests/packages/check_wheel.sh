#!/bin/bash
# check_wheel.sh WHEEL: installed by pip in a bare Debian 12, without network and without numpy, the engine closes and searches; with
# numpy, which pip would fetch, it has arrays, and says of bad ones what is wrong. Prints seconds and megabytes to the first plan.
set -euo pipefail
[[ $# -eq 1 && -f $1 ]] || { sed -n '2,3s/^# \{0,1\}//p' "$0" >&2; exit 2; }
# shellcheck source=tests/packages/bare_debian.sh
source "$(dirname "$0")/bare_debian.sh"

wheel=$(realpath "$1")

make_bare bookworm
within apt-get update -qq
before=$(megabytes)
say "from nothing to a plan"
within apt-get install --print-uris -qq -y --no-install-recommends python3-venv | awk '/^.http/ { sum += $3 } END { printf "to download: %.1f MB of Python, ", sum / 1e6 }'
awk -v bytes="$(stat --format %s "$wheel")" 'BEGIN { printf "and the wheel, %.1f MB\n", bytes / 1e6 }'
cp "$wheel" "$root/tmp/"
start=$EPOCHREALTIME
apt_install python3-venv
python=$EPOCHREALTIME
within python3 -m venv /opt/venv
within /opt/venv/bin/pip install --quiet --no-index --no-deps --disable-pip-version-check --root-user-action=ignore "/tmp/${wheel##*/}"
installed=$EPOCHREALTIME
within apt-get clean
echo "installed: $(($(megabytes) - before)) MB more than the $before MB of the Debian without it"
within /opt/venv/bin/python - <<'END'
import coapt

result = coapt.engine().search("human-functional-mr", evaluations=60, region_points=65, plans=1).result()
plan = result.plans[0]
print("first plan:", *plan.description, "leak as planned", plan.leak_mm2.nominal, "mm2")
END
echo "seconds: $(seconds "$start" "$python") to install Python, $(seconds "$python" "$installed") the wheel, $(seconds "$installed" "$EPOCHREALTIME") to the first ranked plan, $(seconds "$start" "$EPOCHREALTIME") together"

say "a closure in a line"
within /opt/venv/bin/python -c "import coapt; print(coapt.preset('human-normal').close().measure.leak_mm2)"
if within sh -c 'ldd /opt/venv/lib/python3.*/site-packages/coapt/_engine*.so' | grep 'not found'; then fail "libraries are missing"; fi

say "with numpy"
apt_install python3-numpy
within python3 -m venv --system-site-packages /opt/venv
within /opt/venv/bin/pip check --disable-pip-version-check
within /opt/venv/bin/python - <<'END'
import hashlib
import ssl
import sqlite3

import numpy

import coapt

valve = coapt.preset("human-normal")
assert valve.close().closed_mm.shape == valve.vertices_mm.shape
assert valve.with_arrays(vertices_mm=valve.vertices_mm.astype(numpy.float32)).close().status == "converged"
for arrays in (
    {"vertices_mm": valve.vertices_mm[:, :2]},
    {"vertices_mm": numpy.full_like(valve.vertices_mm, numpy.nan)},
):
    try:
        valve.with_arrays(**arrays)
        raise SystemExit("taken")
    except coapt.BadDocument as error:
        print(f"{type(error).__name__}: {error}")
# Python's own libraries beside the wheel's.
print(ssl.OPENSSL_VERSION, sqlite3.sqlite_version, hashlib.new("sha256", b"").hexdigest()[:8])
END
say "passed"
