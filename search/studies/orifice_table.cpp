#include "search/studies/orifice_table.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <unordered_set>
#include <utility>

#include "core/metrics/exact_orifice.h"
#include "search/evaluator.h"
#include "search/parallel.h"

namespace coapt {
namespace {

constexpr double kRounding = 1e-6;  // mm or percent

std::int64_t rounded(double value) { return std::llround(value / kRounding); }
double number(std::int64_t key) { return kRounding * static_cast<double>(key); }

Configuration configuration_of(const ConfigurationKey& key) {
  Configuration c;
  c.change.ap_dilation_percent = number(key[0]);
  c.change.annular_height_percent = number(key[1]);
  c.change.anterolateral_mm = Vec3(number(key[2]), number(key[3]), number(key[4]));
  c.change.posteromedial_mm = Vec3(number(key[5]), number(key[6]), number(key[7]));
  c.ring_sizes_below = static_cast<int>(key[8]);
  return c;
}

OrificeSample close_one(const Valve& valve, const Configuration& configuration,
                        const ClosureOptions& options) {
  OrificeSample sample;
  sample.area_mm2 = std::numeric_limits<double>::quiet_NaN();
  const Expected<Valve> changed = configure(valve, configuration);
  if (!changed) return sample;
  const ClosureResult closure = close_valve(*changed, options);
  if (closure.status == ClosureStatus::Diverged) return sample;
  double sum = 0.0, squares = 0.0;
  for (const Points& end : closure.samples_mm) {
    const double area = exact_orifice(*changed, end, 0.5 * changed->tissue.thickness_mm).area_mm2;
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

std::size_t ConfigurationKeyHash::operator()(const ConfigurationKey& key) const {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a, a number at a time, with a final mix
  for (const std::int64_t k : key) hash = (hash ^ static_cast<std::uint64_t>(k)) * 0x100000001b3;
  return static_cast<std::size_t>(hash ^ (hash >> 32));
}

ClosureOptions thesis_closure() {
  ClosureOptions options;
  options.samples = kThesisSamples;
  return options;
}

OrificeTable::OrificeTable(const Valve& valve, OrificeTableOptions options)
    : valve_(valve), options_(std::move(options)) {
  for (const auto& [key, sample] : options_.known) known_[key].sample = sample;
  options_.known.clear();
}

std::vector<OrificeSample> OrificeTable::at(std::span<const Configuration> configurations) {
  std::vector<ConfigurationKey> keys, missing;
  std::unordered_set<ConfigurationKey, ConfigurationKeyHash> asked;
  for (const Configuration& configuration : configurations) {
    keys.push_back(key_of(configuration));
    if (!known_.contains(keys.back()) && asked.insert(keys.back()).second)
      missing.push_back(keys.back());
  }
  const int count = static_cast<int>(missing.size());
  std::vector<OrificeSample> closed(missing.size());
  std::mutex mutex;
  int done = 0;
  // A closure that cannot be kept ends the batch, by its exception.
  std::atomic<bool> failed = false;
  for_each_index(count, options_.threads, [&](int i) {
    if (failed) return;
    closed[i] = close_one(valve_, configuration_of(missing[i]), options_.closure);
    const std::lock_guard<std::mutex> lock(mutex);
    try {
      if (options_.keep) options_.keep(missing[i], closed[i]);
    } catch (...) {
      failed = true;
      throw;
    }
    if (options_.progress) options_.progress(++done, count);
  });
  for (std::size_t i = 0; i < missing.size(); ++i) known_[missing[i]].sample = closed[i];
  closures_ += count;
  std::vector<OrificeSample> samples;
  for (const ConfigurationKey& key : keys) samples.push_back(ask(known_.at(key)));
  return samples;
}

const OrificeSample* OrificeTable::find(const Configuration& configuration) {
  const auto found = known_.find(key_of(configuration));
  return found == known_.end() ? nullptr : &ask(found->second);
}

const OrificeSample& OrificeTable::ask(Entry& entry) {
  if (!entry.asked) {
    entry.asked = true;
    ++configurations_;
    if (!entry.sample.trusted) ++untrusted_;
  }
  return entry.sample;
}

}  // namespace coapt
