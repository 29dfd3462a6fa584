// Designed rings: the shape within a plan, and the file of a design, coapt.ring/1.
#pragma once

#include <string_view>

#include "core/repair/ring_design.h"
#include "io/json/json.h"
#include "io/json/json_reader.h"

namespace coapt {

/// {"name", and each of kRingTerms by its name}.
Json to_json(const DesignedShape& shape);
/// Ranges of the terms; whether the shape can be sewn is check_designed_shape()'s.
DesignedShape read_designed_shape(const JsonPlace& place);

/// coapt.ring/1: {"schema", "ring": the shape, "sizing": {"width_over_transverse"}, "provenance"}.
/// @param provenance how it was made, for people; an object, which reading leaves out; may be empty.
Json to_json(const RingDesign& design, const Json& provenance);
Expected<RingDesign> ring_from_json(const Json& json);
Expected<RingDesign> read_ring(std::string_view text);

}  // namespace coapt
