#include <algorithm>

#include "search/studies/finding_text.h"
#include "search/studies/findings_parts.h"

namespace coapt {
namespace {

const AnchorSummary* find(const std::vector<AnchorSummary>& summaries, Displaced displaced,
                          const std::string& anchor) {
  const auto found = std::find_if(summaries.begin(), summaries.end(), [&](const auto& s) {
    return s.displaced == displaced && s.anchor.name == anchor;
  });
  return found == summaries.end() ? nullptr : &*found;
}

std::string one_against_other(double trigone, double peak, int decimals = 2) {
  return "trigone " + in_words(trigone, decimals) + ", saddle peak " + in_words(peak, decimals);
}

}  // namespace

std::vector<Finding> anchor_findings(const ApproximationStudy& study) {
  const std::string prefix = std::string(to_string(study.protocol)) + "/";
  const std::vector<AnchorSummary> summaries = summarise(study);
  std::vector<Finding> all;
  int configurations = 0, repaired = 0;
  double length = 0.0, angle = 0.0;
  for (const AnchorSummary& s : summaries) {
    configurations += s.configurations;
    repaired += s.repaired;
    length += s.length_sd_mm2 * s.configurations;
    angle += s.angle_sd_mm2 * s.configurations;
  }
  if (configurations == 0) return all;
  length /= configurations;
  angle /= configurations;
  all.push_back(
      {prefix + "approximation-always-repairs", "4.3.2",
       "effective whatever the initial position and the anchor",
       std::to_string(repaired) + " of " + std::to_string(configurations) + " below 5 mm2", "all",
       repaired == configurations});
  all.push_back({prefix + "length-matters-more-than-angle", "4.3.2",
                 "more sensitive to suture length than to angle",
                 "sd in the region by length (+-1 mm) " + in_words(length, 2) +
                     ", by angles (+-5 degrees) " + in_words(angle, 2) + " mm2",
                 "length's is the larger", length > angle});
  for (const Displaced displaced : kDisplaced) {
    const AnchorSummary* trigone = find(summaries, displaced, "trigone");
    const AnchorSummary* peak = find(summaries, displaced, "saddle peak");
    if (trigone == nullptr || peak == nullptr) continue;
    const std::string of = std::string("-") + to_string(displaced);
    const auto compare = [&](const std::string& name, const std::string& says, double ours,
                             double theirs) {
      all.push_back({prefix + name + of, "4.3.2", says, one_against_other(ours, theirs) + " mm2",
                     "the trigone's is smaller", ours < theirs});
    };
    compare("trigone-smaller-sd", "trigones: smaller standard deviation within the regions",
            trigone->sd_mm2, peak->sd_mm2);
    compare("trigone-smaller-mean", "trigones: smaller mean orifice within the regions",
            trigone->mean_mm2, peak->mean_mm2);
    compare("trigone-smaller-sd-of-means", "trigones: smaller standard deviation across the means",
            trigone->sd_of_means_mm2, peak->sd_of_means_mm2);
    compare("trigone-less-sensitive-to-length", "trigones: less sensitive to suture length (4.4.2)",
            trigone->length_sd_mm2, peak->length_sd_mm2);
    if (displaced != Displaced::Both)
      all.push_back({prefix + "trigone-varies-by-less-than-2" + of, "4.4.2",
                     "sensitivity at the trigones below 2 mm2",
                     "sd across the means " + in_words(trigone->sd_of_means_mm2, 2) +
                         ", within the regions " + in_words(trigone->sd_mm2, 2) + " mm2",
                     "both below 2 mm2", trigone->sd_of_means_mm2 < 2.0 && trigone->sd_mm2 < 2.0});
  }
  return all;
}

}  // namespace coapt
