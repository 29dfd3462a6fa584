// nlohmann's tokenizer drives a builder that keeps its own stack: the usual one neither limits
// depth nor notices a name that comes twice. Members are gathered in a tree, in which the thousandth
// name is found as soon as the first, and put into their object in the order of their names.

#include "io/json/parse_json.h"

#include "io/json/json.h"
#include "io/json/json_reader.h"

namespace coapt {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{64} << 20;
constexpr std::size_t kMaxDepth = 32;
constexpr std::size_t kMaxNameBytes = 256;  // names return in pointers
constexpr std::size_t kMaxMessage = 200;

// Readable in a message, whatever bytes the input held.
std::string printable(std::string text) {
  if (text.size() > kMaxMessage) text = text.substr(0, kMaxMessage) + "...";
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return text;
}

class Builder {
 public:
  Builder(ProblemList& problems, std::size_t max_values)
      : problems_(problems), max_values_(max_values) {}

  ~Builder() {
    take_apart(root_);
    for (Level& level : levels_)
      for (auto& [name, value] : level.members) take_apart(value);
  }

  Json take() { return std::move(root_); }

  // The events of Json::sax_parse; false stops it.
  bool null() { return put(nullptr); }
  bool boolean(bool value) { return put(value); }
  bool number_integer(std::int64_t value) { return put(value); }
  bool number_unsigned(std::uint64_t value) { return put(value); }
  bool number_float(double value, const std::string&) { return put(value); }
  bool string(std::string& value) { return put(std::move(value)); }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Json::object()); }
  bool start_array(std::size_t) { return open(Json::array()); }
  bool end_object() {
    Level& level = levels_.back();
    auto& object = level.value->get_ref<Json::object_t&>();
    object.reserve(level.members.size());  // all that can run out of memory here
    while (!level.members.empty()) {
      auto member = level.members.extract(level.members.begin());
      object.emplace_back(std::move(member.key()), std::move(member.mapped()));
    }
    return close();
  }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    if (name.size() > kMaxNameBytes) return stop("holds a name longer than 256 bytes");
    Level& level = levels_.back();
    level.name = std::move(name);
    if (level.members.contains(level.name)) {
      problems_.add(ErrorCode::InvalidJson, path(), "is given more than once");
    }
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) {
    constexpr int kNumberOverflow = 406;
    const std::string what = error.what();
    const std::size_t start = what.find("] ");
    problems_.add(error.id == kNumberOverflow ? ErrorCode::OutOfRange : ErrorCode::InvalidJson,
                  path(1), printable(start == std::string::npos ? what : what.substr(start + 2)));
    return false;
  }

 private:
  struct Level {
    Json* value;
    std::string name;                     // the latest, in an object
    std::map<std::string, Json> members;  // of an object, until it is closed
  };

  // To the value begun last, or in an array to the `ahead`-th after it.
  std::string path(std::size_t ahead = 0) const {
    Json::json_pointer pointer;
    for (const Level& level : levels_) {
      const bool last = &level == &levels_.back();
      if (level.value->is_array()) {
        pointer.push_back(std::to_string(level.value->size() - 1 + (last ? ahead : 0)));
      } else if (!last || !level.members.empty() || !level.name.empty()) {
        pointer.push_back(level.name);
      }
    }
    return pointer.to_string();
  }

  bool stop(const std::string& message) {
    problems_.add(ErrorCode::InvalidJson, path(), message);
    return false;
  }

  bool count() {
    return ++values_ <= max_values_ ||
           stop("is more than the " + std::to_string(max_values_) + " values accepted");
  }

  Json* insert(Json&& value) {
    if (levels_.empty()) return &(root_ = std::move(value));
    Level& level = levels_.back();
    if (level.value->is_object()) return &(level.members[level.name] = std::move(value));
    level.value->push_back(std::move(value));
    return &level.value->back();
  }

  bool put(Json&& value) {
    insert(std::move(value));
    return count();
  }

  bool open(Json&& value) {
    Json* const inserted = insert(std::move(value));
    if (levels_.size() == kMaxDepth) return stop("is nested deeper than the 32 levels accepted");
    if (!count()) return false;
    levels_.push_back({inserted, {}, {}});
    return true;
  }

  bool close() {
    levels_.pop_back();
    return true;
  }

  ProblemList& problems_;
  const std::size_t max_values_;
  Json root_;
  std::vector<Level> levels_;
  std::size_t values_ = 0;
};

}  // namespace

void take_apart(Json& value) {
  if (auto* const array = value.get_ptr<Json::array_t*>()) {
    for (; !array->empty(); array->pop_back()) take_apart(array->back());
  } else if (auto* const object = value.get_ptr<Json::object_t*>()) {
    for (; !object->empty(); object->pop_back()) take_apart(object->back().second);
  }
}

Expected<Json> parse_json(std::string_view text, std::size_t max_values) {
  if (text.size() > kMaxBytes) {
    return Error{
        ErrorCode::InvalidJson, "",
        "has " + std::to_string(text.size()) + " bytes, at most 67108864 (64 MiB) are accepted"};
  }
  ProblemList problems;
  Builder builder(problems, max_values);
  Json::sax_parse(text.begin(), text.end(), &builder);
  // To the library it is the end of the text.
  if (const std::size_t nul = text.find('\0'); problems.empty() && nul != text.npos)
    problems.add(ErrorCode::InvalidJson, "",
                 "has a NUL character at byte " + std::to_string(nul + 1));
  if (!problems.empty()) return std::move(problems).take();
  return builder.take();
}

}  // namespace coapt
