// Work of kind "plans": a search for repair plans on each of several valves.
//
// The first part: {"search": options as a request for plans has them, "valves": [part, ...]}. An item is a valve, its search
// whole. Neither clock nor machine decide anything of an answer: a search with a limit of time is refused.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "farm/work/work.h"
#include "search/plans/search_options.h"

namespace coapt {

/// What one search leaves. Packed: of each, a 64-bit length and the bytes.
struct PlanAnswer {
  std::string plans;     ///< coapt.plans/2, "seconds" null, "reproduce" without a command
  std::string material;  ///< of its report (io/picture/report_material.h)
  std::string tried;     ///< every plan tried (io/picture/search_csv.h)
};

/// Errors: options that would not give the same plans elsewhere, as pointers into them; options.threads counts for nothing.
Expected<WorkRequest> plan_request(const std::vector<Valve>& valves, const SearchOptions& options);

/// Errors: also those of check_search() for each valve ("/valves/0: ..." in words, the pointer into "/search").
Expected<Work> open_plan_work(const WorkRequest& request);

/// In the order of the valves. Errors: bytes that are no such answers.
Expected<std::vector<PlanAnswer>> plan_answers(std::string_view bytes);

}  // namespace coapt
