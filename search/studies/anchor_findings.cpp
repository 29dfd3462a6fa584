#include "search/studies/anchor_findings.h"

#include <cmath>

#include "search/studies/finding_text.h"

namespace coapt {
namespace {

constexpr double kThesisLimit_mm2 = 2.0;  // thesis 4.4.2

/// Means over all approximations of what summaries give by class and anchor.
struct Overall {
  int configurations = 0, repaired = 0;
  double length_sd_mm2 = 0.0, angle_sd_mm2 = 0.0, length_slope = 0.0, swing_slope = 0.0;
};

Overall overall(const std::vector<AnchorSummary>& summaries) {
  Overall all;
  for (const AnchorSummary& s : summaries) {
    all.configurations += s.configurations;
    all.repaired += s.repaired;
    all.length_sd_mm2 += s.length_sd_mm2 * s.configurations;
    all.angle_sd_mm2 += s.angle_sd_mm2 * s.configurations;
    all.length_slope += s.length_slope_mm2_per_mm * s.configurations;
    all.swing_slope += s.swing_slope_mm2_per_mm * s.configurations;
  }
  for (double* mean : {&all.length_sd_mm2, &all.angle_sd_mm2, &all.length_slope, &all.swing_slope})
    *mean /= all.configurations;
  return all;
}

std::string of_pairs(int smaller, const PairedAnchors& pairs) {
  return "smaller in " + in_percent(static_cast<double>(smaller) / pairs.configurations) + " of " +
         std::to_string(pairs.configurations) + " displacements";
}

}  // namespace

std::vector<Finding> anchor_findings(const ApproximationStudy& study) {
  const std::string prefix = std::string(to_string(study.protocol)) + "/";
  const std::vector<AnchorSummary> summaries = summarise(study);
  std::vector<Finding> all;
  if (summaries.empty()) return all;
  const Overall mean = overall(summaries);
  all.push_back({prefix + "approximation-always-repairs", "4.3.2",
                 "effective whatever the initial position and the anchor",
                 std::to_string(mean.repaired) + " of " + std::to_string(mean.configurations) +
                     " below 5 mm2",
                 "all", mean.repaired == mean.configurations});
  all.push_back({prefix + "length-matters-more-than-angle", "4.3.2",
                 "more sensitive to suture length than to angle, as it moves the tip apically",
                 in_words(mean.length_slope, 1) + " mm2 per mm of suture, " +
                     in_words(mean.swing_slope, 1) + " per mm of swing",
                 "per mm of the tip's way, length's is the larger",
                 mean.length_slope > mean.swing_slope});
  all.push_back({prefix + "length-varies-the-region-more-than-angle", "4.3.2",
                 "the same over the region: +-1 mm of suture, +-5 degrees of swing",
                 "sd by length " + in_words(mean.length_sd_mm2, 2) + ", by angles " +
                     in_words(mean.angle_sd_mm2, 2) + " mm2",
                 "length's is the larger", mean.length_sd_mm2 > mean.angle_sd_mm2});
  for (const Displaced displaced : kDisplaced) {
    const AnchorSummary* trigone = find_summary(summaries, study.protocol, displaced, "trigone");
    const AnchorSummary* peak = find_summary(summaries, study.protocol, displaced, "saddle peak");
    if (trigone == nullptr || peak == nullptr) continue;
    const std::string of = std::string("-") + to_string(displaced);
    const PairedAnchors pairs = pair_anchors(study, displaced);
    std::string note;
    if (trigone->clamped_share > 0.0)
      note = "; " + in_percent(trigone->clamped_share) + " of the trigone's and " +
             in_percent(peak->clamped_share) + " of the peak's nodes outside the grid";
    const auto compare = [&](const std::string& name, const std::string& says, double ours,
                             double theirs, const std::string& more) {
      const bool tie = std::abs(ours - theirs) <= kAnchorTie * theirs;
      all.push_back({prefix + name + of, "4.3.2", says,
                     "trigone " + in_words(ours, 2) + ", saddle peak " + in_words(theirs, 2) +
                         " mm2" + (tie ? ", a tie" : "") + more,
                     "the trigone's is smaller by more than 1 %", ours < theirs && !tie});
    };
    compare("trigone-smaller-sd", "trigones: smaller standard deviation within the regions",
            trigone->sd_mm2, peak->sd_mm2, "; " + of_pairs(pairs.smaller_sd, pairs) + note);
    compare("trigone-smaller-mean", "trigones: smaller mean orifice within the regions",
            trigone->mean_mm2, peak->mean_mm2, "; " + of_pairs(pairs.smaller_mean, pairs) + note);
    compare("trigone-smaller-sd-of-means", "trigones: smaller standard deviation across the means",
            trigone->sd_of_means_mm2, peak->sd_of_means_mm2, note);
    compare("trigone-less-sensitive-to-length", "trigones: less sensitive to suture length (4.4.2)",
            trigone->length_sd_mm2, peak->length_sd_mm2, note);
    if (displaced != Displaced::Both)
      all.push_back({prefix + "trigone-sensitivity-below-2" + of, "4.4.2",
                     "sensitivity at the trigones below 2 mm2",
                     "sd by suture length " + in_words(trigone->length_sd_mm2, 2) +
                         ", across the means " + in_words(trigone->sd_of_means_mm2, 2) +
                         ", whole region " + in_words(trigone->sd_mm2, 2) + " mm2",
                     "by suture length", trigone->length_sd_mm2 < kThesisLimit_mm2});
  }
  return all;
}

}  // namespace coapt
