#include "io/json/result_json.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/metrics/closed_figures.h"
#include "core/valve/leaflets.h"
#include "io/json/diagnosis_json.h"
#include "io/json/version.h"

namespace coapt {
namespace {

constexpr std::array kErrorCodes = {
    ErrorCode::InvalidJson, ErrorCode::MissingField, ErrorCode::UnknownField,
    ErrorCode::WrongType,   ErrorCode::OutOfRange,   ErrorCode::BadReference,
    ErrorCode::BadTopology, ErrorCode::BadGeometry,  ErrorCode::ImpossibleStep,
    ErrorCode::Unsupported, ErrorCode::InputOutput,  ErrorCode::Busy,
    ErrorCode::NoSpace};

const char* name_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::InvalidJson:
      return "invalid_json";
    case ErrorCode::MissingField:
      return "missing_field";
    case ErrorCode::UnknownField:
      return "unknown_field";
    case ErrorCode::WrongType:
      return "wrong_type";
    case ErrorCode::OutOfRange:
      return "out_of_range";
    case ErrorCode::BadReference:
      return "bad_reference";
    case ErrorCode::BadTopology:
      return "bad_topology";
    case ErrorCode::BadGeometry:
      return "bad_geometry";
    case ErrorCode::ImpossibleStep:
      return "impossible_step";
    case ErrorCode::Unsupported:
      return "unsupported";
    case ErrorCode::InputOutput:
      return "input_output";
    case ErrorCode::Busy:
      return "busy";
    case ErrorCode::NoSpace:
      return "no_space";
  }
  return "";
}

/// To a hundredth.
Json rounded_json(const Vec3& v) {
  Json list = Json::array();
  for (const double coordinate : v) list.push_back(std::round(100.0 * coordinate) / 100.0);
  return list;
}

Json opening_json(const LeakOpening& opening) {
  Json segments = Json::array(), outline = Json::array();
  for (const Segment segment : opening.segments) segments.push_back(to_string(segment));
  for (const int vertex : opening.surface.outline)
    outline.push_back(rounded_json(opening.surface.points_mm.row(vertex).transpose()));
  return {{"area_mm2", opening.area_mm2},
          {"centroid_mm", rounded_json(opening.centroid_mm)},
          {"normal", {opening.normal.x(), opening.normal.y(), opening.normal.z()}},
          {"segments", std::move(segments)},
          {"width_mm", opening.width_mm},
          {"outline_mm", std::move(outline)}};
}

Json coaptation_json(const Coaptation& coaptation) {
  Json sections = Json::array();
  for (const CoaptationSection& section : coaptation.sections) {
    sections.push_back({{"along", section.along},
                        {"height_mm", section.height_mm},
                        {"distance_mm", section.distance_mm},
                        {"contact", section.contact}});
  }
  return {{"height_min_mm", coaptation.height_min_mm},
          {"height_mean_mm", coaptation.height_mean_mm},
          {"height_p10_mm", coaptation.height_p10_mm},
          {"distance_max_mm", coaptation.distance_max_mm},
          {"sections", std::move(sections)}};
}

Json annulus_json(const AnnulusMeasure& annulus) {
  return {{"ap_mm", annulus.ap_mm},
          {"al_pm_mm", annulus.al_pm_mm},
          {"circumference_mm", annulus.circumference_mm},
          {"area_mm2", annulus.area_mm2},
          {"saddle_height_mm", annulus.saddle_height_mm}};
}

Json leaflets_json(const std::vector<LeafletMeasure>& leaflets) {
  Json list = Json::array();
  for (const LeafletMeasure& leaflet : leaflets)
    list.push_back({{"name", leaflet.name},
                    {"rest_area_mm2", leaflet.rest_area_mm2},
                    {"closed_area_mm2", leaflet.closed_area_mm2},
                    {"contact_share", leaflet.contact_share},
                    {"stretch_median", leaflet.stretch_median}});
  return list;
}

/// Of closed_figures(), by their names.
Json estimates_json(const ValveMeasure& measure, int triangles) {
  Json json;
  const auto estimates = closed_estimates(measure, triangles);
  for (std::size_t i = 0; i < estimates.size(); ++i)
    json[closed_figures()[i].name] = estimate_json(estimates[i]);
  return json;
}

// `json` with the members of `more` after its own.
Json joined(Json json, const Json& more) {
  for (const auto& [name, value] : more.items()) json[name] = value;
  return json;
}

}  // namespace

const std::vector<std::string>& not_modelled() {
  static const std::vector<std::string> kSentences = {
      "Blood flow: pressure is static and jets are not computed; the diastolic gradient is the one "
      "that drives the filling pulse through the opening (Bernoulli).",
      "Filling: relaxation and stiffness of the ventricle, and the flow around sutures.",
      "Ventricle: annulus and papillary tips do not move while the valve closes.",
      "Tissue: local variation, calcification, clefts that are not in the valve file, tearing "
      "sutures, healing and growth."};
  return kSentences;
}

Json observed_names(const std::vector<Observation>& observed) {
  Json names = Json::array();
  for (const Observation& seen : observed) names.push_back(row_of(seen.figure).name);
  return names;
}

Json to_json(const Errors& errors) {
  Json list = Json::array();
  for (const Error& error : errors) {
    list.push_back(
        {{"code", name_of(error.code)}, {"path", error.path}, {"message", error.message}});
  }
  return list;
}

