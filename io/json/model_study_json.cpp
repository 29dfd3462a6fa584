#include "io/json/model_study_json.h"

#include <cmath>

#include "io/json/result_json.h"
#include "io/json/version.h"
#include "search/model_draw.h"

namespace coapt {
namespace {

Json leak_json(const ModelUncertainty& leak) {
  Json parameters = Json::array();
  for (std::size_t i = 0; i < leak.decided_by.total.size(); ++i) {
    const ModelParameter& parameter = model_parameters()[i];
    parameters.push_back({{"name", parameter.name},
                          {"lower", parameter.lower},
                          {"upper", parameter.upper},
                          {"first", leak.decided_by.first[i]},
                          {"total", leak.decided_by.total[i]},
                          {"effect_mm2", leak.decided_by.effect[i]}});
  }
  return {{"as_it_is_mm2", leak.as_it_is_mm2},
          {"mean_mm2", leak.mean_mm2},
          {"sd_mm2", leak.sd_mm2},
          {"p5_mm2", leak.p5_mm2},
          {"p95_mm2", leak.p95_mm2},
          {"predicted_share", leak.decided_by.predicted_share},
          {"parameters", std::move(parameters)}};
}

Json known(double number) { return std::isfinite(number) ? Json(number) : Json(); }

/// What is known of the valve and its draws, then `found`.
Json document_of(const char* format, const ModelStudy& study, const std::string& valve_name,
                 const Json& found) {
  Json document = {{"valve", valve_name},
                   {"status", to_string(study.as_it_is.status)},
                   {"crossing", study.as_it_is.crossing}};
  document.update(tissue_draws_json(study));
  document.update(found);
  return result_document(format, std::move(document));
}

}  // namespace

Json to_json(const ModelStudy& study, const std::string& valve_name) {
  return document_of("coapt.model_study/2", study, valve_name, {{"leak", leak_json(study.leak)}});
}

Json to_json(const ModelStudy& study, const std::vector<InformationRow>& rows,
             const std::string& valve_name) {
  const ValveMeasure& measure = study.as_it_is.measure;
  Json leak = {{"area_mm2", measure.leak.area_mm2}, {"sd_mm2", study.leak.sd_mm2}};
  leak.update(to_json(Estimate{measure.leak.area_mm2,
                               area_interval(measure.leak.area_mm2, measure.leak_error_mm2),
                               tissue_interval(study)}));
  return document_of("coapt.information/1", study, valve_name,
                     {{"leak", std::move(leak)}, {"rows", to_json(rows)}});
}

Json to_json(const std::vector<InformationRow>& rows) {
  Json list = Json::array();
  for (const InformationRow& row : rows)
    list.push_back({{"measurement", row.measurement},
                    {"share_removed", known(row.share_removed)},
                    {"remaining_mm2", known(row.remaining_mm2)}});
  return list;
}

Json tissue_draws_json(const ModelStudy& study) {
  return {{"draws", study.draws.size()},
          {"untrusted", study.untrusted},
          {"chordae_drawn", study.draws_chordae},
          {"fit_drawn", study.draws_fit},
          {"observed", observed_names(study.observed)},
          {"effective", study.effective},
          {"contradicts_model", study.contradicts}};
}

}  // namespace coapt
