// Closures of one valve's configurations, each made once, on all threads.
//
// A configuration is known by its numbers rounded to 1e-6 mm (or percent); what is closed is the
// rounded one, so that the answer does not depend on who asked first. Cost of looking up: O(1).
// Method fast: a configuration starts from what closures around it let expect
// (configuration_frame.h), which are closed where nobody has asked for them, too.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/closure/closure.h"
#include "search/prepared_valves.h"
#include "search/start_comparison.h"
#include "search/studies/configuration.h"

namespace coapt {

/// The regurgitant orifice of one configuration (thesis 4.2.1).
struct OrificeSample {
  double area_mm2 = 0.0;  ///< mean over the end states; NaN if the configuration cannot be made
  double sd_mm2 = 0.0;    ///< over the end states, 0 of one
  bool trusted = false;   ///< converged, without leaflets through each other
};

/// Dilation, height, displacements (anterolateral, posteromedial) in 1e-6 percent or mm, sizes.
using ConfigurationKey = std::array<std::int64_t, 9>;
ConfigurationKey key_of(const Configuration& configuration);
/// The rounded one, which is closed.
Configuration configuration_of(const ConfigurationKey& key);

struct ConfigurationKeyHash {
  std::size_t operator()(const ConfigurationKey& key) const;
};
using KnownOrifices = std::unordered_map<ConfigurationKey, OrificeSample, ConfigurationKeyHash>;

/// Closes these configurations somewhere else; samples in their order, the bits that a table would give.
/// Calls its second argument with how many are done and planned. What it throws ends OrificeTable::at().
using CloseElsewhere = std::function<std::vector<OrificeSample>(
    const std::vector<ConfigurationKey>&, const std::function<void(int, int)>&)>;

struct OrificeTableOptions {
  ClosureOptions closure;
  int threads = 0;      ///< 0: all cores; does not change any answer
  KnownOrifices known;  ///< of this valve and these closure options, from an earlier run
  /// Told of each closure as it ends, from one thread at a time. What it throws ends at().
  std::function<void(const ConfigurationKey&, const OrificeSample&)> keep;
  /// Done and planned of the present batch, likewise.
  std::function<void(int, int)> progress;
  CloseElsewhere close_elsewhere;  ///< all that at() does not know, in one call; empty: here
};

class OrificeTable {
 public:
  OrificeTable(const Valve& valve, OrificeTableOptions options);

  const Valve& valve() const { return valve_; }
  void use_threads(int threads) { options_.threads = threads; }  ///< from here on; 0: all cores
  /// Closes those that are not known. In the order of `configurations`.
  std::vector<OrificeSample> at(std::span<const Configuration> configurations);
  /// Null if it is not known.
  const OrificeSample* find(const Configuration& configuration);

  /// A sample of what was asked for, closed again from where it started and from the open state; on
  /// all threads. These closures are not counted, nor kept.
  StartCheck check_starts();

  /// Made by this table, with those that others start from; or made for it elsewhere, without them.
  int closures() const { return closures_; }
  int configurations() const { return configurations_; }  ///< asked for: closed now, or known
  int known() const { return known_before_; }             ///< of those, from an earlier run
  int untrusted() const { return untrusted_; }            ///< of those asked for

 private:
  enum class Start { Open, Predicted };
  using Closure = std::shared_ptr<const ClosureResult>;  ///< null: it cannot be made
  struct Closed {
    OrificeSample sample;
    Closure closure;
  };
  /// Of a batch.
  struct Share {
    int done = 0, planned = 0;
  };
  struct Entry {
    OrificeSample sample;
    bool before = false;  ///< from an earlier run
    bool asked = false;
  };
  const OrificeSample& ask(Entry& entry);
  /// What its closure is predicted from; none: it starts from the open state.
  std::vector<ConfigurationKey> frame_of(const ConfigurationKey& key) const;
  /// Predicted: all of its frame is at hand.
  Closed close_one(const ConfigurationKey& key, Start start) const;
  void close(const std::vector<ConfigurationKey>& keys, Start start, Share of_batch);
  void close_elsewhere(std::vector<ConfigurationKey> keys);

  Valve valve_;
  OrificeTableOptions options_;
  std::shared_ptr<PreparedValves> prepared_ = std::make_shared<PreparedValves>();

  std::unordered_map<ConfigurationKey, Entry, ConfigurationKeyHash> known_;
  /// Of configurations on the lattice.
  std::unordered_map<ConfigurationKey, Closure, ConfigurationKeyHash> frame_;
  int closures_ = 0, configurations_ = 0, known_before_ = 0, untrusted_ = 0;
};

}  // namespace coapt
