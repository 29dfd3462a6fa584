#include "io/json/population_json.h"

#include <algorithm>
#include <utility>

#include "io/json/json_reader.h"
#include "io/json/parse_json.h"
#include "io/json/population_prior_json.h"
#include "io/json/result_json.h"
#include "io/json/version.h"
#include "search/population/population_factors.h"

namespace coapt {
namespace {

constexpr int kMostMembers = 100'000;

struct CountName {
  const char* name;
  int DrawCounts::*count;
};
constexpr std::array<CountName, 9> kCountNames = {
    {{"anatomies", &DrawCounts::anatomies},
     {"anatomies_invalid", &DrawCounts::anatomies_invalid},
     {"anatomies_untrusted", &DrawCounts::anatomies_untrusted},
     {"anatomies_leaking", &DrawCounts::anatomies_leaking},
     {"anatomies_resistant", &DrawCounts::anatomies_resistant},
     {"lesions", &DrawCounts::lesions},
     {"lesions_invalid", &DrawCounts::lesions_invalid},
     {"lesions_untrusted", &DrawCounts::lesions_untrusted},
     {"lesions_competent", &DrawCounts::lesions_competent}}};

template <std::size_t N>
Json names_of(const std::array<PopulationFactor, N>& factors) {
  Json names = Json::array();
  for (const PopulationFactor& factor : factors) names.push_back(factor.name);
  return names;
}

/// The order of another version's factors could not be told from its numbers.
template <std::size_t N>
void check_names(const JsonPlace& place, const std::array<PopulationFactor, N>& factors) {
  if (place.value != names_of(factors))
    add_problem(place, ErrorCode::Unsupported, "names other factors than this version of coapt");
}

template <std::size_t N>
std::array<double, N> read_values(const JsonPlace& place) {
  const std::vector<double> read = read_list(place, read_number);
  std::array<double, N> values{};
  if (place.value.is_array() && read.size() != N)
    add_problem(place, ErrorCode::OutOfRange, "must have " + std::to_string(N) + " numbers");
  else
    std::copy(read.begin(), read.end(), values.begin());
  return values;
}

DrawCounts read_draws(const JsonPlace& place) {
  DrawCounts draws;
  std::vector<JsonField> fields;
  for (const CountName& count : kCountNames)
    fields.push_back({count.name, [&draws, &count](const JsonPlace& at) {
                        draws.*count.count = read_integer(at);
                      }});
  read_fields(place, fields);
  return draws;
}

PopulationMember read_member(const JsonPlace& place) {
  PopulationMember member;
  read_fields(place, {{"index", into(member.index, read_integer)},
                      {"aetiology",
                       [&](const JsonPlace& at) {
                         member.aetiology =
                             read_name(at, std::vector(kAetiologies.begin(), kAetiologies.end()));
                       }},
                      {"anatomy", into(member.anatomy, read_values<kAnatomyFactors>)},
                      {"lesions", into(member.lesions, read_values<kLesionFactors>)},
                      {"leak_healthy_mm2", into(member.leak_healthy_mm2, read_number)},
                      {"leak_mm2", into(member.leak_mm2, read_number)},
                      {"draws", into(member.draws, read_draws)}});
  return member;
}

void read_members(const JsonPlace& place, Population& population) {
  population.members = read_list(place, read_member);
  if (population.members.size() > kMostMembers)
    add_problem(place, ErrorCode::OutOfRange,
                "must have at most " + std::to_string(kMostMembers) + " members");
  for (std::size_t i = 0; i < population.members.size(); ++i)
    if (population.members[i].index != static_cast<int>(i)) {
      add_problem(place, ErrorCode::OutOfRange, "must be ordered by index, from 0");
      return;
    }
}

}  // namespace

Json to_json(const PopulationMember& member) {
  Json draws;
  for (const CountName& count : kCountNames) draws[count.name] = member.draws.*count.count;
  return {{"index", member.index},
          {"aetiology", to_string(member.aetiology)},
          {"anatomy", member.anatomy},
          {"lesions", member.lesions},
          {"leak_healthy_mm2", member.leak_healthy_mm2},
          {"leak_mm2", member.leak_mm2},
          {"draws", std::move(draws)}};
}

Expected<PopulationMember> member_from_json(const Json& json) {
  ProblemList problems;
  PopulationMember member = read_member({json, problems});
  if (!problems.empty()) return std::move(problems).take();
  return member;
}

Json to_json(const Population& population) {
  Json members = Json::array();
  for (const PopulationMember& member : population.members) members.push_back(to_json(member));
  return result_document("coapt.population/1", {{"seed", population.seed},
                                                {"prior", to_json(population.prior)},
                                                {"anatomy_factors", names_of(anatomy_factors())},
                                                {"lesion_factors", names_of(lesion_factors())},
                                                {"members", std::move(members)}});
}

Expected<Population> population_from_json(const Json& json) {
  ProblemList problems;
  const JsonPlace top{json, problems};
  Population population;
  read_fields(
      top,
      {{"schema", [](const JsonPlace& place) { read_schema(place, "coapt.population/1"); }},
       {"version", [](const JsonPlace& place) { read_string(place); }},
       {"revision", [](const JsonPlace&) {}, false},
       {"notice", [](const JsonPlace& place) { read_string(place); }},
       {"seed", into(population.seed, read_unsigned)},
       {"prior", document(population.prior, prior_from_json)},
       {"anatomy_factors", [](const JsonPlace& place) { check_names(place, anatomy_factors()); }},
       {"lesion_factors", [](const JsonPlace& place) { check_names(place, lesion_factors()); }},
       {"members", [&](const JsonPlace& place) { read_members(place, population); }}});
  if (!problems.empty()) return std::move(problems).take();
  return population;
}

Expected<Population> read_population(std::string_view text) {
  const Expected<Json> json = parse_json(text);
  if (!json) return json.errors();
  return population_from_json(*json);
}

}  // namespace coapt
