// Draws of the model weighed by what was observed of the valve (Valve::observed): Bayes' rule by importance weights. The likelihood of a
// draw is normal in each figure that was observed, with the observation's standard deviation and the closure's own numerical error.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/metrics/measure.h"
#include "core/valve/observed.h"

namespace coapt {

/// Figures of a closure, in the order of ObservedFigure, and standard deviations of their numerical errors.
struct ModelFigures {
  std::array<double, kObservedFigures> value{}, sd{};
};

ModelFigures model_figures(const ValveMeasure& measure);

/// Below so many draws' worth of weight an interval is not to be believed: more draws are needed.
inline constexpr double kLeastEffective = 20.0;
/// An observation that no draw is nearer to than so many standard deviations contradicts the model.
inline constexpr double kContradicting_sd = 3.0;
inline constexpr int kConditionedDraws = 64, kMostBlocks = 4;

/// How many draws are made at a time, and how often at most: where something was observed kConditionedDraws or more, up to four times.
struct DrawBlocks {
  int draws = 0, blocks = 1;
};
DrawBlocks draw_blocks(const std::vector<Observation>& observed, int asked);

struct Conditioning {
  /// By draw, sum 1; 0 of draws that are not to be trusted. All others alike without observations, or where those contradict the model.
  std::vector<double> weights;
  double effective =
      0.0;  ///< draws that would say as much if they weighed alike, 1 / sum of squares (Kish 1965)
  bool contradicts = false;  ///< no draw lies within kContradicting_sd of all that was observed
};

/// @param draws figures of the valve as it was observed, unrepaired, in each draw; empty: not to be trusted
Conditioning condition(const std::vector<Observation>& observed,
                       const std::vector<std::optional<ModelFigures>>& draws);

/// `count` of the draws, in order, each about as often as it weighs (systematic resampling, Kitagawa 1996): they weigh alike.
/// @pre the sum of the weights is 1
std::vector<int> resampled(const std::vector<double>& weights, int count);

}  // namespace coapt
