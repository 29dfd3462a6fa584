// What the model leaves open of a valve's leak, for people: tables, a page, a summary.
#pragma once

#include <string>
#include <vector>

#include "io/json/named_file.h"
#include "search/studies/model_study.h"

namespace coapt {

/// How draws weigh by what was observed, the end of a sentence: "contradicts the model: ...", said of what was observed, or "say as much as 23
/// that weigh alike", of the draws.
std::string weight_words(bool contradicts, double effective);

/// areas.csv, parameters.csv, draws.csv, index.html, and summary.txt, what a terminal shows.
std::vector<NamedFile> model_study_files(const ModelStudy& study, const std::string& valve);

}  // namespace coapt
