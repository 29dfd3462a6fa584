#include "io/json/opening_json.h"

#include <limits>

#include "core/metrics/figure_error.h"
#include "io/json/result_json.h"
#include "io/json/version.h"

namespace coapt {
namespace {

/// With the mesh's error of an opening that is to be trusted.
Json figure_json(const OpenedValve& opened, Figure figure, double value) {
  Estimate estimate{value};
  if (trusted(opened.closure))
    estimate.numerical =
        figure_interval(figure, value, static_cast<int>(opened.valve.faces.rows()));
  return estimate_json(estimate);
}

}  // namespace

Json opening_figures_json(const OpenedValve& opened, double seconds) {
  const OpeningMeasure& measure = opened.measure;
  return {{"status", to_string(opened.closure.status)},
          {"crossing", opened.closure.crossing},
          {"opening_area_mm2", measure.opening_area_mm2},
          {"leak", to_json(opened.leak, std::numeric_limits<double>::quiet_NaN())},
          {"projected_area_mm2", measure.projected_area_mm2},
          {"annulus_area_mm2", measure.annulus_area_mm2},
          {"gradient_mmhg", measure.gradient_mmhg},
          {"gradient_exercise_mmhg", measure.gradient_exercise_mmhg},
          {"estimates",
           {{"opening_area_mm2", figure_json(opened, Figure::Opening, measure.opening_area_mm2)},
            {"gradient_mmhg", figure_json(opened, Figure::Gradient, measure.gradient_mmhg)}}},
          {"flow_ml_s", measure.flow_ml_s},
          {"flow_exercise_ml_s", measure.flow_exercise_ml_s},
          {"pressure_mmhg", measure.pressure_mmhg},
          {"systole",
           {{"annular_contraction", opened.valve.systole.annular_contraction},
            {"tip_approach", opened.valve.systole.tip_approach}}},
          {"residual", opened.closure.residual},
          {"steps", opened.closure.steps},
          {"seconds", seconds}};
}

Json opening_to_json(const OpenedValve& opened, double seconds) {
  Json json = result_document("coapt.opening/2", {{"name", opened.valve.name}});
  json.update(opening_figures_json(opened, seconds));
  return json;
}

}  // namespace coapt
