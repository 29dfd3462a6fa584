// Volumes that stand one after the other in a file: phases of the heart, of which one is used, or masks of which each is one label
// ("one-hot"), as neural networks write them. Masks are told by their numbers, 0 and 1 alone in all volumes, and by their places: those of a
// label are elsewhere than those of another, while in phases the same leaflets hardly move.
#pragma once

#include "io/image/voxel_stream.h"

namespace coapt {

/// Into the map: one phase, or each mask as a layer of its own but for the background's, which is what no other has.
/// @param phase from 1; 0: the first that has labels, or the first. @pre map.phases
Errors read_phase(ByteStream& stream, const VoxelLayout& of_a_phase, int phase, Index most_voxels,
                  LabelMap& map);

}  // namespace coapt
