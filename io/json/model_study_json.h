// How much of an answer is the model's, as JSON.
#pragma once

#include <string>

#include "io/json/json.h"
#include "search/studies/model_study.h"

namespace coapt {

/// coapt.model_study/2: "leak" over the draws, with its "parameters". What is not known is
/// null.
Json to_json(const ModelStudy& study, const std::string& valve_name);

}  // namespace coapt
