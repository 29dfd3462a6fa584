// Valves that are stored, presets, ring shapes.
#pragma once

#include "server/json_body.h"
#include "server/page_tokens.h"
#include "server/route.h"

namespace coapt {

/// POST /v1/valves, coapt.valve/1: stores it; its id is the hash of its content.
struct PostValve {
  JobStore& store;
  ValveSource valves;
  Answer operator()(const Request& request) const;
};

/// 201 with the id of a valve that is new, else 200.
/// @param more members of the answer
Answer store_valve(JobStore& store, const ServiceLimits& limits, const Valve& valve,
                   const Json& more = Json::object());

/// GET /v1/valves?page_size=&page_token=: newest first.
struct GetValves {
  const JobStore& store;
  const PageTokens& tokens;
  Answer operator()(const Request& request) const;
};

/// GET /v1/valves/{id} and /v1/presets/{name}: coapt.valve/1.
struct GetValve {
  ValveSource valves;
  Answer operator()(const Request& request) const;
};

/// DELETE /v1/valves/{id}
struct DeleteValve {
  JobStore& store;
  ValveCache& known;
  Answer operator()(const Request& request) const;
};

/// GET /v1/presets
struct GetPresets {
  Answer operator()(const Request& request) const;
};

/// GET /v1/rings
struct GetRings {
  Answer operator()(const Request& request) const;
};

}  // namespace coapt
