// The first byte of an input of fuzz_endpoints.
#pragma once

#include <array>
#include <string_view>

namespace coapt {

/// Renamed by PATCH.
inline constexpr std::string_view kKeptPlanPath = "/v1/kept-plans/kept";

/// Requests with a body, which is what follows: POST, but for kKeptPlanPath. The byte is 'a' and the place in this list.
inline constexpr std::array<std::string_view, 26> kBodyPaths = {
    "/v1/valves",         "/v1/valves:validate", "/v1/closures",
    "/v1/scenes",         "/v1/exports",         "/v1/pictures",
    "/v1/evaluations",    "/v1/reports",         "/v1/plans",
    "/v1/studies",        "/v1/jobs/job:cancel", "/v1/openings",
    "/v1/kept-plans",     kKeptPlanPath,         "/v1/valves:import",
    "/v1/imports",        "/v1/imports:preview", "/v1/diagnoses",
    "/v1/physiology",     "/v1/preferences",     "/v1/information",
    "/v1/valves:observe", "/v1/comparisons",     "/v1/exports:files",
    "/v1/fits",           "/v1/model-studies"};

/// Forms to kFormPath: what follows is the body, its parts divided by kFormBoundary. Their byte comes after those of the paths above.
inline constexpr std::string_view kFormPath = "/v1/valves:import", kFormBoundary = "X";

/// Requests without a body: what follows is path and query, as after percent-decoding. Their bytes come
/// after that of forms.
inline constexpr std::array<std::string_view, 2> kOtherMethods = {"GET", "DELETE"};

/// In the store from the start: an ended search, a waiting one, the valve of both, a plan kept for it.
inline constexpr const char* kEndedJob = "job";
inline constexpr const char* kWaitingJob = "wait";
inline constexpr const char* kStoredValve = "valve";
inline constexpr const char* kKeptPlan = "kept";

}  // namespace coapt
