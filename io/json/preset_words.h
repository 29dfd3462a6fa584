// What each preset is, in plain words (words/presets.json): what command line, service and page say of it.
#pragma once

#include <string>
#include <string_view>

#include "io/json/json.h"

namespace coapt {

/// words/presets.json, as it was when coapt was built.
std::string_view preset_words_text();

/// name, group ("Human", "Disease" or "Porcine"), title, about (a sentence or two).
/// @pre `name` is one of preset_names().
Json preset_words(const std::string& name);

}  // namespace coapt