Errors errors_from_json(const Json& list) {
  Errors errors;
  for (const Json& one : list) {
    if (!one.is_object()) continue;
    const std::string name = one.value("code", "");
    const auto code = std::find_if(kErrorCodes.begin(), kErrorCodes.end(),
                                   [&](ErrorCode known) { return name == name_of(known); });
    errors.push_back({code == kErrorCodes.end() ? ErrorCode::Unsupported : *code,
                      one.value("path", ""), one.value("message", "")});
  }
  return errors;
}

Json to_json(const Estimate& estimate) {
  return {{"numerical", interval_json(estimate.numerical)},
          {"tissue", interval_json(estimate.tissue)},
          {"execution", interval_json(estimate.execution)}};
}

Json interval_json(const std::optional<Interval>& interval) {
  return interval ? Json{interval->low, interval->high} : Json();
}

Json estimate_json(const Estimate& estimate) {
  Json json = {{"value", estimate.value}};
  json.update(to_json(estimate));
  return json;
}

Json to_json(const Leak& leak, double error_mm2) {
  Json openings = Json::array();
  for (const LeakOpening& opening : leak.openings) openings.push_back(opening_json(opening));
  Json json = {{"area_mm2", leak.area_mm2},
               {"error_mm2", std::isfinite(error_mm2) ? Json(error_mm2) : Json()}};
  json.update(to_json(Estimate{leak.area_mm2, area_interval(leak.area_mm2, error_mm2)}));
  json["between_mm2"] =
      std::isfinite(leak.area_mm2) ? Json{leak.lower_mm2, leak.upper_mm2} : Json();
  json["openings"] = std::move(openings);
  return json;
}

Json to_json(const ValveMeasure& measure) {
  const Json leak = to_json(measure.leak, measure.leak_error_mm2);
  Json json = {{"leak_mm2", measure.leak.area_mm2},
               {"leak_mm2_error", leak["error_mm2"]},
               {"leak", leak},
               {"coaptation", coaptation_json(measure.coaptation)},
               {"annulus", annulus_json(measure.annulus)},
               {"tenting_height_mm", measure.tenting_height_mm},
               {"tenting_area_mm2", measure.tenting_area_mm2},
               {"tension_max_n", measure.tension_max_n},
               {"tension_sum_n", measure.tension_sum_n},
               {"strain_circumferential_max", measure.strain_circumferential_max},
               {"strain_radial_max", measure.strain_radial_max}};
  if (!measure.leaflets.empty()) json["leaflets"] = leaflets_json(measure.leaflets);
  return json;
}

Json to_json(const AccurateClosure& closure, double error_mm2) {
  return {{"error_mm2", std::isfinite(error_mm2) ? Json(error_mm2) : Json()},
          {"refinements", closure.refinements},
          {"residual_tolerance", closure.tier.residual_tolerance},
          {"way_tolerance_mm", closure.tier.way_tolerance_mm}};
}

Json to_json(const MeshConvergence& convergence, const MeshConvergenceOptions& options) {
  Json levels = Json::array();
  for (const MeshLevel& level : convergence.levels)
    levels.push_back({{"triangles", level.triangles},
                      {"vertices", level.vertices},
                      {"status", to_string(level.status)},
                      {"crossing", level.crossing},
                      {"leak_mm2", level.leak_mm2},
                      {"change_mm2", level.change_mm2}});
  return {{"stop", to_string(convergence.stop)},
          {"within_mm2", options.within_mm2},
          {"within_share", options.within_share},
          {"order", convergence.limit.order},
          {"monotonous", convergence.limit.monotonous},
          {"leak_limit_mm2", convergence.limit.leak_mm2},
          {"leak_error_mm2", convergence.limit.error_mm2},
          {"other_end_mm2", convergence.other_end_mm2},
          {"levels", std::move(levels)}};
}

Json closure_to_json(const Valve& valve, const ClosureResult& closure, const ValveMeasure& measure,
                     double seconds) {
  Json attempts = Json::array();
  for (const ClosureAttempt& attempt : closure.attempts)
    attempts.push_back({{"how", attempt.how},
                        {"status", to_string(attempt.status)},
                        {"crossing_pairs", attempt.crossing_pairs},
                        {"residual", attempt.residual},
                        {"steps", attempt.steps}});
  Json json = joined(result_document("coapt.closure/2", {{"valve", valve.name},
                                                         {"triangles", valve.faces.rows()},
                                                         {"method", to_string(closure.method)},
                                                         {"membrane", to_string(closure.membrane)},
                                                         {"status", to_string(closure.status)},
                                                         {"residual", closure.residual},
                                                         {"steps", closure.steps},
                                                         {"seconds", seconds},
                                                         {"crossing", closure.crossing},
                                                         {"crossing_pairs", closure.crossing_pairs},
                                                         {"attempts", std::move(attempts)}}),
                     to_json(measure));
  if (is_mitral(valve))
    json["coaptation_area_index"] = coaptation_area_index(valve, closure.closed_mm);
  const bool known = is_mitral(valve) && trusted(closure);
  json["estimates"] = estimates_json(measure, known ? static_cast<int>(valve.faces.rows()) : 0);
  json["diagnosis"] = to_json(diagnose(valve, closure, measure));
  return json;
}

}  // namespace coapt
