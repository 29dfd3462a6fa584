#include "io/json/repair_answers.h"

#include <utility>

#include "core/repair/apply_plan.h"
#include "core/repair/limits.h"
#include "core/repair/rings.h"
#include "io/json/opening_json.h"
#include "io/json/result_json.h"
#include "io/json/scene_json.h"
#include "search/plans/gates.h"

namespace coapt {
namespace {

std::vector<std::string> warnings(const RepairRequest& asked) {
  return warnings_of(operation_gates({asked.plan, asked.valve, asked.repaired}));
}

/// @param target a number, or one that need not be there
template <class Number>
JsonField number_field(const char* name, Number& target, Range range, const char* unit) {
  return {name,
          into(target, [range, unit](
                           const JsonPlace& place) { return read_number_in(place, range, unit); }),
          false};
}

}  // namespace

std::vector<MaterialValue> read_material(const JsonPlace& place) {
  std::vector<MaterialValue> material;
  std::vector<JsonField> fields;
  for (const Dimension* dimension : material_table())
    fields.push_back({dimension->name,
                      [&material, dimension](const JsonPlace& at) {
                        material.push_back(
                            {dimension, read_number_in(at, dimension->accepted, dimension->unit)});
                      },
                      false});
  read_fields(place, fields);
  return material;
}

JsonField material_field(std::vector<MaterialValue>& material) {
  return {"material", into(material, read_material), false};
}

Errors apply(RepairRequest& asked) {
  ProblemList problems;
  Expected<Valve> valve = with_material(asked.valve, asked.material);
  if (!valve) {
    add_below(problems, "/material", valve.errors());
    return std::move(problems).take();
  }
  asked.valve = *std::move(valve);
  Expected<Valve> repaired = apply_plan(asked.valve, asked.plan);
  if (!repaired) {
    add_below(problems, "/plan", repaired.errors());
    return std::move(problems).take();
  }
  asked.repaired = *std::move(repaired);
  return {};
}

std::vector<JsonField> opening_fields(OpeningOptions& options) {
  return {number_field("pressure_mmhg", options.pressure_mmhg, kFillingPressures_mmhg, " mmHg"),
          number_field("flow_ml_s", options.flow_ml_s, kFillingFlows_ml_s, " ml/s"),
          number_field("exercise", options.exercise, kExercises, "")};
}

JsonField frames_field(int& frames) {
  return {"frames", into(frames, integer_in(0, kMostFrames)), false};
}

Json closure_answer(const RepairRequest& asked, const ClosureResult& closure,
                    const ValveMeasure& measured, double seconds) {
  Json json = closure_to_json(asked.repaired, closure, measured, seconds);
  json["warnings"] = warnings(asked);
  return json;
}

Json scene_answer(const RepairRequest& asked, const ClosedValve& closed, int frames,
                  double seconds) {
  Json scene =
      scene_to_json({asked.repaired, closed.closure, closed.measure.leak, asked.plan, frames});
  scene["closure"] = closure_answer(asked, closed.closure, closed.measure, seconds);
  return scene;
}

Json opening_answer(const RepairRequest& asked, const OpenedValve& opened, int frames,
                    double seconds) {
  Json json = opening_to_json(opened, seconds);
  json["warnings"] = warnings(asked);
  for (const std::string& warning : opening_warnings(opened)) json["warnings"].push_back(warning);
  json["scene"] = opening_scene_to_json(opened, frames);
  return json;
}

Json rings_answer() {
  Json shapes = Json::array();
  for (const RingShape& ring : kRingShapes)
    shapes.push_back({{"name", ring.name},
                      {"ap_over_transverse", ring.ap_over_transverse},
                      {"transverse_factor", ring.transverse_factor},
                      {"saddle_over_transverse", ring.saddle_over_transverse},
                      {"note", ring.note}});
  return {{"rings", std::move(shapes)},
          {"sizes_mm",
           {{"min", kRingSizesMm.min}, {"max", kRingSizesMm.max}, {"step", kRingSizeStep_mm}}}};
}

}  // namespace coapt
