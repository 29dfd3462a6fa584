#include "search/studies/calibration.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "core/metrics/orifice.h"
#include "core/presets/presets.h"
#include "search/evaluator.h"
#include "search/least_squares.h"
#include "search/parallel.h"
#include "search/random_share.h"
#include "search/rank_correlation.h"
#include "search/studies/geometry_studies.h"
#include "search/studies/thesis_figures.h"

namespace coapt {
namespace {

using Point = Eigen::VectorXd;
constexpr double kFailed_mm2 =
    400.0;  // of a valve that cannot be made or closed: twice the largest

/// Orifices of one anatomy at all targets; kFailed_mm2 where it does not close uncrossed.
struct Answers {
  std::vector<double> area_mm2;
  int untrusted = 0;
};

std::vector<Answers> close_all(const std::vector<Anatomy>& anatomies,
                               const std::vector<CalibrationTarget>& targets, int threads) {
  const int size = static_cast<int>(targets.size());
  std::vector<std::optional<Valve>> valves(anatomies.size());
  for_each_index(static_cast<int>(anatomies.size()), threads, [&](int at) {
    const Expected<Valve> valve = make_taut_valve(parametric_valve(anatomies[at], "calibrated"));
    if (valve) valves[at] = *valve;
  });
  std::vector<double> area(anatomies.size() * size, kFailed_mm2);
  std::vector<char> fine(area.size(), 0);
  for_each_index(static_cast<int>(area.size()), threads, [&](int at) {
    const std::optional<Valve>& valve = valves[at / size];
    if (!valve) return;
    const Expected<Valve> changed = configure(*valve, targets[at % size].configuration);
    if (!changed) return;
    const ClosureResult closure = close_valve(*changed);
    if (!trusted(closure)) return;
    area[at] = orifice_mm2(*changed, closure.closed_mm);
    fine[at] = 1;
  });
  std::vector<Answers> answers(anatomies.size());
  for (int i = 0; i < std::ssize(area); ++i) {
    answers[i / size].area_mm2.push_back(area[i]);
    if (fine[i] == 0) ++answers[i / size].untrusted;
  }
  return answers;
}

std::vector<double> shares_of(const Point& point) {
  return {point.data(), point.data() + point.size()};
}

Point typical_point() {
  Point point(kAnatomyParameters);
  for (int i = 0; i < kAnatomyParameters; ++i) {
    const AnatomyParameter& p = anatomy_parameters()[i];
    point(i) = (p.typical - p.lower) / (p.upper - p.lower);
  }
  return point;
}

Calibration judged(const Anatomy& anatomy, const Answers& answers, int closures) {
  Calibration result{anatomy, answers.area_mm2};
  result.untrusted = answers.untrusted;
  result.closures = closures;
  std::vector<double> ours, theirs;
  for (std::size_t k = 0; k < 3; ++k)
    result.largest_dilation_error =
        std::max(result.largest_dilation_error,
                 std::abs(answers.area_mm2[k] / thesis::kDilated_mm2[k] - 1.0));
  for (std::size_t row = 0, k = 3; row < 3; ++row)
    for (const double area : thesis::kDisplaced_mm2[row]) {
      theirs.push_back(area);
      ours.push_back(answers.area_mm2[k++]);
      result.rms_mm2 += std::pow(ours.back() - area, 2) / 21.0;
    }
  result.rms_mm2 = std::sqrt(result.rms_mm2);
  result.spearman = rank_correlation(ours, theirs);
  return result;
}

}  // namespace

std::vector<CalibrationTarget> calibration_targets() {
  std::vector<CalibrationTarget> targets;
  for (std::size_t k = 0; k < 3; ++k) {
    Configuration dilated;
    dilated.change.ap_dilation_percent = thesis::kDilation_percent[k];
    targets.push_back(
        {"AP " + std::to_string(static_cast<int>(thesis::kDilation_percent[k])) + " %", dilated,
         thesis::kDilated_mm2[k]});
  }
  for (std::size_t row = 0; row < kDisplaced.size(); ++row)
    for (std::size_t k = 0; k < kAxes.size(); ++k) {
      const Vec3 by(kAxes[k][0], kAxes[k][1], kAxes[k][2]);
      targets.push_back({std::string(to_string(kDisplaced[row])) + ' ' + kAxesNames[k],
                         displacement(kDisplaced[row], kMostDisplacement_mm * by),
                         thesis::kDisplaced_mm2[row][k]});
    }
  targets.push_back({"undisturbed", {}, 0.0});
  return targets;
}

Calibration calibrate(const CalibrationOptions& options) {
  const std::vector<CalibrationTarget> targets = calibration_targets();
  const Point typical = typical_point();
  int closures = 0;
  const auto residual_of = [&](const Point& point, const Answers& answers) {
    const auto size = std::ssize(targets);
    Point residual(size + point.size());
    for (Eigen::Index k = 0; k < size; ++k)
      residual(k) = std::sqrt(answers.area_mm2[k] + 1.0) - std::sqrt(targets[k].area_mm2 + 1.0);
    residual.tail(point.size()) = options.towards_typical * (point - typical);
    return residual;
  };
  const ResidualsAt residuals = [&](const std::vector<Point>& points) {
    std::vector<Anatomy> anatomies;
    for (const Point& point : points) anatomies.push_back(anatomy_at(shares_of(point)));
    const std::vector<Answers> answers = close_all(anatomies, targets, options.threads);
    closures += static_cast<int>(points.size() * (targets.size() + 1));
    std::vector<Point> all;
    for (std::size_t i = 0; i < points.size(); ++i)
      all.push_back(residual_of(points[i], answers[i]));
    return all;
  };
  std::mt19937_64 engine(options.seed);
  const auto die = [&] { return 2.0 * random_share(engine) - 1.0; };
  std::vector<Point> looks = {typical};
  while (static_cast<int>(looks.size()) < options.first_looks) {
    Point look = typical;
    for (Eigen::Index i = 0; i < look.size(); ++i)
      look(i) = std::clamp(look(i) + options.spread * die(), 0.0, 1.0);
    looks.push_back(look);
  }
  const std::vector<Point> seen = residuals(looks);
  std::size_t best = 0;
  for (std::size_t i = 1; i < seen.size(); ++i)
    if (seen[i].squaredNorm() < seen[best].squaredNorm()) best = i;
  LeastSquaresOptions fitting;
  fitting.most_rounds = options.most_rounds;
  fitting.progress = [&](int round, double cost) {
    return !options.progress || options.progress(round, cost);
  };
  const LeastSquaresFit fit = fit_least_squares(residuals, looks[best], fitting);
  const Anatomy anatomy = anatomy_at(shares_of(fit.point));
  return judged(anatomy, close_all({anatomy}, targets, options.threads).front(), closures);
}

}  // namespace coapt
