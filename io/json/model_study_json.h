// How much of an answer is the model's, as JSON.
#pragma once

#include <string>
#include <vector>

#include "io/json/json.h"
#include "search/studies/model_study.h"

namespace coapt {

/// coapt.model_study/2: "leak" over the draws, with its "parameters". What is not known is
/// null.
Json to_json(const ModelStudy& study, const std::string& valve_name);

/// coapt.information/1: "leak" with its error, and rows[] of "measurement", "share_removed", "remaining_mm2", most telling first.
Json to_json(const ModelStudy& study, const std::vector<InformationRow>& rows,
             const std::string& valve_name);

/// rows[] alone.
Json to_json(const std::vector<InformationRow>& rows);

/// {"draws", "untrusted", "chordae_drawn", "fit_drawn", "observed", "effective", "contradicts_model"}: what a tissue interval is of.
Json tissue_draws_json(const ModelStudy& study);

}  // namespace coapt
