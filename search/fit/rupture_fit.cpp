#include "search/fit/rupture_fit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "core/valve/ruptures.h"
#include "search/fit/fit_problem.h"

namespace coapt {
namespace {

constexpr double kHopeful = 3.0;  // times the intact fit's sum of squares
constexpr int kMostRefits = 2;
constexpr double kIntactPrior = 0.5;  // assumed

using Clock = std::chrono::steady_clock;
using ValuesByName = std::map<std::string, double>;

/// A closure of the screen.
struct Screened {
  Eigen::VectorXd point;
  FitAnswer answer;
};

/// A valve and the values at which it explains the surface best so far.
struct Candidate {
  std::string name;
  Valve valve;
  Eigen::VectorXd point = {};
  std::vector<Screened> screens = {};
  FitAnswer answer = {};                                    ///< trusted once it has closed
  double screen = std::numeric_limits<double>::infinity();  ///< sum of squares
  std::optional<ValveFit> fit = {};
};

ValuesByName fitted_values(const ValveFit& fit) {
  ValuesByName values;
  for (const FittedParameter& fitted : fit.parameters) values[fitted.parameter.name] = fitted.value;
  return values;
}

/// One fit after the other, within the time of one.
class RuptureFit {
 public:
  RuptureFit(const Valve& valve, const MeasuredClosure& measured, FitOptions options)
      : measured_(measured), options_(std::move(options)) {
    options_.ruptures = false;
    candidates_.push_back({"intact", valve});
    for (const Segment segment : held_segments(valve))
      candidates_.push_back(
          {std::string("ruptured_") + to_string(segment), with_ruptured(valve, segment)});
  }

  Expected<ValveFit> run() {
    Candidate& intact = candidates_.front();
    if (Errors errors = fit(intact, options_); !errors.empty()) return errors;
    options_.keep = nullptr;
    options_.from.reset();
    if (screen()) refit();
    return most_probable();
  }

 private:
  const ValveFit& intact() const { return *candidates_.front().fit; }

  double seconds_left() const {
    return options_.most_seconds - std::chrono::duration<double>(Clock::now() - began_).count();
  }

  bool cancelled() const { return options_.cancelled && options_.cancelled(); }

  /// Asked during closures, on any thread.
  bool halted() const { return seconds_left() <= 0.0 || cancelled(); }

  /// Of candidates that nothing is tried of any more.
  void leave_out(const Candidate& candidate) {
    if (!cut_short_) cut_short_ = cancelled() ? FitStop::Cancelled : FitStop::TimeLimit;
    left_out_.push_back(candidate.name);
  }

  double squares(const Valve& valve, const Screened& of, const FitWeights& weights) const {
    return FitProblem(valve, measured_, options_, intact().points_mm)
        .residual(of.point, of.answer, weights)
        .squaredNorm();
  }
  double squares(const Candidate& of, const FitWeights& weights) const {
    return squares(of.valve, {of.point, of.answer}, weights);
  }

  Errors fit(Candidate& candidate, FitOptions options) {
    if (options_.progress)
      options.progress = [&, before = rounds_](int round, double rms_mm) {
        return options_.progress(before + round, rms_mm);
      };
    Expected<ValveFit> fitted = fit_valve(candidate.valve, measured_, options);
    if (!fitted) return fitted.errors();
    rounds_ += fitted->rounds;
    closures_ += fitted->closures;
    if (fitted->stop == FitStop::TimeLimit || fitted->stop == FitStop::Cancelled)
      cut_short_ = fitted->stop;
    candidate.point = FitProblem(candidate.valve, measured_, options_, fitted->points_mm)
                          .point_of(fitted_values(*fitted));
    candidate.answer = {fitted->distances_mm, fitted->leak.mm2, true};
    candidate.fit = *std::move(fitted);
    return {};
  }

  /// False if there is no time.
  bool screen() {
    const ValuesByName fitted = fitted_values(intact());
    ValuesByName as_long_as_given = fitted;
    std::erase_if(as_long_as_given,
                  [](const auto& value) { return value.first.starts_with("slack_"); });
    ClosureBudget budget = unhurried_budget(intact().before);
    budget.cancelled = [&] { return halted(); };
    for (std::size_t at = 1; at < candidates_.size(); ++at) {
      Candidate& candidate = candidates_[at];
      FitProblem problem(candidate.valve, measured_, options_, intact().points_mm);
      problem.allow(budget);
      const std::vector<Eigen::VectorXd> points = {
          problem.point_of(fitted), problem.point_of(as_long_as_given), problem.point_of({})};
      const std::vector<FitAnswer> answers = problem.answers_with_leaks(points);
      closures_ += problem.closures();
      if (cut_short_ || halted()) {
        for (std::size_t rest = 1; rest < candidates_.size(); ++rest) leave_out(candidates_[rest]);
        candidates_.resize(1);  // a part of them would make a biased comparison
        return false;
      }
      for (std::size_t i = 0; i < points.size(); ++i)
        if (answers[i].trusted) candidate.screens.push_back({points[i], answers[i]});
    }
    return true;
  }

