# Asks a service for a closure and for its picture, with curl alone; COAPT_SERVER says where it is.
plan='{"schema": "coapt.plan/1", "steps": [{"step": "annuloplasty", "shape": "generic-classic", "size_mm": 34}]}'
ask() { curl --silent --show-error --fail -H "Authorization: Bearer ${COAPT_TOKEN:-}" "$@"; }
ask -d "{\"valve\": \"human-functional-mr\", \"plan\": $plan}" "$COAPT_SERVER/v1/closures" |
  python3 -c 'import json, sys; answer = json.load(sys.stdin); print(answer["status"], round(answer["leak_mm2"], 1), "mm2")'
ask -d "{\"valve\": \"human-functional-mr\", \"plan\": $plan}" "$COAPT_SERVER/v1/pictures" > a_closure.png
