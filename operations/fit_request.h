// To what a valve is fitted and how, in a request.
#pragma once

#include <optional>
#include <vector>

#include "io/json/json_reader.h"
#include "operations/context.h"
#include "search/fit/fit.h"

namespace coapt {

struct FitTarget {
  MeasuredSide side = MeasuredSide::Atrial;
  std::optional<double> leak_mm2;
  double leak_sd_mm2 = MeasuredClosure{}.leak_sd_mm2;
  FitOptions options;
};

/// Fields "side", "leak_mm2", "leak_sd_mm2", "known", "slack_sd", "tip_sd_mm", "hidden_sd_mm", "points" and "rounds".
/// `target` must outlive them.
std::vector<JsonField> fit_fields(FitTarget& target);

/// Errors of fit_valve() in the words of such a request, below `path`; others of the valve, below `valve`.
Errors as_fit_fields(Errors errors, const std::string& path, const std::string& valve);

/// The options with the threads and time of the context, which also ends the fit and hears how far it is.
FitOptions within(FitOptions options, Context& context);

}  // namespace coapt
