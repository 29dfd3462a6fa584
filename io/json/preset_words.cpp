#include "io/json/preset_words.h"

namespace coapt {

Json preset_words(const std::string& name) {
  static const Json kWords = Json::parse(preset_words_text());
  Json words = {{"name", name}};
  words.update(kWords.at(name));
  return words;
}

}  // namespace coapt
