#include "io/json/findings_json.h"

namespace coapt {

Json to_json(const std::vector<Finding>& findings) {
  Json list = Json::array();
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
