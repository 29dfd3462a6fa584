#!/bin/bash
# fake_farm.sh: speaks as coapt-farm does to whoever asks; the label says what it does.
set -eu
test "$1 $2 $3 $4" = "add - --wait --progress-json"
case ${6:-} in
  echo) # answers with what it was sent, while it is being sent
    cat
    ;;
  progress)
    cat >/dev/null
    echo '{"done": 256, "items": 1000, "workers": 3, "rate_per_s": 12.5, "eta_s": 59.5}' >&2
    printf '{"done": 1000, "items": 1000, "workers": 2, "rate_per_s": 13, "eta_s": 0}' >&2
    printf 'answer'
    ;;
  address) printf '%s' "$COAPT_FARM" ;;
  holes)
    echo '{"error": {"code": "unsupported", "path": "/keys/7", "message": "3 items were given up"}}' >&2
    exit 4
    ;;
  deaf) # reads nothing
    echo 'the database does not answer' >&2
    exit 1
    ;;
  waits) # ends by SIGTERM alone
    echo '{"done": 0, "items": 1, "workers": 0, "rate_per_s": 0, "eta_s": null}' >&2
    exec sleep 60
    ;;
  killed) kill -9 $$ ;;
esac
