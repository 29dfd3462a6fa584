// The closures of a study, made by whoever is asked.
#pragma once

#include "farm/ask/ask.h"
#include "search/studies/orifice_table.h"

namespace coapt {

/// For OrificeTableOptions::close_elsewhere of a table of this valve. Throws (std::runtime_error) what the asker says.
/// @param context its progress is not called, but the table's is.
CloseElsewhere closures_asked_of(const Asker& asker, const Valve& valve,
                                 const ClosureOptions& closure, const AskContext& context);

}  // namespace coapt
