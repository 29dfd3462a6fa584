// What the kinds of work share: documents among the parts, numbers and texts in packed answers.
#pragma once

#include <bit>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "farm/work/work.h"
#include "io/json/json_reader.h"

namespace coapt {

/// The part that the integer at `place` names; null if there is none.
const std::string* named_part(const JsonPlace& place, const WorkRequest& request);

/// What `read` makes of the part that the integer at `place` names. Stand-in an empty T. Problems of the part's own document are
/// listed at `place`, each with its pointer in words.
template <class T>
T read_part(const JsonPlace& place, const WorkRequest& request,
            Expected<T> (*read)(std::string_view)) {
  const std::string* part = named_part(place, request);
  if (part == nullptr) return {};
  Expected<T> value = read(*part);
  if (value) return *std::move(value);
  for (const Error& error : value.errors())
    add_problem(place, error.code, error.path + ": " + error.message);
  return {};
}

/// What is wrong with an answer; empty: it could be read.
template <class T>
std::string objection_of(const Expected<std::vector<T>>& answers, int count) {
  if (!answers) return answers.errors().front().message;
  if (std::ssize(*answers) == count) return "";
  return std::to_string(answers->size()) + " answers, where " + std::to_string(count) +
         " are asked for";
}

/// The same, then what `each(answer, index)` says against the first answer that it says something against.
template <class T, class Each>
std::string objection_of(const Expected<std::vector<T>>& answers, int count, const Each& each) {
  std::string objection = objection_of(answers, count);
  for (int i = 0; objection.empty() && i < count; ++i)
    objection = each((*answers)[static_cast<std::size_t>(i)], i);
  return objection;
}

/// Of tasks of a search each: one of a few would take as long as what was asked for.
inline int sampled_searches(std::int64_t items) { return items >= 5 ? 1 : 0; }

/// Little-endian, eight bytes each.
void pack(std::string& bytes, std::uint64_t value);
inline void pack(std::string& bytes, double value) {
  pack(bytes, std::bit_cast<std::uint64_t>(value));
}
/// @pre bytes holds eight from `at` on.
std::uint64_t unpacked(std::string_view bytes, std::size_t at);

/// Its 64-bit length, then its bytes.
void pack_text(std::string& bytes, const std::string& text);
/// The first of `bytes`, which begin behind it then; none if they are cut off.
std::optional<std::string> take_text(std::string_view& bytes);

}  // namespace coapt
