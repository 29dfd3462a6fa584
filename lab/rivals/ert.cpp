#include "lab/rivals/ert.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace coapt::rivals {
namespace {

std::vector<std::string> methods_of(const std::vector<MeasuredRun>& runs) {
  std::vector<std::string> methods;
  for (const MeasuredRun& run : runs)
    if (std::find(methods.begin(), methods.end(), run.method) == methods.end())
      methods.push_back(run.method);
  return methods;
}

}  // namespace

int closures_to(const MeasuredRun& run, double target_mm2) {
  for (const auto& [closures, above] : run.improvements)
    if (above <= target_mm2) return closures;
  return -1;
}

std::vector<Ert> expected_running_times(const std::vector<MeasuredRun>& runs,
                                        const std::string& lattice) {
  std::vector<Ert> rows;
  for (const std::string& method : methods_of(runs))
    for (const double target : kErtTargets_mm2) {
      Ert row{method, target, 0.0, 0, 0};
      double spent = 0.0;
      for (const MeasuredRun& run : runs) {
        if (run.method != method || (!lattice.empty() && run.lattice != lattice)) continue;
        ++row.runs;
        const int reached = closures_to(run, target);
        row.successes += reached >= 0;
        spent += reached >= 0 ? reached : run.spent;
      }
      row.closures =
          row.successes > 0 ? spent / row.successes : std::numeric_limits<double>::infinity();
      if (row.runs > 0) rows.push_back(row);
    }
  return rows;
}

std::vector<ReachedShares> reached_shares(const std::vector<MeasuredRun>& runs) {
  std::vector<ReachedShares> all;
  for (const std::string& method : methods_of(runs)) {
    std::vector<double> closures;
    double pairs = 0.0;
    for (const MeasuredRun& run : runs) {
      if (run.method != method) continue;
      for (const double target : kErtTargets_mm2) {
        pairs += 1.0;
        if (const int reached = closures_to(run, target); reached >= 0) closures.push_back(reached);
      }
    }
    std::sort(closures.begin(), closures.end());
    ReachedShares shares{method, {}, {}};
    for (std::size_t i = 0; i < closures.size(); ++i) {
      if (i + 1 < closures.size() && closures[i + 1] == closures[i]) continue;
      shares.closures.push_back(std::max(1.0, closures[i]));
      shares.share.push_back(static_cast<double>(i + 1) / pairs);
    }
    all.push_back(shares);
  }
  return all;
}

std::string ert_csv(const std::vector<Ert>& rows) {
  std::string text = "method,target_mm2,ert_closures,successes,seeds\n";
  for (const Ert& row : rows) {
    char line[160];
    std::snprintf(line, sizeof line, ",%g,%.1f,%d,%d\n",
                  row.target_mm2 < 1e-6 ? 0.0 : row.target_mm2, row.closures, row.successes,
                  row.runs);
    text += row.method + line;
  }
  return text;
}

}  // namespace coapt::rivals
