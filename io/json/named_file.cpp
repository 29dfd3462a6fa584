#include "io/json/named_file.h"

#include <utility>

#include "io/json/base64.h"

namespace coapt {

NamedFile read_file(const JsonPlace& place) {
  NamedFile file;
  std::optional<std::string> text, base64;
  read_fields(place, std::vector<JsonField>{{"name", into(file.name, read_string)},
                                            {"text", into(text, read_string), false},
                                            {"base64", into(base64, read_string), false}});
  if (text.has_value() == base64.has_value()) {
    add_problem(place, ErrorCode::MissingField, "must have either text or base64");
  } else if (text) {
    file.bytes = *std::move(text);
  } else if (std::optional<std::string> bytes = decoded_base64(*base64)) {
    file.bytes = *std::move(bytes);
  } else {
    add_problem(place, ErrorCode::OutOfRange, "base64 contains invalid characters");
  }
  return file;
}

Json to_json(const NamedFile& file) {
  return {{"name", file.name}, {"base64", encoded_base64(file.bytes)}};
}

}  // namespace coapt
