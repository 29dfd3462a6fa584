// A fit as a problem of least squares: points of the unit cube in, residuals out.
#pragma once

#include <Eigen/Core>
#include <atomic>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "search/fit/fit.h"

namespace coapt {

/// A closed valve as the fit sees it.
struct FitAnswer {
  std::vector<double> distances_mm;  ///< of the measured points
  double leak_mm2 = 0.0;             ///< where it was measured
  bool trusted = false;              ///< it closes; else the numbers are large and mean nothing
};

/// Root mean square distance; NaN of one that is not trusted.
double rms_distance_mm(const FitAnswer& answer);

/// How residuals are weighed.
struct FitWeights {
  double noise_mm = 0.0;
  double independent = 0.0;  ///< points
  double outlier_mm =
      0.0;  ///< distances count as less and less beyond it (a point of another structure)
};

/// The place of the least rms distance among all that were closed.
struct NearestPoint {
  Eigen::VectorXd point;  ///< of the unit cube; empty: none yet
  double rms_mm = std::numeric_limits<double>::infinity();
};

/// From 3 mm, or from three times the median distance where the model lies farther off than that.
double outlier_mm(const FitAnswer& answer);

/// By the distances that an answer leaves.
FitWeights weights_of(const Points& points_mm, const FitAnswer& answer);

/// Ten times the steps of the valve as given, for each closure of a fit.
ClosureBudget unhurried_budget(const ClosedValve& before);

class FitProblem {
 public:
  /// All of these must outlive it; `points_mm` are those that are used.
  FitProblem(const Valve& valve, const MeasuredClosure& measured, const FitOptions& options,
             const Points& points_mm);

  const std::vector<FitParameter>& parameters() const { return parameters_; }
  int closures() const { return closures_; }
  /// Those of a run that was broken off, whose last answer is asked for once more.
  void count_before(int closures) { closures_ = closures - 1; }

  /// What each closure from now on may cost.
  void allow(ClosureBudget budget) { budget_ = std::move(budget); }

  /// In the cube; values by name, others at their priors.
  Eigen::VectorXd point_of(const std::map<std::string, double>& values) const;
  std::vector<double> values(const Eigen::VectorXd& point) const;

  FitAnswer answer_of(const ClosedValve& closed) const;
  /// Their leaks are measured if the fit knows one: that takes longer than to close.
  std::vector<FitAnswer> answers(const std::vector<Eigen::VectorXd>& points);
  std::vector<FitAnswer> answers_with_leaks(const std::vector<Eigen::VectorXd>& points);

  const NearestPoint& nearest() const { return nearest_; }
  /// A place that another run has met, or a closure that was made elsewhere.
  void meet(const NearestPoint& place);

  /// Weighed distances, the leak, and how far each value is from its prior.
  Eigen::VectorXd residual(const Eigen::VectorXd& point, const FitAnswer& answer,
                           const FitWeights& weights) const;

 private:
  std::vector<FitAnswer> answers(const std::vector<Eigen::VectorXd>& points, bool with_leaks);

  const Valve& valve_;
  const MeasuredClosure& measured_;
  const FitOptions& options_;
  const Points& points_mm_;
  std::vector<FitParameter> parameters_;
  ClosureBudget budget_;
  NearestPoint nearest_;
  std::atomic<int> closures_ = 0;
};

}  // namespace coapt
