#include "lab/verdicts/verdict_study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "core/presets/presets.h"
#include "core/repair/apply_plan.h"
#include "core/valve/remodel.h"
#include "lab/verdicts/drawn_plans.h"
#include "search/plans/plan_search.h"
#include "search/rank_correlation.h"
#include "search/studies/generality.h"

namespace coapt {
namespace {

constexpr int kAnatomies = 2;
constexpr double kUntrustedLeak_mm2 = 1e6;  // last in every order
constexpr double kApart_mm2 = 0.1;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Both muscles displaced, so that a search offers sutures of either.
Remodelling diseased() {
  Remodelling change;
  change.ap_dilation_percent = 25.0;
  change.anterolateral_mm = Vec3(2.0, 4.0, 3.0);
  change.posteromedial_mm = Vec3(3.0, 5.0, 4.0);
  return change;
}

struct JudgedValve {
  std::string name;
  bool held_out = false;
  std::uint64_t seed = 0;                              // of its plans
  std::function<Expected<Valve>(int)> with_triangles;  // 0: the valve's own number
};

std::vector<JudgedValve> judged_valves(const VerdictStudyOptions& options) {
  const auto preset = [](const std::string& name) {
    return [name](int triangles) { return make_preset(name, triangles); };
  };
  const auto sick = [](const auto& make) {
    return [make](int triangles) {
      const Expected<Valve> valve = make(triangles);
      return valve ? remodel(*valve, diseased()) : valve;
    };
  };
  std::vector<JudgedValve> valves = {
      {"human-functional-mr", false, 0, preset("human-functional-mr")},
      {"human-p2-prolapse", false, 0, preset("human-p2-prolapse")},
      {"porcine-1", false, 0, sick(preset("porcine-1"))},
      {"human-normal", true, 0, sick(preset("human-normal"))}};
  for (const ParametricValve& drawn :
       random_anatomies(kAnatomies, options.seed, options.threads).dimensions)
    valves.push_back({drawn.name, true, 0, sick([drawn](int triangles) {
                        ParametricValve dimensions = drawn;
                        if (triangles > 0) dimensions.triangles = triangles;
                        return make_taut_valve(dimensions);
                      })});
  for (std::size_t i = 0; i < valves.size(); ++i) valves[i].seed = options.seed + i;
  return valves;
}

std::vector<NamedPlan> plans_for(const Valve& valve, const Valve& reference, int count,
                                 std::uint64_t seed) {
  std::vector<NamedPlan> plans;
  for (const RepairPlan& plan : draw_plans(valve, count, seed))
    if (apply_plan(reference, plan)) plans.push_back({std::to_string(plans.size()), plan});
  return plans;
}

MeshVerdict own_verdict(const RankedPlan& plan) {
  return {trusted(plan), plan.measure.leak.area_mm2};
}

JudgedPlan described(const RankedPlan& ranked) {
  JudgedPlan judged;
  judged.plan = std::stoi(ranked.name);
  for (const RepairStep& step : ranked.plan.steps) {
    if (const auto* ring = std::get_if<Annuloplasty>(&step)) judged.ring = shape_of(*ring);
    judged.sutures += std::holds_alternative<PapillaryApproximation>(step);
    judged.neochordae += std::holds_alternative<Neochorda>(step);
  }
  judged.own = own_verdict(ranked);
  if (ranked.fine) judged.fine = {trusted(*ranked.fine), ranked.fine->leak_mm2};
  judged.rank = ranked.own_mesh_rank > 0 ? ranked.own_mesh_rank : ranked.rank;
  judged.fine_rank = ranked.own_mesh_rank > 0 ? ranked.rank : 0;
  judged.cost = ranked.cost;
  return judged;
}

/// In the order in which they were drawn.
std::vector<JudgedPlan> judge(const JudgedValve& of, const VerdictStudyOptions& options,
                              const std::function<void()>& progress) {
  const Expected<Valve> valve = of.with_triangles(0);
  const Expected<Valve> finest = of.with_triangles(options.reference_triangles);
  if (!valve || !finest) return {};
  const std::vector<NamedPlan> plans = plans_for(*valve, *finest, options.plans, of.seed);
  SearchOptions ranking;
  ranking.threads = options.threads;
  ranking.region_points = options.nodes;
  ranking.evidence = false;
  const Expected<SearchResult> own = evaluate_plans(*valve, plans, ranking, {});
  progress();
  ranking.fine_levels = 0;
  const Expected<SearchResult> reference = evaluate_plans(*finest, plans, ranking, {});
  progress();
  if (!own || !reference) return {};
  std::vector<JudgedPlan> judged;
  for (const RankedPlan& ranked : own->plans) {
    judged.push_back(described(ranked));
    judged.back().valve = of.name;
    judged.back().held_out = of.held_out;
    for (const RankedPlan& there : reference->plans)
      if (there.name == ranked.name) {
        judged.back().reference = own_verdict(there);
        judged.back().reference_rank = there.rank;
        judged.back().reference_cost = there.cost;
      }
  }
  std::sort(judged.begin(), judged.end(),
            [](const JudgedPlan& a, const JudgedPlan& b) { return a.plan < b.plan; });
  return judged;
}

double ordered_leak(const MeshVerdict& verdict) {
  return verdict.trusted ? verdict.leak_mm2 : kUntrustedLeak_mm2;
}

using Value = std::function<double(const JudgedPlan&)>;
struct Order {
  std::string name;
  bool leak = false;
  Value value;
};

std::vector<std::vector<JudgedPlan>> by_valve(const std::vector<JudgedPlan>& plans, bool all) {
  std::vector<std::vector<JudgedPlan>> valves;
  for (const JudgedPlan& plan : plans) {
    if (!all && !plan.held_out) continue;
    if (valves.empty() || valves.back().front().valve != plan.valve) valves.emplace_back();
    valves.back().push_back(plan);
  }
  return valves;
}

OrderAgreement agreement(const std::vector<std::vector<JudgedPlan>>& valves, const Order& order,
                         const Order& reference) {
  OrderAgreement agreement{order.name, reference.name, {}, 0.0, kNone, 0.0};
  PairCount pairs, apart;
  for (const std::vector<JudgedPlan>& plans : valves) {
    std::vector<double> x, y;
    for (const JudgedPlan& plan : plans) {
      x.push_back(order.value(plan));
      y.push_back(reference.value(plan));
    }
    pairs += count_pairs(x, y);
    apart += count_pairs(x, y, kApart_mm2);
    agreement.spearman += rank_correlation(x, y) / static_cast<double>(valves.size());
  }
  agreement.tau = kendall_tau(pairs);
  if (order.leak && reference.leak) agreement.tau_apart = kendall_tau(apart);
  return agreement;
}

}  // namespace

bool MeshVerdict::competent() const { return trusted && leak_mm2 < kTraceLeak_mm2; }

std::vector<JudgedPlan> study_verdicts(const VerdictStudyOptions& options,
                                       const std::function<void(int, int)>& progress) {
  const std::vector<JudgedValve> valves = judged_valves(options);
  const int planned = 2 * static_cast<int>(valves.size());
  int done = 0;
  std::vector<JudgedPlan> plans;
  for (const JudgedValve& valve : valves) {
    const std::vector<JudgedPlan> judged = judge(valve, options, [&] {
      if (progress) progress(++done, planned);
    });
    plans.insert(plans.end(), judged.begin(), judged.end());
  }
  return plans;
}

std::string verdicts_csv(const std::vector<JudgedPlan>& plans) {
  std::ostringstream csv;
  csv << "valve,held_out,plan,ring,sutures,neochordae,own_trusted,own_leak_mm2,fine_trusted,"
         "fine_leak_mm2,reference_trusted,reference_leak_mm2,rank,fine_rank,reference_rank,cost,"
         "reference_cost\n";
  for (const JudgedPlan& p : plans) {
    csv << p.valve << ',' << (p.held_out ? "true" : "false") << ',' << p.plan << ',' << p.ring
        << ',' << p.sutures << ',' << p.neochordae;
    for (const MeshVerdict& verdict : {p.own, p.fine, p.reference}) {
      csv << ',' << (verdict.trusted ? "true" : "false") << ',';
      if (verdict.trusted) csv << verdict.leak_mm2;
    }
    csv << ',' << p.rank << ',' << p.fine_rank << ',' << p.reference_rank << ',' << p.cost << ','
        << p.reference_cost << '\n';
  }
  return csv.str();
}

std::vector<OrderAgreement> order_agreements(const std::vector<JudgedPlan>& plans) {
  const std::vector<Order> orders = {
      {"own leak", true, [](const JudgedPlan& p) { return ordered_leak(p.own); }},
      {"fine leak", true, [](const JudgedPlan& p) { return ordered_leak(p.fine); }},
      {"rank", false, [](const JudgedPlan& p) { return p.rank; }},
      {"fine rank", false, [](const JudgedPlan& p) { return p.fine_rank; }}};
  const std::vector<Order> references = {
      {"leak", true, [](const JudgedPlan& p) { return ordered_leak(p.reference); }},
      {"rank", false, [](const JudgedPlan& p) { return p.reference_rank; }}};
  std::vector<OrderAgreement> agreements;
  for (const bool all : {true, false}) {
    const std::vector<std::vector<JudgedPlan>> valves = by_valve(plans, all);
    if (valves.empty()) continue;
    for (const Order& reference : references)
      for (const Order& order : orders) {
        agreements.push_back(agreement(valves, order, reference));
        agreements.back().valves = all ? "all" : "held out";
      }
  }
  return agreements;
}

std::vector<VerdictAgreement> verdict_agreements(const std::vector<JudgedPlan>& plans) {
  std::vector<VerdictAgreement> agreements;
  for (const bool all : {true, false}) {
    const std::string valves = all ? "all" : "held out";
    VerdictAgreement own{"own", valves, {}}, fine{"fine", valves, {}};
    for (const JudgedPlan& plan : plans) {
      if (!all && !plan.held_out) continue;
      own.count.add(plan.own.competent(), plan.reference.competent());
      fine.count.add(plan.fine.competent(), plan.reference.competent());
    }
    agreements.push_back(own);
    agreements.push_back(fine);
  }
  return agreements;
}

}  // namespace coapt
