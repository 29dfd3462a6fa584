#include "io/mesh/text_scan.h"

#include <algorithm>
#include <charconv>

namespace coapt {
namespace {

template <class T>
std::optional<T> parse(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  T value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (text.empty() || error != std::errc() || stop != end) return {};
  return value;
}

}  // namespace

std::optional<Line> LineScanner::next() {
  if (rest_.empty()) return {};
  const std::size_t end = rest_.find(end_);
  std::string_view text = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  return Line{++number_, text};
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kLineBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kLineBlanks) - first + 1);
}

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> found;
  for (std::size_t end = 0;;) {
    const std::size_t start = text.find_first_not_of(kLineBlanks, end);
    if (start == std::string_view::npos || found.size() == kMaxWords) return found;
    end = std::min(text.find_first_of(kLineBlanks, start), text.size());
    found.push_back(text.substr(start, end - start));
  }
}

std::vector<std::string_view> fields(std::string_view text) {
  std::vector<std::string_view> found;
  for (std::size_t start = 0;;) {
    const std::size_t comma = text.find(',', start);
    found.push_back(trimmed(text.substr(start, comma - start)));
    if (comma == std::string_view::npos || found.size() == kMaxWords) return found;
    start = comma + 1;
  }
}

std::optional<double> to_number(std::string_view text) { return parse<double>(text); }

std::optional<long long> to_integer(std::string_view text) { return parse<long long>(text); }

}  // namespace coapt
