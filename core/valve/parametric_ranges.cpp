#include <array>
#include <cmath>

#include "core/valve/parametric.h"

namespace coapt {
namespace {

struct Accepted {
  const char* path;
  std::optional<double> value;
  double low, high;
};

}  // namespace

Errors check_dimensions(const ParametricValve& d) {
  const Vec3& tips = d.asymmetry.tip_mm;
  const std::array<Accepted, 23> ranges = {
      {{"/ap_mm", d.ap_mm, 8, 80},
       {"/al_pm_mm", d.al_pm_mm, 8, 100},
       {"/saddle_height_mm", d.saddle_height_mm, 0, 20},
       {"/anterior_height_mm", d.anterior_height_mm, 4, 60},
       {"/posterior_height_mm", d.posterior_height_mm, 3, 60},
       {"/lateral_height_mm", d.lateral_height_mm, 3, 60},
       {"/commissure_height_mm", d.commissure_height_mm, 2, 30},
       {"/cleft_depth_mm", d.cleft_depth_mm, 0, 10},
       {"/anterior_arc", d.anterior_arc, 0.25, 0.5},
       {"/inclination_deg", d.inclination_deg, 0, 45},
       {"/tip_depth_mm", d.tip_depth_mm, 8, 60},
       {"/tip_spread_mm", d.tip_spread_mm, 4, 60},
       {"/trigone_share", d.trigone_share, 0.3, 1.0},
       {"/slack", d.slack, 0.8, 1.5},
       {"/posterior_slack", d.posterior_slack, 0.8, 1.5},
       {"/strut_slack", d.strut_slack, 0.8, 1.5},
       {"/basal_slack", d.basal_slack, 0.8, 1.5},
       {"/asymmetry/tip_mm/0", tips.x(), -10, 10},
       {"/asymmetry/tip_mm/1", tips.y(), -10, 10},
       {"/asymmetry/tip_mm/2", tips.z(), -10, 10},
       {"/asymmetry/leaflet_height", d.asymmetry.leaflet_height, -0.4, 0.4},
       {"/asymmetry/slack", d.asymmetry.slack, -0.2, 0.2},
       {"/triangles", static_cast<double>(d.triangles), 100, 50000}}};
  Errors errors;
  for (const Accepted& r : ranges)
    if (r.value && !(*r.value >= r.low && *r.value <= r.high))
      errors.push_back({ErrorCode::OutOfRange, r.path,
                        "is " + std::to_string(*r.value) + ", accepted: " + std::to_string(r.low) +
                            " to " + std::to_string(r.high)});
  if (!(std::abs(d.tip_posterior_mm) <= 20.0))
    errors.push_back({ErrorCode::OutOfRange, "/tip_posterior_mm", "accepted: -20 to 20"});
  if (d.annulus_mm.has_value() != d.tips_mm.has_value())
    errors.push_back({ErrorCode::MissingField, d.annulus_mm ? "/tips_mm" : "/annulus_mm",
                      "a measured annulus and measured tips come together"});
  if (d.annulus_mm && (d.annulus_mm->rows() < 12 || !d.annulus_mm->allFinite()))
    errors.push_back({ErrorCode::OutOfRange, "/annulus_mm", "accepted: 12 or more finite points"});
  if (d.tips_mm && (d.tips_mm->rows() < 2 || !d.tips_mm->allFinite()))
    errors.push_back({ErrorCode::OutOfRange, "/tips_mm", "accepted: 2 or more finite points"});
  return errors;
}

}  // namespace coapt
