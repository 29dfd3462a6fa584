// A valve, repaired or not, under draws of what the model does not know of it, within the limits of a request.
#pragma once

#include "operations/repair_request.h"
#include "search/studies/model_study.h"

namespace coapt {

/// Closures of so many draws: with a plan the valve before it is closed, too; chordae that were not seen are drawn anew by one.
int draw_closures(const RepairRequest& asked, int draws);

/// Errors: more draws than a service has closures for, at "/draws".
Errors check_draws(const RepairRequest& asked, int draws, const Context& context);

/// Errors: refusal(), if its time was over.
Expected<ModelStudy> study_within(const RepairRequest& asked, ModelStudyOptions study,
                                  ClosureOptions closure, Context& context);

}  // namespace coapt
