#include "io/json/fit_json.h"

#include <cmath>

#include "io/json/json_reader.h"
#include "io/json/result_json.h"
#include "io/json/version.h"

namespace coapt {
namespace {

Json parameters_json(const ValveFit& fit) {
  Json all = Json::array();
  for (const FittedParameter& fitted : fit.parameters) {
    const FitParameter& parameter = fitted.parameter;
    all.push_back({{"name", parameter.name},
                   {"unit", parameter.unit},
                   {"value", fitted.value},
                   {"sd", fitted.sd},
                   {"prior", parameter.prior},
                   {"prior_sd", parameter.prior_sd},
                   {"identifiable", fitted.identifiable}});
  }
  return all;
}

Json correlations_json(const Eigen::MatrixXd& covariance) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < covariance.cols(); ++j)
      row.push_back(covariance(i, j) / std::sqrt(covariance(i, i) * covariance(j, j)));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json hypotheses_json(const ValveFit& fit) {
  Json all = Json::array();
  for (const FitHypothesis& of : fit.hypotheses) {
    const bool closes = std::isfinite(of.rms_mm);
    all.push_back({{"name", of.name},
                   {"probability", of.probability},
                   {"objective", closes ? Json(of.objective) : Json(nullptr)},
                   {"rms_mm", closes ? Json(of.rms_mm) : Json(nullptr)},
                   {"leak_mm2", closes ? Json(of.leak_mm2) : Json(nullptr)},
                   {"refitted", of.refitted},
                   {"taken", of.name == fit.taken}});
  }
  return all;
}

Json leak_json(const ValveFit& fit, const MeasuredClosure& measured) {
  Json leak = {{"before", fit.before.measure.leak.area_mm2},
               {"fitted", fit.leak.mm2},
               {"sd", fit.leak.sd_mm2}};
  if (measured.leak_mm2) {
    leak["given"] = *measured.leak_mm2;
    leak["given_sd"] = measured.leak_sd_mm2;
  }
  return leak;
}

}  // namespace

Json to_json(const FitState& state) {
  const Eigen::VectorXd& point = state.squares.point;
  return {{"pass", state.pass},
          {"noise_mm", state.noise_mm},
          {"independent_points", state.independent_points},
          {"outlier_mm", state.outlier_mm},
          {"point", std::vector<double>(point.begin(), point.end())},
          {"difference", state.squares.difference},
          {"pass_rounds", state.squares.rounds},
          {"rounds", state.rounds},
          {"closures", state.closures},
          {"nearest", std::vector<double>(state.nearest.begin(), state.nearest.end())},
          {"nearest_rms_mm", state.nearest_rms_mm}};
}

std::optional<FitState> fit_state_from_json(const Json& json) {
  FitState state;
  std::vector<double> point, nearest;
  ProblemList problems;
  read_fields(
      {json, problems},
      {{"pass", into(state.pass, read_integer)},
       {"noise_mm", into(state.noise_mm, read_number)},
       {"independent_points", into(state.independent_points, read_number)},
       {"outlier_mm", into(state.outlier_mm, read_number)},
       {"point", [&](const JsonPlace& place) { point = read_list(place, read_number); }},
       {"difference", into(state.squares.difference, read_number)},
       {"pass_rounds", into(state.squares.rounds, read_integer)},
       {"rounds", into(state.rounds, read_integer)},
       {"closures", into(state.closures, read_integer)},
       {"nearest", [&](const JsonPlace& place) { nearest = read_list(place, read_number); }},
       {"nearest_rms_mm", into(state.nearest_rms_mm, read_number)}});
  if (!problems.empty()) return std::nullopt;
  state.nearest = Eigen::Map<const Eigen::VectorXd>(nearest.data(), std::ssize(nearest));
  state.squares.point = Eigen::Map<const Eigen::VectorXd>(point.data(), std::ssize(point));
  return state;
}

Json fit_to_json(const ValveFit& fit, const FittedFiles& files) {
  const bool atrial = files.measured.side == MeasuredSide::Atrial;
  Json json = result_document("coapt.fit/1", {{"valve", files.valve},
                                              {"closed", files.closed},
                                              {"side", atrial ? "atrial" : "middle"},
                                              {"rms_mm", fit.rms_mm},
                                              {"rms_before_mm", fit.rms_before_mm},
                                              {"best_rms_mm", fit.best_rms_mm},
                                              {"look", !doubts_of(fit).empty()},
                                              {"doubts", doubts_of(fit)},
                                              {"points",
                                               {{"given", files.measured.points_mm.rows()},
                                                {"used", fit.points_mm.rows()},
                                                {"independent", fit.independent_points}}},
                                              {"leak_mm2", leak_json(fit, files.measured)},
                                              {"parameters", parameters_json(fit)},
                                              {"correlations", correlations_json(fit.covariance)},
                                              {"rounds", fit.rounds},
                                              {"closures", fit.closures},
                                              {"finished", fit.stop == FitStop::AtRest},
                                              {"stop", to_string(fit.stop)}});
  if (!fit.hypotheses.empty()) {
    json["hypotheses"] = hypotheses_json(fit);
    json["hypotheses_left_out"] = fit.left_out;
  }
  return json;
}

}  // namespace coapt
