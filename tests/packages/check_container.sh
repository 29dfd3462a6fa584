#!/bin/bash
# check_container.sh DEBS: builds examples/deploy/Containerfile with buildah and runs the service in it. No registry is asked: the
# image to begin with is made by mmdebstrap from this machine's sources of apt. Needs root and the network.
set -euo pipefail
[[ $# -eq 1 && -d $1 ]] || { sed -n '2,3s/^# \{0,1\}//p' "$0" >&2; exit 2; }

containerfile=$(cd "$(dirname "$0")/../.." && pwd)/examples/deploy/Containerfile
debs=$(realpath "$1")
folder=$(mktemp -d /var/tmp/coapt-container-XXXXXX)
export STORAGE_DRIVER=vfs BUILDAH_ISOLATION=chroot
storage=(--root "$folder/storage" --runroot "$folder/run")
server=
finish() {
  [[ -z $server ]] || kill "$server" 2>/dev/null || true
  buildah "${storage[@]}" rm --all >/dev/null 2>&1 || true
  buildah "${storage[@]}" rmi --all --force >/dev/null 2>&1 || true
  # Mounts of a container that was killed are this machine's: not reached.
  rm -rf --one-file-system "$folder"
}
trap finish EXIT

mapfile -t sources < <(grep -lE '^Suites:.*\bbookworm\b' /etc/apt/sources.list.d/*.sources)
mmdebstrap --quiet --mode=root --variant=apt bookworm "$folder/debian.tar" "${sources[@]}"
base=$(buildah "${storage[@]}" from scratch)
buildah "${storage[@]}" add --quiet "$base" "$folder/debian.tar" /
buildah "${storage[@]}" commit --quiet "$base" localhost/debian-12 >/dev/null

buildah "${storage[@]}" build --quiet --network host --build-arg BASE=localhost/debian-12 --tag localhost/coapt-server --file "$containerfile" "$debs"
container=$(buildah "${storage[@]}" from localhost/coapt-server)
token=$(head -c 32 /dev/urandom | base64)
printf '%s\n' "$token" >"$folder/token"
chown 990 "$folder/token"
chmod 0400 "$folder/token"
mapfile -t entry < <(buildah "${storage[@]}" inspect --format '{{range .OCIv1.Config.Entrypoint}}{{println .}}{{end}}' "$container" | sed '/^$/d')
buildah "${storage[@]}" run --network host --volume "$folder/token:/run/secrets/coapt-token:ro" "$container" -- "${entry[@]}" --port 8091 &
server=$!
ask() { curl --silent --fail --retry 30 --retry-delay 1 --retry-connrefused --header "Authorization: Bearer $token" "$@"; }
ask http://127.0.0.1:8091/version
ask http://127.0.0.1:8091/ | grep --quiet '<title>'
ask --data '{"valve": "human-normal"}' http://127.0.0.1:8091/v1/closures | grep --only-matching '"status": *"[a-z]*"'
