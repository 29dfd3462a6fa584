// A file in a document: {"name", "text" or "base64"}.
#pragma once

#include <string>

#include "io/json/json_reader.h"

namespace coapt {

struct NamedFile {
  std::string name;
  std::string bytes;
};

NamedFile read_file(const JsonPlace& place);
/// As base64.
Json to_json(const NamedFile& file);

}  // namespace coapt
