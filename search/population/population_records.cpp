#include "search/population/population_records.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>

#include "core/closure/predicted_start.h"
#include "core/repair/apply_plan.h"
#include "search/evaluator.h"
#include "search/parallel.h"
#include "search/plans/disturbance.h"
#include "search/plans/disturbance_frame.h"
#include "search/plans/gates.h"
#include "search/plans/objective.h"
#include "search/population/population_factors.h"

namespace coapt {
namespace {

static_assert(std::is_trivially_copyable_v<PopulationRecord>);
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

float single(double value) { return static_cast<float>(value); }

double tip_to_trigone_mm(const Valve& valve, Side side) {
  const PapillaryApproximation to_trigone{.side = side, .anchor = Anchor::IpsilateralTrigone};
  return (papillary_tip_mm(valve, side) - anchor_mm(valve, to_trigone)).norm();
}

std::array<float, kFeatures> features_of(const PopulationMember& member, const Valve& valve,
                                         const Evaluation& closed) {
  const HumanValve human = diseased_valve(member.aetiology, member.anatomy, member.lesions);
  const AnnulusMeasure& annulus = closed.measure.annulus;
  const double al = tip_to_trigone_mm(valve, Side::Anterolateral),
               pm = tip_to_trigone_mm(valve, Side::Posteromedial);
  const double apart =
      (papillary_tip_mm(valve, Side::Posteromedial) - papillary_tip_mm(valve, Side::Anterolateral))
          .norm();
  const bool prolapses =
      member.aetiology == Aetiology::P2Flail || member.aetiology == Aetiology::Barlow;
  return {single(annulus.ap_mm),
          single(annulus.al_pm_mm),
          single(annulus.ap_mm / annulus.al_pm_mm),
          single(annulus.saddle_height_mm),
          single(closed.measure.tenting_height_mm),
          single(al),
          single(pm),
          single(pm - al),
          single(apart),
          single(human.dimensions.anterior_height_mm.value_or(0.0)),
          single(human.dimensions.posterior_height_mm.value_or(0.0)),
          single(closed.measure.leak.area_mm2),
          prolapses ? 1.0f : 0.0f,
          ruptured_chordae(member.lesions) > 0 ? 1.0f : 0.0f};
}

/// The valve as it is, and what closes it and its repairs.
struct ClosedMember {
  const Valve& valve;
  Evaluator evaluate;
  ClosedPlan before;
};

ClosedMember closed_member(const Valve& valve, const PopulationRecordOptions& options) {
  ClosedMember closed{valve, closing_evaluator(options.closure), {}};
  closed.before = with_leak_surface(valve, closed.evaluate(valve, nullptr));
  return closed;
}

/// What the first closures of a plan's nodes let expect of the next one.
std::optional<ClosureResult> predict(const Valve& repaired, const std::vector<ClosedPlan>& closed,
                                     int node) {
  std::vector<ClosureShare> shares;
  for (const FrameShare& part : predicted_from(node))
    shares.push_back(
        {closed[static_cast<std::size_t>(part.disturbance)].closure.get(), part.share});
  if (shares.empty()) return std::nullopt;
  return predicted_start(repaired.faces, shares);
}

CandidateRecord close_plan(const ClosedMember& member, const RepairPlan& plan, int nodes) {
  CandidateRecord record{static_cast<int>(CandidateState::Impossible), 0, kNan, kNan, kNan, kNan};
  const Expected<Valve> repaired = apply_plan(member.valve, plan);
  if (!repaired) return record;
  record.state = static_cast<int>(CandidateState::Rejected);
  if (is_rejected(operation_gates({plan, member.valve, *repaired}))) return record;
  record.state = static_cast<int>(CandidateState::Closed);
  std::vector<ClosedPlan> closed{member.evaluate(*repaired, member.before.closure.get())};
  std::vector<ScoredClosure> closures{{plan_closure(closed.front().evaluation), 0.0}};
  for (int d = 1; d < nodes; ++d) {
    const Disturbance& disturbance = disturbances()[static_cast<std::size_t>(d)];
    const std::optional<ClosureResult> predicted = predict(*repaired, closed, d);
    closed.push_back(member.evaluate(disturb(member.valve, *repaired, plan, disturbance),
                                     predicted ? &*predicted : closed.front().closure.get()));
    closures.push_back({plan_closure(closed.back().evaluation), region_share(disturbance)});
  }
  double sum = 0.0, squares = 0.0;
  int count = 0;
  for (const ScoredClosure& scored : closures) {
    if (!trusted(scored.closure)) continue;
    const double leak = scored.closure.leak_mm2;
    sum += leak;
    squares += leak * leak;
    ++count;
  }
  record.failures = nodes - count;
  if (trusted(closures.front().closure))
    record.planned_mm2 = single(closures.front().closure.leak_mm2);
  if (count > 0) {
    record.mean_mm2 = single(sum / count);
    record.sd_mm2 = single(std::sqrt(std::max(0.0, squares / count - sum / count * (sum / count))));
  }
  record.cost = single(plan_cost(
      closures, effort(member.valve, *repaired, plan),
      {member.valve.tissue.thickness_mm, member.before.evaluation.measure.tension_max_n, {}}));
  return record;
}

}  // namespace

const std::array<EchoFeature, kFeatures>& echo_features() {
  static constexpr std::array<EchoFeature, kFeatures> kAll = {
      {{"annulus_ap_mm", "anteroposterior diameter, mm", 1},
       {"annulus_transverse_mm", "transverse diameter, mm", 1},
       {"annulus_ratio", "anteroposterior over transverse diameter", 2},
       {"annular_height_mm", "annular height, mm", 1},
       {"tenting_height_mm", "tenting height, mm", 1},
       {"al_tip_to_trigone_mm", "anterolateral tip to its trigone, mm", 1},
       {"pm_tip_to_trigone_mm", "posteromedial tip to its trigone, mm", 1},
       {"tip_asymmetry_mm", "posteromedial less anterolateral tip distance, mm", 1},
       {"tips_apart_mm", "distance of the papillary tips, mm", 1},
       {"a2_height_mm", "A2 height, mm", 1},
       {"p2_height_mm", "P2 height, mm", 1},
       {"leak_mm2", "leak, mm2", 0},
       {"prolapse", "P2 prolapses", 0},
       {"flail", "P2 is flail", 0}}};
  return kAll;
}

PopulationRecord population_record(const PopulationMember& member,
                                   const PopulationRecordOptions& options) {
  PopulationRecord record;
  record.index = member.index;
  record.aetiology = static_cast<int>(member.aetiology);
  const Expected<Valve> valve = make_valve(member);
  if (!valve) return record;
  const ClosedMember closed = closed_member(*valve, options);
  if (!trusted(closed.before.evaluation)) return record;
  record.made = 1;
  record.leak_mm2 = single(closed.before.evaluation.measure.leak.area_mm2);
  record.features = features_of(member, *valve, closed.before.evaluation);
  const CandidateSite site = candidate_site(*valve);
  const std::vector<CandidateRepair>& candidates = candidate_repairs();
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (!is_offered(candidates[c], member.aetiology)) continue;
    const std::optional<RepairPlan> plan = candidate_plan(candidates[c], site);
    record.candidates[c] =
        plan ? close_plan(closed, *plan, options.nodes)
             : CandidateRecord{
                   static_cast<int>(CandidateState::Impossible), 0, kNan, kNan, kNan, kNan};
  }
  return record;
}

