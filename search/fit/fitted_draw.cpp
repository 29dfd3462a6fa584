#include "search/fit/fitted_draw.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>

#include "search/fit/fit_parameters.h"

namespace coapt {
namespace {

/// The standard normal number that a share of the distribution lies below, by bisection.
double normal_quantile(double share) {
  double low = -8.0, high = 8.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle * std::sqrt(0.5)) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::vector<FitParameter>::const_iterator named(const std::vector<FitParameter>& all,
                                                const std::string& name) {
  return std::find_if(all.begin(), all.end(),
                      [&](const FitParameter& parameter) { return parameter.name == name; });
}

}  // namespace

Errors check_fitted_parameters(const Valve& valve) {
  Errors errors;
  if (!valve.fitted) return errors;
  const std::vector<FitParameter> all = fit_parameters(valve, {});
  std::string accepted;
  for (const FitParameter& parameter : all)
    accepted += (accepted.empty() ? "" : ", ") + parameter.name;
  for (std::size_t i = 0; i < valve.fitted->parameters.size(); ++i)
    if (const std::string& name = valve.fitted->parameters[i]; named(all, name) == all.end())
      errors.push_back({ErrorCode::OutOfRange, "/fit/parameters/" + std::to_string(i),
                        "is '" + name + "', must be one of this valve's: " + accepted});
  return errors;
}

Expected<Valve> with_fitted_draw(const Valve& valve, const std::vector<double>& shares) {
  const auto& [names, covariance] = *valve.fitted;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(covariance);
  Eigen::VectorXd along(covariance.rows());
  for (Eigen::Index i = 0; i < along.size(); ++i)
    along(i) = std::sqrt(std::max(0.0, axes.eigenvalues()(i))) *
               normal_quantile(shares[static_cast<std::size_t>(i)]);
  const Eigen::VectorXd moved = axes.eigenvectors() * along;
  const std::vector<FitParameter> all = fit_parameters(valve, {});
  std::vector<FitParameter> parameters;
  std::vector<double> values;
  for (std::size_t i = 0; i < names.size(); ++i) {
    parameters.push_back(*named(all, names[i]));
    const FitParameter& parameter = parameters.back();
    values.push_back(std::clamp(parameter.prior + moved(static_cast<Eigen::Index>(i)),
                                parameter.lower, parameter.upper));
  }
  return with_parameters(valve, parameters, values);
}

}  // namespace coapt
