#include "io/json/population_prior_json.h"

#include <cassert>
#include <map>
#include <utility>

#include "io/json/json_reader.h"
#include "io/json/parse_json.h"
#include "io/json/population_json.h"
#include "search/population/population_factors.h"

namespace coapt {
namespace {

PriorFactor read_factor(const JsonPlace& place) {
  PriorFactor factor;
  PriorDistribution& d = factor.distribution;
  read_fields(place, {{"mean", into(d.mean, read_number)},
                      {"sd", into(d.sd, read_number)},
                      {"min", into(d.min, read_number)},
                      {"max", into(d.max, read_number)},
                      {"source", into(factor.source, read_string)},
                      {"assumed", into(factor.assumed, read_boolean), false}});
  return factor;
}

/// An object of factors by name, those of `known` alone.
template <std::size_t N>
std::vector<PriorFactor> read_factors(const JsonPlace& place,
                                      const std::array<PopulationFactor, N>& known) {
  std::vector<PriorFactor> factors;
  std::vector<JsonField> fields;
  for (std::size_t f = 0; f < N; ++f)
    fields.push_back({known[f].name,
                      [&factors, f](const JsonPlace& at) {
                        factors.push_back(read_factor(at));
                        factors.back().factor = static_cast<int>(f);
                      },
                      false});
  read_fields(place, fields);
  return factors;
}

int read_anatomy_factor(const JsonPlace& place) {
  std::vector<std::string> names;
  for (const PopulationFactor& factor : anatomy_factors()) names.emplace_back(factor.name);
  return static_cast<int>(read_choice(place, names).value_or(0));
}

PriorCorrelation read_correlation(const JsonPlace& place) {
  PriorCorrelation pair;
  read_fields(place, {{"first", into(pair.first, read_anatomy_factor)},
                      {"second", into(pair.second, read_anatomy_factor)},
                      {"r", into(pair.r, read_number)},
                      {"source", into(pair.source, read_string)},
                      {"assumed", into(pair.assumed, read_boolean), false}});
  return pair;
}

AetiologyPrior read_aetiology(const JsonPlace& place) {
  AetiologyPrior prior;
  read_fields(place, {{"name",
                       [&](const JsonPlace& at) {
                         prior.aetiology =
                             read_name(at, std::vector(kAetiologies.begin(), kAetiologies.end()));
                       }},
                      {"share", into(prior.share, read_number)},
                      {"source", into(prior.source, read_string)},
                      {"assumed", into(prior.assumed, read_boolean), false},
                      {"lesions", [&](const JsonPlace& at) {
                         prior.lesions = read_factors(at, lesion_factors());
                       }}});
  return prior;
}

Json factors_to_json(const std::vector<PriorFactor>& factors,
                     std::span<const PopulationFactor> known) {
  Json json = Json::object();
  for (const PriorFactor& factor : factors) {
    const PriorDistribution& d = factor.distribution;
    json[known[static_cast<std::size_t>(factor.factor)].name] = {{"mean", d.mean},
                                                                 {"sd", d.sd},
                                                                 {"min", d.min},
                                                                 {"max", d.max},
                                                                 {"source", factor.source},
                                                                 {"assumed", factor.assumed}};
  }
  return json;
}

}  // namespace

Expected<PopulationPrior> prior_from_json(const Json& json) {
  ProblemList problems;
  const JsonPlace top{json, problems};
  PopulationPrior prior;
  read_fields(
      top,
      {{"schema", [](const JsonPlace& place) { read_schema(place, "coapt.population_prior/1"); }},
       {"name", into(prior.name, read_string)},
       {"anatomy",
        [&](const JsonPlace& place) { prior.anatomy = read_factors(place, anatomy_factors()); }},
       {"correlations",
        [&](const JsonPlace& place) { prior.correlations = read_list(place, read_correlation); }},
       {"aetiologies",
        [&](const JsonPlace& place) { prior.aetiologies = read_list(place, read_aetiology); }}});
  if (problems.empty()) add_below(problems, "", check_prior(prior));
  if (!problems.empty()) return std::move(problems).take();
  return prior;
}

Expected<PopulationPrior> read_prior(std::string_view text) {
  const Expected<Json> json = parse_json(text);
  if (!json) return json.errors();
  return prior_from_json(*json);
}

Json to_json(const PopulationPrior& prior) {
  Json correlations = Json::array(), aetiologies = Json::array();
  for (const PriorCorrelation& pair : prior.correlations)
    correlations.push_back(
        {{"first", anatomy_factors()[static_cast<std::size_t>(pair.first)].name},
         {"second", anatomy_factors()[static_cast<std::size_t>(pair.second)].name},
         {"r", pair.r},
         {"source", pair.source},
         {"assumed", pair.assumed}});
  for (const AetiologyPrior& aetiology : prior.aetiologies)
    aetiologies.push_back({{"name", to_string(aetiology.aetiology)},
                           {"share", aetiology.share},
                           {"source", aetiology.source},
                           {"assumed", aetiology.assumed},
                           {"lesions", factors_to_json(aetiology.lesions, lesion_factors())}});
  return {{"schema", "coapt.population_prior/1"},
          {"name", prior.name},
          {"anatomy", factors_to_json(prior.anatomy, anatomy_factors())},
          {"correlations", std::move(correlations)},
          {"aetiologies", std::move(aetiologies)}};
}

PopulationPrior adult_prior() {
  Expected<PopulationPrior> prior = read_prior(adult_prior_text());
  assert(prior);  // a test reads it
  return *std::move(prior);
}

}  // namespace coapt
