#include "search/conditioning.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/metrics/area_error.h"

namespace coapt {
namespace {

/// Standard deviations between a draw and an observation.
double distance_sd(const Observation& seen, const ModelFigures& draw) {
  const auto at = static_cast<std::size_t>(seen.figure);
  const double sd = std::hypot(seen.sd, draw.sd[at]);
  const double distance = std::abs(draw.value[at] - seen.value) / sd;
  return std::isfinite(distance) ? distance : std::numeric_limits<double>::infinity();
}

}  // namespace

DrawBlocks draw_blocks(const std::vector<Observation>& observed, int asked) {
  if (asked == 0 || observed.empty()) return {.draws = asked};
  return {std::max(asked, kConditionedDraws), kMostBlocks};
}

ModelFigures model_figures(const ValveMeasure& measure) {
  double widest_mm = 0.0;
  for (const LeakOpening& opening : measure.leak.openings)
    widest_mm = std::max(widest_mm, opening.width_mm);
  const double leak_sd_mm2 =
      std::isfinite(measure.leak_error_mm2) ? measure.leak_error_mm2 / kAreaErrorSds : 0.0;
  return {{measure.leak.area_mm2, measure.tenting_area_mm2, widest_mm}, {leak_sd_mm2, 0.0, 0.0}};
}

Conditioning condition(const std::vector<Observation>& observed,
                       const std::vector<std::optional<ModelFigures>>& draws) {
  Conditioning found;
  std::vector<double> squares;  // by draw: sum of squared distances
  double least = std::numeric_limits<double>::infinity(), nearest_sd = least;
  for (const std::optional<ModelFigures>& draw : draws) {
    double sum = 0.0, farthest_sd = 0.0;
    if (!draw) sum = std::numeric_limits<double>::infinity();
    for (const Observation& seen : observed) {
      if (!draw) break;
      const double away_sd = distance_sd(seen, *draw);
      sum += away_sd * away_sd;
      farthest_sd = std::max(farthest_sd, away_sd);
    }
    squares.push_back(sum);
    least = std::min(least, sum);
    if (draw) nearest_sd = std::min(nearest_sd, farthest_sd);
  }
  const bool any =
      std::any_of(draws.begin(), draws.end(), [](const auto& draw) { return draw.has_value(); });
  found.contradicts = any && !(nearest_sd <= kContradicting_sd);
  double sum = 0.0, sum_of_squares = 0.0;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const double weight = !draws[i]           ? 0.0
                          : found.contradicts ? 1.0
                                              : std::exp(-0.5 * (squares[i] - least));
    found.weights.push_back(weight);
    sum += weight;
  }
  for (double& weight : found.weights) {
    if (sum > 0.0) weight /= sum;
    sum_of_squares += weight * weight;
  }
  if (sum_of_squares > 0.0) found.effective = 1.0 / sum_of_squares;
  return found;
}

std::vector<int> resampled(const std::vector<double>& weights, int count) {
  std::vector<int> picked;
  double below = 0.0;
  std::size_t at = 0;
  for (int i = 0; i < count; ++i) {
    const double share = (i + 0.5) / count;
    while (at + 1 < weights.size() && below + weights[at] < share) below += weights[at++];
    while (at > 0 && weights[at] == 0.0) --at;  // the last ones may have none
    picked.push_back(static_cast<int>(at));
  }
  return picked;
}

}  // namespace coapt
