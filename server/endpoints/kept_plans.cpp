#include "server/endpoints/kept_plans.h"

#include <algorithm>

#include "core/repair/apply_plan.h"
#include "io/json/plan_json.h"
#include "io/store/kept_plans.h"
#include "server/answers.h"
#include "server/content_id.h"
#include "server/query.h"

namespace coapt {
namespace {

constexpr std::size_t kLongestName = 200;  // bytes
constexpr const char* kKind = "kept plan";

std::string read_name_of_plan(const JsonPlace& place) {
  std::string name = read_string(place);
  const auto is_control = [](unsigned char c) { return c < ' ' || c == 127; };
  if (place.value.is_string() &&
      (name.empty() || name.size() > kLongestName || std::ranges::any_of(name, is_control)))
    add_problem(place, ErrorCode::OutOfRange,
                "must be a line of 1 to " + std::to_string(kLongestName) + " bytes of UTF-8");
  return name;
}

Json to_json(const KeptPlan& kept) {
  return {{"kept_plan", kept.id},
          {"name", kept.name},
          {"valve", kept.valve},
          {"plan", Json::parse(kept.plan)}};
}

Answer kept_answer(const Expected<std::optional<KeptPlan>>& kept) {
  if (!kept) return store_problem(kept.errors());
  return *kept ? json_answer(200, to_json(**kept)) : not_found(kKind);
}

/// What is said against doing the plan on the valve of that name.
Errors check(const ValveSource& valves, const std::string& valve, const RepairPlan& plan) {
  const Expected<Valve> named = named_valve(valves, valve);
  ProblemList problems;
  if (!named) {
    add_below(problems, "/valve", named.errors());
  } else if (const Expected<Valve> repaired = apply_plan(*named, plan); !repaired) {
    add_below(problems, "/plan", repaired.errors());
  }
  return std::move(problems).take();
}

}  // namespace

Answer PostKeptPlan::operator()(const Request& request) const {
  KeptPlan kept = {random_id(), "", "", ""};
  RepairPlan plan;
  if (auto refused = read_body(valves, request,
                               {{"name", into(kept.name, read_name_of_plan)},
                                {"valve", into(kept.valve, read_string)},
                                {"plan", document(plan, plan_from_json)}}))
    return *std::move(refused);
  if (const Errors errors = check(valves, kept.valve, plan); !errors.empty())
    return problem(422, errors);
  kept.plan = to_json(plan).dump();
  const int most = valves.limits.kept_plans;
  const Expected<bool> is_kept = keep_plan(store, kept, most);
  if (!is_kept) return store_problem(is_kept.errors());
  if (!*is_kept)
    return problem(
        409, ErrorCode::OutOfRange,
        "this service keeps at most " + std::to_string(most) + " plans; remove some first");
  Answer answer = json_answer(201, to_json(kept));
  answer.headers.emplace_back("Location", "/v1/kept-plans/" + kept.id);
  return answer;
}

Answer GetKeptPlans::operator()(const Request& request) const {
  ProblemList problems;
  check_query(request, {"valve", "page_size", "page_token"}, problems);
  const std::int64_t size = integer_in(request, "page_size", {1.0, 100.0}, 20, problems);
  const std::int64_t before = page_token_in(request, tokens, problems);
  if (!problems.empty()) return problem(422, std::move(problems).take());
  const auto valve = request.query.find("valve");
  const Expected<KeptPlanPage> page = kept_plans(store, static_cast<int>(size), before,
                                                 valve == request.query.end() ? "" : valve->second);
  if (!page) return store_problem(page.errors());
  Json list = Json::array();
  for (const KeptPlan& kept : page->plans) list.push_back(to_json(kept));
  return json_answer(200,
                     {{"kept_plans", std::move(list)},
                      {"next_page_token", next_page_token(request, tokens, page->next_before)}});
}

Answer GetKeptPlan::operator()(const Request& request) const {
  return kept_answer(kept_plan(store, request.parameters.at(0)));
}

Answer RenameKeptPlan::operator()(const Request& request) const {
  std::string name;
  if (auto refused = read_body(valves, request, {{"name", into(name, read_name_of_plan)}}))
    return *std::move(refused);
  const std::string& id = request.parameters.at(0);
  const Expected<bool> renamed = rename_kept_plan(store, id, name);
  if (!renamed) return store_problem(renamed.errors());
  return *renamed ? kept_answer(kept_plan(store, id)) : not_found(kKind);
}

Answer DeleteKeptPlan::operator()(const Request& request) const {
  const Expected<bool> removed = remove_kept_plan(store, request.parameters.at(0));
  if (!removed) return store_problem(removed.errors());
  return *removed ? Answer{204} : not_found(kKind);
}

}  // namespace coapt
