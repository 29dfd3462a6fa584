// Reading JSON strictly. A document is walked by JsonPlace; each function below returns the value
// at a place, or lists what is wrong with it and returns a stand-in, so that one pass finds every
// problem. The pointer to a place is spelt only when there is a problem.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/valve/problem_list.h"
#include "io/json/json.h"

namespace coapt {

struct JsonPlace {
  const Json& value;
  ProblemList& problems;
  const JsonPlace* parent = nullptr;
  std::string_view name = {};  ///< in the parent, if that is an object
  std::size_t index = 0;       ///< in the parent, if that is an array
};

std::string pointer(const JsonPlace& place);
void add_problem(const JsonPlace& place, ErrorCode code, std::string message);
/// Lists `errors`, whose pointers start at `pointer`.
void add_below(ProblemList& problems, const std::string& pointer, const Errors& errors);

struct JsonField {
  std::string_view name;
  std::function<void(const JsonPlace&)> read;
  bool required = true;
};

/// Calls `read` of each field that is there, in the order given; missing and unknown ones are
/// problems.
void read_fields(const JsonPlace& place, std::span<const JsonField> fields);
inline void read_fields(const JsonPlace& place, std::initializer_list<JsonField> fields) {
  read_fields(place, std::span(fields.begin(), fields.size()));
}

/// For JsonField::read: stores what read(place) returns in `target`.
template <class T, class Read>
std::function<void(const JsonPlace&)> into(T& target, Read read) {
  return [&target, read](const JsonPlace& place) { target = read(place); };
}

/// For JsonField::read: a document read by `from_json` (plan_from_json, ...); `target` is set if it has no problem.
template <class T>
std::function<void(const JsonPlace&)> document(T& target, Expected<T> (*from_json)(const Json&)) {
  return [&target, from_json](const JsonPlace& place) {
    Expected<T> value = from_json(place.value);
    if (value) {
      target = *std::move(value);
    } else {
      add_below(place.problems, pointer(place), value.errors());
    }
  };
}

/// Calls `read` for each entry, until the problems are crowded; not at all if the value is no
/// array.
void read_array(const JsonPlace& place, const std::function<void(const JsonPlace&)>& read);

template <class Read>
auto read_list(const JsonPlace& place, Read read) {
  std::vector<std::invoke_result_t<Read, const JsonPlace&>> list;
  read_array(place, [&](const JsonPlace& entry) { list.push_back(read(entry)); });
  return list;
}

/// Stand-in NaN.
double read_number(const JsonPlace& place);
double read_number_in(const JsonPlace& place, Range range, const char* unit = "");

inline constexpr int kNoInteger = std::numeric_limits<int>::min();
/// Stand-in kNoInteger. 3.0 is no integer.
int read_integer(const JsonPlace& place);
int read_integer_in(const JsonPlace& place, int min, int max);
/// Readers of fields with a range.
inline auto number_in(double min, double max) {
  return [=](const JsonPlace& place) { return read_number_in(place, {min, max}); };
}
inline auto integer_in(int min, int max) {
  return [=](const JsonPlace& place) { return read_integer_in(place, min, max); };
}
std::uint64_t read_unsigned(const JsonPlace& place);
bool read_boolean(const JsonPlace& place);
std::string read_string(const JsonPlace& place);
/// Three numbers; stand-in NaN.
Vec3 read_vector(const JsonPlace& place);
/// Three integers; stand-in kNoInteger.
std::array<int, 3> read_indices(const JsonPlace& place);
Points read_points(const JsonPlace& place);
/// Unsupported unless the string at `place` is `schema`.
void read_schema(const JsonPlace& place, std::string_view schema, std::string_view earlier = {});

/// The index of the string at `place` among `names`; BadReference and none if it is not there.
std::optional<std::size_t> read_choice(const JsonPlace& place,
                                       const std::vector<std::string>& names);

/// The member `name` of an object, by itself: for the one that tells which others there are.
/// None, and a problem, if it is missing or `place` is no object.
std::optional<JsonPlace> read_member(const JsonPlace& place, std::string_view name);

/// One of an enumeration's values by its to_string(). Stand-in the first.
template <class Enum>
Enum read_name(const JsonPlace& place, const std::vector<Enum>& choices) {
  std::vector<std::string> names;
  for (const Enum choice : choices) names.push_back(to_string(choice));
  return choices[read_choice(place, names).value_or(0)];
}

}  // namespace coapt
