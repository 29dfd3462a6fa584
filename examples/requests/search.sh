#!/bin/bash
# search.sh VALVE [SEARCH]: stores a valve file, searches repair plans for it, prints them ranked.
#
# VALVE is a coapt.valve/1, SEARCH the "search" of a request ({} by default). COAPT_SERVER says where the service is
# (http://127.0.0.1:8080), COAPT_TOKEN its token. Ctrl-C ends the search early; its best so far is printed.
set -euo pipefail

url=${COAPT_SERVER:-http://127.0.0.1:8080}
[[ $# -eq 1 || $# -eq 2 ]] || { sed -n '2,5s/^# \?//p' "$0" >&2; exit 2; }
answer=$(mktemp)
trap 'rm -f "$answer"' EXIT

# call PATH OPTION...: the answer is in the file `answer`; one that refuses is printed, and ends this script. curl
# tries again where the service is busy, and leaves Ctrl-C to the loop below; one that came before it was ignored (130)
# costs a second try. The token does not appear among the processes.
call() {
  local status=130 try
  for try in 1 2; do
    [[ $status -eq 130 ]] || break
    status=0
    (
      trap '' INT
      curl --silent --show-error --fail-with-body --retry 5 --output "$answer" \
        --config <([[ -z ${COAPT_TOKEN:-} ]] || printf 'header = "Authorization: Bearer %s"\n' "$COAPT_TOKEN") \
        "${@:2}" "$url$1"
    ) || status=$?
  done
  [[ $status -eq 0 ]] || { cat "$answer" >&2; exit 1; }
}

# field NAME: of the answer.
field() (
  trap '' INT
  python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))[sys.argv[2]])' "$answer" "$1"
)

call /v1/valves --header 'Content-Type: application/json' --data-binary "@$1"
search='{}'
[[ $# -eq 1 ]] || search=$(<"$2")
request="{\"valve\": \"$(field id)\", \"search\": $search}"

# With a key of its own the request can be repeated without a second search, should its answer be lost.
key=$(</proc/sys/kernel/random/uuid)
cancelled=false
trap 'cancelled=true' INT
call /v1/plans --header 'Content-Type: application/json' --data-binary "$request" --header "Idempotency-Key: $key"
id=$(field id) || id=$(field id)
job=/v1/jobs/$id

until [[ $(field state) =~ SUCCEEDED|FAILED|CANCELLED ]]; do
  sleep 0.5 || true
  if $cancelled; then
    cancelled=false
    call "$job:cancel" --request POST --data ''
  fi
  call "$job"
done

python3 - "$answer" <<'PYTHON'
import json, sys

job = json.load(open(sys.argv[1]))
for problem in job["problems"]:
    print(problem["message"], file=sys.stderr)
for plan in job["plans"] or []:
    leak = plan["leak_mm2"]
    region = "" if leak["mean"] is None else f", {leak['mean']:.1f} (sd {leak['sd']:.1f}) over its region"
    print(f"{plan['rank']:2}. leak {leak['nominal']:.1f} mm2 as planned{region}; cost {plan['cost']:.1f}")
    print(*(f"    {line}" for line in plan["description"]), sep="\n")
print(job["notice"], file=sys.stderr)
sys.exit(job["state"] == "FAILED")
PYTHON
