#include "search/fit/fit_problem.h"

#include <algorithm>
#include <cmath>

#include "core/metrics/leak.h"
#include "core/metrics/quantile.h"
#include "search/evaluator.h"
#include "search/fit/correlated_noise.h"
#include "search/parallel.h"

namespace coapt {
namespace {

constexpr double kLeastOutlier_mm = 3.0, kOutlierMedians = 3.0;  // assumed
constexpr double kUntrusted_mm = 10.0;      // distance of a valve that does not close
constexpr double kMostTimesAsGiven = 10.0;  // steps of a closure

constexpr double kLeastNoise_mm = 0.01;
// Of the variance of fitted values over that of the linearised posterior, in 20 twins (coapt-lab chart twins; 20 others
// judge it): residuals of a fit are less alike than the errors that it has absorbed, and the mesh adds its own.
constexpr double kDiscrepancy = 3.5;

double capped(double distance_mm, double outlier_mm) {
  return distance_mm / Vec2(1.0, distance_mm / outlier_mm).norm();
}

}  // namespace

double rms_distance_mm(const FitAnswer& answer) {
  if (!answer.trusted) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  for (const double distance : answer.distances_mm) sum += distance * distance;
  return std::sqrt(sum / static_cast<double>(answer.distances_mm.size()));
}

double outlier_mm(const FitAnswer& answer) {
  std::vector<double> away;
  for (const double distance : answer.distances_mm) away.push_back(std::abs(distance));
  return std::max(kLeastOutlier_mm, kOutlierMedians * quantile(std::move(away), 0.5));
}

FitWeights weights_of(const Points& points_mm, const FitAnswer& answer) {
  const CorrelatedNoise noise = correlated_noise(points_mm, answer.distances_mm);
  return {std::max(kLeastNoise_mm, noise.sd_mm), noise.independent / kDiscrepancy,
          outlier_mm(answer)};
}

ClosureBudget unhurried_budget(const ClosedValve& before) {
  const double most_steps = kMostTimesAsGiven * before.closure.steps;
  return {most_steps * static_cast<double>(before.valve.rest_mm.rows()), {}};
}

FitProblem::FitProblem(const Valve& valve, const MeasuredClosure& measured,
                       const FitOptions& options, const Points& points_mm)
    : valve_(valve),
      measured_(measured),
      options_(options),
      points_mm_(points_mm),
      parameters_(fit_parameters(valve, options.unknowns)) {}

Eigen::VectorXd FitProblem::point_of(const std::map<std::string, double>& values) const {
  Eigen::VectorXd at(std::ssize(parameters_));
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    const FitParameter& p = parameters_[static_cast<std::size_t>(i)];
    const auto given = values.find(p.name);
    const double value = given == values.end() ? p.prior : given->second;
    at(i) = std::clamp((value - p.lower) / (p.upper - p.lower), 0.0, 1.0);
  }
  return at;
}

std::vector<double> FitProblem::values(const Eigen::VectorXd& point) const {
  std::vector<double> all;
  for (Eigen::Index i = 0; i < point.size(); ++i) {
    const FitParameter& p = parameters_[static_cast<std::size_t>(i)];
    all.push_back(p.lower + point(i) * (p.upper - p.lower));
  }
  return all;
}

FitAnswer FitProblem::answer_of(const ClosedValve& closed) const {
  return {signed_distances_mm(points_mm_, surface_of(closed), measured_.side),
          closed.measure.leak.area_mm2, true};
}

std::vector<FitAnswer> FitProblem::answers(const std::vector<Eigen::VectorXd>& points) {
  return answers(points, measured_.leak_mm2.has_value());
}

std::vector<FitAnswer> FitProblem::answers_with_leaks(const std::vector<Eigen::VectorXd>& points) {
  return answers(points, true);
}

std::vector<FitAnswer> FitProblem::answers(const std::vector<Eigen::VectorXd>& points,
                                           bool with_leaks) {
  std::vector<FitAnswer> all(points.size());
  ClosureOptions closing = options_.closure;
  closing.budget = budget_;
  for_each_index(static_cast<int>(points.size()), options_.threads, [&](int at) {
    FitAnswer& answer = all[static_cast<std::size_t>(at)];
    const Expected<Valve> changed =
        with_parameters(valve_, parameters_, values(points[static_cast<std::size_t>(at)]));
    answer.distances_mm.assign(static_cast<std::size_t>(points_mm_.rows()), kUntrusted_mm);
    if (!changed || (budget_.cancelled && budget_.cancelled())) return;
    ClosedValve closed{*changed, close_valve(*changed, closing), {}};
    if (trusted(closed.closure)) {
      if (with_leaks) closed.measure.leak = measure_leak(*changed, closed.closure.closed_mm);
      answer = answer_of(closed);
    }
    ++closures_;
  });
  for (std::size_t i = 0; i < points.size(); ++i)
    if (all[i].trusted) meet({points[i], rms_distance_mm(all[i])});
  return all;
}

void FitProblem::meet(const NearestPoint& place) {
  if (place.rms_mm < nearest_.rms_mm) nearest_ = place;
}

Eigen::VectorXd FitProblem::residual(const Eigen::VectorXd& point, const FitAnswer& answer,
                                     const FitWeights& weights) const {
  const Eigen::Index n = points_mm_.rows(), m = point.size();
  const double each = std::sqrt(weights.independent / static_cast<double>(n)) / weights.noise_mm;
  Eigen::VectorXd all = Eigen::VectorXd::Zero(n + 1 + m);
  for (Eigen::Index i = 0; i < n; ++i)
    all(i) = each * capped(answer.distances_mm[static_cast<std::size_t>(i)], weights.outlier_mm);
  if (measured_.leak_mm2) all(n) = (answer.leak_mm2 - *measured_.leak_mm2) / measured_.leak_sd_mm2;
  const std::vector<double> at = values(point);
  for (Eigen::Index i = 0; i < m; ++i) {
    const FitParameter& p = parameters_[static_cast<std::size_t>(i)];
    all(n + 1 + i) = (at[static_cast<std::size_t>(i)] - p.prior) / p.prior_sd;
  }
  return all;
}

}  // namespace coapt
