// Why a valve leaks, as JSON.
#pragma once

#include <optional>

#include "core/closed/diagnosis.h"
#include "core/metrics/estimate.h"
#include "io/json/json.h"

namespace coapt {

/// {"competent", "competent_sure", "leak_mm2", "leak_error_mm2", "type", "types", "type_sure", "not_ruled_out", "segments": [{"name",
/// "finding", "sure", "edge_mm", "highest_mm", "override_mm", "width_mm", "ruptured_chordae"}], "tip_to_trigone_mm", "tenting_height_mm",
/// "tethering", "tethered_side", "annulus": {"ap_mm", "transverse_mm", "dilated"}, "thresholds": [{"figure", "threshold", "unit",
/// "source"}], "sentence", "summary"}; null if nothing could be diagnosed.
/// @param leak what the sentence tells of its error, see sentence_of()
Json to_json(const std::optional<Diagnosis>& diagnosis, const Estimate& leak = {});

/// coapt.diagnosis/1: the same, and the valve's name.
Json diagnosis_document(const Diagnosis& diagnosis, const Valve& valve);

}  // namespace coapt