  /// By the answer that leaves the least distances, of screens and fits.
  FitWeights common_weights() const {
    const FitAnswer* clearest = &candidates_.front().answer;
    const auto look_at = [&](const FitAnswer& answer) {
      if (answer.trusted && rms_distance_mm(answer) < rms_distance_mm(*clearest))
        clearest = &answer;
    };
    for (const Candidate& candidate : candidates_) {
      look_at(candidate.answer);
      for (const Screened& screened : candidate.screens) look_at(screened.answer);
    }
    return weights_of(intact().points_mm, *clearest);
  }

  /// Each candidate at its best screen.
  void choose_screens(const FitWeights& weights) {
    for (Candidate& candidate : candidates_)
      for (const Screened& screened : candidate.screens) {
        const double sum = squares(candidate.valve, screened, weights);
        if (sum >= candidate.screen) continue;
        candidate.point = screened.point;
        candidate.answer = screened.answer;
        candidate.screen = sum;
      }
  }

  void refit() {
    const FitWeights weights = common_weights();
    choose_screens(weights);
    const double most = kHopeful * squares(candidates_.front(), weights);
    std::vector<Candidate*> hopeful;
    for (Candidate& candidate : candidates_)
      if (candidate.screen <= most) hopeful.push_back(&candidate);
    std::stable_sort(hopeful.begin(), hopeful.end(),
                     [](const Candidate* a, const Candidate* b) { return a->screen < b->screen; });
    if (std::ssize(hopeful) > kMostRefits) hopeful.resize(kMostRefits);
    for (std::size_t i = 0; i < hopeful.size(); ++i) {
      Candidate& candidate = *hopeful[i];
      if (halted()) {
        leave_out(candidate);
        continue;
      }
      FitOptions options = options_;
      options.most_seconds = seconds_left() / static_cast<double>(hopeful.size() - i);
      const FitProblem problem(candidate.valve, measured_, options, intact().points_mm);
      const std::vector<double> values = problem.values(candidate.point);
      for (std::size_t p = 0; p < values.size(); ++p)
        options.start[problem.parameters()[p].name] = values[p];
      fit(candidate, options);  // one that does not close at its priors keeps its screen
    }
  }

  ValveFit most_probable() {
    const FitWeights weights = common_weights();
    const auto others = static_cast<double>(std::ssize(candidates_) - 1);
    std::vector<FitHypothesis> hypotheses;
    std::vector<double> costs;
    std::size_t best = 0;
    for (std::size_t at = 0; at < candidates_.size(); ++at) {
      const Candidate& candidate = candidates_[at];
      const double cost = candidate.answer.trusted ? squares(candidate, weights)
                                                   : std::numeric_limits<double>::infinity();
      const double prior = at == 0 ? kIntactPrior : (1.0 - kIntactPrior) / others;
      costs.push_back(cost - 2.0 * std::log(prior));
      if (candidate.fit && costs[at] < costs[best]) best = at;
      hypotheses.push_back({candidate.name, rms_distance_mm(candidate.answer),
                            candidate.answer.leak_mm2, cost, 0.0, candidate.fit.has_value()});
    }
    double sum = 0.0;
    const double least = *std::min_element(costs.begin(), costs.end());
    for (const double cost : costs) sum += std::exp(-0.5 * (cost - least));
    for (std::size_t at = 0; at < costs.size(); ++at)
      hypotheses[at].probability = std::exp(-0.5 * (costs[at] - least)) / sum;
    ValveFit fit = *candidates_[best].fit;
    fit.before = intact().before;
    fit.rms_before_mm = intact().rms_before_mm;
    fit.rounds = rounds_;
    fit.closures = closures_;
    if (cut_short_) fit.stop = *cut_short_;
    fit.hypotheses = std::move(hypotheses);
    fit.taken = candidates_[best].name;
    fit.left_out = left_out_;
    return fit;
  }

  const MeasuredClosure& measured_;
  FitOptions options_;
  Clock::time_point began_ = Clock::now();
  std::vector<Candidate> candidates_;  ///< the valve as given first
  int rounds_ = 0, closures_ = 0;
  std::optional<FitStop> cut_short_;  ///< TimeLimit or Cancelled
  std::vector<std::string> left_out_;
};

}  // namespace

Expected<ValveFit> fit_with_ruptures(const Valve& valve, const MeasuredClosure& measured,
                                     FitOptions options) {
  return RuptureFit(valve, measured, std::move(options)).run();
}

}  // namespace coapt