CandidateRecord record_of_plan(const Valve& valve, const RepairPlan& plan,
                               const PopulationRecordOptions& options) {
  return close_plan(closed_member(valve, options), plan, options.nodes);
}

std::string population_records(const Population& population, const PopulationRecordOptions& options,
                               int first, int count) {
  std::vector<PopulationRecord> records(static_cast<std::size_t>(count));
  const auto cancelled = [&] { return options.cancelled != nullptr && *options.cancelled; };
  for_each_index(count, options.threads, [&](int i) {
    if (cancelled()) return;
    records[static_cast<std::size_t>(i)] =
        population_record(population.members[static_cast<std::size_t>(first + i)], options);
    if (options.progress) options.progress();
  });
  if (cancelled()) return {};
  std::string bytes(records.size() * sizeof(PopulationRecord), '\0');
  std::memcpy(bytes.data(), records.data(), bytes.size());
  return bytes;
}

Expected<std::vector<PopulationRecord>> unpack_records(std::string_view bytes) {
  if (bytes.size() % sizeof(PopulationRecord) != 0)
    return Error{ErrorCode::Unsupported, "", "holds no whole number of population records"};
  std::vector<PopulationRecord> records(bytes.size() / sizeof(PopulationRecord));
  if (!bytes.empty()) std::memcpy(records.data(), bytes.data(), bytes.size());
  return records;
}

}  // namespace coapt
