#include "io/json/model_study_json.h"

#include "io/json/result_json.h"
#include "io/json/version.h"
#include "search/model_draw.h"

namespace coapt {
namespace {

Json area_json(const ModelUncertainty& area) {
  Json parameters = Json::array();
  for (std::size_t i = 0; i < area.decided_by.total.size(); ++i) {
    const ModelParameter& parameter = model_parameters()[i];
    parameters.push_back({{"name", parameter.name},
                          {"lower", parameter.lower},
                          {"upper", parameter.upper},
                          {"first", area.decided_by.first[i]},
                          {"total", area.decided_by.total[i]},
                          {"effect_mm2", area.decided_by.effect[i]}});
  }
  return {{"name", area.name},
          {"as_it_is_mm2", area.as_it_is_mm2},
          {"mean_mm2", area.mean_mm2},
          {"sd_mm2", area.sd_mm2},
          {"p5_mm2", area.p5_mm2},
          {"p95_mm2", area.p95_mm2},
          {"predicted_share", area.decided_by.predicted_share},
          {"parameters", std::move(parameters)}};
}

}  // namespace

Json to_json(const ModelStudy& study, const std::string& valve_name) {
  return result_document("coapt.model_study/1",
                         {{"valve", valve_name},
                          {"status", to_string(study.as_it_is.status)},
                          {"crossing", study.as_it_is.crossing},
                          {"draws", study.draws.size()},
                          {"untrusted", study.untrusted},
                          {"areas", {area_json(study.leak), area_json(study.orifice)}}});
}

}  // namespace coapt
