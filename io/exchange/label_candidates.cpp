#include "io/exchange/label_candidates.h"

#include <algorithm>
#include <set>

#include "io/image/label_voxels.h"

namespace coapt {
namespace {

/// Numbers that other programs and public sets give the leaflets.
struct Convention {
  int anterior, posterior;
  const char* name;
};
constexpr std::array kConventions = {
    Convention{kUsualAnterior, 2, "the numbering of coapt and most tools"},
    Convention{2, 1, "the numbering of the public data set MVSeg2023"},
};

}  // namespace

std::string convention(int anterior, int posterior) {
  for (const Convention& known : kConventions)
    if (known.anterior == anterior && known.posterior == posterior) return known.name;
  return {};
}

const char* option_of(ValvePart part) {
  return part == ValvePart::Anterior    ? "anterior"
         : part == ValvePart::Posterior ? "posterior"
                                        : "annulus";
}

const char* words_of(ValvePart part) {
  return part == ValvePart::Anterior    ? "anterior leaflet"
         : part == ValvePart::Posterior ? "posterior leaflet"
                                        : "annulus";
}

NamedPart named(ValvePart part) {
  return part == ValvePart::Anterior    ? NamedPart::Anterior
         : part == ValvePart::Posterior ? NamedPart::Posterior
                                        : NamedPart::Annulus;
}

bool is_like(const LabelShape& shape, const LabelShape& other) {
  const double thick = shape.thickness / other.thickness;
  const double large = static_cast<double>(shape.voxels) / static_cast<double>(other.voxels);
  return thick > 0.4 && thick < 2.5 && large > 0.1 && large < 10.0;
}

std::vector<LabelCandidate> candidates(const LabelMap& map) {
  std::vector<LabelCandidate> all;
  std::set<int> values, layers;
  for (const LabelAt& label : labels_of(map)) {
    LabelCandidate& candidate = all.emplace_back();
    candidate.label = label;
    candidate.number = label.value;
    values.insert(label.value);
    layers.insert(label.layer);
    for (const LabelName& name : map.names)
      if (name.layer == label.layer && name.value == label.value) candidate.name = name.name;
    candidate.meant = part_named(candidate.name);
  }
  if (values.size() < all.size() && layers.size() == all.size())
    for (LabelCandidate& candidate : all) candidate.number = candidate.label.layer + 1;
  return all;
}

LabelShape shape_of(const LabelMap& map, const LabelCandidate& candidate) {
  const LabelVoxels voxels(map, candidate.label);
  const LabelBox box = voxels.box();
  const Index crossings = voxels.crossings(box);
  return {2.0 * static_cast<double>(box.count) / static_cast<double>(std::max<Index>(1, crossings)),
          box.count};
}

}  // namespace coapt
