#include "io/json/findings_json.h"

namespace coapt {

nlohmann::ordered_json to_json(const std::vector<Finding>& findings) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Finding& finding : findings)
    list.push_back({{"finding", finding.finding},
                    {"section", finding.section},
                    {"thesis", finding.thesis},
                    {"ours", finding.ours},
                    {"judged", finding.judged},
                    {"agrees", finding.agrees}});
  return list;
}

}  // namespace coapt
