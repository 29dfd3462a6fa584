#include "io/image/label_phases.h"

#include <algorithm>

namespace coapt {
namespace {

using Volume = std::vector<std::uint16_t>;

constexpr int kMostMasks = 64;
constexpr double kMostShared = 0.5;  // of the smaller of two masks, in both

Index count_of(const Volume& mask) {
  return std::count_if(mask.begin(), mask.end(), [](std::uint16_t label) { return label != 0; });
}

Index shared(const Volume& a, const Volume& b) {
  Index count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != 0 && b[i] != 0 ? 1 : 0;
  return count;
}

/// Two at least that are not empty, all elsewhere.
bool are_labels(const std::vector<Volume>& masks) {
  std::vector<const Volume*> filled;
  for (const Volume& mask : masks)
    if (count_of(mask) > 0) filled.push_back(&mask);
  for (std::size_t i = 0; i < filled.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Index smaller = std::min(count_of(*filled[i]), count_of(*filled[k]));
      if (static_cast<double>(shared(*filled[i], *filled[k])) >
          kMostShared * static_cast<double>(smaller))
        return false;
    }
  return filled.size() > 1;
}

/// The mask of all voxels that no other one has; its place, or the end.
std::size_t background_of(const std::vector<Volume>& masks) {
  Volume count(masks[0].size(), 0);
  for (const Volume& mask : masks)
    for (std::size_t i = 0; i < mask.size(); ++i)
      count[i] = static_cast<std::uint16_t>(count[i] + mask[i]);
  if (std::any_of(count.begin(), count.end(), [](std::uint16_t of) { return of == 0; }))
    return masks.size();
  for (std::size_t k = 0; k < masks.size(); ++k) {
    bool alone = 2 * count_of(masks[k]) > std::ssize(count);
    for (std::size_t i = 0; alone && i < count.size(); ++i)
      alone = masks[k][i] == 0 || count[i] == 1;
    if (alone) return k;
  }
  return masks.size();
}

void take_masks(std::vector<Volume> masks, LabelMap& map) {
  map.masks = static_cast<int>(masks.size());
  map.phases = 1;
  if (const std::size_t background = background_of(masks); background < masks.size())
    masks.erase(masks.begin() + static_cast<std::ptrdiff_t>(background));
  map.layers = static_cast<int>(masks.size());
  for (const Volume& mask : masks) map.voxels.insert(map.voxels.end(), mask.begin(), mask.end());
}

}  // namespace

Errors read_phase(ByteStream& stream, const VoxelLayout& of_a_phase, int phase, Index most_voxels,
                  LabelMap& map) {
  if (phase > map.phases)
    return {Error{ErrorCode::OutOfRange, "/phase",
                  "is " + std::to_string(phase) + ", must be from 1 to " +
                      std::to_string(map.phases) + ", the number of phases in the file"}};
  const auto take = [&](Volume volume, int at) {
    map.voxels = std::move(volume);
    map.phase = at;
    return Errors{};
  };
  bool only_masks = phase == 0 && map.phases > 1 && map.phases <= kMostMasks &&
                    static_cast<Index>(of_a_phase.count) <= most_voxels / map.phases;
  std::vector<Volume> read;  // masks, or empty ones
  for (int at = 1; at <= map.phases; ++at) {
    Expected<Volume> labels = read_labels(stream, of_a_phase);
    if (labels && at == map.phases)
      if (Errors errors = check_end(stream); !errors.empty()) return errors;
    if (!labels) return labels.errors();
    const std::uint16_t most = *std::max_element(labels->begin(), labels->end());
    only_masks = only_masks && most <= 1;
    if (!only_masks)
      for (std::size_t k = 0; k < read.size(); ++k)
        if (count_of(read[k]) > 0) return take(std::move(read[k]), static_cast<int>(k) + 1);
    if (at == phase || (phase == 0 && most > 0 && !only_masks)) return take(*std::move(labels), at);
    if (only_masks || read.empty()) read.push_back(*std::move(labels));
  }
  if (only_masks && are_labels(read)) {
    take_masks(std::move(read), map);
    return {};
  }
  for (std::size_t k = 0; k < read.size(); ++k)
    if (count_of(read[k]) > 0) return take(std::move(read[k]), static_cast<int>(k) + 1);
  return take(std::move(read[0]), 1);
}

}  // namespace coapt
