#include "farm/work/import_work.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/closed/closed_valve.h"
#include "core/closure/standing.h"
#include "farm/work/work_parts.h"
#include "io/exchange/decisions_json.h"
#include "io/json/parse_json.h"
#include "io/json/valve_json.h"
#include "io/mesh/text_scan.h"
#include "search/parallel.h"
#include "search/plans/plan_search.h"

namespace coapt {
namespace {

constexpr int kImportsAtOnce = 8;
constexpr int kMostEvaluations = 100'000;

struct ImportWork {
  std::vector<ImportRequest> asked;
  int evaluations = 0;
  std::shared_ptr<std::atomic<bool>> stop;
};

/// Of the file that it is of, if there are several.
std::string reason_of(const Error& error, const ImportRequest& asked) {
  const std::string files = "/files/";
  if (!error.path.starts_with(files) || !asked.files)
    return error.path == "/files" || error.path == "/slicerheart" || error.path.empty()
               ? error.message
               : error.path.substr(1) + ": " + error.message;
  const std::size_t slash = error.path.find('/', files.size());
  const std::optional<long long> index =
      to_integer(error.path.substr(files.size(), slash - files.size()));
  std::string reason;
  if (asked.files->size() > 1 && index && *index < std::ssize(*asked.files))
    reason = (*asked.files)[static_cast<std::size_t>(*index)].name + ": ";
  if (slash != std::string::npos) reason += error.path.substr(slash + 1) + ": ";
  return reason + error.message;
}

Json refused(const Error& error, const ImportRequest& asked) {
  return {{"stage", "refused"}, {"reason", reason_of(error, asked)}, {"looks", Json::array()}};
}

/// The plan of a valve that closes, in its row.
void add_plan(const Valve& valve, const ImportWork& work, int threads, Json& row) {
  SearchOptions options;
  options.evaluations = work.evaluations;
  options.plans = 1;
  options.evidence = false;
  options.model_draws = 0;
  options.region_points = 17;
  options.threads = threads;
  const Expected<SearchResult> found = search_plans(valve, options, {.cancelled = work.stop.get()});
  if (*work.stop) throw WorkStopped();
  if (!found || found->plans.empty()) {
    row["reason"] = found ? "no plan was found" : found.errors()[0].message;
    return;
  }
  row["stage"] = "planned";
  row["plan_leak_mm2"] = found->plans[0].measure.leak.area_mm2;
}

ImportOutcome tried(const ImportRequest& asked, const ImportWork& work, int threads) {
  ClosureBudget budget;
  budget.cancelled = [stop = work.stop] { return stop->load(); };
  const Expected<ImportedValve> made = make_import(asked, budget);
  if (*work.stop) throw WorkStopped();
  if (!made) return {refused(made.errors()[0], asked), ""};
  ImportOutcome outcome{{{"stage", "imported"}, {"reason", ""}, {"looks", Json::array()}},
                        write_valve(made->valve)};
  for (const ImportDecision& decision : made->decisions)
    if (decision.look) outcome.row["looks"].push_back(sentence(decision));
  const ClosedValve closed = close_and_measure(made->valve);
  if (!trusted(closed.closure)) {
    outcome.row["reason"] = doubt_about(closed.closure);
    return outcome;
  }
  outcome.row["stage"] = "closed";
  outcome.row["leak_mm2"] = closed.measure.leak.area_mm2;
  if (work.evaluations > 0 && is_mitral(made->valve))
    add_plan(made->valve, work, threads, outcome.row);
  return outcome;
}

std::string pack_outcomes(const std::vector<ImportOutcome>& outcomes) {
  std::string bytes;
  for (const ImportOutcome& one : outcomes) {
    pack_text(bytes, json_text(one.row));
    pack_text(bytes, one.valve);
  }
  return bytes;
}

NamedFile read_file_of(const JsonPlace& place, const WorkRequest& request) {
  NamedFile file;
  const std::string* bytes = nullptr;
  read_fields(
      place, {{"name", into(file.name, read_string)},
              {"part", into(bytes, [&](const JsonPlace& at) { return named_part(at, request); })}});
  if (bytes != nullptr) file.bytes = *bytes;
  return file;
}

ImportCase read_case(const JsonPlace& place, const WorkRequest& request) {
  ImportCase one;
  read_fields(place, {{"name", into(one.name, read_string)},
                      {"slicerheart", into(one.slicerheart, read_boolean)},
                      {"files", into(one.files, [&](const JsonPlace& files) {
                         return read_list(files, [&](const JsonPlace& file) {
                           return read_file_of(file, request);
                         });
                       })}});
  return one;
}

/// Whether a study can count and show it.
bool is_row(const Json& row) {
  const auto text = [&](const char* name) { return row.contains(name) && row[name].is_string(); };
  const auto number = [&](const char* name) {
    return !row.contains(name) || row[name].is_number();
  };
  return row.is_object() && text("stage") && text("reason") && number("leak_mm2") &&
         number("plan_leak_mm2") &&
         std::find(std::begin(kImportStages), std::end(kImportStages),
                   row["stage"].get<std::string>()) != std::end(kImportStages) &&
         row.contains("looks") && row["looks"].is_array() &&
         std::all_of(row["looks"].begin(), row["looks"].end(),
                     [](const Json& look) { return look.is_string(); });
}

std::string objection_to(const ImportOutcome& outcome) {
  if (!is_row(outcome.row)) return "a row is none of an import";
  if ((outcome.row["stage"] == "refused") != outcome.valve.empty())
    return "a valve is there without an import, or the other way round";
  if (outcome.valve.empty()) return "";
  const Expected<Valve> valve = read_any_valve(outcome.valve);
  return valve ? "" : "a valve cannot be read: " + valve.errors().front().message;
}

}  // namespace

ImportRequest as_request(ImportCase one, int seed) {
  ImportRequest request;
  request.name = std::move(one.name);
  (one.slicerheart ? request.slicerheart : request.files) = std::move(one.files);
  request.reading.most_unpacked = kMostUnpacked;
  request.seed = seed;
  return request;
}

WorkRequest imports_request(const std::vector<ImportCase>& cases, const ImportTrial& trial) {
  Json json = {
      {"imports", Json::array()}, {"seed", trial.seed}, {"evaluations", trial.evaluations}};
  WorkRequest request{"imports", {""}};
  for (const ImportCase& one : cases) {
    Json files = Json::array();
    for (const NamedFile& file : one.files) {
      files.push_back({{"name", file.name}, {"part", request.parts.size()}});
      request.parts.push_back(file.bytes);
    }
    json["imports"].push_back(
        {{"name", one.name}, {"slicerheart", one.slicerheart}, {"files", std::move(files)}});
  }
  request.parts.front() = json_text(json);
  return request;
}

Expected<Work> open_import_work(const WorkRequest& request) {
  const Expected<Json> json = parse_json(request.parts.front());
  if (!json) return json.errors();
  ProblemList problems;
  Work work;
  const auto imports = std::make_shared<ImportWork>();
  imports->stop = work.stop;
  int seed = 1;
  std::vector<ImportCase> cases;
  read_fields({*json, problems},
              {{"imports", into(cases,
                                [&](const JsonPlace& place) {
                                  return read_list(place, [&](const JsonPlace& at) {
                                    return read_case(at, request);
                                  });
                                })},
               {"seed", into(seed, integer_in(0, 2147483647))},
               {"evaluations", into(imports->evaluations, integer_in(0, kMostEvaluations))}});
  if (!problems.empty()) return std::move(problems).take();
  for (ImportCase& one : cases) imports->asked.push_back(as_request(std::move(one), seed));
  const bool plans = imports->evaluations > 0;
  work.items = std::ssize(imports->asked);
  work.task_items = plans ? 1 : kImportsAtOnce;
  work.compute = [imports, plans](std::int64_t first, int count, int threads) {
    std::vector<ImportOutcome> outcomes(static_cast<std::size_t>(count));
    for_each_index(count, plans ? 1 : threads, [&](int i) {
      if (*imports->stop) throw WorkStopped();
      outcomes[static_cast<std::size_t>(i)] = tried(
          imports->asked.at(static_cast<std::size_t>(first + i)), *imports, plans ? threads : 1);
    });
    return pack_outcomes(outcomes);
  };
  work.objection = [](std::int64_t /*first*/, int count, std::string_view bytes) {
    return objection_of(import_outcomes(bytes), count,
                        [](const ImportOutcome& outcome, int) { return objection_to(outcome); });
  };
  if (plans) work.sampled_tasks = sampled_searches(work.items);
  return work;
}

Expected<std::vector<ImportOutcome>> import_outcomes(std::string_view bytes) {
  std::vector<ImportOutcome> outcomes;
  while (!bytes.empty()) {
    const std::optional<std::string> row = take_text(bytes);
    std::optional<std::string> valve = take_text(bytes);
    if (!row || !valve)
      return Error{ErrorCode::InputOutput, "", "an answer with imports is cut off"};
    Expected<Json> read = parse_json(*row);
    if (!read) return read.errors();
    outcomes.push_back({*std::move(read), *std::move(valve)});
  }
  return outcomes;
}

}  // namespace coapt
