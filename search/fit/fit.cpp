#include "search/fit/fit.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>

#include "core/valve/median.h"
#include "core/valve/number_text.h"
#include "search/evaluator.h"
#include "search/fit/fit_posterior.h"
#include "search/fit/fit_problem.h"
#include "search/fit/rupture_fit.h"

namespace coapt {
namespace {

constexpr int kLeastPoints = 100;
constexpr double kMostCoordinate_mm = 1e5;
constexpr double kMostAway_mm = 15.0;  // of the median point from the valve as given
constexpr int kPasses = 2;
constexpr double kFirstNoise_mm = 0.5;
constexpr double kFirstShare = 0.1;  // of points that are independent
constexpr double kIdentified = 0.5;
constexpr double kFarRms_mm = 2.0;  // a fit that ends there has not met the surface
constexpr double kNearRms_mm =
    0.3;  // one that ends here has, however its distances lie beside each other
// Answers whose rms distances differ by less are as near as each other: then the more probable one is taken.
constexpr double kAsNear = 1.02;

using Clock = std::chrono::steady_clock;

/// What cannot be fitted at all.
Errors check(const MeasuredClosure& measured, const FitProblem& problem, const Points& points_mm,
             const ClosedValve& before) {
  if (problem.parameters().empty())
    return {Error{ErrorCode::OutOfRange, "/unknowns",
                  "excludes every parameter; nothing is left to fit"}};
  if (points_mm.rows() < kLeastPoints)
    return {Error{ErrorCode::OutOfRange, "/points_mm",
                  "has " + std::to_string(points_mm.rows()) + " points, must be at least " +
                      std::to_string(kLeastPoints)}};
  if (measured.leak_mm2 && !(*measured.leak_mm2 >= 0.0 && *measured.leak_mm2 <= 2000.0))
    return {Error{ErrorCode::OutOfRange, "/leak_mm2",
                  "is " + shown(*measured.leak_mm2) + " mm2, must be from 0 to 2000 mm2"}};
  if (!trusted(before.closure))
    return {Error{
        ErrorCode::BadGeometry, "",
        "the closure of the valve did not converge or its leaflets cross, so distances cannot be "
        "measured"}};
  std::vector<double> distances = problem.answer_of(before).distances_mm;
  for (double& distance : distances) distance = std::abs(distance);
  if (const double middle_mm = median(std::move(distances)); middle_mm > kMostAway_mm)
    return {Error{ErrorCode::BadGeometry, "/points_mm",
                  "is " + with_decimals(middle_mm, 0) +
                      " mm from the closed valve (median), must be within 15 mm; check its frame "
                      "and its unit of length"}};
  return {};
}

/// How far an answer is from what its weights hold for the most probable, in the parameters' units.
Eigen::VectorXd shift(const FitProblem& problem, const Eigen::VectorXd& from,
                      const Eigen::VectorXd& to) {
  const std::vector<double> a = problem.values(from), b = problem.values(to);
  Eigen::VectorXd by(std::ssize(a));
  for (Eigen::Index i = 0; i < by.size(); ++i)
    by(i) = b[static_cast<std::size_t>(i)] - a[static_cast<std::size_t>(i)];
  return by;
}

/// Of a slack in shares of the fitted length, of the stiffness in shares of the fitted one, of others as they are.
FittedValues uncertainty(const ValveFit& fit) {
  FittedValues fitted;
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(fit.covariance.rows());
  for (const FittedParameter& found : fit.parameters) {
    if (std::holds_alternative<ChordalGroup>(found.parameter.changes) ||
        std::holds_alternative<Stiffness>(found.parameter.changes))
      scale(std::ssize(fitted.parameters)) = 1.0 / found.value;
    fitted.parameters.push_back(found.parameter.name);
  }
  fitted.covariance = scale.asDiagonal() * fit.covariance * scale.asDiagonal();
  return fitted;
}

}  // namespace

const char* to_string(FitStop stop) {
  switch (stop) {
    case FitStop::AtRest:
      return "at_rest";
    case FitStop::RoundLimit:
      return "round_limit";
    case FitStop::TimeLimit:
      return "time_limit";
    case FitStop::Cancelled:
      return "cancelled";
  }
  return "";
}

std::vector<std::string> doubts_of(const ValveFit& fit) {
  std::vector<std::string> doubts;
  if (fit.rms_mm > kFarRms_mm)
    doubts.push_back(
        "the fitted valve does not match the surface: " + with_decimals(fit.rms_mm, 2) +
        " mm rms exceeds " + with_decimals(kFarRms_mm, 0) + " mm");
  if (fit.rms_mm > kNearRms_mm &&
      fit.independent_points < static_cast<double>(fit.parameters.size()))
    doubts.push_back(
        "the surface is equivalent to " + std::to_string(std::lround(fit.independent_points)) +
        " independent points, fewer than the " + std::to_string(fit.parameters.size()) +
        " parameters, because its distances vary together");
  return doubts;
}

Expected<ValveFit> fit_valve(const Valve& valve, const MeasuredClosure& measured,
                             const FitOptions& options) {
  if (options.ruptures && is_mitral(valve)) return fit_with_ruptures(valve, measured, options);
  if (!(measured.points_mm.array().abs() <= kMostCoordinate_mm).all())
    return Error{ErrorCode::OutOfRange, "/points_mm",
                 "has coordinates that are not numbers from -1e5 to 1e5 mm"};
  const Clock::time_point began = Clock::now();
  ValveFit fit;
  fit.points_mm = thinned(measured.points_mm, options.most_points);
  FitProblem problem(valve, measured, options, fit.points_mm);
  fit.before = close_and_measure(valve, options.closure);
  if (Errors errors = check(measured, problem, fit.points_mm, fit.before); !errors.empty())
    return errors;
  const FitAnswer as_given = problem.answer_of(fit.before);
  fit.rms_before_mm = rms_distance_mm(as_given);
  problem.meet({problem.point_of({}), fit.rms_before_mm});

  FitWeights weights{kFirstNoise_mm, kFirstShare * static_cast<double>(fit.points_mm.rows()),
                     outlier_mm(as_given)};
  Eigen::VectorXd point = problem.point_of(options.start);
  FitAnswer answer;
  int first_pass = 0;
  const bool goes_on =
      options.from && options.from->squares.point.size() == std::ssize(problem.parameters());
  if (goes_on) {
    first_pass = options.from->pass;
    weights = {options.from->noise_mm, options.from->independent_points, options.from->outlier_mm};
    fit.rounds = options.from->rounds;
    problem.meet({options.from->nearest, options.from->nearest_rms_mm});
    problem.count_before(options.from->closures);
  }
  const ClosureBudget unhurried = unhurried_budget(fit.before);
  // Closures that are to come: two for each parameter, and what is fitted twice.
  const double last_closures = 2.0 * static_cast<double>(point.size()) + 2.0;
  const auto out_of_time = [&] {
    const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
    return seconds * (1.0 + last_closures / (1.0 + problem.closures())) > options.most_seconds;
  };
  std::atomic<FitStop> ended = FitStop::AtRest;
  const auto halted = [&] {  // on any thread, and from then on
    if (ended == FitStop::AtRest && out_of_time()) ended = FitStop::TimeLimit;
    if (ended == FitStop::AtRest && options.cancelled && options.cancelled())
      ended = FitStop::Cancelled;
    return ended != FitStop::AtRest;
  };
  for (int pass = first_pass; pass < kPasses && ended == FitStop::AtRest; ++pass) {
    problem.allow({unhurried.vertex_steps, halted});
    const ResidualsAt residuals = [&](const std::vector<Eigen::VectorXd>& points) {
      const std::vector<FitAnswer> answers = problem.answers(points);
      std::vector<Eigen::VectorXd> all;
      for (std::size_t i = 0; i < points.size(); ++i)
        all.push_back(problem.residual(points[i], answers[i], weights));
      return all;
    };
    LeastSquaresOptions fitting;
    fitting.most_rounds = options.most_rounds;
    fitting.progress = [&](int round, double cost) {
      const double rms_mm = std::sqrt(cost / weights.independent) * weights.noise_mm;
      if (options.progress && !options.progress(fit.rounds + round, rms_mm))
        ended = FitStop::Cancelled;
      return !halted();
    };
    fitting.keep = [&](const LeastSquaresState& squares) {
      if (options.keep)
        options.keep({pass, weights.noise_mm, weights.independent, weights.outlier_mm, squares,
                      fit.rounds, problem.closures(), problem.nearest().point,
                      problem.nearest().rms_mm});
    };
    const bool resumes = goes_on && pass == first_pass;
    const LeastSquaresFit found =
        resumes ? resume_least_squares(residuals, options.from->squares, fitting)
                : fit_least_squares(residuals, point, fitting);
    point = found.point;
    fit.rounds += found.rounds;
    fit.stop = ended;
    if (fit.stop == FitStop::AtRest && found.rounds >= options.most_rounds)
      fit.stop = FitStop::RoundLimit;
    problem.allow(unhurried);
    answer = problem.answers({point}).front();
    weights = weights_of(fit.points_mm, answer);
  }
  const Eigen::VectorXd most_probable = point;
  if (!(rms_distance_mm(answer) <= kAsNear * problem.nearest().rms_mm)) {
    point = problem.nearest().point;
    answer = problem.answers({point}).front();
    weights = weights_of(fit.points_mm, answer);
  }

  const std::vector<double> values = problem.values(point);
  Expected<Valve> fitted = with_parameters(valve, problem.parameters(), values);
  if (!fitted) return fitted.errors();
  fit.closed = close_and_measure(*fitted, options.closure);
  fit.distances_mm = answer.distances_mm;
  fit.rms_mm = rms_distance_mm(answer);
  fit.best_rms_mm = problem.nearest().rms_mm;
  fit.independent_points = weights.independent;
  const FitPosterior posterior = posterior_at(problem, point, weights);
  const Eigen::VectorXd away = shift(problem, point, most_probable);
  fit.covariance = posterior.covariance + away * away.transpose();
  fit.leak = {fit.closed.measure.leak.area_mm2,
              Vec2(posterior.leak_sd_mm2, fit.closed.measure.leak_error_mm2).norm()};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const double sd = std::sqrt(fit.covariance(at, at));
    fit.parameters.push_back({problem.parameters()[i], values[i], sd,
                              sd < kIdentified * problem.parameters()[i].prior_sd});
  }
  fit.closed.valve.fitted = uncertainty(fit);
  fit.closures = problem.closures() + 2;
  return fit;
}

}  // namespace coapt
