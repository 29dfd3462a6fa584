// What closing, drawing and opening a repaired valve answer, as JSON: the service's and the browser's engine's.
#pragma once

#include "core/closed/closed_valve.h"
#include "core/opened/opened_valve.h"
#include "core/valve/dimension_table.h"
#include "io/json/json_reader.h"

namespace coapt {

struct RepairRequest {
  Valve valve;                            ///< with the material asked for, once apply() is done
  RepairPlan plan;                        ///< no steps, if there is none
  Valve repaired;                         ///< the valve as the plan leaves it
  std::vector<MaterialValue> material{};  ///< in place of the valve's own
};

/// Field "material": {"pressure_mmhg", "radial_extension", ...}, names of material_table().
JsonField material_field(std::vector<MaterialValue>& material);
std::vector<MaterialValue> read_material(const JsonPlace& place);

/// Gives the valve its material and applies the plan; problems point below "/material" and "/plan".
Errors apply(RepairRequest& asked);

/// Fields of a request for an opening: "pressure_mmhg", "flow_ml_s", "exercise".
std::vector<JsonField> opening_fields(OpeningOptions& options);

/// Field "frames": 0 to kMostFrames.
JsonField frames_field(int& frames);

/// coapt.closure/2, with the warnings of the operation. `measured`: measure(asked.repaired, closure)
Json closure_answer(const RepairRequest& asked, const ClosureResult& closure,
                    const ValveMeasure& measured, double seconds);

/// coapt.scene/2, with that as "closure".
Json scene_answer(const RepairRequest& asked, const ClosedValve& closed, int frames,
                  double seconds);

/// coapt.opening/2, with the warnings of the operation and "scene".
Json opening_answer(const RepairRequest& asked, const OpenedValve& opened, int frames,
                    double seconds);

/// Ring shapes and sizes.
Json rings_answer();

}  // namespace coapt
