// Bodies of multipart/form-data: the first line is the parameters of their type.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "io/json/parse_json.h"
#include "server/form_body.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace coapt;
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string type = "multipart/form-data; " + std::string(text.substr(0, end));
  const Expected<std::string> json = json_of_form(text.substr(std::min(end + 1, size)), type);
  if (!json) return 0;
  const Expected<Json> document = parse_json(*json);
  if (document && !document->is_object()) std::abort();
  return 0;
}
