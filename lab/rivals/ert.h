// Expected running time to a target (Hansen et al. 2010), in closures, and its distribution.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace coapt::rivals {

/// A run of one method on one solved lattice.
struct MeasuredRun {
  std::string method, lattice;
  std::uint64_t seed = 0;
  std::vector<std::pair<int, double>> improvements;  ///< closures spent, cost less the optimum
  int spent = 0;                                     ///< closures in all
};

/// Cost above the optimum, mm2; the last is the optimum itself, within rounding.
inline constexpr double kErtTargets_mm2[] = {5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 1e-9};

struct Ert {
  std::string method;
  double target_mm2 = 0.0;
  double closures =
      0.0;  ///< of all runs until they reach it, or end, for each success; infinite without
  int successes = 0, runs = 0;
};

/// Closures until the run reached the target; -1 if it did not.
int closures_to(const MeasuredRun& run, double target_mm2);

/// By method in the order of their first run, then by target. @param lattice empty: over all.
std::vector<Ert> expected_running_times(const std::vector<MeasuredRun>& runs,
                                        const std::string& lattice = "");

/// Share of (run, target) pairs of a method that were reached within so many closures, at each closure where one is.
struct ReachedShares {
  std::string method;
  std::vector<double> closures, share;
};
std::vector<ReachedShares> reached_shares(const std::vector<MeasuredRun>& runs);

/// "method,target_mm2,ert_closures,successes,seeds"; an infinite time is "inf".
std::string ert_csv(const std::vector<Ert>& rows);

}  // namespace coapt::rivals
