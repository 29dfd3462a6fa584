#include "lab/diseases/durable_anchors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

#include "core/metrics/mean_and_sd.h"
#include "core/presets/human_presets.h"
#include "core/presets/taut_valve.h"
#include "core/repair/approximation.h"
#include "search/latin_hypercube.h"
#include "search/parallel.h"
#include "search/plans/durability.h"
#include "search/studies/anchor_question.h"

namespace coapt {
namespace {

// Outwards, posterior and apical as 8 to 8 to 5 (disturbance.h).
const Vec3 kDisplacement_mm = 8.0 * Vec3(8.0, 8.0, 5.0).normalized();
constexpr double kMovementStep_mm = 0.5;
constexpr double kTie_mm = 0.1;
constexpr std::array<Anchor, 2> kAnchors = {Anchor::IpsilateralTrigone, Anchor::SaddlePeak};
constexpr std::array<double, 2> kLimits_mm2 = {kGoodRepair_mm2, kCompetentLeak_mm2};

std::vector<Side> sides_of(Displaced displaced) {
  if (displaced == Displaced::Anterolateral) return {Side::Anterolateral};
  if (displaced == Displaced::Posteromedial) return {Side::Posteromedial};
  return {Side::Anterolateral, Side::Posteromedial};
}

RepairPlan repair(const Valve& valve, const DurableAnchor& like, double movement_mm) {
  RepairPlan plan;
  if (like.ring) plan.steps.push_back(Annuloplasty{OwnRing{0}});
  for (const Side side : sides_of(like.displaced)) {
    PapillaryApproximation suture{.side = side, .anchor = like.anchor};
    suture.suture_length_mm = anchor_distance_mm(valve, suture) - movement_mm;
    plan.steps.push_back(suture);
  }
  return plan;
}

/// Of one valve with one anchor, a repair for each limit, the looser first.
std::vector<DurableAnchor> repairs_of(PlanEvaluations& evaluations, DurableAnchor like) {
  std::vector<DurableAnchor> repairs;
  double movement = 0.0;
  for (const double limit : kLimits_mm2) {
    like.limit_mm2 = limit;
    repairs.push_back(like);
    for (; !repairs.back().repaired; movement += kMovementStep_mm) {
      PlanRecord& record = evaluations.record(repair(evaluations.valve(), like, movement));
      if (!record.possible) break;
      evaluations.close_here(record, 1);
      const PlanClosure& closure = record.closures.at(0);
      if (!trusted(closure) || leak_mm2(closure) > limit) continue;
      PlanRecord* const found_plan = &record;
      close_disease(evaluations, {&found_plan, 1}, PlanEvaluations::Phase::Ranking);
      DurableAnchor& found = repairs.back();
      found.repaired = true;
      found.movement_mm = movement;
      found.suture_mm = std::get<PapillaryApproximation>(record.plan.steps.back()).suture_length_mm;
      found.leak_mm2 = leak_mm2(closure);
      found.durability_mm = durability(record)->expected_mm;
      break;  // the next limit starts from the same suture
    }
  }
  return repairs;
}

std::vector<DurableAnchor> repairs_of(int anatomy, const std::vector<double>& shares) {
  const Evaluator evaluate = closing_evaluator({});
  const Expected<Valve> valve = make_taut_valve(scanned_anatomy(human_normal().dimensions, shares));
  if (!valve) return {};
  const Evaluation healthy = evaluate(*valve, nullptr).evaluation;
  if (!trusted(healthy) || leak_mm2(healthy.measure) > kGoodRepair_mm2) return {};
  std::vector<DurableAnchor> repairs;
  for (const Displaced displaced : kDisplaced) {
    const Expected<Valve> diseased = configure(*valve, displacement(displaced, kDisplacement_mm));
    if (!diseased) continue;
    SearchMonitor monitor(0.0, nullptr);
    PlanEvaluationOptions here;
    here.threads = 1;  // anatomies are side by side
    PlanEvaluations evaluations(evaluate, *diseased, here, monitor);
    const double leak = leak_mm2(evaluations.before().measure);
    if (!trusted(evaluations.before()) || leak <= kGoodRepair_mm2) continue;
    for (const bool ring : {false, true})
      for (const Anchor anchor : kAnchors)
        for (const DurableAnchor& found : repairs_of(evaluations, {.anatomy = anatomy,
                                                                  .displaced = displaced,
                                                                  .ring = ring,
                                                                  .anchor = anchor,
                                                                  .leak_before_mm2 = leak}))
          repairs.push_back(found);
  }
  return repairs;
}

}  // namespace

std::vector<DurableAnchor> study_durable_anchors(const DurableAnchorOptions& options,
                                                 const std::function<void(int, int)>& progress) {
  const std::vector<std::vector<double>> shares =
      latin_hypercube(options.anatomies, kScanFactors, options.seed);
  std::vector<DurableAnchor> all;
  constexpr int kAtOnce = 8;
  for (int first = 0; first < options.anatomies; first += kAtOnce) {
    if (progress) progress(first, options.anatomies);
    const int count = std::min(kAtOnce, options.anatomies - first);
    std::vector<std::vector<DurableAnchor>> found(static_cast<std::size_t>(count));
    for_each_index(count, options.threads, [&](int i) {
      found[static_cast<std::size_t>(i)] =
          repairs_of(first + i, shares[static_cast<std::size_t>(first + i)]);
    });
    for (const std::vector<DurableAnchor>& repairs : found)
      all.insert(all.end(), repairs.begin(), repairs.end());
  }
  if (progress) progress(options.anatomies, options.anatomies);
  return all;
}

std::vector<DurableAnchorAnswer> durable_anchor_answers(const std::vector<DurableAnchor>& repairs) {
  using Question = std::tuple<bool, Displaced, double, bool>;
  struct Differences {
    std::vector<double> durability_mm, movement_mm;
  };
  std::map<Question, Differences> differences;
  for (const DurableAnchor& trigone : repairs) {
    if (!trigone.repaired || trigone.anchor != Anchor::IpsilateralTrigone) continue;
    const auto peak = std::find_if(repairs.begin(), repairs.end(), [&](const DurableAnchor& of) {
      return of.repaired && of.anchor == Anchor::SaddlePeak && of.anatomy == trigone.anatomy &&
             of.displaced == trigone.displaced && of.ring == trigone.ring &&
             of.limit_mm2 == trigone.limit_mm2;
    });
    if (peak == repairs.end()) continue;
    Differences& of =
        differences[{trigone.ring, trigone.displaced, trigone.limit_mm2, trigone.anatomy % 2 == 1}];
    of.durability_mm.push_back(trigone.durability_mm - peak->durability_mm);
    of.movement_mm.push_back(trigone.movement_mm - peak->movement_mm);
  }
  std::vector<DurableAnchorAnswer> answers;
  for (const auto& [question, of] : differences) {
    DurableAnchorAnswer answer;
    std::tie(answer.ring, answer.displaced, answer.limit_mm2, answer.odd) = question;
    answer.anatomies = static_cast<int>(of.durability_mm.size());
    for (const double mm : of.durability_mm) {
      answer.trigone_longer += mm > kTie_mm;
      answer.peak_longer += mm < -kTie_mm;
    }
    const auto [mean, sd] = mean_and_sd(of.durability_mm);
    answer.mean_mm = mean;
    answer.sd_mm = sd;
    answer.movement_mm = mean_and_sd(of.movement_mm).mean;
    answers.push_back(answer);
  }
  return answers;
}

std::string durable_anchors_csv(const std::vector<DurableAnchor>& repairs) {
  std::ostringstream out;
  out << "anatomy,displaced,ring,anchor,limit_mm2,repaired,leak_before_mm2,movement_mm,suture_mm,"
         "leak_"
         "mm2,"
         "durability_mm\n";
  for (const DurableAnchor& of : repairs)
    out << of.anatomy << ',' << to_string(of.displaced) << ',' << (of.ring ? 1 : 0) << ','
        << (of.anchor == Anchor::SaddlePeak ? "saddle peak" : "trigone") << ',' << of.limit_mm2
        << ',' << (of.repaired ? 1 : 0) << ',' << of.leak_before_mm2 << ',' << of.movement_mm << ','
        << of.suture_mm << ',' << of.leak_mm2 << ',' << of.durability_mm << '\n';
  return out.str();
}

}  // namespace coapt
