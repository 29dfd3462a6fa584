#include "io/exchange/label_candidates.h"

#include <algorithm>
#include <set>

#include "io/image/label_voxels.h"

namespace coapt {
namespace {

/// Numbers that other programs and public sets give the leaflets. Sets of whole hearts (MM-WHS, TotalSegmentator) and of chambers
/// in echo (CAMUS, MITEA) have no labels of leaflets; SlicerHeart's terminology names them and numbers none.
struct Convention {
  int anterior, posterior;
  const char* name;
};
constexpr std::array kConventions = {
    // Annulus 3, and 4 for that of the aortic valve, in github.com/velluma/mvseg, README.
    Convention{kUsualAnterior, 2, "the numbering of coapt and most tools"},
    // No annulus. Carnahan et al. 2023, synapse.org, syn51186045; github.com/openmedlab/Awesome-Medical-Dataset, MVSeg-3DTEE.md.
    Convention{2, 1, "the numbering of the public data set MVSeg2023"},
    // Annulus 1. Munafo et al. 2023 (IEEE Access, arXiv 2302.10634); github.com/rmuna96/mvtool, src/metricsfromnifti.py.
    Convention{2, 3, "the numbering of mv3Dseg and mvtool (Politecnico di Milano)"},
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
