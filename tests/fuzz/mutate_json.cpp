// libFuzzer's own mutations mostly break the JSON. Half of the time a document that parses gets one
// value changed instead, which leads past the parser into the checks behind it. One byte before the
// document stays as it is: fuzz_endpoints chooses by it.

#include <cstdint>
#include <cstring>
#include <random>

#include "io/json/json_reader.h"
#include "io/json/parse_json.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using coapt::Json;

std::size_t below(std::minstd_rand& random, std::size_t end) {
  return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
}

// A value somewhere in the document; deep ones are as likely as shallow ones.
Json& choose(Json& document, std::minstd_rand& random) {
  Json* value = &document;
  while (value->is_structured() && !value->empty() && below(random, 8) > 0) {
    value = &*std::next(value->begin(), static_cast<std::ptrdiff_t>(below(random, value->size())));
  }
  return *value;
}

void change(Json& document, std::minstd_rand& random) {
  static const Json values = {0,
                              -1,
                              1,
                              7,
                              8,
                              31,
                              32,
                              1e300,
                              -1e-300,
                              0.5,
                              -0.0,
                              1e18,
                              false,
                              "",
                              "A1",
                              "coapt",
                              "own",
                              nullptr,
                              Json::array(),
                              Json::object(),
                              4294967295u,
                              18446744073709551615u};
  Json& value = choose(document, random);
  switch (below(random, 4)) {
    case 0:
      value = values[below(random, values.size())];
      break;
    case 1:
      value = Json(choose(document, random));
      break;
    case 2:
      if (value.is_structured() && !value.empty()) {
        value.erase(
            std::next(value.begin(), static_cast<std::ptrdiff_t>(below(random, value.size()))));
      }
      break;
    case 3:
      if (value.is_number_integer())
        value = value.get<std::int64_t>() % 1000 + (below(random, 2) ? 1 : -1);
      if (value.is_number_float()) value = value.get<double>() * (below(random, 2) ? 1.001 : -1.0);
      if (value.is_array() && !value.empty())
        value.push_back(Json(value[below(random, value.size())]));
      break;
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  std::minstd_rand random(seed);
  const std::size_t start = size > 1 && data[0] != '{' && data[1] == '{' ? 1 : 0;
  auto document = coapt::parse_json({reinterpret_cast<const char*>(data) + start, size - start});
  if (!document || below(random, 2) == 0) return LLVMFuzzerMutate(data, size, max_size);
  change(*document, random);
  const std::string text = document->dump();
  if (start + text.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
  std::memcpy(data + start, text.data(), text.size());
  return start + text.size();
}
