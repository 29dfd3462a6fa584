#include "io/json/weights_json.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "io/json/json_reader.h"
#include "io/json/parse_json.h"
#include "io/json/result_json.h"
#include "io/json/search_options_json.h"
#include "io/json/version.h"
#include "search/preference/posterior_draws.h"

namespace coapt {
namespace {

constexpr Range kPositive = {1e-6, 1e6};
constexpr Range kCovariances = {-1e3, 1e3};
constexpr double kSymmetric = 1e-9;

Json unknown_names() {
  Json names = Json::array();
  for (int i = 0; i < kUnknowns; ++i) names.push_back(unknown_name(i));
  return names;
}

Json log_sd_json(const Unknowns& sd) {
  Json json;
  for (int i = 0; i < kUnknowns; ++i) json[unknown_name(i)] = sd[i];
  return json;
}

Json covariance_json(const UnknownsMatrix& matrix) {
  Json rows = Json::array();
  for (int i = 0; i < kUnknowns; ++i) {
    Json row = Json::array();
    for (int j = 0; j < kUnknowns; ++j) row.push_back(matrix(i, j));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json informed_json(const PreferencePosterior& posterior) {
  const std::vector<bool> said = informed(posterior);
  Json names = Json::array();
  for (int term = 0; term < kLearnedTerms; ++term)
    if (said[static_cast<std::size_t>(term)]) names.push_back(unknown_name(term));
  return names;
}

void read_unknown_names(const JsonPlace& place) {
  if (place.value != unknown_names())
    add_problem(place, ErrorCode::BadReference, "must be " + unknown_names().dump());
}

UnknownsMatrix read_covariance_matrix(const JsonPlace& place) {
  UnknownsMatrix matrix = UnknownsMatrix::Identity();
  const auto rows = read_list(place, [](const JsonPlace& row) {
    return read_list(row, [](const JsonPlace& at) { return read_number_in(at, kCovariances); });
  });
  const auto full = [](const auto& row) { return row.size() == kUnknowns; };
  if (rows.size() != kUnknowns || !std::all_of(rows.begin(), rows.end(), full)) {
    const std::string count = std::to_string(kUnknowns);
    add_problem(place, ErrorCode::OutOfRange, "must have " + count + " rows of " + count);
    return matrix;
  }
  for (int i = 0; i < kUnknowns; ++i)
    for (int j = 0; j < kUnknowns; ++j)
      matrix(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  const bool symmetric = (matrix - matrix.transpose()).cwiseAbs().maxCoeff() < kSymmetric;
  if (!symmetric || Eigen::LLT<UnknownsMatrix>(matrix).info() != Eigen::Success)
    add_problem(place, ErrorCode::OutOfRange, "must be symmetric and positive definite");
  return matrix;
}

UnknownsMatrix read_covariance(const JsonPlace& place) {
  UnknownsMatrix matrix = UnknownsMatrix::Identity();
  read_fields(place,
              {{"names", read_unknown_names}, {"matrix", into(matrix, read_covariance_matrix)}});
  return matrix;
}

/// In the logarithms' place, so that a weight of 0 has none.
double read_logarithm(const JsonPlace& place) { return std::log(read_number_in(place, kPositive)); }

Unknowns read_log_weights(const JsonPlace& place) {
  Unknowns logarithms = Unknowns::Zero();
  for (int term = 0; term < kLearnedTerms; ++term)
    if (const std::optional<JsonPlace> at = read_member(
            place, cost_term_rows()[static_cast<std::size_t>(term)].name))  // outlives the place
      logarithms[term] = read_logarithm(*at);
  return logarithms;
}

CostTerms terms_from_json(const Json& plan) {
  CostTerms terms;
  for (int term = 0; term < kTerms; ++term)
    terms.amounts[term] =
        plan["cost_terms"][cost_term_rows()[static_cast<std::size_t>(term)].name].get<double>();
  return terms;
}

}  // namespace

Json to_json(const LearnedWeights& learned, const AnswerCounts& counts) {
  const PreferencePosterior& posterior = learned.posterior;
  return result_document(
      "coapt.weights/1",
      {{"weights", to_json(learned.weights)},
       {"noise_mm2", std::exp(posterior.mean[kNoise])},
       {"tie", std::exp(posterior.mean[kTie])},
       {"log_sd", log_sd_json(log_sd(posterior))},
       {"covariance",
        {{"names", unknown_names()}, {"matrix", covariance_json(posterior.covariance)}}},
       {"informed", informed_json(posterior)},
       {"answers", counts.answers},
       {"unable", counts.unable},
       {"consistency", counts.consistency ? Json(*counts.consistency) : Json()}});
}

Expected<LearnedWeights> read_learned_weights(std::string_view text) {
  const Expected<Json> json = parse_json(text);
  if (!json) return json.errors();
  ProblemList problems;
  LearnedWeights learned;
  Unknowns& mean = learned.posterior.mean;
  double log_noise = 0.0, log_tie = 0.0;
  const auto read_weights_and_logarithms = [&](const JsonPlace& at) {
    learned.weights = read_cost_weights(at);
    mean = read_log_weights(at);
  };
  const auto ignore = [](const JsonPlace&) {};
  read_fields({*json, problems},
              {{"schema", [](const JsonPlace& at) { read_schema(at, "coapt.weights/1"); }},
               {"version", ignore, false},
               {"revision", ignore, false},
               {"notice", ignore, false},
               {"weights", read_weights_and_logarithms},
               {"noise_mm2", into(log_noise, read_logarithm)},
               {"tie", into(log_tie, read_logarithm)},
               {"log_sd", ignore, false},
               {"covariance", into(learned.posterior.covariance, read_covariance)},
               {"informed", ignore, false},
               {"answers", ignore, false},
               {"unable", ignore, false},
               {"consistency", ignore, false}});
  if (!problems.empty()) return std::move(problems).take();
  mean[kNoise] = log_noise;
  mean[kTie] = log_tie;
  return learned;
}

void add_preferred_over_next(Json& result, const PreferencePosterior& posterior) {
  const PosteriorDraws draws = draw(posterior);
  Json& plans = result["plans"];
  for (std::size_t i = 0; i < plans.size(); ++i) {
    plans[i]["preferred_over_next"] = nullptr;
    if (i + 1 == plans.size()) break;
    const CostTerms apart = {terms_from_json(plans[i]).amounts -
                             terms_from_json(plans[i + 1]).amounts};
    plans[i]["preferred_over_next"] = preferred(apart, draws);
  }
}

}  // namespace coapt
