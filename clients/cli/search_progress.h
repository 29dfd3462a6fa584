#pragma once

#include "io/command_line/progress_bar.h"
#include "search/plans/search_progress.h"

namespace coapt {

/// Closures and the lowest leak so far, if one is known.
void show(const ProgressBar& bar, const SearchProgress& progress);

}  // namespace coapt
