#include "io/json/plan_json.h"
#include "io/json/ring_json.h"

namespace coapt {
namespace {

Json point_json(const LeafletPoint& point) {
  return {{"leaflet", to_string(point.leaflet)}, {"along", point.along}, {"height", point.height}};
}

Json step_json(const Annuloplasty& step) {
  if (const auto* designed = std::get_if<DesignedRing>(&step.ring))
    return {{"step", "annuloplasty"},
            {"shape", kDesignedShape},
            {"ring", to_json(designed->shape)},
            {"size_mm", designed->size_mm}};
  Json json = {{"step", "annuloplasty"}, {"shape", shape_of(step)}};
  if (const auto* own = std::get_if<OwnRing>(&step.ring)) {
    json["sizes_below"] = own->sizes_below;
  } else {
    json["size_mm"] = std::get<CatalogueRing>(step.ring).size_mm;
  }
  return json;
}

Json step_json(const Neochorda& step) {
  return {{"step", "neochorda"},
          {"head", step.head},
          {"insertion", point_json(step.insertion)},
          {"length_mm", step.length_mm}};
}

Json step_json(const ChordalLengthChange& step) {
  return {
      {"step", "chordal_length_change"}, {"chorda", step.chorda}, {"change_mm", step.change_mm}};
}

Json step_json(const ChordalExcision& step) {
  return {{"step", "chordal_excision"}, {"chorda", step.chorda}};
}

Json step_json(const ChordalTransfer& step) {
  return {{"step", "chordal_transfer"},
          {"chorda", step.chorda},
          {"insertion", point_json(step.insertion)}};
}

Json step_json(const PapillaryApproximation& step) {
  Json json = {{"step", "papillary_approximation"},
               {"side", to_string(step.side)},
               {"anchor", to_string(step.anchor)}};
  if (step.anchor == Anchor::AnnulusPoint) json["annulus_around"] = step.annulus_around;
  json["suture_length_mm"] = step.suture_length_mm;
  return json;
}

Json step_json(const EdgeToEdge& step) {
  Json json = {{"step", "edge_to_edge"},
               {"device", to_string(step.device)},
               {"along", step.along},
               {"width_mm", step.width_mm}};
  if (step.device == EdgeDevice::Clip) {
    json["grasp_mm"] = step.grasp_mm;
    json["rows"] = step.rows;
    json["annulus_drawn_in_percent"] = step.annulus_drawn_in_percent;
  }
  return json;
}

Json step_json(const LeafletResection& step) {
  Json json = {{"step", "leaflet_resection"}, {"shape", to_string(step.shape)}};
  const bool quadrangular = step.shape == ResectionShape::Quadrangular;
  if (!quadrangular) json["leaflet"] = to_string(step.leaflet);
  json["along"] = step.along;
  json["width_mm"] = step.width_mm;
  if (quadrangular)
    json["sliding"] = step.sliding;
  else
    json["height"] = step.height;
  return json;
}

}  // namespace

Json to_json(const RepairPlan& plan) {
  Json steps = Json::array();
  for (const RepairStep& step : plan.steps) {
    steps.push_back(std::visit([](const auto& kind) { return step_json(kind); }, step));
  }
  return {{"schema", "coapt.plan/1"}, {"steps", std::move(steps)}};
}

}  // namespace coapt
