// What closures answer, as JSON.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/closed/accurate_closure.h"
#include "core/closed/mesh_convergence.h"
#include "core/closure/closure.h"
#include "core/metrics/estimate.h"
#include "core/metrics/measure.h"
#include "io/json/json.h"

namespace coapt {

/// What coapt leaves out, a sentence each.
const std::vector<std::string>& not_modelled();

/// ["leak_mm2", ...]: which figures of the valve were observed.
Json observed_names(const std::vector<Observation>& observed);

Json to_json(const Errors& errors);  ///< [{"code","path","message"}, ...]
/// Of such a list; a code that is not known becomes Unsupported.
Errors errors_from_json(const Json& list);
Json to_json(const ValveMeasure& measure);

/// {"numerical": [low, high], "tissue", "execution"}: what is known of how far a number may be off, from 5 to 95 %. What is not known is
/// null.
Json to_json(const Estimate& estimate);

/// [low, high]; null: none.
Json interval_json(const std::optional<Interval>& interval);

/// {"value", and the members of an Estimate}.
Json estimate_json(const Estimate& estimate);

/// {"area_mm2", "error_mm2", and the members of an Estimate, "between_mm2": [lower, upper], "openings": [{"area_mm2", "centroid_mm", "normal", "segments", "width_mm",
/// "outline_mm"}]}. What is not known is null.
Json to_json(const Leak& leak, double error_mm2);

/// {"error_mm2", "refinements", "residual_tolerance", "way_tolerance_mm"}: what was asked for, and
/// how it was kept.
Json to_json(const AccurateClosure& closure, double error_mm2);

/// {"stop", "within_mm2", "within_share", "order", "monotonous", "leak_limit_mm2", "leak_error_mm2", "levels": [...]}:
/// what finer and finer meshes say of a leak. What is not known is null.
Json to_json(const MeshConvergence& convergence, const MeshConvergenceOptions& options);

/// Keys that scripts rely on: method, membrane, status, crossing, leak_mm2, leak, residual,
/// steps, seconds, triangles; then every measure, and the diagnosis (diagnosis_json.h).
Json closure_to_json(const Valve& valve, const ClosureResult& closure, const ValveMeasure& measure,
                     double seconds);

}  // namespace coapt
