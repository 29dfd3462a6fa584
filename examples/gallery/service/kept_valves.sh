# Stores a valve in a service, asks why it leaks by its id, and draws the valve as the service has it.
ask() { curl --silent --show-error --fail -H "Authorization: Bearer ${COAPT_TOKEN:-}" "$@"; }
id=$(ask --data-binary @examples/valves/bodyparts3d-leaking.json "$COAPT_SERVER/v1/valves" |
  python3 -c 'import json, sys; print(json.load(sys.stdin)["id"])')
ask -d "{\"valve\": \"$id\"}" "$COAPT_SERVER/v1/diagnoses" |
  python3 -c 'import json, sys; print(json.load(sys.stdin)["sentence"])'
ask -d "{\"valve\": \"$id\"}" "$COAPT_SERVER/v1/pictures" > kept_valves.png
