#pragma once

#include <string>
#include <vector>

#include "search/studies/anchor_question.h"

namespace coapt {

/// Share of anatomies where the trigone is the better anchor: a block per class, a row per protocol, a
/// column per objective.
std::string anchor_question_svg(const std::vector<AnchorAnswer>& answers);

}  // namespace coapt
