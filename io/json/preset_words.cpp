#include "io/json/preset_words.h"

#include "io/json/json.h"

namespace coapt {

PresetWords preset_words(const std::string& name) {
  static const Json kWords = Json::parse(preset_words_text());
  const Json& words = kWords.at(name);
  return {words.at("group"), words.at("title"), words.at("about")};
}

}  // namespace coapt
