// Text line by line: what the mesh and CSV readers share.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace coapt {

struct Line {
  int number = 0;  ///< from 1
  std::string_view text;
};

/// Hands out lines without their ends (\n or \r\n; \r where a text has no \n); none after the last.
class LineScanner {
 public:
  explicit LineScanner(std::string_view text)
      : rest_(text), end_(text.find('\n') == std::string_view::npos ? '\r' : '\n') {}
  std::optional<Line> next();
  std::string_view rest() const { return rest_; }               ///< after the last line handed out
  int number() const { return number_; }                        ///< of that line
  void skip(std::size_t bytes) { rest_.remove_prefix(bytes); }  ///< at most rest().size()

 private:
  std::string_view rest_;
  char end_;
  int number_ = 0;
};

std::string_view trimmed(std::string_view text);

/// What parts words within a line.
inline constexpr std::string_view kLineBlanks = " \t\r\f\v";

/// More words or fields in a line are passed over: a closed line of OBJ has its points in one.
inline constexpr std::size_t kMaxWords = 100'002;

/// Words between blanks and tabs.
std::vector<std::string_view> words(std::string_view text);

/// Fields between commas, trimmed; "" has one, which is empty.
std::vector<std::string_view> fields(std::string_view text);

/// The whole of `text` as a number ("nan" and "inf" included), or none.
std::optional<double> to_number(std::string_view text);
std::optional<long long> to_integer(std::string_view text);

}  // namespace coapt
