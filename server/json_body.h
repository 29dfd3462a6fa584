// Reading the bodies of requests: objects whose fields are coapt's own documents.
#pragma once

#include <optional>
#include <vector>

#include "core/repair/plan.h"
#include "core/valve/valve.h"
#include "io/json/json_reader.h"
#include "io/store/job_store.h"
#include "server/answer.h"
#include "server/compute.h"
#include "server/limits.h"
#include "server/route.h"
#include "server/valve_cache.h"

namespace coapt {

/// Where requests have their valves from.
struct ValveSource {
  const JobStore& store;
  const ServiceLimits& limits;
  ValveCache& known;
  Compute& parsing;  ///< turns: a document takes twenty times its bytes while it is read
};

/// A stored valve by its id, or a preset by its name; BadReference if there is none.
Expected<Valve> named_valve(const ValveSource& source, const std::string& name);

/// Reads a valve written there (coapt.valve/1), or named there: an id or a preset.
std::function<void(const JsonPlace&)> valve_field(const ValveSource& source, Valve& target);

/// The most values that a document with a valve of these limits may have: three times what one has that is written
/// out in full, because each takes up to a hundred bytes while it is read.
std::size_t most_values(const ServiceLimits& limits);

/// Reads an object of these fields. What is wrong with it, if anything: 400 if it is no JSON, else 422 with
/// every problem; 503 if too many are read at once.
std::optional<Answer> read_body(const ValveSource& source, const Request& request,
                                const std::vector<JsonField>& fields);

/// The same for what `read` makes of the document: 422 with what it says against it.
std::optional<Answer> read_body(const ValveSource& source, const Request& request,
                                const std::function<Errors(const Json&)>& read);

/// How long a body takes to be read, in seconds, roughly.
double reading_seconds(const Request& request);

}  // namespace coapt
