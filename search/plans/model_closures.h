// What the model's own error makes of the order of plans: reported plans closed again, as planned,
// under common draws of what is not known of the valve (valve_draw.h).
//
// A plan is judged in a draw as on its own material, by what its closure as planned changes: the
// region's mean leak and the cost move by as much. A rank holds if the plan stays ahead of the next
// one in nearly every draw; the same draws for both, so what moves both alike does not count.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "search/conditioning.h"
#include "search/information.h"
#include "search/plans/plan_evaluations.h"
#include "search/plans/valve_draw.h"

namespace coapt {

/// A leak over draws of the model; trusted closures alone.
struct ModelSpread {
  int draws = 0;     ///< closures made
  int failures = 0;  ///< of them: not trusted, left out
  double mean_mm2 = std::numeric_limits<double>::quiet_NaN();
  double sd_mm2 = std::numeric_limits<double>::quiet_NaN();
  double worst_mm2 = std::numeric_limits<double>::quiet_NaN();
};

struct ModelClosures {
  int draws = 0;  ///< asked for
  /// Where something was observed of the valve (Valve::observed): the draws below are kConditionedDraws or more, picked from `pool`
  /// as they weigh, so that they weigh alike; one may be there several times.
  int pool = 0;
  double effective =
      0.0;  ///< Conditioning::effective of the pool; as many as draws where nothing was observed
  bool contradicts = false;  ///< what was observed contradicts the model: the draws are not weighed
  std::vector<ModelDraw> distinct;  ///< draws below, each once
  std::vector<int> picked;          ///< by draw: which of `distinct`
  /// By draw, their leaks by the surface; empty without draws, or if the search was cancelled before.
  std::vector<PlanClosure> before;
  std::vector<CostContext> contexts;  ///< of costs there: as thick, as tense unrepaired
  std::map<const PlanRecord*, std::vector<PlanClosure>> plans;
  /// The same closures, their leaks by the surface; none where the evaluator keeps no closures.
  std::map<const PlanRecord*, std::vector<PlanClosure>> measured;
  /// By `distinct`, weights and leaks left out: what measurements would show of the unrepaired valve; none of a draw that is not to be
  /// trusted.
  std::vector<std::optional<InformedDraw>> informed;
  int closures = 0;  ///< made; SearchResult::closures does not count them
};

/// On all threads; a search that is cancelled makes no more, one out of time makes all. Without observations as many draws as asked for.
/// @param known of the same valve and as many draws: what is missing is added
ModelClosures close_under_draws(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& plans,
                                int asked, ModelClosures known = {});

/// How many closures that makes at most.
int most_draw_closures(const Valve& valve, int plans, int asked);

/// Which measurement of the valve would say most of the leak that a plan leaves. None of fewer than kConditionedDraws draws, which say
/// too little, where what was observed contradicts the model, and where leaks were not measured.
std::vector<InformationRow> information_rows(const ModelClosures& model, const PlanRecord& plan);

ModelSpread model_spread(const std::vector<PlanClosure>& by_draw);

/// A plan in one draw, beside itself on its own material.
struct DrawnChange {
  bool trusted = true;
  double leak_mm2 = 0.0, cost = 0.0;  ///< more than on its own material
};
DrawnChange change_in_draw(const PlanEvaluations& evaluations, const PlanRecord& plan,
                           const ModelClosures& model, int draw);

}  // namespace coapt
