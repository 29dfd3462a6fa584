#pragma once

#include <string>

namespace coapt {

/// Beside kReportStyle: the first page, and how the report prints on A4 and Letter, with the notice, the
/// valve's name, date and page numbers in the margins of every sheet.
std::string report_page_style(const std::string& valve_name, const std::string& date = "");

}  // namespace coapt
