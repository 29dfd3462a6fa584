#!/bin/bash
# arm64_root.sh: unpacks the libraries that coapt is built against (group build of packages.txt) for 64-bit ARM into build/arm64-root, from
# the archives of this machine's apt. Nothing in it runs, and apt itself learns no other architecture.
set -euo pipefail
cd "$(dirname "$0")/../.."
root=build/arm64-root

release=$(. /etc/os-release && echo "$VERSION_CODENAME")
packages=$(awk '$1 == "build" && $2 ~ /-dev$/ && $2 !~ /python|pybind/ { print $2 }' cmake/packages.txt | paste --serial --delimiters=,)
[[ $packages != "$(cat "$root/.complete" 2>/dev/null)" ]] || exit 0
rm -rf "$root"
mkdir -p build
apt-get indextargets --format "deb \$(SITE) \$(RELEASE) \$(COMPONENT)" "Created-By: Packages" | sort --unique | grep " $release" |
  mmdebstrap --quiet --arch=arm64 --variant=extract --include="$packages,libc6-dev,libstdc++6,libgomp1" "$release" "$root" -
# Links of Debian's begin at the root, which is this machine's for the linker.
find "$root/usr" -type l -lname '/*' -printf '%p %l\n' | while read -r link target; do ln -srf "$root$target" "$link"; done
echo "$packages" >"$root/.complete"
