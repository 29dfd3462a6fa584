#include "io/picture/search_csv.h"

#include "core/repair/describe.h"
#include "io/json/plan_json.h"
#include "io/json/result_json.h"
#include "io/picture/csv_lines.h"

namespace coapt {
namespace {

std::string in_words(const Valve& valve, const RepairPlan& plan) {
  std::string words;
  for (const std::string& line : describe(valve, plan)) words += (words.empty() ? "" : "; ") + line;
  return words;
}

}  // namespace

std::string tried_plans_csv(const Valve& valve, const SearchResult& result) {
  CsvLines csv(
      "number,rank,description,cost_mm2,nodes,failed_nodes,mean_leak_mm2,sd_leak_mm2,"
      "cost_as_planned_mm2,leak_mm2,coaptation_mm,tension_max_n,status,"
      "crossing,"
      "plan");
  int number = 0;
  for (const TriedPlan& tried : result.tried) {
    csv << ++number;
    if (tried.rank > 0) {
      csv << tried.rank;
    } else {
      csv << "";
    }
    csv << in_words(valve, tried.plan) << tried.cost << tried.nodes << tried.failures
        << tried.leak_mm2.mean << tried.leak_mm2.sd << tried.cost_as_planned
        << tried.planned.leak_mm2 << tried.planned.coaptation_mm << tried.planned.tension_max_n
        << to_string(tried.planned.status) << tried.planned.crossing << to_json(tried.plan).dump();
    csv.end_line();
  }
  return csv.text();
}

}  // namespace coapt
