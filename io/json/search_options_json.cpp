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

Method read_method(const JsonPlace& place) {
  const std::string name = read_string(place);
  for (const Method method : {Method::Fast, Method::Thesis})
    if (name == to_string(method)) return method;
  if (place.value.is_string())
    add_problem(place, ErrorCode::Unsupported, "is not a method, must be \"fast\" or \"thesis\"");
  return Method::Fast;
}

ClosureOptions read_closure_options(const JsonPlace& place) {
  ClosureOptions options;
  read_fields(place, {{"method", into(options.method, read_method), false},
                      number("residual_tolerance", options.residual_tolerance, {1e-6, 1.0})});
  return options;
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
                                 number("seconds", options.seconds, {0.0, 1e6}, " s"),
                                 {"closure", into(options.closure, read_closure_options), false}});
  if (!problems.empty()) return std::move(problems).take();
  return options;
}

}  // namespace coapt
