// The first byte of an input of fuzz_endpoints.
#pragma once

#include <array>
#include <string_view>

namespace coapt {

/// Renamed by PATCH.
inline constexpr std::string_view kKeptPlanPath = "/v1/kept-plans/kept";

/// Requests with a body, which is what follows: POST, but for kKeptPlanPath. The byte is 'a' and the place in this list.
inline constexpr std::array<std::string_view, 14> kBodyPaths = {
    "/v1/valves",          "/v1/valves:validate", "/v1/closures",   "/v1/scenes", "/v1/exports",
    "/v1/pictures",        "/v1/evaluations",     "/v1/reports",    "/v1/plans",  "/v1/studies",
    "/v1/jobs/job:cancel", "/v1/openings",        "/v1/kept-plans", kKeptPlanPath};

/// Requests without a body: what follows is path and query, as after percent-decoding. Their bytes come
/// after those of the paths above.
inline constexpr std::array<std::string_view, 2> kOtherMethods = {"GET", "DELETE"};

/// In the store from the start: an ended search, a waiting one, the valve of both, a plan kept for it.
inline constexpr const char* kEndedJob = "job";
inline constexpr const char* kWaitingJob = "wait";
inline constexpr const char* kStoredValve = "valve";
inline constexpr const char* kKeptPlan = "kept";

}  // namespace coapt
