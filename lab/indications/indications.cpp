#include "lab/indications/indications.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>

#include "core/presets/presets.h"
#include "core/repair/apply_plan.h"
#include "core/repair/describe.h"
#include "core/valve/number_text.h"
#include "core/valve/remodel.h"
#include "search/parallel.h"
#include "search/plans/acceptance.h"
#include "search/plans/durability.h"
#include "search/plans/fine_closures.h"
#include "search/plans/plan_order.h"
#include "search/plans/plan_search.h"
#include "search/plans/ranking.h"
#include "search/random_share.h"

namespace coapt {
namespace {

const char* type_of(Aetiology aetiology) {
  switch (aetiology) {
    case Aetiology::Ischaemic:
    case Aetiology::Dilated:
      return "IIIb";
    case Aetiology::P2Flail:
    case Aetiology::Barlow:
      return "II";
  }
  return "";
}

std::vector<std::string> avoidable_of(const RankedPlan& plan) {
  std::vector<std::string> rules;
  for (const Gate& gate : plan.gates)
    if (avoidable_warnings({gate}) > 0) rules.push_back(gate.rule);
  return rules;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

bool is_ring_alone(const RepairPlan& plan) {
  return plan.steps.size() == 1 && std::holds_alternative<Annuloplasty>(plan.steps.front());
}

/// Every ring alone, then as many at random: a branch, then a point of it.
std::vector<RepairPlan> challengers_of(const PlanSpace& space, std::size_t steps,
                                       const IndicationOptions& options) {
  std::vector<const Branch*> fewer;
  std::vector<RepairPlan> plans;
  for (const Branch& branch : space.branches()) {
    if (space.plan(branch, start_of(branch)).steps.size() >= steps) continue;
    fewer.push_back(&branch);
    if (!is_ring_alone(space.plan(branch, start_of(branch)))) continue;
    for (std::int64_t number = 0; number < point_count(branch); ++number)
      plans.push_back(space.plan(branch, point_at(branch, number)));
  }
  std::mt19937_64 engine(options.search.seed);
  const auto drawn = [&](std::size_t count) {
    return static_cast<std::size_t>(random_share(engine) * static_cast<double>(count));
  };
  for (int i = 0; i < options.challengers && !fewer.empty(); ++i) {
    const Branch& branch = *fewer[drawn(fewer.size())];
    const auto points = static_cast<std::size_t>(point_count(branch));
    plans.push_back(space.plan(branch, point_at(branch, static_cast<std::int64_t>(drawn(points)))));
  }
  return plans;
}

/// As a search closes and ranks its plans, without draws of the model.
class Arena {
 public:
  Arena(const Valve& valve, const SearchOptions& options, const std::atomic<bool>& cancelled)
      : options_(options),
        evaluate_(closing_evaluator(options.closure)),
        monitor_(0.0, &cancelled),
        evaluations_(evaluate_, valve,
                     {.threads = options.threads,
                      .known = {},
                      .keep = {},
                      .weights = options.weights,
                      .open = Opener{open_plan}},
                     monitor_) {
    options_.region_points = std::min(options.region_points, kChosenBy);
    options_.plans = std::numeric_limits<int>::max();
  }

  /// Those that are possible and leak mildly at most, as planned and then over the errors of execution.
  std::vector<PlanRecord*> acceptable_of(const std::vector<RepairPlan>& plans) {
    std::vector<PlanRecord*> records;
    for (const RepairPlan& plan : plans)
      if (PlanRecord* const record = &evaluations_.record(plan);
          !is_infeasible(*record) &&
          std::find(records.begin(), records.end(), record) == records.end())
        records.push_back(record);
    close(records, 1);
    std::erase_if(records, [](const PlanRecord* record) {
      const PlanClosure& planned = record->closures.at(0);
      return !trusted(planned) || planned.leak_mm2 >= kMildLeak_mm2;
    });
    close(records, options_.region_points);
    std::erase_if(records, [&](const PlanRecord* record) {
      return acceptance_of(evaluations_, *record, options_.region_points, {}, {}).mean() <
             kAcceptable;
    });
    return records;
  }

  std::vector<RankedPlan> ranked(std::vector<PlanRecord*> records) {
    close(records, options_.region_points);
    evaluations_.open(records, PlanEvaluations::Phase::Ranking);
    close_disease(evaluations_, records, PlanEvaluations::Phase::Ranking);
    if (evaluations_.cancelled()) return {};
    return rank(evaluations_, records, options_,
                close_fine(evaluations_, records, options_.fine_levels));
  }

  PlanRecord& record(const RepairPlan& plan) { return evaluations_.record(plan); }

 private:
  void close(const std::vector<PlanRecord*>& records, int nodes) {
    std::vector<PlanEvaluations::Wanted> wanted;
    for (PlanRecord* record : records)
      for (int node = 0; node < nodes; ++node) wanted.push_back({record, node});
    evaluations_.close(wanted, PlanEvaluations::Phase::Ranking);
  }

  SearchOptions options_;
  Evaluator evaluate_;
  SearchMonitor monitor_;
  PlanEvaluations evaluations_;
};

Challenge challenge(Arena& arena, const PlanSpace& space, const RankedPlan& first,
                    const IndicationOptions& options) {
  Challenge found;
  const std::vector<RepairPlan> plans = challengers_of(space, first.plan.steps.size(), options);
  found.plans = static_cast<int>(plans.size());
  std::vector<PlanRecord*> records = arena.acceptable_of(plans);
  PlanRecord* const own = &arena.record(first.plan);
  records.push_back(own);
  const std::vector<RankedPlan> ranked = arena.ranked(records);
  bool before_first = true;
  for (const RankedPlan& plan : ranked) {
    if (&arena.record(plan.plan) == own) {
      before_first = false;
      continue;
    }
    found.ahead += before_first;
    found.acceptable += plan.is_acceptable;
    found.beat += plan.is_acceptable && avoidable_of(plan).size() <= avoidable_of(first).size();
    if (!is_ring_alone(plan.plan) || !found.ring_alone.empty()) continue;
    found.ring_alone = joined(plan.description, "; ");
    found.ring_probability = plan.acceptable_probability;
    if (plan.durability) found.ring_durability_mm = plan.durability->expected_mm;
  }
  return found;
}

/// Of the first plans of all seeds.
int of_first_class(Arena& arena, const std::vector<RepairPlan>& firsts) {
  std::vector<PlanRecord*> records;
  for (const RepairPlan& plan : firsts)
    if (PlanRecord* const record = &arena.record(plan);
        std::find(records.begin(), records.end(), record) == records.end())
      records.push_back(record);
  const std::vector<RankedPlan> ranked = arena.ranked(records);
  return static_cast<int>(std::count_if(firsts.begin(), firsts.end(), [&](const RepairPlan& plan) {
    return std::any_of(ranked.begin(), ranked.end(), [&](const RankedPlan& one) {
      return one.of_class == 1 && &arena.record(one.plan) == &arena.record(plan);
    });
  }));
}

std::string number(double value, int decimals) {
  return std::isfinite(value) ? with_decimals(value, decimals) : "";
}

}  // namespace

Expected<std::vector<KnownDisease>> known_presets() {
  std::vector<KnownDisease> known;
  for (const auto& [name, type] : {std::pair<const char*, const char*>{"human-normal", "competent"},
                                   {"hypertrophic", "competent"},
                                   {"human-functional-mr", "IIIb"},
                                   {"secondary-mr", "IIIb"},
                                   {"human-p2-prolapse", "II"},
                                   {"fibroelastic-flail", "II"},
                                   {"barlow", "II"},
                                   {"marfan", "II"}}) {
    const Expected<Valve> valve = make_preset(name);
    if (!valve) return valve.errors();
    known.push_back({name, type, *valve});
  }
  struct Made {
    const char *name, *type, *preset;
    Remodelling change;
  };
  for (const Made& made :
       {Made{"atrial",
             "I",
             "human-normal",
             {.ap_dilation_percent = 30.0, .annular_height_percent = 50.0}},
        Made{"ischaemic",
             "IIIb",
             "human-normal",
             {.ap_dilation_percent = 20.0, .posteromedial_mm = {6.0, 5.0, 6.0}}},
        Made{"dilated",
             "IIIb",
             "human-normal",
             {.ap_dilation_percent = 12.0,
             .anterolateral_mm = {4.0, 4.0, 5.0},
             .posteromedial_mm = {5.0, 5.0, 6.0}}},
        Made{"flail-dilated", "II", "human-p2-prolapse", {.ap_dilation_percent = 18.0}}}) {
    const Expected<Valve> preset = make_preset(made.preset);
    if (!preset) return preset.errors();
    const Expected<Valve> valve = remodel(*preset, made.change);
    if (!valve) return valve.errors();
    known.push_back({made.name, made.type, *valve});
  }
  return known;
}

Expected<std::vector<KnownDisease>> known_members(const PopulationPrior& prior, std::uint64_t seed,
                                                  int count, int threads) {
  std::vector<KnownDisease> known(static_cast<std::size_t>(count));
  std::vector<Errors> errors(known.size());
  for_each_index(count, threads, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    const Expected<PopulationMember> drawn = member(prior, seed, i);
    const Expected<Valve> valve = drawn ? make_valve(*drawn) : Expected<Valve>(drawn.errors());
    if (valve)
      known[at] = {"member-" + std::to_string(i), type_of(drawn->aetiology), *valve};
    else
      errors[at] = valve.errors();
  });
  for (const Errors& some : errors)
    if (!some.empty()) return some;
  return known;
}

bool is_indicated(const RankedPlan& plan, const std::string& type) {
  if (type == "competent") return plan.plan.steps.empty();
  int rings = 0;
  bool mends = false, moves_muscles = false, is_usual_ring = true;
  for (const RepairStep& step : plan.plan.steps) {
    mends = mends || std::holds_alternative<Neochorda>(step) ||
            std::holds_alternative<LeafletResection>(step);
    moves_muscles = moves_muscles || std::holds_alternative<PapillaryApproximation>(step);
    if (const auto* const ring = std::get_if<Annuloplasty>(&step)) {
      ++rings;
      const std::string shape = shape_of(*ring);
      is_usual_ring = type == "IIIb" ? shape != kOwnShape : shape == "generic-classic";
    }
  }
  return rings == 1 && is_usual_ring && (mends || type != "II") &&
         (!moves_muscles || type == "IIIb") && avoidable_of(plan).empty();
}

Expected<IndicationRow> judge_indication(const KnownDisease& known,
                                         const IndicationOptions& options,
                                         const std::atomic<bool>& cancelled) {
  IndicationRow row{.valve = known.name, .type = known.type};
  SearchContext context;
  context.cancelled = &cancelled;
  std::optional<SearchResult> result;
  std::vector<RepairPlan> firsts;
  for (int i = 0; i < options.seeds; ++i) {
    SearchOptions search = options.search;
    search.seed += static_cast<std::uint64_t>(i);
    const Expected<SearchResult> found = search_plans(known.valve, search, context);
    if (!found) return found.errors();
    if (!found->plans.empty()) firsts.push_back(found->plans.front().plan);
    if (i == 0) result = *found;
  }
  row.closures = result->closures;
  if (const auto& diagnosis = result->diagnosis) {
    if (diagnosis->competent) row.type = "competent";  // a disease that does not leak
    row.diagnosed = diagnosis->types.empty() ? "competent" : to_string(diagnosis->types.front());
    row.sure = diagnosis->type_sure;
    row.leak_mm2 = diagnosis->leak_mm2;
  }
  if (result->plans.empty() || cancelled) return row;
  const RankedPlan& first = result->plans.front();
  row.first_plan = first.plan.steps.empty() ? "no operation" : joined(first.description, "; ");
  row.of_class = static_cast<int>(
      std::count_if(result->plans.begin(), result->plans.end(),
                    [&](const RankedPlan& plan) { return plan.of_class == first.of_class; }));
  row.times_first = first.times_first;
  row.acceptable = first.acceptable_probability;
  if (first.durability) row.durability_mm = first.durability->expected_mm;
  row.warnings = joined(avoidable_of(first), " ");
  row.indicated = is_indicated(first, row.type);
  Arena arena(known.valve, options.search, cancelled);
  if (options.seeds > 1) row.same_class = of_first_class(arena, firsts);
  if (options.challenge)
    row.challenge = challenge(
        arena, PlanSpace(known.valve, options.search.rules, result->diagnosis), first, options);
  return row;
}

std::string indications_csv(const std::vector<IndicationRow>& rows) {
  std::ostringstream out;
  out << "valve,type,diagnosed,sure,leak_mm2,first_plan,of_class,times_first,acceptable,durability_"
         "mm,warnings,"
         "indicated,closures,seeds_same_class,challengers,challengers_acceptable,beat_first,"
         "ahead_of_first,ring_alone,ring_acceptable,ring_durability_mm\n";
  for (const IndicationRow& row : rows) {
    out << row.valve << ',' << row.type << ',' << row.diagnosed << ','
        << (row.sure ? "true" : "false") << ',' << number(row.leak_mm2, 1) << ",\""
        << row.first_plan << "\"," << row.of_class << ',' << row.times_first << ','
        << number(row.acceptable, 3) << ',' << number(row.durability_mm, 1) << ',' << row.warnings
        << ',' << (row.indicated ? "true" : "false") << ',' << row.closures << ','
        << (row.same_class ? std::to_string(*row.same_class) : "");
    if (const auto& asked = row.challenge)
      out << ',' << asked->plans << ',' << asked->acceptable << ',' << asked->beat << ','
          << asked->ahead << ",\"" << asked->ring_alone << "\","
          << number(asked->ring_probability, 3) << ',' << number(asked->ring_durability_mm, 1)
          << '\n';
    else
      out << ",,,,,,,\n";
  }
  return out.str();
}

}  // namespace coapt
