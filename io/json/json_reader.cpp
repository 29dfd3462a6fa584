#include "io/json/json_reader.h"

#include <algorithm>
#include <vector>

#include "core/valve/nearest_name.h"

namespace coapt {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMaxShown = 40;

// A value as it may stand in a message: short ones in full.
std::string described(const Json& value) {
  if (value.is_array()) return "an array";
  if (value.is_object()) return "an object";
  if (value.is_string() && value.get_ref<const std::string&>().size() > kMaxShown) {
    return "a long string";
  }
  return json_text(value);
}

void wrong_type(const JsonPlace& place, const char* expected) {
  add_problem(place, ErrorCode::WrongType,
              "is " + described(place.value) + ", must be " + expected);
}

JsonPlace member(const JsonPlace& place, const Json& value, std::string_view name) {
  return {value, place.problems, &place, name};
}

void report_missing(const JsonPlace& place, std::string_view name) {
  add_problem(member(place, Json(), name), ErrorCode::MissingField, "is missing");
}

JsonPlace entry(const JsonPlace& place, std::size_t index) {
  return {place.value[index], place.problems, &place, {}, index};
}

bool is_triple(const JsonPlace& place, const char* expected) {
  if (place.value.is_array() && place.value.size() == 3) return true;
  if (place.value.is_array()) {
    add_problem(place, ErrorCode::OutOfRange,
                "has " + std::to_string(place.value.size()) + " entries, must have 3");
  } else {
    wrong_type(place, expected);
  }
  return false;
}

}  // namespace

std::string pointer(const JsonPlace& place) {
  std::vector<std::string> tokens;
  for (const JsonPlace* at = &place; at->parent != nullptr; at = at->parent) {
    tokens.push_back(at->parent->value.is_object() ? std::string(at->name)
                                                   : std::to_string(at->index));
  }
  Json::json_pointer path;
  for (auto token = tokens.rbegin(); token != tokens.rend(); ++token) path.push_back(*token);
  return path.to_string();
}

void add_problem(const JsonPlace& place, ErrorCode code, std::string message) {
  place.problems.add(code, pointer(place), std::move(message));
}

void add_below(ProblemList& problems, const std::string& pointer, const Errors& errors) {
  for (const Error& error : errors) {
    problems.add(error.code, pointer + error.path, error.message);
  }
}

void read_fields(const JsonPlace& place, std::span<const JsonField> fields) {
  if (!place.value.is_object()) return wrong_type(place, "an object");
  for (const JsonField& field : fields) {
    const auto found = place.value.find(field.name);
    if (found != place.value.end()) {
      field.read(member(place, *found, field.name));
    } else if (field.required) {
      report_missing(place, field.name);
    }
  }
  for (auto item = place.value.begin(); item != place.value.end(); ++item) {
    if (place.problems.crowded()) return;
    const auto known = [&](const JsonField& field) { return field.name == item.key(); };
    if (std::any_of(fields.begin(), fields.end(), known)) continue;
    std::string message = "is not a field here, must be one of";
    std::vector<std::string> names;
    for (const JsonField& field : fields) message += ' ' + names.emplace_back(field.name);
    add_problem(member(place, *item, item.key()), ErrorCode::UnknownField,
                message + did_you_mean(item.key(), names));
  }
}

void read_array(const JsonPlace& place, const std::function<void(const JsonPlace&)>& read) {
  if (!place.value.is_array()) return wrong_type(place, "an array");
  for (std::size_t i = 0; i < place.value.size() && !place.problems.crowded(); ++i) {
    read(entry(place, i));
  }
}

double read_number(const JsonPlace& place) {
  if (place.value.is_number()) return place.value.get<double>();
  wrong_type(place, "a number");
  return kNoNumber;
}

double read_number_in(const JsonPlace& place, Range range, const char* unit) {
  const double number = read_number(place);
  if (place.value.is_number() && !(number >= range.min && number <= range.max)) {
    check_range(place.problems, pointer(place), number, range, unit);
  }
  return number;
}

