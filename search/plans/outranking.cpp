#include "search/plans/outranking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "search/random_share.h"

namespace coapt {
namespace {

constexpr int kResamples = 400;
/// Of a region's mean leak, for the same plan closed from elsewhere: 0.00 to 0.06 mm2, of a flail
/// leaflet 0.19 (plan_evaluations.h).
constexpr double kScatter_mm2 = 0.05, kFlailScatter_mm2 = 0.19;

/// One resample of the region's nodes, the same for both plans.
class Resampling {
 public:
  Resampling(const PlanEvaluations& evaluations, const JudgedRecord& judged, int nodes)
      : evaluations_(evaluations), judged_(judged) {
    for (int d = 0; d < nodes; ++d)
      closures_.push_back({judged.plan->closures.at(d), region_share(disturbances()[d])});
  }
  /// What decides between two plans, less being better: not closing robustly, then the cost.
  std::pair<bool, double> outcome(const std::vector<std::size_t>& nodes, double error_mm2) const {
    std::vector<ScoredClosure> drawn;
    double mean = error_mm2, squares = 0.0;
    bool robust = true;
    const double n = static_cast<double>(nodes.size());
    for (const std::size_t node : nodes) {
      drawn.push_back(closures_[node]);
      const double leak = drawn.back().closure.leak_mm2;
      robust = robust && trusted(drawn.back().closure);
      mean += leak / n;
      squares += leak * leak / n;
    }
    const double centre = mean - error_mm2;
    const double sd = std::sqrt(std::max(0.0, squares - centre * centre));
    robust = robust && judged_.closes_finely && mean + sd < kCompetentLeak_mm2;
    const CostWeights& weights = evaluations_.context().weights;
    const double price = weights.leak + (robust ? 0.0 : weights.incompetence);
    return {!robust, plan_cost(drawn, judged_.plan->effort, evaluations_.context()) +
                         judged_.cost_change + price * error_mm2};
  }

 private:
  const PlanEvaluations& evaluations_;
  JudgedRecord judged_;
  std::vector<ScoredClosure> closures_;
};

double normal(std::mt19937_64& engine) {  // Box and Muller (1958)
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random_share(engine)));
  return radius * std::cos(2.0 * std::numbers::pi * random_share(engine));
}

}  // namespace

double probability_ahead(const PlanEvaluations& evaluations, const JudgedRecord& a,
                         const JudgedRecord& b, int nodes) {
  if (nodes < 2) return std::numeric_limits<double>::quiet_NaN();
  const Resampling first(evaluations, a, nodes), second(evaluations, b, nodes);
  const bool flail =
      std::any_of(evaluations.valve().chordae.begin(), evaluations.valve().chordae.end(),
                  [](const Chorda& chorda) { return chorda.ruptured; });
  const double scatter_mm2 = flail ? kFlailScatter_mm2 : kScatter_mm2;
  std::mt19937_64 engine(1);
  int below = 0;
  for (int r = 0; r < kResamples; ++r) {
    std::vector<std::size_t> drawn{0};  // as planned, always
    while (std::ssize(drawn) < nodes)
      drawn.push_back(static_cast<std::size_t>(random_share(engine) * nodes));
    const double error_a = scatter_mm2 * normal(engine), error_b = scatter_mm2 * normal(engine);
    below += first.outcome(drawn, error_a) < second.outcome(drawn, error_b);
  }
  return static_cast<double>(below) / kResamples;
}

}  // namespace coapt
