// The result of designing a ring as JSON: coapt.ring_design/1.
#pragma once

#include <string>

#include "io/json/json.h"
#include "search/rings/design_ring.h"

namespace coapt {

/// What a design was made for.
struct RingDesignSource {
  std::string population;  ///< name and seed, or the valve's name
  std::string aetiology;   ///< that members were chosen by; empty: all
  std::uint64_t seed = 1;  ///< of the search
  int evaluations = 0;     ///< asked for
};

/// {"schema", "version", "notice", "design": coapt.ring/1, "generic": its name and rule, "gain_held_out", "gain_low", "gain_high" (points of
/// the share of closures below 5 mm2, held-out members), "leak_gain_mm2" and its interval, counts, "verdicts" by aetiology, "claims",
/// "rivals"}.
Json to_json(const RingDesignResult& result, const RingDesignSource& source);

/// The design alone, with its provenance: what -o writes.
Json ring_document(const RingDesignResult& result, const RingDesignSource& source);

}  // namespace coapt
