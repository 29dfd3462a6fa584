#include "lab/diseases/barlow_study.h"

#include <cmath>
#include <iterator>
#include <sstream>

#include "core/closed/closed_valve.h"
#include "core/metrics/leaflet_measure.h"
#include "core/presets/human_presets.h"
#include "search/evaluator.h"
#include "search/latin_hypercube.h"
#include "search/parallel.h"

namespace coapt {
namespace {

constexpr double kCompetent_mm2 = 1.0;
constexpr double kLeastReduction = -0.2, kMostReduction = 0.65, kReductionStep = 0.05;
constexpr int kReductions = 18;

/// Between half_width less and half_width more than 1.
double around_one(double share, double half_width) {
  return 1.0 + half_width * (2.0 * share - 1.0);
}

/// Patients differ by a tenth in what was measured of them; assumed.
HumanValve drawn_barlow(const std::vector<double>& shares) {
  HumanValve human = barlow();
  ParametricValve& d = human.dimensions;
  d.ap_mm *= around_one(shares[0], 0.1);
  d.al_pm_mm *= around_one(shares[1], 0.1);
  const double anterior = around_one(shares[2], 0.1), posterior = around_one(shares[3], 0.1);
  *d.anterior_height_mm *= anterior;
  for (std::optional<double>* height :
       {&d.posterior_height_mm, &d.lateral_height_mm, &d.commissure_height_mm})
    **height *= posterior;
  d.slack *= around_one(shares[4], 0.05);
  human.p2_slack *= around_one(shares[5], 0.1);
  return human;
}
constexpr int kShares = 6;

Valve with_annulus(Valve valve, double reduction) {
  const Vec3 centre = valve.annulus_mm.colwise().mean();
  const double scale = std::sqrt(1.0 - reduction);
  for (Eigen::Index i = 0; i < valve.annulus_mm.rows(); ++i) {
    const Vec3 point = valve.annulus_mm.row(i);
    valve.annulus_mm.row(i) = (centre + scale * (point - centre)).transpose();
  }
  return valve;
}

BarlowState closed_state(const Valve& valve, BarlowState state) {
  const ClosedValve closed = close_and_measure(with_annulus(valve, state.reduction));
  state.trusted = trusted(closed.closure);
  state.leak_mm2 = leak_mm2(closed.measure);
  state.coaptation_area_index = coaptation_area_index(valve, closed.closure.closed_mm);
  return state;
}

/// The human valve's law, at the thickness of the disease.
Valve healthy(Valve valve) {
  const double thickness_mm = valve.tissue.thickness_mm;
  valve.tissue = human_normal().dimensions.tissue;
  valve.tissue.thickness_mm = thickness_mm;
  return valve;
}

/// Where a line through the states of one valve first reaches the index.
std::optional<double> reduction_for(const std::vector<const BarlowState*>& states, double index) {
  for (std::size_t i = 1; i < states.size(); ++i) {
    const double low = states[i - 1]->coaptation_area_index,
                 high = states[i]->coaptation_area_index;
    if (low < index && high >= index)
      return std::lerp(states[i - 1]->reduction, states[i]->reduction,
                       (index - low) / (high - low));
  }
  return {};
}

}  // namespace

const char* to_string(BarlowTissue tissue) {
  return tissue == BarlowTissue::Healthy ? "healthy" : "myxomatous";
}

std::vector<BarlowState> study_barlow(const BarlowStudyOptions& options,
                                      const std::function<void(int, int)>& progress) {
  const std::vector<std::vector<double>> shares =
      latin_hypercube(options.valves, kShares, options.seed);
  std::vector<BarlowState> all;
  for (int v = 0; v < options.valves; ++v) {
    if (progress) progress(v, options.valves);
    const Expected<Valve> valve =
        make_human_valve(drawn_barlow(shares[static_cast<std::size_t>(v)]));
    if (!valve) continue;
    std::vector<BarlowState> states(static_cast<std::size_t>(2 * kReductions));
    for_each_index(2 * kReductions, options.threads, [&](int i) {
      const BarlowTissue tissue =
          i < kReductions ? BarlowTissue::Myxomatous : BarlowTissue::Healthy;
      BarlowState state{v, tissue, kLeastReduction + kReductionStep * (i % kReductions)};
      states[static_cast<std::size_t>(i)] =
          closed_state(tissue == BarlowTissue::Healthy ? healthy(*valve) : *valve, state);
    });
    all.insert(all.end(), states.begin(), states.end());
  }
  if (progress) progress(options.valves, options.valves);
  return all;
}

std::vector<BarlowAnswer> barlow_answers(const std::vector<BarlowState>& states) {
  constexpr double kAsIs = 0.5 * kReductionStep;
  std::vector<BarlowAnswer> answers;
  for (auto begin = states.begin(); begin != states.end();) {
    BarlowAnswer answer;
    answer.valve = begin->valve;
    std::vector<const BarlowState*> series;
    auto state = begin;
    for (; state != states.end() && state->valve == begin->valve; ++state) {
      if (!state->trusted) continue;
      const bool as_is = std::abs(state->reduction) < kAsIs;
      if (state->tissue == BarlowTissue::Healthy) {
        if (as_is) answer.healthy_leak_mm2 = state->leak_mm2;
        continue;
      }
      if (as_is) {
        answer.leak_mm2 = state->leak_mm2;
        answer.index_as_is = state->coaptation_area_index;
      }
      if (state->reduction > -kAsIs) series.push_back(&*state);
    }
    answer.reduction_for_index = reduction_for(series, kAguileraIndex);
    for (const BarlowState* of : series)
      if (!answer.reduction_to_close && of->leak_mm2 < kCompetent_mm2)
        answer.reduction_to_close = of->reduction;
    answers.push_back(answer);
    begin = state;
  }
  return answers;
}

std::string barlow_csv(const std::vector<BarlowState>& states) {
  std::ostringstream out;
  out << "valve,tissue,reduction,trusted,coaptation_area_index,leak_mm2\n";
  for (const BarlowState& state : states)
    out << state.valve << ',' << to_string(state.tissue) << ',' << state.reduction << ','
        << (state.trusted ? 1 : 0) << ',' << state.coaptation_area_index << ',' << state.leak_mm2
        << '\n';
  return out.str();
}

}  // namespace coapt
