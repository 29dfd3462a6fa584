#include "search/studies/generality.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <random>

#include "core/metrics/leak.h"
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
  return trusted(closure) && measure_leak(valve, closure.closed_mm).area_mm2 <= kMildLeak_mm2;
}

}  // namespace

RandomAnatomies random_anatomies(int count, std::uint64_t seed, int threads) {
  std::mt19937_64 engine(seed);
  RandomAnatomies random;
  while (static_cast<int>(random.valves.size()) < count &&
         random.drawn < kMostDrawnFactor * count) {
    std::vector<std::optional<Valve>> valves(kDrawnAtOnce);
    std::vector<ParametricValve> dimensions;
    for (int i = 0; i < kDrawnAtOnce; ++i) {
      std::vector<double> shares(kAnatomyParameters);
      for (double& share : shares) share = random_share(engine);
      dimensions.push_back(
          parametric_valve(anatomy_at(shares), "random-" + std::to_string(random.drawn + i)));
    }
    for_each_index(kDrawnAtOnce, threads, [&](int i) {
      Expected<Valve> valve = make_taut_valve(dimensions[i]);
      if (valve && competent(*valve)) valves[i] = *valve;
    });
    random.drawn += kDrawnAtOnce;
    for (int i = 0; i < kDrawnAtOnce && static_cast<int>(random.valves.size()) < count; ++i) {
      if (!valves[i]) continue;
      random.valves.push_back(*valves[i]);
      random.dimensions.push_back(dimensions[i]);
    }
  }
  return random;
}

std::vector<ValveFindings> study_generality(const std::vector<StudiedValve>& valves,
                                            const OpenTable& open_table,
                                            const GeneralityOptions& options) {
  const int count = static_cast<int>(valves.size());
  std::vector<ValveFindings> all(valves.size());
  std::mutex mutex;
  int done = 0;
  for_each_index(count, options.at_once, [&](int i) {
    const StudiedValve& studied = valves[i];
    OrificeTable table = open_table(studied.valve);
    const std::vector<Finding> found = findings(study_thesis(table, options.studies));
    all[i] = {studied.kind,           studied.valve.name, found,
              table.configurations(), table.untrusted(),  table.closures()};
    const std::lock_guard<std::mutex> lock(mutex);
    if (options.progress) options.progress(++done, count);
  });
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
