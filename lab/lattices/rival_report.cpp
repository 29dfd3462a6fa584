#include "lab/lattices/rival_report.h"

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace coapt {
namespace {

constexpr double kCharted_mm2 = 0.2;
constexpr std::size_t kCurves = 6;

}  // namespace

std::string ecdf_csv(const std::vector<rivals::MeasuredRun>& runs,
                     const std::vector<rivals::Ert>& rows) {
  std::vector<std::pair<double, std::string>> order;
  for (const rivals::Ert& row : rows)
    if (row.target_mm2 == kCharted_mm2 && row.method != "coapt" && row.method != "random")
      order.emplace_back(row.closures, row.method);
  std::sort(order.begin(), order.end());
  std::vector<std::string> shown = {"coapt", "random"};
  for (const auto& [closures, method] : order)
    if (shown.size() < kCurves) shown.push_back(method);
  std::ostringstream csv;
  csv << "method,closures,share\n";
  for (const rivals::ReachedShares& reached : rivals::reached_shares(runs)) {
    if (std::find(shown.begin(), shown.end(), reached.method) == shown.end()) continue;
    for (std::size_t i = 0; i < reached.closures.size(); ++i)
      csv << reached.method << ',' << reached.closures[i] << ',' << reached.share[i] << '\n';
  }
  return csv.str();
}

Json to_json(const Hits& hits) {
  return {{"lattice", hits.lattice},
          {"plans", hits.plans},
          {"seeds", hits.runs},
          {"optimum_found", hits.optimum},
          {"top_1_percent_found", hits.top_percent},
          {"regret_mean_mm2", hits.regret_mean},
          {"regret_worst_mm2", hits.regret_worst}};
}

Json to_json(const LatticeFindings& findings) {
  auto rings = Json::array();
  for (const RingTightness& ring : findings.rings)
    rings.push_back({{"sizes_below", {ring.from, ring.to}},
                     {"closing", ring.closing},
                     {"robust", ring.robust},
                     {"sd_mm2", ring.sd_mm2}});
  const AnchorPairs& pairs = findings.anchors;
  return {{"rings", rings},
          {"anchors",
           {{"pairs", pairs.pairs},
            {"trigone_cheaper", pairs.trigone_cheaper},
            {"trigone_tighter", pairs.trigone_tighter},
            {"cost_difference", pairs.cost_difference},
            {"mean_difference_mm2", pairs.mean_difference_mm2},
            {"sd_difference_mm2", pairs.sd_difference_mm2}}}};
}

Json to_json(const std::vector<rivals::Ert>& rows) {
  auto json = Json::array();
  for (const rivals::Ert& row : rows)
    json.push_back({{"method", row.method},
                    {"target_mm2", row.target_mm2 < 1e-6 ? 0.0 : row.target_mm2},
                    {"ert_closures", row.closures},
                    {"successes", row.successes},
                    {"seeds", row.runs}});
  return json;
}

void print_hits(std::ostream& out, const std::vector<Hits>& hits) {
  out << "lattice        plans   optimum found   in the best 1 %   regret mean, worst (mm2)\n"
      << std::fixed << std::setprecision(2);
  for (const Hits& h : hits)
    out << std::left << std::setw(14) << h.lattice << std::right << std::setw(6) << h.plans
        << std::setw(9) << h.optimum << " of " << h.runs << std::setw(11) << h.top_percent << " of "
        << h.runs << std::setw(14) << h.regret_mean << std::setw(8) << h.regret_worst << '\n';
}

void print_times(std::ostream& out, const std::vector<rivals::Ert>& rows) {
  out << "\nclosures to the optimum +     5       2       1     0.5     0.2     0.1       0\n"
      << std::setprecision(0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool first = i == 0 || rows[i - 1].method != rows[i].method;
    if (first) out << (i == 0 ? "" : "\n") << std::left << std::setw(25) << rows[i].method;
    out << std::right << std::setw(8) << rows[i].closures;
  }
  out << '\n';
}

}  // namespace coapt
