// What stands in every result: which build said it, so that a figure can be traced to the code that made it, and for whom it is not.
#pragma once

#include <string>
#include <string_view>

#include "io/json/json.h"

namespace coapt {

inline constexpr std::string_view kResearchNotice =
    "coapt is research software, not a medical device; not for clinical decisions.";

/// Raised with every change of the code that moves a closure or its leak: what is stored is then closed again.
inline constexpr int kClosureRevision = 11;
/// Likewise of what else decides a PlanClosure: plan_key(), apply_plan(), kRingShapes, the disturbance of an index, the
/// neighbour that its closure starts from, what is measured of it.
inline constexpr int kPlanRevision = 12;

/// "0.2.0".
std::string_view version();
/// Twelve digits of the commit, "+changes" after them if files differed from it; "unknown" of sources without history.
std::string_view git_revision();
/// "coapt 0.2.0", and who may rely on it: what --version prints of a program.
std::string about(std::string_view program);
/// {"git", "closures", "plans"}: beside "version" in results.
Json revision_json();
/// A result as users get it: "schema", "version", "revision", "notice", then the members of `rest`.
Json result_document(std::string_view schema, Json rest);

}  // namespace coapt
