#include "search/studies/anchor_question.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/presets/presets.h"
#include "search/latin_hypercube.h"
#include "search/parallel.h"
#include "search/plans/objective.h"

namespace coapt {
namespace {

void ask(const Valve& valve, const OpenTable& open_table, const AnchorQuestionOptions& options,
         ScannedAnatomy& scanned) {
  OrificeTable table = open_table(valve);
  const Configuration undisturbed;
  const OrificeSample sample = table.at({&undisturbed, 1}).front();
  scanned.competent = sample.trusted && sample.area_mm2 <= kMildLeak_mm2;
  if (scanned.competent)
    for (const Protocol protocol : options.protocols)
      for (const AnchorSummary& summary : summarise(
               study_approximation(table, protocol, thesis_anchors(valve), options.approximation)))
        scanned.summaries.push_back(summary);
  scanned.closures = table.closures();
}

AnchorAnswer answer(const std::vector<ScannedAnatomy>& scan, Protocol protocol, Displaced displaced,
                    AnchorObjective objective) {
  AnchorAnswer found{protocol, displaced, objective};
  std::vector<std::vector<double>> shares;
  std::vector<double> differences;
  for (const ScannedAnatomy& scanned : scan) {
    const AnchorSummary* trigone = find_summary(scanned.summaries, protocol, displaced, "trigone");
    const AnchorSummary* other =
        find_summary(scanned.summaries, protocol, displaced, "saddle peak");
    if (trigone == nullptr || other == nullptr) continue;
    const double peak = value_of(*other, objective);
    const double difference = value_of(*trigone, objective) - peak;
    if (!std::isfinite(difference)) continue;  // an anchor that repairs nothing has no movement
    shares.push_back(scanned.shares);
    differences.push_back(difference);
    ++found.anatomies;
    if (std::abs(difference) <= kAnchorTie * std::abs(peak))
      ++found.ties;
    else if (difference < 0.0)
      ++found.trigone_wins;
    found.mean_difference += difference;
  }
  if (found.anatomies > 0) found.mean_difference /= found.anatomies;
  found.decided_by = sobol_indices(shares, differences);
  return found;
}

}  // namespace

const char* to_string(AnchorObjective objective) {
  switch (objective) {
    case AnchorObjective::Mean:
      return "mean";
    case AnchorObjective::Sd:
      return "sd";
    case AnchorObjective::LengthSensitivity:
      return "length sensitivity";
    case AnchorObjective::Movement:
      return "movement";
    case AnchorObjective::LeakingShare:
      return "leaking share";
  }
  return "";
}

double value_of(const AnchorSummary& summary, AnchorObjective objective) {
  switch (objective) {
    case AnchorObjective::Mean:
      return summary.mean_mm2;
    case AnchorObjective::Sd:
      return summary.sd_mm2;
    case AnchorObjective::LengthSensitivity:
      return summary.length_sd_mm2;
    case AnchorObjective::Movement:
      return summary.movement_mm;
    case AnchorObjective::LeakingShare:
      return summary.leaking_share;
  }
  return 0.0;
}

const std::array<ScanFactor, kScanFactors>& scan_factors() {
  static constexpr std::array<ScanFactor, kScanFactors> kFactors = {
      {{"tip spread mm", 18.0, 32.0},
       {"tips behind the centre mm", -2.0, 7.0},
       {"tip depth mm", 20.0, 30.0},
       {"trigones, share from saddle peak to commissure", 0.5, 0.95},
       {"saddle height mm", 3.0, 10.0},
       {"reserve, factor of leaflet heights", 0.97, 1.1}}};
  return kFactors;
}

ParametricValve scanned_anatomy(const ParametricValve& centre, const std::vector<double>& shares) {
  const auto at = [&](std::size_t factor) {
    const ScanFactor& f = scan_factors()[factor];
    return f.lower + shares[factor] * (f.upper - f.lower);
  };
  ParametricValve anatomy = centre;
  anatomy.name = "scanned";
  anatomy.tip_spread_mm = at(0);
  anatomy.tip_posterior_mm = at(1);
  anatomy.tip_depth_mm = at(2);
  anatomy.trigone_share = at(3);
  const Proportions heights = proportions(centre, centre.ap_mm, centre.al_pm_mm);
  anatomy.saddle_height_mm = at(4);
  anatomy.anterior_height_mm = at(5) * heights.anterior_height_mm;
  anatomy.posterior_height_mm = at(5) * heights.posterior_height_mm;
  anatomy.lateral_height_mm = at(5) * heights.lateral_height_mm;
  anatomy.commissure_height_mm = at(5) * heights.commissure_height_mm;
  return anatomy;
}

std::vector<ScannedAnatomy> scan_anchors(const ParametricValve& centre, const OpenTable& open_table,
                                         const AnchorQuestionOptions& options) {
  std::vector<ScannedAnatomy> scan(static_cast<std::size_t>(options.anatomies));
  const std::vector<std::vector<double>> designs =
      latin_hypercube(options.anatomies, kScanFactors, options.seed);
  std::mutex mutex;
  int done = 0;
  for_each_index(options.anatomies, options.at_once, [&](int i) {
    scan[i].shares = designs[i];
    const Expected<Valve> valve = make_taut_valve(scanned_anatomy(centre, designs[i]));
    if (valve) ask(*valve, open_table, options, scan[i]);
    const std::lock_guard<std::mutex> lock(mutex);
    if (options.progress) options.progress(++done, options.anatomies);
  });
  return scan;
}

std::vector<AnchorAnswer> answer_anchor_question(const std::vector<ScannedAnatomy>& scan) {
  std::vector<Protocol> protocols;
  for (const ScannedAnatomy& scanned : scan)
    for (const AnchorSummary& s : scanned.summaries)
      if (std::find(protocols.begin(), protocols.end(), s.protocol) == protocols.end())
        protocols.push_back(s.protocol);
  std::vector<AnchorAnswer> answers;
  for (const Protocol protocol : protocols)
    for (const Displaced displaced : kDisplaced)
      for (const AnchorObjective objective : kAnchorObjectives)
        answers.push_back(answer(scan, protocol, displaced, objective));
  return answers;
}

}  // namespace coapt
