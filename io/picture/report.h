// The plan report: one HTML file, no scripts, nothing fetched.
#pragma once

#include <string>
#include <vector>

#include "io/json/plans_json.h"
#include "io/picture/picture.h"

namespace coapt {

struct PlanReport {
  const ClosedValve& before;
  const std::vector<ClosedValve>& after;  ///< of the ranked plans, best first; may be fewer
  const SearchResult& result;
  const SearchRequest& request;
  int about = 0;  ///< rank of the one plan that it is about; 0: all of them, the first in front
};

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

/// The report on all plans.
std::string plan_report_html(const SearchResult& result, const SearchRequest& request);

}  // namespace coapt
