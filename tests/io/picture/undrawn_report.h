// Reports of which the words are asked for.
#pragma once

#include <string>

#include "io/picture/report.h"

namespace coapt {

/// The report with nothing for its pictures, whose drawing takes nearly all of its time.
inline std::string undrawn_report(PlanReport report) {
  report.picture = [](const ReportPicture&) { return std::string("AA=="); };
  return plan_report_html(report);
}

}  // namespace coapt
