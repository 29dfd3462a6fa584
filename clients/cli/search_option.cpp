#include "clients/cli/search_option.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace coapt {
namespace {

template <class Value>
Check check_of(const Range& range) {
  if constexpr (std::is_same_v<Value, std::uint64_t>) {
    return number_from(std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max());
  } else {
    return number_from(static_cast<Value>(range.min), static_cast<Value>(range.max));
  }
}

}  // namespace

std::string flag_of(const OptionRow<SearchOptions>& row) {
  std::string name = row.name;
  if (name.ends_with("_mm2")) name.resize(name.size() - std::string("_mm2").size());
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

void add_search_option(Command command, const std::string& name, SearchOptions& options) {
  for (const OptionRow<SearchOptions>& row : search_option_rows())
    if (row.name == name)
      std::visit(
          [&]<class Value>(Value SearchOptions::*member) {
            if constexpr (!std::is_same_v<Value, bool>)
              command.add_option(flag_of(row), options.*member, row.help)
                  .check(check_of<Value>(row.range))
                  .show_default();
          },
          row.member);
}

}  // namespace coapt
