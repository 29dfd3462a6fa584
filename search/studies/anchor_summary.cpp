#include "search/studies/anchor_summary.h"

#include <algorithm>
#include <cmath>

namespace coapt {

std::vector<AnchorSummary> summarise(const ApproximationStudy& study) {
  std::vector<AnchorSummary> summaries;
  for (const Displaced displaced : kDisplaced)
    for (std::size_t anchor = 0; anchor < study.anchors.size(); ++anchor) {
      AnchorSummary s{study.protocol, displaced, study.anchors[anchor]};
      double squares = 0.0;
      for (const Approximation& found : study.approximations) {
        if (found.displaced != displaced || found.anchor != anchor) continue;
        const RegionOrifice& region = found.region;
        ++s.configurations;
        if (found.repaired) ++s.repaired;
        s.mean_mm2 += region.mean_mm2;
        squares += region.mean_mm2 * region.mean_mm2;
        s.sd_mm2 += region.sd_mm2;
        s.length_sd_mm2 += region.length_sd_mm2;
        s.angle_sd_mm2 += region.angle_sd_mm2;
        s.length_slope_mm2_per_mm += region.length_slope_mm2_per_mm;
        s.swing_slope_mm2_per_mm += region.swing_slope_mm2_per_mm;
        if (found.repaired) {
          s.movement_mm += found.movement_mm;
          s.suture_mm += found.suture_mm;
        }
        s.leaking_share += region.leaking_share;
        s.clamped_share += region.clamped_share;
      }
      if (s.configurations == 0) continue;
      const double n = s.configurations;
      for (double* mean :
           {&s.mean_mm2, &s.sd_mm2, &s.length_sd_mm2, &s.angle_sd_mm2, &s.length_slope_mm2_per_mm,
            &s.swing_slope_mm2_per_mm, &s.leaking_share, &s.clamped_share})
        *mean /= n;
      s.movement_mm /= s.repaired;  // NaN if there is none
      s.suture_mm /= s.repaired;
      s.sd_of_means_mm2 = std::sqrt(std::max(0.0, squares / n - s.mean_mm2 * s.mean_mm2));
      summaries.push_back(s);
    }
  return summaries;
}

const AnchorSummary* find_summary(const std::vector<AnchorSummary>& summaries, Protocol protocol,
                                  Displaced displaced, const std::string& anchor) {
  const auto found = std::find_if(summaries.begin(), summaries.end(), [&](const auto& s) {
    return s.protocol == protocol && s.displaced == displaced && s.anchor.name == anchor;
  });
  return found == summaries.end() ? nullptr : &*found;
}

PairedAnchors pair_anchors(const ApproximationStudy& study, Displaced displaced) {
  PairedAnchors pairs;
  for (const Approximation& trigone : study.approximations) {
    if (trigone.displaced != displaced || study.anchors[trigone.anchor].name != "trigone") continue;
    for (const Approximation& peak : study.approximations) {
      if (peak.displaced != displaced || peak.displaced_mm != trigone.displaced_mm ||
          study.anchors[peak.anchor].name != "saddle peak")
        continue;
      ++pairs.configurations;
      if (trigone.region.mean_mm2 < peak.region.mean_mm2) ++pairs.smaller_mean;
      if (trigone.region.sd_mm2 < peak.region.sd_mm2) ++pairs.smaller_sd;
    }
  }
  return pairs;
}

}  // namespace coapt
