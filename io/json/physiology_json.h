// What a valve does beside what was measured in hearts, as JSON.
#pragma once

#include "io/json/json.h"
#include "search/studies/physiology.h"

namespace coapt {

/// {"quantity", "what", "value", "unit", "low", "high", "source", "verdict"}; what is not known is null.
Json to_json(const PhysiologyRow& row);

/// coapt.physiology/1: "kind" and "species" of the valve, each judged or not, and "rows".
Json to_json(const Physiology& physiology, const Valve& valve);

}  // namespace coapt
