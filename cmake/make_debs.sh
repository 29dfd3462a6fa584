#!/bin/bash
# make_debs.sh [OPTION...]: the Debian packages of the last commit, with their source, in build/deb. OPTIONs are dpkg-buildpackage's.
# The page is taken along as it was built (make web static), the site of documents if it was (make docs): a package is built without
# the network.
set -euo pipefail
cd "$(dirname "$0")/.."

[[ -z $(git status --porcelain) ]] || echo "make_debs.sh: the packages are of the last commit, without the changes since" >&2
version=$(dpkg-parsechangelog --show-field Version)
rm -rf build/deb
tree=build/deb/coapt-$version
mkdir -p "$tree/build"
git archive HEAD | tar --extract --directory "$tree"
for built in web static docs; do
  [[ ! -d build/$built ]] || cp --archive "build/$built" "$tree/build/"
done
(cd "$tree" && dpkg-buildpackage --unsigned-source --unsigned-changes "$@")
rm -rf "$tree"
