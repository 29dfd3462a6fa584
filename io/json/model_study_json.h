// How much of an answer is the model's, as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "search/studies/model_study.h"

namespace coapt {

/// coapt.model_study/1: "areas" has leak and orifice, each with its "parameters". What is not known is
/// null.
nlohmann::ordered_json to_json(const ModelStudy& study, const std::string& valve_name);

}  // namespace coapt
