#include "io/json/plan_document.h"

#include <string>

#include "io/json/json_reader.h"
#include "io/json/parse_json.h"
#include "io/json/plan_json.h"

namespace coapt {
namespace {

/// {"name", "plan", ...}, or the plan itself.
NamedPlan read_entry(const JsonPlace& place, std::string name) {
  if (place.value.is_object() && place.value.contains("steps") && !place.value.contains("plan"))
    return {std::move(name), read_plan_within(place)};
  const auto plan = read_member(place, "plan");
  if (!plan) return {};
  const auto own = place.value.find("name");
  if (own != place.value.end() && own->is_string()) name = own->get<std::string>();
  return {std::move(name), read_plan_within(*plan)};
}

std::vector<NamedPlan> read_entries(const JsonPlace& list) {
  std::vector<NamedPlan> plans;
  read_array(list, [&](const JsonPlace& entry) {
    plans.push_back(read_entry(entry, "plan " + std::to_string(plans.size() + 1)));
  });
  if (list.value.is_array() && plans.empty())
    add_problem(list, ErrorCode::OutOfRange, "has no plan; at least one is needed");
  return plans;
}

}  // namespace

Expected<std::vector<NamedPlan>> read_plans(std::string_view text) {
  const auto json = parse_json(text);
  if (!json) return json.errors();
  ProblemList problems;
  const JsonPlace document{*json, problems};
  std::vector<NamedPlan> plans;
  const auto has = [&](const char* name) { return json->is_object() && json->contains(name); };
  if (has("plans")) {
    plans = read_entries(*read_member(document, "plans"));
  } else if (has("kept_plans")) {
    plans = read_entries(*read_member(document, "kept_plans"));
  } else if (has("plan")) {
    plans.push_back(read_entry(document, "plan 1"));
  } else {
    const Expected<RepairPlan> plan = plan_from_json(*json);
    if (!plan) return plan.errors();
    plans.push_back({"", *plan});
  }
  if (!problems.empty()) return std::move(problems).take();
  return plans;
}

}  // namespace coapt
