#include "server/endpoints/valves.h"

#include "core/presets/presets.h"
#include "io/json/parse_json.h"
#include "io/json/preset_words.h"
#include "io/json/repair_answers.h"
#include "io/json/result_json.h"
#include "io/json/valve_json.h"
#include "io/store/stored_valves.h"
#include "server/answers.h"
#include "server/content_id.h"
#include "server/jobs/job_board.h"
#include "server/query.h"
#include "server/turns.h"

namespace coapt {
namespace {

struct Read {
  Expected<Valve> valve;          ///< or why this service does not take it
  std::optional<Answer> refusal;  ///< there is none to judge: no JSON, or too much of it at once
};

Read read_valve_body(const ValveSource& source, const Request& request) {
  const Compute::Turn turn(source.parsing, {reading_seconds(request), request.client});
  if (!turn)
    return {Valve{}, retry_later(503, "too many requests are being read", turn.retry_after_s())};
  const Expected<Json> json = parse_json(request.body, most_values(source.limits));
  if (!json) return {Valve{}, problem(400, json.errors())};
  Expected<Valve> valve = valve_from_json(*json);
  if (valve)
    if (const Errors errors = check_size(*valve, operation_limits(source.limits)); !errors.empty())
      return {errors, std::nullopt};
  return {std::move(valve), std::nullopt};
}

}  // namespace

Answer store_valve(JobStore& store, const ServiceLimits& limits, const Valve& valve,
                   const Json& more) {
  const std::string document = write_valve(valve);
  const std::string id = content_id(document);
  const Expected<bool> is_new = add_valve(store, id, document);
  if (!is_new) return store_problem(is_new.errors());
  static_cast<void>(store.retain(limits.retention, wall_clock_ms()));  // else with the next
  Json stored = {{"id", id},
                 {"vertices", valve.rest_mm.rows()},
                 {"triangles", valve.faces.rows()},
                 {"chordae", valve.chordae.size()}};
  stored.update(more);
  Answer answer = json_answer(*is_new ? 201 : 200, std::move(stored));
  answer.headers.emplace_back("Location", "/v1/valves/" + id);
  return answer;
}

Answer PostValve::operator()(const Request& request) const {
  const auto [valve, refusal] = read_valve_body(valves, request);
  if (refusal) return *refusal;
  if (!valve) return problem(422, valve.errors());
  return store_valve(store, valves.limits, *valve);
}

Answer GetValves::operator()(const Request& request) const {
  ProblemList problems;
  check_query(request, {"page_size", "page_token"}, problems);
  const std::int64_t size = integer_in(request, "page_size", {1.0, 100.0}, 20, problems);
  const std::int64_t before = page_token_in(request, tokens, problems);
  if (!problems.empty()) return problem(422, std::move(problems).take());
  const Expected<ValvePage> page = stored_valves(store, static_cast<int>(size), before);
  if (!page) return store_problem(page.errors());
  Json list = Json::array();
  for (const ValveSummary& valve : page->valves)
    list.push_back({{"valve", valve.id},
                    {"name", valve.name},
                    {"vertices", valve.vertices},
                    {"triangles", valve.triangles}});
  return json_answer(200,
                     {{"valves", std::move(list)},
                      {"next_page_token", next_page_token(request, tokens, page->next_before)}});
}

Answer GetValve::operator()(const Request& request) const {
  const Expected<Valve> valve = named_valve(valves, request.parameters.at(0));
  if (valve) return {200, Content{"application/json", write_valve(*valve)}};
  const bool is_missing = valve.errors().front().code == ErrorCode::BadReference;
  return is_missing ? not_found("valve") : store_problem(valve.errors());
}

Answer DeleteValve::operator()(const Request& request) const {
  const Expected<bool> removed = remove_valve(store, request.parameters.at(0));
  known.remove(request.parameters.at(0));
  if (removed) return *removed ? Answer{204} : not_found("valve");
  const bool is_used = removed.errors().front().code == ErrorCode::BadReference;
  return is_used ? problem(409, removed.errors()) : store_problem(removed.errors());
}

Answer GetPresets::operator()(const Request& /*request*/) const {
  Json presets = Json::array();
  for (const std::string& name : preset_names()) {
    Json preset = preset_words(name);
    preset["valve"] = "/v1/presets/" + name;
    presets.push_back(std::move(preset));
  }
  return json_answer(200, {{"presets", std::move(presets)}});
}

Answer GetRings::operator()(const Request& /*request*/) const {
  return json_answer(200, rings_answer());
}

}  // namespace coapt
