// The findings of thesis 4.3 and 4.4, each beside what a valve shows.
#pragma once

#include <string>
#include <vector>

#include "search/studies/thesis_study.h"

namespace coapt {

struct Finding {
  std::string finding;  ///< stable name, such as "dilation-grows-superlinearly"
  std::string section;  ///< of the thesis, such as "4.3.1"
  std::string thesis;   ///< what the thesis says
  std::string ours;     ///< what this valve shows, in numbers
  std::string judged;   ///< when that agrees
  bool agrees = false;
};

/// In the order of the thesis. The anchor findings come once for each protocol of the study.
std::vector<Finding> findings(const ThesisStudy& study);

}  // namespace coapt
