// Exit codes of coapt; the README and `coapt --help` list them.
#pragma once

#include "core/closure/closure.h"
#include "search/search.h"

namespace coapt {

namespace exit_code {
inline constexpr int kOk = 0;
inline constexpr int kFailure = 1;          ///< coapt failed: an output could not be written
inline constexpr int kBadInput = 2;         ///< the command line or an input file is wrong
inline constexpr int kNotClosed = 3;        ///< the closure did not converge, or leaflets cross
inline constexpr int kNoCompetentPlan = 4;  ///< no plan makes the valve competent
inline constexpr int kInterrupted = 130;    ///< Ctrl-C; the best so far was printed
}  // namespace exit_code

/// Leak (orifice and hidden gap) below which a closed valve counts as competent.
inline constexpr double kCompetentMm2 = 1.0;

int exit_code_of(const ClosureResult& closure);

/// kOk if some plan converges without crossing and is competent.
int exit_code_of(const SearchResult& result);

}  // namespace coapt
