#include "lab/verdicts/chordae_study.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "core/closed/closed_valve.h"
#include "core/metrics/mean_and_sd.h"
#include "core/metrics/quantile.h"
#include "core/presets/synthetic_chordae.h"
#include "core/repair/apply_plan.h"
#include "lab/closures/varied_scenes.h"
#include "lab/verdicts/agreement.h"
#include "lab/verdicts/drawn_plans.h"
#include "search/evaluator.h"
#include "search/parallel.h"
#include "search/studies/generality.h"

namespace coapt {
namespace {

constexpr double kTie_mm2 = 0.1;

std::optional<double> leak_of(const Expected<Valve>& valve) {
  if (!valve) return {};
  const ClosedValve closed = close_and_measure(*valve);
  if (!trusted(closed.closure)) return {};
  return leak_mm2(closed.measure);
}

Expected<Valve> with_chordae(const Valve& valve, ChordaeKnown known, int draw) {
  if (known == ChordaeKnown::Own) return valve;
  Points tips_mm(known == ChordaeKnown::TipsSeen ? std::ssize(valve.heads) : 0, 3);
  for (Eigen::Index i = 0; i < tips_mm.rows(); ++i)
    tips_mm.row(i) = valve.heads[static_cast<std::size_t>(i)].rest_mm.transpose();
  return with_synthetic_chordae(valve, draw, tips_mm);
}

DrawnAnatomy judged(const Valve& valve, const std::vector<RepairPlan>& plans, DrawnAnatomy of) {
  const Expected<Valve> drawn = with_chordae(valve, of.known, of.draw);
  of.leak_mm2.assign(plans.size() + 1, std::nullopt);
  if (!drawn) return of;
  of.leak_mm2[0] = leak_of(*drawn);
  for (std::size_t i = 0; i < plans.size(); ++i)
    of.leak_mm2[i + 1] = leak_of(apply_plan(*drawn, plans[i]));
  return of;
}

/// Of one plan over the draws.
struct Spread {
  double median_mm2 = std::nan(""), sd_mm2 = std::nan("");
};

Spread spread_of(const std::vector<const DrawnAnatomy*>& draws, std::size_t plan, int& refused) {
  std::vector<double> leaks;
  for (const DrawnAnatomy* draw : draws) {
    if (draw->leak_mm2[plan])
      leaks.push_back(*draw->leak_mm2[plan]);
    else
      ++refused;
  }
  if (leaks.empty()) return {};
  return {quantile(leaks, 0.5), mean_and_sd(leaks).sd};
}

}  // namespace

const char* to_string(ChordaeKnown known) {
  switch (known) {
    case ChordaeKnown::Own:
      return "own";
    case ChordaeKnown::TipsSeen:
      return "tips seen";
    case ChordaeKnown::Nothing:
      return "nothing seen";
  }
  return "";
}

std::vector<DrawnAnatomy> study_chordae(const ChordaeStudyOptions& options,
                                        const std::function<void(int, int)>& progress) {
  const RandomAnatomies anatomies =
      random_anatomies(options.anatomies, options.seed, options.threads);
  std::vector<DrawnAnatomy> all;
  for (int i = 0; i < options.anatomies; ++i) {
    if (progress) progress(i, options.anatomies);
    const Valve valve = varied_scene(anatomies.valves[static_cast<std::size_t>(i)], options.seed, i,
                                     SceneRings::None);
    const std::vector<RepairPlan> plans = draw_plans(valve, options.plans, options.seed);
    std::vector<DrawnAnatomy> of = {{i, ChordaeKnown::Own, 0, {}}};
    for (const ChordaeKnown known : {ChordaeKnown::TipsSeen, ChordaeKnown::Nothing})
      for (int draw = 1; draw <= options.draws; ++draw) of.push_back({i, known, draw, {}});
    for_each_index(static_cast<int>(of.size()), options.threads, [&](int at) {
      DrawnAnatomy& drawn = of[static_cast<std::size_t>(at)];
      drawn = judged(valve, plans, drawn);
    });
    all.insert(all.end(), of.begin(), of.end());
  }
  return all;
}

std::vector<ChordaeAgreement> chordae_agreements(const std::vector<DrawnAnatomy>& all) {
  std::vector<ChordaeAgreement> agreements;
  for (const ChordaeKnown known : {ChordaeKnown::TipsSeen, ChordaeKnown::Nothing}) {
    std::map<int, const DrawnAnatomy*> own;
    std::map<int, std::vector<const DrawnAnatomy*>> draws;
    for (const DrawnAnatomy& drawn : all) {
      if (drawn.known == ChordaeKnown::Own) own[drawn.anatomy] = &drawn;
      if (drawn.known == known) draws[drawn.anatomy].push_back(&drawn);
    }
    ChordaeAgreement agreement{known};
    std::vector<double> taus, regrets, errors, sds;
    for (const auto& [anatomy, of] : draws) {
      std::vector<double> ours, theirs;
      for (std::size_t plan = 0; plan < own[anatomy]->leak_mm2.size(); ++plan) {
        const Spread spread = spread_of(of, plan, agreement.refused);
        const std::optional<double>& truth = own[anatomy]->leak_mm2[plan];
        if (!truth || std::isnan(spread.median_mm2)) continue;
        ours.push_back(spread.median_mm2);
        theirs.push_back(*truth);
        errors.push_back(std::abs(spread.median_mm2 - *truth));
        sds.push_back(spread.sd_mm2);
      }
      if (ours.size() < 2) continue;
      ++agreement.anatomies;
      const double tau = kendall_tau(count_pairs(ours, theirs, kTie_mm2));
      if (!std::isnan(tau)) taus.push_back(tau);
      const auto chosen = std::min_element(ours.begin(), ours.end()) - ours.begin();
      regrets.push_back(theirs[static_cast<std::size_t>(chosen)] -
                        *std::min_element(theirs.begin(), theirs.end()));
    }
    agreement.tau = quantile(taus, 0.5);
    agreement.regret_mm2 = quantile(regrets, 0.5);
    agreement.most_regret_mm2 = quantile(regrets, 1.0);
    agreement.error_mm2 = quantile(errors, 0.5);
    agreement.sd_mm2 = quantile(sds, 0.5);
    agreements.push_back(agreement);
  }
  return agreements;
}

std::string chordae_csv(const std::vector<DrawnAnatomy>& all) {
  std::ostringstream csv;
  csv << "anatomy,known,draw,plan,leak_mm2\n";
  for (const DrawnAnatomy& drawn : all)
    for (std::size_t plan = 0; plan < drawn.leak_mm2.size(); ++plan) {
      csv << drawn.anatomy << ',' << to_string(drawn.known) << ',' << drawn.draw << ',' << plan
          << ',';
      if (drawn.leak_mm2[plan]) csv << *drawn.leak_mm2[plan];
      csv << '\n';
    }
  return csv.str();
}

}  // namespace coapt
