#include "lab/twins/twin_study.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/closed/close_refined.h"
#include "core/metrics/shape_comparison.h"
#include "core/valve/ruptures.h"
#include "lab/closures/varied_scenes.h"
#include "search/evaluator.h"
#include "search/random_share.h"
#include "search/studies/generality.h"

namespace coapt {
namespace {

constexpr double kMostDrawn_sd = 2.5;

struct Truth {
  std::vector<FitParameter> parameters;
  std::vector<double> values;
  ClosedValve closed;  ///< on the refined mesh
};

std::optional<Truth> draw_truth(const Valve& valve, const std::vector<FitParameter>& parameters,
                                int refinements, std::mt19937_64& engine) {
  Truth truth;
  truth.parameters = parameters;
  for (const FitParameter& p : parameters)
    truth.values.push_back(std::clamp(
        p.prior + p.prior_sd * std::clamp(normal_share(engine), -kMostDrawn_sd, kMostDrawn_sd),
        p.lower, p.upper));
  const Expected<Valve> own = with_parameters(valve, parameters, truth.values);
  if (!own) return {};
  truth.closed = close_and_measure(*own);
  for (int i = 0; i < refinements && trusted(truth.closed.closure); ++i) {
    const std::optional<ClosedValve> fine =
        close_refined(truth.closed, ClosureOptions{}, std::numeric_limits<int>::max());
    if (!fine) return {};
    truth.closed = *fine;
  }
  if (!trusted(truth.closed.closure)) return {};
  return truth;
}

double node_rms_mm(const Points& a, const Points& fine) {
  return std::sqrt((a - fine.topRows(a.rows())).squaredNorm() / static_cast<double>(a.rows()));
}

Twin judged(const ValveFit& fit, const Truth& truth, Eigen::Index points) {
  Twin twin;
  twin.points = static_cast<int>(points);
  for (const FittedParameter& fitted : fit.parameters) {  // some may have ruptured away
    const auto own = std::find_if(
        truth.parameters.begin(), truth.parameters.end(),
        [&](const FitParameter& drawn) { return drawn.name == fitted.parameter.name; });
    if (own != truth.parameters.end())
      twin.parameters.push_back(
          {fitted, truth.values[static_cast<std::size_t>(own - truth.parameters.begin())]});
  }
  const Points& exact = truth.closed.closure.closed_mm;
  twin.rms_before_mm = fit.rms_before_mm;
  twin.rms_mm = fit.rms_mm;
  twin.node_rms_mm = node_rms_mm(fit.closed.closure.closed_mm, exact);
  twin.node_rms_before_mm = node_rms_mm(fit.before.closure.closed_mm, exact);
  twin.surface_rms_mm =
      compare_shapes(in_pieces(fit.closed.closure.closed_mm, fit.closed.valve.faces),
                     in_pieces(exact, truth.closed.valve.faces), Alignment::None)
          .distance.rms_mm;
  twin.leak_mm2 = truth.closed.measure.leak.area_mm2;
  twin.leak_before_mm2 = fit.before.measure.leak.area_mm2;
  twin.fitted_leak = fit.leak;
  twin.independent_points = fit.independent_points;
  twin.rounds = fit.rounds;
  twin.closures = fit.closures;
  twin.taken = fit.taken;
  twin.hypotheses = fit.hypotheses;
  return twin;
}

}  // namespace

std::vector<Twin> study_twins(const TwinStudyOptions& options,
                              const std::function<void(int, int)>& progress) {
  const RandomAnatomies anatomies =
      random_anatomies(options.twins, options.seed, options.fit.threads);
  std::vector<Twin> twins;
  for (int i = 0; i < options.twins; ++i) {
    if (progress) progress(i, options.twins);
    std::mt19937_64 engine(options.seed * 1000003 + static_cast<std::uint64_t>(i));
    const Valve valve = varied_scene(anatomies.valves[static_cast<std::size_t>(i)], options.seed, i,
                                     SceneRings::None);
    Valve own = valve;
    std::string lesion = "intact";
    if (options.fit.ruptures && i / 2 % 2 == 0) {
      const std::vector<Segment> held = held_segments(valve);
      const Segment segment = held[engine() % held.size()];
      own = with_ruptured(valve, segment);
      lesion = std::string("ruptured_") + to_string(segment);
    }
    const std::vector<FitParameter> parameters = fit_parameters(own, options.fit.unknowns);
    std::optional<Truth> truth;
    for (int attempt = 0; attempt < 20 && !truth; ++attempt)
      truth = draw_truth(own, parameters, options.refinements, engine);
    if (!truth) continue;
    MeasuredClosure measured;
    measured.points_mm = echo_view(truth->closed, options.echo, engine());
    if (options.leak_known)
      measured.leak_mm2 = std::max(
          0.0, truth->closed.measure.leak.area_mm2 + measured.leak_sd_mm2 * normal_share(engine));
    const Expected<ValveFit> fit = fit_valve(valve, measured, options.fit);
    if (!fit) continue;
    twins.push_back(judged(*fit, *truth, measured.points_mm.rows()));
    twins.back().number = i;
    twins.back().lesion = lesion;
  }
  return twins;
}

}  // namespace coapt
