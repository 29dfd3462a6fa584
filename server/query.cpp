#include "server/query.h"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace coapt {

std::int64_t integer_in(const Request& request, const char* name, Range range,
                        std::int64_t otherwise, ProblemList& problems) {
  const auto found = request.query.find(name);
  if (found == request.query.end()) return otherwise;
  const std::string& text = found->second;
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const double value = static_cast<double>(number);
  if (error == std::errc() && end == text.data() + text.size() && value >= range.min &&
      value <= range.max)
    return number;
  problems.add(ErrorCode::OutOfRange, std::string("?") + name,
               "must be an integer from " + shown(range.min) + " to " + shown(range.max));
  return otherwise;
}

void check_query(const Request& request, std::initializer_list<const char*> known,
                 ProblemList& problems) {
  for (const auto& parameter : request.query) {
    const std::string& name = parameter.first;
    if (std::none_of(known.begin(), known.end(), [&](const char* one) { return name == one; }))
      problems.add(ErrorCode::UnknownField, "?" + name.substr(0, 64),
                   "is not a parameter of this path");
  }
}

}  // namespace coapt
