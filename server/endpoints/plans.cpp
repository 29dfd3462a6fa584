#include "server/endpoints/plans.h"

#include "io/json/plans_json.h"
#include "io/json/search_options_json.h"
#include "io/json/valve_json.h"
#include "io/store/subject.h"
#include "search/plans/plan_search.h"
#include "server/request.h"

namespace coapt {

Answer PostPlans::operator()(std::string_view body) const {
  const Expected<nlohmann::json> request = parse_json(body);
  if (!request) return problem(400, request.errors());
  Valve valve;
  SearchOptions options;
  ProblemList problems;
  read_fields({*request, problems},
              {{"valve", document(valve, valve_from_json)},
               {"search", document(options, search_options_from_json), false}});
  if (!problems.empty()) return problem(422, std::move(problems).take());

  SearchContext context{.catalogue = catalogue, .cancelled = &stopping};
  const Expected<SearchResult> result = search_plans(valve, options, context);
  if (!result) {
    add_below(problems, "/search", result.errors());
    return problem(422, std::move(problems).take());
  }
  return {200, to_json(*result, {options, subject_of(valve, options.closure), ""})};
}

}  // namespace coapt
