#include "search/studies/generality.h"

#include <algorithm>
#include <optional>
#include <random>

#include "core/metrics/exact_orifice.h"
#include "core/presets/presets.h"
#include "search/evaluator.h"
#include "search/parallel.h"
#include "search/plans/objective.h"
#include "search/random_share.h"

namespace coapt {
namespace {

constexpr int kDrawnAtOnce = 16;      // the same for any number of threads
constexpr int kMostDrawnFactor = 50;  // gives up after so many times the count

bool competent(const Valve& valve) {
  const ClosureResult closure = close_valve(valve);
  return trusted(closure) && measure_orifice(valve, closure).area_mm2 <= kGoodRepair_mm2;
}

}  // namespace

RandomAnatomies random_anatomies(int count, std::uint64_t seed, int threads) {
  std::mt19937_64 engine(seed);
  RandomAnatomies random;
  while (static_cast<int>(random.valves.size()) < count &&
         random.drawn < kMostDrawnFactor * count) {
    std::vector<std::optional<Valve>> valves(kDrawnAtOnce);
    std::vector<Anatomy> anatomies;
    for (int i = 0; i < kDrawnAtOnce; ++i) {
      std::vector<double> shares(kAnatomyParameters);
      for (double& share : shares) share = random_share(engine);
      anatomies.push_back(anatomy_at(shares));
    }
    for_each_index(kDrawnAtOnce, threads, [&](int i) {
      Expected<Valve> valve = make_taut_valve(
          parametric_valve(anatomies[i], "random-" + std::to_string(random.drawn + i)));
      if (valve && competent(*valve)) valves[i] = *valve;
    });
    random.drawn += kDrawnAtOnce;
    for (const std::optional<Valve>& valve : valves)
      if (valve && static_cast<int>(random.valves.size()) < count) random.valves.push_back(*valve);
  }
  return random;
}

std::vector<ValveFindings> study_generality(const std::vector<StudiedValve>& valves,
                                            const OpenTable& open_table,
                                            const ThesisStudyOptions& options,
                                            const std::function<void(int, int)>& progress) {
  std::vector<ValveFindings> all;
  for (const StudiedValve& studied : valves) {
    OrificeTable table = open_table(studied.valve);
    const std::vector<Finding> found = findings(study_thesis(table, options));
    all.push_back({studied.kind, studied.valve.name, found, table.closures(), table.untrusted()});
    if (progress) progress(static_cast<int>(all.size()), static_cast<int>(valves.size()));
  }
  return all;
}

std::vector<FindingShare> finding_shares(const std::vector<ValveFindings>& studied) {
  std::vector<FindingShare> shares;
  const auto add = [&](const Finding& finding, const std::string& kind) {
    auto at = std::find_if(shares.begin(), shares.end(), [&](const FindingShare& share) {
      return share.finding == finding.finding && share.kind == kind;
    });
    if (at == shares.end()) at = shares.insert(at, {finding.finding, kind, 0, 0});
    ++at->valves;
    if (finding.agrees) ++at->agree;
  };
  for (const ValveFindings& valve : studied)
    for (const Finding& finding : valve.findings) {
      add(finding, "");
      add(finding, valve.kind);
    }
  return shares;
}

}  // namespace coapt