int read_integer(const JsonPlace& place) {
  return read_integer_in(place, kNoInteger, std::numeric_limits<int>::max());
}

int read_integer_in(const JsonPlace& place, int min, int max) {
  if (!place.value.is_number_integer()) {
    wrong_type(place, "an integer");
    return kNoInteger;
  }
  const bool huge = place.value.is_number_unsigned() &&
                    place.value.get<std::uint64_t>() > std::numeric_limits<int>::max();
  if (!huge) {
    const auto number = place.value.get<std::int64_t>();
    if (number >= min && number <= max) return static_cast<int>(number);
  }
  add_problem(place, ErrorCode::OutOfRange,
              "is " + place.value.dump() + ", must be from " + std::to_string(min) + " to " +
                  std::to_string(max));
  return kNoInteger;
}

std::uint64_t read_unsigned(const JsonPlace& place) {
  if (place.value.is_number_unsigned()) return place.value.get<std::uint64_t>();
  if (place.value.is_number_integer()) {
    add_problem(place, ErrorCode::OutOfRange,
                "is " + place.value.dump() + ", must be from 0 to 18446744073709551615");
  } else {
    wrong_type(place, "an integer");
  }
  return 0;
}

bool read_boolean(const JsonPlace& place) {
  if (place.value.is_boolean()) return place.value.get<bool>();
  wrong_type(place, "true or false");
  return false;
}

std::string read_string(const JsonPlace& place) {
  if (place.value.is_string()) return place.value.get<std::string>();
  wrong_type(place, "a string");
  return {};
}

Vec3 read_vector(const JsonPlace& place) {
  Vec3 vector = Vec3::Constant(kNoNumber);
  if (!is_triple(place, "an array of three numbers")) return vector;
  for (int axis = 0; axis < 3; ++axis) {
    vector[axis] = read_number(entry(place, static_cast<std::size_t>(axis)));
  }
  return vector;
}

std::array<int, 3> read_indices(const JsonPlace& place) {
  std::array<int, 3> indices = {kNoInteger, kNoInteger, kNoInteger};
  if (!is_triple(place, "an array of three integers")) return indices;
  for (std::size_t i = 0; i < 3; ++i) indices[i] = read_integer(entry(place, i));
  return indices;
}

Points read_points(const JsonPlace& place) {
  const std::vector<Vec3> rows = read_list(place, read_vector);
  Points points(std::ssize(rows), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) points.row(static_cast<Eigen::Index>(i)) = rows[i];
  return points;
}

void read_schema(const JsonPlace& place, std::string_view schema, std::string_view earlier) {
  const std::string found = read_string(place);
  if (!place.value.is_string() || found == schema || (!earlier.empty() && found == earlier)) return;
  add_problem(place, ErrorCode::Unsupported,
              "is " + described(place.value) + ", must be \"" + std::string(schema) + "\"");
}

std::optional<std::size_t> read_choice(const JsonPlace& place,
                                       const std::vector<std::string>& names) {
  const std::string found = read_string(place);
  if (!place.value.is_string()) return {};
  const auto match = std::find(names.begin(), names.end(), found);
  if (match != names.end()) return static_cast<std::size_t>(match - names.begin());
  std::string message = "is " + described(place.value) + ", must be one of";
  for (const std::string& name : names) message += " \"" + name + '"';
  add_problem(place, ErrorCode::BadReference, message + did_you_mean(found, names));
  return {};
}

std::optional<JsonPlace> read_member(const JsonPlace& place, std::string_view name) {
  if (!place.value.is_object()) {
    wrong_type(place, "an object");
    return {};
  }
  const auto found = place.value.find(name);
  if (found != place.value.end()) return member(place, *found, name);
  report_missing(place, name);
  return {};
}

}  // namespace coapt
