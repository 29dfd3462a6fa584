// What each preset is, in plain words (words/presets.json): what command line, service and page say of it.
#pragma once

#include <string>
#include <string_view>

namespace coapt {

struct PresetWords {
  std::string group;  ///< "Human", "Disease" or "Porcine"
  std::string title;
  std::string about;  ///< a sentence or two
};

/// words/presets.json, as it was when coapt was built.
std::string_view preset_words_text();

/// @pre `name` is one of preset_names().
PresetWords preset_words(const std::string& name);

}  // namespace coapt
