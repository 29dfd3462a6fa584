// Tables as text that spreadsheets read.
#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "core/valve/types.h"

namespace coapt {

/// Lines of comma-separated cells. Text with a comma or a quote is quoted (RFC 4180).
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
    if (value.find_first_of(",\"\n") == std::string::npos) {
      text_ << value;
      return *this;
    }
    text_ << '"';
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
  void separate() {
    if (!first_) text_ << ',';
    first_ = false;
  }
  std::ostringstream text_;
  bool first_ = true;
};

}  // namespace coapt
