// The plan report: one HTML file, no scripts, nothing fetched.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/closed/closed_valve.h"
#include "io/json/plans_json.h"

namespace coapt {

/// A picture of a report.
struct ReportPicture {
  enum class View { Before, AtrialPair, SectionChange, After };
  View view = View::Before;
  std::size_t plan = 0;  ///< index of the plan, of all but Before
};

struct PlanReport {
  const ClosedValve& before;
  const std::vector<ClosedValve>& after;  ///< of the ranked plans, best first; may be fewer
  const SearchResult& result;
  const SearchRequest& request;
  int about = 0;  ///< rank of the one plan that it is about; 0: all of them, the first in front
  std::string date = {};  ///< "28 November 2026"; empty: none
  /// What stands for a picture, in base64; empty: it is drawn.
  std::function<std::string(const ReportPicture&)> picture = {};
};

/// PNG, in base64. @param after as of PlanReport, with the picture's plan
std::string drawn(const ReportPicture& picture, const ClosedValve& before,
                  const std::vector<ClosedValve>& after);

/// A first page that fits on one sheet (picture, plan in surgical words, figures that matter, what to watch,
/// other plans), then the evidence, then the limits and how to get the same again.
std::string plan_report_html(const PlanReport& report);

/// The valve, and as each ranked plan leaves it, closed as the search closed them.
struct PlanPictures {
  ClosedValve before;
  std::vector<ClosedValve> after;
};
/// @pre the search kept its closures
PlanPictures pictures_of(const SearchResult& result);

/// The report on all plans, of today.
std::string plan_report_html(const SearchResult& result, const SearchRequest& request);

/// Of this day, where this program runs: "28 November 2026".
std::string today();

/// Index of the plan in front. @pre there are plans.
std::size_t plan_in_front(const PlanReport& report);

/// Whether the evidence has a part for that plan.
bool is_told(const PlanReport& report, const RankedPlan& plan);

/// In base64: drawn, or what stands for it.
std::string picture_of(const PlanReport& report, const ReportPicture& picture);

}  // namespace coapt
