// A farm, asked through the program coapt-farm.
#pragma once

#include <string>

#include "farm/ask/ask.h"

namespace coapt {

/// A farm: the database that its workers take their work from.
struct Farm {
  std::string url;  ///< postgres://..., as coapt-farm has it
  /// Path of coapt-farm, or its name for PATH.
  std::string program = "coapt-farm";
};

/// The farm at `url`, asked through the coapt-farm beside this program, else the one of PATH.
Farm farm_at(const std::string& url);

/// Done by the farm's workers. Work that the farm has already is taken up, so that who asked and died may ask again. Cancelled,
/// the work stays in the farm. May be called from several threads at once.
Asker ask_farm(const Farm& farm);

}  // namespace coapt
