// find_min_global of dlib (King 2017: Malherbe and Vayatis's upper bounds of Lipschitz functions,
// and Powell's trust regions), with integer variables. An evaluation costs milliseconds, more as they
// grow in number.
#pragma once

#include "lab/rivals/rivals.h"

namespace coapt::rivals {

inline constexpr const char* kDlibRival = "dlib_find_min_global";
/// Calls, the free ones too: 600 cost 11 ms each.
inline constexpr int kMostDlibCalls = 500;

void search_by_dlib(const RivalProblem& problem, const SharesCost& cost);

}  // namespace coapt::rivals
