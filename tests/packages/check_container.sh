#!/bin/bash
# check_container.sh DEBS: builds examples/deploy/Containerfile with buildah and runs the service in it. No registry is asked: the
# image to begin with is made by mmdebstrap from this machine's sources of apt. Needs root and the network.
set -euo pipefail
[[ $# -eq 1 && -d $1 ]] || { sed -n '2,3s/^# \{0,1\}//p' "$0" >&2; exit 2; }
# shellcheck source=tests/packages/bare_debian.sh
source "$(dirname "$0")/bare_debian.sh"

containerfile=$(cd "$(dirname "$0")/../.." && pwd)/examples/deploy/Containerfile
debs=$(realpath "$1")
export STORAGE_DRIVER=vfs BUILDAH_ISOLATION=chroot
storage=(--root "$root/storage" --runroot "$root/run")

sources_of bookworm | mmdebstrap --quiet --mode=root --variant=apt bookworm "$root/debian.tar" -
base=$(buildah "${storage[@]}" from scratch)
buildah "${storage[@]}" add --quiet "$base" "$root/debian.tar" /
buildah "${storage[@]}" commit --quiet "$base" localhost/debian-12 >/dev/null

buildah "${storage[@]}" build --quiet --network host --build-arg BASE=localhost/debian-12 --tag localhost/coapt-server --file "$containerfile" "$debs"
container=$(buildah "${storage[@]}" from localhost/coapt-server)
token=$(head -c 32 /dev/urandom | base64)
printf '%s\n' "$token" >"$root/token"
chown 990 "$root/token"
chmod 0400 "$root/token"
mapfile -t entry < <(buildah "${storage[@]}" inspect --format '{{range .OCIv1.Config.Entrypoint}}{{println .}}{{end}}' "$container" | sed '/^$/d')
buildah "${storage[@]}" run --network host --volume "$root/token:/run/secrets/coapt-token:ro" "$container" -- "${entry[@]}" --port 8091 &
ask() { curl --silent --fail --retry 30 --retry-delay 1 --retry-connrefused --header "Authorization: Bearer $token" "$@"; }
ask http://127.0.0.1:8091/version
ask http://127.0.0.1:8091/ | grep --quiet '<title>'
ask --data '{"valve": "human-normal"}' http://127.0.0.1:8091/v1/closures | grep --only-matching '"status": *"[a-z]*"'
