#!/bin/sh
# Builds the valves of real human anatomy in this folder from source/bodyparts3d (CC BY-SA 2.1 JP) with
# coapt itself. The program is build/release/bin/coapt, or $COAPT; the files go here, or to the folder
# named as the first argument.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
coapt=${COAPT:-$here/../../build/release/bin/coapt}
out=${1:-$here}
cd "$here/source/bodyparts3d"

# import NAME TRIANGLES FILE
import() {
  "$coapt" valve import --leaflet anterior_leaflet_sheet.obj posterior_leaflet_sheet.obj \
    --annulus annulus_centerline.csv --chordae chordae.csv --name "$1" --triangles "$2" -o "$3" \
    --provenance 'BodyParts3D, (c) The Database Center for Life Science licensed under CC Attribution-Share Alike 2.1 Japan; this file is adapted from it and under the same licence (https://creativecommons.org/licenses/by-sa/2.1/jp/)' \
    --provenance 'adult male, one half-open state, made by illustrators on an MRI-based body: anatomical-illustration grade, not a segmented scan' \
    --provenance 'before the import: parts welded, annulus and chordae traced to centre lines, leaflet sheets cut from the chordae strips (source/bodyparts3d/SOURCE.md)'
}

import bodyparts3d 720 "$out/bodyparts3d.json"
import bodyparts3d-1400 1400 "$out/bodyparts3d-1400.json"
import bodyparts3d-2600 2600 "$out/bodyparts3d-2600.json"

# Functional regurgitation as in thesis 4.2: a dilated annulus and papillary tips displaced outwards,
# backwards and apically, the posteromedial one more.
import bodyparts3d-leaking 720 - |
  "$coapt" valve remodel - --ap-dilation 15 --displace-al 1,1,1 --displace-pm 3,4,4 \
    --name bodyparts3d-leaking -o "$out/bodyparts3d-leaking.json"
