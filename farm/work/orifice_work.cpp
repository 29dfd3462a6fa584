#include "farm/work/orifice_work.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "farm/work/closure_options_json.h"
#include "farm/work/work_parts.h"
#include "io/json/parse_json.h"
#include "io/json/subject.h"
#include "io/json/valve_json.h"

namespace coapt {
namespace {

constexpr std::size_t kAnswerBytes = 17;
// 256 closures of 648 triangles by method fast take about 1.2 s on one core; a closure grows with the triangles' number to
// 1.5, and the thesis's method takes some hundred times as long.
constexpr double kItems = 256.0, kTriangles = 648.0, kThesisFactor = 100.0;
// Of a run, so that its workers end together and what whoever asks computes again is a small share; but fewer items hardly share the
// closures that they start from (60 ms an item in tasks of 3, 20 in tasks of 36).
constexpr std::int64_t kTasks = 16, kLeastItems = 64;
constexpr std::int64_t kMostKeyNumber = std::int64_t{1} << 52;  // a double holds it

std::int64_t read_key_number(const JsonPlace& place) {
  const Json& value = place.value;
  const bool fits = value.is_number_unsigned()
                        ? value.get<std::uint64_t>() <= std::uint64_t{kMostKeyNumber}
                        : value.is_number_integer() && value.get<std::int64_t>() >= -kMostKeyNumber;
  if (fits) return value.get<std::int64_t>();
  add_problem(place, ErrorCode::WrongType, "must be an integer below 2^52");
  return 0;
}

ConfigurationKey read_key(const JsonPlace& place) {
  ConfigurationKey key{};
  const std::vector<std::int64_t> numbers = read_list(place, read_key_number);
  if (numbers.size() == key.size()) {
    std::copy(numbers.begin(), numbers.end(), key.begin());
  } else if (place.value.is_array()) {
    add_problem(place, ErrorCode::OutOfRange,
                "has " + std::to_string(numbers.size()) + " numbers, must have 9");
  }
  return key;
}

int items_at_once(const Valve& valve, const ClosureOptions& closure, std::int64_t of_all) {
  const double triangles = static_cast<double>(std::max<Index>(valve.faces.rows(), 1));
  double items = kItems * std::pow(kTriangles / triangles, 1.5);
  if (closure.method == Method::Thesis) items /= kThesisFactor;
  const double share = static_cast<double>(std::max(of_all / kTasks, kLeastItems));
  return static_cast<int>(std::clamp(items, 1.0, std::min(share, kItems)));
}

/// Outlives the work that it is made for: it may know the shared table alone.
OrificeTableOptions options_of_table(const ClosureOptions& closure, SharedTable& shared) {
  OrificeTableOptions options;
  options.closure = closure;
  options.closure.budget.cancelled = [&shared] { return shared.stop->load(); };
  // Of a stopped batch nothing may be kept: its closures may be unfinished.
  options.keep = [&shared](const ConfigurationKey&, const OrificeSample&) {
    if (*shared.stop) throw WorkStopped();
  };
  return options;
}

/// The work's state: which items it has answered, and the table that it computes them with.
class OrificeWorker {
 public:
  OrificeWorker(Valve valve, const ClosureOptions& closure, std::vector<ConfigurationKey> keys,
                std::shared_ptr<SharedTable> shared)
      : valve_(std::move(valve)), keys_(std::move(keys)), shared_(std::move(shared)) {
    options_ = options_of_table(closure, *shared_);
    answered_.resize(keys_.size());
  }

