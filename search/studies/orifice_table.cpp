#include "search/studies/orifice_table.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "core/closure/predicted_start.h"
#include "core/metrics/orifice.h"
#include "search/evaluator.h"
#include "search/parallel.h"
#include "search/studies/configuration_frame.h"

namespace coapt {
namespace {

constexpr int kStartSample = 24;
constexpr double kRounding = 1e-6;  // mm or percent

std::int64_t rounded(double value) { return std::llround(value / kRounding); }
double number(std::int64_t key) { return kRounding * static_cast<double>(key); }

OrificeSample sample_of(const Valve& closed_valve, const ClosureResult& closure) {
  OrificeSample sample;
  double sum = 0.0, squares = 0.0;
  for (const Points& end : closure.samples_mm) {
    const double area = orifice_mm2(closed_valve, end);
    sum += area;
    squares += area * area;
  }
  const double n = static_cast<double>(closure.samples_mm.size());
  sample.area_mm2 = sum / n;
  sample.sd_mm2 = std::sqrt(std::max(0.0, squares / n - sample.area_mm2 * sample.area_mm2));
  sample.trusted = trusted(closure) && std::isfinite(sample.area_mm2);
  return sample;
}

}  // namespace

ConfigurationKey key_of(const Configuration& c) {
  const Vec3& al = c.change.anterolateral_mm;
  const Vec3& pm = c.change.posteromedial_mm;
  return {rounded(c.change.ap_dilation_percent),
          rounded(c.change.annular_height_percent),
          rounded(al.x()),
          rounded(al.y()),
          rounded(al.z()),
          rounded(pm.x()),
          rounded(pm.y()),
          rounded(pm.z()),
          c.ring_sizes_below};
}

Configuration configuration_of(const ConfigurationKey& key) {
  Configuration c;
  c.change.ap_dilation_percent = number(key[0]);
  c.change.annular_height_percent = number(key[1]);
  c.change.anterolateral_mm = Vec3(number(key[2]), number(key[3]), number(key[4]));
  c.change.posteromedial_mm = Vec3(number(key[5]), number(key[6]), number(key[7]));
  c.ring_sizes_below = static_cast<int>(key[8]);
  return c;
}

std::size_t ConfigurationKeyHash::operator()(const ConfigurationKey& key) const {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a, a number at a time, with a final mix
  for (const std::int64_t k : key) hash = (hash ^ static_cast<std::uint64_t>(k)) * 0x100000001b3;
  return static_cast<std::size_t>(hash ^ (hash >> 32));
}

OrificeTable::OrificeTable(const Valve& valve, OrificeTableOptions options)
    : valve_(valve), options_(std::move(options)) {
  for (const auto& [key, sample] : options_.known) known_[key] = {sample, true};
  options_.known.clear();
}

OrificeTable::Closed OrificeTable::close_one(const ConfigurationKey& key, Start start) const {
  Closed closed;
  closed.sample.area_mm2 = std::numeric_limits<double>::quiet_NaN();
  const Configuration configuration = configuration_of(key);
  const Expected<Valve> changed = configure(valve_, configuration);
  if (!changed) return closed;
  std::optional<ClosureResult> neighbour;
  if (start == Start::Predicted) {
    std::vector<ClosureShare> shares;
    for (const ConfigurationShare& part : predicted_from(configuration))
      shares.push_back({frame_.at(key_of(part.configuration)).get(), part.share});
    neighbour = predicted_start(changed->faces, shares);
  }
  const auto prepared = prepared_->of(*changed, options_.closure);
  closed.closure = std::make_shared<const ClosureResult>(
      close_valve(*prepared, *changed, options_.closure, neighbour ? &*neighbour : nullptr));
  if (closed.closure->status != ClosureStatus::Diverged)
    closed.sample = sample_of(*changed, *closed.closure);
  return closed;
}

std::vector<ConfigurationKey> OrificeTable::frame_of(const ConfigurationKey& key) const {
  std::vector<ConfigurationKey> frame;
  if (options_.closure.method != Method::Fast) return frame;
  for (const ConfigurationShare& part : predicted_from(configuration_of(key)))
    frame.push_back(key_of(part.configuration));
  return frame;
}

std::vector<OrificeSample> OrificeTable::at(std::span<const Configuration> configurations) {
  std::vector<ConfigurationKey> keys, around, within;
  std::unordered_set<ConfigurationKey, ConfigurationKeyHash> asked, needed;
  for (const Configuration& configuration : configurations) {
    const ConfigurationKey& key = keys.emplace_back(key_of(configuration));
    if (known_.contains(key) || !asked.insert(key).second) continue;
    const std::vector<ConfigurationKey> frame = frame_of(key);
    if (!frame.empty()) within.push_back(key);
    for (const ConfigurationKey& part : frame.empty() ? std::vector{key} : frame)
      if (!frame_.contains(part) && needed.insert(part).second) around.push_back(part);
  }
  if (options_.close_elsewhere) {
    close_elsewhere({asked.begin(), asked.end()});
  } else {
    const int planned = static_cast<int>(around.size() + within.size());
    close(around, Start::Open, {0, planned});
    close(within, Start::Predicted, {static_cast<int>(around.size()), planned});
  }
  std::vector<OrificeSample> samples;
  for (const ConfigurationKey& key : keys) samples.push_back(ask(known_.at(key)));
  return samples;
}

void OrificeTable::close(const std::vector<ConfigurationKey>& keys, Start start, Share of_batch) {
  std::vector<Closed> closed(keys.size());
  std::mutex mutex;
  // A closure that cannot be kept ends the batch, by its exception.
  std::atomic<bool> failed = false;
  for_each_index(static_cast<int>(keys.size()), options_.threads, [&](int i) {
    if (failed) return;
    closed[i] = close_one(keys[i], start);
    const std::lock_guard<std::mutex> lock(mutex);
    try {
      if (options_.keep && !known_.contains(keys[i])) options_.keep(keys[i], closed[i].sample);
    } catch (...) {
      failed = true;
      throw;
    }
    if (options_.progress) options_.progress(++of_batch.done, of_batch.planned);
  });
  for (std::size_t i = 0; i < keys.size(); ++i) {
    known_.try_emplace(keys[i], Entry{closed[i].sample});
    if (start == Start::Open) frame_[keys[i]] = std::move(closed[i].closure);
  }
  closures_ += static_cast<int>(keys.size());
}

void OrificeTable::close_elsewhere(std::vector<ConfigurationKey> keys) {
  if (keys.empty()) return;
  // The same batch in any order of asking; and neighbours start from the same closures.
  std::sort(keys.begin(), keys.end());
  const std::vector<OrificeSample> samples = options_.close_elsewhere(
      keys, options_.progress ? options_.progress : [](int, int) {});
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (options_.keep) options_.keep(keys[i], samples.at(i));
    known_.try_emplace(keys[i], Entry{samples.at(i)});
  }
  closures_ += static_cast<int>(keys.size());
}

