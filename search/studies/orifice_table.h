// Closures of one valve's configurations, each made once, on all threads.
//
// A configuration is known by its numbers rounded to 1e-6 mm (or percent); what is closed is the
// rounded one, so that the answer does not depend on who asked first. Cost of looking up: O(1).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/closure/closure.h"
#include "search/studies/configuration.h"

namespace coapt {

/// The regurgitant orifice of one configuration (thesis 4.2.1).
struct OrificeSample {
  double area_mm2 = 0.0;  ///< mean over the end states; NaN if the configuration cannot be made
  double sd_mm2 = 0.0;    ///< over the end states
  bool trusted = false;   ///< converged, without leaflets through each other
};

/// Dilation, height, displacements (anterolateral, posteromedial) in 1e-6 percent or mm, sizes.
using ConfigurationKey = std::array<std::int64_t, 9>;
ConfigurationKey key_of(const Configuration& configuration);

struct ConfigurationKeyHash {
  std::size_t operator()(const ConfigurationKey& key) const;
};
using KnownOrifices = std::unordered_map<ConfigurationKey, OrificeSample, ConfigurationKeyHash>;

struct OrificeTableOptions {
  ClosureOptions closure;
  int threads = 0;      ///< 0: all cores; does not change any answer
  KnownOrifices known;  ///< of this valve and these closure options, from an earlier run
  /// Told of each closure as it ends, from one thread at a time. What it throws ends at().
  std::function<void(const ConfigurationKey&, const OrificeSample&)> keep;
  /// Done and planned of the present batch, likewise.
  std::function<void(int, int)> progress;
};

/// The thesis's way to close a configuration: five end states (4.2.1), default tolerances.
ClosureOptions thesis_closure();

class OrificeTable {
 public:
  OrificeTable(const Valve& valve, OrificeTableOptions options);

  const Valve& valve() const { return valve_; }
  /// Closes those that are not known. In the order of `configurations`.
  std::vector<OrificeSample> at(std::span<const Configuration> configurations);
  /// Null if it is not known.
  const OrificeSample* find(const Configuration& configuration);

  int closures() const { return closures_; }              ///< made by this table
  int configurations() const { return configurations_; }  ///< asked for: closed now, or known
  int untrusted() const { return untrusted_; }            ///< of those

 private:
  Valve valve_;
  OrificeTableOptions options_;
  struct Entry {
    OrificeSample sample;
    bool asked = false;
  };
  const OrificeSample& ask(Entry& entry);

  std::unordered_map<ConfigurationKey, Entry, ConfigurationKeyHash> known_;
  int closures_ = 0, configurations_ = 0, untrusted_ = 0;
};

}  // namespace coapt
