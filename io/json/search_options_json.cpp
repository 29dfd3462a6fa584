#include "io/json/json_reader.h"
#include "io/json/result_json.h"

namespace coapt {
namespace {

JsonField number(std::string_view name, double& target, Range range, const char* unit = "") {
  const auto read = [=](const JsonPlace& place) { return read_number_in(place, range, unit); };
  return {name, into(target, read), false};
}

JsonField integer(std::string_view name, int& target, int min, int max) {
  const auto read = [=](const JsonPlace& place) { return read_integer_in(place, min, max); };
  return {name, into(target, read), false};
}

}  // namespace

Expected<SearchOptions> search_options_from_json(const nlohmann::json& json) {
  ProblemList problems;
  SearchOptions options;
  read_fields({json, problems}, {integer("evaluations", options.evaluations, 1, 1'000'000),
                                 {"seed", into(options.seed, read_unsigned), false},
                                 integer("threads", options.threads, 0, 1024),
                                 integer("plans", options.plans, 1, 50),
                                 integer("region_points", options.region_points, 1, 1089),
                                 number("seconds", options.seconds, {0.0, 1e6}, " s")});
  if (!problems.empty()) return std::move(problems).take();
  return options;
}

}  // namespace coapt