  std::string operator()(std::int64_t first, int count, int threads,
                         const std::atomic<bool>& stop) {
    std::vector<Configuration> configurations;
    bool again = false;
    for (std::int64_t i = first; i < first + count; ++i) {
      configurations.push_back(configuration_of(keys_.at(static_cast<std::size_t>(i))));
      again |= answered_[static_cast<std::size_t>(i)];
    }
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    shared_->stop = &stop;
    std::string bytes;
    if (again) {  // to be computed again, not remembered: it checks the first answer
      OrificeTable table(valve_, options_);
      bytes = answers_of(table, configurations, threads);
    } else {
      // Back in its place when all is well.
      std::unique_ptr<OrificeTable> table = std::move(shared_->table);
      if (table == nullptr) table = std::make_unique<OrificeTable>(valve_, options_);
      bytes = answers_of(*table, configurations, threads);
      shared_->table = std::move(table);
    }
    for (std::int64_t i = first; i < first + count; ++i)
      answered_[static_cast<std::size_t>(i)] = true;
    return bytes;
  }

 private:
  void go_on() const {
    if (*shared_->stop) throw WorkStopped();
  }

  std::string answers_of(OrificeTable& table, const std::vector<Configuration>& configurations,
                         int threads) const {
    table.use_threads(threads);
    std::string bytes;
    for (const OrificeSample& sample : table.at(configurations)) append(bytes, sample);
    go_on();
    return bytes;
  }

  static void append(std::string& bytes, const OrificeSample& sample) {
    for (const double value : {sample.area_mm2, sample.sd_mm2})  // one NaN for all of them
      pack(bytes, std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value);
    bytes += sample.trusted ? '\1' : '\0';
  }

  Valve valve_;
  std::vector<ConfigurationKey> keys_;
  std::shared_ptr<SharedTable> shared_;
  OrificeTableOptions options_;
  std::vector<bool> answered_;
};

}  // namespace

Expected<WorkRequest> orifice_request(const Valve& valve, const ClosureOptions& closure,
                                      const std::vector<ConfigurationKey>& keys) {
  Expected<Json> options = closure_options_json(closure);
  if (!options) return options.errors();
  const Json json = {{"valve", 1}, {"closure", *std::move(options)}, {"keys", keys}};
  return WorkRequest{"orifices", {json.dump(), write_valve(valve)}};
}

Expected<Work> open_orifice_work(const WorkRequest& request, OrificeTables* tables) {
  const Expected<Json> json = parse_json(request.parts.front());
  if (!json) return json.errors();
  ProblemList problems;
  Valve valve;
  ClosureOptions closure;
  std::vector<ConfigurationKey> keys;
  read_fields(
      {*json, problems},
      {{"valve",
        into(valve, [&](const JsonPlace& at) { return read_part(at, request, read_valve); })},
       {"closure", into(closure, read_closure_options)},
       {"keys", into(keys, [](const JsonPlace& at) { return read_list(at, read_key); })}});
  if (!problems.empty()) return std::move(problems).take();
  Work work;
  work.items = std::ssize(keys);
  work.task_items = items_at_once(valve, closure, work.items);
  auto table =
      tables == nullptr ? std::make_shared<SharedTable>() : tables->of(subject_of(valve, closure));
  const auto worker =
      std::make_shared<OrificeWorker>(std::move(valve), closure, std::move(keys), std::move(table));
  work.compute = [worker, stop = work.stop](std::int64_t first, int count, int threads) {
    return (*worker)(first, count, threads, *stop);
  };
  work.objection = [](std::int64_t /*first*/, int count, std::string_view bytes) {
    return objection_of(orifice_answers(bytes, static_cast<std::size_t>(count)), count);
  };
  return work;
}

Expected<std::vector<OrificeSample>> orifice_answers(std::string_view bytes, std::size_t count) {
  if (bytes.size() != kAnswerBytes * count)
    return Error{ErrorCode::Unsupported, "",
                 std::to_string(bytes.size()) + " bytes are no answers to " +
                     std::to_string(count) + " configurations"};
  std::vector<OrificeSample> samples;
  for (std::size_t at = 0; at < bytes.size(); at += kAnswerBytes)
    samples.push_back({std::bit_cast<double>(unpacked(bytes, at)),
                       std::bit_cast<double>(unpacked(bytes, at + 8)), bytes[at + 16] != '\0'});
  return samples;
}

}  // namespace coapt
