#include "farm/work/population_work.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "farm/work/closure_options_json.h"
#include "farm/work/work_parts.h"
#include "io/json/parse_json.h"
#include "io/json/population_json.h"
#include "io/json/population_prior_json.h"
#include "search/parallel.h"
#include "search/plans/disturbance.h"

namespace coapt {
namespace {

// Of one member: some ten closures to draw it, up to 170 to try repairs.
constexpr int kMembersAtOnce = 16, kRecordsAtOnce = 2;
constexpr int kMostItems = 100'000;

int read_count(const JsonPlace& place) { return read_integer_in(place, 1, kMostItems); }

bool is_of(const CandidateRecord& candidate, int nodes) {
  const bool known = candidate.state >= static_cast<int>(CandidateState::NotOffered) &&
                     candidate.state <= static_cast<int>(CandidateState::Closed);
  const std::array figures = {candidate.cost, candidate.planned_mm2, candidate.mean_mm2,
                              candidate.sd_mm2};
  return known && candidate.failures >= 0 && candidate.failures <= nodes &&
         std::none_of(figures.begin(), figures.end(), [](float x) { return std::isinf(x); });
}

/// Whether studies can count with it: they index by its numbers and sort by its features.
bool is_of(const PopulationRecord& record, const PopulationMember& member, int nodes) {
  return record.index == member.index && record.aetiology == static_cast<int>(member.aetiology) &&
         (record.made == 0 || record.made == 1) && std::isfinite(record.leak_mm2) &&
         std::all_of(record.features.begin(), record.features.end(),
                     [](float x) { return std::isfinite(x); }) &&
         std::all_of(record.candidates.begin(), record.candidates.end(),
                     [nodes](const CandidateRecord& one) { return is_of(one, nodes); });
}

}  // namespace

WorkRequest members_request(const PopulationPrior& prior, std::uint64_t seed, int members) {
  const Json json = {{"prior", 1}, {"seed", seed}, {"members", members}};
  return {"members", {json.dump(), to_json(prior).dump()}};
}

Expected<Work> open_members_work(const WorkRequest& request) {
  const Expected<Json> json = parse_json(request.parts.front());
  if (!json) return json.errors();
  ProblemList problems;
  PopulationPrior prior;
  std::uint64_t seed = 0;
  int members = 0;
  read_fields(
      {*json, problems},
      {{"prior",
        into(prior, [&](const JsonPlace& at) { return read_part(at, request, read_prior); })},
       {"seed", into(seed, read_unsigned)},
       {"members", into(members, read_count)}});
  if (!problems.empty()) return std::move(problems).take();
  Work work;
  work.items = members;
  work.task_items = kMembersAtOnce;
  work.compute = [prior = std::move(prior), seed, stop = work.stop](std::int64_t first, int count,
                                                                    int threads) {
    std::vector<std::string> made(static_cast<std::size_t>(count));
    for_each_index(count, threads, [&](int i) {
      if (*stop) throw WorkStopped();
      const Expected<PopulationMember> one = member(prior, seed, static_cast<int>(first) + i);
      if (!one) throw std::runtime_error(one.errors().front().message);
      made[static_cast<std::size_t>(i)] = to_json(*one).dump();
    });
    std::string bytes;
    for (const std::string& text : made) pack_text(bytes, text);
    return bytes;
  };
  work.objection = [](std::int64_t first, int count, std::string_view bytes) {
    return objection_of(member_answers(bytes), count, [&](const PopulationMember& one, int i) {
      return one.index == first + i ? "" : "a member has another number";
    });
  };
  return work;
}

Expected<std::vector<PopulationMember>> member_answers(std::string_view bytes) {
  std::vector<PopulationMember> members;
  while (!bytes.empty()) {
    const std::optional<std::string> text = take_text(bytes);
    if (!text) return Error{ErrorCode::InputOutput, "", "an answer with a member is cut off"};
    const Expected<Json> json = parse_json(*text);
    if (!json) return json.errors();
    const Expected<PopulationMember> one = member_from_json(*json);
    if (!one) return one.errors();
    members.push_back(*one);
  }
  return members;
}

Expected<WorkRequest> records_request(const Population& population, int members,
                                      const PopulationRecordOptions& options) {
  const Expected<Json> closure = closure_options_json(options.closure);
  if (!closure || *closure != *closure_options_json({}))
    return Error{ErrorCode::Unsupported, "/closure", "options of the closure must be the default"};
  const Json json = {{"population", 1}, {"members", members}, {"nodes", options.nodes}};
  return WorkRequest{"records", {json.dump(), to_json(population).dump()}};
}

Expected<Work> open_records_work(const WorkRequest& request) {
  const Expected<Json> json = parse_json(request.parts.front());
  if (!json) return json.errors();
  ProblemList problems;
  const auto population = std::make_shared<Population>();
  PopulationRecordOptions options;
  int members = 0;
  read_fields({*json, problems},
              {{"population",
                into(*population,
                     [&](const JsonPlace& at) { return read_part(at, request, read_population); })},
               {"members", into(members, read_count)},
               {"nodes", into(options.nodes, [](const JsonPlace& at) {
                  return read_integer_in(at, 1, kRegion.count);
                })}});
  if (problems.empty() && members > std::ssize(population->members))
    problems.add(ErrorCode::OutOfRange, "/members", "is more than the population has");
  if (!problems.empty()) return std::move(problems).take();
  Work work;
  work.items = members;
  work.task_items = kRecordsAtOnce;
  work.compute = [population, options, stop = work.stop](std::int64_t first, int count,
                                                         int threads) {
    PopulationRecordOptions here = options;
    here.threads = threads;
    here.cancelled = stop.get();
    std::string bytes = population_records(*population, here, static_cast<int>(first), count);
    if (*stop) throw WorkStopped();
    return bytes;
  };
  work.objection = [population, nodes = options.nodes](std::int64_t first, int count,
                                                       std::string_view bytes) {
    return objection_of(unpack_records(bytes), count, [&](const PopulationRecord& record, int i) {
      return is_of(record, population->members[static_cast<std::size_t>(first + i)], nodes)
                 ? ""
                 : "a record is of another member, or holds what no record can";
    });
  };
  return work;
}

}  // namespace coapt
