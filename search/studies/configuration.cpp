#include "search/studies/configuration.h"

#include "core/repair/apply_plan.h"

namespace coapt {

const char* to_string(Displaced displaced) {
  switch (displaced) {
    case Displaced::Anterolateral:
      return "AL";
    case Displaced::Posteromedial:
      return "PM";
    case Displaced::Both:
      return "both";
  }
  return "";
}

Configuration displacement(Displaced displaced, const Vec3& by_mm, int ring_sizes_below) {
  Configuration configuration;
  if (displaced != Displaced::Posteromedial) configuration.change.anterolateral_mm = by_mm;
  if (displaced != Displaced::Anterolateral) configuration.change.posteromedial_mm = by_mm;
  configuration.ring_sizes_below = ring_sizes_below;
  return configuration;
}

Expected<Valve> configure(const Valve& valve, const Configuration& configuration) {
  if (configuration.ring_sizes_below == 0) return remodel(valve, configuration.change);
  const Expected<Valve> ringed =
      apply_plan(valve, {{Annuloplasty{OwnRing{configuration.ring_sizes_below}}}});
  return ringed ? remodel(*ringed, configuration.change) : ringed;
}

}  // namespace coapt
