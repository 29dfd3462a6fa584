// A study as one HTML file in the plan report's style: no scripts, nothing fetched.
#pragma once

#include <string>
#include <vector>

#include "search/studies/findings.h"

namespace coapt {

struct PageSection {
  std::string heading, text;                    ///< an empty line in the text begins a paragraph
  std::string svg;                              ///< of io/picture, as it is
  std::vector<std::vector<std::string>> table;  ///< the first row is the header
};

/// With the research-only notice. Everything but `svg` is escaped.
std::string study_page(const std::string& title, const std::string& lead,
                       const std::vector<PageSection>& sections);

/// "21 of 27 findings of the thesis hold on this valve.", each finding beside what this valve shows,
/// the figures, what is said of the closures.
std::string findings_page(const std::string& valve_name, const std::vector<Finding>& findings,
                          const std::vector<PageSection>& figures, const std::string& closures);

}  // namespace coapt
