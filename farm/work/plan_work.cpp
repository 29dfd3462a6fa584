#include "farm/work/plan_work.h"

#include <cmath>
#include <limits>
#include <memory>

#include "farm/work/closure_options_json.h"
#include "farm/work/work_parts.h"
#include "io/json/json_form.h"
#include "io/json/parse_json.h"
#include "io/json/plan_document.h"
#include "io/json/plans_json.h"
#include "io/json/search_options_json.h"
#include "io/json/subject.h"
#include "io/json/valve_json.h"
#include "io/picture/report_material.h"
#include "io/picture/search_csv.h"
#include "search/plans/plan_search.h"

namespace coapt {
namespace {

// How far honest shapes, which may come from a predicted start, are from where a closure takes them further: a fold of theirs may give way by
// 5 mm. To compute a search again because of a shape that is right costs no more than its time.
constexpr double kStaysWithin_mm = 1.0 /* rms */, kLeakWithin_mm2 = 0.5, kLeakWithin = 0.02;
constexpr double kFarthest_mm = 1e4;  // of a shape

struct PlanWork {
  std::vector<Valve> valves;
  SearchOptions options;
  std::shared_ptr<std::atomic<bool>> stop;
};

/// Nothing of it depends on threads or clock.
std::string search_one(const PlanWork& work, std::size_t index, int threads) {
  const Valve& valve = work.valves.at(index);
  SearchOptions options = work.options;
  options.threads = threads;
  options.closure.budget.cancelled = [stop = work.stop] { return stop->load(); };
  SearchContext context;
  context.cancelled = work.stop.get();
  Expected<SearchResult> result = search_plans(valve, options, context);
  if (*work.stop) throw WorkStopped();
  if (!result) throw std::runtime_error(result.errors().front().message);
  result->seconds = std::numeric_limits<double>::quiet_NaN();
  const SearchRequest reproduce{work.options, subject_of(valve, work.options.closure), ""};
  std::string bytes;
  pack_text(bytes, to_json(*result, reproduce).dump());
  pack_text(bytes, write_report_material(report_material(*result, reproduce)));
  pack_text(bytes, tried_plans_csv(valve, *result));
  return bytes;
}

/// A document of plans as this version writes it; members that only some searches have are not in it.
const Json& example_of_plans() {
  static const Json example = [] {
    SearchResult result;
    result.plans.emplace_back();
    return to_json(result, SearchRequest{});
  }();
  return example;
}

/// An answer of unknown origin, as far as its form and names are right.
struct PlansRead {
  Json plans;  ///< coapt.plans/2
  PlanPictures shapes;
};

/// The search that was asked for, on this valve, and whole: what a program does with plans, it can do with these. Errors: one, of which
/// the message counts.
Expected<PlansRead> read_plan_answer(const PlanWork& work, std::size_t index,
                                     const PlanAnswer& answer) {
  const auto objection = [](const std::string& what) {
    return Error{ErrorCode::Unsupported, "", what};
  };
  const Valve& valve = work.valves.at(index);
  Expected<Json> plans = parse_json(answer.plans);
  const Json reproduce = plans && plans->is_object() ? plans->value("reproduce", Json()) : Json();
  if (!reproduce.is_object()) return objection("the answer is no plans");
  if (reproduce.value("valve_hash", Json()) != subject_of(valve, work.options.closure))
    return objection("the plans are of another valve");
  const Expected<Json> search = parse_json(to_json(work.options).dump());  // in the reader's order
  if (reproduce.value("search", Json()) != *search)
    return objection("the plans are of another search");
  if (const std::string where = differs_in_form(example_of_plans(), *plans); !where.empty())
    return objection("the plans have another form at " + where);
  std::vector<RepairPlan> repairs;
  if (!(*plans)["plans"].empty()) {
    const Expected<std::vector<NamedPlan>> named = read_plans(answer.plans);
    if (!named) return objection("the plans cannot be read: " + named.errors().front().message);
    for (const NamedPlan& plan : *named) repairs.push_back(plan.plan);
  }
  Expected<PlanPictures> shapes = closed_shapes(answer.material, valve, repairs);
  if (!shapes) return shapes.errors();
  return PlansRead{*std::move(plans), *std::move(shapes)};
}

/// Null where there is none: a form takes null for anything.
Json member_of(const Json& object, const char* name) {
  return object.is_object() ? object.value(name, Json()) : Json();
}

/// Whether the document states the leak that the shape has, and a closure that starts from it stays there.
bool is_at_rest(const ClosedValve& shape, const ClosureOptions& options, const Json& stated) {
  const double leak_mm2 = shape.measure.leak.area_mm2;
  if (member_of(member_of(stated, "leak"), "area_mm2") !=
      (std::isfinite(leak_mm2) ? Json(leak_mm2) : Json()))
    return false;
  const bool is_trusted = trusted(shape.closure);
  if (is_trusted != (member_of(stated, "status") == to_string(ClosureStatus::Converged) &&
                     member_of(stated, "crossing") == false))
    return false;
  if (!is_trusted) return true;  // it is said not to be believed
  if (!(shape.closure.closed_mm.cwiseAbs().maxCoeff() < kFarthest_mm)) return false;
  const ClosureResult again = close_valve(shape.valve, options, &shape.closure);
  const double again_mm2 = measure(shape.valve, again).leak.area_mm2;
  const double moved_mm =
      std::sqrt((again.closed_mm - shape.closure.closed_mm).rowwise().squaredNorm().mean());
  return trusted(again) && moved_mm <= kStaysWithin_mm &&
         std::abs(again_mm2 - leak_mm2) <= kLeakWithin_mm2 + kLeakWithin * leak_mm2;
}

bool are_at_rest(const PlanWork& work, const PlansRead& read) {
  const ClosureOptions& options = work.options.closure;
  if (!is_at_rest(read.shapes.before, options, member_of(read.plans, "before"))) return false;
  for (std::size_t i = 0; i < read.shapes.after.size(); ++i)
    if (!is_at_rest(read.shapes.after[i], options, read.plans.at("plans").at(i))) return false;
  return true;
}

Errors check_valves(const PlanWork& work) {
  ProblemList problems;
  for (std::size_t i = 0; i < work.valves.size(); ++i)
    for (const Error& error : check_search(work.valves[i], work.options))
      problems.add(error.code, "/search" + error.path,
                   "valve " + std::to_string(i + 1) + ": " + error.message);
  return std::move(problems).take();
}

}  // namespace

Expected<WorkRequest> plan_request(const std::vector<Valve>& valves, const SearchOptions& options) {
  ProblemList problems;
  if (options.seconds > 0.0)
    problems.add(ErrorCode::Unsupported, "/seconds",
                 "a limit of time would let the machine decide the plans; must be 0");
  const Expected<Json> closure = closure_options_json(options.closure);
  if (!closure || *closure != *closure_options_json({}))
    problems.add(ErrorCode::Unsupported, "/closure", "options of the closure must be the default");
  if (!problems.empty()) return std::move(problems).take();
  SearchOptions sent = options;
  sent.threads = 0;
  Json json = {{"search", to_json(sent)}, {"valves", Json::array()}};
  WorkRequest request{"plans", {""}};
  for (const Valve& valve : valves) {
    json["valves"].push_back(request.parts.size());
    request.parts.push_back(write_valve(valve));
  }
  request.parts.front() = json.dump();
  return request;
}

Expected<Work> open_plan_work(const WorkRequest& request) {
  const Expected<Json> json = parse_json(request.parts.front());
  if (!json) return json.errors();
  ProblemList problems;
  Work work;
  const auto plans = std::make_shared<PlanWork>();
  plans->stop = work.stop;
  read_fields({*json, problems}, {{"search", document(plans->options, search_options_from_json)},
                                  {"valves", into(plans->valves, [&](const JsonPlace& place) {
                                     return read_list(place, [&](const JsonPlace& at) {
                                       return read_part(at, request, read_valve);
                                     });
                                   })}});
  if (plans->options.seconds > 0.0)
    problems.add(ErrorCode::Unsupported, "/search/seconds", "must be 0: no clock may decide plans");
  if (!problems.empty()) return std::move(problems).take();
  plans->options.threads = 0;
  if (Errors errors = check_valves(*plans); !errors.empty()) return errors;
  work.items = std::ssize(plans->valves);
  work.task_items = 1;
  work.compute = [plans](std::int64_t first, int count, int threads) {
    std::string bytes;
    for (std::int64_t i = first; i < first + count; ++i)
      bytes += search_one(*plans, static_cast<std::size_t>(i), threads);
    return bytes;
  };
  work.objection = [plans](std::int64_t first, int count, std::string_view bytes) {
    return objection_of(plan_answers(bytes), count, [&](const PlanAnswer& answer, int i) {
      const auto read = read_plan_answer(*plans, static_cast<std::size_t>(first + i), answer);
      return read ? std::string() : read.errors().front().message;
    });
  };
  work.doubt = [plans](std::int64_t first, int count, std::string_view bytes) {
    const Expected<std::vector<PlanAnswer>> answers = plan_answers(bytes);
    for (int i = 0; i < count; ++i) {
      const auto read = read_plan_answer(*plans, static_cast<std::size_t>(first + i),
                                         answers->at(static_cast<std::size_t>(i)));
      if (!read || !are_at_rest(*plans, *read)) return true;
    }
    return false;
  };
  work.sampled_tasks = sampled_searches(work.items);
  return work;
}

Expected<std::vector<PlanAnswer>> plan_answers(std::string_view bytes) {
  std::vector<PlanAnswer> answers;
  while (!bytes.empty()) {
    PlanAnswer& answer = answers.emplace_back();
    for (std::string* part : {&answer.plans, &answer.material, &answer.tried}) {
      std::optional<std::string> text = take_text(bytes);
      if (!text) return Error{ErrorCode::InputOutput, "", "an answer with plans is cut off"};
      *part = *std::move(text);
    }
  }
  return answers;
}

}  // namespace coapt