StartCheck OrificeTable::check_starts() {
  std::vector<ConfigurationKey> predicted;
  for (const auto& [key, entry] : known_)
    if (entry.asked && !frame_of(key).empty()) predicted.push_back(key);
  std::sort(predicted.begin(), predicted.end());
  const int count = std::min<int>(kStartSample, static_cast<int>(predicted.size()));
  std::vector<Configuration> sample;
  for (int i = 0; i < count; ++i)
    sample.push_back(configuration_of(predicted[(i + 1) * predicted.size() / count - 1]));
  std::vector<ConfigurationKey> around;
  for (const Configuration& configuration : sample)
    for (const ConfigurationKey& part : frame_of(key_of(configuration)))
      if (frame_.try_emplace(part).second) around.push_back(part);
  std::vector<Closure> closed(around.size());
  for_each_index(static_cast<int>(around.size()), options_.threads,
                 [&](int i) { closed[i] = close_one(around[i], Start::Open).closure; });
  for (std::size_t i = 0; i < around.size(); ++i) frame_[around[i]] = std::move(closed[i]);
  std::vector<StartCheck> checks(sample.size());
  for_each_index(count, options_.threads, [&](int i) {
    const ConfigurationKey key = key_of(sample[i]);
    const Closed a = close_one(key, Start::Predicted), b = close_one(key, Start::Open);
    if (a.sample.trusted && b.sample.trusted)
      checks[i] = compare_ends(*a.closure, *b.closure, a.sample.area_mm2 - b.sample.area_mm2);
  });
  return united(checks);
}

const OrificeSample* OrificeTable::find(const Configuration& configuration) {
  const auto found = known_.find(key_of(configuration));
  return found == known_.end() ? nullptr : &ask(found->second);
}

const OrificeSample& OrificeTable::ask(Entry& entry) {
  if (!entry.asked) {
    entry.asked = true;
    ++configurations_;
    known_before_ += entry.before;
    if (!entry.sample.trusted) ++untrusted_;
  }
  return entry.sample;
}

}  // namespace coapt
