// Tables as text that spreadsheets read.
#pragma once

#include <charconv>
#include <cmath>
#include <sstream>
#include <string>

#include "core/valve/types.h"

namespace coapt {

/// Lines of comma-separated cells. Text with a comma, a quote or an end of a line is quoted (RFC 4180). Text that a spreadsheet would
/// compute (it begins with =, +, -, @, a tab or a return) has an apostrophe before it, which a spreadsheet does not show.
class CsvLines {
 public:
  explicit CsvLines(const std::string& header) { text_ << header << '\n'; }
  CsvLines() = default;

  CsvLines& operator<<(double value) {
    separate();
    if (std::isfinite(value)) text_ << value;
    return *this;
  }
  CsvLines& operator<<(int value) {
    separate();
    text_ << value;
    return *this;
  }
  CsvLines& operator<<(bool value) { return *this << (value ? "true" : "false"); }
  CsvLines& operator<<(const char* value) { return *this << std::string(value); }
  CsvLines& operator<<(const std::string& value) {
    separate();
    const bool computes = value.find_first_of("=+-@\t\r") == 0 && !is_number(value);
    if (value.find_first_of(",\"\n\r") == std::string::npos) {
      text_ << (computes ? "'" : "") << value;
      return *this;
    }
    text_ << '"' << (computes ? "'" : "");
    for (const char c : value) text_ << (c == '"' ? "\"\"" : std::string(1, c));
    text_ << '"';
    return *this;
  }
  CsvLines& operator<<(const Vec3& value) { return *this << value.x() << value.y() << value.z(); }
  void end_line() {
    text_ << '\n';
    first_ = true;
  }
  std::string text() const { return text_.str(); }

 private:
  static bool is_number(const std::string& value) {
    double number = 0.0;
    const auto [end, wrong] = std::from_chars(value.data(), value.data() + value.size(), number);
    return wrong == std::errc() && end == value.data() + value.size();
  }
  void separate() {
    if (!first_) text_ << ',';
    first_ = false;
  }
  std::ostringstream text_;
  bool first_ = true;
};

}  // namespace coapt
